/* test_layout.c - what any layout must keep, and the closed forms of each
 *
 * Built once per layout, -DLAYOUT='"l1.c"' -o test-l1.  It includes the layout,
 * so that it sees device(), func(), pvls() and the helpers of plugin.h, and
 * stands in for AUTO's getp(), getmdmx_() and its variables.
 */
#include LAYOUT

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include "characteristic.h"
#include "eigen.h"
#include "libmlg.h"

#undef abs
#include <cmocka.h>

#include "numbers.h"

enum { SAMPLES = 500, SLOTS = EIGEN_SLOTS, OWN = NDIM - GEAR_STATES };

static double log_uniform(double lo, double hi)
{
  return lo * pow(hi / lo, uniform(0., 1.));
}

/* ---- AUTO's part: an orbit on a mesh, and its monodromy matrix ------------ */

static struct {
  int intervals, per_interval, stride; /* no intervals: an equilibrium */
  double width[64];                    /* of the mesh intervals, sum 1 */
} mesh;

static struct {
  int known;
  double P0[NDIM * NDIM], P1[NDIM * NDIM];
} monodromy;

doublereal getp(const char *code, integer ic, const doublereal *u)
{
  (void)u;
  if (strcmp(code, "NTS") == 0)
    return mesh.intervals;
  if (strcmp(code, "NCO") == 0)
    return mesh.per_interval;
  if (strcmp(code, "NDX") == 0)
    return mesh.stride;
  if (strcmp(code, "DTM") == 0) {
    if (mesh.intervals == 0)
      return 0.;
    if (ic >= 1 && ic <= mesh.intervals)
      return mesh.width[ic - 1];
  }
  fail_msg("getp(\"%s\", %d): not AUTO's", code, ic);
  return NAN;
}

void getmdmx_(const integer *ndim, double *P0, double *P1, int *known)
{
  assert_int_equal(*ndim, NDIM);
  memcpy(P0, monodromy.P0, sizeof monodromy.P0);
  memcpy(P1, monodromy.P1, sizeof monodromy.P1);
  *known = monodromy.known;
}

/* ---- states and parameters -------------------------------------------------- */

static int seed(void **state)
{
  (void)state;
  random_state = 20170408;
  memset(&mesh, 0, sizeof mesh);
  memset(&monodromy, 0, sizeof monodromy);
  return 0;
}

static void rates(const double par[], const double u[], double f[])
{
  func(NDIM, u, NULL, par, 0, f, NULL, NULL);
}

