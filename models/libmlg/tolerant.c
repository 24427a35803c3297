/* tolerant.c - the design of the largest tolerance (tolerance.c) over c_d, k_s and b
 *
 * Of the 2^n corners only a few ever fail first.  The search asks these, then all of them at
 * what it found, goes on with those that failed there too, and ends when none does.
 *
 * At given k_s and b and corner each c_d of an interval is free, exactly; the c_d whose
 * whole range (1 +- p) c_d lies in the intervals of all corners are an interval again.  Its
 * width falls nearly linearly as p grows, so a secant finds the p at which it ends.
 * Over k_s and b the largest p is a ridge with kinks, on which a climb along one axis at a
 * time stops anywhere: at each b the best k_s is found from the beginning.
 */
#include <math.h>
#include <string.h>

#include "box.h"
#include "places.h"

enum { MOST_ASKED = 1024, NEW_CORNERS = 6, NODES_K_S = 64, NODES_B = 15 };

/* A corner, c_d left out, and the part of p at which it is asked. */
struct asked { unsigned corner; int part; };

struct search {
  int layout, k_s, b, c_d;
  double par[LIBMLG_MOST_PARAMETERS], k_psi, V_least, V_top;
  struct libmlg_box box; /* with c_d as its last */
  struct asked asked[MOST_ASKED];
  int n, parts;          /* parts: of p at which all corners are tested */
};

struct best { double p, u, b, c_d; };

/* The box of what is searched: c_d last, so that a corner without it is a number below
 * 2^(n-1). */
static void set_box(struct search *s)
{
  struct libmlg_box *const box = &s->box;

  libmlg_box_of(s->layout, s->par, box);
  for (int i = 0; i < box->n; i++)
    if (box->parameter[i] == s->c_d) {
      memmove(&box->parameter[i], &box->parameter[i + 1], (size_t)(box->n - i - 1) * sizeof *box->parameter);
      box->parameter[box->n - 1] = s->c_d;
    }
}

static double k_s_of(const struct search *s, double u)
{
  return libmlg_place_k_s(s->k_psi, u, MLG_RIGID);
}

static void place(struct search *s, double k_s, double b)
{
  if (libmlg_uses(s->layout, s->k_s) == 1)
    s->par[s->k_s] = k_s;
  if (libmlg_uses(s->layout, s->b) == 1)
    s->par[s->b] = b;
}

/* --- the largest p over c_d ------------------------------------------------------------------ */

/* log(hi/lo) of the c_d whose +-p is free at all corners asked, as far as it is above
 * `enough`; below 0: there is none.  Of several intervals at a corner the widest in log c_d
 * is meant. */
static double room(struct search *s, double p, double enough, double *c_d)
{
  struct libmlg_box rest = s->box;
  double lo = 0., hi = INFINITY;

  rest.n--;
  for (int i = 0; i < s->n; i++) {
    const struct asked asked = s->asked[i];
    const double here = p * box_part(asked.part);
    struct libmlg_interval interval[LIBMLG_MOST_POINTS];
    double par[LIBMLG_MOST_PARAMETERS], ratio = 0., from = 0., to = 0.;

    libmlg_corner(s->par, &rest, asked.corner, here, par);
    const int n = libmlg_intervals(s->layout, par, 0., s->V_least, s->V_top, interval, LIBMLG_MOST_POINTS);

    for (int k = 0; k < n; k++)
      if (interval[k].hi.c_d / interval[k].lo.c_d > ratio) {
        from = interval[k].lo.c_d;
        to = interval[k].hi.c_d;
        ratio = to / from;
      }
    lo = fmax(lo, from / (1. - here));
    hi = fmin(hi, to / (1. + here));
    if (!(ratio > 0.) || log(hi / lo) < enough) { /* the next time it is asked first */
      memmove(&s->asked[1], s->asked, (size_t)i * sizeof asked);
      s->asked[0] = asked;
      return ratio > 0. ? log(hi / lo) : -INFINITY;
    }
  }
  *c_d = isfinite(hi) ? (lo > 0. ? sqrt(lo * hi) : 0.5 * hi) : 2. * lo;
  return log(hi / lo);
}

/* The largest p over c_d at the k_s and b of the search, at the corners asked; 0: none above
 * `floor`. */
