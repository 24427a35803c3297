/* crossing_roots.c - all crossings at one c or one V, the roots of F, and folds over t; see
 * crossing.h */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossing_parts.h"

/* --- roots of one polynomial -------------------------------------------------------------- */

int crossing_companion(const double p[], int n, double re[], double im[])
{
  double H[4 * T * T];

  memset(H, 0, (size_t)(n * n) * sizeof *H);
  for (int i = 0; i < n; i++) {
    if (i > 0)
      H[(i - 1) * n + i] = 1.; /* column by column: below the diagonal */
    H[(n - 1) * n + i] = -p[i] / p[n];
  }
  {
    double scale[2 * T], work[16 * T];
    lapack_int lo, hi;

    LAPACKE_dgebal_work(LAPACK_COL_MAJOR, 'S', n, H, n, &lo, &hi, scale);
    return LAPACKE_dhseqr_work(LAPACK_COL_MAJOR, 'E', 'N', n, lo, hi, H, n, re, im, NULL, 1, work, 16 * T);
  }
}

/* alpha eta - gamma beta, in factors: the product has lost digits. */
struct factors { double alpha[T], eta[T], gamma[T], beta[T]; };

static struct value of_factors(const struct factors *f, int n, double t)
{
  const struct value a = crossing_value(f->alpha, n, t), e = crossing_value(f->eta, n, t), g = crossing_value(f->gamma, n, t), b = crossing_value(f->beta, n, t);

  return (struct value){
    a.p * e.p - g.p * b.p,
    a.d * e.p + a.p * e.d - g.d * b.p - g.p * b.d,
    a.dd * e.p + 2. * a.d * e.d + a.p * e.dd - g.dd * b.p - 2. * g.d * b.d - g.p * b.dd,
  };
}

/* Newton's method from t, which is near a root; the root, or NaN. */
static double root_near(const struct factors *f, int n, double t)
{
  double last = INFINITY;

  for (int i = 0; i < NEWTON_STEPS; i++) {
    const struct value v = of_factors(f, n, t);
    const double step = v.p / v.d;

    if (!(fabs(step) < 0.1 * t))
      return NAN;
    if (!(fabs(step) < last))
      return fabs(step) < 1e-6 * t ? t : NAN;
    last = i > 2 ? fabs(step) : INFINITY;
    t -= step;
  }
  return t;
}

static int add_root(double root[], int n, double t)
{
  for (int i = 0; i < n; i++)
    if (fabs(root[i] / t - 1.) < 1e-12)
      return n;
  if (t > T_LEAST && t < T_MOST)
    root[n++] = t;
  return n;
}

/* The roots t > 0, refined; returns their number.  Two that lie within rounding of each
 * other may come out as a complex pair: there the parabola through the middle tells.
 * Roots far below the largest come from the reversed polynomial, whose 1/t is large. */
static int positive_roots(const struct factors *f, double root[])
{
  double p[T] = { 0. }, reversed[T], re[T], im[T];
  double largest = 0.;
  int n = 0, m;

  crossing_add_product(p, 1., f->alpha, f->eta);
  crossing_add_product(p, -1., f->gamma, f->beta);
  m = crossing_degree(p);
  for (int i = 0; i <= m; i++) {
    reversed[i] = p[m - i];
    largest = fmax(largest, fabs(p[i]));
  }
  /* no root lies below |p0| / (|p0| + largest) */
  for (int way = 0; way < (p[0] == 0. || fabs(p[0]) > 2e-8 * largest ? 1 : 2); way++) {
    if (m == 0 || crossing_companion(way ? reversed : p, m, re, im) != 0)
      return 0;
    for (int i = 0; i < m; i++) {
      const double size = re[i] * re[i] + im[i] * im[i], t = way ? re[i] / size : re[i];
      const double away = fabs(way ? im[i] / size : im[i]);

      if (way ? !(t > 0. && t < 1e-8) : !(t > 1e-9))
        continue;
      if (away <= 1e-13 * t)
        n = add_root(root, n, root_near(f, m, t));
      else if (im[i] > 0. && away < 1e-3 * t) {
        const struct value v = of_factors(f, m, t);
        const double middle = v.d / v.dd, D = middle * middle - 2. * v.p / v.dd;

        for (int side = -1; side <= 1 && D > 0.; side += 2)
          n = add_root(root, n, root_near(f, m, t - middle + side * sqrt(D)));
      }
    }
  }
  return n;
}

/* p + q times x. */
static void combined(double r[T], const double p[T], const double q[T], double x)
{
  for (int i = 0; i < T; i++)
    r[i] = p[i] + x * q[i];
}

