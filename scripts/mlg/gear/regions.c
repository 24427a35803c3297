/* regions.c - zero-shimmy intervals over k_s at one b, and the widest */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "names.h"

enum { GRID = 400, MOST = 4 * GRID };

/* What there is at one compliance, 1e5/k_s. */
struct region {
  double compliance;
  int extrema, n;
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
};

struct job { const char *command; struct arguments a; };

/* 0, or LIBMLG_UNSURE: two points are within rounding of each other there. */
static int look_at(struct job *j, double compliance, struct region *r)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  int n;

  r->compliance = compliance;
  r->extrema = 0;
  j->a.par[NUMBER_K_S] = compliance > 0. ? 1e5 / compliance : INFINITY;
  const int status = libmlg_points_and_intervals(j->a.layout, j->a.par, 0., 0., j->a.V_top, point, &n, r->interval, &r->n);

  for (int i = 0; i < n; i++)
    r->extrema += point[i].kind == LIBMLG_LEAST || point[i].kind == LIBMLG_LARGEST;
  return status;
}

/* A place where two points are one is a single one: then beside it. */
static void region_at(struct job *j, double compliance, struct region *r)
{
  static const double beside[] = { 0., -1e-8, 1e-8, -1e-7, 1e-7, -1e-6, 1e-6 };
  int status = LIBMLG_UNSURE;

  for (size_t i = 0; i < sizeof beside / sizeof *beside && status != 0; i++)
    status = look_at(j, compliance * (1. + beside[i]), r);
  checked(j->command, status);
}

static void print_region(const struct job *j, const struct region *r)
{
  for (int i = 0; i < r->n; i++) {
    const struct libmlg_interval *z = &r->interval[i];

    printf("%s,%.10g,%.8g,%.8g,%.8g,%.6g,%.6g,%.8g\n", libmlg_layout_name(j->a.layout), j->a.par[NUMBER_B],
           1e5 / r->compliance, z->lo.c_d, z->hi.c_d, z->lo.V, z->hi.V, z->hi.c_d - z->lo.c_d);
  }
}

/* The compliance between two at which their numbers of extrema change. */
static double change(struct job *j, const struct region *from, double to, double tolerance)
{
  struct region middle;
  double a = from->compliance, b = to;

  while (fabs(a - b) > tolerance * fabs(a)) {
    if (look_at(j, 0.5 * (a + b), &middle) != 0)
      break; /* as near as can be told */
    if (middle.extrema == from->extrema)
      a = middle.compliance;
    else
      b = middle.compliance;
  }
  return 0.5 * (a + b);
}

static int falling(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;

  return (x < y) - (x > y);
}

/* From soft to stiff in equal ratios, then rigid, and on both sides of each place where a
 * region is born or two meet. */
static int nodes_of(struct job *j, double softest, double stiffest, double node[MOST])
{
  const double ratio = pow(stiffest / softest, 1. / (GRID - 2));
  struct region last, next;
  int n = 0, grid;

  for (int i = 0; i < GRID; i++)
    node[n++] = i + 1 < GRID ? softest * pow(ratio, i) : 0.;
  grid = n;
  region_at(j, node[0], &last);
  for (int i = 1; i < grid && n + 2 <= MOST; i++) {
    region_at(j, node[i], &next);
    if (next.extrema != last.extrema) {
      const double fold = change(j, &last, node[i], 1e-13);

      if (abs(next.extrema - last.extrema) > 1) /* one alone leaves the range of V */
        for (int side = -1; side <= 1; side += 2)
          node[n++] = fold * (1. + 1e-6 * side);
    }
    last = next;
  }
  qsort(node, (size_t)n, sizeof *node, falling);
  return n;
}

/* Between these compliances, and at 0. */
static void print_regions(struct job *j, double softest, double stiffest)
{
  static struct region last, next, beside;
  double node[MOST];
  const int n = nodes_of(j, softest, stiffest, node);

  region_at(j, node[0], &last);
  print_region(j, &last);
  for (int i = 1; i < n; i++) {
    region_at(j, node[i], &next);
    if (next.n != last.n) { /* both sides of where an interval appears or ends */
      double a = last.compliance, b = next.compliance;

      while (a - b > 1e-6 * a) {
        region_at(j, 0.5 * (a + b), &beside);
        if (beside.n == last.n)
          a = beside.compliance;
        else
          b = beside.compliance;
      }
      for (int side = 0; side < 2; side++)
        if ((side ? b : a) != (side ? next.compliance : last.compliance)) {
          region_at(j, side ? b : a, &beside);
          print_region(j, &beside);
        }
    }
    print_region(j, &next);
    last = next;
  }
}

