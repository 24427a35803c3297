/* explore.c - the best design of a network, by a global search with repeated starts
 *
 * The free values of a network are those of its b, k_s and c_d, and of any further elements
 * that are asked for.  Each start is a run of cma.h from a random place; where a design with a
 * zero-shimmy interval is rare, from one of those that the search for damping has found.
 */
#include "explore.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "cma.h"
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

int explore_free(struct explorer *e, const char *name)
{
  struct device_text *const d = device_writable(e->layout);

  for (int i = 0; d && i < d->parts && e->others < EXPLORE_OTHERS; i++) {
    struct part *const p = &d->part[i];

    if (p->slot < 0 && p->text && strncmp(p->text, name, strlen(name)) == 0 && p->text[strlen(name)] == '=') {
      e->other[e->others++] = p;
      return 0;
    }
  }
  return LIBMLG_NONE;
}

/* k = k_psi (1/u - 1), so that a step of u is one of compliance where the spring is stiff. */
static double spring_at(const struct explorer *e, double x)
{
  const double k_psi = e->par[NUMBER_K_PSI];
  const double soft = 1. / (1. + e->k_least / k_psi), stiff = 1. / (1. + 1e9 / k_psi);

  return k_psi * (1. / (stiff + x * (soft - stiff)) - 1.);
}

static double damper_at(double x)
{
  return 10. * pow(1e6, x);
}

/* The place of a design; of other elements, which have none, x stays. */
static void place_of(const struct explorer *e, double k_s, double b, double c_d, double x[])
{
  const double k_psi = e->par[NUMBER_K_PSI];
  const double soft = 1. / (1. + e->k_least / k_psi), stiff = 1. / (1. + 1e9 / k_psi);
  int n = 0;

  if (e->has_k_s)
    x[n++] = fmax(0., fmin(1., (1. / (1. + k_s / k_psi) - stiff) / (soft - stiff)));
  if (e->has_b)
    x[n++] = fmin(1., b / e->b_most);
  x[n + e->others] = fmax(0., fmin(1., log10(c_d / 10.) / 6.));
}

static int set_values(struct explorer *e, const double x[])
{
  int n = 0;

  if (e->has_k_s)
    e->par[NUMBER_K_S] = spring_at(e, x[n++]);
  if (e->has_b)
    e->par[NUMBER_B] = e->b_most * x[n++];
  for (int i = 0; i < e->others; i++, n++)
    e->other[i]->value = e->other[i]->kind == SPRING ? spring_at(e, x[n]) : e->other[i]->kind == DAMPER ? damper_at(x[n])
                                                                                                    : e->b_most * x[n];
  return n;
}

/* --- what is to be largest -------------------------------------------------------------------- */

static double zeta(const double x[], void *context)
{
  struct explorer *const e = context;
  struct libmlg_ratio least;

  e->par[NUMBER_C_D] = damper_at(x[set_values(e, x)]);
  return libmlg_least_ratio(e->layout, e->par, e->V_least, e->V_top, &least) == 0 ? least.zeta : -INFINITY;
}

/* The same at the best c_d, exactly. */
static double best_c_d(const double x[], void *context)
{
  struct explorer *const e = context;
  struct libmlg_ratio best;

  set_values(e, x);
  if (libmlg_best_c_d(e->layout, e->par, e->V_least, e->V_top, &best) != 0)
    return -INFINITY;
  e->par[NUMBER_C_D] = best.c_d;
  return best.zeta;
}

/* --- repeated starts ---------------------------------------------------------------------------- */

/* From the best of a few random places, or from `given`, a place to begin with. */
static double one_start(struct explorer *e, int n, const double *given, double sigma, int most, double enough,
                        struct cma_random *random, double x[], int *asked)
{
  double best = -INFINITY, value, place[EXPLORE_VARIABLES];
  int more;