static double most_of_c_d(struct search *s, double floor, double *c_d)
{
  double lo = floor, hi = floor > 0. ? 1.1 * floor : 1e-3, at_lo = room(s, floor, 0., c_d), at_hi, c;

  if (!(at_lo > 0.))
    return 0.;
  while ((at_hi = room(s, hi, -INFINITY, &c)) > 0.) {
    lo = hi;
    at_lo = at_hi;
    *c_d = c;
    if (hi >= LIBMLG_MOST_TOLERANCE)
      return hi;
    hi = fmin(1.5 * hi, LIBMLG_MOST_TOLERANCE);
  }
  for (int i = 0; i < 60 && hi - lo > 1e-12 * hi; i++) {
    const double secant = lo + (hi - lo) * at_lo / (at_lo - at_hi);
    const double p = isfinite(at_hi) && isfinite(at_lo) && i % 3 < 2 ? fmin(fmax(secant, lo), hi) : 0.5 * (lo + hi);
    const double there = room(s, p, -INFINITY, &c);

    if (there > 0.) {
      lo = p;
      at_lo = there;
      *c_d = c;
    } else {
      hi = p;
      at_hi = there;
    }
    if (there >= 0. && there < 1e-12)
      break;
  }
  return lo;
}

static struct best value_at(struct search *s, double u, double b, double floor)
{
  struct best here = { .u = u, .b = b };

  place(s, k_s_of(s, u), b);
  here.p = most_of_c_d(s, floor, &here.c_d);
  return here;
}

/* --- corners ------------------------------------------------------------------------------- */

static void ask(struct search *s, unsigned corner, int part)
{
  const unsigned rest = corner & ((1u << (s->box.n - 1)) - 1u);

  for (int i = 0; i < s->n; i++)
    if (s->asked[i].corner == rest && s->asked[i].part == part)
      return;
  if (s->n < MOST_ASKED)
    s->asked[s->n++] = (struct asked){ rest, part };
}

/* The corners that the widest interval at this b leads to first, and the design itself; 0:
 * there is no interval. */
static int ask_predicted(struct search *s, double b)
{
  const struct box_at d = { .layout = s->layout, .par = s->par, .box = &s->box, .V_least = s->V_least, .V_top = s->V_top };
  struct libmlg_widest w;
  unsigned first[2];
  int n;

  if (libmlg_widest(s->layout, s->par, 0., s->V_least, s->V_top, &w) != 0 || !(w.width > 0.))
    return 0;
  place(s, fmin(w.k_s, MLG_RIGID), b);
  s->par[s->c_d] = isfinite(w.interval.hi.c_d) ? 0.5 * (w.interval.lo.c_d + w.interval.hi.c_d) : 2. * w.interval.lo.c_d;
  n = box_first_corners(&d, first);
  for (int i = 0; i < n; i++)
    ask(s, first[i], 0);
  ask(s, 0, BOX_PARTS);
  return 1;
}

/* Tests all corners at a design and a hair less than p, and at the parts of p below; the few
 * that fail earliest are asked from now on.  Returns how many are new. */
static int ask_failing(struct search *s, const struct best *best)
{
  double par[LIBMLG_MOST_PARAMETERS], p = best->p * (1. - 1e-8);
  const int before = s->n;

  place(s, k_s_of(s, best->u), best->b);
  memcpy(par, s->par, sizeof par);
  par[s->c_d] = best->c_d;
  const struct box_at d = { .layout = s->layout, .par = par, .box = &s->box, .V_least = s->V_least, .V_top = s->V_top };

  for (int part = 0; part < s->parts && s->n == before; part++) {
    unsigned last[NEW_CORNERS]; /* of those that fail earlier than all before them */
    int failing = 0;

    for (unsigned corner = 0; corner < 1u << s->box.n; corner++)
      if (!box_is_free(&d, corner, p * box_part(part))) {
        p = box_begins(&d, corner, p * box_part(part)) / box_part(part) * (1. - 1e-8);
        last[failing++ % NEW_CORNERS] = corner;
      }
    for (int i = 0; i < failing && i < NEW_CORNERS; i++)
      ask(s, last[i], part);
  }
  return s->n - before;
}

/* --- over k_s and b -------------------------------------------------------------------------- */

static struct best better(struct best a, struct best b)
{
  return b.p > a.p ? b : a;
}

static struct best at_u(struct search *s, double u, double b, double floor)
{
  return value_at(s, u, b, floor);
}

/* Golden section of the largest p from left to right: `at` gives it at one place, whose
 * coordinate is u (at_u) or b, and 0 where it is below `floor`. */
static struct best golden(struct search *s, struct best best, double left, double right, double tolerance,
                          struct best (*at)(struct search *s, double x, double b, double floor))
{
  const double ratio = 0.6180339887498949, b = best.b, floor = 0.8 * best.p;
  double x = right - ratio * (right - left), y = left + ratio * (right - left), top = at == at_u ? best.u : best.b;
  struct best at_x = at(s, x, b, floor), at_y = at(s, y, b, floor);

