/* li4.c - layout LI4: a damper in series with a tuned inerter, beside k_d
 *
 *                         +--------------[ k_d ]--------------+
 *              k_psi      |                   +--[ k_s ]--+   |
 *   wheels ---/\/\/\---o--+---[ c_d ]----o----+           +---+---- strut
 *     psi                       eps      chi  +--[  b  ]--+
 *
 *   drawn in docs/drawings/li4.svg
 *
 *   T_d = k_psi (psi - eps - chi) = k_d (eps + chi) + T_b
 *   T_b = c_d eps' = k_s chi + b chi''
 *
 * b = 0 leaves k_s alone in series with c_d; a rigid k_s gives L1.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                             \
  X(EPS,  "eps",  "rad",   "twist across c_d")       \
  X(CHI,  "chi",  "rad",   "twist across k_s and b") \
  X(DCHI, "dchi", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] to du[DCHI]. */
static inline double device(const double par[], const double u[], double du[])
{
  const struct mlg_fork T = mlg_fork_and_inerter(par, u[PSI], u[EPS], &u[CHI], &du[CHI]);

  du[EPS] = mlg_damper_rate(par, T.T_b);
  return T.T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network branch = series(damper(par[PAR_C_D]),
                                       parallel(spring(par[PAR_K_S]), inerter(par[PAR_B])));

  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), branch));
}

#include "plugin.h"
