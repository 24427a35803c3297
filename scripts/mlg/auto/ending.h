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

#endif
