/* eigen.h - stability of straight rolling from eigenvalues, without AUTO
 *
 * An oracle for the boundaries that AUTO continues: the linearisation of a
 * layout's func() at the zero state, its eigenvalues from LAPACK, and Newton's
 * method on them.  Include it after a layout file (models/l1.c), which gives
 * func() and NDIM, and link -llapacke.
 *
 * A real part is known to about 1e-16 of the norm of the Jacobian (some 1e4
 * to 1e5 /s), that is 1e-11 /s; a boundary to this over the slope of the real
 * part along the parameter.
 */
#ifndef EIGEN_H
#define EIGEN_H

#include <stdbool.h>
#include <stdlib.h>

#include <lapacke.h>

/* AUTO's macros, which evaluate twice */
#undef fabs
#undef min
#undef max

enum { EIGEN_SLOTS = MLG_SLOTS };

/* AUTO's part (models/room.h) */
integer auto_npar = EIGEN_SLOTS;
integer auto_isw = 1; /* straight rolling */

/* Weights of the central difference of tenth order, at 1 to 5 steps. */
static const double eigen_weight[5] = { 5. / 6., -5. / 21., 5. / 84., -5. / 504., 1. / 1260. };

/* Jacobian of func() at zero by columns, A[row + NDIM * column].  The steps
 * stay well inside the branches of the tyre (at |alpha| = alpha_m); truncation
 * is below 1e-15 of the largest entry of a column, rounding about 1e-14
 * (test_layout.c holds it to the closed form within 1e-13). */
static inline void eigen_jacobian(const double par[], double A[NDIM * NDIM])
{
  double step[NDIM], u[NDIM] = { 0. }, ahead[NDIM] = { 0. }, behind[NDIM] = { 0. };

  for (int j = 0; j < NDIM; j++)
    step[j] = 1e-2;
  step[DDELTA] = step[DPSI] = 4.; /* quadratic: any step is exact but for rounding */
  step[LAMBDA_L] = step[LAMBDA_R] = par[PAR_L] * fmin(par[PAR_ALPHA_M], 0.17) / 50.;

  for (int j = 0; j < NDIM; j++) {
    for (int i = 0; i < NDIM; i++)
      A[i + NDIM * j] = 0.;
    for (int k = 5; k > 0; k--) {
      u[j] = k * step[j];
      func(NDIM, u, NULL, par, 0, ahead, NULL, NULL);
      u[j] = -k * step[j];
      func(NDIM, u, NULL, par, 0, behind, NULL, NULL);
      for (int i = 0; i < NDIM; i++)
        A[i + NDIM * j] += eigen_weight[k - 1] / step[j] * (ahead[i] - behind[i]);
    }
    u[j] = 0.;
  }
}

/* d(Jacobian)/d(parameter).  The Jacobian is of degree 1 in V: exact there. */
static inline void eigen_jacobian_slope(const double par[], int slot, double dA[NDIM * NDIM])
{
  double p[EIGEN_SLOTS], A[NDIM * NDIM];
  const double step = slot == PAR_V ? 10. : fabs(par[slot]) > 0. ? 2e-3 * fabs(par[slot]) : 2e-3;

  memcpy(p, par, sizeof p);
  memset(dA, 0, NDIM * NDIM * sizeof *dA);
  for (int k = 5; k > 0; k--)
    for (int sign = -1; sign <= 1; sign += 2) {
      p[slot] = par[slot] + sign * k * step;
      eigen_jacobian(p, A);
      for (int i = 0; i < NDIM * NDIM; i++)
        dA[i] += sign * eigen_weight[k - 1] / step * A[i];
    }
}

/* Eigenvalues by falling real part, of a pair the one above the axis first. */
struct eigen_values { double re[NDIM], im[NDIM]; };

static inline bool eigen_before(double re1, double im1, double re2, double im2)
{
  return re1 > re2 || (!(re2 > re1) && im1 > im2);
}

