/* best_damped.c - the device whose least damping ratio is largest, at one load or over several
 *
 * First a grid over k_s and b: a node counts when some c_d of it is above the best ratio so far.
 * Most nodes are refused by one or two speeds at which none is: the c_d that are damped enough at
 * one speed are a few stretches between roots of one polynomial, and a c_d that is left over
 * either shows the next such speed or is better.  Then the best of them climbs (climb.h), by the
 * slopes of the modes that are least damped on the way, and gets its best c_d.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "best_damped.h"
#include "best_ratio.h"
#include "climb.h"
#include "golden.h"
#include "linearised.h"
#include "places.h"
#include "watch.h"

enum { NODES_K_S = 64, NODES_B = 32, MOST_LOADS = 7, WITNESSES = 12, MOST = 2 * CROSSING_TERMS, ROUNDS = 16, RAISES = 6 };

/* So near to rigid a climb goes: the slope along k_s has no number there. */
static const double least_u = 1e-9;

struct range { double lo, hi; }; /* of c_d, N m s/rad */

/* A speed of one load at which c_d were refused, m/s. */
struct witness { int load; double V; };

struct search {
  struct devices device;
  double V_least, V_top, load[MOST_LOADS];
  int loads; /* 0: the one of par[] */
  struct witness witness[WITNESSES]; /* the last one that refused a node first */
  int witnesses;
  struct libmlg_ratio best;
  double u, v; /* its place */
  double guess[MOST_LOADS]; /* the speeds of the last least ratios, m/s */
  /* of a climb: whether it goes over k_s and b; where these are held, the c_d in the middle of its range, and where
   * it ended */
  int over_u, over_v;
  double held_u, held_v, c_scale, climbed_u;
  int roughly; /* golden section along b alone */
  int status;
};

/* par[] at one of the loads. */
static void at_load(const struct search *s, int load, double par[])
{
  memcpy(par, s->device.par, sizeof s->device.par);
  if (s->loads > 0)
    libmlg_set(par, LIBMLG_F_Z, s->load[load]);
}

static int loads(const struct search *s)
{
  return s->loads > 0 ? s->loads : 1;
}

/* --- is some c_d better? --------------------------------------------------------------------------- */

static double inside(struct range r)
{
  if (!(r.lo > 0.))
    return isfinite(r.hi) ? 0.5 * r.hi : 1e4;
  return isfinite(r.hi) ? sqrt(r.lo * r.hi) : 2. * r.lo;
}

static int add_common(struct range both[], int n, struct range a, struct range b)
{
  const struct range r = { fmax(a.lo, b.lo), fmin(a.hi, b.hi) };

  if (r.lo < r.hi && n < MOST)
    both[n++] = r;
  return n;
}

/* What is left of the c_d in left[] that have the ratio of x at V as well. */
static int refuse(const struct crossing *x, double V, struct range left[], int n)
{
  struct crossing_at at[CROSSING_TERMS];
  struct range both[MOST];
  const int crossings = crossings_at_V(x, V / x->V_unit, at);
  int m = 0;

  crossings_by_c(at, crossings);
  for (int i = 0; i <= crossings; i++) {
    const struct range here = { i > 0 ? at[i - 1].c * x->c_unit : 0., i < crossings ? at[i].c * x->c_unit : INFINITY };
    int common = 0;

    for (int k = 0; k < n; k++)
      common |= here.lo < left[k].hi && left[k].lo < here.hi;
    if (!common || !(crossing_ratio(x, V / x->V_unit, inside(here) / x->c_unit) > x->zeta))
      continue;
    for (int k = 0; k < n; k++)
      m = add_common(both, m, left[k], here);
  }
  memcpy(left, both, (size_t)m * sizeof *both);
  return m;
}

/* Whether c_d has the ratio of x at all speeds; if not *V is one where it has not. */
static int is_above(const struct search *s, const struct crossing *x, double c_d, double *V)
{
  const double c = c_d / x->c_unit, V_least = s->V_least / x->V_unit, V_top = s->V_top / x->V_unit;
  struct crossing_at at[CROSSING_TERMS];
  const int crossings = crossings_at_c(x, c, V_least, V_top, at);
  double least = INFINITY;

  crossings_by_V(at, crossings);
  for (int i = 0; i <= crossings; i++) {
    const double here = 0.5 * ((i > 0 ? at[i - 1].V : V_least) + (i < crossings ? at[i].V : V_top));
    const double zeta = crossing_ratio(x, here, c);

    if (zeta < least) {
      least = zeta;
      *V = here * x->V_unit;
    }
  }
  return least > x->zeta;
}

