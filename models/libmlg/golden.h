/* golden.h - golden section; private to libmlg and the commands */
#ifndef LIBMLG_GOLDEN_H
#define LIBMLG_GOLDEN_H

/* The largest value of f between left and right, to a tolerance in x: of one peak for sure.  *at is
 * the best place known before, `largest` its value (-INFINITY: none is known), and then the best of
 * all that were asked, whose value is returned.  Of two places with the same value, as where f says
 * that both are below a floor, the one on the side of *at is kept. */
double golden_largest(double f(double x, void *context), void *context, double left, double right, double tolerance,
                      double *at, double largest);

#endif
