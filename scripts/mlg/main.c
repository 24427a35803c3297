/* main.c - mlg: the commands of the landing gear and of its runs */
#include <stdio.h>
#include <string.h>

#include "command.h"

extern const struct command command_at, command_constants, command_crossing, command_judge, command_orbit, command_peak, command_point,
  command_points, command_rows, command_run, command_shimmy, command_table, command_widths;

static const struct command *const commands[] = {
  &command_at, &command_constants, &command_crossing, &command_judge, &command_orbit, &command_peak, &command_point,
  &command_points, &command_rows, &command_run, &command_shimmy, &command_table, &command_widths,
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static int help(const char *name)
{
  for (int i = 0; name && i < COMMANDS; i++)
    if (strcmp(name, commands[i]->name) == 0) {
      printf("mlg %s %s\n\n%s\n", name, commands[i]->usage, commands[i]->details);
      return MLG_OK;
    }
  for (int i = 0; i < COMMANDS; i++)
    printf("  mlg %-10s %s\n", commands[i]->name, commands[i]->summary);
  return MLG_OK;
}

int main(int argc, char *argv[])
{
  int status = MLG_BAD_INPUT;

  if (argc > 1 && strcmp(argv[1], "help") == 0)
    return help(argv[2]);
  for (int i = 0; argc > 1 && i < COMMANDS; i++)
    if (strcmp(argv[1], commands[i]->name) == 0) {
      status = commands[i]->run(argc - 1, argv + 1);
      if (fflush(stdout) != 0 || ferror(stdout)) {
        perror(argv[1]);
        status = status == MLG_OK ? MLG_FAILED : status;
      }
      return status;
    }
  fprintf(stderr, "mlg: %s%s%s; mlg help lists the commands\n", argc > 1 ? "'" : "no command", argc > 1 ? argv[1] : "",
          argc > 1 ? "' is none" : "");
  return status;
}