  for (int k = 0; k < (given ? 1 : 12); k++) {
    for (int i = 0; i < n; i++)
      place[i] = given ? given[i] : cma_uniform(random);
    value = zeta(place, e);
    if (k == 0 || value > best) {
      best = value;
      memcpy(x, place, sizeof place);
    }
  }
  more = cma_largest(zeta, e, n, x, sigma, random, most, enough, &value);
  if (more < 0)
    fail("explore", MLG_FAILED, "LAPACK failed");
  *asked += more + (given ? 1 : 12);
  return value;
}

/* Whether two results are one: to this part. */
static const double same = 1e-2;

void explore_zeta(struct explorer *e, int starts, const double given[], double enough, struct found *found)
{
  const int n = e->has_k_s + e->has_b + e->others + 1, most = 250 * n;
  double result[EXPLORE_STARTS], x[EXPLORE_VARIABLES] = { 0. };
  struct cma_random random = { 1 };

  *found = (struct found){ .value = -INFINITY };
  for (int start = 0; start < starts && !(found->value > enough); start++) {
    const int from = start == 0 && given != NULL;

    result[start] = one_start(e, n, from ? given : NULL, from ? 0.03 : 0.15, most, enough, &random, x, &found->asked);
    found->starts++;
    if (result[start] > found->value) {
      found->value = result[start];
      memcpy(found->x, x, sizeof x);
    }
  }
  for (int start = 0; start < found->starts; start++)
    found->met += result[start] >= found->value - same * fabs(found->value);
  found->value = zeta(found->x, e);
  found->lo = found->hi = e->par[NUMBER_C_D];
  if (enough == INFINITY && n > 1) { /* more closely, c_d exactly */
    double exact;

    memcpy(x, found->x, sizeof x);
    for (int k = 0; k < 2 && cma_largest(best_c_d, e, n - 1, x, k ? 1e-5 : 3e-3, &random, 20 * n, INFINITY, &exact) > 0; k++)
      found->asked += 20 * n;
    if (exact > found->value) {
      found->value = best_c_d(x, e);
      found->lo = found->hi = e->par[NUMBER_C_D];
      memcpy(found->x, x, (size_t)(n - 1) * sizeof *x);
      found->x[n - 1] = log10(found->lo / 10.) / 6.;
    }
  }
  found->k_s = e->par[NUMBER_K_S];
  found->b = e->par[NUMBER_B];
  if (enough == INFINITY && e->others == 0 && n > 1) { /* and by a grid that is refined */
    struct libmlg_ratio best;

    if (libmlg_best_damped(e->layout, e->par, 0., e->has_b ? e->b_most : 0., e->V_least, e->V_top, &best) == 0
        && best.zeta > found->value && (!e->has_k_s || (best.k_s >= e->k_least && best.k_s <= 1e9))) {
      found->value = best.zeta;
      found->lo = found->hi = best.c_d;
      found->k_s = best.k_s;
      found->b = best.b;
      place_of(e, found->k_s, found->b, found->lo, found->x);
    }
  }
}

/* --- the widest interval: exact over k_s, so that b alone is left to search ---------------------- */

struct widest { struct explorer *e; int of_ratio; double b; struct libmlg_interval interval; double k_s, size; };

/* At the k_s of par[]. */
static void take_interval(struct widest *w)
{
  struct libmlg_interval all[LIBMLG_MOST_POINTS];
  const int n = libmlg_intervals(w->e->layout, w->e->par, 0., 0., w->e->V_top, all, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n; i++) {
    const double lo = all[i].lo.c_d, hi = all[i].hi.c_d, size = w->of_ratio ? hi / lo : hi - lo;

    if (size > w->size) {
      w->size = size;
      w->interval = all[i];
      w->k_s = w->e->par[NUMBER_K_S];
    }
  }
}

static double at_k_s(const double x[], void *context)
{
  struct widest *const w = context;
  struct widest here = *w;

  here.size = -INFINITY;
  w->e->par[NUMBER_K_S] = spring_at(w->e, x[0]);
  take_interval(&here);
  if (here.size > w->size)
    *w = here;
  return here.size;
}

