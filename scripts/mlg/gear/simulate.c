/* simulate.c - a layout in time, from any start: history, section, orbit, growth */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"

static const char details[] =
  "WHAT  history            states over time\n"
  "      section STATE WAY  states where one of them passes 0, WAY up or down:\n"
  "                         dpsi down are the maxima of psi\n"
  "      orbit              the oscillation it settles on\n"
  "      growth             how fast a small one grows\n"
  "NAME  also a state at t = 0, 0 unless given; straight rolling stays straight, so\n"
  "      one at least has to be given, as psi=0.05;\n"
  "      t_end, s: where to end (10; section 100, growth 20), or when to give up\n"
  "      (orbit, 5000); dt, s: between two rows of a history (0.001);\n"
  "      rtol: relative tolerance of a step (1e-10)\n"
  "\n"
  "Prints CSV: lines that begin with # say the parameters and the units, SI, angles in\n"
  "rad (psi_max in deg); then the names of the columns, then rows.\n"
  "  history, section  t, the states, dstar (lateral deflection delta* = l_delta\n"
  "                    delta, m), T_d (torque of the device, N m), event: section, or\n"
  "                    limit: there a slip angle passes alpha_m\n"
  "  orbit   period, frequency_hz, psi_max, dstar_max (maxima over the period), maxima\n"
  "          of psi in a period, change: how far, by the rate at which it converges, its\n"
  "          states are from those at t = infinity, relative to the oscillation; t:\n"
  "          how long it took; limits: in the last period; shimmy (psi, delta: the larger\n"
  "          angle); the states at a maximum of psi\n"
  "  growth  rate, 1/s, and frequency_hz from the maxima of psi between t_end/2 and\n"
  "          t_end; change: the rate of the second half of these less that of the\n"
  "          first; the first and the last maximum, rad, and how many\n"
  "Status 1 when there is no oscillation to describe or the integration fails.\n";

static const char name[] = "simulate";
static struct arguments given;
static struct libmlg_run run;
static double t_end;

/* On to t or to what comes before; failures end the program. */
static int advance(double t)
{
  const int reached = libmlg_run_to(&run, t);

  if (reached == LIBMLG_FAILED)
    fail(name, MLG_FAILED, "%s", run.error);
  return reached;
}

/* On to the next crossing of the section, over limits; 0 when t_end comes first. */
static int next_crossing(double t)
{
  int reached;

  do
    reached = advance(t);
  while (reached == LIBMLG_AT_LIMIT);
  return reached == LIBMLG_AT_SECTION;
}

static void print_head(const char *columns)
{
  for (int i = 0; i < libmlg_parameters(); i++) {
    const struct libmlg_quantity *q = libmlg_parameter_quantity(i);

    printf("%s%s = %.11g%s%s", i == 0 ? "# " : ", ", q->name, given.par[i], *q->unit ? " " : "", q->unit);
  }
  printf("\n# t s; period s; rate 1/s; psi_max deg; dstar, dstar_max m; T_d N m");
  for (int i = 0; i < libmlg_states(given.layout); i++) {
    const struct libmlg_quantity *q = libmlg_state_quantity(given.layout, i);

    printf("; %s %s", q->name, q->unit);
  }
  printf("\n%s", columns);
}

static void print_states(void)
{
  for (int i = 0; i < libmlg_states(given.layout); i++)
    printf(",%.11g", run.u[i]);
}

static void print_state_names(void)
{
  for (int i = 0; i < libmlg_states(given.layout); i++)
    printf(",%s", libmlg_state_quantity(given.layout, i)->name);
}

static double dstar(void)
{
  return given.par[NUMBER_L_DELTA] * run.u[DELTA];
}

static void print_row(const char *event)
{
  double T_d;

  libmlg_torque(given.layout, given.par, run.u, &T_d);
  printf("%.11g", run.t);
  print_states();
  printf(",%.11g,%.11g,%s\n", dstar(), T_d, event);
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
    const int reached = advance(dt > 0. ? fmin(n * dt, t_end) : t_end);

    if (reached != LIBMLG_AT_TIME)
      print_row(reached == LIBMLG_AT_LIMIT ? "limit" : "section");
    else if (n++, dt > 0.)
      print_row("");
  }
}

/* The distance between two states, relative to the size of the oscillation. */
static double distance(const double u[], const double v[])
{
  double largest = 0.;

  for (int i = 0; i < libmlg_states(given.layout); i++)
    largest = fmax(largest, fabs(u[i] - v[i]) / libmlg_state_size(given.layout, i));
  return largest / libmlg_oscillation_size(given.layout, u);
}

/* Settles, and prints what on.  The maxima of psi are compared with those one
 * period, k of them, earlier, in blocks; k is the least that brings them within
 * 1e-3.  From block to block their distance falls by a ratio, so that what is left
 * to go is the rest of a geometric series. */
