/* linearised.h - the gear at straight rolling, linearised, without its device
 *
 * With delta, psi and lambda = lambda_L = lambda_R growing as exp(s t) the matrix of
 * their equations is (docs/model.md; mlg.h comes before this)
 *
 *   | A11   A12      D1 |   A11 = M11 s^2 + c_delta s + K11, A12 = M12 s^2 + K12,
 *   | A12   A22+Z    D2 |   A22 = M22 s^2 + c_psi s + K22, Z of the device,
 *   | -L s  -p   s + V/l|   p = V cos(phi) + (e_t - h cos(phi)) s.
 */
#ifndef MLG_LINEARISED_H
#define MLG_LINEARISED_H

#include "network.h"

/* The entries of the matrix above, without the device. */
struct gear_matrix { struct poly A11, A12, A22, Ls, p, tyre; double D1, D2; };

static inline struct gear_matrix gear_matrix(const double par[], double V)
{
  const double a = par[PAR_A], l = par[PAR_L], h = par[PAR_H], g = par[PAR_G];
  const double m_D = par[PAR_M_D], l_D = par[PAR_L_D], R = par[PAR_R];
  const double k_alpha = par[PAR_K_ALPHA], k_lambda = par[PAR_K_LAMBDA];
  const double s = sin(par[PAR_PHI]), c = cos(par[PAR_PHI]);
  const double F_z = (par[PAR_M] + m_D) * g, e_t = par[PAR_E] + R * s;
  const double L = par[PAR_L_DELTA] + R * c;
  const double m = a * a * m_D / 4., kappa = a * a * par[PAR_K_T] / 2.;

  return (struct gear_matrix){
    .A11 = { { par[PAR_K_DELTA] - F_z * L * c + kappa * c * c + m_D * g * l_D * c,
               par[PAR_C_DELTA], par[PAR_J_XI] + m_D * l_D * l_D + m * c * c } },
    .A12 = { { -F_z * e_t * c + kappa * c * s, 0., m * c * s } },
    .A22 = { { -F_z * e_t * s + kappa * s * s, par[PAR_C_PSI], par[PAR_J_ZETA] + m * s * s } },
    .Ls = { { 0., L } },
    .p = { { V * c, e_t - h * c } },
    .tyre = { { V / l, 1. } },
    .D1 = F_z * (7. * k_lambda * L - k_alpha * s) / l,
    .D2 = F_z * (7. * k_lambda * e_t + k_alpha * c) / l,
  };
}

/* Where an oscillation of damping ratio zeta lives: s = omega ray, so that
 * ds/domega = ray; zeta = 0 is the Hopf curve. */
static inline double _Complex mlg_ray(double zeta)
{
  return -zeta + sqrt(1. - zeta * zeta) * I;
}

/* |delta| / |psi| of the oscillation at s; above 1 it is delta-shimmy. */
static inline double delta_over_psi(const double par[], double V, double _Complex s)
{
  const struct gear_matrix g = gear_matrix(par, V);
  const double _Complex D1 = g.D1 / poly_value(&g.tyre, s);

  return cabs(poly_value(&g.A12, s) + D1 * poly_value(&g.p, s))
         / cabs(poly_value(&g.A11, s) + D1 * poly_value(&g.Ls, s));
}

#endif
