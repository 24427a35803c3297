/* boundary_points.c - Hopf points, boundary points and intervals of libmlg.h
 *
 * The points themselves come from crossing_extrema.c, the eigenvalue problem, and
 * crossing_roots.c.
 * Between neighbouring values of c_d among all boundary points nothing changes: the
 * Hopf curves neither turn nor leave the range of V.  So one look inside each decides
 * it, and the number of crossings there must fit to what lies between: each extremum
 * adds or takes two, each edge one.  Where it does not fit a point was missed, and that
 * is said instead of an answer.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossing.h"
#include "linearised.h"

enum { MOST = LIBMLG_MOST_POINTS };

/* A boundary point with what it does to the number of crossings as c rises. */
struct event { struct crossing_at at; enum libmlg_kind kind; int jump; };

struct events { struct event event[MOST]; int n; };

static int by_c(const void *a, const void *b)
{
  const struct event *x = a, *y = b;
  const int order = (x->at.c > y->at.c) - (x->at.c < y->at.c);

  return order ? order : y->jump - x->jump; /* of two at one c the birth first */
}

static void add_edges(struct events *e, const struct crossing *x, double V, enum libmlg_kind kind)
{
  struct crossing_at at[CROSSING_TERMS];
  const int n = crossings_at_V(x, V, at);

  for (int i = 0; i < n && e->n < MOST; i++) {
    const double slope = crossing_slope(x, &at[i]); /* dV/dc: into the range or out of it */

    e->event[e->n++] = (struct event){ at[i], kind, (slope > 0.) == (kind == LIBMLG_BOTTOM) ? 1 : -1 };
  }
}

/* A c between event i and the next; -1 is below the first. */
static double between(const struct events *e, int i)
{
  if (e->n == 0)
    return 1.;
  if (i < 0)
    return 0.5 * e->event[0].at.c;
  if (i + 1 == e->n)
    return 2. * e->event[i].at.c;
  return sqrt(e->event[i].at.c * e->event[i + 1].at.c);
}

static void add_extremum(struct events *e, const struct crossing *x, const struct crossing_at *at)
{
  const int least = crossing_curvature(x, at) > 0.;

  e->event[e->n++] = (struct event){ *at, least ? LIBMLG_LEAST : LIBMLG_LARGEST, least ? 2 : -2 };
}

/* The one of n crossings that is about to leave the range of V, and where; LIBMLG_HOPF:
 * none is. */
static enum libmlg_kind leaving(const struct crossing_at at[], int n, double V_least, double V_top, struct crossing_at *which)
{
  double nearest = 1e-6 * (V_top - V_least);
  enum libmlg_kind kind = LIBMLG_HOPF;

  for (int i = 0; i < n; i++) {
    const double up = V_top - at[i].V, down = at[i].V - V_least;

    if (fmin(up, down) < nearest) {
      nearest = fmin(up, down);
      kind = up < down ? LIBMLG_TOP : LIBMLG_BOTTOM;
      *which = at[i];
    }
  }
  return kind;
}

/* The middle of the two of n crossings that are nearest to each other. */
static int meeting(const struct crossing_at at[], int n, struct crossing_at *middle)
{
  double gap = 0.01;

  for (int i = 0; i < n; i++)
    for (int k = 0; k < i; k++)
      if (fabs(at[i].t / at[k].t - 1.) < gap) {
        gap = fabs(at[i].t / at[k].t - 1.);
        *middle = (struct crossing_at){ 0.5 * (at[i].t + at[k].t), 0.5 * (at[i].V + at[k].V), at[i].c };
      }
  return gap < 0.01;
}

/* Where the number of crossings differs at two c and nothing known lies between, one
 * leaves the range of V or two meet; that is followed by bisection.  Beside an inerter's
 * antiresonance, at a c_d of nearly 0, the eigenvalue problem can lose it to rounding. */
