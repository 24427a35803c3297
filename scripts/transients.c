/* transients - straight rolling after a disturbance: peaks and settling times
 *
 *   transients-LAYOUT [NAME=VALUE ...]
 *
 * NAME  a parameter of models/mlg.h, or compliance (1e5/k_s; 0 is rigid); without V
 *       the speeds are 5, 10, ... 200 m/s and those of the minima of zeta they enclose;
 *       dpsi, ddelta: the two disturbances, rates at t = 0 of a gear at rest otherwise,
 *       rad/s (1 and 0.45: each brings 50 J into the wheels or the strut);
 *       t_end, s: how long to integrate at most (5000)
 *
 * Prints CSV, a row for each speed and disturbance:
 *   V                    m/s
 *   disturbance          psi or delta: which rate
 *   psi_max, dstar_max   deg and m: the largest |psi| and |delta*|, delta* = l_delta delta
 *   psi_5, dstar_5       s: settling time, after which |psi| or |delta*| stays below 5 % of
 *                        its largest; >T: it has not by t_end = T; inf: it never does, the
 *                        gear is unstable (10 s are integrated for the peaks)
 *   psi_end, dstar_end   1/s: the decay rate seen from 5 % to 2 %; empty if not settled
 *   rate, zeta           1/s, -: linear decay rate and damping ratio of the least damped
 *                        mode, which need not be the one that is seen
 *   limits               how often a slip angle passed alpha_m
 *
 * Integration is integrate.h's, at a relative tolerance of 1e-11 a step: at 1e-9 it damps
 * by 2e-7 1/s of its own.  Status 1 when it fails, 2 at bad input; one line says which.
 */
#include <stdio.h>
#include <stdlib.h>

#define MLG_NO_AUTO
#include LAYOUT
#include "integrate.h"
#include "arguments.h"
#include "damping.h"

static const char program[] = "transients";
static const double settled = 0.05, done = 0.02;

/* What becomes of one state. */
struct response {
  double peak;
  double time;    /* settling time, s; INFINITY: unstable */
  double end;     /* decay rate from settled to done, 1/s; 0: it has not settled */
};

/* A run, seen at the extrema of a state, whose rate is the next one.  It ends once all
 * extrema of a second are done with. */
static struct response respond(struct integrator *run, const double par[], const double start[],
                               int state, double t_end, double linear_rate)
{
  const int stable = linear_rate > 0.;
  const double until = stable ? t_end : fmin(t_end, 10.);
  struct response r = { .peak = 0. };
  double x_settled = 0., alive = 0., x_alive = 0.; /* |state| at r.time; when it was last not done */
  enum reached reached;

  integrator_start(run, par, start);
  integrator_section(run, state + 1, 0);
  while ((reached = integrator_advance(run, until)) != AT_TIME && run->t < alive + 1.) {
    const double x = fabs(run->u[state]);

    if (reached == FAILED) {
      fprintf(stderr, "%s: V = %g: %s\n", program, par[PAR_V], run->error);
      exit(1);
    }
    if (reached == AT_LIMIT)
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
  else if (reached != AT_TIME)
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

static void print_rows(struct integrator *run, double par[], double V, double dpsi, double ddelta,
                       double t_end)
{
  par[PAR_V] = V;
  const struct characteristic f = characteristic(par);
  const struct mode mode = least_damped(&f, V, par[PAR_C_D]);
  const double rate = -creal(mode.s);

  for (int k = 0; k < 2; k++) {
    double start[NDIM] = { 0. };

    start[DPSI] = k == 0 ? dpsi : 0.;
    start[DDELTA] = k == 1 ? ddelta : 0.;
    if (start[DPSI] == 0. && start[DDELTA] == 0.)
      continue;
    const struct response psi = respond(run, par, start, PSI, t_end, rate);
    const struct response delta = respond(run, par, start, DELTA, t_end, rate);

    printf("%g,%s,%.6g,%.6g", V, k ? "delta" : "psi", psi.peak * 180. / MLG_PI,
           par[PAR_L_DELTA] * delta.peak);
    print_response(&psi, t_end);
    print_response(&delta, t_end);
    printf(",%.6g,%.6g,%ld\n", rate, mode.zeta, run->limits);
  }
}

/* The speeds of the table in ascending order; their number. */
static int table_speeds(const double par[], double speed[])
{
  const struct characteristic f = characteristic(par);
  struct at_c_d at = { &f, par[PAR_C_D] };
  const double step = 5.;
  int n = 0;

  for (double V = step; V <= MLG_V_TOP; V += step) {
    const double zeta = -negative_zeta(V, &at);
    double bottom = V;

    if (V > step && V < MLG_V_TOP && zeta <= -negative_zeta(V - step, &at) && zeta <= -negative_zeta(V + step, &at))
      bottom = summit(negative_zeta, &at, V - step, V + step);
    if (bottom < V)
      speed[n++] = bottom;
    speed[n++] = V;
    if (bottom > V)
      speed[n++] = bottom;
  }
  return n;
}

int main(int argc, char *argv[])
{
  struct { const char *name; double value; } option[] = { { "dpsi", 1. }, { "ddelta", 0.45 }, { "t_end", 5000. } };
  enum { OPTIONS = sizeof option / sizeof *option };
  struct integrator run;
  double par[36] = { 0. }, speed[80];
  int at_V = 0, speeds;

  mlg_defaults(par);
  for (int i = 1; i < argc; i++) {
    size_t length;
    const double value = number_of(program, argv[i], &length);
    int k = 0;

    while (k < OPTIONS && !(strlen(option[k].name) == length && memcmp(option[k].name, argv[i], length) == 0))
      k++;
    if (k < OPTIONS)
      option[k].value = value;
    else if (set_parameter(program, par, argv[i]) == PAR_V)
      at_V = 1;
    if (!(par[PAR_V] > 0.))
      refuse(program, argv[i], "the wheels have to roll: V above 0");
    if (!(option[2].value >= 1. && option[2].value <= 1e4))
      refuse(program, argv[i], "outside its range, 1 to 10000 s");
  }
  if (integrator_begin(&run, 1e-11) != 0) {
    fprintf(stderr, "%s: out of memory\n", program);
    return 1;
  }
  printf("V,disturbance,psi_max,dstar_max,psi_5,psi_end,dstar_5,dstar_end,rate,zeta,limits\n");
  speeds = at_V ? 1 : table_speeds(par, speed);
  for (int i = 0; i < speeds; i++)
    print_rows(&run, par, at_V ? par[PAR_V] : speed[i], option[0].value, option[1].value, option[2].value);
  integrator_end(&run);
  return output_status(program);
}