/* Eigenvalues of a matrix, which is overwritten. */
static inline struct eigen_values eigen_of_matrix(double A[NDIM * NDIM])
{
  struct eigen_values e;

  if (LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', NDIM, A, NDIM, e.re, e.im, NULL, NDIM, NULL, NDIM) != 0) {
    fprintf(stderr, "the Jacobian has no eigenvalues: are its parameters in range?\n");
    exit(1);
  }
  for (int i = 1; i < NDIM; i++)
    for (int j = i; j > 0 && eigen_before(e.re[j], e.im[j], e.re[j - 1], e.im[j - 1]); j--) {
      const double re = e.re[j], im = e.im[j];

      e.re[j] = e.re[j - 1], e.im[j] = e.im[j - 1];
      e.re[j - 1] = re, e.im[j - 1] = im;
    }
  return e;
}

/* The Jacobian, from two at the ends where only V has changed: it is of degree 1 in V. */
static inline void eigen_jacobian_over_V(const double par[], double A[NDIM * NDIM])
{
  static double others[EIGEN_SLOTS], A0[NDIM * NDIM], dA[NDIM * NDIM];
  static enum { NOTHING, NOTED, KNOWN } state;
  const double far = 200.;
  double p[EIGEN_SLOTS];

  memcpy(p, par, sizeof p);
  p[PAR_V] = 0.;
  if (state == NOTHING || memcmp(p, others, sizeof p) != 0) {
    memcpy(others, p, sizeof p);
    state = NOTED;
    eigen_jacobian(par, A);
    return;
  }
  if (state == NOTED) {
    eigen_jacobian(p, A0);
    p[PAR_V] = far;
    eigen_jacobian(p, dA);
    for (int i = 0; i < NDIM * NDIM; i++)
      dA[i] = (dA[i] - A0[i]) / far;
    state = KNOWN;
  }
  for (int i = 0; i < NDIM * NDIM; i++)
    A[i] = A0[i] + par[PAR_V] * dA[i];
}

static inline struct eigen_values eigen_values(const double par[])
{
  double A[NDIM * NDIM];

  eigen_jacobian_over_V(par, A);
  return eigen_of_matrix(A);
}

/* Number of complex pairs right of the imaginary axis. */
static inline int eigen_unstable_pairs(const struct eigen_values *e)
{
  int pairs = 0;

  for (int i = 0; i < NDIM; i++)
    pairs += e->re[i] > 0. && e->im[i] > 0.;
  return pairs;
}

/* One mode: the eigenvalue nearest to a target, and its vectors. */
struct eigen_mode {
  double _Complex value, right[NDIM], left[NDIM];
  double frequency_hz;
  double delta_over_psi; /* |delta| / |psi| */
};

static inline double eigen_abs(double _Complex z)
{
  return hypot(creal(z), cimag(z));
}

static inline struct eigen_mode eigen_mode(const double par[], double _Complex target)
{
  double A[NDIM * NDIM], re[NDIM], im[NDIM], left[NDIM * NDIM], right[NDIM * NDIM];
  struct eigen_mode mode = { .value = 0. };
  int at = -1;

  eigen_jacobian(par, A);
  if (LAPACKE_dgeev(LAPACK_COL_MAJOR, 'V', 'V', NDIM, A, NDIM, re, im, left, NDIM, right, NDIM) != 0) {
    fprintf(stderr, "the Jacobian has no eigenvectors: are its parameters in range?\n");
    exit(1);
  }
  for (int i = 0; i < NDIM; i++)
    if (im[i] >= 0.
        && (at < 0 || eigen_abs(re[i] + im[i] * I - target) < eigen_abs(re[at] + im[at] * I - target)))
      at = i;
  mode.value = re[at] + im[at] * I;
  for (int i = 0; i < NDIM; i++) { /* of a pair LAPACK gives the real and the imaginary part */
    const double *v = right + NDIM * at, *w = left + NDIM * at;

    mode.right[i] = im[at] > 0. ? v[i] + v[i + NDIM] * I : v[i];
    mode.left[i] = im[at] > 0. ? w[i] + w[i + NDIM] * I : w[i];
  }
  mode.frequency_hz = im[at] / (2. * MLG_PI);
  mode.delta_over_psi = eigen_abs(mode.right[DELTA]) / eigen_abs(mode.right[PSI]);
  return mode;
}

