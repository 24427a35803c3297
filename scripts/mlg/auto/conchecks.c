/* conchecks.c - what is checked of an AUTO constants file; see constants.h */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "autofile.h"
#include "libmlg.h"
#include "mlg.h"
#include "conparts.h"
#include "units.h"

/* AUTO-07p 0.9.2, manual chapters 10 and 20.  form: 'i' a whole number from least to
 * most, 'r' a number, '+' a number above 0, 'l' a list, 'd' a dictionary, 'n' one of
 * numbers, 't' a text or whatever AUTO makes of it; what is named is marked 'p', a
 * parameter, or 'u', a parameter or a state.  With numbers beyond these AUTO would
 * write stars for them, or never end. */
static const struct auto_constant { const char *key; char form, names; long least, most; } auto_constants[] = {
  { "unames", 'd', 0, 0, 0 },     { "parnames", 'd', 0, 0, 0 },   { "U", 'n', 'u', 0, 0 },        { "PAR", 'n', 'p', 0, 0 },
  { "ICP", 'l', 'p', 0, 0 },      { "UZR", 'n', 'p', 0, 0 },      { "UZSTOP", 'n', 'p', 0, 0 },   { "THL", 'n', 'p', 0, 0 },
  { "THU", 'n', 'u', 0, 0 },      { "SP", 'l', 0, 0, 0 },         { "STOP", 'l', 0, 0, 0 },       { "NDIM", 'i', 0, 1, 999 },
  { "IPS", 'i', 0, -2, 99 },      { "IRS", 't', 0, 0, 0 },        { "ILP", 'i', 0, -9, 99 },      { "NTST", 'i', 0, 1, 9999 },
  { "NCOL", 'i', 0, 2, 7 },       { "IAD", 'i', 0, 0, 9999 },     { "ISP", 'i', 0, -9, 99 },      { "ISW", 'i', 0, -9, 99 },
  { "IPLT", 'i', 0, -999, 9999 }, { "NBC", 'i', 0, 0, 999 },      { "NINT", 'i', 0, 0, 999 },     { "NMX", 'i', 0, 0, 99999 },
  { "NPR", 'i', 0, -999, 9999 },  { "MXBF", 'i', 0, -999, 9999 }, { "IIS", 'i', 0, 0, 9 },        { "IBR", 'i', 0, 0, 999 },
  { "LAB", 'i', 0, 0, 9999 },     { "IID", 'i', 0, 0, 9 },        { "ITMX", 'i', 0, 1, 999 },     { "ITNW", 'i', 0, 1, 999 },
  { "NWTN", 'i', 0, 0, 999 },     { "JAC", 'i', 0, -1, 1 },       { "NPAR", 'i', 0, 1, 9999 },    { "IADS", 'i', 0, 0, 9999 },
  { "DS", 'r', 0, 0, 0 },         { "DSMIN", 'r', 0, 0, 0 },      { "DSMAX", '+', 0, 0, 0 },      { "EPSL", '+', 0, 0, 0 },
  { "EPSU", '+', 0, 0, 0 },       { "EPSS", '+', 0, 0, 0 },       { "RL0", 'r', 0, 0, 0 },        { "RL1", 'r', 0, 0, 0 },
  { "A0", 'r', 0, 0, 0 },         { "A1", 'r', 0, 0, 0 },         { "e", 't', 0, 0, 0 },          { "s", 't', 0, 0, 0 },
  { "dat", 't', 0, 0, 0 },        { "sv", 't', 0, 0, 0 },         { "TY", 't', 0, 0, 0 },
  /* HomCont */
  { "NUNSTAB", 'i', 0, -1, 999 }, { "NSTAB", 'i', 0, -1, 999 },   { "IEQUIB", 'i', 0, -9, 9 },    { "ITWIST", 'i', 0, 0, 9 },
  { "ISTART", 'i', 0, -999, 999 }, { "IREV", 'l', 0, 0, 0 },      { "IFIXED", 'l', 0, 0, 0 },     { "IPSI", 'l', 0, 0, 0 },
};

static const struct auto_constant *find_constant(const char *key)
{
  for (size_t i = 0; i < sizeof auto_constants / sizeof *auto_constants; i++)
    if (strcmp(key, auto_constants[i].key) == 0)
      return &auto_constants[i];
  return NULL;
}

int is_constant(const char *key)
{
  return find_constant(key) != NULL;
}

