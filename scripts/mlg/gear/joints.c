/* joints.c - the cycles of a gear with play, friction and a real damper: one gear or a map */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "grid.h"

static const char name[] = "joints";

static const double degree = MLG_PI / 180.;

enum { LEAST, PSI_MOST, AT, NEAR, CYCLES, SETTLE, MOST = 32 };

struct map {
  struct arguments a;
  struct option *option;
  struct grid grid;
  struct libmlg_run run;                    /* with cycles=1 */
  double state[LIBMLG_MOST_STATES], psi;    /* of the cycle before, 0: none */
};

static void print_equivalent(const struct arguments *a, const struct option option[])
{
  double equivalent[LIBMLG_MOST_PARAMETERS];
  struct libmlg_mode mode;

  if (libmlg_equivalent(a->layout, a->par, option[AT].value * degree, option[NEAR].value, equivalent, &mode) != 0)
    fail(name, MLG_FAILED, "no oscillation of that size near %g Hz", option[NEAR].value);
  printf("# psi deg; growth 1/s; frequency_hz Hz; k_psi, k_s, k_d N m/rad; c_d, c_psi N m s/rad\n"
         "psi,growth,frequency_hz,delta_over_psi,k_psi,k_s,k_d,c_d,c_psi\n%.11g,%.11g,%.11g,%.11g,%.11g,%.11g,%.11g,%.11g,%.11g\n",
         option[AT].value, mode.re, mode.frequency_hz, mode.delta_over_psi, equivalent[NUMBER_K_PSI],
         equivalent[NUMBER_K_S], equivalent[NUMBER_K_D], equivalent[NUMBER_C_D], equivalent[NUMBER_C_PSI]);
}

static int cycles_of(const struct arguments *a, const struct option option[], struct libmlg_balance cycle[], int *grows)
{
  const int n = libmlg_balance(a->layout, a->par, option[LEAST].value * degree, option[PSI_MOST].value * degree, cycle, MOST, grows);

  if (n < 0)
    fail(name, MLG_FAILED, "LAPACK failed");
  return n;
}

static void print_cycles(const struct arguments *a, const struct option option[])
{
  struct libmlg_balance cycle[MOST];
  int grows;
  const int n = cycles_of(a, option, cycle, &grows);

  printf("# psi deg; dstar m; frequency_hz Hz\npsi,dstar,frequency_hz,stable\n");
  if (grows)
    printf("inf,,,\n");
  for (int i = 0; i < n; i++)
    printf("%.11g,%.11g,%.11g,%d\n", cycle[i].psi / degree, cycle[i].psi * cycle[i].delta_over_psi * a->par[NUMBER_L_DELTA],
           cycle[i].frequency_hz, cycle[i].stable);
}

/* The cycle by integration: from that of the point before, in proportion where both are
 * known, or from afar; what it is where no periodic orbit was found. */
static void print_by_integration(struct map *m, double guess)
{
  const double settle = m->option[SETTLE].value;
  const int same = !isfinite(guess) && !isfinite(m->psi), known = isfinite(guess) && isfinite(m->psi);
  double start[LIBMLG_MOST_STATES] = { 0. };
  struct libmlg_cycle c = { .motion = { .kind = LIBMLG_UNDECIDED } };
  int found = -1;

  if (m->psi > 0. && guess > 0. && (same || known)) {
    for (int i = 0; i < libmlg_states(m->a.layout); i++)
      start[i] = m->state[i] * (same ? 1. : fmin(guess / m->psi, 10.));
    found = libmlg_cycle(&m->run, m->a.layout, m->a.par, start, settle, &c);
  }
  if (found != 0 && c.motion.kind != LIBMLG_QUASI_PERIODIC && c.motion.kind != LIBMLG_IRREGULAR) {
    memset(start, 0, sizeof start);
    start[PSI] = guess > 0. && isfinite(guess) ? fmin(1.2 * guess, 0.3) : 0.1;
    found = libmlg_cycle(&m->run, m->a.layout, m->a.par, start, 5. * settle, &c);
  }
  m->psi = found == 0 ? guess : 0.;
  memcpy(m->state, c.u, sizeof m->state);
  if (found == 0)
    printf(",%.6g,%.6g,%.4g", c.psi / degree, 1. / c.period, c.largest);
  else
    printf(",%s,,", c.motion.kind == LIBMLG_DIES_OUT ? "0" : "");
  printf(",%s,", libmlg_motion_name(c.motion.kind));
  if (found != 0 && c.motion.kind != LIBMLG_DIES_OUT && c.motion.watched > 0)
    printf("%.6g", c.motion.psi_most / degree);
}

/* Of all modes that are found from 4 to 20 Hz the one that grows fastest at that amplitude. */
static void print_growth(void *data)
{
  const struct map *m = data;
  const double nearest = m->option[NEAR].value;
  struct libmlg_mode most = { .re = -INFINITY }, mode;

  for (double near = m->option[NEAR].word ? nearest : 4.; near <= (m->option[NEAR].word ? nearest : 20.); near += 2.)
    if (libmlg_equivalent(m->a.layout, m->a.par, m->option[AT].value * degree, near, NULL, &mode) == 0 && mode.re > most.re)
      most = mode;
  if (isfinite(most.re))
    printf("%.6g,%.6g,%.6g\n", most.re, most.frequency_hz, most.delta_over_psi);
  else
    printf(",,\n");
}