/* The c_d common to left[] and the intervals of the ratio zeta at one load. */
static int exactly(struct search *s, int load, double zeta, struct range left[], int n)
{
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
  struct range both[MOST];
  double par[LIBMLG_MOST_PARAMETERS];
  int m = 0;

  at_load(s, load, par);
  const int intervals = libmlg_intervals(s->device.layout, par, zeta, s->V_least, s->V_top, interval, LIBMLG_MOST_POINTS);

  if (intervals < 0)
    s->status = intervals;
  for (int i = 0; i < n; i++)
    for (int k = 0; k < intervals; k++)
      m = add_common(both, m, left[i], (struct range){ interval[k].lo.c_d, interval[k].hi.c_d });
  memcpy(left, both, (size_t)m * sizeof *both);
  return m;
}

static void note(struct search *s, int i, struct witness w)
{
  if (i == s->witnesses && i < WITNESSES)
    s->witnesses++;
  i = i < WITNESSES ? i : WITNESSES - 1;
  memmove(&s->witness[1], s->witness, (size_t)i * sizeof w);
  s->witness[0] = w;
}

static struct range longest(const struct range left[], int n)
{
  struct range best = left[0];

  for (int i = 1; i < n; i++)
    if (left[i].hi / left[i].lo > best.hi / best.lo)
      best = left[i];
  return best;
}

/* Whether some c_d has a larger ratio than zeta at all loads, and one that has. */
static int has(struct search *s, const struct crossing x[], double zeta, double *c_d)
{
  struct crossing y[MOST_LOADS];
  struct range left[MOST] = { { 0., INFINITY } };
  int n = 1;

  for (int load = 0; load < loads(s); load++)
    y[load] = crossing_on(&x[load], zeta);
  for (int i = 0; i < s->witnesses; i++) {
    const struct witness w = s->witness[i];

    n = refuse(&y[w.load], w.V, left, n);
    if (n == 0) {
      note(s, i, w);
      return 0;
    }
  }
  for (int round = 0; round < ROUNDS; round++) {
    struct witness w = { 0, 0. };

    *c_d = inside(longest(left, n));
    while (w.load < loads(s) && is_above(s, &y[w.load], *c_d, &w.V))
      w.load++;
    if (w.load == loads(s))
      return 1;
    n = refuse(&y[w.load], w.V, left, n);
    note(s, s->witnesses, w);
    if (n == 0)
      return 0;
  }
  for (int load = 0; load < loads(s) && n > 0; load++)
    n = exactly(s, load, zeta, left, n);
  if (n > 0)
    *c_d = inside(longest(left, n));
  return n > 0;
}

/* The least ratio over the loads at the c_d of the device; `which` the load. */
static int least_over(struct search *s, double c_d, struct libmlg_ratio *least, int *which)
{
  least->zeta = INFINITY;
  for (int load = 0; load < loads(s); load++) {
    double par[LIBMLG_MOST_PARAMETERS];
    struct libmlg_ratio here;

    at_load(s, load, par);
    par[libmlg_parameter("c_d")] = c_d;
    const int status = libmlg_least_ratio_from(s->device.layout, par, s->V_least, s->V_top, s->guess[load], &here);

    if (status != 0)
      return status;
    s->guess[load] = here.V;
    if (here.zeta < least->zeta) {
      *least = here;
      *which = load;
    }
  }
  return 0;
}

static void take(struct search *s, const struct libmlg_ratio *here, double u, double v)
{
  if (!(here->zeta > s->best.zeta))
    return;
  s->best = *here;
  s->u = u;
  s->v = v;
}

/* A node: above the best so far, that rises by a few steps to what is nearly the node's own best. */
static void try_node(struct search *s, double u, double v)
{
  struct crossing x[MOST_LOADS];
  double c_d;

  devices_put(&s->device, u, v);
  for (int load = 0; load < loads(s); load++) {
    double par[LIBMLG_MOST_PARAMETERS], slots[MLG_SLOTS];

    at_load(s, load, par);
    libmlg_slots_at_rest(par, slots);
    x[load] = crossing_of(libmlg_find(s->device.layout), slots, 0.);
  }
  for (int raise = 0; raise < RAISES && has(s, x, s->best.zeta + 1e-9 * (1e-3 + fabs(s->best.zeta)), &c_d); raise++) {
    struct libmlg_ratio here;
    int load;

    if (least_over(s, c_d, &here, &load) != 0 || !(here.zeta > s->best.zeta))
      return;
    take(s, &here, u, v);
  }
}

/* --- the climb --------------------------------------------------------------------------------------- */