static int is_slot(const char *text, long *slot)
{
  return whole_number(text, -9999, 9999, slot);
}

const char *name_of(struct constants *c, const char *text)
{
  const struct entry *e = get_entry(&c->own, "parnames");
  long slot;

  if (e) {
    const struct items parnames = split(c, e);

    for (int i = 0; i < parnames.n; i++)
      if (strcmp(parnames.item[i].key, text) == 0)
        return parnames.item[i].value;
  }
  for (int k = 0; k < MLG_PARAMETER_COUNT && is_slot(text, &slot); k++)
    if (mlg_parameters[k].slot + 1 == slot)
      return mlg_parameters[k].name;
  return text;
}

static int has_name(const struct items *names, const char *name)
{
  for (int i = 0; i < names->n; i++)
    if (strcmp(names->item[i].value, name) == 0)
      return 1;
  return 0;
}

/* parnames: a name of the model stands under its own slot; the algebraic problem of a
 * layout's boundary has unknowns of its own, of which one may be called like a parameter. */
static void check_parnames(struct constants *c, const struct entry *e, const struct items *parnames, const struct constants_use *use)
{
  const int own_names = use && use->boundary;

  for (int i = 0; i < parnames->n; i++) {
    const struct item *it = &parnames->item[i];
    const struct mlg_parameter *p = mlg_find(it->value, strlen(it->value));
    long slot;

    if (p && own_names && is_slot(it->key, &slot) && slot != p->slot + 1)
      p = NULL;
    if (!is_slot(it->key, &slot) || slot < 1)
      bad_input(c, c->file, e->line, "parnames: '%s' is not a slot; expected 1, 2, ...", it->key);
    if (strlen(it->value) > 13)
      bad_input(c, c->file, e->line, "parnames: '%s' is longer than AUTO reads, 13 characters", it->value);
    if (p && slot != p->slot + 1)
      bad_input(c, c->file, e->line, "parnames: %s stands under %ld; it is PAR(%d)", it->value, slot, p->slot + 1);
    for (int k = 0; k < MLG_PARAMETER_COUNT; k++)
      if (!p && mlg_parameters[k].slot + 1 == slot)
        bad_input(c, c->file, e->line, "parnames: PAR(%ld) is called '%s'; its name is %s", slot, it->value,
                  mlg_parameters[k].name);
  }
}

static void check_name(struct constants *c, const struct entry *e, const char *text, const struct items *parnames,
                       const struct items *unames, char kind)
{
  const char *name = text[0] == '-' ? text + 1 : text;
  long slot;

  if (is_slot(name, &slot) || has_name(parnames, name) || (kind == 'u' && has_name(unames, name)))
    return;
  bad_input(c, c->file, e->line, "%s: '%s' is not a name of %s", e->key, name, kind == 'u' ? "unames" : "parnames");
}

/* Whether text names points by type, and perhaps by number: HB, HB2. */
static int is_point(const char *text)
{
  static const char *const types[] = { "BP", "LP", "HB", "PD", "TR", "UZ", "EP", "MX", "BT",
                                       "CP", "GH", "ZH", "R1", "R2", "R3", "R4" };

  text += *text == '-';
  for (size_t i = 0; i < sizeof types / sizeof *types; i++)
    if (strncmp(text, types[i], 2) == 0)
      return 1;
  return 0;
}

/* Whether what follows the type of a point is nothing or a number from least. */
static int is_number_of_points(const char *text, long least)
{
  const char *number = text + (*text == '-') + 2;
  long n;

  return !*number || (*number != '-' && whole_number(number, least, 99999, &n));
}

/* IRS: 0, a label (below 0: which of the solutions), or a type and which of it, HB2.  With
 * no such number AUTO would take label 1, and at 0 start from what no solution has given. */
static void check_irs(struct constants *c, const struct entry *e, const struct items *items)
{
  const char *irs = items->n == 1 && e->value[0] != '[' && !items->item[0].key[0] ? items->item[0].value : "";
  const int type = is_point(irs) && irs[0] != '-' ? 2 : 0;
  long n;

  if (strlen(irs) > 11 || !whole_number(irs + type, type ? 1 : -99999, 99999, &n) || (n == 0 && strcmp(irs, "0") != 0))
    bad_input(c, c->file, e->line, "IRS = %s: expected a label, or a type of point and which of these, as HB1", e->value);
}

