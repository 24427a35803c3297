/* numbers.h - random numbers and near comparisons of the tests in C; after cmocka.h */
#ifndef TESTS_NUMBERS_H
#define TESTS_NUMBERS_H

#include <stdint.h>

/* Fails with both numbers; NaN fails too. */
#define assert_near(got, expected, tolerance)                                          \
  do {                                                                                 \
    const double got_ = (got), expected_ = (expected), tolerance_ = (tolerance);       \
    if (!(fabs(got_ - expected_) <= tolerance_))                                       \
      fail_msg("%s = %.17g, expected %.17g within %.2g", #got, got_, expected_, tolerance_); \
  } while (0)

static uint64_t random_state;

static double uniform(double lo, double hi) /* splitmix64 */
{
  uint64_t z = random_state += 0x9e3779b97f4a7c15u;

  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return lo + (hi - lo) * (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

#endif
