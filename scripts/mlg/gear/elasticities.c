/* elasticities.c - by how many per cent bounds and damping move for one of a parameter */
#include <math.h>
#include <stdio.h>

#include "command.h"
#include "designs.h"
#include "names.h"

static double elasticity(const struct arguments *a, double zeta, const struct libmlg_point *point, int parameter)
{
  double slope;

  if (point->kind == LIBMLG_ENDS)
    return 0.;
  checked(a->command, libmlg_point_slope(a->layout, a->par, zeta, point, parameter, &slope));
  return slope * libmlg_value(a->par, parameter) / point->c_d;
}

static void print_row(const struct arguments *a, double zeta, const struct libmlg_interval *interval,
                      const struct libmlg_ratio *least, int parameter)
{
  const double value = libmlg_value(a->par, parameter);
  double slope;

  if (!(fabs(value) > 0.) || value >= MLG_RIGID || (parameter != LIBMLG_F_Z && libmlg_uses(a->layout, parameter) != 1))
    return;
  printf("%s,%.10g,%s,", quantity_name(parameter), value, quantity_unit(parameter));
  if (parameter == NUMBER_C_D)
    printf(",,");
  else
    printf("%.8g,%.8g,", elasticity(a, zeta, &interval->lo, parameter), elasticity(a, zeta, &interval->hi, parameter));
  if (libmlg_ratio_slope(a->layout, a->par, least, parameter, &slope) == 0)
    printf("%.8g", slope * value / least->zeta);
  printf("\n");
}

static int run(int argc, char *argv[])
{
  struct option option[] = { { "V_least", "m/s", 1e-6, 1e3, 0.3, NULL }, { .name = NULL } };
  struct libmlg_interval interval;
  struct libmlg_ratio least;
  struct arguments a;

  read_arguments(&a, argc, argv, option);
  check_speeds(&a, option[0].value);
  if (!take_interval(&a, option[0].value, &interval))
    fail(argv[0], MLG_FAILED, "there is no zero-shimmy interval%s", a.word[NUMBER_C_D] ? " around that c_d" : " at these parameters");
  if (libmlg_least_ratio(a.layout, a.par, option[0].value, a.V_top, &least) != 0)
    fail(argv[0], MLG_FAILED, "no eigenvalues at c_d = %g", a.par[NUMBER_C_D]);
  printf("# d log(c_lo), d log(c_hi), d log(zeta) per d log(parameter); c_lo = %.10g, c_hi = %.10g N m s/rad; zeta = %.8g at V = %.6g m/s"
         " with c_d = %.10g\nparameter,value,unit,c_lo,c_hi,zeta\n",
         interval.lo.c_d, interval.hi.c_d, least.zeta, least.V, a.par[NUMBER_C_D]);
  print_row(&a, 0., &interval, &least, LIBMLG_F_Z);
  for (int n = 0; n < NUMBERS; n++)
    if (n != NUMBER_V && n != NUMBER_ALPHA_M)
      print_row(&a, 0., &interval, &least, n);
  return output_status(argv[0]);
}

const struct command command_elasticities = {
  .name = "elasticities",
  .usage = "LAYOUT [NAME=VALUE ...] [V_least=0.3]",
  .summary = "by how many per cent bounds and damping move for one per cent of a parameter",
  .details =
    "d log(x)/d log(parameter) of both ends c_lo and c_hi of the zero-shimmy interval and of the\n"
    "least damping ratio zeta over V_least < V < V_top, exactly, by implicit differentiation.\n"
    "The interval is the one around c_d or, without c_d, the widest, and zeta that of its middle.\n"
    "CSV, a row for F_z (M with m_D and g held) and for each parameter that is not 0 or rigid:\n"
    "  parameter, value, unit\n"
    "  c_lo, c_hi   elasticities; 0 of a bound of 0 or infinity; empty for c_d\n"
    "  zeta         empty where a real root is the least\n"
    "alpha_m and V are left out: the linearised gear does not know the one, and all V count.\n"
    "Status 1 without an interval.\n",
  .run = run,
};