/* d(eigenvalue)/d(parameter) */
static inline double _Complex eigen_slope(const double par[], const struct eigen_mode *mode, int slot)
{
  double dA[NDIM * NDIM];
  double _Complex above = 0., below = 0.;

  eigen_jacobian_slope(par, slot, dA);
  for (int i = 0; i < NDIM; i++) {
    for (int j = 0; j < NDIM; j++)
      above += conj(mode->left[i]) * dA[i + NDIM * j] * mode->right[j];
    below += conj(mode->left[i]) * mode->right[i];
  }
  return above / below;
}

/* ---- points on boundaries, by Newton's method ----------------------------- */

/* What is 0 at the point: two real parts, or one and its slopes. */
enum eigen_condition { EIGEN_HH = 1, EIGEN_FOLD, EIGEN_CENTRE };

/* Residual of the condition at par; target[] follows the modes. */
static inline void eigen_residual(enum eigen_condition condition, const double par[],
                                  const int slot[], double _Complex target[2], double residual[3])
{
  const struct eigen_mode mode = eigen_mode(par, target[0]);

  residual[0] = creal(target[0] = mode.value);
  if (condition == EIGEN_HH)
    residual[1] = creal(target[1] = eigen_mode(par, target[1]).value);
  else
    for (int i = 1; i <= (condition == EIGEN_FOLD ? 1 : 2); i++)
      residual[i] = creal(eigen_slope(par, &mode, slot[i - 1]));
}

/* The complex modes whose real parts are nearest to 0, nearest first. */
static inline int eigen_critical(const double par[], double _Complex target[2])
{
  const struct eigen_values e = eigen_values(par);
  int found = 0;

  for (int i = 0; i < NDIM; i++)
    if (e.im[i] > 0.) {
      const double _Complex value = e.re[i] + e.im[i] * I;

      if (found == 0 || fabs(e.re[i]) < fabs(creal(target[0]))) {
        if (found)
          target[1] = target[0];
        target[0] = value;
      } else if (found == 1 || fabs(e.re[i]) < fabs(creal(target[1]))) {
        target[1] = value;
      }
      found++;
    }
  return found < 2 ? found : 2;
}

/* Refines a point in place.  The unknowns are par[slot[..]], V first:
 *   EIGEN_HH      V, p       two real parts are 0
 *   EIGEN_FOLD    V, p       a real part and its slope in V are 0: p is extreme
 *   EIGEN_CENTRE  V, p, q    and its slope in p too: in the plane of V and p
 *                            two boundaries meet, or one is about to appear
 * Returns the last relative change, or -1 when Newton's method goes nowhere. */
static inline double eigen_refine(enum eigen_condition condition, double par[], const int slot[])
{
  const int n = condition == EIGEN_CENTRE ? 3 : 2;
  double _Complex target[2] = { 0. };
  double last = HUGE_VAL;

  if (eigen_critical(par, target) < (condition == EIGEN_HH ? 2 : 1))
    return -1.;
  for (int iteration = 0; iteration < 60; iteration++) {
    double p[EIGEN_SLOTS], residual[3], J[9], change = 0.;
    lapack_int pivot[3];

    eigen_residual(condition, par, slot, target, residual);
    memcpy(p, par, sizeof p);
    for (int j = 0; j < n; j++) {
      const double step = 1e-5 * fabs(par[slot[j]]);
      double ahead[3], behind[3];

      for (int sign = -1; sign <= 1; sign += 2) {
        double _Complex near[2] = { target[0], target[1] };

        p[slot[j]] = par[slot[j]] + sign * step;
        eigen_residual(condition, p, slot, near, sign > 0 ? ahead : behind);
      }
      p[slot[j]] = par[slot[j]];
      for (int i = 0; i < n; i++) /* columns: relative changes of the unknowns */
        J[i + n * j] = (ahead[i] - behind[i]) / 2e-5;
    }
    if (LAPACKE_dgesv(LAPACK_COL_MAJOR, n, 1, J, n, pivot, residual, n) != 0)
      return -1.;
    for (int j = 0; j < n; j++)
      change = fmax(change, fabs(residual[j]));
    if (!(change < 1e6) || (change < 1e-8 && change >= last)) /* rounding only */
      return change < 1e-8 ? last : -1.;
    for (int j = 0; j < n; j++)
      par[slot[j]] *= 1. - residual[j] * fmin(1., 0.2 / change);
    last = change;
    if (change < 1e-15)
      return change;
  }
  return last < 1e-8 ? last : -1.;
}

