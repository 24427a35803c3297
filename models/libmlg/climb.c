/* climb.c - see climb.h */
#include "climb.h"

#include <math.h>
#include <string.h>

enum { N = CLIMB_MOST, CUTS = 3 * CLIMB_PIECES };

/* A piece at a place: value + slope (x - at) near it. */
struct cut { double value, slope[N], at[N]; };

struct climb {
  climb_function *f;
  void *context;
  int n, asked, cuts, tops; /* asked: values so far; the first `tops` of the cuts are those of the best place, then the latest first */
  struct cut cut[CUTS];
  double best, at[N], radius;
  int tries; /* since the best place */
  int bent, failed; /* whether the last step back to a kink led higher; places tried without one since */
};

/* --- the model's top --------------------------------------------------------------------------- */

/* The simplex method for: the largest z[0], z >= 0, a z <= right, right >= 0.  Rows are turned in
 * place, the last one the objective, the last column `right`; basic[i] is the variable of row i,
 * columns + i its own slack.  Bland's rule, so that it ends. */
struct programme { int rows, columns; double a[CUTS + N + 1][N + 2]; int basic[CUTS + N], free[N + 1]; };

static void exchange(struct programme *p, int row, int column)
{
  const int last = p->columns, was = p->basic[row];
  const double pivot = p->a[row][column];

  for (int j = 0; j <= last; j++)
    p->a[row][j] /= j == column ? 1. : pivot;
  p->a[row][column] = 1. / pivot;
  for (int i = 0; i <= p->rows; i++) {
    const double factor = p->a[i][column];

    if (i == row || factor == 0.)
      continue;
    for (int j = 0; j <= last; j++)
      p->a[i][j] = j == column ? -factor / pivot : p->a[i][j] - factor * p->a[row][j];
  }
  p->basic[row] = p->free[column];
  p->free[column] = was;
}

static void solve(struct programme *p)
{
  for (int step = 0; step < 200; step++) {
    int column = -1, row = -1;

    for (int j = 0; j < p->columns; j++)
      if (p->a[p->rows][j] < -1e-12 && (column < 0 || p->free[j] < p->free[column]))
        column = j;
    if (column < 0)
      return;
    for (int i = 0; i < p->rows; i++) {
      if (!(p->a[i][column] > 1e-13))
        continue;
      const double here = p->a[i][p->columns] / p->a[i][column];
      const double least = row < 0 ? INFINITY : p->a[row][p->columns] / p->a[row][column];

      if (here < least || (here == least && p->basic[i] < p->basic[row]))
        row = i;
    }
    if (row < 0)
      return;
    exchange(p, row, column);
  }
}

/* The value of a cut at x. */
static double on(const struct climb *c, const struct cut *cut, const double x[])
{
  double value = cut->value;

  for (int j = 0; j < c->n; j++)
    value += cut->slope[j] * (x[j] - cut->at[j]);
  return value;
}

/* The place of the box about the best one at which the least of so many cuts is largest, and how much
 * that is above the best value. */
static double top_of_model(const struct climb *c, const struct cut cut[], int cuts, double x[])
{
  struct programme p = { .rows = cuts + c->n, .columns = c->n + 1 };
  double low[N], scale = 1e-300, floor = INFINITY;

  for (int j = 0; j < c->n; j++)
    low[j] = fmax(0., c->at[j] - c->radius);
  for (int i = 0; i < cuts; i++) {
    floor = fmin(floor, on(c, &cut[i], low));
    for (int j = 0; j < c->n; j++)
      scale = fmax(scale, fabs(cut[i].slope[j]) * c->radius);
  }
  /* z[0]: (value - floor) / scale, the others (x - low) / radius */
  for (int i = 0; i < cuts; i++) {
    p.a[i][0] = 1.;
    for (int j = 0; j < c->n; j++)
      p.a[i][j + 1] = -cut[i].slope[j] * c->radius / scale;
    p.a[i][p.columns] = (on(c, &cut[i], low) - floor) / scale;
  }
  for (int j = 0; j < c->n; j++) {
    p.a[cuts + j][j + 1] = 1.;
    p.a[cuts + j][p.columns] = (fmin(1., c->at[j] + c->radius) - low[j]) / c->radius;
  }
  p.a[p.rows][0] = -1.;
  for (int j = 0; j < p.columns; j++)
    p.free[j] = j;
  for (int i = 0; i < p.rows; i++)
    p.basic[i] = p.columns + i;
  solve(&p);
  memcpy(x, low, (size_t)c->n * sizeof *x);
  for (int i = 0; i < p.rows; i++)
    if (p.basic[i] > 0 && p.basic[i] < p.columns)
      x[p.basic[i] - 1] = fmin(1., low[p.basic[i] - 1] + p.a[i][p.columns] * c->radius);
  return floor + p.a[p.rows][p.columns] * scale - c->best;
}

/* --- the climb ----------------------------------------------------------------------------------- */

static double distance(const struct climb *c, const double x[])
{
  double far = 0.;

  for (int j = 0; j < c->n; j++)
    far = fmax(far, fabs(x[j] - c->at[j]));
  return far;
}

/* Leaves out the cuts of other places that are too far away, and those that the best place shows to
 * be wrong: their piece bends upwards. */
static void clean(struct climb *c)
{
  int kept = c->tops;

  for (int i = c->tops; i < c->cuts; i++)
    if (distance(c, c->cut[i].at) <= 4. * c->radius && on(c, &c->cut[i], c->at) >= c->best)
      c->cut[kept++] = c->cut[i];
  c->cuts = kept;
}

