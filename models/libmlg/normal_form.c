/* normal_form.c - is a Hopf point super- or subcritical?
 *
 * Near a Hopf point the amplitude r of the oscillation obeys
 *   r' = sigma r + a r^3,   sigma the real part of the critical eigenvalue,
 * so that shimmy of the size r^2 = -sigma / a lives where sigma and a differ in
 * sign: beside the stable gear, itself unstable, where a > 0 (subcritical).  a is
 * Re G of the normal form z' = (sigma + i omega) z + G z |z|^2 (Kuznetsov, Elements
 * of Applied Bifurcation Theory, Section 5.4):
 *
 *   G = 1/2 <p, C(q,q,q*) - 2 B(q, A^-1 B(q,q*)) + B(q*, (2 i omega - A)^-1 B(q,q))>
 *
 * A q = i omega q, p its left vector, <p, q> = 1; B and C the second and third
 * derivatives of the rates, by central differences of eighth order and more.
 */
#include <complex.h>

#include <lapacke.h>

#include "layout.h"

enum { MOST = LIBMLG_MOST_STATES };

/* At 1 to 5 steps on either side: the sum is even for the second derivative, odd for
 * the third; the rates are 0 at 0. */
static const double second_weight[5] = { 5. / 3., -5. / 21., 5. / 126., -5. / 1008., 1. / 3150. };
static const double third_weight[5] = { -1669. / 720., 4369. / 2520., -541. / 1120., 1261. / 15120., -41. / 6048. };

/* The gear at hand. */
struct gear { const struct libmlg_layout *l; const double *slots; int n; };

static int jacobian_at_rest(const struct libmlg_layout *l, const double slots[], double A[])
{
  const double rest[MOST] = { 0. };
  double f[MOST];

  l->rhs(l, slots, rest, f);
  l->jacobian(l, slots, rest, f, A, NULL);
  for (int i = 0; i < l->states * l->states; i++)
    if (!isfinite(A[i]))
      return LIBMLG_FAILED;
  return 0;
}

int libmlg_mode_near(const struct libmlg_layout *l, const double slots[], double re, double im,
                     struct libmlg_mode *mode, double _Complex right[], double _Complex left[])
{
  const int n = l->states;
  double A[MOST * MOST], wr[MOST], wi[MOST], vl[MOST * MOST], vr[MOST * MOST];
  int at = -1;

  if (jacobian_at_rest(l, slots, A) != 0
      || LAPACKE_dgeev(LAPACK_COL_MAJOR, 'V', 'V', n, A, n, wr, wi, vl, n, vr, n) != 0)
    return LIBMLG_FAILED;
  for (int i = 0; i < n; i++)
    if (wi[i] >= 0. && (at < 0 || hypot(wr[i] - re, wi[i] - im) < hypot(wr[at] - re, wi[at] - im)))
      at = i;
  *mode = (struct libmlg_mode){
    .V = slots[PAR_V], .re = wr[at], .im = wi[at], .zeta = -wr[at] / hypot(wr[at], wi[at]),
    .frequency_hz = wi[at] / (2. * MLG_PI),
  };
  double _Complex q[MOST];

  for (int i = 0; i < n; i++) { /* of a pair LAPACK gives the real and the imaginary part */
    const double *v = vr + n * at, *w = vl + n * at;

    q[i] = wi[at] > 0. ? v[i] + v[i + n] * I : v[i];
    if (left)
      left[i] = wi[at] > 0. ? w[i] + w[i + n] * I : w[i];
    if (right)
      right[i] = q[i];
  }
  mode->delta_over_psi = cabs(q[DELTA]) / cabs(q[PSI]);
  return 0;
}

