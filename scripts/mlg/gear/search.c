/* search.c - does a large disturbance of a gear that is stable ever go on as shimmy? */
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "command.h"

static const char name[] = "search";

static const double psi_0 = 15. * MLG_PI / 180.; /* rad; the cycles followed end at 15 degrees */
static const double dstar_0 = 0.03;              /* m; the largest cycles reach 0.013 */
static const double window = 2., step = 1e-3;    /* s */
static const double least = 30.;                 /* s, of one start */
static const double small = 0.1;                 /* size that it has to fall below */

/* Element i = 1, 2, ... of the van der Corput sequence of a prime base, in 0 to 1. */
static double halton(int i, int base)
{
  double value = 0., digit = 1.;

  for (; i > 0; i /= base)
    value += (i % base) * (digit /= base);
  return value;
}

/* Largest psi (rad), delta* (m) and size over a window. */
struct size { double psi, dstar, both; };

static struct size over_window(struct libmlg_run *run, const double par[])
{
  const double end = run->t + window;
  struct size largest = { 0., 0., 0. };

  while (run->t < end) {
    const double next = fmin(end, run->t + step);
    int reached;

    while ((reached = libmlg_run_to(run, next)) == LIBMLG_AT_LIMIT)
      ;
    if (reached == LIBMLG_FAILED)
      fail(name, MLG_FAILED, "V = %g, c_d = %g: %s", par[NUMBER_V], par[NUMBER_C_D], run->error);
    const double psi = fabs(run->u[PSI]), dstar = fabs(run->u[DELTA]) * par[NUMBER_L_DELTA];

    largest.psi = fmax(largest.psi, psi);
    largest.dstar = fmax(largest.dstar, dstar);
    largest.both = fmax(largest.both, hypot(psi / psi_0, dstar / dstar_0));
  }
  return largest;
}

/* One start, printed as a row. */
static void try_start(struct libmlg_run *run, const double par[], const double u[], double most)
{
  struct size first, last, before;

  libmlg_run_start(run, par, u);
  last = first = over_window(run, par);
  do {
    before = last;
    last = over_window(run, par);
  } while (run->t < least || (run->t < most && !(last.both < small && last.both < before.both)));
  const double rate = log(before.both / last.both) / window;
  const char *verdict = last.both < small && rate > 0. ? "falls" : "sustained";

  printf("%.6g,%.8g,%.4g,%.4g,%ld,%.0f,%.4g,%.4g,%.3e,%s\n", par[NUMBER_V], par[NUMBER_C_D],
         first.psi * 180. / MLG_PI, first.dstar, run->limits, run->t, last.psi * 180. / MLG_PI,
         last.dstar, rate, verdict);
}

static int search(int argc, char *argv[])
{
  enum { C_LO, C_HI, STARTS, LONGEST };
  struct option option[] = {
    { "c_lo", "N m s/rad", 1e-3, 1e9, 0., NULL }, { "c_hi", "N m s/rad", 1e-3, 1e9, 0., NULL },
    { "starts", "", 1., 1e9, 400., NULL }, { "longest", "s", 30., 1e6, 2000., NULL }, { NULL, NULL, 0., 0., 0., NULL },
  };
  struct arguments a;
  struct libmlg_run run;

  read_arguments(&a, argc, argv, option);
  refuse_given(&a, NUMBER_V, "the speeds run up to V_top; give other parameters");
  refuse_given(&a, NUMBER_C_D, "c_lo and c_hi say which; give other parameters");
  if (!option[C_LO].word || !option[C_HI].word)
    fail(name, MLG_BAD_INPUT, "expected c_lo=VALUE c_hi=VALUE, the interval of c_d");
  if (!(option[C_LO].value <= option[C_HI].value))
    refuse(name, option[C_HI].word, "below c_lo");
  if (!(a.V_top > 1.))
    refuse(name, a.V_top_word, "the speeds begin at 1 m/s");
  if (libmlg_run_begin(&run, a.layout, 1e-8) != 0)
    fail(name, MLG_FAILED, "out of memory");
  printf("V,c_d,psi_start,dstar_start,limits,seconds,psi_end,dstar_end,rate,verdict\n");
  for (int i = 1; i <= (int)option[STARTS].value; i++) {
    double *const par = a.par;
    const double delta_0 = dstar_0 / par[NUMBER_L_DELTA], lambda_0 = par[NUMBER_L] * tan(par[NUMBER_ALPHA_M]);
    double u[LIBMLG_MOST_STATES] = { 0. };

    par[NUMBER_V] = 1. + (a.V_top - 1.) * pow(halton(i, 2), 2.); /* most of what happens, happens below 60 m/s */
    par[NUMBER_C_D] = option[C_LO].value * pow(option[C_HI].value / option[C_LO].value, halton(i, 3));
    u[PSI] = psi_0 * (2. * halton(i, 5) - 1.);
    u[DPSI] = 2. * MLG_PI * 8. * psi_0 * (2. * halton(i, 7) - 1.); /* near 8 Hz */
    u[DELTA] = delta_0 * (2. * halton(i, 11) - 1.);
    u[DDELTA] = 2. * MLG_PI * 17.5 * delta_0 * (2. * halton(i, 13) - 1.); /* near 17.5 Hz */
    u[LAMBDA_L] = lambda_0 * (2. * halton(i, 17) - 1.);
    u[LAMBDA_R] = lambda_0 * (2. * halton(i, 19) - 1.);
    try_start(&run, par, u, option[LONGEST].value);
    fflush(stdout);
  }
  libmlg_run_end(&run);
  return output_status(name);
}

const struct command command_search = {
  .name = name,
  .usage = "LAYOUT c_lo=VALUE c_hi=VALUE [starts=N] [longest=SECONDS] [NAME=VALUE ...]",
  .summary = "integrate large disturbances: does any go on as shimmy?",
  .details =
    "Integrates the gear from N states (400) that fill, as evenly as a Halton sequence\n"
    "does, speeds V from 1 m/s to V_top, dampings c_d from c_lo to c_hi (N m s/rad), psi up\n"
    "to 15 degrees, delta* to 0.03 m, their rates at 8 and 17.5 Hz, and tyre deflections up\n"
    "to the slip angle alpha_m; the device starts at rest.\n"
    "\n"
    "The size of an oscillation is max sqrt((psi/15 deg)^2 + (delta*/0.03 m)^2) over two\n"
    "seconds.  A start is followed for 30 s at least and until its size is below a tenth;\n"
    "if it still falls there it \"falls\".  One that is not there after longest= seconds (2000),\n"
    "or does not fall, is \"sustained\".\n"
    "\n"
    "Prints CSV: V m/s, c_d N m s/rad, psi_start and dstar_start (largest psi, deg, and\n"
    "delta*, m, in the first two seconds), limits (how often a slip angle passed alpha_m),\n"
    "seconds, psi_end, dstar_end (in the last two), rate (at which the size falls there,\n"
    "1/s), verdict (falls, sustained).\n",
  .run = search,
};
