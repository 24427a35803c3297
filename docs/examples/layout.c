/* layout.c - template of a layout: copy it to models/NAME.c (docs/layouts.md)
 *
 *                           +--[ k_s ]--+
 *              k_psi        |           |       +--[ k_d ]--+
 *   wheels ---/\/\/\/---o---+--[ c_s ]--+---o---+           +---- strut
 *     psi              chi  |           |  eps  +--[ c_d ]--+
 *                           +--[  b  ]--+
 *
 *   T_d = k_psi (psi - eps - chi) = k_d eps + c_d eps' = k_s chi + c_s chi' + b chi''
 *
 * LI2 with some damping beside the inerter.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                                   \
  X(EPS,  "eps",  "rad",   "twist across k_d and c_d")     \
  X(CHI,  "chi",  "rad",   "twist across k_s, c_s and b")  \
  X(DCHI, "dchi", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

static const double c_s = 200.; /* N m s/rad */

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] to du[DCHI]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double T_d = mlg_links(par, u[PSI] - u[EPS] - u[CHI]);

  mlg_spring_damper_inerter(T_d, par[PAR_K_S], c_s, par[PAR_B], &u[CHI], &du[CHI]);
  du[EPS] = mlg_damper_rate(par, T_d - mlg_k_d(par, u[EPS]));
  return T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  return series(spring(par[PAR_K_PSI]),
                series(parallel(spring(par[PAR_K_S]), parallel(damper(c_s), inerter(par[PAR_B]))),
                       parallel(spring(par[PAR_K_D]), damper(par[PAR_C_D]))));
}

#include "plugin.h"
