/* test_model.c - the gear and its tyres (models/mlg.h) against the paper's own
 * definitions: H of (6) written out, energies (2), (3), forces (13)-(17), (21)
 * and Lagrange's equation (1), none of which mlg.h contains.  Derivatives are
 * complex steps (exact to rounding) or differences of tenth order.
 */
#include <complex.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "mlg.h"
#include "numbers.h"

enum { SAMPLES = 500, SLOTS = MLG_SLOTS };

static int seed(void **state)
{
  (void)state;
  random_state = 20170408;
  return 0;
}

/* Every parameter off its default, so that none hides behind another. */
static void random_parameters(double par[])
{
  mlg_defaults(par);
#define X(slot, id, name, unit, value, least, most, meaning) par[PAR_##id] *= uniform(0.7, 1.3);
  MLG_PARAMETERS(X)
#undef X
  par[PAR_V] = uniform(0., 100.);
  par[PAR_PHI] = uniform(-0.3, 0.3);
}

/* The doubts between the paper and the other choice, and both ends of it. */
static void random_doubts(double par[], int sample)
{
  static const int choice[] = { PAR_ZB_SHARED, PAR_R_MOVES, PAR_HEADING, PAR_N12_OUT };

  for (int i = 0; i < 4; i++)
    par[choice[i]] = sample % 3 == 2 ? uniform(0., 1.) : (sample / 3) >> i & sample % 3;
  par[PAR_I_P] = sample % 3 ? uniform(0., 20.) : 0.;
}

/* Large angles, tyres on both sides of alpha_m. */
static void random_gear(double u[])
{
  u[DELTA] = uniform(-0.5, 0.5);
  u[PSI] = uniform(-1., 1.);
  u[DDELTA] = uniform(-5., 5.);
  u[DPSI] = uniform(-10., 10.);
  u[LAMBDA_L] = uniform(-0.08, 0.08);
  u[LAMBDA_R] = uniform(-0.08, 0.08);
}

/* ---- the paper's definitions ------------------------------------------- */

typedef double _Complex cplx;

static const double tiny = 1e-40; /* complex step */

/* (6) */
static void rotation(double phi, cplx delta, cplx psi, cplx H[3][3])
{
  H[0][0] = cos(phi) * ccos(psi) + sin(phi) * csin(delta) * csin(psi);
  H[0][1] = -cos(phi) * csin(psi) + sin(phi) * csin(delta) * ccos(psi);
  H[0][2] = sin(phi) * ccos(delta);
  H[1][0] = ccos(delta) * csin(psi);
  H[1][1] = ccos(delta) * ccos(psi);
  H[1][2] = -csin(delta);
  H[2][0] = -sin(phi) * ccos(psi) + cos(phi) * csin(delta) * csin(psi);
  H[2][1] = sin(phi) * csin(psi) + cos(phi) * csin(delta) * ccos(psi);
  H[2][2] = cos(phi) * ccos(delta);
}

/* (16) */
static double roll(const double par[], const double u[])
{
  return asin(sin(par[PAR_PHI]) * sin(u[PSI]) + cos(par[PAR_PHI]) * sin(u[DELTA]) * cos(u[PSI]));
}

/* (14), and with the doubt of the heading */
static cplx heading(const double par[], cplx delta, cplx psi)
{
  return psi * cos(par[PAR_PHI]) * ccos(delta) - par[PAR_HEADING] * sin(par[PAR_PHI]) * delta;
}

/* theta' at the state u, by a complex step along its rates. */
static double heading_rate(const double par[], const double u[])
{
  return cimag(heading(par, u[DELTA] + I * tiny * u[DDELTA], u[PSI] + I * tiny * u[DPSI])) / tiny;
}

/* (19) */
static double loaded_radius(const double par[], const double u[], int side)
{
  const double d = side * par[PAR_A] * roll(par, u) / 2.;

  return par[PAR_R] - 0.2 * d;
}

/* Contact point from B, (18) in global axes. */
static void contact_point(const double par[], cplx delta, cplx psi, int side, double R_i, cplx r[3])
{
  const double body[3] = { -(par[PAR_E] + R_i * sin(par[PAR_PHI])), side * par[PAR_A] / 2.,
                           par[PAR_L_DELTA] + R_i * cos(par[PAR_PHI]) };
  cplx H[3][3];

  rotation(par[PAR_PHI], delta, psi, H);
  for (int k = 0; k < 3; k++)
    r[k] = H[k][0] * body[0] + H[k][1] * body[1] + H[k][2] * body[2];
}

