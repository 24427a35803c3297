/* explore.c - the best designs of a layout or network (explorer.h) */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "explorer.h"

enum quantity { ZETA, WIDTH, RATIO, LOAD, TOLERANCE, QUANTITIES };

static const char *const quantity_name[QUANTITIES] = { "zeta", "width", "ratio", "load", "tolerance" };

/* Static stiffness of the device that was found, without k_psi, N m/rad. */
static double static_stiffness(const struct explorer *e, const struct found *f)
{
  const struct libmlg_layout *const l = libmlg_find(e->layout);
  double par[LIBMLG_MOST_PARAMETERS], slots[MLG_SLOTS];

  memcpy(par, e->par, sizeof par);
  par[NUMBER_K_S] = f->k_s;
  for (int i = 0; i < e->others; i++)
    e->other[i]->value = f->other[i];
  libmlg_slots(par, slots);
  const struct network Z = l->network(l, slots);
  const double K = Z.num.coefficient[0] / Z.den.coefficient[0];

  return K / (1. - K / par[NUMBER_K_PSI]);
}

/* The row of what was found, its value in units of `unit`; none where nothing was. */
static void print_row(enum quantity q, const struct explorer *e, const struct found *f, double unit)
{
  if ((q == ZETA || q == WIDTH || q == RATIO) ? !(f->value > -INFINITY) : !(f->value > 0.))
    return;
  printf("%s,%.10g,%.10g,%.10g,", quantity_name[q], f->value / unit, e->has_k_s ? f->k_s : INFINITY, e->has_b ? f->b : 0.);
  printf("%.10g,%.10g,%d,%d,%d", f->lo, f->hi, f->met, f->starts, f->asked);
  for (int i = 0; i < e->others; i++)
    printf(",%.10g", f->other[i]);
  printf(",%.10g\n", static_stiffness(e, f));
  fflush(stdout);
}

/* Takes leading words that are quantities; returns how many. */
static int take_quantities(int argc, char *argv[], bool asked[QUANTITIES])
{
  int n = 0;

  for (bool taken = true; taken && n + 2 < argc; n += taken) {
    taken = false;
    for (int q = 0; q < QUANTITIES; q++)
      if (strcmp(argv[n + 2], quantity_name[q]) == 0) {
        if (asked[q])
          refuse(argv[0], argv[n + 2], "given already");
        taken = asked[q] = true;
      }
  }
  for (int q = 0; q < QUANTITIES && n == 0; q++)
    asked[q] = true;
  return n;
}

/* What stands behind NAME in a word, or NULL: it does not begin so. */
static const char *behind(const char *word, const char *name)
{
  return strncmp(word, name, strlen(name)) == 0 ? word + strlen(name) : NULL;
}

/* free=NAME: that element of the network is searched too. */
static void take_free(struct explorer *e, int argc, char *argv[], int first)
{
  for (int i = first; i < argc; i++) {
    const char *const name = behind(argv[i], "free="), *wrong;

    if (!name)
      continue;
    for (int k = first; k < i; k++)
      if (strcmp(argv[k], argv[i]) == 0)
        refuse(argv[0], argv[i], "given already");
    wrong = explore_free(e, name);
    if (wrong)
      refuse(argv[0], argv[i], "%s", wrong);
  }
}

static void explore(enum quantity q, struct explorer *e, int starts, struct found *found)
{
  switch (q) {
  case ZETA: explore_zeta(e, starts, found); break;
  case WIDTH:
  case RATIO: explore_interval(e, q == RATIO, starts, found); break;
  case LOAD: explore_load(e, starts, found); break;
  default: explore_tolerance(e, starts, found);
  }
}

/* What was found is where the next searches begin as well. */
static void give(struct explorer *e, const struct found *found)
{
  double x[EXPLORE_VARIABLES];

  explore_place(e, found->k_s, found->b, explore_middle(found->lo, found->hi), x);
  explore_give(e, x);
}

