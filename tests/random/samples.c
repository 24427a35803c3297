/* samples.c - the oracle's answers from samples of V alone, without its pencil */
#include "oracle.h"
#include "matrix.h"

#include <math.h>
#include <stddef.h>

static const double pi = 3.14159265358979323846;

/* Largest real part, that of the mode neutral at V = 0 over V / V_top while V is small. */
static double growth_at(const struct matrix *m, double V, double theta)
{
  double re[MOST], im[MOST], largest = -HUGE_VAL;
  int real = -1;

  if (!matrix_eigenvalues(m, V, theta, re, im))
    return NAN;
  for (int i = 0; i < m->n; i++)
    if (!(fabs(im[i]) > 0.) && (real < 0 || fabs(re[i]) < fabs(re[real])))
      real = i;
  for (int i = 0; i < m->n; i++)
    largest = fmax(largest, i == real ? re[i] / fmin(1., V / m->V_top) : re[i]);
  return largest;
}

double oracle_growth(enum oracle_layout layout, const struct oracle_gear *gear, double c_d, int steps, double *V)
{
  const struct matrix m = matrix_of(layout, gear, MOVES);
  const double theta = theta_of(&m, log(c_d / m.c_unit)), golden = (sqrt(5.) - 1.) / 2.;
  double at[3] = { 0. }, growth[3] = { 0. }, worst = -HUGE_VAL, where = 0.;

  for (int k = 0; k <= steps + 1; k++) { /* cosine spacing: closer at the ends */
    at[0] = at[1], growth[0] = growth[1];
    at[1] = at[2], growth[1] = growth[2];
    if (k <= steps) {
      at[2] = m.V_top * fmax(1e-9, (1. - cos(pi * k / steps)) / 2.);
      growth[2] = growth_at(&m, at[2], theta);
      if (growth[2] > worst)
        worst = growth[2], where = at[2];
    }
    if (k < 2 || k > steps || growth[1] < growth[0] || growth[1] < growth[2])
      continue;
    double lo = at[0], hi = at[2];

    for (int i = 0; i < 60 && hi - lo > 1e-9 * m.V_top; i++) {
      const double x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo);
      const double g1 = growth_at(&m, x1, theta), g2 = growth_at(&m, x2, theta);

      if (fmax(g1, g2) > worst)
        worst = fmax(g1, g2), where = g1 > g2 ? x1 : x2;
      if (g1 > g2)
        hi = x2;
      else
        lo = x1;
    }
  }
  if (V != NULL)
    *V = where * gear->l / m.time;
  return worst / m.time;
}

int oracle_eigenvalues(enum oracle_layout layout, const struct oracle_gear *gear, double c_d, double V,
                       double re[8], double im[8])
{
  const struct matrix m = matrix_of(layout, gear, MOVES);

  if (!matrix_eigenvalues(&m, V * m.time / gear->l, theta_of(&m, log(c_d / m.c_unit)), re, im))
    return 0;
  for (int i = 0; i < m.n; i++) {
    re[i] /= m.time;
    im[i] /= m.time;
  }
  return m.n;
}
