/* test_elements.c - the laws of joints, springs and the damper (models/elements.h)
 *
 * Each by itself: its limits, that it is odd and gives no energy, that a torque found
 * from a rate gives the rate back, and the energy of a cycle against its closed form.
 * What a whole device does with them is in test_layout.c.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "mlg.h"
#include "numbers.h"

enum { SAMPLES = 2000 };

static double par[MLG_SLOTS];

static int seed(void **state)
{
  (void)state;
  random_state = 16;
  mlg_defaults(par);
  par[PAR_C_D] = 3000.;
  par[PAR_K_S] = 8e5;
  return 0;
}

static double any(double lo, double hi)
{
  return lo * pow(hi / lo, uniform(0., 1.));
}

/* Each law is on or off, as the bits of n say. */
static void some_laws(int n)
{
  seed(NULL);
  random_state = (uint64_t)n;
  par[PAR_CORNER] = n & 1 ? any(1e-3, 1.) : 0.;
  par[PAR_V_F] = any(1e-3, 1.);
  par[PAR_C_R] = any(10., 1e3);
  par[PAR_C_D] = any(10., 1e5);
  par[PAR_T_F] = n & 2 ? any(1., 1e3) : 0.;
  par[PAR_C_2] = n & 4 ? any(1., 1e5) : 0.;
  par[PAR_T_MAX] = n & 8 ? any(10., 1e4) : 0.;
  par[PAR_G_PSI] = n & 16 ? any(1e-4, 1e-2) : 0.;
  par[PAR_G_S] = n & 32 ? any(1e-4, 1e-2) : 0.;
  par[PAR_K_S3] = n & 64 ? any(1e5, 1e10) : 0.;
  par[PAR_K_D3] = n & 128 ? any(1e5, 1e10) : 0.;
}

static void dead_zone(void **state)
{
  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    const double g = any(1e-4, 1e-1), x = uniform(-5., 5.) * g, w = g * any(1e-3, 1.), h = 1e-5 * w;
    const double D = mlg_dead_zone(x, g, w), sharp = fabs(x) > g ? copysign(fabs(x) - g, x) : 0.;
    const double slope = mlg_dead_zone_slope(x, g, w);

    assert_near(mlg_dead_zone(x, g, 0.), sharp, 1e-15 * (fabs(x) + g));
    assert_near(D, sharp, 0.5 * w); /* the corner is cut by half its width */
    assert_near(mlg_dead_zone(-x, g, w), -D, 0.);
    assert_true(slope >= 0. && slope <= 1.);
    assert_near((mlg_dead_zone(x + h, g, w) - mlg_dead_zone(x - h, g, w)) / (2. * h), slope, 1e-8 + 1e-15 * g / h);
  }
  assert_near(mlg_behind_gap(par, 0.3, 0.), 0.3, 0.);
}

/* Odd, against the motion, rising; torque and rate belong together. */
static void damper_law(void **state)
{
  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    some_laws(n);
    const double v = uniform(-10., 10.), T = mlg_damper_torque(par, v);
    const double hydraulic = par[PAR_C_D] * fabs(v) + par[PAR_C_2] * v * v;

    assert_near(mlg_damper_torque(par, -v), -T, 1e-12 * fabs(T));
    assert_true(T * v >= 0.);
    assert_true(fabs(mlg_damper_torque(par, 1.001 * v)) > fabs(T));
    assert_near(mlg_damper_rate(par, T), v, 1e-9 * fabs(v));
    assert_near(mlg_damper_rate(par, -T), -mlg_damper_rate(par, T), 1e-12 * fabs(v));
    if (!(n & 8)) /* no valve */
      assert_near(fabs(T), hydraulic + par[PAR_T_F] * tanh(fabs(v) / par[PAR_V_F]), 1e-12 * fabs(T));
    else
      assert_true(fabs(T) <= hydraulic + par[PAR_T_F] + 1e-9);
  }
}

/* Above T_max the oil goes through orifice and valve side by side. */
static void relief_valve(void **state)
{
  (void)state;
  some_laws(8);
  par[PAR_CORNER] = 0.;
  par[PAR_C_D] = 1e4;
  par[PAR_C_R] = 100.;
  par[PAR_T_MAX] = 5000.;
  assert_near(mlg_damper_torque(par, 0.4), 4000., 1e-9);
  assert_near(mlg_damper_torque(par, 1.5), 5000. + 1. / (1. / 1e4 + 1. / 100.), 1e-9);
  par[PAR_CORNER] = 0.1;
  assert_true(mlg_damper_torque(par, 0.5) < 5000. && mlg_damper_torque(par, 0.5) > 2500.);
}

