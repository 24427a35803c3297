/* explore_robust.c - the design that bears the largest load, and that of the largest tolerance
 *
 * Both ask libmlg_is_free() of one design after the other, a few dozen microseconds each.  Where
 * the design itself has shimmy its damping ratio, below 0, leads the search to one that has none.
 */
#include "explorer.h"

#include <math.h>
#include <string.h>

#include "box.h"
#include "command.h"

/* --- load -------------------------------------------------------------------------------------- */

static const double least_load = 1e4, most_load = 1e7; /* N */

static void put_load(struct explorer *e, double F_z)
{
  libmlg_set(e->par, LIBMLG_F_Z, F_z);
}

/* Whether the design of par[] bears a load; whether its k_s and b do with some c_d, which is then
 * in par[]. */
static int design_bears(struct explorer *e, double F_z)
{
  put_load(e, F_z);
  return libmlg_is_free(e->layout, e->par, 0., 0., e->V_top) == 1;
}

static int place_bears(struct explorer *e, double F_z)
{
  struct libmlg_interval i;

  put_load(e, F_z);
  if (libmlg_intervals(e->layout, e->par, 0., 0., e->V_top, &i, 1) < 1)
    return 0;
  e->par[NUMBER_C_D] = isfinite(i.hi.c_d) ? (i.lo.c_d > 0. ? sqrt(i.lo.c_d * i.hi.c_d) : 0.5 * i.hi.c_d) : 2. * i.lo.c_d;
  return 1;
}

static double bisected(struct explorer *e, int (*bears)(struct explorer *e, double F_z), double lo, double hi)
{
  while (hi - lo > 1e-9 * hi) {
    const double middle = sqrt(lo * hi);

    if (bears(e, middle))
      lo = middle;
    else
      hi = middle;
  }
  return lo;
}

/* From a load that is borne as far as all above it are, in steps that grow. */
static double raised(struct explorer *e, int (*bears)(struct explorer *e, double F_z), double from)
{
  double step = 1e-4, next = from * (1. + step);

  for (; next < most_load && bears(e, next); next = from * (1. + (step *= 4.)))
    from = next;
  return bisected(e, bears, from, next);
}

/* The largest load of a design, from one that it bears on: a design without shimmy at
 * one load may have it at less. */
static double design_load(const double x[], void *explorer)
{
  struct explorer *const e = explorer;

  explore_set_all(e, x);
  if (design_bears(e, e->load))
    return raised(e, design_bears, e->load);
  put_load(e, e->load);
  return fmin(explore_ratio(x, e), 0.);
}

static double place_load(const double x[], void *explorer)
{
  struct explorer *const e = explorer;
  double load = 0.;

  explore_set(e, x);
  if (place_bears(e, e->load_here))
    load = raised(e, place_bears, e->load_here);
  else if (place_bears(e, e->load))
    load = bisected(e, place_bears, e->load, e->load_here);
  if (load > 0.) {
    place_bears(e, load); /* its c_d */
    e->load_here = load;
  }
  return load;
}

/* A load that some design bears: that of the gear, or the first one below it; 0: none. */
static double some_load(struct explorer *e, int starts, const double given[])
{
  const int n = explore_variables(e);
  struct cma_random random = { 5 };

  for (e->load = fmin(fmax(libmlg_value(e->par, LIBMLG_F_Z), 2. * least_load), most_load); e->load > least_load; e->load *= 0.8)
    for (int start = 0; start < (starts + 1) / 2; start++) {
      double x[EXPLORE_VARIABLES], value;

      for (int i = 0; i < n; i++)
        x[i] = start == 0 && given ? given[i] : cma_uniform(&random);
      if (cma_largest(design_load, e, n, x, 0.15, &random, 250 * n, 0., &value) < 0)
        fail("explore", MLG_FAILED, "LAPACK failed");
      if (value > 0.)
        return e->load;
    }
  return 0.;
}

void explore_load(struct explorer *e, int starts, const double given[], struct found *found)
{
  static const struct goal goal = { design_load, place_load, 1e-3 };
  const double M = e->par[NUMBER_M];
  double result[EXPLORE_STARTS];

  *found = (struct found){ .starts = starts };
  e->load_here = e->load = some_load(e, starts, given);
  if (e->load > 0.)
    explore_starts(e, &goal, starts, given, result, found);
  e->par[NUMBER_M] = M;
}

/* --- tolerance ------------------------------------------------------------------------------------ */

/* The design of par[] as its corners are asked. */
static struct box_at here(const struct explorer *e)
{
  return (struct box_at){ e->layout, e->par, &e->corners.box, 0., e->V_top };
}

/* The largest p at the corners that are asked; the one that fails first is asked first next time. */
static double tolerance(const double x[], void *explorer)
{
  struct explorer *const e = explorer;
  struct corners *const asked = &e->corners;
  double p = LIBMLG_MOST_TOLERANCE;

  explore_set_all(e, x);
  const struct box_at d = here(e);

  if (!box_is_free(&d, 0, 0.))
    return fmin(explore_ratio(x, e), 0.);
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

  for (int side = 0, since = 0; since < e->corners.box.n; side = (side + 1) % e->corners.box.n, since++)
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
  const int n = explore_variables(e);
  struct cma_random random = { 11 };
  struct libmlg_tolerance all;

  for (int round = 0; round < 12; round++) {
    double value;

    for (int k = 0; k < 3; k++)
      found->asked += explore_climb(tolerance, e, n, found->x, (double[]){ 1e-2, 1e-3, 1e-5 }[k], &random, 150 * n, &value);
    if (with_its_corners(found->x, e) < value * (1. - 1e-6))
      continue;
    explore_set_all(e, found->x);
    if (libmlg_tolerance(e->layout, e->par, &e->corners.box, 0., e->V_top, &all) != 0)
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
  for (int k = 0; k < 8; k++) {
    *asked += explore_climb(tolerance, e, n, x, k == 0 ? 0.15 : 0.02, random, 150 * n, &best);
    if (with_its_corners(x, e) >= best * (1. - 1e-3))
      return;
  }
}

void explore_tolerance(struct explorer *e, int starts, const double given[], struct found *found)
{
  double result[EXPLORE_STARTS], place[EXPLORE_STARTS][EXPLORE_VARIABLES] = { { 0. } };
  struct cma_random random = { 13 };

  *found = (struct found){ .starts = starts };
  e->corners.n = 0;
  explore_set_all(e, (double[EXPLORE_VARIABLES]){ 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5 });
  libmlg_box_of(e->layout, e->par, &e->corners.box);
  for (int start = 0; start < starts; start++)
    tolerant_start(e, start == 0 ? given : NULL, &random, place[start], &found->asked);
  for (int start = 0; start < starts; start++) { /* by the corners of all */
    result[start] = tolerance(place[start], e);
    if (start == 0 || result[start] > found->value) {
      found->value = result[start];
      memcpy(found->x, place[start], sizeof place[start]);
    }
  }
  if (!(found->value > 0.))
    return;
  settle(e, found);
  for (int start = 0; start < starts; start++)
    result[start] = tolerance(place[start], e);
  found->met = explore_met(result, starts, found->value, 1e-2);
  explore_set_all(e, found->x);
  explore_take(e, found);
}
