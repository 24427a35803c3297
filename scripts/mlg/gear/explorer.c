/* explorer.c - a global search of designs: places, repeated starts, the largest damping
 *
 * The free values of a network are those of its b, k_s and c_d, and of any further elements
 * that are asked for.  Each start is a climb (weakest.h) from the best of a few random places, each
 * at the c_d that is best there, exactly.
 */
#include "explorer.h"

#include <math.h>
#include <string.h>

#include "command.h"
#include "networks.h"
#include "weakest.h"

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

/* Of so many random places, each with the c_d that is best damped there, the best; smaller inertances
 * more often. */
static void best_of_some(const struct weakest *w, int places, struct cma_random *random, double x[], int *asked)
{
  struct explorer *const e = w->e;
  const int n = explore_variables(e) - 1;
  double best = -1.;

  for (int i = 0; i <= n; i++)
    x[i] = cma_uniform(random);
  for (int k = 0; k < places; k++) {
    struct libmlg_interval better;
    struct libmlg_ratio here;
    double place[EXPLORE_VARIABLES];

    for (int i = 0; i < n; i++)
      place[i] = cma_uniform(random);
    if (e->has_b)
      place[e->has_k_s] *= place[e->has_k_s];
    explore_set(e, place);
    ++*asked;
    if ((best > -1. && libmlg_intervals(e->layout, e->par, best, w->V_least, e->V_top, &better, 1) < 1)
        || libmlg_best_c_d(e->layout, e->par, w->V_least, e->V_top, &here) != 0 || !(here.zeta > best))
      continue;
    best = here.zeta;
    memcpy(x, place, sizeof place);
    x[n] = place_of_damper(here.c_d);
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

void explore_best(struct explorer *e, const struct starts *starts, double same, struct found *found)
{
  int best = 0;

  for (int i = 1; i < starts->n; i++)
    if (starts->value[i] > starts->value[best])
      best = i;
  found->value = starts->value[best];
  found->met = explore_met(starts->value, starts->n, found->value, same);
  found->starts = starts->n;
  memcpy(found->x, starts->x[best], sizeof found->x);
  explore_set_all(e, found->x);
  explore_take(e, found);
}

void explore_starts(struct weakest *w, double top(struct weakest *w, double x[], int *asked), int n, struct starts *starts,
                    int *asked)
{
  struct explorer *const e = w->e;
  struct cma_random random = { 1 };

  starts->n = e->given.n + n;
  for (int i = 0; i < starts->n; i++) {
    double *const x = starts->x[i];

    if (i < e->given.n)
      memcpy(x, e->given.x[i], sizeof starts->x[i]);
    else /* of many places the best lies on the broadest ridge, of few anywhere */
      best_of_some(w, (int[]){ 24, 8, 3 }[i % 3], &random, x, asked);
    w->n = 0;
    starts->value[i] = top(w, x, asked);
  }
}

/* --- damping ---------------------------------------------------------------------------------- */

static double top_ratio(struct weakest *w, double x[], int *asked)
{
  return weakest_top(w, x, 0.1, asked);
}

void explore_zeta(struct explorer *e, int n, struct found *found)
{
  struct weakest w = { .e = e, .V_least = e->V_least };
  struct starts starts;

  *found = (struct found){ .value = -INFINITY };
  explore_starts(&w, top_ratio, n, &starts, &found->asked);
  explore_best(e, &starts, 1e-2, found);
}
