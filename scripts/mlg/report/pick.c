/* pick.c - mlg pick: rows and columns of a table, for pictures and scripts */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cell.h"
#include "command.h"
#include "csv.h"

enum { MOST_COLUMNS = 64 };

/* NAME*FACTOR:FORMAT; without both a cell stays as it is. */
struct shown { int column; double factor; char format[12]; };

struct pick {
  struct csv table;
  struct condition *where;
  int conditions;
  struct shown shown[MOST_COLUMNS];
  int columns;
  int block[MOST_COLUMNS], blocks;
  int first; /* columns, or -1: */
  int x, y;
  long every;
  int head;
};

/* A name of a list "NAME,NAME"; returns the column. */
static int named(const struct csv *t, const char *list, size_t length, struct text *why)
{
  struct text name = TEXT_NONE;
  int column;

  text_clear(&name);
  text_append(&name, list, length);
  column = csv_column(t, name.at);
  if (column < 0) {
    text_add(why, "%s has no column '%s'; it has", t->file, name.at);
    for (int k = 0; k < t->columns; k++)
      text_add(why, "%s %s", k ? "," : "", csv_name(t, k));
  }
  text_free(&name);
  return column;
}

static void read_shown(struct pick *p, const char *text, size_t length, struct text *why)
{
  struct shown *s = &p->shown[p->columns++];
  const size_t name = strcspn(text, "*:,"), before = strcspn(text, ":,");
  char *end;

  *s = (struct shown){ named(&p->table, text, name, why), 1., "" };
  if (s->column >= 0 && name < before) {
    s->factor = strtod(text + name + 1, &end);
    strcpy(s->format, "%.10g");
    if (end != text + before || !isfinite(s->factor))
      text_add(why, "'%.*s': expected a number behind *", (int)length, text);
  }
  if (s->column >= 0 && before < length) {
    if (length - before < sizeof s->format)
      snprintf(s->format, sizeof s->format, "%%%.*s", (int)(length - before - 1), text + before + 1);
    if (length - before >= sizeof s->format || !is_number_format(s->format))
      text_add(why, "'%.*s': expected a format as .6g behind :", (int)length, text);
  }
}

/* columns=, blocks=, smooth=: names with commas between. */
static void read_list(struct pick *p, char kind, const char *list, struct text *why)
{
  int n = 0;

  for (; *list && n < MOST_COLUMNS && why->length == 0; n++) {
    const size_t length = strcspn(list, ",");

    if (kind == 'c')
      read_shown(p, list, length, why);
    else if (kind == 'b')
      p->block[p->blocks++] = named(&p->table, list, length, why);
    else
      *(n == 0 ? &p->x : &p->y) = named(&p->table, list, length, why);
    list += length + (list[length] == ',');
  }
  if (kind == 's' && n != 2)
    text_add(why, "smooth=: expected two columns");
}

static int read_word(struct pick *p, const char *word, struct text *why)
{
  const char *value = strchr(word, '=') ? strchr(word, '=') + 1 : word;

  if (strncmp(word, "columns=", 8) == 0 || strncmp(word, "blocks=", 7) == 0 || strncmp(word, "smooth=", 7) == 0)
    read_list(p, *word, value, why);
  else if (strncmp(word, "first=", 6) == 0)
    p->first = named(&p->table, value, strlen(value), why);
  else if (strncmp(word, "every=", 6) == 0) {
    if (!whole_number(value, 1, 1000000, &p->every))
      text_add(why, "'%s': expected a whole number from 1 to 1000000", word);
  } else if (strcmp(word, "head") == 0)
    p->head = 1;
  else if (is_condition(word))
    read_row_condition(&p->table, word, &p->where[p->conditions++], why);
  else
    text_add(why, "'%s': expected a condition as NAME=TEXT, columns=, blocks=, smooth=, first=, every=N or head", word);
  return why->length > 0 ? -1 : 0;
}

/* A row, with other values of x and y where `at` is not NULL. */
static void print_row(const struct pick *p, int row, const double at[2])
{
  const int n = p->columns ? p->columns : p->table.columns;

  for (int k = 0; k < n; k++) {
    const struct shown plain = { k, 1., "" }, *s = p->columns ? &p->shown[k] : &plain;
    double x;

    if (at && (s->column == p->x || s->column == p->y))
      printf(*s->format ? s->format : "%.7g", s->factor * at[s->column == p->y]);
    else if (*s->format && row >= 0 && csv_is_number(csv_cell(&p->table, row, s->column), &x))
      printf(s->format, s->factor * x);
    else
      fputs(row < 0 ? csv_name(&p->table, s->column) : csv_cell(&p->table, row, s->column), stdout);
    putchar(k + 1 < n ? ',' : '\n');
  }
}

/* --- a smooth curve through the rows of a block ------------------------------------
 * The centripetal curve of Catmull and Rom, in the logarithms of both coordinates: it passes
 * every row and swings beyond none. */

enum { BETWEEN = 9 }; /* steps from row to row */

struct place { double x, y; };

static struct place place_of(const struct pick *p, int row)
{
  return (struct place){ log(csv_number(&p->table, row, p->x)), log(csv_number(&p->table, row, p->y)) };
}

static struct place mixed(struct place a, struct place b, double from, double to, double at)
{
  const double w = (at - from) / (to - from);

  return (struct place){ a.x + w * (b.x - a.x), a.y + w * (b.y - a.y) };
}

static double knot(double before, struct place a, struct place b)
{
  return before + fmax(1e-9, sqrt(hypot(b.x - a.x, b.y - a.y)));
}

