/* test_criticality.c - criticality.h on an oscillator whose normal form is known
 *
 *   psi'  = -omega q + A psi (psi^2 + q^2) + g psi delta        q in the place of psi'
 *   q'    =  omega psi + A q (psi^2 + q^2) + g q delta
 *   delta' = -d delta + k (psi^2 + q^2)
 *
 * On the centre manifold delta = k r^2 / d + ..., r^2 = psi^2 + q^2: the amplitude of
 * psi obeys r' = (A + g k / d) r^3, so a = A + g k / d, whose second term comes from
 * quadratic terms alone.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "mlg.h"

enum { NDIM = GEAR_STATES };

static double A, g, k;
static const double omega = 70., d = 3.;

static int func(int ndim, const double *u, const int *icp, const double *par, int ijac, double *f,
                double *dfdu, double *dfdp)
{
  const double square = u[PSI] * u[PSI] + u[DPSI] * u[DPSI];

  (void)ndim, (void)icp, (void)par, (void)ijac, (void)dfdu, (void)dfdp;
  for (int i = 0; i < NDIM; i++)
    f[i] = -(1. + i) * u[i];
  f[DELTA] = -d * u[DELTA] + k * square;
  f[PSI] = -omega * u[DPSI] + A * u[PSI] * square + g * u[PSI] * u[DELTA];
  f[DPSI] = omega * u[PSI] + A * u[DPSI] * square + g * u[DPSI] * u[DELTA];
  return 0;
}

#include "criticality.h"

#include <cmocka.h>

#include "numbers.h"

static void is_of_the_normal_form(void **state)
{
  double par[EIGEN_SLOTS] = { 0. };

  (void)state;
  mlg_defaults(par);
  for (int i = 0; i < 200; i++) {
    double _Complex target[2];

    A = uniform(-5., 5.);
    g = uniform(-5., 5.);
    k = uniform(-5., 5.);
    assert_int_equal(eigen_critical(par, target), 1);
    assert_near(cimag(target[0]), omega, 1e-9);
    assert_near(criticality(par, target[0]), A + g * k / d, 1e-7);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = { cmocka_unit_test(is_of_the_normal_form) };

  return cmocka_run_group_tests_name("criticality", tests, NULL, NULL);
}
