/* curves.c - the Hopf curves of a plane as starting points for AUTO, and as a table */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "names.h"
#include "plane.h"

/* of AUTO's pseudo-arclength in (V, c_d): THL of constants/c.LAYOUT.hopf */
static double auto_distance(const struct libmlg_curve_point *a, const struct libmlg_curve_point *b)
{
  return hypot(b->V - a->V, 1e-3 * (b->c_d - a->c_d));
}

/* An open curve begins at the end where a straight run crosses it better. */
static void orient(struct libmlg_curve *curve)
{
  struct libmlg_curve_point *p = curve->point;

  if (curve->closed || !(fabs(p[curve->n - 1].sine) > fabs(p[0].sine)))
    return;
  for (int i = 0, k = curve->n - 1; i < k; i++, k--) {
    const struct libmlg_curve_point point = p[i];

    p[i] = p[k];
    p[k] = point;
  }
  for (int i = 0, k = curve->extrema - 1; i < k; i++, k--) {
    const struct libmlg_point extremum = curve->extremum[i];

    curve->extremum[i] = curve->extremum[k];
    curve->extremum[k] = extremum;
  }
}

/* A closed curve begins at a fold of the period.  AUTO starts at a point past the fold and
 * stops at one before it, where the period is as one half of the way to the start; AUTO
 * must not step over fold and both, so the way is longer than its step. */
static int start_of(const struct libmlg_curve *curve, double step)
{
  const struct libmlg_curve_point *p = curve->point, *last = p + curve->n - 1;
  double way = 0.;
  int i = 0;

  if (!curve->closed)
    return 0;
  while (way < 1.5 * step && i < curve->n / 8) {
    way += auto_distance(&p[i], &p[i + 1]) + auto_distance(last - i, last - i - 1);
    i++;
  }
  return 2 * i;
}

/* The step with which chords stay within 0.04 % of a picture's size of the curve.  The
 * picture shows half of the range of V by two decades of c_d above c_shown; bounds on the
 * step keep small closed curves round and long ones cheap. */
static double smooth_step(const struct libmlg_curve *curve, double V_range, const struct libmlg_plane *plane)
{
  const double V_shown = 0.5 * plane->V_top, c_shown = plane->c_most / 160.;
  double step = V_shown / 100.;

  for (int i = 1; i + 1 < curve->n; i++) {
    const struct libmlg_curve_point *a = &curve->point[i - 1], *b = a + 1, *c = a + 2;
    const double x1 = (b->V - a->V) / V_shown, y1 = 0.5 * log10(b->c_d / a->c_d);
    const double x2 = (c->V - b->V) / V_shown, y2 = 0.5 * log10(c->c_d / b->c_d);
    const double auto_length = auto_distance(a, c) / 2.;
    const double length = hypot(x1 + x2, y1 + y2) / 2.;
    /* turn of the tangent over that length */
    const double turn = fabs(x1 * y2 - x2 * y1) / (hypot(x1, y1) * hypot(x2, y2) + 1e-300);

    if (b->c_d > c_shown && length * turn > 0.)
      step = fmin(step, auto_length * sqrt(8. * 4e-4 / (length * turn)));
  }
  return curve->closed ? fmax(V_range / 300., fmin(V_range / 30., step)) : fmax(0.0015 * V_shown, step);
}

const char *shimmy_of_curve(const struct arguments *a, const struct libmlg_curve *curve)
{
  const struct libmlg_curve_point *p = &curve->point[curve->n / 2];
  double par[LIBMLG_MOST_PARAMETERS];
  struct libmlg_point at[LIBMLG_MOST_POINTS];
  double nearest = INFINITY, ratio = 0.;

  if (curve->extrema)
    return shimmy_name(a->par, curve->extremum[0].delta_over_psi);
  memcpy(par, a->par, sizeof par);
  par[NUMBER_C_D] = p->c_d;
  const int n = libmlg_hopf_at_c_d(a->layout, par, 0., 0., INFINITY, at, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n; i++)
    if (fabs(at[i].omega - p->omega) < nearest) {
      nearest = fabs(at[i].omega - p->omega);
      ratio = at[i].delta_over_psi;
    }
  return shimmy_name(a->par, ratio);
}

