/* device_layout.c - a device that was read from text as a layout of the library
 *
 * All of them share the functions below; par[PAR_DEVICE], a slot of AUTO's own that the
 * library has no use for, says which device it is about.
 */
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "mlg.h"

/* x_1 to x_6 make the transfer function of the device; of these it uses its order. */
#define DEVICE_STATES(X)         \
  X(X1, "x_1", "-", "state 1")   \
  X(X2, "x_2", "-", "state 2")   \
  X(X3, "x_3", "-", "state 3")   \
  X(X4, "x_4", "-", "state 4")   \
  X(X5, "x_5", "-", "state 5")   \
  X(X6, "x_6", "-", "state 6")

enum { LAST_OF_GEAR = LAMBDA_R, DEVICE_STATES(MLG_NUMBERED) NDIM, STATES = NDIM - GEAR_STATES };

static double device(const double par[], const double u[], double du[]);
static struct network device_network(const double par[]);

#define MLG_NO_AUTO
#define MLG_APART
#include "plugin.h"

#include "device_text.h"

enum { PAR_DEVICE = 10 - 1, MOST_DEVICES = 4096 };

_Static_assert((int)STATES == (int)DEVICE_ORDER, "a state for each power of s");

struct device_layout { struct libmlg_layout layout; struct device_text device; };

static struct device_layout *_Atomic devices[MOST_DEVICES];

static const struct device_text *device_at(const double par[])
{
  return &devices[(int)par[PAR_DEVICE]]->device;
}

static struct network device_network(const double par[])
{
  return device_stiffness(device_at(par), par);
}

/* The torque Z psi, Z = num/den, by the controller's canonical form in w = s / omega, omega
 * between the frequencies of the two modes: den(w) x_1 = psi, x_{i+1} = x_i' / omega.  Where
 * an element of 0 or a rigid spring takes the leading coefficients, the states above the
 * degree only follow. */
static double device(const double par[], const double u[], double du[])
{
  const double omega = 80., *const x = u + X1;
  struct network Z = device_network(par);
  double unit = 1., through, T_d;
  const int n = poly_degree(&Z.den);

  for (int i = 0; i <= n; i++, unit *= omega) {
    Z.num.coefficient[i] *= unit;
    Z.den.coefficient[i] *= unit;
  }
  const double lead = Z.den.coefficient[n];

  through = Z.num.coefficient[n] / lead;
  T_d = through * u[PSI];
  for (int i = 0; i < n; i++)
    T_d += (Z.num.coefficient[i] - through * Z.den.coefficient[i]) * x[i];
  for (int i = 0; i < STATES; i++)
    du[X1 + i] = i + 1 < n ? omega * x[i + 1] : -MLG_FOLLOW * x[i];
  if (n > 0) {
    double last = u[PSI];

    for (int i = 0; i < n; i++)
      last -= Z.den.coefficient[i] * x[i];
    du[X1 + n - 1] = omega * last / lead;
  }
  return T_d;
}

static const struct libmlg_quantity state[NDIM] = {
#define X(id, name, unit, meaning) { name, unit, meaning },
  MLG_STATES(X)
#undef X
};

/* par[] of the functions above, and u[], f[] of all states, from those of the device. */
struct place { double par[MLG_SLOTS], u[NDIM], f[NDIM]; };

static void widen(struct place *p, const struct libmlg_layout *l, const double par[], const double u[])
{
  memset(p, 0, sizeof *p);
  memcpy(p->par, par, sizeof p->par);
  p->par[PAR_DEVICE] = l->number;
  memcpy(p->u, u, (size_t)l->states * sizeof *u);
}

static void rhs(const struct libmlg_layout *l, const double par[], const double u[], double f[])
{
  struct place p;

  widen(&p, l, par, u);
  right_hand_side(p.par, p.u, p.f);
  memcpy(f, p.f, (size_t)l->states * sizeof *f);
}

