/* decay.c - from which disturbance, friction or play on does shimmy go on? */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "grid.h"

static const char name[] = "decay";

static const double degree = MLG_PI / 180.;
static const double window = 1.;     /* s, over which the size of an oscillation is the largest psi */
static const double settled = 1e-4;  /* of two windows: what shrinks by less goes on */
static const double exact = 1e-3;    /* relative, of the value that is looked for */

enum { RELEASE, TIME, SIZE, STEPS, MOST_CYCLES = 32 };

struct decay {
  struct arguments a;
  struct option *option;
  struct grid grid;
  struct range of;  /* NAME=FROM:TO:0, what is looked for */
  struct libmlg_run run;
};

/* The largest psi, rad, in a window from here on; infinite where the gear leaves the model. */
static double over_window(struct libmlg_run *run)
{
  const double end = run->t + window;
  double psi = fabs(run->u[PSI]);

  for (int reached; (reached = libmlg_run_to(run, end)) != LIBMLG_AT_TIME;) {
    if (reached == LIBMLG_FAILED)
      return INFINITY;
    psi = fmax(psi, fabs(run->u[PSI]));
  }
  return fmax(psi, fabs(run->u[PSI]));
}

static double play(const struct decay *d)
{
  return d->a.par[NUMBER_G_PSI] + d->a.par[NUMBER_G_S];
}

/* Below that psi, rad, it has died: within the gap, and far below the release. */
static double small(const struct decay *d)
{
  const double release = d->option[RELEASE].value * degree;

  return d->option[SIZE].value * (play(d) > 0. ? fmin(play(d), release) : release);
}

/* Whether shimmy goes on when psi is released, everything else at 0: by integration. */
static int goes_on(struct decay *d)
{
  double u[LIBMLG_MOST_STATES] = { 0. }, before, last = INFINITY;
  int steady = 0;

  u[PSI] = d->option[RELEASE].value * degree;
  libmlg_run_start(&d->run, d->a.par, u);
  libmlg_run_section(&d->run, DPSI, 0);
  do {
    before = last;
    last = over_window(&d->run);
    if (last < small(d))
      return 0;
    steady = d->run.t > 2.5 * window && last > (1. - settled) * before ? steady + 1 : 0;
  } while (steady < 2 && isfinite(last) && d->run.t < d->option[TIME].value);
  return 1;
}

/* The same by describing functions: the release shrinks to the stable cycle below it, or grows
 * from an unstable one to what is above.  A cycle within the gap is none that goes on: there
 * LI2's inerter swings on k_s for ever. */
static int balances(struct decay *d)
{
  struct libmlg_balance cycle[MOST_CYCLES];
  const double least = d->option[SIZE].value * play(d);
  int grows, i = 0, n = libmlg_balance(d->a.layout, d->a.par, 1e-3 * degree, 30. * degree, cycle, MOST_CYCLES, &grows);

  if (n < 0)
    fail(name, MLG_FAILED, "LAPACK failed");
  while (i < n && cycle[i].psi >= d->option[RELEASE].value * degree) /* the largest first */
    i++;
  if (i < n && cycle[i].stable)
    return cycle[i].psi >= least;
  if (i == n && n > 0 && !cycle[n - 1].stable)
    return 0;
  return i > 0 ? cycle[i - 1].psi >= least : grows;
}

static void set(struct decay *d, double value)
{
  retake_value(&d->a, d->of.text, range_name_length(&d->of), value);
}

/* Value i of n from the one end, 0, to the other: equal steps, over a factor of 50 equal ratios. */
static double between(const struct range *r, double i, double n)
{
  return r->from > 0. && r->to / r->from >= 50. ? r->from * pow(r->to / r->from, i / n) : r->from + (r->to - r->from) * i / n;
}

/* The value between the ends where it changes, of several the one next to the end where it
 * dies; NAN when it is the same at both; *from, *to: at the ends. */
static double change(struct decay *d, int verdict(struct decay *d), int *from, int *to)
{
  const int n = (int)d->option[STEPS].value;
  double dies, goes;

  set(d, d->of.from);
  *from = verdict(d);
  set(d, d->of.to);
  *to = verdict(d);
  if (*from == *to)
    return NAN;
  dies = *from ? d->of.to : d->of.from;
  goes = *from ? d->of.from : d->of.to;
  for (int i = 1; i < n; i++) {
    const double next = between(&d->of, *from ? n - i : i, n);

    set(d, next);
    if (verdict(d)) {
      goes = next;
      break;
    }
    dies = next;
  }
  while (fabs(goes - dies) > exact * fmax(goes, dies)) {
    const double middle = 0.5 * (goes + dies);

    set(d, middle);
    *(verdict(d) ? &goes : &dies) = middle;
  }
  return 0.5 * (goes + dies);
}

