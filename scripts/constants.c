/* constants - checks an AUTO constants file and hands over values
 *
 *   constants FILE [layout=LAYOUT] [gear=FILE] [NAME=VALUE ...]
 *
 * Prints FILE as AUTO reads it, one constant per line, with each NAME set to
 * VALUE: NAME is an AUTO constant (DS=-0.1) or a parameter (c_d=5e3, goes into
 * PAR).  gear=FILE sets all that the PAR of that file holds, where a value may have
 * its unit behind it.  layout=LAYOUT makes a file of another layout one of that layout.
 *
 * AUTO passes over many slips in silence.  Here an unknown constant, a name
 * that parnames or unames lacks, a parameter under a wrong slot or outside its
 * physical range (models/mlg.h) ends with one line "FILE:LINE: what, and what
 * would be right" on standard error and status 2, and nothing is printed.
 */
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../models/libmlg/libmlg.h"
#include "../models/mlg.h"
#include "arguments.h"

enum { MAX_FILE = 1 << 16, MAX_ENTRIES = 128, MAX_ITEMS = 256, STATUS_BAD_INPUT = 2 };

/* One KEY = VALUE; the texts live as long as the program. */
struct entry { const char *key, *value; int line; };
struct constants { const char *file; struct entry entry[MAX_ENTRIES]; int n; };

/* One element of a list (key "") or of a dictionary, quotes removed. */
struct item { char key[64], value[256]; };
struct items { struct item item[MAX_ITEMS]; int n; };

/* AUTO-07p 0.9.2, manual chapter 10.  form: 'i' a whole number, 'r' a number, 'l' a
 * list, 'd' a dictionary, 'n' one of numbers, 't' a text or whatever AUTO makes of it;
 * what is named is marked 'p', a parameter, or 'u', a parameter or a state. */
static const struct auto_constant { const char *key; char form, names; } auto_constants[] = {
  { "unames", 'd', 0 },   { "parnames", 'd', 0 }, { "U", 'n', 'u' },      { "PAR", 'n', 'p' },
  { "ICP", 'l', 'p' },    { "UZR", 'n', 'p' },    { "UZSTOP", 'n', 'p' }, { "THL", 'n', 'p' },
  { "THU", 'n', 'u' },    { "SP", 'l', 0 },       { "STOP", 'l', 0 },     { "NDIM", 'i', 0 },
  { "IPS", 'i', 0 },      { "IRS", 't', 0 },      { "ILP", 'i', 0 },      { "NTST", 'i', 0 },
  { "NCOL", 'i', 0 },     { "IAD", 'i', 0 },      { "ISP", 'i', 0 },      { "ISW", 'i', 0 },
  { "IPLT", 'i', 0 },     { "NBC", 'i', 0 },      { "NINT", 'i', 0 },     { "NMX", 'i', 0 },
  { "NPR", 'i', 0 },      { "MXBF", 'i', 0 },     { "IIS", 'i', 0 },      { "IBR", 'i', 0 },
  { "LAB", 'i', 0 },      { "IID", 'i', 0 },      { "ITMX", 'i', 0 },     { "ITNW", 'i', 0 },
  { "NWTN", 'i', 0 },     { "JAC", 'i', 0 },      { "NPAR", 'i', 0 },     { "IADS", 'i', 0 },
  { "DS", 'r', 0 },       { "DSMIN", 'r', 0 },    { "DSMAX", 'r', 0 },    { "EPSL", 'r', 0 },
  { "EPSU", 'r', 0 },     { "EPSS", 'r', 0 },     { "RL0", 'r', 0 },      { "RL1", 'r', 0 },
  { "A0", 'r', 0 },       { "A1", 'r', 0 },       { "e", 't', 0 },        { "s", 't', 0 },
  { "dat", 't', 0 },      { "sv", 't', 0 },
};

/* Outside these AUTO never ends, fills the disk or crashes. */
static const struct { const char *key; double least, most; } auto_ranges[] = {
  { "NDIM", 1, 1000 }, { "NTST", 2, 100000 }, { "NCOL", 2, 7 },   { "NMX", 0, 1e8 },
  { "ITMX", 1, 1000 }, { "ITNW", 1, 1000 },   { "NWTN", 1, 1000 }, { "DSMAX", 1e-12, 1e9 },
};

