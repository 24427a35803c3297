/* li7.c - layout LI7: an inerter across k_d and across a damper with a spring in series
 *
 *                     +---------------[  b  ]---------------+
 *              k_psi  +--------------[ k_d ]----------------+
 *   wheels ---/\/\/\--o                                     o---- strut
 *     psi            chi    k_s                             |
 *                     +---/\/\/\---o--------[ c_d ]---------+
 *                                 eps
 *
 *   drawn in docs/drawings/li7.svg
 *
 *   T_d = k_psi (psi - chi) = b chi'' + k_d chi + T_b
 *   T_b = k_s (chi - eps) = c_d eps'
 *
 * LI3 with k_d beside all; b = 0 leaves LI5 without its b.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                             \
  X(EPS,  "eps",  "rad",   "twist across c_d")       \
  X(CHI,  "chi",  "rad",   "twist across b and k_d") \
  X(DCHI, "dchi", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] to du[DCHI]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double k_s = par[PAR_K_S], b = par[PAR_B];
  struct mlg_fork T = mlg_fork_at(par, u[PSI], u[CHI]);

  if (b > 0. && k_s >= MLG_RIGID) {
    mlg_damper_and_inerter(par, T.T_b, &u[CHI], &du[CHI]);
    du[EPS] = MLG_FOLLOW * (u[CHI] - u[EPS]);
  } else if (b > 0.) {
    const double T_s = mlg_k_s(par, u[CHI] - u[EPS]);

    du[CHI] = u[DCHI];
    du[DCHI] = (T.T_b - T_s) / b;
    du[EPS] = mlg_damper_rate(par, T_s);
  } else {
    T = mlg_fork_and_k_s(par, u[PSI], u[EPS]);
    du[EPS] = mlg_damper_rate(par, T.T_b);
    du[CHI] = MLG_FOLLOW * (u[EPS] - u[CHI]);
    du[DCHI] = MLG_FOLLOW * (du[CHI] - u[DCHI]);
  }
  return T.T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network branch = series(spring(par[PAR_K_S]), damper(par[PAR_C_D]));

  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), parallel(branch, inerter(par[PAR_B]))));
}

#include "plugin.h"
