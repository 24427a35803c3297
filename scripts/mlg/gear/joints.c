/* joints.c - the cycles of a gear with play, friction and a real damper, in a moment */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "joints";

static const double degree = MLG_PI / 180.;

static int joints(int argc, char *argv[])
{
  enum { LEAST, MOST_PSI, AT, NEAR, MOST = 32 };
  struct option option[] = {
    { "psi_least", "deg", 1e-9, 90., 1e-3, NULL }, { "psi_most", "deg", 1e-9, 90., 30., NULL },
    { "at", "deg", 1e-9, 90., 0., NULL }, { "near", "Hz", 1e-3, 1e4, 11., NULL }, { NULL, NULL, 0., 0., 0., NULL },
  };
  struct arguments a;
  struct libmlg_balance cycle[MOST];

  read_arguments(&a, argc, argv, option);
  if (option[LEAST].value >= option[MOST_PSI].value)
    refuse(name, option[MOST_PSI].word ? option[MOST_PSI].word : option[LEAST].word, "psi_most has to be above psi_least");
  if (option[AT].word) {
    double equivalent[LIBMLG_MOST_PARAMETERS];
    struct libmlg_mode mode;

    if (libmlg_equivalent(a.layout, a.par, option[AT].value * degree, option[NEAR].value, equivalent, &mode) != 0)
      fail(name, MLG_FAILED, "no oscillation of that size near %g Hz", option[NEAR].value);
    printf("# psi deg; growth 1/s; frequency_hz Hz; k_psi, k_s, k_d N m/rad; c_d, c_psi N m s/rad\n"
           "psi,growth,frequency_hz,delta_over_psi,k_psi,k_s,k_d,c_d,c_psi\n%.11g,%.11g,%.11g,%.11g,%.11g,%.11g,%.11g,%.11g,%.11g\n",
           option[AT].value, mode.re, mode.frequency_hz, mode.delta_over_psi, equivalent[NUMBER_K_PSI],
           equivalent[NUMBER_K_S], equivalent[NUMBER_K_D], equivalent[NUMBER_C_D], equivalent[NUMBER_C_PSI]);
    return output_status(name);
  }

  const int n = libmlg_balance(a.layout, a.par, option[LEAST].value * degree, option[MOST_PSI].value * degree, cycle, MOST);

  if (n < 0)
    fail(name, MLG_FAILED, "LAPACK failed");
  printf("# psi deg; dstar m; frequency_hz Hz\npsi,dstar,frequency_hz,stable\n");
  for (int i = 0; i < n; i++)
    printf("%.11g,%.11g,%.11g,%d\n", cycle[i].psi / degree, cycle[i].psi * cycle[i].delta_over_psi * a.par[NUMBER_L_DELTA],
           cycle[i].frequency_hz, cycle[i].stable);
  return output_status(name);
}

const struct command command_joints = {
  .name = name,
  .usage = "LAYOUT [at=DEGREES [near=HZ]] [psi_least=DEGREES psi_most=DEGREES] [NAME=VALUE ...]",
  .summary = "cycles of play, friction and a real damper, by describing functions",
  .details =
    "Each element with a law (g_psi, g_s, T_f, T_psi, c_2, T_max, k_s3, k_d3) is taken in\n"
    "an oscillation of the amplitude psi for the linear one that does the same in the mean\n"
    "of a cycle; the gear itself is taken for linear, the motion for one harmonic\n"
    "(docs/joints.md says where that holds).\n"
    "\n"
    "Prints CSV: the cycles with psi from psi_least (0.001 degrees) to psi_most (30), the\n"
    "largest first: psi deg, dstar m, frequency_hz, stable (1, 0): an unstable one is how\n"
    "large a disturbance has to be.  None: straight rolling is reached from everywhere, or\n"
    "from nowhere between these.\n"
    "at=DEGREES prints that linear gear for one amplitude and the mode near near= (11 Hz):\n"
    "growth, 1/s, below 0 where it falls; frequency; k_psi, k_s, k_d, c_d, c_psi.\n",
  .run = joints,
};