/* Every parameter of the gear off its default; a device of any kind. */
static void random_parameters(double par[])
{
  for (int i = 0; i < SLOTS; i++)
    par[i] = 0.;
  mlg_defaults(par);
#define X(slot, id, name, unit, value, least, most, meaning) \
  if (PAR_##id < PAR_ZB_SHARED || PAR_##id > PAR_N12_OUT)       \
    par[PAR_##id] *= uniform(0.7, 1.3);
  MLG_PARAMETERS(X)
#undef X
  par[PAR_V] = uniform(0., 200.);
  par[PAR_PHI] = uniform(-0.3, 0.3);
  par[PAR_C_D] = log_uniform(10., 1e6);
  par[PAR_K_S] = log_uniform(1e4, 1e7);
  par[PAR_B] = log_uniform(1., 1e3);

  const uint64_t before = random_state; /* what follows draws what it drew without doubts */

  if (uniform(0., 1.) < 0.5) { /* all doubts */
    par[PAR_ZB_SHARED] = uniform(0., 1.);
    par[PAR_R_MOVES] = uniform(0., 1.);
    par[PAR_HEADING] = uniform(0., 1.);
    par[PAR_I_P] = uniform(0., 20.);
    par[PAR_N12_OUT] = uniform(0., 1.);
  }
  random_state = before;
}

static void random_state_vector(double u[])
{
  for (int i = 0; i < NDIM; i++)
    u[i] = uniform(-0.5, 0.5);
  u[DDELTA] *= 10.;
  u[DPSI] *= 20.;
  u[LAMBDA_L] *= 0.16;
  u[LAMBDA_R] *= 0.16;
}

/* The ends of the ranges that a continuation reaches. */
static void limiting(double par[], int which)
{
  if (which & 1)
    par[PAR_C_D] = 0.;
  if (which & 2)
    par[PAR_V] = 0.;
  if (which & 4)
    par[PAR_K_S] = MLG_RIGID;
  if (which & 8)
    par[PAR_B] = 0.;
}

/* ---- func() ------------------------------------------------------------------ */

static void starts_at_straight_rolling(void **state)
{
  double par[SLOTS] = { 0. }, expected[SLOTS] = { 0. }, u[NDIM];

  (void)state;
  for (int i = 0; i < NDIM; i++)
    u[i] = 1.;
  stpnt(NDIM, 0., u, par);
  mlg_defaults(expected);
  for (int i = 0; i < NDIM; i++)
    assert_near(u[i], 0., 0.);
  for (int i = 0; i < SLOTS; i++)
    assert_near(par[i], expected[i], 0.);
}

static void zero_is_an_equilibrium_at_every_speed(void **state)
{
  const double zero[NDIM] = { 0. };
  double par[SLOTS], f[NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    limiting(par, n % 16);
    rates(par, zero, f);
    for (int i = 0; i < NDIM; i++)
      assert_near(f[i], 0., 0.);
  }
}

static void mirror(const double u[], double v[])
{
  for (int i = 0; i < NDIM; i++)
    v[i] = -u[i];
  v[LAMBDA_L] = -u[LAMBDA_R];
  v[LAMBDA_R] = -u[LAMBDA_L];
}

static void mirror_symmetry(void **state)
{
  double par[SLOTS], u[NDIM], mirrored[NDIM], f[NDIM], expected[NDIM], got[NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_state_vector(u);
    rates(par, u, f);
    mirror(f, expected);
    mirror(u, mirrored);
    rates(par, mirrored, got);
    for (int i = 0; i < NDIM; i++) /* accelerations are sums of terms of some 1e4 rad/s^2 */
      assert_near(got[i], expected[i], 1e-13 * (fabs(expected[i]) + 1e4));
  }
}

static void func_is_finite(void **state)
{
  double par[SLOTS], u[NDIM], f[NDIM];

  (void)state;
  for (int n = 0; n < 20 * SAMPLES; n++) {
    random_parameters(par);
    limiting(par, n % 16);
    random_state_vector(u);
    for (int upright = 0; upright < 2; upright++) {
      if (upright) { /* the axle stands: the argument of asin in mu (16) is 1 to rounding, or past it */
        const double sign = n & 16 ? 1. : -1.;

        u[DELTA] = sign * MLG_PI / 2.;
        u[PSI] = sign * par[PAR_PHI];
      }
      for (int i = 0; i < NDIM; i++)
        f[i] = NAN;
      rates(par, u, f);
      for (int i = 0; i < NDIM; i++)
        if (!isfinite(f[i]))
          fail_msg("f[%d] = %g with c_d = %g, V = %g, k_s = %g, b = %g, delta = %.17g, psi = %.17g", i, f[i],
                   par[PAR_C_D], par[PAR_V], par[PAR_K_S], par[PAR_B], u[DELTA], u[PSI]);
    }
  }
}

/* libmlg under the layout's name is the same model, its states in the same order. */
static void libmlg_is_func(void **state)
{
  static const char *const names[] = {
#define X(id, name, unit, meaning) name,
    MLG_STATES(X)
#undef X
  };
  char name[] = LAYOUT;
  double par[SLOTS], packed[LIBMLG_MOST_PARAMETERS], u[NDIM], f[NDIM], expected[NDIM];
  double dfdu[NDIM * NDIM], dfdp[LIBMLG_MOST_PARAMETERS * NDIM], dfdu_expected[NDIM * NDIM], dfdp_expected[SLOTS * NDIM];
  int layout;

  (void)state;
  *strchr(name, '.') = '\0';
  layout = libmlg_layout(name);
  assert_int_equal(libmlg_states(layout), NDIM);
  for (int i = 0; i < NDIM; i++)
    assert_int_equal(libmlg_state(layout, names[i]), i);
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    limiting(par, n % 16);
    random_state_vector(u);
    rates(par, u, expected);
#define X(slot, id, name, unit, value, least, most, meaning) packed[libmlg_parameter(name)] = par[PAR_##id];
    MLG_PARAMETERS(X)
#undef X
    assert_int_equal(libmlg_outside(packed), LIBMLG_NONE);
    assert_int_equal(libmlg_rhs(layout, packed, u, f), 0);
    for (int i = 0; i < NDIM; i++)
      assert_near(f[i], expected[i], 1e-12 * fabs(expected[i]));
    derivatives(par, u, expected, dfdu_expected, dfdp_expected);
    assert_int_equal(libmlg_jacobian(layout, packed, u, dfdu, dfdp), 0);
    for (int i = 0; i < NDIM * NDIM; i++)
      assert_near(dfdu[i], dfdu_expected[i], 1e-12 * fabs(dfdu_expected[i]));
#define X(slot, id, name, unit, value, least, most, meaning)                                       \
    for (int i = 0; i < NDIM; i++)                                                                 \
      assert_near(dfdp[libmlg_parameter(name) * NDIM + i], dfdp_expected[PAR_##id * NDIM + i],     \
                  1e-9 * fabs(dfdp_expected[PAR_##id * NDIM + i]));
    MLG_PARAMETERS(X)
#undef X
  }
}

static void libmlg_knows_what_is_none(void **state)
{
  double par[LIBMLG_MOST_PARAMETERS], u[NDIM] = { 0. }, f[NDIM] = { 7. };
  struct libmlg_mode mode;
  int none;

  (void)state;
  assert_int_equal(libmlg_layout("l9"), LIBMLG_NONE);
  assert_int_equal(libmlg_state(0, "eps9"), LIBMLG_NONE);
  assert_int_equal(libmlg_parameter("c_q"), LIBMLG_NONE);
  for (int i = -1; i <= libmlg_layouts(); i += libmlg_layouts() + 1) {
    assert_null(libmlg_layout_name(i));
    assert_null(libmlg_state_quantity(i, 0));
    assert_int_equal(libmlg_states(i), LIBMLG_NONE);
    assert_int_equal(libmlg_state(i, "psi"), LIBMLG_NONE);
    assert_int_equal(libmlg_rhs(i, par, u, f), LIBMLG_NONE);
    assert_int_equal(libmlg_jacobian(i, par, u, f, NULL), LIBMLG_NONE);
    assert_int_equal(libmlg_torque(i, par, u, f), LIBMLG_NONE);
    assert_int_equal(libmlg_uses(i, 0), LIBMLG_NONE);
    assert_int_equal(libmlg_eigenvalues(i, par, f, f, &none), LIBMLG_NONE);
    assert_int_equal(libmlg_least_damped(i, par, &mode), LIBMLG_NONE);
    assert_int_equal(libmlg_criticality(i, par, 50., &mode, f), LIBMLG_NONE);
    assert_int_equal(libmlg_growth_slope(i, par, &mode, 0, f), LIBMLG_NONE);
  }
  assert_near(f[0], 7., 0.);
  assert_null(libmlg_state_quantity(0, libmlg_states(0)));
  for (int i = -1; i <= libmlg_parameters(); i += libmlg_parameters() + 1) {
    assert_null(libmlg_parameter_quantity(i));
    assert_true(isnan(libmlg_least(i)) && isnan(libmlg_most(i)));
    assert_true(isnan(libmlg_default(i)));
  }
  for (int i = 0; i < libmlg_parameters(); i++) {
    const int k_s = i == libmlg_parameter("k_s");
    const double bound[] = { libmlg_least(i), libmlg_most(i) };
    const double outside[] = { bound[0] - 1., k_s ? -INFINITY : 2. * bound[1], k_s ? 0. : INFINITY, NAN };

    libmlg_defaults(par);
    assert_int_equal(libmlg_outside(par), LIBMLG_NONE);
    for (int k = 0; k < 2; k++) {
      par[i] = bound[k];
      assert_int_equal(libmlg_outside(par), LIBMLG_NONE);
    }
    for (int k = 0; k < 4; k++) {
      par[i] = outside[k];
      assert_int_equal(libmlg_outside(par), i);
    }
  }
}

/* What is no number comes back as a failure, not as an end of the program. */
static void libmlg_fails_on_no_numbers(void **state)
{
  double par[LIBMLG_MOST_PARAMETERS], re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES], a;
  struct libmlg_mode mode;
  int n;

  (void)state;
  libmlg_defaults(par);
  par[libmlg_parameter("J_zeta")] = NAN;
  assert_int_equal(libmlg_eigenvalues(0, par, re, im, &n), LIBMLG_FAILED);
  assert_int_equal(libmlg_least_damped(0, par, &mode), LIBMLG_FAILED);
  assert_int_equal(libmlg_criticality(0, par, 50., &mode, &a), LIBMLG_FAILED);
}

/* The eigenvalues of libmlg, of the exact Jacobian and without states that only follow,
 * are those of the oracle, which differences func() and keeps such states. */
static void libmlg_eigenvalues_are_the_oracles(void **state)
{
  char name[] = LAYOUT;
  double par[SLOTS], packed[LIBMLG_MOST_PARAMETERS], re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES];
  struct libmlg_mode mode;
  int layout, n;

  (void)state;
  *strchr(name, '.') = '\0';
  layout = libmlg_layout(name);
  for (int sample = 0; sample < SAMPLES; sample++) {
    random_parameters(par);
    limiting(par, sample % 16 & ~3); /* rigid k_s, b = 0 */
    const struct eigen_values e = eigen_values(par);
    int followers = 0;

#define X(slot, id, name, unit, value, least, most, meaning) packed[libmlg_parameter(name)] = par[PAR_##id];
    MLG_PARAMETERS(X)
#undef X
    assert_int_equal(libmlg_eigenvalues(layout, packed, re, im, &n), 0);
    for (int i = 0, k = 0; i < NDIM; i++)
      if (k < n && hypot(e.re[i] - re[k], e.im[i] - im[k]) <= 1e-7 * (100. + hypot(e.re[i], e.im[i])))
        k++;
      else { /* two that follow one another make a double eigenvalue */
        assert_near(e.re[i], -MLG_FOLLOW, 0.1);
        assert_near(e.im[i], 0., 0.1);
        followers++;
      }
    assert_int_equal(n + followers, NDIM);
    assert_true(followers == 0 || sample % 16 >= 4);

    /* the mode of the least damping ratio is one of them, and none is below it */
    assert_int_equal(libmlg_least_damped(layout, packed, &mode), 0);
    for (int i = 0; i < n; i++)
      if (im[i] >= 0.)
        assert_true(-re[i] / hypot(re[i], im[i]) >= mode.zeta);
    assert_near(mode.zeta, -mode.re / hypot(mode.re, mode.im), 1e-9);
  }
}

/* MODEL: M q'' + C q' + K q + D lambda + (0, T_d) = 0 at straight rolling, in
 * closed form; the device by its own unit vectors. */
static void linearisation_is_the_closed_form(void **state)
{
  double par[SLOTS], A[NDIM * NDIM], expected[NDIM * NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    const double s = sin(par[PAR_PHI]), c = cos(par[PAR_PHI]), a = par[PAR_A], g = par[PAR_G];
    const double m_D = par[PAR_M_D], l_D = par[PAR_L_D], l = par[PAR_L], V = par[PAR_V];
    const double F = (par[PAR_M] + m_D) * g, et = par[PAR_E] + par[PAR_R] * s;
    const double length = par[PAR_L_DELTA] + par[PAR_R] * c;
    const double m = a * a * m_D / 4. * (1. - par[PAR_ZB_SHARED]) * (1. - 0.2 * par[PAR_R_MOVES]), kap = a * a * par[PAR_K_T] / 2.;
    const double M11 = par[PAR_J_XI] + m_D * l_D * l_D + m * c * c, M12 = m * c * s;
    const double M22 = par[PAR_J_ZETA] + m * s * s, det = M11 * M22 - M12 * M12;
    const double K11 = par[PAR_K_DELTA] - F * length * c + kap * c * c + m_D * g * l_D * c;
    const double K12 = -F * et * c + kap * c * s, K22 = -F * et * s + kap * s * s;
    const double D1 = F * (7. * par[PAR_K_LAMBDA] * length - par[PAR_K_ALPHA] * s) / l;
    const double D2 = F * (7. * par[PAR_K_LAMBDA] * et + par[PAR_K_ALPHA] * c) / l;
    const double bent = par[PAR_HEADING] * s, spin = par[PAR_I_P] * V / par[PAR_R];

    for (int j = 0; j < NDIM; j++) {
      double unit[NDIM] = { 0. }, *column = expected + NDIM * j;

      for (int i = 0; i < NDIM; i++)
        column[i] = 0.;
      unit[j] = 1.;
      const double T_d = device(par, unit, column);
      const double on_delta = K11 * unit[DELTA] + K12 * unit[PSI] + par[PAR_C_DELTA] * unit[DDELTA]
                              + spin * unit[DPSI] + D1 * (unit[LAMBDA_L] + unit[LAMBDA_R]) / 2.;
      const double on_psi = K12 * unit[DELTA] + K22 * unit[PSI] + par[PAR_C_PSI] * unit[DPSI]
                            - spin * unit[DDELTA] + D2 * (unit[LAMBDA_L] + unit[LAMBDA_R]) / 2. + T_d;

      column[DELTA] = unit[DDELTA];
      column[PSI] = unit[DPSI];
      column[DDELTA] = (-M22 * on_delta + M12 * on_psi) / det;
      column[DPSI] = (M12 * on_delta - M11 * on_psi) / det;
      for (int i = LAMBDA_L; i <= LAMBDA_R; i++)
        column[i] = (length + par[PAR_H] * bent) * unit[DDELTA] + V * (c * unit[PSI] - bent * unit[DELTA])
                    + (et - par[PAR_H] * c) * unit[DPSI] - V / l * unit[i];
    }
    eigen_jacobian(par, A);
    for (int j = 0; j < NDIM; j++) {
      double largest = 0.;

      for (int i = 0; i < NDIM; i++)
        largest = fmax(largest, fabs(expected[i + NDIM * j]));
      for (int i = 0; i < NDIM; i++)
        assert_near(A[i + NDIM * j], expected[i + NDIM * j], 1e-13 * largest);
    }
  }
}

/* ---- derivatives --------------------------------------------------------------- */

/* d(rates)/dx by the central difference of tenth order; x is a number in par or u. */
static void slope(const double par[], const double u[], double *x, double step, double df[])
{
  const double at = *x;

  for (int i = 0; i < NDIM; i++)
    df[i] = 0.;
  for (int k = 5; k > 0; k--)
    for (int sign = -1; sign <= 1; sign += 2) {
      double f[NDIM];

      *x = at + sign * k * step;
      rates(par, u, f);
      for (int i = 0; i < NDIM; i++)
        df[i] += sign * eigen_weight[k - 1] / step * f[i];
    }
  *x = at;
}

/* A column within 1e-10 of its largest, and 1e-12 of f per change of x by itself,
 * which is what rounding leaves of the difference. */
static void assert_column(const char *name, const double got[], const double expected[],
                          const double f[], double x)
{
  double largest = 0., rounding = 0.;

  for (int i = 0; i < NDIM; i++) {
    largest = fmax(largest, fabs(expected[i]));
    rounding = fmax(rounding, 1e-12 * fabs(f[i] / x));
  }
  for (int i = 0; i < NDIM; i++)
    if (!(fabs(got[i] - expected[i]) <= 1e-10 * largest + rounding))
      fail_msg("d f[%d]/d %s = %.17g, expected %.17g; largest %g, rounding %g", i, name, got[i],
               expected[i], largest, rounding);
}

/* Tyres are kept off the slope jump at alpha_m. */
static void derivatives_are_those_of_func(void **state)
{
  static const char *const name[NDIM] = {
#define X(id, name, unit, meaning) name,
    MLG_STATES(X)
#undef X
  };
  double par[SLOTS], u[NDIM], f[NDIM], dfdu[NDIM * NDIM], dfdp[SLOTS * NDIM], expected[NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    if (n % 2)
      limiting(par, n / 2 % 16);
    random_state_vector(u);
    for (int tyre = LAMBDA_L; tyre <= LAMBDA_R; tyre++) {
      const double alpha = par[PAR_ALPHA_M] * uniform(-1.4, 1.4);

      u[tyre] = par[PAR_L] * tan(fabs(alpha / par[PAR_ALPHA_M]) < 0.8 ? alpha : 1.4 * alpha);
    }
    func(NDIM, u, NULL, par, 2, f, dfdu, dfdp);
    for (int j = 0; j < NDIM; j++) {
      slope(par, u, &u[j], 5e-3 * fabs(u[j]), expected);
      assert_column(name[j], dfdu + j * NDIM, expected, f, u[j]);
    }
    for (int k = 0; k < MLG_PARAMETER_COUNT; k++) {
      const int j = mlg_parameters[k].slot;

      const int doubt = j >= PAR_ZB_SHARED && j <= PAR_N12_OUT;

      if (doubt || (fabs(par[j]) > 0. && par[j] < MLG_RIGID)) { /* else the device has none */
        slope(par, u, &par[j], doubt ? 0.01 : 2e-3 * par[j], expected);
        assert_column(mlg_parameters[k].name, dfdp + j * NDIM, expected, f, doubt ? 1. : par[j]);
      }
    }
    if (n < 16)
      assert_true(derivatives_misfit(par) < 1e-7);
  }
}

/* AUTO has room for d f/d par at ijac = 2 only, and for NPAR columns; what is
 * asked for does not hang on what was there before. */
static void func_writes_what_it_is_asked_for(void **state)
{
  const double mark = -1.5e300;
  double par[SLOTS], u[NDIM], f[3][NDIM], dfdu[2][NDIM * NDIM + 1], dfdp[2][SLOTS * NDIM];

  (void)state;
  random_parameters(par);
  random_state_vector(u);
  rates(par, u, f[0]);
  for (int ijac = 1; ijac <= 2; ijac++) {
    double *const A = dfdu[ijac - 1], *const P = dfdp[ijac - 1];

    for (int i = 0; i <= NDIM * NDIM; i++)
      A[i] = mark;
    for (int i = 0; i < SLOTS * NDIM; i++)
      P[i] = mark;
    func(NDIM, u, NULL, par, ijac, f[ijac], A, P);
    assert_memory_equal(f[ijac], f[0], sizeof f[0]);
    for (int i = 0; i < NDIM * NDIM; i++)
      assert_true(isfinite(A[i]) && A[i] > mark);
    assert_near(A[NDIM * NDIM], mark, 0.);
    for (int j = 0; j < SLOTS; j++) {
      int ours = 0;

      for (int k = 0; k < MLG_PARAMETER_COUNT; k++)
        ours += mlg_parameters[k].slot == j;
      for (int i = 0; i < NDIM; i++)
        assert_true((P[j * NDIM + i] > mark) == (ours && ijac == 2));
    }
  }
  assert_memory_equal(dfdu[0], dfdu[1], sizeof dfdu[0]);
}

/* ---- laws (elements.h) ------------------------------------------------------------ */

/* Each law is on or off, as the bits of n say; corners are rounded. */
static void some_laws(double par[], int n)
{
  par[PAR_CORNER] = uniform(0.3, 1.);
  par[PAR_V_F] = uniform(0.1, 1.);
  par[PAR_C_R] = log_uniform(1e2, 1e4);
  par[PAR_G_PSI] = n & 1 ? log_uniform(1e-3, 1e-2) : 0.;
  par[PAR_G_S] = n & 2 ? log_uniform(1e-3, 1e-2) : 0.;
  par[PAR_T_F] = n & 4 ? uniform(1., 1e3) : 0.;
  par[PAR_T_PSI] = n & 8 ? uniform(1., 1e3) : 0.;
  par[PAR_C_2] = n & 16 ? log_uniform(1., 1e5) : 0.;
  par[PAR_T_MAX] = n & 32 ? log_uniform(1e2, 1e5) : 0.;
  par[PAR_K_S3] = n & 64 ? log_uniform(1e5, 1e8) : 0.;
  par[PAR_K_D3] = n & 128 ? log_uniform(1e5, 1e8) : 0.;
}

static void laws_keep_the_mirror_symmetry(void **state)
{
  const double zero[NDIM] = { 0. };
  double par[SLOTS], u[NDIM], mirrored[NDIM], f[NDIM], expected[NDIM], got[NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    some_laws(par, n);
    limiting(par, n / 3 % 16);
    rates(par, zero, f);
    for (int i = 0; i < NDIM; i++)
      assert_near(f[i], 0., 0.);
    random_state_vector(u);
    rates(par, u, f);
    mirror(f, expected);
    mirror(u, mirrored);
    rates(par, mirrored, got);
    for (int i = 0; i < NDIM; i++) {
      assert_true(isfinite(f[i]));
      assert_near(got[i], expected[i], 1e-11 * (fabs(expected[i]) + 1e4));
    }
  }
}

/* Differences on both sides: 1e-5 of the largest of a column. */
static void derivatives_with_laws(void **state)
{
  double par[SLOTS], u[NDIM], f[NDIM], dfdu[NDIM * NDIM], dfdp[SLOTS * NDIM], expected[NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    some_laws(par, n);
    if (n % 2)
      limiting(par, n / 2 % 16 & ~1); /* without c_d friction alone would be divided by */
    random_state_vector(u);
    u[LAMBDA_L] = par[PAR_L] * tan(par[PAR_ALPHA_M] / 3.);
    u[LAMBDA_R] = -u[LAMBDA_L];
    func(NDIM, u, NULL, par, 2, f, dfdu, dfdp);
    for (int j = 0; j < NDIM + MLG_PARAMETER_COUNT; j++) {
      const int slot = j < NDIM ? 0 : mlg_parameters[j - NDIM].slot;
      double *x = j < NDIM ? &u[j] : &par[slot];
      const double *got = j < NDIM ? dfdu + j * NDIM : dfdp + slot * NDIM;
      const char *name = j < NDIM ? "state" : mlg_parameters[j - NDIM].name;
      double largest = 0.;

      if (j >= NDIM && !(fabs(*x) > 0. && *x < MLG_RIGID))
        continue;
      slope(par, u, x, 1e-6 * fabs(*x) + (j < NDIM ? 1e-8 : 0.), expected);
      for (int i = 0; i < NDIM; i++)
        largest = fmax(largest, fmax(fabs(expected[i]), 1e-3 * fabs(f[i] / *x)));
      for (int i = 0; i < NDIM; i++)
        if (!(fabs(got[i] - expected[i]) <= 1e-5 * largest))
          fail_msg("sample %d: d f[%d]/d %s %d = %.17g, expected %.17g; largest %g", n, i, name, j, got[i], expected[i], largest);
    }
  }
}

/* A twist of psi that goes to and fro takes energy from the wheels in each cycle. */
static void laws_give_no_energy(void **state)
{
  const double step = 2e-5;

  (void)state;
  for (int n = 0; n < 4; n++) {
    const double w = log_uniform(20., 200.), A = log_uniform(3e-3, 5e-2);
    const int period = (int)ceil(2. * MLG_PI / w / step);
    const double h = 2. * MLG_PI / w / period;
    double par[SLOTS], u[NDIM] = { 0. }, work[2] = { 0. }, size = 0.;

    random_parameters(par);
    some_laws(par, n == 0 ? 255 : (int)uniform(1., 255.));
    par[PAR_C_D] = log_uniform(3e3, 3e4);
    par[PAR_B] = n % 2 ? 0. : log_uniform(50., 300.);
    for (int i = 0; i < 6 * period; i++) { /* Runge and Kutta's step of fourth order */
      double k[4][NDIM], v[NDIM], T = 0.;

      for (int stage = 0; stage < 4; stage++) {
        const double part = stage == 0 ? 0. : stage == 3 ? 1. : 0.5, t = (i + part) * h;

        for (int j = GEAR_STATES; j < NDIM; j++)
          v[j] = u[j] + (stage ? part * h * k[stage - 1][j] : 0.);
        v[PSI] = A * sin(w * t);
        v[DPSI] = A * w * cos(w * t);
        T += (stage == 1 || stage == 2 ? 2. : 1.) / 6. * torque_on_wheels(par, v, k[stage]) * v[DPSI];
      }
      for (int j = GEAR_STATES; j < NDIM; j++)
        u[j] += h / 6. * (k[0][j] + 2. * k[1][j] + 2. * k[2][j] + k[3][j]);
      if (i >= 4 * period) {
        work[i >= 5 * period] += T * h;
        size += fabs(T) * h;
      }
    }
    assert_true(work[1] > -1e-6 * size);
  }
}

/* ---- device() ------------------------------------------------------------------ */

/* x' = A x + B psi + B1 psi', T_d = C x + D psi + D1 psi', by unit vectors. */
struct linear_device { double A[OWN * OWN], B[OWN], B1[OWN], C[OWN], D, D1; };

static struct linear_device linear_device(const double par[])
{
  struct linear_device d;
  double u[NDIM] = { 0. }, du[NDIM];

  u[PSI] = 1.;
  d.D = device(par, u, du);
  memcpy(d.B, du + GEAR_STATES, sizeof d.B);
  u[PSI] = 0.;
  u[DPSI] = 1.;
  d.D1 = device(par, u, du);
  memcpy(d.B1, du + GEAR_STATES, sizeof d.B1);
  u[DPSI] = 0.;
  for (int j = 0; j < OWN; j++) {
    u[GEAR_STATES + j] = 1.;
    d.C[j] = device(par, u, du);
    memcpy(d.A + OWN * j, du + GEAR_STATES, sizeof d.B);
    u[GEAR_STATES + j] = 0.;
  }
  return d;
}

/* Dynamic stiffness T_d / psi at the angular frequency w. */
static double _Complex stiffness(const double par[], double w)
{
  const struct linear_device d = linear_device(par);
  double _Complex P[OWN * OWN], x[OWN], Z = d.D + I * w * d.D1;
  lapack_int pivot[OWN];

  for (int i = 0; i < OWN; i++) {
    x[i] = d.B[i] + I * w * d.B1[i];
    for (int j = 0; j < OWN; j++)
      P[i + OWN * j] = (i == j ? I * w : 0.) - d.A[i + OWN * j];
  }
  assert_int_equal(LAPACKE_zgesv(LAPACK_COL_MAJOR, OWN, 1, P, OWN, pivot, x, OWN), 0);
  for (int j = 0; j < OWN; j++)
    Z += d.C[j] * x[j];
  return Z;
}

/* The same in closed form; a layout unknown here has none. */
static double _Complex closed_form(const double par[], double w)
{
  const double k_psi = par[PAR_K_PSI], k_s = par[PAR_K_S], k_d = par[PAR_K_D];
  const double c_d = par[PAR_C_D], b = par[PAR_B];

  if (strcmp(LAYOUT, "l1.c") == 0)
    return 1. / (1. / k_psi + 1. / (k_d + I * w * c_d));
  if (strcmp(LAYOUT, "l2.c") == 0)
    return 1. / (1. / k_psi + 1. / k_s + 1. / (k_d + I * w * c_d));
  if (strcmp(LAYOUT, "li1.c") == 0)
    return 1. / (1. / k_psi + 1. / k_s + 1. / (k_d + I * w * c_d - w * w * b));
  if (strcmp(LAYOUT, "li2.c") == 0)
    return 1. / (1. / k_psi + 1. / (k_s - w * w * b) + 1. / (k_d + I * w * c_d));
  if (strcmp(LAYOUT, "li3.c") == 0)
    return 1. / (1. / k_psi + 1. / (1. / (1. / k_s + 1. / (k_d + I * w * c_d)) - w * w * b));
  if (strcmp(LAYOUT, "li4.c") == 0) {
    const double _Complex tuned = k_s - w * w * b; /* in series with c_d, which may be 0 */

    return 1. / (1. / k_psi + 1. / (k_d + I * w * c_d / (1. + I * w * c_d / tuned)));
  }
  if (strcmp(LAYOUT, "li5.c") == 0) {
    const double _Complex damped = I * w * c_d - w * w * b; /* may be 0 */

    return 1. / (1. / k_psi + 1. / (k_d + damped / (1. + damped / k_s)));
  }
  if (strcmp(LAYOUT, "li6.c") == 0) { /* c_d or b may be 0 */
    const double _Complex chain = c_d > 0. && b > 0. ? 1. / (1. / k_s + 1. / (I * w * c_d) - 1. / (w * w * b)) : 0.;

    return 1. / (1. / k_psi + 1. / (k_d + chain));
  }
  if (strcmp(LAYOUT, "li7.c") == 0)
    return 1. / (1. / k_psi + 1. / (k_d - w * w * b + I * w * c_d / (1. + I * w * c_d / k_s)));
  return NAN;
}

static void device_is_linear(void **state)
{
  double par[SLOTS], u[NDIM], du[NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_state_vector(u);
    const struct linear_device d = linear_device(par);
    const double T_d = device(par, u, du);
    double expected = d.D * u[PSI] + d.D1 * u[DPSI], scale = fabs(expected);

    for (int j = 0; j < OWN; j++) {
      expected += d.C[j] * u[GEAR_STATES + j];
      scale += fabs(d.C[j] * u[GEAR_STATES + j]);
    }
    assert_near(T_d, expected, 1e-13 * scale);
    for (int i = 0; i < OWN; i++) {
      expected = d.B[i] * u[PSI] + d.B1[i] * u[DPSI];
      scale = fabs(expected);
      for (int j = 0; j < OWN; j++) {
        expected += d.A[i + OWN * j] * u[GEAR_STATES + j];
        scale += fabs(d.A[i + OWN * j] * u[GEAR_STATES + j]);
      }
      assert_near(du[GEAR_STATES + i], expected, 1e-13 * scale);
    }
  }
}

static void device_has_the_stiffness_of_its_layout(void **state)
{
  double par[SLOTS];

  (void)state;
  random_parameters(par);
  if (isnan(creal(closed_form(par, 1.))))
    skip();
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    const int limits = n % 16; /* 0: none; else a layout may hold c_d or b off 0 a little */

    limiting(par, limits);
    const double w = limits ? log_uniform(0.1, 200.) : log_uniform(1e-2, 1e5);
    const double _Complex Z = stiffness(par, w), expected = closed_form(par, w);
    /* a resonance without loss multiplies what rounding leaves */
    const double tolerance = (limits ? 1e-6 : 1e-10) * (eigen_abs(expected) + par[PAR_K_PSI]);

    assert_near(creal(Z), creal(expected), tolerance);
    assert_near(cimag(Z), cimag(expected), tolerance);
  }
}

/* device() and device_network() are the same device. */
static void network_is_the_device(void **state)
{
  double par[SLOTS];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    const int limits = n % 16;

    limiting(par, limits);
    const double w = limits ? log_uniform(0.1, 200.) : log_uniform(1e-2, 1e4);
    const struct network network = device_network(par);
    const double _Complex Z = stiffness(par, w);
    const double _Complex expected = poly_value(&network.num, I * w) / poly_value(&network.den, I * w);
    const double tolerance = (limits ? 1e-6 : 1e-9) * (eigen_abs(expected) + par[PAR_K_PSI]);

    assert_near(creal(Z), creal(expected), tolerance);
    assert_near(cimag(Z), cimag(expected), tolerance);
  }
}

/* The characteristic function vanishes at the eigenvalues of the linearised
 * func(), but for the one of lambda_L - lambda_R, -V/l. */
static void characteristic_vanishes_at_the_eigenvalues(void **state)
{
  double par[SLOTS];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    const struct characteristic F = characteristic(par);
    const struct eigen_values e = eigen_values(par);

    for (int i = 0; i < NDIM; i++) {
      const double _Complex s = e.re[i] + I * e.im[i];
      const struct jet at = jet(&F, s, par[PAR_V], par[PAR_C_D]);

      if (eigen_abs(s + par[PAR_V] / par[PAR_L]) > 1e-6 * eigen_abs(s))
        assert_near(eigen_abs(at.F / at.F_s), 0., 1e-6 * eigen_abs(s));
    }
  }
}

