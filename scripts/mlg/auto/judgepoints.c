/* judgepoints.c - what the judge finds along the points of a branch; see judge.h */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mlg.h"
#include "branch.h"
#include "judgepoints.h"

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

/* What may help against a bifurcation that was stepped over before point i. */
static const char *advice(const struct af_part *part, long i)
{
  if (i == 1)
    return "try another start";
  for (long k = i > 4 ? i - 3 : 2; part->constants.ILP == 0 && k <= i + 3 && k < part->points; k++)
    if ((af_value(part, k, 0) - af_value(part, k - 1, 0)) * (af_value(part, k - 1, 0) - af_value(part, k - 2, 0)) < 0.)
      return "a fold, which ILP = 0 hides: ILP=1";
  return "try another DSMAX";
}

/* A change of the number of stable eigenvalues or multipliers without the label of a
 * bifurcation: stepped over.  At a Hopf point, where orbits begin, AUTO counts none,
 * and in its first step it looks for no bifurcation.  Orbits with a multiplier too near to
 * the unit circle to be told, as all are beside a Hopf point, are left out. */
void check_stability(const struct af_branches *all, struct judgement *out, const struct af_part *part, long points)
{
  const struct af_constants *c = &part->constants;
  const int counted = all->has_d && c->IID > 0;

  if (c->ISW != 1 || c->ISP <= 0 || strstr(c->SP, "TR0") || (c->IPS != 1 && c->IPS != 2))
    return;
  const int orbits = counted && is_orbits(part);
  const int from_0 = clear_of_axis(all, &part->point[0]) && !(orbits && !multipliers_are_clear(all, &part->point[0]));
  int labelled = is_bifurcation(af_type_name(part->point[0].type));
  long last = 0;

  for (long i = 1; i < points; i++) {
    const struct af_point *p = &part->point[i], *was = &part->point[last];
    const int now = counted ? p->stable_count : p->stable, before = counted ? was->stable_count : was->stable;
    const int label = is_bifurcation(af_type_name(p->type)), explained = labelled || label || (last == 0 && !from_0);
    const long from = last;
    struct text text = TEXT_NONE;

    labelled |= label;
    if (orbits && now >= 0 && !multipliers_are_clear(all, p))
      continue;
    labelled = label;
    last = i;
    if (now == before || explained)
      continue;
    if (counted && now < 0)
      text_add(&text, "no stability in d. at %s = %.6g", part->column[0], af_value(part, i, 0));
    else if (counted)
      text_add(&text, "%d stable %s become %d", before, c->IPS == 2 ? "multipliers" : "eigenvalues", now);
    else
      text_add(&text, "stable becomes %s", now ? "of unstable" : "unstable");
    if (!(counted && now < 0))
      text_add(&text, " without a label between %s = %.6g and %.6g (%s)", part->column[0], af_value(part, from, 0),
               af_value(part, i, 0), advice(part, i));
    complain(out, text.at);
    text_free(&text);
  }
}

/* Folds, where AUTO is asked for them: its search for the fold can end beside it. */
void check_folds(struct judgement *out, const struct af_part *part, long points)
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
    complain(out, text.at);
    text_free(&text);
  }
}

/* A gear's parameter that left the range in which it means something. */
void check_ranges(struct judgement *out, const struct af_part *part, long points)
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
      complain(out, text.at);
      break;
    }
    text_free(&text);
  }
}

/* A curve of bifurcations of orbits, which ends where the orbit vanishes.  AUTO would
 * follow the zero solution, or turn and run back over the same points. */
void check_curve(struct judgement *out, const struct af_part *part)
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
      complain(out, text.at);
      text_free(&text);
      return;
    }
  }
}
