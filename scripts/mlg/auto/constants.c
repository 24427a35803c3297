/* constants.c - hands values over to an AUTO constants file; see constants.h */
#include "conparts.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "autofile.h"
#include "gearfile.h"
#include "libmlg.h"
#include "mlg.h"

void bad_input(struct constants *c, const char *file, int line, const char *format, ...)
{
  char text[1024];
  va_list args;

  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  if (line > 0)
    text_add(c->why, "%s:%d: %s", file, line, text);
  else
    text_add(c->why, "%s: %s", file, text);
  for (char *t = c->why->at; *t; t++) /* what it quotes may span lines */
    if (iscntrl((unsigned char)*t))
      *t = ' ';
  longjmp(c->refused, 1);
}

void *keep(struct constants *c, size_t size)
{
  if ((c->blocks & (c->blocks - 1)) == 0)
    c->block = must_resize(c->block, (size_t)(c->blocks ? 2 * c->blocks : 1) * sizeof *c->block);
  return c->block[c->blocks++] = must_allocate(size);
}

char *keep_text(struct constants *c, const char *text, size_t length)
{
  char *t = keep(c, length + 1);

  memcpy(t, text, length);
  t[length] = '\0';
  return t;
}

/* --- parameters ------------------------------------------------------------------ */

/* Puts name: value into PAR.  Who goes before keeps its place; nobody gives it twice. */
static void put_parameter(struct constants *c, const char *key, const char *value, const char *file, int line, enum source source)
{
  const char *name = name_of(c, key);
  struct parameter *p;
  int k = 0;

  while (k < c->pars && strcmp(c->par[k].name, name) != 0)
    k++;
  if (k == c->pars) {
    struct parameter *more = keep(c, (size_t)(k + 1) * sizeof *more);

    if (k > 0)
      memcpy(more, c->par, (size_t)k * sizeof *more);
    c->par = more;
    c->pars++;
    c->par[k] = (struct parameter){ key, name, value, file, line, source };
    return;
  }
  p = &c->par[k];
  if (p->source == source && strcmp(key, name) == 0)
    bad_input(c, file, line, "PAR: %s is given twice", name);
  if (p->source == source)
    bad_input(c, file, line, "PAR: %s is given twice, as %s too", name, key);
  if (p->source < source)
    *p = (struct parameter){ p->key, name, value, file, line, source };
}

static void put_dictionary(struct constants *c, const struct entry *e, const char *file, enum source source)
{
  const struct items items = split(c, e);

  if (e->value[0] != '{')
    bad_input(c, file, e->line, "PAR = %s is no dictionary; expected {name: value, ...}", e->value);
  for (int k = 0; k < items.n; k++) {
    if (!items.item[k].key[0])
      bad_input(c, file, e->line, "PAR: '%s' without a name; expected {name: value, ...}", items.item[k].value);
    put_parameter(c, items.item[k].key, items.item[k].value, file, e->line, source);
  }
}

static void put_gear(struct constants *c, const char *file)
{
  struct gear gear;

  if (read_gear(file, &gear, c->why) != 0)
    longjmp(c->refused, 1);
  for (int k = 0; k < gear.n; k++) {
    const struct gear_value *v = &gear.value[k];

    put_parameter(c, v->name, keep_text(c, v->text, strlen(v->text)), file, v->line, OF_GEAR);
  }
}

static struct parameter *find_par(struct constants *c, const char *name)
{
  for (int k = 0; k < c->pars; k++)
    if (strcmp(c->par[k].name, name) == 0)
      return &c->par[k];
  return NULL;
}

