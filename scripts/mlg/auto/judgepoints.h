/* judgepoints.h - what the judge finds along the points of a branch; private to it */
#ifndef MLG_JUDGEPOINTS_H
#define MLG_JUDGEPOINTS_H

#include "autofile.h"
#include "judge.h"

/* Adds a complaint. */
void complain(struct judgement *out, const char *text);

/* Each looks at the first `points` points of a part and complains of
 *   stability  a change of the number of stable eigenvalues without a label
 *   folds      a fold without a label, or a label LP without one
 *   ranges     a parameter of the gear that left its range
 *   curve      a curve of bifurcations of orbits that goes on where the orbit vanished */
void check_stability(const struct af_branches *all, struct judgement *out, const struct af_part *part, long points);
void check_folds(struct judgement *out, const struct af_part *part, long points);
void check_ranges(struct judgement *out, const struct af_part *part, long points);
void check_curve(struct judgement *out, const struct af_part *part);

/* Of a straight run: a Hopf point that the equations have and AUTO has not.  s, layout as for
 * find_ending. */
void check_hopf_points(struct judgement *out, const struct af_part *part, const char *s, const char *layout);

/* Whether a Hopf curve was stopped where it closes; a complaint when that is not its start. */
int closes(const struct af_part *part);
void check_closing(struct judgement *out, const struct af_part *part);

#endif
