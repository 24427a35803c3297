/* cycle.c - a periodic orbit from an integration, by Newton's method on a Poincare map
 *
 * The section is psi' = 0 downwards, the maxima of psi; a period is the least number of
 * them, up to 8, after which the gear is back.  The map's derivative is differenced,
 * column by column, and its eigenvalues are the orbit's multipliers but the trivial one.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <lapacke.h>

#include "layout.h"

enum { MOST = LIBMLG_MOST_STATES, MOST_MAXIMA = 8 };

struct map { struct libmlg_run *run; const double *par; int n, maxima; double size[MOST]; };

static double size_of(const struct map *m, const double u[])
{
  double size = 1e-12;

  for (int i = 0; i < m->n; i++)
    size = fmax(size, fabs(u[i]) / m->size[i]);
  return size;
}

static double distance(const struct map *m, const double u[], const double v[])
{
  double far = 0.;

  for (int i = 0; i < m->n; i++)
    far = fmax(far, fabs(u[i] - v[i]) / m->size[i]);
  return far / size_of(m, u);
}

/* On to the next maximum of psi; 0 when there is none for a long time. */
static int next_maximum(struct libmlg_run *run)
{
  const double end = run->t + 20.;
  int reached;

  do
    reached = libmlg_run_to(run, end);
  while (reached == LIBMLG_AT_LIMIT);
  return reached == LIBMLG_AT_SECTION;
}

/* The map from u to v, a period on; *period its time.  0 when it does not come back. */
static int returns(const struct map *m, const double u[], double v[], double *period)
{
  libmlg_run_start(m->run, m->par, u);
  for (int i = 0; i < m->maxima; i++)
    if (!next_maximum(m->run))
      return 0;
  memcpy(v, m->run->u, (size_t)m->n * sizeof *v);
  *period = m->run->t;
  return 1;
}

/* The least number of maxima after which the run is nearly back, or 0. */
static int count_maxima(struct map *m, double nearly)
{
  double u[MOST];

  memcpy(u, m->run->u, sizeof u);
  for (int k = 1; k <= MOST_MAXIMA; k++)
    if (!next_maximum(m->run))
      return 0;
    else if (distance(m, u, m->run->u) < nearly)
      return k;
  return 0;
}

/* A Newton step of u, whose image is v; the multipliers into c.  dpsi is 0 throughout. */
static int improve(const struct map *m, double u[], const double v[], struct libmlg_cycle *c)
{
  const int n = m->n - 1;
  const double h = 1e-5 * size_of(m, u);
  double J[MOST * MOST], A[MOST * MOST], right[MOST], image[MOST], moved[MOST], period;
  int at[MOST], pivot[MOST], k = 0;

  for (int i = 0; i < m->n; i++)
    if (i != DPSI)
      at[k++] = i;
  for (int j = 0; j < n; j++) {
    memcpy(moved, u, sizeof moved);
    moved[at[j]] += h * m->size[at[j]];
    if (!returns(m, moved, image, &period))
      return 0;
    for (int i = 0; i < n; i++)
      J[i + n * j] = (image[at[i]] - v[at[i]]) / (h * m->size[at[j]]);
  }
  for (int i = 0; i < n; i++) {
    right[i] = v[at[i]] - u[at[i]];
    for (int j = 0; j < n; j++)
      A[i + n * j] = (i == j) - J[i + n * j];
  }
  for (int i = 0; i < n * n; i++)
    if (!isfinite(J[i]))
      return 0;
  if (LAPACKE_dgesv(LAPACK_COL_MAJOR, n, 1, A, n, pivot, right, n) != 0
      || LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', n, J, n, c->multiplier_re, c->multiplier_im, NULL, 1, NULL, 1) != 0)
    return 0;
  for (int i = 0; i < n; i++)
    u[at[i]] += right[i];
  c->multipliers = n;
  return 1;
}

/* Largest |psi| and |delta| over the period. */
static void measure(const struct map *m, struct libmlg_cycle *c)
{
  static const int rate[2] = { DPSI, DDELTA }, angle[2] = { PSI, DELTA };
  double *const most[2] = { &c->psi, &c->delta };

  for (int k = 0; k < 2; k++) {
    libmlg_run_start(m->run, m->par, c->u);
    libmlg_run_section(m->run, rate[k], 0);
    *most[k] = fabs(c->u[angle[k]]);
    for (int reached; (reached = libmlg_run_to(m->run, c->period)) > LIBMLG_AT_TIME;)
      if (reached == LIBMLG_AT_SECTION)
        *most[k] = fmax(*most[k], fabs(m->run->u[angle[k]]));
    c->corners = m->run->corners;
    c->limits = m->run->limits;
  }
  libmlg_run_section(m->run, DPSI, -1);
}

int libmlg_cycle(struct libmlg_run *run, int layout, const double par[], const double start[], double settle,
                 struct libmlg_cycle *c)
{
  struct map m = { .run = run, .par = par, .n = libmlg_states(layout) };
  const double before = libmlg_oscillation_size(layout, start);
  double v[MOST], u[MOST];
  double last = INFINITY;

  if (m.n < 0)
    return LIBMLG_NONE;
  *c = (struct libmlg_cycle){ .why = NULL };
  for (int i = 0; i < m.n; i++)
    m.size[i] = libmlg_state_size(layout, i);
  libmlg_run_start(run, par, start);
  libmlg_run_section(run, DPSI, -1);
  while (run->t < settle)
    if (!next_maximum(run) || libmlg_oscillation_size(layout, run->u) < 1e-7 * before) {
      c->why = "the oscillation dies out";
      return LIBMLG_FAILED;
    }
  if (settle <= 0. && !next_maximum(run)) {
    c->why = "psi has no maximum";
    return LIBMLG_FAILED;
  }
  if ((m.maxima = count_maxima(&m, 0.02)) == 0) {
    c->why = "the oscillation is not periodic yet, or not at all";
    return LIBMLG_FAILED;
  }
  memcpy(u, run->u, sizeof u);
  for (int i = 0; i < 12; i++) {
    if (!returns(&m, u, v, &c->period)) {
      c->why = "Newton's method leads where psi has no maximum";
      return LIBMLG_FAILED;
    }
    c->error = distance(&m, u, v);
    if (c->error < 1e-8 || (i > 2 && c->error > 0.5 * last && c->error < 1e-5))
      break;
    last = c->error;
    if (!improve(&m, u, v, c)) {
      c->why = "the derivative of the Poincare map is singular";
      return LIBMLG_FAILED;
    }
    if (size_of(&m, u) < 1e-3 * size_of(&m, v) || size_of(&m, u) > 1e2 * size_of(&m, v)) {
      c->why = "Newton's method leads away";
      return LIBMLG_FAILED;
    }
  }
  if (size_of(&m, u) < 1e-6 * before) { /* Newton's method came to rest */
    c->why = "the oscillation dies out";
    return LIBMLG_FAILED;
  }
  if (!(c->error < 1e-5)) {
    c->why = "Newton's method does not converge";
    return LIBMLG_FAILED;
  }
  c->maxima = m.maxima;
  memcpy(c->u, u, sizeof c->u);
  if (c->multipliers == 0) { /* converged at once */
    memcpy(v, u, sizeof v);
    if (!returns(&m, u, v, &c->period) || !improve(&m, u, v, c)) {
      c->why = "the derivative of the Poincare map is singular";
      return LIBMLG_FAILED;
    }
  }
  for (int i = 0; i < c->multipliers; i++)
    c->largest = fmax(c->largest, hypot(c->multiplier_re[i], c->multiplier_im[i]));
  measure(&m, c);
  return 0;
}
