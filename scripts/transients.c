/* transients - straight rolling after a disturbance: peaks and settling times
 *
 *   transients-LAYOUT [NAME=VALUE ...]
 *
 * NAME  a parameter of models/mlg.h, or compliance (1e5/k_s; 0 is rigid); without V
 *       the speeds are 5, 10, ... 200 m/s;
 *       dpsi, ddelta: the two disturbances, rates at t = 0 of a gear at rest otherwise,
 *       rad/s (1 and 0.45: each brings 50 J into the wheels or the strut);
 *       window, s: how long to integrate (10)
 *
 * Prints CSV, a row for each speed and disturbance:
 *   V                    m/s
 *   disturbance          psi or delta: which rate
 *   psi_max, dstar_max   deg and m: the largest |psi| and |delta*|, delta* = l_delta delta
 *   psi_5, dstar_5       s: settling time, after which |psi| or |delta*| stays below 5 % of
 *                        its largest; inf: it does not, the gear is unstable
 *   psi_by, dstar_by     run: integrated; rate: longer than the window, and what is left to
 *                        go comes from the linear decay rate
 *   psi_end, dstar_end   1/s: decay rate measured in the second half of the window; only
 *                        where that counts (by rate)
 *   rate, zeta           1/s, -: linear decay rate and damping ratio of the least damped mode
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
static const double settled = 0.05;
static const double stretch = 0.3; /* s: holds several maxima of either mode */

/* What becomes of one state. */
struct response {
  double peak;
  double time;    /* settling time, s */
  int beyond;     /* it is longer than the window */
  double end;     /* decay rate in the second half of the window, 1/s */
};

/* The largest extremum between two times, and when. */
struct largest { double from, to, t, x; };

static void look(struct largest *l, double t, double x)
{
  if (t >= l->from && t <= l->to && x > l->x) {
    l->x = x;
    l->t = t;
  }
}

/* A run, seen at the extrema of a state, whose rate is the next one.  It ends before the
 * window does once all extrema of a second are below a fifth of what counts as settled. */
static struct response respond(struct integrator *run, const double par[], const double start[],
                               int state, double window, double linear_rate)
{
  struct response r = { .peak = 0. };
  struct largest halfway = { window / 2., window / 2. + stretch, 0., 0. };
  struct largest last = { window - stretch, window, 0., 0. };
  double alive = 0.; /* when it was last above that fifth */
  enum reached reached;

  integrator_start(run, par, start);
  integrator_section(run, state + 1, 0);
  while ((reached = integrator_advance(run, window)) != AT_TIME && run->t < alive + 1.) {
    const double x = fabs(run->u[state]);

    if (reached == FAILED) {
      fprintf(stderr, "%s: V = %g: %s\n", program, par[PAR_V], run->error);
      exit(1);
    }
    if (reached == AT_LIMIT)
      continue;
    r.peak = fmax(r.peak, x);
    if (x > settled * r.peak) /* the peak itself is one of these */
      r.time = run->t;
    if (x > settled / 5. * r.peak)
      alive = run->t;
    look(&halfway, run->t, x);
    look(&last, run->t, x);
  }
  r.beyond = r.time > last.from;
  if (r.beyond) {
    r.end = log(halfway.x / last.x) / (last.t - halfway.t);
    r.time = last.t + log(last.x / (settled * r.peak)) / linear_rate;
  }
  if (!(linear_rate > 0.)) /* what has decayed comes back */
    r.time = INFINITY;
  return r;
}

static void print_response(const struct response *r)
{
  if (r->beyond)
    printf(",%.6g,rate,%.6g", r->time, r->end);
  else
    printf(",%.6g,run,", r->time);
}

static void print_rows(struct integrator *run, double par[], double V, double dpsi, double ddelta,
                       double window)
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
    const struct response psi = respond(run, par, start, PSI, window, rate);
    const struct response delta = respond(run, par, start, DELTA, window, rate);

    printf("%g,%s,%.6g,%.6g", V, k ? "delta" : "psi", psi.peak * 180. / MLG_PI,
           par[PAR_L_DELTA] * delta.peak);
    print_response(&psi);
    print_response(&delta);
    printf(",%.6g,%.6g,%ld\n", rate, mode.zeta, run->limits);
  }
}

int main(int argc, char *argv[])
{
  struct { const char *name; double value; } option[] = { { "dpsi", 1. }, { "ddelta", 0.45 }, { "window", 10. } };
  enum { OPTIONS = sizeof option / sizeof *option };
  struct integrator run;
  double par[36] = { 0. };
  int at_V = 0;

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
  printf("V,disturbance,psi_max,dstar_max,psi_5,psi_by,psi_end,dstar_5,dstar_by,dstar_end,rate,zeta,limits\n");
  for (double V = 5.; V <= MLG_V_TOP && !at_V; V += 5.)
    print_rows(&run, par, V, option[0].value, option[1].value, option[2].value);
  if (at_V)
    print_rows(&run, par, par[PAR_V], option[0].value, option[1].value, option[2].value);
  integrator_end(&run);
  return output_status(program);
}