static double widest_at(struct widest *w, double b)
{
  const struct widest none = { .e = w->e, .of_ratio = w->of_ratio, .b = b, .size = -INFINITY };
  struct explorer *const e = w->e;
  struct libmlg_widest best;
  int status;

  *w = none;
  e->par[NUMBER_B] = e->has_b ? b : 0.;
  e->par[NUMBER_K_S] = MLG_RIGID;
  status = (w->of_ratio ? libmlg_largest_ratio : libmlg_widest)(e->layout, e->par, 0., 0., e->V_top, &best);
  if (status != 0 || best.limit == LIBMLG_NO_INTERVAL)
    return w->size;
  if (!e->has_k_s || (best.k_s >= e->k_least && best.k_s <= 1e9)) {
    w->interval = best.interval;
    w->k_s = best.k_s;
    w->size = w->of_ratio ? best.interval.hi.c_d / best.interval.lo.c_d : best.width;
    return w->size;
  }
  /* beyond the springs that are looked at: the best of these */
  for (int start = 0; start < 4; start++) {
    struct cma_random random = { (unsigned)start };
    double x[1] = { start / 3. }, value;

    if (cma_largest(at_k_s, w, 1, x, 0.1, &random, 300, INFINITY, &value) < 0)
      fail("explore", MLG_FAILED, "LAPACK failed");
  }
  return w->size;
}

/* Golden section over b, to this part of its range. */
static struct widest between(struct widest w, double left, double right, double part_left, int *asked)
{
  const double part = 0.6180339887498949;
  struct widest a = w, b = w, best = w;

  widest_at(&a, right - part * (right - left));
  widest_at(&b, left + part * (right - left));
  for (*asked += 2; right - left > part_left * w.e->b_most; ++*asked) {
    const struct widest *const better = a.size >= b.size ? &a : &b;

    if (better->size > best.size)
      best = *better;
    if (a.size >= b.size) {
      right = b.b;
      b = a;
      widest_at(&a, right - part * (right - left));
    } else {
      left = a.b;
      a = b;
      widest_at(&b, left + part * (right - left));
    }
  }
  return best;
}

/* The same at a place of k_s and b, for a narrow interval that the nodes over k_s may miss. */
static double at_place(const double x[], void *context)
{
  struct widest *const w = context;
  struct widest here = *w;

  here.size = -INFINITY;
  set_values(w->e, x);
  here.b = w->e->par[NUMBER_B];
  take_interval(&here);
  if (here.size > w->size)
    *w = here;
  return here.size;
}

/* From a design that has an interval, by the evolution strategy. */
static void beside(struct widest *best, const double given[])
{
  const int n = best->e->has_k_s + best->e->has_b;
  struct cma_random random = { 3 };
  double x[EXPLORE_VARIABLES], value;

  memcpy(x, given, sizeof x);
  for (int k = 0; k < 3 && n > 0; k++)
    if (cma_largest(at_place, best, n, x, (double[]){ 1e-3, 1e-2, 1e-4 }[k], &random, 200 * n, INFINITY, &value) < 0)
      fail("explore", MLG_FAILED, "LAPACK failed");
}

void explore_interval(struct explorer *e, int of_ratio, int starts, const double given[], struct found *found)
{
  const struct widest none = { .e = e, .of_ratio = of_ratio, .size = -INFINITY };
  const int n = e->has_b ? starts : 1;
  const double step = e->b_most / n;
  struct widest best = none;
  double result[EXPLORE_STARTS];
  int asked = 0;

  for (int start = 0; start < n; start++) {
    struct widest here = none;

    if (e->has_b) /* a stretch of b each, and those beside it */
      here = between(none, fmax(0., (start - 1) * step), fmin(e->b_most, (start + 2) * step), 1e-3, &asked);
    else {
      widest_at(&here, 0.);
      asked++;
    }
    result[start] = here.size;
    if (here.size > best.size)
      best = here;
  }
  if (given)
    beside(&best, given);
  if (e->has_b && best.size > -INFINITY) {
    struct widest here = between(best, fmax(0., best.b - 0.01 * e->b_most), fmin(e->b_most, best.b + 0.01 * e->b_most), 1e-8, &asked);

    if (here.size > best.size)
      best = here;
    for (int end = 0; end < 2; end++) {
      widest_at(&here, end ? e->b_most : 0.);
      if (here.size > best.size)
        best = here;
    }
    asked += 2;
  }
  *found = (struct found){ .value = best.size, .k_s = best.k_s, .b = best.b, .lo = best.interval.lo.c_d,
                           .hi = best.interval.hi.c_d, .starts = n, .asked = asked };
  for (int start = 0; start < n; start++)
    found->met += result[start] >= found->value * (1. - same);
}

