/* l2.c - layout L2: the shimmy damper with a spring in series (paper Section 3.2, Fig. 8(b))
 *
 *              k_psi       k_s        +--[ k_d ]--+
 *   wheels ---/\/\/\/---/\/\/\/---o---+           +---- strut
 *     psi                        eps  +--[ c_d ]--+
 *
 *   drawn in docs/drawings/l2.svg
 *
 *   T_d = k_psi_e (psi - eps) = k_d eps + c_d eps'                        (4)
 *   k_psi_e = 1 / (1/k_psi + 1/k_s)                                      (37)
 *
 * A rigid k_s gives L1.
 */
#include "mlg.h"

#define DEVICE_STATES(X) X(EPS, "eps", "rad", "twist across k_d and c_d")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, and du[EPS]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double T_d = mlg_links_and_k_s(par, u[PSI] - u[EPS]);

  du[EPS] = mlg_damper_rate(par, T_d - mlg_k_d(par, u[EPS]));
  return T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  return series(series(spring(par[PAR_K_PSI]), spring(par[PAR_K_S])),
                parallel(spring(par[PAR_K_D]), damper(par[PAR_C_D])));
}

#include "plugin.h"
