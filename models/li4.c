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
 * Seen from the branch of b, k_psi and k_d are one spring k = k_psi + k_d that
 * psi twists by y = psi k_psi / k.  b = 0 leaves k_s alone in series with c_d; a rigid
 * k_s gives L1.
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
  const double k_psi = par[PAR_K_PSI], k_d = par[PAR_K_D], k = k_psi + k_d;
  const double y = u[PSI] * k_psi / k;
  const double T_b = mlg_spring_inerter(k, y - u[EPS], par[PAR_K_S], par[PAR_B], &u[CHI], &du[CHI]);

  du[EPS] = T_b / mlg_damper(par[PAR_C_D]);
  return k_d * y + k_psi / k * T_b;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network branch = series(damper(par[PAR_C_D]),
                                       parallel(spring(par[PAR_K_S]), inerter(par[PAR_B])));

  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), branch));
}

#include "plugin.h"
