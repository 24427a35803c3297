/* oracle.c - zero-shimmy intervals of c_d from dense eigenvalues
 *
 * 1. The matrix (matrix.c): A = A0 + V A1 + theta A2, theta = 1/c_d (or c_d where damper and
 *    inerter stand side by side); A1 and A2 have one row each.
 * 2. All speeds at a c_d.  Two eigenvalues of A add to 0 where A X + X A' = 0 has an
 *    antisymmetric X != 0.  V stands in the row of lambda alone, hence X but for that row
 *    and column comes from one linear solve (a Lyapunov equation without V), and what
 *    remains is a generalised eigenvalue problem P y + V Q y = 0 as long as A less one:
 *    its eigenvalues are all those speeds, real and complex.  Every Hopf point is among
 *    the real ones.  Where the wheels spin (I_p) V is in other rows, too, and the whole
 *    of A X + X A' = 0 is that problem.
 * 3. c_d has no shimmy if none of them is in 0 < V < V_top and one speed is stable.
 * 4. In between, adaptive refinement over x = ln c_d: a cell is done when a real speed
 *    within (0, V_top) plainly lasts across it (shimmy throughout), or when no speed can
 *    have reached the segment [0, V_top] of the complex plane: each moved by less than a
 *    third of its distance to it.  Else the cell is halved, down to 1e-9.  This isolates each event
 *    (two speeds that meet and become complex, a speed that leaves through an end), and goes
 *    on where a pair of complex speeds nearly touches the segment.
 * 5. The cells to start from hold, besides an even grid, what the same eigenvalue problem
 *    gives with V and theta changing places: all c_d with a Hopf point at each of some speeds,
 *    and the middles between them.  What is narrow in c_d is seen by this, what is narrow in
 *    V by 4.
 * 6. Ends: Newton's method on Re = 0 and dRe/dV = 0 of the eigenvalue of A itself.
 */
#include "oracle.h"
#include "matrix.h"

#include <complex.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

enum { PAIRS = (MOST - 1) * (MOST - 2) / 2 }; /* of all states but one */
enum { ROOTS = MOST * (MOST - 1) / 2 };        /* of all pairs of states */

static const double pi = 3.14159265358979323846;

const char *const oracle_name[ORACLE_PARAMETER_COUNT] = {
#define X(name) #name,
  ORACLE_PARAMETERS(X)
#undef X
};

const char *const oracle_layout_name[ORACLE_LAYOUTS] = { "l1", "l2", "li1", "li2", "li3", "li4", "li5", "li6", "li7" };

const char *const oracle_end_name[4] = { "fold", "V=0", "V_top", "open" };

double *oracle_at(struct oracle_gear *gear, int parameter)
{
  double *const at[ORACLE_PARAMETER_COUNT] = {
#define X(name) &gear->name,
    ORACLE_PARAMETERS(X)
#undef X
  };

  return at[parameter];
}

struct oracle_gear oracle_paper(void)
{
  return (struct oracle_gear){
    .k_s = INFINITY, .b = 0., .k_d = 1.09e5, .k_psi = 3.8e5, .c_psi = 300., .k_delta = 6.1e6, .c_delta = 300.,
    .a = 0.5, .e = 0.12, .l_delta = 0.75, .l_D = 0.72, .m_D = 500., .J_xi = 200., .J_eta = 250., .J_zeta = 100.,
    .phi = pi / 60., .h = 0.1, .k_t = 7e5, .k_alpha = 1., .k_lambda = 0.002, .l = 0.3, .R = 0.362, .g = 9.81,
    .M = 200e3 / 9.81 - 500., .V_top = 200.
  };
}

/* --- 2. where two eigenvalues add to 0 ------------------------------------------------ */

/* All values t at which two eigenvalues of A + t B add to 0, B with the row r alone, as
 * alpha / beta.  Returns how many. */
