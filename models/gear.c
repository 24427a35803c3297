/* gear.c - the gear's equations and their derivatives, compiled once for all layouts
 *
 * Layouts compiled with -DMLG_APART are linked with it; without, they have their own.
 */
#include "mlg.h"
#include "gear.h"
#include "jacobian.h"

void mlg_gear_apart(const double par[], const double u[], double T_d, double du[])
{
  mlg_gear(par, u, T_d, du);
}

void mlg_slopes_apart(const double par[], const double u[], const double f[], int parameters,
                      struct mlg_slopes *E)
{
  mlg_slopes(par, u, f, parameters, E);
}
