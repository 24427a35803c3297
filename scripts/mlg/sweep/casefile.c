/* casefile.c - the rows of a CSV as cases: axes whose values belong together; see description.h */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "description.h"
#include "text.h"

struct casefile { struct sweep *sweep; const char *file; int line, first, number; long rows; };

/* The next cell of a row without the blanks around it, as spreadsheets write them; NULL: none. */
static char *next_cell(char **at)
{
  char *cell = *at, *end;

  if (!cell)
    return NULL;
  *at = strchr(cell, ',');
  end = *at ? *at : cell + strlen(cell);
  if (*at)
    *(*at)++ = '\0';
  while (isspace((unsigned char)*cell))
    cell++;
  while (end > cell && isspace((unsigned char)end[-1]))
    *--end = '\0';
  return cell;
}

static void take_names(struct casefile *c, char *row)
{
  struct sweep *s = c->sweep;
  struct text place = TEXT_NONE;
  int column = 0;

  if (!strchr(row, ',') && strpbrk(row, ";\t"))
    slip(s, c->line, row, "cells are separated by commas, with decimal points; this is the first line of %s", c->file);
  for (char *name; (name = next_cell(&row)) != NULL;) {
    text_clear(&place);
    text_add(&place, "%s:%d, column %d", c->file, c->number, ++column);
    s->place = place.at;
    if (!*name)
      slip(s, c->line, name, "expected a name: the first line of the file has those of its columns");
    for (int i = c->first; i < s->axes; i++)
      if (strcmp(s->axis[i].name, name) == 0)
        slip(s, c->line, name, "stands twice among the names, also in column %d", i - c->first + 1);
    new_axis(s, name, c->file, c->line)->kind = AXIS_LIST;
  }
  s->place = NULL;
  text_free(&place);
}

static void take_values(struct casefile *c, char *row)
{
  struct sweep *s = c->sweep;
  struct text place = TEXT_NONE;
  int column = c->first;

  for (char *cell; (cell = next_cell(&row)) != NULL; column++) {
    if (column == s->axes)
      slip(s, c->line, c->file, "row %d has more cells than there are names", c->number);
    struct axis *a = &s->axis[column];

    text_clear(&place);
    text_add(&place, "%s:%d, column %s", c->file, c->number, a->name);
    s->place = place.at;
    check_value(s, a->name, cell, c->line);
    s->place = NULL;
    a->text = must_resize(a->text, (size_t)c->rows * sizeof *a->text);
    a->text[c->rows - 1] = strdup(cell);
  }
  if (column < s->axes)
    slip(s, c->line, c->file, "row %d has fewer cells than there are names", c->number);
  text_free(&place);
}

void add_table(struct sweep *s, const char *file, int line)
{
  struct text text = TEXT_NONE, why = TEXT_NONE;
  struct casefile c = { s, file, line, s->axes, 0, 0 };

  if (read_file(file, &text, &why) != 0)
    slip(s, line, file, "%s", why.at);
  for (char *at = behind_mark(text.at), *next; at; at = next) {
    next = strchr(at, '\n');
    if (next)
      *next++ = '\0';
    c.number++;
    if (*at == '#' || at[strspn(at, " \t\r")] == '\0')
      continue;
    if (c.rows == 0)
      take_names(&c, at);
    else
      take_values(&c, at);
    c.rows++;
  }
  if (c.rows < 2)
    slip(s, line, file, "expected a line of names, and a row for each case");
  s->table_dimension = new_dimension(s, c.rows - 1);
  for (int i = c.first; i < s->axes; i++)
    s->axis[i].dimension = s->table_dimension;
  text_free(&text);
  text_free(&why);
}
