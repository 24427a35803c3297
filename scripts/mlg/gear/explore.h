/* explore.h - the best design of a layout or network, by a global search (explore.c) */
#ifndef MLG_EXPLORE_H
#define MLG_EXPLORE_H

#include "arguments.h"
#include "device_text.h"

enum { EXPLORE_OTHERS = 4, EXPLORE_VARIABLES = EXPLORE_OTHERS + 3, EXPLORE_STARTS = 100 };

/* A place is x[] in the unit box: k_s, b, other elements, each if there is one, then c_d. */
struct explorer {
  int layout, has_k_s, has_b, others;
  double par[LIBMLG_MOST_PARAMETERS], k_least, b_most, V_least, V_top;
  struct part *other[EXPLORE_OTHERS];
};

/* The best design, and how often it was met. */
struct found {
  double value, k_s, b, lo, hi; /* c_d: lo = hi, but of an interval */
  double x[EXPLORE_VARIABLES];
  int met, starts, asked;
};

/* All values but those that are searched stay as in par[]. */
void explore_begin(struct explorer *e, int layout, const double par[], double b_most, double V_least, double V_top);

/* Lets the element NAME=VALUE of the network be searched too; LIBMLG_NONE: there is none. */
int explore_free(struct explorer *e, const char *name);

/* The largest least damping ratio, or the first above `enough`; the widest zero-shimmy
 * interval, or that of the largest hi/lo, for a network with no other free element; the
 * largest load.  given: a place to begin with, or NULL; of a load it has to be a good one. */
void explore_zeta(struct explorer *e, int starts, const double given[], double enough, struct found *found);
void explore_interval(struct explorer *e, int of_ratio, int starts, const double given[], struct found *found);
void explore_load(struct explorer *e, const double given[], struct found *found);

#endif