/* The pieces at x[] before the cuts from number `from` on; the oldest go. */
static void add(struct climb *c, int from, const struct climb_piece piece[], int pieces, const double x[])
{
  const int rest = c->cuts - from, room = CUTS - from - pieces, kept = rest < room ? rest : room;

  memmove(&c->cut[from + pieces], &c->cut[from], (size_t)kept * sizeof *c->cut);
  for (int i = 0; i < pieces; i++) {
    struct cut *const cut = &c->cut[from + i];

    cut->value = piece[i].value;
    memcpy(cut->slope, piece[i].slope, sizeof cut->slope);
    memcpy(cut->at, x, (size_t)c->n * sizeof *x);
  }
  c->cuts = from + pieces + kept;
}

/* The pieces at x[] that have slopes, and the least value. */
static int value_at(struct climb *c, const double x[], struct climb_piece piece[], double *value)
{
  const int n = c->f(x, piece, c->context);

  c->asked++;
  *value = n > 0 ? INFINITY : -INFINITY;
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < c->n; j++)
      if (!isfinite(piece[i].slope[j]))
        return 0;
    *value = fmin(*value, piece[i].value);
  }
  return isfinite(*value) ? n : 0;
}

/* x[] becomes the best place. */
static void move(struct climb *c, const double x[], double value, const struct climb_piece piece[], int pieces)
{
  add(c, 0, piece, pieces, x);
  memcpy(c->at, x, (size_t)c->n * sizeof *x);
  c->best = value;
  c->tops = pieces;
}

/* Whether some cut is below a value at x. */
static int is_lower_at(const struct climb *c, const double x[], double value)
{
  for (int i = 0; i < c->cuts; i++)
    if (on(c, &c->cut[i], x) < value)
      return 1;
  return 0;
}

/* Asks for the pieces of the best place again, of which more may be known by now; whether there are. */
static int look_again(struct climb *c)
{
  struct climb_piece piece[CLIMB_PIECES];
  double value;
  const int pieces = value_at(c, c->at, piece, &value), before = c->tops;

  if (pieces == 0)
    return 0;
  c->cuts -= c->tops;
  memmove(c->cut, &c->cut[c->tops], (size_t)c->cuts * sizeof *c->cut);
  move(c, c->at, value, piece, pieces);
  clean(c);
  return pieces > before;
}

/* A place that is not higher: its pieces correct the model, or, where they do not, the box is
 * too wide for it. */
static void learn(struct climb *c, const double x[], double expected)
{
  const double before = c->radius;

  clean(c);
  if (is_lower_at(c, x, c->best + 0.5 * expected) || (look_again(c) && is_lower_at(c, x, c->best + 0.5 * expected))) {
    if (++c->tries % 3 == 0)
      c->radius *= 0.5;
  } else
    c->radius = 0.3 * fmin(before, distance(c, x));
}

/* Tries a place, which becomes the best if it is higher; else its pieces stand before the others.
 * Returns how many there are. */
static int try(struct climb *c, const double x[], double expected)
{
  struct climb_piece piece[CLIMB_PIECES];
  double value;
  const int pieces = value_at(c, x, piece, &value);
  const double gain = value - c->best, length = distance(c, x);

  if (pieces > 0 && gain > 0.) {
    move(c, x, value, piece, pieces);
    if (gain > 0.5 * expected && length > 0.9 * c->radius)
      c->radius = fmin(2. * c->radius, 0.5);
    else /* a short step may come of cuts from afar that are wrong here: they go with the wide box */
      c->radius = fmin(gain < 0.1 * expected ? 0.7 * c->radius : c->radius, 4. * length);
    c->tries = 0;
  } else
    add(c, c->tops, piece, pieces, x);
  return pieces;
}

static void step(struct climb *c)
{
  double x[N], beside[N];
  const double before = c->best, expected = top_of_model(c, c->cut, c->cuts, x);

  if (!(distance(c, x) > 0.) || !(expected > 1e-13 * fabs(c->best))) { /* none is higher, if the model is right */
    c->radius *= 0.2;
    clean(c);
    return;
  }
  const int pieces = try(c, x, expected);

  if (pieces == 0)
    c->radius = 0.3 * fmin(c->radius, distance(c, x));
  else if (c->best == before) {
    /* back to the kink by the pieces of that place alone: those of the best one may bend away from it */
    if (pieces > 1 && (c->bent || ++c->failed % 4 == 0) && top_of_model(c, &c->cut[c->tops], pieces, beside) > 0.
        && distance(c, beside) > 0.) {
      try(c, beside, expected);
      c->bent = c->best > before;
    }
    if (c->best == before)
      learn(c, x, expected);
  }
  clean(c);
}

int climb_largest(climb_function *f, void *context, int n, double x[], double radius, int most, double enough,
                  double *best)
{
  struct climb c = { .f = f, .context = context, .n = n, .radius = radius };
  struct climb_piece piece[CLIMB_PIECES];
  const int pieces = value_at(&c, x, piece, best);

  if (pieces == 0) {
    *best = -INFINITY;
    return c.asked;
  }
  move(&c, x, *best, piece, pieces);
  while (c.asked < most && c.radius > 1e-9 && !(c.best > enough))
    step(&c);
  memcpy(x, c.at, (size_t)n * sizeof *x);
  *best = c.best;
  return c.asked;
}
