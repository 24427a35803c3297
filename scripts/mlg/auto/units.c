/* units.c - units of the columns of AUTO's files by their names; see units.h */
#include "units.h"

#include <ctype.h>
#include <string.h>

#include "libmlg.h"
#include "mlg.h"

struct unit { const char *name, *unit; };

static const struct result results[] = {
#define X(slot, id, name, unit, meaning) { name, unit, meaning },
  MLG_RESULTS(X)
#undef X
};

const struct result *result_of(const char *name)
{
  for (size_t i = 0; i < sizeof results / sizeof *results; i++)
    if (strcmp(name, results[i].name) == 0)
      return &results[i];
  return NULL;
}

static const struct unit others[] = {
  { "period", "s" }, { "PERIOD", "s" }, { "torus_angle", "rad" },
  /* of models/boundary.h */
  { "compliance", "1e-5 rad/(N m)" }, { "zeta", "-" }, { "width", "N m s/rad" },
};

/* V_1, c_1, f_1, ...: results of point 1 to 4 of models/boundary.h. */
static const struct unit numbered[] = {
  { "V_", "m/s" }, { "c_", "N m s/rad" }, { "f_", "Hz" }, { "ratio_", "-" },
};

const char *unit_of(const char *name)
{
  const struct mlg_parameter *p;

  if (strncmp(name, "MAX ", 4) == 0 || strncmp(name, "MIN ", 4) == 0)
    name += 4;
  p = mlg_find(name, strlen(name));
  if (p)
    return p->unit;
  if (result_of(name))
    return result_of(name)->unit;
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (strcmp(name, others[i].name) == 0)
      return others[i].unit;
  for (size_t i = 0; i < sizeof numbered / sizeof *numbered; i++) {
    const size_t n = strlen(numbered[i].name);

    if (strncmp(name, numbered[i].name, n) == 0 && isdigit((unsigned char)name[n]) && !name[n + 1])
      return numbered[i].unit;
  }
  for (int layout = 0; layout < libmlg_layouts(); layout++) {
    const int state = libmlg_state(layout, name);

    if (state != LIBMLG_NONE)
      return libmlg_state_quantity(layout, state)->unit;
  }
  return NULL;
}

void add_units(struct text *text, char *const name[], int n)
{
  int any = 0;

  for (int k = 0; k < n; k++)
    if (unit_of(name[k]))
      text_add(text, "%s%s %s", any++ ? "; " : "", name[k], unit_of(name[k]));
}
