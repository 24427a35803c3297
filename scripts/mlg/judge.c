/* judge.c - is AUTO's run what it was meant to be?  See judge.h. */
#include "judge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../models/mlg.h"
#include "branch.h"
#include "ending.h"

static const char *const types[] = { "BP", "LP", "HB", "HH", "ZH", "UZ", "PD", "TR", "EP", "MX", "BT", "CP", "GH",
                                     "R1", "R2", "R3", "R4", "LPD", "LTR", "PTR", "TTR", "closed" };
enum { TYPES = sizeof types / sizeof *types };

/* What is being judged and what has been found so far. */
struct judge {
  const struct af_branches *all;
  struct judgement *out;
  long found[TYPES];
};

static int type_number(const char *name, size_t length)
{
  for (int i = 0; i < TYPES; i++)
    if (strlen(types[i]) == length && memcmp(types[i], name, length) == 0)
      return i;
  return -1;
}

static void count(struct judge *j, const char *type)
{
  const int i = type_number(type, strlen(type));

  if (i >= 0)
    j->found[i]++;
}

static void complain(struct judgement *out, const char *text)
{
  text_add(&out->complaints, "%s%s", out->complaints.length ? "; " : "", text);
}

int check_expectations(char *const expected[], int n, struct text *why)
{
  for (int i = 0; i < n; i++) {
    const char *equals = strchr(expected[i], '=');
    long number;

    if (!equals || type_number(expected[i], (size_t)(equals - expected[i])) < 0) {
      text_add(why, "'%s': expected TYPE=COUNT; a TYPE is", expected[i]);
      for (int k = 0; k < TYPES; k++)
        text_add(why, "%s %s", k == TYPES - 1 ? " or" : k ? "," : "", types[k]);
      return -1;
    }
    if (!whole_number(equals + 1, 0, 999999, &number)) {
      text_add(why, "'%s': expected a whole number from 0 to 999999 behind the =", expected[i]);
      return -1;
    }
    for (int k = 0; k < i; k++)
      if (strncmp(expected[k], expected[i], (size_t)(equals - expected[i]) + 1) == 0) {
        text_add(why, "'%s' and '%s': one count for each type", expected[k], expected[i]);
        return -1;
      }
  }
  return 0;
}

/* UZ, EP and MX may stand anywhere and explain no change of stability. */
static int is_bifurcation(const char *type)
{
  return *type && strcmp(type, "UZ") != 0 && strcmp(type, "EP") != 0 && strcmp(type, "MX") != 0;
}

/* Whether straight rolling has no eigenvalue near the imaginary axis there; on it the
 * count of stable ones is up to rounding. */
static int clear_of_axis(const struct af_branches *all, const struct af_point *p)
{
  for (int k = 0; k < p->eigenvalues; k++)
    if (fabs(all->eigenvalue[p->eigenvalue + 2 * (size_t)k]) < 1e-6)
      return 0;
  return p->eigenvalues > 0;
}

/* A change of the number of stable eigenvalues or multipliers without the label of a
 * bifurcation: stepped over.  At a Hopf point, where orbits begin, AUTO counts none,
 * and in its first step it looks for no bifurcation. */
static void check_stability(struct judge *j, const struct af_part *part, long points)
{
  const struct af_constants *c = &part->constants;
  const int counted = j->all->has_d && c->IID > 0;

  if (c->ISW != 1 || c->ISP <= 0 || strstr(c->SP, "TR0") || (c->IPS != 1 && c->IPS != 2))
    return;
  for (long i = 1; i < points; i++) {
    const struct af_point *p = &part->point[i], *was = p - 1;
    const int now = counted ? p->stable_count : p->stable, before = counted ? was->stable_count : was->stable;
    struct text text = TEXT_NONE;

    if (now == before || (i == 1 && !clear_of_axis(j->all, was)) || is_bifurcation(af_type_name(p->type))
        || is_bifurcation(af_type_name(was->type)))
      continue;
    if (counted && now < 0)
      text_add(&text, "no stability in d. at %s = %.6g", part->column[0], af_value(part, i, 0));
    else if (counted)
      text_add(&text, "%d stable %s become %d", before, c->IPS == 2 ? "multipliers" : "eigenvalues", now);
    else
      text_add(&text, "stable becomes %s", now ? "of unstable" : "unstable");
    if (!(counted && now < 0))
      text_add(&text, " without a label between %s = %.6g and %.6g (try another %s)", part->column[0],
               af_value(part, i - 1, 0), af_value(part, i, 0), i == 1 ? "start" : "DSMAX");
    complain(j->out, text.at);
    text_free(&text);
  }
}

