/* matrix.h - the state matrix of the linearised gear with its device, for the oracle
 *
 * States delta, delta', psi, psi', lambda (of lambda_L = lambda_R; their difference decays at
 * -V/l), the twist of the damper and, if b > 0, the twist of the inerter and its rate.  Where
 * the inerter is beside the damper, their twist is one state.
 */
#ifndef MATRIX_H
#define MATRIX_H

#include <stdbool.h>

#include "oracle.h"

enum {
  MOST = 8,   /* states */
  WORK = 512, /* doubles of workspace for LAPACK */
  LAMBDA = 4
};

static const double oracle_rigid = 1e29; /* a k_s from here on does not give */

/* A = A0 + V A1 + theta A2 by columns, A[row + MOST * column]; times in units of time,
 * torques in k_psi, lambda in l.  theta is 1/c_d or c_d, V in l/time. */
struct matrix {
  int n;
  int row;                    /* the one that theta is in; -1: none, a limit of c_d */
  bool parallel;              /* theta is c_d */
  bool spins;                 /* V is in rows beside LAMBDA's, too */
  double A0[MOST * MOST], A1[MOST * MOST], A2[MOST * MOST];
  double time, c_unit, V_top;
};

/* What becomes of the damper: part of the model, or one of the limits of c_d. */
enum damper { MOVES, FREE, LOCKED };

struct matrix matrix_of(enum oracle_layout layout, const struct oracle_gear *gear, enum damper damper);

/* theta at x = ln(c_d / c_unit) */
double theta_of(const struct matrix *m, double x);

/* A into its first m->n rows and columns. */
void matrix_at(const struct matrix *m, double V, double theta, double A[MOST * MOST]);

/* Eigenvalues; false where LAPACK finds none. */
bool matrix_eigenvalues(const struct matrix *m, double V, double theta, double re[MOST], double im[MOST]);

/* NaN where LAPACK finds none. */
double largest_real_part(const struct matrix *m, double V, double theta);

#endif
