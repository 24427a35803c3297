/* areas.c - mlg areas: zero-shimmy intervals over k_s as closed areas
 *
 * From one k_s to the next an interval goes on in the one of the same rank; where their
 * number changes, which a table resolves finely, in the widest that it overlaps.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cell.h"
#include "command.h"
#include "csv.h"

enum { MOST_AT_ONE = 32 };

struct slice { int row[MOST_AT_ONE], area[MOST_AT_ONE], n; };

struct area { struct text rows, lower, upper; };

struct areas {
  const struct csv *table;
  int k_s, c_lo, c_hi, width; /* its columns */
  struct area *area;
  int n;
};

/* A bound jumps where a region of shimmy is born within the interval. */
static void add_to_bound(const struct areas *a, struct text *bound, int column, int row, int before)
{
  const struct csv *t = a->table;
  const double c = csv_number(t, row, column);

  if (before >= 0 && fabs(csv_number(t, before, column) - c) > 0.05 * c)
    text_add(bound, "\n");
  text_add(bound, "%s,%s\n", csv_cell(t, row, a->k_s), csv_cell(t, row, column));
}

/* before: the row that it goes on from where the number of intervals changes, or -1 */
static void add_to_area(struct areas *a, int area, int row, int before)
{
  const struct csv *t = a->table;

  if (area == a->n) {
    a->area = must_resize(a->area, (size_t)(a->n + 1) * sizeof *a->area);
    a->area[a->n++] = (struct area){ TEXT_NONE, TEXT_NONE, TEXT_NONE };
  }
  add_to_bound(a, &a->area[area].lower, a->c_lo, row, before);
  add_to_bound(a, &a->area[area].upper, a->c_hi, row, before);
  text_add(&a->area[area].rows, "%s,%s,%s,%s\n", csv_cell(t, row, a->k_s), csv_cell(t, row, a->c_lo),
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
    add_to_area(a, now->area[i], now->row[i], from >= 0 && now->n != before->n ? before->row[from] : -1);
  }
}

/* A line in why: a row that is no interval, or too many at one k_s. */
static void join(struct areas *a, const struct condition condition[], int n, struct text *why)
{
  const int numbers[] = { a->k_s, a->c_lo, a->c_hi, a->width };
  struct slice before = { .n = 0 }, now = { .n = 0 };

  for (int row = 0; (row = next_fitting(a->table, row, condition, n)) >= 0; row++) {
    if (csv_needs_numbers(a->table, row, numbers, 4, -HUGE_VAL, why) != 0)
      return;
    if (csv_number(a->table, row, a->k_s) > 1e29)
      continue;
    if (now.n > 0 && strcmp(csv_cell(a->table, row, a->k_s), csv_cell(a->table, now.row[0], a->k_s)) != 0) {
      go_on(a, &before, &now);
      before = now;
      now.n = 0;
    }
    if (now.n == MOST_AT_ONE) {
      text_add(why, "%s: more than %d intervals at k_s = %s", a->table->file, MOST_AT_ONE, csv_cell(a->table, row, a->k_s));
      return;
    }
    now.row[now.n++] = row;
  }
  go_on(a, &before, &now);
}

/* The columns that there have to be. */
static int find_columns(struct areas *a, struct text *why)
{
  a->k_s = csv_column(a->table, "k_s");
  a->c_lo = csv_column(a->table, "c_lo");
  a->c_hi = csv_column(a->table, "c_hi");
  a->width = csv_column(a->table, "width");
  if (a->k_s < 0 || a->c_lo < 0 || a->c_hi < 0 || a->width < 0)
    text_add(why, "%s: expected columns k_s, c_lo, c_hi and width", a->table->file);
  return why->length > 0 ? -1 : 0;
}

static void print_areas(const struct areas *a, int bounds)
{
  for (int i = 0; i < a->n; i++)
    if (bounds)
      printf("%s\n%s\n", a->area[i].lower.at, a->area[i].upper.at);
    else
      printf("%s\n", a->area[i].rows.at);
}

static void free_areas(struct areas *a)
{
  for (int i = 0; i < a->n; i++) {
    text_free(&a->area[i].rows);
    text_free(&a->area[i].lower);
    text_free(&a->area[i].upper);
  }
  free(a->area);
}

static int run(int argc, char *argv[])
{
  const int bounds = argc > 2 && strcmp(argv[argc - 1], "bounds") == 0;
  struct condition *condition = must_allocate((size_t)argc * sizeof *condition);
  struct text file = TEXT_NONE, why = TEXT_NONE;
  struct csv t = { .file = NULL };
  struct areas a = { .table = &t };
  int n = 0;

  if (argc < 2)
    text_add(&why, "expected TABLE [CONDITION ...] [bounds]");
  else {
    add_table_file(&file, argv[1]);
    if (csv_read(file.at, &t, &why) == 0 && find_columns(&a, &why) == 0)
      for (int i = 2; i < argc - bounds && why.length == 0; i++) {
        if (!is_condition(argv[i]))
          text_add(&why, "'%s': expected COLUMN=VALUE, or bounds as the last word", argv[i]);
        else
          read_row_condition(&t, argv[i], &condition[n++], &why);
      }
  }
  if (why.length == 0)
    join(&a, condition, n, &why);
  if (why.length == 0)
    print_areas(&a, bounds);
  else
    say_line("areas", why.at);
  free_areas(&a);
  n = why.length > 0 ? MLG_BAD_INPUT : MLG_OK;
  csv_free(&t);
  free(condition);
  text_free(&file);
  text_free(&why);
  return n;
}

const struct command command_areas = {
  "areas", "TABLE [CONDITION ...] [bounds]",
  "zero-shimmy intervals over k_s as closed areas",
  "TABLE with the columns k_s, c_lo, c_hi, width, its rows by k_s; CONDITION as for mlg cell, say\n"
  "layout=li1 b=70.  Prints k_s,c_lo,c_hi,width, an empty line behind each area; bounds: k_s,c_d of\n"
  "their lower and upper bounds as lines, an empty line behind each and where one jumps.\n",
  run,
};
