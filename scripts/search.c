/* search - does a large disturbance of a gear that is stable ever go on as shimmy?
 *
 *   search-LAYOUT C_LO C_HI STARTS [NAME=VALUE ...]
 *
 * Integrates the gear (integrate.h) from STARTS states that fill, as evenly as a
 * Halton sequence does, speeds V from 1 to 200 m/s, dampings c_d from C_LO to C_HI
 * (N m s/rad), and psi, its rate, delta, its rate and both tyre deflections within
 * the ranges below; the device starts at rest.  NAME is a parameter of models/mlg.h.
 *
 * The size of an oscillation is max sqrt((psi/psi_0)^2 + (delta/delta_0)^2) over two
 * seconds.  A start is followed for 30 s at least and until its size is below a tenth,
 * that is delta* below 3 mm and psi below 1.5 degrees; if it still falls there it
 * "falls".  One that is not there after 2000 s, or does not fall, is "sustained".
 *
 * Prints CSV: V m/s, c_d N m s/rad, psi_start and dstar_start (largest psi, deg, and
 * delta*, m, in the first two seconds), limits (how often a slip angle passed alpha_m),
 * seconds, psi_end, dstar_end (in the last two), rate (at which the size falls there,
 * 1/s), verdict (falls, sustained).
 * Bad input: one line, status 2; an integration that fails: status 1.
 */
#define MLG_NO_AUTO
#include LAYOUT
#include "arguments.h"
#include "integrate.h"

static const double psi_0 = 15. * MLG_PI / 180.; /* rad; the cycles followed end at 15 degrees */
static const double dstar_0 = 0.03;              /* m; the largest cycles reach 0.013 */
static const double window = 2., step = 1e-3;    /* s */
static const double least = 30., most = 2000.;   /* s, of one start */
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

static struct size over_window(struct integrator *run)
{
  const double end = run->t + window;
  struct size largest = { 0., 0., 0. };

  while (run->t < end) {
    const double next = fmin(end, run->t + step);
    enum reached reached;

    while ((reached = integrator_advance(run, next)) == AT_LIMIT)
      ;
    if (reached == FAILED) {
      fprintf(stderr, "search: V = %g, c_d = %g: %s\n", run->par[PAR_V], run->par[PAR_C_D], run->error);
      exit(1);
    }
    const double psi = fabs(run->u[PSI]), dstar = fabs(run->u[DELTA]) * run->par[PAR_L_DELTA];

    largest.psi = fmax(largest.psi, psi);
    largest.dstar = fmax(largest.dstar, dstar);
    largest.both = fmax(largest.both, hypot(psi / psi_0, dstar / dstar_0));
  }
  return largest;
}

/* One start, printed as a row. */
static void try_start(struct integrator *run, const double par[], const double u[])
{
  struct size first, last, before;

  integrator_start(run, par, u);
  last = first = over_window(run);
  do {
    before = last;
    last = over_window(run);
  } while (run->t < least || (run->t < most && !(last.both < small && last.both < before.both)));
  const double rate = log(before.both / last.both) / window;
  const char *verdict = last.both < small && rate > 0. ? "falls" : "sustained";

  printf("%.6g,%.8g,%.4g,%.4g,%ld,%.0f,%.4g,%.4g,%.3e,%s\n", par[PAR_V], par[PAR_C_D],
         first.psi * 180. / MLG_PI, first.dstar, run->limits, run->t, last.psi * 180. / MLG_PI,
         last.dstar, rate, verdict);
}

static double number(const char *text, double least)
{
  char *end;
  const double value = strtod(text, &end);

  if (end == text || *end || !(value >= least && value <= 1e9)) {
    fprintf(stderr, "search: '%s': expected a number from %g on\n", text, least);
    exit(2);
  }
  return value;
}

int main(int argc, char *argv[])
{
  double par[36] = { 0. };
  struct integrator run;

  if (argc < 4) {
    fprintf(stderr, "usage: search C_LO C_HI STARTS [NAME=VALUE ...]\n");
    return 2;
  }
  const double c_lo = number(argv[1], 1e-3), c_hi = number(argv[2], c_lo);
  const int starts = (int)number(argv[3], 1.);

  mlg_defaults(par);
  for (int i = 4; i < argc; i++)
    set_parameter("search", par, argv[i]);
  if (integrator_begin(&run, 1e-8) != 0) {
    fprintf(stderr, "search: out of memory\n");
    return 1;
  }
  printf("V,c_d,psi_start,dstar_start,limits,seconds,psi_end,dstar_end,rate,verdict\n");
  for (int i = 1; i <= starts; i++) {
    const double delta_0 = dstar_0 / par[PAR_L_DELTA], lambda_0 = par[PAR_L] * tan(par[PAR_ALPHA_M]);
    double u[NDIM] = { 0. };

    par[PAR_V] = 1. + 199. * pow(halton(i, 2), 2.); /* most of what happens, happens below 60 m/s */
    par[PAR_C_D] = c_lo * pow(c_hi / c_lo, halton(i, 3));
    u[PSI] = psi_0 * (2. * halton(i, 5) - 1.);
    u[DPSI] = 2. * MLG_PI * 8. * psi_0 * (2. * halton(i, 7) - 1.); /* near 8 Hz */
    u[DELTA] = delta_0 * (2. * halton(i, 11) - 1.);
    u[DDELTA] = 2. * MLG_PI * 17.5 * delta_0 * (2. * halton(i, 13) - 1.); /* near 17.5 Hz */
    u[LAMBDA_L] = lambda_0 * (2. * halton(i, 17) - 1.);
    u[LAMBDA_R] = lambda_0 * (2. * halton(i, 19) - 1.);
    try_start(&run, par, u);
    fflush(stdout);
  }
  integrator_end(&run);
  return fflush(stdout) != 0 || ferror(stdout);
}
