/* equilibria.h - what pvls computes along straight rolling and along Hopf curves: test
 * functions for Hopf points, and one for a curve that closes
 *
 * plugin.h includes this behind AUTO's header.
 */
#ifndef MLG_EQUILIBRIA_H
#define MLG_EQUILIBRIA_H

/* ISW of the constants file: 1 straight rolling in one parameter, 2 a Hopf curve in two; as in
 * room.h. */
extern integer auto_isw __asm__("__auto_constants_MOD_isw");

/* LAPACK, which AUTO carries: eigenvalues of A. */
extern void dgeev_(const char *jobvl, const char *jobvr, const integer *n, double *A, const integer *lda,
                   double *re, double *im, double *vl, const integer *ldvl, double *vr, const integer *ldvr,
                   double *work, const integer *lwork, integer *info, size_t len_jobvl, size_t len_jobvr);

/* Test functions of the Hopf points of straight rolling, 1/s: test[0] of psi-shimmy and
 * test[1] of delta-shimmy (mlg_energy_ratio, mlg.h).  Each is the real part of its complex pair of eigenvalues nearest to the imaginary axis, with the sign -
 * when an even number of its pairs grows, + when an odd one does.  It passes smoothly through 0
 * at each of its Hopf points and nowhere else, whereas AUTO's own test, the real part of
 * whichever pair is nearest, changes its sign where another pair becomes that.  It jumps where
 * a growing oscillation turns from the one kind to the other, or into real eigenvalues.
 * -1 without any pair, and on Hopf curves, where it would be 0. */
static void hopf_tests(integer ndim, const double par[], const double u[], double test[2])
{
  double f[NDIM], A[NDIM * NDIM], re[NDIM], im[NDIM], none[1], v[NDIM * NDIM], work[8 * NDIM];
  const integer one = 1, lwork = 8 * NDIM;
  integer info = 0;
  int growing[2] = { 0, 0 }, pairs[2] = { 0, 0 };

  test[0] = test[1] = -1.;
  if (ndim != NDIM || !usable(par) || auto_isw != 1)
    return;
  right_hand_side(par, u, f);
  derivatives(par, u, f, A, NULL);
  dgeev_("N", "V", &ndim, A, &ndim, re, im, none, &one, v, &ndim, work, &lwork, &info, 1, 1);
  for (int i = 0; info == 0 && i + 1 < NDIM; i++)
    if (im[i] > 0.) { /* its vector: column i and i times column i + 1 */
      const double *x = v + NDIM * i, *y = x + NDIM;
      const int kind = mlg_energy_ratio(par, hypot(x[DELTA], y[DELTA]) / hypot(x[PSI], y[PSI])) > 1.;

      growing[kind] += re[i] > 0.;
      test[kind] = pairs[kind]++ == 0 ? fabs(re[i]) : fmin(test[kind], fabs(re[i]));
    }
  for (int kind = 0; kind < 2; kind++)
    if (growing[kind] % 2 == 0)
      test[kind] = -fabs(test[kind]);
}

/* A Hopf curve, as far as it has come: where it began and in which direction, the point before
 * this one, the longest step, and whether it has been on the other side of where it began. */
static struct {
  double start[MLG_SLOTS], direction[MLG_SLOTS], before[MLG_SLOTS], step;
  int begun, directed, behind;
} curve;

/* d = par - from, of parameters above 0 by their ratio, and the period; returns its length. */
static double way_from(const double from[], const double par[], double d[])
{
  double square = 0.;

  memset(d, 0, MLG_SLOTS * sizeof *d);
  for (int k = 0; k <= MLG_PARAMETER_COUNT; k++) {
    const int i = k < MLG_PARAMETER_COUNT ? mlg_parameters[k].slot : PAR_PERIOD;

    d[i] = par[i] > 0. && from[i] > 0. ? log(par[i] / from[i]) : par[i] - from[i];
    square += d[i] * d[i];
  }
  return sqrt(square);
}

/* Passes upwards through 0 where a curve comes round to its start, and is below 0 before: the
 * distance from the plane across the curve at its start, once the curve has been behind that
 * plane and where it is no further from the start than its longest step; else -1.  A curve
 * that bends back within a step may seem to close up to a step early. */
static double closing_test(const double par[])
{
  double d[MLG_SLOTS], distance, along = 0.;

  if (abs((int)auto_isw) != 2)
    return -1.;
  if (!curve.begun) {
    memcpy(curve.start, par, sizeof curve.start);
    memcpy(curve.before, par, sizeof curve.before);
    curve.begun = 1;
  }
  curve.step = fmax(curve.step, way_from(curve.before, par, d));
  memcpy(curve.before, par, sizeof curve.before);
  distance = way_from(curve.start, par, d);
  if (!curve.directed && distance > 1e-6) {
    for (int k = 0; k < MLG_SLOTS; k++)
      curve.direction[k] = d[k] / distance;
    curve.directed = 1;
  }
  for (int k = 0; k < MLG_SLOTS; k++)
    along += d[k] * curve.direction[k];
  if (along < 0. && distance > 1e-6)
    curve.behind = 1;
  return curve.behind && distance < 1.1 * curve.step ? along : -1.;
}

#endif
