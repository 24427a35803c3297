/* explore_interval.c - the widest zero-shimmy interval of c_d, or that of the largest hi/lo
 *
 * Of a network of k_s and b alone exactly over k_s, so that b is left to search; with further
 * elements by repeated starts over all of them but c_d.
 */
#include "explorer.h"
#include "golden.h"

#include <math.h>
#include <string.h>

/* --- over k_s, and what is left of it by cma.h ---------------------------------------------------- */

enum { STRETCHES = 6 };

/* v: of b = b_most v^2, so that small inertances, where peaks are narrow, have their share. */
struct widest { struct explorer *e; int of_ratio; double v; struct libmlg_interval interval; double k_s, size; };

/* At the k_s of par[]. */
static void take_interval(struct widest *w)
{
  struct libmlg_interval all[LIBMLG_MOST_POINTS];
  const int n = libmlg_intervals(w->e->layout, w->e->par, 0., 0., w->e->V_top, all, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n; i++) {
    const double lo = all[i].lo.c_d, hi = all[i].hi.c_d, size = w->of_ratio ? hi / lo : hi - lo;

    if (size > w->size) {
      w->size = size;
      w->interval = all[i];
      w->k_s = w->e->par[NUMBER_K_S];
    }
  }
}

static double at_k_s(const double x[], void *context)
{
  struct widest *const w = context;
  struct widest here = *w;

  here.size = -INFINITY;
  w->e->par[NUMBER_K_S] = explore_spring(w->e, x[0]);
  take_interval(&here);
  if (here.size > w->size)
    *w = here;
  return here.size;
}

static double b_at(const struct explorer *e, double v)
{
  return e->has_b ? e->b_most * v * v : 0.;
}

static double v_at(const struct explorer *e, double b)
{
  return e->b_most > 0. ? sqrt(b / e->b_most) : 0.;
}

static double widest_at(struct widest *w, double v)
{
  const struct widest none = { .e = w->e, .of_ratio = w->of_ratio, .v = v, .size = -INFINITY };
  struct explorer *const e = w->e;
  struct libmlg_widest best;
  int status;

  *w = none;
  e->par[NUMBER_B] = b_at(e, v);
  e->par[NUMBER_K_S] = MLG_RIGID;
  status = (w->of_ratio ? libmlg_largest_ratio : libmlg_widest)(e->layout, e->par, 0., 0., e->V_top, &best);
  if (status != 0 || best.limit == LIBMLG_NO_INTERVAL)
    return w->size;
  if (!e->has_k_s || (best.k_s >= e->k_least && best.k_s <= 1e9)) {
    w->interval = best.interval;
    w->k_s = best.k_s;
    w->size = w->of_ratio ? best.interval.hi.c_d / best.interval.lo.c_d : best.width;
    return w->size;
  }
  /* beyond the springs that are looked at: the best of these */
  for (int start = 0; start < 4; start++) {
    struct cma_random random = { (unsigned)start };
    double x[1] = { start / 3. }, value;

    explore_climb(at_k_s, w, 1, x, 0.1, &random, 300, &value);
  }
  return w->size;
}

struct along { struct widest here, best; int asked; };

static double at_v(double v, void *context)
{
  struct along *const a = context;

  widest_at(&a->here, v);
  a->asked++;
  if (a->here.size > a->best.size)
    a->best = a->here;
  return a->here.size;
}

/* Golden section over v, to this part of its range, from *w, where something is known. */
static struct widest between(struct widest w, double left, double right, double part_left, int *asked)
{
  struct along a = { w, w, 0 };
  double v = w.v;

  golden_largest(at_v, &a, left, right, part_left, &v, w.size);
  *asked += a.asked;
  return a.best;
}

/* The same at a place of k_s and b, for a narrow interval that the nodes over k_s may miss. */
static double at_place(const double x[], void *context)
{
  struct widest *const w = context;
  struct widest here = *w;

  here.size = -INFINITY;
  explore_set(w->e, x);
  here.v = v_at(w->e, w->e->par[NUMBER_B]);
  take_interval(&here);
  if (here.size > w->size)
    *w = here;
  return here.size;
}

/* From a design that has an interval, by the evolution strategy. */
static void beside(struct widest *best, const double given[])
{
  const int n = best->e->has_k_s + best->e->has_b;
  struct cma_random random = { 3 };
  double x[EXPLORE_VARIABLES], value;

  memcpy(x, given, sizeof x);
  for (int k = 0; k < 3 && n > 0; k++)
    explore_climb(at_place, best, n, x, (double[]){ 1e-3, 1e-2, 1e-4 }[k], &random, 200 * n, &value);
}

/* --- over b --------------------------------------------------------------------------------------- */

