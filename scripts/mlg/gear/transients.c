/* transients.c - straight rolling after a disturbance: peaks and settling times */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "transients";
static const double settled = 0.05, done = 0.02;

/* What becomes of one state. */
struct response {
  double peak;
  double time;    /* settling time, s; INFINITY: unstable */
  double end;     /* decay rate from settled to done, 1/s; 0: it has not settled */
  long limits;    /* how often a slip angle passed alpha_m */
};

static int to_next(struct libmlg_run *run, const double par[], double t)
{
  int reached;

  while ((reached = libmlg_run_to(run, t)) == LIBMLG_AT_LIMIT)
    ;
  if (reached == LIBMLG_FAILED)
    fail(name, MLG_FAILED, "V = %g: %s", par[NUMBER_V], run->error);
  return reached;
}

/* How long after the extremum u[] of a state, the last above a level, |state| comes down to
 * it: no later than the next extremum, span s on. */
static double time_to_level(struct libmlg_run *run, const double par[], const double u[], int state, double level, double span)
{
  enum { STEPS = 64 };
  const double sign = u[state] > 0. ? 1. : -1.;
  double x = fabs(u[state]), rate = 0.;

  libmlg_run_start(run, par, u);
  libmlg_run_section(run, -1, 0);
  for (int i = 1; i <= STEPS; i++) {
    const double h = span / STEPS, x_was = x, rate_was = rate;
    double lo = 0., hi = 1.;

    to_next(run, par, i * h);
    x = sign * run->u[state];
    rate = sign * run->u[state + 1];
    if (x > level)
      continue;
    for (int k = 0; k < 50; k++) { /* the cubic through both ends; good to (h omega)^4 / 384 */
      const double s = (lo + hi) / 2., r = 1. - s;

      if (r * r * (1. + 2. * s) * x_was + s * s * (3. - 2. * s) * x + s * r * h * (r * rate_was - s * rate) > level)
        lo = s;
      else
        hi = s;
    }
    return (i - 1 + lo) * h;
  }
  return span;
}

/* A run, seen at the extrema of a state, whose rate is the next one.  It ends once all
 * extrema of a second are done with. */
static struct response respond(struct libmlg_run *run, const double par[], const double start[],
                               int state, double t_end, double linear_rate)
{
  const int stable = linear_rate > 0.;
  const double until = stable ? t_end : fmin(t_end, 10.);
  struct response r = { .peak = 0. };
  double last[LIBMLG_MOST_STATES] = { 0. }; /* the extremum that was last not settled, */
  double t_last = 0., t_next = 0.;          /* its time, and that of the one behind it */
  double alive = 0., x_alive = 0.;          /* the extremum that was last not done */
  int reached;

  libmlg_run_start(run, par, start);
  libmlg_run_section(run, state + 1, 0);
  while ((reached = to_next(run, par, until)) != LIBMLG_AT_TIME && run->t < alive + 1.) {
    const double x = fabs(run->u[state]);

    if (!(t_next > t_last))
      t_next = run->t;
    r.peak = fmax(r.peak, x);
    if (x > settled * r.peak) { /* the peak itself is one of these */
      t_last = t_next = run->t;
      memcpy(last, run->u, sizeof last);
    }
    if (x > done * r.peak) {
      alive = run->t;
      x_alive = x;
    }
  }
  r.limits = run->limits;
  if (!stable) /* what has decayed comes back */
    r.time = INFINITY;
  else if (reached != LIBMLG_AT_TIME) {
    r.end = log(fabs(last[state]) / x_alive) / (alive - t_last);
    r.time = t_last + time_to_level(run, par, last, state, settled * r.peak, t_next - t_last);
  }
  return r;
}

static void print_response(const struct response *r, double t_end)
{
  if (r->end > 0. || isinf(r->time))
    printf(",%.6g,", r->time);
  else
    printf(",>%.6g,", t_end);
  if (r->end > 0.)
    printf("%.6g", r->end);
}

static struct libmlg_mode mode_at(struct arguments *a, double V)
{
  struct libmlg_mode mode;

  a->par[NUMBER_V] = V;
  if (libmlg_least_damped(a->layout, a->par, &mode) != 0)
    fail(name, MLG_FAILED, "no eigenvalues at V = %g", V);
  return mode;
}

/* Where zeta is least between two speeds; NaN: at one of them, to rounding. */
static double worst_between(struct arguments *a, double V_lo, double V_hi)
{
  struct libmlg_ratio least;

  if (libmlg_least_ratio(a->layout, a->par, V_lo, V_hi, &least) != 0)
    fail(name, MLG_FAILED, "no eigenvalues between V = %g and %g", V_lo, V_hi);
  return least.V > V_lo * (1. + 1e-9) && least.V < V_hi * (1. - 1e-9) ? least.V : (double)NAN;
}

