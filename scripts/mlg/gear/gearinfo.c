/* gearinfo.c - a gear by itself: its parameters beside the paper's, and what they mean */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "designs.h"
#include "names.h"

enum { MOST_WORDS = 256, MOST_MODES = 8 };

/* A layout whose device has every element, so that a gear file may have any of them. */
static const char *richest(void)
{
  for (int i = 0; i < libmlg_layouts(); i++)
    if (libmlg_uses(i, NUMBER_K_S) == 1 && libmlg_uses(i, NUMBER_B) == 1)
      return libmlg_layout_name(i);
  return "l1";
}

static double as_shown(int n, double value)
{
  return n == NUMBER_K_S ? shown_k_s(value) : value;
}

static void print_parameters(const struct arguments *a)
{
  printf("name,value,paper,unit,given,meaning\n");
  for (int n = 0; n < NUMBERS; n++) {
    const struct libmlg_quantity *q = libmlg_parameter_quantity(n);

    printf("%s,%.15g,%.15g,%s,%d,\"%s\"\n", q->name, as_shown(n, a->par[n]), as_shown(n, libmlg_default(n)), q->unit,
           a->word[n] || (n == NUMBER_M && a->F_z_word), q->meaning);
  }
}

static void fact(const char *name, double value, const char *unit, const char *meaning)
{
  printf("%s,%.8g,%s,\"%s\"\n", name, value, unit, meaning);
}

/* The two modes of the gear without tyre forces: the device locked (c_d so large that it
 * does not give) or free (so small that its spring alone holds). */
static void print_modes(const struct arguments *a, const char *device)
{
  const int layout = libmlg_layout("l1"), locked = strcmp(device, "locked") == 0;
  const double k_d = a->par[NUMBER_K_D];
  struct libmlg_mode mode[MOST_MODES];
  double par[LIBMLG_MOST_PARAMETERS];
  char name[64], meaning[120];
  int grows;

  memcpy(par, a->par, sizeof par);
  par[NUMBER_V] = 1.;
  par[NUMBER_K_ALPHA] = par[NUMBER_K_LAMBDA] = 0.;
  par[NUMBER_C_D] = locked ? 1e6 * k_d : 1e-8 * k_d;
  const int n = libmlg_modes(layout, par, mode, MOST_MODES, &grows);

  if (n < 0)
    fail(a->command, MLG_FAILED, "no eigenvalues");
  for (int i = 0; i < n; i++) {
    const char *which = shimmy_name(a->par, mode[i].delta_over_psi);

    snprintf(name, sizeof name, "%s_%s_hz", which, device);
    snprintf(meaning, sizeof meaning, "frequency of the %s mode without tyre forces, the device %s", which, device);
    fact(name, mode[i].frequency_hz, "Hz", meaning);
    snprintf(name, sizeof name, "%s_%s_zeta", which, device);
    snprintf(meaning, sizeof meaning, "its damping ratio");
    fact(name, mode[i].zeta, "-", meaning);
  }
}

static void print_facts(const struct arguments *a)
{
  const double *p = a->par, F_z = (p[NUMBER_M] + p[NUMBER_M_D]) * p[NUMBER_G];

  printf("fact,value,unit,meaning\n");
  fact("F_z", F_z, "N", "static load of the gear (M + m_D) g");
  fact("F_wheel", F_z / 2., "N", "static load of a wheel");
  print_modes(a, "locked");
  print_modes(a, "free");
  fact("roll_lift_off", F_z / (p[NUMBER_A] * p[NUMBER_K_T]) * 180. / MLG_PI, "deg",
       "roll of the axle at which a mu k_t/2 takes all of a wheel's static load");
  fact("lambda_limit", p[NUMBER_L] * tan(p[NUMBER_ALPHA_M]), "m", "tyre deflection at the slip angle alpha_m");
  fact("V_top", a->V_top, "m/s", "top of the operating range");
}

static int run(int argc, char *argv[])
{
  const int facts = argc > 1 && strcmp(argv[1], "facts") == 0;
  char *words[MOST_WORDS] = { argv[0], (char *)richest() };
  struct arguments a;
  int n = 2;

  if (argc + 1 > MOST_WORDS)
    fail(argv[0], MLG_BAD_INPUT, "more than %d words", MOST_WORDS);
  for (int i = 1 + facts; i < argc; i++)
    words[n++] = argv[i];
  read_arguments(&a, n, words, NULL);
  if (facts)
    print_facts(&a);
  else
    print_parameters(&a);
  return output_status(argv[0]);
}

const struct command command_gearinfo = {
  .name = "gearinfo",
  .usage = "[facts] [NAME=VALUE ...]",
  .summary = "a gear's parameters beside the paper's, and what follows from them alone",
  .details =
    "CSV: name, value, paper (the value of the paper's gear), unit, given (1: by a word or the\n"
    "gear file), meaning.\n"
    "\n"
    "facts: instead fact, value, unit, meaning: the static load; frequencies and damping\n"
    "ratios of the delta and the psi mode without tyre forces (k_alpha = k_lambda = 0), the\n"
    "device locked (it does not give: k_psi alone) and free (c_d = 0: k_psi and k_d in series);\n"
    "the roll at which a wheel lifts off; the tyre deflection at alpha_m; V_top.  A mode that\n"
    "does not oscillate has no row.\n",
  .run = run,
};