/* d(contact point)/d delta and /d psi, R_i held. */
static void contact_slopes(const double par[], const double u[], int side, double R_i,
                           double by_delta[3], double by_psi[3])
{
  cplx r[3];

  contact_point(par, u[DELTA] + I * tiny, u[PSI], side, R_i, r);
  for (int k = 0; k < 3; k++)
    by_delta[k] = cimag(r[k]) / tiny;
  contact_point(par, u[DELTA], u[PSI] + I * tiny, side, R_i, r);
  for (int k = 0; k < 3; k++)
    by_psi[k] = cimag(r[k]) / tiny;
}

/* z_B' from the constraint (23), (24) of one wheel. */
static double dzB_wheel(const double par[], const double u[], int side, double R_i)
{
  double by_delta[3], by_psi[3];

  contact_slopes(par, u, side, R_i, by_delta, by_psi);
  return by_delta[2] * u[DDELTA] + by_psi[2] * u[DPSI];
}

/* What R_i adds to it when it is differentiated too: d/dt z less the same with R_i held,
 * by a complex step along the rates. */
static double dzB_of_radius(const double par[], const double u[], int side)
{
  const cplx delta = u[DELTA] + I * tiny * u[DDELTA], psi = u[PSI] + I * tiny * u[DPSI];
  const cplx n = sin(par[PAR_PHI]) * csin(psi) + cos(par[PAR_PHI]) * csin(delta) * ccos(psi);
  const double dmu = cimag(n) / tiny / sqrt(1. - creal(n) * creal(n));
  cplx r[2][3];

  for (int k = 0; k < 2; k++) /* z is linear in R_i */
    contact_point(par, u[DELTA], u[PSI], side, k, r[k]);
  return creal(r[1][2] - r[0][2]) * -0.1 * side * par[PAR_A] * dmu;
}

/* z_B' of a wheel as the constraint has it: its own, with R_i as R_moves says. */
static double dzB_own(const double par[], const double u[], int side)
{
  return dzB_wheel(par, u, side, loaded_radius(par, u, side)) + par[PAR_R_MOVES] * dzB_of_radius(par, u, side);
}

static double dzB_mean(const double par[], const double u[])
{
  return (dzB_own(par, u, -1) + dzB_own(par, u, +1)) / 2.;
}

/* (10); psi' turns about the third body axis, column 3 of H. */
static void angular_velocities(double phi, cplx delta, cplx ddelta, cplx dpsi,
                               cplx omega_delta[3], cplx omega_psi[3])
{
  omega_delta[0] = ddelta * cos(phi);
  omega_delta[1] = 0.;
  omega_delta[2] = -ddelta * sin(phi);
  omega_psi[0] = dpsi * ccos(delta) * sin(phi);
  omega_psi[1] = -dpsi * csin(delta);
  omega_psi[2] = dpsi * cos(phi) * ccos(delta);
}

/* v_D of (9), seen from a frame that moves with the aircraft. */
static void velocity_D(const double par[], cplx delta, cplx ddelta, cplx dzB, cplx v[3])
{
  v[0] = -par[PAR_L_D] * sin(par[PAR_PHI]) * csin(delta) * ddelta;
  v[1] = -par[PAR_L_D] * ccos(delta) * ddelta;
  v[2] = -dzB - par[PAR_L_D] * cos(par[PAR_PHI]) * csin(delta) * ddelta;
}

/* (2), (11), (12) */
static cplx kinetic_energy(const double par[], cplx delta, cplx psi, cplx ddelta, cplx dpsi, cplx dzB)
{
  const double J_b[3] = { par[PAR_J_XI], par[PAR_J_ETA], par[PAR_J_ZETA] };
  cplx H[3][3], omega[2][3], v[3], T = 0.;

  rotation(par[PAR_PHI], delta, psi, H);
  angular_velocities(par[PAR_PHI], delta, ddelta, dpsi, omega[0], omega[1]);
  velocity_D(par, delta, ddelta, dzB, v);
  for (int k = 0; k < 3; k++)
    T += par[PAR_M_D] * v[k] * v[k] / 2.;
  for (int w = 0; w < 2; w++)
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) /* J^G = H J^b H^T */
          T += omega[w][i] * H[i][k] * J_b[k] * H[j][k] * omega[w][j] / 2.;
  return T;
}

