/* evaluate.h - the commands of one case of a sweep, and what they answer */
#ifndef MLG_EVALUATE_H
#define MLG_EVALUATE_H

#include <stdatomic.h>
#include <stdbool.h>
#include <sys/types.h>

#include "answer.h"
#include "description.h"
#include "record.h"

struct evaluator {
  const struct sweep *sweep;
  const char *scratch; /* folder of the runs, in MLG_RUNS */
  bool makes_runs;
  int complaints;      /* file of standard error */
  atomic_int *step;    /* which command is at work, from 1 */
  FILE *output;        /* standard output while a command is called */
  char *printed;       /* what it wrote there */
  size_t room;
  struct answer answer;
  struct words words;
  struct text why;     /* of the last failure */
  struct text unit[MOST_STEPS]; /* of the columns of each question, see unitline.h */
  bool has_units[MOST_STEPS];   /* whether it has printed their names yet */
  struct text units;            /* all of them */
};

/* Makes this process one that evaluates: it ends with its parent, has no more memory than
 * the sweep allows, and its standard error goes to complaints.  False: it cannot. */
bool begin_evaluator(struct evaluator *e, const struct sweep *sweep, const char *scratch, int complaints, pid_t parent,
                     atomic_int *step);

/* The record of case n; its text lasts until the next. */
void evaluate(struct evaluator *e, long long n, struct record *record);

/* Whether every question has told the units of its columns; then e->units has them. */
bool units_known(struct evaluator *e);

/* The first line of the complaints, without what would break a table, and no longer than
 * fits into one. */
void first_complaint(int complaints, struct text *text);

#endif