/* ---- crossings along one parameter ---------------------------------------- */

struct eigen_crossing {
  double at;
  double frequency_hz;   /* 0: a real eigenvalue (divergence), no Hopf point */
  double delta_over_psi;
  bool loses_stability;  /* the mode, with the parameter rising */
};

static inline double eigen_real_part(const double par[], int slot, double at, int rank)
{
  double p[EIGEN_SLOTS];

  memcpy(p, par, sizeof p);
  p[slot] = at;
  return eigen_values(p).re[rank];
}

/* Zero of the real part of a rank between two values where its signs differ,
 * to the last bits. */
static inline double eigen_root(const double par[], int slot, double lo, double hi, int rank)
{
  const bool left = eigen_real_part(par, slot, lo, rank) < 0.;

  for (int i = 0; i < 100; i++) {
    const double middle = lo + (hi - lo) / 2.;

    if (middle <= lo || middle >= hi)
      break;
    if ((eigen_real_part(par, slot, middle, rank) < 0.) == left)
      lo = middle;
    else
      hi = middle;
  }
  return lo + (hi - lo) / 2.;
}

/* Point where sign * real part is largest between two values (golden section),
 * or any where it is above 0. */
static inline double eigen_summit(const double par[], int slot, double lo, double hi, int rank, int sign)
{
  const double golden = (sqrt(5.) - 1.) / 2.;
  double x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo);
  double f1 = sign * eigen_real_part(par, slot, x1, rank);
  double f2 = sign * eigen_real_part(par, slot, x2, rank);

  for (int i = 0; i < 45 && f1 <= 0. && f2 <= 0.; i++)
    if (f1 > f2) {
      hi = x2, x2 = x1, f2 = f1;
      x1 = hi - golden * (hi - lo);
      f1 = sign * eigen_real_part(par, slot, x1, rank);
    } else {
      lo = x1, x1 = x2, f1 = f2;
      x2 = lo + golden * (hi - lo);
      f2 = sign * eigen_real_part(par, slot, x2, rank);
    }
  return f1 > f2 ? x1 : x2;
}

/* Every crossing of the imaginary axis with from <= par[slot] <= to, in order.
 * The k-th largest real part is a continuous function of the parameter; each
 * is followed on a grid, and where it turns short of 0 between grid points the
 * turn is refined, so that two crossings within a step are found too.  Returns
 * how many there are; the first room of them are written. */
static inline int eigen_crossings(const double par[], int slot, double from, double to, double step,
                                  struct eigen_crossing crossing[], int room)
{
  const int n = (int)fmax(2., ceil((to - from) / step - 1e-9));
  double *re = malloc((size_t)(n + 1) * NDIM * sizeof *re), p[EIGEN_SLOTS];
  int found = 0;

