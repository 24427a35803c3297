/* transients.c - straight rolling after a disturbance: peaks and settling times */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "transients";
static const double settled = 0.05, done = 0.02;

/* What becomes of one state. */
struct response {
  double peak;
  double time;    /* settling time, s; INFINITY: unstable */
  double end;     /* decay rate from settled to done, 1/s; 0: it has not settled */
};

/* A run, seen at the extrema of a state, whose rate is the next one.  It ends once all
 * extrema of a second are done with. */
static struct response respond(struct libmlg_run *run, const double par[], const double start[],
                               int state, double t_end, double linear_rate)
{
  const int stable = linear_rate > 0.;
  const double until = stable ? t_end : fmin(t_end, 10.);
  struct response r = { .peak = 0. };
  double x_settled = 0., alive = 0., x_alive = 0.; /* |state| at r.time; when it was last not done */
  int reached;

  libmlg_run_start(run, par, start);
  libmlg_run_section(run, state + 1, 0);
  while ((reached = libmlg_run_to(run, until)) != LIBMLG_AT_TIME && run->t < alive + 1.) {
    const double x = fabs(run->u[state]);

    if (reached == LIBMLG_FAILED)
      fail(name, MLG_FAILED, "V = %g: %s", par[NUMBER_V], run->error);
    if (reached == LIBMLG_AT_LIMIT)
      continue;
    r.peak = fmax(r.peak, x);
    if (x > settled * r.peak) { /* the peak itself is one of these */
      r.time = run->t;
      x_settled = x;
    }
    if (x > done * r.peak) {
      alive = run->t;
      x_alive = x;
    }
  }
  if (!stable) /* what has decayed comes back */
    r.time = INFINITY;
  else if (reached != LIBMLG_AT_TIME)
    r.end = log(x_settled / x_alive) / (alive - r.time);
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

/* The least damped mode at one speed, or between two. */
static struct libmlg_mode mode_at(struct arguments *a, double V)
{
  struct libmlg_mode mode;

  a->par[NUMBER_V] = V;
  if (libmlg_least_damped(a->layout, a->par, &mode) != 0)
    fail(name, MLG_FAILED, "no eigenvalues at V = %g", V);
  return mode;
}

static double zeta_at(struct arguments *a, double V)
{
  return mode_at(a, V).zeta;
}

static double worst_between(struct arguments *a, double V_lo, double V_hi)
{
  struct libmlg_mode mode;

  if (libmlg_least_damped_between(a->layout, a->par, V_lo, V_hi, &mode) != 0)
    fail(name, MLG_FAILED, "no eigenvalues between V = %g and %g", V_lo, V_hi);
  return mode.V;
}

enum { DPSI_0, DDELTA_0, T_END };

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
    printf(",%.6g,%.6g,%ld\n", rate, mode.zeta, run->limits);
  }
}

static const double step = 5.; /* between speeds, m/s */

/* The rows at one of the speeds of the table, and at a minimum of zeta beside it. */
static void print_rows_about(struct libmlg_run *run, struct arguments *a, double V)
{
  const double zeta = zeta_at(a, V);
  double bottom = V;

  if (V > step && V + step <= a->V_top && zeta <= zeta_at(a, V - step) && zeta <= zeta_at(a, V + step))
    bottom = worst_between(a, V - step, V + step);
  if (bottom < V)
    print_rows(run, a, bottom);
  print_rows(run, a, V);
  if (bottom > V)
    print_rows(run, a, bottom);
}

static int transients(int argc, char *argv[])
{
  struct option option[] = {
    [DPSI_0] = { "dpsi", "rad/s", -1e6, 1e6, 1., NULL },
    [DDELTA_0] = { "ddelta", "rad/s", -1e6, 1e6, 0.45, NULL },
    [T_END] = { "t_end", "s", 1., 1e4, 5000., NULL },
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
    for (double V = step; V <= a.V_top; V += step)
      print_rows_about(&run, &a, V);
  libmlg_run_end(&run);
  return output_status(name);
}

const struct command command_transients = {
  .name = name,
  .usage = "LAYOUT [NAME=VALUE ...]",
  .summary = "peaks and settling times after a disturbance",
  .details =
    "Without V the speeds are 5, 10, ... m/s up to V_top and those of the minima of zeta\n"
    "that they enclose.  dpsi, ddelta: the two disturbances, rates at t = 0 of a gear at rest\n"
    "otherwise, rad/s (1 and 0.45: each brings 50 J into the wheels or the strut); t_end, s:\n"
    "how long to integrate at most (5000).\n"
    "\n"
    "Prints CSV, a row for each speed and disturbance:\n"
    "  V                   m/s\n"
    "  disturbance         psi or delta: which rate\n"
    "  psi_max, dstar_max  deg and m: the largest |psi| and |delta*|, delta* = l_delta delta\n"
    "  psi_5, dstar_5      s: settling time, after which |psi| or |delta*| stays below 5 % of\n"
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
