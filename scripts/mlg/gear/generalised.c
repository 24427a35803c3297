/* generalised.c - the generalised Hopf points of a layout's Hopf curves */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"
#include "plane.h"

static const char name[] = "generalised";

enum { MOST = 64 };

static int run(int argc, char *argv[])
{
  struct option option[] = {
    { "V_least", "m/s", 1e-9, 1e3, 0.1, NULL },
    { "c_least", "N m s/rad", 1e-9, 1e12, 10., NULL },
    { "c_most", "N m s/rad", 1e-9, 1e12, 8e4, NULL },
    { .name = NULL },
  };
  struct libmlg_generalised_hopf gh[MOST];
  struct arguments a;

  read_arguments(&a, argc, argv, option);
  refuse_given(&a, NUMBER_V, "V is an axis of the plane");
  refuse_given(&a, NUMBER_C_D, "c_d is an axis of the plane");
  if (!(option[0].value < a.V_top) || !(option[1].value < option[2].value))
    fail(name, MLG_BAD_INPUT, "an empty plane: V from %g to %g m/s, c_d from %g to %g N m s/rad", option[0].value, a.V_top,
         option[1].value, option[2].value);

  const struct libmlg_plane plane = { option[0].value, a.V_top, option[1].value, option[2].value };
  const int n = libmlg_generalised_hopf(a.layout, a.par, &plane, gh, MOST);

  if (n < 0 || n > MOST)
    fail(name, MLG_FAILED, n < 0 ? "out of memory" : "more than 64 points: take a part of the plane");
  printf("V,c_d,frequency_hz,delta_over_psi,a_5,a_slope,growth_in_c_d,fold_V,fold_c_d,fold_gap,fold_psi2\n");
  for (int i = 0; i < n; i++) {
    const double gap = gh[i].a_slope * gh[i].a_slope / (4. * gh[i].a_5 * gh[i].growth_in_c_d);

    printf("%.10g,%.10g,%.10g,%.6g,%.8g,%.8g,%.6g,%s,%s,%.6g,%.6g\n", gh[i].V, gh[i].c_d, gh[i].mode.frequency_hz,
           gh[i].mode.delta_over_psi, gh[i].a_5, gh[i].a_slope, gh[i].growth_in_c_d,
           gh[i].a_slope * gh[i].a_5 < 0. ? "above" : "below", gap > 0. ? "above" : "below", gap,
           fabs(gh[i].a_slope / (2. * gh[i].a_5)) * (180. / MLG_PI) * (180. / MLG_PI));
  }
  return output_status(name);
}

const struct command command_generalised = {
  .name = name,
  .usage = "LAYOUT [NAME=VALUE ...] [V_least=0.1] [c_least=10] [c_most=8e4]",
  .summary = "generalised Hopf points (GH), and the folds of cycles that begin there",
  .details =
    "All points of the Hopf curves in the plane at which the cubic coefficient a of\n"
    "r' = sigma r + a r^3 + a_5 r^5 passes 0, r the amplitude of psi.  Prints CSV:\n"
    "  V, c_d          m/s, N m s/rad\n"
    "  frequency_hz, delta_over_psi   of the oscillation; amplitudes, rad/rad\n"
    "  a_5             1/s per rad^4\n"
    "  a_slope         da/dV along the curve, 1/s per rad^2 and m/s\n"
    "  growth_in_c_d   d(sigma)/d(c_d), 1/s per N m s/rad\n"
    "  fold_V          above or below: the side of V on which the fold of cycles begins\n"
    "  fold_c_d        the side of the Hopf curve on which the fold lies\n"
    "  fold_gap        c_d of the fold less that of the Hopf point at the same V, over (V - V_GH)^2,\n"
    "                  N m s/rad per (m/s)^2, to leading order\n"
    "  fold_psi2       square of the amplitude of psi at the fold over |V - V_GH|, deg^2 per m/s\n"
    "V is good to 1e-9, c_d to 1e-8, a_5 to 1e-7 (docs/auto.md).\n",
  .run = run,
};