/* Places of the climb: u and v as far as they are searched, and w = c_d/(c_d + c_scale). */
static int climb_at(const double x[], struct climb_piece *piece, void *context)
{
  double *const slope = piece->slope;
  struct search *const s = context;
  struct devices *const d = &s->device;
  double par[LIBMLG_MOST_PARAMETERS];
  struct libmlg_ratio here;
  int load, n = 0;

  const double u = s->over_u ? fmax(x[n++], least_u) : s->held_u, v = s->over_v ? x[n++] : s->held_v, w = x[n];
  const double c_d = s->c_scale * w / (1. - w);

  devices_put(d, u, v);
  if (!(c_d > 0.) || !isfinite(c_d) || u > PLACES_SOFTEST || least_over(s, c_d, &here, &load) != 0)
    return 0;
  at_load(s, load, par);
  par[libmlg_parameter("c_d")] = c_d;
  n = 0;
  if (s->over_u) {
    slope[n] = NAN;
    libmlg_ratio_slope(d->layout, par, &here, d->k_s, &slope[n]);
    slope[n++] *= -d->k_psi / (u * u);
  }
  if (s->over_v) {
    slope[n] = NAN;
    libmlg_ratio_slope(d->layout, par, &here, d->b, &slope[n]);
    slope[n++] *= d->b_most - d->b_least;
  }
  slope[n] = NAN;
  libmlg_ratio_slope(d->layout, par, &here, libmlg_parameter("c_d"), &slope[n]);
  slope[n] *= s->c_scale / ((1. - w) * (1. - w));
  take(s, &here, u, v);
  piece->value = here.zeta;
  return 1;
}

/* From u, v and the best c_d over c_d and, as far as is said, k_s and b; the largest ratio found. */
static double climb(struct search *s, double u, double v, int over_u, int over_v, double radius, int most)
{
  double x[3], zeta;
  int n = 0;

  s->c_scale = s->best.c_d > 0. ? s->best.c_d : 1.;
  s->held_u = u;
  s->held_v = v;
  s->over_u = over_u;
  s->over_v = over_v;
  if (over_u)
    x[n++] = u;
  if (over_v)
    x[n++] = v;
  x[n++] = 0.5;
  climb_largest(climb_at, s, n, x, radius, most, INFINITY, &zeta);
  s->climbed_u = over_u ? x[0] : u;
  return zeta;
}

/* The largest ratio at one k_s, at the b held. */
static double at_u(double u, void *context)
{
  struct search *const s = context;
  struct libmlg_ratio here;
  int load;

  if (s->loads > 0)
    return climb(s, u, s->held_v, 0, 0, 1e-3, 60);
  devices_put(&s->device, u, s->held_v);
  if (least_over(s, s->best.c_d, &here, &load) != 0
      || libmlg_best_c_d_from(s->device.layout, s->device.par, s->V_least, s->V_top, &here) != 0)
    return -INFINITY;
  take(s, &here, u, s->held_v);
  return here.zeta;
}

/* About the best design at one b; the largest ratio there.  A ridge over k_s and c_d may be bent and thousands
 * of times as steep on one side as on the other, where a climb creeps. */
static double about_u(struct search *s, double u, double v, double half, double known)
{
  s->held_v = v;
  return golden_largest(at_u, s, fmax(least_u, u - half), fmin(PLACES_SOFTEST, u + half), 1e-6 * half, &u, known);
}

/* The largest ratio at one b, from the best design. */
static double at_v(double v, void *context)
{
  struct search *const s = context;
  const double zeta = climb(s, s->u, v, s->device.over_k_s, 0, 1e-3, 100);

  if (!s->device.over_k_s || s->loads > 0 || s->roughly)
    return zeta;
  return about_u(s, s->climbed_u, v, 1e-3, zeta);
}

/* From the best design, `half` of the range of b to both sides and half that of u. */
static void climb_on(struct search *s, double half)
{
  climb(s, s->u, s->v, s->device.over_k_s, s->device.over_b, 0.25 * half, 300);
  for (int again = 0; s->device.over_b && again < 10; again++) {
    const double from = s->v;
    double v = from;

    watch_tell("damping, along b", again, again + 1);
    golden_largest(at_v, s, fmax(0., from - half), fmin(1., from + half), 2e-3 * half, &v, s->best.zeta);
    if (fabs(s->v - from) < 0.9 * half)
      break;
  }
  for (int again = 0; s->device.over_k_s && !(s->roughly && s->device.over_b) && again < 10; again++) {
    const double from = s->u;

    about_u(s, from, s->v, 0.5 * half, s->best.zeta);
    if (fabs(s->u - from) < 0.45 * half)
      break;
  }
}

/* --- the search ---------------------------------------------------------------------------------------- */

