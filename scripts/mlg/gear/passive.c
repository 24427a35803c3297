/* passive.c - the largest damping ratio of any passive device
 *
 * What a device of springs, dampers, inerters and levers can do at its two ends, and no more, is
 * to have a positive-real impedance Z(s)/s, torque over rate of twist (Brune 1931; Smith 2002).
 * A static stiffness of at least k_d is a pole at 0 of at least that residue; it may be taken
 * out, and what is left is positive real: the device is a spring K >= k_d beside any impedance
 * G(s).  G without pole at infinity, of m states, is
 *
 *   x' = (J - R) x + (B - P) u,   T = (B + P)' x + D u,   J = -J',   | R  P |
 *                                                                   | P' D | >= 0
 *
 * and every G of this kind is positive real, every positive-real one of that kind (the energy
 * x'x/2 rises by at most T u; Willems 1972).  With K/s the device has order n = m + 1.  The
 * matrix above is L L', L triangular, so that all entries are free: no constraint is left but
 * K >= k_d.  A pole at infinity, an inerter beside all, is a limit of these.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "cma.h"
#include "command.h"
#include "crossing.h"
#include "device_text.h"
#include "linearised.h"

enum { MOST_M = 4, MOST_VARIABLES = (MOST_M + 1) * (MOST_M + 2) / 2 + MOST_M * (MOST_M + 1) / 2 + 1, MOST_STARTS = 100 };

enum { MOST_SPEEDS = 128, SPEEDS = 40 };

struct passive {
  int layout, m;
  double par[LIBMLG_MOST_PARAMETERS], V_least, V_top, K;
  double softness, V[MOST_SPEEDS]; /* see below */
  int speeds;
};

static int variables(int m)
{
  return (m + 1) * (m + 2) / 2 + m * (m - 1) / 2 + m + 1;
}

/* The variables y are numbers of either sign in units of k_psi and 100 rad/s, drawn apart: y near 0
 * is of the order of 0.01, y = 5 of 1.5. */
static double number(double y)
{
  return 0.02 * sinh(y);
}

struct realisation { double A[MOST_M][MOST_M], in[MOST_M], out[MOST_M], D; };

static struct realisation realisation(int m, const double x[])
{
  double L[MOST_M + 1][MOST_M + 1] = { { 0. } }, W[MOST_M + 1][MOST_M + 1] = { { 0. } };
  struct realisation g = { .D = 0. };

  for (int i = 0; i <= m; i++)
    for (int k = 0; k <= i; k++)
      L[i][k] = number(*x++);
  for (int i = 0; i <= m; i++)
    for (int k = 0; k <= m; k++)
      for (int j = 0; j <= m; j++)
        W[i][k] += L[i][j] * L[k][j];
  for (int i = 0; i < m; i++)
    for (int k = 0; k < m; k++)
      g.A[i][k] = -W[i][k];
  for (int i = 0; i < m; i++)
    for (int k = 0; k < i; k++) {
      const double J = number(*x++);

      g.A[i][k] += J;
      g.A[k][i] -= J;
    }
  for (int i = 0; i < m; i++) {
    const double B = number(*x++);

    g.in[i] = B - W[i][m];
    g.out[i] = B + W[i][m];
  }
  g.D = W[m][m];
  return g;
}

/* out' (s - A)^-1 in = num/den by Leverrier's and Faddeev's recursion, s in units of 100 rad/s. */
static void transfer(int m, const struct realisation *g, double num[MOST_M + 1], double den[MOST_M + 1])
{
  double S[MOST_M][MOST_M] = { { 0. } }, next[MOST_M][MOST_M];

  memset(num, 0, (MOST_M + 1) * sizeof *num);
  den[m] = 1.;
  for (int i = 0; i < m; i++)
    S[i][i] = 1.;
  for (int power = m - 1; power >= 0; power--) {
    double trace = 0.;

    for (int i = 0; i < m; i++)
      for (int k = 0; k < m; k++)
        num[power] += g->out[i] * S[i][k] * g->in[k];
    for (int i = 0; i < m; i++)
      for (int k = 0; k < m; k++) {
        next[i][k] = 0.;
        for (int j = 0; j < m; j++)
          next[i][k] += g->A[i][j] * S[j][k];
      }
    for (int i = 0; i < m; i++)
      trace += next[i][i];
    den[power] = -trace / (m - power);
    for (int i = 0; i < m; i++)
      for (int k = 0; k < m; k++)
        S[i][k] = next[i][k] + (i == k ? den[power] : 0.);
  }
}