/* Doubt: what the wheels that turn with -V/R about their axle, column 2 of H, add to T. */
static cplx spin_energy(const double par[], cplx delta, cplx psi, cplx ddelta, cplx dpsi)
{
  cplx H[3][3], omega[2][3], about = 0.;

  rotation(par[PAR_PHI], delta, psi, H);
  angular_velocities(par[PAR_PHI], delta, ddelta, dpsi, omega[0], omega[1]);
  for (int i = 0; i < 3; i++)
    about += H[i][1] * (omega[0][i] + omega[1][i]);
  return par[PAR_I_P] * -par[PAR_V] / par[PAR_R] * about;
}

static cplx whole_energy(const double par[], cplx delta, cplx psi, cplx ddelta, cplx dpsi, cplx dzB)
{
  return kinetic_energy(par, delta, psi, ddelta, dpsi, dzB) + spin_energy(par, delta, psi, ddelta, dpsi);
}

/* (25), in the form of its source: both arctangents stand outside the cosine */
static double restoring(const double par[], double lambda)
{
  const double alpha = atan(lambda / par[PAR_L]);

  return par[PAR_K_LAMBDA] * atan(7. * tan(alpha)) * cos(0.95 * atan(7. * tan(alpha)));
}

/* (26) */
static double self_aligning(const double par[], double lambda)
{
  const double alpha = atan(lambda / par[PAR_L]);

  if (alpha > par[PAR_ALPHA_M] || alpha < -par[PAR_ALPHA_M])
    return 0.;
  return par[PAR_K_ALPHA] * (par[PAR_ALPHA_M] / MLG_PI) * sin(alpha * (MLG_PI / par[PAR_ALPHA_M]));
}

/* ---- derivatives along the flow ----------------------------------------- */

struct flow {
  const double *par, *u, *du;
  int which, side; /* what scalar is followed */
  double R_i;
};

/* d/dt of a scalar of the state at u, when u' = du. */
static double along(const struct flow *flow, double (*scalar)(const struct flow *, const double *u))
{
  static const double weight[5] = { 5. / 6., -5. / 21., 5. / 84., -5. / 504., 1. / 1260. };
  const double dt = 1e-3;
  double sum = 0.;

  for (int k = 5; k > 0; k--) {
    double ahead[GEAR_STATES], behind[GEAR_STATES];

    for (int i = 0; i < GEAR_STATES; i++) {
      ahead[i] = flow->u[i] + k * dt * flow->du[i];
      behind[i] = flow->u[i] - k * dt * flow->du[i];
    }
    sum += weight[k - 1] * (scalar(flow, ahead) - scalar(flow, behind));
  }
  return sum / dt;
}

static double flow_dzB_wheel(const struct flow *flow, const double *u)
{
  return dzB_wheel(flow->par, u, flow->side, flow->R_i);
}

static double flow_dzB_moving(const struct flow *flow, const double *u)
{
  return dzB_wheel(flow->par, u, flow->side, loaded_radius(flow->par, u, flow->side))
         + dzB_of_radius(flow->par, u, flow->side);
}

/* z_B'' of the constraint of one wheel. */
static double ddzB_own(const struct flow *flow)
{
  const double held = along(flow, flow_dzB_wheel), moving = along(flow, flow_dzB_moving);

  return held + flow->par[PAR_R_MOVES] * (moving - held);
}

static double flow_dz_D(const struct flow *flow, const double *u) /* upwards, from B */
{
  cplx v[3];

  velocity_D(flow->par, u[DELTA], u[DDELTA], 0., v);
  return -creal(v[2]);
}

static double flow_kinetic_energy(const struct flow *flow, const double *u)
{
  return creal(kinetic_energy(flow->par, u[DELTA], u[PSI], u[DDELTA], u[DPSI],
                              dzB_mean(flow->par, u)));
}

static double flow_momentum(const struct flow *flow, const double *u) /* dT/d q' */
{
  const cplx step = I * tiny;

  return cimag(whole_energy(flow->par, u[DELTA], u[PSI],
                              u[DDELTA] + (flow->which == DELTA ? step : 0.),
                              u[DPSI] + (flow->which == PSI ? step : 0.),
                              dzB_mean(flow->par, u))) / tiny;
}