/* One line whatever it quotes, which may span lines in the file. */
static void bad_input(const char *file, int line, const char *format, ...)
{
  char text[1024];
  va_list args;

  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  for (char *t = text; *t; t++)
    if (iscntrl((unsigned char)*t))
      *t = ' ';
  if (line > 0)
    fprintf(stderr, "%s:%d: %s\n", file, line, text);
  else
    fprintf(stderr, "%s: %s\n", file, text);
  exit(STATUS_BAD_INPUT);
}

static const struct auto_constant *find_constant(const char *key)
{
  for (size_t i = 0; i < sizeof auto_constants / sizeof *auto_constants; i++)
    if (strcmp(key, auto_constants[i].key) == 0)
      return &auto_constants[i];
  return NULL;
}

static const struct mlg_parameter *find_parameter(const char *name)
{
  return mlg_find(name, strlen(name));
}

static char *copy(const char *text, size_t length)
{
  char *t = malloc(length + 1);

  if (!t)
    bad_input("constants", 0, "out of memory");
  memcpy(t, text, length);
  t[length] = '\0';
  return t;
}

static char *read_whole(const char *file)
{
  static char buffer[MAX_FILE];
  FILE *f = fopen(file, "r");
  size_t n;

  if (!f)
    bad_input(file, 0, "%s; expected a constants file", strerror(errno));
  n = fread(buffer, 1, sizeof buffer, f);
  if (ferror(f))
    bad_input(file, 0, "%s; expected a constants file", strerror(errno));
  fclose(f);
  if (n == sizeof buffer)
    bad_input(file, 0, "longer than %d bytes; not a constants file", MAX_FILE);
  if (memchr(buffer, '\0', n))
    bad_input(file, 0, "holds a zero byte; not a constants file");
  return copy(buffer, n);
}

/* One entry more, or a new value for one that is there. */
static void set(struct constants *c, const char *key, const char *value, int line)
{
  int i;

  for (i = 0; i < c->n && strcmp(c->entry[i].key, key) != 0; i++)
    ;
  if (i == MAX_ENTRIES)
    bad_input(c->file, line, "more than %d constants", MAX_ENTRIES);
  if (i == c->n)
    c->n++;
  c->entry[i] = (struct entry){ key, value, line };
}

static const struct entry *get(const struct constants *c, const char *key)
{
  for (int i = 0; i < c->n; i++)
    if (strcmp(c->entry[i].key, key) == 0)
      return &c->entry[i];
  return NULL;
}

/* The end of the value at t: past its closing bracket or quote, or at the
 * blank, comma or line end behind it.  NULL: brackets or quotes stay open. */
static const char *value_end(const char *t, int *lines)
{
  int depth = 0;
  char quote = 0;

  for (; *t; t++) {
    if (*t == '\n')
      ++*lines;
    if (quote) {
      if (*t == quote)
        quote = 0;
      else if (*t == '\n')
        return NULL;
    } else if (*t == '\'' || *t == '"')
      quote = *t;
    else if (*t == '[' || *t == '{')
      depth++;
    else if (*t == ']' || *t == '}') {
      if (--depth < 0)
        return NULL;
      if (depth == 0)
        return t + 1;
    } else if (depth == 0 && (isspace((unsigned char)*t) || *t == ',')) {
      if (*t == '\n')
        --*lines;
      return t;
    }
  }
  return depth == 0 && !quote ? t : NULL;
}

