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

/* The number of a device written as text, "k_s-(k_d|c_d|b)" for that of li1, for use wherever
 * a layout's number is asked for: springs k_d, k_s, k=VALUE, dampers c_d, c=VALUE, inerters b,
 * b=VALUE (SI), | between what shares its twist, - what shares its torque, - binding closer,
 * and parentheses; k_psi stands before it all by itself, and c_d has to be in it
 * (docs/networks.md).  The same text has the same number; at most 4096 of them are kept, for
 * the life of the program.  LIBMLG_NONE: it makes no sense, and error[size] says where. */
int libmlg_network(const char *text, char error[], size_t size);

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

/* What a law that is on lacks, in words: friction its v_f, a relief valve its c_r.  NULL:
 * nothing. */
const char *libmlg_lacks(const double par[]);

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
 * to 1e-10, and all of a device with laws (models/elements.h), good to 1e-6 beside its
 * corners; 0 for b = 0, for a rigid k_s and for a law that is 0.  Returns as libmlg_rhs. */
int libmlg_jacobian(int layout, const double par[], const double u[], double dfdu[], double dfdp[]);

/* The torque T_d, N m, that the device takes from the wheels at the states u[].
 * Returns as libmlg_rhs. */
int libmlg_torque(int layout, const double par[], const double u[], double *T_d);

/* The twist *x, rad, that the gap of the torque links has at the states u[] (with the one of
 * k_s, where nothing stands between them), and its half-width *g: a sharp one ends at +-*g.
 * Returns as libmlg_rhs, and LIBMLG_FAILED: it has no gap. */
int libmlg_gap(int layout, const double par[], const double u[], double *x, double *g);

/* --- straight rolling, linearised (LAPACK) ---------------------------------------------
 *
 * Here and wherever straight rolling is looked at, orifice, relief valve and cubic
 * springs are what they are at rest, and play and friction, which have no linearisation
 * there, are left out. */

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
  double delta_over_psi; /* ratio of amplitudes; what it is called: libmlg_is_delta */
};

/* Whether an oscillation in which delta is so many times as large as psi is delta-shimmy: more
 * of its kinetic energy is in the bending than in the torsion, (J_xi + m_D l_D^2) delta^2 >
 * J_zeta psi^2; else it is psi-shimmy. */
int libmlg_is_delta(const double par[], double delta_over_psi);

/* All oscillations at the V of par[], above 0, by falling growth, the first `most` of them
 * into mode[]; and *grows: whether a real eigenvalue does (divergence).  Returns their
 * number, LIBMLG_NONE or LIBMLG_FAILED as libmlg_eigenvalues. */
int libmlg_modes(int layout, const double par[], struct libmlg_mode mode[], int most, int *grows);

/* The mode of the least damping ratio at the V of par[], above 0 (over all V:
 * libmlg_least_ratio).  A real eigenvalue does not oscillate: it has zeta = 1 and never
 * counts; one that grows (divergence) has -1 and always does.
 * Returns as libmlg_eigenvalues. */
int libmlg_least_damped(int layout, const double par[], struct libmlg_mode *mode);

/* Is the Hopf point of the mode nearest to i omega, rad/s, subcritical (*a > 0: unstable
 * shimmy beside the stable gear) or supercritical?  The amplitude r of psi, rad, obeys
 * r' = sigma r + *a r^3 near it, *a in 1/s per rad^2; for that of delta divide by
 * delta_over_psi^2.  Kuznetsov, Elements of Applied Bifurcation Theory, Section 5.4;
 * derivatives by differences, good to 1e-7.
 * Returns as libmlg_eigenvalues. */
int libmlg_criticality(int layout, const double par[], double omega, struct libmlg_mode *mode, double *a);

/* The same with the fifth order, r' = sigma r + *a r^3 + *a_5 r^5, which decides where *a is
 * 0: unstable shimmy of the size r^2 = -*a / *a_5 beside stable gear, or a fold of cycles
 * (Kuznetsov, Section 8.3).  *a_5 in 1/s per rad^4, meant at points where *a is small; good to
 * 1e-7, *a to 1e-9 of its terms.  a_5 may be NULL.  Returns as libmlg_eigenvalues. */
int libmlg_fifth_order(int layout, const double par[], double omega, struct libmlg_mode *mode, double *a, double *a_5);

