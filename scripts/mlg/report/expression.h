/* expression.h - the reading of an expression of cell.h, word after word; private to cell.c and
 * expression.c */
#ifndef MLG_EXPRESSION_H
#define MLG_EXPRESSION_H

#include "cell.h"

/* Where the reading stands. */
struct reading {
  char **word;
  int at, words;
  struct text *why; /* a line, where it fails */
};

/* Each reads what begins at r->at and goes on past it; 0, CELL_MISSING or CELL_WRONG. */
int read_cell(struct reading *r, struct text *value);
int read_expression(struct reading *r, struct text *value);

/* "-", "over", "and", "<=", ")": a word at which a cell ends. */
int is_operator(const char *word);

#endif
