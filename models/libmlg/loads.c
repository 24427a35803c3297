/* loads.c - the design that is best damped over a range of loads, and the largest load with
 * any zero-shimmy design
 */
#include <float.h>
#include <math.h>
#include <string.h>

#include "layout.h"

enum { NODES_K_S = 64, NODES_B = 32, MOST = LIBMLG_MOST_POINTS, LOADS = 7, NODES = 15 };

static const double golden_ratio = 0.6180339887498949;

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
    s->par[s->k_s] = u > 0. ? s->k_psi * (1. / fmin(u, 1. - 1e-6) - 1.) : MLG_RIGID;
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

/* Whether some k_s has an interval at this load and b; which. */
static int bears(int layout, double par[], double F_z, double b, double V_least, double V_top, struct libmlg_widest *w)
{
  struct libmlg_widest here;

  libmlg_set(par, LIBMLG_F_Z, F_z);
  par[libmlg_parameter("b")] = b;
  if (libmlg_widest(layout, par, 0., V_least, V_top, &here) != 0 || !(here.width > 0.))
    return 0;
  *w = here;
  return 1;
}

/* The largest load at one b that is above `floor`, or 0: a grid up to F_most, then bisection
 * above its last load with an interval. */
static double largest_at_b(int layout, double par[], double floor, double F_most, double b, double V_least, double V_top,
                           struct libmlg_widest *w)
{
  double lo = 0., hi;

  if (floor > 0. && !bears(layout, par, floor * (1. + 1e-9), b, V_least, V_top, w))
    return 0.;
  for (int i = 0; i <= 40; i++) {
    const double F_z = floor + (F_most - floor) * i / 40.;

    if (i == 0 ? floor > 0. : bears(layout, par, F_z, b, V_least, V_top, w))
      lo = F_z;
  }
  if (!(lo > 0.) || lo >= F_most)
    return lo;
  for (hi = lo + (F_most - floor) / 40.; hi - lo > 1e-8 * hi;) {
    const double middle = 0.5 * (lo + hi);

    if (bears(layout, par, middle, b, V_least, V_top, w))
      lo = middle;
    else
      hi = middle;
  }
  return lo;
}

int libmlg_largest_load(int layout, const double par[], double F_most, double b_least, double b_most, double V_least,
                        double V_top, struct libmlg_load *load)
{
  const int over_b = libmlg_uses(layout, libmlg_parameter("b")) == 1 && b_most > b_least;
  const double node = (b_most - b_least) / NODES;
  double p[LIBMLG_MOST_PARAMETERS];
  struct libmlg_widest w;

  if (!libmlg_find(layout))
    return LIBMLG_NONE;
  memcpy(p, par, (size_t)libmlg_parameters() * sizeof *par);
  *load = (struct libmlg_load){ .F_z = 0., .b = b_least };
  for (int i = 0; i <= (over_b ? NODES : 0); i++) {
    const double b = b_least + i * node, F_z = largest_at_b(layout, p, load->F_z, F_most, b, V_least, V_top, &w);

    if (F_z > load->F_z)
      *load = (struct libmlg_load){ F_z, w.k_s, b, w.interval };
  }
  if (!over_b || !(load->F_z > 0.))
    return 0;
  double left = fmax(load->b - node, b_least), right = fmin(load->b + node, b_most);
  double x = right - golden_ratio * (right - left), y = left + golden_ratio * (right - left);
  struct libmlg_widest at_x, at_y;
  double F_x = largest_at_b(layout, p, 0., F_most, x, V_least, V_top, &at_x);
  double F_y = largest_at_b(layout, p, 0., F_most, y, V_least, V_top, &at_y);

  while (right - left > 1e-4 * node) {
    if (F_x > load->F_z)
      *load = (struct libmlg_load){ F_x, at_x.k_s, x, at_x.interval };
    if (F_y > load->F_z)
      *load = (struct libmlg_load){ F_y, at_y.k_s, y, at_y.interval };
    if (F_x > F_y) {
      right = y;
      y = x;
      F_y = F_x;
      at_y = at_x;
      x = right - golden_ratio * (right - left);
      F_x = largest_at_b(layout, p, 0., F_most, x, V_least, V_top, &at_x);
    } else {
      left = x;
      x = y;
      F_x = F_y;
      at_x = at_y;
      y = left + golden_ratio * (right - left);
      F_y = largest_at_b(layout, p, 0., F_most, y, V_least, V_top, &at_y);
    }
  }
  return 0;
}