/* The amplitude equations beside a double Hopf point, of the modes nearest to i omega[0] and
 * i omega[1]: r_i' = r_i (sigma_i + a[i][0] r_0^2 + a[i][1] r_1^2), r_i the amplitude, rad, of
 * psi, or of delta where it is delta-shimmy; a in 1/s per rad^2.  Kuznetsov, Section 8.6;
 * derivatives as for libmlg_criticality.  Returns as libmlg_eigenvalues. */
int libmlg_double_hopf(int layout, const double par[], const double omega[2], struct libmlg_mode mode[2], double a[2][2]);

/* d(re)/d(parameter) of the mode nearest to re + i im, 1/s per its unit; good to 1e-8. */
int libmlg_growth_slope(int layout, const double par[], const struct libmlg_mode *mode, int parameter,
                        double *slope);

/* --- play, friction, orifice and relief valve, by describing functions (LAPACK) --------- */

/* A cycle: psi its amplitude, rad; stable where a little larger one falls and a little
 * smaller one grows. */
struct libmlg_balance { double psi, frequency_hz, delta_over_psi; int stable; };

/* What a gear with laws is in an oscillation of the amplitude psi, rad, near that frequency:
 * a linear one with the parameters equivalent[libmlg_parameters()] (k_psi, k_s, k_d, c_d and
 * c_psi as they are in the mean; may be NULL), and its mode, whose re is the rate at which the
 * oscillation grows.  One harmonic, the gear itself linear.
 * Returns 0, LIBMLG_NONE, or LIBMLG_FAILED: no oscillation of that size. */
int libmlg_equivalent(int layout, const double par[], double psi, double near_hz, double equivalent[],
                      struct libmlg_mode *mode);

/* All cycles of the amplitudes psi_least to psi_most, rad, that 40 steps between these show,
 * the largest first, `most` of them at most; *grows: whether an oscillation of psi_most still
 * does.  Returns their number, or as libmlg_modes. */
int libmlg_balance(int layout, const double par[], double psi_least, double psi_most, struct libmlg_balance cycle[],
                   int most, int *grows);

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
  long corners;                    /* how often a sharp corner of a law (end of a gap, relief
                                      valve, reversal of an orifice) was passed */
  char error[200];                 /* why it failed, in one line */
  long steps, most_steps;          /* of the integration since it began; it fails beyond most_steps, 0: never */
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

/* What a run does in the long term, as far as some hundred maxima of psi tell. */
enum libmlg_motion_kind {
  LIBMLG_PERIODIC,
  LIBMLG_DIES_OUT,       /* it falls for good, or stays within its gaps and falls there */
  LIBMLG_SETTLING,       /* to what cannot be told yet: it is slow */
  LIBMLG_QUASI_PERIODIC, /* a torus: a second frequency, and its multiples with the first, alone */
  LIBMLG_IRREGULAR,      /* neighbours part: exponent > 0 */
  LIBMLG_UNDECIDED       /* none of these for sure */
};
const char *libmlg_motion_name(enum libmlg_motion_kind kind); /* "periodic", ... */

struct libmlg_motion {
  enum libmlg_motion_kind kind;
  double psi_least, psi_most; /* of the maxima of psi, rad */
  double frequency_hz;        /* maxima in a second */
  double modulation_hz;       /* the strongest line of their values, at most half of that; 0: none */
  double exponent;            /* 1/s, the largest Lyapunov exponent of their map */
  int watched, maxima;        /* how many; after how many it is nearly back, 0: it is not */
  double time;                /* s, that was watched */
  double u[LIBMLG_MOST_STATES]; /* at the last */
};

/* A periodic orbit. */
struct libmlg_cycle {
  double u[LIBMLG_MOST_STATES]; /* at a maximum of psi */
  double period;                /* s */
  double psi, delta;            /* largest |psi| and |delta|, rad */
  double psi_least, psi_most;   /* of the maxima of psi, rad */
  int maxima;                   /* of psi in a period */
  double error;                 /* how far from u it is after a period, relative to its size */
  int multipliers;              /* Floquet multipliers but the trivial one, and the largest modulus */
  double multiplier_re[LIBMLG_MOST_STATES], multiplier_im[LIBMLG_MOST_STATES], largest;
  long corners, limits;         /* passed in a period */
  const char *why;              /* what went wrong, in words */
  struct libmlg_motion motion;  /* with settle > 0: what it does, where no orbit was found too */
};

