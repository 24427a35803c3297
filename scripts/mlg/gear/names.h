/* names.h - how boundary points are named in tables */
#ifndef MLG_NAMES_H
#define MLG_NAMES_H

#include "libmlg.h"

/* "min", "max", "V_least", "V_top", "hopf", "none" (c_d of 0 or infinity) */
const char *kind_name(enum libmlg_kind kind);

/* "delta" or "psi", what an oscillation with this ratio of amplitudes is called */
const char *shimmy_name(const double par[], double delta_over_psi);

/* "onset", "equal", ...: see `mlg help widest` */
const char *limit_name(enum libmlg_limit limit);

/* A number of points that libmlg returned; one that says an error ends the program. */
int checked(const char *command, int n);

#endif