/* The static load F_z = (M + m_D) g stands for the M that gives it. */
static void put_load(struct constants *c, const struct constants_use *use)
{
  struct parameter *load = find_par(c, "F_z"), *mass = find_par(c, "M");
  double F_z, par[MLG_SLOTS], value;
  char text[40];

  if (!load)
    return;
  if (use && use->starts)
    bad_input(c, load->file, load->line, "PAR: F_z is the load (M + m_D) g of the solution that the run starts from; give M");
  if (!is_finite(load->value, &F_z))
    bad_input(c, load->file, load->line, "F_z = %s is not a finite number", load->value);
  if (mass && mass->source == load->source)
    bad_input(c, load->file, load->line, "PAR: both M and F_z = (M + m_D) g are given; give one");
  mlg_defaults(par);
  for (int k = 0; k < c->pars; k++) {
    const struct mlg_parameter *p = mlg_find(c->par[k].name, strlen(c->par[k].name));

    if (p && is_finite(c->par[k].value, &value))
      par[p->slot] = value;
  }
  if (!mass || mass->source < load->source) {
    value = F_z / par[PAR_G] - par[PAR_M_D];
    if (!mlg_in_range(mlg_find("M", 1), value))
      bad_input(c, load->file, load->line, "F_z = %s N gives M = %g kg, outside its range, 0 to 1e+06", load->value, value);
    snprintf(text, sizeof text, "%.17g", value);
    if (mass)
      mass->value = keep_text(c, text, strlen(text)), mass->source = load->source;
    else {
      *load = (struct parameter){ "M", "M", keep_text(c, text, strlen(text)), load->file, load->line, load->source };
      return;
    }
  }
  *load = c->par[--c->pars];
}

/* --- constants -------------------------------------------------------------------- */

/* Writes items as the dictionary key; names have quotes, numbers of slots none. */
static void set_dictionary(struct constants *c, const char *key, const struct items *items, int line, enum source source)
{
  struct text text = TEXT_NONE;
  long number;

  text_add(&text, "{");
  for (int k = 0; k < items->n; k++) {
    const char *quote = whole_number(items->item[k].key, 0, 1000000, &number) ? "" : "'";

    text_add(&text, "%s%s%s%s: %s", k ? ", " : "", quote, items->item[k].key, quote, items->item[k].value);
  }
  text_add(&text, "}");
  set_entry(c, key, keep_text(c, text.at, text.length), line, source);
  text_free(&text);
}

/* NDIM and unames of a layout.  In a Hopf curve's THU state 2 NDIM + 1 is omega^2 of
 * AUTO's extended system, which moves with NDIM. */
static void set_layout(struct constants *c, const char *name)
{
  const int layout = libmlg_layout(name), n = libmlg_states(layout);
  const struct entry *ndim = get_entry(&c->own, "NDIM"), *unames = get_entry(&c->own, "unames"), *thu = get_entry(&c->own, "THU");
  struct items items;
  long n_was, slot;
  char number[16];

  if (layout == LIBMLG_NONE)
    bad_input(c, c->file, 0, "layout=%s: there is no models/%s.c", name, name);
  if (!ndim || !whole_number(ndim->value, 1, 1000, &n_was))
    bad_input(c, c->file, ndim ? ndim->line : 0, "expected NDIM, the number of states of a layout");
  if (thu) {
    items = split(c, thu);
    for (int k = 0; k < items.n; k++)
      if (whole_number(items.item[k].key, 1, 3000, &slot) && slot == 2 * n_was + 1) {
        snprintf(number, sizeof number, "%d", 2 * n + 1);
        items.item[k].key = keep_text(c, number, strlen(number));
      }
    set_dictionary(c, "THU", &items, thu->line, thu->source);
  }
  items = (struct items){ keep(c, (size_t)n * sizeof *items.item), n };
  for (int k = 0; k < n; k++) {
    const char *state = libmlg_state_quantity(layout, k)->name;
    char *quoted = keep(c, strlen(state) + 3);

    snprintf(number, sizeof number, "%d", k + 1);
    sprintf(quoted, "'%s'", state);
    items.item[k] = (struct item){ keep_text(c, number, strlen(number)), quoted };
  }
  set_dictionary(c, "unames", &items, unames ? unames->line : 0, OF_FILE);
  snprintf(number, sizeof number, "%d", n);
  set_entry(c, "NDIM", keep_text(c, number, strlen(number)), ndim->line, OF_FILE);
}

static int is_parameter_name(struct constants *c, const char *name)
{
  const struct entry *e = get_entry(&c->own, "parnames");

  if (mlg_find(name, strlen(name)))
    return 1;
  if (e) {
    const struct items names = split(c, e);

    for (int i = 0; i < names.n; i++)
      if (strcmp(names.item[i].value, name) == 0)
        return 1;
  }
  return 0;
}