/* The orbit that the states start[] lead to: the gear settles for so many seconds, in a run
 * that has begun, and Newton's method finds the fixed point of its Poincare map, which has to
 * be stable or where the run is; else the run is watched for 400 maxima, and again while it
 * settles.  With settle = 0 it is any orbit, unstable ones too, and nothing is watched.
 * Returns 0, LIBMLG_NONE, or LIBMLG_FAILED and why; why is NULL where *run says it. */
int libmlg_cycle(struct libmlg_run *run, int layout, const double par[], const double start[], double settle,
                 struct libmlg_cycle *cycle);

/* What a state counts in: 1 rad, 1 m or 100 rad/s; and the size of an oscillation: its
 * largest state so counted, 1e-12 at least.  NaN, and 1e-12: no such layout or state. */
double libmlg_state_size(int layout, int state);
double libmlg_oscillation_size(int layout, const double u[]);

/* --- straight rolling: where it is stable ---------------------------------------------
 *
 * par[] as above; its V and c_d do not matter where they are asked for.  A result is
 * complete, for every frequency and every c_d > 0, and polished to rounding (about 1e-12
 * relative where the problem allows): it comes from one eigenvalue problem, not from
 * samples (docs/boundary.md).
 *   zeta      damping ratio asked for, -1 < zeta < 1; 0: stability.  A complex eigenvalue
 *             s has the ratio -Re(s)/|s|; a positive real one is a divergence, below
 *             every ratio.
 *   V_least, V_top   the speeds that are looked at, m/s, V_least < V < V_top; V_least
 *             may be 0, which is a limit: the tyre is neutral there.  V_top is finite.
 * Functions that return a number of points return LIBMLG_NONE for no such layout or range,
 * and LIBMLG_UNSURE when LAPACK failed or what was found contradicts itself. */

enum { LIBMLG_UNSURE = -3, LIBMLG_MOST_POINTS = 128 };

/* What bounds a region of shimmy in the (V, c_d) plane at a point. */
enum libmlg_kind {
  LIBMLG_LEAST,   /* c_d is least along the Hopf curve */
  LIBMLG_LARGEST, /* c_d is largest along it */
  LIBMLG_BOTTOM,  /* the curve leaves the range at V_least; V_least = 0: as V goes to 0 */
  LIBMLG_TOP,     /* it leaves it at V_top */
  LIBMLG_HOPF,    /* an ordinary point of a curve */
  LIBMLG_ENDS     /* c_d of 0 or infinity, as the bound of an interval */
};

/* A Hopf point, or a point of the damping ratio zeta. */
struct libmlg_point {
  double c_d;            /* N m s/rad */
  double V;              /* m/s */
  double omega;          /* |s|, rad/s */
  double delta_over_psi; /* amplitudes, rad/rad; what it is called: libmlg_is_delta */
  enum libmlg_kind kind;
};

/* c_d from lo to hi, N m s/rad, without shimmy for all V in the range; what ends it.
 * lo may be 0 and hi INFINITY (kind LIBMLG_ENDS). */
struct libmlg_interval { struct libmlg_point lo, hi; };

/* All Hopf points at the c_d of par[] and V_least < V < V_top, by rising V, the first
 * `most` of them into point[]. */
int libmlg_hopf_at_c_d(int layout, const double par[], double zeta, double V_least, double V_top,
                       struct libmlg_point point[], int most);

/* All Hopf points at the V of par[] and c_d > 0, by rising c_d. */
int libmlg_hopf_at_V(int layout, const double par[], double zeta, struct libmlg_point point[], int most);

/* All values of one parameter between `from` and `to` at which straight rolling has a Hopf point,
 * the others as in par[], rising, the first `most` of them into at[].  Complete along V and c_d;
 * along others looked for by bisection between 200 values, to 1e-11: two within a 200th of the
 * range that no eigenvalue at its ends announces are not seen.  So it is with laws
 * (models/elements.h), to 1e-7; here, unlike elsewhere, play and friction are what they are at
 * rest: no stiffness within a sharp gap, some within a rounded one, damping T / v_f.  Returns
 * their number, or as libmlg_eigenvalues. */
int libmlg_hopf_along(int layout, const double par[], int parameter, double from, double to, double at[], int most);

/* All boundary points, by rising c_d: the extrema of c_d along the Hopf curves and the
 * points where these leave the range of V. */
int libmlg_boundary_points(int layout, const double par[], double zeta, double V_least, double V_top,
                           struct libmlg_point point[], int most);

/* All intervals of c_d, by rising c_d, in which straight rolling is stable (has at least
 * the ratio zeta) at every V_least < V < V_top.  None for a gear that diverges. */