/* Forces in global axes at the state u of a flow: (13)-(17), (34)-(36). */
struct forces {
  double F_N, G_D;               /* along Z */
  struct {
    double by_delta[3], by_psi[3]; /* of the contact point */
    double F[3], M_Z;
  } wheel[2];
};

static struct forces cartesian_forces(const double par[], const double u[], const double du[])
{
  const double theta = creal(heading(par, u[DELTA], u[PSI]));
  struct forces f = { .F_N = par[PAR_M] * par[PAR_G], .G_D = par[PAR_M_D] * par[PAR_G] };
  struct flow flow = { .par = par, .u = u, .du = du };
  const double ddz_D = along(&flow, flow_dz_D);
  /* N12_z delta'', which (35), (36) do not print */
  const double N12 = par[PAR_L_D] * cos(par[PAR_PHI]) * sin(u[DELTA]) * du[DDELTA];
  double ddzB[2];

  for (int i = 0; i < 2; i++) {
    flow.side = i ? +1 : -1;
    flow.R_i = loaded_radius(par, u, flow.side);
    ddzB[i] = ddzB_own(&flow);
  }
  for (int i = 0; i < 2; i++) {
    const int side = flow.side = i ? +1 : -1;
    const double lambda = u[i ? LAMBDA_R : LAMBDA_L];
    const double shared = ddzB[i] + par[PAR_ZB_SHARED] * ((ddzB[0] + ddzB[1]) / 2. - ddzB[i]);

    flow.R_i = loaded_radius(par, u, side);
    contact_slopes(par, u, side, flow.R_i, f.wheel[i].by_delta, f.wheel[i].by_psi);
    const double F_z = 0.5 * (side * par[PAR_A] * roll(par, u) * par[PAR_K_T]
                              + par[PAR_M_D] * (shared + ddz_D - par[PAR_N12_OUT] * N12)
                              + f.G_D + f.F_N);
    f.wheel[i].F[0] = -F_z * restoring(par, lambda) * sin(theta);
    f.wheel[i].F[1] = F_z * restoring(par, lambda) * cos(theta);
    f.wheel[i].F[2] = -F_z;
    f.wheel[i].M_Z = -self_aligning(par, lambda) * F_z;
  }
  return f;
}

/* ---- tests ---------------------------------------------------------------- */

static void defaults_are_the_verified_parameters(void **state)
{
  double par[SLOTS] = { 0. };

  (void)state;
  mlg_defaults(par);
  assert_near((par[PAR_M] + par[PAR_M_D]) * par[PAR_G], 200e3, 200e3 * 2e-16);
  assert_near(par[PAR_PHI], acos(-1.) / 60., 1e-17);
  /* Table 1 */
  assert_near(par[PAR_A], 0.5, 0.);
  assert_near(par[PAR_C_DELTA], 300., 0.);
  assert_near(par[PAR_C_PSI], 300., 0.);
  assert_near(par[PAR_E], 0.12, 0.);
  assert_near(par[PAR_K_DELTA], 6.1e6, 0.);
  assert_near(par[PAR_K_PSI], 3.8e5, 0.);
  assert_near(par[PAR_J_XI], 200., 0.);
  assert_near(par[PAR_J_ETA], 250., 0.);
  assert_near(par[PAR_J_ZETA], 100., 0.);
  assert_near(par[PAR_L_D], 0.72, 0.);
  assert_near(par[PAR_L_DELTA], 0.75, 0.);
  assert_near(par[PAR_M_D], 500., 0.);
  assert_near(par[PAR_H], 0.1, 0.);
  assert_near(par[PAR_K_T], 7e5, 0.);
  assert_near(par[PAR_K_ALPHA], 1., 0.);
  assert_near(par[PAR_K_LAMBDA], 0.002, 0.);
  assert_near(par[PAR_L], 0.3, 0.);
  assert_near(par[PAR_R], 0.362, 0.);
  assert_near(par[PAR_ALPHA_M], 0.1745, 0.);
  assert_near(par[PAR_K_D], 1.09e5, 0.);
  assert_near(par[PAR_G], 9.81, 0.);
  /* and to the digits that Table 1 prints of the two values it rounds */
  assert_near(par[PAR_PHI], 0.0524, 0.5e-4);
  assert_near(par[PAR_M], 19.9e3, 0.05e3);
}

