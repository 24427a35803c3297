/* test_integrate.c - tests of libmlg_run_to: known solutions, events, restarts
 *
 * With k_alpha = k_lambda = 0 the tyres exert no lateral force: a gear that
 * starts straight stays so, and its tyres relax as lambda = lambda_0 exp(-V t/l),
 * passing |alpha| = alpha_m at a known time.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "libmlg.h"
#include "mlg.h"
#include "numbers.h"

enum { EPS = GEAR_STATES, NDIM }; /* of layout L1 */

/* Numbers of the parameters in libmlg. */
enum {
#define X(slot, id, name, unit, value, least, most, meaning) AT_##id,
  MLG_PARAMETERS(X)
#undef X
};

static struct libmlg_run run;
static double par[LIBMLG_MOST_PARAMETERS];
static int l1;

static int begin(void **state)
{
  (void)state;
  l1 = libmlg_layout("l1");
  assert_int_equal(libmlg_states(l1), NDIM);
  libmlg_defaults(par);
  par[AT_V] = 20.;
  return libmlg_run_begin(&run, l1, 1e-10);
}

static int end(void **state)
{
  (void)state;
  libmlg_run_end(&run);
  return 0;
}

static void start(double psi)
{
  const double u[NDIM] = { [PSI] = psi };

  libmlg_run_start(&run, par, u);
}

static int mirror(int i)
{
  return i == LAMBDA_L ? LAMBDA_R : i == LAMBDA_R ? LAMBDA_L : i;
}

static void tyres_relax(void **state)
{
  const double l = par[AT_L], u[NDIM] = { [LAMBDA_L] = 0.2, [LAMBDA_R] = -0.1 };
  const double limit = l * tan(par[AT_ALPHA_M]);

  (void)state;
  par[AT_K_ALPHA] = par[AT_K_LAMBDA] = 0.;
  libmlg_run_start(&run, par, u);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_LIMIT);
  assert_near(run.t, l / par[AT_V] * log(0.1 / limit), 1e-10);
  assert_near(run.u[LAMBDA_R], -limit, 1e-10);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_LIMIT);
  assert_near(run.t, l / par[AT_V] * log(0.2 / limit), 1e-10);
  assert_int_equal(libmlg_run_to(&run, 0.1), LIBMLG_AT_TIME);
  assert_int_equal(run.limits, 2);
  assert_near(run.t, 0.1, 0.);
  assert_near(run.u[LAMBDA_L], 0.2 * exp(-0.1 * par[AT_V] / l), 1e-10);
  assert_near(run.u[LAMBDA_R], -0.1 * exp(-0.1 * par[AT_V] / l), 1e-10);
  assert_near(run.u[PSI], 0., 1e-12);
}

/* Straight rolling stays, without a section or a limit on its way. */
static void rest_stays(void **state)
{
  (void)state;
  libmlg_run_section(&run, PSI, 1);
  start(0.);
  assert_int_equal(libmlg_run_to(&run, 5.), LIBMLG_AT_TIME);
  for (int i = 0; i < NDIM; i++)
    assert_near(run.u[i], 0., 0.);
}

/* The peaks of psi lie between its zeros, the rate is 0 there, and psi higher
 * than beside them. */
static void sections_are_crossings(void **state)
{
  double up, beside[2];

  (void)state;
  libmlg_run_section(&run, PSI, 1);
  start(0.02);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_SECTION);
  assert_near(run.u[PSI], 0., 1e-12);
  assert_true(run.u[DPSI] > 0.);
  up = run.t;
  start(0.02);
  libmlg_run_section(&run, DPSI, -1);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_SECTION);
  assert_near(run.u[DPSI], 0., 1e-10);
  assert_true(run.t > up && run.t < up + 0.05);

  const double t = run.t, peak = run.u[PSI];
  for (int side = 0; side < 2; side++) {
    start(0.02);
    while (libmlg_run_to(&run, t + (side ? 1e-3 : -1e-3)) == LIBMLG_AT_SECTION)
      ;
    beside[side] = run.u[PSI];
  }
  assert_true(beside[0] < peak && beside[1] < peak);
}

/* A crossing is met whatever times are asked for before it. */
static void sections_do_not_hang_on_the_output(void **state)
{
  double t;

  (void)state;
  libmlg_run_section(&run, DPSI, -1);
  start(0.02);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_SECTION);
  t = run.t;
  start(0.02);
  for (int i = 1; i * 1e-3 < t; i++)
    assert_int_equal(libmlg_run_to(&run, i * 1e-3), LIBMLG_AT_TIME);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_SECTION);
  assert_near(run.t, t, 1e-10);
}

