/* mode.h - a mode of straight rolling at one speed, followed as parameters change; private to
 * libmlg and the commands
 *
 * Where a damping ratio is least over V its slope along V is 0, or an end of the range holds V: by
 * any parameter the least ratio moves, to first order, as the ratio of the same mode at the same
 * speed.  To follow it takes a few steps of Newton's method, microseconds, in place of a search over
 * all modes and V.
 */
#ifndef LIBMLG_MODE_H
#define LIBMLG_MODE_H

#include "layout.h"

struct mode_at { double V, zeta; double _Complex s; }; /* m/s, -, rad/s, above the axis */

/* The mode of the least damping ratio over V_least < V < V_top.  Returns as libmlg_least_ratio,
 * and LIBMLG_FAILED where a real eigenvalue is the least. */
int mode_least(int layout, const double par[], double V_least, double V_top, struct mode_at *mode);

/* Follows it to other parameters, near those at which it was found: *mode becomes what it is at the
 * speed near its own at which its ratio is least.  Returns 0 or LIBMLG_FAILED: it was lost. */
int mode_follow(int layout, const double par[], double V_least, double V_top, struct mode_at *mode);

/* Its damping ratio at other parameters and its own speed.  NaN: it was lost. */
double mode_ratio(int layout, const double par[], const struct mode_at *mode);

#endif
