/* gearfile.c - reads a file of gear parameters and checks names, units and ranges */
#include "gearfile.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "autofile.h"
#include "mlg.h"

enum { GEAR_BYTES = 1 << 16 };

static const char form[] = "expected one constant, PAR = {'name': value, ...}";

/* What is being read: at is the place in its text. */
struct reader { const char *file, *at; int line; struct text *why; };

/* Notes what is wrong, in one line whatever it quotes, and is false. */
static bool slip(const struct reader *r, const char *format, ...)
{
  char what[512];
  va_list values;

  va_start(values, format);
  vsnprintf(what, sizeof what, format, values);
  va_end(values);
  if (r->line > 0)
    text_add(r->why, "%s:%d: %s", r->file, r->line, what);
  else
    text_add(r->why, "%s: %s", r->file, what);
  for (char *t = r->why->at; *t; t++)
    if (iscntrl((unsigned char)*t))
      *t = ' ';
  return false;
}

static bool whole_text(struct reader *r, struct text *text)
{
  struct text why = TEXT_NONE;

  if (read_file(r->file, text, &why) != 0) {
    slip(r, "%.300s; expected a file of gear parameters", why.at + strlen(r->file) + 2); /* behind "FILE: " */
    text_free(&why);
    return false;
  }
  text_free(&why);
  if (text->length >= GEAR_BYTES)
    return slip(r, "longer than %d bytes; not a file of gear parameters", GEAR_BYTES);
  if (memchr(text->at, '\0', text->length))
    return slip(r, "holds a zero byte; not a file of gear parameters");
  return true;
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

static bool expect(struct reader *r, char c)
{
  skip_blanks(r);
  if (*r->at != c)
    return slip(r, "expected '%c' and not '%.10s'; the form is PAR = {'name': value, ...}", c, r->at);
  r->at++;
  return true;
}

/* What stands before one of the characters ends, without blanks and quotes around it. */
static bool read_text(struct reader *r, const char *ends, char text[GEAR_TEXT])
{
  skip_blanks(r);
  const char *from = r->at, *to = from + strcspn(from, ends);

  for (; r->at < to; r->at++)
    r->line += *r->at == '\n';
  while (from < to && (isspace((unsigned char)*from) || strchr("'\"", *from)))
    from++;
  while (to > from && (isspace((unsigned char)to[-1]) || strchr("'\"", to[-1])))
    to--;
  if (to - from >= GEAR_TEXT)
    return slip(r, "PAR: an element longer than %d characters", GEAR_TEXT - 1);
  memcpy(text, from, (size_t)(to - from));
  text[to - from] = '\0';
  return true;
}

/* The unit behind a number, which it is cut from, is the right one. */
static bool check_unit(const struct reader *r, const struct gear_value *v, char *text, const char *unit)
{
  char *given = text + strcspn(text, " \t\n");

  if (!*given)
    return true;
  *given++ = '\0';
  given += strspn(given, " \t\n");
  return strcmp(given, unit) == 0 || slip(r, "PAR: %s is in %s here; it has to be in %s", v->name, given, unit);
}

static bool check_range(const struct reader *r, struct gear_value *v, const char *unit, double least, double most)
{
  if (v->parameter != LIBMLG_F_Z && strcmp(v->name, "k_s") == 0 && is_infinite(v->text))
    v->value = MLG_RIGID;
  else if (!*v->text)
    return slip(r, "%s has no value", v->name);
  else if (!is_finite(v->text, &v->value))
    return slip(r, "%s = %s is not a finite number", v->name, v->text);
  return (v->value >= least && v->value <= most)
         || slip(r, "%s = %s %s is outside its range, %g to %g", v->name, v->text, unit, least, most);
}

/* Slips are told at the line where the element begins, and not where what ends it stands. */
static bool read_value(struct reader *r, struct gear_value *v)
{
  char name[GEAR_TEXT];

  skip_blanks(r);
  struct reader begin = *r;

  if (!read_text(r, ":,}", name))
    return false;
  if (isdigit((unsigned char)*name) && *r->at != ':')
    return slip(&begin, "PAR: '%s' stands where a name should; a number has a decimal point, no comma", name);
  v->parameter = strcmp(name, "F_z") == 0 ? LIBMLG_F_Z : libmlg_parameter(name);
  if (v->parameter == LIBMLG_NONE)
    return slip(&begin, "PAR: '%s' is not a parameter (docs/model.md has them)", name);
  v->name = v->parameter == LIBMLG_F_Z ? "F_z" : libmlg_parameter_quantity(v->parameter)->name;
  if (!expect(r, ':') || !read_text(r, ",}", v->text))
    return false;
  v->line = begin.line;
  if (v->parameter == LIBMLG_F_Z)
    return check_unit(&begin, v, v->text, "N") && check_range(&begin, v, "N", 1e-3, 1e9);
  const char *unit = libmlg_parameter_quantity(v->parameter)->unit;

  return check_unit(&begin, v, v->text, unit) && check_range(&begin, v, unit, libmlg_least(v->parameter), libmlg_most(v->parameter));
}

/* Nothing is given twice, the load not by M and F_z. */
static bool is_new(const struct reader *reader, const struct gear *gear, const struct gear_value *v)
{
  struct reader at = *reader, *const r = &at;

  at.line = v->line;
  for (int k = 0; k < gear->n; k++) {
    const char *const other = gear->value[k].name;

    if (gear->value[k].parameter == v->parameter)
      return slip(r, "PAR: %s is given twice", v->name);
    if ((strcmp(other, "M") == 0 && v->parameter == LIBMLG_F_Z) || (gear->value[k].parameter == LIBMLG_F_Z && strcmp(v->name, "M") == 0))
      return slip(r, "PAR: both M and F_z = (M + m_D) g are given; give one");
  }
  return true;
}

static bool read_values(struct reader *r, struct gear *gear)
{
  skip_blanks_and_comments(r);
  if (strncmp(r->at, "PAR", 3) != 0)
    return slip(r, form);
  r->at += 3;
  if (!expect(r, '=') || !expect(r, '{'))
    return false;
  for (skip_blanks(r); *r->at != '}'; skip_blanks(r)) {
    struct gear_value *const v = &gear->value[gear->n];

    if (!read_value(r, v) || !is_new(r, gear, v))
      return false;
    gear->n++;
    skip_blanks(r);
    if (*r->at == ',')
      r->at++;
    else if (*r->at != '}')
      return slip(r, "PAR: a bracket is left open");
  }
  r->at++;
  skip_blanks_and_comments(r);
  return !*r->at || slip(r, form);
}

int read_gear(const char *file, struct gear *gear, struct text *why)
{
  struct reader r = { file, "", 0, why };
  struct text text = TEXT_NONE;
  bool right = whole_text(&r, &text);

  gear->n = 0;
  if (right) {
    r.at = text.at ? text.at : "";
    if (strncmp(r.at, "\xef\xbb\xbf", 3) == 0) /* the mark that Windows begins files with */
      r.at += 3;
    r.line = 1;
    right = read_values(&r, gear);
  }
  text_free(&text);
  return right ? 0 : -1;
}