static void print_point(void *data)
{
  struct map *m = data;
  struct libmlg_balance cycle[MOST];
  double psi = 0., hz = 0., threshold = 0.;
  int n, grows;

  n = cycles_of(&m->a, m->option, cycle, &grows);
  for (int i = 0; i < n; i++)
    if (cycle[i].stable && !(psi > 0.)) {
      psi = cycle[i].psi;
      hz = cycle[i].frequency_hz;
    } else if (!cycle[i].stable)
      threshold = cycle[i].psi;
  if (grows)
    printf("inf,,");
  else
    printf("%.6g,%.6g,", psi / degree, hz);
  printf("%.6g", threshold / degree);
  if (m->option[CYCLES].value > 0.)
    print_by_integration(m, grows ? INFINITY : psi);
  printf("\n");
}

/* The cycle before is of no use any more. */
static void forget(void *data)
{
  ((struct map *)data)->psi = 0.;
}

static int joints(int argc, char *argv[])
{
  struct option option[] = {
    { "psi_least", "deg", 1e-9, 90., 1e-3, NULL }, { "psi_most", "deg", 1e-9, 90., 30., NULL },
    { "at", "deg", 1e-9, 90., 0., NULL }, { "near", "Hz", 1e-3, 1e4, 11., NULL },
    { "cycles", "", 0., 1., 0., NULL }, { "settle", "s", 0., 1e6, 4., NULL }, { NULL, NULL, 0., 0., 0., NULL },
  };
  struct map m = { .option = option, .grid.a = &m.a };

  begin_arguments(&m.a, argc, argv, option);
  for (int i = 2; i < argc; i++)
    grid_word(&m.grid, argv[i]);
  end_arguments(&m.a);
  if (option[LEAST].value >= option[PSI_MOST].value)
    refuse(name, option[PSI_MOST].word ? option[PSI_MOST].word : option[LEAST].word, "psi_most has to be above psi_least");
  if (option[AT].word && option[CYCLES].value > 0.)
    refuse(name, option[CYCLES].word, "at= asks for one amplitude, not for cycles");
  if (option[AT].word && (option[LEAST].word || option[PSI_MOST].word))
    refuse(name, option[LEAST].word ? option[LEAST].word : option[PSI_MOST].word, "at= asks for one amplitude, not for cycles");
  if (option[NEAR].word && !option[AT].word)
    refuse(name, option[NEAR].word, "goes with at=DEGREES");
  if (option[CYCLES].value > 0. && m.grid.ranges == 0)
    refuse(name, option[CYCLES].word, "goes with a range NAME=FROM:TO:N; `mlg cycle` has the cycle of one gear");
  if (option[SETTLE].word && !(option[CYCLES].value > 0.))
    refuse(name, option[SETTLE].word, "goes with cycles=1");
  if (option[AT].word && m.grid.ranges == 0)
    print_equivalent(&m.a, option);
  else if (m.grid.ranges == 0)
    print_cycles(&m.a, option);
  else {
    if (option[CYCLES].value > 0. && libmlg_run_begin(&m.run, m.a.layout, 1e-8) != 0)
      fail(name, MLG_FAILED, "out of memory");
    grid_check(&m.grid);
    grid_head(&m.grid);
    printf("%s%s\n", option[AT].word ? "growth,frequency_hz,delta_over_psi" : "psi,frequency_hz,threshold",
           option[CYCLES].value > 0. ? ",psi_cycle,hz_cycle,multiplier,motion,psi_most" : "");
    grid_rows(&m.grid, option[AT].word ? print_growth : print_point, forget, &m);
    libmlg_run_end(&m.run);
  }
  return output_status(name);
}

const struct command command_joints = {
  .name = name,
  .usage = "LAYOUT [at=DEGREES [near=HZ]] [cycles=1 [settle=4]] [NAME=VALUE | NAME=FROM:TO:N ...]",
  .summary = "cycles of play, friction and a real damper, by describing functions",
  .details =
    "Each element with a law (g_psi, g_s, T_f, T_psi, c_2, T_max, k_s3, k_d3) is taken in\n"
    "an oscillation of the amplitude psi for the linear one that does the same in the mean\n"
    "of a cycle; the gear itself is taken for linear, the motion for one harmonic\n"
    "(docs/joints.md says where that holds).\n"
    "\n"
    "Prints CSV: the cycles with psi from psi_least= (0.001 degrees) to psi_most= (30), the\n"
    "largest first: psi deg, dstar m, frequency_hz, stable (1, 0): an unstable one is how\n"
    "large a disturbance has to be; psi inf: an oscillation of psi_most grows. No row: from\n"
    "everywhere between these straight rolling is reached, or from nowhere.\n"
    "at=DEGREES prints that linear gear for one amplitude and the mode near near= (11 Hz):\n"
    "growth, 1/s, below 0 where it falls; frequency; k_psi, k_s, k_d, c_d, c_psi.\n"
    "One or two ranges, N values in equal steps, or in equal ratios where TO is at least 50\n"
    "FROM > 0: a row for each: psi, frequency_hz of the\n"
    "largest stable cycle (0: none, inf: it grows), threshold: psi of the smallest unstable\n"
    "cycle (0: none). cycles=1: beside it psi_cycle, hz_cycle and multiplier of the cycle that\n"
    "integration comes to (mlg cycle, rtol 1e-8), settle= seconds from the point before, five\n"
    "times that from afar; 0: it dies out, within the gap at least; empty: not periodic, and\n"
    "motion says what (mlg help cycle), psi_most the largest maximum of psi then.\n"
    "at=DEGREES with ranges: growth, frequency_hz and |delta/psi| of the mode that grows fastest at\n"
    "that amplitude, of those found from 4, 6, ... 20 Hz, or the one near near=.\n",
  .run = joints,
};