static int run_regions(int argc, char *argv[])
{
  enum { K_S_LEAST, K_S_MOST };
  struct option option[] = {
    [K_S_LEAST] = { "k_s_least", "N m/rad", 1e-6, 1e30, NAN, NULL },
    [K_S_MOST] = { "k_s_most", "N m/rad", 1e-6, 1e30, NAN, NULL },
    { .name = NULL },
  };
  struct job j = { .command = argv[0] };

  read_arguments(&j.a, argc, argv, option);
  refuse_given(&j.a, NUMBER_V, "an interval holds for every V");
  refuse_given(&j.a, NUMBER_C_D, "intervals of c_d are asked for");
  refuse_given(&j.a, NUMBER_K_S, "k_s is the axis; k_s_least says from where");
  if (libmlg_uses(j.a.layout, NUMBER_K_S) != 1)
    fail(argv[0], MLG_BAD_INPUT, "layout %s has no k_s", libmlg_layout_name(j.a.layout));
  /* for the paper's gear from a compliance of 0.35, in steps of 1 % */
  const double least = option[K_S_LEAST].word ? option[K_S_LEAST].value : j.a.par[NUMBER_K_PSI] / 1.33;
  const double most = option[K_S_MOST].word ? option[K_S_MOST].value : least * pow(1.01, GRID - 2);

  if (!(least < most))
    fail(argv[0], MLG_BAD_INPUT, "k_s_most = %g is not above k_s_least = %g N m/rad", most, least);
  printf("# Zero-shimmy intervals of c_d. b N m s^2/rad; k_s N m/rad (inf: rigid); c_lo, c_hi, width N m s/rad; V_lo,\n"
         "# V_hi m/s, where the bounds are.\nlayout,b,k_s,c_lo,c_hi,V_lo,V_hi,width\n");
  print_regions(&j, 1e5 / least, 1e5 / most);
  return output_status(argv[0]);
}

const char *limit_name(enum libmlg_limit limit)
{
  static const char *const name[] = { "no interval at any k_s", "onset", "equal", "equal above", "stationary", "rigid",
                                      "soft", "unbounded" };

  return name[limit];
}

static int run_widest(int argc, char *argv[])
{
  struct option option[] = {
    { "V_least", "m/s", 0., 1e3, 0., NULL }, { "zeta", "-", -0.999, 0.999, 0., NULL }, { .name = NULL },
  };
  struct arguments a;
  struct libmlg_widest w;

  read_arguments(&a, argc, argv, option);
  refuse_given(&a, NUMBER_V, "an interval holds for every V");
  refuse_given(&a, NUMBER_C_D, "intervals of c_d are asked for");
  refuse_given(&a, NUMBER_K_S, "the best k_s is asked for; `mlg intervals` takes one");
  if (!(option[0].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[0].value, a.V_top);
  checked(argv[0], libmlg_widest(a.layout, a.par, option[1].value, option[0].value, a.V_top, &w));
  printf("# k_s N m/rad, c_lo, c_hi, width N m s/rad; V_lo, V_hi m/s\nk_s,c_lo,c_hi,V_lo,V_hi,width,limit\n");
  printf("%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%s\n", w.k_s, w.interval.lo.c_d, w.interval.hi.c_d, w.interval.lo.V,
         w.interval.hi.V, w.width, limit_name(w.limit));
  return output_status(argv[0]);
}

const struct command command_regions = {
  .name = "regions",
  .usage = "LAYOUT [NAME=VALUE ...] [k_s_least=k_psi/1.33] [k_s_most=VALUE]",
  .summary = "zero-shimmy intervals over k_s",
  .details =
    "At 399 k_s of equal ratio from k_s_least to k_s_most, in steps of 1 % unless that is given,\n"
    "at the rigid spring, and on both sides of every place where a region is born or two meet\n"
    "and where an interval appears or ends.  CSV:\n"
    "  layout; b N m s^2/rad; k_s N m/rad, inf: rigid\n"
    "  c_lo, c_hi, width  N m s/rad\n"
    "  V_lo, V_hi         m/s, where the bounds are\n",
  .run = run_regions,
};

const struct command command_widest = {
  .name = "widest",
  .usage = "LAYOUT [NAME=VALUE ...] [V_least=0] [zeta=0]",
  .summary = "the widest zero-shimmy interval over k_s",
  .details =
    "CSV: k_s N m/rad; c_lo, c_hi, width N m s/rad; V_lo, V_hi m/s; limit, what ends the\n"
    "growth of the width: onset, a region is born inside; equal, another boundary point reaches\n"
    "c_lo (equal above: c_hi); stationary, nothing does; rigid or soft, the end of the range.\n",
  .run = run_widest,
};