/* Folds, where AUTO is asked for them: its search for the fold can end beside it. */
static void check_folds(struct judge *j, const struct af_part *part, long points)
{
  if (part->constants.ILP <= 0)
    return;
  for (long i = 2; i < points; i++) {
    const double x = af_value(part, i - 1, 0);
    const int turns = (af_value(part, i, 0) - x) * (x - af_value(part, i - 2, 0)) < 0.;
    const int labelled = strcmp(af_type_name(part->point[i - 1].type), "LP") == 0;
    struct text text = TEXT_NONE;

    if (turns == labelled)
      continue;
    if (turns)
      text_add(&text, "fold without a label near %s = %.6g (try another DSMAX)", part->column[0], x);
    else
      text_add(&text, "LP at %s = %.6g is not an extremum", part->column[0], x);
    complain(j->out, text.at);
    text_free(&text);
  }
}

/* A gear's parameter that left the range in which it means something. */
static void check_ranges(struct judge *j, const struct af_part *part, long points)
{
  for (int k = 0; k < part->columns; k++) {
    const struct mlg_parameter *p = mlg_find(part->column[k], strlen(part->column[k]));
    struct text text = TEXT_NONE;

    for (long i = 0; p && i < points; i++) {
      const double x = af_value(part, i, k), slack = 2e-6 * fmax(1., fabs(p->least)); /* a stop is met to AUTO's precision */

      if (x >= p->least - slack && x <= p->most * (1. + 1e-6))
        continue;
      text_add(&text, "%s = %.6g %s is outside its range, %g to %g (stop nearer, UZSTOP)", p->name, x, p->unit,
               p->least, p->most);
      complain(j->out, text.at);
      break;
    }
    text_free(&text);
  }
}

/* A curve of bifurcations of orbits, which ends where the orbit vanishes.  AUTO would
 * follow the zero solution, or turn and run back over the same points. */
static void check_curve(struct judge *j, const struct af_part *part)
{
  const int size = size_column(part);
  double largest = 0.;

  if (part->constants.IPS != 2 || !is_curve(part) || size < 0)
    return;
  for (long i = 2; i < part->points; i++) {
    const double x = af_value(part, i - 1, 0), here = af_value(part, i - 1, size);
    const int turns = (af_value(part, i, 0) - x) * (x - af_value(part, i - 2, 0)) < 0.;
    struct text text = TEXT_NONE;
    long same = 0;

    largest = fmax(largest, here);
    if (af_value(part, i, size) < 1e-5 * largest)
      text_add(&text, "fell onto the zero solution at %s = %.6g", part->column[0], af_value(part, i, 0));
    /* of the next points, how many lie on the way here? */
    for (long k = i; turns && here < af_value(part, i, size) && here < af_value(part, i - 2, size) && k < part->points && k < i + 4; k++)
      for (long m = i - 2; m >= 1; m--) {
        const double a = af_value(part, m, 0), b = af_value(part, m - 1, 0), at = af_value(part, k, 0);

        if ((at - a) * (at - b) <= 0. && a != b) {
          const double t = (at - a) / (b - a), on = af_value(part, m, size) + t * (af_value(part, m - 1, size) - af_value(part, m, size));

          same += fabs(on - af_value(part, k, size)) < 1e-2 * on;
          break;
        }
      }
    if (same >= 2 && text.length == 0)
      text_add(&text, "the curve runs back over itself from %s = %.6g, where the orbit vanishes", part->column[0], x);
    if (text.length > 0) {
      complain(j->out, text.at);
      text_free(&text);
      return;
    }
  }
}

