/* cycle.c - the periodic orbit that a start leads to, as a row or for AUTO to begin from */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "cycle";
static const double degree = MLG_PI / 180.;

enum { SETTLE, RTOL, POINTS, STEPS, SETTINGS, MOST_OPTIONS = LIBMLG_MOST_STATES + SETTINGS + 1 };

static void options(struct option option[MOST_OPTIONS], int layout)
{
  const int n = libmlg_states(layout);
  const struct option setting[] = {
    { "settle", "s", 0., 1e6, 20., NULL }, { "rtol", "-", 1e-14, 1e-3, 1e-10, NULL },
    { "points", "", 10., 1e5, 400., NULL }, { "steps", "", 1., 1e12, 2e7, NULL }, { NULL, NULL, 0., 0., 0., NULL },
  };

  for (int i = 0; i < n; i++) {
    const struct libmlg_quantity *q = libmlg_state_quantity(layout, i);

    option[i] = (struct option){ q->name, q->unit, -1e6, 1e6, 0., NULL };
  }
  memcpy(option + n, setting, sizeof setting);
}

/* t and the states over a period, a line each, and nothing else: AUTO's dat. */
static void print_orbit(struct libmlg_run *run, const struct arguments *a, const struct libmlg_cycle *c, int points)
{
  libmlg_run_section(run, -1, 0);
  libmlg_run_start(run, a->par, c->u);
  for (int k = 0; k <= points; k++) {
    const double t = c->period * k / points;

    while (libmlg_run_to(run, t) == LIBMLG_AT_LIMIT)
      ;
    printf("%.16g", t);
    for (int i = 0; i < libmlg_states(a->layout); i++)
      printf(" %.16g", k < points ? run->u[i] : c->u[i]);
    printf("\n");
  }
}

static void print_row(const struct arguments *a, const struct libmlg_cycle *c)
{
  const int n = libmlg_states(a->layout);

  printf("# period s; frequency_hz Hz; psi_max deg; dstar_max m; error, multiplier -");
  for (int i = 0; i < n; i++)
    printf("; %s %s", libmlg_state_quantity(a->layout, i)->name, libmlg_state_quantity(a->layout, i)->unit);
  printf("\nperiod,frequency_hz,psi_max,dstar_max,maxima,error,multiplier,corners,limits");
  for (int i = 0; i < n; i++)
    printf(",%s", libmlg_state_quantity(a->layout, i)->name);
  printf("\n%.11g,%.11g,%.11g,%.11g,%d,%.1e,%.8g,%ld,%ld", c->period, 1. / c->period, c->psi / degree,
         c->delta * a->par[NUMBER_L_DELTA], c->maxima, c->error, c->largest, c->corners, c->limits);
  for (int i = 0; i < n; i++)
    printf(",%.11g", c->u[i]);
  printf("\n");
}

/* What the start leads to, periodic or not. */
static void print_motion(const struct libmlg_cycle *c, int found)
{
  const struct libmlg_motion *m = &c->motion;

  printf("# psi_least, psi_most deg; frequency_hz, modulation_hz Hz; exponent 1/s; watched s\n"
         "motion,psi_least,psi_most,frequency_hz,modulation_hz,exponent,watched\n%s,", libmlg_motion_name(m->kind));
  if (found)
    printf("%.6g,%.6g,%.8g,,%.4g,\n", c->psi_least / degree, c->psi_most / degree, c->maxima / c->period, log(c->largest) / c->period);
  else if (m->watched == 0)
    printf(",,,,,\n");
  else {
    printf("%.6g,%.6g,%.6g,", m->psi_least / degree, m->psi_most / degree, m->frequency_hz);
    if (m->kind == LIBMLG_QUASI_PERIODIC)
      printf("%.5g", m->modulation_hz);
    printf(",%.3g,%.4g\n", m->exponent, m->time);
  }
}

/* Why there is no orbit, and what there is instead. */
static void say_why_not(const struct libmlg_run *run, const struct libmlg_cycle *c)
{
  const struct libmlg_motion *m = &c->motion;

  if (!c->why)
    fail(name, MLG_FAILED, "%s%s", run->error, run->most_steps > 0 && run->steps >= run->most_steps ? " (steps= allows more)" : "");
  if (m->watched == 0)
    fail(name, MLG_FAILED, "%s", c->why);
  fprintf(stderr, "mlg %s: %s: maxima of psi from %.4g to %.4g degrees, %.4g a second", name, c->why, m->psi_least / degree,
          m->psi_most / degree, m->frequency_hz);
  if (m->kind == LIBMLG_QUASI_PERIODIC)
    fprintf(stderr, ", modulated at %.4g Hz", m->modulation_hz);
  fprintf(stderr, "; Lyapunov exponent %.2g/s over %.3g s\n", m->exponent, m->time);
  exit(MLG_FAILED);
}

