/* criticality.h - is a Hopf point super- or subcritical?
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
 * derivatives of func(), by central differences of eighth order and more.
 *
 * Include it after a layout file.
 */
#ifndef CRITICALITY_H
#define CRITICALITY_H

#include "eigen.h"

/* At 1 to 5 steps on either side: the sum is even for the second derivative,
 * odd for the third; func() is 0 at 0. */
static const double second_weight[5] = { 5. / 3., -5. / 21., 5. / 126., -5. / 1008., 1. / 3150. };
static const double third_weight[5] = { -1669. / 720., 4369. / 2520., -541. / 1120., 1261. / 15120., -41. / 6048. };

/* The derivative of that order of func() at 0 along v: B(v, v) or C(v, v, v). */
static inline void derivative_along(const double par[], const double v[], int order, double out[NDIM])
{
  double ahead[NDIM], behind[NDIM], u[NDIM], h = HUGE_VAL;

  /* a hundredth of what bends the tyre's laws, atan(7 lambda / l), and the angles, and
   * of the rates that go with those; the device alone is linear */
  for (int i = 0; i < GEAR_STATES; i++) {
    const double bend = i == LAMBDA_L || i == LAMBDA_R ? par[PAR_L] / 7. : i == DDELTA || i == DPSI ? 100. : 1.;

    if (v[i] != 0.)
      h = fmin(h, bend / 100. / fabs(v[i]));
  }
  memset(out, 0, NDIM * sizeof *out);
  if (h > 1e300)
    return;
  for (int k = 5; k > 0; k--) {
    for (int i = 0; i < NDIM; i++)
      u[i] = k * h * v[i];
    func(NDIM, u, NULL, par, 0, ahead, NULL, NULL);
    for (int i = 0; i < NDIM; i++)
      u[i] = -u[i];
    func(NDIM, u, NULL, par, 0, behind, NULL, NULL);
    for (int i = 0; i < NDIM; i++)
      out[i] += order == 2 ? second_weight[k - 1] * (ahead[i] + behind[i])
                           : third_weight[k - 1] * (ahead[i] - behind[i]);
  }
  for (int i = 0; i < NDIM; i++)
    out[i] /= pow(h, order);
}

/* Adds factor * B(x, y) = (B(x+y, x+y) - B(x-y, x-y)) / 4 to out. */
static inline void add_bilinear(const double par[], const double x[], const double y[],
                                double _Complex factor, double _Complex out[NDIM])
{
  double sum[NDIM], difference[NDIM], plus[NDIM], minus[NDIM];

  for (int i = 0; i < NDIM; i++) {
    sum[i] = x[i] + y[i];
    difference[i] = x[i] - y[i];
  }
  derivative_along(par, sum, 2, plus);
  derivative_along(par, difference, 2, minus);
  for (int i = 0; i < NDIM; i++)
    out[i] += factor * (plus[i] - minus[i]) / 4.;
}

/* B(x, y) of complex vectors. */
static inline void bilinear(const double par[], const double _Complex x[], const double _Complex y[],
                            double _Complex out[NDIM])
{
  double part[2][2][NDIM]; /* real and imaginary part of x and of y */

  for (int i = 0; i < NDIM; i++) {
    part[0][0][i] = creal(x[i]), part[0][1][i] = cimag(x[i]);
    part[1][0][i] = creal(y[i]), part[1][1][i] = cimag(y[i]);
    out[i] = 0.;
  }
  for (int a = 0; a < 2; a++)
    for (int b = 0; b < 2; b++)
      add_bilinear(par, part[0][a], part[1][b], (a ? I : 1.) * (b ? I : 1.), out);
}

/* C(q, q, q*) = C(r,r,r) + C(r,s,s) + i (C(r,r,s) + C(s,s,s)), q = r + i s, from
 * C along r + s, r - s, r and s. */
static inline void trilinear(const double par[], const double _Complex q[], double _Complex out[NDIM])
{
  double v[4][NDIM], C[4][NDIM];

  for (int i = 0; i < NDIM; i++) {
    v[0][i] = creal(q[i]) + cimag(q[i]);
    v[1][i] = creal(q[i]) - cimag(q[i]);
    v[2][i] = creal(q[i]);
    v[3][i] = cimag(q[i]);
  }
  for (int k = 0; k < 4; k++)
    derivative_along(par, v[k], 3, C[k]);
  for (int i = 0; i < NDIM; i++)
    out[i] = C[2][i] + (C[0][i] + C[1][i] - 2. * C[2][i]) / 6.
             + I * ((C[0][i] - C[1][i] - 2. * C[3][i]) / 6. + C[3][i]);
}

/* x = (shift - A)^-1 rhs, in place; A by columns. */
static inline void solve_shifted(const double A[NDIM * NDIM], double _Complex shift, double _Complex rhs[NDIM])
{
  double _Complex matrix[NDIM * NDIM];
  lapack_int pivot[NDIM];

  for (int i = 0; i < NDIM * NDIM; i++)
    matrix[i] = (i % (NDIM + 1) == 0 ? shift : 0.) - A[i];
  if (LAPACKE_zgesv(LAPACK_COL_MAJOR, NDIM, 1, matrix, NDIM, pivot, rhs, NDIM) != 0) {
    fprintf(stderr, "the Jacobian is singular: are its parameters in range?\n");
    exit(1);
  }
}

/* Re G, in 1/s per rad^2, of the mode nearest to target: r is the amplitude of psi
 * in rad.  For an amplitude of delta divide by (delta/psi)^2 of the mode. */
static inline double criticality(const double par[], double _Complex target)
{
  struct eigen_mode mode = eigen_mode(par, target);
  double A[NDIM * NDIM];
  double _Complex q[NDIM], conj_q[NDIM], mean[NDIM], twice[NDIM], cubic[NDIM], from_mean[NDIM],
    from_twice[NDIM], below = 0., G = 0.;
  const double _Complex scale = 0.5 / mode.right[PSI]; /* psi = z q + c.c., amplitude |z| */

  eigen_jacobian(par, A);
  for (int i = 0; i < NDIM; i++) {
    q[i] = scale * mode.right[i];
    conj_q[i] = conj(q[i]);
    below += conj(mode.left[i]) * q[i];
  }
  bilinear(par, q, conj_q, mean);
  bilinear(par, q, q, twice);
  trilinear(par, q, cubic);
  solve_shifted(A, 0., mean); /* -A^-1 B(q, q*) */
  solve_shifted(A, 2. * I * cimag(mode.value), twice);
  bilinear(par, q, mean, from_mean);
  bilinear(par, conj_q, twice, from_twice);
  for (int i = 0; i < NDIM; i++)
    G += conj(mode.left[i]) / below * (cubic[i] + 2. * from_mean[i] + from_twice[i]) / 2.;
  return creal(G);
}

#endif
