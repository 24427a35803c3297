/* layout.h - a layout as the library sees it; private to models/libmlg
 *
 * Inside the library parameters stand in AUTO's slots, par[MLG_SLOTS] with the
 * indices PAR_V, ... of models/mlg.h; libmlg.h gives them side by side.
 */
#ifndef LIBMLG_LAYOUT_H
#define LIBMLG_LAYOUT_H

#include <complex.h>

#include "libmlg.h"
#include "mlg.h"

struct libmlg_layout {
  const char *name;
  int states;
  const struct libmlg_quantity *state;
  /* dfdp: a column for each slot, or NULL; f: the rates at u */
  void (*rhs)(const struct libmlg_layout *l, const double par[], const double u[], double f[]);
  void (*jacobian)(const struct libmlg_layout *l, const double par[], const double u[], const double f[], double dfdu[],
                   double dfdp[]);
  double (*torque)(const struct libmlg_layout *l, const double par[], const double u[]); /* T_d, N m */
  struct network (*network)(const struct libmlg_layout *l, const double par[]); /* dynamic stiffness of the device */
  /* functions of the states that pass 0 at the corners of the laws; how many */
  int (*corners)(const struct libmlg_layout *l, const double par[], const double u[], double at[MLG_MOST_CORNERS]);
  int number; /* among the devices read from text (device_layout.c), 0 of a file's */
};

/* The layout of that number, or NULL; of those read from text alone. */
const struct libmlg_layout *libmlg_find(int layout);
const struct libmlg_layout *libmlg_find_device(int layout);

/* The slots of AUTO, from par[libmlg_parameters()]. */
void libmlg_slots(const double par[], double slots[MLG_SLOTS]);

/* The same as linear tools take them (mlg_at_rest of elements.h). */
void libmlg_slots_at_rest(const double par[], double slots[MLG_SLOTS]);

/* The eigenvalues of libmlg_eigenvalues(), at slots; how many, or LIBMLG_FAILED. */
int libmlg_spectrum(const struct libmlg_layout *l, const double slots[], double re[], double im[]);

/* The mode whose eigenvalue is nearest to re + i im, at slots, with its eigenvectors
 * unless NULL; 0 or LIBMLG_FAILED. */
int libmlg_mode_near(const struct libmlg_layout *l, const double slots[], double re, double im,
                     struct libmlg_mode *mode, double _Complex right[], double _Complex left[]);

/* The rtol of libmlg_run_begin(). */
double libmlg_run_tolerance(const struct libmlg_run *run);

/* libmlg_criticality() of any right-hand side that has the states of a gear. */
int libmlg_normal_form(const struct libmlg_layout *l, const double slots[], double omega,
                       struct libmlg_mode *mode, double *a);

/* libmlg_fifth_order() likewise. */
int libmlg_fifth_order_of(const struct libmlg_layout *l, const double slots[], double omega, struct libmlg_mode *mode,
                          double *a, double *a_5);

#endif