static void slots_are_distinct_and_not_autos(void **state)
{
  int used[SLOTS] = { 0 };
  double par[SLOTS];

  (void)state;
  for (int i = 0; i < SLOTS; i++)
    par[i] = -123.;
#define X(slot, id, ...) used[PAR_##id]++;
  MLG_PARAMETERS(X)
  MLG_RESULTS(X)
#undef X
  for (int i = 0; i < SLOTS; i++)
    if (i < 36) /* PAR(10)-PAR(14) are AUTO's */
      assert_int_equal(used[i], i < 9 || i > 13 ? 1 : 0);
    else
      assert_true(used[i] <= 1);
  mlg_defaults(par);
  for (int i = 9; i < 14; i++)
    assert_near(par[i], -123., 0.);
  for (int i = 0; i < MLG_PARAMETER_COUNT; i++) {
    const struct mlg_parameter *p = &mlg_parameters[i];

    assert_ptr_equal(mlg_find(p->name, strlen(p->name)), p);
    assert_true(p->least < p->most && mlg_in_range(p, par[p->slot]));
    assert_true(mlg_in_range(p, p->least) && mlg_in_range(p, p->most));
    assert_false(mlg_in_range(p, p->least - 1.) || mlg_in_range(p, NAN));
    assert_true(isinf(p->most) || !mlg_in_range(p, 2. * p->most));
  }
  assert_null(mlg_find("c", 1));
  assert_null(mlg_find("c_d2", 4));
}

static void damper_is_never_zero(void **state)
{
  (void)state;
  assert_near(mlg_damper(3.6e4), 3.6e4, 0.);
  assert_near(mlg_damper(-20.), -20., 0.);
  assert_true(mlg_damper(0.) > 0.);
  assert_true(mlg_damper(0.) <= 1e-3);
}

static void tyre_functions(void **state)
{
  double par[SLOTS];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    const double lambda = uniform(-0.2, 0.2);

    assert_near(mlg_restoring(par, lambda), restoring(par, lambda), 1e-14 * par[PAR_K_LAMBDA]);
    assert_near(mlg_self_aligning(par, lambda), self_aligning(par, lambda), 1e-14 * par[PAR_K_ALPHA]);
    assert_near(mlg_restoring(par, -lambda), -mlg_restoring(par, lambda), 0.);
    assert_near(mlg_self_aligning(par, -lambda), -mlg_self_aligning(par, lambda), 0.);
  }
}

static void tyre_slopes_at_zero(void **state)
{
  const double h = 1e-7; /* the functions are odd: the error is of order (7 h / l)^2 = 5e-12 */
  double par[SLOTS];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    const double restoring_slope = 7. * par[PAR_K_LAMBDA] / par[PAR_L];
    const double self_aligning_slope = par[PAR_K_ALPHA] / par[PAR_L];

    assert_near(mlg_restoring(par, h) / h, restoring_slope, 1e-10 * restoring_slope);
    assert_near(mlg_self_aligning(par, h) / h, self_aligning_slope, 1e-10 * self_aligning_slope);
  }
}

/* C is continuous at |alpha| = alpha_m, where it is 0 on both sides; its slope
 * jumps from -k_alpha (per alpha) to 0.  With the defaults this is at
 * |lambda| = l tan(alpha_m) = 0.0529 m. */
static void self_aligning_ends_at_alpha_m(void **state)
{
  double par[SLOTS];

  (void)state;
  mlg_defaults(par);
  const double alpha_m = par[PAR_ALPHA_M], l = par[PAR_L], h = 1e-6;

  assert_near(l * tan(alpha_m), 0.0529, 0.5e-4);
  for (int sign = -1; sign <= 1; sign += 2) {
    const double inside = mlg_self_aligning(par, sign * l * tan(alpha_m - h));

    assert_near(sign * inside, par[PAR_K_ALPHA] * h, 1e-4 * h);
    assert_near(mlg_self_aligning(par, sign * l * tan(alpha_m + 1e-15)), 0., 1e-14);
    for (double beyond = 1e-9; beyond < 1.; beyond *= 10.)
      assert_near(mlg_self_aligning(par, sign * l * tan(alpha_m + beyond)), 0., 0.);
  }
}