  if (re == NULL)
    abort();
  memcpy(p, par, sizeof p);
#define AT(i) (from + (to - from) * (i) / n)
#define RE(i) re[(size_t)(i) * NDIM + (size_t)k]
  for (int i = 0; i <= n; i++) {
    p[slot] = AT(i);
    const struct eigen_values e = eigen_values(p);

    memcpy(re + (size_t)i * NDIM, e.re, sizeof e.re);
  }
  for (int k = 0; k < NDIM; k++)
    for (int i = 0; i <= n; i++) {
      const int before = i > 0 ? i - 1 : 0, after = i < n ? i + 1 : n;
      const bool left = RE(i) < 0.;
      double root[2];
      int roots = 0;

      if (i < n && left != (RE(after) < 0.)) {
        root[roots++] = eigen_root(par, slot, AT(i), AT(after), k);
      } else if (left == (RE(before) < 0.) && left == (RE(after) < 0.)) {
        const int sign = left ? 1 : -1;

        if (sign * RE(i) >= sign * RE(before) && sign * RE(i) >= sign * RE(after)) {
          const double summit = eigen_summit(par, slot, AT(before), AT(after), k, sign);

          if ((eigen_real_part(par, slot, summit, k) < 0.) != left) {
            root[roots++] = eigen_root(par, slot, AT(before), summit, k);
            root[roots++] = eigen_root(par, slot, summit, AT(after), k);
          }
        }
      }
      for (int r = 0; r < roots; r++) {
        p[slot] = root[r];
        const struct eigen_values e = eigen_values(p);
        const struct eigen_mode mode = eigen_mode(p, e.re[k] + e.im[k] * I);
        const struct eigen_crossing c = { root[r], mode.frequency_hz, mode.delta_over_psi, r == 0 ? left : !left };
        int j = found;

        if (e.im[k] < 0.) /* found with the other of the pair */
          continue;
        if (found++ >= room)
          continue;
        for (; j > 0 && crossing[j - 1].at > c.at; j--)
          crossing[j] = crossing[j - 1];
        crossing[j] = c;
      }
    }
#undef AT
#undef RE
  free(re);
  return found;
}

/* ---- zero-shimmy intervals -------------------------------------------------- */

struct eigen_interval {
  double c_d[2], V[2];    /* its ends, and the speeds at which shimmy sets in */
  double frequency_hz[2];
  bool open[2];           /* the scan ends here, not the interval */
};

struct eigen_scan { double V_lo, V_hi, step, c_d_lo, c_d_hi; int c_d_steps; };

/* Largest real part over all speeds, and the speed where it is. */
static inline double eigen_worst(const double par[], const struct eigen_scan *scan, double c_d, double *V)
{
  const int n = (int)fmax(2., ceil((scan->V_hi - scan->V_lo) / scan->step - 1e-9));
  double p[EIGEN_SLOTS], A0[NDIM * NDIM], dA[NDIM * NDIM], A[NDIM * NDIM];
  double worst = -HUGE_VAL, at[3] = { 0. }, re[3] = { 0. };

  memcpy(p, par, sizeof p);
  p[PAR_C_D] = c_d;
  p[PAR_V] = 0.;
  eigen_jacobian(p, A0);
  p[PAR_V] = scan->V_hi;
  eigen_jacobian(p, dA);
  for (int i = 0; i < NDIM * NDIM; i++)
    dA[i] = (dA[i] - A0[i]) / scan->V_hi; /* degree 1 in V */
  for (int k = 0; k <= n + 1; k++) {
    at[0] = at[1], re[0] = re[1];
    at[1] = at[2], re[1] = re[2];
    if (k <= n) {
      at[2] = scan->V_lo + (scan->V_hi - scan->V_lo) * k / n;
      for (int i = 0; i < NDIM * NDIM; i++)
        A[i] = A0[i] + at[2] * dA[i];
      re[2] = eigen_of_matrix(A).re[0];
    } else {
      re[2] = -HUGE_VAL;
    }
    if (k > 0 && re[1] > worst) {
      worst = re[1];
      *V = at[1];
    }
    /* a summit between samples */
    if (k > 1 && k <= n && re[1] >= re[0] && re[1] >= re[2] && re[1] < 0. && re[1] > -1.) {
      const double summit = eigen_summit(p, PAR_V, at[0], at[2], 0, 1);
      const double top = eigen_real_part(p, PAR_V, summit, 0);

      if (top > worst) {
        worst = top;
        *V = summit;
      }
    }
  }
  return worst;
}

