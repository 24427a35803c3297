/* autofile.h - reads what AUTO-07p writes: b. (branches), d. (stability), s. (solutions)
 *
 * Of AUTO 0.9.2 and of its later versions, of its shell commands (@sv, @ap: several
 * runs one after the other in a file) and of its Python interface, which writes the
 * same form.  A file that is cut, garbled or holds a zero byte gives one line,
 * "FILE:LINE: what", and nothing else: never half a table.
 *
 * A b. file becomes parts: a part begins with each line of column names, so that all
 * its points have the same columns and come from the same run.  AUTO writes the number
 * of a point modulo 9999; here it counts on.
 */
#ifndef MLG_AUTOFILE_H
#define MLG_AUTOFILE_H

#include "text.h"

/* Constants of a run, from the head of its part; as AUTO used them, not as they were
 * asked for, where these differ. */
struct af_constants {
  int NDIM, IPS, ILP, ISP, ISW, IID, NPR;
  long NMX;
  double RL0, RL1, A0, A1; /* bounds of the first parameter and of the second column */
  char *SP;                /* "SP=['TR0']" as it stands there, or "" */
};

/* A point of a branch. */
struct af_point {
  int branch;          /* AUTO's number of the branch, its sign left out */
  long number;         /* of the point in its branch, from 1 */
  int type;            /* AUTO's number of its type, 0 for none; af_type_name */
  int label;           /* that of its solution in s., or 0 */
  int stable;          /* 1 yes, 0 no, by AUTO's sign of the point; says nothing where
                          AUTO computed no stability (judge.h, point_stability) */
  int stable_count;    /* number of stable eigenvalues or multipliers (d.), or -1 */
  int eigenvalues;     /* how many there are from d. */
  size_t eigenvalue;   /* the first of them in af_branches.eigenvalue: re, im, re, im, ... */
  long line;           /* in b. */
};

/* The points of one branch of one run. */
struct af_part {
  struct af_constants constants;
  int columns;
  char **column;       /* their names: "V", "L2-NORM", "MAX psi", "PAR(3)" */
  int parameters;      /* names of PAR(1), PAR(2), ... up to parameters; "" for none */
  char **parameter;
  int states;          /* names of U(1), U(2), ... up to states; "" for none */
  char **state;
  long points;
  struct af_point *point;
  double *value;       /* of column k at point i: value[i * columns + k] */
  long nan;            /* the line of the first value that is no number, or 0 */
  long gap;            /* the line before which a point is missing, or 0 */
};

struct af_branches {
  char *file;          /* as it was given */
  int parts;
  struct af_part *part;
  double *eigenvalue;
  int has_d;           /* whether d. was there and has anything about stability */
  int timed;           /* whether d. holds AUTO's "Total Time", or is empty */
};

/* Reads b, and d when it is not NULL and is there.  Returns 0, or -1 with one line in
 * why and *branches empty.  af_free ends both. */
int af_read(struct af_branches *branches, const char *b, const char *d, struct text *why);
void af_free(struct af_branches *branches);

/* Column of that name, or -1. */
int af_column(const struct af_part *part, const char *name);

/* Value of a column at a point; NaN for column -1. */
double af_value(const struct af_part *part, long point, int column);

/* AUTO's name of a type, "HB", "UZ", ...: "" for 0 and for 4, a point written because
 * of NPR, which is none of UZ (-4). */
const char *af_type_name(int type);

/* A solution in s.; its values are read when asked for. */
struct af_solution {
  int branch, type, label;
  long number;         /* AUTO's, modulo 9999 */
  long rows;           /* points of its mesh, 1 for an equilibrium */
  int row_length;      /* time from 0 to 1, then the states, AUTO's own behind them */
  int states;          /* of the model itself */
  int parameters;      /* PAR(1) to PAR(parameters) */
  size_t body;         /* where it begins in the text */
  long lines, line;    /* lines that follow the first; the first one's number */
};

struct af_solutions {
  char *file;
  int n;
  struct af_solution *solution;
  struct text text;
};

/* As af_read. */
int af_read_solutions(struct af_solutions *solutions, const char *s, struct text *why);
void af_free_solutions(struct af_solutions *solutions);

/* PAR(1) to PAR(parameters) into par[parameters].  Returns 0 or -1 with a line in why. */
int af_solution_parameters(const struct af_solutions *all, const struct af_solution *one, double par[],
                           struct text *why);

/* Its rows into value[rows * row_length].  Returns 0 or -1 with a line in why. */
int af_solution_rows(const struct af_solutions *all, const struct af_solution *one, double value[],
                     struct text *why);

/* The number that the first length characters are: C's and Fortran's writing,
 * 1.0d-1, 1.0-101, NaN, Infinity.  1, or 0 when they are none. */
int af_number(const char *text, size_t length, double *value);

/* Whether text is a finite number as AUTO reads it, 1.0d-1 too, and nothing else. */
int is_finite(const char *text, double *value);

/* Whether text is infinity: inf, Infinity. */
int is_infinite(const char *text);

#endif