/* y[0]: K - k_d = k_psi y[0]^2.  K + s (D + out' (s - A)^-1 in), but for D, which is c_d. */
static void set_device(struct passive *p, const double x[])
{
  const double omega = 100., unit = p->par[NUMBER_K_PSI];
  const struct realisation g = realisation(p->m, x + 1);
  double num[MOST_M + 1], den[MOST_M + 1], scale = 1.;
  struct network Z = { .num = { { 0. } } };

  p->K = p->par[NUMBER_K_D] + unit * x[0] * x[0];
  transfer(p->m, &g, num, den);
  for (int i = 0; i <= p->m; i++, scale /= omega) {
    Z.den.coefficient[i] = den[i] * scale;
    Z.num.coefficient[i] += p->K * den[i] * scale;
    if (i < p->m)
      Z.num.coefficient[i + 1] += unit * num[i] * scale / omega;
  }
  device_writable(p->layout)->rational = Z;
  p->par[NUMBER_C_D] = fmax(1e-3, g.D * unit / omega);
}

/* The dynamic stiffness of the device, without k_psi, at s. */
static double _Complex stiffness_at(const struct passive *p, double _Complex s)
{
  const struct network *const r = &device_of(p->layout)->rational;

  return poly_value(&r->num, s) / poly_value(&r->den, s) + p->par[NUMBER_C_D] * s;
}

static int least(struct passive *p, const double y[], struct libmlg_ratio *ratio)
{
  set_device(p, y);
  return libmlg_least_ratio(p->layout, p->par, p->V_least, p->V_top, ratio);
}

/* --- the value to climb, and its slopes ---------------------------------------------------------------
 * The least of all ratios at many speeds, softened: -softness log(sum exp(-zeta/softness)), smooth and
 * below the least by the softness a few times.  Softness falls in steps, and at each the speed at which
 * the least ratio of all is, exactly, joins the others.
 *
 * A mode s is a root of F = whole + Z minor, Z of the device with k_psi (linearised.h), so that
 * ds = -minor dZ / F_s. */

struct gear_at { double _Complex whole, minor; };

static struct gear_at gear_at(const struct gear_matrix *g, double _Complex s)
{
  const double _Complex A11 = poly_value(&g->A11, s), A12 = poly_value(&g->A12, s), A22 = poly_value(&g->A22, s);
  const double _Complex Ls = poly_value(&g->Ls, s), q = poly_value(&g->p, s), tyre = poly_value(&g->tyre, s);

  return (struct gear_at){
    A11 * (A22 * tyre + q * g->D2) - A12 * (A12 * tyre + Ls * g->D2) + g->D1 * (A22 * Ls - A12 * q),
    A11 * tyre + g->D1 * Ls,
  };
}

static double _Complex behind_k_psi(const struct passive *p, double _Complex s)
{
  return 1. / (1. / p->par[NUMBER_K_PSI] + 1. / stiffness_at(p, s));
}

/* A mode that counts: d zeta = Re(by_Z dZ). */
struct counting { double _Complex s, by_Z; double weight; };

enum { MOST_COUNTING = 400 };

static struct counting counting(const struct passive *p, const struct gear_matrix *g, double _Complex s, double weight)
{
  const double step = 1e-5 * cabs(s), size = cabs(s);
  const struct gear_at here = gear_at(g, s), ahead = gear_at(g, s + step), back = gear_at(g, s - step);
  const double _Complex F_s = (ahead.whole + behind_k_psi(p, s + step) * ahead.minor - back.whole
                               - behind_k_psi(p, s - step) * back.minor) / (2. * step);
  /* zeta = -Re(s)/|s| */
  const double _Complex by_s = -1. / size + creal(s) * conj(s) / (size * size * size);

