/* integrate.c - time integration of a layout with SUNDIALS CVODE 6 or 7
 *
 * Adams methods of order up to 12, whose equations are solved by Newton's iteration
 * with a dense matrix.
 *
 * The tyre's self-aligning moment has a slope jump where a slip angle passes alpha_m
 * (26).  CVODE locates that time and starts anew there, for its formulas assume
 * smoothness; such limits are counted, and a run says when it meets one.  (Past it and
 * back within one step goes unseen, at the error the step allows.)  So it does at the
 * sharp corners of the laws of elements.h: at the ends of a gap, where a relief valve
 * opens, and where the rate of an orifice changes its sign.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "layout.h"

/* CVODE's word on what fails goes nowhere: run->error has it. */
#if SUNDIALS_VERSION_MAJOR >= 7
static int create_context(SUNContext *context)
{
  if (SUNContext_Create(SUN_COMM_NULL, context) != 0)
    return -1;
  return SUNContext_ClearErrHandlers(*context);
}

static int silence(void *cvode)
{
  (void)cvode;
  return CV_SUCCESS;
}
#else
static int create_context(SUNContext *context)
{
  return SUNContext_Create(NULL, context);
}

static int silence(void *cvode)
{
  return CVodeSetErrFile(cvode, NULL);
}
#endif

struct libmlg_integrator {
  const struct libmlg_layout *l;
  double slots[MLG_SLOTS], rtol;
  double state_size[LIBMLG_MOST_STATES];
  int section; /* the state whose passages through 0 are met, -1: none */
  int laws;    /* whether one of elements.h is on */
  int refused; /* whether the last states asked for have no rates */
  long counted; /* steps since CVODE started anew that are in run->steps */
  SUNContext context;
  N_Vector vector; /* around run->u */
  SUNMatrix matrix;
  SUNLinearSolver solver;
  void *cvode;
};

double libmlg_state_size(int layout, int state)
{
  const struct libmlg_quantity *q = libmlg_state_quantity(layout, state);

  return !q ? NAN : strcmp(q->unit, "rad/s") == 0 ? 100. : 1.;
}

static double size_of(const struct libmlg_integrator *in, const double u[])
{
  double size = 1e-12; /* below that a gear is at rest */

  for (int i = 0; i < in->l->states; i++)
    size = fmax(size, fabs(u[i]) / in->state_size[i]);
  return size;
}

/* 1 bids CVODE try a smaller step; it ends when that does not help. */
static int rates(sunrealtype t, N_Vector u, N_Vector du, void *data)
{
  struct libmlg_integrator *in = data;
  const double *x = N_VGetArrayPointer(u);
  double *f = N_VGetArrayPointer(du);

  (void)t;
  in->l->rhs(in->l, in->slots, x, f);
  in->refused = fabs(x[DELTA]) > MLG_PI / 2. || fabs(x[PSI]) > MLG_PI / 2.;
  for (int i = 0; i < in->l->states; i++)
    in->refused |= !isfinite(f[i]);
  return in->refused;
}

/* Error weights: each state to rtol times the size of the oscillation, so that small
 * oscillations are as exact as large ones, and a state that passes 0 as well as one
 * that does not. */
static int weights(N_Vector u, N_Vector weight, void *data)
{
  const struct libmlg_integrator *in = data;
  const double size = size_of(in, N_VGetArrayPointer(u));
  double *w = N_VGetArrayPointer(weight);

  for (int i = 0; i < in->l->states; i++)
    w[i] = 1. / (in->rtol * size * in->state_size[i]);
  return 0;
}

enum { LIMIT_L, LIMIT_R, SECTION, CORNER, ROOTS = CORNER + MLG_MOST_CORNERS };

static int roots(sunrealtype t, N_Vector u, sunrealtype g[], void *data)
{
  const struct libmlg_integrator *in = data;
  const double *x = N_VGetArrayPointer(u), limit = in->slots[PAR_L] * tan(in->slots[PAR_ALPHA_M]);

  (void)t;
  g[LIMIT_L] = fabs(x[LAMBDA_L]) - limit;
  g[LIMIT_R] = fabs(x[LAMBDA_R]) - limit;
  g[SECTION] = in->section < 0 ? 1. : x[in->section];
  for (int k = in->laws ? in->l->corners(in->l, in->slots, x, g + CORNER) : 0; k < MLG_MOST_CORNERS; k++)
    g[CORNER + k] = 1.;
  return 0;
}

void libmlg_run_end(struct libmlg_run *run)
{
  struct libmlg_integrator *in = run->integrator;

  if (!in)
    return;
  CVodeFree(&in->cvode);
  SUNLinSolFree(in->solver);
  SUNMatDestroy(in->matrix);
  N_VDestroy(in->vector);
  SUNContext_Free(&in->context);
  free(in);
  run->integrator = NULL;
}

