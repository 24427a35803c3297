/* crossing_extrema.c - all boundary points, the extrema of c along the curves, from one
 * eigenvalue problem; see crossing.h */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "crossing_parts.h"

enum { MOST_SIZE = 4 * T };

int crossing_extremum_near(const struct crossing *x, struct crossing_at *p)
{
  const double from = p->t;
  double last = INFINITY;

  if (x->speeds > 1)
    return spin_extremum_near(x, p);
  for (int i = 0; i < NEWTON_STEPS; i++) {
    struct parts f = crossing_parts(x, p->t, p->c);
    const struct jet_of_G j = crossing_jet(&f);
    const double det = j.t * j.tc - j.c * j.tt;
    const double dt = (j.G * j.tc - j.c * j.t) / det, dc = (j.t * j.t - j.G * j.tt) / det;
    /* a c below a thousandth is known to as many digits as one of that: the rest is rounding */
    const double step = fabs(dt / p->t) + fabs(dc) / fmax(fabs(p->c), 1e-3);

    /* no better than before: rounding is reached, or this leads nowhere */
    if (!(step < last) || step < 1e-15) {
      p->V = crossing_speed(&f);
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

  if (n < most && isfinite(c) && c > 0. && crossing_extremum_near(x, &p) && p.c > C_LEAST && p.c < C_MOST
      && p.V > V_least && p.V < V_top && is_new(x, out, n, &p))
    out[n++] = p;
  return n;
}

/* Starts Newton's method from both roots c of G at t.  A small closed curve has its least
 * and its largest c at one t, between them D is nearly 0: there from both sides. */
static int add_extrema(const struct crossing *x, double t, double V_least, double V_top,
                       struct crossing_at out[], int n, int most)
{
  const struct parts f0 = crossing_parts(x, t, 0.);
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

void crossing_moebius(const double p[], int m, double out[])
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
 * coefficient after crossing_moebius() is the matrix at t = -1. */
int crossing_extrema(const struct crossing *x, double V_least, double V_top, struct crossing_at out[], int most)
{
  const int d = x->degree, m = d - 1, size = 4 * m;
  double G[3][T], S[2][3][T] = { { { 0. } } };  /* S[row][power of c falling][power of mu] */
  double lead[16], rest[4 * MOST_SIZE], M[MOST_SIZE * MOST_SIZE];
  double re[MOST_SIZE], im[MOST_SIZE], work[8 * MOST_SIZE];
  lapack_int pivot[4];
  int n = 0;

  if (x->speeds > 1)
    return spin_extrema(x, V_least, V_top, out, most);
  if (m < 1)
    return 0;
  crossing_quadratic(x, G[0], G[1], G[2]);
  for (int k = 0; k < 3; k++) {
    double P[T] = { 0. }, Q[T] = { 0. };

    for (int i = 0; i <= m; i++) {
      P[i] = (i + 1) * G[k][i + 1];
      Q[i] = (d - i) * G[k][i];
    }
    crossing_moebius(P, m, S[0][k]);
    crossing_moebius(Q, m, S[1][k]);
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
