/* pick.c - mlg pick: rows of a table, for gnuplot; mlg areas: intervals over k_s as areas */
#include <stdlib.h>
#include <string.h>

#include "cell.h"
#include "command.h"
#include "csv.h"

static int read_or_say(const char *who, const char *name, struct csv *table)
{
  struct text file = TEXT_NONE, why = TEXT_NONE;
  int status;

  add_table_file(&file, name);
  status = csv_read(file.at, table, &why);
  if (status != 0)
    say_line(who, why.at);
  text_free(&file);
  text_free(&why);
  return status == 0 ? MLG_OK : MLG_BAD_INPUT;
}

/* The words behind the table: conditions, and one column by another word. */
static int read_words(const char *who, const struct csv *t, int argc, char *argv[], struct condition condition[],
                      const char *word, int *column)
{
  struct text why = TEXT_NONE;
  const size_t length = strlen(word);
  int n = 0;

  *column = -1;
  for (int i = 0; i < argc && why.length == 0; i++) {
    if (length > 0 && strncmp(argv[i], word, length) == 0) {
      *column = csv_column(t, argv[i] + length);
      if (*column < 0)
        text_add(&why, "'%s': %s has no such column", argv[i], t->file);
    } else if (!is_condition(argv[i]))
      text_add(&why, "'%s': expected COLUMN=VALUE%s%s", argv[i], length > 0 ? " or " : "", word);
    else
      read_row_condition(t, argv[i], &condition[n++], &why);
  }
  if (why.length > 0) {
    say_line(who, why.at);
    n = -1;
  }
  text_free(&why);
  return n;
}

static void print_row(const struct csv *t, int row)
{
  for (int i = 0; i < t->columns; i++)
    printf("%s%s", csv_cell(t, row, i), i + 1 < t->columns ? "," : "\n");
}

static int pick(int argc, char *argv[])
{
  struct condition *condition = must_allocate((size_t)argc * sizeof *condition);
  struct csv t;
  int status, n, block, last = -1;

  if (argc < 2) {
    fputs("usage: mlg pick TABLE [CONDITION ...] [blocks=COLUMN]\n", stderr);
    free(condition);
    return MLG_BAD_INPUT;
  }
  status = read_or_say("pick", argv[1], &t);
  n = status == MLG_OK ? read_words("pick", &t, argc - 2, argv + 2, condition, "blocks=", &block) : -1;
  for (int row = 0; n >= 0 && (row = next_fitting(&t, row, condition, n)) >= 0; row++) {
    if (block >= 0 && last >= 0 && strcmp(csv_cell(&t, row, block), csv_cell(&t, last, block)) != 0)
      putchar('\n');
    print_row(&t, row);
    last = row;
  }
  csv_free(&t);
  free(condition);
  return n < 0 ? MLG_BAD_INPUT : MLG_OK;
}

const struct command command_pick = {
  "pick", "TABLE [CONDITION ...] [blocks=COLUMN]",
  "rows of a table of results/, for a picture",
  "TABLE and CONDITION as for mlg cell; all must fit.  Prints the rows without the table's head;\n"
  "blocks=COLUMN puts an empty line where its cell changes, at which gnuplot lifts the pen:\n"
  "  gnuplot -p -e \"set datafile separator ','; plot '< build/bin/mlg pick fig09 k_s=1e6 blocks=curve' using 7:8 with lines\"\n",
  pick,
};

/* --- areas ----------------------------------------------------------------------------
 * From one k_s to the next an interval goes on in the one of the same rank; where their
 * number changes, which a table resolves finely, in the widest that it overlaps. */

enum { MOST_AT_ONE = 32 };

struct slice { int row[MOST_AT_ONE], area[MOST_AT_ONE], n; };

struct areas {
  const struct csv *table;
  int k_s, c_lo, c_hi, width; /* its columns */
  struct text *area;
  int n;
};

