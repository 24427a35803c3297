/* linearised.h - the gear at straight rolling, linearised, without its device
 *
 * With delta, psi and lambda = lambda_L = lambda_R growing as exp(s t) the matrix of
 * their equations is (docs/model.md; mlg.h comes before this)
 *
 *   | A11   A12      D1 |   A11 = M11 s^2 + c_delta s + K11, A12 = M12 s^2 + K12,
 *   | A21   A22+Z    D2 |   A22 = M22 s^2 + c_psi s + K22, Z of the device, A21 = A12,
 *   | -q    -p   s + V/l|   q = L s, p = V cos(phi) + (e_t - h cos(phi)) s.
 *
 * Of the doubts (mlg.h) zB_shared and R_moves take from the roll inertia m in M11, M12 and
 * M22; with heading q = (L + h sin(phi)) s - V sin(phi); I_p adds s I_p V/R to A12 and takes
 * it from A21; N12_out is not of this order.
 */
#ifndef MLG_LINEARISED_H
#define MLG_LINEARISED_H

#include "network.h"

/* The entries of the matrix above, without the device; [v] is the part with V^v. */
struct gear_matrix { struct poly A11, A22, A12[2], A21[2], q[2], p[2], tyre[2]; double D1, D2; };

static inline struct gear_matrix gear_matrix(const double par[])
{
  const double a = par[PAR_A], l = par[PAR_L], h = par[PAR_H], g = par[PAR_G];
  const double m_D = par[PAR_M_D], l_D = par[PAR_L_D], R = par[PAR_R];
  const double k_alpha = par[PAR_K_ALPHA], k_lambda = par[PAR_K_LAMBDA];
  const double s = sin(par[PAR_PHI]), c = cos(par[PAR_PHI]);
  const double F_z = (par[PAR_M] + m_D) * g, e_t = par[PAR_E] + R * s;
  const double L = par[PAR_L_DELTA] + R * c, bent = par[PAR_HEADING] * s, spin = par[PAR_I_P] / R;
  const double m = a * a * m_D / 4. * (1. - par[PAR_ZB_SHARED]) * (1. - 0.2 * par[PAR_R_MOVES]);
  const double kappa = a * a * par[PAR_K_T] / 2., K12 = -F_z * e_t * c + kappa * c * s;

  return (struct gear_matrix){
    .A11 = { { par[PAR_K_DELTA] - F_z * L * c + kappa * c * c + m_D * g * l_D * c,
               par[PAR_C_DELTA], par[PAR_J_XI] + m_D * l_D * l_D + m * c * c } },
    .A22 = { { -F_z * e_t * s + kappa * s * s, par[PAR_C_PSI], par[PAR_J_ZETA] + m * s * s } },
    .A12 = { { { K12, 0., m * c * s } }, { { 0., spin } } },
    .A21 = { { { K12, 0., m * c * s } }, { { 0., -spin } } },
    .q = { { { 0., L + h * bent } }, { { -bent } } },
    .p = { { { 0., e_t - h * c } }, { { c } } },
    .tyre = { { { 0., 1. } }, { { 1. / l } } },
    .D1 = F_z * (7. * k_lambda * L - k_alpha * s) / l,
    .D2 = F_z * (7. * k_lambda * e_t + k_alpha * c) / l,
  };
}

/* The highest power of V in its determinant, 3 with I_p, and the room for all. */
enum { GEAR_SPEEDS = 4 };

static inline int gear_speeds(const double par[])
{
  return par[PAR_I_P] != 0. ? 3 : 1;
}

/* Adds a A B V^(v + w) to sum[], sum[v + w]. */
static inline void gear_add(struct poly sum[], int power, struct poly term, double sign)
{
  sum[power] = poly_sum(sum[power], sign < 0. ? poly_scaled(term, -1.) : term);
}

/* Determinants of the gear without device, by powers of V: whole, and the minor that Z
 * multiplies. */
static inline void gear_determinants(const double par[], struct poly whole[GEAR_SPEEDS],
                                     struct poly minor[GEAR_SPEEDS])
{
  const struct gear_matrix g = gear_matrix(par);
  const int turns = gear_speeds(par) > 1; /* A12 and A21 have a part with V */

  for (int v = 0; v < GEAR_SPEEDS; v++)
    whole[v] = minor[v] = (struct poly){ { 0. } };
  for (int v = 0; v < 2; v++) { /* of the row of the tyre */
    gear_add(whole, v, poly_product(g.A11, poly_sum(poly_product(g.A22, g.tyre[v]), poly_scaled(g.p[v], g.D2))), 1.);
    for (int w = 0; w <= turns; w++) {
      gear_add(whole, v + w, poly_scaled(poly_product(g.A12[w], g.q[v]), g.D2), -1.);
      gear_add(whole, v + w, poly_scaled(poly_product(g.A21[w], g.p[v]), g.D1), -1.);
      for (int x = 0; x <= turns; x++)
        gear_add(whole, v + w + x, poly_product(poly_product(g.A12[w], g.A21[x]), g.tyre[v]), -1.);
    }
    gear_add(whole, v, poly_scaled(poly_product(g.A22, g.q[v]), g.D1), 1.);
    minor[v] = poly_sum(poly_product(g.A11, g.tyre[v]), poly_scaled(g.q[v], g.D1));
  }
}

/* Where an oscillation of damping ratio zeta lives: s = omega ray, so that
 * ds/domega = ray; zeta = 0 is the Hopf curve. */
static inline double _Complex mlg_ray(double zeta)
{
  return -zeta + sqrt(1. - zeta * zeta) * I;
}

/* An entry of the matrix at s and V. */
static inline double _Complex gear_entry(const struct poly entry[2], double V, double _Complex s)
{
  return poly_value(&entry[0], s) + V * poly_value(&entry[1], s);
}

/* |delta| / |psi| of the oscillation at s. */
static inline double delta_over_psi(const double par[], double V, double _Complex s)
{
  const struct gear_matrix g = gear_matrix(par);
  const double _Complex D1 = g.D1 / gear_entry(g.tyre, V, s);

  return cabs(gear_entry(g.A12, V, s) + D1 * gear_entry(g.p, V, s))
         / cabs(poly_value(&g.A11, s) + D1 * gear_entry(g.q, V, s));
}

#endif
