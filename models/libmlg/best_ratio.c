/* best_ratio.c - the least damping ratio over V, and the c_d where it is largest
 *
 * Both go from one ratio to the next better one and end when the exact answer at that
 * ratio says that there is none: no speed with a lesser ratio, no interval of c_d with a
 * larger one.  Nothing is sampled that could be missed.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossing.h"
#include "linearised.h"

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

static void into_SI(const struct crossing *x, struct libmlg_ratio *r)
{
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
  libmlg_slots(par, slots);
  x = crossing_of(l, slots, 0.);
  status = least_ratio(&x, slots[PAR_C_D] / x.c_unit, V_least / x.V_unit, V_top / x.V_unit, least);
  into_SI(&x, least);
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
  libmlg_slots(par, slots);
  x = crossing_of(l, slots, 0.);
  *best = (struct libmlg_ratio){ .zeta = -1., .c_d = slots[PAR_C_D], .V = V_least };
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
          into_SI(&x, best);
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
