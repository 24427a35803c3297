/* crossing.c - see crossing.h */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "crossing.h"
#include "linearised.h"

enum { T = CROSSING_TERMS, MOST_SIZE = 4 * T, NEWTON_STEPS = 30 };

/* What lies below or above these, in units of struct crossing, is 0 or infinite to
 * rounding: frequencies beyond a million times the gear's own, and a damper of less
 * than 1e-7 or more than 1e9 times the usual one. */
static const double t_least = 1e-40, t_most = 1e12, c_least = 1e-7, c_most = 1e9;

/* --- F ----------------------------------------------------------------------------- */

/* Determinants of the gear without its device, whole and the minor that Z multiplies,
 * as [0] + [1] V: taken apart, not differenced, for V may have any size. */
static void determinants(const double par[], struct poly whole[2], struct poly minor[2])
{
  const struct gear_matrix g = gear_matrix(par, 0.), at_1 = gear_matrix(par, 1.);
  const struct poly tyre[2] = { g.tyre, { { at_1.tyre.coefficient[0] } } };
  const struct poly p[2] = { g.p, { { at_1.p.coefficient[0] } } };

  for (int v = 0; v < 2; v++) {
    const struct poly Ls = v ? (struct poly){ { 0. } } : g.Ls;
    const struct poly psi = poly_sum(poly_product(g.A22, tyre[v]), poly_scaled(p[v], g.D2));
    const struct poly cross = poly_sum(poly_product(g.A12, tyre[v]), poly_scaled(Ls, g.D2));
    const struct poly delta = poly_sum(poly_product(g.A22, Ls), poly_scaled(poly_product(g.A12, p[v]), -1.));

    whole[v] = poly_sum(poly_sum(poly_product(g.A11, psi), poly_scaled(poly_product(g.A12, cross), -1.)),
                        poly_scaled(delta, g.D1));
    minor[v] = poly_sum(poly_product(g.A11, tyre[v]), poly_scaled(Ls, g.D1));
  }
}

/* The device as [0] + [1] c/c_unit.  A rigid spring has no compliance at all. */
static void device(const struct libmlg_layout *layout, const double par[], double c_unit, struct network Z[2])
{
  double p[MLG_SLOTS];

  memcpy(p, par, sizeof p);
  if (p[PAR_K_S] >= MLG_RIGID)
    p[PAR_K_S] = INFINITY;
  p[PAR_C_D] = 0.;
  Z[0] = layout->network(p);
  p[PAR_C_D] = c_unit;
  Z[1] = layout->network(p);
  Z[1].num = poly_sum(Z[1].num, poly_scaled(Z[0].num, -1.));
  Z[1].den = poly_sum(Z[1].den, poly_scaled(Z[0].den, -1.));
}

static int degree_of(const double p[T])
{
  int n = T - 1;

  while (n > 0 && p[n] == 0.)
    n--;
  return n;
}

/* p * q, added to r; what would lie beyond T terms is 0 for any layout. */
static void add_product(double r[T], double sign, const double p[T], const double q[T])
{
  const int n = degree_of(p), m = degree_of(q);

  for (int i = 0; i <= n; i++)
    for (int j = 0; j <= m && i + j < T; j++)
      r[i + j] += sign * p[i] * q[j];
}

/* a + i q b on the ray from F. */
static void split(struct crossing *x)
{
  const double root = sqrt(1. - x->zeta * x->zeta);

  memset(x->a, 0, sizeof x->a);
  memset(x->b, 0, sizeof x->b);
  for (int v = 0; v < 2; v++)
    for (int k = 0; k < 2; k++) {
      double re = 1., im = 0.; /* ray^i */

      for (int i = 0; i <= x->order; i++) {
        const double next = -x->zeta * re - root * im;

        if (x->squared)
          (i % 2 ? x->b : x->a)[v][k][i / 2] = x->F[v][k][i] * (i / 2 % 2 ? -1. : 1.);
        else {
          x->a[v][k][i] = x->F[v][k][i] * re;
          if (i > 0)
            x->b[v][k][i - 1] = x->F[v][k][i] * im;
        }
        im = root * re - x->zeta * im;
        re = next;
      }
    }
}

