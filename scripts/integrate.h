/* integrate.h - time integration of a layout with SUNDIALS CVODE
 *
 * Included after a layout file:
 *
 *   #define MLG_NO_AUTO
 *   #include LAYOUT
 *   #include "integrate.h"
 *
 *   struct integrator run;
 *   integrator_begin(&run, 1e-10);
 *   integrator_section(&run, DPSI, -1);              peaks of psi
 *   integrator_start(&run, par, u);                  at t = 0; again as often as wanted
 *   while ((reached = integrator_advance(&run, t_end)) > AT_TIME)
 *     ...                                            run.t, run.u: a peak, or a limit
 *   integrator_end(&run);
 *
 * Times in s, states in the units of models/mlg.h.  Starting again keeps all
 * memory, so that thousands of runs cost their steps only.
 *
 * Adams methods of order up to 12, whose equations are solved by Newton's
 * iteration with a dense matrix.
 *
 * The tyre's self-aligning moment has a slope jump where a slip angle passes
 * alpha_m (26).  CVODE locates that time and starts anew there, for its formulas
 * assume smoothness; such limits are counted, and a run says when it meets one.
 * (Past it and back within one step goes unseen, at the error the step allows.)
 */
#ifndef MLG_INTEGRATE_H
#define MLG_INTEGRATE_H

#include <stdio.h>
#include <string.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#if SUNDIALS_VERSION_MAJOR < 7
#define SUN_COMM_NULL NULL
#define integrator_silent(run) CVodeSetErrFile((run)->cvode, NULL)
#else
#define integrator_silent(run) SUNContext_ClearErrHandlers((run)->context)
#endif

/* What integrator_advance came to. */
enum reached {
  FAILED = -1,   /* run.error says why, in one line; run.t and run.u are of the last good step */
  AT_TIME,       /* the time asked for */
  AT_SECTION,    /* a crossing of the section before it */
  AT_LIMIT       /* a tyre whose slip angle passes alpha_m before it */
};

struct integrator {
  double t, u[NDIM];             /* where the run is: time, s, and states */
  long limits;                   /* how often a slip angle passed alpha_m since the start */
  char error[200];               /* why it failed */

  double par[36], rtol;
  int section;                   /* the state whose passages through 0 are met, -1: none */
  int refused;                   /* whether the last states asked for have no rates */
  SUNContext context;
  N_Vector vector;               /* around u */
  SUNMatrix matrix;
  SUNLinearSolver solver;
  void *cvode;
};

/* What a state counts in: 1 rad, 1 m, 100 rad/s. */
static const double state_size[] = {
#define X(id, name, unit, meaning) sizeof unit == sizeof "rad/s" ? 100. : 1.,
  MLG_STATES(X)
#undef X
};

/* The size of an oscillation: its largest state, so counted. */
static inline double oscillation_size(const double u[])
{
  double size = 1e-12; /* below that a gear is at rest */

  for (int i = 0; i < NDIM; i++)
    size = fmax(size, fabs(u[i]) / state_size[i]);
  return size;
}

/* 1 bids CVODE try a smaller step; it ends when that does not help. */
static int integrator_rates(sunrealtype t, N_Vector u, N_Vector du, void *data)
{
  struct integrator *run = data;
  const double *x = N_VGetArrayPointer(u);
  double *f = N_VGetArrayPointer(du);

  (void)t;
  right_hand_side(run->par, x, f);
  run->refused = fabs(x[DELTA]) > MLG_PI / 2. || fabs(x[PSI]) > MLG_PI / 2.;
  for (int i = 0; i < NDIM; i++)
    run->refused |= !isfinite(f[i]);
  return run->refused;
}

/* Error weights: each state to rtol times the size of the oscillation, so that
 * small oscillations are as exact as large ones, and a state that passes 0 as
 * well as one that does not. */
static int integrator_weights(N_Vector u, N_Vector weights, void *data)
{
  const struct integrator *run = data;
  const double size = oscillation_size(N_VGetArrayPointer(u));
  double *w = N_VGetArrayPointer(weights);

  for (int i = 0; i < NDIM; i++)
    w[i] = 1. / (run->rtol * size * state_size[i]);
  return 0;
}

enum { LIMIT_L, LIMIT_R, SECTION, ROOTS };