static void parse(struct constants *c, const char *file)
{
  const char *t = read_whole(file);
  int line = 1;

  c->file = file;
  c->n = 0;
  while (*t) {
    if (*t == '\n') {
      line++, t++;
    } else if (isspace((unsigned char)*t) || *t == ',') {
      t++;
    } else if (*t == '#' || *t == '!') {
      t += strcspn(t, "\n");
    } else {
      const size_t length = strspn(t, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
      const char *key = copy(t, length), *value, *end;
      int lines = 0;

      if (length == 0)
        bad_input(file, line, "unexpected '%c'; a constant is written NAME = value", *t);
      t += length;
      t += strspn(t, " \t");
      if (*t != '=')
        bad_input(file, line, "'%s' is not followed by '='; a constant is written NAME = value", key);
      t++;
      value = t + strspn(t, " \t");
      end = value_end(value, &lines);
      if (!end)
        bad_input(file, line, "%s: a bracket or quote is left open", key);
      if (end == value)
        bad_input(file, line, "%s has no value", key);
      if (!find_constant(key))
        bad_input(file, line, "'%s' is not an AUTO constant (see the AUTO manual, chapter 10)", key);
      if (get(c, key))
        bad_input(file, line, "%s is given twice; AUTO would take the last", key);
      set(c, key, copy(value, (size_t)(end - value)), line);
      line += lines;
      t = end;
    }
  }
}

/* Copies one key or value without quotes and blanks around it. */
static void plain(const struct constants *c, const struct entry *e, char *to, size_t size,
                  const char *from, const char *end)
{
  while (from < end && (isspace((unsigned char)*from) || *from == '\'' || *from == '"'))
    from++;
  while (end > from && (isspace((unsigned char)end[-1]) || end[-1] == '\'' || end[-1] == '"'))
    end--;
  if ((size_t)(end - from) >= size)
    bad_input(c->file, e->line, "%s: an element longer than %zu characters", e->key, size - 1);
  memcpy(to, from, (size_t)(end - from));
  to[end - from] = '\0';
}

/* Splits a list [a, b] or a dictionary {k: v, k: v}; a lone value is a list of one. */
static void split(const struct constants *c, const struct entry *e, struct items *items)
{
  const char *t = e->value, *end = t + strlen(t);

  items->n = 0;
  if (*t == '[' || *t == '{')
    t++, end--;
  while (t < end) {
    const char *start = t, *colon = NULL;
    struct item *item = &items->item[items->n];
    int depth = 0;
    char quote = 0;

    for (; t < end && (*t != ',' || depth > 0 || quote); t++) {
      if (quote)
        quote = *t == quote ? 0 : quote;
      else if (*t == '\'' || *t == '"')
        quote = *t;
      else if (*t == '[' || *t == '{')
        depth++;
      else if (*t == ']' || *t == '}')
        depth--;
      else if (*t == ':' && depth == 0 && !colon)
        colon = t;
    }
    if (items->n == MAX_ITEMS)
      bad_input(c->file, e->line, "%s: more than %d elements", e->key, MAX_ITEMS);
    item->key[0] = '\0';
    if (colon)
      plain(c, e, item->key, sizeof item->key, start, colon);
    plain(c, e, item->value, sizeof item->value, colon ? colon + 1 : start, t);
    if (item->value[0] || item->key[0])
      items->n++;
    t += t < end;
  }
}

/* A whole number; 0 when the text is none. */
static int is_integer(const char *text, long *value)
{
  char *end;

  errno = 0;
  *value = strtol(text, &end, 10);
  return end != text && *end == '\0' && errno == 0;
}

static void check_value(const struct constants *c, const struct entry *e, const char *name,
                        const char *text)
{
  const struct mlg_parameter *p = find_parameter(name);
  double x;

  if (!is_number(text, &x))
    bad_input(c->file, e->line, "%s = %s is not a finite number", name, text);
  if (p && !mlg_in_range(p, x))
    bad_input(c->file, e->line, "%s = %s %s is outside its range, %g to %g%s", name, text, p->unit,
              p->least, p->most, p->slot == PAR_K_S ? "; 1e30 is rigid" : "");
}

/* parnames: a name of the model stands under its own slot. */
static void check_parnames(const struct constants *c, const struct items *parnames)
{
  const struct entry *e = get(c, "parnames");

  for (int i = 0; i < parnames->n; i++) {
    const struct item *it = &parnames->item[i];
    const struct mlg_parameter *p = find_parameter(it->value);
    long slot;

    if (!is_integer(it->key, &slot) || slot < 1)
      bad_input(c->file, e->line, "parnames: '%s' is not a slot; expected 1, 2, ...", it->key);
    if (p && slot != p->slot + 1)
      bad_input(c->file, e->line, "parnames: %s stands under %ld; it is PAR(%d)", it->value, slot,
                p->slot + 1);
    for (int k = 0; k < MLG_PARAMETER_COUNT; k++)
      if (!p && mlg_parameters[k].slot + 1 == slot)
        bad_input(c->file, e->line, "parnames: PAR(%ld) is called '%s'; its name is %s", slot,
                  it->value, mlg_parameters[k].name);
  }
}

static int has_name(const struct items *names, const char *name)
{
  for (int i = 0; i < names->n; i++)
    if (strcmp(names->item[i].value, name) == 0)
      return 1;
  return 0;
}

static int is_named(const struct constants *c, const char *key, const char *name)
{
  static struct items names;
  const struct entry *e = get(c, key);

  if (!e)
    return 0;
  split(c, e, &names);
  return has_name(&names, name);
}

static void check_name(const struct constants *c, const struct entry *e, const char *text,
                       const struct items *parnames, const struct items *unames, char kind)
{
  const char *name = text[0] == '-' ? text + 1 : text;
  long slot;

  if (is_integer(name, &slot) || has_name(parnames, name) || (kind == 'u' && has_name(unames, name)))
    return;
  bad_input(c->file, e->line, "%s: '%s' is not a name of %s", e->key, name,
            kind == 'u' ? "unames" : "parnames");
}

/* The meaning of a result of models/mlg.h, or NULL. */
static const char *result(const char *name)
{
  static const struct { const char *name, *meaning; } results[] = {
#define X(slot, id, name, unit, meaning) { name, meaning },
    MLG_RESULTS(X)
#undef X
  };

  for (size_t i = 0; i < sizeof results / sizeof *results; i++)
    if (strcmp(name, results[i].name) == 0)
      return results[i].meaning;
  return NULL;
}

/* The name of the parameter that text gives by its name or by its slot. */
static const char *name_of(const char *text, const struct items *parnames)
{
  for (int i = 0; i < parnames->n; i++)
    if (strcmp(parnames->item[i].key, text) == 0)
      return parnames->item[i].value;
  return text;
}

/* The value, or each of a list of them, that a dictionary gives to a name. */
static void check_numbers(const struct constants *c, const struct entry *e, const struct item *it)
{
  static struct items numbers;
  const struct entry value = { e->key, it->value, e->line };
  double x;

  split(c, &value, &numbers);
  if (!it->value[0])
    bad_input(c->file, e->line, "%s: %s has no value; expected {name: value, ...}", e->key, it->key);
  for (int i = 0; i < numbers.n; i++)
    if (numbers.item[i].key[0] || !is_number(numbers.item[i].value, &x))
      bad_input(c->file, e->line, "%s: %s = %s is not a finite number", e->key, it->key, it->value);
}

/* Whether text names points by type, and perhaps by number: HB, HB2. */
static int is_point(const char *text)
{
  static const char *const types[] = {
    "BP", "LP", "HB", "PD", "TR", "UZ", "EP", "MX", "BT", "CP", "GH", "ZH", "R1", "R2", "R3", "R4",
  };

  text += *text == '-';
  for (size_t i = 0; i < sizeof types / sizeof *types; i++)
    if (strncmp(text, types[i], 2) == 0)
      return 1;
  return 0;
}

/* Whether a value, its items split, has the form that AUTO reads. */
static void check_form(const struct constants *c, const struct entry *e, char form, const struct items *items)
{
  double x;
  long n;

  if (form == 'i' || form == 'r') {
    if (!is_number(e->value, &x))
      bad_input(c->file, e->line, "%s = %s is not a finite number", e->key, e->value);
    if (form == 'i' && !is_integer(e->value, &n))
      bad_input(c->file, e->line, "%s = %s is not a whole number", e->key, e->value);
    for (size_t k = 0; k < sizeof auto_ranges / sizeof *auto_ranges; k++)
      if (strcmp(e->key, auto_ranges[k].key) == 0 && !(x >= auto_ranges[k].least && x <= auto_ranges[k].most))
        bad_input(c->file, e->line, "%s = %s is outside its range, %g to %g", e->key, e->value,
                  auto_ranges[k].least, auto_ranges[k].most);
  } else if (form == 'l') {
    if (e->value[0] != '[')
      bad_input(c->file, e->line, "%s = %s is no list; expected [name, ...]", e->key, e->value);
    for (int k = 0; k < items->n; k++)
      if (items->item[k].key[0])
        bad_input(c->file, e->line, "%s: '%s:' in a list; expected [name, ...]", e->key, items->item[k].key);
  } else if (form == 'd' || form == 'n') {
    if (e->value[0] != '{')
      bad_input(c->file, e->line, "%s = %s is no dictionary; expected {name: value, ...}", e->key, e->value);
    for (int k = 0; k < items->n; k++) {
      if (!items->item[k].key[0])
        bad_input(c->file, e->line, "%s: '%s' without a name; expected {name: value, ...}", e->key,
                  items->item[k].value);
      for (int j = 0; j < k; j++)
        if (strcmp(items->item[j].key, items->item[k].key) == 0)
          bad_input(c->file, e->line, "%s: %s is given twice", e->key, items->item[k].key);
    }
  }
}

static void check(const struct constants *c)
{
  static struct items parnames, unames, items;
  const struct entry *e;
  long ndim, isw;
  const int curve = (e = get(c, "ISW")) && is_integer(e->value, &isw) && labs(isw) == 2;

  parnames.n = unames.n = 0;
  if ((e = get(c, "parnames"))) {
    split(c, e, &parnames);
    check_parnames(c, &parnames);
  }
  if ((e = get(c, "unames")))
    split(c, e, &unames);
  if ((e = get(c, "NDIM"))) {
    if (!is_integer(e->value, &ndim) || ndim < 1)
      bad_input(c->file, e->line, "NDIM = %s is not a number of states", e->value);
    if (unames.n > 0 && unames.n != ndim)
      bad_input(c->file, e->line, "NDIM = %ld, but unames names %d states", ndim, unames.n);
  }
  for (int i = 0; i < c->n; i++) {
    const struct auto_constant *constant;

    e = &c->entry[i];
    constant = find_constant(e->key);
    split(c, e, &items);
    check_form(c, e, constant->form, &items);
    if (strcmp(e->key, "ICP") == 0 && items.n == 0)
      bad_input(c->file, e->line, "ICP names no parameter to continue");
    for (int k = 0; k < items.n && (strcmp(e->key, "SP") == 0 || strcmp(e->key, "STOP") == 0); k++)
      if (!is_point(items.item[k].value))
        bad_input(c->file, e->line, "%s: '%s' is no type of point; expected HB, LP2, ...", e->key,
                  items.item[k].value);
    if (!constant->names)
      continue;
    for (int k = 0; k < items.n; k++) {
      const struct item *it = &items.item[k];
      const char *name = name_of(it->key[0] ? it->key : it->value, &parnames);
      const int set = strcmp(e->key, "PAR") == 0;
      const int continued = strcmp(e->key, "ICP") == 0 && k <= curve;

      check_name(c, e, name, &parnames, &unames, constant->names);
      if ((set || continued) && result(name))
        bad_input(c->file, e->line, "%s: %s is a result (%s); it cannot be %s", e->key, name,
                  result(name), set ? "set" : "continued");
      if (set)
        check_value(c, e, name, it->value);
      else if (constant->form == 'n')
        check_numbers(c, e, it);
    }
  }
}

/* Writes items as the dictionary key; a text among the values has its quotes. */
static void set_dictionary(struct constants *c, const char *key, const struct items *items, int line)
{
  static char text[MAX_ITEMS * (sizeof(struct item) + 8)];
  size_t n = 1;
  long number;

  strcpy(text, "{");
  for (int k = 0; k < items->n; k++) {
    const struct item *it = &items->item[k];
    const char *quote = is_integer(it->key, &number) ? "" : "'";

    n += (size_t)snprintf(text + n, sizeof text - n, "%s%s%s%s: %s", k ? ", " : "", quote, it->key,
                          quote, it->value);
  }
  snprintf(text + n, sizeof text - n, "}");
  set(c, key, copy(text, strlen(text)), line);
}

/* Puts name: value into the dictionary PAR. */
static void put_parameter(struct constants *c, const char *name, const char *value)
{
  static struct items items;
  const struct entry *e = get(c, "PAR");
  int k = 0;

  items.n = 0;
  if (e)
    split(c, e, &items);
  while (k < items.n && strcmp(items.item[k].key, name) != 0)
    k++;
  if (k == MAX_ITEMS || strlen(name) >= sizeof items.item->key
      || strlen(value) >= sizeof items.item->value)
    bad_input(c->file, 0, "%s=%.20s...: too long, or too many parameters", name, value);
  if (k == items.n)
    items.n++;
  strcpy(items.item[k].key, name);
  strcpy(items.item[k].value, value);
  set_dictionary(c, "PAR", &items, e ? e->line : 0);
}

/* NDIM and unames of a layout.  In a Hopf curve's THU state 2 NDIM + 1 is omega^2
 * of AUTO's extended system, which moves with NDIM. */
static void set_layout(struct constants *c, const char *name)
{
  static struct items items;
  static char number[16];
  const int layout = libmlg_layout(name), n = libmlg_states(layout);
  const struct entry *ndim = get(c, "NDIM"), *unames = get(c, "unames"), *thu = get(c, "THU");
  long n_was, slot;

  if (layout == LIBMLG_NONE)
    bad_input(c->file, 0, "layout=%s: there is no models/%s.c", name, name);
  if (!ndim || !is_integer(ndim->value, &n_was))
    bad_input(c->file, ndim ? ndim->line : 0, "expected NDIM, the number of states of a layout");
  if (thu) {
    split(c, thu, &items);
    for (int k = 0; k < items.n; k++)
      if (is_integer(items.item[k].key, &slot) && slot == 2 * n_was + 1)
        snprintf(items.item[k].key, sizeof items.item[k].key, "%d", 2 * n + 1);
    set_dictionary(c, "THU", &items, thu->line);
  }
  items.n = n;
  for (int k = 0; k < n; k++) {
    snprintf(items.item[k].key, sizeof items.item[k].key, "%d", k + 1);
    snprintf(items.item[k].value, sizeof items.item[k].value, "'%s'", libmlg_state_quantity(layout, k)->name);
  }
  set_dictionary(c, "unames", &items, unames ? unames->line : 0);
  snprintf(number, sizeof number, "%d", n);
  set(c, "NDIM", number, ndim->line);
}

static void set_gear(struct constants *c, const char *file)
{
  static struct constants gear;
  static struct items items;
  const struct entry *e;

  parse(&gear, file);
  e = get(&gear, "PAR");
  if (!e || gear.n > 1)
    bad_input(file, 0, "expected one constant, PAR = {'name': value, ...}");
  split(&gear, e, &items);
  for (int k = 0; k < items.n; k++) {
    const struct mlg_parameter *p = find_parameter(items.item[k].key);
    char *unit = items.item[k].value + strcspn(items.item[k].value, " \t\n");

    if (!p)
      bad_input(file, e->line, "PAR: '%s' is not a parameter (see models/mlg.h)", items.item[k].key);
    if (*unit) {
      *unit++ = '\0';
      unit += strspn(unit, " \t\n");
      if (strcmp(unit, p->unit) != 0)
        bad_input(file, e->line, "PAR: %s is in %s here; it has to be in %s", p->name, unit, p->unit);
    }
    check_value(&gear, e, items.item[k].key, items.item[k].value);
    put_parameter(c, items.item[k].key, items.item[k].value);
  }
}

int main(int argc, char *argv[])
{
  static struct constants c;

  if (argc < 2) {
    fprintf(stderr, "usage: constants FILE [layout=LAYOUT] [gear=FILE] [NAME=VALUE ...]\n");
    return STATUS_BAD_INPUT;
  }
  parse(&c, argv[1]);
  for (int i = 2; i < argc; i++) {
    const char *equals = strchr(argv[i], '=');
    const char *name, *value, *end;
    int lines = 0, is_text;

    if (!equals || equals == argv[i] || !equals[1])
      bad_input(argv[1], 0, "'%s': expected NAME=VALUE", argv[i]);
    name = copy(argv[i], (size_t)(equals - argv[i]));
    value = equals + 1;
    end = value_end(value, &lines);
    is_text = strcmp(name, "gear") == 0 || strcmp(name, "layout") == 0;
    if (!is_text && !end)
      bad_input(argv[1], 0, "%s: a bracket or quote is left open", name);
    if (!is_text && *end)
      bad_input(argv[1], 0, "%s = %s is not a finite number", name, value);
    if (strcmp(name, "gear") == 0)
      set_gear(&c, value);
    else if (strcmp(name, "layout") == 0)
      set_layout(&c, value);
    else if (find_parameter(name) || is_named(&c, "parnames", name)) /* before AUTO's constant e */
      put_parameter(&c, name, value);
    else if (find_constant(name))
      set(&c, name, value, 0);
    else
      bad_input(argv[1], 0, "'%s' is neither an AUTO constant nor a parameter (parnames, models/mlg.h)",
                name);
  }
  check(&c);
  for (int i = 0; i < c.n; i++)
    printf("%s = %s\n", c.entry[i].key, c.entry[i].value);
  return output_status("constants");
}
