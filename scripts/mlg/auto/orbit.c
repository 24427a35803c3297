/* orbit.c - mlg orbit: a periodic solution at even phases, or its first state */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mlg.h"
#include "command.h"
#include "solution.h"

enum { SHOWN = 4 }; /* psi in degrees, dstar, lambda_L, lambda_R in m */

/* These four at row i. */
static void shown_at(const struct solution *s, long i, const int column[SHOWN], double l_delta, double shown[SHOWN])
{
  const double *row = &s->value[i * (s->states + 1)];

  for (int k = 0; k < SHOWN; k++)
    shown[k] = row[column[k]];
  shown[0] /= MLG_PI / 180.;
  shown[1] *= l_delta;
}

/* The row at which the larger of psi and delta is largest. */
static long peak_of(const struct solution *s, const int column[SHOWN])
{
  double most[2] = { 0., 0. };
  long peak = 0;
  int large;

  for (long i = 0; i < s->rows; i++)
    for (int k = 0; k < 2; k++)
      most[k] = fmax(most[k], fabs(s->value[i * (s->states + 1) + column[k]]));
  large = column[most[0] > most[1] ? 0 : 1];
  for (long i = 0; i < s->rows; i++)
    if (s->value[i * (s->states + 1) + large] > s->value[peak * (s->states + 1) + large])
      peak = i;
  return peak;
}

static double time_at(const struct solution *s, long i)
{
  return s->value[i * (s->states + 1)];
}

static int print_phases(const struct solution *s, long steps, const char *prefix)
{
  static const char *const names[SHOWN] = { "psi", "delta", "lambda_L", "lambda_R" };
  const double l_delta = solution_parameter(s, "l_delta");
  double here[SHOWN], next[SHOWN], period, start;
  int column[SHOWN];

  for (int k = 0; k < SHOWN; k++)
    if ((column[k] = solution_column(s, names[k])) < 0) {
      fprintf(stderr, "orbit: it has no state '%s'\n", names[k]);
      return MLG_BAD_INPUT;
    }
  if (isnan(l_delta) || s->rows < 3) {
    fprintf(stderr, "orbit: it is no periodic solution of a landing gear\n");
    return MLG_BAD_INPUT;
  }
  start = time_at(s, peak_of(s, column));
  period = time_at(s, s->rows - 1) - time_at(s, 0);
  for (long k = 0; k <= steps; k++) {
    double at = start + (double)(k % steps) / (double)steps * period, w;
    long i = 0;

    if (at >= time_at(s, s->rows - 1))
      at -= period;
    while (i < s->rows - 2 && time_at(s, i + 1) <= at)
      i++;
    w = (at - time_at(s, i)) / (time_at(s, i + 1) - time_at(s, i));
    shown_at(s, i, column, l_delta, here);
    shown_at(s, i + 1, column, l_delta, next);
    printf("%s%s%.6f,%.7f", prefix, *prefix ? "," : "", (double)k / (double)steps, (double)k / (double)steps * period);
    for (int n = 0; n < SHOWN; n++)
      printf(",%.4g", (1. - w) * here[n] + w * next[n]);
    putchar('\n');
  }
  return MLG_OK;
}

static void print_start(const struct solution *s)
{
  for (int k = 0; k < s->states; k++)
    printf("%s=%.11g\n", s->state[k], s->value[k + 1]);
}

static int run(int argc, char *argv[])
{
  struct run_files files;
  struct solution solution;
  const char *prefix = "";
  long phases = 96;
  int status, start = 0;

  if (argc < 3) {
    fputs("usage: mlg orbit RUN NAME [phases=N] [prefix=TEXT] [start]\n", stderr);
    return MLG_BAD_INPUT;
  }
  for (int i = 3; i < argc; i++) {
    if (strncmp(argv[i], "prefix=", 7) == 0)
      prefix = argv[i] + 7;
    else if (strcmp(argv[i], "start") == 0)
      start = 1;
    else if (strncmp(argv[i], "phases=", 7) != 0 || !whole_number(argv[i] + 7, 1, 1000000, &phases)) {
      fprintf(stderr, "orbit: '%s': expected phases=N, prefix=TEXT or start\n", argv[i]);
      return MLG_BAD_INPUT;
    }
  }
  if (find_run_or_say("orbit", argv[1], &files) != 0)
    return MLG_BAD_INPUT;
  status = read_solution_or_say("orbit", &files, argv[2], &solution);
  if (status == 0) {
    if (start)
      print_start(&solution);
    else
      status = print_phases(&solution, phases, prefix);
    free_solution(&solution);
  }
  free_run(&files);
  return status;
}

const struct command command_orbit = {
  "orbit", "RUN NAME [phases=N] [prefix=TEXT] [start]",
  "a periodic solution at even phases, or where it starts",
  "NAME as in IRS (UZ1) or AUTO's label.  Prints prefix, phase (t over the period, 0 at the\n"
  "peak of the larger angle), t (s), psi (deg), dstar, lambda_L, lambda_R (m), N + 1 rows, 96\n"
  "if left out, linear between AUTO's mesh points.  start: instead its first state, a line\n"
  "STATE=VALUE each.  All of it over time: mlg table RUN solution NAME.\n",
  run,
};
