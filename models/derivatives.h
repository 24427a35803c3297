/* derivatives.h - those of a layout's right-hand side by states and parameters
 *
 * The gear's come from jacobian.h.  The device needs none of its own: it is linear
 * in psi, psi' and its states, so that its columns are its values at unit vectors,
 * and by its few parameters it is differenced.
 * plugin.h includes this behind device() and right_hand_side().
 */
#ifndef MLG_DERIVATIVES_H
#define MLG_DERIVATIVES_H

#include "jacobian.h"

/* The parameters that devices depend on; those of the gear are in jacobian.h. */
static const int device_parameter[] = { PAR_C_D, PAR_K_S, PAR_B, PAR_K_D, PAR_K_PSI };
enum { DEVICE_PARAMETERS = sizeof device_parameter / sizeof *device_parameter };

/* The device by itself: its torque in the place of psi'', and its rates. */
static void device_rates(const double par[], const double u[], double f[])
{
  memset(f, 0, GEAR_STATES * sizeof *f);
  f[DPSI] = device(par, u, f);
}

/* d f/dx by differences of fourth order, exact to about 1e-12; x is one of the
 * numbers in par or u, and h a step small against its scale. */
static inline void difference(void rates(const double par[], const double u[], double f[]),
                              const double par[], const double u[], double *x, double h,
                              double df[NDIM])
{
  const double at = *x;
  double f[4][NDIM];

  for (int k = 0; k < 4; k++) {
    *x = at + h * (k < 2 ? k - 2 : k - 1); /* -2, -1, 1, 2 */
    rates(par, u, f[k]);
  }
  *x = at;
  for (int i = 0; i < NDIM; i++)
    df[i] = (8. * (f[2][i] - f[1][i]) - (f[3][i] - f[0][i])) / (12. * h);
}

/* The step for a parameter. At 0 there is none: b = 0 takes the inerter out. */
static double parameter_step(double value)
{
  return 5e-4 * fabs(value);
}

/* M^-1, where M are the slopes of E (jacobian.h) by delta'' and psi''. */
struct inverse { double M11, M12, M21, M22; };

static inline struct inverse inverse(const struct mlg_slopes *E)
{
  const double M11 = E->dddelta[E_DELTA], M12 = E->ddpsi[E_DELTA];
  const double M21 = E->dddelta[E_PSI], M22 = E->ddpsi[E_PSI], det = M11 * M22 - M12 * M21;

  return (struct inverse){ M22 / det, -M12 / det, -M21 / det, M11 / det };
}

/* Adds to df the slopes of the rates that those of E make. */
static inline void add_gear(const struct inverse *m, const double slope[MLG_EQUATIONS], double df[NDIM])
{
  df[DDELTA] -= m->M11 * slope[E_DELTA] + m->M12 * slope[E_PSI];
  df[DPSI] -= m->M21 * slope[E_DELTA] + m->M22 * slope[E_PSI];
  df[LAMBDA_L] += slope[E_LAMBDA_L];
  df[LAMBDA_R] += slope[E_LAMBDA_R];
}

/* The torque in df, which stands in the equation of psi, makes way for what it does. */
static inline void settle_device(const struct inverse *m, double df[NDIM])
{
  const double torque = df[DPSI];

  df[DDELTA] = -m->M12 * torque;
  df[DPSI] = -m->M22 * torque;
}

/* Derivatives of f at u, where f is right_hand_side():
 *   dfdu[j * NDIM + i] = d f_i / d u_j
 *   dfdp[j * NDIM + i] = d f_i / d par[j], unless NULL; of AUTO's parameters none
 * The gear's are exact, and so are the device's, which is linear in psi, psi' and
 * its own states; those by its parameters are differences. */
static inline void derivatives(const double par[], const double u[], const double f[], double dfdu[],
                               double dfdp[])
{
  struct mlg_slopes E;
  double p[PAR_M + 1];

  mlg_slopes(par, u, f, dfdp != NULL, &E);
  const struct inverse m = inverse(&E);
  for (int j = 0; j < NDIM; j++) {
    double unit[NDIM] = { 0. }, *df = dfdu + j * NDIM;

    unit[j] = 1.;
    device_rates(par, unit, df);
    settle_device(&m, df);
    if (j < GEAR_STATES)
      add_gear(&m, E.state[j], df);
  }
  dfdu[DDELTA * NDIM + DELTA] = dfdu[DPSI * NDIM + PSI] = 1.;
  if (dfdp == NULL)
    return;
  for (int k = 0; k < MLG_GEAR_PARAMETERS; k++) {
    const int j = mlg_gear_parameter[k];

    memset(dfdp + j * NDIM, 0, NDIM * sizeof *dfdp);
    add_gear(&m, E.parameter[j], dfdp + j * NDIM);
  }
  memcpy(p, par, sizeof p);
  for (int k = 0; k < DEVICE_PARAMETERS; k++) {
    const int j = device_parameter[k];
    const double h = parameter_step(p[j]);

    memset(dfdp + j * NDIM, 0, NDIM * sizeof *dfdp);
    if (h > 0.) {
      difference(device_rates, p, u, &p[j], h, dfdp + j * NDIM);
      settle_device(&m, dfdp + j * NDIM);
    }
  }
}

#endif