static int run(int argc, char *argv[])
{
  enum { B_MOST, STARTS, V_LEAST };
  struct option option[] = {
    [B_MOST] = { "b_most", "N m s^2/rad", 0., 1e9, 300., NULL },
    [STARTS] = { "starts", "", 1., EXPLORE_STARTS - EXPLORE_GIVEN, 12., NULL },
    [V_LEAST] = { "V_least", "m/s", 0., 1e3, 0.3, NULL },
    { .name = NULL },
  };
  bool asked[QUANTITIES] = { false };
  const char *begin = NULL;
  double given[EXPLORE_VARIABLES];
  struct explorer e;
  struct arguments a;

  begin_arguments(&a, argc, argv, option);
  const int first = 2 + take_quantities(argc, argv, asked);

  for (int i = first; i < argc; i++)
    if (behind(argv[i], "begin=")) {
      if (begin)
        refuse(argv[0], argv[i], "given already");
      begin = argv[i];
    } else if (!behind(argv[i], "free="))
      take_word(&a, argv[i]);
  end_arguments(&a);
  refuse_given(&a, NUMBER_V, "the search is over all speeds");
  const char *const load = a.F_z_word ? a.F_z_word : a.word[NUMBER_M];

  if (first > 2 && asked[LOAD] && load && load != a.gear_word)
    refuse(argv[0], load, "the search for the largest load is over all loads");
  if (!a.word[NUMBER_C_D]) {
    refuse_given(&a, NUMBER_K_S, "all k_s are searched; to begin at a design give its c_d as well");
    refuse_given(&a, NUMBER_B, "all b up to b_most are searched; to begin at a design give its c_d as well");
  }
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  if (a.word[NUMBER_B] && a.par[NUMBER_B] > option[B_MOST].value)
    refuse(argv[0], a.word[NUMBER_B], "above b_most = %g, up to which b is searched", option[B_MOST].value);
  explore_begin(&e, a.layout, a.par, option[B_MOST].value, option[V_LEAST].value, a.V_top);
  take_free(&e, argc, argv, first);
  if (a.word[NUMBER_C_D]) {
    explore_place(&e, a.par[NUMBER_K_S], a.par[NUMBER_B], a.par[NUMBER_C_D], given);
    explore_give(&e, given);
  }
  if (begin)
    explore_begin_at(&e, begin);
  printf("# zeta -, width N m s/rad, ratio -, load N, tolerance %%; k_s, static N m/rad, b N m s^2/rad, c_lo, c_hi N m s/rad\n"
         "quantity,value,k_s,b,c_lo,c_hi,met,starts,asked");
  for (int i = 0; i < e.others; i++)
    printf(",%.*s", (int)strcspn(e.other[i]->text, "="), e.other[i]->text);
  printf(",static\n");

  /* an exact interval is where damping is looked for as well, and with free elements the other way round */
  static const enum quantity order[2][QUANTITIES] = { { WIDTH, RATIO, ZETA, LOAD, TOLERANCE }, { ZETA, WIDTH, RATIO, LOAD, TOLERANCE } };
  double damping = -INFINITY;

  for (int i = 0; i < QUANTITIES; i++) {
    const enum quantity q = order[e.others > 0][i];
    struct found found;

    if (!asked[q] || (q != ZETA && e.others > 0 && asked[ZETA] && !(damping > 0.))) /* no design without shimmy */
      continue;
    explore(q, &e, (int)option[STARTS].value, &found);
    print_row(q, &e, &found, q == TOLERANCE ? 1e-2 : 1.);
    if (q == ZETA || (e.others == 0 && found.value > 0.)) /* where the others begin as well */
      give(&e, &found);
    if (q == ZETA)
      damping = found.value;
  }
  return output_status(argv[0]);
}

const struct command command_explore = {
  .name = "explore",
  .usage = "LAYOUT [QUANTITY ...] [NAME=VALUE ...] [free=NAME] [begin=FILE] [b_most=300] [starts=12]",
  .summary = "the best designs of a layout or network, by repeated starts",
  .details =
    "QUANTITY: zeta, width, ratio, load (over all F_z), tolerance; all of them without.  k_s from 1e4\n"
    "(from k_d, where k_s alone carries a static torque) to 1e9 N m/rad, b from 0 to b_most and c_d\n"
    "from 10 to 1e7 N m s/rad: climbs by the slopes of the modes, or of the corners, that limit a design\n"
    "(models/libmlg/climb.h) from random places, each at its best c_d, and from the designs that were\n"
    "best before; intervals exactly over k_s, by golden section over b.  free=c_2 searches the element\n"
    "c_2=300 of a network as well, springs, dampers and inerters in the same ranges; then intervals by\n"
    "an evolution strategy (models/libmlg/cma.h), and nothing but zeta where no design is\n"
    "damped.  A tolerance is that of such an element, too.  With c_d, and k_s and b, the search begins\n"
    "at that design as well, with begin=FILE at\n"
    "each row of a table with the columns that this command prints.\n"
    "CSV, a row for each, none where there is no interval:\n"
    "  zeta          the largest least damping ratio over V_least=0.3 < V < V_top\n"
    "  width, ratio  of the widest zero-shimmy interval c_lo to c_hi: c_hi - c_lo, c_hi/c_lo\n"
    "  load          the largest static load F_z, N, with a design without shimmy\n"
    "  tolerance     the largest p of `mlg help tolerance`, per cent, all corners tested\n"
    "  k_s, b, c_lo, c_hi  the design; of zeta, load and tolerance c_lo = c_hi = c_d\n"
    "  met, starts   how many of the starts, random or given, came within 1 % of the best, of a load\n"
    "                within 0.1 %; of an interval, starts are six stretches of b that overlap, or with\n"
    "                free=NAME as said\n"
    "  asked         how many designs were looked at; of width and ratio how many b, each with all k_s\n"
    "  c_2, ...      the values of the elements that are free\n"
    "  static        stiffness of the device, without k_psi\n",
  .run = run,
};
