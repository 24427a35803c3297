/* networks.c - every small network: how many there are, and which are one
 *
 * A network of two ends is series-parallel when one may take it apart by splitting it where
 * it is side by side or one behind the other, over and over.  The smallest that is not, the
 * bridge, has five elements.  So all networks of up to four are texts of device_text.h:
 * sets of elements divided into parts that stand side by side or in series, each divided the
 * other way, and so on.
 */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "device_text.h"
#include "networks.h"

/* --- enumeration ------------------------------------------------------------------------ */

enum { MOST_NAMES = 6 };

static void add_text(struct texts *list, const char *a, char operation, const char *b)
{
  if (list->n == list->room) {
    list->room = list->room ? 2 * list->room : 64;
    list->text = realloc(list->text, (size_t)list->room * sizeof *list->text);
    if (!list->text)
      fail("networks", MLG_FAILED, "out of memory");
  }
  if (b)
    snprintf(list->text[list->n++], NETWORK_TEXT, "%s%c%s", a, operation, b);
  else
    snprintf(list->text[list->n++], NETWORK_TEXT, "%s", a);
}

static struct texts rows(const char *const name[], unsigned set, char operation, int parts);

/* All networks of the set that may be one of the parts of a row: one element, or a group of
 * the other kind in parentheses. */
static struct texts parts_of(const char *const name[], unsigned set, char operation)
{
  struct texts list = { 0 };

  if ((set & (set - 1)) == 0) {
    int i = 0;

    while (!(set >> i & 1))
      i++;
    add_text(&list, name[i], 0, NULL);
    return list;
  }
  list = rows(name, set, operation == '|' ? '-' : '|', 2);
  for (int i = 0; i < list.n; i++) {
    char inside[NETWORK_TEXT];

    memcpy(inside, list.text[i], sizeof inside);
    snprintf(list.text[i], NETWORK_TEXT, "(%.*s)", NETWORK_TEXT - 3, inside);
  }
  return list;
}

/* All rows of at least so many parts: the first has the first element of the set, so that
 * each comes once. */
static struct texts rows(const char *const name[], unsigned set, char operation, int parts)
{
  const unsigned first = set & -set;
  struct texts list = { 0 };

  if (parts <= 1) {
    struct texts whole = parts_of(name, set, operation);

    for (int i = 0; i < whole.n; i++)
      add_text(&list, whole.text[i], 0, NULL);
    free(whole.text);
  }
  for (unsigned part = set; part > 0; part = (part - 1) & set) {
    if (!(part & first) || part == set)
      continue;
    struct texts head = parts_of(name, part, operation), tail = rows(name, set & ~part, operation, parts - 1);

    for (int i = 0; i < head.n; i++)
      for (int k = 0; k < tail.n; k++)
        add_text(&list, head.text[i], operation, tail.text[k]);
    free(head.text);
    free(tail.text);
  }
  return list;
}

struct texts networks_of(const char *const name[], int n)
{
  struct texts all = { 0 }, some;

  if (n == 1) {
    add_text(&all, name[0], 0, NULL);
    return all;
  }
  for (int k = 0; k < 2; k++) {
    some = rows(name, (1u << n) - 1u, "|-"[k], 2);
    for (int i = 0; i < some.n; i++)
      add_text(&all, some.text[i], 0, NULL);
    free(some.text);
  }
  return all;
}

/* --- properties -------------------------------------------------------------------------- */

/* Static stiffness: dampers and inerters carry nothing. */
static double static_of(const struct part *p, double k_d, double k_s)
{
  double a, b;

  if (p->kind == SPRING)
    return strcmp(p->text, "k_d") == 0 ? k_d : strcmp(p->text, "k_s") == 0 ? k_s : p->value;
  if (p->kind == DAMPER || p->kind == INERTER)
    return 0.;
  a = static_of(p->a, k_d, k_s);
  b = static_of(p->b, k_d, k_s);
  return p->kind == PARALLEL ? a + b : a > 0. && b > 0. ? a * b / (a + b) : 0.;
}

double network_static(const struct device_text *d, double k_d, double k_s)
{
  return static_of(d->network, k_d, k_s);
}

const char *network_path(const struct device_text *d)
{
  static const struct { const char *name; double value; } path[] = {
    { "k_d", 3. }, { "k_s", 6. }, { "k_d|k_s", 9. }, { "k_d-k_s", 2. },
  };
  const double value = network_static(d, 3., 6.);

  for (size_t i = 0; i < sizeof path / sizeof *path; i++)
    if (fabs(path[i].value - value) < 1e-12)
      return path[i].name;
  return "none";
}

double network_least_k_s(const struct device_text *d, double k_d)
{
  return strcmp(network_path(d), "k_s") == 0 ? k_d : 1e4;
}

/* --- which are one ------------------------------------------------------------------------
 * The dynamic stiffness of one network, k_d, k_s, c_d and b above 0, is a set of functions
 * of s.  Two networks have the same set when each function of either is one of the other: the
 * values that make it so are looked for by Newton's method on the logarithms of the values,
 * for three functions of each. */

