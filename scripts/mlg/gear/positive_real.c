/* positive_real.c - passive devices by numbers without a constraint, and how well they damp; see
 * positive_real.h */
#include "positive_real.h"

#include <math.h>
#include <string.h>

#include "arguments.h"
#include "crossing.h"
#include "device_text.h"
#include "linearised.h"

enum { GUARDS = 200 };

int passive_variables(int m)
{
  return 2 * m + 2;
}

/* The variables y are numbers of either sign in units of k_psi and 100 rad/s, drawn apart: y near 0
 * is of the order of 0.01, y = 5 of 1.5. */
static double number(double y)
{
  return PASSIVE_UNIT * sinh(y);
}

/* The places of the numbers: K, then w, b, r1, r2 of each oscillator, b and r of the state of
 * frequency 0 where m is odd, and d. */
enum { PLACE_K, PLACE_FIRST };
enum { OF_W, OF_B, OF_R1, OF_R2, OF_OSCILLATOR };

struct realisation { double A[MOST_M][MOST_M], in[MOST_M], out[MOST_M], r[MOST_M], d, D; };

/* u to T in the states x alone: A = J - r r', in = b - r d, out = b + r d, D = d^2. */
static struct realisation realisation(int m, const double y[])
{
  struct realisation g = { .D = 0. };
  double b[MOST_M] = { 0. }, *const r = g.r;
  const double *at = y + PLACE_FIRST;

