/* mlg.h - the dual-wheel main landing gear (MLG) and its tyres
 *
 * Equations of Li, Howcroft, Neild and Jiang, "Using continuation analysis to
 * identify shimmy-suppression devices for an aircraft main landing gear",
 * J. Sound Vib. 408 (2017) 234-251; equation numbers in brackets are theirs.
 * The printed appendix carries misprints; what stands here is derived from
 * Eqs (1)-(24) and (31), and docs/model.md lists every deviation once.
 *
 * SI units and radians throughout.  Header only: a layout file includes it
 * and adds its device (see l1.c), so that AUTO's own commands build a layout
 * without knowing anything of this project.
 *
 * docs/drawings/gear.svg shows it from three sides.
 *
 *                B  (strut, rake phi)          seen from behind
 *                |\                               B
 *         l_delta| \ zeta                         |) delta   bending
 *                |  \                             |
 *                C---                        L ===C=== R     a: track width
 *              e (caster), psi: torsion      lambda_L  lambda_R
 *   --> V      R: tyre radius                (tyre deflections at the
 *                                             leading contact points)
 */
#ifndef MLG_H
#define MLG_H

#include <math.h>
#include <string.h>

#include "network.h"

/* Parameters: AUTO's PAR(slot).  Slots 10 to 14 belong to AUTO (PAR(11) is the
 * period, PAR(12) the torus angle).  Those above 36 have to be 0 by default, which
 * is what AUTO takes for them from an older solution that has only 36.  The name is the one in parnames of every
 * constants file.  The value is the default; those of the gear are Table 1
 * with the two values its rounding hides (phi, M; docs/model.md), and
 * constants/gear.printed holds the two as printed.
 *   least, most: the physical range, wide enough for any gear; a value outside
 *   it is a slip, and near 1e300 AUTO would compute without end. */
