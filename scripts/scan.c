/* scan - the boundary of the zero-shimmy region without continuation
 *
 *   scan-LAYOUT points    [NAME=VALUE ...]  boundary points at one k_s and b
 *   scan-LAYOUT intervals [NAME=VALUE ...]  zero-shimmy intervals of c_d there
 *   scan-LAYOUT widest    [NAME=VALUE ...]  the widest of them over k_s
 *   scan-LAYOUT regions   [NAME=VALUE ...]  all intervals over k_s, from AUTO's
 *                         curves of boundary points on standard input
 *   scan-LAYOUT check C_LO C_HI [NAME=VALUE ...]  status 0 if that is an interval
 *                         and cannot be made longer, else 1
 *
 * NAME: a parameter of models/mlg.h, or compliance (1e5/k_s; 0 is rigid), but not V
 * and c_d, over which it looks.
 * At fixed frequency omega every Hopf point (V, c_d) is the root of a quadratic
 * (models/characteristic.h).  The frequencies are swept; where c_d has an
 * extremum along the curve of these points, that is a boundary point, refined
 * to rounding.  A closed curve between two frequencies shows as a maximum of the
 * quadratic's discriminant.  AUTO's runs start from these points, and the
 * intervals check what AUTO found.
 *
 * points prints CSV: c_d N m s/rad, V m/s, frequency_hz, extremum (min, max,
 * or edge: the curve leaves through V = 200), shimmy (psi, delta).
 * intervals prints CSV: c_lo, c_hi, V_lo, V_hi, width; widest first.
 * Bad input: one line, status 2.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MLG_NO_AUTO
#include LAYOUT
#include "characteristic.h"
#include "arguments.h"

static const double V_top = MLG_V_TOP;
static const double c_least = 10., c_most = 1e6; /* range of c_d looked at, N m s/rad */
static const double f_least = 0.5, f_most = 40., f_step = 0.002; /* Hz; delta islands are 10 mHz wide */

enum extremum { MIN, MAX, EDGE };
static const char *const extremum_name[] = { "min", "max", "edge" };

struct point { double omega, V, c; enum extremum extremum; };

struct points { struct point *point; int n, room; };

static int inside(double V, double c)
{
  return V > 0. && V < V_top && c > c_least && c < c_most;
}

/* Zero at an extremum of c_d along the curve. */
static double slope(const struct characteristic *f, double omega, double V, double c)
{
  const struct jet j = jet(f, omega * I, V, c);

  return extremum_sine(&j, I, j.F_V);
}

static void add(struct points *list, struct point p)
{
  if (list->n == list->room) {
    list->room = list->room ? 2 * list->room : 64;
    list->point = realloc(list->point, (size_t)list->room * sizeof *list->point);
    if (!list->point) {
      fprintf(stderr, "scan: out of memory\n");
      exit(1);
    }
  }
  list->point[list->n++] = p;
}

/* Newton on F = 0, slope = 0 from a point nearby; 0 when it goes elsewhere. */
static int refine(const struct characteristic *f, struct point *p)
{
  double x[3] = { p->omega, p->V, p->c };

  for (int iteration = 0; iteration < 30; iteration++) {
    double r[4][3], A[3][4], largest = 0.;

    for (int k = 0; k < 4; k++) { /* residuals at x, and at x with one component moved */
      double y[3] = { x[0], x[1], x[2] };
      struct jet j;
      double _Complex e;

      if (k > 0)
        y[k - 1] *= 1. + 1e-7;
      j = jet(f, y[0] * I, y[1], y[2]);
      e = j.F / j.F_s;
      r[k][0] = creal(e);
      r[k][1] = cimag(e);
      r[k][2] = extremum_sine(&j, I, j.F_V);
    }
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++)
        A[i][k] = (r[k + 1][i] - r[0][i]) / 1e-7; /* per relative change */
      A[i][3] = -r[0][i];
    }
    for (int k = 0; k < 3; k++) { /* Gauss-Jordan with pivoting */
      int best = k;

      for (int i = k + 1; i < 3; i++)
        if (fabs(A[i][k]) > fabs(A[best][k]))
          best = i;
      for (int i = 0; i < 4; i++) {
        const double t = A[k][i];
        A[k][i] = A[best][i];
        A[best][i] = t;
      }
      if (A[k][k] == 0.)
        return 0;
      for (int i = 0; i < 3; i++)
        if (i != k) {
          const double factor = A[i][k] / A[k][k];
          for (int m = k; m < 4; m++)
            A[i][m] -= factor * A[k][m];
        }
    }
    for (int k = 0; k < 3; k++) {
      double step = A[k][3] / A[k][k];

      largest = fmax(largest, fabs(step));
      step = fmax(-0.2, fmin(0.2, step));
      x[k] *= 1. + step;
    }
    if (!(largest < 1e30))
      return 0;
    /* beside a fold rounding keeps the steps above 1e-11 */
    if (largest < 1e-11 || (iteration >= 12 && largest < 1e-7)) {
      if (fabs(x[0] / p->omega - 1.) > 0.02)
        return 0;
      *p = (struct point){ x[0], x[1], x[2], p->extremum };
      return 1;
    }
  }
  return 0;
}