static int add_between(struct events *e, const struct crossing *x, double V_least, double V_top, double c_lo, double c_hi)
{
  struct crossing_at lo[CROSSING_TERMS], hi[CROSSING_TERMS], middle[CROSSING_TERMS], at;
  int n_lo = crossings_at_c(x, c_lo, V_least, V_top, lo), n_hi = crossings_at_c(x, c_hi, V_least, V_top, hi);

  if (n_lo == n_hi || e->n == MOST)
    return 0;
  while (c_hi > c_lo * (1. + (abs(n_lo - n_hi) == 1 ? 1e-14 : 1e-7))) {
    const double c = sqrt(c_lo * c_hi);
    const int n = crossings_at_c(x, c, V_least, V_top, middle);

    if (!(c > c_lo && c < c_hi))
      break;
    if (n == n_lo) {
      c_lo = c;
      memcpy(lo, middle, sizeof lo);
    } else {
      c_hi = c;
      n_hi = n;
      memcpy(hi, middle, sizeof hi);
    }
  }
  if (abs(n_lo - n_hi) == 1) {
    const enum libmlg_kind kind = leaving(n_lo > n_hi ? lo : hi, n_lo > n_hi ? n_lo : n_hi, V_least, V_top, &at);

    if (kind == LIBMLG_HOPF)
      return 0;
    e->event[e->n++] = (struct event){ at, kind, n_hi - n_lo };
    return 1;
  }
  if (!meeting(n_lo > n_hi ? lo : hi, n_lo > n_hi ? n_lo : n_hi, &at) || !crossing_extremum_near(x, &at))
    return 0;
  for (int i = 0; i < e->n; i++)
    if (crossing_same(x, &e->event[i].at, &at))
      return 0;
  add_extremum(e, x, &at);
  return 1;
}

/* Below this c, in the units of struct crossing, c has few digits. */
static const double nearly_no_damper = 1e-6;

/* The event of a cluster that makes this change, or -1. */
static int making(const struct events *e, int first, int last, int change)
{
  for (int i = first; i <= last; i++)
    if (e->event[i].jump == change)
      return i;
  for (int i = first; i <= last; i++)
    if (e->event[i].jump == -change)
      return i;
  return -1;
}

static int is_near(const struct crossing_at *p, const struct crossing_at *q)
{
  const double dc = fabs(p->c / q->c - 1.), dt = fabs(p->t / q->t - 1.);

  return (dc < 1e-5 && dt < 1e-3) || (dc < 1e-3 && dt < 1e-6);
}

/* Events that lie within rounding of each other, where a region is just born, two meet or
 * a curve touches the edge, cannot be told apart nor named: of those around event i only
 * what they do together remains, as one of them or none.  1: there were some. */
static int merge_cluster(struct events *e, const struct crossing *x, double V_least, double V_top, int i)
{
  struct crossing_at there[CROSSING_TERMS];
  struct event whole;
  int first = i, last = i, change, maker;

  while (first > 0 && is_near(&e->event[first - 1].at, &e->event[first].at))
    first--;
  while (last + 1 < e->n && is_near(&e->event[last + 1].at, &e->event[last].at))
    last++;
  change = crossings_at_c(x, between(e, last), V_least, V_top, there);
  change -= crossings_at_c(x, between(e, first - 1), V_least, V_top, there);
  maker = change ? making(e, first, last, change) : -1;
  if ((change != 0 && maker < 0)
      || (first == last && (change != 0 || (abs(e->event[i].jump) != 2 && e->event[i].at.c > nearly_no_damper))))
    return 0;
  if (change != 0) {
    whole = e->event[maker];
    if (whole.jump != change && abs(change) == 2)
      whole.kind = change > 0 ? LIBMLG_LEAST : LIBMLG_LARGEST;
    whole.jump = change;
    e->event[first++] = whole;
  }
  memmove(&e->event[first], &e->event[last + 1], (size_t)(e->n - last - 1) * sizeof *e->event);
  e->n -= last + 1 - first;
  return 1;
}

/* Whether an event of another curve is so near to event i that a region just born there, of
 * which one end was found alone, makes the counts beside i wrong and not i itself. */
static int is_crowded(const struct events *e, int i)
{
  for (int k = i - 1; k <= i + 1; k += 2)
    if (k >= 0 && k < e->n && fabs(e->event[k].at.c / e->event[i].at.c - 1.) < 1e-4
        && fabs(e->event[k].at.t / e->event[i].at.t - 1.) > 1e-3)
      return 1;
  return 0;
}

/* All events by rising c, and crossing[i + 1], the number of crossings above event i.
 * 0, or LIBMLG_UNSURE. */
