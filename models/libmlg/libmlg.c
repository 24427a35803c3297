/* libmlg.c - layouts, states and parameters by name; rates and their derivatives
 *
 * The layouts come from layout.c; the Makefile names them in layouts.h,
 * L(l1) L(l2) ...
 */
#include <math.h>
#include <string.h>

#include "layout.h"

#define L(name) extern const struct libmlg_layout libmlg_layout_##name;
#include "layouts.h"
#undef L

static const struct libmlg_layout *const layouts[] = {
#define L(name) &libmlg_layout_##name,
#include "layouts.h"
#undef L
};

static const struct {
  struct libmlg_quantity quantity;
  int index; /* in AUTO's par[] */
  double value, least, most;
} parameters[] = {
#define X(slot, id, name, unit, value, least, most, meaning) { { name, unit, meaning }, PAR_##id, value, least, most },
  MLG_PARAMETERS(X)
#undef X
};

enum { LAYOUT_COUNT = sizeof layouts / sizeof *layouts, PARAMETERS = sizeof parameters / sizeof *parameters };

_Static_assert((int)PARAMETERS <= (int)LIBMLG_MOST_PARAMETERS, "libmlg.h promises enough");

const struct libmlg_layout *libmlg_find(int layout)
{
  return layout >= 0 && layout < LAYOUT_COUNT ? layouts[layout] : libmlg_find_device(layout);
}

int libmlg_layouts(void)
{
  return LAYOUT_COUNT;
}

int libmlg_layout(const char *name)
{
  for (int i = 0; i < LAYOUT_COUNT; i++)
    if (strcmp(layouts[i]->name, name) == 0)
      return i;
  return LIBMLG_NONE;
}

const char *libmlg_layout_name(int layout)
{
  const struct libmlg_layout *l = libmlg_find(layout);

  return l ? l->name : NULL;
}

int libmlg_states(int layout)
{
  const struct libmlg_layout *l = libmlg_find(layout);

  return l ? l->states : LIBMLG_NONE;
}

int libmlg_state(int layout, const char *name)
{
  for (int i = 0; i < libmlg_states(layout); i++)
    if (strcmp(libmlg_find(layout)->state[i].name, name) == 0)
      return i;
  return LIBMLG_NONE;
}

const struct libmlg_quantity *libmlg_state_quantity(int layout, int state)
{
  return state >= 0 && state < libmlg_states(layout) ? &libmlg_find(layout)->state[state] : NULL;
}

int libmlg_parameters(void)
{
  return PARAMETERS;
}

int libmlg_parameter(const char *name)
{
  for (int i = 0; i < PARAMETERS; i++)
    if (strcmp(parameters[i].quantity.name, name) == 0)
      return i;
  return LIBMLG_NONE;
}

static int is_parameter(int i)
{
  return i >= 0 && i < PARAMETERS;
}

const struct libmlg_quantity *libmlg_parameter_quantity(int i)
{
  return is_parameter(i) ? &parameters[i].quantity : NULL;
}

double libmlg_default(int i)
{
  return is_parameter(i) ? parameters[i].value : NAN;
}

double libmlg_least(int i)
{
  return is_parameter(i) ? parameters[i].least : NAN;
}

double libmlg_most(int i)
{
  return is_parameter(i) ? parameters[i].most : NAN;
}

void libmlg_defaults(double par[])
{
  for (int i = 0; i < PARAMETERS; i++)
    par[i] = parameters[i].value;
}

int libmlg_outside(const double par[])
{
  for (int i = 0; i < PARAMETERS; i++)
    if (!(par[i] >= parameters[i].least && par[i] <= parameters[i].most))
      return i;
  return LIBMLG_NONE;
}

void libmlg_slots(const double par[], double slots[MLG_SLOTS])
{
  memset(slots, 0, MLG_SLOTS * sizeof *slots);
  for (int i = 0; i < PARAMETERS; i++)
    slots[parameters[i].index] = par[i];
}

/* Elements that move no result in its tenth digit, but would put an eigenvalue so far from the
 * others that these have no digits left in the same matrix, are none at all, or rigid. */
static void without_specks(double slots[MLG_SLOTS])
{
  const double J = slots[PAR_J_ZETA], k = slots[PAR_K_PSI];

  if (slots[PAR_B] < 1e-11 * J)
    slots[PAR_B] = 0.;
  if (slots[PAR_C_D] < 1e-12 * sqrt(J * k))
    slots[PAR_C_D] = 0.;
  if (slots[PAR_K_S] > 1e10 * k)
    slots[PAR_K_S] = MLG_RIGID;
}

void libmlg_slots_at_rest(const double par[], double slots[MLG_SLOTS])
{
  libmlg_slots(par, slots);
  mlg_at_rest(slots);
  without_specks(slots);
}

const char *libmlg_lacks(const double par[])
{
  double slots[MLG_SLOTS];

  libmlg_slots(par, slots);
  return mlg_lacks(slots);
}

int libmlg_rhs(int layout, const double par[], const double u[], double f[])
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
  l->rhs(l, slots, u, f);
  return 0;
}

int libmlg_jacobian(int layout, const double par[], const double u[], double dfdu[], double dfdp[])
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS], f[LIBMLG_MOST_STATES], all[MLG_SLOTS * LIBMLG_MOST_STATES];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
  l->rhs(l, slots, u, f);
  l->jacobian(l, slots, u, f, dfdu, dfdp ? all : NULL);
  for (int k = 0; dfdp && k < PARAMETERS; k++)
    memcpy(dfdp + k * l->states, all + parameters[k].index * l->states, (size_t)l->states * sizeof *dfdp);
  return 0;
}

int libmlg_torque(int layout, const double par[], const double u[], double *T_d)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
  *T_d = l->torque(l, slots, u);
  return 0;
}

int libmlg_gap(int layout, const double par[], const double u[], double *x, double *g)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS], at[MLG_MOST_CORNERS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
  slots[PAR_CORNER] = 0.; /* its sharp ends, x - g and x + g, come first of all corners */
  if (!(slots[PAR_G_PSI] > 0. || slots[PAR_G_S] > 0.) || l->corners(l, slots, u, at) < 2)
    return LIBMLG_FAILED;
  *x = 0.5 * (at[0] + at[1]);
  *g = 0.5 * (at[1] - at[0]);
  return 0;
}

/* Whether the rates at some state move with the parameter, of a device that has all. */
int libmlg_uses(int layout, int parameter)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[2][MLG_SLOTS] = { { 0. } }, u[LIBMLG_MOST_STATES], f[2][LIBMLG_MOST_STATES];

  if (!l || !is_parameter(parameter))
    return LIBMLG_NONE;
  for (int k = 0; k < 2; k++) {
    double *const p = slots[k];

    mlg_defaults(p);
    mlg_with_all_laws(p);
    if (k == 1) {
      double *const moved = &p[parameters[parameter].index];

      *moved = *moved != 0. ? 1.1 * *moved : 1.; /* a doubt */
    }
    for (int i = 0; i < l->states; i++)
      u[i] = 1e-2 * (i + 1);
    l->rhs(l, p, u, f[k]);
  }
  return memcmp(f[0], f[1], (size_t)l->states * sizeof **f) != 0;
}
