/* grazing.c - mlg grazing: how the orbits of a run pass the ends of the gap in the torque links
 *
 * A cycle passes each end of its gap twice, or one end only, or none, or comes back to one
 * in between.  Along a branch that number changes where an extremum of the twist just touches
 * an end: there the cycle grazes.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "autofile.h"
#include "command.h"
#include "libmlg.h"
#include "mlg.h"
#include "runs.h"

/* What an orbit does at the ends of its gap. */
struct passages { int number; double nearest; };

/* The number of the layout whose states the solution has. */
static int layout_of(const char *word, const struct run_files *files)
{
  const int layout = files->layout ? libmlg_layout(files->layout) : LIBMLG_NONE;

  if (layout == LIBMLG_NONE)
    fprintf(stderr, "grazing: %s: its layout is not known\n", word);
  return layout;
}

/* The extremum between the times of three values, by a parabola. */
static double extremum(const double t[3], const double x[3])
{
  const double a = (x[1] - x[0]) / (t[1] - t[0]), b = ((x[2] - x[1]) / (t[2] - t[1]) - a) / (t[2] - t[0]);
  const double at = 0.5 * (t[0] + t[1]) - (fabs(b) > 0. ? a / (2. * b) : 0.);

  return x[0] + a * (at - t[0]) + b * (at - t[0]) * (at - t[1]);
}

/* Of the twists x[] at the times t[] of a period, whose last is its first again; half-width g. */
static struct passages passages_of(const double t[], const double x[], long n, double g)
{
  struct passages p = { 0, INFINITY };

  for (long i = 1; i < n; i++) {
    const int next = i + 1 < n;
    const double times[3] = { t[i - 1], t[i], next ? t[i + 1] : t[i] + t[1] - t[0] };
    const double twists[3] = { x[i - 1], x[i], next ? x[i + 1] : x[1] };

    for (int side = -1; side <= 1; side += 2)
      p.number += (x[i - 1] - side * g) * (x[i] - side * g) < 0.;
    if ((twists[1] - twists[0]) * (twists[2] - twists[1]) < 0.) {
      const double beyond = fabs(extremum(times, twists)) / g - 1.;

      p.nearest = fabs(beyond) < fabs(p.nearest) ? beyond : p.nearest;
    }
  }
  return p;
}

/* 0, LIBMLG_FAILED: no gap, or -1 with a line in why. */
static int look_at(const struct af_solutions *all, const struct af_solution *one, int layout, double par[], struct passages *p,
                   struct text *why)
{
  double *row = must_allocate((size_t)one->rows * (size_t)one->row_length * sizeof *row);
  double *t = must_allocate((size_t)one->rows * sizeof *t), *x = must_allocate((size_t)one->rows * sizeof *x), g = 0.;
  int status = af_solution_rows(all, one, row, why);

  for (long i = 0; i < one->rows && status == 0; i++) {
    t[i] = row[i * one->row_length];
    status = libmlg_gap(layout, par, row + i * one->row_length + 1, &x[i], &g);
  }
  if (status == 0)
    *p = passages_of(t, x, one->rows, g);
  free(row);
  free(t);
  free(x);
  return status;
}

static int print(const char *word, const char *along, const struct run_files *files, const struct af_solutions *all)
{
  const int layout = layout_of(word, files), parameter = libmlg_parameter(along);
  double par[LIBMLG_MOST_PARAMETERS], slots[256] = { 0. };
  struct text why = TEXT_NONE;

  if (layout == LIBMLG_NONE || parameter == LIBMLG_NONE) {
    if (layout != LIBMLG_NONE)
      fprintf(stderr, "grazing: '%s': no such parameter\n", along);
    return MLG_BAD_INPUT;
  }
  printf("# %s %s; nearest -\nlabel,%s,passages,nearest\n", along, libmlg_parameter_quantity(parameter)->unit, along);
  for (int i = 0; i < all->n; i++) {
    const struct af_solution *one = &all->solution[i];
    struct passages p;

    if (one->parameters > (int)(sizeof slots / sizeof *slots) || one->states != libmlg_states(layout) || one->rows < 3
        || af_solution_parameters(all, one, slots, &why) != 0) {
      fprintf(stderr, "grazing: %s: %s\n", word, why.length > 0 ? why.at : "not orbits of its layout");
      return MLG_BAD_INPUT;
    }
    libmlg_defaults(par);
    for (int k = 0; k < MLG_PARAMETER_COUNT; k++)
      if (mlg_parameters[k].slot < one->parameters)
        par[libmlg_parameter(mlg_parameters[k].name)] = slots[mlg_parameters[k].slot];
    const int status = look_at(all, one, layout, par, &p, &why);

    if (status == LIBMLG_FAILED)
      continue; /* no gap */
    if (status != 0) {
      fprintf(stderr, "grazing: %s\n", why.at);
      return MLG_BAD_INPUT;
    }
    printf("%d,%.8g,%d,%.4g\n", one->label, par[parameter], p.number, p.nearest);
  }
  text_free(&why);
  return MLG_OK;
}

static int grazing(int argc, char *argv[])
{
  struct run_files files;
  struct af_solutions all;
  struct text why = TEXT_NONE;
  int status;

  if (argc != 3) {
    fputs("usage: mlg grazing RUN PARAMETER\n", stderr);
    return MLG_BAD_INPUT;
  }
  if (find_run_or_say("grazing", argv[1], &files) != 0)
    return MLG_BAD_INPUT;
  if (!files.s || af_read_solutions(&all, files.s, &why) != 0) {
    fprintf(stderr, "grazing: %s\n", files.s ? why.at : "no solutions, s.");
    free_run(&files);
    return MLG_BAD_INPUT;
  }
  status = print(argv[1], argv[2], &files, &all);
  af_free_solutions(&all);
  free_run(&files);
  text_free(&why);
  return status;
}

const struct command command_grazing = {
  .name = "grazing",
  .usage = "RUN PARAMETER",
  .summary = "how the orbits of a run pass the ends of the gap in the torque links",
  .details =
    "For each solution of a branch of orbits that AUTO kept (NPR = 1: all): its label, the value of\n"
    "the parameter, how often the twist of the torque links passes an end of the gap g_psi in a\n"
    "period, 4 where each end is passed out and back, and nearest: of the extrema of the twist\n"
    "the one nearest to an end, how far beyond it, over g_psi, below 0 inside.  Where the number\n"
    "changes from one solution to the next a cycle grazes: nearest is 0 between them.  The gap\n"
    "counts as sharp whatever its corner; a solution without a gap has no row.\n",
  .run = grazing,
};
