/* generalised_hopf.c - the amplitude equation to fifth order, and where its third vanishes
 *
 *   r' = sigma r + a r^3 + a_5 r^5
 *
 * beside a Hopf point.  At a generalised Hopf point (Bautin, GH) a = 0, and the sign of a_5
 * says on which side a fold of cycles begins: cycles of the size r^2 = -a / (2 a_5) fold
 * where sigma = a^2 / (4 a_5), on that part of the Hopf curve where a and a_5 differ in sign
 * (Kuznetsov, Elements of Applied Bifurcation Theory, Section 8.3).
 *
 * The centre manifold u = sum w_jk z^j z*^k, w_10 = q, w_01 = q*, on which
 * z' = i omega z + g_1 z |z|^2 + g_2 z |z|^4, obeys, order by order,
 *
 *   (i omega (j - k) - A) w_jk = N_jk - ((j-1) g_1 + (k-1) g_1*) w_(j-1)(k-1),   j + k <= 4,
 *
 * N = f(u) - A u, with g_1 from (2,1), where <p, w_21> = 0, and g_2 = <p, N_32>; a = Re g_1,
 * a_5 = Re g_2.  N_jk comes from the rates on circles |z| = r: the Fourier mode j - k there
 * over r^(j-k) is a polynomial in r^2.
 */
#include <complex.h>
#include <stdlib.h>

#include <lapacke.h>

#include "crossing.h"

enum { MOST = LIBMLG_MOST_STATES, ORDER = 5, ANGLES = 32, RADII = 7 };

struct manifold {
  const struct libmlg_layout *l;
  const double *slots;
  int n, known;                                  /* w up to the order `known` */
  double omega, reach;                           /* the largest radius, rad of psi */
  double A[MOST * MOST];
  double _Complex w[ORDER][ORDER][MOST], p[MOST], g[2];
  double _Complex mode[ORDER + 1][RADII][MOST];  /* Fourier modes of N on the circles */
};

/* The states at z, from w up to the known order. */
static void states_at(const struct manifold *m, double _Complex z, double u[])
{
  double _Complex power[ORDER] = { 1. };

  for (int j = 1; j <= m->known; j++)
    power[j] = power[j - 1] * z;
  for (int i = 0; i < m->n; i++)
    u[i] = 0.;
  for (int order = 1; order <= m->known; order++)
    for (int k = 0; k <= order; k++)
      for (int i = 0; i < m->n; i++)
        u[i] += creal(m->w[order - k][k][i] * power[order - k] * conj(power[k]));
}

static double radius(const struct manifold *m, int ring)
{
  return m->reach * (ring + 1.) / RADII;
}

/* The Fourier modes of N = f(u) - A u, for the w that are known. */
static void measure(struct manifold *m)
{
  double u[MOST], N[MOST];

  memset(m->mode, 0, sizeof m->mode);
  for (int ring = 0; ring < RADII; ring++)
    for (int angle = 0; angle < ANGLES; angle++) {
      const double theta = 2. * MLG_PI * angle / ANGLES;

      states_at(m, radius(m, ring) * cexp(I * theta), u);
      m->l->rhs(m->l, m->slots, u, N);
      for (int j = 0; j < m->n; j++)
        for (int i = 0; i < m->n; i++)
          N[i] -= m->A[i + m->n * j] * u[j];
      for (int k = 0; k <= ORDER; k++)
        for (int i = 0; i < m->n; i++)
          m->mode[k][ring][i] += N[i] * cexp(-I * k * theta) / ANGLES;
    }
}

/* N_jk, j >= k, from the modes j - k: the coefficient of r^(2k) of the polynomial in r^2
 * through all circles. */
