/* box.h - a design whose parameters lie within +-p of their values; private to libmlg */
#ifndef LIBMLG_BOX_H
#define LIBMLG_BOX_H

#include "layout.h"
#include "part.h"

enum { BOX_ELEMENTS = 4 };

struct box_at {
  int layout;
  const double *par; /* of libmlg */
  const struct libmlg_box *box;
  double V_least, V_top;
  struct part *element[BOX_ELEMENTS]; /* NAME=VALUE of a network that vary as well; their values are as before when a call returns */
  int elements;
};

/* How many things vary: bit i of a corner is that of box->parameter[i], those above of element[]. */
static inline int box_sides(const struct box_at *d)
{
  return d->box->n + d->elements;
}

/* par[], and the elements, with side i at its value and part[i] of it more; box_back() takes the elements
 * back to own[]. */
void box_to(const struct box_at *d, const double part[], double par[], double own[BOX_ELEMENTS]);
void box_back(const struct box_at *d, const double own[BOX_ELEMENTS]);

/* part[] of a corner of the box of size p. */
void box_corner(const struct box_at *d, unsigned corner, double p, double part[LIBMLG_MOST_SIDES]);

/* Whether that corner of the box of size p is free of shimmy. */
int box_is_free(const struct box_at *d, unsigned corner, double p);

/* The size at which a corner that shimmies at p begins to, as p grows from 0. */
double box_begins(const struct box_at *d, unsigned corner, double p);

/* The two corners at which, to first order, a bound of the interval that c_d lies in comes
 * to c_d first, elements at their lower ends; returns 2, or 0: it lies in none. */
int box_first_corners(const struct box_at *d, unsigned corner[2]);

/* libmlg_tolerance(), elements and all: at most LIBMLG_MOST_SIDES vary. */
int box_tolerance(const struct box_at *d, struct libmlg_tolerance *t);

/* Corners are tested at these parts of p, for one that is free at p need not be so below. */
enum { BOX_PARTS = 4 };

static inline double box_part(int i)
{
  return 1. - (double)i / BOX_PARTS;
}

#endif
