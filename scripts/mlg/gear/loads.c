/* loads.c - zero-shimmy intervals and damping over the static load F_z */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "designs.h"
#include "golden.h"
#include "names.h"
#include "waiting.h"
#include "watch.h"

static const char name[] = "loads";

enum { FROM, TO, STEP, B_LEAST, B_MOST, V_LEAST, MOST_LOADS = 10000 };

struct job {
  struct arguments a;
  struct option option[7];
  bool over_b;
  struct libmlg_widest widest; /* of a search, and its b */
  double widest_b;
};

/* One row at the load, k_s and b of the arguments; `damped` where c_d is looked for. */
static void print_row(struct job *j, bool best_c_d)
{
  struct arguments *a = &j->a;
  struct libmlg_interval all[LIBMLG_MOST_POINTS], widest = { { .c_d = 0. }, { .c_d = 0. } };
  const int n = checked(name, libmlg_intervals(a->layout, a->par, 0., 0., a->V_top, all, LIBMLG_MOST_POINTS));
  struct libmlg_mode mode;
  struct libmlg_ratio best;

  for (int i = 0; i < n; i++)
    if (all[i].hi.c_d - all[i].lo.c_d > widest.hi.c_d - widest.lo.c_d)
      widest = all[i];
  if (best_c_d) {
    checked(name, libmlg_best_c_d(a->layout, a->par, j->option[V_LEAST].value, a->V_top, &best));
    a->par[NUMBER_C_D] = best.c_d;
  }
  hide_search();
  printf("%.10g,%.10g,%.10g,", libmlg_value(a->par, LIBMLG_F_Z), shown_k_s(a->par[NUMBER_K_S]), a->par[NUMBER_B]);
  if (n > 0)
    printf("%.10g,%.10g,%.8g,%.8g,", widest.lo.c_d, widest.hi.c_d, widest.hi.c_d - widest.lo.c_d, widest.hi.c_d / widest.lo.c_d);
  else
    printf(",,0,,");
  if (best_c_d)
    mode = shown_mode(a, a->par, j->option[V_LEAST].value, &best);
  else
    least_mode(a, a->par, j->option[V_LEAST].value, &mode);
  printf("%.10g,%.8g,%.6g,%s\n", a->par[NUMBER_C_D], mode.zeta, mode.V, shimmy_name(a->par, mode.delta_over_psi));
}

static void print_head(void)
{
  printf("# F_z N, k_s N m/rad, b N m s^2/rad; c_lo, c_hi, width, c_d N m s/rad; V m/s\n"
         "F_z,k_s,b,c_lo,c_hi,width,ratio,c_d,zeta,V,shimmy\n");
}

/* Width of the widest interval over k_s at b; the best so far is kept. */
static double width_at(double b, void *job)
{
  struct job *const j = job;
  struct arguments *a = &j->a;
  struct libmlg_widest w;

  a->par[NUMBER_B] = b;
  if (libmlg_widest(a->layout, a->par, 0., 0., a->V_top, &w) != 0)
    return 0.;
  if (w.width > j->widest.width) {
    j->widest = w;
    j->widest_b = b;
  }
  return w.width;
}

/* Over b as well: the best of 16, then golden section. */
static bool take_widest(struct job *j)
{
  enum { NODES = 15 };
  const double from = j->option[B_LEAST].value, to = j->option[B_MOST].value, node = (to - from) / NODES;

  j->widest = (struct libmlg_widest){ .width = 0. };
  if (!j->over_b)
    width_at(j->a.par[NUMBER_B], j);
  for (int i = 0; i <= NODES && j->over_b; i++) {
    watch_tell("width, grid over b", i, NODES + 1);
    width_at(from + i * node, j);
  }
  if (!(j->widest.width > 0.))
    return false;
  if (j->over_b && isfinite(j->widest.width)) {
    double b = j->widest_b;

    golden_largest(width_at, j, fmax(b - node, from), fmin(b + node, to), 1e-3 * node, &b, j->widest.width);
  }
  if (libmlg_uses(j->a.layout, NUMBER_K_S) == 1)
    j->a.par[NUMBER_K_S] = fmin(j->widest.k_s, MLG_RIGID);
  j->a.par[NUMBER_B] = j->widest_b;
  return true;
}

static bool take_damped(struct job *j)
{
  struct arguments *a = &j->a;
  const double b_least = j->over_b ? j->option[B_LEAST].value : a->par[NUMBER_B];
  const double b_most = j->over_b ? j->option[B_MOST].value : a->par[NUMBER_B];
  struct libmlg_ratio best;

  if (libmlg_best_damped(a->layout, a->par, b_least, b_most, j->option[V_LEAST].value, a->V_top, &best) != 0 || !(best.zeta > -1.))
    return false;
  a->par[NUMBER_K_S] = fmin(best.k_s, MLG_RIGID);
  a->par[NUMBER_B] = best.b;
  return true;
}

