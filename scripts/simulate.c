/* simulate - a layout in time, from any start
 *
 *   simulate-LAYOUT history            [NAME=VALUE ...]  states over time
 *   simulate-LAYOUT section STATE WAY  [NAME=VALUE ...]  states where one of them passes 0
 *   simulate-LAYOUT orbit              [NAME=VALUE ...]  the oscillation it settles on
 *   simulate-LAYOUT growth             [NAME=VALUE ...]  how fast a small one grows
 *
 * NAME   a parameter of models/mlg.h, or compliance (1e5/k_s; 0 is rigid);
 *        a state at t = 0, 0 unless given; straight rolling stays straight, so
 *        one at least has to be given, as psi=0.05;
 *        t_end, s: where to end (10; section 100, growth 20), or when to give up (orbit, 5000);
 *        dt, s: between two rows of a history (0.001);
 *        rtol: relative tolerance of a step (1e-10)
 * STATE  one of the layout; WAY up or down: dpsi down are the maxima of psi
 *
 * All print CSV: lines that begin with # say the parameters and the units, SI,
 * angles in rad (psi_max in deg); then the names of the columns, then rows.
 *   history, section   t, the states, dstar (lateral deflection delta* = l_delta
 *                      delta, m), T_d (torque of the device, N m), event: section,
 *                      or limit: there a slip angle passes alpha_m
 *   orbit   period, frequency_hz, psi_max, dstar_max (maxima over the period), maxima
 *           of psi in a period, change: how far, by the rate at which it converges, its
 *           states are from those at t = infinity, relative to the oscillation; t:
 *           how long it took; limits: in the last period; the states at a maximum of psi
 *   growth  rate, 1/s, and frequency_hz from the maxima of psi between t_end/2 and
 *           t_end; change: the rate of the second half of these less that of the
 *           first; the first and the last maximum, rad, and how many
 *
 * Integration is integrate.h's.  Status 0; 1 when there is no oscillation to
 * describe or the integration fails, 2 at bad input; one line says which.
 */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

#define MLG_NO_AUTO
#include LAYOUT
#include "integrate.h"
#include "arguments.h"

static struct integrator run;
static double t_end;

static _Noreturn void fail(int status, const char *format, ...)
{
  va_list arguments;

  va_start(arguments, format);
  fprintf(stderr, "simulate: ");
  vfprintf(stderr, format, arguments);
  fprintf(stderr, "\n");
  va_end(arguments);
  exit(status);
}

/* On to t or to what comes before; failures end the program. */
static enum reached advance(double t)
{
  const enum reached reached = integrator_advance(&run, t);

  if (reached == FAILED)
    fail(1, "%s", run.error);
  return reached;
}

/* On to the next crossing of the section, over limits; 0 when t_end comes first. */
static int next_crossing(double t)
{
  enum reached reached;

  do
    reached = advance(t);
  while (reached == AT_LIMIT);
  return reached == AT_SECTION;
}

