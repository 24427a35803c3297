/* characteristic.h - the gear with its device, linearised at straight rolling
 *
 * With delta, psi and lambda = lambda_L = lambda_R growing as exp(s t) the
 * linearised equations have a solution where F(s) = 0,
 *
 *              | A11   A12      D1 |
 *   F = den det| A12   A22+Z    D2 |        Z = num/den of the device
 *              | -L s  -p   s + V/l|
 *
 *   A11 = M11 s^2 + c_delta s + K11, A12 = M12 s^2 + K12,
 *   A22 = M22 s^2 + c_psi s + K22,   p = V cos(phi) + (e_t - h cos(phi)) s.
 * (The difference lambda_L - lambda_R decays as exp(-V t / l) by itself.)
 * F is a polynomial in s, and affine in V, in c_d, in 1/k_s and in b each:
 * at fixed s every Hopf point follows from a quadratic.
 */
#ifndef MLG_CHARACTERISTIC_H
#define MLG_CHARACTERISTIC_H

#include <string.h>

#include "linearised.h"

/* F(s; V, c_d) = f[0][0] + f[1][0] V + f[0][1] c_d + f[1][1] V c_d */
struct characteristic { struct poly f[2][2]; };

/* Determinants of the gear without device: whole, and the minor that Z multiplies. */
static inline void gear_determinants(const double par[], double V, struct poly *whole,
                                     struct poly *minor)
{
  const struct gear_matrix g = gear_matrix(par, V);
  const struct poly psi = poly_sum(poly_product(g.A22, g.tyre), poly_scaled(g.p, g.D2));
  const struct poly cross = poly_sum(poly_product(g.A12, g.tyre), poly_scaled(g.Ls, g.D2));
  const struct poly delta = poly_sum(poly_product(g.A22, g.Ls),
                                     poly_scaled(poly_product(g.A12, g.p), -1.));

  *whole = poly_sum(poly_sum(poly_product(g.A11, psi),
                             poly_scaled(poly_product(g.A12, cross), -1.)),
                    poly_scaled(delta, g.D1));
  *minor = poly_sum(poly_product(g.A11, g.tyre), poly_scaled(g.Ls, g.D1));
}

/* F for the device and gear of par; its V and c_d do not matter.  Being affine,
 * F follows from its values at V and c_d of 0 and at V and c_d of the size of
 * interest: between neighbouring values the difference would be rounding. */
static inline struct characteristic characteristic(const double par[])
{
  const double V = 100., c_d = 1e4;
  double p[MLG_SLOTS];
  struct characteristic F;
  struct network Z[2];
  struct poly whole[2], minor[2];

  memcpy(p, par, sizeof p);
  for (int k = 0; k < 2; k++) {
    p[PAR_C_D] = k * c_d;
    Z[k] = device_network(p);
    gear_determinants(par, k * V, &whole[k], &minor[k]);
  }
  for (int v = 0; v < 2; v++)
    for (int k = 0; k < 2; k++)
      F.f[v][k] = poly_sum(poly_product(Z[k].den, whole[v]), poly_product(Z[k].num, minor[v]));
  for (int k = 0; k < 2; k++)
    F.f[1][k] = poly_scaled(poly_sum(F.f[1][k], poly_scaled(F.f[0][k], -1.)), 1. / V);
  for (int v = 0; v < 2; v++)
    F.f[v][1] = poly_scaled(poly_sum(F.f[v][1], poly_scaled(F.f[v][0], -1.)), 1. / c_d);
  return F;
}

/* F and its derivatives at one point. */
struct jet { double _Complex F, F_s, F_V, F_c; };

static inline struct jet jet(const struct characteristic *f, double _Complex s, double V, double c)
{
  const double _Complex f00 = poly_value(&f->f[0][0], s), f10 = poly_value(&f->f[1][0], s);
  const double _Complex f01 = poly_value(&f->f[0][1], s), f11 = poly_value(&f->f[1][1], s);

  return (struct jet){
    f00 + f10 * V + (f01 + f11 * V) * c,
    poly_derivative(&f->f[0][0], s) + poly_derivative(&f->f[1][0], s) * V
      + (poly_derivative(&f->f[0][1], s) + poly_derivative(&f->f[1][1], s) * V) * c,
    f10 + f11 * c,
    f01 + f11 * V,
  };
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
