/* bfgs.h - the largest value of a function with slopes, kinks allowed */
#ifndef MLG_BFGS_H
#define MLG_BFGS_H

enum { BFGS_MOST = 64 };

/* A function of y[n] and its slopes by them; asked counts how often it was asked. */
struct bfgs {
  double (*value)(void *context, const double y[], double slope[]);
  void *context;
  int n, asked;
};

/* Uphill from y[n], n <= BFGS_MOST, in at most `most` steps of the BFGS method, then again with a fresh
 * matrix where that still helps; y[] becomes the best place.  Returns the value there. */
double bfgs_climb(struct bfgs *f, double y[], int most);

#endif
