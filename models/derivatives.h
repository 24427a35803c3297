/* derivatives.h - those of a layout's right-hand side by states and parameters
 *
 * The gear's come from jacobian.h.  A device needs nothing of its own: while its
 * elements are linear, it is so in psi, psi' and its states, and its columns are its
 * values at unit vectors; where one of them has a law that is not (elements.h) the device
 * alone, a few formulas, is differenced.  So it is by its parameters, those that the gear
 * does not depend on.
 * plugin.h includes this behind device() and right_hand_side().
 */
#ifndef MLG_DERIVATIVES_H
#define MLG_DERIVATIVES_H

#include "jacobian.h"

#ifdef MLG_APART
#define mlg_slopes(par, u, f, parameters, E) mlg_slopes_apart(par, u, f, parameters, E)
#endif

/* The device by itself: its torque in the place of psi'', and its rates. */
static void device_rates(const double par[], const double u[], double f[])
{
  memset(f, 0, GEAR_STATES * sizeof *f);
  f[DPSI] = torque_on_wheels(par, u, f);
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

/* Column j of a device with laws: the step is small against the corner that is nearest
 * to its scale. */
static inline void device_column(const double par[], const double u[], int j, double df[NDIM])
{
  static const char *const unit[NDIM] = {
#define X(id, name, unit, meaning) unit,
    MLG_STATES(X)
#undef X
  };
  const int is_rate = strcmp(unit[j], "rad/s") == 0;
  double x[NDIM], scale = is_rate ? 1e-1 : 1e-2;

  if (is_rate && par[PAR_V_F] > 0.)
    scale = fmin(scale, par[PAR_V_F]);
  for (int k = PAR_G_PSI; k <= PAR_G_S && !is_rate; k++)
    if (par[k] * par[PAR_CORNER] > 0.)
      scale = fmin(scale, par[k] * par[PAR_CORNER]);
  if (!is_rate && par[PAR_T_F] > 0.) /* the damper's rate follows from its torque */
    scale = fmin(scale, par[PAR_V_F] * par[PAR_C_D] / par[PAR_K_PSI]);
  memcpy(x, u, sizeof x);
  difference(device_rates, par, x, &x[j], fmax(1e-2 * scale, 1e-9), df);
}

/* Relative step for a parameter, and for one of a law, which has corners; and whether it
 * can be differenced: b = 0 leaves the inerter out, 0 a law, and a rigid k_s does not give.
 * There the derivative is 0. */
#define MLG_STEP 5e-4
#define MLG_LAW_STEP 1e-5

static inline int differenced(double value)
{
  return fabs(value) > 0. && fabs(value) < MLG_RIGID;
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
 *   dfdp[j * NDIM + i] = d f_i / d par[j], unless NULL; of AUTO's parameters none, and
 *   0 for the doubts when by_doubts is 0 and none acts, which takes half the time
 * The gear's are exact, and so are those of a linear device; those by its parameters and
 * of a device with laws are differences. */
static inline void some_derivatives(const double par[], const double u[], const double f[], double dfdu[],
                                    double dfdp[], int by_doubts)
{
  struct mlg_slopes E;
  const int laws = mlg_has_laws(par);
  double p[MLG_SLOTS];

  mlg_slopes(par, u, f, dfdp == NULL ? 0 : by_doubts ? 2 : 1, &E);
  const struct inverse m = inverse(&E);
  for (int j = 0; j < NDIM; j++) {
    double unit[NDIM] = { 0. }, *df = dfdu + j * NDIM;

    unit[j] = 1.;
    if (laws && (j == PSI || j == DPSI || j >= GEAR_STATES))
      device_column(par, u, j, df);
    else
      device_rates(par, unit, df);
    settle_device(&m, df);
    if (j < GEAR_STATES)
      add_gear(&m, E.state[j], df);
  }
  dfdu[DDELTA * NDIM + DELTA] = dfdu[DPSI * NDIM + PSI] = 1.;
  if (dfdp == NULL)
    return;
  memcpy(p, par, sizeof p);
  for (int k = 0; k < MLG_PARAMETER_COUNT; k++) {
    const int j = mlg_parameters[k].slot;
    double *df = dfdp + j * NDIM;

    memset(df, 0, NDIM * sizeof *df);
    if (mlg_of_gear(j))
      add_gear(&m, E.parameter[j], df);
    else if (differenced(p[j])) {
      difference(device_rates, p, u, &p[j], (laws ? MLG_LAW_STEP : MLG_STEP) * p[j], df);
      settle_device(&m, df);
    }
  }
}

/* All of them. */
static inline void derivatives(const double par[], const double u[], const double f[], double dfdu[],
                               double dfdp[])
{
  some_derivatives(par, u, f, dfdu, dfdp, 1);
}

/* How far derivatives() are from differences of right_hand_side() at some state,
 * relative to the largest of each column (or to 1e-4 of f per relative change, as
 * differences round): below 1e-7, unless jacobian.h does not belong to mlg.h, or
 * device() is not what is said above. */
static inline double derivatives_misfit(const double par[])
{
  double u[NDIM], f[NDIM], dfdu[NDIM * NDIM], dfdp[MLG_SLOTS * NDIM], p[MLG_SLOTS], worst = 0.;

  memcpy(p, par, sizeof p);
  for (int i = 0; i < NDIM; i++)
    u[i] = 3e-3 * (i + 1);
  u[LAMBDA_L] = par[PAR_L] * tan(par[PAR_ALPHA_M] / 3.); /* well below alpha_m */
  u[LAMBDA_R] = u[LAMBDA_L] / 2.;
  right_hand_side(par, u, f);
  derivatives(par, u, f, dfdu, dfdp);
  for (int k = 0; k < NDIM + MLG_PARAMETER_COUNT; k++) {
    const int j = k < NDIM ? k : mlg_parameters[k - NDIM].slot;
    const double *df = (k < NDIM ? dfdu : dfdp) + j * NDIM;
    double *x = k < NDIM ? &u[j] : &p[j], near[NDIM], size = 0., off = 0.;

    if (k >= NDIM && !differenced(*x))
      continue;
    difference(right_hand_side, p, u, x, (k < NDIM ? 1e-2 : MLG_STEP) * *x, near);
    for (int i = 0; i < NDIM; i++) {
      size = fmax(size, fmax(fabs(near[i]), 1e-4 * fabs(f[i] / *x)));
      off = fmax(off, fabs(df[i] - near[i]));
    }
    worst = fmax(worst, off / size);
  }
  return worst;
}

#endif
