/* layout.c - one layout for the library
 *
 * Compiled once per layout around its device, -DLAYOUT='"l1.c"' -DNAME=l1.
 */
#define MLG_NO_AUTO
#include LAYOUT
#include "layout.h"

#define TEXT_OF(name) #name
#define TEXT(name) TEXT_OF(name)
#define ENTRY_OF(name) libmlg_layout_##name
#define ENTRY(name) ENTRY_OF(name)

static const struct libmlg_quantity state[NDIM] = {
#define X(id, name, unit, meaning) { name, unit, meaning },
  MLG_STATES(X)
#undef X
};

_Static_assert((int)NDIM <= (int)LIBMLG_MOST_STATES, "libmlg.h promises enough");

static void rhs(const struct libmlg_layout *l, const double par[], const double u[], double f[])
{
  (void)l;
  right_hand_side(par, u, f);
}

static void jacobian(const struct libmlg_layout *l, const double par[], const double u[], const double f[], double dfdu[],
                     double dfdp[])
{
  (void)l;
  derivatives(par, u, f, dfdu, dfdp);
}

static double torque(const struct libmlg_layout *l, const double par[], const double u[])
{
  double rates[NDIM];

  (void)l;
  return device(par, u, rates);
}

static struct network network(const struct libmlg_layout *l, const double par[])
{
  (void)l;
  return device_network(par);
}

static int corners(const struct libmlg_layout *l, const double par[], const double u[], double at[MLG_MOST_CORNERS])
{
  struct mlg_corners look = { .n = 0 };
  double rates[NDIM];

  (void)l;
  mlg_looking = &look;
  torque_on_wheels(par, u, rates);
  mlg_looking = NULL;
  memcpy(at, look.at, (size_t)look.n * sizeof *at);
  return look.n;
}

const struct libmlg_layout ENTRY(NAME) = {
  TEXT(NAME), NDIM, state, rhs, jacobian, torque, network, corners, 0,
};