/* Whether a value, its items split, has the form that AUTO reads. */
static void check_form(struct constants *c, const struct entry *e, const struct auto_constant *k, const struct items *items)
{
  double x;
  long n;

  if (k->form == 'i' || k->form == 'r' || k->form == '+') {
    if (!is_finite(e->value, &x))
      bad_input(c, c->file, e->line, "%s = %s is not a finite number", e->key, e->value);
    if (k->form == 'i' && !whole_number(e->value, -999999999L, 999999999L, &n))
      bad_input(c, c->file, e->line, "%s = %s is not a whole number", e->key, e->value);
    if (k->form == 'i' && (n < k->least || n > k->most))
      bad_input(c, c->file, e->line, "%s = %s is outside what AUTO can do, %ld to %ld", e->key, e->value, k->least, k->most);
    if ((k->form == '+' && !(x > 0.)) || (strcmp(e->key, "DSMIN") == 0 && x < 0.))
      bad_input(c, c->file, e->line, "%s = %s has to be above 0", e->key, e->value);
  } else if (k->form == 'l') {
    if (e->value[0] != '[')
      bad_input(c, c->file, e->line, "%s = %s is no list; expected [name, ...]", e->key, e->value);
    for (int i = 0; i < items->n; i++)
      if (items->item[i].key[0])
        bad_input(c, c->file, e->line, "%s: '%s:' in a list; expected [name, ...]", e->key, items->item[i].key);
  } else if (k->form == 'd' || k->form == 'n') {
    if (e->value[0] != '{')
      bad_input(c, c->file, e->line, "%s = %s is no dictionary; expected {name: value, ...}", e->key, e->value);
    for (int i = 0; i < items->n; i++) {
      if (!items->item[i].key[0])
        bad_input(c, c->file, e->line, "%s: '%s' without a name; expected {name: value, ...}", e->key, items->item[i].value);
      for (int j = 0; j < i; j++)
        if (strcmp(items->item[j].key, items->item[i].key) == 0)
          bad_input(c, c->file, e->line, "%s: %s is given twice", e->key, items->item[i].key);
    }
  }
}

/* The value, or each of a list of them, that a dictionary gives to a name. */
static void check_numbers(struct constants *c, const struct entry *e, const struct item *it)
{
  const struct entry value = { e->key, it->value, e->line, e->source };
  const struct items numbers = split(c, &value);
  double x;

  if (!it->value[0])
    bad_input(c, c->file, e->line, "%s: %s has no value; expected {name: value, ...}", e->key, it->key);
  for (int i = 0; i < numbers.n; i++)
    if (numbers.item[i].key[0] || !is_finite(numbers.item[i].value, &x))
      bad_input(c, c->file, e->line, "%s: %s = %s is not a finite number", e->key, it->key, it->value);
}

/* Whether a parameter makes any difference to a layout. */
static int has_parameter(int layout, const struct mlg_parameter *p)
{
  return libmlg_uses(layout, libmlg_parameter(p->name)) == 1;
}

/* The value at which an element is as good as absent, or NaN. */
static double neutral(const struct mlg_parameter *p)
{
  return p->slot == PAR_K_S ? MLG_RIGID : p->slot == PAR_B || p->slot >= PAR_G_PSI ? 0. : (double)NAN;
}

static void check_parameter(struct constants *c, const struct parameter *p, const struct constants_use *use)
{
  const struct mlg_parameter *known = mlg_find(p->name, strlen(p->name));
  const int layout = use && use->layout ? libmlg_layout(use->layout) : LIBMLG_NONE;
  double x;

  if (known && known->slot == PAR_K_S && is_infinite(p->value))
    x = MLG_RIGID;
  else if (!is_finite(p->value, &x))
    bad_input(c, p->file, p->line, "%s = %s is not a finite number", p->name, p->value);
  if (known && !mlg_in_range(known, x))
    bad_input(c, p->file, p->line, "%s = %s %s is outside its range, %g to %g%s", p->name, p->value, known->unit,
              known->least, known->most, known->slot == PAR_K_S ? "; 1e30 is rigid" : "");
  if (known && layout != LIBMLG_NONE && !has_parameter(layout, known)
      && !(known->slot == PAR_K_S ? x >= MLG_RIGID : x == neutral(known)))
    bad_input(c, p->file, p->line, "%s = %s: the device of %s has no %s%s", p->name, p->value, use->layout, p->name,
              isnan(neutral(known)) ? "" : known->slot == PAR_K_S ? "; leave it at inf" : "; leave it at 0");
}

