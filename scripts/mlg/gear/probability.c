/* probability.c - the probability of shimmy over V when parameters spread */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "designs.h"
#include "spread.h"

static const char name[] = "probability";

enum { SAMPLES, SEED, V_STEP, MOST_SPEEDS = 100000 };

/* Wilson's interval of a probability, of which k in n were seen, at 95 %. */
static void print_row(const char *V, long k, long n)
{
  const double z = 1.959963984540054, p = (double)k / (double)n, z2 = z * z / (double)n;
  const double middle = (p + z2 / 2.) / (1. + z2), half = z / (1. + z2) * sqrt(p * (1. - p) / (double)n + z2 / (4. * (double)n));

  printf("%s,%ld,%.8g,%.6g,%.6g\n", V, k, p, k == 0 ? 0. : middle - half, k == n ? 1. : middle + half);
}

static int run(int argc, char *argv[])
{
  struct option option[] = { [SAMPLES] = { "samples", "", 1., 1e9, 100000., NULL },
                             [SEED] = { "seed", "", 1., 1e15, 1., NULL },
                             [V_STEP] = { "V_step", "m/s", 1e-3, 1e3, 1., NULL },
                             { .name = NULL } };
  const char *file = NULL;
  struct spread spread[MOST_SPREADS];
  struct libmlg_interval interval;
  struct arguments a;

  begin_arguments(&a, argc, argv, option);
  for (int i = 2; i < argc; i++)
    if (strncmp(argv[i], "spread=", 7) == 0) {
      if (file)
        refuse(name, argv[i], "given already, by 'spread=%.200s'", file);
      if (!argv[i][strlen("spread=")])
        refuse(name, argv[i], "expected spread=FILE");
      file = argv[i] + 7;
    } else
      take_word(&a, argv[i]);
  end_arguments(&a);
  check_speeds(&a, 0.);
  if (!file)
    fail(name, MLG_BAD_INPUT, "expected spread=FILE, a file of spreads (`mlg help probability`)");
  const int steps = (int)floor(fmin(a.V_top / option[V_STEP].value, MOST_SPEEDS + 1.) + 1e-9);

  if (steps < 1 || steps > MOST_SPEEDS)
    refuse(name, option[V_STEP].word ? option[V_STEP].word : a.V_top_word, "expected from 1 to %d steps of V up to V_top", MOST_SPEEDS);
  if (!a.word[NUMBER_C_D] && !take_interval(&a, 0.3, &interval))
    fail(name, MLG_FAILED, "there is no zero-shimmy interval in whose middle c_d could be; give c_d");

  const int n = read_spreads(file, &a, spread);
  const long samples = (long)option[SAMPLES].value;
  struct random random = { (uint64_t)option[SEED].value * 0x9e3779b97f4a7c15u };
  long *const count = calloc((size_t)steps + 1, sizeof *count); /* of any V, then of each */

  if (!count)
    fail(name, MLG_FAILED, "out of memory");
  for (long i = 0; i < samples; i++) {
    struct libmlg_band band[LIBMLG_MOST_POINTS];
    double par[LIBMLG_MOST_PARAMETERS];

    memcpy(par, a.par, sizeof par);
    draw_spreads(&random, spread, n, par);
    const int bands = libmlg_shimmy_speeds(a.layout, par, 0., a.V_top, band, LIBMLG_MOST_POINTS);

    count[0] += bands > 0;
    for (int k = 0; k < bands; k++)
      for (int j = (int)fmax(ceil(band[k].from / option[V_STEP].value), 1.); j <= steps && j * option[V_STEP].value <= band[k].to; j++)
        count[j]++;
  }
  printf("# V m/s; probability of shimmy in %ld samples, seed %.0f, with Wilson's 95 %% interval; k_s = %.8g N m/rad, b = %.8g"
         " N m s^2/rad, c_d = %.8g N m s/rad\nV,count,probability,lo,hi\n",
         samples, option[SEED].value, shown_k_s(a.par[NUMBER_K_S]), a.par[NUMBER_B], a.par[NUMBER_C_D]);
  print_row("any", count[0], samples);
  for (int j = 1; j <= steps; j++) {
    char V[32];

    snprintf(V, sizeof V, "%.8g", j * option[V_STEP].value);
    print_row(V, count[j], samples);
  }
  free(count);
  return output_status(name);
}

const struct command command_probability = {
  .name = name,
  .usage = "LAYOUT spread=FILE [NAME=VALUE ...] [samples=1e5] [seed=1] [V_step=1]",
  .summary = "the probability of shimmy over V when parameters spread",
  .details =
    "FILE has one parameter a line, # begins a comment:\n"
    "  k_t   normal   7.0e5  3.5e4     mean and standard deviation, SI units\n"
    "  F_z   uniform  180e3  210e3     from, to\n"
    "  c_d   uniform  -10%   10%       per cent of the design's own value\n"
    "  e     normal   0%     5%        in SI units or in per cent, both of a line alike\n"
    "The parameters are independent; what falls outside a parameter's physical range is drawn again.\n"
    "Without c_d the design has the middle of its widest zero-shimmy interval.  Each sample is decided\n"
    "exactly: all Hopf speeds at its c_d, and the eigenvalues between them.  CSV:\n"
    "  V                   m/s; any: at one speed or another up to V_top\n"
    "  count, probability  samples with shimmy there, and their part\n"
    "  lo, hi              Wilson's interval at a confidence of 95 %, each row by itself; all rows\n"
    "                      are of the same samples, those of the seed\n",
  .run = run,
};
