/* explorer.c - a global search of designs: places, repeated starts, the largest damping
 *
 * The free values of a network are those of its b, k_s and c_d, and of any further elements
 * that are asked for.  Each start is a run of cma.h from the best of a few random places, then
 * finer ones from there, at the best c_d of each place where that is known exactly.
 */
#include "explorer.h"

#include <math.h>
#include <string.h>

#include "command.h"
#include "networks.h"

/* --- a design from a place in the unit box ------------------------------------------------- */

void explore_begin(struct explorer *e, int layout, const double par[], double b_most, double V_least, double V_top)
{
  const struct device_text *const d = device_of(layout);

  *e = (struct explorer){ .layout = layout, .V_least = V_least, .V_top = V_top, .b_most = b_most };
  memcpy(e->par, par, (size_t)libmlg_parameters() * sizeof *par);
  e->k_least = d ? network_least_k_s(d, par[NUMBER_K_D]) : 1e4;
  e->has_k_s = libmlg_uses(layout, NUMBER_K_S) == 1;
  e->has_b = libmlg_uses(layout, NUMBER_B) == 1;
}

const char *explore_free(struct explorer *e, const char *name)
{
  const char *wrong;
  struct part *const p = device_element(e->layout, name, &wrong);

  if (!p)
    return wrong;
  if (e->others == EXPLORE_OTHERS)
    return "too many elements are free";
  e->other[e->others++] = p;
  return NULL;
}

int explore_variables(const struct explorer *e)
{
  return e->has_k_s + e->has_b + e->others + 1;
}

/* Part of the compliance that k_s may have, beside 1/k_psi: a step of it is one of compliance
 * where the spring is stiff. */
static double softness(const struct explorer *e, double k)
{
  return 1. / (1. + k / e->par[NUMBER_K_PSI]);
}

double explore_spring(const struct explorer *e, double x)
{
  const double soft = softness(e, e->k_least), stiff = softness(e, 1e9);

  return e->par[NUMBER_K_PSI] * (1. / (stiff + x * (soft - stiff)) - 1.);
}

static double place_of_spring(const struct explorer *e, double k)
{
  const double soft = softness(e, e->k_least), stiff = softness(e, 1e9);

  return fmax(0., fmin(1., (softness(e, k) - stiff) / (soft - stiff)));
}

static double damper_at(double x)
{
  return 10. * pow(1e6, x);
}

static double place_of_damper(double c_d)
{
  return fmax(0., fmin(1., log10(c_d / 10.) / 6.));
}

static double place_of_inerter(const struct explorer *e, double b)
{
  return e->b_most > 0. ? fmin(1., b / e->b_most) : 0.;
}

void explore_place(const struct explorer *e, double k_s, double b, double c_d, double x[])
{
  if (e->has_k_s)
    *x++ = place_of_spring(e, k_s);
  if (e->has_b)
    *x++ = place_of_inerter(e, b);
  for (int i = 0; i < e->others; i++) {
    const struct part *const p = e->other[i];

    *x++ = p->kind == SPRING ? place_of_spring(e, p->value) : p->kind == DAMPER ? place_of_damper(p->value) : place_of_inerter(e, p->value);
  }
  *x = place_of_damper(c_d);
}

double explore_middle(double lo, double hi)
{
  if (isfinite(hi))
    return lo > 0. ? sqrt(lo * hi) : 0.5 * hi;
  return lo > 0. ? 2. * lo : 1e3;
}

void explore_give(struct explorer *e, const double x[])
{
  if (e->given.n < EXPLORE_GIVEN)
    memcpy(e->given.x[e->given.n++], x, (size_t)explore_variables(e) * sizeof *x);
}

void explore_set(struct explorer *e, const double x[])
{
  if (e->has_k_s)
    e->par[NUMBER_K_S] = explore_spring(e, *x++);
  if (e->has_b)
    e->par[NUMBER_B] = e->b_most * *x++;
  for (int i = 0; i < e->others; i++, x++) {
    struct part *const p = e->other[i];

    p->value = p->kind == SPRING ? explore_spring(e, *x) : p->kind == DAMPER ? damper_at(*x) : e->b_most * *x;
  }
}