int crossings_at_c(const struct crossing *x, double c, double V_least, double V_top, struct crossing_at out[])
{
  struct factors f;
  double t[T];
  int n = 0, roots;

  if (x->speeds > 1)
    return spin_crossings_at_c(x, c, V_least, V_top, out);
  combined(f.alpha, x->a[0][0], x->a[0][1], c);
  combined(f.gamma, x->a[1][0], x->a[1][1], c);
  combined(f.beta, x->b[0][0], x->b[0][1], c);
  combined(f.eta, x->b[1][0], x->b[1][1], c);
  roots = positive_roots(&f, t);
  for (int i = 0; i < roots; i++) {
    const struct parts at = crossing_parts(x, t[i], c);

    out[n] = (struct crossing_at){ t[i], crossing_speed(&at), c };
    if (out[n].V > V_least && out[n].V < V_top)
      n++;
  }
  return n;
}

/* The part with c^k at one V. */
static void at_speed(double r[T], const struct crossing *x, const double part[CROSSING_SPEEDS][2][T], int k, double V)
{
  for (int i = 0; i < T; i++) {
    r[i] = 0.;
    for (int v = x->speeds; v >= 0; v--)
      r[i] = r[i] * V + part[v][k][i];
  }
}

int crossings_at_V(const struct crossing *x, double V, struct crossing_at out[])
{
  struct factors f;
  double t[T];
  int n = 0, roots;

  at_speed(f.alpha, x, x->a, 0, V);
  at_speed(f.gamma, x, x->a, 1, V);
  at_speed(f.beta, x, x->b, 0, V);
  at_speed(f.eta, x, x->b, 1, V);
  if (V == 0.) { /* F(0) is 0 at V = 0 for every c: no crossing */
    memmove(f.alpha, f.alpha + 1, (T - 1) * sizeof *f.alpha);
    memmove(f.gamma, f.gamma + 1, (T - 1) * sizeof *f.gamma);
    f.alpha[T - 1] = f.gamma[T - 1] = 0.;
  }
  roots = positive_roots(&f, t);
  for (int i = 0; i < roots; i++) {
    const double alpha = crossing_value(f.alpha, T - 1, t[i]).p, gamma = crossing_value(f.gamma, T - 1, t[i]).p;
    const double beta = crossing_value(f.beta, T - 1, t[i]).p, eta = crossing_value(f.eta, T - 1, t[i]).p;

    out[n] = (struct crossing_at){ t[i], V, fabs(gamma) > fabs(eta) ? -alpha / gamma : -beta / eta };
    if (out[n].c > C_LEAST && out[n].c < C_MOST)
      n++;
  }
  return n;
}

static int rising_V(const void *a, const void *b)
{
  const double x = ((const struct crossing_at *)a)->V, y = ((const struct crossing_at *)b)->V;

  return (x > y) - (x < y);
}

static int rising_c(const void *a, const void *b)
{
  const double x = ((const struct crossing_at *)a)->c, y = ((const struct crossing_at *)b)->c;

  return (x > y) - (x < y);
}

void crossings_by_V(struct crossing_at at[], int n)
{
  qsort(at, (size_t)n, sizeof *at, rising_V);
}

void crossings_by_c(struct crossing_at at[], int n)
{
  qsort(at, (size_t)n, sizeof *at, rising_c);
}

/* Takes a root out of p[0..n], n > 1, that is far below all others, of a damper or a speed of
 * nearly 0: beside them its sign would be rounding.  0: there is none. */
static double take_small_root(double p[T], int n)
{
  double size = fabs(p[1]), root = -p[0] / p[1];

  for (int i = 2; i <= n; i++)
    size += fabs(p[i]);
  if (!(fabs(root) < 1e-6 * fabs(p[1]) / size)) /* the others are not below |p1|/size */
    return 0.;
  for (int i = 0; i < 3; i++) { /* p = 0 solved for its linear term */
    double rest = 0.;

    for (int k = n; k >= 2; k--)
      rest = rest * root + p[k];
    root = -(p[0] + rest * root * root) / p[1];
  }
  for (int i = n - 1; i >= 1; i--)
    p[i] += root * p[i + 1];
  memmove(p, p + 1, (size_t)n * sizeof *p);
  return root;
}

int crossing_roots(const struct crossing *x, double V, double c, double re[], double im[])
{
  double p[T];
  int n = x->order;

  for (int i = 0; i <= n; i++) {
    p[i] = 0.;
    for (int v = x->speeds; v >= 0; v--)
      p[i] = p[i] * V + x->F[v][0][i] + c * x->F[v][1][i];
  }
  while (n > 0 && p[n] == 0.)
    n--;
  while (n > 0 && p[0] == 0.) { /* a root that is 0 neither grows nor dies */
    memmove(p, p + 1, (size_t)n * sizeof *p);
    n--;
  }
  const double small = n > 1 ? take_small_root(p, n) : 0.;

  if (small != 0.)
    n--;
  if (n == 0 || crossing_companion(p, n, re, im) != 0)
    return -1;
  if (small != 0.) {
    re[n] = small;
    im[n++] = 0.;
  }
  return n;
}

