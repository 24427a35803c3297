/* golden.c - see golden.h */
#include "golden.h"

static const double part = 0.6180339887498949; /* (sqrt(5) - 1)/2 */

double golden_largest(double f(double x, void *context), void *context, double left, double right, double tolerance,
                      double *at, double largest)
{
  double x = right - part * (right - left), y = left + part * (right - left);
  double at_x = f(x, context), at_y = f(y, context);

  for (;;) {
    if (at_x > largest) {
      largest = at_x;
      *at = x;
    }
    if (at_y > largest) {
      largest = at_y;
      *at = y;
    }
    if (!(right - left > tolerance) || !(left < x && x < y && y < right))
      return largest;
    if (at_x > at_y || (!(at_y > at_x) && *at < y)) {
      right = y;
      y = x;
      at_y = at_x;
      x = right - part * (right - left);
      at_x = f(x, context);
    } else {
      left = x;
      x = y;
      at_x = at_y;
      y = left + part * (right - left);
      at_y = f(y, context);
    }
  }
}
