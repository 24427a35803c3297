/* explore_tolerance.c - the design of the largest tolerance (libmlg_tolerance)
 *
 * Of the 2^n corners of the box only a few fail first: for each mode that limits a design the one
 * to which its slopes lead.  The search asks these, more of them as it finds them, and at its end all.
 */
#include "weakest.h"

#include <math.h>
#include <string.h>

#include "box.h"
#include "command.h"

static void put_p(struct weakest *w, double p)
{
  w->p = p;
}

static int ask(struct explorer *e, unsigned corner)
{
  struct corners *const asked = &e->corners;

  for (int i = 0; i < asked->n; i++)
    if (asked->corner[i] == corner)
      return 0;
  if (asked->n == EXPLORE_CORNERS)
    return 0;
  asked->corner[asked->n++] = corner;
  return 1;
}

/* The corner of the box of size p at which the ratio of a mode is least by its slopes at `from`, of
 * the same size (0: the design itself). */
static unsigned worst_corner(const struct explorer *e, const struct weak *weak, unsigned from, double p)
{
  const double h = 1e-6;
  const struct box_at box = weakest_box(e);
  unsigned corner = 0;

  for (int side = 0; side < box_sides(&box); side++) {
    double ratio[2];

    for (int k = 0; k < 2; k++) {
      double part[LIBMLG_MOST_SIDES], par[LIBMLG_MOST_PARAMETERS], own[BOX_ELEMENTS];

      box_corner(&box, from, p, part);
      part[side] += k ? h : -h;
      box_to(&box, part, par, own);
      ratio[k] = mode_ratio(e->layout, par, &weak->mode);
      box_back(&box, own);
    }
    if (ratio[1] < ratio[0])
      corner |= 1u << side;
  }
  return corner;
}

/* Asks the worst corners of the modes that are least at the place that is set; how many are new. */
static int ask_worst(struct weakest *w)
{
  struct explorer *const e = w->e;
  const double least = w->weak[0].mode.zeta;
  int more = 0;

  for (int i = 0; i < w->n && i < CLIMB_PIECES && w->weak[i].mode.zeta < least + 1e-4; i++)
    more += ask(e, worst_corner(e, &w->weak[i], e->corners.n > more ? e->corners.corner[w->weak[i].at] : 0, w->p));
  return more;
}

/* The largest p at the corners asked, of a design near x[]. */
static double most_tolerance(struct weakest *w, double x[], int *asked)
{
  w->more = NULL;
  if (w->e->corners.n == 0) { /* those of the best damped design */
    w->p = 0.;
    if (!(weakest_top(w, x, 0.1, asked) > 0.))
      return 0.;
    ask_worst(w);
  } else { /* a design without shimmy at all */
    struct corners *const corners = &w->e->corners;
    const int n = corners->n;

    corners->n = 0;
    const double ratio = weakest_top(w, x, 0.1, asked);

    corners->n = n;
    if (!(ratio > 0.))
      return 0.;
  }
  w->more = ask_worst;
  return weakest_most(w, put_p, x, 1e-4, asked);
}

/* Again and again from a place, until all corners tested fail no earlier than those asked. */
static double settle(struct weakest *w, double x[], double from, int *asked)
{
  struct explorer *const e = w->e;
  struct libmlg_tolerance all = { .p = from };

  for (int round = 0; round < 12; round++) {
    const double p = weakest_most(w, put_p, x, 0.95 * all.p, asked);
    const struct box_at box = weakest_box(e);

    if (box_tolerance(&box, &all) != 0)
      fail("explore", MLG_FAILED, "no tolerance at k_s = %g, b = %g, c_d = %g", e->par[NUMBER_K_S], e->par[NUMBER_B], e->par[NUMBER_C_D]);
    if (all.p >= p * (1. - 1e-6) || !ask(e, all.corner))
      break;
  }
  return all.p;
}

void explore_tolerance(struct explorer *e, int n, struct found *found)
{
  struct weakest w = { .e = e };
  struct starts starts;

  *found = (struct found){ .value = 0. };
  e->corners.n = 0;
  explore_set_all(e, (double[EXPLORE_VARIABLES]){ 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5 });
  libmlg_box_of(e->layout, e->par, &e->corners.box);
  explore_starts(&w, most_tolerance, n, &starts, &found->asked);
  explore_best(e, &starts, 1e-2, found);
  if (!(found->value > 0.))
    return;
  found->value = settle(&w, found->x, found->value, &found->asked);
  const struct found settled = *found;

  for (int i = 0; i < starts.n; i++) /* by the corners that are known now */
    if (starts.value[i] > 0.)
      starts.value[i] = weakest_most(&w, put_p, starts.x[i], 0.95 * starts.value[i], &found->asked);
  explore_best(e, &starts, 1e-2, found);
  if (found->value > settled.value * (1. + 1e-6))
    found->value = settle(&w, found->x, found->value, &found->asked);
  else {
    found->value = settled.value;
    memcpy(found->x, settled.x, sizeof found->x);
  }
  explore_set_all(e, found->x);
  explore_take(e, found);
  e->corners.n = 0;
}
