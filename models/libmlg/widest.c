/* widest.c - the widest zero-shimmy interval over k_s
 *
 * Over the compliance 1/k_s the boundary points move smoothly but where one is born,
 * dies or leaves the range of V.  These places are found by bisection on what there is;
 * between them the width is smooth, or has a kink where another point takes over as a
 * bound, and golden section finds its maximum.  What ends the growth there is then read
 * off both sides of it.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "golden.h"
#include "layout.h"
#include "places.h"

/* Each of the nodes and of the finer ones may have a change behind it, which are two more. */
enum { NODES = 64, FINER = 8, MOST_NODES = 3 * (PLACES_MOST + FINER * NODES), MOST_INTERVALS = LIBMLG_MOST_POINTS };

/* What there is at one place u: the widest interval, and a signature that changes with the
 * number and kind of the intervals, or without any with the order and kind of the boundary
 * points: a region may be born, die or part from another one there.  Without an interval the width is below 0: by how
 * much two regions overlap at least, so that a search finds where they part. */
struct state {
  double u, width, parting; /* parting: bottom over top of two regions that overlap, 1: they part */
  unsigned long signature;
  struct libmlg_interval widest;
};

struct search {
  int layout, k_s; /* number of that parameter */
  int by_ratio;    /* log(hi/lo) stands for the width */
  double par[LIBMLG_MOST_PARAMETERS], k_psi, zeta, V_least, V_top;
  int status;
  struct state top; /* of a golden section */
};

/* By which intervals are compared: hi - lo, or log(hi/lo). */
static double size(const struct search *s, double lo, double hi)
{
  return s->by_ratio ? log(hi / lo) : hi - lo;
}

static double k_s_of(const struct search *s, double u)
{
  return libmlg_place_k_s(s->k_psi, u, INFINITY);
}

static struct state state_at(struct search *s, double u)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  struct libmlg_interval interval[MOST_INTERVALS];
  struct state here = { .u = u };
  int points, intervals;

  s->par[s->k_s] = k_s_of(s, u);
  if (libmlg_points_and_intervals(s->layout, s->par, s->zeta, s->V_least, s->V_top, point, &points, interval, &intervals) != 0) {
    s->status = LIBMLG_UNSURE;
    here.signature = 1;
    return here;
  }
  here.signature = (unsigned long)intervals;
  for (int i = 0; i < intervals; i++) {
    const double width = size(s, interval[i].lo.c_d, interval[i].hi.c_d);

    here.signature = here.signature * 64 + (unsigned long)interval[i].lo.kind * 8 + (unsigned long)interval[i].hi.kind;
    /* where two regions part the interval between them is rounding first */
    if (width > here.width && interval[i].hi.c_d > interval[i].lo.c_d * (1. + 1e-9)) {
      here.width = width;
      here.widest = interval[i];
    }
  }
  if (intervals == 0) {
    here.width = -INFINITY;
    for (int i = 0; i < points; i++)
      here.signature = here.signature * 5 + 1 + (unsigned long)point[i].kind;
    for (int i = 0; i + 1 < points; i++) /* the upper one begins before the lower ends */
      if (point[i].kind == LIBMLG_LEAST && point[i + 1].kind == LIBMLG_LARGEST) {
        here.width = fmax(here.width, size(s, point[i + 1].c_d, point[i].c_d));
        here.parting = fmax(here.parting, point[i].c_d / point[i + 1].c_d);
      }
  }
  return here;
}

static int by_u(const void *a, const void *b)
{
  const double x = ((const struct state *)a)->u, y = ((const struct state *)b)->u;

  return (x > y) - (x < y);
}

/* Between two states that differ: both sides of the places where they do, the first from the
 * left, then those between it and the right. */
static int add_changes(struct search *s, struct state left, struct state right, struct state node[], int n)
{
  while (left.signature != right.signature && n + 2 <= MOST_NODES) {
    struct state a = left, b = right;

    while (b.u - a.u > 1e-5) {
      const struct state middle = state_at(s, 0.5 * (a.u + b.u));

      if (middle.signature == left.signature)
        a = middle;
      else
        b = middle;
    }
    node[n++] = a;
    node[n++] = b;
    left = b;
  }
  return n;
}

static double width_at(double u, void *context)
{
  struct search *const s = context;
  const struct state here = state_at(s, u);

  if (here.width > s->top.width)
    s->top = here;
  return here.width;
}

/* The largest width from left to right, or `best`. */
static struct state golden(struct search *s, struct state best, double left, double right, double tolerance)
{
  double u = best.u;

  s->top = best;
  golden_largest(width_at, s, left, right, tolerance, &u, best.width);
  return s->top;
}

