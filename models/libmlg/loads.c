/* loads.c - the design that is best damped over a range of loads, and the largest load with
 * any zero-shimmy design
 */
#include <math.h>
#include <string.h>

#include "layout.h"
#include "places.h"

enum { NODES_K_S = 64, NODES_B = 32, MOST = LIBMLG_MOST_POINTS, LOADS = 7 };

/* --- best damped over a range of loads ------------------------------------------------------ */

/* The place of a design between 0 and 1: u = 1/(1 + k_s/k_psi), v of b in its range. */
struct search {
  int layout, k_s, b;
  double par[LIBMLG_MOST_PARAMETERS], k_psi, b_least, b_most, V_least, V_top, load[LOADS];
  int first; /* of the loads, the one that is asked first */
  struct libmlg_ratio best;
  int status;
};

struct range { double lo, hi; };

/* What is common to both lists, into a[]. */
static int intersect(struct range a[], int n, const struct libmlg_interval b[], int m)
{
  struct range both[MOST];
  int k = 0;

  for (int i = 0; i < n; i++)
    for (int j = 0; j < m && k < MOST; j++) {
      const double lo = fmax(a[i].lo, b[j].lo.c_d), hi = fmin(a[i].hi, b[j].hi.c_d);

      if (lo < hi)
        both[k++] = (struct range){ lo, hi };
    }
  memcpy(a, both, (size_t)k * sizeof *both);
  return k;
}

/* Whether some c_d has at least the ratio zeta at all loads, and one that has. */
static int has(struct search *s, double zeta, double *c_d)
{
  struct range common[MOST] = { { 0., INFINITY } };
  int n = 1;

  for (int i = 0; i < LOADS && n > 0; i++) {
    const int at = (s->first + i) % LOADS;
    struct libmlg_interval interval[MOST];
    double par[LIBMLG_MOST_PARAMETERS];

    memcpy(par, s->par, sizeof par);
    libmlg_set(par, LIBMLG_F_Z, s->load[at]);
    const int m = libmlg_intervals(s->layout, par, zeta, s->V_least, s->V_top, interval, MOST);

    if (m < 0)
      s->status = m;
    n = intersect(common, n, interval, m < 0 ? 0 : m);
    if (n == 0)
      s->first = at;
  }
  if (n == 0)
    return 0;
  const double lo = common[0].lo, hi = common[0].hi;

  *c_d = isfinite(hi) ? (lo > 0. ? sqrt(lo * hi) : 0.5 * hi) : lo > 0. ? 2. * lo : 1.;
  return 1;
}

/* The largest ratio at one k_s and b, when it is above the best so far; 1: it is.  What has a
 * ratio has every lesser one, so that bisection is exact. */
static int improve(struct search *s, double u, double v)
{
  double lo = s->best.zeta, hi, c_d, c;

  if (libmlg_uses(s->layout, s->k_s) == 1)
    s->par[s->k_s] = libmlg_place_k_s(s->k_psi, u, MLG_RIGID);
  if (libmlg_uses(s->layout, s->b) == 1)
    s->par[s->b] = s->b_least + v * (s->b_most - s->b_least);
  if (!has(s, lo + 1e-9 * fabs(lo), &c_d))
    return 0;
  for (double step = fmax(0.1 * fabs(lo), 1e-6); (hi = fmin(lo + step, 0.9)) < 0.9 && has(s, hi, &c); step *= 2.) {
    lo = hi;
    c_d = c;
  }
  while (hi - lo > 1e-10 * fmax(fabs(lo), 1e-6)) {
    const double middle = 0.5 * (lo + hi);

    if (has(s, middle, &c)) {
      lo = middle;
      c_d = c;
    } else
      hi = middle;
  }
  s->best = (struct libmlg_ratio){ .zeta = lo, .c_d = c_d, .k_s = s->par[s->k_s], .b = s->par[s->b] };
  return 1;
}

