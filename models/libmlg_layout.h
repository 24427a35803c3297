/* libmlg_layout.h - a layout as libmlg.c sees it; private to libmlg */
#ifndef LIBMLG_LAYOUT_H
#define LIBMLG_LAYOUT_H

#include "libmlg.h"

struct libmlg_layout {
  const char *name;
  int states;
  const struct libmlg_quantity *state;
  void (*rhs)(const double par[], const double u[], double f[]); /* par: AUTO's slots */
};

#endif