/* One NAME=VALUE of the command line. */
static void put_word(struct constants *c, const char *word)
{
  const char *equals = strchr(word, '='), *name, *value, *end;
  int lines = 0;

  name = keep_text(c, word, (size_t)(equals - word));
  value = equals + 1;
  if (strcmp(name, "gear") == 0) {
    put_gear(c, value);
    return;
  }
  if (strcmp(name, "layout") == 0) {
    set_layout(c, value);
    return;
  }
  end = value_end(value, &lines);
  if (!end)
    bad_input(c, c->file, 0, "%s: a bracket or quote is left open", name);
  if (*end)
    bad_input(c, c->file, 0, "%s = %s is not a finite number", name, value);
  for (const char *t = value; *t; t++)
    if (iscntrl((unsigned char)*t))
      bad_input(c, c->file, 0, "%s: a line end or another control character in its value", name);
  if (is_parameter_name(c, name)) /* before AUTO's constant e */
    put_parameter(c, name, value, c->file, 0, OF_WORD);
  else if (strcmp(name, "PAR") == 0) {
    const struct entry e = { name, value, 0, OF_WORD };

    put_dictionary(c, &e, c->file, OF_WORD);
  } else if (is_constant(name)) {
    const struct entry *e = get_entry(&c->own, name);

    if (e && e->source == OF_WORD)
      bad_input(c, c->file, 0, "%s is given twice, as %s and %s", name, e->value, value);
    set_entry(c, name, value, 0, OF_WORD);
  } else
    bad_input(c, c->file, 0, "'%s' is neither an AUTO constant nor a parameter (parnames, models/mlg.h)", name);
}

static void check_word(struct constants *c, const char *word)
{
  const char *equals = strchr(word, '=');

  if (!equals || equals == word || !equals[1])
    bad_input(c, c->file, 0, "'%s': expected NAME=VALUE", word);
}

/* PAR as an entry again, in the order of the file. */
static void write_parameters(struct constants *c)
{
  const struct entry *e = get_entry(&c->own, "PAR");
  struct items items = { keep(c, (size_t)(c->pars + 1) * sizeof *items.item), c->pars };

  if (!e && c->pars == 0)
    return;
  for (int k = 0; k < c->pars; k++) {
    const struct parameter *p = &c->par[k];
    const int rigid = strcmp(p->name, "k_s") == 0 && is_infinite(p->value);

    items.item[k] = (struct item){ p->key, rigid ? "1e30" : p->value };
  }
  set_dictionary(c, "PAR", &items, e ? e->line : 0, e ? e->source : OF_WORD);
}

/* NPAR, without which AUTO has room for 36 parameters and the models end at once. */
static void give_room(struct constants *c, const struct constants_use *use)
{
  const struct entry *e = get_entry(&c->own, "NPAR");
  const int slots = use && use->boundary ? MLG_BOUNDARY_SLOTS : MLG_SLOTS;
  char number[16];
  long given;

  if (e && whole_number(e->value, 1, 9999, &given) && given < slots)
    bad_input(c, c->file, e->line, "NPAR = %ld is too few; the model has parameters up to PAR(%d)", given, slots);
  snprintf(number, sizeof number, "%d", slots);
  if (!e)
    set_entry(c, "NPAR", keep_text(c, number, strlen(number)), 0, OF_FILE);
}

int hand_over(const char *file, char *const words[], int n, const struct constants_use *use, struct text *out, struct text *why)
{
  struct constants *c = must_allocate(sizeof *c);
  int status = 0;

  *c = (struct constants){ .file = file, .why = why };
  if (setjmp(c->refused))
    status = 2;
  else {
    const struct entry *par;

    parse_constants(c, file, &c->own);
    if ((par = get_entry(&c->own, "PAR")))
      put_dictionary(c, par, file, OF_FILE);
    for (int i = 0; i < n; i++) {
      check_word(c, words[i]);
      put_word(c, words[i]);
    }
    put_load(c, use);
    write_parameters(c);
    check_constants(c, use);
    give_room(c, use);
    for (int i = 0; i < c->own.n; i++)
      text_add(out, "%s = %s\n", c->own.entry[i].key, c->own.entry[i].value);
  }
  for (int i = 0; i < c->blocks; i++)
    free(c->block[i]);
  free(c->block);
  free(c);
  return status;
}
