/* crossing_parts.h - what the files of crossing.h share; private to them
 *
 * Polynomials are arrays of CROSSING_TERMS coefficients, the constant first.
 */
#ifndef LIBMLG_CROSSING_PARTS_H
#define LIBMLG_CROSSING_PARTS_H

#include "crossing.h"

enum { T = CROSSING_TERMS, NEWTON_STEPS = 30 };

/* What lies below or above these, in units of struct crossing, is 0 or infinite to
 * rounding: frequencies beyond a million times the gear's own, and a damper of less
 * than 1e-7 or more than 1e9 times the usual one. */
#define T_LEAST 1e-40
#define T_MOST 1e12
#define C_LEAST 1e-7
#define C_MOST 1e9

/* p, p', p'' at t. */
struct value { double p, d, dd; };

/* alpha = a00 + a01 c and so on, with their derivatives by t; slope: the part by c. */
struct parts { struct value alpha, gamma, beta, eta, alpha_c, gamma_c, beta_c, eta_c; };

/* G = alpha eta - gamma beta and its derivatives, each from its factors: the expanded
 * coefficients have lost digits.  size: of the terms of G. */
struct jet_of_G { double G, t, c, tt, tc, size, size_t_; };

int crossing_degree(const double p[T]);

/* sign p q, added to r; what would lie beyond T terms is 0 for any layout. */
void crossing_add_product(double r[T], double sign, const double p[T], const double q[T]);

/* G = A c^2 + B c + C. */
void crossing_quadratic(const struct crossing *x, double A[T], double B[T], double C[T]);

struct value crossing_value(const double p[T], int n, double t); /* of degree n */
struct parts crossing_parts(const struct crossing *x, double t, double c);
struct jet_of_G crossing_jet(const struct parts *f);

/* V from whichever of the two parts of F divides by the larger. */
double crossing_speed(const struct parts *f);

/* Eigenvalues of the companion matrix of p[0..n], p[n] != 0, n <= 2 T; LAPACK's return
 * value. */
int crossing_companion(const double p[], int n, double re[], double im[]);

/* (1 + mu)^k (1 - mu)^(m - k): t = (1 + mu)/(1 - mu) takes 0 < t < infinity to -1 < mu < 1,
 * so that no root is at infinity and none is favoured. */
void crossing_moebius(const double p[], int m, double out[]);

/* What crossing.h says of crossings_at_c() and so on, for a gear whose wheels spin. */
int spin_crossings_at_c(const struct crossing *x, double c, double V_least, double V_top, struct crossing_at out[]);
int spin_extrema(const struct crossing *x, double V_least, double V_top, struct crossing_at out[], int most);
int spin_extremum_near(const struct crossing *x, struct crossing_at *p); /* from its V, too */
double spin_sine(const struct crossing *x, const struct crossing_at *p);
double spin_slope(const struct crossing *x, const struct crossing_at *p);
double spin_curvature(const struct crossing *x, const struct crossing_at *p);

#endif
