/* passive.c - the largest damping ratio of any passive device (positive_real.h), by a search */
#include "positive_real.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "cma.h"
#include "command.h"
#include "names.h"
#include "device_text.h"

enum { MOST_STARTS = 300, SPEEDS = 40 };

/* --- search: the BFGS method with a weak line search, and repeated starts -------------------------------- */

enum { N = MOST_VARIABLES, LINE_STEPS = 40 };

static double product(int n, const double a[], const double b[])
{
  double sum = 0.;

  for (int i = 0; i < n; i++)
    sum += a[i] * b[i];
  return sum;
}

/* Armijo's and Wolfe's conditions, by doubling and bisection (Lewis and Overton, Math. Program. 141
 * (2013) 135-163, Algorithm 2.6); 1: a better place was found. */
static int line_search(struct passive *p, int n, double y[], double *value, double slope[], const double direction[], int *asked)
{
  const double rise = product(n, slope, direction);
  double lo = 0., hi = INFINITY, t = 1., from[N], best[N], best_value = *value, best_slope[N];

  memcpy(from, y, sizeof from);
  memcpy(best_slope, slope, sizeof best_slope);
  memcpy(best, y, sizeof best);
  for (int i = 0; i < LINE_STEPS; i++) {
    double here[N], s[N] = { 0. }, v;

    for (int k = 0; k < n; k++)
      here[k] = from[k] + t * direction[k];
    v = passive_value(p, here, n, s);
    ++*asked;
    if (v > best_value) {
      best_value = v;
      memcpy(best, here, sizeof best);
      memcpy(best_slope, s, sizeof best_slope);
    }
    if (!(v > *value + 1e-4 * t * rise))
      hi = t;
    else if (product(n, s, direction) > 0.9 * rise)
      lo = t;
    else
      break;
    t = hi < INFINITY ? 0.5 * (lo + hi) : 2. * t;
  }
  const int better = best_value > *value;

  memcpy(y, best, sizeof best);
  memcpy(slope, best_slope, sizeof best_slope);
  *value = best_value;
  return better;
}

/* Uphill from y at one softness; returns the value reached. */
static double climb_softened(struct passive *p, int n, double y[], int most, int *asked)
{
  double H[N * N], slope[N] = { 0. }, value = passive_value(p, y, n, slope);

  for (int again = 0; again < 2; again++) { /* with fresh H where it got stuck */
    const double before = value;

    for (int i = 0; i < n * n; i++)
      H[i] = i % (n + 1) == 0 ? 1. / fmax(1e-12, sqrt(product(n, slope, slope))) : 0.;
    for (int step = 0; step < most; step++) {
      double direction[N], old_y[N], old_slope[N], s[N], g[N], Hg[N];

      for (int i = 0; i < n; i++)
        direction[i] = product(n, H + i * n, slope);
      if (!(product(n, direction, slope) > 0.))
        break;
      memcpy(old_y, y, sizeof old_y);
      memcpy(old_slope, slope, sizeof old_slope);
      if (!line_search(p, n, y, &value, slope, direction, asked))
        break;
      for (int i = 0; i < n; i++) {
        s[i] = y[i] - old_y[i];
        g[i] = old_slope[i] - slope[i];
      }
      const double sg = product(n, s, g);

      if (!(sg > 1e-300))
        continue;
      for (int i = 0; i < n; i++)
        Hg[i] = product(n, H + i * n, g);
      const double gHg = product(n, g, Hg);

      for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
          H[i * n + k] += (1. + gHg / sg) * s[i] * s[k] / sg - (Hg[i] * s[k] + s[i] * Hg[k]) / sg;
    }
    if (!(value > before + 1e-7 * fabs(before)))
      break;
  }
  return value;
}

/* Harder and harder; returns the least ratio reached, exactly. */
static double climb(struct passive *p, int n, double y[], int most, int *asked)
{
  double best = -INFINITY, best_y[N];
  struct libmlg_ratio ratio;

  p->speeds = 0;
  for (int i = 0; i < SPEEDS; i++)
    p->V[p->speeds++] = p->V_least * pow(p->V_top / p->V_least, (double)i / (SPEEDS - 1));
  for (p->softness = 3e-3; p->softness > 5e-8; p->softness *= 0.25) {
    climb_softened(p, n, y, most, asked);
    if (passive_least(p, y, &ratio) != 0)
      break;
    if (p->speeds < MOST_SPEEDS)
      p->V[p->speeds++] = ratio.V;
    if (ratio.zeta > best) {
      best = ratio.zeta;
      memcpy(best_y, y, sizeof best_y);
    }
  }
  if (best > -INFINITY)
    memcpy(y, best_y, sizeof best_y);
  return best;
}

