/* l1.c - layout L1: the shimmy damper (paper Section 3.1, Fig. 3(b))
 *
 *              k_psi         +--[ k_d ]--+
 *   wheels ---/\/\/\/---o----+           +---- strut
 *     psi              eps   +--[ c_d ]--+
 *
 *   drawn in docs/drawings/l1.svg
 *
 *   T_d = k_psi (psi - eps) = k_d eps + c_d eps'                          (4)
 */
#include "mlg.h"

#define DEVICE_STATES(X) X(EPS, "eps", "rad", "twist across k_d and c_d")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, and du[EPS]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double T_d = mlg_links(par, u[PSI] - u[EPS]);

  du[EPS] = mlg_damper_rate(par, T_d - mlg_k_d(par, u[EPS]));
  return T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  return series(spring(par[PAR_K_PSI]), parallel(spring(par[PAR_K_D]), damper(par[PAR_C_D])));
}

#include "plugin.h"
