/* best.c - the least damping ratio over all speeds, and the device that makes it largest */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"
#include "names.h"

enum { V_LEAST, B_LEAST, B_MOST };

static int run(int argc, char *argv[])
{
  struct option option[] = {
    [V_LEAST] = { "V_least", "m/s", 0., 1e3, 0., NULL },
    [B_LEAST] = { "b_least", "N m s^2/rad", 0., 1e9, 0., NULL },
    [B_MOST] = { "b_most", "N m s^2/rad", 0., 1e9, 0., NULL },
    { .name = NULL },
  };
  struct libmlg_ratio best;
  struct libmlg_mode mode;
  struct arguments a;
  int status;

  read_arguments(&a, argc, argv, option);
  refuse_given(&a, NUMBER_V, "the least ratio over all speeds is asked for");
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  if (option[B_MOST].value < option[B_LEAST].value)
    fail(argv[0], MLG_BAD_INPUT, "b_least = %g is above b_most = %g N m s^2/rad", option[B_LEAST].value, option[B_MOST].value);

  const double V_least = option[V_LEAST].value;
  const int over_b = option[B_MOST].word != NULL, over_k_s = libmlg_uses(a.layout, NUMBER_K_S) == 1 && !a.word[NUMBER_K_S];

  if (over_b && (a.word[NUMBER_B] || a.word[NUMBER_K_S] || a.word[NUMBER_C_D]))
    refuse(argv[0], option[B_MOST].word, "over b the best k_s and c_d are asked for, too");
  if (a.word[NUMBER_C_D])
    status = libmlg_least_ratio(a.layout, a.par, V_least, a.V_top, &best);
  else if (over_b || over_k_s)
    status = libmlg_best_damped(a.layout, a.par, over_b ? option[B_LEAST].value : a.par[NUMBER_B],
                                over_b ? option[B_MOST].value : a.par[NUMBER_B], V_least, a.V_top, &best);
  else
    status = libmlg_best_c_d(a.layout, a.par, V_least, a.V_top, &best);
  printf("# k_s N m/rad, b N m s^2/rad, c_d N m s/rad, V m/s, decay 1/s\nk_s,b,c_d,zeta,V,frequency_hz,shimmy,decay\n");
  if (status == 0 && best.zeta > -1.) {
    a.par[NUMBER_K_S] = best.k_s;
    a.par[NUMBER_B] = best.b;
    a.par[NUMBER_C_D] = best.c_d;
    a.par[NUMBER_V] = fmax(best.V, 1e-6 * a.V_top);
    if (libmlg_least_damped(a.layout, a.par, &mode) != 0)
      fail(argv[0], MLG_FAILED, "no eigenvalues at V = %g, c_d = %g", best.V, best.c_d);
    printf("%.10g,%.10g,%.10g,%.8g,%.8g,%.8g,%s,%.8g\n", best.k_s >= MLG_RIGID ? INFINITY : best.k_s, best.b, best.c_d,
           best.zeta, best.V, mode.frequency_hz, mode.delta_over_psi > 1. ? "delta" : "psi", -mode.re);
  } else if (status != 0 && !libmlg_diverges(a.layout, a.par)) {
    checked(argv[0], status);
  }
  return output_status(argv[0]);
}

const struct command command_best = {
  .name = "best",
  .usage = "LAYOUT [NAME=VALUE ...] [b_least=0] [b_most=VALUE] [V_least=0]",
  .summary = "the best damped device: the largest least damping ratio over all speeds",
  .details =
    "With c_d given, the least ratio of that device; otherwise the c_d whose least ratio is\n"
    "largest, at the k_s given or over all k_s; with b_most over b too.  Exact over V and c_d,\n"
    "over k_s and b by a grid that is refined (libmlg.h).  CSV, one row, none for a gear that\n"
    "diverges:\n"
    "  k_s, b, c_d   N m/rad (inf: rigid), N m s^2/rad, N m s/rad\n"
    "  zeta          that ratio, below 0 where there is shimmy; V m/s, frequency_hz, shimmy\n"
    "                (psi, delta) of the mode that has it\n"
    "  decay         1/s: the rate at which that mode decays\n",
  .run = run,
};