int libmlg_run_begin(struct libmlg_run *run, int layout, double rtol)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  struct libmlg_integrator *in;

  *run = (struct libmlg_run){ .t = 0. };
  if (!l)
    return LIBMLG_NONE;
  in = run->integrator = calloc(1, sizeof *in);
  if (!in)
    return LIBMLG_FAILED;
  in->l = l;
  in->rtol = rtol;
  in->section = -1;
  for (int i = 0; i < l->states; i++)
    in->state_size[i] = libmlg_state_size(layout, i);
  mlg_defaults(in->slots);
  if (create_context(&in->context) != 0
      || !(in->vector = N_VMake_Serial(l->states, run->u, in->context))
      || !(in->matrix = SUNDenseMatrix(l->states, l->states, in->context))
      || !(in->solver = SUNLinSol_Dense(in->vector, in->matrix, in->context))
      || !(in->cvode = CVodeCreate(CV_ADAMS, in->context))
      || silence(in->cvode) != CV_SUCCESS
      || CVodeInit(in->cvode, rates, 0., in->vector) != CV_SUCCESS
      || CVodeWFtolerances(in->cvode, weights) != CV_SUCCESS
      || CVodeSetUserData(in->cvode, in) != CV_SUCCESS
      || CVodeSetLinearSolver(in->cvode, in->solver, in->matrix) != CV_SUCCESS
      || CVodeRootInit(in->cvode, ROOTS, roots) != CV_SUCCESS
      || CVodeSetNoInactiveRootWarn(in->cvode) != CV_SUCCESS) {
    libmlg_run_end(run);
    return LIBMLG_FAILED;
  }
  return 0;
}

double libmlg_run_tolerance(const struct libmlg_run *run)
{
  return run->integrator->rtol;
}

/* Starts anew where the run is. */
static void restart(const struct libmlg_run *run)
{
  CVodeReInit(run->integrator->cvode, run->t, run->integrator->vector);
  run->integrator->counted = 0;
}

void libmlg_run_section(struct libmlg_run *run, int state, int direction)
{
  struct libmlg_integrator *in = run->integrator;
  int directions[ROOTS] = { [SECTION] = direction };

  in->section = state;
  CVodeSetRootDirection(in->cvode, directions);
  restart(run);
}

void libmlg_run_start(struct libmlg_run *run, const double par[], const double u[])
{
  struct libmlg_integrator *in = run->integrator;

  libmlg_slots(par, in->slots);
  memmove(run->u, u, (size_t)in->l->states * sizeof *run->u);
  run->t = 0.;
  run->limits = run->corners = 0;
  in->laws = mlg_has_laws(in->slots);
  restart(run);
}

/* CVODE on to t, its steps counted and at most as many as are left. */
static int integrate(struct libmlg_run *run, double t)
{
  struct libmlg_integrator *in = run->integrator;
  const long left = run->most_steps > 0 ? run->most_steps - run->steps : 10 * 1000 * 1000;
  long steps;
  int status;

  if (left <= 0)
    return CV_TOO_MUCH_WORK;
  CVodeSetMaxNumSteps(in->cvode, left);
  status = CVode(in->cvode, t, in->vector, &run->t, CV_NORMAL);
  CVodeGetNumSteps(in->cvode, &steps);
  run->steps += steps - in->counted;
  in->counted = steps;
  return status;
}

/* One stretch of the way to t; *met where a corner ends it that nobody asked for. */
static int stretch(struct libmlg_run *run, double t, int *met)
{
  struct libmlg_integrator *in = run->integrator;
  int found[ROOTS], status;

  *met = 0;
  if (!(t > run->t))
    return LIBMLG_AT_TIME;
  status = integrate(run, t);
  if (status < 0) {
    snprintf(run->error, sizeof run->error, "t = %.6g s: %s", run->t,
             in->refused ? "an angle passes pi/2, or the rates are not finite"
             : status == CV_TOO_MUCH_WORK ? "the steps are used up" : "the steps become too small");
    return LIBMLG_FAILED;
  }
  if (status != CV_ROOT_RETURN)
    return LIBMLG_AT_TIME;
  CVodeGetRootInfo(in->cvode, found);
  for (int k = CORNER; k < ROOTS; k++)
    *met += found[k] != 0;
  run->corners += *met;
  run->limits += (found[LIMIT_L] != 0) + (found[LIMIT_R] != 0);
  if (*met || found[LIMIT_L] || found[LIMIT_R])
    restart(run);
  if (found[SECTION])
    return LIBMLG_AT_SECTION;
  return LIBMLG_AT_LIMIT;
}

int libmlg_run_to(struct libmlg_run *run, double t)
{
  int reached, met;

  do {
    const long limits = run->limits;

    reached = stretch(run, t, &met);
    met = met && reached == LIBMLG_AT_LIMIT && run->limits == limits;
  } while (met);
  return reached;
}

double libmlg_oscillation_size(int layout, const double u[])
{
  double size = 1e-12;

  for (int i = 0; i < libmlg_states(layout); i++)
    size = fmax(size, fabs(u[i]) / libmlg_state_size(layout, i));
  return size;
}
