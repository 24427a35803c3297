/* explore_load.c - the design that bears the largest load
 *
 * At one load the best damped design is looked for; as long as it has no shimmy it bears more.
 */
#include <math.h>

#include "weakest.h"

static const double least_load = 1e4; /* N */

static void put_load(struct weakest *w, double F_z)
{
  libmlg_set(w->e->par, LIBMLG_F_Z, F_z);
}

/* From the load of the gear, or the first one below it that a design near x[] bears. */
static double most_load(struct weakest *w, double x[], int *asked)
{
  double load = 0.;

  for (double F_z = fmax(w->e->load, 2. * least_load); F_z > least_load && !(load > 0.); F_z *= 0.8)
    load = weakest_most(w, put_load, x, F_z, asked);
  return load;
}

void explore_load(struct explorer *e, int n, struct found *found)
{
  const double M = e->par[NUMBER_M];
  struct weakest w = { .e = e };
  struct starts starts;

  *found = (struct found){ .value = 0. };
  e->load = libmlg_value(e->par, LIBMLG_F_Z);
  explore_starts(&w, most_load, n, &starts, &found->asked);
  explore_best(e, &starts, 1e-3, found);
  e->par[NUMBER_M] = M;
}
