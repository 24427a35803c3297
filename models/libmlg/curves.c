/* curves.c - every Hopf curve in a part of the (V, c_d) plane, as a whole
 *
 * At one t (crossing.h) the two roots c of a quadratic are the points of the curves.  Over
 * t each root runs along a curve; both meet where the discriminant vanishes, a fold.  The
 * folds and the places where a root passes an edge of the plane are the roots of
 * polynomials, so that between neighbours of all these nothing happens: one look there
 * tells whether a root is in the plane.  Such stretches, joined, are whole curves: open
 * ones from edge to edge, closed ones from fold to fold and back.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossing.h"
#include "linearised.h"

enum { MOST_BREAKS = 8 * CROSSING_TERMS, POINTS = 256 /* of a stretch */ };

struct stretch { double t[2]; int fold[2], root, used; }; /* fold: which one, or -1 */

struct job {
  struct crossing x;
  double par[MLG_SLOTS];
  struct libmlg_plane plane; /* in the units of x */
  double t[MOST_BREAKS];     /* where something happens, rising */
  int fold[MOST_BREAKS];     /* whether D = 0 there */
  int n;
  struct stretch stretch[2 * MOST_BREAKS];
  int stretches;
};

static void add_break(struct job *j, double t, int fold)
{
  int i = j->n;

  if (j->n == MOST_BREAKS)
    return;
  for (; i > 0 && j->t[i - 1] > t; i--) {
    j->t[i] = j->t[i - 1];
    j->fold[i] = j->fold[i - 1];
  }
  j->t[i] = t;
  j->fold[i] = fold;
  j->n++;
}

static void find_breaks(struct job *j)
{
  struct crossing_at at[CROSSING_TERMS];
  double t[2 * CROSSING_TERMS];
  const int folds = crossing_folds(&j->x, t);

  for (int i = 0; i < folds; i++)
    add_break(j, t[i], 1);
  for (int side = 0; side < 2; side++) {
    const double V = side ? j->plane.V_top : j->plane.V_least, c = side ? j->plane.c_most : j->plane.c_least;
    int n = crossings_at_V(&j->x, V, at);

    for (int i = 0; i < n; i++)
      add_break(j, at[i].t, 0);
    n = crossings_at_c(&j->x, c, 0., INFINITY, at);
    for (int i = 0; i < n; i++)
      add_break(j, at[i].t, 0);
  }
}

static int is_inside(const struct job *j, double t, int root)
{
  struct crossing_at at[2];
  const struct libmlg_plane *p = &j->plane;

  return crossings_at_t(&j->x, t, at) >= 0. && at[root].V > p->V_least && at[root].V < p->V_top
         && at[root].c > p->c_least && at[root].c < p->c_most;
}

static void find_stretches(struct job *j)
{
  for (int root = 0; root < 2; root++)
    for (int i = 0; i + 1 < j->n; i++) {
      struct stretch s = { .root = root, .fold = { j->fold[i] ? i : -1, -1 } };

      if (!is_inside(j, 0.5 * (j->t[i] + j->t[i + 1]), root))
        continue;
      s.t[0] = j->t[i];
      while (!j->fold[i + 1] && i + 2 < j->n && is_inside(j, 0.5 * (j->t[i + 1] + j->t[i + 2]), root))
        i++; /* another root's edge */
      s.t[1] = j->t[i + 1];
      s.fold[1] = j->fold[i + 1] ? i + 1 : -1;
      j->stretch[j->stretches++] = s;
    }
}

/* The other stretch that ends at the same fold, and which of its ends. */
static struct stretch *joined(struct job *j, const struct stretch *s, int end, int *entry)
{
  for (int i = 0; i < j->stretches && s->fold[end] >= 0; i++)
    for (int e = 0; e < 2; e++)
      if (&j->stretch[i] != s && j->stretch[i].fold[e] == s->fold[end]) {
        *entry = e;
        return &j->stretch[i];
      }
  return NULL;
}

static struct libmlg_curve_point point_at(const struct job *j, double t, int root)
{
  struct crossing_at at[2];

  crossings_at_t(&j->x, t, at);
  return (struct libmlg_curve_point){ crossing_omega(&j->x, t), at[root].V * j->x.V_unit, at[root].c * j->x.c_unit,
                                      crossing_sine(&j->x, &at[root]), root };
}

