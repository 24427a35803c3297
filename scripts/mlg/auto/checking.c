/* checking.c - mlg constants: an AUTO constants file with values handed over */
#include <string.h>

#include "libmlg.h"
#include "command.h"
#include "constants.h"

/* The layout in the name c.LAYOUT.RUN of a file, if there is one of that name. */
static const char *layout_of(const char *file, char room[32])
{
  const char *name = strrchr(file, '/') ? strrchr(file, '/') + 1 : file;
  size_t n;

  if (strncmp(name, "c.", 2) != 0)
    return NULL;
  n = strcspn(name + 2, ".");
  if (n == 0 || n >= 32)
    return NULL;
  memcpy(room, name + 2, n);
  room[n] = '\0';
  return libmlg_layout(room) != LIBMLG_NONE ? room : NULL;
}

static int run(int argc, char *argv[])
{
  struct text out = TEXT_NONE, why = TEXT_NONE;
  struct constants_use use = { NULL, 0, 0 };
  char room[32];
  int status;

  if (argc < 2) {
    fputs("usage: mlg constants FILE [layout=LAYOUT] [gear=FILE] [NAME=VALUE ...]\n", stderr);
    return MLG_BAD_INPUT;
  }
  use.layout = layout_of(argv[1], room);
  use.boundary = strncmp(strrchr(argv[1], '/') ? strrchr(argv[1], '/') + 1 : argv[1], "c.boundary.", 11) == 0;
  for (int i = 2; i < argc; i++)
    if (strncmp(argv[i], "layout=", 7) == 0 && libmlg_layout(argv[i] + 7) != LIBMLG_NONE)
      use.layout = argv[i] + 7;
  status = hand_over(argv[1], argv + 2, argc - 2, &use, &out, &why);
  if (status == 0)
    fputs(out.at ? out.at : "", stdout);
  else
    say_line(NULL, why.at);
  text_free(&out);
  text_free(&why);
  return status;
}

const struct command command_constants = {
  "constants", "FILE [layout=LAYOUT] [gear=FILE] [NAME=VALUE ...]",
  "an AUTO constants file, checked, with values handed over",
  "Prints FILE as AUTO reads it, a constant a line, with each NAME set to VALUE: an AUTO\n"
  "constant (DS=-0.1) or a parameter (c_d=5e3, goes into PAR; k_s=inf is rigid; F_z stands\n"
  "for the M with that load).  PAR={...} adds to the file's.  gear=FILE sets the parameters\n"
  "of that file, where a value may have its unit behind it.  Words go before a gear, a gear\n"
  "before the file.  layout=LAYOUT makes a file of another layout one of that layout.\n"
  "Status 2 and one line at a slip that AUTO would pass over: an unknown or repeated\n"
  "constant, name or parameter, a value out of range or of a wrong form, a parameter that\n"
  "the layout's device does not have.\n",
  run,
};
