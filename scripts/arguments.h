/* arguments.h - numbers and NAME=VALUE on the command line of our programs
 *
 * A slip ends the program: one line "PROGRAM: 'WORD': what would be right" on
 * standard error, status 2; an output that cannot be written with status 1.
 */
#ifndef MLG_ARGUMENTS_H
#define MLG_ARGUMENTS_H

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether text is a finite decimal number and nothing else. */
static inline int is_number(const char *text, double *value)
{
  char *end;

  *value = strtod(text, &end);
  return end != text && *end == '\0' && isfinite(*value) && !strpbrk(text, "xXpPnN");
}

static inline _Noreturn void refuse(const char *program, const char *word, const char *right)
{
  fprintf(stderr, "%s: '%s': %s\n", program, word, right);
  exit(2);
}

/* The number behind the = of word; *length is that of the name before it. */
static inline double number_of(const char *program, const char *word, size_t *length)
{
  const char *equals = strchr(word, '=');
  double value;

  if (!equals || !is_number(equals + 1, &value))
    refuse(program, word, "expected NAME=NUMBER");
  *length = (size_t)(equals - word);
  return value;
}

/* value, which word gives to p, if it is within the range of p. */
static inline double in_range(const char *program, const char *word, const struct mlg_parameter *p,
                              double value)
{
  char right[80];

  if (!mlg_in_range(p, value)) {
    snprintf(right, sizeof right, "outside its range, %g to %g %s", p->least, p->most, p->unit);
    refuse(program, word, right);
  }
  return value;
}

/* Sets the parameter that word names, of models/mlg.h or compliance (1e5/k_s; 0
 * is rigid), and returns its slot. */
static inline int set_parameter(const char *program, double par[], const char *word)
{
  static const struct mlg_parameter compliance = { PAR_K_S, "compliance", "1e-5 rad/(N m)", 0., 1e5 };
  size_t length;
  double value = number_of(program, word, &length);
  const struct mlg_parameter *p = mlg_find(word, length);

  if (length == strlen(compliance.name) && memcmp(word, compliance.name, length) == 0)
    p = &compliance;
  if (!p)
    refuse(program, word, "no such parameter (see models/mlg.h)");
  value = in_range(program, word, p, value);
  par[p->slot] = p == &compliance ? 1e5 / value : value;
  return p->slot;
}

/* The same for a program that looks over the whole plane (V, c_d). */
static inline void set_beside_axes(const char *program, double par[], const char *word)
{
  const int slot = set_parameter(program, par, word);

  if (slot == PAR_V || slot == PAR_C_D)
    refuse(program, word, "V and c_d are the axes; give other parameters");
}

/* The status to end with: 1 when not all of the output could be written. */
static inline int output_status(const char *program)
{
  if (fflush(stdout) == 0 && !ferror(stdout))
    return 0;
  fprintf(stderr, "%s: cannot write the output: %s\n", program, strerror(errno));
  return 1;
}

#endif
