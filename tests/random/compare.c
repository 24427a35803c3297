/* compare.c - the library's zero-shimmy intervals against the oracle's
 *
 *   random-compare [N] [OPTION ...]        N random gears (2000) times all layouts
 *   random-compare units [N] [OPTION ...]  the paper's gear in N (100) other units of force, time
 *                                          and length, against its intervals in SI
 *   random-compare hard FILE               the gears of a table (tests/random/hard.csv): oracle
 *                                          and library against the values written there
 *
 * OPTION: seed=S (1), case=K alone or first=K, spread=S (1), layout=NAME (all), doubts=BITS
 * (0; gears.h, random_doubts()).
 *
 * The two are compared as sets of c_d.  Where one says shimmy and the other none, the place is
 * looked at once more, by the oracle on a finer grid and by samples of V alone, and judged:
 *   missed     the library lacks an interval, or a part of one
 *   invented   it claims one, or a part of one, with shimmy inside
 *   oracle     the oracle was wrong, the library right
 *   undecided  neither can be shown
 *   refused    the library returns an error
 * Ends that differ by less than 1e-8 relative agree.  Not judged but counted apart, as
 * ill-conditioned: ends that the rounding of the matrix's entries moves by more than 1e-9, and
 * intervals or gaps narrower than 1e-6 relative.
 *
 * Status: 0 all agree, 1 a difference that is not ill-conditioned, 2 wrong use.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "gears.h"
#include "libmlg.h"

static const double agree = 1e-8;       /* relative difference of ends */
static const double uncertain = 1e-9;   /* relative error of an end that makes it ill-conditioned */
static const double thin = 1e-6;        /* relative width of an interval or gap, likewise */

struct count {
  int answers, intervals, ends, at_0, at_top, open, divergence;
  int missed, invented, oracle, undecided, refused, ill, unresolved;
  double worst;        /* largest relative difference of ends that agree */
  double oracle_time, library_time;
};

struct range { double lo, hi, error; }; /* error: of the worse of its ends */

struct ranges { int n; struct range at[ORACLE_MOST]; };

static double seconds(void)
{
  return (double)clock() / CLOCKS_PER_SEC;
}

static void to_library(const struct oracle_gear *gear, double par[])
{
  struct oracle_gear copy = *gear;

  libmlg_defaults(par);
  for (int i = 0; i < ORACLE_PARAMETER_COUNT; i++)
    par[libmlg_parameter(oracle_name[i])] = *oracle_at(&copy, i);
  par[libmlg_parameter("zB_shared")] = gear->zB_shared;
  par[libmlg_parameter("R_moves")] = gear->R_moves;
  par[libmlg_parameter("heading")] = gear->heading;
  par[libmlg_parameter("I_p")] = gear->I_p;
}

/* Its answer for this c_d alone. */
static int is_free(int layout, const struct oracle_gear *gear, double c_d)
{
  double par[LIBMLG_MOST_PARAMETERS];

  to_library(gear, par);
  par[libmlg_parameter("c_d")] = c_d;
  return libmlg_is_free(libmlg_layout(oracle_layout_name[layout]), par, 0., 0., gear->V_top);
}

/* The library's intervals; n < 0: it refuses. */
static struct ranges of_library(int layout, const struct oracle_gear *gear)
{
  struct libmlg_interval out[ORACLE_MOST];
  double par[LIBMLG_MOST_PARAMETERS];
  struct ranges r = { .n = 0 };

  to_library(gear, par);
  memset(out, 0, sizeof out);
  r.n = libmlg_intervals(libmlg_layout(oracle_layout_name[layout]), par, 0., 0., gear->V_top, out, ORACLE_MOST);
  for (int i = 0; i < r.n && i < ORACLE_MOST; i++) {
    int j = i;

    for (; j > 0 && r.at[j - 1].lo > out[i].lo.c_d; j--)
      r.at[j] = r.at[j - 1];
    r.at[j] = (struct range){ out[i].lo.c_d, out[i].hi.c_d, 0. };
  }
  return r;
}

static struct ranges of_oracle(const struct oracle_answer *answer, double c_unit)
{
  struct ranges r = { .n = answer->intervals };

  for (int i = 0; i < r.n; i++) {
    const struct oracle_interval *v = &answer->interval[i];

    r.at[i] = (struct range){ v->c[0] * c_unit, v->c[1] * c_unit, fmax(v->error[0], v->error[1]) };
  }
  return r;
}

/* Relative distance of two ends; 0 and infinity agree with themselves. */
static double distance(double a, double b)
{
  return (a > b || a < b) ? fabs(log(a / b)) : 0.;
}

