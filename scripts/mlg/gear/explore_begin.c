/* explore_begin.c - designs to begin a search at, from a table as `mlg explore` prints it */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "explorer.h"
#include "../report/csv.h"

static _Noreturn void slip(const char *word, const struct text *why)
{
  refuse("explore", word, "%.400s", why->at);
}

/* A value of at least 0 in the column of that name; infinite only where it may be. */
static double number(const struct csv *t, int row, const char *name, bool may_be_infinite, const char *word)
{
  const int column = csv_column(t, name);
  struct text why = TEXT_NONE;
  double value;

  if (column < 0)
    text_add(&why, "%s has no column %s; expected the columns that explore prints for this device", t->file, name);
  else if (value = csv_number(t, row, column), value >= 0. && (may_be_infinite || isfinite(value)))
    return value;
  else
    text_add(&why, "%s, row %d: '%.40s': expected a %s of at least 0", t->file, row + 1, csv_cell(t, row, column), name);
  slip(word, &why);
}

static void give(struct explorer *e, const struct csv *t, int row, const char *word)
{
  const double k_s = e->has_k_s ? number(t, row, "k_s", true, word) : 0., b = e->has_b ? number(t, row, "b", false, word) : 0.;
  const double c_d = explore_middle(number(t, row, "c_lo", false, word), number(t, row, "c_hi", true, word));
  double x[EXPLORE_VARIABLES];

  for (int i = 0; i < e->others; i++) {
    char name[64];

    snprintf(name, sizeof name, "%.*s", (int)strcspn(e->other[i]->text, "="), e->other[i]->text);
    e->other[i]->value = number(t, row, name, true, word);
  }
  explore_place(e, k_s, b, c_d, x);
  explore_give(e, x);
}

void explore_begin_at(struct explorer *e, const char *word)
{
  struct text why = TEXT_NONE;
  struct csv t;

  if (csv_read(strchr(word, '=') + 1, &t, &why) != 0)
    slip(word, &why);
  if (t.rows > EXPLORE_GIVEN - 2) {
    text_add(&why, "%d designs; %d are most", t.rows, EXPLORE_GIVEN - 2);
    slip(word, &why);
  }
  for (int row = 0; row < t.rows; row++)
    give(e, &t, row, word);
  csv_free(&t);
}