static void print_head(const char *columns)
{
#define X(slot, id, name, unit, value, least, most, meaning) \
  printf("%s%s = %.11g%s%s", slot == 1 ? "# " : ", ", name, run.par[PAR_##id], *unit ? " " : "", unit);
  MLG_PARAMETERS(X)
#undef X
  printf("\n# t s; period s; rate 1/s; psi_max deg; dstar, dstar_max m; T_d N m");
#define X(id, name, unit, meaning) printf("; %s %s", name, unit);
  MLG_STATES(X)
#undef X
  printf("\n%s", columns);
}

static void print_states(void)
{
  for (int i = 0; i < NDIM; i++)
    printf(",%.11g", run.u[i]);
}

static void print_state_names(void)
{
#define X(id, name, unit, meaning) printf("," name);
  MLG_STATES(X)
#undef X
}

static void print_row(const char *event)
{
  double du[NDIM];

  printf("%.11g", run.t);
  print_states();
  printf(",%.11g,%.11g,%s\n", run.par[PAR_L_DELTA] * run.u[DELTA], device(run.par, run.u, du), event);
}

/* A row every dt, and at each section and limit between; with dt = 0 only these. */
static void print_rows(double dt)
{
  print_head("t");
  print_state_names();
  printf(",dstar,T_d,event\n");
  if (dt > 0.)
    print_row("");
  for (double n = 1.; run.t < t_end; ) {
    const enum reached reached = advance(dt > 0. ? fmin(n * dt, t_end) : t_end);

    if (reached != AT_TIME)
      print_row(reached == AT_LIMIT ? "limit" : "section");
    else if (n++, dt > 0.)
      print_row("");
  }
}

/* The distance between two states, relative to the size of the oscillation. */
static double distance(const double u[], const double v[])
{
  double largest = 0.;

  for (int i = 0; i < NDIM; i++)
    largest = fmax(largest, fabs(u[i] - v[i]) / state_size[i]);
  return largest / oscillation_size(u);
}

/* Settles, and prints what on.  The maxima of psi are compared with those one
 * period, k of them, earlier, in blocks; k is the least that brings them within
 * 1e-3.  From block to block their distance falls by a ratio, so that what is left
 * to go is the rest of a geometric series. */
static void print_orbit(void)
{
  enum { MOST = 8, BLOCK = 50 };
  const double accuracy = 1e-6, least = 1e-6 * oscillation_size(run.u);
  struct { double t, u[NDIM]; } ring[MOST + 1], *now = NULL;
  double moved[MOST + 1] = { 0. }, before[MOST + 1] = { 0. }, change = INFINITY;
  double psi_max = -INFINITY, dstar_max = -INFINITY, period = 0.;
  int k = 1;
  long limits;

  integrator_section(&run, DPSI, -1);
  for (long n = 0; !(change < accuracy); n++) {
    if (!next_crossing(t_end))
      fail(1, "not settled at t = %g s, after %ld maxima of psi: it still changes by %.1e of its size in a period",
           t_end, n, n < BLOCK ? 1. : before[k]);
    if (oscillation_size(run.u) < least)
      fail(1, "t = %.4g s: the oscillation has died out", run.t);
    now = &ring[n % (MOST + 1)];
    now->t = run.t;
    memcpy(now->u, run.u, sizeof now->u);
    for (int j = 1; j <= MOST && j <= n; j++)
      moved[j] = fmax(moved[j], distance(now->u, ring[(n - j) % (MOST + 1)].u));
    if ((n + 1) % BLOCK == 0) {
      k = 1;
      for (int j = MOST; j >= 1; j--)
        if (moved[j] < 1e-3)
          k = j;
      const double ratio = fmin(moved[k] / before[k], 0.99);

      change = moved[k] * BLOCK / k * ratio / (1. - ratio);
      memcpy(before, moved, sizeof before);
      memset(moved, 0, sizeof moved);
    }
  }

  for (int j = 0; j < k; j++)
    psi_max = fmax(psi_max, ring[(now - ring + MOST + 1 - j) % (MOST + 1)].u[PSI]);
  period = now->t - ring[(now - ring + MOST + 1 - k) % (MOST + 1)].t;
  limits = run.limits;
  integrator_section(&run, DDELTA, -1);
  while (next_crossing(now->t + period * (1. + 1e-6)))
    dstar_max = fmax(dstar_max, run.par[PAR_L_DELTA] * run.u[DELTA]);
  print_head("period,frequency_hz,psi_max,dstar_max,maxima,change,t,limits");
  print_state_names();
  printf("\n%.11g,%.11g,%.11g,%.11g,%d,%.1e,%.5g,%ld", period, 1. / period, psi_max * 180. / MLG_PI,
         dstar_max, k, change, now->t, run.limits - limits);
  memcpy(run.u, now->u, sizeof run.u);
  print_states();
  printf("\n");
}

/* A straight line through log(maximum) over time. */
struct line { double n, t, y, tt, ty; };

static void add(struct line *line, double t, double y)
{
  line->n += 1.;
  line->t += t;
  line->y += y;
  line->tt += t * t;
  line->ty += t * y;
}

static double slope(const struct line *line)
{
  return (line->n * line->ty - line->t * line->y) / (line->n * line->tt - line->t * line->t);
}

static void print_growth(void)
{
  const double middle = 0.75 * t_end; /* of the maxima that count */
  struct line all = { 0 }, half[2] = { { 0 } };
  double t_first = 0., t_last = 0., first = 0., last = 0.;

  next_crossing(0.5 * t_end); /* there is no section yet */
  integrator_section(&run, DPSI, -1);
  while (next_crossing(t_end)) {
    if (!(run.u[PSI] > 0.))
      fail(1, "t = %g s: a maximum of psi below 0: this is no oscillation about straight rolling", run.t);
    t_last = run.t;
    last = run.u[PSI];
    if (all.n == 0.) {
      t_first = t_last;
      first = last;
    }
    add(&all, t_last - middle, log(last));
    add(&half[t_last > middle], t_last - middle, log(last));
  }
  if (half[0].n < 2. || half[1].n < 2.)
    fail(1, "fewer than 4 maxima of psi between t = %g and %g s", 0.5 * t_end, t_end);
  print_head("rate,frequency_hz,change,psi_first,psi_last,maxima,limits\n");
  printf("%.11g,%.11g,%.1e,%.5g,%.5g,%g,%ld\n", slope(&all), (all.n - 1.) / (t_last - t_first),
         slope(&half[1]) - slope(&half[0]), first, last, all.n, run.limits);
}

/* What a run is given besides parameters: its states at t = 0, in their slots,
 * and settings. */
enum { T_END = NDIM, DT, RTOL, GIVEN };

static const struct mlg_parameter given_names[] = {
#define X(id, name, unit, meaning) { id, name, unit, -1e6, 1e6 },
  MLG_STATES(X)
#undef X
  { T_END, "t_end", "s", 1e-9, 1e9 },
  { DT, "dt", "s", 1e-9, 1e9 },
  { RTOL, "rtol", "", 1e-14, 1e-3 },
};

static void set(double par[], double given[], const char *word)
{
  size_t length;
  const double value = number_of("simulate", word, &length);

  for (int i = 0; i < GIVEN; i++)
    if (strlen(given_names[i].name) == length && memcmp(given_names[i].name, word, length) == 0) {
      given[i] = in_range("simulate", word, &given_names[i], value);
      return;
    }
  set_parameter("simulate", par, word);
}

int main(int argc, char *argv[])
{
  static const struct { const char *name; double t_end; } command[] = {
    { "history", 10. }, { "section", 100. }, { "orbit", 5000. }, { "growth", 20. },
  };
  enum { HISTORY, SECTION_ROWS, ORBIT, GROWTH, COMMANDS };
  double par[36] = { 0. }, given[GIVEN] = { [DT] = 1e-3, [RTOL] = 1e-10 };
  int what = 0, section = -1, direction = 0;

  while (what < COMMANDS && (argc < 2 || strcmp(argv[1], command[what].name) != 0))
    what++;
  if (what == SECTION_ROWS && argc > 3)
    direction = strcmp(argv[3], "up") == 0 ? 1 : strcmp(argv[3], "down") == 0 ? -1 : 0;
  if (what == COMMANDS || (what == SECTION_ROWS && direction == 0))
    fail(2, "usage: simulate history|orbit|growth|section STATE up|down [NAME=VALUE ...]");
  if (what == SECTION_ROWS) {
    for (int i = 0; i < NDIM; i++)
      if (strcmp(argv[2], given_names[i].name) == 0)
        section = i;
    if (section < 0)
      refuse("simulate", argv[2], "no state of this layout");
  }
  mlg_defaults(par);
  given[T_END] = command[what].t_end;
  for (int i = what == SECTION_ROWS ? 4 : 2; i < argc; i++)
    set(par, given, argv[i]);
  if (oscillation_size(given) < 1e-11)
    fail(2, "the gear starts straight and stays so: give a state, as psi=0.05");
  if (fmax(fabs(given[DELTA]), fabs(given[PSI])) > MLG_PI / 2.)
    fail(2, "delta=%g psi=%g: an angle beyond pi/2", given[DELTA], given[PSI]);
  t_end = given[T_END];
  if (integrator_begin(&run, given[RTOL]) != 0)
    fail(1, "out of memory");
  integrator_start(&run, par, given);
  integrator_section(&run, section, direction);
  switch (what) {
  case HISTORY: print_rows(given[DT]); break;
  case SECTION_ROWS: print_rows(0.); break;
  case ORBIT: print_orbit(); break;
  case GROWTH: print_growth(); break;
  }
  integrator_end(&run);
  return output_status("simulate");
}