  return (struct counting){ s, -by_s * here.minor / F_s, weight };
}

/* The softened least ratio at y, -1 where there is none, and its slopes by y unless NULL. */
static double value_and_slopes(struct passive *p, double y[], int n, double slope[])
{
  const double h = 1e-6;
  double least = HUGE_VAL, sum = 0., slots[MLG_SLOTS];
  static struct { double _Complex s; double zeta, V; } mode[MOST_SPEEDS * CROSSING_TERMS];
  static struct counting count[MOST_COUNTING];
  int modes = 0, counts = 0;

  for (int i = 0; i < n; i++) /* far beyond any device */
    if (!(fabs(y[i]) < 16.))
      return -1.;
  set_device(p, y);
  libmlg_slots(p->par, slots);
  const struct crossing x = crossing_of(libmlg_find(p->layout), slots, 0.);

  for (int k = 0; k < p->speeds; k++) {
    double re[CROSSING_TERMS], im[CROSSING_TERMS];
    const int roots = crossing_roots(&x, p->V[k] / x.V_unit, p->par[NUMBER_C_D] / x.c_unit, re, im);

    if (roots < 0)
      return -1.;
    for (int i = 0; i < roots; i++)
      if (im[i] > 0. || (!(im[i] < 0.) && re[i] > 0.)) {
        const double zeta = im[i] > 0. ? -re[i] / hypot(re[i], im[i]) : -1.;

        mode[modes].s = x.omega_unit * (re[i] + I * im[i]);
        mode[modes].V = p->V[k];
        mode[modes++].zeta = zeta;
        least = fmin(least, zeta);
      }
  }
  if (!(least > -1.))
    return -1.;
  for (int i = 0; i < modes; i++)
    sum += exp((least - mode[i].zeta) / p->softness);
  if (!slope)
    return least - p->softness * log(sum);
  for (int i = 0; i < modes && counts < MOST_COUNTING; i++) {
    const double weight = exp((least - mode[i].zeta) / p->softness) / sum;

    if (weight > 1e-7) {
      const struct gear_matrix g = gear_matrix(slots, mode[i].V);

      count[counts++] = counting(p, &g, mode[i].s, weight);
    }
  }
  for (int i = 0; i < n; i++) {
    const double at = y[i];

    slope[i] = 0.;
    for (int k = -1; k <= 1; k += 2) {
      y[i] = at + k * h;
      set_device(p, y);
      for (int c = 0; c < counts; c++)
        slope[i] += k * count[c].weight * creal(count[c].by_Z * behind_k_psi(p, count[c].s)) / (2. * h);
    }
    y[i] = at;
  }
  return least - p->softness * log(sum);
}

/* --- search: the BFGS method with a weak line search, and repeated starts -------------------------------- */

enum { N = MOST_VARIABLES, LINE_STEPS = 40 };

static double product(int n, const double a[], const double b[])
{
  double sum = 0.;

  for (int i = 0; i < n; i++)
    sum += a[i] * b[i];
  return sum;
}

/* Armijo's and Wolfe's conditions, by doubling and bisection (Lewis and Overton, Math. Program. 141
 * (2013) 135-163, Algorithm 2.6); 1: a better place was found. */
