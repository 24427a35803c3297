/* csv.c - the tables of results/; see csv.h */
#define _XOPEN_SOURCE 700
#include "csv.h"

#include <fnmatch.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "uses.h"

static int cells_of(const char *line)
{
  int n = 1;

  for (const char *t = line; *t; t++)
    n += *t == ',';
  return n;
}

/* Cuts a line at its commas, behind the cells that are there. */
static void add_line(struct csv *t, char *line, int *room)
{
  const int first = (t->rows + 1) * t->columns;

  if (first + t->columns > *room) {
    *room = 2 * (first + t->columns);
    t->cell = must_resize(t->cell, (size_t)*room * sizeof *t->cell);
  }
  for (int i = 0; i < t->columns; i++) {
    t->cell[first + i] = line;
    line = strchr(line, ',');
    if (line)
      *line++ = '\0';
  }
}

int csv_read(const char *file, struct csv *t, struct text *why)
{
  struct text name = TEXT_NONE;
  long number = 0;
  int room = 0;

  *t = (struct csv){ NULL, TEXT_NONE, 0, -1, NULL };
  text_add(&name, "%s", file);
  t->file = name.at;
  note_use(file);
  if (read_file(file, &t->text, why) != 0)
    return -1;
  char *line = t->text.at;

  if (strncmp(line, "\xef\xbb\xbf", 3) == 0) /* the mark that Windows begins files with */
    line += 3;
  for (char *next; *line; line = next) {
    next = line + strcspn(line, "\n");
    if (*next)
      *next++ = '\0';
    if (*line && line[strlen(line) - 1] == '\r') /* as Windows ends lines */
      line[strlen(line) - 1] = '\0';
    number++;
    if (*line == '#')
      continue;
    if (t->rows < 0)
      t->columns = cells_of(line);
    if (cells_of(line) != t->columns) {
      text_add(why, "%s:%ld: %d cells, the table has %d columns", file, number, cells_of(line), t->columns);
      return -1;
    }
    add_line(t, line, &room);
    t->rows++;
  }
  if (t->rows < 0) {
    text_add(why, "%s: is no table, it has no line of names", file);
    return -1;
  }
  return 0;
}

void csv_free(struct csv *t)
{
  free(t->file);
  free(t->cell);
  text_free(&t->text);
}

const char *csv_name(const struct csv *t, int column)
{
  return t->cell[column];
}

const char *csv_cell(const struct csv *t, int row, int column)
{
  return t->cell[(row + 1) * t->columns + column];
}

int csv_column(const struct csv *t, const char *name)
{
  for (int i = 0; i < t->columns; i++)
    if (strcmp(t->cell[i], name) == 0)
      return i;
  return -1;
}

int csv_is_number(const char *text, double *value)
{
  char *end;

  *value = strtod(text, &end);
  return end != text && *end == '\0' && !isnan(*value);
}

double csv_number(const struct csv *t, int row, int column)
{
  double x;

  return csv_is_number(csv_cell(t, row, column), &x) ? x : NAN;
}

int csv_needs_numbers(const struct csv *t, int row, const int column[], int columns, double least, struct text *why)
{
  for (int k = 0; k < columns; k++) {
    double x;

    if (csv_is_number(csv_cell(t, row, column[k]), &x) && x > least)
      continue;
    text_add(why, "%s: row %d has '%s' in column %s, expected a number", t->file, row + 1, csv_cell(t, row, column[k]),
             csv_name(t, column[k]));
    if (isfinite(least))
      text_add(why, " above %g", least);
    return -1;
  }
  return 0;
}

/* A condition may have where= before it. */
static const char *without_where(const char *word)
{
  return strncmp(word, "where=", 6) == 0 && strpbrk(word + 6, "=<>") ? word + 6 : word;
}

int is_condition(const char *word)
{
  word = without_where(word);

  const size_t n = strcspn(word, "=!<>");

  return n > 0 && word[n] != '\0' && (word[n] != '!' || word[n + 1] == '=');
}

int read_row_condition(const struct csv *t, const char *word, struct condition *c, struct text *why)
{
  word = without_where(word);

  const size_t n = strcspn(word, "=!<>"), length = strcspn(word, "%=!<>");
  struct text name = TEXT_NONE;
  char *end = NULL;

  *c = (struct condition){ .relation = { word[n], word[n + 1] == '=' && word[n] != '=' ? '=' : '\0', '\0' } };
  c->value = word + n + strlen(c->relation);
  text_append(&name, word, length);
  c->column = csv_column(t, name.at);
  if (c->column < 0)
    text_add(why, "'%s': %s has no column %s", word, t->file, name.at);
  else if (word[length] == '%') {
    c->modulus = strtod(word + length + 1, &end);
    if (end != word + n || !(c->modulus > 0.))
      text_add(why, "'%s': expected a number above 0 behind %%", word);
  }
  text_free(&name);
  return why->length > 0 ? -1 : 0;
}

/* Whether a text is one of "A|B|C*". */
static int is_one_of(const char *cell, const char *list)
{
  struct text one = TEXT_NONE;
  int is = 0;

  for (const char *t = list; t && !is; t = *t ? t + 1 : NULL) {
    const size_t n = strcspn(t, "|");

    text_clear(&one);
    text_append(&one, t, n);
    is = fnmatch(one.at, cell, 0) == 0;
    t += n;
  }
  text_free(&one);
  return is;
}

int fits_condition(const struct csv *t, int row, const struct condition *c)
{
  const char *cell = csv_cell(t, row, c->column);
  double x, y, order;

  if (csv_is_number(cell, &x) && csv_is_number(c->value, &y)) {
    if (c->modulus > 0.)
      x = fmod(x, c->modulus);
    order = x == y || (isfinite(y) && fabs(x - y) <= 1e-12 * fabs(y)) ? 0. : x < y ? -1. : 1.;
  } else
    order = c->modulus > 0. || strchr("<>", c->relation[0]) ? NAN : !is_one_of(cell, c->value);
  switch (c->relation[0]) {
  case '=': return order == 0.;
  case '!': return order != 0.;
  case '<': return order < 0. || (c->relation[1] && order == 0.);
  default: return order > 0. || (c->relation[1] && order == 0.);
  }
}

int next_fitting(const struct csv *t, int row, const struct condition condition[], int conditions)
{
  for (; row < t->rows; row++) {
    int fits = 1;

    for (int k = 0; k < conditions && fits; k++)
      fits = fits_condition(t, row, &condition[k]);
    if (fits)
      return row;
  }
  return -1;
}
