/* gears.c - random gears
 *
 * what             drawn as
 * every parameter  the paper's times 2^(-spread..spread), even in the logarithm
 * e                negative in half of the cases
 * phi              0 in a tenth, negative in a quarter
 * M                in a quarter so that the load is 0.3 to 1.02 of the one that diverges in L1,
 *                  as far as 0 < M <= 1e6 kg
 * k_s              1e5 to 1e7 N m/rad, even in the logarithm; rigid in a tenth
 * b                0 in a tenth, else 0 to 300 N m s^2/rad, half of them even, half even in
 *                  the logarithm from 1
 * V_top            50 to 400 m/s in a third; 5 to 60, even in the logarithm, in a sixth, so that
 *                  Hopf curves leave there; else 200
 */
#include "gears.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t stream_bits(struct stream *stream)
{
  uint64_t z = stream->state += 0x9e3779b97f4a7c15u;

  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double stream_next(struct stream *stream)
{
  return (double)(stream_bits(stream) >> 11) * 0x1p-53;
}

double stream_between(struct stream *stream, double lo, double hi)
{
  return lo + (hi - lo) * stream_next(stream);
}

static struct stream stream_of(uint64_t seed, int number)
{
  struct stream outer = { seed }, inner = { stream_bits(&outer) ^ ((uint64_t)number * 0xd1342543de82ef95u) };

  stream_bits(&inner);
  return inner;
}

struct oracle_gear random_gear(uint64_t seed, int number, double spread)
{
  struct stream stream = stream_of(seed, number);
  struct oracle_gear gear = oracle_paper();

  for (int i = 0; i < ORACLE_PARAMETER_COUNT; i++)
    *oracle_at(&gear, i) *= exp2(stream_between(&stream, -spread, spread));
  if (stream_next(&stream) < 0.5)
    gear.e = -gear.e;

  const double rake = stream_next(&stream);

  gear.phi *= rake < 0.1 ? 0. : rake < 0.35 ? -1. : 1.;
  if (stream_next(&stream) < 0.25) {
    struct oracle_gear probe = gear;
    const double wanted = stream_between(&stream, 0.3, 1.02);
    double lo = 0., hi = 1e8;

    for (int i = 0; i < 80; i++) { /* the least load that diverges, by halving in M */
      probe.M = lo + (hi - lo) / 2.;
      if (oracle_diverges(ORACLE_L1, &probe, NULL))
        hi = probe.M;
      else
        lo = probe.M;
    }
    gear.M = fmax(1., fmin(1e6, wanted * (lo + gear.m_D) - gear.m_D));
  }
  gear.k_s = stream_next(&stream) < 0.1 ? INFINITY : pow(10., stream_between(&stream, 5., 7.));

  const double which = stream_next(&stream), b = stream_next(&stream);

  gear.b = which < 0.1 ? 0. : which < 0.55 ? 300. * b : pow(300., b);

  const double range = stream_next(&stream);

  if (range < 1. / 3.)
    gear.V_top = stream_between(&stream, 50., 400.);
  else if (range < 1. / 2.)
    gear.V_top = 5. * pow(12., stream_next(&stream));
  return gear;
}

void random_doubts(struct oracle_gear *gear, uint64_t seed, int number, int kinds)
{
  struct stream stream = stream_of(seed + 0x5eed, number);
  double *const at[] = { &gear->zB_shared, &gear->R_moves, &gear->heading, &gear->I_p };

  for (int i = 0; i < 4; i++) {
    const double part = stream_next(&stream), whole = stream_next(&stream);

    if (kinds >> i & 1)
      *at[i] = i == 3 ? 20. * part : whole < 1. / 3. ? 1. : part;
  }
}

struct oracle_gear gear_in_units(uint64_t seed, int number, double k_s, double b, double *c_unit)
{
  struct stream stream = stream_of(~seed, number);
  const double F = pow(10., stream_between(&stream, -4., 4.)), T = pow(10., stream_between(&stream, -4., 4.));
  const double L = pow(10., stream_between(&stream, -4., 4.)), torque = F * L, mass = F * T * T / L;
  struct oracle_gear gear = oracle_paper();

  gear.k_s = k_s > 0. ? k_s * torque : INFINITY;
  gear.b = b * torque * T * T;
  gear.k_d *= torque, gear.k_psi *= torque, gear.k_delta *= torque;
  gear.c_psi *= torque * T, gear.c_delta *= torque * T;
  gear.a *= L, gear.e *= L, gear.l_delta *= L, gear.l_D *= L, gear.h *= L, gear.l *= L, gear.R *= L, gear.k_alpha *= L;
  gear.m_D *= mass, gear.M *= mass;
  gear.J_xi *= mass * L * L, gear.J_eta *= mass * L * L, gear.J_zeta *= mass * L * L;
  gear.k_t *= F / L;
  gear.g *= L / (T * T);
  gear.V_top *= L / T;
  *c_unit = torque * T;
  return gear;
}

void print_gear_names(void)
{
  for (int i = 0; i < ORACLE_PARAMETER_COUNT; i++)
    printf("%s,", oracle_name[i]);
  printf("V_top");
}

void print_gear(const struct oracle_gear *gear)
{
  struct oracle_gear copy = *gear;

  for (int i = 0; i < ORACLE_PARAMETER_COUNT; i++)
    printf("%.17g,", *oracle_at(&copy, i));
  printf("%.17g", gear->V_top);
}

bool read_gear(const char *text, struct oracle_gear *gear, const char **rest)
{
  for (int i = 0; i <= ORACLE_PARAMETER_COUNT; i++) {
    char *end;
    const double value = strtod(text, &end);

    if (end == text || (*end != ',' && *end != '\n' && *end != '\0'))
      return false;
    *(i < ORACLE_PARAMETER_COUNT ? oracle_at(gear, i) : &gear->V_top) = value;
    text = end + (*end == ',');
  }
  *rest = text;
  return true;
}

static void refuse(const char *argument, const char *wanted)
{
  fprintf(stderr, "random: %s: %s\n", argument, wanted);
  exit(2);
}

static double number(const char *argument, const char *text, double least, double most)
{
  char *end, wanted[80];
  double value;

  errno = 0;
  value = strtod(text, &end);
  snprintf(wanted, sizeof wanted, "expected a number from %.10g to %.10g", least, most);
  if (end == text || *end != '\0' || errno != 0 || !(value >= least && value <= most))
    refuse(argument, wanted);
  return value;
}

static int whole(const char *argument, const char *text, int least)
{
  const double value = number(argument, text, least, 1e9);

  if (value != floor(value))
    refuse(argument, "expected a whole number");
  return (int)value;
}

int read_layout(const char *argument, const char *name)
{
  char wanted[200] = "expected a layout:";
  int layout = 0;

  while (layout < ORACLE_LAYOUTS && strcmp(name, oracle_layout_name[layout]) != 0)
    layout++;
  if (layout == ORACLE_LAYOUTS) {
    for (layout = 0; layout < ORACLE_LAYOUTS; layout++)
      snprintf(wanted + strlen(wanted), sizeof wanted - strlen(wanted), " %s", oracle_layout_name[layout]);
    refuse(argument, wanted);
  }
  return layout;
}

struct options read_options(int n, char **argument, int cases)
{
  struct options o = { .cases = cases, .seed = 1, .spread = 1., .layout = -1 };

  for (int i = 0; i < n; i++) {
    const char *equals = strchr(argument[i], '='), *value = equals != NULL ? equals + 1 : argument[i];
    const size_t length = equals != NULL ? (size_t)(equals - argument[i]) : 0;

#define IS(name) (length == sizeof name - 1 && memcmp(argument[i], name, sizeof name - 1) == 0)
    if (equals == NULL)
      o.cases = whole(argument[i], value, 1);
    else if (IS("seed"))
      o.seed = (uint64_t)whole(argument[i], value, 0);
    else if (IS("case"))
      o.first = whole(argument[i], value, 0), o.cases = 1;
    else if (IS("first"))
      o.first = whole(argument[i], value, 0);
    else if (IS("spread"))
      o.spread = number(argument[i], value, 0., 10.);
    else if (IS("doubts"))
      o.doubts = (int)number(argument[i], value, 0., 15.);
    else if (IS("layout"))
      o.layout = read_layout(argument[i], value);
    else
      refuse(argument[i], "expected N, seed=, case=, first=, spread=, doubts= or layout=");
#undef IS
  }
  return o;
}
