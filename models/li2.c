/* li2.c - layout LI2: L2 with an inerter beside the spring, TID type (paper Section 4.1, Fig. 11(b))
 *
 *              k_psi        +--[ k_s ]--+       +--[ k_d ]--+
 *   wheels ---/\/\/\/---o---+           +---o---+           +---- strut
 *     psi              chi  +--[  b  ]--+  eps  +--[ c_d ]--+
 *
 *   drawn in docs/drawings/li2.svg
 *
 *   T_d = k_psi (psi - eps - chi) = k_d eps + c_d eps' = k_s chi + b chi''
 *
 * b = 0 gives L2, a rigid k_s L1; chi then has no motion of its own, and the
 * two states follow the twist of k_s.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                               \
  X(EPS,  "eps",  "rad",   "twist across k_d and c_d") \
  X(CHI,  "chi",  "rad",   "twist across k_s and b")   \
  X(DCHI, "dchi", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] to du[DCHI]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double T_d = mlg_links_and_inerter(par, u[PSI] - u[EPS], &u[CHI], &du[CHI]);

  du[EPS] = mlg_damper_rate(par, T_d - mlg_k_d(par, u[EPS]));
  return T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  return series(spring(par[PAR_K_PSI]),
                series(parallel(spring(par[PAR_K_S]), inerter(par[PAR_B])),
                       parallel(spring(par[PAR_K_D]), damper(par[PAR_C_D]))));
}

#include "plugin.h"
