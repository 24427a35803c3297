/* best_ratio.h - the least damping ratio and its best c_d from what is known nearby; private to
 * models/libmlg
 */
#ifndef LIBMLG_BEST_RATIO_H
#define LIBMLG_BEST_RATIO_H

#include "crossing.h"

/* V_least = 0 is a limit, at which a root is 0: a speed a little above. */
double best_ratio_V_least(double V_least, double V_top);

/* libmlg_least_ratio, sooner with a speed, m/s, near where the least is; 0: none is known. */
int libmlg_least_ratio_from(int layout, const double par[], double V_least, double V_top, double guess,
                            struct libmlg_ratio *least);

/* libmlg_best_c_d from *best, a c_d of par[] with its least ratio. */
int libmlg_best_c_d_from(int layout, const double par[], double V_least, double V_top, struct libmlg_ratio *best);

#endif
