/* csv.h - the tables of results/: lines that begin with '#', a line of names, rows
 *
 * A cell holds no comma and no quote, so none is looked for.
 */
#ifndef MLG_CSV_H
#define MLG_CSV_H

#include "text.h"

struct csv {
  char *file;
  struct text text;   /* of the file, cut into cells */
  int columns, rows;
  char **cell;        /* the names, then row after row */
};

/* Reads a table and notes its use (uses.h).  Returns 0, or -1 with a line in why: it cannot
 * be read, has no names, or a row has another number of cells than there are names. */
int csv_read(const char *file, struct csv *table, struct text *why);

void csv_free(struct csv *table);

/* The number of a column, or -1. */
int csv_column(const struct csv *table, const char *name);

const char *csv_name(const struct csv *table, int column);
const char *csv_cell(const struct csv *table, int row, int column);

/* The same as a number, NaN when it is none. */
double csv_number(const struct csv *table, int row, int column);

/* NAME=VALUE, or another of = != < <= > >= between them: which rows are meant; where= may
 * stand before it.  Two numbers are compared as numbers, equal to 1e-12, all else as texts:
 * VALUE may have the shell's * ? [] and be one of several, NAME=A|B*.  NAME%N is the rest
 * of a division by N. */
struct condition {
  int column;
  char relation[3];
  const char *value; /* within the word it was read from */
  double modulus;    /* 0: none */
};

/* Whether a word looks like a condition. */
int is_condition(const char *word);

/* Returns 0, or -1 with a line in why: the table has no such column, N is no number. */
int read_row_condition(const struct csv *table, const char *word, struct condition *condition, struct text *why);

int fits_condition(const struct csv *table, int row, const struct condition *condition);

/* The first row from `row` on that all conditions fit, or -1. */
int next_fitting(const struct csv *table, int row, const struct condition condition[], int conditions);

/* Whether all of text is a number; *value gets it. */
int csv_is_number(const char *text, double *value);

/* Whether a row has numbers above `least` (so no NaN) in these columns.  Returns 0, or -1 with a
 * line in why that names the file, the cell and its column. */
int csv_needs_numbers(const struct csv *table, int row, const int column[], int columns, double least, struct text *why);

#endif
