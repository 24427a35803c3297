/* pick.c - mlg pick: rows and columns of a table in CSV, for pictures and scripts */
#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "autofile.h"
#include "command.h"
#include "text.h"
#include "uses.h"

enum { MOST_CELLS = 64, MOST_CONDITIONS = 16 };

/* NAME=GLOB, NAME!=GLOB, NAME<NUMBER, NAME>NUMBER */
struct condition { char name[64]; int relation, column; const char *text; double number; };

/* NAME*FACTOR:FORMAT; without format and factor a cell stays as it is. */
struct column { char name[64], format[12]; int column; double factor; };

struct pick {
  const char *file;
  struct condition where[MOST_CONDITIONS];
  int conditions;
  struct column shown[MOST_CELLS], block[MOST_CELLS], first;
  int columns, blocks, firsts, head;
  long every;
};

struct row { char *cell[MOST_CELLS]; int cells; };

static int take_name(char name[64], const char *text, size_t length)
{
  if (length == 0 || length > 63)
    return -1;
  memcpy(name, text, length);
  name[length] = '\0';
  return 0;
}

static int read_condition(struct pick *p, const char *text, struct text *why)
{
  const size_t name = strcspn(text, "!=<>");
  struct condition *c = &p->where[p->conditions];
  const char *rest = text + name;

  if (p->conditions == MOST_CONDITIONS || take_name(c->name, text, name) != 0 || !*rest || (*rest == '!' && rest[1] != '=')) {
    text_add(why, "where=%s: expected NAME=TEXT, NAME!=TEXT, NAME<NUMBER or NAME>NUMBER", text);
    return -1;
  }
  c->relation = *rest;
  c->text = rest + (*rest == '!' ? 2 : 1);
  if (!af_number(c->text, strlen(c->text), &c->number)) {
    c->number = NAN;
    if (c->relation == '<' || c->relation == '>') {
      text_add(why, "where=%s: '%s' is no number", text, c->text);
      return -1;
    }
  }
  p->conditions++;
  return 0;
}

static int read_column(struct column *c, const char *text, size_t length, struct text *why)
{
  const size_t name = strcspn(text, "*:,");
  const char *colon = memchr(text, ':', length);
  const size_t before = colon ? (size_t)(colon - text) : length;
  const char *format = colon ? colon + 1 : "";
  const size_t digits = colon ? strspn(format + (*format == '.'), "0123456789") : 0;
  int good;

  *c = (struct column){ .factor = 1. };
  good = take_name(c->name, text, name) == 0;
  if (good && name < before) {
    good = af_number(text + name + 1, before - name - 1, &c->factor) && isfinite(c->factor);
    strcpy(c->format, "%.10g");
  }
  if (good && colon) {
    const size_t n = length - before - 1;

    good = *format == '.' && digits > 0 && digits < 3 && n == digits + 2 && strchr("gef", format[n - 1]);
    if (good)
      sprintf(c->format, "%%%.*s", (int)n, format);
  }
  if (!good)
    text_add(why, "'%.*s': expected NAME, NAME:.6g or NAME*FACTOR:.6g", (int)length, text);
  return good ? 0 : -1;
}

static int read_columns(struct column column[], int *n, const char *list, struct text *why)
{
  for (*n = 0; *list && *n < MOST_CELLS; (*n)++) {
    const size_t length = strcspn(list, ",");

    if (read_column(&column[*n], list, length, why) != 0)
      return -1;
    list += length + (list[length] == ',');
  }
  return 0;
}

static int read_words(struct pick *p, int argc, char *argv[], struct text *why)
{
  int status = 0;

  *p = (struct pick){ .every = 1 };
  for (int i = 1; i < argc && status == 0; i++) {
    const char *word = argv[i];

    if (strncmp(word, "where=", 6) == 0)
      status = read_condition(p, word + 6, why);
    else if (strncmp(word, "columns=", 8) == 0)
      status = read_columns(p->shown, &p->columns, word + 8, why);
    else if (strncmp(word, "blocks=", 7) == 0)
      status = read_columns(p->block, &p->blocks, word + 7, why);
    else if (strncmp(word, "first=", 6) == 0)
      status = read_columns(&p->first, &p->firsts, word + 6, why);
    else if (strncmp(word, "every=", 6) == 0 && whole_number(word + 6, 1, 1000000, &p->every))
      ;
    else if (strcmp(word, "head") == 0)
      p->head = 1;
    else if (!p->file && !(strchr(word, '=') && !strchr(word, '/')))
      p->file = word;
    else {
      text_add(why, "'%s': expected TABLE [where=NAME=TEXT] [columns=NAME,...] [blocks=NAME,...] [first=NAME] [every=N] [head]", word);
      status = -1;
    }
  }
  if (status == 0 && !p->file) {
    text_add(why, "which table?");
    status = -1;
  }
  return status;
}

/* Cuts a line into cells; -1: too many of them. */
static int cut(char *line, struct row *row)
{
  row->cells = 0;
  for (char *t = line; t; row->cells++) {
    if (row->cells == MOST_CELLS)
      return -1;
    row->cell[row->cells] = t;
    t = strchr(t, ',');
    if (t)
      *t++ = '\0';
  }
  return 0;
}

static int find_column(const struct pick *p, const struct row *names, const char *name, int *column, struct text *why)
{
  for (*column = 0; *column < names->cells; ++*column)
    if (strcmp(names->cell[*column], name) == 0)
      return 0;
  text_add(why, "%s has no column '%s'; it has", p->file, name);
  for (int k = 0; k < names->cells; k++)
    text_add(why, "%s %s", k ? "," : "", names->cell[k]);
  return -1;
}