/* The same device with one state more, which does next to nothing. */
static void with_one_more(int m, const double x[], double y[], struct cma_random *random)
{
  int from = 1, to = 1;

  y[0] = x[0];
  for (int i = 0; i <= m + 1; i++)
    for (int k = 0; k <= i; k++) {
      const int row = i > m ? m : i, column = k > m ? m : k;

      /* the new state m, with R of its own; D's row moves down by one */
      y[to++] = i == m || k == m ? (i == k ? 4. : 0.2) * cma_normal(random) : x[from + row * (row + 1) / 2 + column];
    }
  from += (m + 1) * (m + 2) / 2;
  for (int i = 0; i <= m; i++)
    for (int k = 0; k < i; k++)
      y[to++] = i == m ? 2. * cma_normal(random) : x[from + i * (i - 1) / 2 + k];
  from += m * (m - 1) / 2;
  for (int i = 0; i <= m; i++)
    y[to++] = i == m ? 0.5 * cma_normal(random) : x[from + i];
}

/* A number from least to most, its logarithm drawn evenly, as a variable of positive_real.h. */
static double drawn(struct cma_random *random, double least, double most)
{
  const double size = least * pow(most / least, cma_uniform(random));

  return asinh(size / PASSIVE_UNIT) * (cma_uniform(random) < 0.5 ? -1. : 1.);
}

/* Oscillators beside a damper: J couples states in pairs, each at some frequency, and R is nearly
 * diagonal.  In units of k_psi and 100 rad/s. */
static void draw_oscillators(int m, double y[], struct cma_random *random)
{
  int to = 0;

  y[to++] = 0.1 * cma_normal(random);
  for (int i = 0; i <= m; i++)
    for (int k = 0; k <= i; k++)
      y[to++] = i == k ? drawn(random, 0.01, 0.5) : 0.3 * cma_normal(random);
  for (int i = 0; i < m; i++)
    for (int k = 0; k < i; k++)
      y[to++] = i % 2 == 1 && k == i - 1 ? drawn(random, 0.2, 4.) : 0.3 * cma_normal(random);
  for (int i = 0; i < m; i++)
    y[to++] = drawn(random, 0.03, 2.);
}

struct best { double zeta, x[MOST_VARIABLES]; int met, starts, asked; };

/* The least ratio at a place of cma.h's box, exactly. */
static double exact_zeta(const double place[], void *context)
{
  struct passive *const p = context;
  double y[MOST_VARIABLES];
  struct libmlg_ratio ratio;

  for (int i = 0; i < passive_variables(p->m); i++)
    y[i] = 32. * place[i] - 16.;
  return passive_least(p, y, &ratio) == 0 ? ratio.zeta : -INFINITY;
}

/* The best once more, by the evolution strategy, which needs no softening. */
static void polish(struct passive *p, int n, struct best *best)
{
  for (int round = 0; round < 4; round++) {
    struct cma_random random = { 31ULL * (unsigned)round + 7ULL };
    double place[MOST_VARIABLES], zeta;

    for (int i = 0; i < n; i++)
      place[i] = (best->x[i] + 16.) / 32.;
    best->asked += cma_largest(exact_zeta, p, n, place, (double[]){ 0.02, 3e-3, 3e-4, 3e-5 }[round], &random, 150 * n, INFINITY, &zeta);
    if (zeta > best->zeta) {
      best->zeta = zeta;
      for (int i = 0; i < n; i++)
        best->x[i] = 32. * place[i] - 16.;
    }
  }
}

/* Where a start begins: from the best of one order less, from oscillators, from random places, and
 * from the best so far with some of its variables drawn anew, for there are many local maxima. */
static void draw(const struct passive *p, int start, const double before[], const struct best *best, double y[],
                 struct cma_random *random)
{
  const int n = passive_variables(p->m);

  if (start > 3 && start % 2)
    for (int i = 0; i < n; i++)
      y[i] = cma_uniform(random) < 0.35 ? 11. * cma_uniform(random) - 5.5 : best->x[i];
  else if (before && start % 4 == 0)
    with_one_more(p->m - 1, before, y, random);
  else if (start % 4 == 2)
    draw_oscillators(p->m, y, random);
  else
    for (int i = 0; i < n; i++)
      y[i] = i == 0 ? 0.3 * cma_normal(random) : 11. * cma_uniform(random) - 5.5;
}

static void search(struct passive *p, int starts, const double before[], struct best *best)
{
  const int n = passive_variables(p->m);
  double result[MOST_STARTS];

  *best = (struct best){ .zeta = -INFINITY, .starts = starts };
  for (int start = 0; start < starts; start++) {
    struct cma_random random = { 104729ULL * (unsigned)start + 17ULL * (unsigned)p->m + 1ULL };
    double y[MOST_VARIABLES] = { 0. };
    struct libmlg_ratio at;

    for (int again = 0; again < 100; again++) {
      draw(p, start, before, best, y, &random);
      if (passive_least(p, y, &at) == 0 && at.zeta > -0.5)
        break;
    }
    result[start] = climb(p, n, y, 60 + 10 * n, &best->asked);
    if (result[start] > best->zeta) {
      best->zeta = result[start];
      memcpy(best->x, y, sizeof y);
    }
  }
  polish(p, n, best);
  for (int start = 0; start < starts; start++)
    best->met += result[start] >= best->zeta - 0.01 * fabs(best->zeta);
}

