/* crossing_spin.c - crossings and extrema where F is cubic in V: wheels that spin, I_p; see
 * crossing.h
 *
 * At one c the two real polynomials a and b of F = a + i q b, cubic in V, have a common
 * root V where their Sylvester matrix is singular: a polynomial eigenvalue problem in t,
 * so the crossings are all found, as without I_p.  The extrema of c are not the
 * eigenvalues of anything small any more: from the crossings at NODES speeds, real or
 * nearly so, Newton's method on a = b = a_t b_V - a_V b_t = 0 goes to those nearby.  What
 * it misses shows where the number of crossings at two c does not fit
 * (boundary_points.c), but for a region that lies between two nodes of V whole.
 */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "crossing_parts.h"

enum { NODES = 240, MOST_ROWS = 2 * (CROSSING_SPEEDS - 1), MOST_SIZE = MOST_ROWS * T };

/* A part of F and its derivatives at one t, V and c. */
struct jet_of_part { double p, t, V, c, tt, tV, VV, tc, Vc; };

static struct jet_of_part jet_of(const struct crossing *x, const double part[CROSSING_SPEEDS][2][T], const struct crossing_at *at)
{
  const int n = x->squared ? x->order / 2 : x->order;
  struct jet_of_part j = { .p = 0. };

  for (int v = x->speeds; v >= 0; v--) { /* Horner's rule in V */
    const struct value free = crossing_value(part[v][0], n, at->t), by_c = crossing_value(part[v][1], n, at->t);

    j.VV = j.VV * at->V + 2. * j.V;
    j.tV = j.tV * at->V + j.t;
    j.Vc = j.Vc * at->V + j.c;
    j.V = j.V * at->V + j.p;
    j.p = j.p * at->V + free.p + by_c.p * at->c;
    j.t = j.t * at->V + free.d + by_c.d * at->c;
    j.tt = j.tt * at->V + free.dd + by_c.dd * at->c;
    j.c = j.c * at->V + by_c.p;
    j.tc = j.tc * at->V + by_c.d;
  }
  return j;
}

struct jets { struct jet_of_part a, b; };

static struct jets jets(const struct crossing *x, const struct crossing_at *at)
{
  return (struct jets){ jet_of(x, x->a, at), jet_of(x, x->b, at) };
}

/* --- at a point of a curve ------------------------------------------------------------ */

double spin_sine(const struct crossing *x, const struct crossing_at *p)
{
  const struct jets j = jets(x, p);
  const double w = x->squared ? sqrt(p->t) : p->t; /* q of crossing.h */

  return w * (j.a.t * j.b.V - j.b.t * j.a.V) / (hypot(j.a.t, w * j.b.t) * hypot(j.a.V, w * j.b.V));
}

double spin_slope(const struct crossing *x, const struct crossing_at *p)
{
  const struct jets j = jets(x, p);

  return -(j.a.c * j.b.t - j.b.c * j.a.t) / (j.a.V * j.b.t - j.b.V * j.a.t);
}

/* d2c/dt2 along the curve, where dc = 0 and dV/dt follows from the larger slope. */
double spin_curvature(const struct crossing *x, const struct crossing_at *p)
{
  const struct jets j = jets(x, p);
  const double dV = fabs(j.a.V) > fabs(j.b.V) ? -j.a.t / j.a.V : -j.b.t / j.b.V;
  const double a = j.a.tt + 2. * j.a.tV * dV + j.a.VV * dV * dV, b = j.b.tt + 2. * j.b.tV * dV + j.b.VV * dV * dV;

  return -(j.b.V * a - j.a.V * b) / (j.b.V * j.a.c - j.a.V * j.b.c);
}

/* --- crossings at one c --------------------------------------------------------------- */

/* Newton's method for a = b = 0 at c from the t and V of *p; 1: *p is one, to rounding. */
static int crossing_near(const struct crossing *x, struct crossing_at *p)
{
  double last = INFINITY;

  for (int i = 0; i < NEWTON_STEPS; i++) {
    const struct jets j = jets(x, p);
    const double det = j.a.t * j.b.V - j.a.V * j.b.t;
    const double dt = (j.a.p * j.b.V - j.a.V * j.b.p) / det, dV = (j.a.t * j.b.p - j.a.p * j.b.t) / det;
    const double step = fabs(dt / p->t) + fabs(dV) / (1e-3 + fabs(p->V));

    if (!(step < last) || step < 1e-15)
      return step < 1e-8 && p->t > T_LEAST && p->t < T_MOST;
    if (!(step < 0.1))
      return 0;
    last = i > 2 ? step : INFINITY;
    p->t -= dt;
    p->V -= dV;
  }
  return 0;
}

