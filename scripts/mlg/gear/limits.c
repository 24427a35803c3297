/* limits.c - the widest zero-shimmy interval over k_s as b grows, and what limits it
 *
 * Between two b at which another mechanism limits the width, or another boundary point
 * bounds the interval, lies a stretch: one description of what is widest.  Each becomes
 * one run of AUTO (constants/c.boundary.width), from the points of its first b to where
 * the event that ends it passes zero.  What the next stretch is follows from the answer on
 * both sides of the event, for any layout and gear.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "names.h"

enum { MOST_NODES = 2048 };

struct node { double b; struct libmlg_widest w; };

struct job {
  const char *command;
  struct arguments a;
  double step;
  struct node node[MOST_NODES];
  int n;
  int first[MOST_NODES]; /* node that begins a stretch */
};

static struct node node_at(struct job *j, double b)
{
  struct node here = { .b = b };

  j->a.par[NUMBER_B] = b;
  checked(j->command, libmlg_widest(j->a.layout, j->a.par, 0., 0., j->a.V_top, &here.w));
  return here;
}

static int is_near(const struct libmlg_point *p, const struct libmlg_point *q)
{
  return p->kind == q->kind && fabs(p->omega - q->omega) < 0.05 * p->omega && fabs(p->V - q->V) < 0.1 * (p->V + q->V);
}

/* Two of equal c_d, of which either may have come out as the bound. */
static int is_pair(const struct libmlg_point *p, const struct libmlg_point *third, const struct libmlg_point *q,
                   const struct libmlg_point *other)
{
  return (is_near(p, q) && is_near(third, other)) || (is_near(p, other) && is_near(third, q));
}

/* Whether the description goes on from p to q. */
static int goes_on(const struct libmlg_widest *p, const struct libmlg_widest *q)
{
  if (p->limit != q->limit)
    return 0;
  if (p->limit == LIBMLG_NO_INTERVAL || p->limit == LIBMLG_UNBOUNDED)
    return 1;
  if (p->limit == LIBMLG_EQUAL_LO)
    return is_near(&p->interval.hi, &q->interval.hi) && is_pair(&p->interval.lo, &p->third, &q->interval.lo, &q->third);
  if (p->limit == LIBMLG_EQUAL_HI)
    return is_near(&p->interval.lo, &q->interval.lo) && is_pair(&p->interval.hi, &p->third, &q->interval.hi, &q->third);
  return is_near(&p->interval.lo, &q->interval.lo) && is_near(&p->interval.hi, &q->interval.hi);
}

static void add_node(struct job *j, const struct node *node)
{
  if (j->n == MOST_NODES)
    fail(j->command, MLG_FAILED, "more than %d places where the limit changes", MOST_NODES / 2);
  j->first[j->n] = j->n == 0;
  j->node[j->n++] = *node;
}

/* Adds b after a, which is there, and both sides of each event between them. */
static void add_to(struct job *j, const struct node *a, const struct node *b, double tolerance)
{
  if (goes_on(&a->w, &b->w))
    return;
  if (b->b - a->b > tolerance) {
    const struct node middle = node_at(j, 0.5 * (a->b + b->b));

    add_to(j, a, &middle, tolerance);
    if (j->node[j->n - 1].b < middle.b && !goes_on(&middle.w, &b->w))
      add_node(j, &middle);
    add_to(j, &middle, b, tolerance);
    return;
  }
  if (j->node[j->n - 1].b < a->b)
    add_node(j, a);
  add_node(j, b);
  j->first[j->n - 1] = 1;
}

/* Right beside an event rounding may name the limit now so, now so: stretches of less than a
 * thousandth of a step go. */
static void drop_slivers(struct job *j, double least)
{
  int kept = 0;

  for (int i = 0, last; i < j->n; i = last + 1) {
    for (last = i; last + 1 < j->n && !j->first[last + 1]; last++)
      ;
    if (last + 1 < j->n && i > 0 && j->node[last + 1].b - j->node[i].b < least)
      continue;
    for (int k = i; k <= last; k++) {
      j->first[kept] = k == i && !(kept > 0 && goes_on(&j->node[kept - 1].w, &j->node[k].w));
      j->node[kept++] = j->node[k];
    }
  }
  j->n = kept;
}

