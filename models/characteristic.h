/* characteristic.h - the gear with its device, linearised at straight rolling
 *
 * With delta, psi and lambda = lambda_L = lambda_R growing as exp(s t) the
 * linearised equations have a solution where F(s) = 0,
 *
 *              | A11   A12      D1 |
 *   F = den det| A21   A22+Z    D2 |        Z = num/den of the device
 *              | -q    -p   s + V/l|
 *
 * with the entries of linearised.h.  (The difference lambda_L - lambda_R decays as
 * exp(-V t / l) by itself.)  F is a polynomial in s, affine in c_d, in 1/k_s and in b each,
 * and in V but with I_p, where it is cubic: without it every Hopf point at fixed s follows
 * from a quadratic.
 */
#ifndef MLG_CHARACTERISTIC_H
#define MLG_CHARACTERISTIC_H

#include <string.h>

#include "linearised.h"

/* F(s; V, c_d) = sum of f[v][k] V^v c_d^k, v up to speeds. */
struct characteristic { struct poly f[GEAR_SPEEDS][2]; int speeds; };

/* F for the device and gear of par; its V and c_d do not matter.  Being affine, the
 * device follows from its values at c_d of 0 and of the size of interest: between
 * neighbouring values the difference would be rounding. */
static inline struct characteristic characteristic(const double par[])
{
  const double c_d = 1e4;
  double p[MLG_SLOTS];
  struct characteristic F = { .speeds = gear_speeds(par) };
  struct network Z[2];
  struct poly whole[GEAR_SPEEDS], minor[GEAR_SPEEDS];

  memcpy(p, par, sizeof p);
  for (int k = 0; k < 2; k++) {
    p[PAR_C_D] = k * c_d;
    Z[k] = device_network(p);
  }
  gear_determinants(par, whole, minor);
  for (int v = 0; v <= F.speeds; v++) {
    for (int k = 0; k < 2; k++)
      F.f[v][k] = poly_sum(poly_product(Z[k].den, whole[v]), poly_product(Z[k].num, minor[v]));
    F.f[v][1] = poly_scaled(poly_sum(F.f[v][1], poly_scaled(F.f[v][0], -1.)), 1. / c_d);
  }
  return F;
}

/* F and its derivatives at one point. */
struct jet { double _Complex F, F_s, F_V, F_c; };

static inline struct jet jet(const struct characteristic *f, double _Complex s, double V, double c)
{
  struct jet j = { 0., 0., 0., 0. };

  for (int v = f->speeds; v >= 0; v--) { /* Horner's rule in V */
    const double _Complex f_c = poly_value(&f->f[v][1], s);

    j.F_V = j.F_V * V + j.F;
    j.F = j.F * V + poly_value(&f->f[v][0], s) + f_c * c;
    j.F_s = j.F_s * V + poly_derivative(&f->f[v][0], s) + poly_derivative(&f->f[v][1], s) * c;
    j.F_c = j.F_c * V + f_c;
  }
  return j;
}

/* Im(conj(F_s ray) F_x) vanishes where F_s ray domega + F_x dx = 0 with real
 * domega and dx: where all else has an extremum along the curve F = 0.  For
 * x = V that is a boundary point, an extremum of c_d; for x = c_d one of V. */
static inline double extremum_test(const struct jet *j, double _Complex ray, double _Complex F_x)
{
  return cimag(conj(j->F_s * ray) * F_x);
}

/* The same scaled to the sine of an angle. */
static inline double extremum_sine(const struct jet *j, double _Complex ray, double _Complex F_x)
{
  return extremum_test(j, ray, F_x) / (cabs(j->F_s * ray) * cabs(F_x));
}

/* d2(c_d)/dV2 along the curve F = 0 at a boundary point: positive where c_d is
 * least.  It is -(dG/dV)/Im(conj(F_s ray) F_c), G = Im(conj(F_s ray) F_V). */
static inline double curvature(const struct characteristic *f, double _Complex ray, double omega,
                               double V, double c)
{
  const struct jet j = jet(f, omega * ray, V, c);
  const double dV = -creal(j.F_s * ray / j.F_V); /* per domega */
  const double h = 1e-5 * omega;
  const struct jet left = jet(f, (omega - h) * ray, V - h * dV, c);
  const struct jet right = jet(f, (omega + h) * ray, V + h * dV, c);
  const double dG = extremum_test(&right, ray, right.F_V) - extremum_test(&left, ray, left.F_V);

  return -dG / (2. * h * dV) / extremum_test(&j, ray, j.F_c);
}

#endif