void explore_set_all(struct explorer *e, const double x[])
{
  explore_set(e, x);
  e->par[NUMBER_C_D] = damper_at(x[explore_variables(e) - 1]);
}

/* --- repeated starts ---------------------------------------------------------------------------- */

int explore_climb(double f(const double x[], void *context), void *context, int n, double x[], double sigma,
                  struct cma_random *random, int most, double *best)
{
  const int asked = cma_largest(f, context, n, x, sigma, random, most, INFINITY, best);

  if (asked < 0)
    fail("explore", MLG_FAILED, "LAPACK failed");
  return asked;
}

int explore_met(const double result[], int n, double best, double same)
{
  int met = 0;

  for (int i = 0; i < n; i++)
    met += result[i] >= (isfinite(best) ? best - same * fabs(best) : best);
  return met;
}

/* To a place x[], from the best of a few random places or from `given`. */
static double one_start(struct explorer *e, const struct goal *goal, const double given[], struct cma_random *random,
                        double x[], int *asked)
{
  const int n = explore_variables(e), places = given ? 1 : 12;
  double best = -INFINITY, place[EXPLORE_VARIABLES];

  for (int k = 0; k < places; k++) {
    for (int i = 0; i < n; i++)
      place[i] = given ? given[i] : cma_uniform(random);
    const double value = goal->rough(place, e);

    if (k == 0 || value > best) {
      best = value;
      memcpy(x, place, sizeof place);
    }
  }
  *asked += places + explore_climb(goal->rough, e, n, x, given ? 0.03 : 0.15, random, 250 * n, &best);
  for (int k = 0; k < 2; k++) /* finer */
    *asked += explore_climb(goal->rough, e, n, x, k ? 1e-4 : 3e-3, random, 60 * n, &best);
  return best;
}

/* --- about the best of them ----------------------------------------------------------------------- */

/* Golden section over x[0], or over x[1] with the best x[0] of each, within `half` of where they
 * are: a ridge, on which steps in all directions end anywhere, does not stop it. */
struct section { struct explorer *e; const struct goal *goal; double half, best, x[2]; int asked; };

static double along(struct section *s, int variable, double x[2]);

static double at(struct section *s, int variable, const double from[2], double place)
{
  double x[2] = { from[0], from[1] }, value;

  x[variable] = place;
  if (variable == 1)
    return along(s, 0, x);
  value = s->goal->exact(x, s->e);
  s->asked++;
  if (value > s->best) {
    s->best = value;
    memcpy(s->x, x, sizeof x);
  }
  return value;
}

/* The largest value found, x[variable] its place; of all so far s->best at s->x. */
static double along(struct section *s, int variable, double x[2])
{
  const double part = 0.6180339887498949, centre = variable == 0 ? s->x[0] : x[variable];
  double left = fmax(0., centre - s->half), right = fmin(1., centre + s->half);
  double a = right - part * (right - left), b = left + part * (right - left);
  double at_a = at(s, variable, x, a), at_b = at(s, variable, x, b), largest = fmax(at_a, at_b);

  while (right - left > (variable == 0 ? 1e-6 : 1e-3) * s->half) {
    if (at_a >= at_b) {
      right = b;
      b = a;
      at_b = at_a;
      a = right - part * (right - left);
      at_a = at(s, variable, x, a);
    } else {
      left = a;
      a = b;
      at_a = at_b;
      b = left + part * (right - left);
      at_b = at(s, variable, x, b);
    }
    largest = fmax(largest, fmax(at_a, at_b));
  }
  return largest;
}

/* With further elements: the strategy again, at the best c_d of each place. */
static void climb_exactly(struct explorer *e, const struct goal *goal, double x[], double *value, int *asked)
{
  const int n = explore_variables(e) - 1;
  struct cma_random random = { 17 };
  double at[EXPLORE_VARIABLES], best = -INFINITY;

  memcpy(at, x, sizeof at);
  for (int k = 0; k < 2; k++)
    *asked += explore_climb(goal->exact, e, n, at, k ? 1e-4 : 5e-3, &random, 40 * n, &best);
  if (best > *value) {
    *value = goal->exact(at, e);
    memcpy(x, at, (size_t)n * sizeof *at);
    x[n] = place_of_damper(e->par[NUMBER_C_D]);
  }
}