enum { DPSI_0, DDELTA_0, T_END, STEP };

static void print_rows(struct libmlg_run *run, struct arguments *a, double V)
{
  const struct libmlg_mode mode = mode_at(a, V);
  const double rate = -mode.re, t_end = a->option[T_END].value;

  for (int k = 0; k < 2; k++) {
    double start[LIBMLG_MOST_STATES] = { 0. };

    start[DPSI] = k == 0 ? a->option[DPSI_0].value : 0.;
    start[DDELTA] = k == 1 ? a->option[DDELTA_0].value : 0.;
    if (start[DPSI] == 0. && start[DDELTA] == 0.)
      continue;
    const struct response psi = respond(run, a->par, start, PSI, t_end, rate);
    const struct response delta = respond(run, a->par, start, DELTA, t_end, rate);

    printf("%g,%s,%.6g,%.6g", V, k ? "delta" : "psi", psi.peak * 180. / MLG_PI,
           a->par[NUMBER_L_DELTA] * delta.peak);
    print_response(&psi, t_end);
    print_response(&delta, t_end);
    printf(",%.6g,%.6g,%ld\n", rate, mode.zeta, delta.limits);
  }
}

/* The rows at each step of V, and at the minima of zeta between. */
static void print_rows_to(struct libmlg_run *run, struct arguments *a, double V_top)
{
  const double step = a->option[STEP].value;

  for (int i = 1; i * step <= V_top * (1. + 1e-9); i++) {
    const double worst = i > 1 ? worst_between(a, (i - 1) * step, i * step) : NAN;

    if (!isnan(worst))
      print_rows(run, a, worst);
    print_rows(run, a, i * step);
  }
}

static int transients(int argc, char *argv[])
{
  struct option option[] = {
    [DPSI_0] = { "dpsi", "rad/s", -1e6, 1e6, 1., NULL },
    [DDELTA_0] = { "ddelta", "rad/s", -1e6, 1e6, 0.45, NULL },
    [T_END] = { "t_end", "s", 1., 1e4, 5000., NULL },
    [STEP] = { "step", "m/s", 1e-3, 1e3, 5., NULL },
    { NULL, NULL, 0., 0., 0., NULL },
  };
  struct arguments a;
  struct libmlg_run run;

  read_arguments(&a, argc, argv, option);
  if (!(a.par[NUMBER_V] > 0.))
    refuse(name, a.word[NUMBER_V], "the wheels have to roll: V above 0");
  if (libmlg_run_begin(&run, a.layout, 1e-11) != 0)
    fail(name, MLG_FAILED, "out of memory");
  printf("V,disturbance,psi_max,dstar_max,psi_5,psi_end,dstar_5,dstar_end,rate,zeta,limits\n");
  if (a.word[NUMBER_V])
    print_rows(&run, &a, a.par[NUMBER_V]);
  else
    print_rows_to(&run, &a, a.V_top);
  libmlg_run_end(&run);
  return output_status(name);
}

const struct command command_transients = {
  .name = name,
  .usage = "LAYOUT [NAME=VALUE ...] [dpsi=1] [ddelta=0.45] [t_end=5000] [step=5]",
  .summary = "peaks and settling times after a disturbance",
  .details =
    "Without V the speeds are 5, 10, ... m/s (step) up to V_top and, where zeta is least\n"
    "between two of them, that speed.  dpsi, ddelta: the two disturbances, rates at t = 0 of\n"
    "a gear at rest otherwise, rad/s (1 and 0.45: each brings 50 J into the wheels or the\n"
    "strut); t_end, s: how long to integrate at most (5000).\n"
    "\n"
    "Prints CSV, a row for each speed and disturbance:\n"
    "  V                   m/s\n"
    "  disturbance         psi or delta: which rate\n"
    "  psi_max, dstar_max  deg and m: the largest |psi| and |delta*|, delta* = l_delta delta\n"
    "  psi_5, dstar_5      s: settling time, from which on |psi| or |delta*| is below 5 % of\n"
    "                      its largest; >T: it has not by t_end = T; inf: it never does, the\n"
    "                      gear is unstable (10 s are integrated for the peaks)\n"
    "  psi_end, dstar_end  1/s: the decay rate seen from 5 % to 2 %; empty if not settled\n"
    "  rate, zeta          1/s, -: linear decay rate and damping ratio of the least damped\n"
    "                      mode, which need not be the one that is seen\n"
    "  limits              how often a slip angle passed alpha_m\n"
    "The relative tolerance of a step is 1e-11: at 1e-9 the integration damps by 2e-7 1/s of\n"
    "its own.  Status 1 when it fails.\n",
  .run = transients,
};