/* Without inerter LI1, LI2 and LI3 are L2, and L2 with a rigid k_s is L1: torque and
 * eps' to the last bit. */
static void limits_are_the_simpler_layouts(void **state)
{
  double par[SLOTS], u[NDIM], du[NDIM];

  (void)state;
  if (!strstr("l1.c l2.c li1.c li2.c li3.c", LAYOUT))
    skip();
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_state_vector(u);
    par[PAR_B] = 0.;
    if (n % 2 || strcmp(LAYOUT, "l1.c") == 0)
      par[PAR_K_S] = MLG_RIGID;
    const double k_e = n % 2 || strcmp(LAYOUT, "l1.c") == 0
                       ? par[PAR_K_PSI] : mlg_series(par[PAR_K_PSI], par[PAR_K_S]);
    const double T_d = k_e * (u[PSI] - u[GEAR_STATES]);

    assert_true(device(par, u, du) == T_d);
    assert_true(du[GEAR_STATES] == (T_d - par[PAR_K_D] * u[GEAR_STATES]) / par[PAR_C_D]);
  }
}

/* Power taken at frequency w is w |psi|^2 Im Z / 2. */
static void device_gives_no_energy(void **state)
{
  double par[SLOTS];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    limiting(par, n % 16);
    for (double w = 1e-2; w < 1e6; w *= 1.5) {
      const double _Complex Z = stiffness(par, w);

      if (!(cimag(Z) >= -1e-11 * (eigen_abs(Z) + par[PAR_K_PSI])))
        fail_msg("Im Z = %g at w = %g, |Z| = %g", cimag(Z), w, eigen_abs(Z));
    }
  }
}

