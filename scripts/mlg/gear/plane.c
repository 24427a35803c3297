/* plane.c - the (V, c_d) plane exactly, for pictures: its Hopf curves, or its regions */
#include "plane.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "names.h"

enum { V_LEAST, C_LEAST, C_MOST, MOST_MODES = 16, STRIPS = 300 };

double scale_of_c_d(const struct arguments *a)
{
  return a->par[NUMBER_K_D] * sqrt(a->par[NUMBER_J_ZETA] / a->par[NUMBER_K_PSI]);
}

/* A decade about all boundary points and the device's own scale, three about that at most. */
static void natural_range(const struct arguments *a, double V_least, double *c_least, double *c_most)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  const double scale = scale_of_c_d(a);
  const int n = checked(a->command, libmlg_boundary_points(a->layout, a->par, 0., V_least, a->V_top, point, LIBMLG_MOST_POINTS));

  *c_least = fmax(fmin(scale, n > 0 ? point[0].c_d : scale), scale / 100.) / 10.;
  *c_most = fmin(fmax(scale, n > 0 ? point[n - 1].c_d : scale), scale * 100.) * 10.;
}

/* --- curves ------------------------------------------------------------------------------- */

/* The Hopf point at that c_d that is nearest to p in frequency and speed. */
static struct libmlg_point hopf_near(const struct arguments *a, double c_d, const struct libmlg_curve_point *p)
{
  double par[LIBMLG_MOST_PARAMETERS], nearest = HUGE_VAL;
  struct libmlg_point point[LIBMLG_MOST_POINTS], best = { c_d, p->V, p->omega, 0., LIBMLG_HOPF };

  memcpy(par, a->par, sizeof par);
  par[NUMBER_C_D] = c_d;
  const int n = libmlg_hopf_at_c_d(a->layout, par, 0., 0., 2. * a->V_top, point, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n; i++) {
    const double apart = fabs(log(point[i].omega / p->omega)) + fabs(log(point[i].V / p->V));

    if (apart < nearest) {
      nearest = apart;
      best = point[i];
    }
  }
  return best;
}

/* Where the stretches from p and from q cross, to rounding: two oscillations at the margin
 * at once.  The secant method on the difference of their speeds. */
static void print_double_hopf(const struct arguments *a, const struct libmlg_curve_point *p, const struct libmlg_curve_point *q)
{
  const double px = p[1].V - p[0].V, py = p[1].c_d - p[0].c_d, qx = q[1].V - q[0].V, qy = q[1].c_d - q[0].c_d;
  const double rx = q[0].V - p[0].V, ry = q[0].c_d - p[0].c_d, det = px * qy - py * qx;
  const double s = (rx * qy - ry * qx) / det, t = (rx * py - ry * px) / det;

  if (det == 0. || !(s >= 0. && s < 1. && t >= 0. && t < 1.) || fabs(log(p->omega / q->omega)) < 0.02)
    return;
  double c[2] = { p[0].c_d + s * py, 0. }, apart[2];
  struct libmlg_point on_p = hopf_near(a, c[0], p), on_q = hopf_near(a, c[0], q);

  apart[0] = on_p.V - on_q.V;
  c[1] = c[0] * (1. + 1e-4);
  for (int i = 0; i < 20 && fabs(c[1] / c[0] - 1.) > 1e-12; i++) {
    on_p = hopf_near(a, c[1], p);
    on_q = hopf_near(a, c[1], q);
    apart[1] = on_p.V - on_q.V;
    if (apart[1] == apart[0])
      break;
    const double next = c[1] - apart[1] * (c[1] - c[0]) / (apart[1] - apart[0]);

    if (!(next > 0.5 * c[1] && next < 2. * c[1]))
      return;
    c[0] = c[1];
    apart[0] = apart[1];
    c[1] = next;
  }
  printf("0,point,both,HH,%.8g,%.8g,%.6g\n", on_p.V, on_p.c_d, on_p.omega / (2. * MLG_PI));
}

