/* weakest.c - see weakest.h */
#include "weakest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct box_at weakest_box(const struct explorer *e)
{
  struct box_at d = { .layout = e->layout, .par = e->par, .box = &e->corners.box, .V_top = e->V_top, .elements = e->others };

  memcpy(d.element, e->other, sizeof d.element);
  return d;
}

/* The parameters of a case at the place that is set; elements of the network are changed as well
 * until take_back(). */
struct put { struct box_at box; double par[LIBMLG_MOST_PARAMETERS], own[BOX_ELEMENTS]; };

static struct put put(const struct weakest *w, int at)
{
  const struct corners *const corners = &w->e->corners;
  struct put here = { .box = weakest_box(w->e) };
  double part[LIBMLG_MOST_SIDES] = { 0. };

  if (corners->n > 0)
    box_corner(&here.box, corners->corner[at], w->p, part);
  box_to(&here.box, part, here.par, here.own);
  return here;
}

static void take_back(const struct put *here)
{
  box_back(&here->box, here->own);
}

static int cases(const struct weakest *w)
{
  return w->e->corners.n > 0 ? w->e->corners.n : 1;
}

/* Whether it is free of ratios below zeta. */
static int is_above(const struct weakest *w, int at, double zeta)
{
  const struct put here = put(w, at);
  const int is_free = libmlg_is_free(w->e->layout, here.par, zeta, w->V_least, w->e->V_top);

  take_back(&here);
  return is_free == 1;
}

int weakest_is_free(const struct weakest *w)
{
  for (int at = 0; at < cases(w); at++)
    if (!is_above(w, at, 0.))
      return 0;
  return 1;
}

static int is_same(const struct weak *a, const struct weak *b)
{
  return a->at == b->at && fabs(a->mode.V - b->mode.V) < 1e-3 * b->mode.V && cabs(a->mode.s - b->mode.s) < 1e-3 * cabs(b->mode.s);
}

/* Follows all modes to the place that is set; those that are lost or have become one go. */
static double follow(struct weakest *w)
{
  double least = INFINITY;
  int kept = 0;

  for (int i = 0; i < w->n; i++) {
    struct weak here = w->weak[i];
    int same = here.at >= cases(w);

    if (same)
      continue;
    const struct put there = put(w, here.at);

    same = mode_follow(w->e->layout, there.par, w->V_least, w->e->V_top, &here.mode) != 0;
    take_back(&there);
    for (int k = 0; k < kept && !same; k++)
      same = is_same(&w->weak[k], &here);
    if (same)
      continue;
    w->weak[kept++] = here;
    least = fmin(least, here.mode.zeta);
  }
  w->n = kept;
  return least;
}

/* The one of the largest ratio makes room. */
static void add(struct weakest *w, const struct weak *new)
{
  int top = 0;

  if (w->n < WEAKEST_MOST) {
    w->weak[w->n++] = *new;
    return;
  }
  for (int i = 1; i < w->n; i++)
    if (w->weak[i].mode.zeta > w->weak[top].mode.zeta)
      top = i;
  w->weak[top] = *new;
}

/* Looks in all cases for modes of a lesser ratio than those known; the least, or -INFINITY: some
 * case diverges. */
static double complete(struct weakest *w, double least)
{
  for (int at = 0; at < cases(w); at++) {
    struct weak new = { .at = at };

    if (isfinite(least) && is_above(w, at, least - 1e-11 - 1e-8 * fabs(least)))
      continue;
    const struct put here = put(w, at);
    const int status = mode_least(w->e->layout, here.par, w->V_least, w->e->V_top, &new.mode);

    take_back(&here);
    if (status != 0)
      return -INFINITY;
    if (new.mode.zeta < least) {
      add(w, &new);
      least = new.mode.zeta;
    }
  }
  return least;
}

static int rising(const void *a, const void *b)
{
  const double x = ((const struct weak *)a)->mode.zeta, y = ((const struct weak *)b)->mode.zeta;

  return (x > y) - (x < y);
}

