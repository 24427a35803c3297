/* damping.h - the least damped oscillation of a gear that rolls straight
 *
 * The roots s of F(s) = 0 (models/characteristic.h) are the eigenvalues of its
 * companion matrix, from LAPACK.  Damping ratio: zeta = -Re(s)/|s|, 0 at a Hopf
 * point.  A real root does not oscillate: it has zeta = 1 and never counts; one that
 * grows (divergence) has -1 and always does.  The difference of the two tyres'
 * deflections, which is not in F, decays as exp(-V t / l) and is such a real root.
 * Link -llapacke -llapack.
 */
#ifndef MLG_DAMPING_H
#define MLG_DAMPING_H

#include <lapacke.h>

#include "characteristic.h"

/* A root s, 1/s, of F at the speed V, m/s, its imaginary part not below 0. */
struct mode { double _Complex s; double zeta, V; };

/* The root of the least damping ratio at one (V, c_d); V above 0. */
static inline struct mode least_damped(const struct characteristic *f, double V, double c_d)
{
  int n;
  const struct poly p = characteristic_polynomial(f, V, c_d, &n);
  double companion[POLY_TERMS * POLY_TERMS] = { 0. }, re[POLY_TERMS], im[POLY_TERMS];
  struct mode least = { .zeta = HUGE_VAL, .V = V };

  for (int i = 0; i < n; i++) { /* by columns; the first row holds the coefficients */
    companion[n * i] = -p.coefficient[n - 1 - i] / p.coefficient[n];
    if (i > 0)
      companion[i + n * (i - 1)] = 1.;
  }
  if (LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', n, companion, n, re, im, NULL, n, NULL, n) != 0) {
    fprintf(stderr, "damping: no roots of F at V = %g, c_d = %g: are the parameters in range?\n", V, c_d);
    exit(1);
  }
  for (int i = 0; i < n; i++) {
    const double zeta = -re[i] / hypot(re[i], im[i]);

    if (im[i] >= 0. && zeta < least.zeta) {
      least.zeta = zeta;
      least.s = 100. * (re[i] + im[i] * I);
    }
  }
  return least;
}

/* Where value(x, data) is largest between lo and hi: golden section.  Where there are
 * several maxima it finds one of them. */
static inline double summit(double (*value)(double x, void *data), void *data, double lo, double hi)
{
  const double golden = 0.6180339887498949;
  double x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo);
  double y1 = value(x1, data), y2 = value(x2, data);

  for (int i = 0; i < 24; i++) /* to 1e-5 of the range */
    if (y1 > y2) {
      hi = x2, x2 = x1, y2 = y1;
      y1 = value(x1 = hi - golden * (hi - lo), data);
    } else {
      lo = x1, x1 = x2, y1 = y2;
      y2 = value(x2 = lo + golden * (hi - lo), data);
    }
  return y1 > y2 ? x1 : x2;
}

struct at_c_d { const struct characteristic *f; double c_d; };

static inline double negative_zeta(double V, void *data)
{
  const struct at_c_d *at = data;

  return -least_damped(at->f, V, at->c_d).zeta;
}

/* The same over all speeds up to MLG_V_TOP: samples that are dense at low speed, and
 * each minimum between them refined. */
static inline struct mode least_damped_of_all(const struct characteristic *f, double c_d)
{
  enum { SAMPLES = 60 }; /* twice as many change no zeta by 1e-8 of itself (docs/damping.md) */
  struct at_c_d at = { f, c_d };
  struct mode worst = { .zeta = HUGE_VAL }, sample[3];

  for (int i = 1; i <= SAMPLES; i++) {
    sample[0] = sample[1];
    sample[1] = sample[2];
    sample[2] = least_damped(f, MLG_V_TOP * i * i / (SAMPLES * SAMPLES), c_d);
    if (sample[2].zeta < worst.zeta)
      worst = sample[2];
    if (i > 2 && sample[1].zeta <= sample[0].zeta && sample[1].zeta <= sample[2].zeta) {
      const struct mode bottom = least_damped(f, summit(negative_zeta, &at, sample[0].V, sample[2].V), c_d);

      if (bottom.zeta < worst.zeta)
        worst = bottom;
    }
  }
  return worst;
}

#endif
