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
  const int hangs_on_k_d = fabs(network_static(d, 3., 6.) - network_static(d, 4., 6.)) > 1e-12;

  return hangs_on_k_d ? 1e4 : k_d;
}

static int has_leaf(const struct part *p, char operation, const char *name)
{
  const enum part_kind kind = operation == '|' ? PARALLEL : SERIES;

  if (p->kind == kind)
    return has_leaf(p->a, operation, name) || has_leaf(p->b, operation, name);
  return p->kind != PARALLEL && p->kind != SERIES && strncmp(p->text, name, strlen(name)) == 0
         && (p->text[strlen(name)] == '\0' || p->text[strlen(name)] == '=');
}

/* Whether two elements stand directly side by side or one behind the other, so that one of
 * their kind does as well. */
static int has_neighbours(const struct part *p, const char *a, const char *b)
{
  if (p->kind != PARALLEL && p->kind != SERIES)
    return 0;
  const char operation = p->kind == PARALLEL ? '|' : '-';

  return (has_leaf(p, operation, a) && has_leaf(p, operation, b)) || has_neighbours(p->a, a, b) || has_neighbours(p->b, a, b);
}

/* --- the two families --------------------------------------------------------------------------- */

/* Elements of which each network of a family is made, all of a row. */
struct family { const char *name[MOST_NAMES]; int n; };

static const struct family small[] = {
  { { "k_d", "c_d" }, 2 }, { { "k_d", "c_d", "b" }, 3 }, { { "k_s", "k_d", "c_d" }, 3 }, { { "k_s", "k_d", "c_d", "b" }, 4 },
};

/* One damper or one spring more; their values only stand for them. */
#define C_2 "c_2=1000"
#define K_2 "k_2=1e6"

static const struct family larger[] = {
  { { "k_d", "c_d", C_2 }, 3 }, { { "k_d", "c_d", C_2, "b" }, 4 }, { { "k_s", "k_d", "c_d", C_2 }, 4 },
  { { "k_s", "k_d", "c_d", C_2, "b" }, 5 }, { { "k_s", K_2, "k_d", "c_d" }, 4 }, { { "k_s", K_2, "k_d", "c_d", "b" }, 5 },
};

/* Whether the two are one with k_s and k_2 exchanged. */
static int exchanged_springs(struct device_text *a, struct device_text *b)
{
  const double _Complex x = network_at(a, 1.7, 1.9, 3.1), y = network_at(b, 3.1, 1.9, 1.7);

  return cabs(x - y) < 1e-12 * cabs(x);
}

/* Whether a network belongs to the larger family: no smaller one does as well, and it is not
 * one that is there with k_s and k_2 exchanged. */
static int is_new(struct device_text *d, struct device_text before[], int n)
{
  if (has_neighbours(d->network, "c_d", "c_2") || has_neighbours(d->network, "k_s", "k_2"))
    return 0;
  for (int i = 0; i < n && strstr(d->text, "k_2"); i++)
    if (strstr(before[i].text, "k_2") && exchanged_springs(d, &before[i]))
      return 0;
  return 1;
}

/* A network is kept where it is: it holds pointers into itself. */
static struct device_text *networks_in(const struct family family[], int families, int *n, int *all)
{
  struct texts list[sizeof larger / sizeof *larger];
  struct device_text *found;
  char wrong[200];

  *n = *all = 0;
  for (int i = 0; i < families; i++) {
    list[i] = networks_of(family[i].name, family[i].n);
    *all += list[i].n;
  }
  found = calloc((size_t)*all, sizeof *found);
  if (!found)
    fail("networks", MLG_FAILED, "out of memory");
  for (int set = 0; set < families; set++) {
    for (int i = 0; i < list[set].n; i++) {
      struct device_text *const d = &found[*n];

      if (device_read(d, list[set].text[i], wrong, sizeof wrong) != 0)
        refuse("networks", list[set].text[i], "%s", wrong);
      *n += network_static(d, 3., 6.) > 0. && (family == small || is_new(d, found, *n));
    }
    free(list[set].text);
  }
  return found;
}

struct device_text *small_networks(int *n, int *all)
{
  return networks_in(small, sizeof small / sizeof *small, n, all);
}

/* --- the command ------------------------------------------------------------------------------ */

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
static int first_same(struct device_text d[], int i, int k_d_free)
{
  int k = 0;

  while (k < i && !network_same(&d[k], &d[i], k_d_free))
    k++;
  return k + 1;
}

