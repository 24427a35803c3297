/* designs.c - what the commands about loads, elasticities and tolerances share */
#include "designs.h"

#include <math.h>

#include "command.h"
#include "names.h"

/* A c_d that stands for an interval. */
static double middle(const struct arguments *a, double V_least, const struct libmlg_interval *i)
{
  struct libmlg_ratio best;

  if (isfinite(i->hi.c_d))
    return 0.5 * (i->lo.c_d + i->hi.c_d);
  if (i->lo.c_d > 0.)
    return 2. * i->lo.c_d;
  checked(a->command, libmlg_best_c_d(a->layout, a->par, V_least, a->V_top, &best));
  return best.c_d;
}

bool take_interval(struct arguments *a, double V_least, struct libmlg_interval *interval)
{
  struct libmlg_interval all[LIBMLG_MOST_POINTS];
  const double c_d = a->par[NUMBER_C_D];
  const int n = checked(a->command, libmlg_intervals(a->layout, a->par, 0., 0., a->V_top, all, LIBMLG_MOST_POINTS));
  double widest = 0.;

  for (int i = 0; i < n; i++) {
    const double lo = all[i].lo.c_d, hi = all[i].hi.c_d;

    if (a->word[NUMBER_C_D] ? lo < c_d && c_d < hi : hi - lo > widest) {
      widest = hi - lo;
      *interval = all[i];
    }
  }
  if (widest > 0. && !a->word[NUMBER_C_D])
    a->par[NUMBER_C_D] = middle(a, V_least, interval);
  return widest > 0.;
}

const char *quantity_name(int parameter)
{
  return parameter == LIBMLG_F_Z ? "F_z" : libmlg_parameter_quantity(parameter)->name;
}

const char *quantity_unit(int parameter)
{
  return parameter == LIBMLG_F_Z ? "N" : libmlg_parameter_quantity(parameter)->unit;
}

/* The mode that is damped least between two speeds; its V is its place. */
static struct libmlg_mode mode_between(const struct arguments *a, const double par[], double V_least, double V_top)
{
  struct libmlg_ratio least;
  struct libmlg_mode mode;
  double at[LIBMLG_MOST_PARAMETERS];

  if (libmlg_least_ratio(a->layout, par, V_least, V_top, &least) != 0)
    fail(a->command, MLG_FAILED, "no eigenvalues at c_d = %g", par[NUMBER_C_D]);
  for (int i = 0; i < NUMBERS; i++)
    at[i] = par[i];
  at[NUMBER_V] = least.V;
  if (libmlg_least_damped(a->layout, at, &mode) != 0)
    fail(a->command, MLG_FAILED, "no eigenvalues at V = %g, c_d = %g", least.V, par[NUMBER_C_D]);
  mode.zeta = least.zeta; /* which has more digits */
  mode.V = least.V;
  return mode;
}

bool least_mode(const struct arguments *a, const double par[], double V_least, struct libmlg_mode *mode)
{
  *mode = mode_between(a, par, V_least, a->V_top);
  return mode->zeta > -1.;
}

struct libmlg_mode shown_mode(const struct arguments *a, const double par[], double V_least, const struct libmlg_ratio *best)
{
  const double above = best->zeta + 1e-6 * fabs(best->zeta);
  struct libmlg_mode mode = mode_between(a, par, V_least, a->V_top), other;
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  double from = 0., to = 0.;
  int n;

  mode.zeta = best->zeta;
  if (libmlg_is_delta(par, mode.delta_over_psi) || !(best->zeta > -1.))
    return mode;
  n = checked(a->command, libmlg_hopf_at_c_d(a->layout, par, above, V_least, a->V_top, point, LIBMLG_MOST_POINTS));
  for (int i = 0; i < n && i < LIBMLG_MOST_POINTS; i++)
    if (libmlg_is_delta(par, point[i].delta_over_psi)) {
      from = from > 0. ? from : point[i].V;
      to = point[i].V;
    }
  if (!(from < to))
    return mode;
  other = mode_between(a, par, from, to);
  if (!libmlg_is_delta(par, other.delta_over_psi) || !(other.zeta < above))
    return mode;
  other.zeta = best->zeta;
  return other;
}

void check_speeds(const struct arguments *a, double V_least)
{
  refuse_given(a, NUMBER_V, "a design holds for every V");
  if (!(V_least < a->V_top))
    fail(a->command, MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", V_least, a->V_top);
}

double shown_k_s(double k_s)
{
  return k_s >= MLG_RIGID ? INFINITY : k_s;
}