/* The derivative of that order of the rates at 0 along v: B(v, v) or C(v, v, v). */
static void derivative_along(const struct gear *g, const double v[], int order, double out[])
{
  double ahead[MOST], behind[MOST], u[MOST], h = HUGE_VAL;

  /* a hundredth of what bends the tyre's laws, atan(7 lambda / l), and the angles, and
   * of the rates that go with those; the device alone is linear */
  for (int i = 0; i < GEAR_STATES; i++) {
    const double bend = i == LAMBDA_L || i == LAMBDA_R ? g->slots[PAR_L] / 7. : i == DDELTA || i == DPSI ? 100. : 1.;

    if (v[i] != 0.)
      h = fmin(h, bend / 100. / fabs(v[i]));
  }
  memset(out, 0, (size_t)g->n * sizeof *out);
  if (h > 1e300)
    return;
  for (int k = 5; k > 0; k--) {
    for (int i = 0; i < g->n; i++)
      u[i] = k * h * v[i];
    g->l->rhs(g->l, g->slots, u, ahead);
    for (int i = 0; i < g->n; i++)
      u[i] = -u[i];
    g->l->rhs(g->l, g->slots, u, behind);
    for (int i = 0; i < g->n; i++)
      out[i] += order == 2 ? second_weight[k - 1] * (ahead[i] + behind[i])
                           : third_weight[k - 1] * (ahead[i] - behind[i]);
  }
  for (int i = 0; i < g->n; i++)
    out[i] /= pow(h, order);
}

/* Adds factor * B(x, y) = (B(x+y, x+y) - B(x-y, x-y)) / 4 to out. */
static void add_bilinear(const struct gear *g, const double x[], const double y[],
                         double _Complex factor, double _Complex out[])
{
  double sum[MOST], difference[MOST], plus[MOST], minus[MOST];

  for (int i = 0; i < g->n; i++) {
    sum[i] = x[i] + y[i];
    difference[i] = x[i] - y[i];
  }
  derivative_along(g, sum, 2, plus);
  derivative_along(g, difference, 2, minus);
  for (int i = 0; i < g->n; i++)
    out[i] += factor * (plus[i] - minus[i]) / 4.;
}

/* B(x, y) of complex vectors. */
static void bilinear(const struct gear *g, const double _Complex x[], const double _Complex y[],
                     double _Complex out[])
{
  double part[2][2][MOST]; /* real and imaginary part of x and of y */

  for (int i = 0; i < g->n; i++) {
    part[0][0][i] = creal(x[i]), part[0][1][i] = cimag(x[i]);
    part[1][0][i] = creal(y[i]), part[1][1][i] = cimag(y[i]);
    out[i] = 0.;
  }
  for (int a = 0; a < 2; a++)
    for (int b = 0; b < 2; b++)
      add_bilinear(g, part[0][a], part[1][b], (a ? I : 1.) * (b ? I : 1.), out);
}

/* C(q, q, q*) = C(r,r,r) + C(r,s,s) + i (C(r,r,s) + C(s,s,s)), q = r + i s, from
 * C along r + s, r - s, r and s. */
static void trilinear(const struct gear *g, const double _Complex q[], double _Complex out[])
{
  double v[4][MOST], C[4][MOST];

  for (int i = 0; i < g->n; i++) {
    v[0][i] = creal(q[i]) + cimag(q[i]);
    v[1][i] = creal(q[i]) - cimag(q[i]);
    v[2][i] = creal(q[i]);
    v[3][i] = cimag(q[i]);
  }
  for (int k = 0; k < 4; k++)
    derivative_along(g, v[k], 3, C[k]);
  for (int i = 0; i < g->n; i++)
    out[i] = C[2][i] + (C[0][i] + C[1][i] - 2. * C[2][i]) / 6.
             + I * ((C[0][i] - C[1][i] - 2. * C[3][i]) / 6. + C[3][i]);
}

/* x = (shift - A)^-1 rhs, in place; A by columns. */
static int solve_shifted(int n, const double A[], double _Complex shift, double _Complex rhs[])
{
  double _Complex matrix[MOST * MOST];
  lapack_int pivot[MOST];

  for (int i = 0; i < n * n; i++)
    matrix[i] = (i % (n + 1) == 0 ? shift : 0.) - A[i];
  return LAPACKE_zgesv(LAPACK_COL_MAJOR, n, 1, matrix, n, pivot, rhs, n) == 0 ? 0 : LIBMLG_FAILED;
}