static int sums_at_zero(int n, const double A[MOST * MOST], const double B[MOST * MOST], int r,
                        double re[MOST], double im[MOST], double beta[MOST])
{
  const int N = n - 1, pairs = N * (N - 1) / 2;
  int other[MOST - 1], pair[MOST - 1][MOST - 1];
  double L[PAIRS * PAIRS] = { 0. }, Y[PAIRS * (MOST - 1)] = { 0. };
  double P[(MOST - 1) * (MOST - 1)], Q[(MOST - 1) * (MOST - 1)], work[WORK];
  lapack_int pivot[PAIRS];

  for (int i = 0, k = 0; i < n; i++)
    if (i != r)
      other[k++] = i;
  for (int i = 0, k = 0; i < N; i++) {
    pair[i][i] = -1;
    for (int j = 0; j < i; j++)
      pair[i][j] = pair[j][i] = k++;
  }
#define AT(i, j) A[other[i] + MOST * other[j]]
  /* Ao Y + Y Ao' = a y' - y a' for antisymmetric Y, a column for each component of y */
  for (int i = 0; i < N; i++)
    for (int j = 0; j < i; j++) {
      const int row = pair[i][j];

      for (int k = 0; k < N; k++) {
        if (k != j)
          L[row + PAIRS * pair[k][j]] += (k > j ? 1. : -1.) * AT(i, k);
        if (k != i)
          L[row + PAIRS * pair[i][k]] += (i > k ? 1. : -1.) * AT(j, k);
      }
      Y[row + PAIRS * j] += A[other[i] + MOST * r];
      Y[row + PAIRS * i] -= A[other[j] + MOST * r];
    }
  if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, pairs, N, L, PAIRS, pivot, Y, PAIRS) < 0)
    return 0;
  /* the rest: (Ao + alpha) y + Y b = 0, alpha and b of row r and so of degree 1 in t */
  for (int k = 0; k < N; k++)
    for (int i = 0; i < N; i++) {
      double p = AT(i, k) + (i == k ? A[r + MOST * r] : 0.), q = i == k ? B[r + MOST * r] : 0.;

      for (int j = 0; j < N; j++)
        if (j != i) {
          const double y = (i > j ? 1. : -1.) * Y[pair[i][j] + PAIRS * k];

          p += y * A[r + MOST * other[j]];
          q += y * B[r + MOST * other[j]];
        }
      P[i + (MOST - 1) * k] = p;
      Q[i + (MOST - 1) * k] = -q;
    }
#undef AT
  if (LAPACKE_dggev_work(LAPACK_COL_MAJOR, 'N', 'N', N, P, MOST - 1, Q, MOST - 1, re, im, beta,
                         NULL, 1, NULL, 1, work, WORK) != 0)
    return 0;
  return N;
}

/* The same for any B, by the pencil of A X + X A' itself, a row and a column for each pair
 * of states. */
static int all_sums_at_zero(int n, const double A[MOST * MOST], const double B[MOST * MOST],
                            double re[ROOTS], double im[ROOTS], double beta[ROOTS])
{
  int pair[MOST][MOST], pairs = 0;
  double L[2][ROOTS * ROOTS] = { { 0. } }, work[WORK];

  for (int i = 0; i < n; i++)
    for (int j = 0; j < i; j++)
      pair[i][j] = pair[j][i] = pairs++;
  for (int part = 0; part < 2; part++)
    for (int i = 0; i < n; i++)
      for (int j = 0; j < i; j++)
        for (int k = 0; k < n; k++) { /* (A X)_ij and (X A')_ij, X_kj = -X_jk */
          const double *a = part ? B : A, sign = part ? -1. : 1.;
          double *row = L[part] + pair[i][j];

          if (k != j)
            row[ROOTS * pair[k][j]] += sign * (k > j ? 1. : -1.) * a[i + MOST * k];
          if (k != i)
            row[ROOTS * pair[i][k]] += sign * (i > k ? 1. : -1.) * a[j + MOST * k];
        }
  if (LAPACKE_dggev_work(LAPACK_COL_MAJOR, 'N', 'N', pairs, L[0], ROOTS, L[1], ROOTS, re, im, beta,
                         NULL, 1, NULL, 1, work, WORK) != 0)
    return 0;
  return pairs;
}

/* --- 3. one c_d ------------------------------------------------------------------------- */

/* Speeds in units where the range of V is [-1, 1], and their distance to it on the sphere;
 * x is ln c_d in units of c_unit. */