/* G = A c^2 + B c + C. */
static void quadratic(const struct crossing *x, double A[T], double B[T], double C[T])
{
  memset(A, 0, T * sizeof *A);
  memset(B, 0, T * sizeof *B);
  memset(C, 0, T * sizeof *C);
  add_product(A, 1., x->a[0][1], x->b[1][1]);
  add_product(A, -1., x->a[1][1], x->b[0][1]);
  add_product(B, 1., x->a[0][0], x->b[1][1]);
  add_product(B, 1., x->a[0][1], x->b[1][0]);
  add_product(B, -1., x->a[1][0], x->b[0][1]);
  add_product(B, -1., x->a[1][1], x->b[0][0]);
  add_product(C, 1., x->a[0][0], x->b[1][0]);
  add_product(C, -1., x->a[1][0], x->b[0][0]);
}

struct crossing crossing_of(const struct libmlg_layout *layout, const double par[], double zeta)
{
  const struct gear_matrix g = gear_matrix(par, 0.);
  struct crossing x = { .order = 0 };
  struct poly whole[2], minor[2];
  struct network Z[2];
  double largest = 0.;

  /* between the frequencies of the two modes; of l and k_d, k_psi */
  x.omega_unit = pow(fabs(par[PAR_K_DELTA] / g.A11.coefficient[2] * par[PAR_K_PSI] / g.A22.coefficient[2]), 0.25);
  x.V_unit = x.omega_unit * par[PAR_L];
  x.c_unit = sqrt(par[PAR_K_D] * par[PAR_K_PSI]) / x.omega_unit;
  determinants(par, whole, minor);
  device(layout, par, x.c_unit, Z);
  for (int v = 0; v < 2; v++)
    for (int k = 0; k < 2; k++) {
      const struct poly f = poly_sum(poly_product(Z[k].den, whole[v]), poly_product(Z[k].num, minor[v]));
      double unit = v ? x.V_unit : 1.;

      for (int i = 0; i < POLY_TERMS; i++, unit *= x.omega_unit) {
        x.F[v][k][i] = f.coefficient[i] * unit;
        largest = fmax(largest, fabs(x.F[v][k][i]));
      }
    }
  for (int v = 0; v < 2; v++)
    for (int k = 0; k < 2; k++) {
      for (int i = 0; i < POLY_TERMS; i++)
        x.F[v][k][i] /= largest;
      if (degree_of(x.F[v][k]) > x.order)
        x.order = degree_of(x.F[v][k]);
    }
  return crossing_on(&x, zeta);
}

struct crossing crossing_on(const struct crossing *other, double zeta)
{
  struct crossing x = *other;
  double A[T], B[T], C[T];

  x.zeta = zeta;
  x.squared = zeta == 0.;
  split(&x);
  quadratic(&x, A, B, C);
  x.degree = degree_of(A);
  if (degree_of(B) > x.degree)
    x.degree = degree_of(B);
  if (degree_of(C) > x.degree)
    x.degree = degree_of(C);
  return x;
}

double crossing_omega(const struct crossing *x, double t)
{
  return x->omega_unit * (x->squared ? sqrt(t) : t);
}

/* --- values --------------------------------------------------------------------------- */

/* p, p', p'' at t. */
struct value { double p, d, dd; };

static struct value value(const double p[T], int n, double t)
{
  struct value v = { 0., 0., 0. };

  for (int i = n; i >= 0; i--) {
    v.dd = v.dd * t + 2. * v.d;
    v.d = v.d * t + v.p;
    v.p = v.p * t + p[i];
  }
  return v;
}

/* alpha = a00 + a01 c and so on, with their derivatives by t; slope: the part by c. */
struct parts { struct value alpha, gamma, beta, eta, alpha_c, gamma_c, beta_c, eta_c; };

static struct value sum(struct value p, struct value q, double c)
{
  return (struct value){ p.p + q.p * c, p.d + q.d * c, p.dd + q.dd * c };
}

static struct parts parts(const struct crossing *x, double t, double c)
{
  const int n = x->squared ? x->order / 2 : x->order;
  struct parts f = {
    .alpha_c = value(x->a[0][1], n, t), .gamma_c = value(x->a[1][1], n, t),
    .beta_c = value(x->b[0][1], n, t), .eta_c = value(x->b[1][1], n, t),
  };

  f.alpha = sum(value(x->a[0][0], n, t), f.alpha_c, c);
  f.gamma = sum(value(x->a[1][0], n, t), f.gamma_c, c);
  f.beta = sum(value(x->b[0][0], n, t), f.beta_c, c);
  f.eta = sum(value(x->b[1][0], n, t), f.eta_c, c);
  return f;
}

