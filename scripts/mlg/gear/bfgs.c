/* bfgs.c - the BFGS method with a weak line search, which needs no smooth function: A. S. Lewis and
 * M. L. Overton, "Nonsmooth optimization via quasi-Newton methods", Math. Program. 141 (2013)
 * 135-163; see bfgs.h */
#include "bfgs.h"

#include <math.h>
#include <string.h>

enum { N = BFGS_MOST, LINE_STEPS = 40 };

static double product(int n, const double a[], const double b[])
{
  double sum = 0.;

  for (int i = 0; i < n; i++)
    sum += a[i] * b[i];
  return sum;
}

/* Armijo's and Wolfe's conditions, by doubling and bisection (Algorithm 2.6); 1: a better place was
 * found. */
static int line_search(struct bfgs *f, double y[], double *value, double slope[], const double direction[])
{
  const int n = f->n;
  const double rise = product(n, slope, direction);
  double lo = 0., hi = INFINITY, t = 1., from[N], best[N], best_value = *value, best_slope[N];

  memcpy(from, y, (size_t)n * sizeof *y);
  memcpy(best, y, (size_t)n * sizeof *y);
  memcpy(best_slope, slope, (size_t)n * sizeof *slope);
  for (int i = 0; i < LINE_STEPS; i++) {
    double here[N], s[N] = { 0. };

    for (int k = 0; k < n; k++)
      here[k] = from[k] + t * direction[k];
    const double v = f->value(f->context, here, s);

    f->asked++;
    if (v > best_value) {
      best_value = v;
      memcpy(best, here, (size_t)n * sizeof *best);
      memcpy(best_slope, s, (size_t)n * sizeof *best_slope);
    }
    if (!(v > *value + 1e-4 * t * rise))
      hi = t;
    else if (product(n, s, direction) > 0.9 * rise)
      lo = t;
    else
      break;
    t = hi < INFINITY ? 0.5 * (lo + hi) : 2. * t;
  }
  const int better = best_value > *value;

  memcpy(y, best, (size_t)n * sizeof *y);
  memcpy(slope, best_slope, (size_t)n * sizeof *slope);
  *value = best_value;
  return better;
}

/* The matrix after a step s over which the slope fell by g. */
static void update(int n, double H[], const double s[], const double g[])
{
  const double sg = product(n, s, g);
  double Hg[N];

  if (!(sg > 1e-300))
    return;
  for (int i = 0; i < n; i++)
    Hg[i] = product(n, H + i * n, g);
  const double gHg = product(n, g, Hg);

  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++)
      H[i * n + k] += (1. + gHg / sg) * s[i] * s[k] / sg - (Hg[i] * s[k] + s[i] * Hg[k]) / sg;
}

double bfgs_climb(struct bfgs *f, double y[], int most)
{
  const int n = f->n;
  double H[N * N], slope[N] = { 0. }, value = f->value(f->context, y, slope);

  for (int again = 0; again < 2; again++) { /* with fresh H where it got stuck */
    const double before = value;

    for (int i = 0; i < n * n; i++)
      H[i] = i % (n + 1) == 0 ? 1. / fmax(1e-12, sqrt(product(n, slope, slope))) : 0.;
    for (int step = 0; step < most; step++) {
      double direction[N], s[N], g[N];

      for (int i = 0; i < n; i++) {
        direction[i] = product(n, H + i * n, slope);
        s[i] = -y[i];
        g[i] = slope[i];
      }
      if (!(product(n, direction, slope) > 0.) || !line_search(f, y, &value, slope, direction))
        break;
      for (int i = 0; i < n; i++) {
        s[i] += y[i];
        g[i] -= slope[i];
      }
      update(n, H, s, g);
    }
    if (!(value > before + 1e-7 * fabs(before)))
      break;
  }
  return value;
}
