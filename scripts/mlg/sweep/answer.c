/* answer.c - what a command printed, as rows of a sweep's table; see answer.h */
#include "answer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"

enum { MOST_CELLS = 128 };

struct cells { char *at[MOST_CELLS]; int n; };

static void cut(char *line, struct cells *c)
{
  c->n = 0;
  for (char *cell = line; cell && c->n < MOST_CELLS;) {
    char *comma = strchr(cell, ',');

    if (comma)
      *comma++ = '\0';
    c->at[c->n++] = cell;
    cell = comma;
  }
}

/* The next line that holds cells; NULL at the end. */
static char *next_line(char **at)
{
  while (*at && **at) {
    char *line = *at, *end = strchr(line, '\n');

    *at = end ? end + 1 : NULL;
    if (end)
      *end = '\0';
    if (*line && *line != '#')
      return line;
  }
  return NULL;
}

static int place(char *const name[], int names, const char *wanted)
{
  for (int i = 0; i < names; i++)
    if (strcmp(name[i], wanted) == 0)
      return i;
  return -1;
}

/* Without commas, for it may be a cell of failed.csv. */
static int no_column(const struct sweep *s, const struct step *step, int line, const char *wanted, char *const name[], int names,
                     struct text *why)
{
  double x;

  text_add(why, "%s:%d: '%s': ", s->file, line, wanted);
  for (int i = 0; i < names && !step->names; i++)
    if (is_number(name[i], &x)) {
      text_add(why, "mlg %s begins with numbers (%s); not with the names of its columns: a line names = ... has to say these", step->command->name, name[i]);
      return -1;
    }
  text_add(why, step->names ? "the line names of mlg %s has no such column; it has" : "mlg %s prints no such column; it has",
           step->command->name);
  for (int i = 0; i < names; i++)
    text_add(why, " %s", name[i]);
  return -1;
}

static void add_row(const struct step *step, const struct cells *c, const int kept[], struct text *text)
{
  for (int k = 0; k < step->keeps; k++) {
    if (k > 0)
      text_append(text, ",", 1);
    text_append(text, c->at[kept[k]], strlen(c->at[kept[k]]));
  }
  text_append(text, "\n", 1);
}

/* Whether this row is to take the place of the one chosen so far. */
static bool is_better(const struct step *step, const char *cell, double *best, bool first)
{
  char *end = NULL;
  const double x = cell ? strtod(cell, &end) : NAN;

  if (step->rows == ROWS_FIRST)
    return first;
  if (step->rows == ROWS_LAST)
    return true;
  if (end == cell || !(first || isnan(*best) || (step->rows == ROWS_LARGEST ? x > *best : x < *best)))
    return false;
  *best = x;
  return true;
}

/* Whether the first row under given names are the names that the command prints itself. */
static bool are_names(const struct step *step, const struct cells *c)
{
  int same = 0;
  double x;

  for (int i = 0; i < c->n; i++) {
    if (is_number(c->at[i], &x) || !*c->at[i])
      return false;
    same += i < step->names && strcmp(c->at[i], step->name[i]) == 0;
  }
  return same > 0;
}

static int rows_of(const struct sweep *s, const struct step *step, char *output, struct answer *a, struct text *why)
{
  struct cells names, c;
  int kept[MOST_COLUMNS], by = -1;
  bool first = true;
  double best = NAN;
  char *line;

  if (step->names) {
    names.n = step->names;
    memcpy(names.at, step->name, (size_t)step->names * sizeof *step->name);
  } else if ((line = next_line(&output)) != NULL)
    cut(line, &names);
  else
    return 0;
  for (int k = 0; k < step->keeps; k++)
    if ((kept[k] = place(names.at, names.n, step->keep[k].name)) < 0)
      return no_column(s, step, step->keep_line, step->keep[k].name, names.at, names.n, why);
  if (step->rows_column && (by = place(names.at, names.n, step->rows_column)) < 0)
    return no_column(s, step, step->rows_line, step->rows_column, names.at, names.n, why);
  while ((line = next_line(&output)) != NULL) {
    cut(line, &c);
    if (c.n != names.n) {
      text_add(why, "mlg %s prints a row of %d cells under %d names", step->command->name, c.n, names.n);
      return -1;
    }
    if (step->names && first && are_names(step, &c)) {
      text_add(why, "mlg %s prints the names of its columns itself; take the line names away", step->command->name);
      return -1;
    }
    first = false;
    if (step->rows != ROWS_ALL && !is_better(step, by >= 0 ? c.at[by] : NULL, &best, a->rows == 0))
      continue;
    if (step->rows != ROWS_ALL)
      text_clear(&a->text), a->rows = 0;
    add_row(step, &c, kept, &a->text);
    a->rows++;
  }
  return 0;
}

static void add_empty(const struct step *step, struct text *text)
{
  for (int k = 1; k < step->keeps; k++)
    text_append(text, ",", 1);
  text_append(text, "\n", 1);
}

static bool is_first_question(const struct sweep *s, const struct step *step)
{
  for (int i = 0; i < s->steps; i++)
    if (s->step[i].asks)
      return step == &s->step[i];
  return false;
}

/* A row of empty cells for all questions before this step (NULL: for all), if there is none. */
static void add_missing(const struct sweep *s, const struct step *end, struct answer *a)
{
  if (a->rows > 0)
    return;
  for (const struct step *step = s->step; step < (end ? end : s->step + s->steps); step++)
    if (step->asks) {
      if (a->text.length > 0)
        a->text.at[a->text.length - 1] = ','; /* the line goes on */
      add_empty(step, &a->text);
    }
  a->rows = 1;
}

/* The row of this step behind that of those before, where one has none an empty one. */
static int join(const struct sweep *s, const struct step *step, struct answer *a, struct answer *own, struct text *why)
{
  if (a->rows > 1 || own->rows > 1) {
    text_add(why, "%d rows where one stands beside others of the case; a line rows = first, last, largest COLUMN says which",
             a->rows > 1 ? a->rows : own->rows);
    return -1;
  }
  add_missing(s, step, a);
  if (own->rows == 0)
    add_empty(step, &own->text);
  a->text.at[a->text.length - 1] = ',';
  text_append(&a->text, own->text.at, own->text.length);
  return 0;
}

int take_answer(const struct sweep *s, const struct step *step, char *output, struct answer *a, struct text *why)
{
  struct answer own = { TEXT_NONE, 0 };

  if (is_first_question(s, step))
    return rows_of(s, step, output, a, why);
  int status = rows_of(s, step, output, &own, why);

  if (status == 0)
    status = join(s, step, a, &own, why);
  text_free(&own.text);
  return status;
}

void complete_answer(const struct sweep *s, struct answer *a)
{
  add_missing(s, NULL, a);
}