#define MLG_PARAMETERS(X)                                                      \
  /* slot id       name       unit           value  least  most       meaning */ \
  X( 1, V,       "V",       "m/s",            1.0,    0., 1e3,       "forward speed")       \
  X( 2, C_D,     "c_d",     "N m s/rad",    3.6e4,    0., 1e9,       "device damping")      \
  X( 3, K_S,     "k_s",     "N m/rad",  MLG_RIGID,    1., INFINITY,  "device series stiffness") \
  X( 4, B,       "b",       "N m s^2/rad",    0.0,    0., 1e9,       "device inertance")    \
  X( 5, K_D,     "k_d",     "N m/rad",     1.09e5,    1., 1e12,      "device stiffness")    \
  X( 6, K_PSI,   "k_psi",   "N m/rad",      3.8e5,    1., 1e12,      "torsional stiffness of the torque links") \
  X( 7, C_PSI,   "c_psi",   "N m s/rad",    300.0,    0., 1e9,       "torsional damping of the wheel assembly") \
  X( 8, K_DELTA, "k_delta", "N m/rad",      6.1e6,    1., 1e12,      "lateral stiffness of the strut") \
  X( 9, C_DELTA, "c_delta", "N m s/rad",    300.0,    0., 1e9,       "lateral damping of the strut") \
  X(15, A,       "a",       "m",              0.5,  1e-3, 100.,      "track width")         \
  X(16, E,       "e",       "m",             0.12, -100., 100.,      "caster length")       \
  X(17, L_DELTA, "l_delta", "m",             0.75,  1e-3, 100.,      "radius of lateral bending, B to C") \
  X(18, L_D,     "l_D",     "m",             0.72,  1e-3, 100.,      "distance from B to the centre of gravity D") \
  X(19, M_D,     "m_D",     "kg",           500.0,  1e-3, 1e6,       "mass of the bending part") \
  X(20, J_XI,    "J_xi",    "kg m^2",       200.0,  1e-6, 1e9,       "moment of inertia at D, axis xi") \
  X(21, J_ETA,   "J_eta",   "kg m^2",       250.0,  1e-6, 1e9,       "moment of inertia at D, axis eta") \
  X(22, J_ZETA,  "J_zeta",  "kg m^2",       100.0,  1e-6, 1e9,       "moment of inertia at D, axis zeta") \
  X(23, PHI,     "phi",     "rad",   MLG_PI / 60.,  -1.5, 1.5,       "rake angle") \
  X(24, H,       "h",       "m",              0.1,  1e-3, 100.,      "half of the contact patch length") \
  X(25, K_T,     "k_t",     "N/m",          7.0e5,    1., 1e12,      "tyre vertical stiffness") \
  X(26, K_ALPHA, "k_alpha", "m",              1.0,    0., 1e3,       "tyre self-aligning coefficient") \
  X(27, K_LAMBDA,"k_lambda","1/rad",        0.002,    0., 1e3,       "tyre restoring coefficient") \
  X(28, L,       "l",       "m",              0.3,  1e-3, 100.,      "relaxation length")   \
  X(29, R,       "R",       "m",            0.362,  1e-3, 100.,      "tyre unloaded radius") \
  X(30, ALPHA_M, "alpha_m", "rad",         0.1745,  1e-3, 1.5,       "maximum slip angle")  \
  X(31, G,       "g",       "m/s^2",         9.81,  1e-3, 1e3,       "gravitational constant") \
  X(32, M,       "M",       "kg", 200e3/9.81-500.,    0., 1e6,       "mass above B: the load is (M + m_D) g") \
  /* laws of elements.h: play, friction, orifice, relief valve, hardening springs */      \
  X(37, G_PSI,   "g_psi",   "rad",            0.0,    0., 1.,        "half-width of the play of the torque links") \
  X(38, G_S,     "g_s",     "rad",            0.0,    0., 1.,        "half-width of the play of k_s") \
  X(39, CORNER,  "corner",  "-",              0.0,    0., 10.,       "width of the rounded corners of play and relief over g or T_max; 0: sharp") \
  X(40, T_F,     "T_f",     "N m",            0.0,    0., 1e6,       "friction of the damper") \
  X(41, T_PSI,   "T_psi",   "N m",            0.0,    0., 1e6,       "friction of the wheel assembly") \
  X(42, V_F,     "v_f",     "rad/s",          0.0,    0., 1e3,       "speed scale of friction: it is T tanh(v / v_f)") \
  X(43, C_2,     "c_2",     "N m s^2/rad^2",  0.0,    0., 1e9,       "quadratic damping of the device, of an orifice") \
  X(44, T_MAX,   "T_max",   "N m",            0.0,    0., 1e9,       "torque at which the damper's relief valve opens; 0: it has none") \
  X(45, C_R,     "c_r",     "N m s/rad",      0.0,    0., 1e9,       "damping of the open relief valve") \
  X(46, K_S3,    "k_s3",    "N m/rad^3",      0.0,    0., 1e15,      "cubic stiffness of k_s") \
  X(47, K_D3,    "k_d3",    "N m/rad^3",      0.0,    0., 1e15,      "cubic stiffness of k_d") \
  /* Choices in the model that the paper's results hang on (docs/doubts.md): 0 is the
   * paper, 1 the other one, between them a blend; I_p is an inertia. */         \
  X(48, ZB_SHARED, "zB_shared", "-",          0.0,    0., 1.,        "1: one zB'' for both wheels in F_z, the mean") \
  X(49, R_MOVES,  "R_moves", "-",             0.0,    0., 1.,        "1: R_i differentiated in the ground contact") \
  X(50, HEADING,  "heading", "-",             0.0,    0., 1.,        "1: theta with the term -delta sin(phi)") \
  X(51, I_P,      "I_p",     "kg m^2",        0.0,    0., 1e6,       "polar inertia of the wheels, both together") \
  X(52, N12_OUT,  "N12_out", "-",             0.0,    0., 1.,        "1: F_z without N12_z delta''")

/* Results that pvls computes at every point; list them in ICP to see them. */
#define MLG_RESULTS(X)                                                         \
  /* slot id          name          unit  meaning */                           \
  X(33, PSI_MAX,    "psi_max",    "deg", "maximum of psi over the period")     \
  X(34, DSTAR_MAX,  "dstar_max",  "m",   "maximum of delta* = l_delta delta over the period") \
  X(35, TORUS,      "torus",      "-",   "largest |mu| - 1 of the complex Floquet multipliers") \
  X(36, F_Z,        "F_z",        "N",   "static load (M + m_D) g")           \
  X(53, HOPF_PSI,   "hopf_psi",   "1/s", "real part of the eigenvalues of psi-shimmy nearest to 0: 0 at its Hopf points") \
  X(54, HOPF_DELTA, "hopf_delta", "1/s", "the same of delta-shimmy") \
  X(55, CLOSES,     "closes",     "-",   "passes upwards through 0 where a Hopf curve comes round to its start")