int libmlg_intervals(int layout, const double par[], double zeta, double V_least, double V_top,
                     struct libmlg_interval interval[], int most);

/* Both at once, in the time of one: *points and *intervals of them, all of which the arrays
 * of LIBMLG_MOST_POINTS hold.  Returns 0, or what the two would, with neither. */
int libmlg_points_and_intervals(int layout, const double par[], double zeta, double V_least, double V_top,
                                struct libmlg_point point[], int *points, struct libmlg_interval interval[],
                                int *intervals);

/* Stability at the V and c_d of par[]: the least damping ratio of all eigenvalues, -1
 * with a positive real one; the tyres' difference, which decays at V/l, counts 1.
 * NaN: LAPACK failed, or no such layout. */
double libmlg_damping_ratio(int layout, const double par[]);

/* Whether straight rolling is stable (has at least the ratio zeta) at the c_d of par[] and
 * every V_least < V < V_top: 1 or 0, or LIBMLG_NONE (also for a c_d that is no number).  Exact
 * as libmlg_intervals and several times cheaper: the crossings at that one c_d are the roots of
 * one polynomial, and without any the eigenvalues at one speed decide. */
int libmlg_is_free(int layout, const double par[], double zeta, double V_least, double V_top);

/* Speeds with shimmy, m/s. */
struct libmlg_band { double from, to; };

/* All speeds in V_least..V_top at which straight rolling at the c_d of par[] is unstable, as
 * bands by rising V, the first `most` of them into band[].  Returns their number or LIBMLG_NONE. */
int libmlg_shimmy_speeds(int layout, const double par[], double V_least, double V_top, struct libmlg_band band[],
                         int most);

/* Whether the gear diverges, a real root growing, at every V and c_d: 1 or 0; the sign of
 * F(0) decides, which hangs on neither. */
int libmlg_diverges(int layout, const double par[]);

/* --- the best of a device ----------------------------------------------------------------- */

/* The least damping ratio over V_least < V < V_top at the c_d of par[], and where it is.
 * -1 with a positive real eigenvalue.  Exact: no crossing of a lesser ratio is left.
 * Returns 0, LIBMLG_NONE, or LIBMLG_FAILED when LAPACK did. */
struct libmlg_ratio { double zeta, c_d, V, k_s, b; }; /* SI units; k_s INFINITY: rigid */

int libmlg_least_ratio(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *least);

/* The c_d whose least ratio is largest, at the k_s and b of par[]: no c_d has a larger one,
 * for at that ratio (or, where what is found there contradicts itself, at one larger by a
 * thousandth at most) no interval of c_d is left.  Returns as libmlg_least_ratio, or LIBMLG_UNSURE. */
int libmlg_best_c_d(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *best);

/* The c_d, k_s and b of the largest least ratio: over all k_s from rigid to 1e-6 k_psi and
 * b_least <= b <= b_most.  Exact in c_d; over k_s and b from the best node of a grid of 64 by 33,
 * with an inertance closer in k_s as libmlg_widest has it (at each: has any c_d more than the best
 * ratio so far?), a climb by slopes, golden section along b with a climb at each, and over k_s in the
 * end.  The ratio is good to 1e-4 of itself, on the flat ridges that there are along b less so b and k_s; they
 * come with six digits, c_d is the best one there.  Parameters the layout does not use stay. */
int libmlg_best_damped(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                       struct libmlg_ratio *best);

/* --- how far a design is from shimmy -------------------------------------------------------
 *
 * The static load F_z = (M + m_D) g counts as a parameter here, LIBMLG_F_Z: M moves, and m_D
 * and g stay. */

enum { LIBMLG_F_Z = LIBMLG_MOST_PARAMETERS };

/* Its value, N, or that of a parameter; NaN: no such parameter. */
double libmlg_value(const double par[], int parameter);
void libmlg_set(double par[], int parameter, double value);

/* d(c_d)/d(parameter) of a boundary point, a bound of an interval, of the damping ratio zeta;
 * 0 for one of the kind LIBMLG_ENDS and by a rigid k_s.  By implicit differentiation, no
 * difference of two points; good to about 1e-9, less where two points nearly meet, at which
 * it is infinite.  Returns 0, LIBMLG_NONE: no such layout or parameter, LIBMLG_FAILED. */
int libmlg_point_slope(int layout, const double par[], double zeta, const struct libmlg_point *point, int parameter,
                       double *slope);