/* Whether some design near x, which becomes it, has a damping ratio above 0 at the load of par[]. */
static int holds(struct explorer *e, double x[], struct cma_random *random, int *asked)
{
  const int n = e->has_k_s + e->has_b + e->others + 1;
  double value = zeta(x, e);

  for (int k = 0; k < 5 && !(value > 0.); k++) {
    double near[EXPLORE_VARIABLES];

    memcpy(near, x, sizeof near);
    *asked += cma_largest(zeta, e, n, near, (double[]){ 1e-3, 0.01, 0.03, 0.1, 0.2 }[k], random, 120 * n, 0., &value);
    if (value > 0.)
      memcpy(x, near, sizeof near);
  }
  ++*asked;
  return value > 0.;
}

/* The largest load, N, between 1e4 or that of m_D alone and 1e7, at which some design has no
 * shimmy, 0 for none: raised as long as one is found, then
 * bisected, always on from the best so far. */
void explore_load(struct explorer *e, const double given[], struct found *found)
{
  const double V_least = e->V_least, M = e->par[NUMBER_M], weight = (M + e->par[NUMBER_M_D]) * e->par[NUMBER_G];
  const double least = fmax(1e4, e->par[NUMBER_M_D] * e->par[NUMBER_G]), most = 1e7;
  double lo = 0., hi = INFINITY, F_z = fmin(fmax(weight, 1.05 * least), 0.95 * most), x[EXPLORE_VARIABLES];
  struct cma_random random = { 5 };

  *found = (struct found){ .starts = 1, .met = 1, .lo = NAN, .hi = NAN, .k_s = NAN, .b = NAN };
  e->V_least = 0.;
  memcpy(x, given, sizeof x);
  while (hi / lo > 1. + 1e-5 && F_z > least && F_z < most) {
    e->par[NUMBER_M] = F_z / e->par[NUMBER_G] - e->par[NUMBER_M_D];
    if (holds(e, x, &random, &found->asked)) {
      lo = F_z;
      zeta(x, e);
      found->lo = found->hi = e->par[NUMBER_C_D];
      found->k_s = e->par[NUMBER_K_S];
      found->b = e->par[NUMBER_B];
    } else
      hi = F_z;
    F_z = !(lo > 0.) ? 0.9 * hi : hi < INFINITY ? sqrt(lo * hi) : 1.05 * lo;
  }
  e->par[NUMBER_M] = M;
  e->V_least = V_least;
  found->value = lo;
}

/* --- the command ---------------------------------------------------------------------------------- */

static void print_row(const char *what, const struct explorer *e, const struct found *f)
{
  printf("%s,%.10g,%.10g,%.10g,", what, f->value, e->has_k_s ? f->k_s : INFINITY, e->has_b ? f->b : 0.);
  printf("%.10g,%.10g,%d,%d,%d\n", f->lo, f->hi, f->met, f->starts, f->asked);
}

enum quantity { ZETA, WIDTH, RATIO, LOAD, QUANTITIES };

static const char *const quantity_name[QUANTITIES] = { "zeta", "width", "ratio", "load" };

/* Takes leading words that are quantities; returns how many. */
static int take_quantities(int argc, char *argv[], bool asked[QUANTITIES])
{
  int n = 0;

  for (bool taken = true; taken && n + 2 < argc; n += taken) {
    taken = false;
    for (int q = 0; q < QUANTITIES; q++)
      if (strcmp(argv[n + 2], quantity_name[q]) == 0)
        taken = asked[q] = true;
  }
  for (int q = 0; q < QUANTITIES && n == 0; q++)
    asked[q] = true;
  return n;
}

