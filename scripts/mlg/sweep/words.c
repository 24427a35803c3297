/* words.c - the commands of a sweep, with {NAME} in their words; see description.h */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "description.h"
#include "text.h"

/* The length of {NAME} at text, 0: there is none. */
static size_t placeholder(const char *text)
{
  size_t n = 1;

  if (*text != '{' || !isalpha((unsigned char)text[1]))
    return 0;
  while (isalnum((unsigned char)text[n]) || text[n] == '_')
    n++;
  return text[n] == '}' ? n + 1 : 0;
}

/* The next word of *at: up to a blank outside of quotes and brackets.  Double quotes are
 * taken away, as in a shell; single ones belong to the constants of AUTO and stay. */
static char *next_word(struct sweep *s, const char **at, int line)
{
  struct text word = TEXT_NONE;
  char quote = '\0';
  int depth = 0;

  for (; **at && (quote || depth > 0 || !isspace((unsigned char)**at)); (*at)++) {
    const char c = **at;

    if (c == '"' && (quote == '"' || !quote)) {
      quote = quote ? '\0' : '"';
      continue;
    }
    if (c == '\'' && (quote == '\'' || !quote))
      quote = quote ? '\0' : '\'';
    if (!quote)
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    text_append(&word, &c, 1);
  }
  if (quote || depth != 0)
    slip(s, line, word.at, quote ? "a quote is left open" : "a bracket is left open");
  return word.at ? word.at : strdup("");
}

void add_step(struct sweep *s, bool asks, const char *words, int line)
{
  if (s->steps == MOST_STEPS)
    slip(s, line, words, "there are %d commands already", MOST_STEPS);
  struct step *step = &s->step[s->steps++];

  *step = (struct step){ .asks = asks, .line = line, .rows = ROWS_ALL };
  for (const char *at = words + strspn(words, " \t"); *at; at += strspn(at, " \t")) {
    if (step->words == MOST_WORDS)
      slip(s, line, words, "more than %d words", MOST_WORDS);
    step->word[step->words++] = next_word(s, &at, line);
  }
  step->command = find_command(step->word[0]);
  if (strcmp(step->word[0], "cases") == 0 || strcmp(step->word[0], "help") == 0)
    slip(s, line, step->word[0], "this command answers nothing about a gear; `mlg help` lists the others");
  if (!step->command)
    slip(s, line, step->word[0], "no such command; `mlg help` lists them");
  step->again = is_repeatable(step->command);
}

static struct step *last_question(struct sweep *s, const char *value, int line)
{
  if (s->steps == 0 || !s->step[s->steps - 1].asks)
    slip(s, line, value, "has to follow the line ask = ... that it belongs to");
  return &s->step[s->steps - 1];
}

/* The next of the texts between commas, without blanks around it; NULL at the end. */
static char *next_item(const char **at)
{
  if (!*at)
    return NULL;
  const size_t length = strcspn(*at, ",");
  const char *from = *at, *to = *at + length;

  *at = **at && (*at)[length] ? *at + length + 1 : NULL;
  while (from < to && isspace((unsigned char)*from))
    from++;
  while (to > from && isspace((unsigned char)to[-1]))
    to--;
  return strndup(from, (size_t)(to - from));
}

static bool is_kept(const struct sweep *s, const char *name)
{
  for (int i = 0; i < s->steps; i++)
    for (int k = 0; k < s->step[i].keeps; k++)
      if (strcmp(s->step[i].keep[k].as, name) == 0)
        return true;
  return false;
}

void add_keep(struct sweep *s, const char *columns, int line)
{
  struct step *step = last_question(s, columns, line);

  if (step->keeps)
    slip(s, line, columns, "this question has a line keep already");
  step->keep_line = line;
  for (char *item; (item = next_item(&columns)) != NULL;) {
    char *as = strstr(item, " as ");

    if (step->keeps == MOST_COLUMNS)
      slip(s, line, item, "more than %d columns", MOST_COLUMNS);
    if (as)
      *as = '\0', as += strlen(" as "), as += strspn(as, " ");
    else
      as = item;
    if (as != item)
      item[strcspn(item, " ")] = '\0';
    if (!*item || !*as || strchr(as, ' '))
      slip(s, line, item, "expected COLUMN, or COLUMN as NAME");
    if (is_kept(s, as) || find_axis(s, as, strlen(as)) >= 0 || strcmp(as, "case") == 0)
      slip(s, line, as, "the table has a column of that name already; keep it as another, %s as NAME", item);
    step->keep[step->keeps++] = (struct column){ item, as };
  }
}

