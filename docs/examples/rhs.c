/* rhs.c - an example of libmlg: shimmy of layout L1 by the Runge-Kutta method
 *
 *   rhs LAYOUT [NAME=VALUE ...]     NAME: a parameter of libmlg
 *
 * From psi = 1 degree for 120 s; prints the largest psi, degrees, and delta*, mm,
 * of the last second.  At the defaults and V = 20 m/s that is solution A of
 * Figure 6.  Bad input: one line, status 2.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "libmlg.h"

static void bad_input(const char *text, const char *right)
{
  fprintf(stderr, "rhs: '%s': %s\n", text, right);
  exit(2);
}

static void set(double par[], char *text)
{
  char *equals = strchr(text, '=');
  int i;

  if (equals == NULL)
    bad_input(text, "expected NAME=VALUE");
  *equals = '\0';
  i = libmlg_parameter(text);
  if (i == LIBMLG_NONE)
    bad_input(text, "no such parameter");
  par[i] = strtod(equals + 1, NULL);
}

/* One step of length h, s, by the classical method of fourth order. */
static void step(int layout, const double par[], double u[], double h)
{
  static const double weight[4] = { 1. / 6., 1. / 3., 1. / 3., 1. / 6. }, ahead[4] = { 0., 0.5, 0.5, 1. };
  double f[4][LIBMLG_MOST_STATES], v[LIBMLG_MOST_STATES];
  const int n = libmlg_states(layout);

  for (int k = 0; k < 4; k++) {
    for (int i = 0; i < n; i++)
      v[i] = u[i] + (k > 0 ? h * ahead[k] * f[k - 1][i] : 0.);
    libmlg_rhs(layout, par, v, f[k]);
  }
  for (int k = 0; k < 4; k++)
    for (int i = 0; i < n; i++)
      u[i] += h * weight[k] * f[k][i];
}

int main(int argc, char *argv[])
{
  const double degree = 3.14159265358979323846 / 180., h = 5e-4;
  double par[LIBMLG_MOST_PARAMETERS], u[LIBMLG_MOST_STATES] = { 0. }, psi_max = 0., delta_max = 0.;
  const int steps = 240000;
  int layout, outside, psi, delta;

  if (argc < 2 || (layout = libmlg_layout(argv[1])) == LIBMLG_NONE)
    bad_input(argc < 2 ? "" : argv[1], "expected a layout, such as l1");
  libmlg_defaults(par);
  for (int i = 2; i < argc; i++)
    set(par, argv[i]);
  outside = libmlg_outside(par);
  if (outside != LIBMLG_NONE)
    bad_input(libmlg_parameter_quantity(outside)->name, "outside its range");

  psi = libmlg_state(layout, "psi");
  delta = libmlg_state(layout, "delta");
  u[psi] = 1. * degree;
  for (int i = 0; i < steps; i++) {
    step(layout, par, u, h);
    if (i >= steps - 2000) {
      psi_max = fmax(psi_max, fabs(u[psi]));
      delta_max = fmax(delta_max, fabs(u[delta]));
    }
  }
  printf("psi_max %.4f deg, dstar_max %.3f mm\n", psi_max / degree,
         1e3 * delta_max * par[libmlg_parameter("l_delta")]);
  return 0;
}
