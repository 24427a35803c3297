/* curves - every Hopf curve in the (V, c_d) plane, as starting points for AUTO
 *
 *   curves-LAYOUT [NAME=VALUE ...]      NAME: a parameter of models/mlg.h
 *
 * At fixed frequency omega the Hopf points (V, c_d) are the two roots of a
 * quadratic (models/characteristic.h).  Over omega each root runs along a curve;
 * both meet where the discriminant vanishes, a fold in omega.  Stretches inside
 * the plane joined at the folds are whole curves: open ones from edge to edge of
 * the plane, closed ones from fold to fold and back.  None can be missed, however
 * small: the discriminant is searched for every change of its sign.
 *
 * Prints CSV, one curve a line:
 *   curve    number
 *   kind     open or closed
 *   shimmy   psi or delta: the eigenvector where c_d has its first extremum
 *            along the curve, or halfway
 *   c_d, V   where to start: just inside an edge; closed: beside a fold
 *   way      1 if c_d rises from there along the curve, -1 if it falls
 *   stop     closed: the period, s, at which the curve has come round once
 *   V_range  how far the curve extends in V, m/s
 *   step     for AUTO to make a smooth picture, 1 m/s counting as 1000 N m s/rad
 *   extrema  where c_d has an extremum along it, as V:c_d, blanks between
 * Bad input: one line, status 2.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MLG_NO_AUTO
#include LAYOUT
#include "characteristic.h"
#include "arguments.h"

/* the plane, m/s and N m s/rad: UZSTOP of constants/c.LAYOUT.hopf */
static const double V_least = 0.1, V_most = MLG_V_TOP, c_least = 10., c_most = 8e4;
static const double f_least = 0.5, f_most = 40., f_step = 0.002; /* Hz */

/* --- Hopf points at one frequency ------------------------------------------- */

struct sample {
  double omega, D, c[2], V[2];
  int fold; /* -1: there is no Hopf point below this omega, 1: none above */
};

static struct sample sample(const struct characteristic *f, double omega)
{
  const struct hopf_pair p = hopf_pair(f, omega);

  return (struct sample){ omega, p.D, { p.c[0], p.c[1] }, { p.V[0], p.V[1] }, 0 };
}

static int inside(double V, double c, double margin)
{
  return V > V_least * (1. + margin) && V < V_most * (1. - margin)
         && c > c_least * (1. + margin) && c < c_most * (1. - margin);
}

static int is_inside(const struct sample *p, int k)
{
  return p->D >= 0. && inside(p->V[k], p->c[k], 1e-5);
}

/* --- samples over the frequency, folds among them ---------------------------- */

struct samples { struct sample *sample; int n, room; };

static void *grown(void *list, int *room, size_t size)
{
  *room = *room ? 2 * *room : 64;
  list = realloc(list, (size_t)*room * size);
  if (!list) {
    fprintf(stderr, "curves: out of memory\n");
    exit(1);
  }
  return list;
}

static void add_sample(struct samples *list, struct sample p)
{
  if (list->n == list->room)
    list->sample = grown(list->sample, &list->room, sizeof *list->sample);
  list->sample[list->n++] = p;
}

/* Adds what lies after the last sample up to p, as finely as the curves move. */
static void add_finely(struct samples *list, const struct characteristic *f, struct sample p, int depth)
{
  const struct sample last = list->n ? list->sample[list->n - 1] : p;
  int far = 0;

  for (int k = 0; k < 2; k++)
    if (last.D >= 0. && p.D >= 0. && (is_inside(&last, k) || is_inside(&p, k)))
      far |= fabs(p.V[k] - last.V[k]) > 2. || fabs(p.c[k] - last.c[k]) > 0.1 * fabs(p.c[k]);
  if (far && depth > 0) {
    add_finely(list, f, sample(f, 0.5 * (last.omega + p.omega)), depth - 1);
    add_finely(list, f, p, depth - 1);
  } else
    add_sample(list, p);
}

