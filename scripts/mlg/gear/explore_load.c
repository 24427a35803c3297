/* explore_load.c - the design that bears the largest load
 *
 * It asks libmlg_is_free() of one design after the other, a few dozen microseconds each.  Where
 * a design has shimmy its damping ratio, below 0, leads the search to one that has none.
 */
#include "explorer.h"

#include <math.h>
#include <string.h>

#include "command.h"

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
  e->par[NUMBER_C_D] = explore_middle(i.lo.c_d, i.hi.c_d);
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
static double some_load(struct explorer *e, int starts)
{
  const int n = explore_variables(e);
  struct cma_random random = { 5 };

  for (e->load = fmin(fmax(libmlg_value(e->par, LIBMLG_F_Z), 2. * least_load), most_load); e->load > least_load; e->load *= 0.8)
    for (int start = 0; start < e->given.n + (starts + 1) / 2; start++) {
      double x[EXPLORE_VARIABLES], value;

      for (int i = 0; i < n; i++)
        x[i] = start < e->given.n ? e->given.x[start][i] : cma_uniform(&random);
      if (cma_largest(design_load, e, n, x, 0.15, &random, 250 * n, 0., &value) < 0)
        fail("explore", MLG_FAILED, "LAPACK failed");
      if (value > 0.)
        return e->load;
    }
  return 0.;
}

void explore_load(struct explorer *e, int starts, struct found *found)
{
  static const struct goal goal = { design_load, place_load, 1e-3 };
  const double M = e->par[NUMBER_M];
  double result[EXPLORE_STARTS];

  *found = (struct found){ .starts = e->given.n + starts };
  e->load_here = e->load = some_load(e, starts);
  if (e->load > 0.)
    explore_starts(e, &goal, starts, result, found);
  e->par[NUMBER_M] = M;
}
