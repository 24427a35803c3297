/* li6.c - layout LI6: a spring, a damper and an inerter one behind the other, beside k_d
 *
 *                         +--------------[ k_d ]--------------+
 *              k_psi      |     k_s                           |
 *   wheels ---/\/\/\---o--+---/\/\/\---o---[ c_d ]---[  b  ]--+---- strut
 *     psi                             eps
 *
 *   drawn in docs/drawings/li6.svg
 *
 *   T_d = k_psi (psi - x) = k_d x + T_b, x the twist across k_d
 *   T_b = k_s (x - eps), eps' = T_b / c_d + dchi, b dchi' = T_b
 *
 * b = 0 carries no torque and leaves k_d alone.  Where the damper ends and the inerter begins
 * nothing says but their rates, so that their twists are no states.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                             \
  X(EPS,  "eps",  "rad",   "twist across c_d and b") \
  X(DCHI, "dchi", "rad/s", "rate of b")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] and du[DCHI]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double b = par[PAR_B];
  const struct mlg_fork T = b > 0. ? mlg_fork_and_k_s(par, u[PSI], u[EPS]) : mlg_fork_alone(par, u[PSI]);

  if (b > 0.) {
    du[EPS] = mlg_damper_rate(par, T.T_b) + u[DCHI];
    du[DCHI] = T.T_b / b;
  } else {
    du[EPS] = -MLG_FOLLOW * u[EPS];
    du[DCHI] = -MLG_FOLLOW * u[DCHI];
  }
  return T.T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network branch = series(spring(par[PAR_K_S]), damper_and_inerter(par[PAR_C_D], par[PAR_B]));

  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), branch));
}

#include "plugin.h"