static int coefficient(const struct manifold *m, int j, int k, double _Complex N[])
{
  double power[RADII * RADII], weight[RADII] = { 0. };
  lapack_int pivot[RADII];

  for (int row = 0; row < RADII; row++) /* the transpose of x^column at the circles, x = (r / reach)^2 */
    for (int ring = 0; ring < RADII; ring++)
      power[row + RADII * ring] = pow(radius(m, ring) / m->reach, 2. * row);
  weight[k] = 1.;
  if (LAPACKE_dgesv(LAPACK_COL_MAJOR, RADII, 1, power, RADII, pivot, weight, RADII) != 0)
    return LIBMLG_FAILED;
  for (int i = 0; i < m->n; i++) {
    N[i] = 0.;
    for (int ring = 0; ring < RADII; ring++)
      N[i] += weight[ring] * m->mode[j - k][ring][i] / pow(radius(m, ring), j - k);
    N[i] /= pow(m->reach, 2. * k);
  }
  return 0;
}

/* (shift - A) x + g q = rhs with <p, x> = 0 when `bordered`, else g = 0; x in place of rhs. */
static int solve(const struct manifold *m, double shift, int bordered, double _Complex rhs[], double _Complex *g)
{
  const int n = m->n, size = n + bordered;
  double _Complex matrix[(MOST + 1) * (MOST + 1)], right[MOST + 1];
  lapack_int pivot[MOST + 1];

  for (int j = 0; j < size; j++)
    for (int i = 0; i < size; i++)
      matrix[i + size * j] = i < n && j < n ? (i == j ? shift * I : 0.) - m->A[i + n * j]
                             : i < n ? m->w[1][0][i] : j < n ? conj(m->p[j]) : 0.;
  memcpy(right, rhs, (size_t)n * sizeof *rhs);
  right[n] = 0.;
  if (LAPACKE_zgesv(LAPACK_COL_MAJOR, size, 1, matrix, size, pivot, right, size) != 0)
    return LIBMLG_FAILED;
  memcpy(rhs, right, (size_t)n * sizeof *rhs);
  if (bordered)
    *g = right[n];
  return 0;
}

/* The w of the next order. */
static int extend(struct manifold *m)
{
  const int order = m->known + 1;

  measure(m);
  for (int k = 0; 2 * k <= order; k++) {
    const int j = order - k;
    double _Complex *w = m->w[j][k];

    if (coefficient(m, j, k, w) != 0)
      return LIBMLG_FAILED;
    for (int i = 0; i < m->n && k > 0; i++)
      w[i] -= ((j - 1) * m->g[0] + (k - 1) * conj(m->g[0])) * m->w[j - 1][k - 1][i];
    if (solve(m, m->omega * (j - k), j == k + 1, w, &m->g[0]) != 0)
      return LIBMLG_FAILED;
    for (int i = 0; i < m->n; i++)
      m->w[k][j][i] = conj(w[i]);
  }
  m->known = order;
  return 0;
}

/* q and p with psi = z q + c.c., |z| its amplitude, and how far from rest the rates are
 * sampled: an eighth of what bends the tyre's laws, atan(7 lambda / l), and the angles. */
static int begin(struct manifold *m, double omega, struct libmlg_mode *mode)
{
  const double rest[MOST] = { 0. };
  double f[MOST];
  double _Complex q[MOST], below = 0.;

  if (libmlg_mode_near(m->l, m->slots, 0., omega, mode, q, m->p) != 0)
    return LIBMLG_FAILED;
  m->l->rhs(m->l, m->slots, rest, f);
  m->l->jacobian(m->l, m->slots, rest, f, m->A, NULL);
  m->omega = mode->im;
  m->reach = HUGE_VAL;
  for (int i = 0; i < m->n; i++) {
    const double bend = i == LAMBDA_L || i == LAMBDA_R ? m->slots[PAR_L] / 7. : i == DDELTA || i == DPSI ? 100. : 1.;

    m->w[1][0][i] = 0.5 * q[i] / q[PSI];
    m->w[0][1][i] = conj(m->w[1][0][i]);
    if (i < GEAR_STATES)
      m->reach = fmin(m->reach, bend / 8. / (2. * cabs(m->w[1][0][i])));
  }
  for (int i = 0; i < m->n; i++)
    below += conj(m->p[i]) * m->w[1][0][i];
  for (int i = 0; i < m->n; i++)
    m->p[i] /= conj(below);
  m->known = 1;
  return isfinite(m->reach) && mode->im > 0. ? 0 : LIBMLG_FAILED;
}

