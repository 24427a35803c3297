/* tolerance.c - within which tolerance of its parameters a design is free of shimmy
 *
 * All n parameters lie within +-p of their values at once; the corners of that box, 2^n, are
 * tested each, exactly (libmlg_is_free).  One that fails at p is followed down to where it
 * begins to fail, which is the p that the others are tested at from then on: with the corner
 * that fails first found first, by the slopes of the bounds of c_d, all others cost one test.
 */
#include <math.h>
#include <string.h>

#include "box.h"

void libmlg_box_of(int layout, const double par[], struct libmlg_box *box)
{
  static const char *const of_gear[] = { "k_t", "e", "l", "h", "k_lambda", "k_alpha", "c_delta", "c_psi", "k_delta", "k_psi", "c_d" };
  const int k_s = libmlg_parameter("k_s"), b = libmlg_parameter("b");

  box->n = 0;
  box->parameter[box->n++] = LIBMLG_F_Z;
  for (size_t i = 0; i < sizeof of_gear / sizeof *of_gear; i++)
    box->parameter[box->n++] = libmlg_parameter(of_gear[i]);
  if (libmlg_uses(layout, k_s) == 1 && par[k_s] < MLG_RIGID)
    box->parameter[box->n++] = k_s;
  if (libmlg_uses(layout, b) == 1 && par[b] > 0.)
    box->parameter[box->n++] = b;
}

void libmlg_corner(const double par[], const struct libmlg_box *box, unsigned corner, double p, double out[])
{
  memcpy(out, par, (size_t)libmlg_parameters() * sizeof *par);
  for (int i = 0; i < box->n; i++) {
    const double value = libmlg_value(par, box->parameter[i]);

    libmlg_set(out, box->parameter[i], value + (corner >> i & 1u ? p : -p) * value);
  }
}

void box_to(const struct box_at *d, const double part[], double par[], double own[BOX_ELEMENTS])
{
  memcpy(par, d->par, (size_t)libmlg_parameters() * sizeof *par);
  for (int i = 0; i < d->box->n; i++) {
    const double value = libmlg_value(d->par, d->box->parameter[i]);

    libmlg_set(par, d->box->parameter[i], value + part[i] * value);
  }
  for (int i = 0; i < d->elements; i++) {
    own[i] = d->element[i]->value;
    d->element[i]->value += part[d->box->n + i] * own[i];
  }
}

void box_back(const struct box_at *d, const double own[BOX_ELEMENTS])
{
  for (int i = 0; i < d->elements; i++)
    d->element[i]->value = own[i];
}

void box_corner(const struct box_at *d, unsigned corner, double p, double part[LIBMLG_MOST_SIDES])
{
  for (int i = 0; i < box_sides(d); i++)
    part[i] = corner >> i & 1u ? p : -p;
}

int box_is_free(const struct box_at *d, unsigned corner, double p)
{
  double par[LIBMLG_MOST_PARAMETERS], part[LIBMLG_MOST_SIDES], own[BOX_ELEMENTS];
  int is_free;

  box_corner(d, corner, p, part);
  box_to(d, part, par, own);
  is_free = libmlg_is_free(d->layout, par, 0., d->V_least, d->V_top) == 1;
  box_back(d, own);
  return is_free;
}

double box_begins(const struct box_at *d, unsigned corner, double p)
{
  double lo = 0., hi = p;

  while (hi - lo > 1e-13 * hi) {
    const double middle = 0.5 * (lo + hi);

    if (!(middle > lo && middle < hi))
      break;
    if (box_is_free(d, corner, middle))
      lo = middle;
    else
      hi = middle;
  }
  return hi;
}

/* The corner at which the bound of c_d comes nearest to c_d, to first order. */
static unsigned predicted(const struct box_at *d, const struct libmlg_point *bound, double side)
{
  const int c_d = libmlg_parameter("c_d");
  unsigned corner = 0;

  for (int i = 0; i < d->box->n; i++) {
    double slope = 0.;

    if (d->box->parameter[i] == c_d)
      slope = -1.;
    else
      libmlg_point_slope(d->layout, d->par, 0., bound, d->box->parameter[i], &slope);
    if (slope * libmlg_value(d->par, d->box->parameter[i]) * side > 0.)
      corner |= 1u << i;
  }
  return corner;
}

int box_first_corners(const struct box_at *d, unsigned corner[2])
{
  struct libmlg_interval interval[LIBMLG_MOST_POINTS];
  const double c_d = d->par[libmlg_parameter("c_d")];
  const int n = libmlg_intervals(d->layout, d->par, 0., d->V_least, d->V_top, interval, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n; i++)
    if (interval[i].lo.c_d < c_d && c_d < interval[i].hi.c_d) {
      corner[0] = predicted(d, &interval[i].lo, 1.);
      corner[1] = predicted(d, &interval[i].hi, -1.);
      return 2;
    }
  return 0;
}

int box_tolerance(const struct box_at *d, struct libmlg_tolerance *t)
{
  const double below = 1. - 1e-9;
  unsigned first[2] = { 0, 0 };

  if (!libmlg_find(d->layout) || d->box->n < 1 || box_sides(d) > LIBMLG_MOST_SIDES
      || libmlg_is_free(d->layout, d->par, 0., d->V_least, d->V_top) < 0)
    return LIBMLG_NONE;
  *t = (struct libmlg_tolerance){ .p = 0. };
  if (!box_is_free(d, 0, 0.))
    return 0;
  t->p = LIBMLG_MOST_TOLERANCE;
  t->bounded = 0;
  for (int i = 0, n = box_first_corners(d, first); i < n; i++)
    if (!box_is_free(d, first[i], t->p)) {
      t->corner = first[i];
      t->p = box_begins(d, first[i], t->p);
      t->bounded = 1;
    }
  /* until a whole round finds none that fails earlier */
  for (int again = 1; again;) {
    again = 0;
    for (unsigned corner = 0; corner < 1u << box_sides(d); corner++)
      for (int i = 0; i < BOX_PARTS; i++)
        if (!box_is_free(d, corner, below * box_part(i) * t->p)) {
          t->p = box_begins(d, corner, below * box_part(i) * t->p);
          t->corner = corner;
          t->bounded = again = 1;
        }
  }
  return 0;
}

int libmlg_tolerance(int layout, const double par[], const struct libmlg_box *box, double V_least, double V_top,
                     struct libmlg_tolerance *t)
{
  return box_tolerance(&(struct box_at){ .layout = layout, .par = par, .box = box, .V_least = V_least, .V_top = V_top }, t);
}
