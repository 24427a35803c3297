/* best_damped.h - parts of the search for the best damped device; private to models/libmlg */
#ifndef LIBMLG_BEST_DAMPED_H
#define LIBMLG_BEST_DAMPED_H

#include "libmlg.h"

/* Whether a device with b_least <= b <= b_most has a ratio above 0: 1 or 0, by the grid and a climb of
 * libmlg_best_damped; *best is one that has, or the best that was found. */
int best_damped_is_free(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                        struct libmlg_ratio *best);

/* The best device near the k_s, b and c_d of *best, by a climb from there. */
void best_damped_near(int layout, const double par[], double b_least, double b_most, double V_least, double V_top,
                      struct libmlg_ratio *best);

#endif
