/* damping.c - the least damping ratio of the gear that rolls straight, as a table or at best */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "designs.h"
#include "names.h"
#include "waiting.h"

static const char name[] = "damping";

enum { MOST_RANGES = 4 };
enum { V_LEAST, B_LEAST, B_MOST };

struct search {
  struct arguments given;
  struct option option[4];
  bool at_V; /* V is given, else all speeds count */
  struct range range[MOST_RANGES];
  int ranges;
  double value[MOST_RANGES]; /* of each range */
};

static double range_value(const struct range *r, int i)
{
  const double t = (double)i / (r->n - 1);

  return r->from > 0. ? r->from * pow(r->to / r->from, t) : r->from + t * (r->to - r->from);
}

static void set_range(struct search *search, int k, double value)
{
  const struct range *r = &search->range[k];

  retake_value(&search->given, r->text, range_name_length(r), value);
  search->value[k] = value;
}

static _Noreturn void no_answer(const struct arguments *a)
{
  fail(name, MLG_FAILED, "no eigenvalues at V = %g, c_d = %g", a->par[NUMBER_V], a->par[NUMBER_C_D]);
}

/* The least damped mode at V; V = 0 is a limit: there a root is 0. */
static struct libmlg_mode mode_at(struct arguments *a, double V)
{
  struct libmlg_mode mode;

  a->par[NUMBER_V] = V > 0. ? V : 1e-6 * a->V_top;
  if (libmlg_least_damped(a->layout, a->par, &mode) != 0)
    no_answer(a);
  return mode;
}

static struct libmlg_mode mode_between(struct arguments *a, double V_least, double V_top)
{
  struct libmlg_ratio least;

  if (libmlg_least_ratio(a->layout, a->par, V_least, V_top, &least) != 0)
    no_answer(a);
  return mode_at(a, least.V);
}

/* "zeta,V,frequency_hz,shimmy,t_5" */
static void print_mode(const struct arguments *a, const struct libmlg_mode *mode, bool with_V)
{
  printf("%.8g,", mode->zeta);
  if (with_V)
    printf("%.8g,", mode->V);
  printf("%.8g,%s,", mode->frequency_hz, shimmy_name(a->par, mode->delta_over_psi));
  if (mode->re < 0.)
    printf("%.6g", log(20.) / -mode->re);
  printf("\n");
}

static void print_table(struct search *search, int k)
{
  struct arguments *a = &search->given;

  if (k < search->ranges) {
    for (int i = 0; i < search->range[k].n; i++) {
      set_range(search, k, range_value(&search->range[k], i));
      print_table(search, k + 1);
    }
    return;
  }
  const struct libmlg_mode mode = search->at_V ? mode_at(a, a->par[NUMBER_V])
                                               : mode_between(a, search->option[V_LEAST].value, a->V_top);

  for (int i = 0; i < search->ranges; i++)
    printf("%.10g,", search->value[i]);
  print_mode(a, &mode, !search->at_V);
}

static void print_best(struct search *search)
{
  struct arguments *a = &search->given;
  struct option *option = search->option;
  const bool over_k_s = libmlg_uses(a->layout, NUMBER_K_S) && !a->word[NUMBER_K_S];
  const bool over_b = option[B_MOST].word != NULL;
  const double V_least = option[V_LEAST].value, b = a->par[NUMBER_B];
  struct libmlg_ratio best;
  int status;

  refuse_given(a, NUMBER_C_D, "the best c_d is looked for");
  refuse_given(a, NUMBER_V, "all speeds count");
  if (over_b && !libmlg_uses(a->layout, NUMBER_B))
    refuse(name, option[B_MOST].word, "layout %s has no b", libmlg_layout_name(a->layout));
  if (over_b && a->word[NUMBER_B])
    refuse(name, a->word[NUMBER_B], "b_most says that b is looked for");
  if (over_b && a->word[NUMBER_K_S])
    refuse(name, a->word[NUMBER_K_S], "the best b goes with its best k_s; leave it out");
  if (!over_b && option[B_LEAST].word)
    refuse(name, option[B_LEAST].word, "goes with b_most=VALUE");
  if (option[B_LEAST].value > option[B_MOST].value)
    refuse(name, option[B_MOST].word, "below b_least = %g", option[B_LEAST].value);
  show_searches();
  if (over_k_s || over_b)
    status = libmlg_best_damped(a->layout, a->par, over_b ? option[B_LEAST].value : b, over_b ? option[B_MOST].value : b,
                                V_least, a->V_top, &best);
  else
    status = libmlg_best_c_d(a->layout, a->par, V_least, a->V_top, &best);
  if (status == LIBMLG_UNSURE)
    fail(name, MLG_FAILED, "what was found contradicts itself: no answer for these parameters");
  if (status != 0)
    no_answer(a);
  a->par[NUMBER_C_D] = best.c_d;
  a->par[NUMBER_K_S] = best.k_s;
  a->par[NUMBER_B] = best.b;
  const struct libmlg_mode mode = shown_mode(a, a->par, V_least, &best);

  hide_search();
  printf("%s%sc_d,zeta,V,frequency_hz,shimmy,t_5\n", over_b ? "b," : "", over_k_s ? "k_s," : "");
  if (over_b)
    printf("%.8g,", best.b);
  if (over_k_s)
    printf("%.8g,", best.k_s);
  printf("%.10g,", best.c_d);
  print_mode(a, &mode, true);
}