/* G = alpha eta - gamma beta and its derivatives, each from its factors: the expanded
 * coefficients have lost digits.  size: of the terms of G. */
struct jet_of_G { double G, t, c, tt, tc, size, size_t_; };

static struct jet_of_G jet_of_G(const struct parts *f)
{
  return (struct jet_of_G){
    .G = f->alpha.p * f->eta.p - f->gamma.p * f->beta.p,
    .t = f->alpha.d * f->eta.p + f->alpha.p * f->eta.d - f->gamma.d * f->beta.p - f->gamma.p * f->beta.d,
    .c = f->alpha_c.p * f->eta.p + f->alpha.p * f->eta_c.p - f->gamma_c.p * f->beta.p - f->gamma.p * f->beta_c.p,
    .tt = f->alpha.dd * f->eta.p + 2. * f->alpha.d * f->eta.d + f->alpha.p * f->eta.dd
          - f->gamma.dd * f->beta.p - 2. * f->gamma.d * f->beta.d - f->gamma.p * f->beta.dd,
    .tc = f->alpha_c.d * f->eta.p + f->alpha.d * f->eta_c.p + f->alpha_c.p * f->eta.d + f->alpha.p * f->eta_c.d
          - f->gamma_c.d * f->beta.p - f->gamma.d * f->beta_c.p - f->gamma_c.p * f->beta.d - f->gamma.p * f->beta_c.d,
    .size = fabs(f->alpha.p * f->eta.p) + fabs(f->gamma.p * f->beta.p),
    .size_t_ = fabs(f->alpha.d * f->eta.p) + fabs(f->alpha.p * f->eta.d) + fabs(f->gamma.d * f->beta.p)
               + fabs(f->gamma.p * f->beta.d),
  };
}

/* V from whichever of the two parts of F divides by the larger. */
static double speed(const struct parts *f)
{
  return fabs(f->gamma.p) > fabs(f->eta.p) ? -f->alpha.p / f->gamma.p : -f->beta.p / f->eta.p;
}

double crossing_curvature(const struct crossing *x, const struct crossing_at *p)
{
  const struct parts f = parts(x, p->t, p->c);
  const struct jet_of_G j = jet_of_G(&f);

  return -j.tt / j.c;
}

double crossing_slope(const struct crossing *x, const struct crossing_at *p)
{
  const struct parts f = parts(x, p->t, p->c);
  /* a = alpha + gamma V = 0 and b = beta + eta V = 0, differentiated by t and c */
  const double a_t = f.alpha.d + f.gamma.d * p->V, b_t = f.beta.d + f.eta.d * p->V;
  const double a_c = f.alpha_c.p + f.gamma_c.p * p->V, b_c = f.beta_c.p + f.eta_c.p * p->V;

  return -(a_c * b_t - b_c * a_t) / (f.gamma.p * b_t - f.eta.p * a_t);
}

/* --- roots of one polynomial -------------------------------------------------------------- */

/* Eigenvalues of the companion matrix of p[0..n], p[n] != 0; LAPACK's return value. */
static int companion_roots(const double p[], int n, double re[], double im[])
{
  double H[T * T] = { 0. };

  for (int i = 0; i < n; i++) {
    if (i > 0)
      H[(i - 1) * n + i] = 1.; /* column by column: below the diagonal */
    H[(n - 1) * n + i] = -p[i] / p[n];
  }
  {
    double scale[T], work[8 * T];
    lapack_int lo, hi;

    LAPACKE_dgebal_work(LAPACK_COL_MAJOR, 'S', n, H, n, &lo, &hi, scale);
    return LAPACKE_dhseqr_work(LAPACK_COL_MAJOR, 'E', 'N', n, lo, hi, H, n, re, im, NULL, 1, work, 8 * T);
  }
}

/* alpha eta - gamma beta, in factors: the product has lost digits. */
struct factors { double alpha[T], eta[T], gamma[T], beta[T]; };

static struct value of_factors(const struct factors *f, int n, double t)
{
  const struct value a = value(f->alpha, n, t), e = value(f->eta, n, t), g = value(f->gamma, n, t), b = value(f->beta, n, t);

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
  if (t > t_least && t < t_most)
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

