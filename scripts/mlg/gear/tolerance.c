/* tolerance.c - within which tolerance of all its parameters a design is free of shimmy */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "box.h"
#include "command.h"
#include "designs.h"
#include "device_text.h"
#include "names.h"
#include "waiting.h"

static const char name[] = "tolerance";

enum { B_LEAST, B_MOST, V_LEAST, SAMPLE, MOST_NODES = 400 };

/* "F_z+ k_t- ...": the parameters and elements at their upper and lower ends. */
static void print_corner(const struct box_at *d, unsigned corner)
{
  for (int i = 0; i < box_sides(d); i++) {
    const char *const text = i < d->box->n ? quantity_name(d->box->parameter[i]) : d->element[i - d->box->n]->text;

    printf("%s%.*s%c", i ? " " : "", (int)strcspn(text, "="), text, corner >> i & 1u ? '+' : '-');
  }
}

/* Element i = 1, 2, ... of the van der Corput sequence of a prime base, in 0 to 1. */
static double halton(int i, int base)
{
  double value = 0., digit = 1.;

  for (; i > 0; i /= base)
    value += (i % base) * (digit /= base);
  return value;
}

/* How many of the first n points of a Halton sequence in the box of size p shimmy. */
static int failing(const struct box_at *d, double p, int n)
{
  static const int prime[LIBMLG_MOST_SIDES] = { 2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61 };
  int count = 0;

  for (int i = 1; i <= n; i++) {
    double par[LIBMLG_MOST_PARAMETERS], part[LIBMLG_MOST_SIDES], own[BOX_ELEMENTS];

    for (int k = 0; k < box_sides(d); k++)
      part[k] = p * (2. * halton(i, prime[k]) - 1.);
    box_to(d, part, par, own);
    count += libmlg_is_free(d->layout, par, 0., d->V_least, d->V_top) != 1;
    box_back(d, own);
  }
  return count;
}

/* vary=NAME: that element NAME=VALUE of the network varies as well. */
static void take_element(struct box_at *d, const char *word)
{
  const char *wrong = "too many elements vary";
  struct part *const element = d->elements < BOX_ELEMENTS ? device_element(d->layout, strchr(word, '=') + 1, &wrong) : NULL;

  for (int i = 0; i < d->elements; i++)
    if (d->element[i] == element)
      refuse(name, word, "given already");
  if (!element)
    refuse(name, word, "%s", wrong);
  d->element[d->elements++] = element;
}

/* The row of the design d in the arguments. */
static void print_design(const struct arguments *a, struct box_at d, double V_least, int sample)
{
  struct libmlg_box box;
  struct libmlg_tolerance t;
  struct libmlg_mode mode;
  double part[LIBMLG_MOST_SIDES], beyond[LIBMLG_MOST_PARAMETERS], own[BOX_ELEMENTS];

  hide_search();
  libmlg_box_of(a->layout, a->par, &box);
  d.box = &box;
  checked(name, box_tolerance(&d, &t));
  printf("# k_s N m/rad, b N m s^2/rad, c_d N m s/rad; p %%; V m/s\nk_s,b,c_d,p,V,shimmy,corner,corners,sample,failing\n");
  printf("%.10g,%.10g,%.10g,%.8g,", shown_k_s(a->par[NUMBER_K_S]), a->par[NUMBER_B], a->par[NUMBER_C_D], 100. * t.p);
  if (t.p > 0. && !t.bounded)
    printf(",,,");
  else { /* what shimmies a little beyond, or at the design itself */
    box_corner(&d, t.corner, t.p > 0. ? t.p * (1. + 1e-4) : 0., part);
    box_to(&d, part, beyond, own);
    least_mode(a, beyond, V_least, &mode);
    box_back(&d, own);
    printf("%.6g,%s,", mode.V, shimmy_name(beyond, mode.delta_over_psi));
    if (t.p > 0.)
      print_corner(&d, t.corner);
    printf(",");
  }
  printf("%u,%d,%d\n", 1u << box_sides(&d), sample, failing(&d, t.p * (1. - 1e-9), sample));
}