static void find_nodes(struct job *j, double from, double to, double step, double tolerance)
{
  const int steps = (int)floor((to - from) / step + 1e-9);
  struct node last = node_at(j, from);

  add_node(j, &last);
  for (int i = 1; i <= steps; i++) {
    const struct node next = node_at(j, from + i * step);

    add_to(j, &last, &next, tolerance);
    if (j->node[j->n - 1].b < next.b)
      add_node(j, &next);
    last = next;
  }
  drop_slivers(j, 1e-3 * step);
}

/* --- the table ------------------------------------------------------------------------ */

static void print_table(const struct job *j)
{
  printf("# The widest zero-shimmy interval over k_s: b N m s^2/rad, k_s N m/rad, c_lo, c_hi, width N m s/rad, V_lo,\n"
         "# V_hi m/s; limit: what ends its growth over k_s.\n"
         "layout,b,k_s,c_lo,c_hi,width,V_lo,V_hi,limit\n");
  for (int i = 0; i < j->n; i++) {
    const struct libmlg_widest *w = &j->node[i].w;

    if (w->limit == LIBMLG_NO_INTERVAL)
      printf("%s,%.10g,,,,0,,,%s\n", libmlg_layout_name(j->a.layout), j->node[i].b, limit_name(w->limit));
    else
      printf("%s,%.10g,%.10g,%.10g,%.10g,%.10g,%.6g,%.6g,%s\n", libmlg_layout_name(j->a.layout), j->node[i].b, w->k_s,
             w->interval.lo.c_d, w->interval.hi.c_d, w->width, w->interval.lo.V, w->interval.hi.V, limit_name(w->limit));
  }
}

/* --- stretches as runs of AUTO --------------------------------------------------------- */

/* The boundary point, other than lo and hi, that is most like p. */
static struct libmlg_point most_like(struct job *j, const struct node *node, const struct libmlg_point *p)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS], best = node->w.interval.lo;
  double least = HUGE_VAL;

  j->a.par[NUMBER_B] = node->b;
  j->a.par[NUMBER_K_S] = node->w.k_s;
  const int n = checked(j->command, libmlg_boundary_points(j->a.layout, j->a.par, 0., 0., j->a.V_top, point, LIBMLG_MOST_POINTS));

  for (int i = 0; i < n; i++) {
    const double apart = fabs(log(point[i].omega / p->omega)) + fabs(log(point[i].V / p->V)) + 0.1 * fabs(log(point[i].c_d / p->c_d));

    if (point[i].kind == p->kind && apart < least && !is_near(&point[i], &node->w.interval.lo)
        && !is_near(&point[i], &node->w.interval.hi)) {
      least = apart;
      best = point[i];
    }
  }
  return best;
}

/* The top of the next region below the interval: who may take over from lo. */
static struct libmlg_point below(struct job *j, const struct node *node)
{
  const struct libmlg_point *lo = &node->w.interval.lo;
  struct libmlg_point point[LIBMLG_MOST_POINTS], best = *lo;
  double highest = 0.;

  j->a.par[NUMBER_B] = node->b;
  j->a.par[NUMBER_K_S] = node->w.k_s;
  const int n = checked(j->command, libmlg_boundary_points(j->a.layout, j->a.par, 0., 0., j->a.V_top, point, LIBMLG_MOST_POINTS));

  for (int i = 0; i < n; i++)
    if (point[i].kind == lo->kind && point[i].c_d < lo->c_d * (1. + 1e-6) && point[i].c_d > highest && !is_near(&point[i], lo)) {
      highest = point[i].c_d;
      best = point[i];
    }
  return best;
}

static int print_point(int i, const struct libmlg_point *p)
{
  printf("%s'omega_%d': %.12g, 'speed_%d': %.12g, 'logc_%d': %.12g", i > 1 ? ", " : "", i, p->omega / 10., i, p->V / 10., i,
         log10(p->c_d));
  return i + 1;
}

/* What passes zero where the stretch ends: a result of models/boundary.h, or NULL: another
 * interval, far from this one, becomes the wider, or another limit, of which this one knows
 * nothing, is met first. */