/* Whether a boundary point goes on as the other one a small step of u away. */
static int is_same(const struct libmlg_point *p, const struct libmlg_point *q)
{
  return p->kind == q->kind && (p->kind == LIBMLG_ENDS || (fabs(p->omega - q->omega) < 0.01 * p->omega
                                                           && fabs(p->V - q->V) < 0.01 * (p->V + q->V)));
}

static int is_bound(const struct libmlg_interval *interval, const struct libmlg_point *p)
{
  return fabs(p->c_d / interval->lo.c_d - 1.) < 1e-9 || fabs(p->c_d / interval->hi.c_d - 1.) < 1e-9;
}

/* Of a region that bounds the interval beside the best one by its end p, lies the other end
 * inside the best one too?  Then it is born there, at *at. */
static int is_newborn(struct search *s, const struct state *beside, const struct libmlg_point *p,
                      const struct libmlg_interval *best, struct libmlg_point *at)
{
  const enum libmlg_kind other = p->kind == LIBMLG_LEAST ? LIBMLG_LARGEST : LIBMLG_LEAST;
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  int n;

  s->par[s->k_s] = k_s_of(s, beside->u);
  n = libmlg_boundary_points(s->layout, s->par, s->zeta, s->V_least, s->V_top, point, LIBMLG_MOST_POINTS);
  for (int i = 0; i < n; i++)
    if (point[i].kind == other && fabs(point[i].omega / p->omega - 1.) < 3e-3 && fabs(point[i].V / p->V - 1.) < 0.05
        && fabs(point[i].c_d / p->c_d - 1.) < 0.05 && point[i].c_d >= best->lo.c_d * (1. - 1e-12)
        && point[i].c_d <= best->hi.c_d && !is_bound(&beside->widest, &point[i])) {
      *at = *p;
      at->c_d = sqrt(p->c_d * point[i].c_d);
      at->V = 0.5 * (p->V + point[i].V);
      at->omega = 0.5 * (p->omega + point[i].omega);
      return 1;
    }
  return 0;
}

/* The point of another u, a small step away, as it is at the best one. */
static struct libmlg_point same_at(struct search *s, const struct state *best, const struct libmlg_point *p)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS], same = *p;
  double nearest = INFINITY;
  int n;

  s->par[s->k_s] = k_s_of(s, best->u);
  n = libmlg_boundary_points(s->layout, s->par, s->zeta, s->V_least, s->V_top, point, LIBMLG_MOST_POINTS);
  for (int i = 0; i < n; i++)
    if (is_same(&point[i], p) && fabs(log(point[i].c_d / p->c_d)) < nearest) {
      nearest = fabs(log(point[i].c_d / p->c_d));
      same = point[i];
    }
  return same;
}

/* What limits the best state: what bounds the widest interval a little to both sides, where
 * it is another one. */
static void classify(struct search *s, const struct state *best, struct libmlg_widest *w)
{
  const double step = 1e-8;

  if (best->u <= 0. || best->u >= PLACES_SOFTEST) {
    w->limit = best->u <= 0. ? LIBMLG_RIGID : LIBMLG_SOFT;
    return;
  }
  w->limit = LIBMLG_STATIONARY;
  for (int k = 0; k < 2 && w->limit == LIBMLG_STATIONARY; k++) {
    const struct state side = state_at(s, best->u + (k ? step : -step));
    const int below = !is_same(&side.widest.lo, &best->widest.lo), above = !is_same(&side.widest.hi, &best->widest.hi);

    if (!(side.width > 0.) || (!below && !above))
      continue;
    w->third = below ? side.widest.lo : side.widest.hi;
    if (is_newborn(s, &side, &w->third, &best->widest, &w->third))
      w->limit = LIBMLG_ONSET;
    else {
      w->limit = below ? LIBMLG_EQUAL_LO : LIBMLG_EQUAL_HI;
      w->third = same_at(s, best, &w->third);
    }
  }
}

/* The maximum of a smooth width lies where its slope is 0: differences of the exact width
 * over steps in which it is a cubic to rounding. */
static struct state stationary(struct search *s, struct state best)
{
  for (int i = 0; i < 4; i++) {
    const double h = 1e-3 * fmin(best.u, 1. - best.u), h2 = 2. * h;
    const double f[4] = { state_at(s, best.u - h2).width, state_at(s, best.u - h).width,
                          state_at(s, best.u + h).width, state_at(s, best.u + h2).width };
    const double slope = (8. * (f[2] - f[1]) - (f[3] - f[0])) / (12. * h);
    const double bend = (16. * (f[2] + f[1]) - (f[3] + f[0]) - 30. * best.width) / (12. * h * h);
    const struct state next = state_at(s, best.u - slope / bend);

    if (!(bend < 0. && fabs(slope / bend) < h && next.width >= best.width * (1. - 1e-9)))
      break;
    best = next;
  }
  return best;
}

