/* drawn.h - the device of each layout as a tree of its elements (part.h) */
#ifndef MLG_DRAWN_H
#define MLG_DRAWN_H

#include "part.h"

struct drawn {
  const char *layout;
  struct part (*device)(void); /* its parts live as long as the program */
};

/* That of the layout of this name, in libmlg, or NULL. */
const struct drawn *drawn_of(const char *layout);

/* A drawing of the tree, one line above another, in a box of this size, px, its left end at
 * (x, y), stretched to width. */
struct drawn_size { double width, over, under; };

struct drawn_size drawn_size(const struct part *tree);
void draw_part(const struct part *tree, double x, double y, double width);

#endif