struct node {
  double x;
  int roots, inside;        /* inside: how many are real and in the range */
  double _Complex root[ROOTS];
  double distance[ROOTS];   /* to the range; of one inside: to its ends and to the others inside */
  bool real_inside[ROOTS];
  bool shimmy;
};

static double chordal(double _Complex a, double _Complex b)
{
  const double a2 = creal(a) * creal(a) + cimag(a) * cimag(a), b2 = creal(b) * creal(b) + cimag(b) * cimag(b);

  return cabs(a - b) / sqrt((1. + a2) * (1. + b2));
}

static struct node look(const struct matrix *m, double x)
{
  struct node node = { .x = x };
  double A[MOST * MOST], re[ROOTS], im[ROOTS], beta[ROOTS];
  const double theta = theta_of(m, x), middle = m->V_top / 2.;

  matrix_at(m, 0., theta, A);
  node.roots = m->spins ? all_sums_at_zero(m->n, A, m->A1, re, im, beta)
                        : sums_at_zero(m->n, A, m->A1, LAMBDA, re, im, beta);
  for (int i = 0; i < node.roots; i++) {
    /* past 1e15 top speeds it is infinite */
    const double least = 1e-15 * hypot(re[i], im[i]) / middle, by = fabs(beta[i]) > least ? beta[i] : fmax(least, DBL_MIN);
    const double _Complex z = (re[i] / by / middle - 1.) + im[i] / by / middle * I;

    node.root[i] = z;
    node.real_inside[i] = !(fabs(im[i]) > 0.) && fabs(creal(z)) < 1.;
    node.inside += node.real_inside[i];
    node.distance[i] = chordal(z, fmax(-1., fmin(1., creal(z))));
  }
  for (int i = 0; i < node.roots; i++)
    if (node.real_inside[i]) {
      node.distance[i] = fmin(chordal(node.root[i], -1.), chordal(node.root[i], 1.));
      for (int j = 0; j < node.roots; j++)
        if (j != i && node.real_inside[j])
          node.distance[i] = fmin(node.distance[i], chordal(node.root[i], node.root[j]));
    }
  node.shimmy = node.inside > 0 || !(largest_real_part(m, middle, theta) < 0.);
  return node;
}

/* --- 4. cells of c_d ---------------------------------------------------------------------- */

static const double motion = 0.35;     /* part of its distance that a speed may move across a cell */
static const double narrowest = 1e-9;  /* cell, in ln c_d */
static const double narrow = 1e-4;     /* cell in which a lasting instability is taken for one */

/* Does each speed of a that may matter have one of b nearby, far from the range? */
static bool stays_away(const struct node *a, const struct node *b)
{
  for (int i = 0; i < a->roots; i++) {
    bool found = false;

    for (int j = 0; j < b->roots && !found; j++)
      found = chordal(a->root[i], b->root[j]) <= motion * fmin(a->distance[i], b->distance[j]);
    if (!found)
      return false;
  }
  return true;
}

/* One verdict for the whole cell? */
static bool plain(const struct node *a, const struct node *b)
{
  for (int i = 0; i < a->roots; i++)
    for (int j = 0; a->real_inside[i] && j < b->roots; j++)
      if (b->real_inside[j]
          && chordal(a->root[i], b->root[j]) <= motion * fmin(a->distance[i], b->distance[j]))
        return true;
  return a->inside == 0 && b->inside == 0 && a->shimmy == b->shimmy && stays_away(a, b) && stays_away(b, a);
}

enum { UNRESOLVED = 64 };

struct crossing { struct node node[2]; }; /* of them one shimmies, the other does not */

struct search {
  const struct matrix *m;
  int crossings, unresolved, evaluations;
  double unresolved_x[UNRESOLVED];
  struct crossing crossing[2 * ORACLE_MOST];
};

/* Shimmy throughout a narrow cell: a speed where some real part is above 0 at both of its
 * sides, and by about as much. */
