/* box.h - a design whose parameters lie within +-p of their values; private to libmlg */
#ifndef LIBMLG_BOX_H
#define LIBMLG_BOX_H

#include "layout.h"

struct box_at {
  int layout;
  const double *par; /* of libmlg */
  const struct libmlg_box *box;
  double V_least, V_top;
};

/* Whether that corner of the box of size p is free of shimmy. */
int box_is_free(const struct box_at *d, unsigned corner, double p);

/* The size at which a corner that shimmies at p begins to, as p grows from 0. */
double box_begins(const struct box_at *d, unsigned corner, double p);

/* The two corners at which, to first order, a bound of the interval that c_d lies in comes
 * to c_d first; returns 2, or 0: it lies in none. */
int box_first_corners(const struct box_at *d, unsigned corner[2]);

/* Corners are tested at these parts of p, for one that is free at p need not be so below. */
enum { BOX_PARTS = 4 };

static inline double box_part(int i)
{
  return 1. - (double)i / BOX_PARTS;
}

#endif