static void add_refined(struct points *list, const struct characteristic *f, struct point p)
{
  if (!refine(f, &p) || !inside(p.V, p.c))
    return;
  p.extremum = curvature(f, I, p.omega, p.V, p.c) > 0. ? MIN : MAX;
  for (int i = 0; i < list->n; i++)
    if (fabs(list->point[i].c / p.c - 1.) < 1e-8 && fabs(list->point[i].omega / p.omega - 1.) < 1e-8)
      return;
  add(list, p);
}

static int by_c(const void *a, const void *b)
{
  const double x = ((const struct point *)a)->c, y = ((const struct point *)b)->c;

  return (x > y) - (x < y);
}

/* Where the discriminant vanishes between a frequency where it is positive and
 * one where it is not. */
static double discriminant_zero(const struct characteristic *f, double positive, double negative)
{
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (positive + negative);

    if (hopf_pair(f, middle).D > 0.)
      positive = middle;
    else
      negative = middle;
  }
  return positive;
}

/* The extrema of c_d on a closed Hopf curve, once round: up with one root from the
 * least to the largest frequency, back with the other. */
static void add_around(struct points *list, const struct characteristic *f, double least, double largest)
{
  enum { ROUND = 400 };
  struct point last = { 0., 0., 0., MIN };
  double g_last = 0.;

  for (int i = 0; i <= ROUND; i++) {
    const double angle = 2. * MLG_PI * i / ROUND;
    const double omega = 0.5 * (least + largest) - 0.5 * (largest - least) * cos(angle);
    const struct hopf_pair p = hopf_pair(f, omega);
    const int k = angle > MLG_PI;
    const double g = slope(f, omega, p.V[k], p.c[k]);

    if (i > 0 && g * g_last < 0.)
      add_refined(list, f, (struct point){ 0.5 * (omega + last.omega), 0.5 * (p.V[k] + last.V),
                                           0.5 * (p.c[k] + last.c), MIN });
    last = (struct point){ omega, p.V[k], p.c[k], MIN };
    g_last = g;
  }
}

/* A closed Hopf curve that lies between two frequencies of the sweep: Hopf points
 * only where the discriminant has a maximum above 0, between left and right. */
static void add_island(struct points *list, const struct characteristic *f, double left, double right)
{
  const double golden = 0.6180339887498949, from = left, to = right;
  double top, a = right - golden * (right - left), b = left + golden * (right - left);
  double D_a = hopf_pair(f, a).D, D_b = hopf_pair(f, b).D;

  for (int i = 0; i < 70 && right - left > 1e-15 * right; i++)
    if (D_a > D_b) {
      right = b;
      b = a;
      D_b = D_a;
      a = right - golden * (right - left);
      D_a = hopf_pair(f, a).D;
    } else {
      left = a;
      a = b;
      D_a = D_b;
      b = left + golden * (right - left);
      D_b = hopf_pair(f, b).D;
    }
  top = 0.5 * (left + right);
  if (hopf_pair(f, top).D > 0.)
    add_around(list, f, discriminant_zero(f, top, from), discriminant_zero(f, top, to));
}

