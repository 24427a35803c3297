/* arguments.h - NAME=VALUE on the command line of scan and curves */
#ifndef MLG_ARGUMENTS_H
#define MLG_ARGUMENTS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sets the parameter that text names, of models/mlg.h or compliance (1e5/k_s; 0
 * is rigid).  A slip ends the program: one line, status 2. */
static void set_parameter(const char *program, double par[], const char *text)
{
  static const struct { const char *name; int slot; char range; } names[] = {
#define X(slot, id, name, unit, value, range, meaning) { name, PAR_##id, range },
    MLG_PARAMETERS(X)
#undef X
    { "compliance", -1, '0' },
  };
  const char *equals = strchr(text, '=');
  const size_t length = equals ? (size_t)(equals - text) : 0;
  char *end;
  const double value = equals ? strtod(equals + 1, &end) : 0.;

  if (!equals || end == equals + 1 || *end || !isfinite(value)) {
    fprintf(stderr, "%s: '%s': expected NAME=NUMBER\n", program, text);
    exit(2);
  }
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    if (strlen(names[i].name) == length && memcmp(names[i].name, text, length) == 0) {
      if (names[i].range != '*' && !(value > 0. || (names[i].range == '0' && value >= 0.))) {
        fprintf(stderr, "%s: '%s': it must %s\n", program, text,
                names[i].slot == PAR_K_S ? "be above 0 (1e30 is rigid)"
                : names[i].range == '+' ? "be above 0" : "not be below 0");
        exit(2);
      }
      par[names[i].slot < 0 ? PAR_K_S : names[i].slot] = names[i].slot < 0 ? 1e5 / value : value;
      return;
    }
  fprintf(stderr, "%s: '%s': no such parameter (see models/mlg.h)\n", program, text);
  exit(2);
}

#endif
