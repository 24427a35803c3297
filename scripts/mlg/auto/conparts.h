/* conparts.h - what the parts of the constants checker share; see constants.h */
#ifndef MLG_CONPARTS_H
#define MLG_CONPARTS_H

#include <setjmp.h>

#include "constants.h"

enum { MOST_ENTRIES = 128, AUTO_LINE = 2048 /* what AUTO reads of a constant, characters */ };

/* Who gave a value: who stands later here goes before. */
enum source { OF_FILE, OF_GEAR, OF_WORD };

/* One KEY = VALUE. */
struct entry { const char *key, *value; int line; enum source source; };

/* One element of a list (key "") or of a dictionary, quotes removed. */
struct item { const char *key, *value; };
struct items { struct item *item; int n; };

/* One of PAR: key as written, name as in parnames or models/mlg.h. */
struct parameter { const char *key, *name, *value, *file; int line; enum source source; };

/* The constants of one file. */
struct entries {
  const char *file;
  struct entry entry[MOST_ENTRIES];
  int n;
};

struct constants {
  const char *file;
  struct entries own;
  struct parameter *par;
  int pars;
  void **block; /* of memory, all freed in the end */
  int blocks;
  jmp_buf refused;
  struct text *why;
};

/* Ends hand_over with "FILE:LINE: ..." in one line; line 0: "FILE: ...". */
_Noreturn void bad_input(struct constants *c, const char *file, int line, const char *format, ...)
#ifdef __GNUC__
  __attribute__((format(printf, 4, 5)))
#endif
  ;

/* Memory that lives as long as c. */
void *keep(struct constants *c, size_t size);
char *keep_text(struct constants *c, const char *text, size_t length);

/* Reads the constants of a file into to. */
void parse_constants(struct constants *c, const char *file, struct entries *to);

/* The end of the value at t: past its closing bracket or quote, or at the blank, comma
 * or line end behind it.  NULL: brackets or quotes stay open. */
const char *value_end(const char *t, int *lines);

/* Sets an entry of c->own, a new one at the end.  get_entry: NULL when there is none. */
void set_entry(struct constants *c, const char *key, const char *value, int line, enum source source);
const struct entry *get_entry(const struct entries *entries, const char *key);

/* Splits a list [a, b] or a dictionary {k: v, k: v}; a lone value is a list of one. */
struct items split(struct constants *c, const struct entry *e);

/* Whether key is a constant that AUTO knows. */
int is_constant(const char *key);

/* The checks of conchecks.c, once everything is in place. */
void check_constants(struct constants *c, const struct constants_use *use);

/* The name that a slot has in parnames or in models/mlg.h; text itself when it is none. */
const char *name_of(struct constants *c, const char *text);

#endif