/* End of an interval between c_d that are free of shimmy and not. */
static inline void eigen_interval_end(const double par[], const struct eigen_scan *scan, double quiet,
                                      double shimmy, double *c_d, double *V, double *frequency_hz)
{
  static const int slot[2] = { PAR_V, PAR_C_D };
  double p[EIGEN_SLOTS];
  double _Complex target[2] = { 0. };

  eigen_worst(par, scan, shimmy, V);
  while (fabs(shimmy - quiet) > 1e-6 * quiet) {
    const double middle = (quiet + shimmy) / 2.;
    double at;

    if (eigen_worst(par, scan, middle, &at) < 0.) {
      quiet = middle;
    } else {
      shimmy = middle;
      *V = at;
    }
  }
  memcpy(p, par, sizeof p);
  p[PAR_V] = *V;
  p[PAR_C_D] = shimmy;
  if (*V > scan->V_lo && *V < scan->V_hi && eigen_refine(EIGEN_FOLD, p, slot) >= 0.
      && fabs(p[PAR_C_D] - shimmy) < 1e-4 * shimmy) {
    *V = p[PAR_V];
  } else { /* at an end of the range of speeds */
    p[PAR_V] = *V;
    p[PAR_C_D] = eigen_root(p, PAR_C_D, fmin(quiet, shimmy), fmax(quiet, shimmy), 0);
  }
  *c_d = p[PAR_C_D];
  eigen_critical(p, target);
  *frequency_hz = eigen_mode(p, target[0]).frequency_hz;
}

/* Intervals of c_d, between c_d_lo and c_d_hi, in which straight rolling is
 * stable at every speed from V_lo to V_hi.  The scan is by equal ratios; a
 * dip of the worst real part between its points is followed, so that a narrow
 * interval is found too.  Returns how many; the first room are written. */
static inline int eigen_intervals(const double par[], const struct eigen_scan *scan,
                                  struct eigen_interval interval[], int room)
{
  const int n = scan->c_d_steps;
  double *c_d = malloc(2 * (size_t)(n + 1) * sizeof *c_d), *worst = malloc(2 * (size_t)(n + 1) * sizeof *worst);
  double V;
  int points = 0, found = 0;

  if (c_d == NULL || worst == NULL)
    abort();
  for (int i = 0; i <= n; i++) {
    const double next = scan->c_d_lo * pow(scan->c_d_hi / scan->c_d_lo, (double)i / n);
    const double next_worst = eigen_worst(par, scan, next, &V);

    /* a dip at the last point: insert its bottom when shimmy stops there */
    if (points > 1 && worst[points - 1] >= 0. && worst[points - 1] <= worst[points - 2]
        && worst[points - 1] <= next_worst) {
      double lo = c_d[points - 2], hi = next, bottom = c_d[points - 1], bottom_worst = worst[points - 1];

      for (int k = 0; k < 25 && bottom_worst >= 0.; k++) {
        const bool right = hi - bottom > bottom - lo;
        const double x = bottom + 0.382 * ((right ? hi : lo) - bottom);
        const double x_worst = eigen_worst(par, scan, x, &V);

        if (x_worst < bottom_worst) {
          *(right ? &lo : &hi) = bottom;
          bottom = x, bottom_worst = x_worst;
        } else {
          *(right ? &hi : &lo) = x;
        }
      }
      if (bottom_worst < 0.) {
        const bool right = bottom > c_d[points - 1];

        c_d[points] = right ? bottom : c_d[points - 1];
        worst[points] = right ? bottom_worst : worst[points - 1];
        if (!right) {
          c_d[points - 1] = bottom;
          worst[points - 1] = bottom_worst;
        }
        points++;
      }
    }
    c_d[points] = next;
    worst[points++] = next_worst;
  }
  for (int i = 0; i < points; i++) {
    if (!(worst[i] < 0.))
      continue;
    struct eigen_interval z = { .c_d = { c_d[i], 0. }, .open = { i == 0, false } };

    if (!z.open[0])
      eigen_interval_end(par, scan, c_d[i], c_d[i - 1], &z.c_d[0], &z.V[0], &z.frequency_hz[0]);
    while (i + 1 < points && worst[i + 1] < 0.)
      i++;
    z.c_d[1] = c_d[i];
    z.open[1] = i + 1 == points;
    if (!z.open[1])
      eigen_interval_end(par, scan, c_d[i], c_d[i + 1], &z.c_d[1], &z.V[1], &z.frequency_hz[1]);
    if (found++ < room)
      interval[found - 1] = z;
  }
  free(c_d);
  free(worst);
  return found;
}

#endif