static void pose(void **state)
{
  double par[SLOTS], u[GEAR_STATES];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_doubts(par, n);
    random_gear(u);
    const struct mlg_pose p = mlg_pose(par, u);
    const double theta = creal(heading(par, u[DELTA], u[PSI]));

    assert_near(p.mu, roll(par, u), 1e-14);
    assert_near(p.sin_theta, sin(theta), 1e-15);
    assert_near(p.cos_theta, cos(theta), 1e-15);
    assert_near(p.dtheta, heading_rate(par, u), 1e-13);
  }
}

/* Derivatives of r_i = H (X_i, eta_i, Z_i) with R_i held, and z_B'' of each
 * wheel at constant rates. */
static void contact_kinematics(void **state)
{
  double par[SLOTS], u[GEAR_STATES];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_doubts(par, n);
    random_gear(u);
    const struct mlg_pose p = mlg_pose(par, u);
    const double steady[GEAR_STATES] = { [DELTA] = u[DDELTA], [PSI] = u[DPSI] };

    for (int side = -1; side <= 1; side += 2) {
      const struct mlg_contact w = mlg_contact(par, u, &p, side, u[LAMBDA_L]);
      const struct flow flow = { .par = par, .u = u, .du = steady, .side = side,
                                 .R_i = loaded_radius(par, u, side) };
      double by_delta[3], by_psi[3];

      contact_slopes(par, u, side, flow.R_i, by_delta, by_psi);
      assert_near(w.x_delta, by_delta[0], 1e-14);
      assert_near(w.y_delta, by_delta[1], 1e-14);
      assert_near(w.z_delta, by_delta[2], 1e-14);
      assert_near(w.x_psi, by_psi[0], 1e-14);
      assert_near(w.y_psi, by_psi[1], 1e-14);
      assert_near(w.z_psi, by_psi[2], 1e-14);
      assert_near(w.ddzB, ddzB_own(&flow), 1e-9);
    }
  }
}

/* (31) with velocities from (20) */
static void stretched_string(void **state)
{
  double par[SLOTS], u[GEAR_STATES], du[GEAR_STATES];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_doubts(par, n);
    random_gear(u);
    mlg_gear(par, u, 0., du);
    const double theta = creal(heading(par, u[DELTA], u[PSI])), dtheta = heading_rate(par, u);

    for (int i = 0; i < 2; i++) {
      const int side = i ? +1 : -1, slot = i ? LAMBDA_R : LAMBDA_L;
      double by_delta[3], by_psi[3];

      contact_slopes(par, u, side, loaded_radius(par, u, side), by_delta, by_psi);
      const double v_X = par[PAR_V] + by_delta[0] * u[DDELTA] + by_psi[0] * u[DPSI];
      const double v_Y = by_delta[1] * u[DDELTA] + by_psi[1] * u[DPSI];
      const double expected =
          v_X * (sin(theta) - u[slot] / par[PAR_L] * cos(theta))
          - v_Y * (cos(theta) + u[slot] / par[PAR_L] * sin(theta))
          - (par[PAR_H] - u[slot] * u[slot] / par[PAR_L]) * dtheta;

      assert_near(du[slot], expected, 1e-12 * (1. + par[PAR_V]));
    }
  }
}

