/* balance.c - oscillations of a gear with laws, by describing functions
 *
 * In an oscillation of the amplitude A of psi each element with a law does in the mean,
 * over a cycle of its own amplitude, what a linear one would (Kryloff and Bogoliuboff,
 * Introduction to Non-Linear Mechanics; Gelb and Vander Velde, Multiple-Input Describing
 * Functions, Sections 2.2 and 3.1):
 *
 *   k(x) = 1/(pi x) int T(x sin th) sin th dth      of a spring twisted by x sin th
 *   c(v) = 1/(pi v) int T(v cos th) cos th dth      of a damper at the rate v cos th
 *
 * An element stands in the device once, so that its share of the twist, x / A, is the
 * root of dZ/dZ_e at s = i omega (Tellegen's theorem), Z of the network, Z_e its own
 * stiffness.  Both together are solved by iteration; the gear with these elements is linear,
 * and its eigenvalue says how an oscillation of that size grows.  It is a cycle where the
 * growth is 0, a stable one where it falls with A.  All of that takes the gear itself for
 * linear and the motion for one harmonic.
 */
#include <math.h>
#include <string.h>

#include "layout.h"
#include "linearised.h"

enum { POINTS = 128, ELEMENTS = 4 };

static const int element[ELEMENTS] = { PAR_K_PSI, PAR_K_S, PAR_K_D, PAR_C_D };

static double sharp_gap(double x, double g)
{
  const double r = g / x;

  return r >= 1. ? 0. : 1. - 2. / MLG_PI * (asin(r) + r * sqrt(1. - r * r));
}

/* The mean stiffness or damping of a law at the amplitude x. */
static double mean_of(double law(const double par[], double x), const double par[], double x)
{
  double sum = 0.;

  for (int i = 0; i < POINTS; i++) {
    const double s = sin(2. * MLG_PI * (i + 0.5) / POINTS);

    sum += law(par, x * s) * s;
  }
  return 2. * sum / (POINTS * x);
}

static double mean_of_element(int slot, const double par[], double x)
{
  const double g = slot == PAR_K_PSI ? par[PAR_G_PSI] : par[PAR_G_S];

  if ((slot == PAR_K_PSI || (slot == PAR_K_S && !(par[PAR_K_S3] > 0.))) && !(par[PAR_CORNER] > 0.))
    return par[slot] * (g > 0. ? sharp_gap(x, g) : 1.);
  return mean_of(slot == PAR_K_PSI ? mlg_links : slot == PAR_K_S ? mlg_k_s : slot == PAR_K_D ? mlg_k_d : mlg_damper_torque, par, x);
}

static int has_law(int slot, const double par[])
{
  switch (slot) {
  case PAR_K_PSI: return par[PAR_G_PSI] > 0.;
  case PAR_K_S: return par[PAR_K_S] < MLG_RIGID && (par[PAR_G_S] > 0. || par[PAR_K_S3] > 0.);
  case PAR_K_D: return par[PAR_K_D3] > 0.;
  default: return par[PAR_T_F] > 0. || par[PAR_C_2] > 0. || par[PAR_T_MAX] > 0.;
  }
}

static double _Complex stiffness(const struct libmlg_layout *l, const double slots[], double _Complex s)
{
  const struct network Z = l->network(l, slots);

  return poly_value(&Z.num, s) / poly_value(&Z.den, s);
}

/* |x_e / psi| of the element in that slot at s = i omega. */
static double share(const struct libmlg_layout *l, const double slots[], int slot, double omega)
{
  const double h = 1e-5 * slots[slot];
  const double _Complex s = I * omega;
  double p[MLG_SLOTS];
  double _Complex Z[2];

  for (int k = 0; k < 2; k++) {
    memcpy(p, slots, sizeof p);
    p[slot] += k ? h : -h;
    Z[k] = stiffness(l, p, s);
  }
  return sqrt(cabs((Z[1] - Z[0]) / (2. * h * (slot == PAR_C_D ? s : 1.))));
}

/* den det of linearised.h, for the gear with the device of slots. */
static double _Complex characteristic_at(const struct libmlg_layout *l, const double slots[], double _Complex s)
{
  const struct gear_matrix g = gear_matrix(slots);
  const struct network Z = l->network(l, slots);
  const double V = slots[PAR_V];
  const double _Complex A11 = poly_value(&g.A11, s), A22 = poly_value(&g.A22, s);
  const double _Complex A12 = gear_entry(g.A12, V, s), A21 = gear_entry(g.A21, V, s);
  const double _Complex q = gear_entry(g.q, V, s), p = gear_entry(g.p, V, s), tyre = gear_entry(g.tyre, V, s);
  const double _Complex whole = A11 * (A22 * tyre + p * g.D2) - A12 * (A21 * tyre + q * g.D2) + g.D1 * (A22 * q - A21 * p);

  return poly_value(&Z.den, s) * whole + poly_value(&Z.num, s) * (A11 * tyre + q * g.D1);
}

/* The eigenvalue to which so many steps of Newton's method lead from s; 0: to none. */
static double _Complex eigenvalue_from(const struct libmlg_layout *l, const double slots[], double _Complex s, int steps)
{
  for (int i = 0; i < steps; i++) {
    const double h = 1e-6 * cabs(s);
    const double _Complex F = characteristic_at(l, slots, s);
    const double _Complex slope = (characteristic_at(l, slots, s + h) - F) / h;
    const double _Complex step = F / slope;

    if (!isfinite(creal(step)) || !isfinite(cimag(step)))
      return 0.;
    s -= cabs(step) > 0.3 * cabs(s) ? step * (0.3 * cabs(s) / cabs(step)) : step;
    if (cabs(step) < 1e-12 * cabs(s))
      break;
  }
  return s;
}

