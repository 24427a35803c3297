/* crossing.h - where an eigenvalue of straight rolling crosses a ray; private to libmlg
 *
 * F(s; V, c_d) of characteristic.h is bilinear in V and c = c_d.  On the ray of the
 * damping ratio zeta, s = omega (-zeta + i sqrt(1 - zeta^2)),
 *
 *   F = (a00 + a10 V + a01 c + a11 V c) + i q (b00 + b10 V + b01 c + b11 V c),
 *
 * real polynomials a, b in t and a positive factor q: t = omega^2 for zeta = 0 (Hopf
 * points), else t = omega.  Without V it is one condition, quadratic in c:
 *
 *   G(t, c) = (a00 + a01 c)(b10 + b11 c) - (a10 + a11 c)(b00 + b01 c) = 0.
 *
 * Its roots t > 0 at one c are all crossings at that c, each with its V.  Where in
 * addition G_t = 0, c has an extremum along the curve.  All in units of the gear's own
 * (struct crossing), so that the answers do not hang on those of the user.
 */
#ifndef LIBMLG_CROSSING_H
#define LIBMLG_CROSSING_H

#include "layout.h"

enum { CROSSING_TERMS = 24, CROSSING_SPEEDS = 4 };

struct crossing {
  double zeta;
  double omega_unit, V_unit, c_unit; /* rad/s, m/s, N m s/rad */
  int squared;                       /* t is the square of omega / omega_unit */
  int order;                         /* degree of F in s */
  int degree;                        /* of G in t */
  int speeds;                        /* of F in V: 1, or 3 with I_p */
  double F[CROSSING_SPEEDS][2][CROSSING_TERMS]; /* F[v][k][i] belongs to V^v c^k s^i */
  double a[CROSSING_SPEEDS][2][CROSSING_TERMS], b[CROSSING_SPEEDS][2][CROSSING_TERMS];
};

/* One crossing, in the units of struct crossing. */
struct crossing_at { double t, V, c; };

/* F of the layout at par[] (AUTO's slots); its V and c_d do not matter. */
struct crossing crossing_of(const struct libmlg_layout *layout, const double par[], double zeta);

/* The same F on the ray of another damping ratio. */
struct crossing crossing_on(const struct crossing *x, double zeta);

/* The roots t > 0 of G at one c with V_least < V < V_top, at most CROSSING_TERMS;
 * returns their number. */
int crossings_at_c(const struct crossing *x, double c, double V_least, double V_top,
                   struct crossing_at out[]);

/* The same at one V, for c > 0. */
int crossings_at_V(const struct crossing *x, double V, struct crossing_at out[]);

/* Sorts crossings by rising V, or by rising c. */
void crossings_by_V(struct crossing_at at[], int n);
void crossings_by_c(struct crossing_at at[], int n);

/* Both roots c of G at one t, [0] with + sqrt(D), [1] with -, each with its V; D < 0: none
 * is real and both are the real part.  Along t each goes on smoothly. */
double crossings_at_t(const struct crossing *x, double t, struct crossing_at out[2]);

/* The roots t > 0 of D: where the curves turn back in t, at most 2 CROSSING_TERMS. */
int crossing_folds(const struct crossing *x, double t[]);

/* Sine of the angle between F_omega and F_V, 0 where c has an extremum along the curve. */
double crossing_sine(const struct crossing *x, const struct crossing_at *p);

/* All extrema of c along the curves, with c > 0 and V_least < V < V_top; at most `most`
 * of them into out[], returns their number. */
int crossing_extrema(const struct crossing *x, double V_least, double V_top,
                     struct crossing_at out[], int most);

/* Newton's method for such an extremum from the t and c of *p; 1: *p is one, to rounding. */
int crossing_extremum_near(const struct crossing *x, struct crossing_at *p);

/* Whether two of them are one, found twice: beside an antiresonance c has 7 digits.  A
 * least and a largest c are two, however near. */
int crossing_same(const struct crossing *x, const struct crossing_at *p, const struct crossing_at *q);

/* Second derivative of c by t at an extremum: > 0 where c is least. */
double crossing_curvature(const struct crossing *x, const struct crossing_at *p);

/* dV/dc at fixed zeta where the curve passes p. */
double crossing_slope(const struct crossing *x, const struct crossing_at *p);

/* omega in rad/s of a crossing. */
double crossing_omega(const struct crossing *x, double t);

/* The roots of F at one V and c (units of struct crossing) into re[], im[]; returns
 * their number, x->order or less where leading terms vanish, -1: LAPACK failed. */
int crossing_roots(const struct crossing *x, double V, double c, double re[], double im[]);

/* The least damping ratio of these roots, -1 with a positive real one; NaN: LAPACK failed. */
double crossing_ratio(const struct crossing *x, double V, double c);

#endif
