/* mode.c - see mode.h */
#include "mode.h"

#include <math.h>

#include "best_ratio.h"
#include "crossing.h"

/* F(s) at one V and c, all in units of struct crossing, and its derivative. */
static double _Complex value(const struct crossing *x, double V, double c, double _Complex s, double _Complex *slope)
{
  double _Complex F = 0.;

  *slope = 0.;
  for (int i = x->order; i >= 0; i--) {
    double p = 0.;

    for (int v = x->speeds; v >= 0; v--)
      p = p * V + x->F[v][0][i] + c * x->F[v][1][i];
    *slope = *slope * s + F;
    F = F * s + p;
  }
  return F;
}

static struct crossing equation(int layout, const double par[], double *c)
{
  double slots[MLG_SLOTS];

  libmlg_slots_at_rest(par, slots);
  const struct crossing x = crossing_of(libmlg_find(layout), slots, 0.);

  *c = slots[PAR_C_D] / x.c_unit;
  return x;
}

/* The root near s, by Newton's method; 0: there is none. */
static double _Complex root_near(const struct crossing *x, double V, double c, double _Complex s)
{
  double last = INFINITY;

  for (int i = 0; i < 20; i++) {
    double _Complex slope;
    const double _Complex F = value(x, V, c, s, &slope), step = F / slope;
    const double size = cabs(step);

    if (!(size < 0.3 * cabs(s)))
      return 0.;
    if (!(size < last) && size < 1e-9 * cabs(s)) /* rounding */
      break;
    last = size;
    s -= step;
  }
  return s;
}

static double ratio(double _Complex s)
{
  return -creal(s) / cabs(s);
}

int mode_least(int layout, const double par[], double V_least, double V_top, struct mode_at *mode)
{
  struct libmlg_ratio least;
  double re[CROSSING_TERMS], im[CROSSING_TERMS], nearest = INFINITY, c;
  double _Complex s = 0.;
  const int status = libmlg_least_ratio(layout, par, V_least, V_top, &least);

  if (status != 0)
    return status;
  const struct crossing x = equation(layout, par, &c);
  const double V = least.V / x.V_unit;
  const int n = crossing_roots(&x, V, c, re, im);

  for (int i = 0; i < n; i++) {
    const double _Complex root = re[i] + I * im[i];

    if (im[i] > 0. && fabs(ratio(root) - least.zeta) < nearest) {
      nearest = fabs(ratio(root) - least.zeta);
      s = root;
    }
  }
  *mode = (struct mode_at){ least.V, least.zeta, x.omega_unit * s };
  return isfinite(nearest) && least.zeta > -1. ? 0 : LIBMLG_FAILED;
}

/* A speed and the root there, in units of struct crossing. */
struct here { double V, zeta; double _Complex s; };

static int move(const struct crossing *x, double c, double V, struct here *at)
{
  const double _Complex s = root_near(x, V, c, at->s);

  if (!(cimag(s) > 0.))
    return 0;
  *at = (struct here){ V, ratio(s), s };
  return 1;
}

int mode_follow(int layout, const double par[], double V_least, double V_top, struct mode_at *mode)
{
  double c;
  const struct crossing x = equation(layout, par, &c);
  const double lo = best_ratio_V_least(V_least, V_top) / x.V_unit, hi = V_top / x.V_unit;
  struct here at = { .s = mode->s / x.omega_unit };

  if (!move(&x, c, mode->V / x.V_unit, &at))
    return LIBMLG_FAILED;
  for (int i = 0; i < 8; i++) { /* to the top of a parabola through three speeds */
    const double h = 1e-3 * at.V;
    struct here left = at, right = at, next = at;

    if (!move(&x, c, at.V - h, &left) || !move(&x, c, at.V + h, &right))
      break;
    const double slope = 0.5 * (right.zeta - left.zeta), bend = right.zeta - 2. * at.zeta + left.zeta;
    const double far = bend > 0. ? -slope / bend : slope > 0. ? -INFINITY : INFINITY;
    const double V = fmin(hi, fmax(lo, at.V + h * fmin(200., fmax(-200., far))));

    if (!move(&x, c, V, &next) || !(next.zeta < at.zeta))
      break;
    const int near = fabs(V - at.V) < 1e-3 * h;

    at = next;
    if (near)
      break;
  }
  *mode = (struct mode_at){ at.V * x.V_unit, at.zeta, at.s * x.omega_unit };
  return 0;
}

double mode_ratio(int layout, const double par[], const struct mode_at *mode)
{
  double c;
  const struct crossing x = equation(layout, par, &c);
  const double _Complex s = root_near(&x, mode->V / x.V_unit, c, mode->s / x.omega_unit);

  return cimag(s) > 0. ? ratio(s) : NAN;
}
