/* passive.c - the largest damping ratio of any passive device (positive_real.h), by a search */
#include "positive_real.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "bfgs.h"
#include "cma.h"
#include "command.h"
#include "csv.h"
#include "device_text.h"
#include "linearised.h"
#include "names.h"

enum { MOST_STARTS = 300, SPEEDS = 16 };

/* --- uphill ---------------------------------------------------------------------------------------------- */

static double softened(void *context, const double y[], double slope[])
{
  struct passive *const p = context;

  return passive_value(p, y, slope);
}

static double exact(void *context, const double y[], double slope[])
{
  struct passive *const p = context;

  return passive_least_value(p, y, slope);
}

/* Harder and harder, from a softness on, the exact place of the least ratio among the speeds each time,
 * at last, or from a softness of 0 alone, the least ratio itself, with its kinks; returns what was reached. */
static double climb(struct passive *p, double y[], double softness, int *asked)
{
  struct bfgs f = { softened, p, passive_variables(p->m), 0 };
  struct libmlg_ratio ratio;
  double best = passive_least(p, y, &ratio) == 0 ? ratio.zeta : -INFINITY, best_y[MOST_VARIABLES];

  memcpy(best_y, y, (size_t)f.n * sizeof *y);
  p->speeds = 0;
  for (int i = 0; i < SPEEDS; i++)
    p->V[p->speeds++] = p->V_least * pow(p->V_top / p->V_least, (double)i / (SPEEDS - 1));
  for (p->softness = softness; p->softness > 6e-7; p->softness *= 0.25) {
    bfgs_climb(&f, y, 60 + 10 * f.n);
    if (passive_least(p, y, &ratio) != 0)
      break;
    if (p->speeds < MOST_SPEEDS)
      p->V[p->speeds++] = ratio.V;
    if (ratio.zeta > best) {
      best = ratio.zeta;
      memcpy(best_y, y, (size_t)f.n * sizeof *y);
    }
  }
  if (best > -1.) {
    memcpy(y, best_y, (size_t)f.n * sizeof *y);
    f.value = exact;
    best = bfgs_climb(&f, y, 20 * f.n);
  }
  *asked += f.asked;
  return best;
}

/* --- starts ---------------------------------------------------------------------------------------------- */

/* A number from least to most, its logarithm drawn evenly, as a variable of positive_real.h. */
static double drawn(struct cma_random *random, double least, double most)
{
  const double size = least * pow(most / least, cma_uniform(random));

  return asinh(size / PASSIVE_UNIT) * (cma_uniform(random) < 0.5 ? -1. : 1.);
}

/* An oscillator about the frequencies of the gear, coupled by so much. */
static void draw_oscillator(double y[], double coupling, struct cma_random *random)
{
  y[0] = drawn(random, 0.3, 3.);
  for (int i = 1; i < 4; i++)
    y[i] = drawn(random, 0.3 * coupling, 3. * coupling);
}

/* The best device of m - 1 states with one more, coupled by so much at most: one of frequency 0, or
 * that one turned into an oscillator. */
static void with_a_state(int m, const double before[], double y[], double coupling, struct cma_random *random)
{
  const int n = passive_variables(m);

  memcpy(y, before, (size_t)n * sizeof *y);
  y[n - 1] = before[n - 3];
  if (m % 2) {
    y[n - 3] = drawn(random, 0.01 * coupling, coupling);
    y[n - 2] = drawn(random, 0.01 * coupling, coupling);
  } else {
    y[n - 5] = drawn(random, 0.01 * coupling, 5. * coupling);
    y[n - 4] = before[n - 5];
    y[n - 3] = before[n - 4];
    y[n - 2] = drawn(random, 0.01 * coupling, coupling);
  }
}

/* The best device of m - 2 states with an oscillator more. */
static void with_an_oscillator(int m, const double before[], double y[], struct cma_random *random)
{
  const int n = passive_variables(m);

  y[0] = before[0];
  draw_oscillator(y + 1, cma_uniform(random) < 0.5 ? 0.02 : 0.1, random);
  memcpy(y + 5, before + 1, (size_t)(n - 5) * sizeof *y);
}

/* Oscillators beside a damper, at random. */
static void draw_oscillators(int m, double y[], struct cma_random *random)
{
  double *to = y;

  *to++ = 0.3 * cma_normal(random);
  for (int i = 0; i + 1 < m; i += 2, to += 4)
    draw_oscillator(to, 0.3, random);
  while (to < y + passive_variables(m))
    *to++ = drawn(random, 0.01, 1.);
}

struct best { double zeta, x[MOST_VARIABLES]; int met, starts, asked; };

/* One start leaves the best of one order less nearly as it is, so that no order is worse than that. */
static int is_gentle(int m, int start)
{
  return m > 0 && start == 1;
}

/* Where a start begins, for there are many local maxima: at the best of two orders less with an
 * oscillator more, of one order less with a state more, at random, and at the best so far with some of
 * its variables drawn anew or all of them moved a little. */