static int search_begin(struct search *s, int layout, const double par[], double zeta, double V_least, double V_top)
{
  const int n = libmlg_parameters();

  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  *s = (struct search){ .layout = layout, .k_s = libmlg_parameter("k_s"), .zeta = zeta, .V_least = V_least, .V_top = V_top };
  memcpy(s->par, par, (size_t)n * sizeof *par);
  s->k_psi = par[libmlg_parameter("k_psi")];
  return 0;
}

static int widest(int by_ratio, int layout, const double par[], double zeta, double V_least, double V_top, struct libmlg_widest *w)
{
  struct search s;
  struct state node[MOST_NODES], best;
  double u[PLACES_MOST];
  int n, nodes;

  *w = (struct libmlg_widest){ .limit = LIBMLG_NO_INTERVAL };
  if (search_begin(&s, layout, par, zeta, V_least, V_top) != 0)
    return LIBMLG_NONE;
  s.by_ratio = by_ratio;
  n = libmlg_places(layout, par, NODES, u);
  nodes = n - 1;
  for (int i = 0; i < n; i++) {
    s.status = 0;
    node[i] = state_at(&s, u[i]);
    if (s.status != 0) /* a place where two points are one is a single one */
      node[i] = state_at(&s, u[i] + (i < nodes ? 1e-6 : -1e-6) / NODES);
  }
  for (int i = 0; i < nodes; i++) /* where two regions nearly part, more closely */
    if (!(node[i].width > 0.) && !(node[i + 1].width > 0.) && fmax(node[i].parting, node[i + 1].parting) > 0.5) {
      const int parts = (int)ceil(FINER * NODES * (u[i + 1] - u[i]) - 1e-6);

      for (int k = 1; k < parts; k++)
        node[n++] = state_at(&s, u[i] + (u[i + 1] - u[i]) * k / parts);
    }
  qsort(node, (size_t)n, sizeof *node, by_u);
  for (int i = 0, first = n; i + 1 < first; i++)
    if (node[i].signature != node[i + 1].signature)
      n = add_changes(&s, node[i], node[i + 1], node, n);
  qsort(node, (size_t)n, sizeof *node, by_u);
  best = node[0];
  for (int i = 1; i < n; i++)
    if (node[i].width > best.width)
      best = node[i];
  if (best.width > DBL_MAX)
    w->limit = LIBMLG_UNBOUNDED;
  /* local maxima that may come to be the largest between their neighbours, and of these the
   * largest to rounding */
  double left = 0., right = 0.;

  for (int i = 0; i < n && nodes > 0 && !(best.width > DBL_MAX); i++) {
    const struct state *before = &node[i > 0 ? i - 1 : i], *after = &node[i + 1 < n ? i + 1 : i];
    struct state top;

    if (node[i].width < before->width || node[i].width < after->width
        || (node[i].width > 0. ? node[i].width < 0.7 * best.width : best.width > 0. || node[i].parting < 0.5))
      continue;
    top = golden(&s, node[i], before->u, after->u, 1e-5);
    if (top.width >= best.width) {
      best = top;
      left = before->u;
      right = after->u;
    }
  }
  if (right > left)
    best = golden(&s, best, fmax(left, best.u - 3e-5), fmin(right, best.u + 3e-5), 1e-13);
  w->width = fmax(0., best.width);
  w->interval = best.widest;
  w->k_s = k_s_of(&s, best.u);
  if (nodes == 0 || w->limit == LIBMLG_UNBOUNDED || !(best.width > 0.)) {
    if (nodes == 0 && best.width > 0.)
      w->limit = best.width > DBL_MAX ? LIBMLG_UNBOUNDED : LIBMLG_RIGID;
    return 0;
  }
  classify(&s, &best, w);
  if (w->limit == LIBMLG_STATIONARY) {
    best = stationary(&s, best);
    w->width = best.width;
    w->interval = best.widest;
    w->k_s = k_s_of(&s, best.u);
  }
  return 0;
}

int libmlg_widest(int layout, const double par[], double zeta, double V_least, double V_top, struct libmlg_widest *w)
{
  return widest(0, layout, par, zeta, V_least, V_top, w);
}

int libmlg_largest_ratio(int layout, const double par[], double zeta, double V_least, double V_top, struct libmlg_widest *w)
{
  const int status = widest(1, layout, par, zeta, V_least, V_top, w);

  w->width = w->interval.hi.c_d - w->interval.lo.c_d;
  return status;
}
