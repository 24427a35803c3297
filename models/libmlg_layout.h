/* libmlg_layout.h - a layout as libmlg.c sees it; private to libmlg */
#ifndef LIBMLG_LAYOUT_H
#define LIBMLG_LAYOUT_H

#include "libmlg.h"

struct libmlg_layout {
  const char *name;
  int states;
  const struct libmlg_quantity *state;
  /* par, dfdp: AUTO's slots; f: the rates at u */
  void (*rhs)(const double par[], const double u[], double f[]);
  void (*jacobian)(const double par[], const double u[], const double f[], double dfdu[], double dfdp[]);
};

#endif
