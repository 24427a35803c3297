/* description.h - a sweep: what varies, and what is asked of each case
 *
 * Read from a file of lines KEY = VALUE (docs/sweeps.md).  A case is one choice of a value
 * for every axis; cases are numbered from 1, the last axis of the file fastest, so that a
 * number means the same case wherever and whenever it is computed.
 */
#ifndef MLG_DESCRIPTION_H
#define MLG_DESCRIPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "command.h"

enum { MOST_AXES = 48, MOST_STEPS = 16, MOST_WORDS = 64, MOST_COLUMNS = 32, VALUE_SIZE = 128 };

enum axis_kind {
  AXIS_LIST,  /* texts, each a value: a list, or a column of a table of cases */
  AXIS_STEPS, /* from, to, equal steps or ratios */
  AXIS_SAMPLE /* from, to, at the points of a sequence of low discrepancy */
};

struct axis {
  char *name;
  const char *given;  /* its value in the description, for messages */
  int line;
  enum axis_kind kind;
  int dimension;      /* of the sweep; all of a sample, or of a table, have the same one */
  double from, to;
  bool ratios;        /* equal ratios, not differences */
  int coordinate;     /* of the sample */
  char **text;        /* of a list */
};

/* A column of an answer that is kept, and its name in the table. */
struct column { char *name, *as; };

enum rows_kind { ROWS_ALL, ROWS_FIRST, ROWS_LAST, ROWS_LARGEST, ROWS_LEAST };

/* A command of mlg; its output is an answer, or nothing is made of it. */
struct step {
  bool asks;
  int line;
  const struct command *command;
  bool again;             /* the command may be called again in a process */
  char *word[MOST_WORDS]; /* the first is the command; with {NAME} in them */
  int words;
  struct column keep[MOST_COLUMNS];
  int keeps, keep_line, rows_line;
  char *name[MOST_COLUMNS]; /* of the cells, where the command prints none */
  const char *unit[MOST_COLUMNS]; /* of these; NULL: not given */
  int names;
  enum rows_kind rows;
  char *rows_column;
  char *into;               /* the file, among the runs of the case, that its output goes into too; NULL: none */
  bool takes[MOST_AXES]; /* which axes its {parameters} stand for */
};

struct sweep {
  const char *file;
  const char *place; /* in a file that it names, for messages: "some.csv:3, column e"; NULL: none */
  struct axis axis[MOST_AXES];
  int axes;
  long long count[MOST_AXES]; /* of each dimension, the last fastest */
  int dimensions;
  int sample_dimension, table_dimension; /* -1: none */
  long long sample;                      /* its number of points, 0: none asked for */
  int sample_line, gear_line;
  int coordinates;                       /* sampled axes */
  uint64_t stride[MOST_AXES];            /* of each coordinate, in 2^-64 */
  long long cases;
  struct step step[MOST_STEPS];
  int steps;
  char *gear, *table;  /* files, NULL: none */
  double time_limit;   /* of a case, s; 0: none */
  long memory_limit;   /* of a process, MB; 0: none */
  long long block;     /* cases in a block; 0: as timed */
  bool keeps_files;    /* of the runs of AUTO */
};

/* Reads and checks a description.  A slip ends the program with one line
 * "FILE:LINE: 'VALUE': what would be right" and status 2; of a value in a file that it
 * names "FILE:LINE: PLACE: 'VALUE': ...". */
void read_sweep(const char *file, struct sweep *sweep);

/* That line; LINE 0: of the file as a whole. */
_Noreturn void slip(const struct sweep *sweep, int line, const char *value, const char *right, ...)
  __attribute__((format(printf, 4, 5)));

/* A text without the mark that Windows begins files with (UTF-8's BOM). */
char *behind_mark(char *text);

/* --- axes.c --------------------------------------------------------------------------- */

/* A line NAME = VALUES.  Dimensions are numbered as they come. */
void add_axis(struct sweep *sweep, const char *name, const char *values, int line);

/* A new name that varies, GIVEN there, or a slip. */
struct axis *new_axis(struct sweep *sweep, const char *name, const char *given, int line);
int new_dimension(struct sweep *sweep, long long count);

/* A slip unless this value may stand behind that name. */
void check_value(const struct sweep *sweep, const char *name, const char *value, int line);

/* casefile.c: the columns of a table of cases. */
void add_table(struct sweep *sweep, const char *file, int line);

/* What only the whole description tells: the number of cases, the values at the ends. */
void settle_axes(struct sweep *sweep);

/* The value of an axis at the case n, 1 to sweep->cases, as it stands in words and tables. */
const char *axis_value(const struct sweep *sweep, int axis, long long n, char buffer[VALUE_SIZE]);

/* Whether an axis has more than one value. */
bool varies(const struct sweep *sweep, int axis);

int find_axis(const struct sweep *sweep, const char *name, size_t length); /* -1: none */

/* Whether a name is one that the words of mlg take as NAME=VALUE of the gear. */
bool is_parameter(const char *name);

/* Its unit; NULL: it is none, or has none. */
const char *parameter_unit(const char *name);

/* --- words.c -------------------------------------------------------------------------- */

/* A line do = WORDS or ask = WORDS; then keep, names and rows of the last ask, or into of
 * either. */
void add_step(struct sweep *sweep, bool asks, const char *words, int line);
void add_keep(struct sweep *sweep, const char *columns, int line);
void add_names(struct sweep *sweep, const char *names, int line);
void add_rows(struct sweep *sweep, const char *rows, int line);
void add_into(struct sweep *sweep, const char *file, int line);

/* Every {NAME} is known, every axis is used, every question keeps something. */
void settle_steps(struct sweep *sweep);

/* The words of a step for the case n, in *room, which grows; argv[argc] is NULL.
 * Returns argc. */
struct words { char *text; size_t room; char *argv[MOST_WORDS + MOST_AXES + 2]; };
int fill_words(const struct sweep *sweep, const struct step *step, long long n, struct words *words);

#endif