/* Why the last point is the last: a bound that the run met ("RL1 = 100"), or "". */
static void bound_met(const struct af_part *part, struct text *text)
{
  const struct af_constants *c = &part->constants;
  const long last = part->points - 1;
  const double x = af_value(part, last, 0), y = af_value(part, last, part->columns > 1 ? 1 : 0);

  if (x < c->RL0 || x > c->RL1)
    text_add(text, "%s = %.6g", x < c->RL0 ? "RL0" : "RL1", x < c->RL0 ? c->RL0 : c->RL1);
  else if (part->columns > 1 && (y < c->A0 || y > c->A1))
    text_add(text, "%s = %.6g", y < c->A0 ? "A0" : "A1", y < c->A0 ? c->A0 : c->A1);
}

static int expects(const struct judged *run, const char *type)
{
  const size_t n = strlen(type);

  for (int i = 0; i < run->n_expected; i++)
    if (strncmp(run->expected[i], type, n) == 0 && run->expected[i][n] == '=')
      return 1;
  return 0;
}

/* The end of a part: broken off, out of steps, or at a bound. */
static void check_end(struct judge *j, const struct judged *run, const struct af_part *part)
{
  const struct af_point *last = &part->point[part->points - 1];
  const char *type = af_type_name(last->type);
  struct text bound = TEXT_NONE, text = TEXT_NONE;

  bound_met(part, &bound);
  if (part->points == 1 && bound.length > 0)
    text_add(&text, "the start, %s = %.6g, lies outside %s", part->column[0], af_value(part, 0, 0), bound.at);
  else if (!*type)
    text_add(&text, "AUTO broke off at %s = %.6g", part->column[0], af_value(part, part->points - 1, 0));
  else if (strcmp(type, "EP") == 0 && bound.length > 0)
    text_add(&j->out->found, "%sended at %s", j->out->found.length ? " " : "", bound.at);
  else if (strcmp(type, "EP") == 0 && part->points > 1 && !expects(run, "EP"))
    text_add(&text, "ended at EP: the steps (NMX) were used up; where that is meant, expect it: -- EP=1");
  if (text.length > 0)
    complain(j->out, text.at);
  text_free(&bound);
  text_free(&text);
}

static void judge_part(struct judge *j, const struct judged *run, const struct af_part *part)
{
  const struct ending e = find_ending(part, run->s, run->layout);
  struct text text = TEXT_NONE;

  for (long i = 0; i < e.kept; i++) {
    const char *type = af_type_name(part->point[i].type);

    if (!*type || (strcmp(type, "EP") == 0 && i == 0))
      continue;
    count(j, type);
    if (strcmp(point_type(j->all, part, i), type) != 0)
      count(j, point_type(j->all, part, i));
    if (strcmp(type, "EP") != 0 && strcmp(type, "UZ") != 0)
      text_add(&j->out->found, "%s%s %.6g", j->out->found.length ? " " : "", type, af_value(part, i, 0));
  }
  if (e.closed) {
    count(j, "closed");
    text_add(&j->out->found, "%sclosed", j->out->found.length ? " " : "");
  }
  if (e.fell >= 0) {
    text_add(&text, "fell onto the zero solution at %s = %.6g, where straight rolling has no Hopf point", part->column[0],
             af_value(part, e.fell, 0));
    if (!isnan(e.re))
      text_add(&text, " (eigenvalue %.3g + %.4gi)", e.re, e.im);
    complain(j->out, text.at);
  }
  check_stability(j, part, e.kept);
  check_folds(j, part, e.kept);
  check_ranges(j, part, e.kept);
  check_curve(j, part);
  if (!e.closed)
    check_end(j, run, part);
  if (part->gap) {
    text_clear(&text);
    text_add(&text, "%s:%ld: a point is missing before it", j->all->file, part->gap);
    complain(j->out, text.at);
  }
  if (part->nan)
    complain(j->out, "not-a-number in the solution");
  text_free(&text);
}