/* Whether two of them are one, found twice.  Beside an antiresonance V has 9 digits, while two
 * that are about to meet may be that near: those pass a = b = 0 the other way round. */
static int is_same_crossing(const struct crossing *x, const struct crossing_at *p, const struct crossing_at *q)
{
  return fabs(p->t / q->t - 1.) < 1e-9 && fabs(p->V / q->V - 1.) < 1e-6 && (spin_sine(x, p) > 0.) == (spin_sine(x, q) > 0.);
}

/* Adds the crossings near t: a(V) = 0 gives starts for V. */
static int add_crossings(const struct crossing *x, double t, double c, double V_least, double V_top,
                         struct crossing_at out[], int n)
{
  double p[CROSSING_SPEEDS], re[CROSSING_SPEEDS], im[CROSSING_SPEEDS];
  const int m = x->squared ? x->order / 2 : x->order;

  for (int which = 0; which < 2; which++) { /* b where a has no V in it to rounding */
    int degree = x->speeds;

    for (int v = 0; v <= x->speeds; v++)
      p[v] = crossing_value(which ? x->b[v][0] : x->a[v][0], m, t).p + c * crossing_value(which ? x->b[v][1] : x->a[v][1], m, t).p;
    while (degree > 0 && p[degree] == 0.)
      degree--;
    if (degree == 0 || crossing_companion(p, degree, re, im) != 0)
      continue;
    for (int i = 0; i < degree; i++) {
      struct crossing_at at = { t, re[i], c };
      int known = 0;

      if (fabs(im[i]) > 0.05 * fabs(re[i]) || re[i] < 0.8 * V_least || re[i] > 1.2 * V_top || !crossing_near(x, &at)
          || !(at.V > V_least && at.V < V_top))
        continue;
      for (int k = 0; k < n && !known; k++)
        known = is_same_crossing(x, &out[k], &at);
      if (!known && n < T)
        out[n++] = at;
    }
  }
  return n;
}

int spin_crossings_at_c(const struct crossing *x, double c, double V_least, double V_top, struct crossing_at out[])
{
  const int m = x->squared ? x->order / 2 : x->order, d = x->speeds, rows = 2 * d, size = rows * m;
  double S[2][CROSSING_SPEEDS][T + 1]; /* [part][power of V][power of mu] */
  double lead[MOST_ROWS * MOST_ROWS], rest[MOST_ROWS * MOST_SIZE], M[MOST_SIZE * MOST_SIZE];
  double re[MOST_SIZE], im[MOST_SIZE], work[8 * MOST_SIZE];
  lapack_int pivot[MOST_ROWS];
  int n = 0;

  for (int which = 0; which < 2; which++)
    for (int v = 0; v <= d; v++) {
      double p[T];

      for (int i = 0; i < T; i++)
        p[i] = which ? x->b[v][0][i] + c * x->b[v][1][i] : x->a[v][0][i] + c * x->a[v][1][i];
      crossing_moebius(p, m, S[which][v]);
    }
  memset(lead, 0, sizeof lead);
  memset(rest, 0, sizeof rest);
  for (int r = 0; r < rows; r++)
    for (int v = 0; v <= d; v++) { /* row r: part r / d, times V^(r % d) */
      const int column = r % d + v;

      lead[column * rows + r] = S[r / d][v][m];
      for (int i = 0; i < m; i++)
        rest[(i * rows + column) * rows + r] = -S[r / d][v][i];
    }
  if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, rows, size, lead, rows, pivot, rest, rows) != 0)
    return 0;
  memset(M, 0, (size_t)(size * size) * sizeof *M);
  for (int i = 0; i < size - rows; i++)
    M[(i + rows) * size + i] = 1.;
  for (int column = 0; column < size; column++)
    for (int r = 0; r < rows; r++)
      M[column * size + size - rows + r] = rest[column * rows + r];
  if (LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', size, M, size, re, im, NULL, 1, NULL, 1, work, 8 * MOST_SIZE) != 0)
    return 0;
  for (int i = 0; i < size; i++) {
    const double mu = re[i] + im[i]; /* two that are nearly one may come out as a pair: one on each side */

    if (fabs(mu) < 1. && fabs(im[i]) < 1e-3 * (1. - re[i] * re[i]))
      n = add_crossings(x, (1. + mu) / (1. - mu), c, V_least, V_top, out, n);
  }
  return n;
}

/* --- extrema of c --------------------------------------------------------------------- */