static void print_curve(const struct arguments *a, const struct libmlg_plane *plane, const struct libmlg_curve *curve,
                        int number)
{
  const struct libmlg_curve_point *p = curve->point;
  double lowest = p[0].V, highest = p[0].V;

  for (int i = 1; i < curve->n; i++) {
    lowest = fmin(lowest, p[i].V);
    highest = fmax(highest, p[i].V);
  }
  const double V_range = highest - lowest, step = smooth_step(curve, V_range, plane);
  const int start = start_of(curve, step), way = p[start + 1].c_d > p[start].c_d ? 1 : -1;
  /* so near that no other Hopf point disturbs the search for this one */
  const double reach = V_range < 1. ? V_range / 1000. : 0.001;

  printf("%d,%s,%s,%.12g,%.12g,%.12g,%.12g,%.6g,", number, curve->closed ? "closed" : "open", shimmy_of_curve(a, curve), p[start].c_d,
         p[start].V, p[start].V - reach, p[start].V + reach, reach / 4.);
  if (curve->closed)
    printf("%.14g", 2. * MLG_PI / p[curve->n - 1 - start / 2].omega);
  printf(",%.3g,%.3g,", way * (step < 0.1 ? step / 10. : 0.01), step);
  for (int i = 0; i < curve->extrema; i++)
    printf("%s%.12g", i ? " " : "", curve->extremum[i].V);
  printf(",");
  for (int i = 0; i < curve->extrema; i++)
    printf("%s%.12g:%.12g", i ? " " : "", curve->extremum[i].V, curve->extremum[i].c_d);
  printf("\n");
}

static int run(int argc, char *argv[])
{
  const double margin = 1e-5; /* AUTO's run begins just inside the edge that it stops at */
  struct option option[] = {
    { "V_least", "m/s", 1e-9, 1e3, 0.1, NULL },
    { "c_least", "N m s/rad", 1e-9, 1e12, 10., NULL },
    { "c_most", "N m s/rad", 1e-9, 1e12, 8e4, NULL },
    { .name = NULL },
  };
  struct arguments a;
  struct libmlg_curve *curves;

  read_arguments(&a, argc, argv, option);
  refuse_given(&a, NUMBER_V, "V is an axis of the plane");
  refuse_given(&a, NUMBER_C_D, "c_d is an axis of the plane");
  if (!(option[0].value < a.V_top) || !(option[1].value < option[2].value))
    fail(argv[0], MLG_BAD_INPUT, "an empty plane: V from %g to %g m/s, c_d from %g to %g N m s/rad", option[0].value,
         a.V_top, option[1].value, option[2].value);

  const struct libmlg_plane plane = { option[0].value * (1. + margin), a.V_top * (1. - margin),
                                      option[1].value * (1. + margin), option[2].value * (1. - margin) };
  const int n = libmlg_curves(a.layout, a.par, 0., &plane, &curves);

  if (n < 0)
    fail(argv[0], MLG_FAILED, n == LIBMLG_UNSURE ? "whole curves are not known with I_p; `mlg plane LAYOUT regions`, hopf, boundary and intervals take it" : "out of memory");
  printf("curve,kind,shimmy,c_d,V,V_from,V_to,DS_start,stop,DS,DSMAX,extrema_V,extrema\n");
  for (int i = 0; i < n; i++) {
    orient(&curves[i]);
    print_curve(&a, &plane, &curves[i], i + 1);
  }
  libmlg_free_curves(curves, n);
  return output_status(argv[0]);
}

const struct command command_curves = {
  .name = "curves",
  .usage = "LAYOUT [NAME=VALUE ...] [V_least=0.1] [c_least=10] [c_most=8e4]",
  .summary = "every Hopf curve in the (V, c_d) plane, where AUTO may start on it",
  .details =
    "Prints CSV, a row for each curve:\n"
    "  curve      number\n"
    "  kind       open, from edge to edge of the plane, or closed\n"
    "  shimmy     psi or delta: the eigenvector where c_d has its first extremum, or halfway\n"
    "  c_d, V     where to start, N m s/rad and m/s: just inside an edge; closed: beside a fold\n"
    "  V_from, V_to, DS_start   a straight run in V at that c_d that passes it, m/s\n"
    "  stop       closed: the period, s, at which the curve has come round once\n"
    "  DS, DSMAX  of AUTO for a smooth picture, 1 m/s counting as 1000 N m s/rad\n"
    "  extrema_V, extrema   where c_d has an extremum along it, as V and V:c_d, blanks between\n"
    "All curves are found: folds and edges are roots of polynomials (docs/boundary.md).\n",
  .run = run,
};