static bool lasts(const struct matrix *m, const struct node *a, const struct node *b)
{
  static const double V[] = { 0.5, 0.15, 0.9, 0.05, 0.3, 0.7, 0.01, 0.99, 0.001 };

  for (size_t i = 0; i < sizeof V / sizeof *V; i++) {
    const double before = largest_real_part(m, V[i] * m->V_top, theta_of(m, a->x));

    if (before > 1e-6) {
      const double after = largest_real_part(m, V[i] * m->V_top, theta_of(m, b->x));

      if (fabs(after - before) <= motion * fmin(before, after))
        return true;
    }
  }
  return false;
}

static void halve(struct search *s, const struct node *a, const struct node *b)
{
  if (plain(a, b) || (a->shimmy && b->shimmy && b->x - a->x < narrow && lasts(s->m, a, b)))
    return;
  if (b->x - a->x > narrowest) {
    const struct node middle = look(s->m, a->x + (b->x - a->x) / 2.);

    s->evaluations++;
    halve(s, a, &middle);
    halve(s, &middle, b);
  } else if (a->shimmy != b->shimmy && s->crossings < 2 * ORACLE_MOST) {
    s->crossing[s->crossings++] = (struct crossing){ { *a, *b } };
  } else if ((a->inside == 0) == (b->inside == 0) && s->unresolved < UNRESOLVED) {
    s->unresolved_x[s->unresolved++] = a->x;
  }
}

/* --- 5. the cells to start from ------------------------------------------------------------ */

/* How far, in ln c_d, the range is carried on for a Hopf point beyond it: past 1e3 the slow
 * or fast eigenvalue of the damper drowns in rounding. */
static const double beyond = 6.9;

enum { SPEEDS = 160, SLOW = 20, EVEN = 100, FINE = 600, STARTS = EVEN + FINE + 2 + 2 * SPEEDS * (MOST - 1) };

static int by_value(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* ln c_d of all points at some speeds where two eigenvalues add to 0, in order. */
static int at_speeds(const struct matrix *m, double x[])
{
  int n = 0;

  for (int k = 0; k <= SPEEDS && m->row >= 0; k++) {
    const double V = k == 0 ? 0. : m->V_top * (k <= SLOW ? 0.02 * pow(10., -0.2 * (SLOW - k)) / 2.
                                                        : 0.01 + 0.99 * (k - SLOW) / (SPEEDS - SLOW));
    double A[MOST * MOST], re[MOST], im[MOST], beta[MOST];

    matrix_at(m, V, 0., A);
    const int roots = sums_at_zero(m->n, A, m->A2, m->row, re, im, beta);

    for (int i = 0; i < roots && n < SPEEDS * (MOST - 1); i++) {
      const double theta = re[i] / beta[i];

      if (!(fabs(im[i]) > 0.) && theta > 1e-14 && theta < 1e14)
        x[n++] = m->parallel ? log(theta) : -log(theta);
    }
  }
  qsort(x, (size_t)n, sizeof *x, by_value);
  return n;
}

/* The range of ln c_d outside which nothing happens: the damper's force is beside those of
 * the springs and the inertia as good as none, or all. */
static void natural_range(const struct matrix limit[2], double k_least, double k_most, double range[2])
{
  double slow = HUGE_VAL, fast = 0.;

  for (int k = 0; k < 2; k++) {
    double re[MOST], im[MOST];

    if (matrix_eigenvalues(&limit[k], limit[k].V_top / 2., 0., re, im))
      for (int i = 0; i < limit[k].n; i++) {
        slow = fmin(slow, fmax(1e-3, hypot(re[i], im[i])));
        fast = fmax(fast, hypot(re[i], im[i]));
      }
  }
  range[0] = log(1e-3 * k_least / fast);
  range[1] = log(1e3 * k_most / slow);
}

/* --- 6. ends ------------------------------------------------------------------------------ */

struct end { double x, V, error; enum oracle_end end; };

/* Of A at V and theta, the eigenvalue above the real axis nearest to the imaginary one, and
 * of its real part the slopes along A1 and A2.  The two-sided Rayleigh quotient of LAPACK's
 * vectors in long double gives it to the rounding of the matrix's entries, whatever the norm
 * of the others; *error: what this rounding may do to it. */
static double critical(const struct matrix *m, double V, double theta, double *along_V, double *along_theta,
                       double *error)
{
  double A[MOST * MOST], re[MOST], im[MOST], left[MOST * MOST], right[MOST * MOST], work[WORK];
  long double _Complex by_V = 0.L, by_theta = 0.L, by_0 = 0.L, product = 0.L;
  double size = 0.;
  int at = -1;

  matrix_at(m, V, theta, A);
  if (LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'V', 'V', m->n, A, MOST, re, im, left, MOST, right, MOST, work, WORK) != 0)
    return NAN;
  for (int i = 0; i < m->n; i++)
    if (im[i] > 0. && (at < 0 || fabs(re[i]) < fabs(re[at])))
      at = i;
  if (at < 0)
    return NAN;
#define VECTOR(v, i) ((long double)v[(i) + MOST * at] + (long double)v[(i) + MOST * (at + 1)] * I)
  for (int i = 0; i < m->n; i++) {
    const long double _Complex y = conjl(VECTOR(left, i));

    product += y * VECTOR(right, i);
    for (int j = 0; j < m->n; j++) {
      const long double _Complex yx = y * VECTOR(right, j);
      const double a0 = m->A0[i + MOST * j], a1 = m->A1[i + MOST * j], a2 = m->A2[i + MOST * j];

      by_0 += a0 * yx;
      by_V += a1 * yx;
      by_theta += a2 * yx;
      size += (double)cabsl(yx) * (fabs(a0) + V * fabs(a1) + theta * fabs(a2));
    }
  }
#undef VECTOR
  *along_V = (double)creall(by_V / product);
  *along_theta = (double)creall(by_theta / product);
  *error = DBL_EPSILON * size / (double)cabsl(product);
  return (double)creall((by_0 + (long double)V * by_V + (long double)theta * by_theta) / product);
}