static void jacobian(const struct libmlg_layout *l, const double par[], const double u[], const double f[], double dfdu[],
                     double dfdp[])
{
  const size_t row = (size_t)l->states * sizeof *f;
  double by_u[NDIM * NDIM], by_p[MLG_SLOTS * NDIM];
  struct place p;

  widen(&p, l, par, u);
  memcpy(p.f, f, row);
  derivatives(p.par, p.u, p.f, by_u, dfdp ? by_p : NULL);
  for (int j = 0; j < l->states; j++)
    memcpy(dfdu + j * l->states, by_u + j * NDIM, row);
  for (int j = 0; j < MLG_SLOTS && dfdp; j++)
    memcpy(dfdp + j * l->states, by_p + j * NDIM, row);
}

static double torque(const struct libmlg_layout *l, const double par[], const double u[])
{
  struct place p;

  widen(&p, l, par, u);
  return device(p.par, p.u, p.f);
}

static struct network network_of(const struct libmlg_layout *l, const double par[])
{
  return device_stiffness(&devices[l->number]->device, par);
}

/* Networks are linear (friction of the wheels is the gear's). */
static int no_corners(const struct libmlg_layout *l, const double par[], const double u[], double at[MLG_MOST_CORNERS])
{
  (void)l, (void)par, (void)u, (void)at;
  return 0;
}

static const struct libmlg_layout *layout_at(int n)
{
  struct device_layout *const d = n >= 0 && n < MOST_DEVICES ? devices[n] : NULL;

  return d ? &d->layout : NULL;
}

const struct libmlg_layout *libmlg_find_device(int layout)
{
  return layout_at(layout - libmlg_layouts());
}

struct device_text *device_writable(int layout)
{
  return libmlg_find_device(layout) ? &devices[layout - libmlg_layouts()]->device : NULL;
}

const struct device_text *device_of(int layout)
{
  return device_writable(layout);
}

struct part *device_element(int layout, const char *name, const char **wrong)
{
  struct device_text *const d = device_writable(layout);
  const size_t length = strlen(name);
  struct part *found = NULL;

  *wrong = d ? "the network has no element NAME=VALUE of this name" : "a layout has no elements but those of its parameters; give it as a network";
  for (int i = 0; d && i < d->parts; i++) {
    struct part *const p = &d->part[i];

    if (p->slot >= 0 || !p->text || strncmp(p->text, name, length) != 0 || p->text[length] != '=')
      continue;
    if (found) {
      *wrong = "the network has more than one element of this name";
      return NULL;
    }
    found = p;
  }
  return found;
}

/* Takes the next number, or that of the same text, for which d is freed. */
static int enter(struct device_layout *d, char error[], size_t size)
{
  int n = 0;

  d->layout = (struct libmlg_layout){ d->device.text, GEAR_STATES + d->device.order, state, rhs, jacobian, torque,
                                      network_of, no_corners, 0 };
  for (struct device_layout *none = NULL; n < MOST_DEVICES; n++, none = NULL) {
    d->layout.number = n;
    if (atomic_compare_exchange_strong(&devices[n], &none, d))
      return libmlg_layouts() + n;
    if (d->device.whole && strcmp(devices[n]->device.text, d->device.text) == 0) {
      free(d);
      return libmlg_layouts() + n;
    }
  }
  free(d);
  snprintf(error, size, "there are %d networks already", MOST_DEVICES);
  return LIBMLG_NONE;
}

int device_rational(int order)
{
  struct device_layout *d = calloc(1, sizeof *d);
  char ignored[1];

  if (!d)
    return LIBMLG_NONE;
  d->device.order = order + 1; /* with c_d */
  d->device.rational.den.coefficient[0] = 1.;
  return enter(d, ignored, sizeof ignored);
}

int libmlg_network(const char *text, char error[], size_t size)
{
  char ignored[1];
  struct device_layout *d = malloc(sizeof *d);

  if (size == 0) {
    error = ignored;
    size = sizeof ignored;
  }
  if (!d) {
    snprintf(error, size, "out of memory");
    return LIBMLG_NONE;
  }
  if (device_read(&d->device, text, error, size) != 0) {
    free(d);
    return LIBMLG_NONE;
  }
  return enter(d, error, size);
}
