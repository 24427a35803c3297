/* li1.c - layout LI1: L2 with an inerter beside the damper, TVMD type (paper Section 4.1, Fig. 11(a))
 *
 *                                     +--[ k_d ]--+
 *              k_psi       k_s        |           |
 *   wheels ---/\/\/\/---/\/\/\/---o---+--[ c_d ]--+---- strut
 *     psi                        eps  |           |
 *                                     +--[  b  ]--+
 *
 *   drawn in docs/drawings/li1.svg
 *
 *   T_d = k_psi_e (psi - eps) = k_d eps + c_d eps' + b eps''
 *   k_psi_e = 1 / (1/k_psi + 1/k_s)                                      (37)
 *
 * b = 0 gives L2; deps, no longer a state of the device, then follows eps'.
 */
#include "mlg.h"

#define DEVICE_STATES(X)                                  \
  X(EPS,  "eps",  "rad",   "twist across k_d, c_d and b") \
  X(DEPS, "deps", "rad/s", "its rate")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM };

/* Torque T_d, N m, that the device takes from the wheels, du[EPS] and du[DEPS]. */
static inline double device(const double par[], const double u[], double du[])
{
  const double T_d = mlg_links_and_k_s(par, u[PSI] - u[EPS]);

  mlg_damper_and_inerter(par, T_d - mlg_k_d(par, u[EPS]), &u[EPS], &du[EPS]);
  return T_d;
}

/* The same device as a network. */
static inline struct network device_network(const double par[])
{
  return series(series(spring(par[PAR_K_PSI]), spring(par[PAR_K_S])),
                parallel(inerter(par[PAR_B]),
                         parallel(spring(par[PAR_K_D]), damper(par[PAR_C_D]))));
}

#include "plugin.h"
