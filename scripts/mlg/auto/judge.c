/* judge.c - is AUTO's run what it was meant to be?  See judge.h. */
#include "judge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "branch.h"
#include "ending.h"
#include "judgepoints.h"

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

void complain(struct judgement *out, const char *text)
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
  if (e.closed || closes(part)) {
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
  check_stability(j->all, j->out, part, e.kept);
  check_folds(j->out, part, e.kept);
  check_ranges(j->out, part, e.kept);
  check_curve(j->out, part);
  check_hopf_points(j->out, part, run->s, run->layout);
  check_closing(j->out, part);
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

  *out = (struct judgement){ .missed = 0 };
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
