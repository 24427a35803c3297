/* gearfile.h - files of gear parameters: PAR = {'name': value unit, ...}
 *
 * As constants/gear.printed: one constant PAR of AUTO's, a unit behind a value as a
 * check, comments from # or ! to the end of a line.
 */
#ifndef MLG_GEARFILE_H
#define MLG_GEARFILE_H

#include "libmlg.h"

struct gear_value {
  int parameter; /* its number in libmlg */
  double value;
  int line;
};

struct gear {
  int n;
  struct gear_value value[LIBMLG_MOST_PARAMETERS];
};

/* The values of a file, each within its range.  A slip ends the program with one line
 * "FILE:LINE: what, and what would be right" and status 2. */
struct gear read_gear(const char *file);

#endif