static int run(int argc, char *argv[])
{
  enum { B_MOST, STARTS, V_LEAST };
  struct option option[] = {
    [B_MOST] = { "b_most", "N m s^2/rad", 0., 1e9, 300., NULL },
    [STARTS] = { "starts", "", 1., EXPLORE_STARTS, 12., NULL },
    [V_LEAST] = { "V_least", "m/s", 0., 1e3, 0.3, NULL },
    { .name = NULL },
  };
  bool asked[QUANTITIES] = { false };
  struct found damped = { .value = -INFINITY }, interval, load;
  double given[EXPLORE_VARIABLES];
  struct explorer e;
  struct arguments a;

  begin_arguments(&a, argc, argv, option);
  for (int i = 2 + take_quantities(argc, argv, asked); i < argc; i++)
    take_word(&a, argv[i]);
  end_arguments(&a);
  refuse_given(&a, NUMBER_V, "the search is over all speeds");
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  explore_begin(&e, a.layout, a.par, option[B_MOST].value, option[V_LEAST].value, a.V_top);
  const int starts = (int)option[STARTS].value;
  const bool from = a.word[NUMBER_C_D] != NULL;

  if (from)
    place_of(&e, a.par[NUMBER_K_S], a.par[NUMBER_B], a.par[NUMBER_C_D], given);
  printf("# zeta -, width N m s/rad, ratio -, load N; k_s N m/rad, b N m s^2/rad, c_lo, c_hi N m s/rad\n"
         "quantity,value,k_s,b,c_lo,c_hi,met,starts,asked\n");
  if (asked[ZETA] || (asked[LOAD] && !from)) {
    explore_zeta(&e, starts, from ? given : NULL, INFINITY, &damped);
    memcpy(given, damped.x, sizeof given);
  }
  if (asked[ZETA])
    print_row("zeta", &e, &damped);
  for (enum quantity q = WIDTH; q <= RATIO; q++)
    if (asked[q]) {
      explore_interval(&e, q == RATIO, starts, from || asked[ZETA] || asked[LOAD] ? given : NULL, &interval);
      if (interval.value > -INFINITY)
        print_row(quantity_name[q], &e, &interval);
    }
  if (asked[LOAD]) {
    explore_load(&e, given, &load);
    if (load.value > 0.)
      print_row("load", &e, &load);
  }
  return output_status(argv[0]);
}

const struct command command_explore = {
  .name = "explore",
  .usage = "LAYOUT [QUANTITY ...] [NAME=VALUE ...] [b_most=300] [starts=12] [V_least=0.3]",
  .summary = "the best designs of a layout or network, by repeated starts",
  .details =
    "QUANTITY: zeta, width, ratio, load; all of them without.  k_s from 1e4 (from k_d, where k_s\n"
    "alone carries a static torque) to 1e9 N m/rad, b from 0 to b_most and c_d from 10 to 1e7\n"
    "N m s/rad, searched by an evolution strategy from random places (models/libmlg/cma.h); the\n"
    "intervals exactly over k_s, by golden section over b.  With c_d, and k_s and b, the search\n"
    "begins at that design, too.  CSV, a row for each, none where there is no interval:\n"
    "  zeta          the largest least damping ratio over V_least < V < V_top\n"
    "  width, ratio  of the widest zero-shimmy interval c_lo to c_hi: c_hi - c_lo, c_hi/c_lo\n"
    "  load          the largest static load F_z, N, with a design without shimmy\n"
    "  k_s, b, c_lo, c_hi  the design; of zeta and load c_lo = c_hi = c_d\n"
    "  met, starts   how many of the starts came within 1 % of the best\n"
    "  asked         how many designs were looked at; of width and ratio how many b, each with all k_s\n",
  .run = run,
};
