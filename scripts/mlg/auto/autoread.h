/* autoread.h - what autofile.c and autostability.c share; see autofile.h */
#ifndef MLG_AUTOREAD_H
#define MLG_AUTOREAD_H

#include "autofile.h"

enum { WRAP = 9999 }; /* AUTO's numbers of points begin with 1 again behind it */

/* A text being read line by line, and where a complaint goes. */
struct reader {
  const char *file, *at, *end;
  long line; /* number of the line at hand */
  struct text *why;
};

/* "FILE:LINE: what" into why; returns -1. */
int reader_refuse(const struct reader *r, const char *what);

/* The next line, without its end.  0 when there is none. */
int reader_line(struct reader *r, const char **start, size_t *length);

/* The whole number that stands alone in the places from..to of a line; 0 for none. */
int reader_number(const char *line, size_t length, size_t from, size_t to, long *value);

/* The line of the first zero byte, which no file of AUTO's has, or 0. */
long reader_zero(const struct text *text);

/* Gives the points of b. what d. says of them.  Returns 0 or -1 with a line in why. */
int read_stability(struct af_branches *all, const char *file, const struct text *text, struct text *why);

#endif