double crossing_ratio(const struct crossing *x, double V, double c)
{
  double re[T], im[T], least = 1.;
  const int n = crossing_roots(x, V, c, re, im);

  for (int i = 0; i < n; i++) {
    const double size = hypot(re[i], im[i]);

    if (size > 0.)
      least = fmin(least, fabs(im[i]) > 0. || re[i] < 0. ? -re[i] / size : -1.);
  }
  return n < 0 ? NAN : least;
}

/* --- along t ----------------------------------------------------------------------------- */

double crossings_at_t(const struct crossing *x, double t, struct crossing_at out[2])
{
  const struct parts f = crossing_parts(x, t, 0.);
  const double A = f.alpha_c.p * f.eta_c.p - f.gamma_c.p * f.beta_c.p;
  const double B = f.alpha.p * f.eta_c.p + f.alpha_c.p * f.eta.p - f.gamma.p * f.beta_c.p - f.gamma_c.p * f.beta.p;
  const double C = f.alpha.p * f.eta.p - f.gamma.p * f.beta.p;
  const double D = B * B - 4. * A * C, root = sqrt(fmax(D, 0.));
  const int big = B > 0.; /* which one is safe from cancellation */
  const double q = big ? -B - root : -B + root;

  out[big].c = q / (2. * A);
  out[!big].c = 2. * C / q;
  for (int k = 0; k < 2; k++) {
    const struct parts at = crossing_parts(x, t, out[k].c);

    out[k].t = t;
    out[k].V = crossing_speed(&at);
  }
  return D;
}

/* Newton's method for G = G_c = 0 from t; the fold's t, or 0. */
static double fold_near(const struct crossing *x, double t)
{
  struct crossing_at at[2];
  double last = INFINITY, c;

  crossings_at_t(x, t, at);
  c = 0.5 * (at[0].c + at[1].c);
  for (int i = 0; i < NEWTON_STEPS; i++) {
    const struct parts f = crossing_parts(x, t, c);
    const struct jet_of_G j = crossing_jet(&f);
    const double cc = 2. * (f.alpha_c.p * f.eta_c.p - f.gamma_c.p * f.beta_c.p);
    const double det = j.t * cc - j.c * j.tc;
    const double dt = (j.G * cc - j.c * j.c) / det, dc = (j.t * j.c - j.G * j.tc) / det;
    const double step = fabs(dt / t) + fabs(dc / c);

    if (!(step < last) || step < 1e-15)
      return last < 1e-9 || step < 1e-15 ? t : 0.;
    last = i > 3 ? step : INFINITY;
    t -= fabs(dt) < 0.1 * t ? dt : copysign(0.1 * t, dt);
    c -= fabs(dc) < 0.5 * fabs(c) ? dc : copysign(0.5 * c, dc);
  }
  return 0.;
}

/* D in twice the terms of a crossing's polynomials. */
int crossing_folds(const struct crossing *x, double t[])
{
  double A[T], B[T], C[T], D[2 * T] = { 0. }, re[2 * T], im[2 * T];
  int m, n = 0;

  crossing_quadratic(x, A, B, C);
  for (int i = 0; i < T; i++)
    for (int j = 0; j < T; j++)
      D[i + j] += B[i] * B[j] - 4. * A[i] * C[j];
  for (m = 2 * T - 2; m > 0 && D[m] == 0.; m--)
    ;
  if (m == 0 || crossing_companion(D, m, re, im) != 0)
    return 0;
  for (int i = 0; i < m; i++)
    if (re[i] > 0. && fabs(im[i]) <= 1e-2 * re[i]) {
      const double fold = fold_near(x, re[i] + im[i]);
      int known = !(fold > 0.) || fabs(fold / re[i] - 1.) > 0.1;

      for (int k = 0; k < n && !known; k++)
        known = fabs(t[k] / fold - 1.) < 1e-10;
      if (!known)
        t[n++] = fold;
    }
  return n;
}

double crossing_sine(const struct crossing *x, const struct crossing_at *p)
{
  if (x->speeds > 1)
    return spin_sine(x, p);
  const struct parts f = crossing_parts(x, p->t, p->c);
  const double w = x->squared ? sqrt(p->t) : p->t; /* q of crossing.h */
  const double a_t = f.alpha.d + f.gamma.d * p->V, b_t = w * (f.beta.d + f.eta.d * p->V);
  const double a_V = f.gamma.p, b_V = w * f.eta.p;

  return (a_t * b_V - b_t * a_V) / (hypot(a_t, b_t) * hypot(a_V, b_V));
}