/* How long par[] is: AUTO's NPAR, which every constants file gives (AUTO itself has room
 * for 36), and that of the problem of boundary.h. */
enum { MLG_SLOTS = 55, MLG_BOUNDARY_SLOTS = 85 };

#define MLG_PI 3.14159265358979323846
#define MLG_V_TOP 200. /* top of the operating range, m/s, unless V_top says another */
#define MLG_RIGID 1e30 /* a stiffness that does not give: its compliance is 0 to rounding */

/* PAR_V, PAR_C_D, ...: indices into par[], C's counting of AUTO's slots. */
enum mlg_slot {
#define X(slot, id, name, unit, value, least, most, meaning) PAR_##id = (slot) - 1,
  MLG_PARAMETERS(X)
#undef X
#define X(slot, id, name, unit, meaning) PAR_##id = (slot) - 1,
  MLG_RESULTS(X)
#undef X
  PAR_PERIOD = 11 - 1 /* AUTO's */
};

#define X(slot, ...) _Static_assert((slot) <= MLG_SLOTS, "par[] is long enough");
MLG_PARAMETERS(X)
MLG_RESULTS(X)
#undef X

/* A row of the table above; slot counts from 0, as in par[]. */
struct mlg_parameter { int slot; const char *name, *unit; double least, most; };

static const struct mlg_parameter mlg_parameters[] = {
#define X(slot, id, name, unit, value, least, most, meaning) { PAR_##id, name, unit, least, most },
  MLG_PARAMETERS(X)
#undef X
};

enum { MLG_PARAMETER_COUNT = sizeof mlg_parameters / sizeof *mlg_parameters };

/* The parameter whose name is the first length characters of name, or NULL. */
static inline const struct mlg_parameter *mlg_find(const char *name, size_t length)
{
  for (int i = 0; i < MLG_PARAMETER_COUNT; i++)
    if (strlen(mlg_parameters[i].name) == length && memcmp(mlg_parameters[i].name, name, length) == 0)
      return &mlg_parameters[i];
  return NULL;
}

/* Not-a-number is outside every range. */
static inline int mlg_in_range(const struct mlg_parameter *p, double value)
{
  return value >= p->least && value <= p->most;
}

/* States of the gear. */
#define MLG_GEAR_STATES(X)                                                     \
  /* id       name        unit     meaning */                                  \
  X(DELTA,    "delta",    "rad",   "bending angle of the strut")               \
  X(DDELTA,   "ddelta",   "rad/s", "its rate")                                 \
  X(PSI,      "psi",      "rad",   "torsion angle of the wheel assembly")      \
  X(DPSI,     "dpsi",     "rad/s", "its rate")                                 \
  X(LAMBDA_L, "lambda_L", "m",     "lateral deflection of the left tyre at its leading point") \
  X(LAMBDA_R, "lambda_R", "m",     "lateral deflection of the right tyre at its leading point")

/* All states of a layout, which names those of its device in DEVICE_STATES. */
#define MLG_STATES(X) MLG_GEAR_STATES(X) DEVICE_STATES(X)

/* Numbers states in an enum: DELTA = 0, DDELTA, ... */
#define MLG_NUMBERED(id, name, unit, meaning) id,

enum mlg_state { MLG_GEAR_STATES(MLG_NUMBERED) GEAR_STATES };

/* The verified parameters of the paper into par[MLG_SLOTS]; results and AUTO's slots
 * are left alone. */
static inline void mlg_defaults(double par[])
{
#define X(slot, id, name, unit, value, least, most, meaning) par[PAR_##id] = (value);
  MLG_PARAMETERS(X)
#undef X
}

/* Of an oscillation whose amplitudes, rad, have this ratio: the square root of the kinetic energy
 * of the lateral bending, J_xi + m_D l_D^2 about B, over that of the torsion, J_zeta.  Above 1
 * it is called delta-shimmy, below psi-shimmy.  The larger angle would be another name for
 * most of a heavy or long gear's delta modes, which bend little (docs/model.md). */
static inline double mlg_energy_ratio(const double par[], double delta_over_psi)
{
  return delta_over_psi * sqrt((par[PAR_J_XI] + par[PAR_M_D] * par[PAR_L_D] * par[PAR_L_D]) / par[PAR_J_ZETA]);
}

#include "elements.h"