/* The end between two nodes, to rounding. */
static struct end finish(const struct matrix *m, const struct crossing *crossing)
{
  const struct node *in = crossing->node[0].shimmy ? &crossing->node[0] : &crossing->node[1];
  const double lo = crossing->node[0].x, hi = crossing->node[1].x, middle = m->V_top / 2.;
  struct end e = { .x = (lo + hi) / 2., .error = narrowest, .end = ORACLE_FOLD, .V = NAN };
  double x = e.x, V = NAN, gap = HUGE_VAL;

  /* what vanishes here: a pair of speeds, or one at an end of the range */
  for (int i = 0; i < in->roots; i++)
    if (in->real_inside[i]) {
      const double z = creal(in->root[i]);
      const double to_end = fmin(1. + z, 1. - z);

      if (to_end < gap)
        gap = to_end, e.end = z < 0. ? ORACLE_AT_0 : ORACLE_AT_TOP, V = z < 0. ? 0. : m->V_top;
      for (int j = 0; j < i; j++)
        if (in->real_inside[j] && fabs(z - creal(in->root[j])) < gap)
          gap = fabs(z - creal(in->root[j])), e.end = ORACLE_FOLD, V = middle * (1. + (z + creal(in->root[j])) / 2.);
    }
  if (isnan(V))
    return e;
  e.V = V;
  for (int iteration = 0; iteration < 40; iteration++) {
    double along_V, along_theta, error, ignored;
    const double theta = theta_of(m, x);
    const double re = critical(m, V, theta, &along_V, &along_theta, &error);
    const double along_x = along_theta * (m->parallel ? theta : -theta);
    double dx, dV = 0.;

    if (e.end == ORACLE_FOLD) {
      const double step = 1e-4 * fmax(fmin(V, m->V_top - V), 1e-6 * m->V_top);
      double ahead, behind, ahead_theta, behind_theta;

      critical(m, V + step, theta, &ahead, &ahead_theta, &ignored);
      critical(m, V - step, theta, &behind, &behind_theta, &ignored);
      /* re + along_x dx + along_V dV = 0, along_V + (its slopes) = 0 */
      const double VV = (ahead - behind) / (2. * step);
      const double Vx = (ahead_theta - behind_theta) / (2. * step) * (m->parallel ? theta : -theta);
      const double det = along_x * VV - along_V * Vx;

      dx = (-re * VV + along_V * along_V) / det;
      dV = (-along_x * along_V + Vx * re) / det;
    } else {
      dx = -re / along_x;
    }
    e.error = error / fabs(along_x);
    if (!(fabs(dx) < 1e-3) || !(fabs(dV) < 0.1 * V + 1e-3 * m->V_top)) {
      x = NAN;
      break;
    }
    x += dx;
    V += dV;
    if (fabs(dx) <= 1e-15 * (1. + fabs(x)) || (iteration > 4 && fabs(dx) < e.error))
      break;
  }
  /* beyond its cell it is another point: the cell's middle then */
  if (x > lo - 2. * narrowest - e.error && x < hi + 2. * narrowest + e.error) {
    e.x = x;
    e.V = V;
  } else {
    e.error = narrowest;
  }
  return e;
}