static void print_orbit(void)
{
  enum { MOST = 8, BLOCK = 50 };
  const double accuracy = 1e-6, least = 1e-6 * libmlg_oscillation_size(given.layout, run.u);
  struct { double t, u[LIBMLG_MOST_STATES]; } ring[MOST + 1], *now = NULL;
  double moved[MOST + 1] = { 0. }, before[MOST + 1] = { 0. }, change = INFINITY;
  double psi_max = -INFINITY, dstar_max = -INFINITY, period = 0.;
  int k = 1;
  long limits;

  libmlg_run_section(&run, DPSI, -1);
  for (long n = 0; !(change < accuracy); n++) {
    if (!next_crossing(t_end))
      fail(name, MLG_FAILED, "not settled at t = %g s, after %ld maxima of psi: it still changes by %.1e of its size in a period",
           t_end, n, n < BLOCK ? 1. : before[k]);
    if (libmlg_oscillation_size(given.layout, run.u) < least)
      fail(name, MLG_FAILED, "t = %.4g s: the oscillation has died out", run.t);
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
  libmlg_run_section(&run, DDELTA, -1);
  while (next_crossing(now->t + period * (1. + 1e-6)))
    dstar_max = fmax(dstar_max, dstar());
  print_head("period,frequency_hz,psi_max,dstar_max,maxima,change,t,limits,shimmy");
  print_state_names();
  printf("\n%.11g,%.11g,%.11g,%.11g,%d,%.1e,%.5g,%ld,%s", period, 1. / period, psi_max * 180. / MLG_PI,
         dstar_max, k, change, now->t, run.limits - limits, dstar_max > given.par[NUMBER_L_DELTA] * psi_max ? "delta" : "psi");
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
  libmlg_run_section(&run, DPSI, -1);
  while (next_crossing(t_end)) {
    if (!(run.u[PSI] > 0.))
      fail(name, MLG_FAILED, "t = %g s: a maximum of psi below 0: this is no oscillation about straight rolling", run.t);
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
    fail(name, MLG_FAILED, "fewer than 4 maxima of psi between t = %g and %g s", 0.5 * t_end, t_end);
  print_head("rate,frequency_hz,change,psi_first,psi_last,maxima,limits\n");
  printf("%.11g,%.11g,%.1e,%.5g,%.5g,%g,%ld\n", slope(&all), (all.n - 1.) / (t_last - t_first),
         slope(&half[1]) - slope(&half[0]), first, last, all.n, run.limits);
}

/* The states at t = 0, then settings. */
enum { MOST_OPTIONS = LIBMLG_MOST_STATES + 4 };

static void options(struct option option[MOST_OPTIONS], int layout, double end)
{
  const int n = libmlg_states(layout);
  const struct option setting[] = {
    { "t_end", "s", 1e-9, 1e9, end, NULL }, { "dt", "s", 1e-9, 1e9, 1e-3, NULL },
    { "rtol", "-", 1e-14, 1e-3, 1e-10, NULL }, { NULL, NULL, 0., 0., 0., NULL },
  };

  for (int i = 0; i < n; i++) {
    const struct libmlg_quantity *q = libmlg_state_quantity(layout, i);

    option[i] = (struct option){ q->name, q->unit, -1e6, 1e6, 0., NULL };
  }
  memcpy(option + n, setting, sizeof setting);
}

static int simulate(int argc, char *argv[])
{
  static const struct { const char *name; double t_end; } what[] = {
    { "history", 10. }, { "section", 100. }, { "orbit", 5000. }, { "growth", 20. },
  };
  enum { HISTORY, SECTION, ORBIT, GROWTH, WHATS };
  struct option option[MOST_OPTIONS];
  double start[LIBMLG_MOST_STATES] = { 0. };
  int k = 0, section = -1, direction = 0;

  begin_arguments(&given, argc, argv, option);
  while (k < WHATS && (argc < 3 || strcmp(argv[2], what[k].name) != 0))
    k++;
  if (k == SECTION && argc > 4)
    direction = strcmp(argv[4], "up") == 0 ? 1 : strcmp(argv[4], "down") == 0 ? -1 : 0;
  if (k == WHATS || (k == SECTION && direction == 0))
    fail(name, MLG_BAD_INPUT, "expected LAYOUT history|orbit|growth|section STATE up|down [NAME=VALUE ...]");
  if (k == SECTION && (section = libmlg_state(given.layout, argv[3])) == LIBMLG_NONE)
    refuse(name, argv[3], "no state of layout %s", argv[1]);
  options(option, given.layout, what[k].t_end);
  for (int i = k == SECTION ? 5 : 3; i < argc; i++)
    take_word(&given, argv[i]);
  end_arguments(&given);

  const int n = libmlg_states(given.layout);
  const struct option *const setting = option + n;

  for (int i = 0; i < n; i++)
    start[i] = option[i].value;
  if (libmlg_oscillation_size(given.layout, start) < 1e-11)
    fail(name, MLG_BAD_INPUT, "the gear starts straight and stays so: give a state, as psi=0.05");
  if (fmax(fabs(start[DELTA]), fabs(start[PSI])) > MLG_PI / 2.)
    fail(name, MLG_BAD_INPUT, "delta=%g psi=%g: an angle beyond pi/2", start[DELTA], start[PSI]);
  t_end = setting[0].value;
  if (libmlg_run_begin(&run, given.layout, setting[2].value) != 0)
    fail(name, MLG_FAILED, "out of memory");
  libmlg_run_start(&run, given.par, start);
  libmlg_run_section(&run, section, direction);
  switch (k) {
  case HISTORY: print_rows(setting[1].value); break;
  case SECTION: print_rows(0.); break;
  case ORBIT: print_orbit(); break;
  case GROWTH: print_growth(); break;
  }
  libmlg_run_end(&run);
  return output_status(name);
}

const struct command command_simulate = {
  .name = name,
  .usage = "LAYOUT WHAT [NAME=VALUE ...]",
  .summary = "a layout in time, from any start",
  .details = details,
  .run = simulate,
};
