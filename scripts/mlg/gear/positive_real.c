/* positive_real.c - passive devices by numbers without a constraint, and how well they damp; see
 * positive_real.h */
#include "positive_real.h"

#include <math.h>
#include <string.h>

#include "arguments.h"
#include "crossing.h"
#include "device_text.h"
#include "linearised.h"

int passive_variables(int m)
{
  return (m + 1) * (m + 2) / 2 + m * (m - 1) / 2 + m + 1;
}

/* The variables y are numbers of either sign in units of k_psi and 100 rad/s, drawn apart: y near 0
 * is of the order of 0.01, y = 5 of 1.5. */
static double number(double y)
{
  return PASSIVE_UNIT * sinh(y);
}

struct realisation { double A[MOST_M][MOST_M], in[MOST_M], out[MOST_M], D; };

static struct realisation realisation(int m, const double x[])
{
  double L[MOST_M + 1][MOST_M + 1] = { { 0. } }, W[MOST_M + 1][MOST_M + 1] = { { 0. } };
  struct realisation g = { .D = 0. };

  for (int i = 0; i <= m; i++)
    for (int k = 0; k <= i; k++)
      L[i][k] = number(*x++);
  for (int i = 0; i <= m; i++)
    for (int k = 0; k <= m; k++)
      for (int j = 0; j <= m; j++)
        W[i][k] += L[i][j] * L[k][j];
  for (int i = 0; i < m; i++)
    for (int k = 0; k < m; k++)
      g.A[i][k] = -W[i][k];
  for (int i = 0; i < m; i++)
    for (int k = 0; k < i; k++) {
      const double J = number(*x++);

      g.A[i][k] += J;
      g.A[k][i] -= J;
    }
  for (int i = 0; i < m; i++) {
    const double B = number(*x++);

    g.in[i] = B - W[i][m];
    g.out[i] = B + W[i][m];
  }
  g.D = W[m][m];
  return g;
}

/* out' (s - A)^-1 in = num/den by Leverrier's and Faddeev's recursion, s in units of 100 rad/s. */
static void transfer(int m, const struct realisation *g, double num[MOST_M + 1], double den[MOST_M + 1])
{
  double S[MOST_M][MOST_M] = { { 0. } }, next[MOST_M][MOST_M];

  memset(num, 0, (MOST_M + 1) * sizeof *num);
  den[m] = 1.;
  for (int i = 0; i < m; i++)
    S[i][i] = 1.;
  for (int power = m - 1; power >= 0; power--) {
    double trace = 0.;

    for (int i = 0; i < m; i++)
      for (int k = 0; k < m; k++)
        num[power] += g->out[i] * S[i][k] * g->in[k];
    for (int i = 0; i < m; i++)
      for (int k = 0; k < m; k++) {
        next[i][k] = 0.;
        for (int j = 0; j < m; j++)
          next[i][k] += g->A[i][j] * S[j][k];
      }
    for (int i = 0; i < m; i++)
      trace += next[i][i];
    den[power] = -trace / (m - power);
    for (int i = 0; i < m; i++)
      for (int k = 0; k < m; k++)
        S[i][k] = next[i][k] + (i == k ? den[power] : 0.);
  }
}

/* y[0]: K - K_least = k_psi y[0]^2.  K + s (D + out' (s - A)^-1 in), but for D, which is c_d. */
void passive_set(struct passive *p, const double x[])
{
  const double omega = 100., unit = p->par[NUMBER_K_PSI];
  const struct realisation g = realisation(p->m, x + 1);
  double num[MOST_M + 1], den[MOST_M + 1], scale = 1.;
  struct network Z = { .num = { { 0. } } };

  p->K = p->K_least + unit * x[0] * x[0];
  transfer(p->m, &g, num, den);
  for (int i = 0; i <= p->m; i++, scale /= omega) {
    Z.den.coefficient[i] = den[i] * scale;
    Z.num.coefficient[i] += p->K * den[i] * scale;
    if (i < p->m)
      Z.num.coefficient[i + 1] += unit * num[i] * scale / omega;
  }
  device_writable(p->layout)->rational = Z;
  p->par[NUMBER_C_D] = fmax(1e-3, g.D * unit / omega);
}

/* The dynamic stiffness of the device, without k_psi, at s. */
double _Complex passive_stiffness(const struct passive *p, double _Complex s)
{
  const struct network *const r = &device_of(p->layout)->rational;

  return poly_value(&r->num, s) / poly_value(&r->den, s) + p->par[NUMBER_C_D] * s;
}

int passive_least(struct passive *p, const double y[], struct libmlg_ratio *ratio)
{
  passive_set(p, y);
  return libmlg_least_ratio(p->layout, p->par, p->V_least, p->V_top, ratio);
}

