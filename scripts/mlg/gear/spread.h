/* spread.h - files that say how parameters of a gear spread
 *
 * One parameter a line, comments from # to the end of the line:
 *
 *   k_t   normal   7.0e5  3.5e4     mean and standard deviation, in SI units
 *   F_z   uniform  180e3  210e3     from, to
 *   c_d   uniform  -10%   10%       of the design's own value
 *   e     normal   0%     5%
 */
#ifndef MLG_SPREAD_H
#define MLG_SPREAD_H

#include <stdbool.h>
#include <stdint.h>

#include "arguments.h"

struct spread {
  int parameter; /* or LIBMLG_F_Z */
  bool normal;
  double a, b;   /* from, to; mean, standard deviation */
};

enum { MOST_SPREADS = LIBMLG_MOST_PARAMETERS + 1 };

/* The spreads of a file around the design of the arguments; their number.  A slip ends the
 * program with one line "FILE:LINE: what, and what would be right" and status 2. */
int read_spreads(const char *file, const struct arguments *a, struct spread spread[MOST_SPREADS]);

/* A generator of random numbers: any seed but 0 begins another sequence. */
struct random { uint64_t state; };

/* Draws all parameters into par[]; what lies outside a parameter's range is drawn again. */
void draw_spreads(struct random *r, const struct spread spread[], int n, double par[]);

#endif
