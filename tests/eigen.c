/* eigen.c - boundaries of shimmy from eigenvalues, without AUTO
 *
 * Built once per layout, -DLAYOUT='"l1.c"' -o eigen-l1; eigen.h has the method.
 * Without arguments it prints its commands.
 */
#include LAYOUT

#include "eigen.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* plugin.h asks AUTO for these; func() does not. */
doublereal getp(const char *code, integer ic, const doublereal *u)
{
  (void)code, (void)ic, (void)u;
  return 0.;
}

void getmdmx_(const integer *ndim, double *P0, double *P1, int *known)
{
  (void)ndim, (void)P0, (void)P1;
  *known = 0;
}

static const char usage[] =
  "usage: %s command [name=value ...]\n"
  "  eigenvalues                      eigenvalues of straight rolling\n"
  "  boundary free=NAME from= to= [step=]\n"
  "                                   all Hopf points along a parameter; the step is\n"
  "                                   1/400 of the range by default\n"
  "  hh V= c_d=                       double-Hopf point near a guess\n"
  "  fold V= c_d=                     extremum of c_d along a Hopf curve near a guess\n"
  "  centre free=NAME V= c_d=         the value of a third parameter, near a guess of all\n"
  "                                   three, at which two Hopf curves in V and c_d meet or\n"
  "                                   a closed one appears\n"
  "  interval [V_lo=0.1 V_hi=200 step=0.05 c_d_lo=100 c_d_hi=1e5 c_d_steps=300]\n"
  "                                   intervals of c_d without shimmy at any V\n"
  "  folds                            as fold, for each line V,c_d,k_s,b of standard input\n"
  "  map [V_lo=0.5 V_hi=200 V_n=400 c_d_lo=250 c_d_hi=1e5 c_d_n=400]\n"
  "                                   number of unstable pairs on a grid, as CSV\n"
  "Other names are those of the parameters (models/mlg.h), in SI units.\n";

static _Noreturn void refuse(const char *word, const char *right)
{
  fprintf(stderr, "eigen: '%s': %s\n", word, right);
  exit(2);
}

/* The number behind the = of word. */
static double number_of(const char *word)
{
  const char *equals = strchr(word, '=');
  char *end = NULL;
  const double value = equals ? strtod(equals + 1, &end) : 0.;

  if (!equals || end == equals + 1 || *end != '\0' || !isfinite(value))
    refuse(word, "expected NAME=NUMBER");
  return value;
}

/* Sets the parameter that word names and returns its slot. */
static int set_parameter(double par[], const char *word)
{
  const struct mlg_parameter *p = mlg_find(word, strcspn(word, "="));

  if (p == NULL)
    refuse(word, "no such parameter (see models/mlg.h)");
  par[p->slot] = number_of(word);
  if (!mlg_in_range(p, par[p->slot]))
    refuse(word, "outside its range");
  return p->slot;
}

/* What a command takes besides parameters. */
struct option { const char *name; double value; bool given; };

/* Reads name=value arguments.  A command that wants free=NAME passes free_slot. */
static void read_arguments(int n, char **argument, double par[], bool given[],
                           struct option option[], int *free_slot)
{
  for (int i = 0; i < n; i++) {
    const size_t length = strcspn(argument[i], "=");
    struct option *o = option;

    while (o->name != NULL && (strlen(o->name) != length || strncmp(o->name, argument[i], length) != 0))
      o++;
    if (free_slot != NULL && strncmp(argument[i], "free=", 5) == 0) {
      const struct mlg_parameter *which = mlg_find(argument[i] + 5, strlen(argument[i] + 5));

      if (which == NULL)
        refuse(argument[i], "no such parameter (see models/mlg.h)");
      *free_slot = which->slot;
    } else if (o->name != NULL) {
      o->value = number_of(argument[i]);
      o->given = true;
    } else {
      given[set_parameter(par, argument[i])] = true;
    }
  }
}

static const char *name_of(int slot)
{
  for (int i = 0; i < MLG_PARAMETER_COUNT; i++)
    if (mlg_parameters[i].slot == slot)
      return mlg_parameters[i].name;
  return "?";
}

/* The parameters that a command varies must come as a guess, or not at all. */
static void want(const bool given[], int slot, bool guess)
{
  if (given[slot] != guess)
    refuse(name_of(slot), guess ? "a guess is wanted, name=value" : "this command sets it itself");
}

static int print_eigenvalues(int n, char **argument)
{
  struct option option[] = { { NULL, 0., false } };
  double par[EIGEN_SLOTS] = { 0. };
  bool given[EIGEN_SLOTS] = { false };

  mlg_defaults(par);
  read_arguments(n, argument, par, given, option, NULL);
  const struct eigen_values e = eigen_values(par);

  printf("%24s %24s %20s\n", "real_part", "imaginary_part", "frequency_hz");
  for (int i = 0; i < NDIM; i++)
    printf("%24.16e %24.16e %20.12g\n", e.re[i], e.im[i], e.im[i] / (2. * MLG_PI));
  return 0;
}

