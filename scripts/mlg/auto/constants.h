/* constants.h - checks an AUTO constants file and hands over values
 *
 * AUTO passes over many slips in silence.  Here an unknown or repeated constant, a
 * name that parnames or unames lacks, a parameter under a wrong slot or outside its
 * range (models/mlg.h), one that the layout's device does not have, a value of a form
 * that AUTO does not read, or with which it would never end, give one line
 * "FILE:LINE: what, and what would be right", and nothing else.  NPAR, room for the
 * model's parameters, is added where the file does not give it.
 */
#ifndef MLG_CONSTANTS_H
#define MLG_CONSTANTS_H

#include "text.h"

/* What a constants file is to be used for. */
struct constants_use {
  const char *layout; /* "l1": NDIM and the device's parameters are checked; or NULL */
  int boundary;       /* the algebraic problem of that layout, with unknowns of its own */
  int starts;         /* it starts from another run's solution, which has its own gear */
};

/* Reads file and puts in the words, each
 *   NAME=VALUE     an AUTO constant or a parameter; F_z stands for the M with that load,
 *                  k_s=inf for a rigid one
 *   PAR={...}      parameters, beside those of the file
 *   gear=FILE      the parameters of a gear, which may have their units behind them
 *   layout=LAYOUT  makes a file of another layout one of that layout
 * Words go before a gear, a gear before the file; none is given twice.  Adds the file as
 * AUTO reads it to out, a constant a line.  Returns 0, or 2 with a line in why. */
int hand_over(const char *file, char *const words[], int n, const struct constants_use *use, struct text *out,
              struct text *why);

#endif