/* What was expected against what was found. */
static void check_counts(struct judge *j, const struct judged *run)
{
  for (int i = 0; i < run->n_expected; i++) {
    const char *equals = strchr(run->expected[i], '=');
    const int length = (int)(equals - run->expected[i]), type = type_number(run->expected[i], (size_t)length);
    const long wanted = strtol(equals + 1, NULL, 10);
    struct text text = TEXT_NONE;

    if (type < 0)
      continue;
    if (j->found[type] != wanted)
      text_add(&text, "expected %ld %s, found %ld", wanted, types[type], j->found[type]);
    else if (wanted == 0 && strcmp(types[type], "closed") != 0 && strcmp(types[type], "EP") != 0 && strcmp(types[type], "MX") != 0)
      for (int k = 0; k < j->all->parts && text.length == 0; k++)
        if (!looks_for(&j->all->part[k].constants, strcmp(types[type], "HH") == 0 ? "ZH" : types[type]))
          text_add(&text, "expected 0 %s, but the run did not look for it (ILP, ISP, SP)", types[type]);
    if (text.length > 0)
      complain(j->out, text.at);
    text_free(&text);
  }
}

/* "no special point", with what was not looked for. */
static void say_nothing_found(const struct af_branches *all, struct text *found)
{
  struct text missing = TEXT_NONE;
  const char *list = types_of(&all->part[0]);
  int looked = 0;

  for (const char *t = list; *t; t += strspn(t, " ")) {
    char type[8];
    const size_t n = strcspn(t, " ");

    memcpy(type, t, n);
    type[n] = '\0';
    if (looks_for(&all->part[0].constants, type))
      looked++;
    else
      text_add(&missing, "%s%s", missing.length ? ", " : "", type);
    t += n;
  }
  if (looked == 0)
    text_add(found, "no special point looked for");
  else if (missing.length > 0)
    text_add(found, "no special point (not looked for: %s)", missing.at);
  else
    text_add(found, "no special point");
  text_free(&missing);
}

/* Whether AUTO ended itself: its time is in the log.  0 for an empty log as well. */
static int ended_itself(const struct judged *run, int *empty)
{
  struct text log = TEXT_NONE, why = TEXT_NONE;
  int ended;

  *empty = 0;
  if (!run->log)
    return 0;
  *empty = read_file(run->log, &log, &why) != 0 || log.length == 0;
  ended = !*empty && strstr(log.at, "Total Time");
  text_free(&log);
  text_free(&why);
  return ended;
}

/* What is_whole means in judge.h, of files that could be read. */
static int is_whole(const struct judged *run, const struct af_branches *all, struct judgement *out)
{
  const struct af_part *last = all->parts ? &all->part[all->parts - 1] : NULL;
  struct af_solutions solutions;
  int empty;
  const int ended = ended_itself(run, &empty);

  if (empty)
    return 0;
  if (run->s && (ended || !run->log)) {
    if (af_read_solutions(&solutions, run->s, &out->damage) != 0)
      return 0;
    af_free_solutions(&solutions);
  }
  return !ended || (last && last->points > 0 && last->point[last->points - 1].label > 0 && all->timed);
}

void judge_run(const struct judged *run, struct judgement *out)
{
  struct af_branches all;
  struct judge j = { .all = &all, .out = out };
  long solutions = 0;

  *out = (struct judgement){ TEXT_NONE, TEXT_NONE, TEXT_NONE, 0 };
  text_clear(&out->found);
  text_clear(&out->complaints);
  text_clear(&out->damage);
  if (af_read(&all, run->b, run->d, &out->damage) != 0) {
    complain(out, out->damage.at);
    return;
  }
  for (int i = 0; i < all.parts; i++)
    solutions += all.part[i].points;
  for (int i = 0; i < all.parts; i++)
    if (all.part[i].points > 0)
      judge_part(&j, run, &all.part[i]);
  if (run->status != 0) {
    struct text text = TEXT_NONE;

    text_add(&text, "AUTO stopped with status %d", run->status);
    complain(out, text.at);
    text_free(&text);
  }
  if (solutions == 0)
    complain(out, "AUTO computed no solution");
  check_counts(&j, run);
  if (j.found[type_number("MX", 2)])
    complain(out, "MX: no convergence");
  if (out->found.length == 0 && solutions > 0)
    say_nothing_found(&all, &out->found);
  out->whole = is_whole(run, &all, out);
  if (out->damage.length > 0)
    complain(out, out->damage.at);
  af_free(&all);
}

void judgement_free(struct judgement *judgement)
{
  text_free(&judgement->found);
  text_free(&judgement->complaints);
  text_free(&judgement->damage);
}