/* --- all together ------------------------------------------------------------------------- */

bool oracle_diverges(enum oracle_layout layout, const struct oracle_gear *gear, double *margin)
{
  const struct matrix m = matrix_of(layout, gear, MOVES);
  double A[MOST * MOST], size = 0., product = 1.;
  lapack_int pivot[MOST];

  matrix_at(&m, m.V_top / 2., 1., A);
  for (int i = 0; i < m.n; i++) { /* rows to size 1 */
    size = 0.;
    for (int j = 0; j < m.n; j++)
      size = fmax(size, fabs(A[i + MOST * j]));
    for (int j = 0; j < m.n; j++)
      A[i + MOST * j] /= -size;
  }
  LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, m.n, m.n, A, MOST, pivot);
  for (int i = 0; i < m.n; i++)
    product *= A[i + MOST * i] * (pivot[i] == i + 1 ? 1. : -1.);
  if (margin != NULL)
    *margin = product;
  return product < 0.;
}

bool oracle_shimmy(enum oracle_layout layout, const struct oracle_gear *gear, double c_d)
{
  const struct matrix m = matrix_of(layout, gear, MOVES);

  return look(&m, log(c_d / m.c_unit)).shimmy;
}

static void to_interval(struct oracle_interval *interval, int side, const struct end *e, const struct matrix *m,
                        const struct oracle_gear *gear)
{
  interval->c[side] = e->end == ORACLE_OPEN ? (side ? INFINITY : 0.) : exp(e->x) * m->c_unit;
  interval->V[side] = e->V * gear->l / m->time;
  interval->error[side] = e->error;
  interval->end[side] = e->end;
}

/* Between the starts x[0..n-1], in order. */
static void between(struct search *s, const double x[], int n, const struct oracle_gear *gear,
                    struct oracle_answer *answer, struct node *first, struct node *last)
{
  static const struct end open = { .V = NAN, .end = ORACLE_OPEN };
  struct node left = look(s->m, x[0]);
  struct end before = open;

  s->evaluations++;
  *first = left;
  for (int i = 1; i < n; i++)
    if (x[i] - left.x > narrowest) {
      const struct node right = look(s->m, x[i]);

      s->evaluations++;
      halve(s, &left, &right);
      left = right;
    }
  *last = left;
  for (int i = 0; i <= s->crossings; i++) {
    const bool rest = i == s->crossings;
    const struct end e = rest ? open : finish(s->m, &s->crossing[i]);

    if (i > 0 && !rest)
      answer->near_miss = fmin(answer->near_miss, e.x - before.x);
    if ((rest ? !left.shimmy : s->crossing[i].node[1].shimmy) && answer->intervals < ORACLE_MOST) {
      struct oracle_interval *interval = &answer->interval[answer->intervals++];

      to_interval(interval, 0, &before, s->m, gear);
      to_interval(interval, 1, &e, s->m, gear);
    }
    before = e;
  }
  for (int i = 0; i < s->unresolved; i++) { /* beside an end it is the end's own doing */
    bool beside = i > 0 && s->unresolved_x[i] - s->unresolved_x[i - 1] < 1e-6; /* one place */

    for (int j = 0; j < s->crossings; j++)
      beside |= fabs(s->unresolved_x[i] - s->crossing[j].node[0].x) < 20. * narrowest;
    if (!beside) {
      answer->unresolved++;
      answer->unresolved_c = exp(s->unresolved_x[i]) * s->m->c_unit;
    }
  }
  answer->evaluations += s->evaluations;
}