int libmlg_best_over_loads(int layout, const double par[], double F_least, double F_most, double b_least, double b_most,
                           double V_least, double V_top, struct libmlg_ratio *best)
{
  struct search s = { .layout = layout, .k_s = libmlg_parameter("k_s"), .b = libmlg_parameter("b"), .b_least = b_least,
                      .b_most = b_most, .V_least = V_least, .V_top = V_top, .best.zeta = -0.9 };
  const int around = 5;
  double u = 0., v = 0.;

  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  memcpy(s.par, par, (size_t)libmlg_parameters() * sizeof *par);
  s.k_psi = par[libmlg_parameter("k_psi")];
  for (int i = 0; i < LOADS; i++)
    s.load[i] = F_least + (F_most - F_least) * i / (LOADS - 1);
  const int nodes_u = libmlg_uses(layout, s.k_s) == 1 ? NODES_K_S : 0;
  const int nodes_v = libmlg_uses(layout, s.b) == 1 && b_most > b_least ? NODES_B : 0;

  for (int j = 0; j <= nodes_v; j++)
    for (int i = 0; i <= nodes_u; i++)
      if (improve(&s, nodes_u ? (double)i / nodes_u : 0., nodes_v ? (double)j / nodes_v : 0.)) {
        u = nodes_u ? (double)i / nodes_u : 0.;
        v = nodes_v ? (double)j / nodes_v : 0.;
      }
  /* finer and finer grids about the best place so far, as for libmlg_best_damped */
  for (double half_u = nodes_u ? 1. / nodes_u : 0., half_v = nodes_v ? 1. / nodes_v : 0.; half_u > 1e-9 || half_v > 1e-9;) {
    const double u_0 = u, v_0 = v, before = s.best.zeta;

    for (int j = nodes_v ? -around : 0; j <= (nodes_v ? around : 0); j++)
      for (int i = nodes_u ? -around : 0; i <= (nodes_u ? around : 0); i++) {
        const double u_i = u_0 + half_u * i / around, v_j = v_0 + half_v * j / around;

        if (u_i >= 0. && u_i <= 1. && v_j >= 0. && v_j <= 1. && improve(&s, u_i, v_j)) {
          u = u_i;
          v = v_j;
        }
      }
    if (!(s.best.zeta > before + 1e-6 * fabs(before))) {
      half_u *= 0.5;
      half_v *= 0.5;
    }
  }
  *best = s.best;
  return s.best.zeta > -0.9 ? 0 : s.status != 0 ? s.status : LIBMLG_FAILED;
}

/* --- the largest load ------------------------------------------------------------------------- */

enum { FINE_NODES = 128, NODES_LOAD = 12, NODES_LARGEST_B = 15 };

struct largest {
  int layout, k_s, b;
  double par[LIBMLG_MOST_PARAMETERS], k_psi, F_most, V_least, V_top;
};

/* A load and where it is borne. */
struct borne { double F_z, u, b; struct libmlg_interval interval; };

static int bears(struct largest *s, struct borne *at)
{
  struct libmlg_interval interval;

  if (libmlg_uses(s->layout, s->k_s) == 1)
    s->par[s->k_s] = libmlg_place_k_s(s->k_psi, at->u, MLG_RIGID);
  if (libmlg_uses(s->layout, s->b) == 1)
    s->par[s->b] = at->b;
  libmlg_set(s->par, LIBMLG_F_Z, at->F_z);
  if (libmlg_intervals(s->layout, s->par, 0., s->V_least, s->V_top, &interval, 1) < 1)
    return 0;
  at->interval = interval;
  return 1;
}

/* The largest load at one k_s and b that is not below `floor`, else 0: the last of a grid up to
 * F_most that is borne, then bisection above it. */
static struct borne largest_at(struct largest *s, double u, double b, double floor)
{
  const double node = (s->F_most - floor) / NODES_LOAD;
  struct borne best = { 0., u, b, { { .c_d = 0. }, { .c_d = 0. } } }, here = best;
  double hi;