static void draw(const struct passive *p, int start, const struct best found[], double y[], struct cma_random *random)
{
  const int m = p->m, n = passive_variables(m);
  const struct best *const best = &found[m];

  if (m > 1 && (start % 4 == 0 || (start % 4 == 3 && start < 4)))
    with_an_oscillator(m, found[m - 2].x, y, random);
  else if (m > 0 && start % 4 == 1)
    with_a_state(m, found[m - 1].x, y, is_gentle(m, start) ? 1e-4 : 0.2, random);
  else if (start % 4 == 3 && best->zeta > -1.)
    for (int i = 0; i < n; i++)
      y[i] = start % 8 == 3 ? best->x[i] + 0.1 * cma_normal(random)
             : cma_uniform(random) < 0.35 ? 11. * cma_uniform(random) - 5.5 : best->x[i];
  else
    draw_oscillators(m, y, random);
}

static void search(struct passive *p, int starts, struct best found[])
{
  struct best *const best = &found[p->m];
  double result[MOST_STARTS];

  *best = (struct best){ .zeta = -INFINITY, .starts = starts };
  for (int start = 0; start < starts; start++) {
    struct cma_random random = { 104729ULL * (unsigned)start + 17ULL * (unsigned)p->m + 1ULL };
    double y[MOST_VARIABLES] = { 0. };
    struct libmlg_ratio at;

    for (int again = 0; again < 100; again++) {
      draw(p, start, found, y, &random);
      if (passive_least(p, y, &at) == 0 && at.zeta > -0.5)
        break;
    }
    result[start] = climb(p, y, is_gentle(p->m, start) ? 0. : start / 2 % 2 ? 1e-3 : 3e-3, &best->asked);
    if (result[start] > best->zeta) {
      best->zeta = result[start];
      memcpy(best->x, y, sizeof y);
    }
  }
  for (int start = 0; start < starts; start++)
    best->met += result[start] >= best->zeta - 0.01 * fabs(best->zeta);
}

/* How many starts of that order: at order 2 they are cheap, and the largest maximum is narrow. */
static int starts_of(int order, int starts)
{
  return order == 2 ? 3 * starts : starts;
}

static void print_row(struct passive *p, const struct best *best)
{
  struct libmlg_ratio ratio;
  double slots[MLG_SLOTS];

  if (passive_least(p, best->x, &ratio) != 0)
    fail("passive", MLG_FAILED, "no eigenvalues");
  const double _Complex s = passive_mode(p, ratio.V), Z = passive_stiffness(p, I * 2. * MLG_PI * 17.5);

  libmlg_slots(p->par, slots);
  printf("%d,%.8g,%.8g,%.8g,%s,%.8g,%.8g,%.8g,%d,%d,%d,", p->m + 1, ratio.zeta, ratio.V, cimag(s) / (2. * MLG_PI),
         shimmy_name(p->par, delta_over_psi(slots, ratio.V, s)), p->K, creal(Z), cimag(Z), best->met, best->starts, best->asked);
  for (int of_den = 0; of_den < 2; of_den++)
    for (int i = 0; i <= p->m + 1; i++) {
      const struct network *const r = &device_of(p->layout)->rational;
      const double beside = i > 0 ? p->par[NUMBER_C_D] * r->den.coefficient[i - 1] : 0.;

      printf("%s%.15g", i == 0 ? of_den ? "," : "" : " ", of_den ? r->den.coefficient[i] : r->num.coefficient[i] + beside);
    }
  for (int i = 0; i < passive_variables(p->m); i++)
    printf("%c%.17g", i == 0 ? ',' : ' ', best->x[i]);
  putchar('\n');
  fflush(stdout);
}

static void begin_order(struct passive *p, int m)
{
  p->m = m;
  p->layout = device_rational(m);
  if (p->layout == LIBMLG_NONE)
    fail("passive", MLG_FAILED, "out of memory");
}

