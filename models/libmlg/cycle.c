/* cycle.c - a periodic orbit from an integration, by Newton's method on a Poincare map
 *
 * The map is that of the maxima of psi (poincare.h); a period is the least number of them
 * after which the gear is back.  The map's derivative is differenced, column by column, and
 * its eigenvalues are the orbit's multipliers but the trivial one.  The run may settle on
 * something else than the orbit that Newton's method finds beside it: then it is watched
 * (motion.c), and looked at again.
 */
#include <math.h>
#include <string.h>

#include <lapacke.h>

#include "poincare.h"

enum { MOST = LIBMLG_MOST_STATES, MOST_MAXIMA = 8, ROUNDS = 6 };

static const char no_maximum[] = "Newton's method leads where psi has no maximum";
static const char singular[] = "the derivative of the Poincare map is singular";

/* The least number of maxima after which the run is nearly back, or 0. */
static int count_maxima(const struct poincare *m, double nearly)
{
  double u[MOST];

  memcpy(u, m->run->u, sizeof u);
  for (int k = 1; k <= MOST_MAXIMA; k++)
    if (!poincare_next(m))
      return 0;
    else if (poincare_distance(m, u, m->run->u) < nearly)
      return k;
  return 0;
}

/* The derivative of the map at u, whose image is v, without dpsi, which is 0 throughout: at[]
 * are its n states.  Differences to one side will do for Newton's method; both sides are good to
 * 1e-4 at rtol 1e-8, 1e-6 at 1e-10, for multipliers.  0 when psi has no maximum there. */
static int derivative(const struct poincare *m, const double u[], const double v[], int maxima, int sides, int at[], double J[])
{
  const int n = m->n - 1;
  const double h = (sides == 2 ? m->difference_2 : m->difference) * poincare_size(m, u);
  double moved[MOST], image[MOST], back[MOST], time;
  int k = 0;

  for (int i = 0; i < m->n; i++)
    if (i != DPSI)
      at[k++] = i;
  for (int j = 0; j < n; j++) {
    const double step = h * m->size[at[j]];

    memcpy(back, v, sizeof back);
    memcpy(moved, u, sizeof moved);
    moved[at[j]] = u[at[j]] + step;
    if (!poincare_image(m, moved, maxima, image, &time))
      return 0;
    moved[at[j]] = u[at[j]] - step;
    if (sides == 2 && !poincare_image(m, moved, maxima, back, &time))
      return 0;
    for (int i = 0; i < n; i++) {
      J[i + n * j] = (image[at[i]] - back[at[i]]) / (sides * step);
      if (!isfinite(J[i + n * j]))
        return 0;
    }
  }
  return 1;
}

/* A Newton step of u, whose image is v. */
static int improve(const struct poincare *m, double u[], const double v[], struct libmlg_cycle *c)
{
  const int n = m->n - 1;
  double J[MOST * MOST], A[MOST * MOST], right[MOST];
  int at[MOST], pivot[MOST];

  if (!derivative(m, u, v, c->maxima, 1, at, J))
    return 0;
  for (int i = 0; i < n; i++) {
    right[i] = v[at[i]] - u[at[i]];
    for (int j = 0; j < n; j++)
      A[i + n * j] = (i == j) - J[i + n * j];
  }
  if (LAPACKE_dgesv(LAPACK_COL_MAJOR, n, 1, A, n, pivot, right, n) != 0)
    return 0;
  for (int i = 0; i < n; i++)
    u[at[i]] += right[i];
  return 1;
}