/* Adds p, and before it the fold between it and the last one. */
static void add_with_fold(struct samples *list, const struct characteristic *f, struct sample p)
{
  if (list->n && (list->sample[list->n - 1].D >= 0.) != (p.D >= 0.)) {
    struct sample in = p, out = list->sample[list->n - 1];

    if (p.D < 0.) {
      out = p;
      in = list->sample[list->n - 1];
    }
    for (int i = 0; i < 60; i++) {
      const struct sample middle = sample(f, 0.5 * (in.omega + out.omega));

      if (middle.D >= 0.)
        in = middle;
      else
        out = middle;
    }
    in.fold = p.D < 0. ? 1 : -1;
    add_finely(list, f, in, 30);
  }
  add_finely(list, f, p, 30);
}

/* The extremum of D between l and r; sign = 1: maximum, -1: minimum. */
static struct sample extremum_of_D(const struct characteristic *f, double l, double r, double sign)
{
  const double golden = 0.6180339887498949;

  for (int i = 0; i < 50; i++) {
    const double a = r - golden * (r - l), b = l + golden * (r - l);

    if (sign * sample(f, a).D > sign * sample(f, b).D)
      r = b;
    else
      l = a;
  }
  return sample(f, 0.5 * (l + r));
}

static struct samples all_samples(const struct characteristic *f)
{
  struct samples list = { NULL, 0, 0 };
  struct sample before = { 0 }, last = { 0 };

  for (double frequency = f_least; frequency <= f_most; frequency += f_step) {
    const struct sample now = sample(f, 2. * MLG_PI * frequency);

    if (before.omega > 0. && (before.D >= 0.) == (last.D >= 0.) && (last.D >= 0.) == (now.D >= 0.)) {
      const double sign = last.D < 0. ? 1. : -1.;

      if (sign * (last.D - before.D) > 0. && sign * (last.D - now.D) > 0.) {
        const struct sample peak = extremum_of_D(f, before.omega, now.omega, sign);

        if ((peak.D >= 0.) != (last.D >= 0.)) { /* a curve, or a gap, between the samples */
          if (peak.omega < last.omega)
            list.n--; /* last comes after it */
          add_with_fold(&list, f, peak);
          if (peak.omega < last.omega)
            add_with_fold(&list, f, last);
        }
      }
    }
    add_with_fold(&list, f, now);
    before = last;
    last = now;
  }
  return list;
}

/* --- stretches of a root inside the plane, joined at folds ------------------- */

struct stretch {
  int root;
  double omega[2];   /* its two ends */
  int fold[2];       /* the fold's place among the samples, or -1: an edge */
  int used;
};

struct stretches { struct stretch *stretch; int n, room; };

/* The end at an edge: between a sample inside and one outside. */
static double edge(const struct characteristic *f, int k, double in, double out)
{
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (in + out);
    const struct sample p = sample(f, middle);

    if (is_inside(&p, k))
      in = middle;
    else
      out = middle;
  }
  return in;
}

static struct stretches all_stretches(const struct characteristic *f, const struct samples *list)
{
  struct stretches all = { NULL, 0, 0 };

  for (int k = 0; k < 2; k++)
    for (int i = 0; i < list->n; i++) {
      const struct sample *p = list->sample;
      struct stretch s = { k, { p[i].omega, 0. }, { -1, -1 }, 0 };

      if (!is_inside(&p[i], k))
        continue;
      if (p[i].fold < 0)
        s.fold[0] = i;
      else if (i > 0)
        s.omega[0] = edge(f, k, p[i].omega, p[i - 1].omega);
      while (p[i].fold <= 0 && i + 1 < list->n && is_inside(&p[i + 1], k))
        i++;
      s.omega[1] = p[i].omega;
      if (p[i].fold > 0)
        s.fold[1] = i;
      else if (i + 1 < list->n)
        s.omega[1] = edge(f, k, p[i].omega, p[i + 1].omega);
      if (all.n == all.room)
        all.stretch = grown(all.stretch, &all.room, sizeof *all.stretch);
      all.stretch[all.n++] = s;
    }
  return all;
}