/* All boundary points, by rising c_d. */
static struct points boundary_points(const struct characteristic *f)
{
  struct points list = { NULL, 0, 0 };
  struct hopf_pair last = { .D = -1. }, before = { .D = -1. };
  const double step = 2. * MLG_PI * f_step;
  double last_omega = 0.;
  int samples = 0; /* with Hopf points, since the last one without */

  for (double frequency = f_least; frequency <= f_most; frequency += f_step) {
    const double omega = 2. * MLG_PI * frequency;
    const struct hopf_pair now = hopf_pair(f, omega);

    for (int k = 0; k < 2; k++) {
      if (now.D >= 0. && last.D >= 0. && (inside(now.V[k], now.c[k]) || inside(last.V[k], last.c[k]))) {
        const double g0 = slope(f, last_omega, last.V[k], last.c[k]);
        const double g1 = slope(f, omega, now.V[k], now.c[k]);
        const double t = g0 / (g0 - g1);

        if (g0 * g1 < 0. && fabs(now.c[k] - last.c[k]) < 0.5 * fabs(now.c[k] + last.c[k]))
          add_refined(&list, f, (struct point){ last_omega + t * (omega - last_omega),
                                                last.V[k] + t * (now.V[k] - last.V[k]),
                                                last.c[k] + t * (now.c[k] - last.c[k]), MIN });
        if ((last.V[k] - V_top) * (now.V[k] - V_top) < 0. && now.c[k] > c_least && now.c[k] < c_most
            && fabs(now.V[k] - last.V[k]) < 10.)
          add(&list, (struct point){ omega, V_top, now.c[k], EDGE });
      }
    }
    /* the curve turns back in omega between the two samples */
    if ((now.D >= 0.) != (last.D >= 0.)) {
      const struct hopf_pair *r = now.D >= 0. ? &now : &last;
      const double w = now.D >= 0. ? omega : last_omega;

      if (inside(r->V[0], r->c[0]) && inside(r->V[1], r->c[1])
          && slope(f, w, r->V[0], r->c[0]) * slope(f, w, r->V[1], r->c[1]) < 0.)
        add_refined(&list, f, (struct point){ w, 0.5 * (r->V[0] + r->V[1]), 0.5 * (r->c[0] + r->c[1]), MIN });
    }
    /* closed curves of a few samples or none */
    if (now.D >= 0.)
      samples = last.D >= 0. ? samples + 1 : 1;
    else if (last.D >= 0. && samples < 50)
      add_around(&list, f, discriminant_zero(f, last_omega, last_omega - samples * step),
                 discriminant_zero(f, last_omega, omega));
    else if (before.D < last.D && last.D < 0. && last.D >= now.D)
      add_island(&list, f, last_omega - step, omega);
    before = last;
    last = now;
    last_omega = omega;
  }
  if (list.n > 1)
    qsort(list.point, (size_t)list.n, sizeof *list.point, by_c);
  return list;
}

/* Routh's test of F at one (V, c_d). */
static int is_stable(const struct characteristic *f, double V, double c)
{
  double row[2][POLY_TERMS] = { { 0. } };
  int degree;
  const struct poly p = characteristic_polynomial(f, V, c, &degree);

  for (int i = 0; i <= degree; i++)
    row[i % 2][i / 2] = p.coefficient[degree - i];
  for (int k = 0; k < degree; k++) {
    double *upper = row[k % 2], *lower = row[(k + 1) % 2];

    const double factor = upper[0] / lower[0];

    if (!(factor > 0.))
      return 0;
    for (int i = 0; i + 1 < POLY_TERMS; i++)
      upper[i] = upper[i + 1] - factor * lower[i + 1];
  }
  return 1;
}