/* Is c in one of them? */
static bool among(const struct ranges *r, double c)
{
  for (int i = 0; i < r->n; i++)
    if (c > r->at[i].lo && c < r->at[i].hi)
      return true;
  return false;
}

/* How far rounding may move the oracle's end nearest to c. */
static double error_near(const struct ranges *r, double c)
{
  double error = 0., nearest = HUGE_VAL;

  for (int i = 0; i < r->n; i++) {
    const double d = fmin(distance(c, r->at[i].lo), distance(c, r->at[i].hi));

    if (d < nearest)
      nearest = d, error = r->at[i].error;
  }
  return error;
}

enum verdict { MISSED, INVENTED, ORACLE, UNDECIDED };

static const char *const verdict_name[] = { "missed", "invented", "oracle", "undecided" };

/* Who is right between lo and hi, of which only the library says that there is no shimmy
 * (claimed) or only the oracle: the oracle on a grid of its own there, and at points even in
 * ln c_d and within every part that it finds, samples of V. */
static enum verdict judge(int layout, const struct oracle_gear *gear, double lo, double hi, bool claimed)
{
  enum { POINTS = 9, STEPS = 400, SPEEDS = 4000 };
  const enum oracle_layout of = (enum oracle_layout)layout;
  const double from = lo > 0. ? lo : hi * 1e-6, to = hi < INFINITY ? hi : fmax(from, lo) * 1e6;
  const struct oracle_answer closer = oracle_examine(of, gear, from * (1. + 1e-9), to * (1. - 1e-9), STEPS);
  double point[POINTS + 2 * ORACLE_MOST];
  int points = 0, calm = 0, shimmy = 0;

  for (int i = 1; i <= POINTS; i++)
    point[points++] = from * pow(to / from, (double)i / (POINTS + 1));
  for (int i = 0; i < closer.intervals; i++) {
    const double *c = closer.interval[i].c;

    point[points++] = sqrt(c[0] * c[1]);
    if (i > 0)
      point[points++] = sqrt(c[0] * closer.interval[i - 1].c[1]);
  }
  for (int i = 0; i < points; i++) {
    bool free_of_shimmy = false;
    double V;

    for (int j = 0; j < closer.intervals; j++)
      free_of_shimmy |= point[i] > closer.interval[j].c[0] && point[i] < closer.interval[j].c[1];

    const bool sampled = oracle_growth(of, gear, point[i], SPEEDS, &V) < 0.;

    calm += free_of_shimmy && sampled;
    shimmy += !free_of_shimmy && !sampled;
  }
  if (calm == points)
    return claimed ? ORACLE : MISSED;
  if (shimmy == points || (shimmy > 0 && claimed))
    return claimed ? INVENTED : ORACLE;
  return UNDECIDED;
}