/* Between the second and the third of four places. */
static struct place curve_at(const struct place p[4], double part)
{
  const double t0 = 0., t1 = knot(t0, p[0], p[1]), t2 = knot(t1, p[1], p[2]), t3 = knot(t2, p[2], p[3]);
  const double t = t1 + part * (t2 - t1);
  const struct place a = mixed(p[0], p[1], t0, t1, t), b = mixed(p[1], p[2], t1, t2, t), c = mixed(p[2], p[3], t2, t3, t);

  return mixed(mixed(a, b, t0, t2, t), mixed(b, c, t1, t3, t), t1, t2, t);
}

/* From row block[k] to the next. */
static void print_between(const struct pick *p, const int block[], int n, int k)
{
  struct place place[4];

  for (int i = 0; i < 4; i++)
    place[i] = place_of(p, block[k + i - 1 < 0 ? 0 : k + i - 1 >= n ? n - 1 : k + i - 1]);
  for (int i = 1; i < BETWEEN; i++) {
    const struct place here = curve_at(place, (double)i / BETWEEN);
    const double at[2] = { exp(here.x), exp(here.y) };

    if (isfinite(at[0]) && isfinite(at[1]))
      print_row(p, block[k], at);
  }
}

/* --- rows ------------------------------------------------------------------------------- */

static void print_block(const struct pick *p, const int block[], int n)
{
  for (int k = 0; k < n; k++) {
    print_row(p, block[k], NULL);
    if (p->x >= 0 && k + 1 < n)
      print_between(p, block, n, k);
  }
}

static int differ(const struct pick *p, int row, int other, const int column[], int n)
{
  for (int k = 0; k < n; k++)
    if (strcmp(csv_cell(&p->table, row, column[k]), csv_cell(&p->table, other, column[k])) != 0)
      return 1;
  return 0;
}

/* A smooth curve is drawn through all rows: each has to be a point of it. */
static void check_smooth(const struct pick *p, struct text *why)
{
  const int numbers[] = { p->x, p->y };

  for (int row = 0; p->x >= 0 && (row = next_fitting(&p->table, row, p->where, p->conditions)) >= 0; row++)
    if (csv_needs_numbers(&p->table, row, numbers, 2, 0., why) != 0)
      return;
}

static void print_rows(const struct pick *p)
{
  int *block = must_allocate((size_t)(p->table.rows + 1) * sizeof *block), rows = 0, before = -1;
  long chosen = 0;

  if (p->head)
    print_row(p, -1, NULL);
  for (int row = 0; (row = next_fitting(&p->table, row, p->where, p->conditions)) >= 0; row++) {
    if (p->first >= 0 && before >= 0 && !differ(p, row, before, &p->first, 1))
      continue;
    if (before >= 0 && differ(p, row, before, p->block, p->blocks)) {
      print_block(p, block, rows);
      putchar('\n');
      rows = 0;
    }
    if (chosen++ % p->every == 0)
      block[rows++] = row;
    before = row;
  }
  print_block(p, block, rows);
  free(block);
}

static int run(int argc, char *argv[])
{
  struct pick p = { .first = -1, .x = -1, .y = -1, .every = 1 };
  struct text file = TEXT_NONE, why = TEXT_NONE;
  int status = MLG_OK;

  if (argc < 2) {
    fputs("usage: mlg pick TABLE [CONDITION ...] [columns=NAME,...] [blocks=NAME,...]; `mlg help pick` says more\n", stderr);
    return MLG_BAD_INPUT;
  }
  p.where = must_allocate((size_t)argc * sizeof *p.where);
  add_table_file(&file, argv[1]);
  if (csv_read(file.at, &p.table, &why) == 0)
    for (int i = 2; i < argc && read_word(&p, argv[i], &why) == 0; i++)
      ;
  if (why.length == 0)
    check_smooth(&p, &why);
  if (why.length > 0)
    status = MLG_BAD_INPUT;
  else {
    print_rows(&p);
    if (fflush(stdout) != 0 || ferror(stdout)) {
      text_add(&why, "cannot write the output");
      status = MLG_FAILED;
    }
  }
  if (status != MLG_OK)
    say_line("pick", why.at);
  csv_free(&p.table);
  free(p.where);
  text_free(&file);
  text_free(&why);
  return status;
}

const struct command command_pick = {
  "pick", "TABLE [CONDITION ...] [columns=NAME[*FACTOR][:FORMAT],...] [blocks=NAME,...]\n"
  "     [smooth=NAME,NAME] [first=NAME] [every=N] [head]",
  "rows and columns of a table in CSV, by the names of its columns",
  "TABLE: results/TABLE.csv, or a file with a slash in its name.  CONDITION: as for mlg cell, also\n"
  "with where= before it: NAME=TEXT or NAME!=TEXT (a number by its value, other text as the shell's\n"
  "* ? [] say, A|B one of them), NAME<X, <=, >, >=; all have to hold.  columns: these, in this\n"
  "order, times FACTOR and as FORMAT (.6g) if there is one.  first: only where the value of this\n"
  "column is another than in the row before.  blocks: an empty line where that of one of these\n"
  "changes, at which gnuplot lifts the pen.  smooth: rows of a smooth curve in these two columns\n"
  "between.  every: each Nth, from the first on.  head: the names first.  In gnuplot:\n"
  "  plot '< build/bin/mlg pick fig09 k_s=1e6 blocks=curve' using 7:8 with lines\n"
  "Status 2: no such column, a row with another number of cells, or for smooth one without numbers\n"
  "above 0.\n",
  run,
};
