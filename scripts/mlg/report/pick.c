/* pick.c - mlg pick: rows of a table, for a picture; mlg areas: intervals over k_s as areas */
#include <math.h>
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

/* What pick is asked for beside conditions. */
struct how { int block, x, y; }; /* columns, or -1 */

/* blocks=COLUMN, smooth=COLUMN,COLUMN; 0: word is none of these */
static int read_how(const struct csv *t, const char *word, struct how *how, struct text *why)
{
  struct text first = TEXT_NONE;
  const char *comma = strchr(word, ',');

  if (strncmp(word, "blocks=", 7) == 0) {
    if ((how->block = csv_column(t, word + 7)) < 0)
      text_add(why, "'%s': %s has no such column", word, t->file);
    return 1;
  }
  if (strncmp(word, "smooth=", 7) != 0)
    return 0;
  if (comma) {
    text_append(&first, word + 7, (size_t)(comma - word - 7));
    how->x = csv_column(t, first.at);
    how->y = csv_column(t, comma + 1);
  }
  if (how->x < 0 || how->y < 0)
    text_add(why, "'%s': expected two columns of %s", word, t->file);
  text_free(&first);
  return 1;
}

/* The words behind the table: conditions, of which it returns the number, or -1 and has said
 * why; how may be NULL. */
static int read_words(const char *who, const struct csv *t, int argc, char *argv[], struct condition condition[],
                      struct how *how)
{
  struct text why = TEXT_NONE;
  int n = 0;

  for (int i = 0; i < argc && why.length == 0; i++) {
    if (how && read_how(t, argv[i], how, &why))
      continue;
    if (!is_condition(argv[i]))
      text_add(&why, "'%s': expected COLUMN=VALUE%s", argv[i], how ? ", blocks=COLUMN or smooth=COLUMN,COLUMN" : "");
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

/* --- a smooth curve through the rows of a block ------------------------------------
 * The centripetal curve of Catmull and Rom, in the logarithms of both coordinates: it passes
 * every row and swings beyond none. */

enum { BETWEEN = 9 }; /* steps from row to row */

struct place { double x, y; };

static struct place place_of(const struct csv *t, int row, const struct how *how)
{
  return (struct place){ log(csv_number(t, row, how->x)), log(csv_number(t, row, how->y)) };
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
static void print_between(const struct csv *t, const int block[], int n, int k, const struct how *how)
{
  struct place p[4];

  for (int i = 0; i < 4; i++)
    p[i] = place_of(t, block[k + i - 1 < 0 ? 0 : k + i - 1 >= n ? n - 1 : k + i - 1], how);
  for (int i = 1; i < BETWEEN; i++) {
    const struct place at = curve_at(p, (double)i / BETWEEN);

    if (!isfinite(at.x) || !isfinite(at.y))
      continue;
    for (int column = 0; column < t->columns; column++) {
      if (column == how->x || column == how->y)
        printf("%.7g", exp(column == how->x ? at.x : at.y));
      else
        fputs(csv_cell(t, block[k], column), stdout);
      putchar(column + 1 < t->columns ? ',' : '\n');
    }
  }
}

static void print_block(const struct csv *t, const int block[], int n, const struct how *how)
{
  for (int k = 0; k < n; k++) {
    print_row(t, block[k]);
    if (how->x >= 0 && k + 1 < n)
      print_between(t, block, n, k, how);
  }
}

static void print_blocks(const struct csv *t, const struct condition condition[], int n, const struct how *how)
{
  int *block = must_allocate((size_t)(t->rows + 1) * sizeof *block), rows = 0;

  for (int row = 0; (row = next_fitting(t, row, condition, n)) >= 0; row++) {
    if (how->block >= 0 && rows > 0 && strcmp(csv_cell(t, row, how->block), csv_cell(t, block[0], how->block)) != 0) {
      print_block(t, block, rows, how);
      putchar('\n');
      rows = 0;
    }
    block[rows++] = row;
  }
  print_block(t, block, rows, how);
  free(block);
}

static int pick(int argc, char *argv[])
{
  struct condition *condition = must_allocate((size_t)argc * sizeof *condition);
  struct how how = { -1, -1, -1 };
  struct csv t;
  int n = -1;

  if (argc < 2) {
    fputs("usage: mlg pick TABLE [CONDITION ...] [blocks=COLUMN] [smooth=COLUMN,COLUMN]\n", stderr);
    free(condition);
    return MLG_BAD_INPUT;
  }
  if (read_or_say("pick", argv[1], &t) == MLG_OK)
    n = read_words("pick", &t, argc - 2, argv + 2, condition, &how);
  if (n >= 0)
    print_blocks(&t, condition, n, &how);
  csv_free(&t);
  free(condition);
  return n < 0 ? MLG_BAD_INPUT : MLG_OK;
}

const struct command command_pick = {
  "pick", "TABLE [CONDITION ...] [blocks=COLUMN] [smooth=COLUMN,COLUMN]",
  "rows of a table of results/, for a picture",
  "TABLE and CONDITION as for mlg cell; all must fit.  Prints the rows without the table's head;\n"
  "blocks=COLUMN puts an empty line where its cell changes, at which gnuplot lifts the pen;\n"
  "smooth=X,Y puts rows of a smooth curve in these two columns between:\n"
  "  gnuplot -p -e \"set datafile separator ','; plot '< build/bin/mlg pick fig09 k_s=1e6 blocks=curve' using 7:8 with lines\"\n",
  pick,
};

/* --- areas ----------------------------------------------------------------------------
 * From one k_s to the next an interval goes on in the one of the same rank; where their
 * number changes, which a table resolves finely, in the widest that it overlaps. */

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
  const int bounds = argc > 2 && strcmp(argv[argc - 1], "bounds") == 0;
  int n = -1;

  if (argc < 2) {
    fputs("usage: mlg areas TABLE [CONDITION ...] [bounds]\n", stderr);
    free(condition);
    return MLG_BAD_INPUT;
  }
  if (read_or_say("areas", argv[1], &t) == MLG_OK)
    n = read_words("areas", &t, argc - 2 - bounds, argv + 2, condition, NULL);
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
    if (bounds)
      printf("%s\n%s\n", a.area[i].lower.at, a.area[i].upper.at);
    else
      printf("%s\n", a.area[i].rows.at);
    text_free(&a.area[i].rows);
    text_free(&a.area[i].lower);
    text_free(&a.area[i].upper);
  }
  free(a.area);
  csv_free(&t);
  free(condition);
  return n < 0 ? MLG_BAD_INPUT : MLG_OK;
}

const struct command command_areas = {
  "areas", "TABLE [CONDITION ...] [bounds]",
  "zero-shimmy intervals over k_s as closed areas",
  "TABLE with the columns k_s, c_lo, c_hi, width, its rows by k_s; CONDITION as for mlg cell, say\n"
  "layout=li1 b=70.  Prints k_s,c_lo,c_hi,width, an empty line behind each area; bounds: k_s,c_d of\n"
  "their lower and upper bounds as lines, an empty line behind each and where one jumps.\n",
  areas,
};