enum { VALUES = 4, SAMPLES = 6, TRIES = 12, STEPS = 60 };

static const int value_slot[VALUES] = { PAR_K_D, PAR_K_S, PAR_C_D, PAR_B };

static double random_part(unsigned long long *seed)
{
  *seed = *seed * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*seed >> 11) / 9007199254740992.;
}

/* log Z at SAMPLES points of the right half plane, where it has neither zero nor pole. */
static void sample(const struct device_text *d, const double logarithm[VALUES], double out[2 * SAMPLES])
{
  double par[MLG_SLOTS] = { [PAR_K_PSI] = MLG_RIGID * MLG_RIGID };
  struct network Z;

  for (int i = 0; i < VALUES; i++)
    par[value_slot[i]] = exp(logarithm[i]);
  Z = device_stiffness(d, par);
  for (int i = 0; i < SAMPLES; i++) {
    const double _Complex s = (0.2 + 0.3 * i) + I * (2.5 - 0.4 * i);
    const double _Complex value = clog(poly_value(&Z.num, s) / poly_value(&Z.den, s));

    out[2 * i] = creal(value);
    out[2 * i + 1] = cimag(value);
  }
}

/* Solves the normal equations J'J x = J'r of free unknowns, damped; 0: singular. */
static int solve(double A[VALUES][VALUES + 1], int n)
{
  for (int i = 0; i < n; i++) {
    for (int r = i + 1; r < n; r++)
      for (int c = n; c >= i; c--)
        A[r][c] -= A[r][i] / A[i][i] * A[i][c];
    if (!(fabs(A[i][i]) > 0.))
      return 0;
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int c = i + 1; c < n; c++)
      A[i][n] -= A[i][c] * A[c][n];
    A[i][n] /= A[i][i];
  }
  return 1;
}

static double misfit(const struct device_text *d, const double x[VALUES], const double target[], double r[])
{
  double sum = 0.;

  sample(d, x, r);
  for (int i = 0; i < 2 * SAMPLES; i++) {
    r[i] -= target[i];
    sum += r[i] * r[i];
  }
  return sum;
}

/* Whether the target is a function of network d, from the values x on; those below `first`
 * are held. */
static int reaches(const struct device_text *d, double x[VALUES], int first, const double target[])
{
  double r[2 * SAMPLES], size = misfit(d, x, target, r), damping = 1e-3;

  for (int step = 0; step < STEPS && size > 1e-24; step++) {
    double J[2 * SAMPLES][VALUES], A[VALUES][VALUES + 1] = { { 0. } }, next[VALUES], away[2 * SAMPLES];
    const int n = VALUES - first;

    for (int k = first; k < VALUES; k++) {
      const double at = x[k], h = 1e-6;

      x[k] = at + h;
      sample(d, x, away);
      x[k] = at - h;
      double back[2 * SAMPLES];
      sample(d, x, back);
      x[k] = at;
      for (int i = 0; i < 2 * SAMPLES; i++)
        J[i][k] = (away[i] - back[i]) / (2. * h);
    }
    for (int a = 0; a < n; a++) {
      for (int b = 0; b < n; b++)
        for (int i = 0; i < 2 * SAMPLES; i++)
          A[a][b] += J[i][first + a] * J[i][first + b];
      for (int i = 0; i < 2 * SAMPLES; i++)
        A[a][n] -= J[i][first + a] * r[i];
      A[a][a] += damping * (A[a][a] + 1e-12);
    }
    if (!solve(A, n))
      return 0;
    for (int k = 0; k < VALUES; k++)
      next[k] = x[k] + (k < first ? 0. : fmax(-2., fmin(2., A[k - first][n])));
    const double better = misfit(d, next, target, away);

    if (better < size) {
      memcpy(x, next, sizeof next);
      memcpy(r, away, sizeof away);
      size = better;
      damping *= 0.1;
    } else if ((damping *= 10.) > 1e6)
      break;
  }
  return size < 1e-18;
}

/* Whether the functions of `of`, three at random, are functions of `by`. */
static int is_within(const struct device_text *of, const struct device_text *by, int first)
{
  unsigned long long seed = 1;

  for (int k = 0; k < 3; k++) {
    double value[VALUES], target[2 * SAMPLES];
    int found = 0;

    for (int i = 0; i < VALUES; i++)
      value[i] = i < first ? 0. : 2. * random_part(&seed) - 1.;
    sample(of, value, target);
    for (int attempt = 0; attempt < TRIES && !found; attempt++) {
      double x[VALUES];

      for (int i = 0; i < VALUES; i++)
        x[i] = i < first ? 0. : 4. * random_part(&seed) - 2.;
      found = reaches(by, x, first, target);
    }
    if (!found)
      return 0;
  }
  return 1;
}