/* A run does not know what the same integrator did before. */
static void restarts_are_clean(void **state)
{
  double first[NDIM];

  (void)state;
  start(0.02);
  assert_int_equal(libmlg_run_to(&run, 2.), LIBMLG_AT_TIME);
  memcpy(first, run.u, sizeof first);
  par[AT_V] = 60.;
  start(0.3);
  while (libmlg_run_to(&run, 0.5) == LIBMLG_AT_LIMIT)
    ;
  assert_true(run.limits > 0);
  par[AT_V] = 20.;
  start(0.02);
  assert_int_equal(run.limits, 0);
  assert_int_equal(libmlg_run_to(&run, 2.), LIBMLG_AT_TIME);
  assert_memory_equal(first, run.u, sizeof first);
}

/* (delta, psi, lambda_L, lambda_R, eps) -> -(delta, psi, lambda_R, lambda_L, eps),
 * from large random states, through their limits. */
static void mirrored_starts_mirror(void **state)
{
  double u[2][NDIM], first[NDIM];
  long limits, all = 0;

  (void)state;
  for (int sample = 0; sample < 20; sample++) {
    for (int i = 0; i < NDIM; i++)
      u[0][i] = uniform(-0.1, 0.1) * libmlg_state_size(l1, i);
    for (int i = 0; i < NDIM; i++)
      u[1][i] = -u[0][mirror(i)];
    for (int k = 0; k < 2; k++) {
      libmlg_run_start(&run, par, u[k]);
      while (libmlg_run_to(&run, 0.2) == LIBMLG_AT_LIMIT)
        ;
      if (k == 0) {
        memcpy(first, run.u, sizeof first);
        all += limits = run.limits;
      }
    }
    assert_int_equal(run.limits, limits);
    for (int i = 0; i < NDIM; i++)
      assert_near(run.u[mirror(i)], -first[i], 1e-9 * libmlg_state_size(l1, i));
  }
  assert_true(all > 20);
}

/* Small oscillations are as exact as large ones: there the gear is linear. */
static void weights_follow_the_size(void **state)
{
  double small[NDIM];

  (void)state;
  start(1e-6);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_TIME);
  memcpy(small, run.u, sizeof small);
  start(1e-5);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_AT_TIME);
  for (int i = 0; i < NDIM; i++)
    assert_near(run.u[i] * 0.1, small[i], 1e-6 * libmlg_state_size(l1, i) * libmlg_oscillation_size(l1, small));
}

/* The error falls with the tolerance. */
static void tolerance_is_kept(void **state)
{
  struct libmlg_run exact;
  const double u[NDIM] = { [PSI] = 0.05 };

  (void)state;
  assert_int_equal(libmlg_run_begin(&exact, l1, 1e-13), 0);
  libmlg_run_start(&exact, par, u);
  start(0.05);
  assert_int_equal(libmlg_run_to(&exact, 2.), LIBMLG_AT_TIME);
  assert_int_equal(libmlg_run_to(&run, 2.), LIBMLG_AT_TIME);
  for (int i = 0; i < NDIM; i++)
    assert_near(run.u[i], exact.u[i], 1e-8 * libmlg_state_size(l1, i) * libmlg_oscillation_size(l1, exact.u));
  libmlg_run_end(&exact);
}

static void failures_say_why(void **state)
{
  int reached;

  (void)state;
  par[AT_K_PSI] = -1e6; /* no range of ours: psi runs away */
  start(0.2);
  do
    reached = libmlg_run_to(&run, 10.);
  while (reached == LIBMLG_AT_LIMIT);
  assert_int_equal(reached, LIBMLG_FAILED);
  assert_true(run.t > 0. && fabs(run.u[PSI]) > 1. && fabs(run.u[PSI]) <= MLG_PI / 2.);
  assert_non_null(strstr(run.error, "pi/2"));
  par[AT_L] = 0.;
  start(0.);
  assert_int_equal(libmlg_run_to(&run, 1.), LIBMLG_FAILED);
  assert_true(strlen(run.error) > 10 && !strchr(run.error, '\n'));
}

static void no_layout_no_run(void **state)
{
  struct libmlg_run none;

  (void)state;
  assert_int_equal(libmlg_run_begin(&none, LIBMLG_NONE, 1e-10), LIBMLG_NONE);
  libmlg_run_end(&none);
  assert_true(isnan(libmlg_state_size(l1, NDIM)));
}

int main(void)
{
#define T(f) cmocka_unit_test_setup_teardown(f, begin, end)
  const struct CMUnitTest tests[] = {
    T(tyres_relax), T(rest_stays), T(sections_are_crossings), T(sections_do_not_hang_on_the_output),
    T(restarts_are_clean), T(mirrored_starts_mirror), T(weights_follow_the_size),
    T(tolerance_is_kept), T(failures_say_why), T(no_layout_no_run),
  };

  return cmocka_run_group_tests(tests, NULL, NULL);
}