  for (int i = 0; i <= NODES_LOAD; i++) {
    here.F_z = floor + i * node;
    if (here.F_z > 0. && bears(s, &here))
      best = here;
  }
  if (!(best.F_z > 0.))
    return best;
  for (hi = fmin(best.F_z + node, s->F_most); hi - best.F_z > 1e-11 * hi;) {
    here.F_z = 0.5 * (best.F_z + hi);
    if (bears(s, &here))
      best = here;
    else
      hi = here.F_z;
  }
  return best;
}

static struct borne larger(struct borne a, struct borne b)
{
  return b.F_z > a.F_z ? b : a;
}

static struct borne over_u(struct largest *s, double u, double b, double floor)
{
  return largest_at(s, u, b, floor);
}

/* Golden section beside best, over u, or over b with `at` looking for the best u. */
static struct borne golden(struct largest *s, struct borne best, int over_b, double left, double right, double tolerance,
                           struct borne (*at)(struct largest *s, double u, double b, double floor))
{
  const double ratio = 0.6180339887498949, floor = 0.9 * best.F_z, u = best.u, b = best.b;
  double x = right - ratio * (right - left), y = left + ratio * (right - left);
  struct borne at_x = at(s, over_b ? u : x, over_b ? x : b, floor), at_y = at(s, over_b ? u : y, over_b ? y : b, floor);

  while (right - left > tolerance) {
    best = larger(best, larger(at_x, at_y));
    if (at_x.F_z > at_y.F_z || (at_x.F_z == at_y.F_z && (over_b ? best.b < y : best.u < y))) {
      right = y;
      y = x;
      at_y = at_x;
      x = right - ratio * (right - left);
      at_x = at(s, over_b ? u : x, over_b ? x : b, floor);
    } else {
      left = x;
      x = y;
      at_x = at_y;
      y = left + ratio * (right - left);
      at_y = at(s, over_b ? u : y, over_b ? y : b, floor);
    }
  }
  return best;
}

/* The best k_s at one b: of a grid, then beside its best. */
static struct borne over_k_s(struct largest *s, double ignored, double b, double floor)
{
  struct borne best = { .F_z = 0., .b = b };
  double u[PLACES_MOST];
  int nodes, top = 0;

  (void)ignored;
  if (libmlg_uses(s->layout, s->b) == 1)
    s->par[s->b] = b;
  nodes = libmlg_places(s->layout, s->par, FINE_NODES, u);
  for (int i = 0; i < nodes; i++) {
    const struct borne here = largest_at(s, u[i], b, fmax(floor, best.F_z * (1. + 1e-12)));

    if (here.F_z > best.F_z) {
      best = here;
      top = i;
    }
  }
  if (nodes > 1 && best.F_z > 0.)
    best = golden(s, best, 0, u[top > 0 ? top - 1 : 0], u[top + 1 < nodes ? top + 1 : top], 1e-11, over_u);
  return best;
}

int libmlg_largest_load(int layout, const double par[], double F_most, double b_least, double b_most, double V_least,
                        double V_top, struct libmlg_load *load)
{
  struct largest s = { .layout = layout, .k_s = libmlg_parameter("k_s"), .b = libmlg_parameter("b"), .F_most = F_most,
                       .V_least = V_least, .V_top = V_top };
  const int nodes = libmlg_uses(layout, s.b) == 1 && b_most > b_least ? NODES_LARGEST_B : 0;
  const double node = (b_most - b_least) / NODES_LARGEST_B;
  struct borne best = { .F_z = 0. };

  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  memcpy(s.par, par, (size_t)libmlg_parameters() * sizeof *par);
  s.k_psi = par[libmlg_parameter("k_psi")];
  for (int i = 0; i <= nodes; i++)
    best = larger(best, over_k_s(&s, 0., b_least + i * node, best.F_z * (1. + 1e-12)));
  if (nodes && best.F_z > 0.)
    best = golden(&s, best, 1, fmax(best.b - node, b_least), fmin(best.b + node, b_most), 1e-4 * node, over_k_s);
  *load = (struct libmlg_load){ best.F_z, INFINITY, best.b, best.interval };
  if (libmlg_uses(layout, s.k_s) == 1)
    load->k_s = libmlg_place_k_s(s.k_psi, best.u, INFINITY);
  return 0;
}