int weakest_at(const double x[], struct climb_piece piece[], void *weakest)
{
  const double h = 1e-6; /* of the unit box */
  struct weakest *const w = weakest;
  struct explorer *const e = w->e;
  const int n = explore_variables(e);
  double least, y[EXPLORE_VARIABLES];
  int pieces = 0;

  explore_set_all(e, x);
  least = complete(w, follow(w));
  if (!isfinite(least))
    return 0;
  qsort(w->weak, (size_t)w->n, sizeof *w->weak, rising);
  while (pieces < w->n && pieces < CLIMB_PIECES && w->weak[pieces].mode.zeta < least + fmax(3. * fabs(least), 1e-3)) {
    piece[pieces] = (struct climb_piece){ .value = w->weak[pieces].mode.zeta };
    pieces++;
  }
  for (int j = 0; j < n; j++)
    for (int side = -1; side <= 1; side += 2) {
      memcpy(y, x, (size_t)n * sizeof *x);
      y[j] += side * h;
      explore_set_all(e, y);
      for (int i = 0; i < pieces; i++) {
        const struct put here = put(w, w->weak[i].at);

        piece[i].slope[j] += side * mode_ratio(e->layout, here.par, &w->weak[i].mode) / (2. * h);
        take_back(&here);
      }
    }
  explore_set_all(e, x);
  return pieces;
}

/* --- tops -------------------------------------------------------------------------------------- */

/* In so many climbs of `most` values at most. */
static double climb(struct weakest *w, double x[], double radius, int climbs, int most, int *asked)
{
  double top = -INFINITY;

  for (int k = 0, more = 1; k < 8 && (k < climbs || more > 0); k++) {
    *asked += climb_largest(weakest_at, w, explore_variables(w->e), x, k == 0 ? radius : 0.1 * radius, most, INFINITY, &top);
    explore_set_all(w->e, x);
    more = w->more && isfinite(top) ? w->more(w) : 0;
  }
  return top;
}

double weakest_top(struct weakest *w, double x[], double radius, int *asked)
{
  return climb(w, x, radius, 2, 100 * explore_variables(w->e), asked);
}

/* The largest t near that one at which the design that is set is free; 0: there is none. */
static double borne(struct weakest *w, void put_t(struct weakest *w, double t), double t)
{
  double lo = t, hi = t, step = 1e-6;

  put_t(w, t);
  if (weakest_is_free(w))
    for (lo = t, hi = t * (1. + step); put_t(w, hi), weakest_is_free(w) && step < 4.; step *= 4.) {
      lo = hi;
      hi *= 1. + step;
    }
  else
    for (hi = t, lo = t * (1. - step); put_t(w, lo), !weakest_is_free(w); step *= 4.) {
      hi = lo;
      lo *= 1. - step;
      if (step > 0.3)
        return 0.;
    }
  while (hi - lo > 1e-10 * hi) {
    const double middle = 0.5 * (lo + hi);

    put_t(w, middle);
    if (weakest_is_free(w))
      lo = middle;
    else
      hi = middle;
  }
  return lo;
}

double weakest_most(struct weakest *w, void put_t(struct weakest *w, double t), double x[], double t, int *asked)
{
  const int n = explore_variables(w->e);
  double best = 0., at[EXPLORE_VARIABLES], before = 0., ratio_before = NAN;

  memcpy(at, x, (size_t)n * sizeof *x);
  for (int k = 0, last = 0; k < 40; k++) {
    put_t(w, t);
    /* until the end it need not be the very top */
    const double ratio = last ? weakest_top(w, at, 0.01, asked) : climb(w, at, k == 0 ? 0.1 : 0.01, 1, 15 * n, asked);
    const double here = isfinite(ratio) ? borne(w, put_t, t) : 0., grows = here - best;

    if (grows > 0.) {
      best = here;
      memcpy(x, at, (size_t)n * sizeof *x);
    }
    if (!(best > 0.))
      return 0.;
    /* where a straight line through the last two ratios is 0 */
    const double falls = (ratio_before - ratio) / (t - before), root = t + ratio / falls;
    const double next = falls > 0. && root > best ? fmin(root, 1.3 * best) : best;
    const int ends = !(grows > 1e-7 * best) && !(next > best * (1. + 1e-7));

    if (last && ends)
      break;
    last = last || ends || fabs(next - t) < 1e-3 * t;
    before = t;
    ratio_before = ratio;
    t = next;
  }
  put_t(w, best);
  explore_set_all(w->e, x);
  return best;
}
