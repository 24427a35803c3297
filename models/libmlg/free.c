/* free.c - does this one gear shimmy at this c_d, and at which speeds? */
#include <math.h>

#include "crossing.h"

/* What both can be asked of. */
static int is_question(const struct libmlg_layout *l, const double slots[], double V_least, double V_top)
{
  return l && V_least >= 0. && V_top > V_least && isfinite(V_top) && slots[PAR_C_D] >= 0. && isfinite(slots[PAR_C_D]);
}

int libmlg_is_free(int layout, const double par[], double zeta, double V_least, double V_top)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];
  struct crossing_at at[CROSSING_TERMS];

  libmlg_slots_at_rest(par, slots);
  if (!is_question(l, slots, V_least, V_top))
    return LIBMLG_NONE;
  const struct crossing x = crossing_of(l, slots, zeta);
  const double c = slots[PAR_C_D] / x.c_unit, lo = V_least / x.V_unit, hi = V_top / x.V_unit;

  /* without a crossing one speed stands for all; of the two questions the cheaper first */
  return crossings_at_c(&x, c, lo, hi, at) == 0 && crossing_ratio(&x, 0.5 * (lo + hi), c) > zeta;
}

int libmlg_shimmy_speeds(int layout, const double par[], double V_least, double V_top, struct libmlg_band band[], int most)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];
  struct crossing_at at[CROSSING_TERMS + 1];
  int n = 0;

  libmlg_slots_at_rest(par, slots);
  if (!is_question(l, slots, V_least, V_top))
    return LIBMLG_NONE;
  const struct crossing x = crossing_of(l, slots, 0.);
  const double c = slots[PAR_C_D] / x.c_unit;
  const int crossings = crossings_at_c(&x, c, V_least / x.V_unit, V_top / x.V_unit, at);
  double from = V_least;

  crossings_by_V(at, crossings);
  for (int i = 0; i <= crossings; i++) {
    const double to = i < crossings ? at[i].V * x.V_unit : V_top;

    if (to > from && !(crossing_ratio(&x, 0.5 * (from + to) / x.V_unit, c) > 0.)) {
      if (n > 0 && n <= most && band[n - 1].to == from) /* another mode sets in: one band */
        band[n - 1].to = to;
      else if (n++ < most)
        band[n - 1] = (struct libmlg_band){ from, to };
    }
    from = to;
  }
  return n;
}