static int steps(const struct job *j)
{
  return (int)floor((j->option[TO].value - j->option[FROM].value) / j->option[STEP].value + 1e-9);
}

/* A design at each load: the one given, or its own best. */
static void print_loads(struct job *j, bool (*take)(struct job *j))
{
  const double b = j->a.par[NUMBER_B];

  print_head();
  for (int i = 0; i <= steps(j); i++) {
    libmlg_set(j->a.par, LIBMLG_F_Z, j->option[FROM].value + i * j->option[STEP].value);
    if (take) {
      j->a.par[NUMBER_B] = b;
      if (take(j))
        print_row(j, true);
      else
        printf("%.10g,,,,,0,,,,,\n", libmlg_value(j->a.par, LIBMLG_F_Z));
    } else
      print_row(j, false);
    fflush(stdout);
  }
}

static void take_over(struct job *j)
{
  struct arguments *a = &j->a;
  struct libmlg_ratio best;

  checked(name, libmlg_best_over_loads(a->layout, a->par, j->option[FROM].value, j->option[TO].value,
                                       j->over_b ? j->option[B_LEAST].value : a->par[NUMBER_B],
                                       j->over_b ? j->option[B_MOST].value : a->par[NUMBER_B], j->option[V_LEAST].value,
                                       a->V_top, &best));
  a->par[NUMBER_K_S] = fmin(best.k_s, MLG_RIGID);
  a->par[NUMBER_B] = best.b;
  a->par[NUMBER_C_D] = best.c_d;
}

static int print_largest(struct job *j)
{
  const double b = j->a.par[NUMBER_B];
  struct libmlg_load load;

  libmlg_largest_load(j->a.layout, j->a.par, j->option[TO].value, j->over_b ? j->option[B_LEAST].value : b,
                      j->over_b ? j->option[B_MOST].value : b, 0., j->a.V_top, &load);
  if (!(load.F_z > 0.))
    fail(name, MLG_FAILED, "no design has a zero-shimmy interval at any load looked at, up to F_z = %g N", j->option[TO].value);
  printf("# F_z N, k_s N m/rad, b N m s^2/rad, c_d N m s/rad%s\nF_z,k_s,b,c_d\n%.9g,%.10g,%.8g,%.8g\n",
         load.F_z >= j->option[TO].value ? "; the largest looked at has an interval" : "", load.F_z, shown_k_s(load.k_s), load.b,
         load.c_d);
  return output_status(name);
}

/* The M of an end of the axis is one that a gear may have; F_z itself is in the range of its option. */
static void check_load(const struct job *j, int end)
{
  double par[LIBMLG_MOST_PARAMETERS];

  memcpy(par, j->a.par, sizeof par);
  libmlg_set(par, LIBMLG_F_Z, j->option[end].value);
  if (!(par[NUMBER_M] >= libmlg_least(NUMBER_M) && par[NUMBER_M] <= libmlg_most(NUMBER_M)))
    fail(name, MLG_BAD_INPUT, "%s = %g N makes M = F_z/g - m_D = %g kg, outside its range, %g to %g kg", j->option[end].name,
         j->option[end].value, par[NUMBER_M], libmlg_least(NUMBER_M), libmlg_most(NUMBER_M));
}

static void check(struct job *j, bool searches, bool over_loads)
{
  const struct option *o = j->option;

  check_speeds(&j->a, o[V_LEAST].value);
  if (j->a.word[NUMBER_M] && j->a.word[NUMBER_M] != j->a.gear_word)
    refuse(name, j->a.word[NUMBER_M], "the load is the axis: from, to, step");
  if (j->a.F_z_word && j->a.F_z_word != j->a.gear_word)
    refuse(name, j->a.F_z_word, "the load is the axis: from, to, step");
  if (!(o[FROM].value < o[TO].value))
    fail(name, MLG_BAD_INPUT, "from = %g is not below to = %g N", o[FROM].value, o[TO].value);
  for (int end = FROM; end <= TO && over_loads; end++) /* `largest` looks at any */
    check_load(j, end);
  if (steps(j) >= MOST_LOADS)
    refuse(name, o[STEP].word ? o[STEP].word : o[TO].word, "more than %d loads", MOST_LOADS);
  if (!searches && (o[B_LEAST].word || o[B_MOST].word))
    refuse(name, o[B_MOST].word ? o[B_MOST].word : o[B_LEAST].word, "goes with a search: widest, damped, over or largest");
  if (!searches)
    return;
  refuse_given(&j->a, NUMBER_C_D, "the best c_d is looked for");
  refuse_given(&j->a, NUMBER_K_S, "the best k_s is looked for");
  if (o[B_LEAST].word && !o[B_MOST].word)
    refuse(name, o[B_LEAST].word, "goes with b_most=VALUE");
  if (o[B_MOST].word && !libmlg_uses(j->a.layout, NUMBER_B))
    refuse(name, o[B_MOST].word, "layout %s has no b", libmlg_layout_name(j->a.layout));
  if (o[B_MOST].word && j->a.word[NUMBER_B])
    refuse(name, j->a.word[NUMBER_B], "b_most says that b is looked for");
  if (o[B_MOST].word && !(o[B_LEAST].value < o[B_MOST].value))
    refuse(name, o[B_MOST].word, "not above b_least = %g", o[B_LEAST].value);
}