static int print_boundary(int n, char **argument)
{
  enum { FROM, TO, STEP, ROOM = 1000 };
  static struct eigen_crossing crossing[ROOM];
  struct option option[] = {
    { "from", 0., false }, { "to", 0., false }, { "step", 0., false }, { NULL, 0., false }
  };
  double par[EIGEN_SLOTS] = { 0. };
  bool given[EIGEN_SLOTS] = { false };
  int slot = -1;

  mlg_defaults(par);
  read_arguments(n, argument, par, given, option, &slot);
  if (slot < 0 || !option[FROM].given || !option[TO].given)
    refuse("boundary", "free=NAME, from= and to= are wanted");
  want(given, slot, false);
  if (!(option[TO].value > option[FROM].value))
    refuse("boundary", "to= has to be above from=");
  if (!option[STEP].given)
    option[STEP].value = (option[TO].value - option[FROM].value) / 400.;
  if (!(option[STEP].value >= 1e-6 * (option[TO].value - option[FROM].value)))
    refuse("step", "it has to be above a millionth of the range");

  const int found = eigen_crossings(par, slot, option[FROM].value, option[TO].value,
                                    option[STEP].value, crossing, ROOM);

  printf("%20s %18s %18s  %s\n", name_of(slot), "frequency_hz", "delta_over_psi", "mode");
  for (int i = 0; i < found && i < ROOM; i++)
    printf("%20.13g %18.12g %18.12g  %s%s\n", crossing[i].at, crossing[i].frequency_hz,
           crossing[i].delta_over_psi, crossing[i].loses_stability ? "loses stability" : "regains stability",
           crossing[i].frequency_hz > 0. ? "" : " (real eigenvalue: no Hopf point)");
  return 0;
}

static int print_point(enum eigen_condition condition, int n, char **argument)
{
  struct option option[] = { { NULL, 0., false } };
  double par[EIGEN_SLOTS] = { 0. };
  bool given[EIGEN_SLOTS] = { false };
  int slot[3] = { PAR_V, PAR_C_D, -1 };
  const int unknowns = condition == EIGEN_CENTRE ? 3 : 2;
  double _Complex mode[2] = { 0. };

  mlg_defaults(par);
  read_arguments(n, argument, par, given, option, unknowns == 3 ? &slot[2] : NULL);
  if (unknowns == 3 && slot[2] < 0)
    refuse("centre", "free=NAME is wanted");
  for (int i = 0; i < unknowns; i++)
    want(given, slot[i], true);
  const double change = eigen_refine(condition, par, slot);

  if (change < 0.) {
    fprintf(stderr, "no such point near the guess: Newton's method does not converge\n");
    return 1;
  }
  eigen_critical(par, mode);
  for (int i = 0; i < unknowns; i++)
    printf("%20s = %.13g\n", name_of(slot[i]), par[slot[i]]);
  for (int i = 0; i < (condition == EIGEN_HH ? 2 : 1); i++) {
    const struct eigen_mode m = eigen_mode(par, mode[i]);

    printf("%20s = %.12g\n%20s = %.12g\n%20s = %.1e\n", "frequency_hz", m.frequency_hz,
           "delta_over_psi", m.delta_over_psi, "real_part", creal(m.value));
  }
  printf("%20s = %.1e\n", "last_change", change);
  return 0;
}

static int print_intervals(int n, char **argument)
{
  enum { V_LO, V_HI, STEP, C_D_LO, C_D_HI, C_D_STEPS, ROOM = 100 };
  static struct eigen_interval interval[ROOM];
  struct option option[] = {
    { "V_lo", 0.1, false }, { "V_hi", 200., false }, { "step", 0.05, false },
    { "c_d_lo", 100., false }, { "c_d_hi", 1e5, false }, { "c_d_steps", 300., false },
    { NULL, 0., false }
  };
  double par[EIGEN_SLOTS] = { 0. };
  bool given[EIGEN_SLOTS] = { false };

  mlg_defaults(par);
  read_arguments(n, argument, par, given, option, NULL);
  want(given, PAR_V, false);
  want(given, PAR_C_D, false);
  if (!(option[V_LO].value >= 0. && option[V_HI].value > option[V_LO].value && option[STEP].value >= 1e-4
        && option[C_D_LO].value > 0. && option[C_D_HI].value > option[C_D_LO].value
        && option[C_D_STEPS].value >= 2. && option[C_D_STEPS].value <= 1e6))
    refuse("interval", "0 <= V_lo < V_hi, step >= 1e-4, 0 < c_d_lo < c_d_hi and c_d_steps >= 2 are wanted");
  const struct eigen_scan scan = { option[V_LO].value, option[V_HI].value, option[STEP].value,
                                   option[C_D_LO].value, option[C_D_HI].value,
                                   (int)option[C_D_STEPS].value };
  const int found = eigen_intervals(par, &scan, interval, ROOM);

  printf("%18s %18s %18s  %s\n", "c_d", "V", "frequency_hz", "end");
  for (int i = 0; i < found && i < ROOM; i++)
    for (int end = 0; end < 2; end++)
      if (interval[i].open[end])
        printf("%18.12g %18s %18s  %s (of the scan)\n", interval[i].c_d[end], "-", "-", end ? "upper" : "lower");
      else
        printf("%18.12g %18.12g %18.12g  %s\n", interval[i].c_d[end], interval[i].V[end],
               interval[i].frequency_hz[end], end ? "upper" : "lower");
  return 0;
}