static void print_change(struct decay *d, int verdict(struct decay *d), const char *end)
{
  static const char *const word[2] = { "dies", "goes on" };
  int from, to;
  const double value = change(d, verdict, &from, &to);

  if (isnan(value))
    printf(",");
  else
    printf("%.4g,", value);
  printf("%s,%s%s", word[from], word[to], end);
}

static void print_point(void *data)
{
  print_change(data, goes_on, ",");
  print_change(data, balances, "\n");
  fflush(stdout);
}

/* NAME=FROM:TO, what is looked for. */
static int take_of(struct decay *d, const char *word)
{
  const char *equals = strchr(word, '=');
  struct range r = { .text = word };
  char rest;

  if (!equals || sscanf(equals + 1, "%lf:%lf%c", &r.from, &r.to, &rest) != 2)
    return 0;
  if (d->of.text)
    refuse(name, word, "'%.200s' is looked for already", d->of.text);
  if (!(r.from < r.to && isfinite(r.to)))
    refuse(name, word, "expected NAME=FROM:TO, FROM below TO");
  d->of = r;
  take_value(&d->a, word, range_name_length(&d->of), d->of.to);
  return 1;
}

static int decay(int argc, char *argv[])
{
  struct option option[] = {
    { "release", "deg", 1e-6, 90., 5., NULL }, { "time", "s", 5., 1e6, 100., NULL },
    { "size", "-", 1e-6, 0.99, 0.5, NULL }, { "steps", "", 1., 1e4, 1., NULL }, { NULL, NULL, 0., 0., 0., NULL },
  };
  struct decay d = { .option = option, .grid.a = &d.a };

  begin_arguments(&d.a, argc, argv, option);
  for (int i = 2; i < argc; i++)
    if (!take_of(&d, argv[i]))
      grid_word(&d.grid, argv[i]);
  end_arguments(&d.a);
  if (!d.of.text)
    fail(name, MLG_BAD_INPUT, "expected NAME=FROM:TO, the value that is looked for, as T_psi=0:1000 or release=0.01:10");
  if (libmlg_run_begin(&d.run, d.a.layout, 1e-8) != 0)
    fail(name, MLG_FAILED, "out of memory");
  set(&d, d.of.from);
  grid_check(&d.grid);
  set(&d, d.of.to);
  grid_check(&d.grid);
  grid_head(&d.grid);
  printf("%.*s,from,to,balance,balance_from,balance_to\n", (int)range_name_length(&d.of), d.of.text);
  grid_rows(&d.grid, print_point, NULL, &d);
  libmlg_run_end(&d.run);
  return output_status(name);
}

const struct command command_decay = {
  .name = name,
  .usage = "LAYOUT NAME=FROM:TO [release=5] [steps=1] [NAME=VALUE | NAME=FROM:TO:N ...]",
  .summary = "from which disturbance, friction or play on shimmy goes on",
  .details =
    "Releases the gear at psi = release= degrees (5), everything else at rest, and integrates,\n"
    "sharp corners located (rtol 1e-8), until the largest psi of a second is below size= (0.5)\n"
    "times the play, or the release where that is smaller or there is no play: it dies; or\n"
    "it twice shrinks by less than 1e-4 from one second to the next, or has not died after time=\n"
    "(100) seconds, or leaves the model: it goes on.  By halving it looks, to 1e-3, for the value\n"
    "of NAME between FROM and TO where that changes: NAME is a parameter (T_psi=0:1000), or\n"
    "release (release=0.01:10), the least disturbance that goes on.  Where it changes more than\n"
    "once: of the changes that steps= (1) steps show the one next to the end where it dies.\n"
    "\n"
    "Prints CSV: a row for each gear of up to two ranges NAME=FROM:TO:N (as mlg joints): the\n"
    "value; what happens at FROM and at TO (dies, goes on), and where that is the same the\n"
    "value is empty; balance, balance_from, balance_to: the same by describing functions.\n",
  .run = decay,
};
