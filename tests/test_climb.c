/* test_climb.c - climb_largest on leasts of smooth functions whose tops are known
 *
 * Corners: f = min over i of 0..n of a_i (x - top) + bend_i |x - top|^2, the a_i of very different
 * sizes and with 0 in the middle of them: within reach of the bends the top is 0, at `top`.  Ridges:
 * f = -steep |y - curve(x)| - (x - top)^2, a kink that is bent.  Walls: a top outside the unit box.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "climb.h"
#include "numbers.h"

enum { N = 4 };

struct corner { int n; double top[N], a[N + 1][N], bend[N + 1]; };

static int corner(const double x[], struct climb_piece piece[], void *context)
{
  const struct corner *const c = context;

  for (int i = 0; i <= c->n; i++) {
    double square = 0.;

    piece[i].value = 0.;
    for (int j = 0; j < c->n; j++) {
      square += (x[j] - c->top[j]) * (x[j] - c->top[j]);
      piece[i].value += c->a[i][j] * (x[j] - c->top[j]);
      piece[i].slope[j] = c->a[i][j] + 2. * c->bend[i] * (x[j] - c->top[j]);
    }
    piece[i].value += c->bend[i] * square;
  }
  return c->n + 1;
}

/* n + 1 slopes of which the first n are random and the last makes a sum with positive weights 0. */
static struct corner random_corner(int n)
{
  struct corner c = { .n = n };

  for (int j = 0; j < n; j++)
    c.top[j] = uniform(0.1, 0.9);
  for (int i = 0; i < n; i++) {
    const double size = pow(10., uniform(-2., 2.));

    for (int j = 0; j < n; j++) {
      c.a[i][j] = size * (uniform(-1., 1.) + (i == j));
      c.a[n][j] -= c.a[i][j] * uniform(0.999, 1.) / size;
    }
    c.bend[i] = size * uniform(-0.1, 0.02); /* most bend downwards */
  }
  c.bend[n] = uniform(-0.1, 0.02);
  return c;
}

static void a_corner_is_found(void **state)
{
  (void)state;
  random_state = 1405;
  for (int sample = 0; sample < 500; sample++) {
    const int n = 1 + sample % N;
    struct corner c = random_corner(n);
    double x[N], best;

    for (int j = 0; j < n; j++)
      x[j] = c.top[j] + uniform(-0.1, 0.1);
    const int asked = climb_largest(corner, &c, n, x, 0.1, 400, INFINITY, &best);

    assert_in_range(asked, 1, 402);
    if (!(best > -1e-7))
      fail_msg("sample %d of %d variables: %g after %d values", sample, n, best, asked);
  }
}

struct ridge { double steep, bend, top; int one_at_a_time; };

/* y = 0.2 + bend x^2 */
static int ridge(const double x[], struct climb_piece piece[], void *context)
{
  const struct ridge *const r = context;
  const double off = x[1] - 0.2 - r->bend * x[0] * x[0], along = -(x[0] - r->top) * (x[0] - r->top);
  const int both = !r->one_at_a_time;

  for (int i = 0; i < 1 + both; i++) {
    const double side = both ? 2. * i - 1. : off > 0. ? -1. : 1.;

    piece[i] = (struct climb_piece){ side * r->steep * off + along, { -2. * side * r->steep * r->bend * x[0] - 2. * (x[0] - r->top), side * r->steep } };
  }
  return 1 + both;
}

static void a_bent_ridge_is_followed(void **state)
{
  (void)state;
  random_state = 1406;
  for (int sample = 0; sample < 200; sample++) {
    struct ridge r = { pow(10., uniform(-1., sample % 2 ? 1. : 3.)), uniform(-0.2, 0.7), uniform(0.6, 0.95), sample % 2 };
    double x[2] = { uniform(0., 0.3), uniform(0., 1.) }, best;

    climb_largest(ridge, &r, 2, x, 0.1, 600, INFINITY, &best);
    if (!(best > -1e-7))
      fail_msg("sample %d: %g at %g, %g; steep %g, bend %g, top %g", sample, best, x[0], x[1], r.steep, r.bend, r.top);
    assert_near(x[0], r.top, 1e-3);
  }
}

/* One smooth function whose top is outside: the largest within the walls is at (1, 0.3, 0). */
static int outside(const double x[], struct climb_piece piece[], void *context)
{
  (void)context;
  if (x[0] < 0. || x[0] > 1. || x[2] < 0. || x[2] > 1.)
    fail_msg("asked for %g, %g, %g", x[0], x[1], x[2]);
  piece[0] = (struct climb_piece){ -pow(x[0] - 1.5, 2.) - 100. * pow(x[1] - 0.3, 2.) - x[2],
                                   { -2. * (x[0] - 1.5), -200. * (x[1] - 0.3), -1. } };
  return 1;
}

static void walls_are_kept(void **state)
{
  double x[3] = { 0.2, 0.9, 0.5 }, best;

  (void)state;
  climb_largest(outside, NULL, 3, x, 0.1, 200, INFINITY, &best);
  assert_near(best, -0.25, 1e-8);
  assert_near(x[0], 1., 0.);
  assert_near(x[1], 0.3, 1e-4);
  assert_near(x[2], 0., 0.);
}

/* No value left of 0.4, where it would be largest. */
static int ends(const double x[], struct climb_piece piece[], void *context)
{
  (void)context;
  piece[0] = (struct climb_piece){ -x[0], { -1. } };
  return x[0] > 0.4;
}

static void the_end_of_all_values_is_met(void **state)
{
  double x[1] = { 0.8 }, best;

  (void)state;
  climb_largest(ends, NULL, 1, x, 0.1, 200, INFINITY, &best);
  assert_near(best, -0.4, 1e-6);
  x[0] = 0.8;
  assert_true(climb_largest(ends, NULL, 1, x, 0.1, 200, -0.7, &best) < 10 && best > -0.7); /* enough */
  x[0] = 0.1;
  assert_int_equal(climb_largest(ends, NULL, 1, x, 0.1, 200, INFINITY, &best), 1);
  assert_true(best == -INFINITY && x[0] == 0.1);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_corner_is_found),
    cmocka_unit_test(a_bent_ridge_is_followed),
    cmocka_unit_test(walls_are_kept),
    cmocka_unit_test(the_end_of_all_values_is_met),
  };

  return cmocka_run_group_tests_name("climb", tests, NULL, NULL);
}