int libmlg_fifth_order_of(const struct libmlg_layout *l, const double slots[], double omega, struct libmlg_mode *mode,
                          double *a, double *a_5)
{
  struct manifold *m = calloc(1, sizeof *m);
  double _Complex N[MOST];
  int status = m ? 0 : LIBMLG_FAILED;

  if (status == 0) {
    m->l = l, m->slots = slots, m->n = l->states;
    status = begin(m, omega, mode);
  }
  while (status == 0 && m->known < (a_5 ? ORDER - 1 : 3))
    status = extend(m);
  if (status == 0)
    *a = creal(m->g[0]);
  if (status == 0 && a_5) {
    measure(m);
    status = coefficient(m, 3, 2, N);
    for (int i = 0; i < m->n && status == 0; i++)
      m->g[1] += conj(m->p[i]) * N[i];
    *a_5 = creal(m->g[1]);
  }
  if (status == 0 && !(isfinite(*a) && isfinite(creal(m->g[1]))))
    status = LIBMLG_FAILED;
  free(m);
  return status;
}

int libmlg_fifth_order(int layout, const double par[], double omega, struct libmlg_mode *mode, double *a, double *a_5)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  return libmlg_fifth_order_of(l, slots, omega, mode, a, a_5);
}

/* --- generalised Hopf points of whole curves ------------------------------------------- */

/* A Hopf curve, whose point at the frequency t (crossing.h) is one of two roots. */
struct along { int layout, root; double par[LIBMLG_MOST_PARAMETERS]; struct crossing x; };

/* The Hopf point there, into par[], its cubic coefficient and, unless NULL, that of the fifth
 * order; NaN: it has none. */
static double cubic_at(struct along *h, double omega, double *a_5)
{
  static const char *const name[] = { "V", "c_d" };
  struct crossing_at at[2];
  struct libmlg_mode mode;
  double a;

  crossings_at_t(&h->x, omega / h->x.omega_unit * (omega / h->x.omega_unit), at);
  h->par[libmlg_parameter(name[0])] = at[h->root].V * h->x.V_unit;
  h->par[libmlg_parameter(name[1])] = at[h->root].c * h->x.c_unit;
  return libmlg_fifth_order(h->layout, h->par, omega, &mode, &a, a_5) == 0 ? a : NAN;
}

/* The point at which a passes 0 between two frequencies, where it is a_0 and a_1. */
static int refine(struct along *h, double omega_0, double omega_1, struct libmlg_generalised_hopf *gh)
{
  const int V = libmlg_parameter("V"), c_d = libmlg_parameter("c_d");
  double at[2] = { omega_0, omega_1 }, a[2], a_5 = NAN, middle, here = NAN, end_a[2];

  for (int k = 0; k < 2; k++)
    end_a[k] = a[k] = cubic_at(h, at[k], NULL);
  if (!(a[0] * a[1] < 0.)) /* to rounding 0 at an end */
    return 0;
  for (int i = 0; i < 200; i++) {
    /* the secant, and every third time the middle */
    middle = i % 3 == 2 ? 0.5 * (at[0] + at[1]) : at[0] - a[0] * (at[1] - at[0]) / (a[1] - a[0]);
    here = cubic_at(h, middle, &a_5);
    if (isnan(here))
      return 0;
    const int side = here * a[0] > 0. ? 0 : 1;

    at[side] = middle;
    a[side] = here;
    if (here == 0. || fabs(at[1] - at[0]) <= 4e-16 * fabs(middle))
      break;
  }
  if (!(fabs(here) < fmax(fabs(end_a[0]), fabs(end_a[1])))) /* it passes infinity */
    return 0;
  *gh = (struct libmlg_generalised_hopf){ .V = h->par[V], .c_d = h->par[c_d], .a_5 = a_5 };

  double par[LIBMLG_MOST_PARAMETERS], a_beside[2], V_beside[2];

  memcpy(par, h->par, sizeof par);
  for (int k = 0; k < 2; k++) {
    a_beside[k] = cubic_at(h, middle * (k ? 1. + 1e-4 : 1. - 1e-4), NULL);
    V_beside[k] = h->par[V];
  }
  gh->a_slope = (a_beside[1] - a_beside[0]) / (V_beside[1] - V_beside[0]);
  if (libmlg_criticality(h->layout, par, middle, &gh->mode, &a[0]) != 0
      || libmlg_growth_slope(h->layout, par, &gh->mode, c_d, &gh->growth_in_c_d) != 0)
    return 0;
  return 1;
}

