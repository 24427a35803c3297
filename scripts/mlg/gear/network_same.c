/* network_same.c - whether two networks are one
 *
 * The dynamic stiffness of one network, k_d, k_s, c_d and b above 0, is a set of functions
 * of s.  Two networks have the same set when each function of either is one of the other: the
 * values that make it so are looked for by Newton's method on the logarithms of the values,
 * for three functions of each.
 */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "networks.h"

enum { NAMED = 4, VALUES = NAMED + 1, SAMPLES = 6, TRIES = 12, STEPS = 60 };

static const int value_slot[NAMED] = { PAR_K_D, PAR_K_S, PAR_C_D, PAR_B };

/* Behind those of the names that of one element NAME=VALUE, if there is one. */
static void set_other(struct device_text *d, double value)
{
  for (int i = 0; i < d->parts; i++)
    if (d->part[i].slot < 0 && d->part[i].text)
      d->part[i].value = value;
}

static double random_part(unsigned long long *seed)
{
  *seed = *seed * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*seed >> 11) / 9007199254740992.;
}

/* log Z at SAMPLES points of the right half plane, where it has neither zero nor pole. */
static void sample(struct device_text *d, const double logarithm[VALUES], double out[2 * SAMPLES])
{
  double par[MLG_SLOTS] = { [PAR_K_PSI] = MLG_RIGID * MLG_RIGID };
  struct network Z;

  for (int i = 0; i < NAMED; i++)
    par[value_slot[i]] = exp(logarithm[i]);
  set_other(d, exp(logarithm[NAMED]));
  Z = device_stiffness(d, par);
  for (int i = 0; i < SAMPLES; i++) {
    const double _Complex s = (0.2 + 0.3 * i) + I * (2.5 - 0.4 * i);
    const double _Complex value = clog(poly_value(&Z.num, s) / poly_value(&Z.den, s));

    out[2 * i] = creal(value);
    out[2 * i + 1] = cimag(value);
  }
}

/* Solves the normal equations J'J x = J'r of free unknowns, damped; 0: singular. */
static int solve(double A[VALUES][VALUES + 1], int n)
{
  for (int i = 0; i < n; i++) {
    for (int r = i + 1; r < n; r++)
      for (int c = n; c >= i; c--)
        A[r][c] -= A[r][i] / A[i][i] * A[i][c];
    if (!(fabs(A[i][i]) > 0.))
      return 0;
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int c = i + 1; c < n; c++)
      A[i][n] -= A[i][c] * A[c][n];
    A[i][n] /= A[i][i];
  }
  return 1;
}

static double misfit(struct device_text *d, const double x[VALUES], const double target[], double r[])
{
  double sum = 0.;

  sample(d, x, r);
  for (int i = 0; i < 2 * SAMPLES; i++) {
    r[i] -= target[i];
    sum += r[i] * r[i];
  }
  return sum;
}

/* Whether the target is a function of network d, from the values x on; those below `first`
 * are held. */
static int reaches(struct device_text *d, double x[VALUES], int first, const double target[])
{
  double r[2 * SAMPLES], size = misfit(d, x, target, r), damping = 1e-3;

  for (int step = 0; step < STEPS && size > 1e-24; step++) {
    double J[2 * SAMPLES][VALUES], A[VALUES][VALUES + 1] = { { 0. } }, next[VALUES], away[2 * SAMPLES];
    const int n = VALUES - first;

    for (int k = first; k < VALUES; k++) {
      const double at = x[k], h = 1e-6;

      x[k] = at + h;
      sample(d, x, away);
      x[k] = at - h;
      double back[2 * SAMPLES];
      sample(d, x, back);
      x[k] = at;
      for (int i = 0; i < 2 * SAMPLES; i++)
        J[i][k] = (away[i] - back[i]) / (2. * h);
    }
    for (int a = 0; a < n; a++) {
      for (int b = 0; b < n; b++)
        for (int i = 0; i < 2 * SAMPLES; i++)
          A[a][b] += J[i][first + a] * J[i][first + b];
      for (int i = 0; i < 2 * SAMPLES; i++)
        A[a][n] -= J[i][first + a] * r[i];
      A[a][a] += damping * (A[a][a] + 1e-12);
    }
    if (!solve(A, n))
      return 0;
    for (int k = 0; k < VALUES; k++)
      next[k] = x[k] + (k < first ? 0. : fmax(-2., fmin(2., A[k - first][n])));
    const double better = misfit(d, next, target, away);

    if (better < size) {
      memcpy(x, next, sizeof next);
      memcpy(r, away, sizeof away);
      size = better;
      damping *= 0.1;
    } else if ((damping *= 10.) > 1e6)
      break;
  }
  return size < 1e-18;
}

/* Whether the functions of `of`, three at random, are functions of `by`. */
static int is_within(struct device_text *of, struct device_text *by, int first)
{
  unsigned long long seed = 1;

  for (int k = 0; k < 3; k++) {
    double value[VALUES], target[2 * SAMPLES];
    int found = 0;

    for (int i = 0; i < VALUES; i++)
      value[i] = i < first ? 0. : 2. * random_part(&seed) - 1.;
    sample(of, value, target);
    for (int attempt = 0; attempt < TRIES && !found; attempt++) {
      double x[VALUES];

      for (int i = 0; i < VALUES; i++)
        x[i] = i < first ? 0. : 4. * random_part(&seed) - 2.;
      found = reaches(by, x, first, target);
    }
    if (!found)
      return 0;
  }
  return 1;
}

/* The powers of s that are in num and den, which do not hang on the values. */
static unsigned powers(struct device_text *d)
{
  double par[MLG_SLOTS] = { [PAR_K_PSI] = MLG_RIGID * MLG_RIGID, [PAR_K_D] = 1., [PAR_K_S] = 1., [PAR_C_D] = 1., [PAR_B] = 1. };

  set_other(d, 1.);
  const struct network Z = device_stiffness(d, par);
  unsigned bits = 0;

  for (int i = 0; i < POLY_TERMS; i++)
    bits |= (unsigned)(Z.num.coefficient[i] > 1e-9) << i | (unsigned)(Z.den.coefficient[i] > 1e-9) << (i + POLY_TERMS);
  return bits;
}

int network_same(struct device_text *a, struct device_text *b, int k_d_free)
{
  const int first = k_d_free ? 0 : 1;

  return powers(a) == powers(b) && is_within(a, b, first) && is_within(b, a, first);
}
