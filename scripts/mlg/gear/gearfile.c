/* gearfile.c - reads a file of gear parameters and checks names, units and ranges */
#include "gearfile.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"

enum { MOST_BYTES = 1 << 16, MOST_TEXT = 80 };

/* What is being read: text is a string, at the place in it. */
struct reader { const char *file, *at; int line; };

static _Noreturn void slip(const struct reader *r, const char *format, ...)
{
  va_list values;

  va_start(values, format);
  refuse_file(r->file, r->line, format, values);
}

static const char *whole_text(const struct reader *r)
{
  static char text[MOST_BYTES + 1];
  FILE *f = fopen(r->file, "r");

  size_t n;

  if (!f)
    slip(r, "%s; expected a file of gear parameters", strerror(errno));
  n = fread(text, 1, MOST_BYTES, f);
  if (ferror(f))
    slip(r, "%s; expected a file of gear parameters", strerror(errno));
  fclose(f);
  if (n == MOST_BYTES)
    slip(r, "longer than %d bytes; not a file of gear parameters", MOST_BYTES);
  text[n] = '\0';
  if (strlen(text) != n)
    slip(r, "holds a zero byte; not a file of gear parameters");
  return text;
}

static void skip_blanks(struct reader *r)
{
  for (; isspace((unsigned char)*r->at); r->at++)
    r->line += *r->at == '\n';
}

static void skip_blanks_and_comments(struct reader *r)
{
  for (skip_blanks(r); *r->at == '#' || *r->at == '!'; skip_blanks(r))
    r->at += strcspn(r->at, "\n");
}

static void expect(struct reader *r, char c)
{
  skip_blanks(r);
  if (*r->at != c)
    slip(r, "expected '%c' and not '%.10s'; the form is PAR = {'name': value, ...}", c, r->at);
  r->at++;
}

/* What stands before one of the characters ends, without blanks and quotes around it. */
static void read_text(struct reader *r, const char *ends, char text[MOST_TEXT])
{
  skip_blanks(r);
  const char *from = r->at, *to = from + strcspn(from, ends);

  for (; r->at < to; r->at++)
    r->line += *r->at == '\n';
  while (from < to && (isspace((unsigned char)*from) || strchr("'\"", *from)))
    from++;
  while (to > from && (isspace((unsigned char)to[-1]) || strchr("'\"", to[-1])))
    to--;
  if (to - from >= MOST_TEXT)
    slip(r, "PAR: an element longer than %d characters", MOST_TEXT - 1);
  memcpy(text, from, (size_t)(to - from));
  text[to - from] = '\0';
}

static struct gear_value read_value(struct reader *r)
{
  char name[MOST_TEXT], value[MOST_TEXT];
  const struct libmlg_quantity *q;
  struct gear_value v;

  read_text(r, ":,}", name);
  v.parameter = libmlg_parameter(name);
  if (v.parameter == LIBMLG_NONE)
    slip(r, "PAR: '%s' is not a parameter (see models/mlg.h)%s", name,
         strcmp(name, "F_z") == 0 ? "; the load is M here, (M + m_D) g = F_z" : "");
  expect(r, ':');
  read_text(r, ",}", value);
  v.line = r->line;
  q = libmlg_parameter_quantity(v.parameter);
  char *unit = value + strcspn(value, " \t\n");

  if (*unit) {
    *unit++ = '\0';
    unit += strspn(unit, " \t\n");
    if (strcmp(unit, q->unit) != 0)
      slip(r, "PAR: %s is in %s here; it has to be in %s", name, unit, q->unit);
  }
  if (!is_number(value, &v.value))
    slip(r, "%s = %s is not a finite number", name, value);
  if (!(v.value >= libmlg_least(v.parameter) && v.value <= libmlg_most(v.parameter)))
    slip(r, "%s = %s %s is outside its range, %g to %g", name, value, q->unit, libmlg_least(v.parameter),
         libmlg_most(v.parameter));
  return v;
}

struct gear read_gear(const char *file)
{
  struct reader r = { file, "", 0 };
  struct gear gear = { .n = 0 };

  r.at = whole_text(&r);
  r.line = 1;
  skip_blanks_and_comments(&r);
  if (strncmp(r.at, "PAR", 3) != 0)
    slip(&r, "expected one constant, PAR = {'name': value, ...}");
  r.at += 3;
  expect(&r, '=');
  expect(&r, '{');
  for (skip_blanks(&r); *r.at != '}'; skip_blanks(&r)) {
    const struct gear_value v = read_value(&r);

    for (int k = 0; k < gear.n; k++)
      if (gear.value[k].parameter == v.parameter)
        slip(&r, "PAR: %s is given twice", libmlg_parameter_quantity(v.parameter)->name);
    gear.value[gear.n++] = v;
    skip_blanks(&r);
    if (*r.at == ',')
      r.at++;
    else if (*r.at != '}')
      slip(&r, "PAR: a bracket is left open");
  }
  r.at++;
  skip_blanks_and_comments(&r);
  if (*r.at)
    slip(&r, "expected one constant, PAR = {'name': value, ...}");
  return gear;
}
