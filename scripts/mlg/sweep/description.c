/* description.c - the lines of a sweep's description; see description.h */
#define _POSIX_C_SOURCE 200809L
#include "description.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "arguments.h"
#include "text.h"

_Noreturn void slip(const struct sweep *sweep, int line, const char *value, const char *right, ...)
{
  struct text text = TEXT_NONE;
  char what[600];
  va_list values;

  va_start(values, right);
  vsnprintf(what, sizeof what, right, values);
  va_end(values);
  text_add(&text, "%s", sweep->file);
  if (line > 0)
    text_add(&text, ":%d", line);
  if (sweep->place)
    text_add(&text, ": %s", sweep->place);
  text_add(&text, value ? ": '%.200s': " : ": ", value);
  text_add(&text, "%s", what);
  say_line(NULL, text.at);
  exit(MLG_BAD_INPUT);
}

char *behind_mark(char *text)
{
  return strncmp(text, "\xef\xbb\xbf", 3) == 0 ? text + 3 : text;
}

static char *trimmed(char *text)
{
  size_t n = strlen(text);

  while (n > 0 && isspace((unsigned char)text[n - 1]))
    text[--n] = '\0';
  while (isspace((unsigned char)*text))
    text++;
  return text;
}

/* A # behind a blank, or first, begins a comment. */
static void cut_comment(char *line)
{
  for (char *t = line; (t = strchr(t, '#')) != NULL; t++)
    if (t == line || isspace((unsigned char)t[-1])) {
      *t = '\0';
      return;
    }
}

/* NUMBER, or NUMBER UNIT, within least and most. */
static double quantity(const struct sweep *sweep, const char *value, const char *unit, double least, double most, int line)
{
  char number[64] = "";
  const size_t n = strcspn(value, " \t");
  const char *rest = value + n + strspn(value + n, " \t");
  double x;

  if (n < sizeof number)
    memcpy(number, value, n);
  if (!is_number(number, &x) || (*rest && strcmp(rest, unit) != 0) || !(x >= least && x <= most))
    slip(sweep, line, value, "expected a number from %g to %g%s%s%s", least, most, *unit ? ", in " : "", unit,
         *unit ? " or without a unit" : "");
  return x;
}

static long long whole(const struct sweep *sweep, const char *value, double most, int line)
{
  const double x = quantity(sweep, value, "", 1., most, line);

  if (x != floor(x))
    slip(sweep, line, value, "expected a whole number");
  return (long long)x;
}

enum setting { GEAR, CASES, SAMPLE, TIME, MEMORY, BLOCK, FILES, DO, ASK, KEEP, NAMES, ROWS, INTO, SETTINGS };

static const char *const setting_name[SETTINGS] = { "gear", "cases", "sample", "time",  "memory", "block",
                                                    "files", "do",   "ask",    "keep", "names",  "rows", "into" };

static enum setting setting_of(const char *key)
{
  for (int i = 0; i < SETTINGS; i++)
    if (strcmp(setting_name[i], key) == 0)
      return (enum setting)i;
  return SETTINGS;
}

/* A file by its name from the checkout, or else beside the description. */
static char *file_of(const struct sweep *s, const char *value)
{
  const char *slash = strrchr(s->file, '/');
  struct text beside = TEXT_NONE;

  if (*value != '/' && slash && access(value, F_OK) != 0) {
    text_append(&beside, s->file, (size_t)(slash + 1 - s->file));
    text_add(&beside, "%s", value);
    if (access(beside.at, F_OK) == 0)
      return beside.at;
  }
  text_free(&beside);
  return strdup(value);
}

static void take_setting(struct sweep *s, enum setting setting, const char *value, int line)
{
  switch (setting) {
  case GEAR:
    s->gear = file_of(s, value);
    s->gear_line = line;
    break;
  case CASES:
    s->table = file_of(s, value);
    add_table(s, s->table, line);
    break;
  case SAMPLE:
    s->sample = whole(s, value, 1e12, line);
    s->sample_line = line;
    break;
  case TIME: s->time_limit = quantity(s, value, "s", 0.01, 1e6, line); break;
  case MEMORY: s->memory_limit = (long)quantity(s, value, "MB", 64, 1e6, line); break;
  case BLOCK: s->block = whole(s, value, 1e9, line); break;
  case FILES:
    if (strcmp(value, "keep") != 0)
      slip(s, line, value, "expected keep: AUTO's files stay; without this line they go");
    s->keeps_files = true;
    break;
  case DO:
  case ASK: add_step(s, setting == ASK, value, line); break;
  case KEEP: add_keep(s, value, line); break;
  case NAMES: add_names(s, value, line); break;
  case ROWS: add_rows(s, value, line); break;
  case INTO: add_into(s, value, line); break;
  case SETTINGS: break;
  }
}