/* Until the ratio is above `enough`. */
static void over_the_grid(struct search *s, double enough)
{
  struct devices *const d = &s->device;

  for (int j = 0; j <= (d->over_b ? NODES_B : 0); j++) {
    double u[PLACES_MOST];

    devices_put(d, 0., (double)j / NODES_B);
    const int nodes = libmlg_places(d->layout, d->par, NODES_K_S, u);

    watch_tell("damping, grid over b", j, d->over_b ? NODES_B + 1 : 1);
    for (int i = 0; i < nodes && !(s->best.zeta > enough); i++)
      try_node(s, u[i], (double)j / NODES_B);
  }
}

static double to_six_digits(double x)
{
  char text[32];

  snprintf(text, sizeof text, "%.6g", x);
  return strtod(text, NULL);
}

/* On a flat maximum rounding moves the place in its seventh digit: of k_s and b six are
 * kept, with the best c_d there. */
static void to_known_digits(struct search *s)
{
  struct devices *const d = &s->device;
  struct libmlg_ratio here;

  devices_put(d, s->u <= least_u ? 0. : s->u, s->v);
  if (libmlg_best_c_d_from(d->layout, d->par, s->V_least, s->V_top, &s->best) != 0)
    s->status = LIBMLG_UNSURE;
  if (d->over_k_s)
    d->par[d->k_s] = to_six_digits(s->best.k_s);
  if (d->over_b)
    d->par[d->b] = fmin(fmax(to_six_digits(s->best.b), d->b_least), d->b_most);
  if (libmlg_best_c_d(d->layout, d->par, s->V_least, s->V_top, &here) == 0
      && here.zeta > s->best.zeta - 1e-4 * fabs(s->best.zeta))
    s->best = here;
}

static int begin(struct search *s, int layout, const double par[], double b_least, double b_most, double V_least, double V_top)
{
  *s = (struct search){ .V_least = best_ratio_V_least(V_least, V_top), .V_top = V_top, .best.zeta = -1. };
  return devices_begin(&s->device, layout, par, b_least, b_most);
}

int libmlg_best_damped(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                       struct libmlg_ratio *best)
{
  struct search s;

  if (begin(&s, layout, par, b_least, b_most, V_least, V_top) != 0)
    return LIBMLG_NONE;
  over_the_grid(&s, INFINITY);
  if (s.best.zeta > -1.) {
    climb_on(&s, 1. / NODES_B);
    to_known_digits(&s);
  }
  if (!(s.best.zeta > -1.) && s.status == 0) /* a real eigenvalue grows with any: par's own stands for them */
    return libmlg_best_c_d(layout, par, V_least, V_top, best);
  *best = s.best;
  return s.best.zeta > -1. ? 0 : s.status;
}

int best_damped_is_free(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                        struct libmlg_ratio *best)
{
  struct search s;

  if (begin(&s, layout, par, b_least, b_most, V_least, V_top) != 0)
    return 0;
  over_the_grid(&s, 0.);
  if (s.best.zeta > -1. && !(s.best.zeta > 0.))
    climb(&s, s.u, s.v, s.device.over_k_s, s.device.over_b, 0.5 / NODES_K_S, 300);
  *best = s.best;
  return s.best.zeta > 0.;
}

void best_damped_near(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                      struct libmlg_ratio *best)
{
  struct search s;

  if (begin(&s, layout, par, b_least, b_most, V_least, V_top) != 0)
    return;
  s.u = best->k_s < INFINITY ? 1. / (1. + best->k_s / s.device.k_psi) : 0.;
  s.v = s.device.over_b ? (best->b - b_least) / (b_most - b_least) : 0.;
  s.best.c_d = best->c_d;
  s.roughly = 1;
  climb_on(&s, 0.1 / NODES_B);
  *best = s.best;
}

int libmlg_best_over_loads(int layout, const double par[], double F_least, double F_most, double b_least, double b_most,
                           double V_least, double V_top, struct libmlg_ratio *best)
{
  struct search s;

  if (begin(&s, layout, par, b_least, b_most, V_least, V_top) != 0)
    return LIBMLG_NONE;
  s.best.zeta = -0.9;
  for (s.loads = 0; s.loads < MOST_LOADS; s.loads++)
    s.load[s.loads] = F_least + (F_most - F_least) * s.loads / (MOST_LOADS - 1);
  over_the_grid(&s, INFINITY);
  if (s.best.zeta > -0.9)
    climb_on(&s, 1. / NODES_B);
  *best = s.best;
  return s.best.zeta > -0.9 ? 0 : s.status != 0 ? s.status : LIBMLG_FAILED;
}
