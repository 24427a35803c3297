/* slopes.c - how bounds of c_d and damping ratios move with a parameter p
 *
 * Along the curve F(omega ray; V, c, p) = 0 of characteristic.h
 *
 *   F_s ray domega + F_V dV + F_c dc + F_p dp = 0.
 *
 * At a boundary point F_V is, but for a real factor, F_s ray (an extremum of c), or dV = 0
 * (an edge of the range of V).  Either way what is left of the imaginary part of this times
 * the conjugate of F_s ray is
 *
 *   dc/dp = - Im(conj(F_s ray) F_p) / Im(conj(F_s ray) F_c).
 *
 * An eigenvalue s moves by -F_p/F_s, and with it zeta = -Re(s)/|s|; where zeta is least over
 * V, the slope along V is 0 or the end of the range holds V, so that V may be held.
 */
#include <math.h>
#include <string.h>

#include "crossing.h"
#include "linearised.h"

/* --- the load as a parameter ------------------------------------------------------------ */

double libmlg_value(const double par[], int parameter)
{
  if (parameter == LIBMLG_F_Z)
    return (par[libmlg_parameter("M")] + par[libmlg_parameter("m_D")]) * par[libmlg_parameter("g")];
  return parameter >= 0 && parameter < libmlg_parameters() ? par[parameter] : NAN;
}

void libmlg_set(double par[], int parameter, double value)
{
  if (parameter == LIBMLG_F_Z)
    par[libmlg_parameter("M")] = value / par[libmlg_parameter("g")] - par[libmlg_parameter("m_D")];
  else if (parameter >= 0 && parameter < libmlg_parameters())
    par[parameter] = value;
}

/* --- derivatives of F ------------------------------------------------------------------- */

/* A point in SI units: F(s; V, c) at its own parameters. */
struct place { const struct libmlg_layout *layout; double _Complex s; double V, c; };

static double _Complex polynomial(const double p[], int n, double _Complex s)
{
  double _Complex value = 0.;

  for (int i = n; i >= 0; i--)
    value = value * s + p[i];
  return value;
}

/* F at other parameters.  It comes divided by a positive number that moves with them, which
 * does nothing to a derivative where F = 0. */
static double _Complex F_at(const struct place *at, const double par[])
{
  double slots[MLG_SLOTS];

  libmlg_slots(par, slots);
  const struct crossing x = crossing_of(at->layout, slots, 0.);
  const double _Complex s = at->s / x.omega_unit;
  const double V = at->V / x.V_unit, c = at->c / x.c_unit;

  double _Complex F = 0.;

  for (int v = x.speeds; v >= 0; v--)
    F = F * V + polynomial(x.F[v][0], x.order, s) + polynomial(x.F[v][1], x.order, s) * c;
  return F;
}

/* Central differences of eighth order: exact for polynomials up to that degree, and F is one
 * of at most fourth degree in every parameter but l (1/l) and phi (sine and cosine). */
static const double weight[4] = { 4. / 5., -1. / 5., 4. / 105., -1. / 280. };

static const double step = 1e-2; /* of the parameter, where F is smooth to (step)^8 */

static double _Complex F_by_parameter(const struct place *at, const double par[], int parameter)
{
  const double value = libmlg_value(par, parameter);
  const double usual = parameter == LIBMLG_F_Z ? value : libmlg_default(parameter);
  double p[LIBMLG_MOST_PARAMETERS], scale = fabs(value) > 0. ? fabs(value) : fabs(usual) > 0. ? fabs(usual) : 1.;
  double _Complex sum = 0.;
  const int in_compliance = parameter == libmlg_parameter("k_s"); /* in which F is affine */

  memcpy(p, par, (size_t)libmlg_parameters() * sizeof *par);
  if (!isfinite(scale) || scale >= MLG_RIGID)
    return 0.; /* a rigid spring */
  for (int i = 0; i < 4; i++)
    for (int side = -1; side <= 1; side += 2) {
      const double part = 1. + side * (i + 1) * step;

      libmlg_set(p, parameter, in_compliance ? value / part : value + side * (i + 1) * step * scale);
      sum += side * weight[i] * F_at(at, p);
    }
  return (in_compliance ? -1. : 1.) * sum / (step * scale);
}