/* Self-aligning moment per vertical force, m (26). */
static inline double mlg_self_aligning(const double par[], double lambda)
{
  const double alpha_m = par[PAR_ALPHA_M];
  const double alpha = atan(lambda / par[PAR_L]);

  if (fabs(alpha) > alpha_m)
    return 0.;
  return par[PAR_K_ALPHA] * alpha_m / MLG_PI * sin(alpha * MLG_PI / alpha_m);
}

/* Lateral force per vertical force (25). */
static inline double mlg_restoring(const double par[], double lambda)
{
  const double t = atan(7. * lambda / par[PAR_L]); /* tan(alpha) = lambda / l */

  return par[PAR_K_LAMBDA] * t * cos(0.95 * t);
}

/* What both wheels share of the position and speed of the gear. */
struct mlg_pose {
  double s, c;                     /* sin phi, cos phi */
  double sin_delta, cos_delta, sin_psi, cos_psi;
  double sin_theta, cos_theta;     /* heading of the wheels, theta (14) */
  double dtheta;                   /* its rate, rad/s */
  double mu;                       /* roll of the axle (16), rad */
};

static inline struct mlg_pose mlg_pose(const double par[], const double u[])
{
  struct mlg_pose p = {
    .s = sin(par[PAR_PHI]), .c = cos(par[PAR_PHI]),
    .sin_delta = sin(u[DELTA]), .cos_delta = cos(u[DELTA]),
    .sin_psi = sin(u[PSI]), .cos_psi = cos(u[PSI]),
  };
  const double bent = par[PAR_HEADING] * p.s; /* doubt: theta turns with -delta sin(phi) too */
  const double theta = u[PSI] * p.c * p.cos_delta - bent * u[DELTA];

  p.sin_theta = sin(theta);
  p.cos_theta = cos(theta);
  p.dtheta = p.c * (u[DPSI] * p.cos_delta - u[PSI] * p.sin_delta * u[DDELTA]) - bent * u[DDELTA];
  /* the argument is a component of a unit vector: only rounding can carry it past 1 */
  p.mu = asin(fmax(-1., fmin(1., p.s * p.sin_psi + p.c * p.sin_delta * p.cos_psi)));
  return p;
}

/* Ground contact of one wheel.  Its vertical force F_z depends on the
 * accelerations: F_z = F_0 + F_delta delta'' + F_psi psi''; and so does zB''. */
struct mlg_contact {
  double x_delta, y_delta, z_delta; /* d(contact point)/d delta, m/rad */
  double x_psi, y_psi, z_psi;       /* d(contact point)/d psi, m/rad */
  double zB_delta, zB_psi, ddzB;    /* zB'' = zB_delta delta'' + zB_psi psi'' + ddzB, m/s^2 */
  double F_0, F_delta, F_psi;       /* N, N s^2/rad, N s^2/rad */
  double Q_delta, Q_psi;            /* generalised force per F_z, N_5 of (32), (33), m */
};

/* Doubt: adds to the wheel's zB'' what R_i (19) does there when it is differentiated too,
 * z_R R'' + 2 (dz_R/dt) R', times R_moves. */
static inline void mlg_moving_radius(const double par[], const double u[], const struct mlg_pose *p,
                                     double side, struct mlg_contact *w)
{
  const double s = p->s, c = p->c, ddelta = u[DDELTA], dpsi = u[DPSI];
  /* n = sin(mu) and its derivatives; cos(mu) is 0 where the axle stands upright */
  const double n = p->s * p->sin_psi + p->c * p->sin_delta * p->cos_psi;
  const double n_delta = c * p->cos_delta * p->cos_psi;
  const double n_psi = s * p->cos_psi - c * p->sin_delta * p->sin_psi;
  const double dn = n_delta * ddelta + n_psi * dpsi;
  const double ddn = -c * p->sin_delta * p->cos_psi * ddelta * ddelta
                     - 2. * c * p->cos_delta * p->sin_psi * ddelta * dpsi - n * dpsi * dpsi;
  const double cos_mu = fmax(1e-6, sqrt(fmax(0., 1. - n * n)));
  const double R_mu = -0.1 * side * par[PAR_A];
  /* dz/dR_i */
  const double z_R = s * s * p->cos_psi + c * (c * p->cos_delta - s * p->sin_delta * p->sin_psi);
  const double dz_R = -(c * c * p->sin_delta + s * c * p->cos_delta * p->sin_psi) * ddelta
                      - s * (s * p->sin_psi + c * p->sin_delta * p->cos_psi) * dpsi;
  const double factor = par[PAR_R_MOVES] * R_mu / cos_mu;

  w->zB_delta += factor * z_R * n_delta;
  w->zB_psi += factor * z_R * n_psi;
  w->ddzB += factor * (z_R * (ddn + n * dn * dn / (cos_mu * cos_mu)) + 2. * dz_R * dn);
}

