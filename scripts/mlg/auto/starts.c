/* starts.c - mlg starts: boundary points from which AUTO may follow the curves of a gear;
 * mlg agree: AUTO's boundary points against the exact ones
 *
 * Both hold runs of models/boundary.h against models/libmlg: the first to see which curves
 * are there already, the second as a check that shares nothing with AUTO.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "branch.h"
#include "names.h"
#include "command.h"
#include "select.h"

/* The words of a command: those before the layout's NAME=VALUE are runs. */
struct job {
  struct arguments a;
  struct run_data *run;
  int runs;
};

static void read_runs(struct job *j, const char *command, char *words[], int n)
{
  j->run = must_allocate((size_t)(n + 1) * sizeof *j->run);
  for (int i = 0; i < n; i++)
    if (read_run_or_say(command, words[i], &j->run[j->runs++]) != 0)
      exit(MLG_BAD_INPUT);
}

static void free_runs(struct job *j)
{
  for (int i = 0; i < j->runs; i++)
    free_run_data(&j->run[i]);
  free(j->run);
}

/* --- mlg starts --------------------------------------------------------------------- */

/* Whether a curve of the runs passes this point at the compliance. */
static int is_followed(const struct job *j, double compliance, const struct libmlg_point *p)
{
  for (int r = 0; r < j->runs; r++)
    for (int part = 0; part < j->run[r].all.parts; part++)
      for (long i = 1; i < j->run[r].ending[part].kept; i++) {
        const struct run_data *run = &j->run[r];
        const double before = number_at(run, part, i - 1, "compliance"), here = number_at(run, part, i, "compliance");
        const double t = (compliance - before) / (here - before);
        const double c0 = log10(number_at(run, part, i - 1, "c_1")), c1 = log10(number_at(run, part, i, "c_1"));
        const double f0 = number_at(run, part, i - 1, "f_1"), f1 = number_at(run, part, i, "f_1");

        if (t >= 0. && t <= 1. && fabs(c0 + t * (c1 - c0) - log10(p->c_d)) < 3e-3
            && fabs(f0 + t * (f1 - f0) - p->omega / (2. * MLG_PI)) < 0.03)
          return 1;
      }
  return 0;
}

/* A start that no rounding of the last digits changes: AUTO's steps hang on it. */
static double ten_digits(double x)
{
  char text[32];

  snprintf(text, sizeof text, "%.10g", x);
  return strtod(text, NULL);
}

static int run_starts(int argc, char *argv[])
{
  struct option option[] = {
    { "c_least", "N m s/rad", 0., INFINITY, 0., NULL },
    { "c_most", "N m s/rad", 0., INFINITY, INFINITY, NULL },
    { .name = NULL },
  };
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  struct job j = { .runs = 0 };
  int words = 2;

  begin_arguments(&j.a, argc, argv, option);
  for (; words < argc && strchr(argv[words], '='); words++)
    take_word(&j.a, argv[words]);
  end_arguments(&j.a);
  read_runs(&j, argv[0], argv + words, argc - words);

  const double k_s = j.a.par[NUMBER_K_S], compliance = k_s < MLG_RIGID ? 1e5 / k_s : 0.;
  const int n = checked(argv[0], libmlg_boundary_points(j.a.layout, j.a.par, 0., 0., j.a.V_top, point, LIBMLG_MOST_POINTS));

  for (int i = 0; i < n; i++)
    if ((point[i].kind == LIBMLG_LEAST || point[i].kind == LIBMLG_LARGEST) && point[i].c_d > option[0].value
        && point[i].c_d < option[1].value && !is_followed(&j, compliance, &point[i]))
      printf("U={'omega_1': %.12g, 'speed_1': %.12g, 'logc_1': %.12g}\n",
             2. * MLG_PI * ten_digits(point[i].omega / (2. * MLG_PI)) / 10., ten_digits(point[i].V) / 10.,
             log10(ten_digits(point[i].c_d)));
  free_runs(&j);
  return output_status(argv[0]);
}

/* --- mlg agree ----------------------------------------------------------------------- */

