/* places.h - where a search over k_s looks; private to models/libmlg
 *
 * The place of a spring is u = 1 / (1 + k_s/k_psi): 0 is rigid, 1 without stiffness.
 */
#ifndef LIBMLG_PLACES_H
#define LIBMLG_PLACES_H

#include "libmlg.h"

enum { PLACES_MOST = 512 };

/* The softest spring that is looked at, 1e-6 k_psi. */
#define PLACES_SOFTEST (1. / (1. + 1e-6))

/* k_s at u, N m/rad; `rigid` at 0. */
double libmlg_place_k_s(double k_psi, double u, double rigid);

/* The nodes of a search, rising u[PLACES_MOST] from 0 to PLACES_SOFTEST; how many.  They are
 * `equal` equal steps; where the device has an inertance, which with k_s is in resonance within
 * a narrow range of k_s, k_s changes by no more than a tenth from node to node as well, from 0.02 to
 * 2000 k_psi.  One node, 0, where the device has no k_s. */
int libmlg_places(int layout, const double par[], int equal, double u[]);

/* The devices of a search: k_s at the place u, and b at v, b_least at 0 and b_most at 1; what the
 * layout does not have, and b where it has no range, stays as in par[]. */
struct devices {
  int layout, k_s, b;   /* numbers of these parameters */
  int over_k_s, over_b; /* what the search goes over */
  double par[LIBMLG_MOST_PARAMETERS], k_psi, b_least, b_most;
};

/* 0, or LIBMLG_NONE: no such layout. */
int devices_begin(struct devices *d, int layout, const double par[], double b_least, double b_most);

/* Puts k_s and b into d->par; a spring at u = 0 is INFINITY. */
void devices_put(struct devices *d, double u, double v);

#endif
