/* plugin.h - what AUTO-07p wants around a device: func, stpnt, pvls
 *
 * Included at the end of a layout file, which has included mlg.h and defined
 * NDIM (its number of states) and device().  AUTO's header comes last on
 * purpose: its macros fabs, min and max must not reach the equations.
 *
 * -DMLG_NO_AUTO leaves AUTO out, for programs that want the device or the
 * right-hand side alone.
 * Two more spare the compiler work, where all layouts are built side by side:
 * -DMLG_BOUNDARY gives the device's network alone, to link with boundary.c, and
 * -DMLG_APART leaves the gear's equations to gear.c.
 */
#ifndef MLG_PLUGIN_H
#define MLG_PLUGIN_H

#ifdef MLG_BOUNDARY

/* The device of boundary.c. */
struct network layout_network(const double par[]);

struct network layout_network(const double par[])
{
  return device_network(par);
}

#else

#ifdef MLG_APART
#include "gear.h"
#define mlg_gear mlg_gear_apart
#endif

/* The torque, N m, on the wheels, and the rates of the device's states. */
static inline double torque_on_wheels(const double par[], const double u[], double f[])
{
  const double T_d = device(par, u, f);

  return fabs(par[PAR_T_PSI]) > 0. ? T_d + mlg_wheel_friction(par, u[DPSI]) : T_d;
}

/* f = u' for states u[NDIM] (AUTO calls them ndim of its own). */
static inline void right_hand_side(const double par[], const double u[], double f[])
{
  mlg_gear(par, u, torque_on_wheels(par, u, f), f);
}

#include "derivatives.h"

#ifndef MLG_NO_AUTO

#include "auto_f2c.h"
#include "room.h"

/* AUTO's own: the monodromy matrix of the orbit at hand is -P1^-1 P0. */
extern void getmdmx_(const integer *ndim, double *P0, double *P1, int *known);
/* LAPACK, which AUTO carries: eigenvalues of the pencil (A, B). */
extern void dggev_(const char *jobvl, const char *jobvr, const integer *n, double *A,
                   const integer *lda, double *B, const integer *ldb, double *alpha_re,
                   double *alpha_im, double *beta, double *vl, const integer *ldvl, double *vr,
                   const integer *ldvr, double *work, const integer *lwork, integer *info,
                   size_t len_jobvl, size_t len_jobvr);

/* Whether each parameter that is divided by is above 0, else the device would
 * silently be detached, or all turn into NaN; and no law lacks another.  Says the first
 * that does not hold. */
static int usable(const double par[])
{
  static const int divisor[] = { PAR_K_S, PAR_K_PSI, PAR_L, PAR_ALPHA_M };
  static int said;

  for (size_t i = 0; i < sizeof divisor / sizeof *divisor; i++)
    if (!(par[divisor[i]] > 0.)) {
      for (int k = 0; k < MLG_PARAMETER_COUNT && !said; k++)
        if (mlg_parameters[k].slot == divisor[i])
          said = fprintf(stderr, "PAR(%d) %s = %g %s must be above 0\n", divisor[i] + 1,
                         mlg_parameters[k].name, par[divisor[i]], mlg_parameters[k].unit);
      return 0;
    }
  if (mlg_lacks(par)) {
    if (!said)
      said = fprintf(stderr, "%s\n", mlg_lacks(par));
    return 0;
  }
  return 1;
}

/* Ends the run, at its first call, when the derivatives are not those of the
 * right-hand side: AUTO would go on with wrong eigenvalues. */
static void refuse_misfit(void)
{
  static int fits;
  double par[MLG_SLOTS], misfit;

  if (fits)
    return;
  mlg_defaults(par);
  par[PAR_K_S] = 1e6;
  par[PAR_B] = 100.;
  par[PAR_ZB_SHARED] = par[PAR_R_MOVES] = par[PAR_HEADING] = par[PAR_N12_OUT] = 0.3;
  par[PAR_I_P] = 3.;
  misfit = derivatives_misfit(par);
  if (!(misfit < 1e-6)) {
    fprintf(stderr, "the derivatives are off by %.1g: models/jacobian.h does not fit models/mlg.h, or "
            "models/derivatives.h this device; their heads say more; JAC = 0 does without\n", misfit);
    exit(2);
  }
  fits = 1;
}

/* Whether a doubt is among the free parameters: in AUTO's icp a 0 ends them, and it has
 * room for more than ndim + 7 always.  NULL: all are asked for. */
static int doubt_is_free(integer ndim, const integer *icp)
{
  for (integer i = 0; icp != NULL && i < ndim + 8; i++)
    if (icp[i] <= 0)
      return 0;
    else if (icp[i] > PAR_ZB_SHARED && icp[i] <= PAR_N12_OUT + 1)
      return 1;
  return 1;
}

/* Right-hand side and its derivatives (AUTO's FUNC, JAC = 1); those by parameters
 * at ijac = 2 only, AUTO has no room for them at 1.  Where a parameter is unusable
 * the rates are so large, with a unit Jacobian, that AUTO tries a shorter step (it
 * takes NaN for converged, or goes on for ever), and ends with MX when that does
 * not help. */