/* The best of the stretches of v, each with those beside it and from the best of its nodes, to result[]. */
static struct widest over_b(const struct widest *none, double result[], int *asked)
{
  const double step = 1. / STRETCHES;
  struct widest best = *none, node[STRETCHES + 1];

  for (int k = 0; k <= STRETCHES; k++) {
    node[k] = *none;
    widest_at(&node[k], k * step);
    ++*asked;
  }
  for (int i = 0; i < STRETCHES; i++) {
    const int first = i > 0 ? i - 1 : 0, last = i + 2 < STRETCHES ? i + 2 : STRETCHES;
    const struct widest *from = &node[first];

    for (int k = first + 1; k <= last; k++)
      if (node[k].size > from->size)
        from = &node[k];
    const struct widest here = between(*from, first * step, last * step, 1e-3, asked);

    result[i] = here.size;
    if (here.size > best.size)
      best = here;
  }
  return best;
}

/* Closely about the best so far. */
static void refine_b(struct widest *best, int *asked)
{
  const struct widest here = between(*best, fmax(0., best->v - 0.01), fmin(1., best->v + 0.01), 5e-9, asked);

  if (here.size > best->size)
    *best = here;
}

/* --- over further elements -------------------------------------------------------------------------- */

/* The size of the interval at a place, or where there is none the damping ratio there, below 0,
 * at the c_d that is set. */
static double size_or_ratio(const double x[], void *explorer)
{
  struct explorer *const e = explorer;
  struct widest here = { .e = e, .of_ratio = e->of_ratio, .size = -INFINITY };
  struct libmlg_ratio least;

  explore_set(e, x);
  take_interval(&here);
  if (here.size > 0.)
    return here.size;
  return libmlg_least_ratio(e->layout, e->par, e->V_least, e->V_top, &least) == 0 ? fmin(least.zeta, 0.) : -INFINITY;
}

static struct widest over_others(struct explorer *e, int starts, double result[], double at[], int *asked)
{
  const int n = explore_variables(e) - 1;
  struct widest best = { .e = e, .of_ratio = e->of_ratio, .size = -INFINITY };
  struct cma_random random = { 7 };

  for (int start = 0; start < e->given.n + starts; start++) {
    const double *const given = start < e->given.n ? e->given.x[start] : NULL;
    double x[EXPLORE_VARIABLES] = { 0. }, place[EXPLORE_VARIABLES] = { 0. };

    if (given)
      explore_set_all(e, given); /* its c_d */
    result[start] = -INFINITY;
    for (int k = 0; k < (given ? 1 : 12); k++) {
      for (int i = 0; i < n; i++)
        place[i] = given ? given[i] : cma_uniform(&random);
      const double value = size_or_ratio(place, e);

      ++*asked;
      if (value > result[start]) {
        result[start] = value;
        memcpy(x, place, sizeof place);
      }
    }
    for (int k = 0; k < 4 && result[start] < INFINITY; k++)
      *asked += explore_climb(size_or_ratio, e, n, x, given && k == 0 ? 0.05 : (double[]){ 0.15, 0.02, 1e-3, 1e-5 }[k], &random,
                              n * (k == 0 ? 150 : 60), &result[start]);
    if (result[start] > best.size && result[start] > 0.) {
      explore_set(e, x);
      take_interval(&best);
      memcpy(at, x, sizeof x);
    }
  }
  return best;
}

void explore_interval(struct explorer *e, int of_ratio, int starts, struct found *found)
{
  const struct widest none = { .e = e, .of_ratio = of_ratio, .size = -INFINITY };
  struct widest best = none;
  double result[EXPLORE_STARTS];

  *found = (struct found){ .starts = e->others > 0 ? e->given.n + starts : e->has_b ? STRETCHES : 1 };
  e->of_ratio = of_ratio;
  if (e->others > 0) {
    best = over_others(e, starts, result, found->x, &found->asked);
  } else if (e->has_b) {
    best = over_b(&none, result, &found->asked);
  } else {
    result[0] = widest_at(&best, 0.);
    found->asked++;
  }
  for (int i = 0; i < e->given.n && e->others == 0; i++)
    beside(&best, e->given.x[i]);
  if (e->has_b && e->others == 0 && best.size > -INFINITY)
    refine_b(&best, &found->asked);
  if (e->others > 0)
    explore_set(e, found->x);
  else
    e->par[NUMBER_B] = b_at(e, best.v);
  explore_take(e, found);
  found->value = best.size;
  found->k_s = best.k_s;
  found->lo = best.interval.lo.c_d;
  found->hi = best.interval.hi.c_d;
  found->met = explore_met(result, found->starts, best.size, 1e-2);
}
