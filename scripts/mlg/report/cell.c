/* cell.c - one cell of a table of results/; see cell.h */
#include "expression.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "csv.h"

enum { MOST_CONDITIONS = 16, MOST_TABLES = 24 };

void add_table_file(struct text *file, const char *name)
{
  if (strchr(name, '/'))
    text_add(file, "%s", name);
  else
    text_add(file, "%sresults/%s.csv", checkout(), name);
}

/* Each table is read once. */
static const struct csv *table_of(const char *name, struct text *why)
{
  static struct csv read[MOST_TABLES];
  static int n;
  struct text file = TEXT_NONE;
  const struct csv *t = NULL;

  add_table_file(&file, name);
  for (int i = 0; i < n && !t; i++)
    if (strcmp(read[i].file, file.at) == 0)
      t = &read[i];
  if (!t && n < MOST_TABLES && csv_read(file.at, &read[n], why) == 0)
    t = &read[n++];
  else if (!t && why->length == 0)
    text_add(why, "%s: more than %d tables", name, MOST_TABLES);
  text_free(&file);
  return t;
}

/* --- which rows are meant, and which of them ---------------------------------------- */

struct choice {
  const struct csv *table;
  int column;
  struct condition condition[MOST_CONDITIONS];
  int conditions;
  long nth;
  int extreme, sign; /* the column of largest= and least=, +1 or -1; or -1 */
  int along;         /* the column of at: and nearest:, or -1 */
  double place;
  int nearest, list, each;
};

static int first_fitting(const struct choice *c, int row)
{
  return next_fitting(c->table, row, c->condition, c->conditions);
}

static int column_or_say(const struct choice *c, const char *name, int *column, struct text *why)
{
  *column = csv_column(c->table, name);
  if (*column < 0)
    text_add(why, "%s has no column %s", c->table->file, name);
  return *column < 0 ? CELL_WRONG : 0;
}

/* at:COLUMN=TERM, nearest:COLUMN=TERM */
static int read_place(struct reading *r, struct choice *c)
{
  const char *word = strchr(r->word[r->at++], ':') + 1, *equals = strchr(word, '=');
  struct text name = TEXT_NONE, value = TEXT_NONE;
  int status;

  if (!equals) {
    text_add(r->why, "'%s': expected COLUMN=NUMBER", word);
    return CELL_WRONG;
  }
  text_append(&name, word, (size_t)(equals - word));
  status = column_or_say(c, name.at, &c->along, r->why);
  if (status == 0 && strcmp(equals, "=(") == 0) {
    status = read_expression(r, &value);
    if (status == 0 && (r->at == r->words || strcmp(r->word[r->at++], ")") != 0)) {
      text_add(r->why, "expected a )");
      status = CELL_WRONG;
    }
  } else
    text_add(&value, "%s", equals + 1);
  if (status == 0 && !csv_is_number(value.at, &c->place)) {
    text_add(r->why, "'%s': expected a number", value.at);
    status = CELL_WRONG;
  }
  text_free(&name);
  text_free(&value);
  return status;
}

static int read_choice(struct reading *r, struct choice *c)
{
  int status = 0;

  while (status == 0 && r->at < r->words && !is_operator(r->word[r->at])) {
    const char *word = r->word[r->at];

    if (strncmp(word, "at:", 3) == 0 || strncmp(word, "nearest:", 8) == 0) {
      c->nearest = *word == 'n';
      status = read_place(r, c);
      continue;
    }
    r->at++;
    if (strcmp(word, "list") == 0)
      c->list = 1;
    else if (strcmp(word, "each") == 0)
      c->each = 1;
    else if (strncmp(word, "nth=", 4) == 0 && whole_number(word + 4, 1, 1000000, &c->nth))
      continue;
    else if (strncmp(word, "largest=", 8) == 0 || strncmp(word, "least=", 6) == 0) {
      c->sign = word[1] == 'a' ? 1 : -1;
      status = column_or_say(c, strchr(word, '=') + 1, &c->extreme, r->why);
    } else if (!is_condition(word) || c->conditions == MOST_CONDITIONS) {
      text_add(r->why, "'%s': expected COLUMN=VALUE or another condition", word);
      status = CELL_WRONG;
    } else if (read_row_condition(c->table, word, &c->condition[c->conditions++], r->why) != 0)
      status = CELL_WRONG;
  }
  return status;
}

/* How many curves among the rows that fit end on their first point. */
static int closed_curves(const struct choice *c)
{
  const struct csv *t = c->table;
  const int mark[] = { csv_column(t, "k_s"), csv_column(t, "curve"), csv_column(t, "V"), csv_column(t, "c_d") };
  int n = 0;

  for (int row = first_fitting(c, 0), first, last; row >= 0;) {
    first = last = row;
    do {
      row = first_fitting(c, last + 1);
      if (row != last + 1 || strcmp(csv_cell(t, row, mark[0]), csv_cell(t, first, mark[0])) != 0
          || strcmp(csv_cell(t, row, mark[1]), csv_cell(t, first, mark[1])) != 0)
        break;
      last = row;
    } while (row >= 0);
    n += last > first && strcmp(csv_cell(t, first, mark[2]), csv_cell(t, last, mark[2])) == 0
         && strcmp(csv_cell(t, first, mark[3]), csv_cell(t, last, mark[3])) == 0;
  }
  return n;
}