/* The other stretch that ends at the same fold, and which of its ends. */
static struct stretch *joined(const struct stretches *all, const struct stretch *s, int end, int *entry)
{
  for (int i = 0; i < all->n; i++)
    for (int e = 0; e < 2; e++)
      if (&all->stretch[i] != s && s->fold[end] >= 0 && all->stretch[i].fold[e] == s->fold[end]) {
        *entry = e;
        return &all->stretch[i];
      }
  return NULL;
}

/* --- a whole curve ------------------------------------------------------------ */

struct point { double omega, V, c, slope; int root; };

enum { POINTS = 256 }; /* on a stretch, closer towards its ends */

struct curve { struct point *point; int n, room, closed; };

static struct point point_on(const struct characteristic *f, double omega, int k)
{
  const struct sample p = sample(f, omega);
  const struct jet j = jet(f, omega * I, p.V[k], p.c[k]);

  return (struct point){ omega, p.V[k], p.c[k], extremum_sine(&j, I, j.F_V), k };
}

/* Follows the stretches from one end of s until an edge, or once round. */
static struct curve follow(const struct characteristic *f, const struct stretches *all,
                           struct stretch *s, int entry)
{
  struct curve curve = { NULL, 0, 0, 0 };
  const struct stretch *first = s;

  do {
    const double from = s->omega[entry], to = s->omega[!entry];

    s->used = 1;
    for (int i = 0; i <= POINTS; i++) {
      const double t = 0.5 * (1. - cos(MLG_PI * i / POINTS));

      if (curve.n == curve.room)
        curve.point = grown(curve.point, &curve.room, sizeof *curve.point);
      curve.point[curve.n++] = point_on(f, from + t * (to - from), s->root);
    }
    s = joined(all, s, !entry, &entry);
  } while (s && s != first);
  curve.closed = s != NULL;
  return curve;
}

static void reverse(struct curve *curve)
{
  for (int i = 0, j = curve->n - 1; i < j; i++, j--) {
    const struct point p = curve->point[i];

    curve->point[i] = curve->point[j];
    curve->point[j] = p;
  }
}

static double auto_distance(const struct point *a, const struct point *b)
{
  return hypot(b->V - a->V, 1e-3 * (b->c - a->c));
}

/* Whole curves: the open ones first. */
static struct curve *all_curves(const struct characteristic *f, int *n)
{
  struct samples samples = all_samples(f);
  struct stretches all = all_stretches(f, &samples);
  struct curve *curves = NULL;
  int room = 0;

  *n = 0;
  for (int closed = 0; closed < 2; closed++)
    for (int i = 0; i < all.n; i++) {
      struct stretch *s = &all.stretch[i];
      int entry = 0;
      struct curve curve;

      if (s->used || (!closed && s->fold[0] >= 0 && s->fold[1] >= 0))
        continue;
      if (closed) /* what is left is closed: from its fold of lowest or highest omega */
        for (int j = i; j < all.n; j++)
          if (!all.stretch[j].used && all.stretch[j].omega[0] < s->omega[0])
            s = &all.stretch[j];
      if (!closed && s->fold[0] >= 0)
        entry = 1;
      curve = follow(f, &all, s, entry);
      if (!closed) {
        /* from the end where a straight run crosses it better */
        const double first = fabs(curve.point[0].slope), last = fabs(curve.point[curve.n - 1].slope);

        if (last > first)
          reverse(&curve);
      }
      if (*n == room)
        curves = grown(curves, &room, sizeof *curves);
      curves[(*n)++] = curve;
    }
  free(samples.sample);
  free(all.stretch);
  return curves;
}

/* A closed curve begins at a fold of the period.  AUTO starts at a point past the
 * fold and stops at one before it, where the period is as one half of the way
 * to the start; AUTO must not step over fold and both, so the way is longer than its step. */
