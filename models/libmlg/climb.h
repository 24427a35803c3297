/* climb.h - the top of a least of smooth functions of a few variables, with slopes; private to
 * libmlg and the commands
 *
 * A least damping ratio, or a load or tolerance that the first of several modes or corners
 * ends, is f(x) = min over i of f_i(x), each f_i smooth: its top lies in a corner of two or
 * more of them, or on a ridge between them, where methods that only compare values creep and
 * those that trust one slope zigzag.  Here the f_i that are least at the best place and at the
 * places tried about it make a model, the least of straight lines; its top within a box about the
 * best place, a linear programme, is the next place.  The box grows
 * where the model does well and shrinks where it does not, as in Schramm and Zowe's bundle
 * trust method, SIAM J. Optim. 2 (1992) 121-152.
 */
#ifndef LIBMLG_CLIMB_H
#define LIBMLG_CLIMB_H

enum { CLIMB_MOST = 8 };

/* One of the f_i at a place: its value and its slopes. */
struct climb_piece { double value, slope[CLIMB_MOST]; };

/* The pieces that are least or nearly so at x[n], CLIMB_PIECES at most; the least of them is f(x).
 * Returns how many, 0: there is no value. */
enum { CLIMB_PIECES = 16 };
typedef int climb_function(const double x[], struct climb_piece piece[], void *context);

/* From x[n], 0 <= x <= 1, n <= CLIMB_MOST, with a box of half-width `radius` to begin with, until
 * that is below 1e-9 or the value above `enough`; after about `most` values in any case.  x[] becomes
 * the best place, *best its value.  Returns the number of values asked for. */
int climb_largest(climb_function *f, void *context, int n, double x[], double radius, int most, double enough,
                  double *best);

#endif
