/* rows.c - mlg rows: the points of runs as rows of a table; mlg point: one of them */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "branch.h"
#include "command.h"
#include "select.h"

/* What was asked for. */
struct rows {
  char **run;
  int runs;
  struct columns columns;
  struct choice choice;
  const char *prefix;
  long every, phase;
  int reverse;
  char types[128], kept[128], only[128];
};

/* ",HB,LP," of "HB,LP" */
static int read_types(char room[128], const char *list, const char **to, struct text *why)
{
  if (strlen(list) > 120 || !*list) {
    text_add(why, "'%s': expected types as HB,LP", list);
    return -1;
  }
  snprintf(room, 128, ",%s,", list);
  *to = room;
  return 0;
}

static int read_word(struct rows *r, const char *word, struct text *why)
{
  if (strncmp(word, "columns=", 8) == 0)
    return read_columns(word + 8, &r->columns, why);
  if (strncmp(word, "prefix=", 7) == 0)
    r->prefix = word + 7;
  else if (strncmp(word, "where=", 6) == 0)
    return read_condition(&r->choice, word + 6, why);
  else if (strncmp(word, "types=", 6) == 0)
    return read_types(r->types, word + 6, &r->choice.types, why);
  else if (strncmp(word, "keep=", 5) == 0)
    return read_types(r->kept, word + 5, &r->choice.kept, why);
  else if (strncmp(word, "only=", 5) == 0)
    return read_types(r->only, word + 5, &r->choice.only, why);
  else if (strncmp(word, "every=", 6) == 0 && whole_number(word + 6, 1, 1000000, &r->every))
    return 0;
  else if (strncmp(word, "phase=", 6) == 0 && whole_number(word + 6, 0, 1000000, &r->phase))
    return 0;
  else if (strcmp(word, "reverse") == 0)
    r->reverse = 1;
  else if (strcmp(word, "ends") == 0)
    r->choice.ends = 1;
  else if (strcmp(word, "bifurcations=stable") == 0)
    r->choice.bifurcations_stable = 1;
  else if (!strchr(word, '=') || strchr(word, '/'))
    r->run[r->runs++] = (char *)word;
  else {
    text_add(why, "'%s': expected a run, columns=, prefix=, every=, phase=, types=, keep=, only=, where=, ends, "
             "bifurcations=stable or reverse", word);
    return -1;
  }
  return 0;
}

static int read_words(struct rows *r, int argc, char *argv[], struct text *why)
{
  *r = (struct rows){ .choice.types = ",HB,HH,TR,LP,BP,GH,", .prefix = "", .every = 1 };
  r->run = must_allocate((size_t)argc * sizeof *r->run);
  for (int i = 1; i < argc; i++)
    if (read_word(r, argv[i], why) != 0)
      return -1;
  if (r->runs == 0)
    text_add(why, "which run?");
  else if (r->columns.n == 0)
    text_add(why, "columns=NAME,... says which");
  return why->length > 0 ? -1 : 0;
}

static void free_rows(struct rows *r)
{
  free(r->run);
  free_columns(&r->columns);
}

static int row_of(const struct rows *r, const struct run_data *data, int part, long point, int number, struct text *row, struct text *why)
{
  text_clear(row);
  if (*r->prefix)
    text_add(row, "%s", r->prefix);
  for (int k = 0; k < r->columns.n; k++) {
    if (k > 0 || *r->prefix)
      text_add(row, ",");
    if (add_cell(row, &r->choice, data, part, point, &r->columns.column[k], number, why) != 0)
      return -1;
  }
  return 0;
}

/* The points of one part that are to be rows, by number: the closing Hopf point has the
 * number behind the last. */
static long chosen_points(const struct rows *r, const struct run_data *data, int part, long **chosen)
{
  const struct ending *e = &data->ending[part];
  long n = 0, kept = 0;

  *chosen = must_allocate((size_t)(e->kept + 2) * sizeof **chosen);
  for (long i = 0; i < e->kept; i++)
    if (is_chosen(&r->choice, data, part, i))
      (*chosen)[n++] = i;
  if (r->choice.ends && e->closed && !r->choice.only)
    (*chosen)[n++] = e->kept;
  for (long k = 1; k <= n; k++) {
    const long point = (*chosen)[k - 1];
    const char *type = point < e->kept ? point_type(&data->all, &data->all.part[part], point) : "";

    if (k == 1 || k == n || k % r->every == r->phase % r->every || *shown_type(&r->choice, data, part, point)
        || (r->choice.kept && lists(r->choice.kept, type)))
      (*chosen)[kept++] = point;
  }
  return kept;
}

static int add_rows(const struct rows *r, const struct run_data *data, int number, struct text *out, struct text *why)
{
  struct text row = TEXT_NONE;
  int status = 0;

  for (int j = 0; j < data->all.parts && status == 0; j++) {
    const int part = r->reverse ? data->all.parts - 1 - j : j;
    long *chosen, n;

    if (data->all.part[part].points == 0)
      continue;
    n = chosen_points(r, data, part, &chosen);
    for (long k = 0; k < n && status == 0; k++) {
      status = row_of(r, data, part, chosen[r->reverse ? n - 1 - k : k], number, &row, why);
      if (status == 0)
        text_add(out, "%s\n", row.at);
    }
    free(chosen);
  }
  text_free(&row);
  return status;
}

static int say(const char *command, struct text *why, int status)
{
  if (why->length > 0)
    say_line(command, why->at);
  text_free(why);
  return status;
}

