/* tolerant.c - the design of the largest tolerance (tolerance.c) over c_d, k_s and b
 *
 * Of the 2^n corners only a few ever fail first.  The search asks these, then all of them at
 * what it found, goes on with those that failed there too, and ends when none does: with fewer
 * corners every design bears more, so that none is missed.
 *
 * At given k_s and b and corner each c_d of an interval is free, exactly; the c_d whose
 * whole range (1 +- p) c_d lies in the intervals of all corners are an interval again.  Its
 * width falls nearly linearly as p grows, so a secant finds the p at which it ends: where the lower
 * bound at one corner meets the upper bound at another, whose slopes are that of p.  Over k_s and
 * b the largest p is a ridge with kinks, on which the best node of a grid climbs (climb.h).
 */
#include <math.h>
#include <string.h>

#include "box.h"
#include "climb.h"
#include "golden.h"
#include "places.h"
#include "watch.h"

enum { MOST_ASKED = 1024, NEW_CORNERS = 6, NODES_K_S = 64, NODES_B = 15, MOST = LIBMLG_MOST_POINTS };

/* A corner, c_d left out, and the part of p at which it is asked. */
struct asked { unsigned corner; int part; };

/* A bound of c_d at a corner, and a range of c_d between two. */
struct bound { struct asked at; struct libmlg_point point; };
struct range { double lo, hi; struct bound lower, upper; };

struct search {
  struct devices device;
  int c_d; /* number of that parameter */
  double V_least, V_top;
  struct libmlg_box box; /* with c_d as its last */
  struct asked asked[MOST_ASKED];
  int n, parts; /* parts: of p at which all corners are tested */
  struct best { double p, u, v, c_d; } best;
  struct range range; /* of c_d at the p that was found last */
  double v; /* of a climb over u alone */
};

/* The box of what is searched: c_d last, so that a corner without it is a number below
 * 2^(n-1). */
static void set_box(struct search *s)
{
  struct libmlg_box *const box = &s->box;

  libmlg_box_of(s->device.layout, s->device.par, box);
  for (int i = 0; i < box->n; i++)
    if (box->parameter[i] == s->c_d) {
      memmove(&box->parameter[i], &box->parameter[i + 1], (size_t)(box->n - i - 1) * sizeof *box->parameter);
      box->parameter[box->n - 1] = s->c_d;
    }
}

static void place(struct search *s, double u, double v)
{
  devices_put(&s->device, u, v);
  set_box(s);
}

/* --- the largest p over c_d ------------------------------------------------------------------ */

/* par[] at a corner without c_d. */
static void to_corner(const struct search *s, struct asked asked, double p, double par[])
{
  struct libmlg_box rest = s->box;

  rest.n--;
  libmlg_corner(s->device.par, &rest, asked.corner, p * box_part(asked.part), par);
}

/* What two ranges have in common; without that the gap between them, hi below lo. */
static struct range common(struct range a, struct range b)
{
  return (struct range){ a.lo > b.lo ? a.lo : b.lo, a.hi < b.hi ? a.hi : b.hi, a.lo > b.lo ? a.lower : b.lower,
                         a.hi < b.hi ? a.upper : b.upper };
}

/* log(hi/lo) of the longest range of c_d whose +-p is free at all corners asked, into s->range; below
 * 0: there is none, and by how much the first corner that leaves none misses. */
static double room(struct search *s, double p, double *c_d)
{
  struct range left[MOST] = { { .lo = 0., .hi = INFINITY } };
  int n = 1;

  for (int i = 0; i < s->n; i++) {
    const struct asked asked = s->asked[i];
    const double here = p * box_part(asked.part);
    struct libmlg_interval interval[MOST];
    double par[LIBMLG_MOST_PARAMETERS], gap = -INFINITY;
    struct range both[MOST];
    int m = 0;

    to_corner(s, asked, p, par);
    const int intervals = libmlg_intervals(s->device.layout, par, 0., s->V_least, s->V_top, interval, MOST);

    for (int k = 0; k < n * intervals; k++) {
      const struct libmlg_interval *const free = &interval[k / n];
      const struct range r = common(left[k % n], (struct range){ free->lo.c_d / (1. - here), free->hi.c_d / (1. + here),
                                                                 { asked, free->lo }, { asked, free->hi } });

      if (r.lo < r.hi && m < MOST)
        both[m++] = r;
      else
        gap = fmax(gap, log(r.hi / r.lo));
    }
    if (m == 0) { /* the next time it is asked first */
      memmove(&s->asked[1], s->asked, (size_t)i * sizeof asked);
      s->asked[0] = asked;
      return gap;
    }
    n = m;
    memcpy(left, both, (size_t)n * sizeof *both);
  }
  s->range = left[0];
  for (int i = 1; i < n; i++)
    if (left[i].hi / left[i].lo > s->range.hi / s->range.lo)
      s->range = left[i];
  const double lo = s->range.lo, hi = s->range.hi;

  *c_d = isfinite(hi) ? (lo > 0. ? sqrt(lo * hi) : 0.5 * hi) : 2. * lo;
  return log(hi / lo);
}