int libmlg_equivalent(int layout, const double par[], double psi, double near_hz, double equivalent[],
                      struct libmlg_mode *mode)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  const double floor = 1e-7; /* of a stiffness: inside its gap a joint has none */
  double slots[MLG_SLOTS], p[MLG_SLOTS];
  double _Complex s = 2. * MLG_PI * near_hz * I;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
  memcpy(p, slots, sizeof p);
  mlg_at_rest(p);
  p[PAR_K_S3] = p[PAR_K_D3] = 0.;
  for (int e = 0; e < ELEMENTS; e++) /* to begin with */
    if (has_law(element[e], slots) && element[e] == PAR_C_D)
      p[PAR_C_D] = fmax(slots[PAR_C_D], 1.); /* an orifice alone has no linear part */
    else if (has_law(element[e], slots))
      p[element[e]] = fmax(mean_of_element(element[e], slots, psi), 1e-3 * slots[element[e]]);
  for (int i = 0; i < 300; i++) {
    const double _Complex before = s;
    double change = 0.;

    s = eigenvalue_from(l, p, s, i == 0 ? 50 : 1); /* converges with the elements */
    if (!(cimag(s) > 1e-3))
      return LIBMLG_FAILED;
    p[PAR_C_PSI] = slots[PAR_C_PSI] + (slots[PAR_T_PSI] > 0. ? mean_of(mlg_wheel_friction, slots, cimag(s) * psi) : 0.);
    for (int e = 0; e < ELEMENTS; e++)
      if (has_law(element[e], slots)) {
        const int slot = element[e];
        const double x = share(l, p, slot, cimag(s)) * psi;
        const double mean = fmax(mean_of_element(slot, slots, (slot == PAR_C_D ? cimag(s) : 1.) * x), floor * fmax(slots[slot], 1.));
        const double next = sqrt(p[slot] * mean); /* half of the way, for all hang together */

        change = fmax(change, fabs(log(next / p[slot])));
        p[slot] = next;
      }
    if (change < 1e-9 && cabs(s - before) < 1e-10 * cabs(s))
      break;
  }
  *mode = (struct libmlg_mode){
    .V = slots[PAR_V], .re = creal(s), .im = cimag(s), .zeta = -creal(s) / cabs(s), .frequency_hz = cimag(s) / (2. * MLG_PI),
    .delta_over_psi = delta_over_psi(p, slots[PAR_V], s),
  };
  if (equivalent)
    for (int k = 0; k < MLG_PARAMETER_COUNT; k++)
      equivalent[libmlg_parameter(mlg_parameters[k].name)] = p[mlg_parameters[k].slot];
  return 0;
}

/* The amplitude between lo and hi where the growth is 0, and its mode; growth: at hi. */
static double root_between(int layout, const double par[], double lo, double hi, double growth, double hz,
                           struct libmlg_mode *at)
{
  for (int k = 0; k < 40 && hi / lo > 1. + 1e-9; k++) {
    const double middle = sqrt(lo * hi);

    if (libmlg_equivalent(layout, par, middle, hz, NULL, at) != 0)
      break;
    if (at->re * growth > 0.)
      hi = middle;
    else
      lo = middle;
  }
  return sqrt(lo * hi);
}

/* Cycles of one mode, known at the largest amplitude; returns how many there are now. */
static int follow(int layout, const double par[], double hz, double psi_least, double psi_most,
                  struct libmlg_balance cycle[], int n, int most, int *grows)
{
  enum { STEPS = 40 };
  double psi = psi_most, growth = NAN;

  for (int i = 0; i <= STEPS; i++) { /* from the large, where play is small, to the small */
    const double next = psi_most * pow(psi_least / psi_most, (double)i / STEPS);
    struct libmlg_mode here, at;

    if (libmlg_equivalent(layout, par, next, hz, NULL, &here) != 0)
      break; /* it oscillates no longer */
    *grows |= i == 0 && here.re > 0.;
    if (growth * here.re < 0. && n < most) {
      at = here;
      const double root = root_between(layout, par, next, psi, growth, here.frequency_hz, &at);

      if (fabs(at.re) > 1e-3 * fabs(here.re - growth))
        break; /* it was another mode's */
      cycle[n++] = (struct libmlg_balance){ root, at.frequency_hz, at.delta_over_psi, growth < 0. };
    }
    psi = next;
    hz = here.frequency_hz;
    growth = here.re;
  }
  return n;
}

int libmlg_balance(int layout, const double par[], double psi_least, double psi_most, struct libmlg_balance cycle[], int most,
                   int *grows)
{
  enum { MODES = 6 };
  struct libmlg_mode mode[MODES];
  int diverges, n = 0, modes;

  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  if ((modes = libmlg_modes(layout, par, mode, MODES, &diverges)) < 0)
    return modes;
  *grows = 0;
  for (int m = 0; m < modes && m < MODES; m++)
    n = follow(layout, par, mode[m].frequency_hz, psi_least, psi_most, cycle, n, most, grows);
  /* two modes may have become one on the way: each cycle once, the largest first */
  for (int i = 0; i < n; i++)
    for (int j = i + 1; j < n; j++)
      if (fabs(log(cycle[i].psi / cycle[j].psi)) < 1e-6 && fabs(cycle[i].frequency_hz / cycle[j].frequency_hz - 1.) < 1e-6)
        cycle[j--] = cycle[--n];
  for (int i = 1; i < n; i++)
    for (int j = i; j > 0 && cycle[j].psi > cycle[j - 1].psi; j--) {
      const struct libmlg_balance keep = cycle[j];

      cycle[j] = cycle[j - 1];
      cycle[j - 1] = keep;
    }
  return n;
}