int libmlg_normal_form(const struct libmlg_layout *l, const double slots[], double omega,
                       struct libmlg_mode *mode, double *a)
{
  const struct gear g = { l, slots, l->states };
  double A[MOST * MOST];
  double _Complex q[MOST], p[MOST], conj_q[MOST] = { 0. }, mean[MOST], twice[MOST], cubic[MOST], from_mean[MOST],
    from_twice[MOST], below = 0., G = 0.;

  if (libmlg_mode_near(l, slots, 0., omega, mode, q, p) != 0 || jacobian_at_rest(l, slots, A) != 0)
    return LIBMLG_FAILED;
  const double _Complex scale = 0.5 / q[PSI]; /* psi = z q + c.c., amplitude |z| */

  for (int i = 0; i < g.n; i++) {
    q[i] *= scale;
    conj_q[i] = conj(q[i]);
    below += conj(p[i]) * q[i];
  }
  bilinear(&g, q, conj_q, mean);
  bilinear(&g, q, q, twice);
  trilinear(&g, q, cubic);
  if (solve_shifted(g.n, A, 0., mean) != 0 /* -A^-1 B(q, q*) */
      || solve_shifted(g.n, A, 2. * I * mode->im, twice) != 0)
    return LIBMLG_FAILED;
  bilinear(&g, q, mean, from_mean);
  bilinear(&g, conj_q, twice, from_twice);
  for (int i = 0; i < g.n; i++)
    G += conj(p[i]) / below * (cubic[i] + 2. * from_mean[i] + from_twice[i]) / 2.;
  *a = creal(G);
  return 0;
}

int libmlg_criticality(int layout, const double par[], double omega, struct libmlg_mode *mode, double *a)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  return libmlg_normal_form(l, slots, omega, mode, a);
}

/* --- double Hopf points ------------------------------------------------------------ */

/* C(q, w, w*) = C(q, r, r) + C(q, s, s), w = r + i s, and of real vectors
 * C(x, y, y) = (C along x + y + C along x - y - 2 C along x) / 6. */
static void trilinear_mixed(const struct gear *g, const double _Complex q[], const double _Complex w[],
                            double _Complex out[])
{
  double x[MOST], sum[MOST], difference[MOST], C[3][MOST];

  memset(out, 0, (size_t)g->n * sizeof *out);
  for (int a = 0; a < 2; a++)
    for (int b = 0; b < 2; b++) {
      for (int i = 0; i < g->n; i++) {
        const double y = b ? cimag(w[i]) : creal(w[i]);

        x[i] = a ? cimag(q[i]) : creal(q[i]);
        sum[i] = x[i] + y;
        difference[i] = x[i] - y;
      }
      derivative_along(g, sum, 3, C[0]);
      derivative_along(g, difference, 3, C[1]);
      derivative_along(g, x, 3, C[2]);
      for (int i = 0; i < g->n; i++)
        out[i] += (a ? I : 1.) * (C[0][i] + C[1][i] - 2. * C[2][i]) / 6.;
    }
}

/* The effect of mode w on mode q: Re <p, C(q,w,w*) + B(q,h0) + B(w,h-) + B(w*,h+)>, where
 * h0 = -A^-1 B(w,w*), h- = (i (omega - nu) - A)^-1 B(q,w*), h+ = (i (omega + nu) - A)^-1 B(q,w). */