void add_names(struct sweep *s, const char *names, int line)
{
  struct step *step = last_question(s, names, line);

  if (step->names)
    slip(s, line, names, "this question has a line names already");
  for (char *item; (item = next_item(&names)) != NULL;) {
    if (step->names == MOST_COLUMNS || !*item)
      slip(s, line, item, "expected at most %d names with commas between them", MOST_COLUMNS);
    char *unit = item + strcspn(item, " \t"); /* "psi_max deg" */

    if (*unit)
      *unit++ = '\0', unit += strspn(unit, " \t");
    for (int i = 0; i < step->names; i++)
      if (strcmp(step->name[i], item) == 0)
        slip(s, line, item, "stands twice among the names");
    step->unit[step->names] = *unit ? unit : NULL;
    step->name[step->names++] = item;
  }
}

void add_rows(struct sweep *s, const char *rows, int line)
{
  static const char *const kind[] = { [ROWS_ALL] = "all", "first", "last", "largest ", "least " };
  struct step *step = last_question(s, rows, line);

  if (step->rows_line)
    slip(s, line, rows, "this question has a line rows already");
  step->rows_line = line;
  for (int k = ROWS_ALL; k <= ROWS_LEAST; k++) {
    const size_t length = strlen(kind[k]);

    if (k < ROWS_LARGEST ? strcmp(rows, kind[k]) == 0 : strncmp(rows, kind[k], length) == 0) {
      step->rows = (enum rows_kind)k;
      step->rows_column = k < ROWS_LARGEST ? NULL : strdup(rows + length + strspn(rows + length, " "));
      return;
    }
  }
  slip(s, line, rows, "expected all, first, last, largest COLUMN or least COLUMN");
}