static int find_multipliers(const struct poincare *m, const double v[], struct libmlg_cycle *c)
{
  const int n = m->n - 1;
  double J[MOST * MOST];
  int at[MOST];

  if (!derivative(m, c->u, v, c->maxima, 2, at, J)
      || LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', n, J, n, c->multiplier_re, c->multiplier_im, NULL, 1, NULL, 1) != 0)
    return 0;
  c->multipliers = n;
  c->largest = 0.;
  for (int i = 0; i < n; i++)
    c->largest = fmax(c->largest, hypot(c->multiplier_re[i], c->multiplier_im[i]));
  return 1;
}

/* The fixed point near c->u, and the time there; else 0 and why. */
static int fixed_point(const struct poincare *m, double before, struct libmlg_cycle *c)
{
  double v[MOST], last = INFINITY;

  for (int i = 0; i < 12; i++) {
    c->why = no_maximum;
    if (!poincare_image(m, c->u, c->maxima, v, &c->period))
      return 0;
    c->error = poincare_distance(m, c->u, v);
    if (c->error < 1e-8 || (i > 2 && c->error > 0.5 * last && c->error < 1e-5))
      break;
    last = c->error;
    c->why = singular;
    if (!improve(m, c->u, v, c))
      return 0;
    c->why = "Newton's method leads away";
    if (poincare_size(m, c->u) < 1e-3 * poincare_size(m, v) || poincare_size(m, c->u) > 1e2 * poincare_size(m, v))
      return 0;
  }
  c->why = "the oscillation dies out";
  if (poincare_size(m, c->u) < 1e-6 * before) /* Newton's method came to rest */
    return 0;
  c->why = "Newton's method does not converge";
  return c->error < 1e-5;
}

/* The orbit of c->maxima maxima near c->u, and its multipliers; else 0 and why. */
static int orbit_near(const struct poincare *m, double before, struct libmlg_cycle *c)
{
  double v[MOST];

  if (!fixed_point(m, before, c))
    return 0;
  c->why = singular;
  if (!poincare_image(m, c->u, c->maxima, v, &c->period) || !find_multipliers(m, v, c))
    return 0;
  c->why = NULL;
  return 1;
}

/* The same with its least period.  Beside a doubled orbit, too near to be told from it, there
 * is an unstable one of half the period. */
static int newton(const struct poincare *m, double before, struct libmlg_cycle *c)
{
  if (!orbit_near(m, before, c))
    return 0;
  for (int k = 1; k < c->maxima; k++) {
    struct libmlg_cycle shorter = *c;
    double v[MOST], time;

    shorter.maxima = k;
    if (c->maxima % k == 0 && poincare_image(m, c->u, k, v, &time) && poincare_distance(m, c->u, v) < 0.02
        && orbit_near(m, before, &shorter) && poincare_distance(m, c->u, shorter.u) < 0.05
        && (shorter.largest < 1. || c->largest >= 1.))
      *c = shorter;
  }
  return 1;
}

/* The maxima of psi, and the largest |psi| and |delta| over the period. */
static void measure(const struct poincare *m, struct libmlg_cycle *c)
{
  static const int rate[2] = { DPSI, DDELTA }, angle[2] = { PSI, DELTA };
  double *const most[2] = { &c->psi, &c->delta };

  libmlg_run_start(m->run, m->par, c->u);
  c->psi_least = c->psi_most = c->u[PSI];
  for (int k = 1; k < c->maxima && poincare_next(m); k++) {
    c->psi_least = fmin(c->psi_least, m->run->u[PSI]);
    c->psi_most = fmax(c->psi_most, m->run->u[PSI]);
  }
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

/* Settles for so long, to a maximum of psi; else 0, why and, where it is at rest, that. */
static int settle_for(const struct poincare *m, double settle, double before, struct libmlg_cycle *c)
{
  int on;

  do {
    on = poincare_next(m);
    if (poincare_size(m, m->run->u) < 1e-7 * before || (!on && fabs(m->run->u[PSI]) < m->gap)) {
      c->why = "the oscillation dies out";
      c->motion.kind = LIBMLG_DIES_OUT;
      return 0;
    }
  } while (on && m->run->t < settle);
  c->why = "psi has no maximum for 20 s";
  return on;
}

static const char *why_not(enum libmlg_motion_kind kind)
{
  switch (kind) {
  case LIBMLG_DIES_OUT: return "the oscillation dies out";
  case LIBMLG_SETTLING: return "the oscillation still settles";
  case LIBMLG_QUASI_PERIODIC: return "the oscillation is quasi-periodic, a torus";
  case LIBMLG_IRREGULAR: return "the oscillation is irregular";
  default: return "the oscillation is not periodic, and what it is was not found out";
  }
}

static int is_lasting(enum libmlg_motion_kind kind)
{
  return kind == LIBMLG_QUASI_PERIODIC || kind == LIBMLG_IRREGULAR;
}

static int steps_are_used_up(const struct libmlg_run *run)
{
  return run->most_steps > 0 && run->steps >= run->most_steps;
}

/* Newton's method from where the run is, with a period of so many maxima (0: none is seen). */
static int try_orbit(const struct poincare *m, int maxima, double before, struct libmlg_cycle *c)
{
  c->maxima = maxima;
  memcpy(c->u, m->run->u, sizeof c->u);
  if (maxima == 0) {
    c->why = "the oscillation is not periodic yet, or not at all";
    return 0;
  }
  if (newton(m, before, c))
    return 1;
  if (!steps_are_used_up(m->run)) /* where Newton's method went astray the integration may well have failed */
    m->run->error[0] = '\0';
  return 0;
}

/* The orbit that it settles on, watching it where need be. */
static int settled_orbit(const struct poincare *m, double before, struct libmlg_cycle *c)
{
  enum libmlg_motion_kind last = LIBMLG_UNDECIDED;
  double u[MOST];

  for (int round = 0; round < ROUNDS; round++) {
    memcpy(u, m->run->u, sizeof u);
    if (try_orbit(m, count_maxima(m, 0.02), before, c) && c->largest < 1.) {
      c->motion.kind = LIBMLG_PERIODIC;
      return 1;
    }
    libmlg_run_start(m->run, m->par, u);
    if (!poincare_watch(m, &c->motion))
      return 0;
    if (poincare_size(m, c->motion.u) < 1e-7 * before)
      c->motion.kind = LIBMLG_DIES_OUT;
    if (c->motion.maxima > MOST_MAXIMA && try_orbit(m, c->motion.maxima, before, c) && c->largest < 1.) {
      c->motion.kind = LIBMLG_PERIODIC;
      return 1;
    }
    libmlg_run_start(m->run, m->par, c->motion.u);
    if (c->motion.kind == LIBMLG_PERIODIC && try_orbit(m, c->motion.maxima, before, c))
      return 1; /* it stays there, whatever the differences say of its multipliers */
    if (c->motion.kind == LIBMLG_DIES_OUT || (c->motion.kind == last && is_lasting(last)))
      break;
    last = c->motion.kind; /* a transient may look like a torus or irregular: so twice running */
    if (round == ROUNDS - 1 && is_lasting(last))
      c->motion.kind = LIBMLG_UNDECIDED;
    libmlg_run_start(m->run, m->par, c->motion.u);
  }
  c->why = why_not(c->motion.kind);
  return 0;
}

int libmlg_cycle(struct libmlg_run *run, int layout, const double par[], const double start[], double settle,
                 struct libmlg_cycle *c)
{
  const double before = libmlg_oscillation_size(layout, start);
  struct poincare m;
  int found;

  if (poincare_begin(&m, run, layout, par) != 0)
    return LIBMLG_NONE;
  *c = (struct libmlg_cycle){ .motion = { .kind = LIBMLG_UNDECIDED } };
  run->error[0] = '\0';
  libmlg_run_start(run, par, start);
  libmlg_run_section(run, DPSI, -1);
  if (!settle_for(&m, settle, before, c))
    found = 0;
  else
    found = settle > 0. ? settled_orbit(&m, before, c) : try_orbit(&m, count_maxima(&m, 0.02), before, c);
  if (run->error[0]) { /* the integration failed */
    c->why = NULL;
    c->motion.kind = LIBMLG_UNDECIDED;
    found = 0;
  }
  if (!found)
    return LIBMLG_FAILED;
  measure(&m, c);
  return 0;
}
