/* gear.h - the gear's equations compiled by themselves, gear.c
 *
 * They are the same for every layout, and most of what there is to compile.
 */
#ifndef MLG_GEAR_H
#define MLG_GEAR_H

struct mlg_slopes;

/* mlg_gear() of mlg.h and mlg_slopes() of jacobian.h. */
void mlg_gear_apart(const double par[], const double u[], double T_d, double du[]);
void mlg_slopes_apart(const double par[], const double u[], const double f[], int parameters,
                      struct mlg_slopes *E);

#endif