/* Kinematics and generalised forces of a wheel: all of the contact but F_z.  side = -1
 * left, +1 right; lambda is that tyre's deflection. */
static inline struct mlg_contact mlg_contact(const double par[], const double u[],
                                             const struct mlg_pose *p, double side, double lambda)
{
  const double a = par[PAR_A], e = par[PAR_E], l_delta = par[PAR_L_DELTA], R = par[PAR_R];
  const double ddelta = u[DDELTA], dpsi = u[DPSI];
  const double s = p->s, c = p->c, sin_delta = p->sin_delta, cos_delta = p->cos_delta;
  const double sin_theta = p->sin_theta, cos_theta = p->cos_theta;
  struct mlg_contact w;

  /* The contact point (18) is Q E1 + P E2 + Z E3 on axes that bend with delta
   * but do not turn with psi: E1 = (c, 0, -s), E2 = (s sin, cos, c sin)(delta),
   * E3 = (s cos, -sin, c cos)(delta); H of (6) is these turned by psi.  Hence
   * dE2/d delta = E3, dE3/d delta = -E2, dQ/d psi = -P, dP/d psi = Q.  R_i is
   * held in these derivatives. */
  const double d = side * a * p->mu / 2.; /* tyre deflection */
  const double R_i = R - 0.2 * d;         /* (19) */
  const double X = -(e + R_i * s), Y = side * a / 2., Z = l_delta + R_i * c;
  const double P = X * p->sin_psi + Y * p->cos_psi;
  const double Q = X * p->cos_psi - Y * p->sin_psi;

  w.x_delta = s * (P * cos_delta - Z * sin_delta);
  w.y_delta = -P * sin_delta - Z * cos_delta;
  w.z_delta = c * (P * cos_delta - Z * sin_delta);
  w.x_psi = Q * s * sin_delta - P * c;
  w.y_psi = Q * cos_delta;
  w.z_psi = Q * c * sin_delta + P * s;

  /* ground contact (23), (24), differentiated in time */
  const double z_delta_delta = -c * (P * sin_delta + Z * cos_delta);
  const double z_delta_psi = c * Q * cos_delta;
  const double z_psi_psi = Q * s - P * c * sin_delta;
  w.zB_delta = w.z_delta;
  w.zB_psi = w.z_psi;
  w.ddzB = z_delta_delta * ddelta * ddelta + 2. * z_delta_psi * ddelta * dpsi
           + z_psi_psi * dpsi * dpsi;
  if (par[PAR_R_MOVES] != 0.)
    mlg_moving_radius(par, u, p, side, &w);

  /* tyre forces (14), (17) along delta and psi (21) */
  const double Lambda = mlg_restoring(par, lambda);
  const double C = mlg_self_aligning(par, lambda);
  w.Q_delta = Lambda * (sin_theta * w.x_delta - cos_theta * w.y_delta) + w.z_delta - C * s;
  w.Q_psi = Lambda * (sin_theta * w.x_psi - cos_theta * w.y_psi) + w.z_psi + C * c * cos_delta;
  return w;
}

/* Vertical force (34)-(36) of a wheel, its term N12_z delta'' kept; other is the other
 * wheel, whose zB'' counts as much as its own when zB'' is shared. */
static inline void mlg_vertical_force(const double par[], const double u[], const struct mlg_pose *p,
                                      double side, struct mlg_contact *w, const struct mlg_contact *other)
{
  const double a = par[PAR_A], l_D = par[PAR_L_D], m_D = par[PAR_M_D], ddelta = u[DDELTA];
  const double c = p->c, half = 0.5 * par[PAR_ZB_SHARED]; /* doubt */
  const double zB_delta = w->zB_delta + half * (other->zB_delta - w->zB_delta);
  const double zB_psi = w->zB_psi + half * (other->zB_psi - w->zB_psi);
  const double ddzB = w->ddzB + half * (other->ddzB - w->ddzB);

  w->F_0 = 0.5 * (side * a * p->mu * par[PAR_K_T] + m_D * ddzB
                  + m_D * l_D * c * p->cos_delta * ddelta * ddelta + (m_D + par[PAR_M]) * par[PAR_G]);
  w->F_delta = 0.5 * m_D * (zB_delta + (1. - par[PAR_N12_OUT]) * l_D * c * p->sin_delta);
  w->F_psi = 0.5 * m_D * zB_psi;
}

