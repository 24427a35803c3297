/* fill.c - mlg fill: a text with cells of the tables in it */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cell.h"
#include "command.h"
#include "csv.h"
#include "libmlg.h"
#include "uses.h"

/* A table of results/ as Markdown. */
static int add_table(struct text *page, const char *name, struct text *why)
{
  struct text file = TEXT_NONE;
  struct csv t;
  int status;

  add_table_file(&file, name);
  status = csv_read(file.at, &t, why);
  for (int row = -1; status == 0 && row < t.rows; row++) {
    for (int i = 0; i < t.columns; i++)
      text_add(page, "| %s ", row < 0 ? csv_name(&t, i) : csv_cell(&t, row, i));
    text_add(page, "|\n");
    for (int i = 0; row < 0 && i < t.columns; i++)
      text_add(page, "%s---%s", i == 0 ? "|" : "", i + 1 < t.columns ? "|" : "|\n");
  }
  if (status == 0)
    page->at[--page->length] = '\0'; /* the line's end stands behind the cell */
  csv_free(&t);
  text_free(&file);
  return status == 0 ? 0 : CELL_WRONG;
}

static int by_text(const void *a, const void *b)
{
  return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Of each part of verification.csv: its rows, how many failed, the largest difference over
 * its tolerance. */
static int add_checks(struct text *page, struct text *why)
{
  struct text file = TEXT_NONE;
  struct csv t;
  const char **part = NULL;
  int status, column[4], parts = 0;
  static const char *const name[4] = { "part", "difference", "tolerance", "pass" };

  add_table_file(&file, "verification");
  status = csv_read(file.at, &t, why);
  for (int i = 0; i < 4 && status == 0; i++)
    if ((column[i] = csv_column(&t, name[i])) < 0) {
      text_add(why, "%s has no column %s", t.file, name[i]);
      status = -1;
    }
  for (int row = 0; status == 0 && row < t.rows; row++) {
    int known = 0;

    for (int i = 0; i < parts; i++)
      known |= strcmp(part[i], csv_cell(&t, row, column[0])) == 0;
    if (!known) {
      part = must_resize(part, (size_t)(parts + 1) * sizeof *part);
      part[parts++] = csv_cell(&t, row, column[0]);
    }
  }
  if (parts > 0)
    qsort(part, (size_t)parts, sizeof *part, by_text);
  for (int i = 0; i < parts; i++) {
    int n = 0, failed = 0;
    double worst = 0.;

    for (int row = 0; row < t.rows; row++)
      if (strcmp(csv_cell(&t, row, column[0]), part[i]) == 0) {
        const double limit = strtod(csv_cell(&t, row, column[2]), NULL), off = csv_number(&t, row, column[1]);

        n++;
        failed += strcmp(csv_cell(&t, row, column[3]), "yes") != 0;
        if (limit > 0. && off / limit > worst)
          worst = off / limit;
      }
    text_add(page, "%s| %s | %d | %d | %.2f |", i > 0 ? "\n" : "", part[i], n, failed, worst);
  }
  free(part);
  csv_free(&t);
  text_free(&file);
  return status == 0 ? 0 : CELL_WRONG;
}

static int add_layouts(struct text *page)
{
  for (int i = 0; i < libmlg_layouts(); i++) {
    const char *name = libmlg_layout_name(i);
    struct text title = TEXT_NONE;

    text_add(&title, "%s", name);
    for (char *t = title.at; *t; t++)
      *t = (char)toupper((unsigned char)*t);
    text_add(page, "%s| %s | ![%s](../docs/drawings/%s.svg) |", i > 0 ? "\n" : "", title.at, title.at, name);
    text_free(&title);
  }
  return 0;
}

static int add_version(struct text *page, struct text *why)
{
  struct text file = TEXT_NONE, cff = TEXT_NONE;
  const char *t = NULL;

  text_add(&file, "%sCITATION.cff", checkout());
  note_use(file.at);
  if (read_file(file.at, &cff, why) == 0 && (t = strstr(cff.at, "\nversion: ")) != NULL) {
    t += strlen("\nversion: ");
    text_append(page, t, strcspn(t, "\n"));
  } else if (why->length == 0)
    text_add(why, "%s: has no version", file.at);
  text_free(&file);
  text_free(&cff);
  return t ? 0 : CELL_WRONG;
}

/* What stands between {{ and }}. */
static int add_field(struct text *page, char *field, struct text *why)
{
  struct text value = TEXT_NONE;
  char *format = NULL;
  int status;

  if (strcmp(field, "layouts") == 0)
    return add_layouts(page);
  if (strcmp(field, "version") == 0)
    return add_version(page, why);
  if (strcmp(field, "checks") == 0)
    return add_checks(page, why);
  if (strncmp(field, "table ", 6) == 0)
    return add_table(page, field + 6, why);
  if (*field == '%') {
    format = field;
    field += strcspn(field, " ");
    if (*field)
      *field++ = '\0';
    if (!is_number_format(format)) {
      text_add(why, "'%s': expected a format as %%.2f", format);
      return CELL_WRONG;
    }
  }
  status = cell_value_of(field, format, &value, why);
  if (status == 0)
    text_add(page, "%s", value.at);
  text_free(&value);
  return status;
}

/* Every picture that the page shows, NAME of ![..](NAME), has to be in results/. */
static int pictures_are_there(const struct text *page, struct text *why)
{
  for (const char *t = page->at; (t = strstr(t, "![")) != NULL; t++) {
    const char *name = strstr(t, "](");
    struct text file = TEXT_NONE;
    int there;

    if (!name)
      break;
    text_add(&file, "%sresults/", checkout());
    text_append(&file, name + 2, strcspn(name + 2, ")"));
    note_use(file.at);
    there = access(file.at, R_OK) == 0;
    if (!there)
      text_add(why, "there is no %s; its script's word draw makes it", file.at);
    text_free(&file);
    if (!there)
      return CELL_MISSING;
  }
  return 0;
}

static int fill(char *text, struct text *page, const char *file, struct text *why)
{
  char *t = text, *open;
  int status = 0, line = 1;

  while (status == 0 && (open = strstr(t, "{{")) != NULL) {
    char *close = strstr(open, "}}");
    struct text what = TEXT_NONE;

    text_append(page, t, (size_t)(open - t));
    for (; t < open; t++)
      line += *t == '\n';
    if (!close) {
      text_add(why, "%s:%d: {{ without }}", file, line);
      return CELL_WRONG;
    }
    for (char *c = open; c < close; c++)
      line += *c == '\n';
    *close = '\0';
    status = add_field(page, open + 2, &what);
    if (status != 0)
      text_add(why, "%s:%d: %s", file, line, what.at);
    text_free(&what);
    t = close + 2;
  }
  text_append(page, t, strlen(t));
  return status == 0 ? pictures_are_there(page, why) : status;
}

static int run(int argc, char *argv[])
{
  struct text text = TEXT_NONE, page = TEXT_NONE, why = TEXT_NONE;
  int status;

  if (argc != 2) {
    fputs("usage: mlg fill FILE\n", stderr);
    return MLG_BAD_INPUT;
  }
  note_use(argv[1]);
  status = read_file(argv[1], &text, &why) == 0 ? fill(text.at, &page, argv[1], &why) : CELL_WRONG;
  if (status == 0)
    fputs(page.at, stdout);
  else
    say_line("fill", why.at);
  text_free(&text);
  text_free(&page);
  text_free(&why);
  return status == 0 ? MLG_OK : status == CELL_MISSING ? MLG_FAILED : MLG_BAD_INPUT;
}

const struct command command_fill = {
  "fill", "FILE",
  "a text with cells of the tables in it",
  "Prints the file with each {{...}} replaced by its value: {{%.1f widths width layout=li2 b=140}},\n"
  "an expression of `mlg help cell` with the format before it or none; {{table NAME}}, a table of\n"
  "results/ as Markdown; {{layouts}}, {{checks}}, {{version}}.  A cell or a picture that is not there:\n"
  "one line, status 1.\n",
  run,
};
