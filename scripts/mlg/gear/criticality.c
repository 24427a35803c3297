/* criticality.c - is shimmy born beside the stable gear or not? at Hopf points of a table */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "names.h"

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

/* A Hopf point, and what is found there. */
struct point { double V, c_d, frequency_hz, delta_over_psi, a, growth; };

/* That of the mode nearest to the frequency of p, at its V and c_d. */
static void examine(struct arguments *a, struct point *p)
{
  struct libmlg_mode mode;

  a->par[NUMBER_V] = p->V;
  a->par[NUMBER_C_D] = p->c_d;
  if (libmlg_criticality(a->layout, a->par, 2. * MLG_PI * p->frequency_hz, &mode, &p->a) != 0
      || libmlg_growth_slope(a->layout, a->par, &mode, NUMBER_C_D, &p->growth) != 0)
    fail(name, MLG_FAILED, "no mode at V = %g, c_d = %g", p->V, p->c_d);
  p->frequency_hz = mode.frequency_hz;
  p->delta_over_psi = mode.delta_over_psi;
}

static void print_point(const struct point *p, int digits)
{
  printf("%.*g,%.*g,%.*g,%.*g,%.*g,%.*g\n", digits, p->V, digits, p->c_d, digits, p->frequency_hz, digits, p->delta_over_psi, digits,
         p->a, digits, p->growth);
}

/* The Hopf point at the speed V whose c_d lies between those of p and q; false: none. */
static bool between(struct arguments *a, const struct point *p, const struct point *q, double V, struct point *found)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  int n;

  a->par[NUMBER_V] = V;
  n = checked(name, libmlg_hopf_at_V(a->layout, a->par, 0., point, LIBMLG_MOST_POINTS));
  for (int i = 0; i < n && i < LIBMLG_MOST_POINTS; i++)
    if ((point[i].c_d - p->c_d) * (point[i].c_d - q->c_d) < 0.) {
      *found = (struct point){ .V = V, .c_d = point[i].c_d, .frequency_hz = point[i].omega / (2. * MLG_PI) };
      examine(a, found);
      return true;
    }
  return false;
}

/* The point GH between p and q, at which a passes 0, by bisection in V. */
static void print_change(struct arguments *a, struct point p, struct point q, int digits)
{
  struct point middle = p;

  while (fabs(q.V - p.V) > 1e-10 * p.V && between(a, &p, &q, 0.5 * (p.V + q.V), &middle))
    *((middle.a > 0.) == (p.a > 0.) ? &p : &q) = middle;
  if (fabs(q.V - p.V) > 1e-6 * p.V)
    fail(name, MLG_FAILED, "no Hopf point between V = %g, c_d = %g and V = %g, c_d = %g: on one curve they would be neighbours",
         p.V, p.c_d, q.V, q.c_d);
  middle.a = 0.;
  print_point(&middle, digits);
}

static int run(int argc, char *argv[])
{
  struct option option[] = { { "digits", "", 1., 17., 10., NULL }, { .name = NULL } };
  struct arguments a;
  struct point p = { .V = 0. }, before = { .V = 0. };
  bool changes = false;

  begin_arguments(&a, argc, argv, option);
  for (int i = 2; i < argc; i++)
    if (strcmp(argv[i], "GH") == 0)
      changes = true;
    else
      take_word(&a, argv[i]);
  end_arguments(&a);
  for (enum parameter_number n = NUMBER_V; n <= NUMBER_B; n++)
    refuse_given(&a, n, "the points on standard input give it");
  printf("V,c_d,frequency_hz,delta_over_psi,a,growth_in_c_d\n");
  for (int i = 0; read_point(&a, &p.frequency_hz); i++) {
    p.V = a.par[NUMBER_V];
    p.c_d = a.par[NUMBER_C_D];
    examine(&a, &p);
    if (!changes)
      print_point(&p, (int)option[0].value);
    else if (i > 0 && p.a * before.a < 0.)
      print_change(&a, before, p, (int)option[0].value);
    before = p;
  }
  return output_status(name);
}

const struct command command_criticality = {
  .name = name,
  .usage = "LAYOUT [GH] [NAME=VALUE ...] [digits=10] < POINTS",
  .summary = "are Hopf points super- or subcritical?",
  .details =
    "POINTS: a line V,c_d,k_s,b,frequency_hz for each Hopf point, SI units.  GH: instead of\n"
    "these, points of one Hopf curve in order, those between two of them at which a\n"
    "passes 0 (generalised Hopf points; k_s and b are the same for all).\n"
    "\n"
    "Prints CSV, a row for each:\n"
    "  V, c_d          m/s, N m s/rad\n"
    "  frequency_hz    of the mode nearest to that frequency\n"
    "  delta_over_psi  ratio of amplitudes, rad/rad\n"
    "  a               1/s per rad^2: the amplitude r of psi obeys r' = sigma r + a r^3 beside\n"
    "                  the point; a < 0 supercritical, a > 0 subcritical: shimmy, unstable\n"
    "                  itself, beside the stable gear\n"
    "  growth_in_c_d   d(sigma)/d(c_d), 1/s per N m s/rad\n",
  .run = run,
};