/* The powers of s that are in num and den, which do not hang on the values. */
static unsigned powers(const struct device_text *d)
{
  double par[MLG_SLOTS] = { [PAR_K_PSI] = MLG_RIGID * MLG_RIGID, [PAR_K_D] = 1., [PAR_K_S] = 1., [PAR_C_D] = 1., [PAR_B] = 1. };
  const struct network Z = device_stiffness(d, par);
  unsigned bits = 0;

  for (int i = 0; i < POLY_TERMS; i++)
    bits |= (unsigned)(Z.num.coefficient[i] > 1e-9) << i | (unsigned)(Z.den.coefficient[i] > 1e-9) << (i + POLY_TERMS);
  return bits;
}

int network_same(const struct device_text *a, const struct device_text *b, int k_d_free)
{
  const int first = k_d_free ? 0 : 1;

  return powers(a) == powers(b) && is_within(a, b, first) && is_within(b, a, first);
}

/* --- the command ------------------------------------------------------------------------------ */

struct device_text *small_networks(int *n, int *all)
{
  static const char *const name[][MOST_NAMES] = {
    { "k_d", "c_d" }, { "k_d", "c_d", "b" }, { "k_s", "k_d", "c_d" }, { "k_s", "k_d", "c_d", "b" },
  };
  static const int names[] = { 2, 3, 3, 4 };
  struct texts list[4];
  struct device_text *small;
  char wrong[200];

  *n = *all = 0;
  for (int set = 0; set < 4; set++) {
    list[set] = networks_of(name[set], names[set]);
    *all += list[set].n;
  }
  small = calloc((size_t)*all, sizeof *small);
  if (!small)
    fail("networks", MLG_FAILED, "out of memory");
  for (int set = 0; set < 4; set++) {
    for (int i = 0; i < list[set].n; i++) {
      if (device_read(&small[*n], list[set].text[i], wrong, sizeof wrong) != 0)
        refuse("networks", list[set].text[i], "%s", wrong);
      *n += strcmp(network_path(&small[*n]), "none") != 0;
    }
    free(list[set].text);
  }
  return small;
}

/* The name of the layout in models/ that has this stiffness, or "". */
static const char *layout_of(const struct device_text *d)
{
  const double _Complex s = 3. + 70. * I;
  double par[MLG_SLOTS] = { 0. };

  mlg_defaults(par);
  par[PAR_K_S] = 7.3e5;
  par[PAR_B] = 83.;
  const struct network Z = device_stiffness(d, par);

  for (int i = 0; i < libmlg_layouts(); i++) {
    const struct libmlg_layout *const l = libmlg_find(i);
    const struct network Y = l->network(l, par);
    const double _Complex ratio = poly_value(&Z.num, s) * poly_value(&Y.den, s) / (poly_value(&Z.den, s) * poly_value(&Y.num, s));

    if (cabs(ratio - 1.) < 1e-10)
      return l->name;
  }
  return "";
}

/* The number, from 1 on, of the first network that is one with number i. */
static int first_same(const struct device_text small[], int i, int k_d_free)
{
  int k = 0;

  while (k < i && !network_same(&small[k], &small[i], k_d_free))
    k++;
  return k + 1;
}

static int run(int argc, char *argv[])
{
  int n, all, distinct = 0, families = 0;
  struct device_text *small;

  if (argc > 1)
    refuse(argv[0], argv[1], "expected nothing behind the command");
  small = small_networks(&n, &all);
  int *const same = malloc((size_t)n * sizeof *same), *const family = malloc((size_t)n * sizeof *family);

  if (!same || !family)
    fail(argv[0], MLG_FAILED, "out of memory");
  for (int i = 0; i < n; i++) {
    same[i] = first_same(small, i, 0);
    family[i] = first_same(small, i, 1);
    distinct += same[i] == i + 1;
    families += family[i] == i + 1;
  }
  printf("# %d series-parallel networks of k_d, c_d and at most one of each of k_s and b, as labelled elements; %d of them\n"
         "# have a path of springs; of these, %d differ in dynamic stiffness at the k_d of the gear, %d where k_d is free, too\n"
         "number,network,states,path,same,family,layout\n", all, n, distinct, families);
  for (int i = 0; i < n; i++)
    printf("%d,%s,%d,%s,%d,%d,%s\n", i + 1, small[i].text, small[i].order, network_path(&small[i]), same[i], family[i],
           layout_of(&small[i]));
  free(same);
  free(family);
  free(small);
  return output_status(argv[0]);
}

const struct command command_networks = {
  .name = "networks",
  .usage = "",
  .summary = "every small network of springs, a damper and an inerter",
  .details =
    "All series-parallel networks of k_d, c_d and at most one of each of k_s and b, each once, that\n"
    "carry a static torque, to stand behind k_psi.  No others have so few elements: the smallest\n"
    "that is not series-parallel, the bridge, has five.  CSV:\n"
    "  number, network  | side by side, - one behind the other, - binding closer; goes for LAYOUT\n"
    "  states           of the device\n"
    "  path             the springs that carry a static torque\n"
    "  same             number of the first network with the same dynamic stiffnesses over all k_s,\n"
    "                   c_d and b, found by solving for these at random values\n"
    "  family           the same, with k_d free, too\n"
    "  layout           its name in models/\n",
  .run = run,
};