static void print_crossings(const struct arguments *a, const struct libmlg_curve curve[], int n)
{
  for (int i = 0; i < n; i++)
    for (int k = i; k < n; k++)
      for (int u = 0; u + 1 < curve[i].n; u++)
        for (int v = k == i ? u + 2 : 0; v + 1 < curve[k].n; v++)
          print_double_hopf(a, &curve[i].point[u], &curve[k].point[v]);
}

static void print_curve_point(int curve, const char *kind, const char *shimmy, const struct libmlg_curve_point *p)
{
  printf("%d,%s,%s,,%.8g,%.8g,%.6g\n", curve + 1, kind, shimmy, p->V, p->c_d, p->omega / (2. * MLG_PI));
}

static void print_curves(const struct arguments *a, const struct libmlg_plane *plane)
{
  struct libmlg_curve *curve;
  const int n = libmlg_curves(a->layout, a->par, 0., plane, &curve);

  if (n < 0)
    fail(a->command, MLG_FAILED, n == LIBMLG_UNSURE ? "whole curves are not known with I_p; `mlg plane LAYOUT regions`, hopf, boundary and intervals take it" : "out of memory");
  printf("# Hopf curves: V m/s, c_d N m s/rad, frequency Hz; plane %.6g,%.6g,%.6g,%.6g\n"
         "curve,kind,shimmy,type,V,c_d,frequency_hz\n", plane->V_least, plane->V_top, plane->c_least, plane->c_most);
  for (int i = 0; i < n; i++) {
    const char *kind = curve[i].closed ? "closed" : "open", *before = NULL;

    for (int k = 0; k < curve[i].n; k++) {
      const struct libmlg_curve_point *p = &curve[i].point[k];
      const char *shimmy = shimmy_name(a->par, hopf_near(a, p->c_d, p).delta_over_psi);

      if (before && before != shimmy) { /* the stretches of either name meet there */
        print_curve_point(i, kind, before, p);
        printf("\n");
      }
      print_curve_point(i, kind, shimmy, p);
      before = shimmy;
    }
    printf("\n");
    for (int k = 0; k < curve[i].extrema; k++)
      printf("%d,%s,%s,LP,%.8g,%.8g,%.6g\n", i + 1, kind, shimmy_name(a->par, curve[i].extremum[k].delta_over_psi), curve[i].extremum[k].V,
             curve[i].extremum[k].c_d, curve[i].extremum[k].omega / (2. * MLG_PI));
    if (curve[i].extrema)
      printf("\n");
  }
  print_crossings(a, curve, n);
  libmlg_free_curves(curve, n);
}

/* --- regions ------------------------------------------------------------------------------ */

/* What grows at the V and c_d of par[]. */
static const char *growing(const struct arguments *a, const double par[])
{
  struct libmlg_mode mode[MOST_MODES];
  int psi = 0, delta = 0, diverges;
  const int n = libmlg_modes(a->layout, par, mode, MOST_MODES, &diverges);

  if (n < 0)
    fail(a->command, MLG_FAILED, "no eigenvalues at V = %g, c_d = %g", par[NUMBER_V], par[NUMBER_C_D]);
  for (int i = 0; i < n; i++)
    if (mode[i].re > 0.)
      *(libmlg_is_delta(par, mode[i].delta_over_psi) ? &delta : &psi) = 1;
  return diverges ? "divergence" : psi && delta ? "both" : psi ? "psi" : delta ? "delta" : "none";
}