static void add_to_area(struct areas *a, int area, int row)
{
  const struct csv *t = a->table;

  if (area == a->n) {
    a->area = must_resize(a->area, (size_t)(a->n + 1) * sizeof *a->area);
    a->area[a->n++] = (struct text)TEXT_NONE;
  }
  text_add(&a->area[area], "%s,%s,%s,%s\n", csv_cell(t, row, a->k_s), csv_cell(t, row, a->c_lo),
           csv_cell(t, row, a->c_hi), csv_cell(t, row, a->width));
}

static int best_of(const struct areas *a, const struct slice *before, const int taken[], int row)
{
  const struct csv *t = a->table;
  const double lo = csv_number(t, row, a->c_lo), hi = csv_number(t, row, a->c_hi);
  double widest = 0.;
  int best = -1;

  for (int j = 0; j < before->n; j++) {
    const double lo_j = csv_number(t, before->row[j], a->c_lo), hi_j = csv_number(t, before->row[j], a->c_hi);

    if (!taken[j] && lo_j < hi && hi_j > lo && hi_j - lo_j > widest) {
      widest = hi_j - lo_j;
      best = j;
    }
  }
  return best;
}

static void go_on(struct areas *a, const struct slice *before, struct slice *now)
{
  int taken[MOST_AT_ONE] = { 0 };

  for (int i = 0; i < now->n; i++) {
    const int from = now->n == before->n ? i : best_of(a, before, taken, now->row[i]);

    if (from >= 0)
      taken[from] = 1;
    now->area[i] = from >= 0 ? before->area[from] : a->n;
    add_to_area(a, now->area[i], now->row[i]);
  }
}

static void join(struct areas *a, const struct condition condition[], int n)
{
  struct slice before = { .n = 0 }, now = { .n = 0 };
  double x;

  for (int row = 0; (row = next_fitting(a->table, row, condition, n)) >= 0; row++) {
    if (!csv_is_number(csv_cell(a->table, row, a->k_s), &x) || x > 1e29)
      continue;
    if (now.n > 0 && strcmp(csv_cell(a->table, row, a->k_s), csv_cell(a->table, now.row[0], a->k_s)) != 0) {
      go_on(a, &before, &now);
      before = now;
      now.n = 0;
    }
    if (now.n < MOST_AT_ONE)
      now.row[now.n++] = row;
  }
  go_on(a, &before, &now);
}

static int areas(int argc, char *argv[])
{
  struct condition *condition = must_allocate((size_t)argc * sizeof *condition);
  struct areas a = { .area = NULL };
  struct csv t;
  int status, n, none;

  if (argc < 2) {
    fputs("usage: mlg areas TABLE [CONDITION ...]\n", stderr);
    free(condition);
    return MLG_BAD_INPUT;
  }
  status = read_or_say("areas", argv[1], &t);
  n = status == MLG_OK ? read_words("areas", &t, argc - 2, argv + 2, condition, "", &none) : -1;
  if (n >= 0) {
    a.table = &t;
    a.k_s = csv_column(&t, "k_s");
    a.c_lo = csv_column(&t, "c_lo");
    a.c_hi = csv_column(&t, "c_hi");
    a.width = csv_column(&t, "width");
    if (a.k_s < 0 || a.c_lo < 0 || a.c_hi < 0 || a.width < 0) {
      fprintf(stderr, "areas: %s: expected columns k_s, c_lo, c_hi and width\n", t.file);
      n = -1;
    } else
      join(&a, condition, n);
  }
  for (int i = 0; i < a.n; i++) {
    printf("%s\n", a.area[i].at);
    text_free(&a.area[i]);
  }
  free(a.area);
  csv_free(&t);
  free(condition);
  return n < 0 ? MLG_BAD_INPUT : MLG_OK;
}

const struct command command_areas = {
  "areas", "TABLE [CONDITION ...]",
  "zero-shimmy intervals over k_s as closed areas",
  "TABLE with the columns k_s, c_lo, c_hi, width, its rows by k_s; CONDITION as for mlg cell, say\n"
  "layout=li1 b=70.  Prints k_s,c_lo,c_hi,width, an empty line behind each area.\n",
  areas,
};
