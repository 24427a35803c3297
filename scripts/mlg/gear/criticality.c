/* criticality.c - is shimmy born beside the stable gear or not? at Hopf points of a table */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "criticality";

/* A line V,c_d,k_s,b,frequency_hz of standard input; false at the end of the input. */
static bool read_point(struct arguments *a, double *frequency_hz)
{
  static const enum parameter_number column[] = { NUMBER_V, NUMBER_C_D, NUMBER_K_S, NUMBER_B };
  enum { COLUMNS = sizeof column / sizeof *column };
  static int line;
  char text[256], *at = text;

  line++;
  if (fgets(text, sizeof text, stdin) == NULL)
    return false;
  for (int i = 0; i <= COLUMNS; i++) {
    char *end;
    const double value = strtod(at, &end);

    if (end == at || *end != (i < COLUMNS ? ',' : '\n')) {
      text[strcspn(text, "\n")] = '\0';
      fail(name, MLG_BAD_INPUT, "standard input:%d: '%.80s': expected V,c_d,k_s,b,frequency_hz", line, text);
    }
    at = end + 1;
    if (i == COLUMNS)
      *frequency_hz = value;
    else if (value >= libmlg_least(column[i]) && value <= libmlg_most(column[i]))
      a->par[column[i]] = value;
    else
      fail(name, MLG_BAD_INPUT, "standard input:%d: %s = %g: outside its range, %g to %g %s", line,
           libmlg_parameter_quantity(column[i])->name, value, libmlg_least(column[i]),
           libmlg_most(column[i]), libmlg_parameter_quantity(column[i])->unit);
  }
  return true;
}

static int run(int argc, char *argv[])
{
  struct arguments a;
  double frequency_hz = 0., coefficient, growth;
  struct libmlg_mode mode;

  read_arguments(&a, argc, argv, NULL);
  for (enum parameter_number n = NUMBER_V; n <= NUMBER_B; n++)
    refuse_given(&a, n, "the points on standard input give it");
  printf("V,c_d,frequency_hz,delta_over_psi,a,growth_in_c_d\n");
  while (read_point(&a, &frequency_hz)) {
    if (libmlg_criticality(a.layout, a.par, 2. * MLG_PI * frequency_hz, &mode, &coefficient) != 0
        || libmlg_growth_slope(a.layout, a.par, &mode, NUMBER_C_D, &growth) != 0)
      fail(name, MLG_FAILED, "no mode at V = %g, c_d = %g", a.par[NUMBER_V], a.par[NUMBER_C_D]);
    printf("%.10g,%.10g,%.8g,%.6g,%.10g,%.10g\n", a.par[NUMBER_V], a.par[NUMBER_C_D], mode.frequency_hz,
           mode.delta_over_psi, coefficient, growth);
  }
  return output_status(name);
}

const struct command command_criticality = {
  .name = name,
  .usage = "LAYOUT [NAME=VALUE ...] < POINTS",
  .summary = "are Hopf points super- or subcritical?",
  .details =
    "POINTS: a line V,c_d,k_s,b,frequency_hz for each Hopf point, SI units.\n"
    "\n"
    "Prints CSV, a row for each:\n"
    "  V, c_d          m/s, N m s/rad\n"
    "  frequency_hz    of the mode nearest to that frequency\n"
    "  delta_over_psi  ratio of amplitudes; above 1 it is delta-shimmy\n"
    "  a               1/s per rad^2: the amplitude r of psi obeys r' = sigma r + a r^3 beside\n"
    "                  the point; a < 0 supercritical, a > 0 subcritical: shimmy, unstable\n"
    "                  itself, beside the stable gear\n"
    "  growth_in_c_d   d(sigma)/d(c_d), 1/s per N m s/rad\n",
  .run = run,
};