static void print_regions(const struct arguments *a, const struct libmlg_plane *plane)
{
  const double step = log(plane->c_most / plane->c_least) / STRIPS;
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  double par[LIBMLG_MOST_PARAMETERS];

  memcpy(par, a->par, sizeof par);
  printf("# strips of the plane: c_lo, c_hi N m s/rad, V_lo, V_hi m/s; grows: psi, delta, both, divergence, none\n"
         "c_lo,c_hi,V_lo,V_hi,grows\n");
  for (int i = 0; i < STRIPS; i++) {
    double V = 0.;

    par[NUMBER_C_D] = plane->c_least * exp((i + 0.5) * step);
    const int n = checked(a->command, libmlg_hopf_at_c_d(a->layout, par, 0., 0., plane->V_top, point, LIBMLG_MOST_POINTS));

    for (int k = 0; k <= n; k++) {
      const double to = k < n ? point[k].V : plane->V_top;

      par[NUMBER_V] = 0.5 * (V + to);
      if (to > V)
        printf("%.6g,%.6g,%.6g,%.6g,%s\n", plane->c_least * exp(i * step), plane->c_least * exp((i + 1.) * step), V, to,
               growing(a, par));
      V = to;
    }
  }
}

static int run(int argc, char *argv[])
{
  struct option option[] = {
    [V_LEAST] = { "V_least", "m/s", 1e-9, 1e3, NAN, NULL },
    [C_LEAST] = { "c_least", "N m s/rad", 1e-12, 1e15, NAN, NULL },
    [C_MOST] = { "c_most", "N m s/rad", 1e-12, 1e15, NAN, NULL },
    { .name = NULL },
  };
  const int regions = argc > 2 && strcmp(argv[2], "regions") == 0;
  struct libmlg_plane plane;
  struct arguments a;

  begin_arguments(&a, argc, argv, option);
  for (int i = 2 + regions; i < argc; i++)
    take_word(&a, argv[i]);
  end_arguments(&a);
  refuse_given(&a, NUMBER_V, "V is an axis of the plane");
  refuse_given(&a, NUMBER_C_D, "c_d is an axis of the plane");
  plane.V_top = a.V_top;
  plane.V_least = option[V_LEAST].word ? option[V_LEAST].value : a.V_top / 2000.;
  natural_range(&a, 0., &plane.c_least, &plane.c_most);
  if (option[C_LEAST].word)
    plane.c_least = option[C_LEAST].value;
  if (option[C_MOST].word)
    plane.c_most = option[C_MOST].value;
  if (!(plane.V_least < plane.V_top) || !(plane.c_least < plane.c_most))
    fail(argv[0], MLG_BAD_INPUT, "an empty plane: V from %g to %g m/s, c_d from %g to %g N m s/rad", plane.V_least,
         plane.V_top, plane.c_least, plane.c_most);
  if (regions)
    print_regions(&a, &plane);
  else
    print_curves(&a, &plane);
  return output_status(argv[0]);
}

const struct command command_plane = {
  .name = "plane",
  .usage = "LAYOUT [regions] [NAME=VALUE ...] [V_least=V_top/2000] [c_least=] [c_most=]",
  .summary = "the (V, c_d) plane exactly: its Hopf curves as points, or what grows where",
  .details =
    "Without c_least and c_most a decade about all boundary points and about\n"
    "k_d sqrt(J_zeta/k_psi), the device's own scale, and three decades about that at most.\n"
    "CSV, a block with an empty line behind it for each curve, or stretch of one name:\n"
    "  curve, kind   number; open, from edge to edge, or closed\n"
    "  shimmy        psi or delta, the oscillation at the margin there\n"
    "  type          LP: an extremum of c_d along it; HH (curve 0): two oscillations at once, to\n"
    "                rounding\n"
    "  V, c_d, frequency_hz   m/s, N m s/rad, Hz\n"
    "Not with I_p, where more than two c_d belong to a frequency; `regions` takes it.\n"
    "\n"
    "regions: strips of the plane instead, 300 of equal ratio in c_d, each cut where it crosses a\n"
    "Hopf curve at the c_d of its middle:\n"
    "  c_lo, c_hi, V_lo, V_hi   N m s/rad, m/s\n"
    "  grows         psi, delta, both: which oscillations grow there; divergence; none\n",
  .run = run,
};
