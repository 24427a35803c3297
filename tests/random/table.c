/* table.c - the oracle's answers as a table, and the oracle against brute force
 *
 *   random-oracle table [N] [OPTION ...]   zero-shimmy intervals of N random gears, as CSV
 *   random-oracle units [N] [OPTION ...]   the paper's gear in N other units of force, time and
 *                                          length: its intervals in those units
 *   random-oracle brute [N] [OPTION ...]   the oracle against samples of c_d and V alone
 *   random-oracle gear  LAYOUT NAME=VALUE ...  the paper's gear but for these, as the table
 *   random-oracle growth LAYOUT C_D NAME=VALUE ...  its largest real part there over V, 1/s
 *
 * OPTION: seed=S (1), case=K alone or first=K, spread=S (parameters times 2^(-S..S); 1),
 * layout=NAME (all).
 *
 * Columns: case; layout; the gear's parameters as in docs/model.md, SI (k_s, k_d, k_psi, k_delta
 * N m/rad; b N m s^2/rad; c_psi, c_delta N m s/rad; lengths and k_alpha m; masses kg; J kg m^2;
 * phi rad; k_t N/m; k_lambda 1/rad; g m/s^2; V_top m/s); verdict: interval, none, divergence;
 * number, of: which interval of how many; c_lo, c_hi N m s/rad; V_lo, V_hi m/s: where shimmy
 * sets in; error_lo, error_hi: relative, estimated; end_lo, end_hi: fold, V=0, V_top, open;
 * unresolved: places the oracle cannot decide.  Bad input: one line, status 2; brute has
 * status 1 where the two differ.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gears.h"

static void print_head(void)
{
  printf("case,layout,");
  print_gear_names();
  printf(",verdict,number,of,c_lo,c_hi,V_lo,V_hi,error_lo,error_hi,end_lo,end_hi,unresolved\n");
}

static void print_answer(const char *name, int layout, const struct oracle_gear *gear)
{
  const struct oracle_answer answer = oracle_intervals((enum oracle_layout)layout, gear);

  for (int i = 0; i < answer.intervals || i == 0; i++) {
    printf("%s,%s,", name, oracle_layout_name[layout]);
    print_gear(gear);
    if (answer.intervals == 0) {
      printf(",%s,,0,,,,,,,,,%d\n", answer.divergence ? "divergence" : "none", answer.unresolved);
      continue;
    }
    const struct oracle_interval *v = &answer.interval[i];

    printf(",interval,%d,%d,%.13g,%.13g,%.9g,%.9g,%.1e,%.1e,%s,%s,%d\n", i + 1, answer.intervals, v->c[0], v->c[1],
           v->V[0], v->V[1], v->error[0], v->error[1], oracle_end_name[v->end[0]], oracle_end_name[v->end[1]],
           answer.unresolved);
  }
}

static int table(const struct options *o)
{
  print_head();
  for (int k = o->first; k < o->first + o->cases; k++) {
    const struct oracle_gear gear = random_gear(o->seed, k, o->spread);
    char name[16];

    snprintf(name, sizeof name, "%d", k);
    for (int layout = 0; layout < ORACLE_LAYOUTS; layout++)
      if (o->layout < 0 || o->layout == layout)
        print_answer(name, layout, &gear);
  }
  return 0;
}

static int units(const struct options *o)
{
  static const struct { enum oracle_layout layout; double k_s, b; } paper[] = {
    { ORACLE_L1, 0., 0. }, { ORACLE_L2, 7.86e5, 0. }, { ORACLE_LI1, 6.38e5, 140. }, { ORACLE_LI2, 1.1e6, 80. }
  };
  double worst = 0.;
  int bad = 0;

  for (int k = o->first; k < o->first + o->cases; k++)
    for (int i = 0; i < 4; i++) {
      double c_unit;
      const struct oracle_gear gear = gear_in_units(o->seed, k, paper[i].k_s, paper[i].b, &c_unit);
      struct oracle_gear plain = oracle_paper();

      plain.k_s = paper[i].k_s > 0. ? paper[i].k_s : INFINITY;
      plain.b = paper[i].b;

      const struct oracle_answer want = oracle_intervals(paper[i].layout, &plain);
      const struct oracle_answer got = oracle_intervals(paper[i].layout, &gear);

      bad += got.intervals != want.intervals;
      for (int j = 0; j < got.intervals && j < want.intervals; j++)
        for (int side = 0; side < 2; side++)
          if (want.interval[j].c[side] > 0. && want.interval[j].c[side] < INFINITY)
            worst = fmax(worst, fabs(got.interval[j].c[side] / c_unit / want.interval[j].c[side] - 1.));
    }
  printf("%d cases, %d with another number of intervals, largest relative difference %.1e\n", 4 * o->cases, bad, worst);
  return bad > 0 || worst > 1e-10;
}

/* Samples of c_d and V against the oracle's intervals. */
static int brute(const struct options *o)
{
  enum { STEPS = 500, SPEEDS = 300, FINE = 20000 };
  int samples = 0, wrong = 0, fine = 0, ends = 0;

  for (int k = o->first; k < o->first + o->cases; k++)
    for (int layout = 0; layout < ORACLE_LAYOUTS; layout++) {
      if (o->layout >= 0 && o->layout != layout)
        continue;
      const struct oracle_gear gear = random_gear(o->seed, k, o->spread);
      const enum oracle_layout of = (enum oracle_layout)layout;
      const struct oracle_answer answer = oracle_intervals(of, &gear);

      for (int i = 0; i <= STEPS + 4 * answer.intervals; i++) {
        double c = exp(log(1.) + log(1e8) * i / STEPS), V;
        bool inside = false, at_end = false;

        if (i > STEPS) { /* just inside and just outside an end */
          const struct oracle_interval *v = &answer.interval[(i - STEPS - 1) / 4];
          const int side = (i - STEPS - 1) / 2 % 2;

          if (v->end[side] == ORACLE_OPEN)
            continue;
          c = v->c[side] * ((i - STEPS - 1) % 2 ? 1. - 1e-5 : 1. + 1e-5);
          at_end = true;
        }
        for (int j = 0; j < answer.intervals; j++) {
          inside |= c > answer.interval[j].c[0] && c < answer.interval[j].c[1];
        }
        samples++;
        ends += at_end;
        if ((oracle_growth(of, &gear, c, SPEEDS, &V) < 0.) == inside)
          continue;
        fine++;
        if (!inside && (oracle_growth(of, &gear, c, FINE, &V) < 0.) == inside)
          continue;
        wrong++;
        printf("case=%d layout=%s c_d=%.12g: the oracle says %s, the samples %.6g /s at V = %.9g\n", k,
               oracle_layout_name[layout], c, inside ? "no shimmy" : answer.divergence ? "divergence" : "shimmy",
               oracle_growth(of, &gear, c, FINE, &V), V);
      }
      fprintf(stderr, "\rcase %d %s: %d samples, %d looked at closer, %d differ  ", k, oracle_layout_name[layout],
              samples, fine, wrong);
    }
  fprintf(stderr, "\n");
  printf("%d samples of c_d, %d of them beside an end, %d looked at closer, %d differ\n", samples, ends, fine, wrong);
  return wrong > 0;
}