static int line_search(struct passive *p, int n, double y[], double *value, double slope[], const double direction[], int *asked)
{
  const double rise = product(n, slope, direction);
  double lo = 0., hi = INFINITY, t = 1., from[N], best[N], best_value = *value, best_slope[N];

  memcpy(from, y, sizeof from);
  memcpy(best_slope, slope, sizeof best_slope);
  memcpy(best, y, sizeof best);
  for (int i = 0; i < LINE_STEPS; i++) {
    double here[N], s[N] = { 0. }, v;

    for (int k = 0; k < n; k++)
      here[k] = from[k] + t * direction[k];
    v = value_and_slopes(p, here, n, s);
    ++*asked;
    if (v > best_value) {
      best_value = v;
      memcpy(best, here, sizeof best);
      memcpy(best_slope, s, sizeof best_slope);
    }
    if (!(v > *value + 1e-4 * t * rise))
      hi = t;
    else if (product(n, s, direction) > 0.9 * rise)
      lo = t;
    else
      break;
    t = hi < INFINITY ? 0.5 * (lo + hi) : 2. * t;
  }
  const int better = best_value > *value;

  memcpy(y, best, sizeof best);
  memcpy(slope, best_slope, sizeof best_slope);
  *value = best_value;
  return better;
}

/* Uphill from y at one softness; returns the value reached. */
static double climb_softened(struct passive *p, int n, double y[], int most, int *asked)
{
  double H[N * N], slope[N] = { 0. }, value = value_and_slopes(p, y, n, slope);

  for (int again = 0; again < 2; again++) { /* with fresh H where it got stuck */
    const double before = value;

    for (int i = 0; i < n * n; i++)
      H[i] = i % (n + 1) == 0 ? 1. / fmax(1e-12, sqrt(product(n, slope, slope))) : 0.;
    for (int step = 0; step < most; step++) {
      double direction[N], old_y[N], old_slope[N], s[N], g[N], Hg[N];

      for (int i = 0; i < n; i++)
        direction[i] = product(n, H + i * n, slope);
      if (!(product(n, direction, slope) > 0.))
        break;
      memcpy(old_y, y, sizeof old_y);
      memcpy(old_slope, slope, sizeof old_slope);
      if (!line_search(p, n, y, &value, slope, direction, asked))
        break;
      for (int i = 0; i < n; i++) {
        s[i] = y[i] - old_y[i];
        g[i] = old_slope[i] - slope[i];
      }
      const double sg = product(n, s, g);

      if (!(sg > 1e-300))
        continue;
      for (int i = 0; i < n; i++)
        Hg[i] = product(n, H + i * n, g);
      const double gHg = product(n, g, Hg);

      for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
          H[i * n + k] += (1. + gHg / sg) * s[i] * s[k] / sg - (Hg[i] * s[k] + s[i] * Hg[k]) / sg;
    }
    if (!(value > before + 1e-7 * fabs(before)))
      break;
  }
  return value;
}

/* Harder and harder; returns the least ratio reached, exactly. */
static double climb(struct passive *p, int n, double y[], int most, int *asked)
{
  double best = -INFINITY, best_y[N];
  struct libmlg_ratio ratio;

  p->speeds = 0;
  for (int i = 0; i < SPEEDS; i++)
    p->V[p->speeds++] = p->V_least * pow(p->V_top / p->V_least, (double)i / (SPEEDS - 1));
  for (p->softness = 3e-3; p->softness > 5e-8; p->softness *= 0.25) {
    climb_softened(p, n, y, most, asked);
    if (least(p, y, &ratio) != 0)
      break;
    if (p->speeds < MOST_SPEEDS)
      p->V[p->speeds++] = ratio.V;
    if (ratio.zeta > best) {
      best = ratio.zeta;
      memcpy(best_y, y, sizeof best_y);
    }
  }
  if (best > -INFINITY)
    memcpy(y, best_y, sizeof best_y);
  return best;
}

/* The same device with one state more, which does next to nothing. */
static void with_one_more(int m, const double x[], double y[], struct cma_random *random)
{
  int from = 1, to = 1;

  y[0] = x[0];
  for (int i = 0; i <= m + 1; i++)
    for (int k = 0; k <= i; k++) {
      const int row = i > m ? m : i, column = k > m ? m : k;

      /* the new state m, with R of its own; D's row moves down by one */
      y[to++] = i == m || k == m ? (i == k ? 4. : 0.2) * cma_normal(random) : x[from + row * (row + 1) / 2 + column];
    }
  from += (m + 1) * (m + 2) / 2;
  for (int i = 0; i <= m; i++)
    for (int k = 0; k < i; k++)
      y[to++] = i == m ? 2. * cma_normal(random) : x[from + i * (i - 1) / 2 + k];
  from += m * (m - 1) / 2;
  for (int i = 0; i <= m; i++)
    y[to++] = i == m ? 0.5 * cma_normal(random) : x[from + i];
}