static void device_alone_is_stable(void **state)
{
  double par[SLOTS], re[OWN], im[OWN];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    limiting(par, n % 16);
    struct linear_device d = linear_device(par);
    double largest = 0.;

    assert_int_equal(LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', OWN, d.A, OWN, re, im, NULL, OWN, NULL, OWN), 0);
    for (int i = 0; i < OWN; i++)
      largest = fmax(largest, hypot(re[i], im[i]));
    for (int i = 0; i < OWN; i++)
      assert_true(re[i] <= 1e-10 * largest);
  }
}

/* ---- parameters that would detach the device ------------------------------------- */

/* Whether the rates are out of all proportion, all of them or none, and the
 * Jacobian then is a regular one, by which AUTO's steps stay finite. */
static int unusable_with(int slot, double value)
{
  double par[SLOTS] = { 0. }, u[NDIM] = { 0. }, f[NDIM], dfdu[NDIM * NDIM], dfdp[SLOTS * NDIM];
  int large = 0;

  mlg_defaults(par);
  par[slot] = value;
  func(NDIM, u, NULL, par, 2, f, dfdu, dfdp);
  for (int i = 0; i < NDIM; i++)
    large += f[i] > 1e9;
  assert_true(large == 0 || large == NDIM);
  for (int i = 0; i < NDIM * NDIM && large; i++)
    assert_near(dfdu[i], i % (NDIM + 1) == 0, 0.);
  for (int k = 0; k < MLG_PARAMETER_COUNT * NDIM && large; k++)
    assert_near(dfdp[mlg_parameters[k / NDIM].slot * NDIM + k % NDIM], 0., 0.);
  return large > 0;
}

