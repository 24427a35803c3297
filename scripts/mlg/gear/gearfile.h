/* gearfile.h - files of gear parameters: PAR = {'name': value unit, ...}
 *
 * As constants/gear.printed: one constant PAR of AUTO's, a unit behind a value as a
 * check, comments from # or ! to the end of a line.  F_z, N, may stand in the place of M; a
 * rigid k_s is inf.  The one reader of them, for commands and for constants files.
 */
#ifndef MLG_GEARFILE_H
#define MLG_GEARFILE_H

#include "libmlg.h"
#include "text.h"

enum { GEAR_TEXT = 80 };

struct gear_value {
  int parameter; /* its number in libmlg, or LIBMLG_F_Z */
  const char *name;
  double value;
  char text[GEAR_TEXT]; /* the number as written */
  int line;
};

struct gear {
  int n;
  struct gear_value value[LIBMLG_MOST_PARAMETERS];
};

/* The values of a file, each within its range.  Returns 0, or -1 with one line
 * "FILE:LINE: what, and what would be right" in why. */
int read_gear(const char *file, struct gear *gear, struct text *why);

#endif