/* All changes of sign between two frequencies; where a bends so much that it may reach 0
 * between them, in halves. */
static int between(struct along *h, double omega_0, double a_0, double omega_1, double a_1, int depth,
                   struct libmlg_generalised_hopf gh[], int most)
{
  const double middle = 0.5 * (omega_0 + omega_1), a = cubic_at(h, middle, NULL);
  const int changes = a_0 * a < 0. || a * a_1 < 0.;
  const double size = changes ? fmax(fabs(a_0), fabs(a_1)) : fmin(fabs(a), fmin(fabs(a_0), fabs(a_1)));
  int n = 0;

  if (depth < 10 && fabs(a - 0.5 * (a_0 + a_1)) > 0.25 * size) {
    n = between(h, omega_0, a_0, middle, a, depth + 1, gh, most);
    return n + between(h, middle, a, omega_1, a_1, depth + 1, gh + (n < most ? n : most), most - (n < most ? n : most));
  }
  for (int half = 0; half < 2; half++)
    if ((half ? a : a_0) * (half ? a_1 : a) < 0.) {
      struct libmlg_generalised_hopf one;

      if (refine(h, half ? middle : omega_0, half ? omega_1 : middle, &one)) {
        if (n < most)
          gh[n] = one;
        n++;
      }
    }
  return n;
}

/* Points within rounding of each other are one. */
static int without_doubles(struct libmlg_generalised_hopf gh[], int n)
{
  int kept = 0;

  for (int i = 0; i < n; i++)
    if (kept == 0 || !(fabs(gh[i].V / gh[kept - 1].V - 1.) < 1e-7 && fabs(gh[i].mode.im / gh[kept - 1].mode.im - 1.) < 1e-7))
      gh[kept++] = gh[i];
  return kept;
}

int libmlg_generalised_hopf(int layout, const double par[], const struct libmlg_plane *plane,
                            struct libmlg_generalised_hopf gh[], int most)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  struct libmlg_curve *curves;
  struct along h = { .layout = layout };
  double slots[MLG_SLOTS];
  int n = 0;
  const int known = libmlg_curves(layout, par, 0., plane, &curves);

  if (known < 0)
    return known;
  memcpy(h.par, par, (size_t)libmlg_parameters() * sizeof *par);
  libmlg_slots_at_rest(par, slots);
  h.x = crossing_of(l, slots, 0.);
  for (int c = 0; c < known; c++) {
    double before = NAN;

    for (int i = 0; i < curves[c].n; i++) {
      const struct libmlg_curve_point *p = &curves[c].point[i];

      h.root = p->root;
      const double a = cubic_at(&h, p->omega, NULL);

      if (i > 0 && p[-1].root == p->root && p[-1].omega != p->omega)
        n += between(&h, p[-1].omega, before, p->omega, a, 0, gh + (n < most ? n : most), most - (n < most ? n : most));
      before = a;
    }
  }
  libmlg_free_curves(curves, known);
  return n > most ? n : without_doubles(gh, n);
}
