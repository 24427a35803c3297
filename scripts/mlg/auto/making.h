/* making.h - a run that is made, judged and put in its place; private to mlg run */
#ifndef MLG_MAKING_H
#define MLG_MAKING_H

#include <time.h>

#include "text.h"

/* What was asked for, and where it will be. */
struct request {
  const char *name, *constants, *from, *model;
  char **word;                     /* for the constants */
  int words;
  char **expected;
  int n_expected;
  char *file, *layout, *program;   /* the constants file; "l1"; "l1.boundary" */
  char *exe, *folder, *part, *start;
  struct text text;                /* the constants as AUTO gets them */
  int orbit;                       /* start is an orbit's file, AUTO's dat */
  struct timespec began;
};

/* The four texts as one, for free(). */
char *joined(const char *a, const char *b, const char *c, const char *d);

/* Makes the run when it is not up to date, says what it found or why it failed, and
 * returns the command's status. */
int make_if_needed(const struct request *r);

#endif