static int cycle(int argc, char *argv[])
{
  struct option option[MOST_OPTIONS];
  struct arguments a;
  struct libmlg_run run;
  struct libmlg_cycle c;
  double start[LIBMLG_MOST_STATES] = { 0. };
  enum { ROW, ORBIT, MOTION } what = ROW;

  begin_arguments(&a, argc, argv, option);
  options(option, a.layout);
  if (argc > 2)
    what = strcmp(argv[2], "orbit") == 0 ? ORBIT : strcmp(argv[2], "motion") == 0 ? MOTION : ROW;
  for (int i = what == ROW ? 2 : 3; i < argc; i++)
    take_word(&a, argv[i]);
  end_arguments(&a);
  const int n = libmlg_states(a.layout);

  if (option[n + POINTS].word && what != ORBIT)
    refuse(name, option[n + POINTS].word, "goes with `mlg cycle LAYOUT orbit`");

  for (int i = 0; i < n; i++)
    start[i] = option[i].value;
  if (libmlg_oscillation_size(a.layout, start) < 1e-11)
    fail(name, MLG_BAD_INPUT, "the gear starts straight and stays so: give a state, as psi=0.05");
  if (fmax(fabs(start[DELTA]), fabs(start[PSI])) > MLG_PI / 2.)
    fail(name, MLG_BAD_INPUT, "delta=%g psi=%g: an angle beyond pi/2", start[DELTA], start[PSI]);
  if (libmlg_run_begin(&run, a.layout, option[n + RTOL].value) != 0)
    fail(name, MLG_FAILED, "out of memory");
  run.most_steps = (long)option[n + STEPS].value;
  const int found = libmlg_cycle(&run, a.layout, a.par, start, option[n + SETTLE].value, &c) == 0;

  if (!found && (what != MOTION || !c.why))
    say_why_not(&run, &c);
  if (what == ORBIT)
    print_orbit(&run, &a, &c, (int)option[n + POINTS].value);
  else if (what == MOTION)
    print_motion(&c, found);
  else
    print_row(&a, &c);
  libmlg_run_end(&run);
  return output_status(name);
}

const struct command command_cycle = {
  .name = name,
  .usage = "LAYOUT [orbit | motion] [NAME=VALUE ...]",
  .summary = "the periodic orbit that a start leads to, for AUTO to begin from; or what else",
  .details =
    "Integrates from a state (psi=0.05, as for mlg simulate) for settle=20 seconds, the sharp\n"
    "corners of play, orifice and relief valve located on the way, and finds the periodic\n"
    "orbit by Newton's method on the Poincare map of the maxima of psi.  Where that orbit is\n"
    "unstable, or none is seen, the run is watched for 400 maxima and, while it still settles,\n"
    "five times again.  settle=0 begins at once, which finds unstable orbits beside the start\n"
    "too.  rtol: of a step (1e-10).  steps=2e7 of the integration are taken at most.\n"
    "\n"
    "Prints CSV: period, frequency_hz, psi_max (deg) and dstar_max (m), the largest of\n"
    "either sign; maxima of psi in a period; error: how far the states are from where they\n"
    "were after a period, relative to the oscillation; multiplier: the largest modulus of the\n"
    "Floquet multipliers but the trivial one, stable below 1; corners and limits (slip angles\n"
    "passing alpha_m) in a period; the states at a maximum of psi.\n"
    "orbit prints t and the states at points=400 times of a period: AUTO's dat\n"
    "(docs/joints.md).\n"
    "motion prints what the start leads to, periodic or not: motion (periodic, dies_out,\n"
    "settling, quasi_periodic, irregular, undecided); psi_least and psi_most (deg) of the maxima\n"
    "of psi, how many a second; modulation_hz of their values, on a torus; exponent (1/s), the\n"
    "largest Lyapunov exponent, above 0 where neighbours part; watched (s).\n"
    "Status 1: no periodic orbit was found, and why; with motion: the integration failed.\n",
  .run = cycle,
};
