/* damping.c - the least damping ratio of the gear that rolls straight, as a table or at best */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "golden.h"

static const char name[] = "damping";

struct range { const char *text; double from, to; int n; }; /* text begins NAME= */

enum { MOST_RANGES = 4 };

struct search {
  struct arguments given;
  bool at_V; /* V is given, else all speeds count */
  struct range range[MOST_RANGES];
  int ranges;
  int level;                 /* of best: the range that is being searched */
  double value[MOST_RANGES]; /* of each range */
  double best[MOST_RANGES];  /* the values so far best */
  struct libmlg_mode best_mode;
};

static double range_value(const struct range *r, int i)
{
  const double t = (double)i / (r->n - 1);

  return r->from > 0. ? r->from * pow(r->to / r->from, t) : r->from + t * (r->to - r->from);
}

static size_t name_length(const struct range *r)
{
  return strcspn(r->text, "=");
}

static void set_range(struct search *search, int k, double value)
{
  const struct range *r = &search->range[k];

  retake_value(&search->given, r->text, name_length(r), value);
  search->value[k] = value;
}

static struct libmlg_mode mode_of(const struct search *search)
{
  const struct arguments *a = &search->given;
  struct libmlg_mode mode;
  const int status = search->at_V ? libmlg_least_damped(a->layout, a->par, &mode)
                                  : libmlg_least_damped_to(a->layout, a->par, a->V_top, &mode);

  if (status != 0)
    fail(name, MLG_FAILED, "no eigenvalues at V = %g, c_d = %g", a->par[NUMBER_V], a->par[NUMBER_C_D]);
  return mode;
}

static void print_row(const struct search *search, const double value[], const struct libmlg_mode *mode)
{
  for (int k = 0; k < search->ranges; k++)
    printf("%.10g,", value[k]);
  printf("%.8g,", mode->zeta);
  if (!search->at_V)
    printf("%.8g,", mode->V);
  printf("%.8g,%s\n", mode->frequency_hz, mode->delta_over_psi > 1. ? "delta" : "psi");
}

static void print_table(struct search *search, int k)
{
  if (k == search->ranges) {
    const struct libmlg_mode mode = mode_of(search);

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
    const struct libmlg_mode mode = mode_of(search);

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
static void add_range(struct search *search, const char *text, bool best)
{
  struct range *r = &search->range[search->ranges];
  const char *equals = strchr(text, '=');
  char rest;

  if (search->ranges == MOST_RANGES)
    refuse(name, text, "there are four ranges already");
  *r = (struct range){ .text = text, .n = 13 };
  if (!equals || (best ? sscanf(equals + 1, "%lf:%lf%c", &r->from, &r->to, &rest) != 2
                       : sscanf(equals + 1, "%lf:%lf:%d%c", &r->from, &r->to, &r->n, &rest) != 3)
      || !(r->from < r->to && isfinite(r->to)) || r->n < 2)
    refuse(name, text, best ? "expected NAME=FROM:TO, FROM below TO"
                            : "expected NAME=FROM:TO:N, FROM below TO and N above 1");
  take_value(&search->given, text, name_length(r), r->to);
  search->ranges++;
}

static int damping(int argc, char *argv[])
{
  struct search search = { .best_mode.zeta = -HUGE_VAL };
  const bool best = argc > 2 && strcmp(argv[2], "best") == 0;

  begin_arguments(&search.given, argc, argv, NULL);
  for (int i = 2 + best; i < argc; i++)
    if (strchr(argv[i], ':'))
      add_range(&search, argv[i], best);
    else
      take_word(&search.given, argv[i]);
  end_arguments(&search.given);
  search.at_V = search.given.word[NUMBER_V] != NULL;
  if (best && !search.ranges)
    fail(name, MLG_BAD_INPUT, "expected LAYOUT best NAME=FROM:TO ... [NAME=VALUE ...]");
  for (int k = 0; k < search.ranges; k++)
    set_range(&search, k, search.range[k].from);
  if (!(search.given.par[NUMBER_V] > 0.))
    refuse(name, search.given.word[NUMBER_V], "the wheels have to roll: V above 0");
  for (int k = 0; k < search.ranges; k++)
    printf("%.*s,", (int)name_length(&search.range[k]), search.range[k].text);
  printf("zeta,%sfrequency_hz,shimmy\n", search.at_V ? "" : "V,");
  if (best) {
    best_from(0., &search);
    for (int k = 0; k < search.ranges; k++)
      set_range(&search, k, search.best[k]);
    print_row(&search, search.best, &search.best_mode);
  } else {
    print_table(&search, 0);
  }
  return output_status(name);
}

const struct command command_damping = {
  .name = name,
  .usage = "LAYOUT [best] [NAME=VALUE | NAME=FROM:TO:N ...]",
  .summary = "least damping ratio of straight rolling, as a table or the best",
  .details =
    "zeta = -Re(s)/|s| is the least over all eigenvalues s, at V if that is given, otherwise\n"
    "the least over all speeds up to V_top.  N values stand in equal ratios, from FROM = 0\n"
    "in equal steps.\n"
    "\n"
    "  mlg damping li1 b=140 k_s=6.38e5 c_d=6e3                   its least damping ratio\n"
    "  mlg damping li1 b=140 k_s=6.38e5 c_d=6e3 V=0.5:200:300     along V\n"
    "  mlg damping li1 b=140 k_s=3e5:1e6:100 c_d=1e3:2e4:100      over the plane (k_s, c_d)\n"
    "  mlg damping li1 best b=140 c_d=1e3:3e4 compliance=0:0.35   the best damped gear\n"
    "\n"
    "best searches every range NAME=FROM:TO by 13 values and golden section about the best\n"
    "of them, for each value of the ranges that stand before it.\n"
    "\n"
    "Prints CSV: a column for each range; zeta; V m/s where that is, if V is no column;\n"
    "frequency_hz and shimmy (psi, delta) of that mode.  A real root that grows has\n"
    "zeta = -1 and frequency 0.\n",
  .run = damping,
};
