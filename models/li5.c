/* li5.c - layout LI5: a spring in series with a damped inerter, beside k_d
 *
 *                         +--------------[ k_d ]--------------+
 *              k_psi      |     k_s           +--[ c_d ]--+   |
 *   wheels ---/\/\/\---o--+---/\/\/\-----o----+           +---+---- strut
 *     psi                               eps   +--[  b  ]--+
 *
 *   drawn in docs/drawings/li5.svg
 *
 *   T_d = k_psi (psi - x) = k_d x + T_b, x the twist across k_d
 *   T_b = k_s (x - eps) = c_d eps' + b eps''
 *
 * b = 0 leaves c_d alone in series with k_s.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                             \
  X(EPS,  "eps",  "rad",   "twist across c_d and b") \
  X(DEPS, "deps", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] and du[DEPS]. */
static inline double device(const double par[], const double u[], double du[])
{
  const struct mlg_fork T = mlg_fork_and_k_s(par, u[PSI], u[EPS]);

  mlg_damper_and_inerter(par, T.T_b, &u[EPS], &du[EPS]);
  return T.T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network branch = series(spring(par[PAR_K_S]),
                                       parallel(damper(par[PAR_C_D]), inerter(par[PAR_B])));

  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), branch));
}

#include "plugin.h"
