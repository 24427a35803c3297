/* test_positive_real.c - any passive device as numbers, its slopes, and the climb on them */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "arguments.h" /* its fail() before cmocka's macro */
#include "bfgs.h"
#include "cma.h"
#include "device_text.h"
#include "positive_real.h"

#include <cmocka.h>

static struct passive gear(int m)
{
  struct passive p = { .layout = device_rational(m), .m = m, .V_least = 0.3, .V_top = 200., .K_least = 109e3 };

  assert_true(p.layout != LIBMLG_NONE);
  for (int i = 0; i < libmlg_parameters(); i++)
    p.par[i] = libmlg_default(i);
  return p;
}

static void draw(int n, double y[], struct cma_random *random)
{
  for (int i = 0; i < n; i++)
    y[i] = 8. * cma_uniform(random) - 4.;
}

/* Re(Z/s) >= 0 for s on and to the right of the imaginary axis, whatever the numbers. */
static void every_device_is_passive(void **state)
{
  struct cma_random random = { 5 };

  (void)state;
  for (int m = 0; m <= MOST_M; m++)
    for (int k = 0; k < 20; k++) {
      struct passive p = gear(m);
      double y[MOST_VARIABLES];

      draw(passive_variables(m), y, &random);
      passive_set(&p, y);
      assert_true(p.K >= p.K_least);
      for (double omega = 1e-1; omega < 1e5; omega *= 1.7)
        for (int right = 0; right < 2; right++) {
          const double _Complex s = right * omega + I * omega, impedance = passive_stiffness(&p, s) / s;

          assert_true(creal(impedance) >= -1e-9 * cabs(impedance));
        }
    }
}

/* Against differences of the value. */
static void slopes(void **state)
{
  struct cma_random random = { 3 };

  (void)state;
  for (int m = 0; m <= MOST_M; m++)
    for (int k = 0, seen = 0; k < 200 && seen < 3; k++) {
      struct passive p = gear(m);
      double y[MOST_VARIABLES], slope[MOST_VARIABLES], ignored[MOST_VARIABLES], largest = 0.;
      const int n = passive_variables(m);

      p.softness = 1e-2;
      p.V[p.speeds++] = 10.;
      p.V[p.speeds++] = 60.;
      draw(n, y, &random);
      if (!(passive_value(&p, y, slope) > -0.9))
        continue;
      seen++;
      for (int i = 0; i < n; i++)
        largest = fmax(largest, fabs(slope[i]));
      for (int i = 0; i < n; i++) {
        const double h = 1e-5, at = y[i];

        y[i] = at + h;
        const double ahead = passive_value(&p, y, ignored);
        y[i] = at - h;
        const double back = passive_value(&p, y, ignored);
        y[i] = at;
        assert_true(fabs((ahead - back) / (2. * h) - slope[i]) < 1e-4 * largest + 1e-9);
      }
    }
}

/* The least damped mode has the least ratio. */
static void mode_of_the_least_ratio(void **state)
{
  struct cma_random random = { 11 };
  int seen = 0;

  (void)state;
  for (int k = 0; k < 40; k++) {
    struct passive p = gear(k % (MOST_M + 1));
    double y[MOST_VARIABLES];
    struct libmlg_ratio ratio;

    draw(passive_variables(p.m), y, &random);
    assert_int_equal(passive_least(&p, y, &ratio), 0);
    if (!(ratio.zeta > -1.))
      continue;
    seen++;
    const double _Complex s = passive_mode(&p, ratio.V);

    assert_true(fabs(-creal(s) / cabs(s) - ratio.zeta) < 1e-9);
  }
  assert_true(seen > 10);
}

/* Lewis and Overton's first example, -(w |x^2 - y| + (1 - x)^2), with a kink along a parabola. */
static double kinked(void *context, const double x[], double slope[])
{
  const double w = *(const double *)context, gap = x[0] * x[0] - x[1], side = gap > 0. ? w : -w;

  slope[0] = -(side * 2. * x[0] - 2. * (1. - x[0]));
  slope[1] = side;
  return -(w * fabs(gap) + (1. - x[0]) * (1. - x[0]));
}

static void climbs_along_a_kink(void **state)
{
  double w = 8., y[2] = { -1., -1. };
  struct bfgs f = { kinked, &w, 2, 0 };

  (void)state;
  assert_true(bfgs_climb(&f, y, 500) > -1e-8);
  assert_true(fabs(y[0] - 1.) < 1e-4 && fabs(y[1] - 1.) < 1e-4);
  assert_true(f.asked > 10 && f.asked < 5000);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(every_device_is_passive),
    cmocka_unit_test(slopes),
    cmocka_unit_test(mode_of_the_least_ratio),
    cmocka_unit_test(climbs_along_a_kink),
  };

  return cmocka_run_group_tests(tests, NULL, NULL);
}