/* No shimmy at this c_d: stable at so many speeds of the operating range. */
static int is_zero_shimmy(const struct characteristic *f, double c, int speeds)
{
  const double V_first = 0.05;

  for (int i = 0; i <= speeds; i++)
    if (!is_stable(f, V_first + i * (V_top - V_first) / speeds, c))
      return 0;
  return 1;
}

/* A zero-shimmy interval of c_d, and the speeds of its two bounds; hi = 0: none. */
struct interval { double lo, hi, V_lo, V_hi; };

/* The interval above point i of a list sorted by c_d, if it is a zero-shimmy
 * one; i = -1 is the lower end of the range. */
static struct interval interval_above(const struct characteristic *f, const struct points *list,
                                      int i)
{
  const struct interval none = { 0., 0., 0., 0. };
  const double lo = i < 0 ? c_least : list->point[i].c, V_lo = i < 0 ? 0. : list->point[i].V;
  const int last = i + 1 == list->n;
  const double hi = last ? c_most : list->point[i + 1].c, V_hi = last ? 0. : list->point[i + 1].V;
  /* where in the interval, by logarithm; more than the middle, lest a region that
   * the list lacks lies inside */
  static const double place[] = { 0.5, 0.02, 0.25, 0.75, 0.98 };

  /* above a least c_d and below a largest one there is shimmy */
  if (!(hi > lo * (1. + 1e-9)) || (i >= 0 && list->point[i].extremum == MIN)
      || (!last && list->point[i + 1].extremum == MAX))
    return none;
  for (size_t k = 0; k < sizeof place / sizeof *place; k++)
    if (!is_zero_shimmy(f, lo * pow(hi / lo, place[k]), 200))
      return none;
  return (struct interval){ lo, hi, V_lo, V_hi };
}

static void print_points(const double par[])
{
  const struct characteristic f = characteristic(par);
  const struct points list = boundary_points(&f);

  printf("c_d,V,frequency_hz,extremum,shimmy\n");
  for (int i = 0; i < list.n; i++) {
    const struct point *p = &list.point[i];

    printf("%.10g,%.10g,%.10g,%s,%s\n", p->c, p->V, p->omega / (2. * MLG_PI),
           extremum_name[p->extremum],
           delta_over_psi(par, p->V, p->omega * I) > 1. ? "delta" : "psi");
  }
  free(list.point);
}

static void print_intervals(const double par[])
{
  const struct characteristic f = characteristic(par);
  const struct points list = boundary_points(&f);

  printf("c_lo,c_hi,V_lo,V_hi,width\n");
  for (int i = -1; i < list.n; i++) {
    const struct interval z = interval_above(&f, &list, i);

    if (z.hi > 0.)
      printf("%.10g,%.10g,%.10g,%.10g,%.10g\n", z.lo, z.hi, z.V_lo, z.V_hi, z.hi - z.lo);
  }
  free(list.point);
}

/* The widest interval at one compliance. */
static struct interval widest_at(double par[], double compliance)
{
  struct characteristic f;
  struct points list;
  struct interval widest = { 0., 0., 0., 0. };

  par[PAR_K_S] = 1e5 / compliance;
  f = characteristic(par);
  list = boundary_points(&f);
  for (int i = -1; i < list.n; i++) {
    const struct interval z = interval_above(&f, &list, i);

    if (z.hi - z.lo > widest.hi - widest.lo)
      widest = z;
  }
  free(list.point);
  return widest;
}

/* The widest interval over k_s at one b: a grid, then golden section about its
 * best node.  The width has a kink or a jump where another mechanism takes over. */
static void print_widest(double par[])
{
  const double golden = 0.6180339887498949, step = 0.0025;
  double best = 0., left, right;
  struct interval widest = { 0., 0., 0., 0. };

  for (double compliance = 0.; compliance < 0.35; compliance += step) {
    const struct interval w = widest_at(par, compliance);

    if (w.hi - w.lo > widest.hi - widest.lo) {
      widest = w;
      best = compliance;
    }
  }
  left = fmax(0., best - step);
  right = best + step;
  for (int i = 0; i < 40; i++) {
    const double at[2] = { right - golden * (right - left), left + golden * (right - left) };
    const struct interval w[2] = { widest_at(par, at[0]), widest_at(par, at[1]) };

    for (int k = 0; k < 2; k++)
      if (w[k].hi - w[k].lo > widest.hi - widest.lo) {
        widest = w[k];
        best = at[k];
      }
    if (w[0].hi - w[0].lo > w[1].hi - w[1].lo)
      right = at[1];
    else
      left = at[0];
  }
  printf("compliance,k_s,c_lo,c_hi,V_lo,V_hi,width\n%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n",
         best, 1e5 / best, widest.lo, widest.hi, widest.V_lo, widest.V_hi, widest.hi - widest.lo);
}