static int by_value(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* Compares two sets; a line for each difference. */
static void differences(const char *what, int layout, const struct oracle_gear *gear, double c_unit,
                        const struct ranges *oracle, const struct ranges *library, struct count *count)
{
  double end[4 * ORACLE_MOST];
  int ends = 0;

  if (library->n < 0 || library->n > ORACLE_MOST) {
    printf("%s layout=%s: refused: the library returns %d, the oracle has %d intervals\n", what,
           oracle_layout_name[layout], library->n, oracle->n);
    count->refused++;
    return;
  }
  for (int i = 0; i < oracle->n; i++)
    end[ends++] = oracle->at[i].lo, end[ends++] = oracle->at[i].hi;
  for (int i = 0; i < library->n; i++)
    end[ends++] = library->at[i].lo, end[ends++] = library->at[i].hi;
  qsort(end, (size_t)ends, sizeof *end, by_value);
  for (int i = 0; i + 1 < ends; i++) {
    const double lo = end[i], hi = end[i + 1], width = distance(lo, hi);

    if (!(hi > lo))
      continue;
    const double inside = !(lo > 0.) ? hi / 2. : hi < INFINITY ? sqrt(lo) * sqrt(hi) : 2. * lo;
    const bool of_oracle = among(oracle, inside), of_library = among(library, inside);

    if (of_oracle == of_library) {
      if (width > thin && isfinite(inside) && is_free(layout, gear, inside / c_unit) != of_library) {
        printf("%s layout=%s: refused: libmlg_is_free() contradicts libmlg_intervals() at c_d = %.17g\n", what,
               oracle_layout_name[layout], inside);
        count->refused++;
      }
      continue;
    }
    if (width <= agree) {
      count->worst = fmax(count->worst, width);
      continue;
    }
    const double error = error_near(oracle, inside);

    if (width < thin || (error > uncertain && width < 1e3 * error)) {
      printf("%s layout=%s: ill-conditioned: (%.13g, %.13g), the oracle's error %.1e\n", what,
             oracle_layout_name[layout], lo, hi, error);
      count->ill++;
      if (error > uncertain || width < 10. * agree)
        continue;
    }
    const enum verdict verdict = judge(layout, gear, lo / c_unit, hi / c_unit, of_library);

    printf("%s layout=%s: %s: (%.13g, %.13g) free of shimmy by the %s alone, relative width %.1e\n", what,
           oracle_layout_name[layout], verdict_name[verdict], lo, hi, of_oracle ? "oracle" : "library", width);
    *(verdict == MISSED ? &count->missed : verdict == INVENTED ? &count->invented
      : verdict == ORACLE ? &count->oracle : &count->undecided) += 1;
  }
}

static void summary(const struct count *c, int cases)
{
  printf("%d gears, %d answers (%d divergent), %d intervals; ends: %d folds, %d at V = 0, %d at V_top, %d at c_d = 0 or"
         " infinity\n", cases, c->answers, c->divergence, c->intervals, c->ends - c->at_0 - c->at_top - c->open, c->at_0,
         c->at_top, c->open);
  printf("missed %d, invented %d, oracle wrong %d, undecided %d, refused %d; ill-conditioned %d, unresolved by the oracle %d\n",
         c->missed, c->invented, c->oracle, c->undecided, c->refused, c->ill, c->unresolved);
  printf("ends agree within %.1e; %.3g ms an answer by the oracle, %.3g ms by the library\n", c->worst,
         1e3 * c->oracle_time / c->answers, 1e3 * c->library_time / c->answers);
}

static int failures(const struct count *c)
{
  return c->missed + c->invented + c->oracle + c->undecided + c->refused;
}

static void tally(struct count *count, const struct oracle_answer *answer)
{
  count->answers++;
  count->divergence += answer->divergence;
  count->unresolved += answer->unresolved;
  count->intervals += answer->intervals;
  for (int i = 0; i < answer->intervals; i++)
    for (int side = 0; side < 2; side++) {
      count->ends++;
      count->at_0 += answer->interval[i].end[side] == ORACLE_AT_0;
      count->at_top += answer->interval[i].end[side] == ORACLE_AT_TOP;
      count->open += answer->interval[i].end[side] == ORACLE_OPEN;
    }
}

/* One gear: the oracle's answer for it times c_unit, against the library's in_units. */
static void compare(const char *what, int layout, const struct oracle_gear *gear, const struct oracle_gear *in_units,
                    double c_unit, struct count *count)
{
  const double start = seconds();
  const struct oracle_answer answer = oracle_intervals((enum oracle_layout)layout, gear);
  const double middle = seconds();
  const struct ranges library = of_library(layout, in_units);
  const struct ranges oracle = of_oracle(&answer, c_unit);

  count->library_time += seconds() - middle;
  count->oracle_time += middle - start;
  tally(count, &answer);
  differences(what, layout, gear, c_unit, &oracle, &library, count);
}

static int compare_random(const struct options *o)
{
  struct count count = { .answers = 0 };

  for (int k = o->first; k < o->first + o->cases; k++) {
    struct oracle_gear gear = random_gear(o->seed, k, o->spread);
    char what[80];

    random_doubts(&gear, o->seed, k, o->doubts);

    snprintf(what, sizeof what, "seed=%llu case=%d doubts=%d", (unsigned long long)o->seed, k, o->doubts);
    for (int layout = 0; layout < ORACLE_LAYOUTS; layout++)
      if (o->layout < 0 || o->layout == layout)
        compare(what, layout, &gear, &gear, 1., &count);
    if ((k + 1 - o->first) % 20 == 0)
      fprintf(stderr, "\r%d of %d gears, %d differences ", k + 1 - o->first, o->cases, failures(&count));
    fflush(stdout);
  }
  fprintf(stderr, "\n");
  summary(&count, o->cases);
  return failures(&count) > 0;
}

static int compare_units(const struct options *o)
{
  static const struct { enum oracle_layout layout; double k_s, b; } paper[] = {
    { ORACLE_L1, 0., 0. }, { ORACLE_L2, 7.86e5, 0. }, { ORACLE_LI1, 6.38e5, 140. }, { ORACLE_LI2, 1.1e6, 80. }
  };
  struct count count = { .answers = 0 };

  for (int k = o->first; k < o->first + o->cases; k++)
    for (int i = 0; i < (int)(sizeof paper / sizeof *paper); i++) {
      double c_unit;
      const struct oracle_gear in_units = gear_in_units(o->seed, k, paper[i].k_s, paper[i].b, &c_unit);
      struct oracle_gear gear = oracle_paper();
      char what[80];

      gear.k_s = paper[i].k_s > 0. ? paper[i].k_s : INFINITY;
      gear.b = paper[i].b;
      snprintf(what, sizeof what, "units seed=%llu case=%d", (unsigned long long)o->seed, k);
      compare(what, (int)paper[i].layout, &gear, &in_units, c_unit, &count);
    }
  summary(&count, o->cases);
  return failures(&count) > 0;
}

/* --- the table of hard gears -------------------------------------------------------- */

enum { LINE = 2000 };

/* name,layout,parameters,V_top,of,c_lo,c_hi: true for a row that is read.  A # begins a comment. */
static bool read_row(char *line, char name[64], int *layout, struct oracle_gear *gear, int *of, struct range *range)
{
  const char *rest = strchr(line, ',');
  size_t length;

  if (rest == NULL || (length = (size_t)(rest - line)) == 0 || length > 63)
    return false;
  memcpy(name, line, length);
  name[length] = '\0';
  line += length + 1;
  if ((rest = strchr(line, ',')) == NULL)
    return false;
  length = (size_t)(rest - line);
  for (*layout = 0; *layout < ORACLE_LAYOUTS; (*layout)++)
    if (strlen(oracle_layout_name[*layout]) == length && memcmp(oracle_layout_name[*layout], line, length) == 0)
      break;
  if (*layout == ORACLE_LAYOUTS || !read_gear(rest + 1, gear, &rest))
    return false;
  *range = (struct range){ 0., 0., 0. };
  return sscanf(rest, "%d,%lf,%lf", of, &range->lo, &range->hi) == 3 || (sscanf(rest, "%d", of) == 1 && *of == 0);
}

static int compare_hard(const char *path)
{
  FILE *file = fopen(path, "r");
  char line[LINE], name[64];
  struct count count = { .answers = 0 };
  int number = 0, gears = 0, wrong = 0, layout, of;
  struct oracle_gear gear;
  struct range range;

  if (file == NULL) {
    fprintf(stderr, "random-compare: %s: cannot be read\n", path);
    return 2;
  }
  while (fgets(line, sizeof line, file) != NULL) {
    struct ranges want = { .n = 0 };

    number++;
    if (line[0] == '#' || strncmp(line, "name,", 5) == 0)
      continue;
    for (bool first = true; first || want.n < of; first = false) {
      if (!first && (number++, fgets(line, sizeof line, file) == NULL))
        line[0] = '\0';
      if (!read_row(line, name, &layout, &gear, &of, &range) || of < 0 || of > ORACLE_MOST) {
        fprintf(stderr, "random-compare: %s:%d: expected name,layout,parameters,V_top,of,c_lo,c_hi\n", path, number);
        fclose(file);
        return 2;
      }
      if (of > 0)
        want.at[want.n++] = range;
    }
    const struct oracle_answer answer = oracle_intervals((enum oracle_layout)layout, &gear);
    const struct ranges library = of_library(layout, &gear), oracle = of_oracle(&answer, 1.);

    gears++;
    tally(&count, &answer);
    if (oracle.n != want.n) {
      printf("%s: the oracle has %d intervals, the table %d\n", name, oracle.n, want.n);
      wrong++;
    }
    for (int i = 0; i < oracle.n && i < want.n; i++) {
      const double off = fmax(distance(oracle.at[i].lo, want.at[i].lo), distance(oracle.at[i].hi, want.at[i].hi));

      want.at[i].error = oracle.at[i].error;
      if (off > fmax(1e-9, 10. * oracle.at[i].error)) {
        printf("%s: the oracle has (%.13g, %.13g), the table (%.13g, %.13g)\n", name, oracle.at[i].lo, oracle.at[i].hi,
               want.at[i].lo, want.at[i].hi);
        wrong++;
      }
    }
    differences(name, layout, &gear, 1., &want, &library, &count);
  }
  fclose(file);
  if (gears == 0) {
    fprintf(stderr, "random-compare: %s: no gear in it\n", path);
    return 2;
  }
  summary(&count, gears);
  return wrong > 0 || failures(&count) > 0;
}

int main(int argc, char **argv)
{
  if (argc > 1 && strcmp(argv[1], "hard") == 0) {
    if (argc != 3) {
      fprintf(stderr, "random-compare: hard: expected one file\n");
      return 2;
    }
    return compare_hard(argv[2]);
  }
  const bool units = argc > 1 && strcmp(argv[1], "units") == 0;
  const struct options o = read_options(argc - 1 - units, argv + 1 + units, units ? 100 : 2000);

  return units ? compare_units(&o) : compare_random(&o);
}