  add_product(p, 1., f->alpha, f->eta);
  add_product(p, -1., f->gamma, f->beta);
  m = degree_of(p);
  for (int i = 0; i <= m; i++) {
    reversed[i] = p[m - i];
    largest = fmax(largest, fabs(p[i]));
  }
  /* no root lies below |p0| / (|p0| + largest) */
  for (int way = 0; way < (p[0] == 0. || fabs(p[0]) > 2e-8 * largest ? 1 : 2); way++) {
    if (m == 0 || companion_roots(way ? reversed : p, m, re, im) != 0)
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

  combined(f.alpha, x->a[0][0], x->a[0][1], c);
  combined(f.gamma, x->a[1][0], x->a[1][1], c);
  combined(f.beta, x->b[0][0], x->b[0][1], c);
  combined(f.eta, x->b[1][0], x->b[1][1], c);
  roots = positive_roots(&f, t);
  for (int i = 0; i < roots; i++) {
    const struct parts at = parts(x, t[i], c);

    out[n] = (struct crossing_at){ t[i], speed(&at), c };
    if (out[n].V > V_least && out[n].V < V_top)
      n++;
  }
  return n;
}

int crossings_at_V(const struct crossing *x, double V, struct crossing_at out[])
{
  struct factors f;
  double t[T];
  int n = 0, roots;

  combined(f.alpha, x->a[0][0], x->a[1][0], V);
  combined(f.gamma, x->a[0][1], x->a[1][1], V);
  combined(f.beta, x->b[0][0], x->b[1][0], V);
  combined(f.eta, x->b[0][1], x->b[1][1], V);
  if (V == 0.) { /* F(0) is 0 at V = 0 for every c: no crossing */
    memmove(f.alpha, f.alpha + 1, (T - 1) * sizeof *f.alpha);
    memmove(f.gamma, f.gamma + 1, (T - 1) * sizeof *f.gamma);
    f.alpha[T - 1] = f.gamma[T - 1] = 0.;
  }
  roots = positive_roots(&f, t);
  for (int i = 0; i < roots; i++) {
    const double alpha = value(f.alpha, T - 1, t[i]).p, gamma = value(f.gamma, T - 1, t[i]).p;
    const double beta = value(f.beta, T - 1, t[i]).p, eta = value(f.eta, T - 1, t[i]).p;

    out[n] = (struct crossing_at){ t[i], V, fabs(gamma) > fabs(eta) ? -alpha / gamma : -beta / eta };
    if (out[n].c > c_least && out[n].c < c_most)
      n++;
  }
  return n;
}

int crossing_roots(const struct crossing *x, double V, double c, double re[], double im[])
{
  double p[T];
  int n = x->order;

  for (int i = 0; i <= n; i++)
    p[i] = x->F[0][0][i] + V * x->F[1][0][i] + c * (x->F[0][1][i] + V * x->F[1][1][i]);
  while (n > 0 && p[n] == 0.)
    n--;
  return n == 0 || companion_roots(p, n, re, im) != 0 ? -1 : n;
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
  const struct parts f = parts(x, t, 0.);
  const double A = f.alpha_c.p * f.eta_c.p - f.gamma_c.p * f.beta_c.p;
  const double B = f.alpha.p * f.eta_c.p + f.alpha_c.p * f.eta.p - f.gamma.p * f.beta_c.p - f.gamma_c.p * f.beta.p;
  const double C = f.alpha.p * f.eta.p - f.gamma.p * f.beta.p;
  const double D = B * B - 4. * A * C, root = sqrt(fmax(D, 0.));
  const int big = B > 0.; /* which one is safe from cancellation */
  const double q = big ? -B - root : -B + root;

  out[big].c = q / (2. * A);
  out[!big].c = 2. * C / q;
  for (int k = 0; k < 2; k++) {
    const struct parts at = parts(x, t, out[k].c);

    out[k].t = t;
    out[k].V = speed(&at);
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
    const struct parts f = parts(x, t, c);
    const struct jet_of_G j = jet_of_G(&f);
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
  double A[T], B[T], C[T], D[2 * T] = { 0. }, re[2 * T], im[2 * T], H[4 * T * T] = { 0. }, scale[2 * T], work[16 * T];
  lapack_int lo, hi;
  int m, n = 0;

  quadratic(x, A, B, C);
  for (int i = 0; i < T; i++)
    for (int j = 0; j < T; j++)
      D[i + j] += B[i] * B[j] - 4. * A[i] * C[j];
  for (m = 2 * T - 2; m > 0 && D[m] == 0.; m--)
    ;
  for (int i = 0; i < m; i++) {
    if (i > 0)
      H[(i - 1) * m + i] = 1.;
    H[(m - 1) * m + i] = -D[i] / D[m];
  }
  LAPACKE_dgebal_work(LAPACK_COL_MAJOR, 'S', m, H, m, &lo, &hi, scale);
  if (m == 0 || LAPACKE_dhseqr_work(LAPACK_COL_MAJOR, 'E', 'N', m, lo, hi, H, m, re, im, NULL, 1, work, 16 * T) != 0)
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
  const struct parts f = parts(x, p->t, p->c);
  const double w = x->squared ? sqrt(p->t) : p->t; /* q of crossing.h */
  const double a_t = f.alpha.d + f.gamma.d * p->V, b_t = w * (f.beta.d + f.eta.d * p->V);
  const double a_V = f.gamma.p, b_V = w * f.eta.p;

  return (a_t * b_V - b_t * a_V) / (hypot(a_t, b_t) * hypot(a_V, b_V));
}

/* --- extrema ---------------------------------------------------------------------------- */

int crossing_extremum_near(const struct crossing *x, struct crossing_at *p)
{
  const double from = p->t;
  double last = INFINITY;

  for (int i = 0; i < NEWTON_STEPS; i++) {
    struct parts f = parts(x, p->t, p->c);
    const struct jet_of_G j = jet_of_G(&f);
    const double det = j.t * j.tc - j.c * j.tt;
    const double dt = (j.G * j.tc - j.c * j.t) / det, dc = (j.t * j.t - j.G * j.tt) / det;
    const double step = fabs(dt / p->t) + fabs(dc / p->c);

    /* no better than before: rounding is reached, or this leads nowhere */
    if (!(step < last) || step < 1e-15) {
      p->V = speed(&f);
      return (last < 1e-9 || step < 1e-15) && fabs(p->t / from - 1.) < 0.3;
    }
    last = i > 3 ? step : INFINITY;
    p->t -= fabs(dt) < 0.2 * p->t ? dt : copysign(0.2 * p->t, dt);
    p->c -= fabs(dc) < 0.5 * p->c ? dc : copysign(0.5 * p->c, dc);
  }
  return 0;
}

int crossing_same(const struct crossing *x, const struct crossing_at *p, const struct crossing_at *q)
{
  return fabs(p->t / q->t - 1.) < 1e-9 && fabs(p->c / q->c - 1.) < 1e-7
         && (crossing_curvature(x, p) > 0.) == (crossing_curvature(x, q) > 0.);
}

static int is_new(const struct crossing *x, const struct crossing_at out[], int n, const struct crossing_at *p)
{
  for (int i = 0; i < n; i++)
    if (crossing_same(x, &out[i], p))
      return 0;
  return 1;
}

static int add_extremum(const struct crossing *x, double t, double c, double V_least, double V_top,
                        struct crossing_at out[], int n, int most)
{
  struct crossing_at p = { .t = t, .c = c };

  if (n < most && isfinite(c) && c > 0. && crossing_extremum_near(x, &p) && p.c > c_least && p.c < c_most
      && p.V > V_least && p.V < V_top && is_new(x, out, n, &p))
    out[n++] = p;
  return n;
}

/* Starts Newton's method from both roots c of G at t.  A small closed curve has its least
 * and its largest c at one t, between them D is nearly 0: there from both sides. */
static int add_extrema(const struct crossing *x, double t, double V_least, double V_top,
                       struct crossing_at out[], int n, int most)
{
  const struct parts f0 = parts(x, t, 0.);
  const double A = f0.alpha_c.p * f0.eta_c.p - f0.gamma_c.p * f0.beta_c.p;
  const double B = f0.alpha.p * f0.eta_c.p + f0.alpha_c.p * f0.eta.p - f0.gamma.p * f0.beta_c.p - f0.gamma_c.p * f0.beta.p;
  const double C = f0.alpha.p * f0.eta.p - f0.gamma.p * f0.beta.p;
  const double D = B * B - 4. * A * C, middle = -0.5 * B / A;

  if (D > 0.) {
    const double q = -0.5 * (B + copysign(sqrt(D), B));

    n = add_extremum(x, t, q / A, V_least, V_top, out, n, most);
    n = add_extremum(x, t, C / q, V_least, V_top, out, n, most);
  }
  if (fabs(D) < 1e-5 * B * B)
    for (double away = 1e-2; away > 1e-10; away *= 0.1) {
      n = add_extremum(x, t, middle * (1. + away), V_least, V_top, out, n, most);
      n = add_extremum(x, t, middle * (1. - away), V_least, V_top, out, n, most);
    }
  else if (D < 0.)
    n = add_extremum(x, t, middle, V_least, V_top, out, n, most);
  return n;
}

/* (1 + mu)^k (1 - mu)^(m - k): t = (1 + mu)/(1 - mu) takes 0 < t < infinity to -1 < mu < 1,
 * so that no root is at infinity and none is favoured. */
static void moebius(const double p[], int m, double out[])
{
  double up[T + 1] = { 1. }; /* (1 + mu)^k, then times (1 - mu)^(m - k) */

  memset(out, 0, (size_t)(m + 1) * sizeof *out);
  for (int k = 0; k <= m; k++) {
    double term[T + 1] = { 0. };

    memcpy(term, up, (size_t)(k + 1) * sizeof *term);
    for (int j = 0; j < m - k; j++)
      for (int i = k + j + 1; i > 0; i--)
        term[i] -= term[i - 1];
    for (int i = 0; i <= m; i++)
      out[i] += p[k] * term[i];
    for (int i = k + 1; i > 0; i--)
      up[i] += up[i - 1];
  }
}

/* With G homogeneous of degree d in t and 1, G = G_t = 0 where G_t and d G - t G_t
 * vanish, both of degree m = d - 1.  As quadratics in c they share a root where their
 * Sylvester matrix is singular: eigenvalues mu of a matrix polynomial, whose leading
 * coefficient after moebius() is the matrix at t = -1. */
int crossing_extrema(const struct crossing *x, double V_least, double V_top, struct crossing_at out[], int most)
{
  const int d = x->degree, m = d - 1, size = 4 * m;
  double G[3][T], S[2][3][T] = { { { 0. } } };  /* S[row][power of c falling][power of mu] */
  double lead[16], rest[4 * MOST_SIZE], M[MOST_SIZE * MOST_SIZE];
  double re[MOST_SIZE], im[MOST_SIZE], work[8 * MOST_SIZE];
  lapack_int pivot[4];
  int n = 0;

  if (m < 1)
    return 0;
  quadratic(x, G[0], G[1], G[2]);
  for (int k = 0; k < 3; k++) {
    double P[T] = { 0. }, Q[T] = { 0. };

    for (int i = 0; i <= m; i++) {
      P[i] = (i + 1) * G[k][i + 1];
      Q[i] = (d - i) * G[k][i];
    }
    moebius(P, m, S[0][k]);
    moebius(Q, m, S[1][k]);
  }
  /* lead X = -rest, column by column */
  memset(lead, 0, sizeof lead);
  memset(rest, 0, sizeof rest);
  for (int r = 0; r < 4; r++)
    for (int k = 0; k < 3; k++) {
      const int column = r % 2 + k;

      lead[column * 4 + r] = S[r / 2][k][m];
      for (int i = 0; i < m; i++)
        rest[(i * 4 + column) * 4 + r] = -S[r / 2][k][i];
    }
  if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, 4, size, lead, 4, pivot, rest, 4) != 0)
    return 0;
  /* companion matrix: y, mu y, ..., mu^(m-1) y */
  memset(M, 0, (size_t)(size * size) * sizeof *M);
  for (int i = 0; i < size - 4; i++)
    M[(i + 4) * size + i] = 1.;
  for (int column = 0; column < size; column++)
    for (int r = 0; r < 4; r++)
      M[column * size + size - 4 + r] = rest[column * 4 + r];
  if (LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', size, M, size, re, im, NULL, 1, NULL, 1, work, 8 * MOST_SIZE) != 0)
    return 0;
  for (int i = 0; i < size; i++) {
    /* two that are nearly one may come out as a complex pair */
    const double away = hypot(re[i], im[i]) < 1. ? im[i] : INFINITY;

    if (fabs(away) < 0.02 * (1. - re[i] * re[i])) {
      const double mu = re[i] + im[i]; /* of a pair one on each side */

      if (fabs(mu) < 1.)
        n = add_extrema(x, (1. + mu) / (1. - mu), V_least, V_top, out, n, most);
    }
  }
  return n;
}