struct best { double zeta, x[MOST_VARIABLES]; int met, starts, asked; };

/* The least ratio at a place of cma.h's box, exactly. */
static double exact_zeta(const double place[], void *context)
{
  struct passive *const p = context;
  double y[MOST_VARIABLES];
  struct libmlg_ratio ratio;

  for (int i = 0; i < variables(p->m); i++)
    y[i] = 32. * place[i] - 16.;
  return least(p, y, &ratio) == 0 ? ratio.zeta : -INFINITY;
}

/* The best once more, by the evolution strategy, which needs no softening. */
static void polish(struct passive *p, int n, struct best *best)
{
  for (int round = 0; round < 4; round++) {
    struct cma_random random = { 31ULL * (unsigned)round + 7ULL };
    double place[MOST_VARIABLES], zeta;

    for (int i = 0; i < n; i++)
      place[i] = (best->x[i] + 16.) / 32.;
    best->asked += cma_largest(exact_zeta, p, n, place, (double[]){ 0.02, 3e-3, 3e-4, 3e-5 }[round], &random, 150 * n, INFINITY, &zeta);
    if (zeta > best->zeta) {
      best->zeta = zeta;
      for (int i = 0; i < n; i++)
        best->x[i] = 32. * place[i] - 16.;
    }
  }
}

/* From the best of one order less, from random places, and from the best so far, changed in part:
 * there are many local maxima. */
static void search(struct passive *p, int starts, const double before[], struct best *best)
{
  const int n = variables(p->m);
  double result[MOST_STARTS];

  *best = (struct best){ .zeta = -INFINITY, .starts = starts };
  for (int start = 0; start < starts; start++) {
    struct cma_random random = { 104729ULL * (unsigned)start + 17ULL * (unsigned)p->m + 1ULL };
    double y[MOST_VARIABLES] = { 0. };
    struct libmlg_ratio drawn;

    for (int draw = 0; draw < 100; draw++) {
      if (start > 3 && start % 2) /* the best so far with some of its variables drawn anew */
        for (int i = 0; i < n; i++)
          y[i] = cma_uniform(&random) < 0.35 ? 11. * cma_uniform(&random) - 5.5 : best->x[i];
      else if (before && start % 4 == 0)
        with_one_more(p->m - 1, before, y, &random);
      else
        for (int i = 0; i < n; i++)
          y[i] = i == 0 ? 0.3 * cma_normal(&random) : 11. * cma_uniform(&random) - 5.5;
      if (least(p, y, &drawn) == 0 && drawn.zeta > -0.5)
        break;
    }
    result[start] = climb(p, n, y, 60 + 10 * n, &best->asked);
    if (result[start] > best->zeta) {
      best->zeta = result[start];
      memcpy(best->x, y, sizeof y);
    }
  }
  polish(p, n, best);
  for (int start = 0; start < starts; start++)
    best->met += result[start] >= best->zeta - 0.01 * fabs(best->zeta);
}