/* NAME=FROM:TO:N */
static void add_range(struct search *search, const char *text)
{
  if (search->ranges == MOST_RANGES)
    refuse(name, text, "there are four ranges already");
  search->range[search->ranges++] = take_range(&search->given, text);
}

static int damping(int argc, char *argv[])
{
  struct search search = { .option = { [V_LEAST] = { "V_least", "m/s", 0., 1e3, 0.3, NULL },
                                       [B_LEAST] = { "b_least", "N m s^2/rad", 0., 1e9, 0., NULL },
                                       [B_MOST] = { "b_most", "N m s^2/rad", 0., 1e9, 0., NULL } } };
  struct arguments *a = &search.given;
  const bool best = argc > 2 && strcmp(argv[2], "best") == 0;

  begin_arguments(a, argc, argv, search.option);
  for (int i = 2 + best; i < argc; i++)
    if (strchr(argv[i], ':') && !best)
      add_range(&search, argv[i]);
    else
      take_word(a, argv[i]);
  end_arguments(a);
  search.at_V = a->word[NUMBER_V] != NULL;
  if (!search.at_V && !(search.option[V_LEAST].value < a->V_top))
    fail(name, MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", search.option[V_LEAST].value, a->V_top);
  if (best) {
    print_best(&search);
    return output_status(name);
  }
  for (int k = B_LEAST; k <= B_MOST; k++)
    if (search.option[k].word)
      refuse(name, search.option[k].word, "goes with `mlg damping LAYOUT best`");
  for (int k = 0; k < search.ranges; k++)
    set_range(&search, k, search.range[k].from);
  if (!(a->par[NUMBER_V] > 0.))
    refuse(name, a->word[NUMBER_V], "the wheels have to roll: V above 0");
  for (int k = 0; k < search.ranges; k++)
    printf("%.*s,", (int)range_name_length(&search.range[k]), search.range[k].text);
  printf("zeta,%sfrequency_hz,shimmy,t_5\n", search.at_V ? "" : "V,");
  print_table(&search, 0);
  return output_status(name);
}

const struct command command_damping = {
  .name = name,
  .usage = "LAYOUT [best] [NAME=VALUE | NAME=FROM:TO:N ...] [V_least=0.3] [b_least=0 b_most=VALUE]",
  .summary = "least damping ratio of straight rolling, as a table or the best",
  .details =
    "zeta = -Re(s)/|s| is the least over all eigenvalues s, at V if that is given, otherwise\n"
    "the least over all V from V_least (0: the limit) to V_top, exactly.  N values stand in\n"
    "equal ratios, from FROM = 0 in equal steps.\n"
    "\n"
    "  mlg damping li1 b=140 k_s=6.38e5 c_d=6e3                   its least damping ratio\n"
    "  mlg damping li1 b=140 k_s=6.38e5 c_d=6e3 V=0.5:200:300     along V\n"
    "  mlg damping li1 b=140 k_s=3e5:1e6:100 c_d=1e3:2e4:100      over the plane (k_s, c_d)\n"
    "  mlg damping li1 best b=140 k_s=6.38e5                      the best c_d\n"
    "  mlg damping li1 best b=140                                 and k_s, from rigid to 1e-6 k_psi\n"
    "  mlg damping li1 best b_most=300                            and b, from 0 (b_least) to 300\n"
    "\n"
    "best: the c_d of the largest least zeta, exactly, and the k_s (unless it is given) and b\n"
    "(with b_most) by a grid, a climb from its best and golden section.  Zeta is what counts there, to\n"
    "1e-4 of it, on ridges that are nearly flat along b; two modes often\n"
    "share it; shown is that of delta if it is among them.\n"
    "\n"
    "Prints CSV: a column for each range, for best b, k_s and c_d as far as they were looked\n"
    "for; zeta; V m/s where that is, if V is no column; frequency_hz and shimmy (psi, delta)\n"
    "of that mode; t_5 s, in which it decays to 5 %, if it does.  A real root that grows has\n"
    "zeta = -1 and frequency 0.\n",
  .run = damping,
};
