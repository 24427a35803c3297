/* ending.c - where a branch of orbits ends; see ending.h */
#include "ending.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "libmlg.h"
#include "mlg.h"
#include "branch.h"

enum { MOST_LAYOUTS = sizeof ((struct rolling *)0)->layout / sizeof (int) };

/* AUTO's slot of a column: that of its name in parnames, or of PAR(n); 0 for none. */
static int slot_of(const struct af_part *part, const char *name)
{
  long slot;
  char number[8];

  for (int k = 0; k < part->parameters; k++)
    if (strcmp(part->parameter[k], name) == 0)
      return k + 1;
  if (strncmp(name, "PAR(", 4) == 0 && strlen(name) < 9) {
    strcpy(number, name + 4);
    number[strcspn(number, ")")] = '\0';
    if (whole_number(number, 1, MLG_BOUNDARY_SLOTS, &slot))
      return (int)slot;
  }
  return 0;
}

/* libmlg's number of AUTO's parameter slot, or LIBMLG_NONE. */
static int parameter_at(int slot)
{
  for (int k = 0; k < MLG_PARAMETER_COUNT; k++)
    if (mlg_parameters[k].slot + 1 == slot)
      return libmlg_parameter(mlg_parameters[k].name);
  return LIBMLG_NONE;
}

static int has_states(int layout, const struct af_part *part)
{
  if (libmlg_states(layout) != part->states)
    return 0;
  for (int k = 0; k < part->states; k++)
    if (strcmp(libmlg_state_quantity(layout, k)->name, part->state[k]) != 0)
      return 0;
  return 1;
}

/* Whether a solution is of a point of the part: their parameters are the same. */
static int is_of_point(const struct af_part *part, long point, const double par[], int parameters)
{
  for (int k = 0; k < part->columns; k++) {
    const int slot = slot_of(part, part->column[k]);
    const double x = af_value(part, point, k);

    if (slot > 0 && slot <= parameters && !(fabs(par[slot - 1] - x) <= 1e-9 * fabs(x) + 1e-300))
      return 0;
  }
  return 1;
}

/* All parameters of the part's run, from one of its solutions in s., where there may be
 * those of other runs too.  0 when there is none. */
static int find_parameters(struct rolling *r, const struct af_part *part, const struct af_solutions *solutions)
{
  struct text why = TEXT_NONE;
  int known = 0;

  for (long i = 0; i < part->points && !known; i++)
    for (int k = 0; k < solutions->n && part->point[i].label > 0 && !known; k++) {
      const struct af_solution *one = &solutions->solution[k];
      double *par;

      if (one->label != part->point[i].label || one->type != part->point[i].type
          || one->parameters <= PAR_M)
        continue;
      const size_t slots = one->parameters > MLG_SLOTS ? (size_t)one->parameters : MLG_SLOTS;

      par = must_allocate(slots * sizeof *par); /* what an older solution lacks is 0 */
      memset(par, 0, slots * sizeof *par);
      known = af_solution_parameters(solutions, one, par, &why) == 0 && is_of_point(part, i, par, one->parameters);
      for (int n = 0; n < MLG_PARAMETER_COUNT && known; n++)
        r->par[parameter_at(mlg_parameters[n].slot + 1)] = par[mlg_parameters[n].slot];
      free(par);
    }
  text_free(&why);
  return known;
}

int find_rolling(struct rolling *r, const struct af_part *part, const char *s, const char *layout)
{
  struct af_solutions solutions;
  struct text why = TEXT_NONE;
  int known = 0;

  r->layouts = 0;
  for (int i = 0; i < libmlg_layouts() && r->layouts < MOST_LAYOUTS; i++)
    if (layout ? strcmp(libmlg_layout_name(i), layout) == 0 : has_states(i, part))
      r->layout[r->layouts++] = i;
  r->parameter = parameter_at(slot_of(part, part->column[0]));
  libmlg_defaults(r->par);
  if (r->layouts > 0 && r->parameter != LIBMLG_NONE && s && af_read_solutions(&solutions, s, &why) == 0) {
    known = find_parameters(r, part, &solutions);
    af_free_solutions(&solutions);
  }
  text_free(&why);
  return known;
}

/* The eigenvalue of straight rolling nearest to near_re + i near_im at a value of the
 * continued parameter.  0 when LAPACK fails. */
static int nearest_eigenvalue(const struct rolling *r, int layout, double value, const double near[2], double found[2])
{
  double par[LIBMLG_MOST_PARAMETERS], u[LIBMLG_MOST_STATES] = { 0. };
  double A[LIBMLG_MOST_STATES * LIBMLG_MOST_STATES], re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES];
  const int n = libmlg_states(layout);
  double least = INFINITY;

  memcpy(par, r->par, sizeof par);
  par[r->parameter] = value;
  if (libmlg_outside(par) != LIBMLG_NONE || libmlg_jacobian(layout, par, u, A, NULL) != 0)
    return 0;
  for (int i = 0; i < n * n; i++)
    if (!isfinite(A[i]))
      return 0;
  if (LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', n, A, n, re, im, NULL, 1, NULL, 1) != 0)
    return 0;
  for (int i = 0; i < n; i++) {
    const double distance = hypot(re[i] - near[0], im[i] - near[1]);

    if (distance < least) {
      least = distance;
      found[0] = re[i];
      found[1] = im[i];
    }
  }
  return 1;
}