static int find_events(const struct crossing *x, double V_least, double V_top, struct events *e, int crossing[MOST + 1])
{
  const double narrow = 1e-5;
  struct crossing_at at[MOST];
  const int extrema = crossing_extrema(x, V_least, V_top, at, MOST - 2 * CROSSING_TERMS);
  int misfit, found, rounds = 0;

  e->n = 0;
  if (extrema < 0)
    return LIBMLG_UNSURE;
  for (int i = 0; i < extrema; i++)
    add_extremum(e, x, &at[i]);
  add_edges(e, x, V_least, LIBMLG_BOTTOM);
  add_edges(e, x, V_top, LIBMLG_TOP);
  qsort(e->event, (size_t)e->n, sizeof *e->event, by_c);
  for (int i = 0; i + 2 < e->n; i++) /* a least and a largest c may be that near, no third */
    if (is_near(&e->event[i].at, &e->event[i + 1].at) && is_near(&e->event[i + 1].at, &e->event[i + 2].at))
      merge_cluster(e, x, V_least, V_top, i);
  do {
    qsort(e->event, (size_t)e->n, sizeof *e->event, by_c);
    misfit = -1;
    for (int i = -1; i < e->n; i++) {
      struct crossing_at there[CROSSING_TERMS];

      /* two crossings in so narrow a gap cannot be told from none */
      if (i >= 0 && i + 1 < e->n && e->event[i + 1].at.c < e->event[i].at.c * (1. + narrow))
        crossing[i + 1] = crossing[i] + e->event[i].jump;
      else
        crossing[i + 1] = crossings_at_c(x, between(e, i), V_least, V_top, there);
      if (i >= 0 && misfit < 0 && crossing[i + 1] - crossing[i] != e->event[i].jump)
        misfit = i;
    }
    found = 0;
    for (double beside = 1e-6; misfit >= 0 && !found && beside < 0.1; beside *= 100.)
      found = add_between(e, x, V_least, V_top, between(e, misfit - 1), e->event[misfit].at.c * (1. - beside))
              || add_between(e, x, V_least, V_top, e->event[misfit].at.c * (1. + beside), between(e, misfit));
    if (misfit >= 0 && !found && !is_crowded(e, misfit))
      found = merge_cluster(e, x, V_least, V_top, misfit);
  } while (found && ++rounds < MOST);
  return misfit < 0 ? 0 : LIBMLG_UNSURE;
}

/* What a call works on. */
struct problem { const struct libmlg_layout *layout; double par[MLG_SLOTS]; struct crossing x; };

static int problem(struct problem *p, int layout, const double par[], double zeta)
{
  p->layout = libmlg_find(layout);
  if (!p->layout)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, p->par);
  p->x = crossing_of(p->layout, p->par, zeta);
  return 0;
}

static struct libmlg_point point_of(const struct problem *p, const struct crossing_at *at, enum libmlg_kind kind)
{
  const double V = at->V * p->x.V_unit, omega = crossing_omega(&p->x, at->t);

  return (struct libmlg_point){ at->c * p->x.c_unit, V, omega,
                                delta_over_psi(p->par, V, omega * mlg_ray(p->x.zeta)), kind };
}

static int hand_over(const struct problem *p, struct crossing_at at[], int n, struct libmlg_point point[], int most,
                     void sort(struct crossing_at[], int))
{
  sort(at, n);
  for (int i = 0; i < n && i < most; i++)
    point[i] = point_of(p, &at[i], LIBMLG_HOPF);
  return n;
}

/* A range of speeds to look at. */
static int is_range(double V_least, double V_top)
{
  return V_least >= 0. && V_top > V_least && isfinite(V_top);
}

int libmlg_hopf_at_c_d(int layout, const double par[], double zeta, double V_least, double V_top,
                       struct libmlg_point point[], int most)
{
  struct problem p;
  struct crossing_at at[CROSSING_TERMS];

  if (!is_range(V_least, V_top) || problem(&p, layout, par, zeta) != 0)
    return LIBMLG_NONE;
  return hand_over(&p, at, crossings_at_c(&p.x, p.par[PAR_C_D] / p.x.c_unit, V_least / p.x.V_unit, V_top / p.x.V_unit, at),
                   point, most, crossings_by_V);
}

