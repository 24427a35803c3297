/* layout.h - a layout as libmlg.c sees it; private to libmlg */
#ifndef LIBMLG_LAYOUT_H
#define LIBMLG_LAYOUT_H

#include "libmlg.h"
#include "network.h"

enum { LIBMLG_SLOTS = 36 }; /* AUTO's par[] */

struct libmlg_layout {
  const char *name;
  int states;
  const struct libmlg_quantity *state;
  /* par, dfdp: AUTO's slots; f: the rates at u */
  void (*rhs)(const double par[], const double u[], double f[]);
  void (*jacobian)(const double par[], const double u[], const double f[], double dfdu[], double dfdp[]);
  struct network (*network)(const double par[]); /* the device with k_psi */
};

/* NULL: no such layout */
const struct libmlg_layout *libmlg_find(int layout);

/* AUTO's slots from par[libmlg_parameters()]. */
void libmlg_into_slots(const double par[], double slots[LIBMLG_SLOTS]);

#endif