static void take_best(struct arguments *a, double b_least, double b_most)
{
  struct libmlg_design best;

  show_searches();
  checked(name, libmlg_most_tolerant(a->layout, a->par, b_least, b_most, 0., a->V_top, &best));
  if (!(best.p > 0.))
    fail(name, MLG_FAILED, "no design has a zero-shimmy interval");
  a->par[NUMBER_K_S] = fmin(best.k_s, MLG_RIGID);
  a->par[NUMBER_B] = best.b;
  a->par[NUMBER_C_D] = best.c_d;
}

/* --- the map over k_s and b ---------------------------------------------------------------------- */

/* NAME=FROM:TO:N into the range it is of. */
static void take_axis(struct arguments *a, const char *word, struct range *k_s, struct range *b)
{
  const struct range r = take_range(a, word);

  if (r.n > MOST_NODES)
    refuse(name, word, "more than %d values", MOST_NODES);
  if (a->word[NUMBER_K_S] == word)
    *k_s = r;
  else if (a->word[NUMBER_B] == word)
    *b = r;
  else
    refuse(name, word, "expected k_s=FROM:TO:N or b=FROM:TO:N: a map is over these");
  retake_value(a, word, range_name_length(&r), r.from); /* is it in the range of its name as well? */
  retake_value(a, word, range_name_length(&r), r.to);
}

static int map(int argc, char *argv[])
{
  struct option option[] = { { .name = NULL } };
  struct range k_s = { .text = NULL }, b = { .text = NULL };
  struct arguments a;

  begin_arguments(&a, argc, argv, option);
  for (int i = 3; i < argc; i++)
    if (strchr(argv[i], ':'))
      take_axis(&a, argv[i], &k_s, &b);
    else
      take_word(&a, argv[i]);
  end_arguments(&a);
  check_speeds(&a, 0.);
  refuse_given(&a, NUMBER_C_D, "the best c_d is looked for");
  if (!libmlg_uses(a.layout, NUMBER_K_S))
    refuse(name, argv[1], "has no k_s to map");
  if (!k_s.text)
    fail(name, MLG_BAD_INPUT, "expected k_s=FROM:TO:N");
  if (!b.text)
    b = (struct range){ .from = a.par[NUMBER_B], .to = a.par[NUMBER_B], .n = 1 };

  const int nodes = k_s.n * b.n;
  struct libmlg_design *const node = malloc((size_t)nodes * sizeof *node);

  if (!node)
    fail(name, MLG_FAILED, "out of memory");
  for (int j = 0; j < b.n; j++)
    for (int i = 0; i < k_s.n; i++)
      node[j * k_s.n + i] = (struct libmlg_design){ .k_s = k_s.from * pow(k_s.to / k_s.from, (double)i / (k_s.n - 1)),
                                                    .b = b.from + (b.n > 1 ? (b.to - b.from) * j / (b.n - 1) : 0.) };

  show_searches();
  checked(name, libmlg_tolerance_map(a.layout, a.par, node, nodes, 0., a.V_top));
  hide_search();
  printf("# k_s N m/rad, b N m s^2/rad, c_d N m s/rad; p %%\nk_s,b,c_d,p\n");
  for (int i = 0; i < nodes; i++)
    printf("%.8g,%.8g,%.8g,%.6g\n", node[i].k_s, node[i].b, node[i].c_d, 100. * node[i].p);
  free(node);
  return output_status(name);
}

