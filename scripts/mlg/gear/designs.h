/* designs.h - what the commands about loads, elasticities and tolerances share */
#ifndef MLG_DESIGNS_H
#define MLG_DESIGNS_H

#include "arguments.h"

/* Of the intervals of c_d at the parameters of a the one around its c_d if that was given,
 * otherwise the widest, in whose middle c_d is put: twice lo where it has no end, and where
 * every c_d is free, the best damped one over V_least < V; 0: there is none. */
bool take_interval(struct arguments *a, double V_least, struct libmlg_interval *interval);

/* "F_z", or the name of a parameter; its unit. */
const char *quantity_name(int parameter);
const char *quantity_unit(int parameter);

/* What grows first, or is damped least: V m/s and "psi" or "delta" of the least damping ratio
 * at the c_d of par[]; false: a real root. */
bool least_mode(const struct arguments *a, const double par[], double V_least, struct libmlg_mode *mode);

/* The mode of a best c_d of par[] with its ratio: there two are often damped alike, and of psi and delta
 * the latter is shown, not the one that rounding chooses. */
struct libmlg_mode shown_mode(const struct arguments *a, const double par[], double V_least, const struct libmlg_ratio *best);

/* Refuses V, which is no parameter of a design, and V_least not below V_top. */
void check_speeds(const struct arguments *a, double V_least);

/* "inf" for a rigid k_s. */
double shown_k_s(double k_s);

#endif
