/* poincare.h - the Poincare map of the maxima of psi; private to models/libmlg
 *
 * The section is psi' = 0 downwards.  Distances are relative to the size of the oscillation,
 * each state counted in libmlg_state_size().
 */
#ifndef LIBMLG_POINCARE_H
#define LIBMLG_POINCARE_H

#include "layout.h"

struct poincare {
  struct libmlg_run *run;
  const double *par;
  int n; /* states */
  double size[LIBMLG_MOST_STATES];
  double gap;        /* half-width of the sharp play of the torque links, rad, or 0 */
  double difference, difference_2; /* of states, relative, to one and to both sides, for its derivative */
};

/* Of a run that has begun; LIBMLG_NONE: no such layout. */
int poincare_begin(struct poincare *m, struct libmlg_run *run, int layout, const double par[]);

double poincare_size(const struct poincare *m, const double u[]);
double poincare_distance(const struct poincare *m, const double u[], const double v[]);

/* On to the next maximum of psi; 0 when there is none for 20 s, or the integration fails. */
int poincare_next(const struct poincare *m);

/* From the maximum u so many maxima on, to v, in *time s; 0 as poincare_next(). */
int poincare_image(const struct poincare *m, const double u[], int maxima, double v[], double *time);

/* Watches the run, which is at a maximum, for some hundred of them more: what is it doing?
 * 0 when the integration failed. */
int poincare_watch(const struct poincare *m, struct libmlg_motion *motion);

#endif