/* One row of AUTO's boundary-point curves. */
struct row { int curve; double compliance; struct point point; };

/* Rows "curve,compliance,c_d,V,frequency_hz" from standard input. */
static struct row *read_rows(int *n)
{
  struct row *rows = NULL, r;
  int room = 0;

  *n = 0;
  while (scanf("%d,%lf,%lf,%lf,%lf", &r.curve, &r.compliance, &r.point.c, &r.point.V,
               &r.point.omega) == 5) {
    r.point.omega *= 2. * MLG_PI;
    r.point.extremum = MIN;
    if (*n == room) {
      room = room ? 2 * room : 1024;
      rows = realloc(rows, (size_t)room * sizeof *rows);
      if (!rows) {
        fprintf(stderr, "scan: out of memory\n");
        exit(1);
      }
    }
    rows[(*n)++] = r;
  }
  if (!feof(stdin)) {
    fprintf(stderr, "scan: row %d: expected curve,compliance,c_d,V,frequency_hz\n", *n + 1);
    exit(2);
  }
  return rows;
}

/* The zero-shimmy intervals at one compliance. */
enum { MOST_INTERVALS = 16 };
struct region { double compliance; int n; struct interval interval[MOST_INTERVALS]; };

/* Whether row i is a fold of its curve. */
static int is_fold(const struct row *rows, int n, int i)
{
  return i > 0 && i + 1 < n && rows[i - 1].curve == rows[i].curve && rows[i + 1].curve == rows[i].curve
         && (rows[i].compliance - rows[i - 1].compliance) * (rows[i + 1].compliance - rows[i].compliance) < 0.;
}

/* How far from row i to row i + 1 the curve passes the compliance, 0 to 1, or
 * -1.  Beside a fold the points move as the root of the distance from it. */
static double fraction(const struct row *rows, int n, int i, double compliance)
{
  const struct row *a = &rows[i], *b = &rows[i + 1];
  const double t = (compliance - a->compliance) / (b->compliance - a->compliance), slack = 1e-6;

  if (a->curve != b->curve || !(t >= -slack && t <= 1. + slack))
    return -1.;
  if (is_fold(rows, n, i))
    return t > 0. ? sqrt(t) : -1.;
  if (is_fold(rows, n, i + 1))
    return t < 1. ? 1. - sqrt(1. - t) : -1.;
  return fmax(0., t);
}

/* Bounded by AUTO's curves: where they pass the compliance, refined there; what
 * lies between is tested by Routh. */
static struct region region_at(double par[], double compliance, const struct row *rows, int n)
{
  struct region region = { .compliance = compliance, .n = 0 };
  struct points list = { NULL, 0, 0 };
  struct characteristic f;

  par[PAR_K_S] = 1e5 / compliance;
  f = characteristic(par);
  for (int i = 0; i + 1 < n; i++) {
    const struct row *a = &rows[i], *b = &rows[i + 1];
    const double t = fraction(rows, n, i, compliance);

    if (t >= 0.)
      add_refined(&list, &f, (struct point){ a->point.omega + t * (b->point.omega - a->point.omega),
                                             a->point.V + t * (b->point.V - a->point.V),
                                             a->point.c * pow(b->point.c / a->point.c, t), MIN });
  }
  if (list.n > 1)
    qsort(list.point, (size_t)list.n, sizeof *list.point, by_c);
  for (int i = -1; i < list.n && region.n < MOST_INTERVALS; i++) {
    const struct interval z = interval_above(&f, &list, i);

    if (z.hi > 0.)
      region.interval[region.n++] = z;
  }
  free(list.point);
  return region;
}

