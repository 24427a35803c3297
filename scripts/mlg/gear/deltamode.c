/* deltamode.c - what damping of the delta mode a device in the torsion can give at most
 *
 * A device is seen by the delta mode at one frequency only, its own, about 17.5 Hz, at every speed:
 * there its dynamic stiffness with k_psi is one complex number Z, and all that passivity asks of it is
 * Im(Z) >= 0.  With Z held along the small way that the mode moves, the best Z of all is the best that
 * any device of any order can do for this mode, whatever becomes of the psi mode.  Z infinite is the
 * wheels locked in torsion: what is left of the gear then is delta and the tyre.
 */
#include <complex.h>
#include <math.h>
#include <stdio.h>

#include "arguments.h"
#include "cma.h"
#include "command.h"
#include "layout.h"
#include "linearised.h"

enum { SPEEDS = 60, STEPS = 30, FROM_LOCKED = 6 };

struct delta_mode { double slots[MLG_SLOTS], V_least, V_top, k_psi; double V; };

/* At one speed. */
struct gear_polynomials { struct poly whole, minor; double omega; };

static struct gear_polynomials gear_at(const double slots[], double V)
{
  const struct gear_matrix g = gear_matrix(slots);
  struct gear_polynomials at = { .omega = sqrt(g.A11.coefficient[0] / g.A11.coefficient[2]) };
  struct poly whole[GEAR_SPEEDS], minor[GEAR_SPEEDS];

  gear_determinants(slots, whole, minor);
  for (int v = GEAR_SPEEDS - 1; v >= 0; v--) {
    at.whole = poly_sum(poly_scaled(at.whole, V), whole[v]);
    at.minor = poly_sum(poly_scaled(at.minor, V), minor[v]);
  }
  return at;
}

/* F / Z, which is regular at a compliance 1/Z of 0. */
static double _Complex F(const struct gear_polynomials *g, double _Complex s, double _Complex compliance)
{
  return poly_value(&g->minor, s) + compliance * poly_value(&g->whole, s);
}

/* The delta mode at one speed, followed from that of the strut alone, by Newton's method. */
static double _Complex mode_at(const struct gear_polynomials *g, double _Complex compliance)
{
  double _Complex s = I * g->omega;

  for (int part = 0; part <= FROM_LOCKED; part++)
    for (int i = 0; i < STEPS; i++) {
      const double h = 1e-6 * cabs(s);
      const double _Complex here = compliance * part / FROM_LOCKED;
      const double _Complex step = F(g, s, here) * 2. * h / (F(g, s + h, here) - F(g, s - h, here));

      s -= step;
      if (cabs(step) < 1e-12 * cabs(s))
        break;
    }
  return s;
}

/* The least ratio over the speeds, at one compliance. */
static double least(struct delta_mode *d, double _Complex compliance)
{
  double zeta = HUGE_VAL;

  for (int i = 0; i < SPEEDS; i++) {
    const double V = d->V_least * pow(d->V_top / d->V_least, (double)i / (SPEEDS - 1));
    const struct gear_polynomials g = gear_at(d->slots, V);
    const double _Complex s = mode_at(&g, compliance);

    if (-creal(s) / cabs(s) < zeta) {
      zeta = -creal(s) / cabs(s);
      d->V = V;
    }
  }
  return zeta;
}

/* The disc of all passive compliances: k_psi/Z is in the lower half plane; behind k_psi, which takes part
 * itself, it is 1 + k_psi/Z_d. */
static double _Complex compliance_at(const struct delta_mode *d, const double place[2])
{
  return (tan(3.1 * (place[0] - 0.5)) - I * tan(1.55 * place[1])) / d->k_psi;
}

static double of_place(const double place[], void *context)
{
  return least(context, compliance_at(context, place));
}

static void print_row(const char *what, const struct delta_mode *d, double zeta, double _Complex Z)
{
  printf("%s,%.8g,%.6g,%.8g,%.8g\n", what, zeta, d->V, creal(Z), cimag(Z));
}

static int run(int argc, char *argv[])
{
  enum { V_LEAST };
  struct option option[] = { [V_LEAST] = { "V_least", "m/s", 1e-3, 1e3, 0.3, NULL }, { .name = NULL } };
  char *words[64] = { argv[0], (char *)"l1" };
  struct arguments a;
  struct delta_mode d = { .V = NAN };
  double best = -INFINITY, place[2] = { 0.5, 0.5 };

  if (argc > 62)
    fail(argv[0], MLG_BAD_INPUT, "too many words");
  for (int i = 1; i < argc; i++)
    words[i + 1] = argv[i];
  read_arguments(&a, argc + 1, words, option);
  refuse_given(&a, NUMBER_V, "the least ratio over all speeds is asked for");
  refuse_given(&a, NUMBER_C_D, "any device is asked for");
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  libmlg_slots(a.par, d.slots);
  if (!(gear_matrix(d.slots).A11.coefficient[0] > 0.))
    fail(argv[0], MLG_FAILED, "delta does not oscillate: the load takes all of k_delta's stiffness away");
  d.k_psi = a.par[NUMBER_K_PSI];
  d.V_least = option[V_LEAST].value;
  d.V_top = a.V_top;
  for (int start = 0; start < 4; start++) {
    struct cma_random random = { (unsigned)start + 1u };
    double here[2] = { 0.25 + 0.5 * cma_uniform(&random), cma_uniform(&random) }, value;

    if (cma_largest(of_place, &d, 2, here, 0.2, &random, 400, INFINITY, &value) < 0)
      fail(argv[0], MLG_FAILED, "LAPACK failed");
    if (value > best) {
      best = value;
      place[0] = here[0];
      place[1] = here[1];
    }
  }

  const struct gear_matrix g = gear_matrix(d.slots);
  const double *const A11 = g.A11.coefficient;

  printf("# V m/s; Z N m/rad at the delta mode, with k_psi\nwhat,zeta,V,Z_re,Z_im\n");
  print_row("strut", &d, A11[1] / (2. * sqrt(A11[0] * A11[2])), INFINITY);
  print_row("locked", &d, least(&d, 0.), INFINITY);
  print_row("any", &d, least(&d, compliance_at(&d, place)), 1. / compliance_at(&d, place));
  return output_status(argv[0]);
}

const struct command command_deltamode = {
  .name = "deltamode",
  .usage = "[NAME=VALUE ...] [V_least=0.3]",
  .summary = "the damping of the delta mode that a device could give at most",
  .details =
    "Rows, with the least damping ratio over 60 speeds from V_least to V_top:\n"
    "  strut    c_delta/(2 sqrt(K11 M11)): without tyre\n"
    "  locked   wheels locked in torsion\n"
    "  any      the best passive dynamic stiffness Z at that frequency, Im(Z) >= 0: no device does\n"
    "           better for this mode as long as Z hardly changes between its frequencies at all speeds\n"
    "CSV: what, zeta, V where it is least (m/s), Z_re and Z_im N m/rad.\n",
  .run = run,
};