static const char *event_between(const struct libmlg_widest *w, const struct libmlg_widest *next)
{
  const int same_lo = is_near(&w->interval.lo, &next->interval.lo) || is_near(&w->third, &next->interval.lo)
                      || (next->limit == LIBMLG_EQUAL_LO && is_near(&w->interval.lo, &next->third));

  if (fabs(next->k_s / w->k_s - 1.) > 1e-4)
    return NULL;
  if (w->limit == LIBMLG_ONSET && next->limit == LIBMLG_EQUAL_LO && same_lo)
    return "gap";
  if (w->limit == LIBMLG_EQUAL_LO && next->limit == LIBMLG_STATIONARY && same_lo)
    return "slope_1";
  if (w->limit == LIBMLG_EQUAL_LO && next->limit == LIBMLG_ONSET && same_lo)
    return "fold";
  if (w->limit == LIBMLG_ONSET && next->limit == LIBMLG_ONSET && !is_near(&w->interval.lo, &next->interval.lo))
    return "rival";
  return NULL;
}

static double width_at(struct job *j, double b)
{
  return node_at(j, b).w.width;
}

/* The b inside a stretch at which the width is largest, or NaN: at an end.  Newton's method
 * on differences, for the width is flat there. */
static double peak_of(struct job *j, int first, int last)
{
  int top = first;

  for (int i = first; i <= last; i++)
    if (j->node[i].w.width > j->node[top].w.width)
      top = i;
  if (top == first || top == last)
    return NAN;

  const double left = j->node[top - 1].b, right = j->node[top + 1].b;
  double b = j->node[top].b;

  for (double h = 0.2 * fmin(b - left, right - b), i = 0; i < 6; i++) {
    const double before = width_at(j, b - h), here = width_at(j, b), after = width_at(j, b + h);
    const double step = 0.5 * h * (before - after) / (before - 2. * here + after);

    b = fmax(left + h, fmin(right - h, b + step));
    if (fabs(step) < 1e-4)
      break;
    h = fmax(0.02 * (right - left) * 0.2, fmin(h, fabs(step)));
  }
  return b;
}

/* Where a run of a stretch begins: at the first step of b inside, away from the event that
 * begins it, where things move fast. */
static const struct node *start_of(const struct job *j, int first, int last)
{
  for (int i = first; i <= last; i++)
    if (fabs(j->node[i].b / j->step - round(j->node[i].b / j->step)) < 1e-9)
      return &j->node[i];
  return &j->node[first];
}

/* One run: NAME=VALUE words of `mlg run` behind the stretch's number, range and limit. */
static void print_stretch(struct job *j, int number, int first, int last)
{
  const struct node *node = start_of(j, first, last), *end = &j->node[last];
  const struct libmlg_widest *w = &node->w, *next = last + 1 < j->n ? &j->node[last + 1].w : NULL;
  const char *event = next ? event_between(&end->w, next) : "b";
  const double peak = peak_of(j, first, last);
  const int with_rival = event && strcmp(event, "rival") == 0;
  struct libmlg_point lo = w->interval.lo, hi = w->interval.hi, third = w->third;
  int i = 1;

  if (w->limit == LIBMLG_NO_INTERVAL || w->limit == LIBMLG_UNBOUNDED)
    return;
  printf("%d,%.10g,%.10g,%.10g,", number, j->node[first].b, next ? j->node[last + 1].b : end->b, node->b);
  if (!isnan(peak))
    printf("%.3f", peak);
  printf(",%s,", limit_name(w->limit));
  if (w->limit == LIBMLG_RIGID || w->limit == LIBMLG_SOFT || w->interval.lo.kind != LIBMLG_LARGEST || w->interval.hi.kind != LIBMLG_LEAST) {
    printf(",,\n"); /* none of the conditions of models/boundary.h */
    return;
  }
  if (w->limit == LIBMLG_EQUAL_LO && lo.delta_over_psi > third.delta_over_psi) {
    lo = w->third; /* by the delta region is meant: point 1 is its top */
    third = w->interval.lo;
  }
  if (w->limit == LIBMLG_EQUAL_HI && hi.delta_over_psi > third.delta_over_psi) {
    hi = w->third;
    third = w->interval.hi;
  }
  if (w->limit == LIBMLG_STATIONARY)
    third = below(j, node);
  printf("%s,%s,\"U={", with_rival ? "boundary.rival" : "boundary.width", event ? event : "wider");
  i = print_point(i, &third);
  if (with_rival) {
    const struct libmlg_point rival = most_like(j, node, &next->interval.lo);

    i = print_point(i, &rival);
  }
  i = print_point(i, &lo);
  print_point(i, &hi);
  printf(", 'kappa': %.12g}\"\n", 1e5 / w->k_s);
}