/* The step of Newton's method for a = b = a_t b_V - a_V b_t = 0. */
static struct crossing_at extremum_step(const struct crossing *x, const struct crossing_at *p)
{
  const struct jets j = jets(x, p);
  const struct jet_of_part *const a = &j.a, *const b = &j.b;
  const double M[3][4] = {
    { a->t, a->V, a->c, a->p },
    { b->t, b->V, b->c, b->p },
    { a->tt * b->V + a->t * b->tV - a->tV * b->t - a->V * b->tt,
      a->tV * b->V + a->t * b->VV - a->VV * b->t - a->V * b->tV,
      a->tc * b->V + a->t * b->Vc - a->Vc * b->t - a->V * b->tc, a->t * b->V - a->V * b->t },
  };
  double det[4]; /* without column k */

  for (int k = 0; k < 4; k++) {
    const int i = k > 0 ? 0 : 1, l = k > 1 ? 1 : 2, n = k > 2 ? 2 : 3;

    det[k] = M[0][i] * (M[1][l] * M[2][n] - M[1][n] * M[2][l]) - M[0][l] * (M[1][i] * M[2][n] - M[1][n] * M[2][i])
             + M[0][n] * (M[1][i] * M[2][l] - M[1][l] * M[2][i]);
  }
  return (struct crossing_at){ det[0] / det[3], -det[1] / det[3], det[2] / det[3] };
}

static void limited(double *x, double step, double most)
{
  *x -= fabs(step) < most * fabs(*x) ? step : copysign(most * *x, step);
}

int spin_extremum_near(const struct crossing *x, struct crossing_at *p)
{
  const double from = p->t;
  double last = INFINITY;

  for (int i = 0; i < NEWTON_STEPS; i++) {
    const struct crossing_at d = extremum_step(x, p);
    const double step = fabs(d.t / p->t) + fabs(d.c / p->c) + fabs(d.V / p->V);

    if (!(step < last) || step < 1e-15)
      return (last < 1e-9 || step < 1e-15) && fabs(p->t / from - 1.) < 0.3;
    last = i > 3 ? step : INFINITY;
    limited(&p->t, d.t, 0.2);
    limited(&p->V, d.V, 0.3);
    limited(&p->c, d.c, 0.5);
  }
  return 0;
}

/* From all crossings at one V, real or nearly so: Newton's method where its first step
 * does not lead past the neighbours of this V. */
static int add_extrema_near(const struct crossing *x, double V, double reach, double V_least, double V_top,
                            struct crossing_at out[], int n, int most)
{
  double f[4][T] = { { 0. } }, p[T] = { 0. }, re[T], im[T], power = 1.;

  for (int v = 0; v <= x->speeds; v++, power *= V)
    for (int i = 0; i < T; i++)
      for (int k = 0; k < 2; k++) {
        f[k][i] += power * x->a[v][k][i];
        f[2 + k][i] += power * x->b[v][k][i];
      }
  crossing_add_product(p, 1., f[0], f[3]);
  crossing_add_product(p, -1., f[1], f[2]);
  const int m = crossing_degree(p);

  if (m == 0 || crossing_companion(p, m, re, im) != 0)
    return n;
  for (int i = 0; i < m; i++) {
    struct crossing_at at = { .t = re[i] + im[i], .V = V }, step;
    double value[4];

    if (!(at.t > 1e-9) || !(fabs(im[i]) < 0.1 * re[i]))
      continue;
    for (int k = 0; k < 4; k++)
      value[k] = crossing_value(f[k], T - 1, at.t).p;
    at.c = fabs(value[1]) > fabs(value[3]) ? -value[0] / value[1] : -value[2] / value[3];
    if (!(at.c > C_LEAST && at.c < C_MOST))
      continue;
    step = extremum_step(x, &at);
    if (!(fabs(step.V) < 3. * reach) || n == most || !spin_extremum_near(x, &at) || !(at.c > C_LEAST && at.c < C_MOST)
        || !(at.V > V_least && at.V < V_top))
      continue;
    int known = 0;

    for (int k = 0; k < n && !known; k++)
      known = crossing_same(x, &out[k], &at);
    if (!known)
      out[n++] = at;
  }
  return n;
}

int spin_extrema(const struct crossing *x, double V_least, double V_top, struct crossing_at out[], int most)
{
  int n = 0;

  for (int i = 0; i < NODES; i++) { /* closer at low speeds */
    const double u = (i + 0.5) / NODES, du = 1. / NODES;

    n = add_extrema_near(x, V_least + (V_top - V_least) * u * u, 2. * u * du * (V_top - V_least), V_least, V_top, out, n, most);
  }
  return n;
}
