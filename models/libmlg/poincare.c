/* poincare.c - the Poincare map of the maxima of psi; see poincare.h */
#include <math.h>
#include <string.h>

#include "poincare.h"

int poincare_begin(struct poincare *m, struct libmlg_run *run, int layout, const double par[])
{
  *m = (struct poincare){ .run = run, .par = par, .n = libmlg_states(layout) };
  m->gap = par[libmlg_parameter("corner")] > 0. ? 0. : par[libmlg_parameter("g_psi")];
  m->difference = fmax(1e-5, sqrt(libmlg_run_tolerance(run)));
  m->difference_2 = 0.5 * cbrt(libmlg_run_tolerance(run));
  for (int i = 0; i < m->n; i++)
    m->size[i] = libmlg_state_size(layout, i);
  return m->n < 0 ? LIBMLG_NONE : 0;
}

double poincare_size(const struct poincare *m, const double u[])
{
  double size = 1e-12;

  for (int i = 0; i < m->n; i++)
    size = fmax(size, fabs(u[i]) / m->size[i]);
  return size;
}

double poincare_distance(const struct poincare *m, const double u[], const double v[])
{
  double far = 0.;

  for (int i = 0; i < m->n; i++)
    far = fmax(far, fabs(u[i] - v[i]) / m->size[i]);
  return far / poincare_size(m, u);
}

int poincare_next(const struct poincare *m)
{
  const double end = m->run->t + 20.;
  int reached;

  do
    reached = libmlg_run_to(m->run, end);
  while (reached == LIBMLG_AT_LIMIT);
  return reached == LIBMLG_AT_SECTION;
}

int poincare_image(const struct poincare *m, const double u[], int maxima, double v[], double *time)
{
  libmlg_run_start(m->run, m->par, u);
  for (int i = 0; i < maxima; i++)
    if (!poincare_next(m))
      return 0;
  memcpy(v, m->run->u, (size_t)m->n * sizeof *v);
  *time = m->run->t;
  return 1;
}