static int run_rows(int argc, char *argv[])
{
  struct text why = TEXT_NONE, out = TEXT_NONE;
  struct rows r;
  int status = read_words(&r, argc, argv, &why) == 0 ? MLG_OK : MLG_BAD_INPUT;

  for (int i = 0; i < r.runs && status == MLG_OK; i++) {
    struct run_data data;

    status = read_run_or_say("rows", r.run[i], &data);
    if (status == 0 && add_rows(&r, &data, i + 1, &out, &why) != 0)
      status = MLG_BAD_INPUT;
    free_run_data(&data);
  }
  if (status == MLG_OK && out.length > 0)
    fputs(out.at, stdout);
  text_free(&out);
  free_rows(&r);
  return say("rows", &why, status);
}

const struct command command_rows = {
  "rows", "RUN... columns=NAME[:FORMAT],... [prefix=TEXT] [every=N] [phase=K] [types=LIST] [keep=LIST]\n"
  "     [only=LIST] [where=NAME<VALUE] [ends] [bifurcations=stable] [reverse]",
  "the points of runs as rows of a table",
  "columns: AUTO's, or point, label, type, name (HB2), stable (1, 0, empty: not known), run,\n"
  "number (of the run), frequency (Hz), k_s, size (of an orbit, over the largest), shimmy,\n"
  "and of boundary points bp, curve, extremum.  FORMAT: .8g, .5f, .3e or d; .6g if left out.\n"
  "prefix: cells before them.  every=N: each Nth point from the Nth on, or from phase=K on,\n"
  "beside the first, the last and those with a type.  types: those that count as such,\n"
  "HB,HH,TR,LP,BP,GH if left out, any for all.  keep: types that are kept too.  only: no\n"
  "other points than of these types.  where: no other points; = holds to 1e-6 relative.\n"
  "ends: the Hopf points where a branch of orbits begins and closes, as HB.\n"
  "bifurcations=stable: stable is 1 at points with a type, where both sides meet.\n",
  run_rows,
};

/* --- one point ------------------------------------------------------------------- */

/* Whether a point is of the kind asked for: HB2 by name, HB by type, 7 by label. */
static int is_named(const struct run_data *data, int part, long point, const char *wanted)
{
  const struct column name = { "name", "" }, label = { "label", "" };
  const struct choice any = { .types = ",any," };
  struct text text = TEXT_NONE, why = TEXT_NONE;
  int is = strcmp(point_type(&data->all, &data->all.part[part], point), wanted) == 0;

  for (int k = 0; k < 2 && !is; k++) {
    text_clear(&text);
    add_cell(&text, &any, data, part, point, k ? &label : &name, 1, &why);
    is = text.length > 0 && strcmp(text.at, wanted) == 0;
  }
  text_free(&text);
  text_free(&why);
  return is;
}

static int find_point(const struct rows *r, const struct run_data *data, const char *wanted, int *part, long *point)
{
  int found = 0;

  for (int j = 0; j < data->all.parts; j++)
    for (long i = 0; i < data->ending[j].kept; i++) {
      const int last = strcmp(wanted, "last") == 0;

      if (!is_chosen(&r->choice, data, j, i) || !(last || strcmp(wanted, "first") == 0 || is_named(data, j, i, wanted)))
        continue;
      *part = j;
      *point = i;
      found = 1;
      if (!last)
        return 1;
    }
  return found;
}

/* The names of the labelled points. */
static void add_names(const struct run_data *data, struct text *text)
{
  const struct column name = { "name", "" };
  const struct choice any = { .types = ",any," };
  struct text why = TEXT_NONE;

  for (int j = 0; j < data->all.parts; j++)
    for (long i = 0; i < data->ending[j].kept; i++)
      if (data->all.part[j].point[i].label > 0) {
        text_add(text, " ");
        add_cell(text, &any, data, j, i, &name, 1, &why);
      }
  text_free(&why);
}

static int run_point(int argc, char *argv[])
{
  struct text why = TEXT_NONE, row = TEXT_NONE;
  struct run_data data;
  struct rows r;
  int status, part;
  long point;

  if (argc < 4 || strchr(argv[2], '=')) {
    fputs("usage: mlg point RUN NAME columns=NAME[:FORMAT],... [where=NAME<VALUE]\n", stderr);
    return MLG_BAD_INPUT;
  }
  const char *wanted = argv[2];

  argv[2] = argv[0]; /* the words without NAME */
  argv[2] = argv[1];
  status = read_words(&r, argc - 1, argv + 1, &why) == 0 ? MLG_OK : MLG_BAD_INPUT;
  if (status == MLG_OK && r.runs != 1) {
    text_add(&why, "one run at a time");
    status = MLG_BAD_INPUT;
  }
  if (status == MLG_OK) {
    status = read_run_or_say("point", r.run[0], &data);
    if (status == 0) {
      if (!find_point(&r, &data, wanted, &part, &point)) {
        text_add(&why, "%s has no such point '%s'; it has", r.run[0], wanted);
        add_names(&data, &why);
        status = MLG_FAILED;
      } else if (row_of(&r, &data, part, point, 1, &row, &why) != 0)
        status = MLG_BAD_INPUT;
      else
        puts(row.at);
    }
    free_run_data(&data);
  }
  text_free(&row);
  free_rows(&r);
  return say("point", &why, status);
}

const struct command command_point = {
  "point", "RUN NAME columns=NAME[:FORMAT],... [where=NAME<VALUE]",
  "one point of a run as a row",
  "NAME: HB2 for the second Hopf point, as IRS takes it; LP for the first of that type; AUTO's\n"
  "label; first or last.  columns and where as for mlg rows: `mlg point RUN UZ where=V=20\n"
  "columns=label` gives the label at V = 20.  Status 1: the run has no such point.\n",
  run_point,
};
