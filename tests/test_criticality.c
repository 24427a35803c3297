/* test_criticality.c - libmlg_normal_form on an oscillator whose normal form is known
 *
 *   psi'  = -omega q + A psi (psi^2 + q^2) + g psi delta        q in the place of psi'
 *   q'    =  omega psi + A q (psi^2 + q^2) + g q delta
 *   delta' = -d delta + k (psi^2 + q^2)
 *
 * On the centre manifold delta = k r^2 / d + ..., r^2 = psi^2 + q^2: the amplitude of
 * psi obeys r' = (A + g k / d) r^3, so a = A + g k / d, whose second term comes from
 * quadratic terms alone.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "layout.h"
#include "numbers.h"

enum { NDIM = GEAR_STATES };

static double A, g, k;
static const double omega = 70., d = 3.;

static void rates(const double par[], const double u[], double f[])
{
  const double square = u[PSI] * u[PSI] + u[DPSI] * u[DPSI];

  (void)par;
  for (int i = 0; i < NDIM; i++)
    f[i] = -(1. + i) * u[i];
  f[DELTA] = -d * u[DELTA] + k * square;
  f[PSI] = -omega * u[DPSI] + A * u[PSI] * square + g * u[PSI] * u[DELTA];
  f[DPSI] = omega * u[PSI] + A * u[DPSI] * square + g * u[DPSI] * u[DELTA];
}

/* At rest. */
static void jacobian(const double par[], const double u[], const double f[], double dfdu[], double dfdp[])
{
  (void)par, (void)u, (void)f, (void)dfdp;
  for (int i = 0; i < NDIM * NDIM; i++)
    dfdu[i] = i % (NDIM + 1) == 0 ? -(1. + i / NDIM) : 0.;
  dfdu[DELTA + NDIM * DELTA] = -d;
  dfdu[PSI + NDIM * PSI] = dfdu[DPSI + NDIM * DPSI] = 0.;
  dfdu[PSI + NDIM * DPSI] = -omega;
  dfdu[DPSI + NDIM * PSI] = omega;
}

static void is_of_the_normal_form(void **state)
{
  const struct libmlg_layout oscillator = { "oscillator", NDIM, NULL, rates, jacobian, NULL, NULL };
  double par[MLG_SLOTS] = { 0. }, a;
  struct libmlg_mode mode;

  (void)state;
  mlg_defaults(par);
  for (int i = 0; i < 200; i++) {
    A = uniform(-5., 5.);
    g = uniform(-5., 5.);
    k = uniform(-5., 5.);
    assert_int_equal(libmlg_normal_form(&oscillator, par, 60., &mode, &a), 0);
    assert_near(mode.im, omega, 1e-9);
    assert_near(a, A + g * k / d, 1e-7);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = { cmocka_unit_test(is_of_the_normal_form) };

  return cmocka_run_group_tests_name("criticality", tests, NULL, NULL);
}
