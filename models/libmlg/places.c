/* places.c - where a search over k_s looks; see places.h */
#include <math.h>
#include <string.h>

#include "places.h"

static const double ratio_most = 1.1, stiffest = 2000., softest = 0.02; /* of k_s; of k_psi */

double libmlg_place_k_s(double k_psi, double u, double rigid)
{
  return u > 0. ? k_psi * (1. / fmin(u, PLACES_SOFTEST) - 1.) : rigid;
}

static double place_of(double k_s)
{
  return 1. / (1. + k_s);
}

/* A text may have inertances by value, so that every text counts as one with an inerter. */
static int has_inertance(int layout, const double par[])
{
  const int b = libmlg_parameter("b");

  return layout >= libmlg_layouts() || (libmlg_uses(layout, b) == 1 && par[b] > 0.);
}

int libmlg_places(int layout, const double par[], int equal, double u[])
{
  const int close = has_inertance(layout, par);
  int n = 0;

  u[n++] = 0.;
  if (libmlg_uses(layout, libmlg_parameter("k_s")) != 1)
    return n;
  for (int i = 0; i < equal; i++) {
    const double right = i + 1 < equal ? (double)(i + 1) / equal : PLACES_SOFTEST;
    const double from = fmin(1. / fmax(u[n - 1], 1e-12) - 1., stiffest), to = fmax(1. / right - 1., softest);
    const int parts = close && from > to ? (int)ceil(log(from / to) / log(ratio_most)) : 0;

    for (int k = from < stiffest ? 1 : 0; k < parts && n < PLACES_MOST; k++)
      u[n++] = place_of(from * pow(to / from, (double)k / parts));
    if (n < PLACES_MOST)
      u[n++] = right;
  }
  return n;
}

int devices_begin(struct devices *d, int layout, const double par[], double b_least, double b_most)
{
  *d = (struct devices){ .layout = layout, .k_s = libmlg_parameter("k_s"), .b = libmlg_parameter("b"), .b_least = b_least,
                         .b_most = b_most };
  if (libmlg_uses(layout, d->k_s) < 0)
    return LIBMLG_NONE;
  d->over_k_s = libmlg_uses(layout, d->k_s) == 1;
  d->over_b = libmlg_uses(layout, d->b) == 1 && b_most > b_least;
  memcpy(d->par, par, (size_t)libmlg_parameters() * sizeof *par);
  d->k_psi = par[libmlg_parameter("k_psi")];
  if (libmlg_uses(layout, d->b) == 1)
    d->par[d->b] = b_least;
  return 0;
}

void devices_put(struct devices *d, double u, double v)
{
  if (d->over_k_s)
    d->par[d->k_s] = libmlg_place_k_s(d->k_psi, u, INFINITY);
  if (d->over_b)
    d->par[d->b] = d->b_least + v * (d->b_most - d->b_least);
}