static void laws_that_tend_to_linear(void **state)
{
  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    const double x = uniform(-0.1, 0.1);

    seed(NULL);
    random_state = (uint64_t)n;
    par[PAR_C_D] = any(10., 1e5);
    assert_near(mlg_damper_torque(par, x), par[PAR_C_D] * x, 0.);
    assert_near(mlg_damper_rate(par, x), x / par[PAR_C_D], 0.);
    assert_near(mlg_links(par, x), par[PAR_K_PSI] * x, 0.);
    assert_near(mlg_links_and_k_s(par, x), mlg_series(par[PAR_K_PSI], par[PAR_K_S]) * x, 0.);
    par[PAR_T_F] = 1e-9;
    par[PAR_V_F] = 1e-3;
    par[PAR_C_2] = 1e-14;
    par[PAR_T_MAX] = 1e9;
    par[PAR_C_R] = 1.;
    par[PAR_G_PSI] = par[PAR_G_S] = 1e-16;
    par[PAR_K_S3] = par[PAR_K_D3] = 1e-6;
    assert_near(mlg_damper_torque(par, x), par[PAR_C_D] * x, 1e-8);
    assert_near(mlg_damper_rate(par, 1e5 * x), 1e5 * x / par[PAR_C_D], 1e-9);
    assert_near(mlg_links(par, x), par[PAR_K_PSI] * x, 1e-9);
    assert_near(mlg_links_and_k_s(par, x), mlg_series(par[PAR_K_PSI], par[PAR_K_S]) * x, 1e-9);
    assert_near(mlg_k_s(par, x), par[PAR_K_S] * x, 1e-9);
    assert_near(mlg_k_d(par, x), par[PAR_K_D] * x, 1e-9);
  }
}

/* Joined elements: one torque goes through all in series, and twists add. */
static void joined(void **state)
{
  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    some_laws(n);
    const double y = uniform(-0.1, 0.1), z = uniform(-0.1, 0.1), T = mlg_links_and_k_s(par, y);
    const double open = par[PAR_G_PSI] + par[PAR_G_S];
    const double twist = (open > 0. ? mlg_dead_zone(y, open, par[PAR_CORNER] * open) : y) - T / par[PAR_K_PSI]; /* of k_s */

    assert_near(mlg_cubic(par[PAR_K_S], par[PAR_K_S3], twist), T, 1e-9 * fabs(T) + 1e-9);
    assert_near(mlg_links_and_k_s(par, -y), -T, 1e-12 * fabs(T));

    const struct mlg_fork fork = mlg_fork_and_k_s(par, y, z);
    const double k = par[PAR_K_PSI] + par[PAR_K_D];

    if (n & (16 | 32 | 64 | 128)) {
      /* the twist x of k_d from its own torque, then the other two */
      double x = (fork.T_d - fork.T_b) / par[PAR_K_D];

      for (int i = 0; i < 100; i++)
        x -= (mlg_k_d(par, x) - fork.T_d + fork.T_b) / (par[PAR_K_D] + 3. * par[PAR_K_D3] * x * x);
      assert_near(mlg_links(par, y - x), fork.T_d, 1e-8 * (fabs(fork.T_d) + fabs(fork.T_b)) + 1e-6);
      assert_near(mlg_k_s(par, x - z), fork.T_b, 1e-8 * (fabs(fork.T_d) + fabs(fork.T_b)) + 1e-6);
    } else {
      assert_near(fork.T_b, mlg_series(k, par[PAR_K_S]) * (y * par[PAR_K_PSI] / k - z), 0.);
    }
  }
}

/* The energy, N m rad = J, that the damper and the wheels take in a cycle A sin(w t). */
static double energy(double A, double w)
{
  enum { POINTS = 200000 };
  double sum = 0.;

  for (int i = 0; i < POINTS; i++) {
    const double v = A * w * cos(2. * MLG_PI * i / POINTS);

    sum += (mlg_damper_torque(par, v) + mlg_wheel_friction(par, v)) * v;
  }
  return sum * 2. * MLG_PI / w / POINTS;
}

static void energy_of_a_cycle(void **state)
{
  const double A = 0.02, w = 70.;

  (void)state;
  seed(NULL);
  assert_near(energy(A, w), MLG_PI * 3000. * w * A * A, 1e-9 * MLG_PI * 3000. * w * A * A);
  par[PAR_C_D] = 0.;
  par[PAR_C_2] = 500.;
  assert_near(energy(A, w), 8. / 3. * 500. * w * w * A * A * A, 1e-8 * 8. / 3. * 500. * w * w * A * A * A);
  par[PAR_C_2] = 0.;
  par[PAR_T_F] = 120.;
  par[PAR_T_PSI] = 80.;
  par[PAR_V_F] = 1e-3; /* (1 - (pi^2/24)(v_f / A w)^2) of the limit */
  assert_near(energy(A, w), 4. * 200. * A, 1e-6 * 4. * 200. * A);
}

static void laws_that_lack_something(void **state)
{
  (void)state;
  seed(NULL);
  assert_null(mlg_lacks(par));
  par[PAR_T_PSI] = 1.;
  assert_non_null(strstr(mlg_lacks(par), "v_f"));
  par[PAR_V_F] = 0.1;
  assert_null(mlg_lacks(par));
  par[PAR_T_MAX] = 1.;
  assert_non_null(strstr(mlg_lacks(par), "c_r"));
  assert_true(mlg_has_laws(par));
  mlg_at_rest(par);
  assert_false(mlg_has_laws(par));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(dead_zone, seed),
    cmocka_unit_test_setup(damper_law, seed),
    cmocka_unit_test_setup(relief_valve, seed),
    cmocka_unit_test_setup(laws_that_tend_to_linear, seed),
    cmocka_unit_test_setup(joined, seed),
    cmocka_unit_test_setup(energy_of_a_cycle, seed),
    cmocka_unit_test_setup(laws_that_lack_something, seed),
  };

  return cmocka_run_group_tests_name("elements", tests, NULL, NULL);
}