static int run(int argc, char *argv[])
{
  struct job j = { .option = { [FROM] = { "from", "N", 1., 1e9, 100e3, NULL },
                               [TO] = { "to", "N", 1., 1e9, 250e3, NULL },
                               [STEP] = { "step", "N", 1e-3, 1e9, 5e3, NULL },
                               [B_LEAST] = { "b_least", "N m s^2/rad", 0., 1e9, 0., NULL },
                               [B_MOST] = { "b_most", "N m s^2/rad", 0., 1e9, 0., NULL },
                               [V_LEAST] = { "V_least", "m/s", 1e-6, 1e3, 0.3, NULL } } };
  static const char *const searches[] = { "widest", "damped", "over", "largest" };
  enum { WIDEST, DAMPED, OVER, LARGEST, GIVEN };
  int search = GIVEN;

  for (int k = 0; k < GIVEN && argc > 2; k++)
    if (strcmp(argv[2], searches[k]) == 0)
      search = k;
  begin_arguments(&j.a, argc, argv, j.option);
  for (int i = 2 + (search != GIVEN); i < argc; i++)
    take_word(&j.a, argv[i]);
  end_arguments(&j.a);
  if (search == LARGEST && !j.option[TO].word)
    j.option[TO].value = 400e3;
  check(&j, search != GIVEN, search != LARGEST);
  show_searches();
  j.over_b = j.option[B_MOST].word != NULL;
  if (search == LARGEST)
    return print_largest(&j);
  if (search == OVER)
    take_over(&j);
  if (search == GIVEN && !j.a.word[NUMBER_C_D]) {
    struct libmlg_interval interval;

    if (!take_interval(&j.a, j.option[V_LEAST].value, &interval))
      fail(name, MLG_FAILED, "there is no zero-shimmy interval at the gear's own load in whose middle c_d could be; give c_d");
  }
  print_loads(&j, search == WIDEST ? take_widest : search == DAMPED ? take_damped : NULL);
  return output_status(name);
}

const struct command command_loads = {
  .name = name,
  .usage = "LAYOUT [widest | damped | over | largest] [NAME=VALUE ...] [OPTION=VALUE ...]",
  .summary = "zero-shimmy intervals and damping over the static load F_z",
  .details =
    "F_z = (M + m_D) g enters through M, 0 at least; m_D stays.  A row for each load from `from` to `to`:\n"
    "  mlg loads l2 k_s=7.86e5            the device given; without c_d the middle of its widest\n"
    "                                     interval at the gear's own load\n"
    "  mlg loads li1 widest b=140         at each load the k_s of the widest interval\n"
    "  mlg loads li1 damped b_most=300    at each load the best damped k_s and b\n"
    "  mlg loads li2 over b=140 from=1.8e5 to=2.1e5\n"
    "                                     the one device whose least damping ratio over these loads\n"
    "                                     is largest\n"
    "  mlg loads li2 largest b_most=300   one row: the largest load, up to `to` (4e5), at which any\n"
    "                                     device has a zero-shimmy interval, above the last of 12 in\n"
    "                                     equal steps with one\n"
    "OPTION: from=1e5, to=2.5e5, step=5e3, V_least=0.3; with b_most (b_least=0) b is looked for as\n"
    "well (libmlg.h says how).  CSV:\n"
    "  F_z, k_s, b                N, N m/rad (inf: rigid), N m s^2/rad\n"
    "  c_lo, c_hi, width, ratio   the widest zero-shimmy interval, N m s/rad, c_hi/c_lo; empty and 0:\n"
    "                             none\n"
    "  c_d                        given; with widest and damped the best damped one\n"
    "  zeta, V, shimmy            least damping ratio over V_least < V < V_top at that c_d, below 0\n"
    "                             where there is shimmy (-1: a real root), its speed m/s and mode\n",
  .run = run,
};
