/* command.h - what the commands of mlg are to its main program
 *
 * Each command stands in a file of its own kind (points.c, judge.c, ...) and is
 * listed in main.c.  argv[0] is the command's name, argv[1] what follows it.
 */
#ifndef MLG_COMMAND_H
#define MLG_COMMAND_H

#include <stdbool.h>

/* Exit status of every command. */
enum { MLG_OK, MLG_FAILED, MLG_BAD_INPUT };

struct command {
  const char *name;               /* "intervals" */
  const char *usage;              /* "LAYOUT [NAME=VALUE ...]", what follows the name */
  const char *summary;            /* one line for `mlg help` */
  const char *details;            /* for `mlg help COMMAND`: arguments, columns with units */
  int (*run)(int argc, char *argv[]); /* returns an exit status */
};

/* The command of that name, or NULL. */
const struct command *find_command(const char *name);

/* Whether it keeps nothing, so that one process may call it again and again (mlg cases). */
bool is_repeatable(const struct command *command);

#endif
