/* unitline.h - the units of an answer's columns, as the command's comments say them */
#ifndef MLG_UNITLINE_H
#define MLG_UNITLINE_H

#include <stdbool.h>

#include "description.h"
#include "text.h"

/* Adds "NAME UNIT; NAME UNIT" for the columns that a question keeps, by their names in the
 * table, as far as what the command printed says their units: lines such as
 * "# psi_least, psi_most deg; frequency_hz Hz" above the names.  What is called as a parameter
 * or a result of models/mlg.h has its unit anyway; where the description has a line names,
 * that says them.  OUTPUT stays as it is.  False: the names are not printed (yet). */
bool read_unit_line(const struct step *step, const char *output, struct text *units);

#endif