/* The largest p over c_d at the k_s and b of the search, at the corners asked: from lo, which there
 * is with the room at_lo, to hi and on from there. */
static double most_from(struct search *s, double lo, double at_lo, double hi, double *c_d)
{
  double at_hi, c, step = 1.;

  while ((at_hi = room(s, hi, &c)) > 0.) {
    lo = hi;
    at_lo = at_hi;
    *c_d = c;
    if (hi >= LIBMLG_MOST_TOLERANCE)
      return hi;
    step = fmin(2. * step, 16.);
    hi = fmin(hi * (1. + 0.03 * step), LIBMLG_MOST_TOLERANCE);
  }
  for (int i = 0; i < 60 && hi - lo > 1e-11 * hi; i++) {
    const double secant = lo + (hi - lo) * at_lo / (at_lo - at_hi);
    const double there_p = isfinite(at_hi) && isfinite(at_lo) && i % 3 < 2 ? fmin(fmax(secant, lo), hi) : 0.5 * (lo + hi);
    const double there = room(s, there_p, &c);

    if (there > 0.) {
      lo = there_p;
      at_lo = there;
      *c_d = c;
    } else {
      hi = there_p;
      at_hi = there;
    }
    if (there >= 0. && there < 1e-11)
      break;
  }
  return lo;
}

/* That p, if it is above `floor`, else 0. */
static double most_above(struct search *s, double floor, double *c_d)
{
  const double at_floor = room(s, floor, c_d);

  return at_floor > 0. ? most_from(s, floor, at_floor, fmax(1.1 * floor, 1e-3), c_d) : 0.;
}

/* That p, from one nearby: 0 where there is none. */
static double most_near(struct search *s, double p, double *c_d)
{
  double lo = p, at_lo;

  while (!((at_lo = room(s, lo, c_d)) > 0.))
    if ((lo *= lo > 0.9 * p ? 0.98 : 0.5) < 1e-5)
      return 0.;
  return most_from(s, lo, at_lo, lo < p ? lo / 0.98 : 1.005 * lo, c_d);
}

/* --- corners ------------------------------------------------------------------------------- */

static void ask(struct search *s, unsigned corner, int part)
{
  const unsigned rest = corner & ((1u << (s->box.n - 1)) - 1u);

  for (int i = 0; i < s->n; i++)
    if (s->asked[i].corner == rest && s->asked[i].part == part)
      return;
  if (s->n < MOST_ASKED)
    s->asked[s->n++] = (struct asked){ rest, part };
}

/* The corners that the widest interval at this b leads to first, and the design itself; 0:
 * there is no interval. */
static int ask_predicted(struct search *s, double v)
{
  double *const par = s->device.par;
  const struct box_at d = { .layout = s->device.layout, .par = par, .box = &s->box, .V_least = s->V_least, .V_top = s->V_top };
  struct libmlg_widest w;
  unsigned first[2];
  int n;

  place(s, 0.5, v);
  if (libmlg_widest(s->device.layout, par, 0., s->V_least, s->V_top, &w) != 0 || !(w.width > 0.))
    return 0;
  if (s->device.over_k_s)
    par[s->device.k_s] = w.k_s;
  set_box(s);
  par[s->c_d] = isfinite(w.interval.hi.c_d) ? 0.5 * (w.interval.lo.c_d + w.interval.hi.c_d) : 2. * w.interval.lo.c_d;
  n = box_first_corners(&d, first);
  for (int i = 0; i < n; i++)
    ask(s, first[i], 0);
  ask(s, 0, BOX_PARTS);
  return 1;
}

/* Tests all corners at a design and a hair less than p, and at the parts of p below; the few
 * that fail earliest are asked from now on.  Returns how many are new. */
