/* oracle.h - zero-shimmy intervals of c_d from dense eigenvalues, without the library
 *
 * An oracle for libmlg_intervals().  It shares no code and no method with it: the
 * gear's linearised equations are written down here once more, the device is solved
 * as a network of forces and twists (no polynomial, no impedance), and nothing but
 * dense eigenvalue problems decides.  oracle.c says how.
 *
 * A gear shimmies at c_d if straight rolling has an eigenvalue with a real part above
 * 0 at some speed 0 < V < V_top.  A zero-shimmy interval is a longest interval of c_d
 * in (0, infinity) without shimmy.  SI units and radians, or any other consistent
 * units of force, time and length: all is made dimensionless by the gear itself.
 *
 * Link -llapacke -llapack -lm.
 */
#ifndef ORACLE_H
#define ORACLE_H

#include <stdbool.h>

/* Parameters of the gear and of its device, by the names of the field; V and c_d are
 * not among them. */
#define ORACLE_PARAMETERS(X)                                                    \
  X(k_s) X(b) X(k_d) X(k_psi) X(c_psi) X(k_delta) X(c_delta)                    \
  X(a) X(e) X(l_delta) X(l_D) X(m_D) X(J_xi) X(J_eta) X(J_zeta) X(phi) X(h)     \
  X(k_t) X(k_alpha) X(k_lambda) X(l) X(R) X(g) X(M)

struct oracle_gear {
#define X(name) double name;
  ORACLE_PARAMETERS(X)
#undef X
  double V_top; /* the speeds are 0 < V < V_top */
  double zB_shared, R_moves, heading, I_p; /* doubts, 0 in the paper (docs/doubts.md) */
};

enum oracle_parameter {
#define X(name) ORACLE_##name,
  ORACLE_PARAMETERS(X)
#undef X
  ORACLE_PARAMETER_COUNT
};

extern const char *const oracle_name[ORACLE_PARAMETER_COUNT];

/* A parameter by its number. */
double *oracle_at(struct oracle_gear *gear, int parameter);

/* The paper's gear with k_s rigid, b = 0 and V_top = 200 m/s. */
struct oracle_gear oracle_paper(void);

/* Layouts, in the order of oracle_layout_name[]. */
enum oracle_layout { ORACLE_L1, ORACLE_L2, ORACLE_LI1, ORACLE_LI2, ORACLE_LI3, ORACLE_LI4, ORACLE_LI5, ORACLE_LI6, ORACLE_LI7,
                     ORACLE_LAYOUTS };

extern const char *const oracle_layout_name[ORACLE_LAYOUTS];

/* What an end of an interval is. */
enum oracle_end {
  ORACLE_FOLD,  /* c_d is extreme along a Hopf curve */
  ORACLE_AT_0,  /* a Hopf curve leaves through V = 0 */
  ORACLE_AT_TOP, /* or through V = V_top */
  ORACLE_OPEN   /* c_d = 0 or infinity */
};

extern const char *const oracle_end_name[4];

struct oracle_interval {
  double c[2];            /* its ends, N m s/rad: 0 and INFINITY possible */
  double V[2];            /* speeds at which shimmy sets in there, m/s; NaN where open */
  double error[2];        /* estimated relative error of an end */
  enum oracle_end end[2];
};

enum { ORACLE_MOST = 32 };

struct oracle_answer {
  bool divergence;        /* a real eigenvalue above 0, at every V and c_d: no interval */
  int intervals;
  struct oracle_interval interval[ORACLE_MOST]; /* by rising c_d */
  int unresolved;         /* cells of c_d, 1e-9 wide, of which it cannot say what is inside */
  double unresolved_c;    /* one of them */
  double near_miss;       /* the narrowest interval or gap between two, in ln c_d */
  int evaluations;        /* eigenvalue problems at a c_d or a V */
};

/* All zero-shimmy intervals. */
struct oracle_answer oracle_intervals(enum oracle_layout layout, const struct oracle_gear *gear);

/* The same between two values of c_d and on a grid of this many steps before refinement:
 * looks again, and closer, at what one side claims.  Intervals are cut at c_lo and c_hi. */
struct oracle_answer oracle_examine(enum oracle_layout layout, const struct oracle_gear *gear,
                                    double c_lo, double c_hi, int steps);

/* Is there shimmy at c_d?  Exact in V: every speed at which two eigenvalues add to 0 comes
 * from one eigenvalue problem.  Not to be asked of a divergent gear. */
bool oracle_shimmy(enum oracle_layout layout, const struct oracle_gear *gear, double c_d);

/* A real eigenvalue above 0 (divergence): its sign hangs neither on V nor on c_d.
 * *margin, unless NULL, is the static determinant over the sum of its terms' sizes. */
bool oracle_diverges(enum oracle_layout layout, const struct oracle_gear *gear, double *margin);

/* --- brute force: the same answers from samples of V alone -------------------------- */

/* Largest real part over V, 1/s, from steps samples of V, each local maximum refined.  The
 * mode that is neutral at V = 0 counts as its slope there, so that a stable gear is below 0
 * by a margin.  *V is where it is. */
double oracle_growth(enum oracle_layout layout, const struct oracle_gear *gear, double c_d,
                     int steps, double *V);

/* Real parts (1/s) and imaginary parts (rad/s) of all eigenvalues but that of
 * lambda_L - lambda_R, -V/l.  Returns how many, at most 8. */
int oracle_eigenvalues(enum oracle_layout layout, const struct oracle_gear *gear, double c_d,
                       double V, double re[8], double im[8]);

#endif
