/* positive_real.h - any passive device of an order, as numbers without a constraint
 *
 * What a device of springs, dampers, inerters and levers can do at its two ends, and no more, is
 * to have a positive-real impedance Z(s)/s, torque over rate of twist (Brune 1931; Smith 2002).
 * A static stiffness of at least K_least is a pole at 0 of at least that residue; it may be taken
 * out, and what is left is positive real: the device is a spring K >= K_least beside any
 * impedance G(s).  G without pole at infinity, of m states, is
 *
 *   x' = (J - R) x + (B - P) u,   T = (B + P)' x + D u,   J = -J',   | R  P |
 *                                                                   | P' D | >= 0
 *
 * and every G of this kind is positive real, every positive-real one of that kind (the energy
 * x'x/2 rises by at most T u; Willems 1972).  With K/s the device has order n = m + 1.  The
 * matrix above is L L', L triangular, so that all entries are free: no constraint is left but
 * K >= K_least.  A pole at infinity, an inerter beside all, is a limit of these.
 */
#ifndef MLG_POSITIVE_REAL_H
#define MLG_POSITIVE_REAL_H

#include <complex.h>

#include "libmlg.h"

enum { MOST_M = 5, MOST_VARIABLES = (MOST_M + 1) * (MOST_M + 2) / 2 + MOST_M * (MOST_M + 1) / 2 + 1 };
enum { MOST_SPEEDS = 128 };

#define PASSIVE_UNIT 0.02 /* below it the variables are even, above it logarithmic */

/* A gear, and the device that was set last: layout is that of device_rational(m), its c_d in par[]. */
struct passive {
  int layout, m;
  double par[LIBMLG_MOST_PARAMETERS], V_least, V_top, K, K_least;
  double softness, V[MOST_SPEEDS]; /* of passive_value */
  int speeds;
};

/* How many numbers y[] a device with m states beside its spring has. */
int passive_variables(int m);

/* Makes y[] the device of p. */
void passive_set(struct passive *p, const double y[]);

/* The dynamic stiffness of the device, without k_psi, N m/rad, at s, 1/s. */
double _Complex passive_stiffness(const struct passive *p, double _Complex s);

/* The least ratio of the device y[] over all speeds, exactly; as libmlg_least_ratio. */
int passive_least(struct passive *p, const double y[], struct libmlg_ratio *ratio);

/* The softened least ratio over the speeds V[] of p, smooth in y[n], -1 where there is none, and
 * its slopes by y unless NULL. */
double passive_value(struct passive *p, double y[], int n, double slope[]);

#endif