static void print_region(const struct region *r)
{
  for (int i = 0; i < r->n; i++) {
    const struct interval *z = &r->interval[i];

    printf("%.10g,%.8g,%.8g,%.8g,%.6g,%.6g,%.8g\n", r->compliance, 1e5 / r->compliance, z->lo, z->hi,
           z->V_lo, z->V_hi, z->hi - z->lo);
  }
}

static int falling(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;

  return (x < y) - (x > y);
}

/* The same over the compliance from 0.35 down to 0 (k_s from 2.9e5 to rigid): in
 * steps of 1 %, and on both sides of each fold of a curve, where a region is born
 * or two meet.  Where an interval appears or ends between two of these, both
 * sides of that place are found by bisection. */
static void print_regions(double par[])
{
  enum { GRID = 400, MOST = GRID + 64 };
  double node[MOST];
  int n, nodes = 0;
  struct row *rows = read_rows(&n);
  struct region last;

  for (int i = 0; i < GRID; i++)
    node[nodes++] = i + 1 < GRID ? 0.35 * pow(1.01, -i) : 0.;
  for (int i = 0; i < n && nodes + 2 <= MOST; i++)
    if (is_fold(rows, n, i))
      for (int side = -1; side <= 1; side += 2)
        node[nodes++] = rows[i].compliance * (1. + 1e-6 * side);
  qsort(node, (size_t)nodes, sizeof *node, falling);

  printf("compliance,k_s,c_lo,c_hi,V_lo,V_hi,width\n");
  last = region_at(par, node[0], rows, n);
  print_region(&last);
  for (int i = 1; i < nodes; i++) {
    const struct region next = region_at(par, node[i], rows, n);

    if (next.n != last.n) {
      struct region a = last, b = next;

      while (a.compliance - b.compliance > 1e-6 * a.compliance) {
        const struct region middle = region_at(par, 0.5 * (a.compliance + b.compliance), rows, n);

        if (middle.n == last.n)
          a = middle;
        else
          b = middle;
      }
      if (a.compliance != last.compliance)
        print_region(&a);
      if (b.compliance != next.compliance)
        print_region(&b);
    }
    print_region(&next);
    last = next;
  }
  free(rows);
}

/* Whether (c_lo, c_hi) is a zero-shimmy interval and cannot be made longer, by
 * Routh's test over V: inside right up to the ends, and just outside. */
static int is_whole_interval(const double par[], double c_lo, double c_hi)
{
  const struct characteristic f = characteristic(par);

  for (int i = 0; i <= 16; i++)
    if (!is_zero_shimmy(&f, c_lo * (1. + 1e-6) * pow(c_hi / c_lo * (1. - 2e-6), i / 16.), 800))
      return 0;
  return !is_zero_shimmy(&f, c_lo * 0.998, 800) && !is_zero_shimmy(&f, c_hi * 1.002, 800);
}

int main(int argc, char *argv[])
{
  double par[36] = { 0. };
  const char *what = argc > 1 ? argv[1] : "";
  const int check = strcmp(what, "check") == 0;
  double c_lo, c_hi;

  mlg_defaults(par);
  for (int i = check ? 4 : 2; i < argc; i++)
    set_beside_axes("scan", par, argv[i]);
  if (strcmp(what, "points") == 0)
    print_points(par);
  else if (strcmp(what, "intervals") == 0)
    print_intervals(par);
  else if (strcmp(what, "widest") == 0)
    print_widest(par);
  else if (strcmp(what, "regions") == 0)
    print_regions(par);
  else if (check && argc > 3 && is_number(argv[2], &c_lo) && is_number(argv[3], &c_hi))
    return !is_whole_interval(par, c_lo, c_hi);
  else {
    fprintf(stderr, "usage: scan points|intervals|widest|regions|check C_LO C_HI [NAME=VALUE ...]\n");
    return 2;
  }
  return output_status("scan");
}
