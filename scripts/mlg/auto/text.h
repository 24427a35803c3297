/* text.h - texts that grow, files read whole, and the names of runs
 *
 * What a function here cannot do it says in a struct text of its caller, in one
 * line without the line's end; no function prints or ends the program.
 */
#ifndef MLG_TEXT_H
#define MLG_TEXT_H

#include <stddef.h>
#include <stdio.h>

/* A text that grows; start with TEXT_NONE, end with text_free.  at is always a
 * string, length its length. */
struct text { char *at; size_t length, room; };

#define TEXT_NONE { NULL, 0, 0 }

/* Adds to the end as printf would.  Without memory the program ends, status 1. */
void text_add(struct text *text, const char *format, ...)
#ifdef __GNUC__
  __attribute__((format(printf, 2, 3)))
#endif
  ;

/* Adds length bytes as they are. */
void text_append(struct text *text, const char *bytes, size_t length);

/* Empties the text and keeps its memory. */
void text_clear(struct text *text);

void text_free(struct text *text);

/* malloc, realloc: without memory the program ends with one line, status 1. */
void *must_allocate(size_t size);
void *must_resize(void *block, size_t size);

/* The bytes of a regular file into *text, replacing what it held.  Returns 0, or
 * -1 with the reason in why ("FILE: No such file or directory"). */
int read_file(const char *file, struct text *text, struct text *why);

/* Writes bytes to file.new and moves it to file: neither a full disk nor a stop
 * leaves half a file.  Returns 0, or -1 with the reason in why. */
int write_file(const char *file, const char *bytes, size_t length, struct text *why);

/* Prints "WHO: WHAT" on standard error as one line, whatever it quotes; WHO may be NULL. */
void say_line(const char *who, const char *what);

/* Whether name may be that of a run, a figure or a table: letters, digits, and
 * . _ - + after a letter or a digit, at most 100 of them. */
int is_name(const char *name);

/* What is_name wants, for messages. */
#define NAME_RULE "letters, digits, . _ - and +, a letter or a digit first, at most 100"

/* A whole number within least..most and nothing else; 1 when text is one. */
int whole_number(const char *text, long least, long most, long *value);

/* The checkout that holds this program as build/bin/mlg, with a slash behind it, and
 * "" when it is the folder that the program was started in.  MLG_ROOT names another. */
const char *checkout(void);

/* The folder of the runs: MLG_RUNS, or build/runs of the checkout. */
const char *runs_folder(void);

#endif