static void unusable_divisors_are_refused(void **state)
{
  const int divisor[] = { PAR_K_S, PAR_K_PSI, PAR_L, PAR_ALPHA_M };

  (void)state;
  assert_false(unusable_with(PAR_V, 20.));
  for (size_t i = 0; i < sizeof divisor / sizeof *divisor; i++) {
    assert_true(unusable_with(divisor[i], 0.));
    assert_true(unusable_with(divisor[i], -1.));
    assert_true(unusable_with(divisor[i], NAN));
  }
}

/* ---- pvls() ------------------------------------------------------------------------ */

enum { INTERVALS = 20, PER_INTERVAL = 4, STRIDE = NDIM + 3 };

/* psi and delta as sinusoids with an offset, at AUTO's mesh points. */
struct sinusoid { double psi, psi_phase, psi_offset, delta, delta_phase, delta_offset; };

static void synthetic_orbit(const struct sinusoid *orbit, double period, double u[])
{
  const double w = 2. * MLG_PI / period;
  double sum = 0., t = 0.;

  mesh.intervals = INTERVALS;
  mesh.per_interval = PER_INTERVAL;
  mesh.stride = STRIDE;
  for (int i = 0; i < INTERVALS; i++)
    sum += mesh.width[i] = uniform(0.5, 1.5);
  for (int i = 0; i < INTERVALS; i++)
    mesh.width[i] /= sum;
  for (int j = 0; j <= INTERVALS * PER_INTERVAL; j++) {
    double *v = u + (size_t)j * STRIDE;

    for (int i = 0; i < STRIDE; i++)
      v[i] = 1e6 * uniform(-1., 1.); /* what pvls must not read */
    v[PSI] = orbit->psi_offset + orbit->psi * sin(w * t + orbit->psi_phase);
    v[DPSI] = orbit->psi * w * cos(w * t + orbit->psi_phase);
    v[DELTA] = orbit->delta_offset + orbit->delta * sin(w * t + orbit->delta_phase);
    v[DDELTA] = orbit->delta * w * cos(w * t + orbit->delta_phase);
    if (j < INTERVALS * PER_INTERVAL)
      t += period * mesh.width[j / PER_INTERVAL] / PER_INTERVAL;
  }
}