/* d(zeta)/d(parameter) of a least ratio as libmlg_least_ratio gives it, likewise.  Where two
 * modes share the least ratio it is that of the one that was found.  Returns as above, and
 * LIBMLG_FAILED where a real eigenvalue is the least. */
int libmlg_ratio_slope(int layout, const double par[], const struct libmlg_ratio *least, int parameter, double *slope);

/* Parameters that vary together, each by +-p of its value: as many as 2^LIBMLG_MOST_SIDES
 * corners. */
enum { LIBMLG_MOST_SIDES = 18 };

struct libmlg_box { int n, parameter[LIBMLG_MOST_SIDES]; };

/* The one of this project: F_z, k_t, e, l, h, k_lambda, k_alpha, c_delta, c_psi, k_delta, k_psi,
 * c_d, and k_s and b where the layout has them and they are neither rigid nor 0. */
void libmlg_box_of(int layout, const double par[], struct libmlg_box *box);

/* par[] at a corner of the box of size p (1: 100 %): parameter[i] is at its upper end where bit i of
 * corner is 1. */
void libmlg_corner(const double par[], const struct libmlg_box *box, unsigned corner, double p, double out[]);

/* p: where the first of all corners begins to shimmy; 0 where the design itself does.  Each of the
 * 2^n corners is tested exactly at p, 3/4, 1/2 and 1/4 of it; bounded 0: none shimmies at the
 * most that is looked at. */
#define LIBMLG_MOST_TOLERANCE 0.9

struct libmlg_tolerance { double p; unsigned corner; int bounded; };

/* That of the design par[], its c_d included.  Returns 0 or LIBMLG_NONE. */
int libmlg_tolerance(int layout, const double par[], const struct libmlg_box *box, double V_least, double V_top,
                     struct libmlg_tolerance *tolerance);

struct libmlg_design { double k_s, b, c_d, p; };

/* The k_s, c_d and b, b_least <= b <= b_most, of the largest tolerance in libmlg_box_of: p = 0,
 * there is none.  Over c_d exact; over k_s and b from the best node of a grid of those of
 * libmlg_widest by 16, a climb by slopes, then golden section along b with a climb at each, or over
 * k_s.  After each all corners are tested at the best design, in the end at parts of p as well; where
 * one fails that was not asked before, all again.  Returns 0 or LIBMLG_NONE. */
int libmlg_most_tolerant(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                         struct libmlg_design *design);

/* The same at the k_s and b of each of n designs: sets their c_d and p, both 0 where there is
 * none.  All corners are tested at p, but not at parts of it; p is a bound from above where a corner
 * fails below p alone.  Returns 0 or LIBMLG_NONE. */
int libmlg_tolerance_map(int layout, const double par[], struct libmlg_design node[], int n, double V_least, double V_top);

/* What ends the growth of the widest interval over k_s. */
enum libmlg_limit {
  LIBMLG_NO_INTERVAL, /* there is none at any k_s */
  LIBMLG_ONSET,       /* beyond it a region is born inside the interval, at `third` */
  LIBMLG_EQUAL_LO,    /* `third` has the c_d of lo and bounds the interval beyond */
  LIBMLG_EQUAL_HI,    /* the same of hi */
  LIBMLG_STATIONARY,  /* the width has a smooth maximum */
  LIBMLG_RIGID,       /* the rigid spring is best */
  LIBMLG_SOFT,        /* the softest spring that is looked at, 1e-6 k_psi, is best */
  LIBMLG_UNBOUNDED    /* some interval has no upper end: there is no widest one */
};

struct libmlg_widest {
  double k_s;                      /* N m/rad; INFINITY: rigid */
  double width;                    /* N m s/rad */
  struct libmlg_interval interval; /* at k_s, or a rounding error on the wider side of it */
  struct libmlg_point third;       /* see enum libmlg_limit */
  enum libmlg_limit limit;
};

/* The widest interval over k_s, from rigid to 1e-6 k_psi, at the b of par[].  A layout
 * without k_s has one interval or more at k_s = infinity.  Wherever the kinds of the
 * boundary points in their order of c_d differ between neighbouring nodes (64 steps of
 * 1/(1 + k_s/k_psi); with an inertance at most 10 % of k_s), all k_s at which they change are
 * bisected, to 1e-5 of that; two changes between nodes that undo each other are not seen.  Returns 0,
 * LIBMLG_NONE or LIBMLG_UNSURE. */