static int cross_coefficient(const struct gear *g, const double A[], const double _Complex q[], const double _Complex p[],
                             double omega, const double _Complex w[], double nu, double *a)
{
  double _Complex conj_w[MOST], h[3][MOST], term[3][MOST], cubic[MOST], G = 0.;

  for (int i = 0; i < g->n; i++)
    conj_w[i] = conj(w[i]);
  bilinear(g, w, conj_w, h[0]);
  bilinear(g, q, conj_w, h[1]);
  bilinear(g, q, w, h[2]);
  if (solve_shifted(g->n, A, 0., h[0]) != 0 || solve_shifted(g->n, A, (omega - nu) * I, h[1]) != 0
      || solve_shifted(g->n, A, (omega + nu) * I, h[2]) != 0)
    return LIBMLG_FAILED;
  bilinear(g, q, h[0], term[0]);
  bilinear(g, w, h[1], term[1]);
  bilinear(g, conj_w, h[2], term[2]);
  trilinear_mixed(g, q, w, cubic);
  for (int i = 0; i < g->n; i++)
    G += conj(p[i]) * (cubic[i] + term[0][i] + term[1][i] + term[2][i]);
  *a = creal(G);
  return 0;
}

int libmlg_double_hopf(int layout, const double par[], const double omega[2], struct libmlg_mode mode[2], double a[2][2])
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS], A[MOST * MOST];
  double _Complex q[2][MOST], p[2][MOST];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  const struct gear g = { l, slots, l->states };

  if (jacobian_at_rest(l, slots, A) != 0)
    return LIBMLG_FAILED;
  for (int k = 0; k < 2; k++) {
    double _Complex below = 0., scale;

    if (libmlg_normal_form(l, slots, omega[k], &mode[k], &a[k][k]) != 0
        || libmlg_mode_near(l, slots, 0., omega[k], &mode[k], q[k], p[k]) != 0)
      return LIBMLG_FAILED;
    scale = 0.5 / q[k][PSI];
    if (mlg_energy_ratio(slots, mode[k].delta_over_psi) > 1.) {
      scale = 0.5 / q[k][DELTA];
      a[k][k] /= mode[k].delta_over_psi * mode[k].delta_over_psi;
    }
    for (int i = 0; i < g.n; i++) {
      q[k][i] *= scale;
      below += conj(p[k][i]) * q[k][i];
    }
    for (int i = 0; i < g.n; i++)
      p[k][i] /= conj(below);
  }
  for (int k = 0; k < 2; k++)
    if (cross_coefficient(&g, A, q[k], p[k], mode[k].im, q[1 - k], mode[1 - k].im, &a[k][1 - k]) != 0)
      return LIBMLG_FAILED;
  return 0;
}

/* <p, dA/dpar q> / <p, q>, dA/dpar by the central difference of fourth order. */
int libmlg_growth_slope(int layout, const double par[], const struct libmlg_mode *mode, int parameter,
                        double *slope)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  static const double weight[4] = { 1. / 12., -2. / 3., 2. / 3., -1. / 12. };
  double p[LIBMLG_MOST_PARAMETERS], slots[MLG_SLOTS], dA[MOST * MOST] = { 0. }, A[MOST * MOST];
  double _Complex right[MOST], left[MOST], above = 0., below = 0.;
  struct libmlg_mode same;

  if (!l || parameter < 0 || parameter >= libmlg_parameters())
    return LIBMLG_NONE;
  const double step = par[parameter] != 0. ? 1e-3 * par[parameter] : 1e-3;

  libmlg_slots_at_rest(par, slots);
  if (libmlg_mode_near(l, slots, mode->re, mode->im, &same, right, left) != 0)
    return LIBMLG_FAILED;
  for (int k = 0; k < 4; k++) {
    memcpy(p, par, (size_t)libmlg_parameters() * sizeof *p);
    p[parameter] += step * (k < 2 ? k - 2 : k - 1);
    libmlg_slots_at_rest(p, slots);
    if (jacobian_at_rest(l, slots, A) != 0)
      return LIBMLG_FAILED;
    for (int i = 0; i < l->states * l->states; i++)
      dA[i] += weight[k] / step * A[i];
  }
  for (int i = 0; i < l->states; i++) {
    for (int j = 0; j < l->states; j++)
      above += conj(left[i]) * dA[i + l->states * j] * right[j];
    below += conj(left[i]) * right[i];
  }
  *slope = creal(above / below);
  return 0;
}
