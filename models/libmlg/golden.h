/* golden.h - where a function of one variable is largest; private to this project */
#ifndef LIBMLG_GOLDEN_H
#define LIBMLG_GOLDEN_H

/* The x between lo and hi where value(x, data) is largest, by golden section to 1e-5 of
 * the range.  Where there are several maxima it finds one of them. */
static inline double summit(double (*value)(double x, void *data), void *data, double lo, double hi)
{
  const double golden = 0.6180339887498949;
  double x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo);
  double y1 = value(x1, data), y2 = value(x2, data);

  for (int i = 0; i < 24; i++)
    if (y1 > y2) {
      hi = x2, x2 = x1, y2 = y1;
      y1 = value(x1 = hi - golden * (hi - lo), data);
    } else {
      lo = x1, x1 = x2, y1 = y2;
      y2 = value(x2 = lo + golden * (hi - lo), data);
    }
  return y1 > y2 ? x1 : x2;
}

#endif
