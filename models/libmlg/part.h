/* part.h - a device as a tree of its elements; private to models/libmlg and the commands */
#ifndef LIBMLG_PART_H
#define LIBMLG_PART_H

enum part_kind { SPRING, DAMPER, INERTER, PARALLEL, SERIES };

/* A group has its two parts, an element its value: that of par[slot], or where that is
 * below 0 the number itself. */
struct part {
  enum part_kind kind;
  const char *text; /* of an element: the name of its parameter, else as it is written */
  int slot;
  double value;
  const struct part *a, *b;
};

#endif
