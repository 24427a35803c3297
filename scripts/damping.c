/* damping - the least damping ratio of the gear that rolls straight
 *
 *   damping-LAYOUT [NAME=VALUE | NAME=FROM:TO:N ...]
 *   damping-LAYOUT best NAME=FROM:TO ... [NAME=VALUE ...]
 *
 * NAME: a parameter of models/mlg.h, or compliance (1e5/k_s; 0 is rigid).  N values
 * stand in equal ratios, from FROM = 0 in equal steps.  zeta = -Re(s)/|s| is the
 * least over all modes (scripts/damping.h), at V if that is given, otherwise the least
 * over all speeds up to 200 m/s.
 *
 *   damping-li1 b=140 k_s=6.38e5 c_d=6e3                   its least damping ratio
 *   damping-li1 b=140 k_s=6.38e5 c_d=6e3 V=0.5:200:300     along V
 *   damping-li1 b=140 k_s=3e5:1e6:100 c_d=1e3:2e4:100      over the plane (k_s, c_d)
 *   damping-li1 best b=140 c_d=1e3:3e4 compliance=0:0.35   the best damped gear
 *
 * best searches every range by 13 values and golden section about the best of them,
 * for each value of the ranges that stand before it.
 *
 * Prints CSV: a column for each range; zeta; V m/s where that is, if V is no column;
 * frequency_hz and shimmy (psi, delta) of that mode.  A real root that grows has
 * zeta = -1 and frequency 0.
 * Bad input: one line, status 2.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MLG_NO_AUTO
#include LAYOUT
#include "arguments.h"
#include "damping.h"

static const char program[] = "damping";

struct range { const char *text; double from, to; int n; }; /* text begins NAME= */

enum { MOST_RANGES = 4 };

struct search {
  double par[36];
  int at_V; /* V is given, else all speeds count */
  struct range range[MOST_RANGES];
  int ranges;
  int level;                 /* of best: the range that is being searched */
  double value[MOST_RANGES]; /* of each range */
  double best[MOST_RANGES];  /* the values so far best */
  struct mode best_mode;
};

static double range_value(const struct range *r, int i)
{
  const double t = (double)i / (r->n - 1);

  return r->from > 0. ? r->from * pow(r->to / r->from, t) : r->from + t * (r->to - r->from);
}

/* A parameter by NAME=VALUE; at V = 0 a root is 0. */
static void set(struct search *search, const char *word)
{
  if (set_parameter(program, search->par, word) == PAR_V) {
    search->at_V = 1;
    if (!(search->par[PAR_V] > 0.))
      refuse(program, word, "the wheels have to roll: V above 0");
  }
}

/* Through set, which knows names and limits. */
static void set_range(struct search *search, int k, double value)
{
  char word[64];
  const char *name = search->range[k].text;

  snprintf(word, sizeof word, "%.*s=%.17g", (int)strcspn(name, "="), name, value);
  set(search, word);
  search->value[k] = value;
}

static struct mode mode_of(const struct search *search)
{
  const struct characteristic f = characteristic(search->par);
  const double c_d = search->par[PAR_C_D];

  return search->at_V ? least_damped(&f, search->par[PAR_V], c_d) : least_damped_of_all(&f, c_d);
}

static void print_row(const struct search *search, const double value[], const struct mode *mode)
{
  double par[36];

  memcpy(par, search->par, sizeof par);
  for (int k = 0; k < search->ranges; k++)
    printf("%.10g,", value[k]);
  printf("%.8g,", mode->zeta);
  if (!search->at_V)
    printf("%.8g,", mode->V);
  printf("%.8g,%s\n", cimag(mode->s) / (2. * MLG_PI),
         delta_over_psi(par, mode->V, mode->s) > 1. ? "delta" : "psi");
}

static void print_table(struct search *search, int k)
{
  if (k == search->ranges) {
    const struct mode mode = mode_of(search);

    print_row(search, search->value, &mode);
    return;
  }
  for (int i = 0; i < search->range[k].n; i++) {
    set_range(search, k, range_value(&search->range[k], i));
    print_table(search, k + 1);
  }
}

/* The largest zeta over the ranges from search->level on, with x for the one before. */
static double best_from(double x, void *data)
{
  struct search *search = data;
  const int k = search->level;

  if (k > 0)
    set_range(search, k - 1, x);
  if (k == search->ranges) {
    const struct mode mode = mode_of(search);

    if (mode.zeta > search->best_mode.zeta) {
      search->best_mode = mode;
      memcpy(search->best, search->value, sizeof search->best);
    }
    return mode.zeta;
  }
  const struct range *r = &search->range[k];
  double best = -HUGE_VAL;
  int at = 0;

  search->level++;
  for (int i = 0; i < r->n; i++) {
    const double zeta = best_from(range_value(r, i), search);

    if (zeta > best) {
      best = zeta;
      at = i;
    }
  }
  const double top = summit(best_from, search, range_value(r, at > 0 ? at - 1 : 0),
                            range_value(r, at + 1 < r->n ? at + 1 : at));

  best = fmax(best, best_from(top, search));
  search->level--;
  return best;
}

/* NAME=FROM:TO:N, or NAME=FROM:TO for best. */
static void add_range(struct search *search, const char *text, int best)
{
  struct range *r = &search->range[search->ranges];
  const char *equals = strchr(text, '=');
  char rest;

  if (search->ranges == MOST_RANGES)
    refuse(program, text, "there are four ranges already");
  *r = (struct range){ .text = text, .n = 13 };
  if (!equals || (best ? sscanf(equals + 1, "%lf:%lf%c", &r->from, &r->to, &rest) != 2
                       : sscanf(equals + 1, "%lf:%lf:%d%c", &r->from, &r->to, &r->n, &rest) != 3)
      || !(r->from < r->to && isfinite(r->to)) || r->n < 2)
    refuse(program, text, best ? "expected NAME=FROM:TO, FROM below TO"
                               : "expected NAME=FROM:TO:N, FROM below TO and N above 1");
  search->ranges++;
  set_range(search, search->ranges - 1, r->to); /* names and limits are looked at now */
  set_range(search, search->ranges - 1, r->from);
}

int main(int argc, char *argv[])
{
  struct search search = { .best_mode.zeta = -HUGE_VAL };
  const int best = argc > 1 && strcmp(argv[1], "best") == 0;

  mlg_defaults(search.par);
  for (int i = 1 + best; i < argc; i++)
    if (strchr(argv[i], ':'))
      add_range(&search, argv[i], best);
    else
      set(&search, argv[i]);
  if (best && !search.ranges) {
    fprintf(stderr, "usage: damping best NAME=FROM:TO ... [NAME=VALUE ...]\n");
    return 2;
  }
  for (int k = 0; k < search.ranges; k++)
    printf("%.*s,", (int)strcspn(search.range[k].text, "="), search.range[k].text);
  printf("zeta,%sfrequency_hz,shimmy\n", search.at_V ? "" : "V,");
  if (best) {
    best_from(0., &search);
    for (int k = 0; k < search.ranges; k++)
      set_range(&search, k, search.best[k]);
    print_row(&search, search.best, &search.best_mode);
  } else {
    print_table(&search, 0);
  }
  return output_status(program);
}