/* (1) with (21) for q = delta and psi: d/dt dT/dq' - dT/dq + dU/dq + dD/dq' = Q */
static void lagranges_equation(void **state)
{
  double par[SLOTS], u[GEAR_STATES], du[GEAR_STATES];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_doubts(par, n);
    random_gear(u);
    const double T_d = uniform(-1e5, 1e5), phi = par[PAR_PHI];

    mlg_gear(par, u, T_d, du);
    assert_near(du[DELTA], u[DDELTA], 0.);
    assert_near(du[PSI], u[DPSI], 0.);
    const struct forces f = cartesian_forces(par, u, du);

    for (int q = DELTA; q <= PSI; q += PSI - DELTA) {
      const int by_delta = q == DELTA;
      const struct flow flow = { .par = par, .u = u, .du = du, .which = q };
      const cplx step = I * tiny;
      cplx omega_delta[3], omega_psi[3], v_D[3];

      angular_velocities(phi, u[DELTA], by_delta, !by_delta, omega_delta, omega_psi);
      velocity_D(par, u[DELTA], by_delta, 0., v_D); /* unit rate: dv_D/dq' */
      const double dT_dq = cimag(whole_energy(par, u[DELTA] + (by_delta ? step : 0.),
                                                u[PSI] + (by_delta ? 0. : step), u[DDELTA],
                                                u[DPSI], dzB_mean(par, u))) / tiny;
      const double elastic = by_delta ? par[PAR_K_DELTA] * u[DELTA] : T_d;
      const double viscous = by_delta ? par[PAR_C_DELTA] * u[DDELTA] : par[PAR_C_PSI] * u[DPSI];
      double Q = f.G_D * creal(v_D[2]), scale = fabs(elastic) + fabs(viscous) + fabs(Q);

      for (int i = 0; i < 2; i++) {
        const double *r_q = by_delta ? f.wheel[i].by_delta : f.wheel[i].by_psi;

        for (int k = 0; k < 3; k++) {
          Q += f.wheel[i].F[k] * r_q[k];
          scale += fabs(f.wheel[i].F[k] * r_q[k]);
        }
        Q += f.wheel[i].M_Z * creal(omega_delta[2] + omega_psi[2]);
      }
      assert_near(along(&flow, flow_momentum) - dT_dq, Q - elastic - viscous, 1e-10 * scale);
    }
  }
}

/* dT/dt along the flow is the power of all Cartesian forces less what the
 * springs store and the dampers take; z_B' is the mean of the wheels'. */
static void energy_balance(void **state)
{
  double par[SLOTS], u[GEAR_STATES], du[GEAR_STATES];

  (void)state;
  for (int n = 0; n < SAMPLES; n++) {
    random_parameters(par);
    random_doubts(par, n);
    par[PAR_N12_OUT] = 0.; /* without that term it does not hold */
    random_gear(u);
    const double T_d = uniform(-1e5, 1e5), dzB = dzB_mean(par, u);

    mlg_gear(par, u, T_d, du);
    const struct forces f = cartesian_forces(par, u, du);
    const struct flow flow = { .par = par, .u = u, .du = du };
    cplx omega_delta[3], omega_psi[3], v_D[3];

    angular_velocities(par[PAR_PHI], u[DELTA], u[DDELTA], u[DPSI], omega_delta, omega_psi);
    velocity_D(par, u[DELTA], u[DDELTA], dzB, v_D);
    const double part[] = {
      -f.F_N * dzB, f.G_D * creal(v_D[2]),                                  /* (13) */
      -par[PAR_K_DELTA] * u[DELTA] * u[DDELTA], -T_d * u[DPSI],             /* (3) */
      -par[PAR_C_DELTA] * u[DDELTA] * u[DDELTA], -par[PAR_C_PSI] * u[DPSI] * u[DPSI], /* (5) */
    };
    double power = 0., scale = 0.;

    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
      power += part[i];
      scale += fabs(part[i]);
    }
    for (int i = 0; i < 2; i++) {
      for (int k = 0; k < 3; k++) { /* the contact point, in the frame of the aircraft */
        const double v = f.wheel[i].by_delta[k] * u[DDELTA] + f.wheel[i].by_psi[k] * u[DPSI]
                         - (k == 2 ? dzB : 0.);

        power += f.wheel[i].F[k] * v;
        scale += fabs(f.wheel[i].F[k] * v);
      }
      power += f.wheel[i].M_Z * creal(omega_delta[2] + omega_psi[2]);
    }
    assert_near(along(&flow, flow_kinetic_energy), power, 1e-10 * scale);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(defaults_are_the_verified_parameters, seed),
    cmocka_unit_test_setup(slots_are_distinct_and_not_autos, seed),
    cmocka_unit_test_setup(damper_is_never_zero, seed),
    cmocka_unit_test_setup(tyre_functions, seed),
    cmocka_unit_test_setup(tyre_slopes_at_zero, seed),
    cmocka_unit_test_setup(self_aligning_ends_at_alpha_m, seed),
    cmocka_unit_test_setup(pose, seed),
    cmocka_unit_test_setup(contact_kinematics, seed),
    cmocka_unit_test_setup(stretched_string, seed),
    cmocka_unit_test_setup(lagranges_equation, seed),
    cmocka_unit_test_setup(energy_balance, seed),
  };

  return cmocka_run_group_tests_name("gear", tests, NULL, NULL);
}