static int run(int argc, char *argv[])
{
  struct option option[] = { [B_LEAST] = { "b_least", "N m s^2/rad", 0., 1e9, 0., NULL },
                             [B_MOST] = { "b_most", "N m s^2/rad", 0., 1e9, 0., NULL },
                             [V_LEAST] = { "V_least", "m/s", 1e-6, 1e3, 0.3, NULL },
                             [SAMPLE] = { "sample", "", 0., 1e7, 10000., NULL },
                             { .name = NULL } };
  const bool best = argc > 2 && strcmp(argv[2], "best") == 0;
  struct libmlg_interval interval;
  struct arguments a;

  if (argc > 2 && strcmp(argv[2], "map") == 0)
    return map(argc, argv);
  begin_arguments(&a, argc, argv, option);
  struct box_at d = { .layout = a.layout, .par = a.par };

  for (int i = 2 + best; i < argc; i++)
    if (strncmp(argv[i], "vary=", 5) != 0)
      take_word(&a, argv[i]);
    else if (best)
      refuse(name, argv[i], "goes with a design; `mlg explore` searches with free=NAME");
    else
      take_element(&d, argv[i]);
  end_arguments(&a);
  d.V_top = a.V_top;
  check_speeds(&a, option[V_LEAST].value);
  for (int k = B_LEAST; k <= B_MOST && !best; k++)
    if (option[k].word)
      refuse(name, option[k].word, "goes with `mlg tolerance LAYOUT best`");
  if (best) {
    refuse_given(&a, NUMBER_C_D, "the best c_d is looked for");
    refuse_given(&a, NUMBER_K_S, "the best k_s is looked for");
    if (option[B_MOST].word && !libmlg_uses(a.layout, NUMBER_B))
      refuse(name, option[B_MOST].word, "layout %s has no b", libmlg_layout_name(a.layout));
    if (option[B_MOST].word && a.word[NUMBER_B])
      refuse(name, a.word[NUMBER_B], "b_most says that b is looked for");
    if (option[B_LEAST].word && !option[B_MOST].word)
      refuse(name, option[B_LEAST].word, "goes with b_most=VALUE");
    if (option[B_MOST].word && !(option[B_LEAST].value < option[B_MOST].value))
      refuse(name, option[B_MOST].word, "not above b_least = %g", option[B_LEAST].value);
    take_best(&a, option[B_MOST].word ? option[B_LEAST].value : a.par[NUMBER_B],
              option[B_MOST].word ? option[B_MOST].value : a.par[NUMBER_B]);
  } else if (!take_interval(&a, option[V_LEAST].value, &interval) && !a.word[NUMBER_C_D])
    fail(name, MLG_FAILED, "there is no zero-shimmy interval in whose middle c_d could be; give c_d");
  print_design(&a, d, option[V_LEAST].value, (int)option[SAMPLE].value);
  return output_status(name);
}

const struct command command_tolerance = {
  .name = name,
  .usage = "LAYOUT [best | map] [NAME=VALUE ...] [b_least=0 b_most=B] [vary=NAME] [sample=10000]",
  .summary = "the tolerance of all parameters within which a design is free of shimmy",
  .details =
    "p: F_z, k_t, e, l, h, k_lambda, k_alpha, c_delta, c_psi, k_delta, k_psi, c_d and, where the\n"
    "device has them, k_s and b may all lie anywhere within +-p % at once, and no corner of that box\n"
    "shimmies at any V up to V_top; every corner is tested exactly, at p, 3/4, 1/2 and 1/4 of it.\n"
    "The largest p that is looked at is 90 %.\n"
    "  mlg tolerance l2 k_s=7.86e5 c_d=8e3          of this design; without c_d the middle of the\n"
    "                                               widest interval\n"
    "  mlg tolerance li2 best b=140                 the k_s and c_d of the largest p\n"
    "  mlg tolerance li2 best b_most=300            and b: at each b the best k_s from the beginning\n"
    "  mlg tolerance li2 map k_s=3e5:4e6:40 b=0:300:21\n"
    "                                               p at the c_d of the largest p over k_s and b\n"
    "\n"
    "CSV: k_s N m/rad (inf: rigid), b N m s^2/rad, c_d N m s/rad, p in per cent, 0 where the design\n"
    "itself shimmies;\n"
    "  V, shimmy         m/s, and psi or delta: what grows a hair beyond p\n"
    "  corner, corners   the first that shimmies, + and - of each parameter; how many there are\n"
    "  sample, failing   points of a Halton sequence in the box of size p, and how many of them\n"
    "                    shimmy: corners are no proof for what lies between them\n"
    "With a network vary=c_2 says that its element c_2=VALUE lies within +-p % as well.\n"
    "A map has p at each node from all corners, at p alone and not at parts of it.\n",
  .run = run,
};