static int ask_failing(struct search *s, const struct best *best)
{
  double par[LIBMLG_MOST_PARAMETERS], p = best->p * (1. - 1e-8);
  const int before = s->n;

  place(s, best->u, best->v);
  memcpy(par, s->device.par, sizeof par);
  par[s->c_d] = best->c_d;
  const struct box_at d = { .layout = s->device.layout, .par = par, .box = &s->box, .V_least = s->V_least, .V_top = s->V_top };

  for (int part = 0; part < s->parts && s->n == before; part++) {
    unsigned last[NEW_CORNERS]; /* of those that fail earlier than all before them */
    int failing = 0;

    watch_tell("tolerance, all corners, part of p", part, s->parts);
    for (unsigned corner = 0; corner < 1u << s->box.n; corner++)
      if (!box_is_free(&d, corner, p * box_part(part))) {
        p = box_begins(&d, corner, p * box_part(part)) / box_part(part) * (1. - 1e-8);
        last[failing++ % NEW_CORNERS] = corner;
      }
    for (int i = 0; i < failing && i < NEW_CORNERS; i++)
      ask(s, last[i], part);
  }
  return s->n - before;
}

/* --- over k_s and b -------------------------------------------------------------------------- */

static void take(struct search *s, struct best here)
{
  if (here.p > s->best.p)
    s->best = here;
}

/* d(log c_d of a bound less the part of p that c_d may be off)/d(parameter) and, of p itself, of all that
 * vary; `side` 1 of a lower, -1 of an upper bound. */
static double bound_slope(struct search *s, const struct bound *bound, double side, double p, int parameter)
{
  const double part = box_part(bound->at.part);
  double par[LIBMLG_MOST_PARAMETERS], sum = 0., slope;

  if (bound->point.kind == LIBMLG_ENDS)
    return NAN;
  to_corner(s, bound->at, p, par);
  for (int i = 0; i < s->box.n - 1; i++) {
    const int k = s->box.parameter[i];
    const double sign = bound->at.corner >> i & 1u ? part : -part;

    if (parameter >= 0 && k != parameter)
      continue;
    if (libmlg_point_slope(s->device.layout, par, 0., &bound->point, k, &slope) != 0)
      return NAN;
    sum += slope / bound->point.c_d * (parameter >= 0 ? 1. + sign * p : sign * libmlg_value(s->device.par, k));
  }
  return parameter >= 0 ? sum : sum + side * part / (1. - side * part * p);
}

/* dp/d(parameter) where the two bounds meet. */
static double slope_of_p(struct search *s, double p, int parameter)
{
  const struct bound lo = s->range.lower, hi = s->range.upper;

  return -(bound_slope(s, &lo, 1., p, parameter) - bound_slope(s, &hi, -1., p, parameter))
         / (bound_slope(s, &lo, 1., p, -1) - bound_slope(s, &hi, -1., p, -1));
}

/* Places of the climb: u and, with v = NAN, v. */
static int climb_at(const double x[], struct climb_piece *piece, void *context)
{
  double *const slope = piece->slope;
  struct search *const s = context;
  const struct devices *const d = &s->device;
  struct best here = { .u = fmin(fmax(x[0], 1e-6), PLACES_SOFTEST), .v = isnan(s->v) ? x[1] : s->v };

  place(s, here.u, here.v);
  here.p = most_near(s, s->best.p, &here.c_d);
  if (!(here.p > 0.))
    return 0;
  slope[0] = slope_of_p(s, here.p, d->k_s) * -d->k_psi / (here.u * here.u);
  if (isnan(s->v))
    slope[1] = slope_of_p(s, here.p, d->b) * (d->b_most - d->b_least);
  take(s, here);
  piece->value = here.p;
  return 1;
}

/* From the best design. */
static double climb(struct search *s, double v, double radius, int most)
{
  double x[2] = { s->best.u, s->best.v }, p = s->best.p;

  s->v = v;
  if (s->device.over_k_s)
    climb_largest(climb_at, s, isnan(v) ? 2 : 1, x, radius, most, INFINITY, &p);
  return p;
}

/* The largest p at one b, from the best design. */
static double at_v(double v, void *context)
{
  return climb(context, v, 2e-3, 40);
}

static struct best value_at(struct search *s, double u, double v, double floor)
{
  struct best here = { .u = u, .v = v };

  place(s, u, v);
  here.p = most_above(s, floor, &here.c_d);
  return here;
}

