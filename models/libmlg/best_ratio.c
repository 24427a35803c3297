/* best_ratio.c - the least damping ratio over V, and the c_d where it is largest
 *
 * Both go from one ratio to the next better one and end when the exact answer at that
 * ratio says that there is none: no speed with a lesser ratio, no interval of c_d with a
 * larger one.  Nothing is sampled that could be missed.
 */
#include <math.h>
#include <stdlib.h>

#include "best_ratio.h"
#include "bracket.h"
#include "linearised.h"

enum { STEPS = 200 };

static int rising(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* All in the units of x: the least ratio at c over the speeds, from the level at `guess`, a speed
 * near where it is; 0: from those at the ends alone. */
static int least_ratio(const struct crossing *x, double c, double V_least, double V_top, double guess, struct libmlg_ratio *least)
{
  *least = (struct libmlg_ratio){ .zeta = HUGE_VAL, .c_d = c };
  for (int step = 0; step < STEPS; step++) {
    double V[CROSSING_TERMS + 2] = { V_least, V_top };
    const double before = least->zeta;
    int n = 2;

    if (step == 0 && guess > V_least && guess < V_top)
      V[n++] = guess;
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

double best_ratio_V_least(double V_least, double V_top)
{
  return fmax(V_least, 1e-9 * V_top);
}

static void into_SI(const struct crossing *x, const double slots[], struct libmlg_ratio *r)
{
  r->k_s = slots[PAR_K_S] < MLG_RIGID ? slots[PAR_K_S] : INFINITY;
  r->b = slots[PAR_B];
  r->c_d *= x->c_unit;
  r->V *= x->V_unit;
}

int libmlg_least_ratio_from(int layout, const double par[], double V_least, double V_top, double guess,
                            struct libmlg_ratio *least)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];
  struct crossing x;
  int status;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  V_least = best_ratio_V_least(V_least, V_top);
  x = crossing_of(l, slots, 0.);
  status = least_ratio(&x, slots[PAR_C_D] / x.c_unit, V_least / x.V_unit, V_top / x.V_unit, guess / x.V_unit, least);
  into_SI(&x, slots, least);
  return status;
}

int libmlg_least_ratio(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *least)
{
  return libmlg_least_ratio_from(layout, par, V_least, V_top, 0., least);
}

/* --- the best c_d ------------------------------------------------------------------------------ */

/* Inside lo to hi, which may be 0 or infinite. */
static double inside(double lo, double hi, double part)
{
  if (!(lo > 0.))
    return isfinite(hi) ? hi * part : 1.;
  return isfinite(hi) ? lo * pow(hi / lo, part) : lo / part;
}

/* Between the ends of an interval, where the ratios at the speeds of both ends are the same: one of
 * them rises with c, the other falls, and the best c is there but for the speeds that move on
 * (the exchange of Remez).  In the units of x. */
static double meeting(const struct crossing *x, const struct libmlg_interval *i)
{
  const double V_lo = i->lo.V / x->V_unit, V_hi = i->hi.V / x->V_unit;
  struct bracket b = { .lo = i->lo.c_d / x->c_unit, .hi = i->hi.c_d / x->c_unit };

  if (!(b.lo > 0.) || !isfinite(b.hi))
    return inside(b.lo, b.hi, 0.5);
  b.at_lo = crossing_ratio(x, V_lo, b.lo) - crossing_ratio(x, V_hi, b.lo);
  b.at_hi = crossing_ratio(x, V_lo, b.hi) - crossing_ratio(x, V_hi, b.hi);
  if (!(b.at_lo < 0.) || !(b.at_hi > 0.))
    return inside(b.lo, b.hi, 0.5);
  for (int k = 0; k < 12 && b.hi > b.lo * (1. + 1e-13); k++) {
    const double c = bracket_secant(&b);
    const double here = crossing_ratio(x, V_lo, c) - crossing_ratio(x, V_hi, c);

    if (!(c > b.lo && c < b.hi) || here == 0.)
      return c;
    bracket_narrow(&b, c, here);
  }
  return b.lo + (b.hi - b.lo) * 0.5;
}

/* The intervals of a ratio or, where what is found there contradicts itself, of a slightly larger
 * one: of two speeds or modes that share a ratio to rounding one may be lost. */
static int intervals_above(int layout, const double par[], double zeta, double V_least, double V_top,
                           struct libmlg_interval interval[])
{
  int n = LIBMLG_UNSURE;

  for (double more = 0.; n == LIBMLG_UNSURE && more < 1e-3; more = fmax(10. * more, 1e-11))
    n = libmlg_intervals(layout, par, zeta + more * (1e-6 + fabs(zeta)), V_least, V_top, interval, LIBMLG_MOST_POINTS);
  return n;
}

int libmlg_best_c_d_from(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *best)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
  double slots[MLG_SLOTS];

  libmlg_slots_at_rest(par, slots);
  V_least = best_ratio_V_least(V_least, V_top);
  const struct crossing x = crossing_of(l, slots, 0.);

  for (int step = 0; step < STEPS; step++) {
    const double before = best->zeta, zeta = before + 1e-13 * (1e-3 + fabs(before));
    const int n = intervals_above(layout, par, zeta, V_least, V_top, interval);

    if (n <= 0)
      return n;
    for (int i = 0; i < n; i++) {
      const double lo = interval[i].lo.c_d / x.c_unit, hi = interval[i].hi.c_d / x.c_unit;
      const double c[4] = { meeting(&x, &interval[i]), inside(lo, hi, 0.1), inside(lo, hi, 0.9), 0. };

      /* far from the best the middle alone creeps; without a lower end no damper may be best */
      for (int k = 0; k < 4; k++) {
        struct libmlg_ratio r;

        if (k < 3 ? !(c[k] > lo && c[k] < hi) || (k > 0 && step > 2) : lo > 0.)
          continue;
        if (least_ratio(&x, c[k], V_least / x.V_unit, V_top / x.V_unit, best->V / x.V_unit, &r) != 0)
          return LIBMLG_FAILED;
        if (r.zeta > best->zeta) {
          *best = r;
          into_SI(&x, slots, best);
        }
      }
    }
    if (!(best->zeta > before)) /* what is left is rounding */
      return 0;
  }
  return 0;
}

int libmlg_best_c_d(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *best)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];
  struct crossing x;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  x = crossing_of(l, slots, 0.);
  *best = (struct libmlg_ratio){ .zeta = -1., .c_d = slots[PAR_C_D], .V = V_least, .k_s = slots[PAR_K_S], .b = slots[PAR_B] };
  if (libmlg_diverges(layout, par))
    return 0;
  slots[PAR_C_D] = x.c_unit; /* any does to begin with */
  if (least_ratio(&x, 1., best_ratio_V_least(V_least, V_top) / x.V_unit, V_top / x.V_unit, 0., best) != 0)
    return LIBMLG_FAILED;
  into_SI(&x, slots, best);
  return libmlg_best_c_d_from(layout, par, V_least, V_top, best);
}
