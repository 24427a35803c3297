/* unfolding.c - what lives beside a double Hopf point: the cubic amplitude equations */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "unfolding";

/* The frequencies, rad/s, of the two oscillations nearest to the axis of stability. */
static int nearest_two(const struct arguments *a, double omega[2])
{
  double re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES], nearest[2] = { HUGE_VAL, HUGE_VAL };
  int n;

  if (libmlg_eigenvalues(a->layout, a->par, re, im, &n) != 0)
    return -1;
  for (int i = 0; i < n; i++) {
    if (im[i] <= 0.)
      continue;
    if (fabs(re[i]) < nearest[0]) {
      nearest[1] = nearest[0], omega[1] = omega[0];
      nearest[0] = fabs(re[i]), omega[0] = im[i];
    } else if (fabs(re[i]) < nearest[1])
      nearest[1] = fabs(re[i]), omega[1] = im[i];
  }
  if (omega[0] > omega[1]) {
    const double higher = omega[0];

    omega[0] = omega[1], omega[1] = higher;
  }
  return isfinite(nearest[1]) && fmax(nearest[0], nearest[1]) < 1e-5 * omega[0] ? 0 : -1;
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
  double omega[2] = { 0., 0. }, a[2][2], slope[2][2];
  static const enum parameter_number parameter[2] = { NUMBER_V, NUMBER_C_D };

  read_arguments(&arguments, argc, argv, NULL);
  if (nearest_two(&arguments, omega) != 0)
    fail(name, MLG_FAILED, "no double Hopf point at V = %g, c_d = %g: two oscillations have to be undamped to 1e-5",
         arguments.par[NUMBER_V], arguments.par[NUMBER_C_D]);
  if (libmlg_double_hopf(arguments.layout, arguments.par, omega, mode, a) != 0)
    fail(name, MLG_FAILED, "no normal form: the Jacobian is not finite, or the frequencies are in resonance");
  for (int k = 0; k < 2; k++)
    for (int j = 0; j < 2; j++)
      if (libmlg_growth_slope(arguments.layout, arguments.par, &mode[k], parameter[j], &slope[k][j]) != 0)
        fail(name, MLG_FAILED, "no derivatives of the eigenvalues");

  const double theta = a[0][1] / a[1][1], delta = a[1][0] / a[0][0];
  double torus[2]; /* dV/dc_d of sigma_2 = delta sigma_1, and of sigma_1 = theta sigma_2 */

  torus[0] = -(slope[1][1] - delta * slope[0][1]) / (slope[1][0] - delta * slope[0][0]);
  torus[1] = -(slope[0][1] - theta * slope[1][1]) / (slope[0][0] - theta * slope[1][0]);
  printf("mode,frequency_hz,angle,re,a_own,a_other,dre_dV,dre_dc_d,torus_dV_dc_d,unfolding\n");
  for (int k = 0; k < 2; k++)
    printf("%d,%.8g,%s,%.3e,%.8g,%.8g,%.8g,%.8g,%.8g,%s\n", k + 1, mode[k].frequency_hz,
           mode[k].delta_over_psi > 1. ? "delta" : "psi", mode[k].re, a[k][k], a[k][1 - k], slope[k][0], slope[k][1],
           torus[k], unfolding_case((const double (*)[2])a, theta, delta));
  return output_status(name);
}

const struct command command_unfolding = {
  .name = name,
  .usage = "LAYOUT V=VALUE c_d=VALUE [NAME=VALUE ...]",
  .summary = "what lives beside a double Hopf point",
  .details =
    "At a double Hopf point the amplitudes obey r_i' = r_i (sigma_i + a_own r_i^2 + a_other r_j^2),\n"
    "sigma_i = dre_dV (V - V_HH) + dre_dc_d (c_d - c_HH).  Prints CSV, a row for each oscillation:\n"
    "  frequency_hz   Hz, the lower first; angle: r is its amplitude of psi or of delta, rad\n"
    "  re             real part of the eigenvalue, 1/s; how exact the point is\n"
    "  a_own          1/s per rad^2; below 0 its Hopf points here are supercritical\n"
    "  a_other        the effect of the other oscillation\n"
    "  dre_dV, dre_dc_d  of the real part, 1/s per m/s and per N m s/rad\n"
    "  torus_dV_dc_d  slope of the curve of its torus points where it begins, at the double Hopf point\n"
    "  unfolding      difficult (a_own of different signs), or Kuznetsov's simple I to V (Section\n"
    "                 8.6.2): with a_own < 0, in I both oscillations are stable between the torus\n"
    "                 curves and the torus there is not; in II, where each leaves the other room, the\n"
    "                 torus is stable\n",
  .run = run,
};
