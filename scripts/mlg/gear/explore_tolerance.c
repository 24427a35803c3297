/* explore_tolerance.c - the design of the largest tolerance (libmlg_tolerance)
 *
 * Of the 2^n corners of the box only a few fail first: the search asks these, adds the corners that
 * fail earlier where it has come to, by the slopes of the bounds of c_d and by turning one
 * parameter after the other, and at its end tests all of them.
 */
#include "explorer.h"

#include <math.h>
#include <string.h>

#include "box.h"
#include "command.h"

/* The design of par[] as its corners are asked. */
static struct box_at here(const struct explorer *e)
{
  struct box_at d = { .layout = e->layout, .par = e->par, .box = &e->corners.box, .V_top = e->V_top, .elements = e->others };

  memcpy(d.element, e->other, sizeof d.element);
  return d;
}

/* The largest p of the design of par[] at the corners that are asked; the one that fails first is
 * asked first next time. */
static double tolerance_here(struct explorer *e)
{
  struct corners *const asked = &e->corners;
  const struct box_at d = here(e);
  double p = LIBMLG_MOST_TOLERANCE;

  for (int i = 0; i < asked->n; i++) {
    const unsigned corner = asked->corner[i];

    if (box_is_free(&d, corner, p * (1. - 1e-9)))
      continue;
    p = box_begins(&d, corner, p);
    memmove(&asked->corner[1], asked->corner, (size_t)i * sizeof corner);
    asked->corner[0] = corner;
  }
  return p;
}

static double tolerance(const double x[], void *explorer)
{
  struct explorer *const e = explorer;

  explore_set_all(e, x);
  const struct box_at d = here(e);

  return box_is_free(&d, 0, 0.) ? tolerance_here(e) : fmin(explore_ratio(x, e), 0.);
}

/* Of a place, at the best c_d, which is left in par[]: golden section over log c_d in the interval
 * without shimmy of the largest hi/lo. */
static double tolerance_over_c_d(const double x[], void *explorer)
{
  struct explorer *const e = explorer;
  const double part = 0.6180339887498949;
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
  double lo = 1., hi = 0., best = 0., c_d = 0.;

  explore_set(e, x);
  const int n = libmlg_intervals(e->layout, e->par, 0., 0., e->V_top, interval, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n; i++) {
    const double from = fmax(interval[i].lo.c_d, 1e-4 * fmin(interval[i].hi.c_d, 1e4)), to = fmin(interval[i].hi.c_d, 1e4 * from);

    if (to / from > hi / lo) {
      lo = from;
      hi = to;
    }
  }
  for (double left = log(lo), right = log(hi), a = 0., b = 0., at_a = -1., at_b = -1.; right - left > 1e-5;) {
    if (at_a < 0.) {
      e->par[NUMBER_C_D] = exp(a = right - part * (right - left));
      at_a = tolerance_here(e);
      if (at_a > best)
        best = at_a, c_d = e->par[NUMBER_C_D];
    }
    if (at_b < 0.) {
      e->par[NUMBER_C_D] = exp(b = left + part * (right - left));
      at_b = tolerance_here(e);
      if (at_b > best)
        best = at_b, c_d = e->par[NUMBER_C_D];
    }
    if (at_a >= at_b) {
      right = b;
      b = a;
      at_b = at_a;
      at_a = -1.;
    } else {
      left = a;
      a = b;
      at_a = at_b;
      at_b = -1.;
    }
  }
  if (best > 0.)
    e->par[NUMBER_C_D] = c_d;
  return best;
}

/* Climbs at the best c_d of each place, twice, so often; the value. */
static double climb_exactly(struct explorer *e, double x[], int often, struct cma_random *random, int *asked)
{
  const int n = explore_variables(e) - 1;
  double value = tolerance_over_c_d(x, e);

  for (int k = 0; k < 2 && n > 0; k++)
    *asked += explore_climb(tolerance_over_c_d, e, n, x, k ? 1e-3 : 0.02, random, often, &value);
  value = tolerance_over_c_d(x, e);
  explore_place(e, e->par[NUMBER_K_S], e->par[NUMBER_B], e->par[NUMBER_C_D], x);
  return value;
}

static int ask(struct explorer *e, unsigned corner)
{
  struct corners *const asked = &e->corners;

  for (int i = 0; i < asked->n; i++)
    if (asked->corner[i] == corner)
      return 0;
  if (asked->n < EXPLORE_CORNERS)
    asked->corner[asked->n++] = corner;
  return 1;
}

