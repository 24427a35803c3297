/* test_criticality.c - libmlg_normal_form and libmlg_fifth_order on an oscillator whose
 * normal form is known
 *
 *   psi'  = -omega q + psi (A R + D R^2 + g delta),  R = psi^2 + q^2,   q in the place of psi'
 *   q'    =  omega psi + q (A R + D R^2 + g delta)
 *   delta' = -d delta + k R + e R^2
 *
 * On the centre manifold delta = h R + H R^2 + ..., h = k / d, and with r' = (A + g h) r^3
 * from R^2: 2 h (A + g h) = -d H + e.  So the amplitude of psi obeys r' = a r^3 + a_5 r^5 with
 * a = A + g h and a_5 = D + g H, whose second terms come from terms of lower order alone.
 *
 * Rotating about the origin, it has no second or third harmonic: that these are right, another
 * variable in which it is not a circle shows, psi = x + s x^2, which leaves a and a_5 as they
 * are where a = 0, up to the scale of r, which is that of x and of psi alike.
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

static double A, D, g, k, e, s;
static const double omega = 70., d = 3.;

static void rates(const struct libmlg_layout *l, const double par[], const double u[], double f[])
{
  /* psi = x + s x^2 */
  const double x = s != 0. ? (sqrt(1. + 4. * s * u[PSI]) - 1.) / (2. * s) : u[PSI];
  const double R = x * x + u[DPSI] * u[DPSI], growth = A * R + D * R * R + g * u[DELTA];

  (void)l, (void)par;
  for (int i = 0; i < NDIM; i++)
    f[i] = -(1. + i) * u[i];
  f[DELTA] = -d * u[DELTA] + k * R + e * R * R;
  f[PSI] = (1. + 2. * s * x) * (-omega * u[DPSI] + x * growth);
  f[DPSI] = omega * x + u[DPSI] * growth;
}

/* The derivative at rest is that of the straight oscillator. */
static void jacobian(const struct libmlg_layout *l, const double par[], const double u[], const double f[], double dfdu[],
                     double dfdp[])
{
  (void)l, (void)par, (void)u, (void)f, (void)dfdp;
  for (int i = 0; i < NDIM * NDIM; i++)
    dfdu[i] = i % (NDIM + 1) == 0 ? -(1. + i / NDIM) : 0.;
  dfdu[DELTA + NDIM * DELTA] = -d;
  dfdu[PSI + NDIM * PSI] = dfdu[DPSI + NDIM * DPSI] = 0.;
  dfdu[PSI + NDIM * DPSI] = -omega;
  dfdu[DPSI + NDIM * PSI] = omega;
}

static const struct libmlg_layout oscillator = { .name = "oscillator", .states = NDIM, .rhs = rates, .jacobian = jacobian };

static void is_of_the_normal_form(void **state)
{
  double par[MLG_SLOTS] = { 0. }, a;
  struct libmlg_mode mode;

  (void)state;
  mlg_defaults(par);
  for (int i = 0; i < 200; i++) {
    A = uniform(-5., 5.);
    D = e = s = 0.;
    g = uniform(-5., 5.);
    k = uniform(-5., 5.);
    assert_int_equal(libmlg_normal_form(&oscillator, par, 60., &mode, &a), 0);
    assert_near(mode.im, omega, 1e-9);
    assert_near(a, A + g * k / d, 1e-7);
  }
}

static void fifth_order_is_of_the_normal_form(void **state)
{
  double par[MLG_SLOTS] = { 0. }, a, a_5;
  struct libmlg_mode mode;

  (void)state;
  mlg_defaults(par);
  for (int i = 0; i < 200; i++) {
    A = uniform(-5., 5.);
    D = uniform(-5., 5.);
    g = uniform(-5., 5.);
    k = uniform(-5., 5.);
    e = uniform(-5., 5.);
    s = 0.;
    const double h = k / d, H = (e - 2. * h * (A + g * h)) / d;

    assert_int_equal(libmlg_fifth_order_of(&oscillator, par, 60., &mode, &a, &a_5), 0);
    assert_near(a, A + g * h, 1e-9);
    assert_near(a_5, D + g * H, 1e-7);

    A = -g * h; /* a = 0, and harmonics */
    s = uniform(-0.2, 0.2); /* the rates bend at psi = 1 / (4 s), as those of the gear at 1 */
    assert_int_equal(libmlg_fifth_order_of(&oscillator, par, 60., &mode, &a, &a_5), 0);
    assert_near(a, 0., 1e-8);
    assert_near(a_5, D + g * e / d, 5e-6);
  }
  s = 0.;
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(is_of_the_normal_form),
    cmocka_unit_test(fifth_order_is_of_the_normal_form),
  };

  return cmocka_run_group_tests_name("criticality", tests, NULL, NULL);
}
