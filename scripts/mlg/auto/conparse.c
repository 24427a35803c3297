/* conparse.c - the form of an AUTO constants file; see constants.h
 *
 * NAME = value, a comma, blanks or a line end between them; a value is a number, a
 * text, a list [..] or a dictionary {..}, which may span lines; # and ! begin a
 * comment.  AUTO cuts what is longer than its own line.
 */
#include "conparts.h"

#include <ctype.h>
#include <string.h>

#include "autofile.h"

enum { MOST_BYTES = 1 << 16 };

void set_entry(struct constants *c, const char *key, const char *value, int line, enum source source)
{
  int i;

  for (i = 0; i < c->own.n && strcmp(c->own.entry[i].key, key) != 0; i++)
    ;
  if (i == MOST_ENTRIES)
    bad_input(c, c->file, line, "more than %d constants", MOST_ENTRIES);
  if (strlen(key) + strlen(value) > AUTO_LINE - 48)
    bad_input(c, c->file, line, "%s is longer than AUTO reads, %d characters", key, AUTO_LINE - 48);
  if (i == c->own.n)
    c->own.n++;
  c->own.entry[i] = (struct entry){ key, value, line, source };
}

const struct entry *get_entry(const struct entries *entries, const char *key)
{
  for (int i = 0; i < entries->n; i++)
    if (strcmp(entries->entry[i].key, key) == 0)
      return &entries->entry[i];
  return NULL;
}

const char *value_end(const char *t, int *lines)
{
  int depth = 0;
  char quote = 0;

  for (; *t; t++) {
    if (*t == '\n')
      ++*lines;
    if (quote) {
      if (*t == quote)
        quote = 0;
      else if (*t == '\n')
        return NULL;
    } else if (*t == '\'' || *t == '"')
      quote = *t;
    else if (*t == '[' || *t == '{')
      depth++;
    else if (*t == ']' || *t == '}') {
      if (--depth < 0)
        return NULL;
      if (depth == 0)
        return t + 1;
    } else if (depth == 0 && (isspace((unsigned char)*t) || *t == ',')) {
      if (*t == '\n')
        --*lines;
      return t;
    }
  }
  return depth == 0 && !quote ? t : NULL;
}

static const char *text_of(struct constants *c, const char *file)
{
  struct text text = TEXT_NONE, why = TEXT_NONE;
  const char *kept;

  if (read_file(file, &text, &why) != 0) {
    char reason[512];

    snprintf(reason, sizeof reason, "%s", why.at + strlen(file) + 2); /* behind "FILE: " */
    text_free(&text);
    text_free(&why);
    bad_input(c, file, 0, "%s; expected a constants file", reason);
  }
  text_free(&why);
  kept = keep_text(c, text.at, text.length);
  if (text.length >= MOST_BYTES || memchr(text.at, '\0', text.length)) {
    const int zero = text.length < MOST_BYTES;

    text_free(&text);
    bad_input(c, file, 0, zero ? "holds a zero byte; not a constants file" : "longer than 65536 bytes; not a constants file");
  }
  text_free(&text);
  return kept;
}

void parse_constants(struct constants *c, const char *file, struct entries *to)
{
  const char *t = text_of(c, file);
  int line = 1;

  to->file = file;
  to->n = 0;
  while (*t) {
    if (*t == '\n') {
      line++, t++;
    } else if (isspace((unsigned char)*t) || *t == ',') {
      t++;
    } else if (*t == '#' || *t == '!') {
      t += strcspn(t, "\n");
    } else {
      const size_t length = strspn(t, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
      const char *key = keep_text(c, t, length), *value, *end;
      int lines = 0;

      if (length == 0)
        bad_input(c, file, line, "unexpected '%c'; a constant is written NAME = value", *t);
      t += length;
      t += strspn(t, " \t");
      if (*t != '=')
        bad_input(c, file, line, "'%s' is not followed by '='; a constant is written NAME = value", key);
      t++;
      value = t + strspn(t, " \t");
      end = value_end(value, &lines);
      if (!end)
        bad_input(c, file, line, "%s: a bracket or quote is left open", key);
      if (end == value)
        bad_input(c, file, line, "%s has no value", key);
      if (!is_constant(key))
        bad_input(c, file, line, "'%s' is not an AUTO constant (see the AUTO manual, chapter 10)", key);
      if (get_entry(to, key))
        bad_input(c, file, line, "%s is given twice; AUTO would take the last", key);
      if (to->n == MOST_ENTRIES)
        bad_input(c, file, line, "more than %d constants", MOST_ENTRIES);
      if (length + (size_t)(end - value) > AUTO_LINE - 48)
        bad_input(c, file, line, "%s is longer than AUTO reads, %d characters", key, AUTO_LINE - 48);
      to->entry[to->n++] = (struct entry){ key, keep_text(c, value, (size_t)(end - value)), line, OF_FILE };
      line += lines;
      t = end;
    }
  }
}

/* A key or a value without quotes and blanks around it. */
static const char *plain(struct constants *c, const char *from, const char *end)
{
  while (from < end && (isspace((unsigned char)*from) || *from == '\'' || *from == '"'))
    from++;
  while (end > from && (isspace((unsigned char)end[-1]) || end[-1] == '\'' || end[-1] == '"'))
    end--;
  return keep_text(c, from, (size_t)(end - from));
}

struct items split(struct constants *c, const struct entry *e)
{
  const char *t = e->value, *end = t + strlen(t);
  struct items items = { keep(c, (strlen(t) + 1) * sizeof *items.item), 0 };

  if (*t == '[' || *t == '{')
    t++, end--;
  while (t < end) {
    const char *start = t, *colon = NULL;
    struct item *item = &items.item[items.n];
    int depth = 0;
    char quote = 0;

    for (; t < end && (*t != ',' || depth > 0 || quote); t++) {
      if (quote)
        quote = *t == quote ? 0 : quote;
      else if (*t == '\'' || *t == '"')
        quote = *t;
      else if (*t == '[' || *t == '{')
        depth++;
      else if (*t == ']' || *t == '}')
        depth--;
      else if (*t == ':' && depth == 0 && !colon)
        colon = t;
    }
    item->key = colon ? plain(c, start, colon) : "";
    item->value = plain(c, colon ? colon + 1 : start, t);
    if (item->value[0] || item->key[0])
      items.n++;
    t += t < end;
  }
  return items;
}