int libmlg_hopf_at_V(int layout, const double par[], double zeta, struct libmlg_point point[], int most)
{
  struct problem p;
  struct crossing_at at[CROSSING_TERMS];

  if (problem(&p, layout, par, zeta) != 0)
    return LIBMLG_NONE;
  return hand_over(&p, at, crossings_at_V(&p.x, p.par[PAR_V] / p.x.V_unit, at), point, most, crossings_by_c);
}

/* Both at once, for what they share; *points and *intervals may be LIBMLG_UNSURE. */
static void points_and_intervals(const struct problem *p, double V_least, double V_top, struct libmlg_point point[],
                                 int most_points, int *points, struct libmlg_interval interval[], int most_intervals,
                                 int *intervals)
{
  const struct libmlg_point zero = { .c_d = 0., .kind = LIBMLG_ENDS }, infinite = { .c_d = INFINITY, .kind = LIBMLG_ENDS };
  struct events e;
  int crossing[MOST + 1], n = 0;

  V_least /= p->x.V_unit;
  V_top /= p->x.V_unit;
  *points = *intervals = find_events(&p->x, V_least, V_top, &e, crossing);
  if (*points != 0)
    return;
  for (int i = 0; i < e.n && i < most_points; i++)
    point[i] = point_of(p, &e.event[i].at, e.event[i].kind);
  for (int i = -1; i < e.n && most_intervals > 0; i++)
    if (crossing[i + 1] == 0 && crossing_ratio(&p->x, 0.5 * (V_least + V_top), between(&e, i)) > p->x.zeta) {
      if (n < most_intervals)
        interval[n] = (struct libmlg_interval){
          i < 0 ? zero : point_of(p, &e.event[i].at, e.event[i].kind),
          i + 1 == e.n ? infinite : point_of(p, &e.event[i + 1].at, e.event[i + 1].kind),
        };
      n++;
    }
  *points = e.n;
  *intervals = n;
}

int libmlg_boundary_points(int layout, const double par[], double zeta, double V_least, double V_top,
                           struct libmlg_point point[], int most)
{
  struct problem p;
  int points, intervals;

  if (!is_range(V_least, V_top) || problem(&p, layout, par, zeta) != 0)
    return LIBMLG_NONE;
  points_and_intervals(&p, V_least, V_top, point, most, &points, NULL, 0, &intervals);
  return points;
}

int libmlg_intervals(int layout, const double par[], double zeta, double V_least, double V_top,
                     struct libmlg_interval interval[], int most)
{
  struct problem p;
  int points, intervals;

  if (!is_range(V_least, V_top) || problem(&p, layout, par, zeta) != 0)
    return LIBMLG_NONE;
  points_and_intervals(&p, V_least, V_top, NULL, 0, &points, interval, most > 0 ? most : 1, &intervals);
  return intervals;
}

int libmlg_points_and_intervals(int layout, const double par[], double zeta, double V_least, double V_top,
                                struct libmlg_point point[], int *points, struct libmlg_interval interval[], int *intervals)
{
  struct problem p;
  int status = is_range(V_least, V_top) ? problem(&p, layout, par, zeta) : LIBMLG_NONE;

  *points = *intervals = 0;
  if (status != 0)
    return status;
  points_and_intervals(&p, V_least, V_top, point, MOST, points, interval, MOST, intervals);
  status = *points < 0 ? *points : 0;
  if (status != 0)
    *points = *intervals = 0;
  return status;
}

double libmlg_damping_ratio(int layout, const double par[])
{
  struct problem p;

  if (problem(&p, layout, par, 0.) != 0)
    return NAN;
  return crossing_ratio(&p.x, p.par[PAR_V] / p.x.V_unit, p.par[PAR_C_D] / p.x.c_unit);
}

int libmlg_diverges(int layout, const double par[])
{
  struct problem p;

  if (problem(&p, layout, par, 0.) != 0)
    return LIBMLG_NONE;
  /* the sign of F(0)/V beside that of the leading term, at any c_d: it may take part in both */
  return (p.x.F[1][0][0] + p.x.F[1][1][0]) * (p.x.F[0][0][p.x.order] + p.x.F[0][1][p.x.order]) < 0.;
}