/* Asks the corners to which the slopes of the bounds lead at this design, and from the one that
 * fails first those beside it that fail earlier, one parameter after the other to its other end;
 * how many are new. */
static int ask_more(struct explorer *e, const double x[])
{
  unsigned first[2];
  double p = tolerance(x, e);
  int more = 0, n;

  if (!(p > 0.))
    return 0;
  const struct box_at d = here(e);

  n = box_first_corners(&d, first);
  for (int i = 0; i < n; i++)
    more += ask(e, first[i]);
  p = tolerance(x, e) * (1. - 1e-7);
  unsigned at = e->corners.corner[0];

  for (int side = 0, since = 0; since < box_sides(&d); side = (side + 1) % box_sides(&d), since++)
    if (!box_is_free(&d, at ^ 1u << side, p)) {
      at ^= 1u << side;
      p = box_begins(&d, at, p) * (1. - 1e-7);
      since = 0;
    }
  return more + ask(e, at);
}

/* The largest p, as often as new corners are found to fail earlier. */
static double with_its_corners(const double x[], void *explorer)
{
  struct explorer *const e = explorer;

  for (int k = 0; k < 8 && ask_more(e, x) > 0; k++)
    ;
  return tolerance(x, e);
}

/* Climbs from the best so far, until all corners tested fail no earlier than those asked. */
static void settle(struct explorer *e, struct found *found)
{
  struct cma_random random = { 11 };
  struct libmlg_tolerance all;

  for (int round = 0; round < 12; round++) {
    const double value = climb_exactly(e, found->x, 80, &random, &found->asked);

    if (with_its_corners(found->x, e) < value * (1. - 1e-6))
      continue;
    explore_set_all(e, found->x);
    const struct box_at d = here(e);

    if (box_tolerance(&d, &all) != 0)
      fail("explore", MLG_FAILED, "no tolerance at k_s = %g, b = %g, c_d = %g", e->par[NUMBER_K_S], e->par[NUMBER_B], e->par[NUMBER_C_D]);
    found->value = all.p;
    if (all.p >= value * (1. - 1e-6) || !ask(e, all.corner))
      return;
  }
}

/* One start, to a place x[]; more corners are asked on the way. */
static void tolerant_start(struct explorer *e, const double given[], struct cma_random *random, double x[], int *asked)
{
  const int n = explore_variables(e);
  double best = -INFINITY, place[EXPLORE_VARIABLES];

  for (int k = 0; k < (given ? 1 : 12); k++) {
    for (int i = 0; i < n; i++)
      place[i] = given ? given[i] : cma_uniform(random);
    const double value = tolerance(place, e);

    ++*asked;
    if (k == 0 || value > best) {
      best = value;
      memcpy(x, place, sizeof place);
    }
  }
  for (int k = 0; k < 12; k++) {
    *asked += explore_climb(tolerance, e, n, x, k == 0 ? 0.15 : 0.02, random, 150 * n, &best);
    if (with_its_corners(x, e) >= best * (1. - 1e-3))
      break;
  }
}

void explore_tolerance(struct explorer *e, int starts, struct found *found)
{
  double result[EXPLORE_STARTS], place[EXPLORE_STARTS][EXPLORE_VARIABLES] = { { 0. } };
  struct cma_random random = { 13 };
  const int n = e->given.n + starts;
  int top = 0;

  *found = (struct found){ .starts = n };
  e->corners.n = 0;
  explore_set_all(e, (double[EXPLORE_VARIABLES]){ 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5 });
  libmlg_box_of(e->layout, e->par, &e->corners.box);
  for (int start = 0; start < n; start++) {
    tolerant_start(e, start < e->given.n ? e->given.x[start] : NULL, &random, place[start], &found->asked);
    if (tolerance(place[start], e) > 0.)
      climb_exactly(e, place[start], 30, &random, &found->asked);
  }
  for (int start = 0; start < n; start++) { /* by the corners of all */
    result[start] = tolerance(place[start], e);
    if (start == 0 || result[start] > found->value) {
      top = start;
      found->value = result[start];
      memcpy(found->x, place[start], sizeof place[start]);
    }
  }
  if (!(found->value > 0.))
    return;
  settle(e, found);
  for (int start = 0; start < n; start++)
    result[start] = start == top ? found->value : tolerance(place[start], e);
  found->met = explore_met(result, n, found->value, 1e-2);
  explore_set_all(e, found->x);
  explore_take(e, found);
}