static bool is_identifier(const char *key)
{
  if (!isalpha((unsigned char)*key))
    return false;
  for (; *key; key++)
    if (!isalnum((unsigned char)*key) && *key != '_')
      return false;
  return true;
}

/* The setting that a name is but for capitals; NULL: none, or a parameter. */
static const char *capital_of(const char *key)
{
  for (int i = 0; i < SETTINGS; i++)
    if (strcasecmp(setting_name[i], key) == 0 && !is_parameter(key))
      return setting_name[i];
  return strcasecmp("layout", key) == 0 && strcmp("layout", key) != 0 ? "layout" : NULL;
}

/* One line, with those that continue it. */
static void take_line(struct sweep *s, char *text, int line, bool given[SETTINGS])
{
  char *equals = strchr(text, '=');
  enum setting setting;

  if (!equals)
    slip(s, line, trimmed(text), "expected NAME = VALUES, or one of gear, cases, sample, do, ask, keep, ... = VALUE");
  *equals = '\0';
  char *key = trimmed(text), *value = trimmed(equals + 1);

  setting = setting_of(key);
  if (setting == SETTINGS && is_identifier(key) && capital_of(key))
    slip(s, line, key, "not %s? names are in small letters, unless they are those of parameters", capital_of(key));
  if (!*value)
    slip(s, line, key, "no value behind =");
  if (setting == SETTINGS && !is_identifier(key))
    slip(s, line, key, "a name has letters, digits and _, a letter first");
  if (setting < DO && given[setting])
    slip(s, line, key, "given twice");
  if (setting == SETTINGS)
    add_axis(s, key, value, line);
  else
    take_setting(s, setting, value, line);
  if (setting < SETTINGS)
    given[setting] = true;
}

/* Whether a line looks as if it were meant to stand by itself: "ask = ...", "e = ..."; words of
 * a command, such as keep=UZ, have no blank before =. */
static bool begins_anew(const char *text)
{
  const size_t n = strcspn(text, " \t=");
  char key[40] = "";

  if (n >= sizeof key || text[n] == '=' || text[n + strspn(text + n, " \t")] != '=')
    return false;
  memcpy(key, text, n);
  return setting_of(key) < SETTINGS || is_parameter(key) || strcmp(key, "layout") == 0;
}

void read_sweep(const char *file, struct sweep *s)
{
  struct text text = TEXT_NONE, why = TEXT_NONE, line = TEXT_NONE;
  bool given[SETTINGS] = { false };
  int number = 0, first = 0;

  *s = (struct sweep){ .file = file, .sample_dimension = -1, .table_dimension = -1 };
  if (read_file(file, &text, &why) != 0) {
    say_line("mlg cases", why.at);
    exit(MLG_BAD_INPUT);
  }
  if (strlen(text.at) != text.length)
    slip(s, 0, NULL, "holds a zero byte; not the description of a sweep");
  text_clear(&line);
  for (char *at = behind_mark(text.at), *next; at; at = next) {
    next = strchr(at, '\n');
    if (next)
      *next++ = '\0';
    number++;
    cut_comment(at);
    const bool continues = isspace((unsigned char)*at) && line.length > 0;

    if (*trimmed(at) == '\0')
      continue;
    if (continues && begins_anew(trimmed(at)))
      slip(s, number, trimmed(at), "a line that begins with a blank goes on with the one before; take the blank away");
    if (isspace((unsigned char)*at) && !continues)
      slip(s, number, trimmed(at), "a line that begins with a blank goes on with the one before, and there is none");
    if (!continues && line.length > 0) {
      take_line(s, line.at, first, given);
      text_clear(&line);
    }
    if (!continues)
      first = number;
    text_add(&line, "%s%s", continues ? " " : "", trimmed(at));
  }
  if (line.length > 0)
    take_line(s, line.at, first, given);
  text_free(&line);
  text_free(&text);
  text_free(&why);
  settle_axes(s);
  settle_steps(s);
}