static int usage(void)
{
  fprintf(stderr, "random-oracle: expected table, units or brute [N] [seed=S] [case=K] [first=K] [spread=S] [layout=NAME],"
                  " gear LAYOUT NAME=VALUE ... or growth LAYOUT C_D NAME=VALUE ...\n");
  return 2;
}

/* The paper's gear with NAME=VALUE changed. */
static struct oracle_gear changed(int n, char **argument)
{
  struct oracle_gear gear = oracle_paper();

  for (int i = 0; i < n; i++) {
    const char *equals = strchr(argument[i], '=');
    double *into = NULL;
    char *end = NULL;

    if (equals != NULL) {
      const size_t length = (size_t)(equals - argument[i]);

      for (int j = 0; j < ORACLE_PARAMETER_COUNT; j++)
        if (strlen(oracle_name[j]) == length && memcmp(oracle_name[j], argument[i], length) == 0)
          into = oracle_at(&gear, j);
      if (length == 5 && memcmp(argument[i], "V_top", 5) == 0)
        into = &gear.V_top;
    }
    if (into != NULL)
      *into = strtod(equals + 1, &end);
    if (into == NULL || end == equals + 1 || *end != '\0' || isnan(*into)) {
      fprintf(stderr, "random: %s: expected NAME=VALUE, a parameter of the gear or V_top\n", argument[i]);
      exit(2);
    }
    const bool any = into == &gear.e || into == &gear.phi;
    const bool not_below_0 = into == &gear.b || into == &gear.c_psi || into == &gear.c_delta || into == &gear.k_alpha
                             || into == &gear.k_lambda || into == &gear.M;

    if ((!any && !(*into > 0. || (not_below_0 && !(*into < 0.)))) || (isinf(*into) && into != &gear.k_s)) {
      fprintf(stderr, "random: %s: expected a value %s\n", argument[i],
              any ? "that is finite" : not_below_0 ? "from 0, finite" : "above 0, finite (k_s=inf: rigid)");
      exit(2);
    }
  }
  return gear;
}

int main(int argc, char **argv)
{
  const char *command = argc > 1 ? argv[1] : "";

  if (strcmp(command, "gear") == 0 && argc > 2) {
    const int layout = read_layout(argv[2], argv[2]);
    const struct oracle_gear gear = changed(argc - 3, argv + 3);

    print_head();
    print_answer("-", layout, &gear);
    return 0;
  }
  if (strcmp(command, "growth") == 0 && argc > 3) {
    const struct oracle_gear gear = changed(argc - 4, argv + 4);
    const double c_d = strtod(argv[3], NULL);
    double V;

    if (!(c_d > 0.)) {
      fprintf(stderr, "random: %s: expected c_d above 0\n", argv[3]);
      return 2;
    }
    const double growth = oracle_growth((enum oracle_layout)read_layout(argv[2], argv[2]), &gear, c_d, 20000, &V);

    printf("%.9g 1/s at V = %.9g m/s\n", growth, V);
    return 0;
  }
  if (strcmp(command, "table") != 0 && strcmp(command, "units") != 0 && strcmp(command, "brute") != 0)
    return usage();

  const struct options o = read_options(argc - 2, argv + 2, strcmp(command, "brute") == 0 ? 20 : 100);

  return command[0] == 't' ? table(&o) : command[0] == 'u' ? units(&o) : brute(&o);
}
