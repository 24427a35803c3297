/* unitline.c - the units of an answer's columns; see unitline.h */
#define _POSIX_C_SOURCE 200809L
#include "unitline.h"

#include <ctype.h>
#include <string.h>

#include "mlg.h"
#include "units.h"

/* "m/s", "N m s/rad", "1e-5 rad/(N m)", "-": no other words than these. */
static bool is_unit(const char *text, size_t n)
{
  static const char *const known[] = { "m", "s", "N", "rad", "Hz", "deg", "kg", "e", NULL };

  if (n == 0 || strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/^()%-. ") < n)
    return false;
  for (size_t at = 0, length; at < n; at += length) {
    bool is_known = false;

    for (length = 0; at + length < n && isalpha((unsigned char)text[at + length]); length++)
      ;
    for (int k = 0; length > 0 && known[k] && !is_known; k++)
      is_known = strlen(known[k]) == length && memcmp(known[k], text + at, length) == 0;
    if (length > 0 && !is_known)
      return false;
    length += length == 0;
  }
  return true;
}

static int kept_as(const struct step *step, const char *name, size_t length)
{
  for (int k = 0; k < step->keeps; k++)
    if (strlen(step->keep[k].name) == length && memcmp(step->keep[k].name, name, length) == 0)
      return k;
  return -1;
}

/* V, psi_max and the like are called so, and in these units, by every command. */
static const char *unit_everywhere(const char *name)
{
  const struct result *const result = result_of(name);

  if (result)
    return strcmp(result->unit, "-") == 0 ? NULL : result->unit;
  return parameter_unit(name);
}

struct found { const char *unit[MOST_COLUMNS]; size_t length[MOST_COLUMNS]; bool waits[MOST_COLUMNS]; };

static void give(struct found *f, const char *unit, size_t length)
{
  for (int k = 0; k < MOST_COLUMNS; k++)
    if (f->waits[k] && !f->unit[k])
      f->unit[k] = unit, f->length[k] = length;
}

/* "NAME", whose unit stands behind one of the next, or "NAME UNIT". */
static void take_part(const struct step *step, const char *at, size_t n, struct found *f)
{
  const char *end = at + n;

  for (; at < end && *at == ' '; at++)
    ;
  for (; end > at && isspace((unsigned char)end[-1]); end--)
    ;
  const char *name_end = memchr(at, ' ', (size_t)(end - at)), *unit, *note;
  const int k = kept_as(step, at, (size_t)((name_end ? name_end : end) - at));

  if (k >= 0)
    f->waits[k] = true;
  if (!name_end)
    return;
  unit = name_end + strspn(name_end, " ");
  if ((note = strstr(unit, " (")) != NULL && note < end) /* "N m/rad (inf: rigid)" */
    end = note;
  if (is_unit(unit, (size_t)(end - unit)))
    give(f, unit, (size_t)(end - unit));
  memset(f->waits, 0, sizeof f->waits);
}

/* One text of the comments; commas go on with a list of names, ; : and a full stop end it. */
static void take_comments(const struct step *step, const char *text, struct found *f)
{
  int depth = 0;

  for (const char *from = text, *at = text;; at++) {
    depth += (*at == '(') - (*at == ')');
    const bool stop = (*at == '.' && at[1] == ' ') || *at == ';' || *at == ':';

    if (*at && (depth > 0 || (*at != ',' && !stop)))
      continue;
    take_part(step, from, (size_t)(at - from), f);
    if (stop)
      memset(f->waits, 0, sizeof f->waits);
    if (!*at)
      return;
    from = at + 1;
  }
}

/* The comments above the names as one text, without #; false: no names are there. */
static bool comments_of(const char *output, struct text *comments)
{
  text_clear(comments);
  for (const char *line = output; *line;) {
    const size_t n = strcspn(line, "\n");

    if (n > 0 && *line != '#')
      return true;
    if (n > 0) {
      text_append(comments, " ", 1);
      text_append(comments, line + 1, n - 1);
    }
    line += n + (line[n] == '\n');
  }
  return false;
}

bool read_unit_line(const struct step *step, const char *output, struct text *units)
{
  struct text comments = TEXT_NONE;
  struct found f = { .unit = { NULL } };
  bool known = true;

  if (step->names) {
    for (int i = 0; i < step->names; i++) {
      const int k = kept_as(step, step->name[i], strlen(step->name[i]));

      if (k >= 0 && step->unit[i])
        f.unit[k] = step->unit[i], f.length[k] = strlen(step->unit[i]);
    }
  } else if ((known = comments_of(output, &comments)))
    take_comments(step, comments.at, &f);
  for (int k = 0; k < step->keeps && !step->names; k++)
    if (!f.unit[k] && (f.unit[k] = unit_everywhere(step->keep[k].name)) != NULL)
      f.length[k] = strlen(f.unit[k]);
  text_clear(units);
  for (int k = 0; k < step->keeps; k++)
    if (f.unit[k])
      text_add(units, "%s%s %.*s", units->length > 0 ? "; " : "", step->keep[k].as, (int)f.length[k], f.unit[k]);
  text_free(&comments);
  return known;
}