static void print_row(struct passive *p, const struct best *best)
{
  struct libmlg_ratio ratio;
  struct libmlg_mode mode;

  if (least(p, best->x, &ratio) != 0)
    fail("passive", MLG_FAILED, "no eigenvalues");
  p->par[NUMBER_V] = ratio.V;
  if (libmlg_least_damped(p->layout, p->par, &mode) != 0)
    fail("passive", MLG_FAILED, "no eigenvalues");
  const struct device_text *const d = device_of(p->layout);
  const double _Complex Z = stiffness_at(p, I * 2. * MLG_PI * 17.5);

  printf("%d,%.8g,%.8g,%.8g,%s,%.8g,%.8g,%.8g,%d,%d,%d,", p->m + 1, best->zeta, ratio.V, mode.frequency_hz,
         mode.delta_over_psi > 1. ? "delta" : "psi", p->K, creal(Z), cimag(Z), best->met, best->starts, best->asked);
  for (int of_den = 0; of_den < 2; of_den++)
    for (int i = 0; i <= p->m + 1; i++) {
      const struct network *const r = &d->rational;
      const double beside = i > 0 ? p->par[NUMBER_C_D] * r->den.coefficient[i - 1] : 0.;

      printf("%s%.15g", i == 0 ? of_den ? "," : "" : " ", of_den ? r->den.coefficient[i] : r->num.coefficient[i] + beside);
    }
  putchar('\n');
  fflush(stdout);
}

static int run(int argc, char *argv[])
{
  enum { ORDER, STARTS, V_LEAST };
  struct option option[] = {
    [ORDER] = { "order", "-", 1., MOST_M + 1., MOST_M + 1., NULL },
    [STARTS] = { "starts", "-", 1., MOST_STARTS, 20., NULL },
    [V_LEAST] = { "V_least", "m/s", 0., 1e3, 0.3, NULL },
    { .name = NULL },
  };
  char *words[64] = { argv[0], (char *)"k_d|c_d" };
  struct passive p = { .layout = 0 };
  struct arguments a;
  struct best best;
  double before[MOST_VARIABLES];

  if (argc > 62)
    fail(argv[0], MLG_BAD_INPUT, "too many words");
  memcpy(words + 2, argv + 1, (size_t)(argc - 1) * sizeof *argv);
  read_arguments(&a, argc + 1, words, option);
  refuse_given(&a, NUMBER_V, "the search is over all speeds");
  refuse_given(&a, NUMBER_C_D, "the search is over all devices");
  if (!(option[V_LEAST].value < a.V_top))
    fail(argv[0], MLG_BAD_INPUT, "V_least = %g m/s is not below V_top = %g m/s", option[V_LEAST].value, a.V_top);
  memcpy(p.par, a.par, sizeof p.par);
  p.V_least = option[V_LEAST].value;
  p.V_top = a.V_top;
  printf("# V m/s, K N m/rad, Z_re, Z_im N m/rad at 17.5 Hz; num, den of Z, powers of s rising, SI\n"
         "order,zeta,V,frequency_hz,shimmy,K,Z_re,Z_im,met,starts,asked,num,den\n");
  for (p.m = 0; p.m < (int)option[ORDER].value; p.m++) {
    p.layout = device_rational(p.m);
    if (p.layout == LIBMLG_NONE)
      fail(argv[0], MLG_FAILED, "out of memory");
    search(&p, (int)option[STARTS].value, p.m > 0 ? before : NULL, &best);
    print_row(&p, &best);
    memcpy(before, best.x, sizeof before);
  }
  return output_status(argv[0]);
}

const struct command command_passive = {
  .name = "passive",
  .usage = "[NAME=VALUE ...] [order=5] [starts=20] [V_least=0.3]",
  .summary = "the largest damping ratio of any passive device",
  .details =
    "Of all devices behind k_psi that give no energy and have a static stiffness of at least k_d,\n"
    "of order 1, 2, ... to `order`: every positive-real impedance of that order, as a spring beside\n"
    "a port-Hamiltonian system, by the BFGS method (scripts/mlg/gear/passive.c).\n"
    "CSV, a row for each order, printed as it is found:\n"
    "  zeta          the least damping ratio over V_least < V < V_top, at its largest\n"
    "  V, frequency_hz, shimmy  of the mode that has it\n"
    "  K             static stiffness of the device, without k_psi\n"
    "  Z_re, Z_im    its dynamic stiffness at 17.5 Hz, where the delta mode is\n"
    "  met, starts   how many of the starts came within 1 % of the best\n"
    "  asked         how many devices were looked at\n"
    "  num, den      of Z, with blanks between the coefficients\n",
  .run = run,
};