static void pvls_finds_the_peaks_of_an_orbit(void **state)
{
  static double u[(INTERVALS * PER_INTERVAL + 1) * STRIDE];
  double par[SLOTS];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    const struct sinusoid orbit = {
      log_uniform(1e-6, 0.3), uniform(0., 2. * MLG_PI), 0.,
      log_uniform(1e-6, 0.1), uniform(0., 2. * MLG_PI), n % 2 ? uniform(-0.01, 0.01) : 0.,
    };

    random_parameters(par);
    par[PAR_PERIOD] = uniform(0.05, 0.2);
    synthetic_orbit(&orbit, par[PAR_PERIOD], u);
    pvls(NDIM, u, par);
    assert_near(par[PAR_PSI_MAX], orbit.psi * 180. / MLG_PI, 1e-6 * orbit.psi * 180. / MLG_PI);
    assert_near(par[PAR_DSTAR_MAX], (orbit.delta + orbit.delta_offset) * par[PAR_L_DELTA],
                1e-6 * orbit.delta * par[PAR_L_DELTA]);
    assert_near(par[PAR_TORUS], -1., 0.); /* monodromy unknown */
    assert_near(par[PAR_F_Z], (par[PAR_M] + par[PAR_M_D]) * par[PAR_G], 0.);
  }
}