/* Rate of a tyre's deflection, m/s: stretched string (31). */
static inline double mlg_stretched_string(const double par[], const double u[],
                                          const struct mlg_pose *p, const struct mlg_contact *w,
                                          double lambda)
{
  const double v_X = par[PAR_V] + w->x_delta * u[DDELTA] + w->x_psi * u[DPSI];
  const double v_Y = w->y_delta * u[DDELTA] + w->y_psi * u[DPSI];
  const double slope = lambda / par[PAR_L];

  return v_X * (p->sin_theta - slope * p->cos_theta) - v_Y * (p->cos_theta + slope * p->sin_theta)
         - (par[PAR_H] - slope * lambda) * p->dtheta;
}

/* Time derivatives of the gear's states, du[DELTA] to du[LAMBDA_R], when the
 * device takes the torque T_d (N m) from the wheels: (31)-(36). */
static inline void mlg_gear(const double par[], const double u[], double T_d, double du[])
{
  const double l_D = par[PAR_L_D], m_D = par[PAR_M_D], J_eta = par[PAR_J_ETA];
  const double J_skew = par[PAR_J_XI] - J_eta;
  const double ddelta = u[DDELTA], dpsi = u[DPSI];
  const struct mlg_pose p = mlg_pose(par, u);
  struct mlg_contact wheel[2] = {
    mlg_contact(par, u, &p, -1., u[LAMBDA_L]),
    mlg_contact(par, u, &p, +1., u[LAMBDA_R]),
  };
  const double N12 = m_D * l_D * p.c * p.sin_delta;
  /* doubt: the wheels, with V/R about their axle, turn psi' into a moment on delta and back */
  const double spin = par[PAR_I_P] * par[PAR_V] / par[PAR_R] * p.cos_psi;

  mlg_vertical_force(par, u, &p, -1., &wheel[0], &wheel[1]);
  mlg_vertical_force(par, u, &p, +1., &wheel[1], &wheel[0]);

  /* (32) and (33) as M11 delta'' + M12 psi'' = b1, M21 delta'' + M22 psi'' = b2;
   * zB'' in (32) is the mean of the two wheels' */
  double M11 = J_eta + J_skew * p.cos_psi * p.cos_psi + m_D * l_D * l_D, M12 = 0.;
  double M21 = 0., M22 = par[PAR_J_ZETA];
  double b1 = 2. * J_skew * p.cos_psi * p.sin_psi * ddelta * dpsi - par[PAR_C_DELTA] * ddelta
              - par[PAR_K_DELTA] * u[DELTA] - l_D * m_D * par[PAR_G] * p.sin_delta * p.c
              - spin * dpsi;
  double b2 = -J_skew * p.cos_psi * p.sin_psi * ddelta * ddelta - par[PAR_C_PSI] * dpsi - T_d + spin * ddelta;

  for (int i = 0; i < 2; i++) {
    const struct mlg_contact *w = &wheel[i];

    M11 += 0.5 * N12 * w->zB_delta + w->F_delta * w->Q_delta;
    M12 += 0.5 * N12 * w->zB_psi + w->F_psi * w->Q_delta;
    M21 += w->F_delta * w->Q_psi;
    M22 += w->F_psi * w->Q_psi;
    b1 -= 0.5 * N12 * w->ddzB + w->F_0 * w->Q_delta;
    b2 -= w->F_0 * w->Q_psi;
  }
  const double det = M11 * M22 - M12 * M21;

  du[DELTA] = ddelta;
  du[DDELTA] = (M22 * b1 - M12 * b2) / det;
  du[PSI] = dpsi;
  du[DPSI] = (M11 * b2 - M21 * b1) / det;
  du[LAMBDA_L] = mlg_stretched_string(par, u, &p, &wheel[0], u[LAMBDA_L]);
  du[LAMBDA_R] = mlg_stretched_string(par, u, &p, &wheel[1], u[LAMBDA_R]);
}

#endif
