/* targets.c - mlg targets: the paper's numbers against ours
 *
 * A row of tests/targets.csv says by its last column, `cell`, where this run's value stands
 * (cell.h).  It is read from the tables the runs left, never from the targets.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cell.h"
#include "command.h"
#include "csv.h"

/* The columns of the targets. */
enum { ID, QUANTITY, UNIT, PAPER, CONVERGED, TOLERANCE, CELL, NEEDED };

static const char *const needed[NEEDED] = { "id", "quantity", "unit", "paper", "converged", "tolerance", "cell" };

/* tolerance: "-" for a text, "1e-5" relative, "0.01 m/s" in the unit */
static int passes(const char *computed, const char *converged, const char *tolerance)
{
  double x, y, scale = 1.;
  char *unit;
  const double limit = strtod(tolerance, &unit);

  if (!*computed)
    return 0;
  if (strcmp(tolerance, "-") == 0)
    return strcmp(computed, converged) == 0;
  if (!csv_is_number(computed, &x) || !csv_is_number(converged, &y))
    return 0;
  if (!*unit)
    scale = fabs(y);
  return fabs(x - y) <= limit * scale;
}

/* Both forms of a row; returns whether it passes, or -1 with a line in why. */
static int add_row(const struct csv *t, int row, const int column[], struct text *table, struct text *shown, struct text *why)
{
  const char *cell[NEEDED], *pass;
  struct text value = TEXT_NONE, missing = TEXT_NONE;
  int status, passed;

  for (int i = 0; i < NEEDED; i++)
    cell[i] = csv_cell(t, row, column[i]);
  status = cell_value_of(cell[CELL], NULL, &value, &missing);
  if (status == CELL_MISSING)
    text_clear(&value);
  passed = status != CELL_WRONG && passes(value.at, cell[CONVERGED], cell[TOLERANCE]);
  pass = passed ? "yes" : "no";
  if (status == CELL_WRONG)
    text_add(why, "%s: %s: %s", t->file, cell[ID], missing.at);
  else {
    text_add(table, "%s,%s,%s,%s,%s,%s,%s,%s\n", cell[ID], cell[QUANTITY], cell[UNIT], cell[PAPER],
             cell[CONVERGED], value.at, cell[TOLERANCE], pass);
    text_add(shown, "%-10s %-48s %-11s %14s %14s %14s  %-10s %s\n", cell[ID], cell[QUANTITY], cell[UNIT],
             cell[PAPER], cell[CONVERGED], value.at, cell[TOLERANCE], pass);
  }
  text_free(&value);
  text_free(&missing);
  return status == CELL_WRONG ? -1 : passed;
}

/* Puts the table in place unless it is there already. */
static int put(const char *file, const struct text *table, struct text *why)
{
  struct text before = TEXT_NONE, none = TEXT_NONE;
  int status = 0;

  if (read_file(file, &before, &none) != 0 || before.length != table->length || memcmp(before.at, table->at, table->length) != 0)
    status = write_file(file, table->at, table->length, why);
  text_free(&before);
  text_free(&none);
  return status;
}

static int run(int argc, char *argv[])
{
  struct text table = TEXT_NONE, shown = TEXT_NONE, why = TEXT_NONE, file = TEXT_NONE;
  struct csv t;
  int column[NEEDED], missed = 0, status;

  (void)argv;
  if (argc > 1) {
    fputs("usage: mlg targets\n", stderr);
    return MLG_BAD_INPUT;
  }
  text_add(&file, "%stests/targets.csv", checkout());
  status = csv_read(file.at, &t, &why);
  for (int i = 0; i < NEEDED && status == 0; i++)
    if ((column[i] = csv_column(&t, needed[i])) < 0) {
      text_add(&why, "%s has no column %s", file.at, needed[i]);
      status = -1;
    }
  text_add(&table, "# Paper against this run. paper: what its text says (figure: shown, not printed); converged: the value to reach;\n"
                   "# computed: this run; tolerance: relative, or in the unit where it names it.\n"
                   "id,quantity,unit,paper,converged,computed,tolerance,pass\n");
  text_add(&shown, "%-10s %-48s %-11s %14s %14s %14s  %-10s %s\n", "id", "quantity", "unit", "paper", "converged", "computed", "tolerance", "pass");
  for (int row = 0; row < t.rows && status == 0; row++) {
    const int passed = add_row(&t, row, column, &table, &shown, &why);

    if (passed < 0)
      status = -1;
    else
      missed += !passed;
  }
  text_clear(&file);
  text_add(&file, "%sresults/targets.csv", checkout());
  if (status == 0)
    status = put(file.at, &table, &why);
  if (status == 0) {
    fputs(shown.at, stdout);
    fflush(stdout);
    if (missed > 0)
      fprintf(stderr, "%d target(s) missed\n", missed);
  } else
    say_line("targets", why.at);
  csv_free(&t);
  text_free(&table);
  text_free(&shown);
  text_free(&why);
  text_free(&file);
  return status == 0 && missed == 0 ? MLG_OK : MLG_FAILED;
}

const struct command command_targets = {
  "targets", "",
  "the paper's numbers against ours",
  "Joins tests/targets.csv, whose column `cell` says where a value stands (mlg help cell), with\n"
  "the tables in results/.  Writes results/targets.csv, prints it readably; status 1 if a row fails.\n",
  run,
};
