/* boundary.h - AUTO problem (IPS=0) for boundary points of the zero-shimmy region
 *
 * Built by boundary.c instead of plugin.h's func, stpnt and pvls, around the
 * network of the same layout file.  A boundary point is an extremum of c_d along a Hopf curve
 * of the (V, c_d) plane: F = 0 and Im(conj(F_s ray) F_V) = 0, F from
 * characteristic.h.  AUTO continues up to four of them side by side; the last
 * two, called lo and hi, bound the interval of c_d whose width is looked at.
 *
 * Unknowns, three for each point i = 1 to NDIM / 3:
 *   omega_i  angular frequency / 10, rad/s    speed_i  V / 10, m/s
 *   logc_i   log10 of c_d in N m s/rad
 * and then, NDIM % 3 of them:
 *   kappa    1e5 / k_s, N m/rad; 0 is rigid   inert    b / 100, N m s^2/rad
 * Free parameter: compliance, b, or any other, when NDIM % 3 is 0; b or any
 * other when kappa is unknown; width when both are.
 * For kappa one more equation closes the system, by the parameter closing:
 *   0  onset: point 1 is where a closed Hopf curve is born, Im(conj(F_s ray) F_c) = 0
 *   1  equal: point 1 has the c_d of lo
 *   2  stationary: the width has an extremum over the compliance
 *   3  equal above: point 1 has the c_d of hi
 * and for inert: c_d of hi less that of lo is width, so that a fold of the curve
 * is the extremum of the width over b.
 * With zeta > 0 the points bound the region of damping ratio above zeta.
 */
#ifndef MLG_BOUNDARY_H
#define MLG_BOUNDARY_H

#include "characteristic.h"

/* Parameters of this problem beside those of the gear: NPAR = MLG_BOUNDARY_SLOTS. */
enum boundary_slot {
  PAR_COMPLIANCE = 33 - 1, /* 1e5 / k_s, N m/rad */
  PAR_ZETA,                /* damping ratio on the boundary */
  PAR_CLOSING,             /* see above */
  PAR_WIDTH,               /* c_d of hi less that of lo, N m s/rad */
  PAR_POINT = 61 - 1,      /* results of point 1, then of the others: */
  POINT_V = 0,             /* V_i, m/s */
  POINT_C,                 /* c_i, c_d in N m s/rad */
  POINT_FREQUENCY,         /* f_i, Hz */
  POINT_RATIO,             /* ratio_i, mlg_energy_ratio: above 1 delta-shimmy */
  POINT_KIND,              /* kind_i, 1: c_d is least, -1: largest */
  POINT_RESULTS,
  /* these pass 0 where another mechanism takes over: */
  PAR_GAP = 81 - 1,        /* log10 of c_1 / c_lo */
  PAR_RIVAL,               /* log10 of c_2 / c_lo, with four points */
  PAR_FOLD,                /* sine in the onset equation of point 1 */
  PAR_SLOPE,               /* d(c_hi - c_lo)/d(compliance), N m s/rad */
  PAR_SLOPE_1              /* d(c_hi - c_1)/d(compliance), N m s/rad */
};

_Static_assert(PAR_POINT >= (int)MLG_SLOTS && PAR_SLOPE_1 + 1 == (int)MLG_BOUNDARY_SLOTS, "the gear's slots stay");

enum closing { ONSET, EQUAL, STATIONARY, EQUAL_ABOVE };

/* Where one point stands. */
struct boundary_point { double omega, V, c; };

static struct boundary_point boundary_point(const double u[], int i)
{
  return (struct boundary_point){ 10. * u[3 * i], 10. * u[3 * i + 1], pow(10., u[3 * i + 2]) };
}

/* Parameters with the unknowns among them put in; the compliance as given. */
static struct characteristic characteristic_at(int ndim, const double u[], const double par[],
                                               double compliance)
{
  double p[MLG_SLOTS];

  memcpy(p, par, sizeof p);
  p[PAR_K_S] = 1e5 / compliance; /* infinite at 0, which spring() takes */
  if (ndim % 3 == 2)
    p[PAR_B] = 100. * u[ndim - 1];
  return characteristic(p);
}

static double compliance_of(int ndim, const double u[], const double par[])
{
  return ndim % 3 ? u[ndim - ndim % 3] : par[PAR_COMPLIANCE];
}

static double width_of(int points, const double u[])
{
  return points < 2 ? 0. : boundary_point(u, points - 1).c - boundary_point(u, points - 2).c;
}

/* F at the unknowns, and beside them in the compliance, in which it is affine. */
struct drifting { struct characteristic here, beside; double _Complex ray; };

static struct drifting drifting(int ndim, const double u[], const double par[])
{
  const double compliance = compliance_of(ndim, u, par);

  return (struct drifting){
    characteristic_at(ndim, u, par, compliance),
    characteristic_at(ndim, u, par, compliance + 1.),
    mlg_ray(par[PAR_ZETA]),
  };
}

