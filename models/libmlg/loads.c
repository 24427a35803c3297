/* loads.c - the largest load with any zero-shimmy design
 *
 * The largest least damping ratio of all designs, at each load, falls as the load rises; where it
 * passes 0 the last design is lost.  It is a smooth function of the load, however narrow the
 * intervals of c_d and the ranges of k_s and b become there.
 */
#include <math.h>
#include <string.h>

#include "best_damped.h"
#include "bracket.h"
#include "layout.h"
#include "watch.h"

enum { LOADS = 12, ROUNDS = 40 };

struct largest {
  int layout;
  double par[LIBMLG_MOST_PARAMETERS], b_least, b_most, V_least, V_top;
};

static int is_free(struct largest *s, double F_z, struct libmlg_ratio *design)
{
  libmlg_set(s->par, LIBMLG_F_Z, F_z);
  return best_damped_is_free(s->layout, s->par, s->b_least, s->b_most, s->V_least, s->V_top, design);
}

/* The largest ratio at a load, from a design nearby, which becomes that with it. */
static double ratio_at(struct largest *s, double F_z, struct libmlg_ratio *design)
{
  libmlg_set(s->par, LIBMLG_F_Z, F_z);
  best_damped_near(s->layout, s->par, s->b_least, s->b_most, s->V_least, s->V_top, design);
  return design->zeta;
}

/* From a design that is free at the load F_lo to the load below F_hi up to which designs near it are. */
static double follow(struct largest *s, double F_lo, double F_hi, struct libmlg_ratio *design)
{
  struct libmlg_ratio at = *design;
  struct bracket b = { .lo = F_lo, .hi = F_hi, .at_lo = ratio_at(s, F_lo, design), .at_hi = ratio_at(s, F_hi, &at) };

  if (b.at_hi > 0.) {
    *design = at;
    return F_hi;
  }
  for (int i = 0; i < ROUNDS && b.hi > b.lo * (1. + 1e-11); i++) {
    const double secant = bracket_secant(&b);
    const double F_z = secant > b.lo && secant < b.hi ? secant : 0.5 * (b.lo + b.hi);

    watch_tell("largest load, step", i, ROUNDS);
    at = *design;
    const double zeta = ratio_at(s, F_z, &at);

    if (zeta > 0.)
      *design = at;
    bracket_narrow(&b, F_z, zeta);
    if (fabs(zeta) < 1e-14)
      break;
  }
  return b.lo;
}

int libmlg_largest_load(int layout, const double par[], double F_most, double b_least, double b_most, double V_least,
                        double V_top, struct libmlg_load *load)
{
  struct largest s = { .layout = layout, .b_least = b_least, .b_most = b_most, .V_least = V_least, .V_top = V_top };
  struct libmlg_ratio design, other;
  int i = LOADS;

  *load = (struct libmlg_load){ .F_z = 0. };
  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  memcpy(s.par, par, (size_t)libmlg_parameters() * sizeof *par);
  while (i > 0 && !is_free(&s, F_most * i / LOADS, &design))
    i--;
  if (i == 0)
    return 0;
  load->F_z = F_most * i / LOADS;
  libmlg_best_damped(layout, s.par, b_least, b_most, V_least, V_top, &design);
  for (int more = i < LOADS; more;) { /* until the grid knows of none a little above, either */
    load->F_z = follow(&s, load->F_z, F_most * (i + 1) / LOADS, &design);
    more = is_free(&s, load->F_z * (1. + 1e-5), &other);
    if (more) {
      load->F_z *= 1. + 1e-5;
      design = other;
    }
  }
  load->k_s = design.k_s;
  load->b = design.b;
  load->c_d = design.c_d;
  return 0;
}