static int integrator_roots(sunrealtype t, N_Vector u, sunrealtype g[], void *data)
{
  const struct integrator *run = data;
  const double *x = N_VGetArrayPointer(u), limit = run->par[PAR_L] * tan(run->par[PAR_ALPHA_M]);

  (void)t;
  g[LIMIT_L] = fabs(x[LAMBDA_L]) - limit;
  g[LIMIT_R] = fabs(x[LAMBDA_R]) - limit;
  g[SECTION] = run->section < 0 ? 1. : x[run->section];
  return 0;
}

/* Frees all; also after a begin that failed. */
static inline void integrator_end(struct integrator *run)
{
  CVodeFree(&run->cvode);
  SUNLinSolFree(run->solver);
  SUNMatDestroy(run->matrix);
  N_VDestroy(run->vector);
  SUNContext_Free(&run->context);
}

/* Makes ready for runs with the relative tolerance rtol of a step; 0, or -1 when
 * memory is short. */
static inline int integrator_begin(struct integrator *run, double rtol)
{
  *run = (struct integrator){ .rtol = rtol, .section = -1 };
  mlg_defaults(run->par);
  if (SUNContext_Create(SUN_COMM_NULL, &run->context) != 0
      || !(run->vector = N_VMake_Serial(NDIM, run->u, run->context))
      || !(run->matrix = SUNDenseMatrix(NDIM, NDIM, run->context))
      || !(run->solver = SUNLinSol_Dense(run->vector, run->matrix, run->context))
      || !(run->cvode = CVodeCreate(CV_ADAMS, run->context))
      || integrator_silent(run) != CV_SUCCESS
      || CVodeInit(run->cvode, integrator_rates, 0., run->vector) != CV_SUCCESS
      || CVodeWFtolerances(run->cvode, integrator_weights) != CV_SUCCESS
      || CVodeSetUserData(run->cvode, run) != CV_SUCCESS
      || CVodeSetLinearSolver(run->cvode, run->solver, run->matrix) != CV_SUCCESS
      || CVodeRootInit(run->cvode, ROOTS, integrator_roots) != CV_SUCCESS
      || CVodeSetNoInactiveRootWarn(run->cvode) != CV_SUCCESS
      || CVodeSetMaxNumSteps(run->cvode, 10 * 1000 * 1000) != CV_SUCCESS) {
    integrator_end(run);
    return -1;
  }
  return 0;
}

/* From here on the run stops where the state passes 0: upwards (direction = 1)
 * or downwards (-1).  (DPSI, -1) are the peaks of psi.  state = -1: nowhere.  A
 * start on the section is no crossing. */
static inline void integrator_section(struct integrator *run, int state, int direction)
{
  int directions[ROOTS] = { 0, 0, direction };

  run->section = state;
  CVodeSetRootDirection(run->cvode, directions);
  CVodeReInit(run->cvode, run->t, run->vector);
}

/* A new run with these parameters from the states u at t = 0. */
static inline void integrator_start(struct integrator *run, const double par[], const double u[])
{
  memcpy(run->par, par, sizeof run->par);
  memmove(run->u, u, sizeof run->u);
  run->t = 0.;
  run->limits = 0;
  CVodeReInit(run->cvode, run->t, run->vector);
}

/* On to the time t, s, or to what comes before it. */
static inline enum reached integrator_advance(struct integrator *run, double t)
{
  int roots[ROOTS], status;

  if (!(t > run->t))
    return AT_TIME;
  status = CVode(run->cvode, t, run->vector, &run->t, CV_NORMAL);
  if (status < 0) {
    snprintf(run->error, sizeof run->error, "t = %.6g s: %s", run->t,
             run->refused ? "an angle passes pi/2, or the rates are not finite"
             : status == CV_TOO_MUCH_WORK ? "the steps are used up" : "the steps become too small");
    return FAILED;
  }
  if (status != CV_ROOT_RETURN)
    return AT_TIME;
  CVodeGetRootInfo(run->cvode, roots);
  if (!roots[LIMIT_L] && !roots[LIMIT_R])
    return AT_SECTION;
  run->limits += (roots[LIMIT_L] != 0) + (roots[LIMIT_R] != 0);
  CVodeReInit(run->cvode, run->t, run->vector);
  return AT_LIMIT;
}

#endif
