/* grid.h - a row for each gear of one or two ranges NAME=FROM:TO:N of a command */
#ifndef MLG_GRID_H
#define MLG_GRID_H

#include "arguments.h"

enum { MOST_RANGES = 2 };

struct grid {
  struct arguments *a;
  struct range range[MOST_RANGES];
  int ranges;
  double value[MOST_RANGES];
};

/* A word of the command: a range, or what take_word() takes. */
void grid_word(struct grid *g, const char *word);

/* Refuses what the ends of the ranges would make of the gear, before anything is printed. */
void grid_check(struct grid *g);

/* The names of the ranges, a comma behind each. */
void grid_head(const struct grid *g);

/* For each gear, the last range innermost, prints the values and calls point, which prints
 * the rest of the row; fresh, where not NULL, before each round of the innermost range. */
void grid_rows(struct grid *g, void point(void *data), void fresh(void *data), void *data);

#endif
