/* boundary.c - Hopf points, boundary points and zero-shimmy intervals at one k_s and b */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"
#include "names.h"

static struct option options[3]; /* as read last */

const char *kind_name(enum libmlg_kind kind)
{
  static const char *const name[] = { "min", "max", "V_least", "V_top", "hopf", "none" };

  return name[kind];
}

const char *shimmy_name(const double par[], double delta_over_psi)
{
  return libmlg_is_delta(par, delta_over_psi) ? "delta" : "psi";
}

int checked(const char *command, int n)
{
  if (n == LIBMLG_UNSURE)
    fail(command, MLG_FAILED, "what was found contradicts itself: no answer for these parameters");
  if (n < 0)
    fail(command, MLG_FAILED, "no eigenvalues: the parameters are not finite");
  return n;
}

static void read_range(struct arguments *a, int argc, char *argv[])
{
  options[0] = (struct option){ "V_least", "m/s", 0., 1e3, 0., NULL };
  options[1] = (struct option){ "zeta", "-", -0.999, 0.999, 0., NULL };
  read_arguments(a, argc, argv, options);
  if (!(options[0].value < a->V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", options[0].value, a->V_top);
}

static const char units[] = "# c_d N m s/rad, V m/s";

static void print_boundary_points(const struct arguments *a, const struct libmlg_point point[], int n)
{
  printf("%s\nc_d,V,frequency_hz,extremum,shimmy\n", units);
  for (int i = 0; i < n; i++)
    printf("%.10g,%.10g,%.10g,%s,%s\n", point[i].c_d, point[i].V, point[i].omega / (2. * MLG_PI), kind_name(point[i].kind),
           shimmy_name(a->par, point[i].delta_over_psi));
}

/* "above" or "below": on which side of a Hopf point, in the parameter n, its mode grows. */
static const char *grows(struct arguments *a, const struct libmlg_point *p, enum parameter_number n)
{
  const struct libmlg_mode mode = { .re = 0., .im = p->omega };
  double slope;

  a->par[NUMBER_V] = p->V;
  a->par[NUMBER_C_D] = p->c_d;
  if (libmlg_growth_slope(a->layout, a->par, &mode, n, &slope) != 0)
    fail(a->command, MLG_FAILED, "no mode at V = %g, c_d = %g", p->V, p->c_d);
  return slope > 0. ? "above" : "below";
}

static void print_hopf_points(struct arguments *a, const struct libmlg_point point[], int n)
{
  const enum parameter_number along = a->word[NUMBER_V] ? NUMBER_C_D : NUMBER_V;

  printf("%s\nc_d,V,frequency_hz,shimmy,grows\n", units);
  for (int i = 0; i < n; i++)
    printf("%.10g,%.10g,%.10g,%s,%s\n", point[i].c_d, point[i].V, point[i].omega / (2. * MLG_PI), shimmy_name(a->par, point[i].delta_over_psi),
           options[1].value == 0. ? grows(a, &point[i], along) : "");
}

static int run_boundary(int argc, char *argv[])
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  struct arguments a;

  read_range(&a, argc, argv);
  refuse_given(&a, NUMBER_V, "boundary points are asked for at every V");
  refuse_given(&a, NUMBER_C_D, "boundary points are asked for at every c_d");
  print_boundary_points(&a, point, checked(argv[0], libmlg_boundary_points(a.layout, a.par, options[1].value, options[0].value, a.V_top,
                                                                       point, LIBMLG_MOST_POINTS)));
  return output_status(argv[0]);
}

static int run_hopf(int argc, char *argv[])
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  struct arguments a;
  int n;

  read_range(&a, argc, argv);
  if (!a.word[NUMBER_V] == !a.word[NUMBER_C_D])
    fail(argv[0], MLG_BAD_INPUT, "expected one of V=VALUE and c_d=VALUE");
  if (a.word[NUMBER_V])
    n = libmlg_hopf_at_V(a.layout, a.par, options[1].value, point, LIBMLG_MOST_POINTS);
  else
    n = libmlg_hopf_at_c_d(a.layout, a.par, options[1].value, options[0].value, a.V_top, point, LIBMLG_MOST_POINTS);
  print_hopf_points(&a, point, checked(argv[0], n));
  return output_status(argv[0]);
}

static int run_intervals(int argc, char *argv[])
{
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
  struct arguments a;

  read_range(&a, argc, argv);
  refuse_given(&a, NUMBER_V, "an interval holds for every V");
  refuse_given(&a, NUMBER_C_D, "intervals of c_d are asked for");

  const int n = checked(argv[0], libmlg_intervals(a.layout, a.par, options[1].value, options[0].value, a.V_top, interval,
                                                  LIBMLG_MOST_POINTS));

  printf("# c_lo, c_hi, width N m s/rad; V_lo, V_hi m/s%s\nc_lo,c_hi,V_lo,V_hi,width,lower,upper\n",
         libmlg_diverges(a.layout, a.par) ? "; the gear diverges at every V and c_d" : "");
  for (int i = 0; i < n; i++) {
    const struct libmlg_point *lo = &interval[i].lo, *hi = &interval[i].hi;

    printf("%.10g,%.10g,%.10g,%.10g,%.10g,%s,%s\n", lo->c_d, hi->c_d, lo->V, hi->V, hi->c_d - lo->c_d, kind_name(lo->kind),
           kind_name(hi->kind));
  }
  return output_status(argv[0]);
}

const struct command command_boundary = {
  .name = "boundary",
  .usage = "LAYOUT [NAME=VALUE ...] [V_least=0] [zeta=0]",
  .summary = "boundary points: where regions of shimmy begin and end in c_d",
  .details =
    "All of them, exactly, for V_least < V < V_top and any c_d and frequency.  CSV:\n"
    "  c_d           N m s/rad\n"
    "  V             m/s\n"
    "  frequency_hz  Hz\n"
    "  extremum      min, max: of c_d along the Hopf curve; V_top, V_least: the curve leaves the\n"
    "                range there (V_least = 0: as V goes to 0)\n"
    "  shimmy        psi or delta, where more of the kinetic energy is\n"
    "zeta: boundary of that damping ratio instead.\n",
  .run = run_boundary,
};

const struct command command_hopf = {
  .name = "hopf",
  .usage = "LAYOUT V=VALUE|c_d=VALUE [NAME=VALUE ...] [V_least=0] [zeta=0]",
  .summary = "all Hopf points at one V or at one c_d",
  .details =
    "By rising c_d or V; columns as those of `mlg boundary`, and\n"
    "  grows         above, below: on which side in c_d or V the mode of the point grows\n"
    "zeta: points of that damping ratio instead; grows is empty then.\n",
  .run = run_hopf,
};

const struct command command_intervals = {
  .name = "intervals",
  .usage = "LAYOUT [NAME=VALUE ...] [V_least=0] [zeta=0]",
  .summary = "zero-shimmy intervals of c_d",
  .details =
    "All of them, exactly: no shimmy at any V_least < V < V_top.  CSV:\n"
    "  c_lo, c_hi, width  N m s/rad; c_hi may be inf\n"
    "  V_lo, V_hi         m/s, where the bounds are\n"
    "  lower, upper       what bounds it, as extremum of `mlg boundary`; none: c_d of 0 or inf\n"
    "zeta: intervals in which every oscillation has at least that damping ratio.\n",
  .run = run_intervals,
};
