/* expression.c - what is made of the cells of tables; see cell.h.  Also mlg cell */
#include "expression.h"

#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "csv.h"

int is_operator(const char *word)
{
  static const char *const operators[] = { "-", "/", "over", "and", "=", "!=", "<", "<=", ">", ">=", ")" };

  for (size_t i = 0; i < sizeof operators / sizeof *operators; i++)
    if (strcmp(word, operators[i]) == 0)
      return 1;
  return 0;
}

static int term(struct reading *r, struct text *value)
{
  int status = 0;

  text_clear(value);
  if (r->at == r->words || (is_operator(r->word[r->at]))) {
    text_add(r->why, "expected a table and a column, a number or a text");
    return CELL_WRONG;
  }
  if (strcmp(r->word[r->at], "(") == 0) {
    r->at++;
    status = read_expression(r, value);
    if (status == 0 && (r->at == r->words || strcmp(r->word[r->at++], ")") != 0)) {
      text_add(r->why, "expected a )");
      status = CELL_WRONG;
    }
  } else if (r->at + 1 < r->words && !is_operator(r->word[r->at + 1]))
    status = read_cell(r, value);
  else
    text_add(value, "%s", r->word[r->at++]);
  return status;
}

static int side(struct reading *r, struct text *value)
{
  int status = term(r, value);

  while (status == 0 && r->at < r->words && strchr("-/o", *r->word[r->at])) {
    const char operator = *r->word[r->at++];
    struct text second = TEXT_NONE;
    double x, y;

    status = term(r, &second);
    if (status == 0 && (!csv_is_number(value->at, &x) || !csv_is_number(second.at, &y) || (operator != '-' && y == 0.))) {
      text_add(r->why, "'%s' and '%s': expected numbers, the second not 0", value->at, second.at);
      status = CELL_MISSING;
    }
    text_clear(value);
    if (status == 0)
      text_add(value, "%.9g", operator == '-' ? x - y : operator == '/' ? x / y : 100. * (x / y - 1.));
    text_free(&second);
  }
  return status;
}

static int holds(const char *first, const char *relation, const char *second)
{
  double x, y, order;

  if (csv_is_number(first, &x) && csv_is_number(second, &y))
    order = x - y;
  else
    order = strcmp(first, second);
  return (*relation == '=' && order == 0.) || (*relation == '!' && order != 0.)
         || (*relation == '<' && (order < 0. || (relation[1] && order == 0.)))
         || (*relation == '>' && (order > 0. || (relation[1] && order == 0.)));
}

/* Texts are the same or not, none is less; not-a-number is a text. */
static int are_ordered(const char *first, const char *relation, const char *second, struct text *why)
{
  double x;

  if (strchr("=!", *relation) || (csv_is_number(first, &x) && csv_is_number(second, &x)))
    return 1;
  text_add(why, "'%s' %s '%s': expected numbers", first, relation, second);
  return 0;
}

int read_expression(struct reading *r, struct text *value)
{
  struct text second = TEXT_NONE;
  int status = side(r, value), all = 1;

  while (status == 0 && r->at < r->words && strchr("=!<>", *r->word[r->at])) {
    const char *relation = r->word[r->at++];

    status = side(r, &second);
    if (status != 0)
      break;
    if (!are_ordered(value->at, relation, second.at, r->why)) {
      status = CELL_MISSING;
      break;
    }
    all = holds(value->at, relation, second.at) && all;
    text_clear(value);
    text_add(value, "%s", all ? "yes" : "no");
    if (r->at == r->words || strcmp(r->word[r->at], "and") != 0)
      break;
    r->at++;
    status = side(r, value);
  }
  text_free(&second);
  return status;
}

int is_number_format(const char *format)
{
  const char *t = format;

  if (*t++ != '%')
    return 0;
  if (*t == '.')
    t += 1 + strspn(t + 1, "0123456789");
  return t - format <= 4 && *t && strchr("efg", *t) && !t[1];
}

/* Every number of a text in that format. */
static void put_in_format(struct text *value, const char *format)
{
  struct text shown = TEXT_NONE;

  text_clear(&shown);
  for (const char *t = value->at; *t;) {
    const size_t blank = strspn(t, ", "), n = strcspn(t + blank, ", ");
    struct text one = TEXT_NONE;
    double x;

    text_append(&shown, t, blank);
    text_append(&one, t + blank, n);
    if (csv_is_number(one.at, &x))
      text_add(&shown, format, x);
    else
      text_add(&shown, "%s", one.at);
    text_free(&one);
    t += blank + n;
  }
  text_free(value);
  *value = shown;
}

int cell_value(char *word[], int words, const char *format, struct text *value, struct text *why)
{
  struct reading r = { word, 0, words, why };
  int status = read_expression(&r, value);

  if (status == 0 && r.at < words) {
    text_add(why, "'%s': unexpected", word[r.at]);
    status = CELL_WRONG;
  }
  if (status == 0 && format)
    put_in_format(value, format);
  return status;
}

int cell_value_of(const char *text, const char *format, struct text *value, struct text *why)
{
  struct text copy = TEXT_NONE;
  char **word = must_allocate((strlen(text) + 1) * sizeof *word);
  int n = 0, status;

  text_add(&copy, "%s", text);
  for (char *t = strtok(copy.at, " \n"); t; t = strtok(NULL, " \n"))
    word[n++] = t;
  status = cell_value(word, n, format, value, why);
  free(word);
  text_free(&copy);
  return status;
}

static int run(int argc, char *argv[])
{
  const char *format = argc > 1 && strncmp(argv[1], "format=", 7) == 0 ? argv[1] + 7 : NULL;
  const int first = format ? 2 : 1;
  struct text value = TEXT_NONE, why = TEXT_NONE;
  int status;

  if (argc - first < 2 || (format && !is_number_format(format))) {
    fputs(format && !is_number_format(format) ? "cell: format=: expected one as %.2f, %.3e or %g\n"
                                              : "usage: mlg cell [format=%.2f] TABLE COLUMN [CONDITION ...]\n", stderr);
    return MLG_BAD_INPUT;
  }
  status = cell_value(argv + first, argc - first, format, &value, &why);
  if (status == 0)
    puts(value.at);
  else
    say_line("cell", why.at);
  text_free(&value);
  text_free(&why);
  return status == 0 ? MLG_OK : status == CELL_MISSING ? MLG_FAILED : MLG_BAD_INPUT;
}

const struct command command_cell = {
  "cell", "[format=%.2f] TABLE COLUMN [CONDITION ...]",
  "what a table of results/ says",
  "TABLE: results/TABLE.csv, or a file with a slash in its name.  CONDITION: COLUMN=VALUE, or\n"
  "with != < <= > >=, or COLUMN=A|B, or COLUMN%10=0, the rest of a division; the first row that\n"
  "fits all counts.  nth=N: the N-th; largest=COLUMN, least=COLUMN, nearest:COLUMN=X: the one with\n"
  "that number there; at:COLUMN=X: between two rows around it, in a straight line; list: all; each:\n"
  "all once, by size.\n"
  "COLUMN `count`: how many rows fit.  Cells may be combined by - / and over (per cent above),\n"
  "compared by = != < <= > >=, and joined by and, with blanks around each:\n"
  "  mlg cell widths b layout=li1 largest=width\n"
  "  mlg cell format=%.2f widths width layout=li2 b=140 over widths width layout=li2 b=0\n"
  "Status 1: no row fits.\n",
  run,
};