/* The same by s, V and c, in which F is a polynomial, V and c to the first power. */
static double _Complex F_by_s(const struct place *at, const double par[])
{
  const double h = step * cabs(at->s);
  double _Complex sum = 0.;

  for (int i = 0; i < 4; i++)
    for (int side = -1; side <= 1; side += 2) {
      struct place beside = *at;

      beside.s += side * (i + 1) * h;
      sum += side * weight[i] * F_at(&beside, par);
    }
  return sum / h;
}

static double _Complex F_by_c(const struct place *at, const double par[])
{
  struct place none = *at;

  none.c = 0.;
  return (F_at(at, par) - F_at(&none, par)) / at->c;
}

static int is_known(int layout, int parameter)
{
  return libmlg_find(layout) && (parameter == LIBMLG_F_Z || (parameter >= 0 && parameter < libmlg_parameters()));
}

int libmlg_point_slope(int layout, const double par[], double zeta, const struct libmlg_point *point, int parameter,
                       double *slope)
{
  const double _Complex ray = mlg_ray(zeta);
  const struct place at = { libmlg_find(layout), point->omega * ray, point->V, point->c_d };

  if (!is_known(layout, parameter))
    return LIBMLG_NONE;
  if (point->kind == LIBMLG_ENDS || !(point->c_d > 0.) || !isfinite(point->c_d)) {
    *slope = 0.;
    return 0;
  }
  const double _Complex along = conj(F_by_s(&at, par) * ray);

  *slope = -cimag(along * F_by_parameter(&at, par, parameter)) / cimag(along * F_by_c(&at, par));
  return isfinite(*slope) ? 0 : LIBMLG_FAILED;
}

/* The root s above the axis whose damping ratio is zeta, rad/s. */
static int root_of_ratio(const struct place *at, const double par[], double zeta, double _Complex *s)
{
  double slots[MLG_SLOTS], re[CROSSING_TERMS], im[CROSSING_TERMS], nearest = INFINITY;
  int n;

  libmlg_slots(par, slots);
  const struct crossing x = crossing_of(at->layout, slots, 0.);

  n = crossing_roots(&x, at->V / x.V_unit, at->c / x.c_unit, re, im);
  for (int i = 0; i < n; i++) {
    const double apart = fabs(-re[i] / hypot(re[i], im[i]) - zeta);

    if (im[i] > 0. && apart < nearest) {
      nearest = apart;
      *s = x.omega_unit * (re[i] + I * im[i]);
    }
  }
  return isfinite(nearest) ? 0 : LIBMLG_FAILED;
}

int libmlg_ratio_slope(int layout, const double par[], const struct libmlg_ratio *least, int parameter, double *slope)
{
  struct place at = { libmlg_find(layout), 0., least->V, least->c_d };

  if (!is_known(layout, parameter))
    return LIBMLG_NONE;
  if (root_of_ratio(&at, par, least->zeta, &at.s) != 0)
    return LIBMLG_FAILED;
  for (int i = 0; i < 3; i++) /* roots of a companion matrix lack digits */
    at.s -= F_at(&at, par) / F_by_s(&at, par);

  double _Complex ds;

  if (parameter == libmlg_parameter("c_d"))
    ds = -F_by_c(&at, par) / F_by_s(&at, par);
  else if (parameter == libmlg_parameter("V")) /* held: see above */
    ds = 0.;
  else
    ds = -F_by_parameter(&at, par, parameter) / F_by_s(&at, par);
  const double size = cabs(at.s);

  /* d(-Re s/|s|) = -Im s (Im s Re ds - Re s Im ds)/|s|^3 */
  *slope = -cimag(at.s) * (cimag(at.s) * creal(ds) - creal(at.s) * cimag(ds)) / (size * size * size);
  return isfinite(*slope) ? 0 : LIBMLG_FAILED;
}