int libmlg_widest(int layout, const double par[], double zeta, double V_least, double V_top, struct libmlg_widest *widest);

/* The same for the interval whose ratio c_hi/c_lo is largest, which does not favour large c_d. */
int libmlg_largest_ratio(int layout, const double par[], double zeta, double V_least, double V_top, struct libmlg_widest *widest);

/* --- over loads ------------------------------------------------------------------------------- */

/* The k_s, c_d and b, b_least <= b <= b_most, whose least damping ratio over V_least < V < V_top
 * and over the load F_z (LIBMLG_F_Z) from F_least to F_most, N, is largest: seven loads in equal
 * steps count.  Over k_s and b as libmlg_best_damped.  Returns 0, LIBMLG_NONE, LIBMLG_UNSURE or LIBMLG_FAILED: no design has a ratio. */
int libmlg_best_over_loads(int layout, const double par[], double F_least, double F_most, double b_least, double b_most,
                           double V_least, double V_top, struct libmlg_ratio *best);

/* A load, N, and a design that is free of shimmy there, the last one at the largest load. */
struct libmlg_load { double F_z, k_s, b, c_d; };

/* The largest load up to F_most, N, at which any k_s and b, b_least <= b <= b_most, has a zero-shimmy
 * interval; F_z = 0: none has.  The largest least damping ratio of all designs, as libmlg_best_damped
 * finds it, is above 0 at the last of 12 loads in equal steps up to F_most; above it the load at which it passes 0, to 1e-9.
 * A range of loads with designs between two of these 12 is not seen.  Returns 0 or LIBMLG_NONE. */
int libmlg_largest_load(int layout, const double par[], double F_most, double b_least, double b_most, double V_least,
                        double V_top, struct libmlg_load *load);

/* --- Hopf curves as a whole ------------------------------------------------------------------ */

/* The part of the (V, c_d) plane that is looked at, m/s and N m s/rad; all above 0. */
struct libmlg_plane { double V_least, V_top, c_least, c_most; };

/* A point of a curve; sine: of the angle between F_omega and F_V, 0 at an extremum of c_d. */
struct libmlg_curve_point { double omega, V, c_d, sine; int root; };

enum { LIBMLG_MOST_EXTREMA = 16 };

/* A whole curve in the plane: open from edge to edge, closed from the fold of its lowest
 * omega once round.  point[n], closer to each other towards its folds and edges. */
struct libmlg_curve {
  int closed, n;
  struct libmlg_curve_point *point;
  int extrema;                                       /* of c_d along it */
  struct libmlg_point extremum[LIBMLG_MOST_EXTREMA]; /* in the order of the points */
};

/* All curves of the damping ratio zeta (0: Hopf curves), the open ones first; *curves is to
 * go to libmlg_free_curves().  Returns their number, LIBMLG_NONE, LIBMLG_UNSURE: with I_p
 * they are not known as a whole, LIBMLG_FAILED: out of memory. */
int libmlg_curves(int layout, const double par[], double zeta, const struct libmlg_plane *plane,
                  struct libmlg_curve **curves);
void libmlg_free_curves(struct libmlg_curve *curves, int n);

/* A generalised Hopf point: where *a of libmlg_criticality passes 0 along a Hopf curve.  There a
 * fold of cycles begins, on the side on which a_slope (V - gh.V) and a_5 differ in sign, at
 * c_d - c_Hopf(V) = (a_slope (V - gh.V))^2 / (4 a_5 growth_in_c_d) to leading order, with the
 * amplitude r^2 = -a_slope (V - gh.V) / (2 a_5) of psi, rad^2. */
struct libmlg_generalised_hopf {
  double V, c_d;           /* m/s, N m s/rad */
  struct libmlg_mode mode;
  double a_5;              /* 1/s per rad^4 */
  double a_slope;          /* da/dV along the curve, 1/s per rad^2 and m/s */
  double growth_in_c_d;    /* d(re)/d(c_d), 1/s per N m s/rad */
};

/* All of them on the Hopf curves of the plane, in the order of libmlg_curves, the first `most`
 * of them into gh[].  a is sampled at the points of the curves, and between them where it
 * bends so much that it may reach 0.  Returns their number, or as libmlg_curves. */
int libmlg_generalised_hopf(int layout, const double par[], const struct libmlg_plane *plane,
                            struct libmlg_generalised_hopf gh[], int most);

#if defined __GNUC__
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif

#endif
