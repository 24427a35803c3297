/* judgehopf.c - has AUTO found every Hopf point of a straight run, and did a Hopf curve that
 * stopped where it closes close there? */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mlg.h"
#include "branch.h"
#include "ending.h"
#include "judgepoints.h"

/* The distance to the next of them, or to an end. */
static double gap_at(const double at[], int n, int i, double lo, double hi)
{
  return fmin(at[i] - (i > 0 ? at[i - 1] : lo), (i + 1 < n ? at[i + 1] : hi) - at[i]);
}

/* How near AUTO's Hopf point is to count as that one: its search ends within EPSS, and two of
 * them are told apart. */
static double reach(double at, double gap)
{
  return fmax(1e-6 * fabs(at), fmin(1e-3 * fabs(at), 0.1 * gap));
}

/* Whether AUTO passes a value and has a Hopf point there. */
static int is_found(const struct af_part *part, double value, double within)
{
  for (long i = 0; i < part->points; i++)
    if (strcmp(af_type_name(part->point[i].type), "HB") == 0 && fabs(af_value(part, i, 0) - value) <= within)
      return 1;
  return 0;
}

/* The Hopf points of the run, at[LIBMLG_MOST_POINTS]; -1 where layouts of these states differ. */
static int exact_points(const struct rolling *r, double lo, double hi, double at[])
{
  double other[LIBMLG_MOST_POINTS];
  int n = libmlg_hopf_along(r->layout[0], r->par, r->parameter, lo, hi, at, LIBMLG_MOST_POINTS);

  n = n < LIBMLG_MOST_POINTS ? n : LIBMLG_MOST_POINTS;
  for (int k = 1; k < r->layouts && n >= 0; k++) {
    if (libmlg_hopf_along(r->layout[k], r->par, r->parameter, lo, hi, other, LIBMLG_MOST_POINTS) != n)
      return -1;
    for (int i = 0; i < n; i++)
      if (fabs(other[i] - at[i]) > 1e-7 * fabs(at[i]))
        return -1;
  }
  return n;
}

void check_hopf_points(struct judgement *out, const struct af_part *part, const char *s, const char *layout)
{
  double at[LIBMLG_MOST_POINTS], lo = INFINITY, hi = -INFINITY;
  struct rolling r;
  struct text text = TEXT_NONE;
  int n, missed = 0;

  if (!is_straight(part) || !looks_for(&part->constants, "HB") || part->points < 2 || !find_rolling(&r, part, s, layout))
    return;
  for (long i = 0; i < part->points; i++) {
    lo = fmin(lo, af_value(part, i, 0));
    hi = fmax(hi, af_value(part, i, 0));
  }
  n = exact_points(&r, lo, hi, at);
  for (int i = 0; i < n; i++) {
    const double within = reach(at[i], gap_at(at, n, i, lo, hi));

    /* in its first step AUTO looks for none, and where it begins or ends on one */
    if (at[i] - lo > within && hi - at[i] > within && !is_found(part, at[i], within))
      text_add(&text, "%s%.7g", missed++ ? ", " : "", at[i]);
  }
  if (missed > 0) {
    struct text line = TEXT_NONE;

    text_add(&line, "stepped over the Hopf point%s at %s = %s", missed > 1 ? "s" : "", part->column[0], text.at);
    complain(out, line.at);
    text_free(&line);
    out->missed = missed;
    out->hopf_points = 0;
    for (int i = 0; i < n && i < MOST_HOPF_POINTS; i++)
      out->hopf[out->hopf_points++] = (struct hopf_point){ at[i], gap_at(at, n, i, lo, hi) };
    snprintf(out->hopf_along, sizeof out->hopf_along, "%s", part->column[0]);
    out->start = af_value(part, 0, 0);
    out->step = fabs(af_value(part, 1, 0) - out->start);
  }
  text_free(&text);
}

int closes(const struct af_part *part)
{
  const long last = part->points - 1;
  const int test = af_column(part, "closes");

  return part->constants.IPS == 1 && is_curve(part) && last > 2 && test >= 0 && strcmp(af_type_name(part->point[last].type), "UZ") == 0
         && fabs(af_value(part, last, test)) < 1e-5;
}

void check_closing(struct judgement *out, const struct af_part *part)
{
  const long last = part->points - 1;

  for (int k = 0; closes(part) && k < part->columns; k++) {
    const double start = af_value(part, 0, k), end = af_value(part, last, k);
    struct text text = TEXT_NONE;

    if (!mlg_find(part->column[k], strlen(part->column[k])) || fabs(end - start) <= 1e-3 * fabs(start) + 1e-300)
      continue;
    text_add(&text, "stopped as if it closed, but %s is %.6g there and %.6g at the start", part->column[k], end, start);
    complain(out, text.at);
    text_free(&text);
  }
}