/* --- the value to climb, and its slopes ---------------------------------------------------------------
 * The least of all ratios at many speeds, softened: -softness log(sum exp(-zeta/softness)), smooth and
 * below the least by the softness a few times.  Softness falls in steps, and at each the speed at which
 * the least ratio of all is, exactly, joins the others.
 *
 * A mode s is a root of F = whole + Z minor, Z of the device with k_psi (linearised.h), so that
 * ds = -minor dZ / F_s. */

/* whole and minor of a gear, by powers of V. */
struct gear_polynomials { struct poly whole[GEAR_SPEEDS], minor[GEAR_SPEEDS]; };

struct gear_at { double _Complex whole, minor; };

static struct gear_at gear_at(const struct gear_polynomials *g, double V, double _Complex s)
{
  struct gear_at at = { 0., 0. };

  for (int v = GEAR_SPEEDS - 1; v >= 0; v--) {
    at.whole = at.whole * V + poly_value(&g->whole[v], s);
    at.minor = at.minor * V + poly_value(&g->minor[v], s);
  }
  return at;
}

static double _Complex behind_k_psi(const struct passive *p, double _Complex s)
{
  return 1. / (1. / p->par[NUMBER_K_PSI] + 1. / passive_stiffness(p, s));
}

/* A mode that counts: d zeta = Re(by_Z dZ). */
struct counting { double _Complex s, by_Z; double weight; };

enum { MOST_COUNTING = 400 };

static struct counting counting(const struct passive *p, const struct gear_polynomials *g, double V, double _Complex s,
                                double weight)
{
  const double step = 1e-5 * cabs(s), size = cabs(s);
  const struct gear_at here = gear_at(g, V, s), ahead = gear_at(g, V, s + step), back = gear_at(g, V, s - step);
  const double _Complex F_s = (ahead.whole + behind_k_psi(p, s + step) * ahead.minor - back.whole
                               - behind_k_psi(p, s - step) * back.minor) / (2. * step);
  /* zeta = -Re(s)/|s| */
  const double _Complex by_s = -1. / size + creal(s) * conj(s) / (size * size * size);

  return (struct counting){ s, -by_s * here.minor / F_s, weight };
}

/* The softened least ratio at y, -1 where there is none, and its slopes by y unless NULL. */
double passive_value(struct passive *p, double y[], int n, double slope[])
{
  const double h = 1e-6;
  double least = HUGE_VAL, sum = 0., slots[MLG_SLOTS];
  static struct { double _Complex s; double zeta, V; } mode[MOST_SPEEDS * CROSSING_TERMS];
  static struct counting count[MOST_COUNTING];
  struct gear_polynomials g;
  int modes = 0, counts = 0;

  for (int i = 0; i < n; i++) /* far beyond any device */
    if (!(fabs(y[i]) < 16.))
      return -1.;
  passive_set(p, y);
  libmlg_slots(p->par, slots);
  const struct crossing x = crossing_of(libmlg_find(p->layout), slots, 0.);

  for (int k = 0; k < p->speeds; k++) {
    double re[CROSSING_TERMS], im[CROSSING_TERMS];
    const int roots = crossing_roots(&x, p->V[k] / x.V_unit, p->par[NUMBER_C_D] / x.c_unit, re, im);

    if (roots < 0)
      return -1.;
    for (int i = 0; i < roots; i++)
      if (im[i] > 0. || (!(im[i] < 0.) && re[i] > 0.)) {
        const double zeta = im[i] > 0. ? -re[i] / hypot(re[i], im[i]) : -1.;

        mode[modes].s = x.omega_unit * (re[i] + I * im[i]);
        mode[modes].V = p->V[k];
        mode[modes++].zeta = zeta;
        least = fmin(least, zeta);
      }
  }
  if (!(least > -1.))
    return -1.;
  for (int i = 0; i < modes; i++)
    sum += exp((least - mode[i].zeta) / p->softness);
  if (!slope)
    return least - p->softness * log(sum);
  gear_determinants(slots, g.whole, g.minor);
  for (int i = 0; i < modes && counts < MOST_COUNTING; i++) {
    const double weight = exp((least - mode[i].zeta) / p->softness) / sum;

    if (weight > 1e-7)
      count[counts++] = counting(p, &g, mode[i].V, mode[i].s, weight);
  }
  for (int i = 0; i < n; i++) {
    const double at = y[i];

    slope[i] = 0.;
    for (int k = -1; k <= 1; k += 2) {
      y[i] = at + k * h;
      passive_set(p, y);
      for (int c = 0; c < counts; c++)
        slope[i] += k * count[c].weight * creal(count[c].by_Z * behind_k_psi(p, count[c].s)) / (2. * h);
    }
    y[i] = at;
  }
  return least - p->softness * log(sum);
}
