/* libmlg.h - the landing gear as a C library: rates, eigenvalues, integration
 *
 * For continuation and simulation codes that want the very model AUTO runs, and
 * what the commands of mlg are made of.  Needs nothing of AUTO and no other header
 * of this project; link -lmlg -lm, and behind it -llapacke -llapack for what says
 * LAPACK here, -lsundials_cvode -lsundials_nvecserial for what says SUNDIALS.
 * `make libmlg` builds build/lib/libmlg.a and build/lib/libmlg.so; a layout is in
 * them when its file is in models/.
 *
 * A layout, a parameter and a state each have a number, 0, 1, ..., and a name;
 * numbers may differ from one version to the next, names do not.  SI units and
 * radians.  All functions may be called from several threads at once.
 */
#ifndef LIBMLG_H
#define LIBMLG_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined __GNUC__
#pragma GCC visibility push(default) /* the rest of the library does not show */
#endif

/* The array sizes that are enough for any layout. */
enum { LIBMLG_MOST_PARAMETERS = 64, LIBMLG_MOST_STATES = 32 };

/* Returned for a name or a number that is none; and for a problem without a solution. */
enum { LIBMLG_NONE = -1, LIBMLG_FAILED = -2 };

/* What a parameter or a state is; the texts are not to be freed. */
struct libmlg_quantity {
  const char *name;    /* as in AUTO's constants files: "c_d" */
  const char *unit;    /* "N m s/rad"; "-": a pure number */
  const char *meaning; /* "device damping" */
};

/* --- layouts ----------------------------------------------------------------- */

int libmlg_layouts(void);                   /* how many there are */
int libmlg_layout(const char *name);        /* number of "l1", or LIBMLG_NONE */
const char *libmlg_layout_name(int layout); /* NULL: no such layout */

/* --- states: those of the gear, then those of the device ----------------------- */

int libmlg_states(int layout); /* how many, or LIBMLG_NONE: no such layout */
int libmlg_state(int layout, const char *name); /* number of "psi", or LIBMLG_NONE */
const struct libmlg_quantity *libmlg_state_quantity(int layout, int state); /* or NULL */

/* --- parameters: the same for every layout --------------------------------------- */

int libmlg_parameters(void);             /* how many there are */
int libmlg_parameter(const char *name);  /* number of "c_d", or LIBMLG_NONE */
const struct libmlg_quantity *libmlg_parameter_quantity(int parameter); /* or NULL */

/* The default, that of the paper's gear at V = 1 m/s, c_d = 3.6e4 N m s/rad,
 * k_s rigid, b = 0.  NaN: no such parameter. */
double libmlg_default(int parameter);

/* The least and the largest value it may have; a k_s of 1e30 or infinity is rigid.
 * NaN: no such parameter. */
double libmlg_least(int parameter);
double libmlg_most(int parameter);

/* Defaults into par[libmlg_parameters()]. */
void libmlg_defaults(double par[]);

/* The first parameter outside its range, or LIBMLG_NONE: all are inside. */
int libmlg_outside(const double par[]);

/* 1 where the rates of the layout depend on the parameter, 0 where its device has no such
 * element (l1 has no k_s and no b), LIBMLG_NONE: no such layout or parameter. */
int libmlg_uses(int layout, int parameter);

/* --- the equations ----------------------------------------------------------------- */

/* f[] = u' for states u[], both libmlg_states(layout) long, at the parameters
 * par[libmlg_parameters()]; rates are per second.  The ranges are not looked at
 * (libmlg_outside does that).  c_d = 0, b = 0 and a rigid k_s may be given.
 * Returns 0, or LIBMLG_NONE: no such layout, f[] as it was. */
int libmlg_rhs(int layout, const double par[], const double u[], double f[]);

/* Its derivatives there, n = libmlg_states(layout):
 *   dfdu[j * n + i] = d f_i / d u_j,   dfdp[k * n + i] = d f_i / d par[k]
 * dfdp may be NULL.  Exact, but those by the device's own parameters, which are good
 * to 1e-10; 0 for b = 0 and for a rigid k_s.  Returns as libmlg_rhs. */
int libmlg_jacobian(int layout, const double par[], const double u[], double dfdu[], double dfdp[]);

/* The torque T_d, N m, that the device takes from the wheels at the states u[].
 * Returns as libmlg_rhs. */
int libmlg_torque(int layout, const double par[], const double u[], double *T_d);

/* --- straight rolling, linearised (LAPACK) --------------------------------------------- */

/* Eigenvalues re[i] + i im[i], 1/s, of the Jacobian at u = 0, by falling real part, of a
 * pair the one above the axis first; *n of them, at most libmlg_states(layout).  Those of
 * states that have no equation of their own are left out: without inerter or with a
 * rigid k_s a layout lets such a state follow its value at 1000/s (models/mlg.h), so that
 * its row or its column of the Jacobian is 0 but for -1000 on the diagonal.
 * Rounding is some 1e-16 of the norm of the balanced Jacobian, about 1e-11/s.
 * Returns 0, LIBMLG_NONE: no such layout, LIBMLG_FAILED: the Jacobian is not finite. */
