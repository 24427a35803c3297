/* best_ratio.c - the least damping ratio over V, and the c_d where it is largest
 *
 * Both go from one ratio to the next better one and end when the exact answer at that
 * ratio says that there is none: no speed with a lesser ratio, no interval of c_d with a
 * larger one.  Nothing is sampled that could be missed.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crossing.h"
#include "linearised.h"
#include "places.h"

enum { STEPS = 200 };

static int rising(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* All in the units of x: the least ratio at c over the speeds. */
static int least_ratio(const struct crossing *x, double c, double V_least, double V_top, struct libmlg_ratio *least)
{
  *least = (struct libmlg_ratio){ .zeta = HUGE_VAL, .c_d = c };
  for (int step = 0; step < STEPS; step++) {
    double V[CROSSING_TERMS + 2] = { V_least, V_top };
    const double before = least->zeta;
    int n = 2;

    if (step > 0) {
      struct crossing_at at[CROSSING_TERMS];
      const struct crossing y = crossing_on(x, before);
      const int crossings = crossings_at_c(&y, c, V_least, V_top, at);

      for (int i = 0; i < crossings; i++)
        V[n++] = at[i].V;
      qsort(V, (size_t)n, sizeof *V, rising);
    }
    for (int i = 0; i < n; i++) { /* the ends, then the middle of each stretch */
      const double here = step == 0 ? V[i] : i > 0 ? 0.5 * (V[i - 1] + V[i]) : V[0];
      const double zeta = crossing_ratio(x, here, c);

      if (isnan(zeta))
        return LIBMLG_FAILED;
      if (zeta < least->zeta) {
        least->zeta = zeta;
        least->V = here;
      }
    }
    if (!(least->zeta > -1.)) /* a positive real eigenvalue */
      return 0;
    if (step > 0 && !(least->zeta < before - 1e-14 * (1e-3 + fabs(before))))
      return 0;
  }
  return 0;
}

/* V_least = 0 is a limit: there a root is 0. */
static double above_0(double V_least, double V_top)
{
  return fmax(V_least, 1e-9 * V_top);
}

static void into_SI(const struct crossing *x, const double slots[], struct libmlg_ratio *r)
{
  r->k_s = slots[PAR_K_S];
  r->b = slots[PAR_B];
  r->c_d *= x->c_unit;
  r->V *= x->V_unit;
}

int libmlg_least_ratio(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *least)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];
  struct crossing x;
  int status;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  V_least = above_0(V_least, V_top);
  x = crossing_of(l, slots, 0.);
  status = least_ratio(&x, slots[PAR_C_D] / x.c_unit, V_least / x.V_unit, V_top / x.V_unit, least);
  into_SI(&x, slots, least);
  return status;
}

/* Inside lo to hi, which may be 0 or infinite. */
static double inside(double lo, double hi, double part)
{
  if (!(lo > 0.))
    return isfinite(hi) ? hi * part : 1.;
  return isfinite(hi) ? lo * pow(hi / lo, part) : lo / part;
}

int libmlg_best_c_d(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *best)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  struct libmlg_interval interval[LIBMLG_MOST_POINTS], last = { { .c_d = 0. }, { .c_d = 0. } };
  double slots[MLG_SLOTS], last_zeta = NAN;
  struct crossing x;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  V_least = above_0(V_least, V_top);
  x = crossing_of(l, slots, 0.);
  *best = (struct libmlg_ratio){ .zeta = -1., .c_d = slots[PAR_C_D], .V = V_least, .k_s = slots[PAR_K_S], .b = slots[PAR_B] };
  if (libmlg_diverges(layout, par))
    return 0;
  for (int step = 0; step < STEPS; step++) {
    /* step 0: any c_d does to begin with */
    const double zeta = best->zeta + 1e-13 * (1e-3 + fabs(best->zeta));
    const int n = step == 0 ? 1 : libmlg_intervals(layout, par, zeta, V_least, V_top, interval, LIBMLG_MOST_POINTS);

    if (n < 0)
      return n;
    if (n == 0)
      return 0;
    if (step == 0)
      interval[0] = (struct libmlg_interval){ { .c_d = 0. }, { .c_d = INFINITY } };
    const double before = best->zeta;

    for (int i = 0; i < n; i++) {
      const double lo = interval[i].lo.c_d / x.c_unit, hi = interval[i].hi.c_d / x.c_unit;
      double c[4] = { inside(lo, hi, 0.5), inside(lo, hi, 0.1), inside(lo, hi, 0.9), 0. };
      int m = step < 3 ? 3 : 1;

      /* where the two ends, each moving on as it did, would meet */
      if (n == 1 && last_zeta < zeta && last.lo.c_d > 0. && lo > 0.) {
        const double up = log(interval[i].lo.c_d / last.lo.c_d), down = log(last.hi.c_d / interval[i].hi.c_d);

        if (up + down > 0.)
          c[m++] = lo * exp(log(hi / lo) * up / (up + down));
      }
      for (int k = 0; k < m; k++) {
        struct libmlg_ratio r;

        if (!(c[k] > lo && c[k] < hi))
          continue;
        if (least_ratio(&x, c[k], V_least / x.V_unit, V_top / x.V_unit, &r) != 0)
          return LIBMLG_FAILED;
        if (r.zeta > best->zeta) {
          *best = r;
          into_SI(&x, slots, best);
        }
      }
    }
    last = interval[0];
    last_zeta = step > 0 ? zeta : NAN;
    if (!(best->zeta > before) && step > 0) /* what is left is rounding */
      return 0;
  }
  return 0;
}

