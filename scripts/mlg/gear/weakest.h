/* weakest.h - the modes of a design that have the least damping ratios, with slopes
 *
 * The least damping ratio of a place, over V and over the cases that a design has to bear at once
 * (the corners of the box of tolerances that are asked, or the design alone), as the pieces of
 * climb.h: each case's modes at the speeds where their ratios are least, followed from place to
 * place (mode.h).  The least is exact: in no case is there a speed with a lesser ratio
 * (libmlg_is_free).
 */
#ifndef MLG_WEAKEST_H
#define MLG_WEAKEST_H

#include "climb.h"
#include "explorer.h"
#include "mode.h"

enum { WEAKEST_MOST = 32 };

struct weak { int at; struct mode_at mode; }; /* at: number of the corner, or 0 */

struct weakest {
  struct explorer *e;
  double V_least, p; /* p: size of the box */
  int (*more)(struct weakest *w); /* asks more corners at the top of a climb, and says how many; or NULL */
  int n;
  struct weak weak[WEAKEST_MOST]; /* those that are known at the last place, by rising ratio */
};

/* climb_function of struct weakest: its variables are those of a place (explorer.h). */
int weakest_at(const double x[], struct climb_piece piece[], void *weakest);

/* Whether the design that is set is free of shimmy in all cases. */
int weakest_is_free(const struct weakest *w);

/* The box of the design that is set. */
struct box_at weakest_box(const struct explorer *e);

/* Climbs to the largest least ratio from x[], in a box of half-width `radius` at first, with more
 * corners as they are found; x[] becomes its place, which is set.  Returns the ratio, or -INFINITY:
 * none at x[]. */
double weakest_top(struct weakest *w, double x[], double radius, int *asked);

/* The largest t at which some design near x[] is free of shimmy, looked for from t on, where put()
 * sets a case to t: the top of the least ratio at one t, then at the t which that design bears or at
 * which the ratio, as it falls, would be 0, until t does not grow.  x[] becomes its design.  0: the
 * ratio is below 0 at the t one begins with. */
double weakest_most(struct weakest *w, void put(struct weakest *w, double t), double x[], double t, int *asked);

#endif