static int start_of(const struct curve *curve, double step)
{
  const struct point *p = curve->point, *last = p + curve->n - 1;
  double way = 0.;
  int i = 0;

  if (!curve->closed)
    return 0;
  while (way < 1.5 * step && i < POINTS / 4) {
    way += auto_distance(&p[i], &p[i + 1]) + auto_distance(last - i, last - i - 1);
    i++;
  }
  return 2 * i;
}

/* The extremum of c_d between two neighbours, where slope changes its sign. */
static struct point extremum_between(const struct characteristic *f, struct point a, struct point b)
{
  for (int i = 0; i < 60; i++) {
    const struct point middle = point_on(f, 0.5 * (a.omega + b.omega), a.root);

    if (middle.slope * a.slope > 0.)
      a = middle;
    else
      b = middle;
  }
  return a;
}

/* The step with which chords stay within 0.04 % of a picture's size of the curve.
 * The picture shows 100 m/s by two decades of c_d above 500; bounds on the step
 * keep small closed curves round and long ones cheap. */
static double smooth_step(const struct curve *curve, double V_range)
{
  double step = 1.;

  for (int i = 1; i + 1 < curve->n; i++) {
    const struct point *a = &curve->point[i - 1], *b = a + 1, *c = a + 2;
    const double x1 = (b->V - a->V) / 100., y1 = 0.5 * log10(b->c / a->c);
    const double x2 = (c->V - b->V) / 100., y2 = 0.5 * log10(c->c / b->c);
    const double auto_length = auto_distance(a, c) / 2.;
    const double length = hypot(x1 + x2, y1 + y2) / 2.;
    /* turn of the tangent over that length */
    const double turn = fabs(x1 * y2 - x2 * y1) / (hypot(x1, y1) * hypot(x2, y2) + 1e-300);

    if (b->c > 500. && length * turn > 0.)
      step = fmin(step, auto_length * sqrt(8. * 4e-4 / (length * turn)));
  }
  return curve->closed ? fmax(V_range / 300., fmin(V_range / 30., step)) : fmax(0.15, step);
}

static void print_curve(const double par[], const struct characteristic *f,
                        const struct curve *curve, int number)
{
  const struct point *p = curve->point;
  struct point shown = p[curve->n / 2], extremum[16];
  double lowest = p[0].V, highest = p[0].V, step;
  int extrema = 0, start;

  for (int i = 1; i < curve->n; i++) {
    lowest = fmin(lowest, p[i].V);
    highest = fmax(highest, p[i].V);
    if (p[i].root == p[i - 1].root && p[i].slope * p[i - 1].slope < 0. && extrema < 16)
      extremum[extrema++] = extremum_between(f, p[i - 1], p[i]);
  }
  if (extrema)
    shown = extremum[0];
  step = smooth_step(curve, highest - lowest);
  start = start_of(curve, step);
  printf("%d,%s,%s,%.12g,%.12g,%d,", number, curve->closed ? "closed" : "open",
         delta_over_psi(par, shown.V, shown.omega * I) > 1. ? "delta" : "psi",
         p[start].c, p[start].V, p[start + 1].c > p[start].c ? 1 : -1);
  if (curve->closed)
    printf("%.14g", 2. * MLG_PI / p[curve->n - 1 - start / 2].omega);
  printf(",%.6g,%.3g,", highest - lowest, step);
  for (int i = 0; i < extrema; i++)
    printf("%s%.12g:%.12g", i ? " " : "", extremum[i].V, extremum[i].c);
  printf("\n");
}

int main(int argc, char *argv[])
{
  double par[36] = { 0. };
  struct characteristic f;
  struct curve *curves;
  int n;

  mlg_defaults(par);
  for (int i = 1; i < argc; i++)
    set_beside_axes("curves", par, argv[i]);
  f = characteristic(par);
  curves = all_curves(&f, &n);
  printf("curve,kind,shimmy,c_d,V,way,stop,V_range,step,extrema\n");
  for (int i = 0; i < n; i++) {
    print_curve(par, &f, &curves[i], i + 1);
    free(curves[i].point);
  }
  free(curves);
  return output_status("curves");
}
