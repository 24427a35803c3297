/* units.h - units of the columns of AUTO's files by their names */
#ifndef MLG_UNITS_H
#define MLG_UNITS_H

#include "text.h"

/* A result of models/mlg.h by its name, or NULL. */
struct result { const char *name, *unit, *meaning; };
const struct result *result_of(const char *name);

/* "m/s" for "V", "rad" for "MAX psi"; NULL for a name that is not known.  Parameters and
 * results of models/mlg.h, states of every layout, results of models/boundary.h. */
const char *unit_of(const char *name);

/* "V m/s; c_d N m s/rad" of those names that have a unit. */
void add_units(struct text *text, char *const name[], int n);

#endif
