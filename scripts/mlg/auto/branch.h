/* branch.h - what may be said of the points of a branch
 *
 * AUTO writes a sign, a type and a count whether it computed them or not.  These
 * functions say what it looked for, and nothing where it did not.
 */
#ifndef MLG_BRANCH_H
#define MLG_BRANCH_H

#include "autofile.h"

/* What a part's run follows. */
int is_orbits(const struct af_part *part);        /* periodic solutions in one parameter */
int is_straight(const struct af_part *part);      /* equilibria in one parameter */
int is_curve(const struct af_part *part);         /* points of bifurcation in two */

/* The name of a point's type: AUTO's, but HH for a ZH that is a double Hopf point: two
 * pairs of eigenvalues on the imaginary axis and off zero.  AUTO calls any change of
 * the number of stable eigenvalues on a Hopf curve ZH. */
const char *point_type(const struct af_branches *all, const struct af_part *part, long point);

/* 1 stable, 0 unstable, -1 not known: AUTO computed none (ISP = 0, curves of
 * bifurcation points, the first point of a branch of orbits), or the multiplier that
 * decides lies within AUTO's tolerance of the unit circle, 1e-5.  Near 1 it is told by the
 * points that follow, up to the next fold or branch point. */
int point_stability(const struct af_branches *all, const struct af_part *part, long point);

/* Whether none of an orbit's multipliers, the trivial one left aside, lies within AUTO's
 * tolerance of the unit circle: its number of stable ones means something. */
int multipliers_are_clear(const struct af_branches *all, const struct af_point *point);

/* Whether the run looked for points of a type ("HB"). */
int looks_for(const struct af_constants *constants, const char *type);

/* The types that are asked of a run of this kind, "BP HB". */
const char *types_of(const struct af_part *part);

/* Column that measures the size of an orbit, or -1. */
int size_column(const struct af_part *part);

#endif
