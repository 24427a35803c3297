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
 * Seen from the branch of b, k_psi and k_d are one spring k = k_psi + k_d that
 * psi twists by y = psi k_psi / k.  b = 0 leaves c_d alone in series with k_s.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                             \
  X(EPS,  "eps",  "rad",   "twist across c_d and b") \
  X(DEPS, "deps", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] and du[DEPS]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double k_psi = par[PAR_K_PSI], k_d = par[PAR_K_D], k = k_psi + k_d;
  const double y = u[PSI] * k_psi / k;
  const double T_b = mlg_series(k, par[PAR_K_S]) * (y - u[EPS]);

  mlg_spring_damper_inerter(T_b, 0., par[PAR_C_D], par[PAR_B], &u[EPS], &du[EPS]);
  return k_d * y + k_psi / k * T_b;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network branch = series(spring(par[PAR_K_S]),
                                       parallel(damper(par[PAR_C_D]), inerter(par[PAR_B])));

  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), branch));
}

#include "plugin.h"
