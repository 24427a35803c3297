/* cma.h - the largest value of a function of a few variables, without slopes; private to
 * libmlg and the commands
 *
 * Hansen and Ostermeier's evolution strategy with covariance matrix adaptation, as in
 * N. Hansen, "The CMA evolution strategy: a tutorial", arXiv:1604.00772, Table 1 and Fig. 6,
 * with positive weights.  Only the order of the values counts, so that kinks, jumps and
 * places without a value (-INFINITY) do no harm.  One run finds one maximum, not always the
 * largest: begin at many places and say how many of them came to the best.
 */
#ifndef LIBMLG_CMA_H
#define LIBMLG_CMA_H

enum { CMA_MOST = 64 };

/* Numbers uniform in 0 to 1, and normal ones; the same for the same seed everywhere. */
struct cma_random { unsigned long long state; };
double cma_uniform(struct cma_random *r);
double cma_normal(struct cma_random *r);

/* From x[n], 0 <= x <= 1, n <= CMA_MOST, with steps of size sigma to begin with, until steps
 * are below 1e-12, `most` values were asked for or one is above `enough`.  What leaves the box is reflected at its
 * walls.  x[] becomes the best place, *best its value.  Returns the number of values asked for, or
 * -1: LAPACK failed. */
int cma_largest(double f(const double x[], void *context), void *context, int n, double x[], double sigma,
                struct cma_random *random, int most, double enough, double *best);

#endif
