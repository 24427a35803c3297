/* li3.c - layout LI3: an inerter across the whole chain of L2
 *
 *                     +---------------[  b  ]---------------+
 *              k_psi  |     k_s          +--[ k_d ]--+      |
 *   wheels ---/\/\/\--o---/\/\/\---o-----+           +------o---- strut
 *     psi            chi          eps    +--[ c_d ]--+
 *
 *   drawn in docs/drawings/li3.svg
 *
 *   T_d = k_psi (psi - chi) = b chi'' + k_s (chi - eps)
 *   k_s (chi - eps) = k_d eps + c_d eps'
 *
 * b = 0 gives L2, where chi follows the twist behind k_psi; a rigid k_s gives LI1,
 * where eps follows chi.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                               \
  X(EPS,  "eps",  "rad",   "twist across k_d and c_d") \
  X(CHI,  "chi",  "rad",   "twist across b")           \
  X(DCHI, "dchi", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] to du[DCHI]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double k_s = par[PAR_K_S], b = par[PAR_B];
  double T_d = mlg_links(par, u[PSI] - u[CHI]);

  if (b > 0. && k_s >= MLG_RIGID) {
    mlg_damper_and_inerter(par, T_d - mlg_k_d(par, u[CHI]), &u[CHI], &du[CHI]);
    du[EPS] = MLG_FOLLOW * (u[CHI] - u[EPS]);
  } else if (b > 0.) {
    const double T_s = mlg_k_s(par, u[CHI] - u[EPS]);

    du[CHI] = u[DCHI];
    du[DCHI] = (T_d - T_s) / b;
    du[EPS] = mlg_damper_rate(par, T_s - mlg_k_d(par, u[EPS]));
  } else {
    T_d = mlg_links_and_k_s(par, u[PSI] - u[EPS]);
    du[EPS] = mlg_damper_rate(par, T_d - mlg_k_d(par, u[EPS]));
    du[CHI] = MLG_FOLLOW * (u[EPS] + T_d / k_s - u[CHI]);
    du[DCHI] = MLG_FOLLOW * (du[CHI] - u[DCHI]);
  }
  return T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  const struct network chain = series(spring(par[PAR_K_S]),
                                      parallel(spring(par[PAR_K_D]), damper(par[PAR_C_D])));

  return series(spring(par[PAR_K_PSI]), parallel(inerter(par[PAR_B]), chain));
}

#include "plugin.h"
