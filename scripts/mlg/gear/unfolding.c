/* unfolding.c - what lives beside a double Hopf point: the cubic amplitude equations */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"
#include "names.h"

static const char name[] = "unfolding";

/* The two oscillations nearest to the axis of stability, the lower frequency first. */
static int nearest_two(const struct arguments *a, struct libmlg_mode mode[2])
{
  struct libmlg_mode all[LIBMLG_MOST_STATES];
  int grows;
  const int n = libmlg_modes(a->layout, a->par, all, LIBMLG_MOST_STATES, &grows);

  if (n < 2)
    return -1;
  for (int k = 0; k < 2; k++)
    for (int i = k + 1; i < n; i++)
      if (fabs(all[i].re) < fabs(all[k].re)) {
        const struct libmlg_mode nearer = all[i];

        all[i] = all[k], all[k] = nearer;
      }
  const int lower = all[1].im < all[0].im;

  mode[0] = all[lower];
  mode[1] = all[!lower];
  return 0;
}

static const enum parameter_number axis[2] = { NUMBER_V, NUMBER_C_D };

static void slopes_of(const struct arguments *a, const struct libmlg_mode mode[2], double slope[2][2])
{
  for (int k = 0; k < 2; k++)
    for (int j = 0; j < 2; j++)
      if (libmlg_growth_slope(a->layout, a->par, &mode[k], axis[j], &slope[k][j]) != 0)
        fail(name, MLG_FAILED, "no derivatives of the eigenvalues");
}

/* x with slope x = growth, for what V and c_d are to change by. */
static void solve(double slope[2][2], const double growth[2], double x[2])
{
  const double det = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];

  x[0] = (growth[0] * slope[1][1] - growth[1] * slope[0][1]) / det;
  x[1] = (growth[1] * slope[0][0] - growth[0] * slope[1][0]) / det;
}

/* Newton's method for the V and c_d at which both real parts are 0, no further than 1 % away. */
static int find_point(struct arguments *a, struct libmlg_mode mode[2])
{
  const double start[2] = { a->par[NUMBER_V], a->par[NUMBER_C_D] };
  double slope[2][2], x[2];

  for (int i = 0; i < 30; i++) {
    if (nearest_two(a, mode) != 0)
      return -1;
    if (fmax(fabs(mode[0].re), fabs(mode[1].re)) < 1e-11 * mode[1].im)
      return 0;
    slopes_of(a, mode, slope);
    solve(slope, (const double[]){ -mode[0].re, -mode[1].re }, x);
    for (int j = 0; j < 2; j++) {
      a->par[axis[j]] += x[j];
      if (!(fabs(a->par[axis[j]] / start[j] - 1.) < 1e-2))
        return -1;
    }
  }
  return fmax(fabs(mode[0].re), fabs(mode[1].re)) < 1e-8 * mode[1].im ? 0 : -1;
}

/* Kuznetsov's cases of the simple unfolding, Section 8.6.2. */
static const char *unfolding_case(const double a[2][2], double theta, double delta)
{
  if (a[0][0] * a[1][1] < 0.)
    return "difficult";
  if (theta > 0. && delta > 0.)
    return theta * delta > 1. ? "simple I" : "simple II";
  if (theta < 0. && delta < 0.)
    return theta * delta < 1. ? "simple IV" : "simple V";
  return "simple III";
}

static int run(int argc, char *argv[])
{
  struct arguments arguments;
  struct libmlg_mode mode[2];
  double a[2][2], slope[2][2], torus[2][2];

  read_arguments(&arguments, argc, argv, NULL);
  const double V = arguments.par[NUMBER_V], c_d = arguments.par[NUMBER_C_D];

  if (find_point(&arguments, mode) != 0)
    fail(name, MLG_FAILED, "no double Hopf point within 1 %% of V = %g, c_d = %g", V, c_d);
  if (libmlg_double_hopf(arguments.layout, arguments.par, (const double[]){ mode[0].im, mode[1].im }, mode, a) != 0)
    fail(name, MLG_FAILED, "no normal form: the Jacobian is not finite, or the frequencies are in resonance");
  slopes_of(&arguments, mode, slope);
  for (int k = 0; k < 2; k++) { /* where r_k^2 = 1 holds its own growth and that of the other at 0 */
    double growth[2];

    growth[k] = -a[k][k];
    growth[1 - k] = -a[1 - k][k];
    solve(slope, growth, torus[k]);
  }
  printf("mode,frequency_hz,angle,re,a_own,a_other,dre_dV,dre_dc_d,torus_V,torus_c_d,torus_dV_dc_d,unfolding,V,c_d\n");
  for (int k = 0; k < 2; k++)
    printf("%d,%.8g,%s,%.3e,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%s,%.10g,%.10g\n", k + 1, mode[k].frequency_hz,
           shimmy_name(arguments.par, mode[k].delta_over_psi), mode[k].re, a[k][k], a[k][1 - k], slope[k][0], slope[k][1],
           torus[k][0], torus[k][1], torus[k][0] / torus[k][1],
           unfolding_case((const double (*)[2])a, a[0][1] / a[1][1], a[1][0] / a[0][0]), arguments.par[NUMBER_V],
           arguments.par[NUMBER_C_D]);
  return output_status(name);
}

const struct command command_unfolding = {
  .name = name,
  .usage = "LAYOUT V=VALUE c_d=VALUE [NAME=VALUE ...]",
  .summary = "what lives beside a double Hopf point",
  .details =
    "At the double Hopf point within 1 % of V and c_d the amplitudes obey\n"
    "  r_i' = r_i (sigma_i + a_own r_i^2 + a_other r_j^2),\n"
    "  sigma_i = dre_dV (V - V_HH) + dre_dc_d (c_d - c_HH).\n"
    "Prints CSV, a row for each oscillation:\n"
    "  frequency_hz   Hz, the lower first; angle: r is its amplitude of psi or of delta, rad\n"
    "  re             real part of the eigenvalue, 1/s; how exact the point is\n"
    "  a_own          1/s per rad^2; below 0 its Hopf points here are supercritical\n"
    "  a_other        the effect of the other oscillation\n"
    "  dre_dV, dre_dc_d  of the real part, 1/s per m/s and per N m s/rad\n"
    "  torus_V, torus_c_d  its torus points begin at V_HH + torus_V r^2, c_HH + torus_c_d r^2\n"
    "  torus_dV_dc_d  its slope there\n"
    "  unfolding      difficult (a_own of different signs), or Kuznetsov's simple I to V (Section\n"
    "                 8.6.2): with a_own < 0, in I both oscillations are stable between the torus\n"
    "                 curves and the torus there is not; in II, where each leaves the other room, the\n"
    "                 torus is stable\n"
    "  V, c_d         of the point, m/s and N m s/rad\n",
  .run = run,
};
