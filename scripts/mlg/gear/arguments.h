/* arguments.h - what follows a command of mlg: LAYOUT [NAME=VALUE ...]
 *
 *   LAYOUT      the name of one in models/, or a network as text, "k_s-(k_d|c_d|b)"
 *               (docs/networks.md)
 *   NAME=VALUE  a parameter of models/mlg.h, SI units and radians, within its range.
 *               k_s=inf is rigid; compliance=X is k_s = 1e5/X, 0 rigid; F_z=X is the
 *               M that makes the static load (M + m_D) g = X N
 *   gear=FILE   the values of a gear file (gearfile.h) for what is not given by name
 *   V_top=X     the top of the operating range, 200 m/s
 *
 * A command may have options of its own in the same form.  A name given twice, a name
 * that is none, a value outside its range, and a parameter that the device of the layout
 * does not have (unless it is a rigid k_s or b = 0) end the program with one line
 * "mlg COMMAND: 'WORD': what would be right" on standard error and status 2.
 */
#ifndef MLG_ARGUMENTS_H
#define MLG_ARGUMENTS_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "libmlg.h"
#include "mlg.h"

/* NUMBER_V, NUMBER_C_D, ...: numbers of the parameters in libmlg's par[]. */
enum parameter_number {
#define X(slot, id, name, unit, value, least, most, meaning) NUMBER_##id,
  MLG_PARAMETERS(X)
#undef X
  NUMBERS
};

/* NAME=VALUE of a command beside parameters; a list ends with the name NULL. */
struct option {
  const char *name, *unit; /* "": a count, a whole number */
  double least, most;
  double value;     /* the default, until it is given */
  const char *word; /* that gave it, or NULL */
};

struct arguments {
  const char *command;                      /* its name, for messages */
  int layout;                               /* of libmlg */
  double par[LIBMLG_MOST_PARAMETERS];       /* of libmlg */
  const char *word[LIBMLG_MOST_PARAMETERS]; /* that gave each; NULL: the default, or a gear file's */
  double V_top;                             /* m/s */
  const char *V_top_word, *F_z_word, *gear_word;
  double F_z;
  struct option *option;
};

/* All of argv[1], the layout, and argv[2], ...: begin, take each, end. */
void read_arguments(struct arguments *a, int argc, char *argv[], struct option option[]);

/* The same in steps, for a command that has words of another form among them:
 * defaults and the layout argv[1]; one word; what only all words together say. */
void begin_arguments(struct arguments *a, int argc, char *argv[], struct option option[]);
void take_word(struct arguments *a, const char *word);
void end_arguments(struct arguments *a);

/* What word gives to the name that is its first length characters: checked as above. */
void take_value(struct arguments *a, const char *word, size_t length, double value);

/* Another value for a name that this word has given, once the arguments have ended. */
void retake_value(struct arguments *a, const char *word, size_t length, double value);

/* A word NAME=FROM:TO:N, N values from FROM to TO; text is the word. */
struct range { const char *text; double from, to; int n; };

/* Reads one, FROM below TO and N from 2 to a million, and gives TO to its name; or refuses it. */
struct range take_range(struct arguments *a, const char *text);

/* How long NAME is. */
size_t range_name_length(const struct range *r);

/* Refuses a parameter that was given although the command varies it. */
void refuse_given(const struct arguments *a, enum parameter_number n, const char *right);

/* One line "mlg COMMAND: 'WORD': RIGHT", status 2. */
_Noreturn void refuse(const char *command, const char *word, const char *right, ...)
  __attribute__((format(printf, 3, 4)));

/* One line "mlg COMMAND: TEXT" with that status. */
_Noreturn void fail(const char *command, int status, const char *text, ...)
  __attribute__((format(printf, 3, 4)));

/* One line "FILE:LINE: TEXT", or "FILE: TEXT" at line 0, status 2. */
_Noreturn void refuse_file(const char *file, int line, const char *text, va_list values);

/* Whether text is a finite decimal number and nothing else. */
bool is_number(const char *text, double *value);

/* A value within the range of what is called so, or refused. */
double in_range(const char *command, const char *word, const char *unit, double least, double most,
                double value);

/* The status to end with: MLG_FAILED, and a line, when not all of the output could be
 * written. */
int output_status(const char *command);

#endif