/* --- over k_s and b ------------------------------------------------------------------- */

enum { NODES_K_S = 64, NODES_B = 33 };

/* The place of a number between 0 and 1: u = 1 / (1 + k_s/k_psi), and of b in its range. */
struct search {
  int layout, k_s, b;
  double par[LIBMLG_MOST_PARAMETERS], k_psi, b_least, b_most, V_least, V_top;
  struct libmlg_ratio best;
  int status;
};

static void place(struct search *s, double u, double v)
{
  if (libmlg_uses(s->layout, s->k_s) == 1)
    s->par[s->k_s] = libmlg_place_k_s(s->k_psi, u, INFINITY);
  if (libmlg_uses(s->layout, s->b) == 1)
    s->par[s->b] = s->b_least + v * (s->b_most - s->b_least);
}

/* The best ratio there, when it is better than the best so far; 1: it was. */
static int improve(struct search *s, double u, double v)
{
  struct libmlg_interval interval;
  struct libmlg_ratio here;
  int status;

  place(s, u, v);
  if (libmlg_intervals(s->layout, s->par, s->best.zeta, s->V_least, s->V_top, &interval, 1) == 0)
    return 0;
  status = libmlg_best_c_d(s->layout, s->par, s->V_least, s->V_top, &here);
  if (status != 0)
    s->status = status;
  else if (here.zeta > s->best.zeta) {
    s->best = here;
    return 1;
  }
  return 0;
}

static double between_0_and_1(double x)
{
  return fmin(1., fmax(0., x));
}

/* Finer and finer grids about the best place so far: its ridges have kinks and jumps, at
 * which a search by slopes or sections would stop.  Where the place moves on along a ridge the
 * grid turns into the direction of that move, and is stretched to twice its length: a ridge may
 * be ten thousand times as long as it is wide. */
static void zoom(struct search *s, double u, double v, double half_u, double half_v)
{
  enum { AROUND = 5 };
  const int both = half_u > 0. && half_v > 0.;
  double x = 1., y = 0., stretch = 1.; /* the direction, in units of half_u and half_v */

  while (half_u > 1e-10 || half_v > 1e-10) {
    const double u_0 = u, v_0 = v, before = s->best.zeta;

    for (int j = -AROUND; j <= AROUND; j++)
      for (int i = -AROUND; i <= AROUND; i++) {
        const double along = stretch * i / AROUND, across = (double)j / AROUND;
        const double u_i = between_0_and_1(u_0 + half_u * (along * x - across * y));
        const double v_j = between_0_and_1(v_0 + half_v * (along * y + across * x));

        if ((i != 0 && !(half_u > 0.)) || (j != 0 && !(half_v > 0.)))
          continue;
        if (improve(s, u_i, v_j)) {
          u = u_i;
          v = v_j;
        }
      }
    if (s->best.zeta > before + 1e-6 * fabs(before)) {
      const double dx = (u - u_0) / half_u, dy = (v - v_0) / half_v, length = hypot(dx, dy);

      if (both && length > 0.) {
        x = dx / length;
        y = dy / length;
        stretch = fmax(1., 2. * length);
      }
      continue;
    }
    if (y != 0. || stretch > 1.) { /* the ridge ends or bends */
      x = stretch = 1.;
      y = 0.;
      continue;
    }
    half_u *= 0.5;
    half_v *= 0.5;
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
  struct libmlg_ratio here;

  if (libmlg_uses(s->layout, s->k_s) == 1)
    s->par[s->k_s] = to_six_digits(s->best.k_s);
  if (libmlg_uses(s->layout, s->b) == 1 && s->b_most > s->b_least)
    s->par[s->b] = fmin(fmax(to_six_digits(s->best.b), s->b_least), s->b_most);
  if (libmlg_best_c_d(s->layout, s->par, s->V_least, s->V_top, &here) == 0
      && here.zeta > s->best.zeta - 1e-4 * fabs(s->best.zeta))
    s->best = here;
}

int libmlg_best_damped(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                       struct libmlg_ratio *best)
{
  struct search s = { .layout = layout, .k_s = libmlg_parameter("k_s"), .b = libmlg_parameter("b"), .b_least = b_least,
                      .b_most = b_most, .V_least = V_least, .V_top = V_top, .best.zeta = -1. };
  double u = 0., v = 0.;

  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  memcpy(s.par, par, (size_t)libmlg_parameters() * sizeof *par);
  s.k_psi = par[libmlg_parameter("k_psi")];
  const int over_k_s = libmlg_uses(layout, s.k_s) == 1, over_b = libmlg_uses(layout, s.b) == 1 && b_most > b_least;

  for (int j = 0; j < (over_b ? NODES_B : 1); j++) {
    double node[PLACES_MOST];
    int nodes;

    place(&s, 0., (double)j / (NODES_B - 1));
    nodes = libmlg_places(layout, s.par, NODES_K_S, node);
    for (int i = 0; i < nodes; i++)
      if (improve(&s, node[i], (double)j / (NODES_B - 1))) {
        u = node[i];
        v = (double)j / (NODES_B - 1);
      }
  }
  zoom(&s, u, v, over_k_s ? 1. / NODES_K_S : 0., over_b ? 1. / (NODES_B - 1) : 0.);
  if (s.best.zeta > -1.)
    to_known_digits(&s);
  *best = s.best;
  return s.best.zeta > -1. ? 0 : s.status;
}
