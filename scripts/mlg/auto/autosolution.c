/* autosolution.c - AUTO's s. files; see autofile.h
 *
 * A solution begins with a line of 16 numbers (12 in old files): 1 branch, 2 point,
 * 3 type, 4 label, 7 rows, 8 length of a row, 9 how many lines follow, 12 the number
 * of parameters, 14 the number of the model's states.  Rows and parameters stand 7
 * numbers to a line; the parameters come last.
 */
#include "autofile.h"

#include <stdlib.h>
#include <string.h>

enum { FIELDS = 16, PER_LINE = 7 };

/* The numbers of a first line, in 6, 6, 6, 6, 6, 6, 8, 6, 8 and then 5 characters
 * each; how many there are, or 0. */
static int first_line(const char *line, size_t length, long number[FIELDS])
{
  size_t from = 0;
  int n = 0;

  while (length > 0 && (line[length - 1] == ' ' || line[length - 1] == '\r'))
    length--;
  while (from < length && n < FIELDS) {
    const size_t width = n == 6 || n == 8 ? 8 : n < 9 ? 6 : 5;
    char copy[16];
    size_t k = 0;

    if (from + width > length)
      return 0;
    for (size_t i = from; i < from + width; i++)
      if (line[i] != ' ')
        copy[k++] = line[i];
    copy[k] = '\0';
    if (!whole_number(copy, -2147483647L, 2147483647L, &number[n]))
      return 0;
    n++;
    from += width;
  }
  return from == length && (n == 12 || n == FIELDS) ? n : 0;
}

static int refuse(const struct af_solutions *all, long line, struct text *why, const char *what)
{
  text_add(why, "%s:%ld: %s", all->file, line, what);
  return -1;
}

static int index_solutions(struct af_solutions *all, struct text *why)
{
  const char *t = all->text.at, *const end = t + all->text.length;
  long line = 0;

  if (memchr(t, '\0', all->text.length)) {
    for (line = 1; *t; t++)
      line += *t == '\n';
    return refuse(all, line, why, "a zero byte");
  }
  while (t < end) {
    const char *next = memchr(t, '\n', (size_t)(end - t));
    long number[FIELDS] = { 0 };
    struct af_solution *one;
    int n;

    line++;
    if (!next)
      return refuse(all, line, why, "the last line is cut");
    n = first_line(t, (size_t)(next - t), number);
    if (n == 0)
      return refuse(all, line, why, "not the first line of a solution, which has 12 or 16 whole numbers");
    if (number[6] < 0 || number[7] < 1 || number[7] > 100000 || number[8] < 1 || number[11] < 0 || number[11] > 100000
        || number[2] < -99 || number[2] > 99)
      return refuse(all, line, why, "a solution without rows, lines or parameters");
    if (number[6] == 0 || (n == FIELDS && number[4] == 0)) { /* AUTO's mark of the last label */
      t = next + 1;
      continue;
    }
    all->solution = must_resize(all->solution, (size_t)(all->n + 1) * sizeof *all->solution);
    one = &all->solution[all->n];
    *one = (struct af_solution){ .branch = (int)labs(number[0]), .number = labs(number[1]), .type = (int)number[2],
                                 .label = (int)number[3], .rows = number[6], .row_length = (int)number[7],
                                 .lines = number[8], .parameters = (int)number[11], .line = line };
    one->states = n == FIELDS && number[13] > 0 && number[13] < number[7] ? (int)number[13] : one->row_length - 1;
    if (number[6] > number[8] || (number[11] + PER_LINE - 1) / PER_LINE > number[8])
      return refuse(all, line, why, "a solution with fewer lines than rows");
    t = next + 1;
    one->body = (size_t)(t - all->text.at);
    for (long k = 0; k < one->lines; k++, t = next + 1) {
      next = t < end ? memchr(t, '\n', (size_t)(end - t)) : NULL;
      line++;
      if (!next) {
        text_add(why, "%s:%ld: the solution of label %d is cut: %ld of its %ld lines are there", all->file, line,
                 one->label, k, one->lines);
        return -1;
      }
    }
    all->n++;
  }
  return 0;
}

int af_read_solutions(struct af_solutions *all, const char *s, struct text *why)
{
  int status;

  *all = (struct af_solutions){ 0 };
  all->file = must_allocate(strlen(s) + 1);
  strcpy(all->file, s);
  status = read_file(s, &all->text, why);
  if (status == 0)
    status = index_solutions(all, why);
  if (status != 0)
    af_free_solutions(all);
  return status;
}

void af_free_solutions(struct af_solutions *all)
{
  free(all->file);
  free(all->solution);
  text_free(&all->text);
  *all = (struct af_solutions){ 0 };
}

/* Reads n numbers from the lines of a solution, the first `skip` lines left out. */
static int read_numbers(const struct af_solutions *all, const struct af_solution *one, long skip, size_t n,
                        double value[], struct text *why)
{
  const char *t = all->text.at + one->body;
  long line = one->line;
  size_t got = 0;

  for (long k = 0; k < one->lines && got < n; k++) {
    const char *const end = strchr(t, '\n');

    line++;
    for (const char *from = t; k >= skip && got < n && from < end;) {
      size_t length;

      while (from < end && (*from == ' ' || *from == '\r'))
        from++;
      for (length = 0; from + length < end && from[length] != ' ' && from[length] != '\r'; length++)
        ;
      if (length > 0 && !af_number(from, length, &value[got++]))
        return refuse(all, line, why, "no number");
      from += length;
    }
    t = end + 1;
  }
  if (got == n)
    return 0;
  text_add(why, "%s:%ld: the solution of label %d has %zu numbers where %zu belong", all->file, line, one->label, got, n);
  return -1;
}

int af_solution_parameters(const struct af_solutions *all, const struct af_solution *one, double par[], struct text *why)
{
  return read_numbers(all, one, one->lines - (one->parameters + PER_LINE - 1) / PER_LINE, (size_t)one->parameters, par, why);
}

int af_solution_rows(const struct af_solutions *all, const struct af_solution *one, double value[], struct text *why)
{
  return read_numbers(all, one, 0, (size_t)one->rows * (size_t)one->row_length, value, why);
}