/* Whether two rows of fig07 are a double Hopf point and a point within 1 % of it. */
static int meet(const struct csv *t, int row, int next)
{
  const int V = csv_column(t, "V"), c_d = csv_column(t, "c_d"), type = csv_column(t, "type");

  return (strcmp(csv_cell(t, row, type), "HH") == 0 || strcmp(csv_cell(t, next, type), "HH") == 0)
         && fabs(csv_number(t, row, V) - csv_number(t, next, V)) <= 0.01 * csv_number(t, next, V)
         && fabs(csv_number(t, row, c_d) - csv_number(t, next, c_d)) <= 0.01 * csv_number(t, next, c_d);
}

/* How many torus curves begin and end so: the torus run stops just short of a double Hopf
 * point, whose row comes first and last in its curve. */
static int joined_curves(const struct csv *t)
{
  const int curve = csv_column(t, "curve");
  int n = 0, ends = 0;

  for (int row = 1; row < t->rows; row++) {
    const int same = strcmp(csv_cell(t, row, curve), csv_cell(t, row - 1, curve)) == 0;

    if (!same)
      ends = 0;
    else if (strncmp(csv_cell(t, row, curve), "torus", 5) == 0 && meet(t, row - 1, row) && ++ends == 2)
      n++;
  }
  return n;
}

static int by_size(const void *a, const void *b)
{
  const double x = strtod(*(char *const *)a, NULL), y = strtod(*(char *const *)b, NULL);

  return x < y ? -1 : x > y ? 1 : strcmp(*(char *const *)a, *(char *const *)b);
}

/* list and each */
static int many(const struct choice *c, struct text *value)
{
  const char **cell = must_allocate((size_t)(c->table->rows + 1) * sizeof *cell);
  int n = 0;

  for (int row = first_fitting(c, 0); row >= 0; row = first_fitting(c, row + 1))
    cell[n++] = csv_cell(c->table, row, c->column);
  if (c->each)
    qsort(cell, (size_t)n, sizeof *cell, by_size);
  text_clear(value);
  for (int i = 0; i < n; i++)
    if (!c->each || i == 0 || strcmp(cell[i], cell[i - 1]) != 0)
      text_add(value, "%s%s", i == 0 ? "" : c->each ? " " : ", ", cell[i]);
  free(cell);
  return n > 0 || c->each ? 0 : CELL_MISSING;
}

/* at:, the nth time */
static int between(const struct choice *c, struct text *value)
{
  const struct csv *t = c->table;
  long n = 0;

  for (int row = first_fitting(c, 0), next; row >= 0; row = next) {
    const double x = csv_number(t, row, c->along);
    double y;

    next = first_fitting(c, row + 1);
    if (next != row + 1)
      continue;
    y = csv_number(t, next, c->along);
    if (isfinite(x) && isfinite(y) && (x > c->place) != (y > c->place) && ++n == c->nth) {
      const double from = csv_number(t, row, c->column), to = csv_number(t, next, c->column);

      text_add(value, "%.9g", from + (to - from) * (c->place - x) / (y - x));
      return 0;
    }
  }
  return CELL_MISSING;
}

/* What the row that counts has the most of. */
static double merit(const struct choice *c, int row)
{
  return c->nearest ? -fabs(csv_number(c->table, row, c->along) - c->place) : c->sign * csv_number(c->table, row, c->extreme);
}

/* The row that counts, or -1. */
static int chosen_row(const struct choice *c)
{
  int row = first_fitting(c, 0), best = row;

  if (c->extreme < 0 && !c->nearest) {
    for (long n = 1; row >= 0 && n < c->nth; n++)
      row = first_fitting(c, row + 1);
    return row;
  }
  for (; row >= 0; row = first_fitting(c, row + 1))
    if (merit(c, row) > merit(c, best) || isnan(merit(c, best)))
      best = row;
  return best >= 0 && !isnan(merit(c, best)) ? best : -1; /* none of a column without numbers */
}

int read_cell(struct reading *r, struct text *value)
{
  struct choice c = { .nth = 1, .extreme = -1, .along = -1 };
  const int first = r->at;
  const char *column = r->word[r->at + 1];
  int status, row, n = 0;

  c.table = table_of(r->word[r->at], r->why);
  if (!c.table)
    return CELL_WRONG;
  r->at += 2;
  c.column = csv_column(c.table, column);
  if (c.column < 0 && strcmp(column, "count") != 0 && strcmp(column, "closed") != 0 && strcmp(column, "joined") != 0)
    return column_or_say(&c, column, &c.column, r->why);
  status = read_choice(r, &c);
  if (status != 0)
    return status;
  if (c.column < 0 && *column == 'c' && column[1] == 'o') {
    for (row = first_fitting(&c, 0); row >= 0; row = first_fitting(&c, row + 1))
      n++;
    text_add(value, "%d", n);
  } else if (c.column < 0)
    text_add(value, "%d", *column == 'c' ? closed_curves(&c) : joined_curves(c.table));
  else if (c.list || c.each)
    status = many(&c, value);
  else if (c.along >= 0 && !c.nearest)
    status = between(&c, value);
  else if ((row = chosen_row(&c)) < 0)
    status = CELL_MISSING;
  else
    text_add(value, "%s", csv_cell(c.table, row, c.column));
  if (status == CELL_MISSING) {
    text_add(r->why, "MISSING(%s %s", c.table->file, column);
    for (int i = first + 2; i < r->at; i++)
      text_add(r->why, " %s", r->word[i]);
    text_add(r->why, ")");
  }
  return status;
}