void add_into(struct sweep *s, const char *file, int line)
{
  struct step *step = s->steps > 0 ? &s->step[s->steps - 1] : NULL;

  if (!step)
    slip(s, line, file, "has to follow the line do = ... or ask = ... that it belongs to");
  if (step->into)
    slip(s, line, file, "this command has a line into already");
  if (!isalnum((unsigned char)*file) || file[strspn(file, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-")])
    slip(s, line, file, "expected the name of a file: letters, digits, . _ and -, a letter or a digit first");
  step->into = strdup(file);
}

/* Whether a step has this {NAME}. */
static bool has(const struct step *step, const char *name)
{
  const size_t length = strlen(name);

  for (int i = 0; i < step->words; i++)
    for (const char *t = step->word[i]; (t = strchr(t, '{')) != NULL; t++)
      if (placeholder(t) == length + 2 && memcmp(t + 1, name, length) == 0)
        return true;
  return false;
}

static void check_placeholders(const struct sweep *s, const struct step *step)
{
  int all = 0;

  for (int i = 0; i < step->words; i++)
    for (const char *t = step->word[i]; (t = strchr(t, '{')) != NULL; t++) {
      const size_t n = placeholder(t);
      char name[VALUE_SIZE];

      if (n < 3)
        continue;
      snprintf(name, sizeof name, "%.*s", (int)(n - 2), t + 1);
      if (strcmp(name, "parameters") == 0 && (strcmp(step->word[i], "{parameters}") != 0 || ++all > 1))
        slip(s, step->line, step->word[i], "{parameters} stands for several words: one by itself, and once");
      if (strcmp(name, "parameters") != 0 && strcmp(name, "case") != 0 && find_axis(s, name, n - 2) < 0)
        slip(s, step->line, step->word[i], "no line gives {%s}; there are {parameters}, {case} and the names of this file", name);
    }
}

/* A column of a table of cases that holds words, not numbers only: it names the cases. */
static bool is_label(const struct sweep *s, const struct axis *a)
{
  double x;

  if (a->dimension != s->table_dimension || is_parameter(a->name))
    return false;
  for (long long i = 0; i < s->count[a->dimension]; i++)
    if (!is_number(a->text[i], &x))
      return true;
  return false;
}

static void check_used(const struct sweep *s, const struct axis *a)
{
  if (is_label(s, a))
    return;
  for (int i = 0; i < s->steps; i++)
    if (has(&s->step[i], a->name) || (is_parameter(a->name) && has(&s->step[i], "parameters")))
      return;
  if (is_parameter(a->name))
    slip(s, a->line, a->name, "no command uses it: put {parameters} or {%s} among its words", a->name);
  slip(s, a->line, a->name, "no parameter of models/mlg.h, and no command has {%s} among its words%s", a->name,
       a->dimension == s->table_dimension ? "; a column that names cases holds words, not numbers only" : "");
}

/* What `mlg points` prints, a column each, as its help says it. */
static const struct { const char *name, *unit; } of_points[] = {
  { "prefix", NULL }, { "run", NULL }, { "type", NULL }, { "V", "m/s" }, { "c_d", "N m s/rad" }, { "k_s", "N m/rad" },
  { "b", "N m s^2/rad" }, { "frequency", "Hz" }, { "psi_max", "deg" }, { "dstar_max", "m" }
};

enum { OF_POINTS = sizeof of_points / sizeof *of_points };

/* Commands that print cells alone want names for them. */
static void check_names(const struct sweep *s, struct step *step)
{
  static const char *const bare[] = { "points", "point", "rows", "at", "crossing", "peak", "shimmy", "curve", "widths", NULL };
  const bool is_points = strcmp(step->command->name, "points") == 0;

  for (int i = 0; bare[i] && !step->names; i++)
    if (strcmp(bare[i], step->command->name) == 0)
      slip(s, step->line, bare[i], "prints no names of its columns: a line names = %s has to follow (`mlg help %s`)",
           is_points ? "prefix, run, type, V, c_d, k_s, b, frequency, psi_max, dstar_max" : "A, B, ...", bare[i]);
  if (is_points && step->names != OF_POINTS)
    slip(s, step->line, "points", "prints %d columns, and the line names has %d (`mlg help points`)", OF_POINTS, step->names);
  for (int i = 0; is_points && i < OF_POINTS; i++)
    if (!step->unit[i])
      step->unit[i] = of_points[i].unit;
}

void settle_steps(struct sweep *s)
{
  int questions = 0;

  for (int i = 0; i < s->steps; i++) {
    check_placeholders(s, &s->step[i]);
    for (int k = 0; k < s->axes; k++)
      s->step[i].takes[k] = is_parameter(s->axis[k].name) && !has(&s->step[i], s->axis[k].name);
    questions += s->step[i].asks;
    if (s->step[i].asks)
      check_names(s, &s->step[i]);
    if (s->step[i].asks && !s->step[i].keeps)
      slip(s, s->step[i].line, s->step[i].word[0], "a line keep = COLUMN, ... has to follow: what is to be in the table");
  }
  if (questions == 0)
    slip(s, 0, NULL, "asks nothing; expected a line ask = COMMAND WORDS and a line keep = COLUMN, ...");
  for (int i = 0; i < s->axes; i++)
    check_used(s, &s->axis[i]);
  if (s->gear) {
    struct text text = TEXT_NONE, why = TEXT_NONE;
    bool used = false;

    if (read_file(s->gear, &text, &why) != 0)
      slip(s, s->gear_line, s->gear, "%s", why.at);
    text_free(&text);
    text_free(&why);

    for (int i = 0; i < s->steps; i++)
      used = used || has(&s->step[i], "parameters");
    if (!used)
      slip(s, s->gear_line, s->gear, "this gear is used by no command: put {parameters} among its words");
  }
}

/* --- the words of a case ---------------------------------------------------------------- */

/* Adds bytes to words->text; they are cut into words later, for it may move. */
static size_t put(struct words *w, size_t at, const char *bytes, size_t n)
{
  if (at + n + 1 > w->room) {
    w->room = 2 * (at + n + 1);
    w->text = must_resize(w->text, w->room);
  }
  memcpy(w->text + at, bytes, n);
  w->text[at + n] = '\0';
  return at + n;
}

static size_t put_value(const struct sweep *s, struct words *w, size_t at, const char *name, size_t length, long long n)
{
  char buffer[VALUE_SIZE];
  const char *value = buffer;
  const int axis = find_axis(s, name, length);

  if (axis >= 0)
    value = axis_value(s, axis, n, buffer);
  else
    snprintf(buffer, sizeof buffer, "%lld", n);
  return put(w, at, value, strlen(value));
}

static size_t put_parameters(const struct sweep *s, const struct step *step, struct words *w, size_t at, long long n, int *argc)
{
  if (s->gear) {
    at = put(w, put(w, at, "gear=", 5), s->gear, strlen(s->gear)) + 1;
    (*argc)++;
  }
  for (int i = 0; i < s->axes; i++)
    if (step->takes[i]) {
      const char *name = s->axis[i].name;

      at = put(w, put(w, at, name, strlen(name)), "=", 1);
      at = put_value(s, w, at, name, strlen(name), n) + 1;
      (*argc)++;
    }
  return at;
}

int fill_words(const struct sweep *s, const struct step *step, long long n, struct words *w)
{
  size_t at = 0;
  int argc = 0;

  for (int i = 0; i < step->words; i++) {
    if (strcmp(step->word[i], "{parameters}") == 0) {
      at = put_parameters(s, step, w, at, n, &argc);
      continue;
    }
    at = put(w, at, "", 0);
    for (const char *t = step->word[i]; *t;) {
      const size_t length = placeholder(t), plain = length ? 0 : 1 + strcspn(t + 1, "{");

      at = length ? put_value(s, w, at, t + 1, length - 2, n) : put(w, at, t, plain);
      t += length + plain;
    }
    at++;
    argc++;
  }
  char *word = w->text;

  for (int i = 0; i < argc; i++) {
    w->argv[i] = word;
    word += strlen(word) + 1;
  }
  w->argv[argc] = NULL;
  return argc;
}