/* That no law of models/elements.h lacks what it needs. */
static void check_laws(struct constants *c)
{
  double slots[MLG_SLOTS] = { 0. };

  mlg_defaults(slots);
  for (int k = 0; k < c->pars; k++) {
    const struct mlg_parameter *p = mlg_find(c->par[k].name, strlen(c->par[k].name));

    if (p)
      is_finite(c->par[k].value, &slots[p->slot]);
  }
  if (mlg_lacks(slots))
    bad_input(c, c->file, 0, "%s", mlg_lacks(slots));
}

/* The names in a list or dictionary. */
static void check_names(struct constants *c, const struct entry *e, const struct auto_constant *constant, const struct items *items,
                        const struct items *parnames, const struct items *unames, int curve, const struct constants_use *use)
{
  const int layout = use && use->layout && !use->boundary ? libmlg_layout(use->layout) : LIBMLG_NONE;

  for (int k = 0; k < items->n; k++) {
    const struct item *it = &items->item[k];
    const char *name = name_of(c, it->key[0] ? it->key : it->value);
    const struct mlg_parameter *p = mlg_find(name, strlen(name));
    const int set = strcmp(e->key, "PAR") == 0;
    const int continued = strcmp(e->key, "ICP") == 0 && k <= curve;

    check_name(c, e, name, parnames, unames, constant->names);
    if ((set || continued) && result_of(name))
      bad_input(c, c->file, e->line, "%s: %s is a result (%s); it cannot be %s", e->key, name, result_of(name)->meaning,
                set ? "set" : "continued");
    if (continued && p && layout != LIBMLG_NONE && !has_parameter(layout, p))
      bad_input(c, c->file, e->line, "ICP: the device of %s has no %s; it cannot be continued", use->layout, name);
    if (!set && constant->form == 'n')
      check_numbers(c, e, it);
  }
}

static void check_states(struct constants *c, const struct items *unames, const struct constants_use *use)
{
  const struct entry *e = get_entry(&c->own, "NDIM");
  const int states = use && use->layout && !use->boundary ? libmlg_states(libmlg_layout(use->layout)) : LIBMLG_NONE;
  long ndim;

  if (!e)
    return;
  if (!whole_number(e->value, 1, 999999999L, &ndim))
    bad_input(c, c->file, e->line, "NDIM = %s is not a number of states", e->value);
  if (unames->n > 0 && unames->n != ndim)
    bad_input(c, c->file, e->line, "NDIM = %ld, but unames names %d states", ndim, unames->n);
  if (states != LIBMLG_NONE && ndim != states)
    bad_input(c, c->file, e->line, "NDIM = %ld, but the layout %s has %d states", ndim, use->layout, states);
}

void check_constants(struct constants *c, const struct constants_use *use)
{
  struct items parnames = { NULL, 0 }, unames = { NULL, 0 };
  const struct entry *e = get_entry(&c->own, "ISW");
  long isw;
  const int curve = e && whole_number(e->value, -9, 99, &isw) && labs(isw) == 2;

  if ((e = get_entry(&c->own, "parnames"))) {
    parnames = split(c, e);
    check_parnames(c, e, &parnames, use);
  }
  if ((e = get_entry(&c->own, "unames")))
    unames = split(c, e);
  check_states(c, &unames, use);
  for (int i = 0; i < c->own.n; i++) {
    const struct auto_constant *constant;
    struct items items;

    e = &c->own.entry[i];
    constant = find_constant(e->key);
    items = split(c, e);
    check_form(c, e, constant, &items);
    if (strcmp(e->key, "ICP") == 0 && items.n == 0)
      bad_input(c, c->file, e->line, "ICP names no parameter to continue");
    for (int k = 0; k < items.n && (strcmp(e->key, "SP") == 0 || strcmp(e->key, "STOP") == 0); k++)
      if (!is_point(items.item[k].value) || !is_number_of_points(items.item[k].value, e->key[1] == 'T'))
        bad_input(c, c->file, e->line, "%s: '%s' is no type of point; expected HB, LP2, ...", e->key, items.item[k].value);
    if (strcmp(e->key, "IRS") == 0)
      check_irs(c, e, &items);
    if (constant->names)
      check_names(c, e, constant, &items, &parnames, &unames, curve, use);
  }
  for (int k = 0; k < c->pars; k++)
    check_parameter(c, &c->par[k], use);
  if (!use || !use->starts)
    check_laws(c);
}