int libmlg_eigenvalues(int layout, const double par[], double re[], double im[], int *n);

/* An oscillation of straight rolling, with growth exp(re t). */
struct libmlg_mode {
  double V;              /* m/s */
  double re, im;         /* its eigenvalue, 1/s, im >= 0 */
  double zeta;           /* damping ratio -re / |re + i im|; below 0 it grows */
  double frequency_hz;   /* im / (2 pi) */
  double delta_over_psi; /* ratio of amplitudes; above 1 it is delta-shimmy */
};

/* The mode of the least damping ratio at the V of par[], above 0.  A real eigenvalue does
 * not oscillate: it has zeta = 1 and never counts; one that grows (divergence) has -1
 * and always does.
 * Returns as libmlg_eigenvalues. */
int libmlg_least_damped(int layout, const double par[], struct libmlg_mode *mode);

/* The same where zeta is least between two speeds, m/s, to 1e-5 of their difference,
 * where one minimum lies there; and over all speeds above 0 up to V_top, from 60 that
 * are dense at low speed. */
int libmlg_least_damped_between(int layout, const double par[], double V_lo, double V_hi,
                                struct libmlg_mode *mode);
int libmlg_least_damped_to(int layout, const double par[], double V_top, struct libmlg_mode *mode);

/* Is the Hopf point of the mode nearest to i omega, rad/s, subcritical (*a > 0: unstable
 * shimmy beside the stable gear) or supercritical?  The amplitude r of psi, rad, obeys
 * r' = sigma r + *a r^3 near it, *a in 1/s per rad^2; for that of delta divide by
 * delta_over_psi^2.  Kuznetsov, Elements of Applied Bifurcation Theory, Section 5.4;
 * derivatives by differences, good to 1e-7.
 * Returns as libmlg_eigenvalues. */
int libmlg_criticality(int layout, const double par[], double omega, struct libmlg_mode *mode, double *a);

/* d(re)/d(parameter) of the mode nearest to re + i im, 1/s per its unit; good to 1e-8. */
int libmlg_growth_slope(int layout, const double par[], const struct libmlg_mode *mode, int parameter,
                        double *slope);

/* --- integration in time (SUNDIALS) ---------------------------------------------------- */

/* A run.  Starting again keeps all memory, so that thousands of runs cost their steps
 * only:
 *
 *   libmlg_run_begin(&run, layout, 1e-10);
 *   libmlg_run_section(&run, libmlg_state(layout, "dpsi"), -1);   peaks of psi
 *   libmlg_run_start(&run, par, u);                               at t = 0
 *   while ((reached = libmlg_run_to(&run, t_end)) > LIBMLG_AT_TIME)
 *     ...                                                         run.t, run.u: a peak, or a limit
 *   libmlg_run_end(&run);
 *
 * The struct may not be copied or moved meanwhile. */
struct libmlg_run {
  double t, u[LIBMLG_MOST_STATES]; /* where it is: time, s, and states */
  long limits;                     /* how often a slip angle passed alpha_m since the start */
  char error[200];                 /* why it failed, in one line */
  struct libmlg_integrator *integrator; /* its own */
};

/* What libmlg_run_to comes to. */
enum {
  LIBMLG_AT_TIME,    /* the time asked for */
  LIBMLG_AT_SECTION, /* a crossing of the section before it */
  LIBMLG_AT_LIMIT    /* a tyre whose slip angle passes alpha_m before it */
};

/* Makes ready for runs with the relative tolerance rtol of a step, relative to the size
 * of the oscillation.  Returns 0, LIBMLG_NONE: no such layout, LIBMLG_FAILED: memory is
 * short. */
int libmlg_run_begin(struct libmlg_run *run, int layout, double rtol);

/* A new run from the states u[] at t = 0. */
void libmlg_run_start(struct libmlg_run *run, const double par[], const double u[]);

/* From here on the run stops where the state passes 0: upwards (direction 1), downwards
 * (-1) or both ways (0).  State -1: nowhere.  A start on the section is no crossing. */
void libmlg_run_section(struct libmlg_run *run, int state, int direction);

/* On to the time t, s, or to what comes before it; LIBMLG_FAILED: run->error says why, and
 * run->t and run->u are of the last good step. */
int libmlg_run_to(struct libmlg_run *run, double t);

/* Frees all; also after a begin that failed, or a second time. */
void libmlg_run_end(struct libmlg_run *run);

/* What a state counts in: 1 rad, 1 m or 100 rad/s; and the size of an oscillation: its
 * largest state so counted, 1e-12 at least.  NaN, and 1e-12: no such layout or state. */
double libmlg_state_size(int layout, int state);
double libmlg_oscillation_size(int layout, const double u[]);

#if defined __GNUC__
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif

#endif