/* Where another interval becomes the wider nothing passes zero, so the place has to be known
 * better than that of another event. */
static void sharpen(struct job *j)
{
  for (int i = 0; i + 1 < j->n; i++)
    while (j->first[i + 1] && j->node[i].w.limit != LIBMLG_NO_INTERVAL
           && j->node[i + 1].w.limit != LIBMLG_NO_INTERVAL && !event_between(&j->node[i].w, &j->node[i + 1].w)
           && j->node[i + 1].b - j->node[i].b > 2e-4) {
      const struct node middle = node_at(j, 0.5 * (j->node[i].b + j->node[i + 1].b));

      j->node[goes_on(&j->node[i].w, &middle.w) ? i : i + 1] = middle;
    }
}

static void print_stretches(struct job *j)
{
  int number = 0;

  printf("stretch,b_from,b_to,b_start,b_peak,limit,constants,event,U\n");
  for (int i = 0; i < j->n; i++)
    if (j->first[i]) {
      int last = i;

      while (last + 1 < j->n && !j->first[last + 1])
        last++;
      print_stretch(j, ++number, i, last);
    }
}

static int run(int argc, char *argv[])
{
  static struct job j;
  struct option option[] = {
    { "b_least", "N m s^2/rad", 0., 1e9, 0., NULL },
    { "b_most", "N m s^2/rad", 0., 1e9, 300., NULL },
    { "b_step", "N m s^2/rad", 1e-6, 1e9, 10., NULL },
    { "tolerance", "N m s^2/rad", 1e-12, 1e3, 1e-6, NULL },
    { .name = NULL },
  };
  const int stretches = argc > 2 && strcmp(argv[2], "stretches") == 0;

  j.command = argv[0];
  begin_arguments(&j.a, argc, argv, option);
  for (int i = 2 + stretches; i < argc; i++)
    take_word(&j.a, argv[i]);
  end_arguments(&j.a);
  refuse_given(&j.a, NUMBER_V, "an interval holds for every V");
  refuse_given(&j.a, NUMBER_C_D, "intervals of c_d are asked for");
  refuse_given(&j.a, NUMBER_K_S, "the best k_s is asked for");
  refuse_given(&j.a, NUMBER_B, "b is the axis: b_least, b_most, b_step");
  if (!(option[0].value < option[1].value))
    fail(argv[0], MLG_BAD_INPUT, "b_least = %g is not below b_most = %g N m s^2/rad", option[0].value, option[1].value);
  if ((option[1].value - option[0].value) / option[2].value > MOST_NODES / 2)
    refuse(argv[0], option[2].word ? option[2].word : option[1].word, "more than %d steps of b", MOST_NODES / 2);
  j.step = option[2].value;
  find_nodes(&j, option[0].value, option[1].value, option[2].value, option[3].value);
  if (stretches) {
    sharpen(&j);
    print_stretches(&j);
  } else
    print_table(&j);
  return output_status(argv[0]);
}

const struct command command_limits = {
  .name = "limits",
  .usage = "LAYOUT [stretches] [NAME=VALUE ...] [b_least=0] [b_most=300] [b_step=10] [tolerance=1e-6]",
  .summary = "the widest zero-shimmy interval over k_s as b grows, and what limits it",
  .details =
    "A row at each step of b and on both sides, tolerance apart, of each b where the limit or\n"
    "the bounds change.  CSV: layout; b N m s^2/rad; k_s N m/rad; c_lo, c_hi, width N m s/rad;\n"
    "V_lo, V_hi m/s; limit as in `mlg widest`.\n"
    "\n"
    "stretches: one row for each stretch with one limit instead, as a run of AUTO:\n"
    "  stretch, b_from, b_to, b_start, limit; b_peak: where the width is largest inside\n"
    "  constants   boundary.width or boundary.rival; empty: AUTO has no condition for it\n"
    "  event       what passes zero where the stretch ends (models/boundary.h); wider: at b_to\n"
    "              another interval becomes the wider, or another limit is met first; b: at\n"
    "              b_to the range ends\n"
    "  U           the unknowns at b_start, as one word for `mlg run`\n",
  .run = run,
};
