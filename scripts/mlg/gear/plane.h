/* plane.h - what the commands about the (V, c_d) plane share */
#ifndef MLG_PLANE_H
#define MLG_PLANE_H

#include "arguments.h"

/* psi or delta, what a Hopf curve bounds: at its first extremum, or halfway. */
const char *shimmy_of_curve(const struct arguments *a, const struct libmlg_curve *curve);

/* The c_d, N m s/rad, at which the damper is as stiff as k_d where the wheels turn on k_psi:
 * a device's own scale, whatever the gear. */
double scale_of_c_d(const struct arguments *a);

#endif