/* The orders 1, 2, ... that a table of this command has; returns how many. */
static int take_found(struct passive *p, const char *file, struct best found[])
{
  static const char *const name[] = { "order", "zeta", "met", "starts", "asked", "y" };
  enum { ORDER, ZETA, MET, STARTS, ASKED, Y, COLUMNS };
  struct text why = TEXT_NONE;
  struct csv table;
  int column[COLUMNS], row;

  if (csv_read(file, &table, &why) != 0)
    fail("passive", MLG_BAD_INPUT, "%s", why.at);
  for (int i = 0; i < COLUMNS; i++)
    if ((column[i] = csv_column(&table, name[i])) < 0)
      fail("passive", MLG_BAD_INPUT, "%s: no table of mlg passive, for it has no column '%s'", file, name[i]);
  for (row = 0; row < table.rows && row <= MOST_M; row++) {
    const char *at = csv_cell(&table, row, column[Y]);
    const double zeta = csv_number(&table, row, column[ZETA]);
    struct libmlg_ratio ratio;

    if (csv_number(&table, row, column[ORDER]) != row + 1)
      fail("passive", MLG_BAD_INPUT, "%s: row %d is of order '%s'", file, row + 1, csv_cell(&table, row, column[ORDER]));
    found[row] = (struct best){ .met = (int)csv_number(&table, row, column[MET]),
                                .starts = (int)csv_number(&table, row, column[STARTS]),
                                .asked = (int)csv_number(&table, row, column[ASKED]) };
    for (int i = 0; i < passive_variables(row); i++) {
      char *end;

      found[row].x[i] = strtod(at, &end);
      if (end == at || !(fabs(found[row].x[i]) < PASSIVE_MOST))
        fail("passive", MLG_BAD_INPUT, "%s: order %d: '%s': expected %d numbers", file, row + 1,
             csv_cell(&table, row, column[Y]), passive_variables(row));
      at = end;
    }
    begin_order(p, row);
    if (passive_least(p, found[row].x, &ratio) != 0 || !(fabs(ratio.zeta - zeta) < 1e-6 * fabs(zeta)))
      fail("passive", MLG_BAD_INPUT, "%s: order %d has zeta = %.8g, with this gear and range of V it is %.8g", file, row + 1, zeta, ratio.zeta);
  }
  csv_free(&table);
  text_free(&why);
  return row;
}

static int run(int argc, char *argv[])
{
  enum { ORDER, STARTS, K_LEAST, V_LEAST };
  struct option option[] = {
    [ORDER] = { "order", "", 1., MOST_M + 1., MOST_M + 1., NULL },
    [STARTS] = { "starts", "", 1., MOST_STARTS / 3., 16., NULL },
    [K_LEAST] = { "K_least", "N m/rad", 0., 1e9, NAN, NULL },
    [V_LEAST] = { "V_least", "m/s", 1e-3, 1e3, 0.3, NULL },
    { .name = NULL },
  };
  char *words[] = { argv[0], (char *)"k_d|c_d", NULL };
  const char *file = NULL;
  struct passive p = { .layout = 0 };
  struct arguments a;
  struct best found[MOST_M + 1];

  begin_arguments(&a, 2, words, option);
  for (int i = 1; i < argc; i++)
    if (strncmp(argv[i], "from=", 5) == 0) {
      if (file)
        refuse(argv[0], argv[i], "given already, by 'from=%.200s'", file);
      file = argv[i] + 5;
    } else
      take_word(&a, argv[i]);
  end_arguments(&a);
  refuse_given(&a, NUMBER_V, "the search is over all speeds");
  refuse_given(&a, NUMBER_C_D, "the search is over all devices");
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  memcpy(p.par, a.par, sizeof p.par);
  p.K_least = option[K_LEAST].word ? option[K_LEAST].value : p.par[NUMBER_K_D];
  p.V_least = option[V_LEAST].value;
  p.V_top = a.V_top;
  const int known = file ? take_found(&p, file, found) : 0;

  printf("# V m/s, K N m/rad, Z_re, Z_im N m/rad at 17.5 Hz; num, den of Z, powers of s rising, SI\n"
         "order,zeta,V,frequency_hz,shimmy,K,Z_re,Z_im,met,starts,asked,num,den,y\n");
  for (int m = 0; m < (int)option[ORDER].value; m++) {
    begin_order(&p, m);
    if (m >= known)
      search(&p, starts_of(m + 1, (int)option[STARTS].value), found);
    print_row(&p, &found[m]);
  }
  return output_status(argv[0]);
}

const struct command command_passive = {
  .name = "passive",
  .usage = "[NAME=VALUE ...] [order=7] [starts=16] [K_least=k_d] [V_least=0.3] [from=FILE]",
  .summary = "the largest damping ratio of any passive device",
  .details =
    "Of all devices behind k_psi that give no energy and have a static stiffness of at least K_least,\n"
    "of order 1, 2, ... to `order`: every positive-real impedance of that order, as a spring beside\n"
    "a network without losses that ends in one damper, by the BFGS method (scripts/mlg/gear/passive.c)\n"
    "from so many starts, three times as many for order 2.  K_least=0: any device.\n"
    "from=FILE: a table of this command; its orders are taken over and the others follow.\n"
    "A search, no proof: what it finds is a bound from below, also where many starts met; hold it against\n"
    "`mlg damping LAYOUT best b_most=VALUE` of this gear.\n"
    "CSV, a row for each order, printed as it is found:\n"
    "  zeta          the least damping ratio over V_least < V < V_top, at its largest\n"
    "  V, frequency_hz, shimmy  of the mode that has it\n"
    "  K             static stiffness of the device, without k_psi\n"
    "  Z_re, Z_im    its dynamic stiffness at 17.5 Hz, where the delta mode is\n"
    "  met, starts   how many of the starts came within 1 % of the best\n"
    "  asked         how many devices were looked at\n"
    "  num, den      of Z, with blanks between the coefficients\n"
    "  y             its variables (scripts/mlg/gear/positive_real.h), to go on from\n",
  .run = run,
};
