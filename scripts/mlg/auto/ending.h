/* ending.h - where a branch of orbits ends
 *
 * A branch of shimmy begins at a Hopf point of straight rolling and ends at another.
 * AUTO does not know that: it turns round and retraces the branch, or goes on along
 * the zero solution.  The end is checked against the eigenvalues of straight rolling:
 * without a Hopf point there, of that frequency, nothing is called closed and nothing
 * is cut off.
 */
#ifndef MLG_ENDING_H
#define MLG_ENDING_H

#include "autofile.h"
#include "libmlg.h"

struct ending {
  long kept;      /* points up to the closing Hopf point; all of them when not closed */
  int closed;     /* whether the branch closes */
  double value;   /* of the first parameter at the closing Hopf point */
  double period;  /* of its oscillation, s */
  long fell;      /* the point from which on AUTO followed the zero solution, or -1 */
  double re, im;  /* there, if fell >= 0 and known: the eigenvalue of straight rolling, 1/s,
                     nearest to the oscillation that went; else NaN */
};

/* The ending of a part that is_orbits; that of any other has all points.  s: AUTO's s.
 * file, or NULL; from a solution of the part come the parameters that are no columns.
 * layout: the name of the layout, or NULL for any that has these states.  A branch
 * whose layout or parameters are not known is not called closed. */
struct ending find_ending(const struct af_part *part, const char *s, const char *layout);

/* Straight rolling near a branch. */
struct rolling {
  double par[LIBMLG_MOST_PARAMETERS]; /* all but the one that is continued */
  int layout[64], layouts;            /* that may be the branch's */
  int parameter;                      /* libmlg's number of the one that is continued */
};

/* That of a part, from one of its solutions in s.; arguments as above.  0 when it is not known. */
int find_rolling(struct rolling *rolling, const struct af_part *part, const char *s, const char *layout);

#endif