static int *numbers(int n)
{
  int *const number = malloc((size_t)n * sizeof *number);

  if (!number)
    fail("networks", MLG_FAILED, "out of memory");
  return number;
}

static void list_small(void)
{
  int n, all, distinct = 0, families = 0;
  struct device_text *const d = small_networks(&n, &all);
  int *const same = numbers(n), *const family = numbers(n);

  for (int i = 0; i < n; i++) {
    same[i] = first_same(d, i, 0);
    family[i] = first_same(d, i, 1);
    distinct += same[i] == i + 1;
    families += family[i] == i + 1;
  }
  printf("# %d series-parallel networks of k_d, c_d and at most one of each of k_s and b, as labelled elements; %d of them\n"
         "# have a path of springs; of these, %d differ in dynamic stiffness at the k_d of the gear, %d where k_d is free, too\n"
         "number,network,states,path,same,family,layout\n", all, n, distinct, families);
  for (int i = 0; i < n; i++)
    printf("%d,%s,%d,%s,%d,%d,%s\n", i + 1, d[i].text, d[i].order, network_path(&d[i]), same[i], family[i], layout_of(&d[i]));
  free(same);
  free(family);
  free(d);
}

/* with_same: which are one as well, most of a minute. */
static void list_larger(int with_same)
{
  int n, all, distinct = 0;
  struct device_text *const d = networks_in(larger, sizeof larger / sizeof *larger, &n, &all);
  int *const same = numbers(n);

  for (int i = 0; i < n && with_same; i++) {
    same[i] = first_same(d, i, 0);
    distinct += same[i] == i + 1;
  }
  printf("# %d series-parallel networks of k_d, c_d, at most one of each of k_s and b, and a second damper c_2 or a spring k_2\n"
         "# beside k_s, as labelled elements; %d of them have a path of springs and are not one of fewer elements, nor the same with\n"
         "# k_s and k_2 exchanged\n", all, n);
  if (with_same)
    printf("# these are %d different sets of dynamic stiffnesses at the k_d of the gear\n", distinct);
  printf("number,network,states,free%s\n", with_same ? ",same" : "");
  for (int i = 0; i < n; i++) {
    printf("%d,%s,%d,%s", i + 1, d[i].text, d[i].order, strstr(d[i].text, "c_2") ? "c_2" : "k_2");
    printf(with_same ? ",%d\n" : "\n", same[i]);
  }
  free(same);
  free(d);
}

static void list_limits(void)
{
  int n, m, all;
  struct device_text *const d = networks_in(larger, sizeof larger / sizeof *larger, &n, &all);
  struct device_text *const less = small_networks(&m, &all);

  printf("number,network,element,end,limit,limit_network\n");
  for (int i = 0; i < n; i++)
    print_limits(i + 1, &d[i], less, m);
  free(less);
  free(d);
}

static int run(int argc, char *argv[])
{
  const char *const which = argc == 3 && strcmp(argv[1], "larger") == 0 ? argv[2] : "";

  if (argc == 2 && strcmp(argv[1], "larger") == 0)
    list_larger(0);
  else if (strcmp(which, "same") == 0)
    list_larger(1);
  else if (strcmp(which, "limits") == 0)
    list_limits();
  else if (argc > 1)
    refuse(argv[0], argv[argc > 2 && strcmp(argv[1], "larger") == 0 ? 2 : 1], "expected nothing, `larger`, `larger same` or `larger limits`");
  else
    list_small();
  return output_status(argv[0]);
}

const struct command command_networks = {
  .name = "networks",
  .usage = "[larger [same | limits]]",
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
    "  layout           its name in models/\n"
    "larger: those with a second damper c_2, or with a spring k_2 beside k_s; no two like elements\n"
    "side by side or one behind the other.  Columns number, network, states, with `same` (most of a\n"
    "minute) same, and\n"
    "  free             the element more; explore NETWORK free=NAME searches its value\n"
    "larger limits: which of the small ones each becomes as one element goes to an end, 0 or inf; its\n"
    "k_2 then is the k_s of the smaller one where k_s goes, c_2 the c_d where c_d goes.  Columns number,\n"
    "network, element, end, limit (number of the small one), limit_network\n",
  .run = run,
};