/* The extremum of c_d between two neighbours, whose sines differ in sign. */
static struct libmlg_point extremum(const struct job *j, double t_a, double t_b, int root)
{
  const struct libmlg_curve_point a = point_at(j, t_a, root);
  struct libmlg_curve_point p;

  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (t_a + t_b);

    if (point_at(j, middle, root).sine * a.sine > 0.)
      t_a = middle;
    else
      t_b = middle;
  }
  p = point_at(j, t_a, root);
  return (struct libmlg_point){ p.c_d, p.V, p.omega, delta_over_psi(j->par, p.V, p.omega * mlg_ray(j->x.zeta)),
                                a.c_d > p.c_d ? LIBMLG_LEAST : LIBMLG_LARGEST };
}

/* omega / omega_unit */
static double in_omega(const struct job *j, double t)
{
  return j->x.squared ? sqrt(t) : t;
}

/* Follows the stretches from one end of s until an edge, or once round; 0, or
 * LIBMLG_FAILED. */
static int follow(struct job *j, struct stretch *s, int entry, struct libmlg_curve *curve)
{
  const struct stretch *first = s;

  *curve = (struct libmlg_curve){ .n = 0 };
  do {
    const double from = in_omega(j, s->t[entry]), to = in_omega(j, s->t[!entry]);
    struct libmlg_curve_point *more = realloc(curve->point, (size_t)(curve->n + POINTS + 1) * sizeof *more);
    double t_before = s->t[entry];

    if (!more)
      return LIBMLG_FAILED;
    curve->point = more;
    s->used = 1;
    for (int i = 0; i <= POINTS; i++) {
      const double omega = from + 0.5 * (1. - cos(MLG_PI * i / POINTS)) * (to - from);
      const double t = i == 0 ? s->t[entry] : i == POINTS ? s->t[!entry] : j->x.squared ? omega * omega : omega;
      struct libmlg_curve_point *p = &curve->point[curve->n++];

      *p = point_at(j, t, s->root);
      if (i > 0 && p[-1].sine * p->sine < 0. && curve->extrema < LIBMLG_MOST_EXTREMA)
        curve->extremum[curve->extrema++] = extremum(j, t_before, t, s->root);
      t_before = t;
    }
    s = joined(j, s, !entry, &entry);
  } while (s && s != first);
  curve->closed = s != NULL;
  return 0;
}

/* Whole curves: the open ones first, of the others the one of the lowest t. */
static int find_curves(struct job *j, struct libmlg_curve curves[])
{
  int n = 0;

  for (int closed = 0; closed < 2; closed++)
    for (int i = 0; i < j->stretches; i++) {
      struct stretch *s = &j->stretch[i];

      if (s->used || (!closed && s->fold[0] >= 0 && s->fold[1] >= 0))
        continue;
      for (int k = i; closed && k < j->stretches; k++)
        if (!j->stretch[k].used && j->stretch[k].t[0] < s->t[0])
          s = &j->stretch[k];
      if (follow(j, s, !closed && s->fold[0] >= 0, &curves[n++]) != 0) {
        libmlg_free_curves(curves, n);
        return LIBMLG_FAILED;
      }
      if (closed)
        i--; /* it may have been another one */
    }
  return n;
}

int libmlg_curves(int layout, const double par[], double zeta, const struct libmlg_plane *plane,
                  struct libmlg_curve **curves)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  struct job *j;
  int n;

  if (!l)
    return LIBMLG_NONE;
  j = calloc(1, sizeof *j);
  *curves = calloc(2 * MOST_BREAKS, sizeof **curves);
  if (!j || !*curves) {
    free(j);
    free(*curves);
    return LIBMLG_FAILED;
  }
  libmlg_slots_at_rest(par, j->par);
  j->x = crossing_of(l, j->par, zeta);
  if (j->x.speeds > 1) { /* at one t the roots are not two */
    free(j);
    free(*curves);
    return LIBMLG_UNSURE;
  }
  j->plane = (struct libmlg_plane){ plane->V_least / j->x.V_unit, plane->V_top / j->x.V_unit,
                                    plane->c_least / j->x.c_unit, plane->c_most / j->x.c_unit };
  find_breaks(j);
  find_stretches(j);
  n = find_curves(j, *curves);
  free(j);
  return n;
}

void libmlg_free_curves(struct libmlg_curve *curves, int n)
{
  for (int i = 0; i < n; i++)
    free(curves[i].point);
  free(curves);
}