static int find_columns(struct pick *p, const struct row *names, struct text *why)
{
  int status = 0;

  for (int k = 0; k < p->conditions && status == 0; k++)
    status = find_column(p, names, p->where[k].name, &p->where[k].column, why);
  for (int k = 0; k < p->columns && status == 0; k++)
    status = find_column(p, names, p->shown[k].name, &p->shown[k].column, why);
  for (int k = 0; k < p->blocks && status == 0; k++)
    status = find_column(p, names, p->block[k].name, &p->block[k].column, why);
  if (p->firsts && status == 0)
    status = find_column(p, names, p->first.name, &p->first.column, why);
  return status;
}

static int holds(const struct condition *c, const char *cell)
{
  double x;
  const int is_number = af_number(cell, strlen(cell), &x);
  int equal;

  if (c->relation == '<')
    return is_number && x < c->number;
  if (c->relation == '>')
    return is_number && x > c->number;
  if (is_number && isfinite(x) && isfinite(c->number))
    equal = fabs(x - c->number) <= 1e-12 * fabs(c->number);
  else
    equal = fnmatch(c->text, cell, 0) == 0;
  return equal == (c->relation == '=');
}

static int is_chosen(const struct pick *p, const struct row *row)
{
  for (int k = 0; k < p->conditions; k++)
    if (!holds(&p->where[k], row->cell[p->where[k].column]))
      return 0;
  return 1;
}

static int differ(const struct row *a, const struct row *b, const struct column column[], int n)
{
  for (int k = 0; k < n; k++)
    if (strcmp(a->cell[column[k].column], b->cell[column[k].column]) != 0)
      return 1;
  return 0;
}

/* A row of the output; the names of the columns stay as they are. */
static void add_row(const struct pick *p, const struct row *row, int as_names, struct text *out)
{
  const int n = p->columns ? p->columns : row->cells;

  for (int k = 0; k < n; k++) {
    const struct column *c = p->columns ? &p->shown[k] : NULL;
    const char *cell = row->cell[c ? c->column : k];
    double x;

    if (k > 0)
      text_add(out, ",");
    if (!as_names && c && *c->format && af_number(cell, strlen(cell), &x))
      text_add(out, c->format, x * c->factor);
    else
      text_add(out, "%s", cell);
  }
  text_add(out, "\n");
}

/* Returns 0, or -1 with a line in why. */
static int pick_rows(struct pick *p, char *table, struct text *out, struct text *why)
{
  struct row names = { .cells = 0 }, before = { .cells = 0 }, row;
  long line = 0, chosen = 0;

  for (char *t = table, *end; t && *t; t = end) {
    end = strchr(t, '\n');
    if (end)
      *end++ = '\0';
    line++;
    if (*t == '#')
      continue;
    if (cut(t, &row) != 0 || (names.cells > 0 && row.cells != names.cells)) {
      text_add(why, "%s:%ld: a row of %d cells under %d names", p->file, line, row.cells, names.cells);
      return -1;
    }
    if (names.cells == 0) {
      names = row;
      if (find_columns(p, &names, why) != 0)
        return -1;
      if (p->head)
        add_row(p, &names, 1, out);
      continue;
    }
    if (!is_chosen(p, &row) || (p->firsts && before.cells > 0 && !differ(&row, &before, &p->first, 1)))
      continue;
    if (before.cells > 0 && differ(&row, &before, p->block, p->blocks))
      text_add(out, "\n");
    if (chosen++ % p->every == 0)
      add_row(p, &row, 0, out);
    before = row;
  }
  if (names.cells == 0)
    text_add(why, "%s: no names of columns in it", p->file);
  return names.cells == 0 ? -1 : 0;
}

static int run(int argc, char *argv[])
{
  struct text why = TEXT_NONE, table = TEXT_NONE, out = TEXT_NONE;
  struct pick p;
  int status = MLG_BAD_INPUT;

  if (read_words(&p, argc, argv, &why) == 0 && read_file(p.file, &table, &why) == 0) {
    note_use(p.file);
    if (pick_rows(&p, table.at, &out, &why) == 0) {
      status = MLG_OK;
      if (out.length > 0)
        fputs(out.at, stdout);
    }
  }
  if (status == MLG_OK && (fflush(stdout) != 0 || ferror(stdout))) {
    text_add(&why, "cannot write the output");
    status = MLG_FAILED;
  }
  if (why.length > 0)
    say_line("pick", why.at);
  text_free(&why);
  text_free(&table);
  text_free(&out);
  return status;
}

const struct command command_pick = {
  "pick", "TABLE [where=NAME=TEXT]... [columns=NAME[*FACTOR][:FORMAT],...] [blocks=NAME,...]\n"
  "     [first=NAME] [every=N] [head]",
  "rows and columns of a table in CSV, by the names of its columns",
  "where: rows in which all of these hold: NAME=TEXT or NAME!=TEXT (a number by its value, other\n"
  "text as the shell's * ? [] say), NAME<NUMBER, NAME>NUMBER.  columns: these, in this order,\n"
  "times FACTOR and as FORMAT (.6g) if there is one.  first: only where the value of this column\n"
  "is another than in the row before.  blocks: an empty line where that of one of these changes,\n"
  "for gnuplot.  every: each Nth of them, from the first on.  head: their names first.  Lines\n"
  "with # are passed over.  Status 2: no such column, or a row with another number of cells.\n",
  run,
};