static double at_u(double u, void *context)
{
  struct search *const s = context;
  const struct best here = value_at(s, u, s->best.v, 0.9 * s->best.p);

  take(s, here);
  return here.p;
}

/* About the best design: along b, where the ridge may be nearly flat and a climb over both end before
 * its top, or over k_s alone. */
static void golden(struct search *s)
{
  const double half_v = 1. / NODES_B, half_u = 0.1 / NODES_K_S;
  double u = s->best.u, v = s->best.v;

  if (s->device.over_b)
    golden_largest(at_v, s, fmax(0., v - half_v), fmin(1., v + half_v), 2e-3 * half_v, &v, s->best.p);
  else if (s->device.over_k_s)
    golden_largest(at_u, s, fmax(1e-6, u - half_u), fmin(PLACES_SOFTEST, u + half_u), 1e-5 * half_u, &u, s->best.p);
}

static void over_the_grid(struct search *s)
{
  const struct devices *const d = &s->device;

  s->best.p = 0.;
  for (int j = 0; j <= (d->over_b ? NODES_B : 0); j++) {
    double u[PLACES_MOST];

    devices_put(&s->device, 0.5, (double)j / NODES_B);
    const int nodes = libmlg_places(d->layout, d->par, NODES_K_S, u);

    watch_tell("tolerance, grid over b", j, d->over_b ? NODES_B + 1 : 1);
    for (int i = nodes > 1; i < nodes; i++) /* a rigid k_s has no tolerance */
      take(s, value_at(s, u[i], (double)j / NODES_B, s->best.p));
  }
}

static int search_begin(struct search *s, int layout, const double par[], double b_least, double b_most, double V_least,
                        double V_top)
{
  *s = (struct search){ .c_d = libmlg_parameter("c_d"), .V_least = V_least, .V_top = V_top, .parts = 1 };
  return devices_begin(&s->device, layout, par, b_least, b_most);
}

/* After each all corners are tested at the best design; where one fails that was not asked before,
 * again from the grid: another place may be the best now. */
enum stage { GRID, CLIMB, GOLDEN, PARTS, FOUND };

int libmlg_most_tolerant(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                         struct libmlg_design *design)
{
  struct search s;

  if (search_begin(&s, layout, par, b_least, b_most, V_least, V_top) != 0)
    return LIBMLG_NONE;
  design->p = 0.;
  for (int j = 0; j <= (s.device.over_b ? NODES_B : 0) && s.n == 0; j++)
    ask_predicted(&s, (double)j / NODES_B);
  if (s.n == 0)
    return 0;
  for (enum stage stage = GRID; stage < FOUND;) {
    switch (stage) {
    case GRID: over_the_grid(&s); break;
    case CLIMB: climb(&s, s.device.over_b ? NAN : 0., 0.25 / NODES_B, 100); break;
    case GOLDEN: golden(&s); break;
    default: s.parts = BOX_PARTS;
    }
    if (!(s.best.p > 0.))
      return 0;
    stage = ask_failing(&s, &s.best) > 0 ? GRID : stage + 1;
  }
  place(&s, s.best.u, s.best.v);
  *design = (struct libmlg_design){ .k_s = s.device.over_k_s ? s.device.par[s.device.k_s] : MLG_RIGID,
                                    .b = s.device.par[s.device.b], .c_d = s.best.c_d, .p = s.best.p };
  return 0;
}

/* --- a map ------------------------------------------------------------------------------------ */

int libmlg_tolerance_map(int layout, const double par[], struct libmlg_design node[], int n, double V_least, double V_top)
{
  struct search s;

  for (int i = 0; i < n; i++) {
    const double b = node[i].b;

    watch_tell("tolerance, node", i, n);
    if (i == 0 ? search_begin(&s, layout, par, b, b, V_least, V_top) != 0 : 0)
      return LIBMLG_NONE;
    s.device.par[s.device.b] = b;
    s.best = (struct best){ .u = 1. / (1. + node[i].k_s / s.device.k_psi) };
    if (s.n > 0 || ask_predicted(&s, 0.))
      do
        s.best = value_at(&s, s.best.u, 0., 0.);
      while (s.best.p > 0. && ask_failing(&s, &s.best) > 0);
    node[i].p = s.best.p;
    node[i].c_d = s.best.p > 0. ? s.best.c_d : 0.;
  }
  return 0;
}