/* d(c_d)/d(compliance) of one boundary point. */
static double drift(const struct drifting *F, const double u[], int i)
{
  const struct boundary_point p = boundary_point(u, i);
  const struct jet j = jet(&F->here, p.omega * F->ray, p.V, p.c);
  const double _Complex F_compliance = jet(&F->beside, p.omega * F->ray, p.V, p.c).F - j.F;

  return -extremum_test(&j, F->ray, F_compliance) / extremum_test(&j, F->ray, j.F_c);
}

/* d(c_hi - c_i)/d(compliance), N m s/rad; 0 with one point. */
static double width_slope(const struct drifting *F, int points, const double u[], int i)
{
  return points < 2 ? 0. : drift(F, u, points - 1) - drift(F, u, i);
}

/* The equations above, each scaled to order one. */
static void boundary_equations(int ndim, const double u[], const double par[], double f[])
{
  const int points = ndim / 3;
  const double _Complex ray = mlg_ray(par[PAR_ZETA]);
  const int stationary = ndim % 3 && (int)par[PAR_CLOSING] == STATIONARY;
  struct drifting both;

  if (stationary)
    both = drifting(ndim, u, par);
  else
    both.here = characteristic_at(ndim, u, par, compliance_of(ndim, u, par));
  const struct characteristic F = both.here;

  for (int i = 0; i < points; i++) {
    const struct boundary_point p = boundary_point(u, i);
    const struct jet j = jet(&F, p.omega * ray, p.V, p.c);
    const double _Complex residual = j.F / j.F_s; /* distance to the root, rad/s */

    f[3 * i] = creal(residual);
    f[3 * i + 1] = cimag(residual);
    f[3 * i + 2] = extremum_sine(&j, ray, j.F_V);
    if (i == 0 && ndim % 3 && (int)par[PAR_CLOSING] == ONSET)
      f[3 * points] = extremum_sine(&j, ray, j.F_c);
  }
  if (ndim % 3 && (int)par[PAR_CLOSING] == EQUAL)
    f[3 * points] = u[2] - u[3 * points - 4];
  if (ndim % 3 && (int)par[PAR_CLOSING] == EQUAL_ABOVE)
    f[3 * points] = u[2] - u[3 * points - 1];
  if (stationary)
    f[3 * points] = 1e-5 * width_slope(&both, points, u, points - 2);
  if (ndim % 3 == 2)
    f[3 * points + 1] = 1e-4 * (width_of(points, u) - par[PAR_WIDTH]);
}

#include "auto_f2c.h"
#include "room.h"

/* AUTO's FUNC; derivatives are AUTO's differences (JAC=0). */
int func(integer ndim, const doublereal *u, const integer *icp, const doublereal *par,
         integer ijac, doublereal *f, doublereal *dfdu, doublereal *dfdp)
{
  (void)icp, (void)ijac, (void)dfdu, (void)dfdp;
  need_room(MLG_BOUNDARY_SLOTS);
  boundary_equations(ndim, u, par, f);
  return 0;
}

/* AUTO's STPNT: the default gear; the constants file gives the points (U). */
int stpnt(integer ndim, doublereal t, doublereal *u, doublereal *par)
{
  (void)ndim, (void)t, (void)u;
  need_room(MLG_BOUNDARY_SLOTS);
  mlg_defaults(par);
  par[PAR_COMPLIANCE] = par[PAR_ZETA] = par[PAR_CLOSING] = par[PAR_WIDTH] = 0.;
  return 0;
}

/* AUTO's PVLS: the results of boundary_slot. */
int pvls(integer ndim, const doublereal *u, doublereal *par)
{
  const int points = ndim / 3;
  const double compliance = compliance_of(ndim, u, par);
  const double _Complex ray = mlg_ray(par[PAR_ZETA]);
  const struct drifting both = drifting(ndim, u, par);
  const struct characteristic F = both.here;

  if (ndim % 3 == 2)
    par[PAR_B] = 100. * u[ndim - 1];
  else
    par[PAR_WIDTH] = width_of(points, u);
  par[PAR_COMPLIANCE] = compliance;
  for (int i = 0; i < points; i++) {
    const struct boundary_point p = boundary_point(u, i);
    const struct jet j = jet(&F, p.omega * ray, p.V, p.c);
    double *result = &par[PAR_POINT + i * POINT_RESULTS];

    if (i == 0)
      par[PAR_FOLD] = extremum_sine(&j, ray, j.F_c);
    result[POINT_V] = p.V;
    result[POINT_C] = p.c;
    result[POINT_FREQUENCY] = p.omega / (2. * MLG_PI);
    result[POINT_RATIO] = mlg_energy_ratio(par, delta_over_psi(par, p.V, p.omega * ray));
    result[POINT_KIND] = curvature(&F, ray, p.omega, p.V, p.c) > 0. ? 1. : -1.;
  }
  if (points > 2)
    par[PAR_GAP] = u[2] - u[3 * points - 4];
  if (points > 3)
    par[PAR_RIVAL] = u[5] - u[3 * points - 4];
  par[PAR_SLOPE] = width_slope(&both, points, u, points - 2);
  par[PAR_SLOPE_1] = width_slope(&both, points, u, 0);
  return 0;
}

#endif