/* P0 and P1 with -P1^-1 P0 = S B S^-1, S and P1 random. */
static void set_monodromy(const double B[NDIM * NDIM])
{
  double S[NDIM * NDIM], SB[NDIM * NDIM], transposed[NDIM * NDIM], monodromy_t[NDIM * NDIM];
  lapack_int pivot[NDIM];

  for (int i = 0; i < NDIM; i++)
    for (int j = 0; j < NDIM; j++) {
      S[i + NDIM * j] = uniform(-1., 1.) + (i == j ? 4. : 0.);
      monodromy.P1[i + NDIM * j] = uniform(-1., 1.) + (i == j ? 4. : 0.);
    }
  for (int i = 0; i < NDIM; i++)
    for (int j = 0; j < NDIM; j++) {
      SB[i + NDIM * j] = 0.;
      for (int k = 0; k < NDIM; k++)
        SB[i + NDIM * j] += S[i + NDIM * k] * B[k + NDIM * j];
    }
  /* X S = S B: solve with the transposes */
  for (int i = 0; i < NDIM; i++)
    for (int j = 0; j < NDIM; j++) {
      transposed[j + NDIM * i] = S[i + NDIM * j];
      monodromy_t[j + NDIM * i] = SB[i + NDIM * j];
    }
  assert_int_equal(LAPACKE_dgesv(LAPACK_COL_MAJOR, NDIM, NDIM, transposed, NDIM, pivot, monodromy_t, NDIM), 0);
  for (int i = 0; i < NDIM; i++)
    for (int j = 0; j < NDIM; j++) {
      monodromy.P0[i + NDIM * j] = 0.;
      for (int k = 0; k < NDIM; k++)
        monodromy.P0[i + NDIM * j] -= monodromy.P1[i + NDIM * k] * monodromy_t[j + NDIM * k];
    }
  monodromy.known = 1;
}

/* Real multipliers on the diagonal, from 0.95 (a hiding neighbour of 1) down. */
static void real_multipliers(double B[NDIM * NDIM])
{
  for (int i = 0; i < NDIM * NDIM; i++)
    B[i] = 0.;
  for (int i = 0; i < NDIM; i++)
    B[i * (NDIM + 1)] = i == 0 ? 1. : 0.95 * pow(-0.3, i - 1);
}

static void pair(double B[NDIM * NDIM], int at, double modulus, double angle)
{
  B[at + NDIM * at] = B[at + 1 + NDIM * (at + 1)] = modulus * cos(angle);
  B[at + 1 + NDIM * at] = modulus * sin(angle);
  B[at + NDIM * (at + 1)] = -modulus * sin(angle);
}

static void pvls_at_an_equilibrium(void **state)
{
  double par[SLOTS] = { 0. }, u[NDIM], B[NDIM * NDIM];

  (void)state;
  real_multipliers(B);
  pair(B, 4, 1.02, 0.7);
  set_monodromy(B); /* of an orbit before: not to be used */
  for (int n = 0; n < SAMPLES; n++) {
    mlg_defaults(par);
    random_state_vector(u);
    pvls(NDIM, u, par);
    assert_near(par[PAR_PSI_MAX], u[PSI] * 180. / MLG_PI, 1e-14);
    assert_near(par[PAR_DSTAR_MAX], u[DELTA] * par[PAR_L_DELTA], 1e-16);
    assert_near(par[PAR_TORUS], -1., 0.);
    assert_near(par[PAR_F_Z], 200e3, 1e-10);
    assert_near(par[PAR_CLOSES], -1., 0.);
  }
}

/* At straight rolling: the growth of the two kinds of shimmy, as the library has it. */
static void hopf_tests_are_the_growth_of_shimmy(void **state)
{
  const char name[] = LAYOUT;
  char layout[32] = "";
  struct libmlg_mode mode[LIBMLG_MOST_STATES];
  double slots[MLG_SLOTS] = { 0. }, par[LIBMLG_MOST_PARAMETERS], u[NDIM] = { 0. };
  int grows, signs = 0;

  (void)state;
  memcpy(layout, name, strcspn(name, "."));
  memset(&mesh, 0, sizeof mesh);
  for (int n = 0; n < SAMPLES; n++) {
    double nearest[2] = { -1., -1. };
    int growing[2] = { 0, 0 };

    mlg_defaults(slots);
    libmlg_defaults(par);
    par[libmlg_parameter("V")] = slots[PAR_V] = uniform(1., 100.);
    par[libmlg_parameter("c_d")] = slots[PAR_C_D] = uniform(1e3, 8e4);
    pvls(NDIM, u, slots);
    const int modes = libmlg_modes(libmlg_layout(layout), par, mode, LIBMLG_MOST_STATES, &grows);

    for (int i = 0; i < modes; i++) {
      const int kind = libmlg_is_delta(par, mode[i].delta_over_psi);

      growing[kind] += mode[i].re > 0.;
      if (nearest[kind] < 0. || fabs(mode[i].re) < nearest[kind])
        nearest[kind] = fabs(mode[i].re);
    }
    for (int kind = 0; kind < 2; kind++) {
      const double test = slots[kind ? PAR_HOPF_DELTA : PAR_HOPF_PSI];

      assert_near(fabs(test), fabs(nearest[kind]), 1e-8 * fabs(test) + 1e-8);
      assert_int_equal(test > 0., growing[kind] % 2);
      signs += test > 0.;
    }
  }
  assert_true(signs > 0 && signs < 2 * SAMPLES);
}