/* The c_d of the exact point nearest to that one; infinite: there is none. */
static double nearest(const struct libmlg_point point[], int n, double c_d, double V)
{
  double best = INFINITY;

  for (int i = 0; i < n; i++)
    if (fabs(point[i].V - V) < 1e-2 * (1. + V) && fabs(point[i].c_d - c_d) < fabs(best - c_d))
      best = point[i].c_d;
  return best;
}

/* |d log c_d / d log k_s| of the exact point c_d, V: AUTO's files give k_s with ten digits,
 * so that where c_d moves fast it is k_s in which the two can agree. */
static double steepness(struct job *j, double k_s, double c_d, double V)
{
  const double step = 1e-8;
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  double moved;
  int n;

  if (!(k_s < MLG_RIGID))
    return 0.;
  j->a.par[NUMBER_K_S] = k_s * (1. + step);
  n = libmlg_boundary_points(j->a.layout, j->a.par, 0., 0., 2. * V + 10., point, LIBMLG_MOST_POINTS);
  j->a.par[NUMBER_K_S] = k_s;
  moved = fabs(nearest(point, n, c_d, V) / c_d - 1.);
  return isfinite(moved) ? moved / step : 0.;
}

/* Whether from lo to hi there is no shimmy, a hair on the softer side of the onset that may
 * limit the interval. */
static int is_interval(struct job *j, double k_s, double lo, double hi)
{
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
  int n;

  j->a.par[NUMBER_K_S] = k_s * (1. - 1e-7);
  n = libmlg_intervals(j->a.layout, j->a.par, 0., 0., j->a.V_top, interval, LIBMLG_MOST_POINTS);
  for (int i = 0; i < n; i++)
    if (fabs(interval[i].lo.c_d / lo - 1.) < 1e-5 && fabs(interval[i].hi.c_d / hi - 1.) < 1e-5)
      return 1;
  return 0;
}

/* The largest of V_1, V_2, ... at a point. */
static double largest_V(const struct run_data *run, int part, long i, int points)
{
  double V = 0.;

  for (int k = 1; k <= points; k++) {
    char name[16];

    snprintf(name, sizeof name, "V_%d", k);
    V = fmax(V, number_at(run, part, i, name));
  }
  return V;
}

/* The exact points at that k_s; at an onset, where two of them are one and cannot be told
 * apart, those a rounding error beside it, of which AUTO's ten digits of k_s know no more. */
static int exact_points(struct job *j, double k_s, double V_top, struct libmlg_point point[])
{
  static const double beside[] = { 0., -1e-9, 1e-9, -3e-9, 3e-9 };
  int n = LIBMLG_UNSURE;

  for (size_t side = 0; side < sizeof beside / sizeof *beside && n < 0; side++) {
    j->a.par[NUMBER_K_S] = fmin(k_s * (1. + beside[side]), MLG_RIGID);
    n = libmlg_boundary_points(j->a.layout, j->a.par, 0., 0., V_top, point, LIBMLG_MOST_POINTS);
  }
  j->a.par[NUMBER_K_S] = fmin(k_s, MLG_RIGID);
  return n;
}

/* The parameters that the run moves, beside V, c_d and k_s, into the arguments. */
static void take_parameters(struct job *j, const struct run_data *run, int part, long i)
{
  for (int n = 0; n < NUMBERS; n++) {
    const double value = n == NUMBER_V || n == NUMBER_C_D || n == NUMBER_K_S ? (double)NAN
                         : n == NUMBER_B ? number_at(run, part, i, "b")
                         : af_column(&run->all.part[part], libmlg_parameter_quantity(n)->name) >= 0
                           ? number_at(run, part, i, libmlg_parameter_quantity(n)->name) : (double)NAN;

    if (!isnan(value))
      j->a.par[n] = value;
  }
}