struct oracle_answer oracle_intervals(enum oracle_layout layout, const struct oracle_gear *gear)
{
  struct oracle_answer answer = { .near_miss = HUGE_VAL };

  if ((answer.divergence = oracle_diverges(layout, gear, NULL)))
    return answer;

  const struct matrix m = matrix_of(layout, gear, MOVES);
  const struct matrix limit[2] = { matrix_of(layout, gear, FREE), matrix_of(layout, gear, LOCKED) };
  const double k_s = gear->k_s / gear->k_psi, k_d = gear->k_d / gear->k_psi;
  const bool with_k_s = layout != ORACLE_L1 && k_s < oracle_rigid;
  struct search s = { .m = &m };
  struct node first, last;
  double at[SPEEDS * (MOST - 1)], x[STARTS], range[2];
  const int found = at_speeds(&m, at);
  int n = 0;

  natural_range(limit, fmin(1., fmin(k_d, with_k_s ? k_s : 1.)), fmax(1., fmax(k_d, with_k_s ? k_s : 1.)), range);
  if (found > 0) {
    range[0] = fmin(range[0], fmax(range[0] - beyond, at[0] - 1.));
    range[1] = fmax(range[1], fmin(range[1] + beyond, at[found - 1] + 1.));
  }
  for (int i = 0; i <= EVEN; i++)
    x[n++] = range[0] + (range[1] - range[0]) * i / EVEN;
  /* where there are Hopf points it is finer; all that is found may be rounding, beyond the range */
  const double from = found > 0 ? fmax(range[0], at[0] - 1.) : range[1];
  const double to = found > 0 ? fmin(range[1], at[found - 1] + 1.) : range[0];

  for (int i = 0; i <= FINE && from < to; i++)
    x[n++] = from + (to - from) * i / FINE;
  for (int i = 0; i < found; i++) {
    if (at[i] < range[0] || at[i] > range[1])
      continue;
    x[n++] = at[i];
    if (i > 0 && at[i] - at[i - 1] > 1e-6)
      x[n++] = (at[i] + at[i - 1]) / 2.;
  }
  qsort(x, (size_t)n, sizeof *x, by_value);
  s.evaluations = SPEEDS;
  between(&s, x, n, gear, &answer, &first, &last);
  /* beyond the range: as the limits say */
  if (first.shimmy != look(&limit[0], 0.).shimmy) {
    answer.unresolved++;
    answer.unresolved_c = exp(first.x) * m.c_unit;
  }
  if (last.shimmy != look(&limit[1], 0.).shimmy) {
    answer.unresolved++;
    answer.unresolved_c = exp(last.x) * m.c_unit;
  }
  return answer;
}

struct oracle_answer oracle_examine(enum oracle_layout layout, const struct oracle_gear *gear,
                                    double c_lo, double c_hi, int steps)
{
  struct oracle_answer answer = { .near_miss = HUGE_VAL };
  struct node first, last;

  if ((answer.divergence = oracle_diverges(layout, gear, NULL)) || steps < 1)
    return answer;

  const struct matrix m = matrix_of(layout, gear, MOVES);
  const double lo = log(c_lo / m.c_unit), hi = log(c_hi / m.c_unit);
  struct search s = { .m = &m };
  double *x = malloc((size_t)(steps + 1) * sizeof *x);

  if (x == NULL)
    abort();
  for (int i = 0; i <= steps; i++)
    x[i] = lo + (hi - lo) * i / steps;
  between(&s, x, steps + 1, gear, &answer, &first, &last);
  free(x);
  for (int i = 0; i < answer.intervals; i++) { /* cut, not open */
    if (answer.interval[i].end[0] == ORACLE_OPEN)
      answer.interval[i].c[0] = c_lo;
    if (answer.interval[i].end[1] == ORACLE_OPEN)
      answer.interval[i].c[1] = c_hi;
  }
  return answer;
}
