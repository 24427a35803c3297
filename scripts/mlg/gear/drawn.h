/* drawn.h - the device of a layout as a tree of its elements */
#ifndef MLG_DRAWN_H
#define MLG_DRAWN_H

enum kind { SPRING, DAMPER, INERTER, PARALLEL, SERIES };

struct part { /* a group has its parts, an element the text of its value */
  enum kind kind;
  const char *text;
  const struct part *a, *b;
};

struct drawn {
  const char *layout;
  struct part (*device)(void); /* its parts live as long as the program */
};

#endif