  while (right - left > tolerance) {
    best = better(best, better(at_x, at_y));
    top = at == at_u ? best.u : best.b;
    if (at_x.p > at_y.p || (!(at_x.p < at_y.p) && top < y)) { /* both may be below the floor */
      right = y;
      y = x;
      at_y = at_x;
      x = right - ratio * (right - left);
      at_x = at(s, x, b, floor);
    } else {
      left = x;
      x = y;
      at_x = at_y;
      y = left + ratio * (right - left);
      at_y = at(s, y, b, floor);
    }
  }
  return best;
}

/* The best k_s and c_d at one b, if its p is above `floor`: of a grid over u, then beside its
 * best; all corners tested in the end. */
static struct best best_at_b(struct search *s, double b, double floor)
{
  struct best best = { .p = 0., .b = b };
  double u[PLACES_MOST];
  int nodes, top = 0;

  place(s, libmlg_uses(s->layout, s->k_s) == 1 ? 1e6 : MLG_RIGID, b);
  nodes = libmlg_places(s->layout, s->par, NODES_K_S, u);
  set_box(s);
  if (!ask_predicted(s, b))
    return best;
  do {
    best.p = 0.;
    for (int i = nodes > 1; i < nodes; i++) { /* a rigid k_s has no tolerance */
      const struct best here = value_at(s, u[i], b, fmax(best.p, floor));

      if (here.p > best.p) {
        best = here;
        top = i;
      }
    }
  } while (best.p > 0. && ask_failing(s, &best) > 0);
  if (nodes == 1 || !(best.p > 0.))
    return best;
  do
    best = golden(s, value_at(s, u[top], b, 0.), fmax(u[top - 1], 1e-6), u[top + 1 < nodes ? top + 1 : top], 1e-7, at_u);
  while (best.p > 0. && ask_failing(s, &best) > 0);
  return best;
}

static struct best at_b(struct search *s, double b, double ignored, double floor)
{
  (void)ignored;
  return best_at_b(s, b, floor);
}

static int search_begin(struct search *s, int layout, const double par[], double V_least, double V_top)
{
  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  *s = (struct search){ .layout = layout, .k_s = libmlg_parameter("k_s"), .b = libmlg_parameter("b"),
                        .c_d = libmlg_parameter("c_d"), .V_least = V_least, .V_top = V_top, .parts = 1 };
  memcpy(s->par, par, (size_t)libmlg_parameters() * sizeof *par);
  s->k_psi = par[libmlg_parameter("k_psi")];
  return 0;
}

int libmlg_most_tolerant(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                         struct libmlg_design *design)
{
  const int nodes = libmlg_uses(layout, libmlg_parameter("b")) == 1 && b_most > b_least ? NODES_B : 0;
  const double node = (b_most - b_least) / NODES_B;
  struct best best = { .p = 0., .b = b_least };
  struct search s;

  if (search_begin(&s, layout, par, V_least, V_top) != 0)
    return LIBMLG_NONE;
  for (int i = 0; i <= nodes; i++)
    best = better(best, best_at_b(&s, b_least + i * node, 0.8 * best.p)); /* a node may lie off its peak */
  if (!(best.p > 0.)) {
    design->p = 0.;
    return 0;
  }
  const double left = fmax(best.b - node, b_least), right = fmin(best.b + node, b_most);

  /* along the ridge by the corners known by now, then all of them; again while these know better */
  for (int asked = -1; asked < s.n;) {
    asked = s.n;
    s.parts = 0;
    if (nodes > 0)
      best = golden(&s, value_at(&s, best.u, best.b, 0.), left, right, 1e-3 * node, at_b);
    s.parts = BOX_PARTS;
    best = best_at_b(&s, best.b, 0.);
  }
  place(&s, k_s_of(&s, best.u), best.b);
  if (libmlg_uses(layout, s.k_s) != 1)
    s.par[s.k_s] = MLG_RIGID;
  *design = (struct libmlg_design){ .k_s = s.par[s.k_s], .b = s.par[s.b], .c_d = best.c_d, .p = best.p };
  return 0;
}

/* --- a map ------------------------------------------------------------------------------------ */

int libmlg_tolerance_map(int layout, const double par[], struct libmlg_design node[], int n, double V_least, double V_top)
{
  struct search s;

  if (search_begin(&s, layout, par, V_least, V_top) != 0)
    return LIBMLG_NONE;
  for (int i = 0; i < n; i++) {
    const double u = 1. / (1. + node[i].k_s / s.k_psi);
    struct best here = { .p = 0. };

    place(&s, node[i].k_s, node[i].b);
    set_box(&s);
    if (s.n > 0 || ask_predicted(&s, node[i].b))
      do
        here = value_at(&s, u, node[i].b, 0.);
      while (here.p > 0. && ask_failing(&s, &here) > 0);
    node[i].p = here.p;
    node[i].c_d = here.c_d;
  }
  return 0;
}