/* The Hopf point within reach of value, of an oscillation of about omega rad/s: by
 * secants in the real part.  Returns 1 and its value and omega, or 0. */
static int hopf_point(const struct rolling *r, int layout, double value, double omega, double reach, double at[2])
{
  double x[2] = { value, value + 1e-2 * reach }, mu[2][2], near[2] = { 0., omega };

  if (!nearest_eigenvalue(r, layout, x[0], near, mu[0]) || !nearest_eigenvalue(r, layout, x[1], mu[0], mu[1]))
    return 0;
  for (int i = 0; i < 40; i++) {
    const double slope = (mu[1][0] - mu[0][0]) / (x[1] - x[0]);
    const double next = x[1] - mu[1][0] / slope;

    if (x[1] == x[0] || !isfinite(next) || fabs(next - value) > reach)
      return 0;
    x[0] = x[1];
    memcpy(mu[0], mu[1], sizeof mu[0]);
    x[1] = next;
    if (!nearest_eigenvalue(r, layout, x[1], mu[0], mu[1]))
      return 0;
    if (fabs(x[1] - x[0]) <= 1e-13 * fabs(x[1]) || fabs(mu[1][0]) <= 1e-12 * fabs(mu[1][1])) {
      at[0] = x[1];
      at[1] = mu[1][1];
      return mu[1][1] > 0. && fabs(mu[1][1] / omega - 1.) < 0.02;
    }
  }
  return 0;
}

/* Where the squared size of the orbits runs out in a straight line, through point n and
 * the last one before of at least twice its size, since points that lie close have no
 * digits to tell: the parameter and the period.  0 when the orbits do not get smaller. */
static int runs_out(const struct af_part *part, long n, int size, int period, double at[2])
{
  const double s1 = af_value(part, n, size);
  const int column[2] = { 0, period };
  double s0, share;
  long m = n - 1;

  while (m > 0 && af_value(part, m, size) < 2. * s1 && af_value(part, m - 1, size) > af_value(part, m, size))
    m--;
  s0 = af_value(part, m, size);
  if (!(s1 > 0. && s1 < s0))
    return 0;
  share = s1 * s1 / (s0 * s0 - s1 * s1);
  for (int k = 0; k < 2; k++)
    at[k] = af_value(part, n, column[k]) + share * (af_value(part, n, column[k]) - af_value(part, m, column[k]));
  return isfinite(at[0]) && at[1] > 0.;
}

/* Whether the branch closes behind its point n. */
static int closes(const struct rolling *r, const struct af_part *part, long n, int size, int period, struct ending *e)
{
  double at[2], hopf[2];
  double reach;

  if (n < 1 || !runs_out(part, n, size, period, at))
    return 0;
  reach = 0.5 * fabs(at[0] - af_value(part, n, 0)) + 1e-4 * fabs(at[0]);
  for (int i = 0; i < r->layouts; i++)
    if (hopf_point(r, r->layout[i], at[0], 2. * MLG_PI / at[1], reach, hopf)) {
      e->closed = 1;
      e->value = hopf[0];
      e->period = 2. * MLG_PI / hopf[1];
      return 1;
    }
  return 0;
}

struct ending find_ending(const struct af_part *part, const char *s, const char *layout)
{
  struct ending e = { .kept = part->points, .value = NAN, .period = NAN, .fell = -1, .re = NAN, .im = NAN };
  const int size = size_column(part);
  int period = af_column(part, "period"), known = -1;
  double largest = 0.;
  struct rolling r;

  if (period < 0)
    period = af_column(part, "PERIOD");
  if (!is_orbits(part) || size < 0 || period < 0)
    return e;
  for (long i = 1; i < part->points; i++) {
    const double here = af_value(part, i, size), before = af_value(part, i - 1, size);
    const int zero = here < fmax(1e-9, 1e-5 * largest);
    const int branch_point = strcmp(af_type_name(part->point[i].type), "BP") == 0;
    /* a fold of orbits has no smallest one, a branch that retraces itself has */
    const int turns = i > 1 && before < here && before < af_value(part, i - 2, size)
                      && (af_value(part, i, 0) - af_value(part, i - 1, 0)) * (af_value(part, i - 1, 0) - af_value(part, i - 2, 0)) < 0.;

    largest = fmax(largest, here);
    if (!zero && !branch_point && !turns)
      continue;
    if (known < 0)
      known = find_rolling(&r, part, s, layout);
    if (known && closes(&r, part, i - 1, size, period, &e)) {
      e.kept = i;
      break;
    }
    if (zero) {
      const double T = af_value(part, i, period), near[2] = { 0., 2. * MLG_PI / T };
      double mu[2];

      e.fell = i;
      if (known && T > 0. && nearest_eigenvalue(&r, r.layout[0], af_value(part, i, 0), near, mu))
        e.re = mu[0], e.im = mu[1];
      break;
    }
  }
  return e;
}