  for (int i = 0; i + 1 < m; i += 2, at += OF_OSCILLATOR) {
    g.A[i][i + 1] = number(at[OF_W]);
    g.A[i + 1][i] = -number(at[OF_W]);
    b[i] = number(at[OF_B]);
    r[i] = number(at[OF_R1]);
    r[i + 1] = number(at[OF_R2]);
  }
  if (m % 2) {
    b[m - 1] = number(*at++);
    r[m - 1] = number(*at++);
  }
  g.d = number(*at);
  for (int i = 0; i < m; i++) {
    for (int k = 0; k < m; k++)
      g.A[i][k] -= r[i] * r[k];
    g.in[i] = b[i] - r[i] * g.d;
    g.out[i] = b[i] + r[i] * g.d;
  }
  g.D = g.d * g.d;
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

/* K - K_least = k_psi y[PLACE_K]^2.  K + s (D + out' (s - A)^-1 in), but for D, which is c_d. */
void passive_set(struct passive *p, const double y[])
{
  const double omega = 100., unit = p->par[NUMBER_K_PSI];
  const struct realisation g = realisation(p->m, y);
  double num[MOST_M + 1], den[MOST_M + 1], scale = 1.;
  struct network Z = { .num = { { 0. } } };

  p->K = p->K_least + unit * y[PLACE_K] * y[PLACE_K];
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

/* --- the value to climb, and its slopes ---------------------------------------------------------------
 * The least of all ratios at many speeds, softened: -softness log(sum exp(-zeta/softness)), smooth and
 * below the least by the softness a few times.  Softness falls in steps, and at each the speed at which
 * the least ratio of all is, exactly, joins the others.
 *
 * A mode s is a root of F = whole + Z minor, Z of the device with k_psi (linearised.h), so that
 * ds = -minor dZ / F_s. */

/* whole and minor of a gear, by powers of V. */
struct gear_polynomials { struct poly whole[GEAR_SPEEDS], minor[GEAR_SPEEDS]; };

struct gear_at { double _Complex whole, minor, whole_s, minor_s; };

static struct gear_at gear_at(const struct gear_polynomials *g, double V, double _Complex s)
{
  struct gear_at at = { 0., 0., 0., 0. };

  for (int v = GEAR_SPEEDS - 1; v >= 0; v--) {
    at.whole = at.whole * V + poly_value(&g->whole[v], s);
    at.minor = at.minor * V + poly_value(&g->minor[v], s);
    at.whole_s = at.whole_s * V + poly_derivative(&g->whole[v], s);
    at.minor_s = at.minor_s * V + poly_derivative(&g->minor[v], s);
  }
  return at;
}

/* Solves (s - A) x = f, or z (s - A) = f, by elimination with pivots. */
static void solve(int m, const double A[MOST_M][MOST_M], int from_left, double _Complex s, const double f[], double _Complex x[])
{
  double _Complex M[MOST_M][MOST_M + 1];

  for (int i = 0; i < m; i++) {
    for (int k = 0; k < m; k++)
      M[i][k] = (i == k ? s : 0.) - (from_left ? A[k][i] : A[i][k]);
    M[i][m] = f[i];
  }
  for (int column = 0; column < m; column++) {
    int pivot = column;

    for (int i = column + 1; i < m; i++)
      if (cabs(M[i][column]) > cabs(M[pivot][column]))
        pivot = i;
    for (int k = column; k <= m; k++) {
      const double _Complex other = M[pivot][k];

      M[pivot][k] = M[column][k];
      M[column][k] = other;
    }
    for (int i = column + 1; i < m; i++) {
      const double _Complex factor = M[i][column] / M[column][column];

      for (int k = column; k <= m; k++)
        M[i][k] -= factor * M[column][k];
    }
  }
  for (int i = m - 1; i >= 0; i--) {
    x[i] = M[i][m];
    for (int k = i + 1; k < m; k++)
      x[i] -= M[i][k] * x[k];
    x[i] /= M[i][i];
  }
}

/* The stiffness with k_psi at s, and its slopes by s and by y[]. */
struct port { double _Complex Z, by_s, by[MOST_VARIABLES]; };

/* With x = (s - A)^-1 in and z = out'(s - A)^-1, dG = dD + z dA x + dout' x + z din and G_s = -z x. */
static struct port port_at(const struct passive *p, const double y[], double _Complex s)
{
  const int m = p->m, n = passive_variables(m);
  const double unit = p->par[NUMBER_K_PSI], omega = 100.;
  const double _Complex t = s / omega;
  const struct realisation g = realisation(m, y);
  double _Complex x[MOST_M], z[MOST_M], G = g.D, G_t = 0., rx = 0., zr = 0.;
  struct port at;
  int to = PLACE_FIRST;

  solve(m, g.A, 0, t, g.in, x);
  solve(m, g.A, 1, t, g.out, z);
  for (int i = 0; i < m; i++) {
    G += g.out[i] * x[i];
    G_t -= z[i] * x[i];
    rx += g.r[i] * x[i];
    zr += z[i] * g.r[i];
  }
  for (int i = 0; i < m; i += 2) {
    const int pair = i + 1 < m;

    if (pair)
      at.by[to++] = z[i] * x[i + 1] - z[i + 1] * x[i];
    at.by[to++] = x[i] + z[i];
    for (int k = i; k <= i + pair; k++)
      at.by[to++] = g.d * (x[k] - z[k]) - z[k] * rx - zr * x[k];
  }
  at.by[to] = 2. * g.d + rx - zr;

  const double _Complex device = p->K / unit + t * G, behind = 1. / (1. + device);

  for (int i = PLACE_FIRST; i < n; i++)
    at.by[i] *= t * PASSIVE_UNIT * cosh(y[i]);
  at.by[PLACE_K] = 2. * y[PLACE_K];
  for (int i = 0; i < n; i++)
    at.by[i] *= unit * behind * behind;
  at.by_s = unit * behind * behind * (G + t * G_t) / omega;
  at.Z = unit * device * behind;
  return at;
}

/* Adds weight times the slopes of the ratio of one mode. */
static void add_slopes(const struct passive *p, const double y[], const struct gear_polynomials *g, double V, double _Complex s,
                       double weight, double slope[])
{
  const double size = cabs(s);
  const struct gear_at gear = gear_at(g, V, s);
  const struct port port = port_at(p, y, s);
  const double _Complex F_s = gear.whole_s + port.by_s * gear.minor + port.Z * gear.minor_s;
  /* zeta = -Re(s)/|s|: d zeta = Re(by_s ds) */
  const double _Complex by_s = -1. / size + creal(s) * conj(s) / (size * size * size), by_Z = -by_s * gear.minor / F_s;

  for (int i = 0; i < passive_variables(p->m); i++)
    slope[i] += weight * creal(by_Z * port.by[i]);
}

/* The roots of F at one speed, in pairs once; returns their number, -1: LAPACK failed. */
static int modes_at(const struct passive *p, const struct crossing *x, double V, double _Complex s[])
{
  double re[CROSSING_TERMS], im[CROSSING_TERMS];
  const int roots = crossing_roots(x, V / x->V_unit, p->par[NUMBER_C_D] / x->c_unit, re, im);
  int n = 0;

  for (int i = 0; i < roots; i++)
    if (im[i] > 0. || (!(im[i] < 0.) && re[i] > 0.))
      s[n++] = x->omega_unit * (re[i] + I * im[i]);
  return roots < 0 ? -1 : n;
}

static double ratio_of(double _Complex s)
{
  return cimag(s) > 0. ? -creal(s) / cabs(s) : -1.;
}

double _Complex passive_mode(const struct passive *p, double V)
{
  double _Complex s[CROSSING_TERMS], least = NAN;
  double slots[MLG_SLOTS];

  libmlg_slots(p->par, slots);
  const struct crossing x = crossing_of(libmlg_find(p->layout), slots, 0.);
  const int n = modes_at(p, &x, V, s);

  for (int i = 0; i < n; i++)
    if (i == 0 || ratio_of(s[i]) < ratio_of(least))
      least = s[i];
  return least;
}

/* Beside a mode that a device holds near another, the exact answer has missed a dip over V: the
 * least of a grid counts where it is less. */
int passive_least(struct passive *p, const double y[], struct libmlg_ratio *ratio)
{
  passive_set(p, y);
  const int status = libmlg_least_ratio(p->layout, p->par, p->V_least, p->V_top, ratio);

  for (int i = 0; i < GUARDS && status == 0; i++) {
    const double V = p->V_least * pow(p->V_top / p->V_least, (double)i / (GUARDS - 1)), zeta = ratio_of(passive_mode(p, V));

    if (zeta < ratio->zeta) {
      ratio->zeta = zeta;
      ratio->V = V;
    }
  }
  return status;
}

static int is_far(int n, const double y[])
{
  for (int i = 0; i < n; i++)
    if (!(fabs(y[i]) < PASSIVE_MOST))
      return 1;
  return 0;
}

double passive_value(struct passive *p, const double y[], double slope[])
{
  static struct { double _Complex s; double zeta, V; } mode[MOST_SPEEDS * CROSSING_TERMS];
  double least = HUGE_VAL, sum = 0., slots[MLG_SLOTS];
  struct gear_polynomials g;
  const int n = passive_variables(p->m);
  int modes = 0;

  memset(slope, 0, (size_t)n * sizeof *slope);
  if (is_far(n, y))
    return -1.;
  passive_set(p, y);
  libmlg_slots(p->par, slots);
  const struct crossing x = crossing_of(libmlg_find(p->layout), slots, 0.);

  for (int k = 0; k < p->speeds; k++) {
    double _Complex s[CROSSING_TERMS];
    const int here = modes_at(p, &x, p->V[k], s);

    if (here < 0)
      return -1.;
    for (int i = 0; i < here; i++, modes++) {
      mode[modes].s = s[i];
      mode[modes].V = p->V[k];
      mode[modes].zeta = ratio_of(s[i]);
      least = fmin(least, mode[modes].zeta);
    }
  }
  if (!(least > -1.))
    return -1.;
  for (int i = 0; i < modes; i++)
    sum += exp((least - mode[i].zeta) / p->softness);
  gear_determinants(slots, g.whole, g.minor);
  for (int i = 0; i < modes; i++) {
    const double weight = exp((least - mode[i].zeta) / p->softness) / sum;

    if (weight > 1e-7)
      add_slopes(p, y, &g, mode[i].V, mode[i].s, weight, slope);
  }
  return least - p->softness * log(sum);
}

double passive_least_value(struct passive *p, const double y[], double slope[])
{
  struct libmlg_ratio ratio;

  memset(slope, 0, (size_t)passive_variables(p->m) * sizeof *slope);
  if (is_far(passive_variables(p->m), y) || passive_least(p, y, &ratio) != 0 || !(ratio.zeta > -1.))
    return -1.;
  p->speeds = 1;
  p->V[0] = ratio.V;
  p->softness = 1e-9;
  return passive_value(p, y, slope) > -1. ? ratio.zeta : -1.;
}