int func(integer ndim, const doublereal *u, const integer *icp, const doublereal *par,
         integer ijac, doublereal *f, doublereal *dfdu, doublereal *dfdp)
{
  need_room(MLG_SLOTS);
  if (usable(par)) {
    right_hand_side(par, u, f);
    if (ijac != 0) {
      refuse_misfit();
      some_derivatives(par, u, f, dfdu, ijac == 2 ? dfdp : NULL, ijac == 2 && doubt_is_free(ndim, icp));
    }
    return 0;
  }
  for (integer i = 0; i < ndim; i++) {
    f[i] = 1e10;
    for (integer j = 0; j < ndim && ijac != 0; j++)
      dfdu[j * ndim + i] = i == j;
    for (int k = 0; k < MLG_PARAMETER_COUNT && ijac == 2; k++)
      dfdp[mlg_parameters[k].slot * ndim + i] = 0.;
  }
  return 0;
}

/* Straight rolling with the default parameters (AUTO's STPNT). */
int stpnt(integer ndim, doublereal t, doublereal *u, doublereal *par)
{
  (void)t;
  need_room(MLG_SLOTS);
  mlg_defaults(par);
  for (integer i = 0; i < ndim; i++)
    u[i] = 0.;
  return 0;
}

/* Number of mesh points of the orbit that AUTO hands to pvls, less one; 0 for
 * an equilibrium. */
static int orbit_steps(const double *u)
{
  return getp("DTM", 1, u) > 0. ? (int)(getp("NTS", 0, u) * getp("NCO", 0, u)) : 0;
}

/* Peak of state i, whose time derivative is state rate: cubic Hermite between
 * mesh points, so that it does not hang on where these fall. */
static double orbit_peak(const double *u, double period, int i, int rate)
{
  const int stride = (int)getp("NDX", 0, u), per_interval = (int)getp("NCO", 0, u);
  double peak = u[i];

  for (int j = 0; j < orbit_steps(u); j++) {
    const double *u0 = u + (size_t)j * (size_t)stride, *u1 = u0 + stride;
    const double step = period * getp("DTM", 1 + j / per_interval, u) / per_interval;
    const double v0 = u0[rate] * step, v1 = u1[rate] * step;

    peak = fmax(peak, u1[i]);
    if (v0 > 0. && v1 < 0.) { /* y(x) = u0 + v0 x + p x^2 + q x^3 on 0 <= x <= 1 */
      const double q = 2. * (u0[i] - u1[i]) + v0 + v1;
      const double p = 3. * (u1[i] - u0[i]) - 2. * v0 - v1;
      const double x = v0 / (sqrt(fmax(0., p * p - 3. * q * v0)) - p);

      peak = fmax(peak, u0[i] + x * (v0 + x * (p + x * q)));
    }
  }
  return peak;
}

/* Largest |mu| - 1 of the complex Floquet multipliers mu, -1 without any.  It
 * passes through 0 at every torus point, whereas AUTO's own test looks at the
 * multiplier nearest to the unit circle only, which may be a real one.  Pairs
 * within 0.01 rad of the real axis are the trivial multiplier 1 and a
 * neighbour, split by rounding. */
static double orbit_torus(integer ndim)
{
  double P0[NDIM * NDIM], P1[NDIM * NDIM], re[NDIM], im[NDIM], beta[NDIM], none[1];
  double work[16 * NDIM], largest = 0.;
  const integer one = 1, lwork = 16 * NDIM;
  integer info = 0;
  int known = 0;

  if (ndim != NDIM)
    return -1.;
  getmdmx_(&ndim, P0, P1, &known);
  if (!known)
    return -1.;
  for (int i = 0; i < NDIM * NDIM; i++)
    P1[i] = -P1[i];
  dggev_("N", "N", &ndim, P0, &ndim, P1, &ndim, re, im, beta, none, &one, none, &one, work, &lwork,
         &info, 1, 1);
  for (int i = 0; info == 0 && i < NDIM; i++)
    if (fabs(beta[i]) > 0. && fabs(atan2(im[i], re[i])) > 0.01 && im[i] != 0.)
      largest = fmax(largest, hypot(re[i], im[i]) / fabs(beta[i]));
  return largest - 1.;
}

#include "equilibria.h"

/* Results of a solution (AUTO's PVLS): MLG_RESULTS of mlg.h. */
int pvls(integer ndim, const doublereal *u, doublereal *par)
{
  const double period = par[PAR_PERIOD];
  double hopf[2] = { -1., -1. };

  par[PAR_PSI_MAX] = orbit_peak(u, period, PSI, DPSI) * 180. / MLG_PI;
  par[PAR_DSTAR_MAX] = orbit_peak(u, period, DELTA, DDELTA) * par[PAR_L_DELTA];
  par[PAR_TORUS] = orbit_steps(u) > 0 ? orbit_torus(ndim) : -1.;
  if (orbit_steps(u) == 0)
    hopf_tests(ndim, par, u, hopf);
  par[PAR_HOPF_PSI] = hopf[0];
  par[PAR_HOPF_DELTA] = hopf[1];
  par[PAR_CLOSES] = orbit_steps(u) > 0 ? -1. : closing_test(par);
  par[PAR_F_Z] = (par[PAR_M] + par[PAR_M_D]) * par[PAR_G];
  return 0;
}

#include "unused.h"

#endif /* MLG_NO_AUTO */
#endif /* MLG_BOUNDARY */

#endif