/* The largest difference along a run; complaints on standard error. */
static double compare_run(struct job *j, const struct run_data *run, double tolerance, long *compared)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  double worst = 0.;

  for (int part = 0; part < run->all.parts; part++) {
    const struct af_part *p = &run->all.part[part];
    int points = 1;

    for (char name[16]; snprintf(name, sizeof name, "V_%d", points + 1) > 0 && af_column(p, name) >= 0; points++)
      ;
    for (long i = 1; i < run->ending[part].kept; i++) { /* AUTO does not correct the first */
      const double k_s = number_at(run, part, i, "k_s");
      int n;

      take_parameters(j, run, part, i);
      n = exact_points(j, k_s, 2. * largest_V(run, part, i, points) + 10., point);
      /* at an onset two exact points are one, to the root of rounding: past it */
      for (int k = 1; k <= points; k++) {
        char c[16], V[16];
        double apart;

        snprintf(c, sizeof c, "c_%d", k);
        snprintf(V, sizeof V, "V_%d", k);
        if (k == 1 && (fabs(number_at(run, part, i, "fold")) < 1e-3 || number_at(run, part, i, "closing") == 0. || (points == 1 && strcmp(point_type(&run->all, p, i), "LP") == 0)))
          continue;
        const double exact = nearest(point, n, number_at(run, part, i, c), number_at(run, part, i, V));

        apart = fabs(exact / number_at(run, part, i, c) - 1.);
        if (!(apart <= worst && apart < tolerance) && isfinite(exact))
          apart /= fmax(1., steepness(j, k_s, exact, number_at(run, part, i, V)));
        worst = fmax(worst, apart);
        (*compared)++;
        if (!(apart < tolerance))
          fprintf(stderr, "agree: %s, k_s = %.10g, b = %g: c_d = %.10g at V = %.6g m/s is no boundary point, nearest %.1e off\n",
                  run->files.name, k_s, j->a.par[NUMBER_B], number_at(run, part, i, c), number_at(run, part, i, V), apart);
      }
      if (points > 1 && strcmp(point_type(&run->all, p, i), "UZ") == 0) {
        char lo[16], hi[16];

        snprintf(lo, sizeof lo, "c_%d", points - 1);
        snprintf(hi, sizeof hi, "c_%d", points);
        if (number_at(run, part, i, lo) < number_at(run, part, i, hi) /* AUTO may pass the end of all intervals */
            && !is_interval(j, k_s, number_at(run, part, i, lo), number_at(run, part, i, hi))) {
          fprintf(stderr, "agree: %s, b = %g: c_d from %.10g to %.10g at k_s = %.10g is not a zero-shimmy interval\n",
                  run->files.name, j->a.par[NUMBER_B], number_at(run, part, i, lo), number_at(run, part, i, hi), k_s);
          worst = INFINITY;
        }
      }
    }
  }
  return worst;
}

static int run_agree(int argc, char *argv[])
{
  struct option option[] = { { "tolerance", "-", 1e-15, 1., 1e-8, NULL }, { .name = NULL } };
  struct job j = { .runs = 0 };
  double worst = 0.;
  long compared = 0;
  int words = 2;

  begin_arguments(&j.a, argc, argv, option);
  for (; words < argc && strchr(argv[words], '='); words++)
    take_word(&j.a, argv[words]);
  end_arguments(&j.a);
  read_runs(&j, argv[0], argv + words, argc - words);
  for (int r = 0; r < j.runs; r++)
    worst = fmax(worst, compare_run(&j, &j.run[r], option[0].value, &compared));
  printf("%ld boundary points, within %.1e\n", compared, worst);
  free_runs(&j);
  return worst < option[0].value && compared > 0 ? output_status(argv[0]) : MLG_FAILED;
}

const struct command command_starts = {
  .name = "starts",
  .usage = "LAYOUT [NAME=VALUE ...] [c_least=0] [c_most=inf] [RUN ...]",
  .summary = "boundary points from which AUTO may follow their curves over k_s",
  .details =
    "A line U={...} for `mlg run NAME boundary.point`, by rising c_d, for each boundary point at\n"
    "that k_s and b that none of the RUNs passes.\n",
  .run = run_starts,
};

const struct command command_agree = {
  .name = "agree",
  .usage = "LAYOUT [NAME=VALUE ...] [tolerance=1e-8] RUN ...",
  .summary = "AUTO's boundary points against the exact ones",
  .details =
    "RUNs of boundary.point, boundary.width or boundary.rival, over the compliance, b or any\n"
    "parameter of the gear, M for one.  Status 1, and a line for each:\n"
    "a point that differs by more than the tolerance, relative, in c_d or where that moves\n"
    "faster in k_s, from every exact boundary point; an interval at a labelled point in which\n"
    "there is shimmy.\n",
  .run = run_agree,
};