static void turn(double par[], double angle)
{
  mlg_defaults(par);
  par[PAR_V] = 20. * exp(0.3 * cos(angle));
  par[PAR_C_D] = 5e3 * exp(0.5 * sin(angle) + 0.15 * cos(2. * angle));
  par[PAR_PERIOD] = 0.06 * exp(0.01 * sin(angle));
}

/* Round a closed curve it is below 0, and above where the curve has passed its start. */
static void closing_test_passes_0_at_the_start_only(void **state)
{
  double par[MLG_SLOTS] = { 0. }, u[NDIM] = { 0. };

  (void)state;
  memset(&mesh, 0, sizeof mesh);
  auto_isw = 2;
  for (int n = 0; n < 100; n++) {
    const double from = uniform(0., 2. * MLG_PI), step = uniform(0.02, 0.2) * (n % 2 ? 1. : -1.);
    double way = 0.;

    memset(&curve, 0, sizeof curve);
    for (; fabs(way) < 2. * MLG_PI + fabs(step); way += way == 0. ? 0.1 * step : step) { /* AUTO's first step is a short one */
      const double rest = fabs(way) - 2. * MLG_PI;

      turn(par, from + way);
      pvls(NDIM, u, par);
      if (rest < 0.)
        assert_true(par[PAR_CLOSES] < 0.);
      else if (rest > 1e-9)
        assert_true(par[PAR_CLOSES] > 0.);
    }
  }
  auto_isw = 1;
}

static void torus_is_the_largest_complex_multiplier(void **state)
{
  double B[NDIM * NDIM];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    real_multipliers(B);
    set_monodromy(B);
    assert_near(orbit_torus(NDIM), -1., 0.); /* none complex */

    pair(B, 4, 1.02, 0.7); /* in place of two small reals */
    set_monodromy(B);
    assert_near(orbit_torus(NDIM), 0.02, 1e-12);

    pair(B, 4, 1.03, 0.05); /* nearly real, and yet a pair */
    set_monodromy(B);
    assert_near(orbit_torus(NDIM), 0.03, 1e-12);

    pair(B, 4, 1.02, 0.7);
    pair(B, 2, 0.4, 2.5); /* a smaller pair beside it */
    set_monodromy(B);
    assert_near(orbit_torus(NDIM), 0.02, 1e-12);

    real_multipliers(B);
    B[NDIM + 1] = 1.5; /* a real one outside is no torus */
    pair(B, 4, 0.99, -3.);
    set_monodromy(B);
    assert_near(orbit_torus(NDIM), -0.01, 1e-12);

    real_multipliers(B);
    pair(B, 0, 1.0001, 1e-3); /* 1 and a neighbour, split by rounding */
    pair(B, 4, 0.8, 1.1);
    set_monodromy(B);
    assert_near(orbit_torus(NDIM), -0.2, 1e-12);

    monodromy.known = 0;
    assert_near(orbit_torus(NDIM), -1., 0.);
    assert_near(orbit_torus(NDIM + 1), -1., 0.); /* an extended system, not the orbit */
  }
}

/* ---- boundaries -------------------------------------------------------------------- */

/* Zero-shimmy intervals of the paper, to the five digits known. */
static void zero_shimmy_interval_of_the_paper(void **state)
{
  static const struct { const char *layout; double k_s, b, c_d[2]; } published[] = {
    { "l1.c", MLG_RIGID, 0., { 2754.35, 3018.98 } },
    { "l2.c", 7.86e5, 0., { 3813.91, 14032.51 } },
    { "li1.c", 6.38e5, 140., { 2319.48, 13562.68 } },
  };
  const struct eigen_scan scan = { 0.1, 200., 0.5, 1e3, 3e4, 60 };
  struct eigen_interval interval[2];
  double par[SLOTS] = { 0. };
  int known = 0;

  (void)state;
  for (size_t i = 0; i < sizeof published / sizeof *published; i++)
    if (strcmp(LAYOUT, published[i].layout) == 0) {
      mlg_defaults(par);
      par[PAR_K_S] = published[i].k_s;
      par[PAR_B] = published[i].b;
      assert_int_equal(eigen_intervals(par, &scan, interval, 2), 1);
      for (int end = 0; end < 2; end++) {
        assert_false(interval[0].open[end]);
        assert_near(interval[0].c_d[end], published[i].c_d[end], 1e-5 * published[i].c_d[end]);
      }
      known = 1;
    }
  if (!known)
    skip();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(starts_at_straight_rolling, seed),
    cmocka_unit_test_setup(zero_is_an_equilibrium_at_every_speed, seed),
    cmocka_unit_test_setup(mirror_symmetry, seed),
    cmocka_unit_test_setup(func_is_finite, seed),
    cmocka_unit_test_setup(libmlg_is_func, seed),
    cmocka_unit_test_setup(libmlg_knows_what_is_none, seed),
    cmocka_unit_test_setup(libmlg_eigenvalues_are_the_oracles, seed),
    cmocka_unit_test_setup(libmlg_fails_on_no_numbers, seed),
    cmocka_unit_test_setup(linearisation_is_the_closed_form, seed),
    cmocka_unit_test_setup(derivatives_are_those_of_func, seed),
    cmocka_unit_test_setup(func_writes_what_it_is_asked_for, seed),
    cmocka_unit_test_setup(laws_keep_the_mirror_symmetry, seed),
    cmocka_unit_test_setup(derivatives_with_laws, seed),
    cmocka_unit_test_setup(laws_give_no_energy, seed),
    cmocka_unit_test_setup(device_is_linear, seed),
    cmocka_unit_test_setup(device_has_the_stiffness_of_its_layout, seed),
    cmocka_unit_test_setup(network_is_the_device, seed),
    cmocka_unit_test_setup(characteristic_vanishes_at_the_eigenvalues, seed),
    cmocka_unit_test_setup(limits_are_the_simpler_layouts, seed),
    cmocka_unit_test_setup(device_gives_no_energy, seed),
    cmocka_unit_test_setup(device_alone_is_stable, seed),
    cmocka_unit_test_setup(unusable_divisors_are_refused, seed),
    cmocka_unit_test_setup(pvls_finds_the_peaks_of_an_orbit, seed),
    cmocka_unit_test_setup(pvls_at_an_equilibrium, seed),
    cmocka_unit_test_setup(hopf_tests_are_the_growth_of_shimmy, seed),
    cmocka_unit_test_setup(closing_test_passes_0_at_the_start_only, seed),
    cmocka_unit_test_setup(torus_is_the_largest_complex_multiplier, seed),
    cmocka_unit_test_setup(zero_shimmy_interval_of_the_paper, seed),
  };

  return cmocka_run_group_tests_name(LAYOUT, tests, NULL, NULL);
}