/* How many starts of that order: they are cheap at low orders, which have narrow maxima, and dear
 * at high ones, which begin from the best of the order before. */
static int starts_of(int order, int starts)
{
  return order <= 2 ? 3 * starts : order <= 4 ? starts : (starts + 1) / 2;
}

static void print_row(struct passive *p, const struct best *best)
{
  struct libmlg_ratio ratio;
  struct libmlg_mode mode;

  if (passive_least(p, best->x, &ratio) != 0)
    fail("passive", MLG_FAILED, "no eigenvalues");
  p->par[NUMBER_V] = ratio.V;
  if (libmlg_least_damped(p->layout, p->par, &mode) != 0)
    fail("passive", MLG_FAILED, "no eigenvalues");
  const struct device_text *const d = device_of(p->layout);
  const double _Complex Z = passive_stiffness(p, I * 2. * MLG_PI * 17.5);

  printf("%d,%.8g,%.8g,%.8g,%s,%.8g,%.8g,%.8g,%d,%d,%d,", p->m + 1, best->zeta, ratio.V, mode.frequency_hz,
         shimmy_name(p->par, mode.delta_over_psi), p->K, creal(Z), cimag(Z), best->met, best->starts, best->asked);
  for (int of_den = 0; of_den < 2; of_den++)
    for (int i = 0; i <= p->m + 1; i++) {
      const struct network *const r = &d->rational;
      const double beside = i > 0 ? p->par[NUMBER_C_D] * r->den.coefficient[i - 1] : 0.;

      printf("%s%.15g", i == 0 ? of_den ? "," : "" : " ", of_den ? r->den.coefficient[i] : r->num.coefficient[i] + beside);
    }
  putchar('\n');
  fflush(stdout);
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
  char *words[64] = { argv[0], (char *)"k_d|c_d" };
  struct passive p = { .layout = 0 };
  struct arguments a;
  struct best best;
  double before[MOST_VARIABLES];

  if (argc > 62)
    fail(argv[0], MLG_BAD_INPUT, "too many words");
  memcpy(words + 2, argv + 1, (size_t)(argc - 1) * sizeof *argv);
  read_arguments(&a, argc + 1, words, option);
  refuse_given(&a, NUMBER_V, "the search is over all speeds");
  refuse_given(&a, NUMBER_C_D, "the search is over all devices");
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  memcpy(p.par, a.par, sizeof p.par);
  p.K_least = option[K_LEAST].word ? option[K_LEAST].value : p.par[NUMBER_K_D];
  p.V_least = option[V_LEAST].value;
  p.V_top = a.V_top;
  printf("# V m/s, K N m/rad, Z_re, Z_im N m/rad at 17.5 Hz; num, den of Z, powers of s rising, SI\n"
         "order,zeta,V,frequency_hz,shimmy,K,Z_re,Z_im,met,starts,asked,num,den\n");
  for (p.m = 0; p.m < (int)option[ORDER].value; p.m++) {
    p.layout = device_rational(p.m);
    if (p.layout == LIBMLG_NONE)
      fail(argv[0], MLG_FAILED, "out of memory");
    search(&p, starts_of(p.m + 1, (int)option[STARTS].value), p.m > 0 ? before : NULL, &best);
    print_row(&p, &best);
    memcpy(before, best.x, sizeof before);
  }
  return output_status(argv[0]);
}

const struct command command_passive = {
  .name = "passive",
  .usage = "[NAME=VALUE ...] [order=6] [starts=16] [K_least=k_d] [V_least=0.3]",
  .summary = "the largest damping ratio of any passive device",
  .details =
    "Of all devices behind k_psi that give no energy and have a static stiffness of at least K_least,\n"
    "of order 1, 2, ... to `order`: every positive-real impedance of that order, as a spring beside\n"
    "a port-Hamiltonian system, by the BFGS method (scripts/mlg/gear/passive.c) from so many\n"
    "starts, three times as many for orders 1 and 2, half as many for 5 and 6.  K_least=0: any device.\n"
    "A search, no proof: what it finds is a bound from below, also where many starts met; hold it against\n"
    "`mlg damping LAYOUT best b_most=VALUE` of this gear.\n"
    "CSV, a row for each order, printed as it is found:\n"
    "  zeta          the least damping ratio over V_least < V < V_top, at its largest\n"
    "  V, frequency_hz, shimmy  of the mode that has it\n"
    "  K             static stiffness of the device, without k_psi\n"
    "  Z_re, Z_im    its dynamic stiffness at 17.5 Hz, where the delta mode is\n"
    "  met, starts   how many of the starts came within 1 % of the best\n"
    "  asked         how many devices were looked at\n"
    "  num, den      of Z, with blanks between the coefficients\n",
  .run = run,
};