/* A place and its value from there on, in a wide window as often as that moves on, then in a narrow
 * one; so for k_s and b alone. */
static void refine(struct explorer *e, const struct goal *goal, double x[], double *value, int *asked)
{
  const int n = explore_variables(e) - 1;

  if (!goal->exact || n < 1)
    return;
  if (n > 2) {
    climb_exactly(e, goal, x, value, asked);
    return;
  }
  for (int wide = 8; wide >= 0; wide--) {
    struct section s = { e, goal, wide ? 0.06 : 0.003, -INFINITY, { x[0], x[1] }, 0 };

    at(&s, 0, s.x, s.x[0]);
    along(&s, n - 1, (double[2]){ x[0], x[1] });
    *asked += s.asked;
    if (wide && !(s.best > *value + 1e-4 * fabs(*value)))
      wide = 1;
    if (s.best > *value) {
      *value = goal->exact(s.x, e);
      memcpy(x, s.x, (size_t)n * sizeof *s.x);
      x[n] = place_of_damper(e->par[NUMBER_C_D]);
    }
  }
}

void explore_take(const struct explorer *e, struct found *found)
{
  found->lo = found->hi = e->par[NUMBER_C_D];
  found->k_s = e->par[NUMBER_K_S];
  found->b = e->par[NUMBER_B];
  for (int i = 0; i < e->others; i++)
    found->other[i] = e->other[i]->value;
}

/* The design of its place. */
static void take_design(struct explorer *e, const struct goal *goal, struct found *found)
{
  explore_set_all(e, found->x);
  if (goal->exact)
    goal->exact(found->x, e);
  explore_take(e, found);
}

/* The number of the largest of result[n] but for number `not`. */
static int largest(const double result[], int n, int not)
{
  int best = not == 0 && n > 1;

  for (int i = 0; i < n; i++)
    if (i != not && result[i] > result[best])
      best = i;
  return best;
}

void explore_starts(struct explorer *e, const struct goal *goal, int starts, double result[], struct found *found)
{
  double place[EXPLORE_STARTS][EXPLORE_VARIABLES] = { { 0. } };
  struct cma_random random = { 1 };
  const int n = e->given.n + starts;

  *found = (struct found){ .starts = n };
  for (int i = 0; i < n; i++)
    result[i] = one_start(e, goal, i < e->given.n ? e->given.x[i] : NULL, &random, place[i], &found->asked);
  /* the best two on their own ways */
  const int best = largest(result, n, -1), second = largest(result, n, best);

  refine(e, goal, place[best], &result[best], &found->asked);
  if (n > 1)
    refine(e, goal, place[second], &result[second], &found->asked);
  const int top = largest(result, n, -1);

  found->value = result[top];
  memcpy(found->x, place[top], sizeof place[top]);
  found->met = explore_met(result, n, found->value, goal->same);
  take_design(e, goal, found);
}

/* --- damping ---------------------------------------------------------------------------------- */

double explore_ratio(const double x[], void *explorer)
{
  struct explorer *const e = explorer;
  struct libmlg_ratio least;

  explore_set_all(e, x);
  return libmlg_least_ratio(e->layout, e->par, e->V_least, e->V_top, &least) == 0 ? least.zeta : -INFINITY;
}

void explore_zeta(struct explorer *e, int starts, struct found *found)
{
  static const struct goal goal = { explore_ratio, NULL, 1e-2 };
  double result[EXPLORE_STARTS + 1];
  struct libmlg_ratio best;

  explore_starts(e, &goal, starts, result, found);
  if (e->others > 0)
    return;
  /* and by a grid that is refined, exactly over c_d: a start more */
  if (libmlg_best_damped(e->layout, e->par, 0., e->has_b ? e->b_most : 0., e->V_least, e->V_top, &best) != 0
      || (e->has_k_s && !(best.k_s >= e->k_least && best.k_s <= 1e9)))
    return;
  result[found->starts++] = best.zeta;
  if (best.zeta > found->value) {
    found->value = best.zeta;
    found->lo = found->hi = best.c_d;
    found->k_s = best.k_s;
    found->b = best.b;
    explore_place(e, found->k_s, found->b, found->lo, found->x);
  }
  found->met = explore_met(result, found->starts, found->value, goal.same);
}
