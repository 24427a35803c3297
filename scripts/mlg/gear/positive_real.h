/* positive_real.h - any passive device of an order, as numbers without a constraint
 *
 * What a device of springs, dampers, inerters and levers can do at its two ends, and no more, is
 * to have a positive-real impedance Z(s)/s, torque over rate of twist (Brune 1931; Smith 2002).
 * A static stiffness of at least K_least is a pole at 0 of at least that residue; it may be taken
 * out, and what is left is positive real: the device is a spring K >= K_least beside any
 * impedance G(s).  A positive-real G without pole at infinity, of m states, is a network without
 * losses that ends in one damper (Darlington 1939): with the energy x'x/2, J = -J',
 *
 *   x' = J x + b u - r v,   T = b'x + d v,   v = r'x + d u,
 *
 * u the rate of twist, T the torque, v rate and torque of the damper of 1, so that the energy rises by
 * T u - v^2.  One damper is enough: the dissipation of the Kalman-Yakubovich-Popov lemma has
 * the rank of the spectral density of G, one.  Turned into the modes of J the states are oscillators of
 * frequency w, each with b = (b, 0) and r = (r1, r2), and one of frequency 0 where m is odd:
 * 2m + 1 numbers, as many as G has coefficients, and each G but for signs once.  With K/s the device has
 * order n = m + 1.  In closed form, with Phi = (s - J)^-1,
 *
 *   G = b'Phi b + (d - b'Phi r)(d + r'Phi b)/(1 + r'Phi r).
 *
 * A pole at infinity, an inerter beside all, is a limit of these.
 */
#ifndef MLG_POSITIVE_REAL_H
#define MLG_POSITIVE_REAL_H

#include <complex.h>

#include "libmlg.h"

enum { MOST_M = 6, MOST_VARIABLES = 2 * MOST_M + 2 };
enum { MOST_SPEEDS = 128 };

#define PASSIVE_UNIT 0.02 /* below it the variables are even, above it logarithmic */
#define PASSIVE_MOST 16.  /* a variable beyond is far from any device */

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

/* The mode of the device that was set last which has the least ratio at one speed, 1/s. */
double _Complex passive_mode(const struct passive *p, double V);

/* The softened least ratio of the device y[] over the speeds V[] of p, smooth, -1 where there is none, and
 * its slopes by y[]. */
double passive_value(struct passive *p, const double y[], double slope[]);

/* The least ratio over all speeds, exactly, and the slopes of the mode that has it. */
double passive_least_value(struct passive *p, const double y[], double slope[]);

#endif