static int print_map(int n, char **argument)
{
  enum { V_LO, V_HI, V_N, C_D_LO, C_D_HI, C_D_N };
  struct option option[] = {
    { "V_lo", 0.5, false }, { "V_hi", 200., false }, { "V_n", 400., false },
    { "c_d_lo", 250., false }, { "c_d_hi", 1e5, false }, { "c_d_n", 400., false },
    { NULL, 0., false }
  };
  double par[EIGEN_SLOTS] = { 0. };
  bool given[EIGEN_SLOTS] = { false };

  mlg_defaults(par);
  read_arguments(n, argument, par, given, option, NULL);
  want(given, PAR_V, false);
  want(given, PAR_C_D, false);
  if (!(option[V_LO].value >= 0. && option[V_HI].value > option[V_LO].value && option[C_D_LO].value >= 0.
        && option[C_D_HI].value > option[C_D_LO].value && option[V_N].value >= 2. && option[V_N].value <= 1e5
        && option[C_D_N].value >= 2. && option[C_D_N].value <= 1e5))
    refuse("map", "0 <= V_lo < V_hi, 0 <= c_d_lo < c_d_hi and 2 <= V_n, c_d_n <= 1e5 are wanted");
  const int V_n = (int)option[V_N].value, c_d_n = (int)option[C_D_N].value;

  printf("V,c_d,unstable_pairs\n");
  for (int j = 0; j < c_d_n; j++)
    for (int i = 0; i < V_n; i++) {
      par[PAR_V] = option[V_LO].value + (option[V_HI].value - option[V_LO].value) * i / (V_n - 1);
      par[PAR_C_D] = option[C_D_LO].value + (option[C_D_HI].value - option[C_D_LO].value) * j / (c_d_n - 1);
      const struct eigen_values e = eigen_values(par);

      printf("%.10g,%.10g,%d\n", par[PAR_V], par[PAR_C_D], eigen_unstable_pairs(&e));
    }
  return 0;
}

/* A line V,c_d,k_s,b of standard input into par; false at the end of the input. */
static bool read_point(double par[])
{
  static int line = 0;
  char text[256], *at = text;
  double *const into[] = { &par[PAR_V], &par[PAR_C_D], &par[PAR_K_S], &par[PAR_B] };

  line++;
  if (fgets(text, sizeof text, stdin) == NULL)
    return false;
  for (int i = 0; i < 4; i++) {
    char *end;

    *into[i] = strtod(at, &end);
    if (end == at || *end != (i < 3 ? ',' : '\n')) {
      fprintf(stderr, "standard input:%d: '%.*s': expected V,c_d,k_s,b\n", line, (int)strcspn(text, "\n"), text);
      exit(2);
    }
    at = end + 1;
  }
  return true;
}

static int print_folds(int n, char **argument)
{
  struct option option[] = { { NULL, 0., false } };
  static const int slot[2] = { PAR_V, PAR_C_D };
  double par[EIGEN_SLOTS] = { 0. };
  bool given[EIGEN_SLOTS] = { false };

  mlg_defaults(par);
  read_arguments(n, argument, par, given, option, NULL);
  printf("V,c_d\n");
  while (read_point(par)) {
    const bool found = eigen_refine(EIGEN_FOLD, par, slot) >= 0.;

    printf(found ? "%.13g,%.13g\n" : ",\n", par[PAR_V], par[PAR_C_D]);
  }
  return 0;
}

int main(int argc, char **argv)
{
  const char *command = argc > 1 ? argv[1] : "";
  const int n = argc - 2;
  char **argument = argv + 2;
  int status;

  if (strcmp(command, "eigenvalues") == 0)
    status = print_eigenvalues(n, argument);
  else if (strcmp(command, "boundary") == 0)
    status = print_boundary(n, argument);
  else if (strcmp(command, "hh") == 0)
    status = print_point(EIGEN_HH, n, argument);
  else if (strcmp(command, "fold") == 0)
    status = print_point(EIGEN_FOLD, n, argument);
  else if (strcmp(command, "centre") == 0)
    status = print_point(EIGEN_CENTRE, n, argument);
  else if (strcmp(command, "interval") == 0)
    status = print_intervals(n, argument);
  else if (strcmp(command, "folds") == 0)
    status = print_folds(n, argument);
  else if (strcmp(command, "map") == 0)
    status = print_map(n, argument);
  else {
    fprintf(stderr, usage, argv[0]);
    return 2;
  }
  if (fflush(stdout) != 0 || ferror(stdout)) {
    fprintf(stderr, "eigen: cannot write the output: %s\n", strerror(errno));
    return 1;
  }
  return status;
}
