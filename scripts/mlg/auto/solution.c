/* solution.c - a solution of a run over time, its states by name; see solution.h */
#include "solution.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mlg.h"
#include "units.h"

static char *copy(const char *text)
{
  char *t = must_allocate(strlen(text) + 1);

  return strcpy(t, text);
}

/* The solution called so, or NULL with those that there are in names. */
static const struct af_solution *find(const struct af_solutions *all, const char *wanted, struct text *names)
{
  for (int i = 0; i < all->n; i++) {
    const struct af_solution *one = &all->solution[i];
    const char *type = af_type_name(one->type);
    char name[32], label[16];
    int number = 1;

    for (int k = 0; k < i; k++)
      number += strcmp(af_type_name(all->solution[k].type), type) == 0;
    snprintf(name, sizeof name, "%s%d", type, number);
    snprintf(label, sizeof label, "%d", one->label);
    if (strcmp(label, wanted) == 0 || (*type && strcmp(name, wanted) == 0))
      return one;
    text_add(names, " %s", *type ? name : label);
  }
  return NULL;
}

/* Values and names; 0, or -1 with a line in why. */
static int fill(struct solution *s, const struct af_solutions *all, const struct af_solution *one, const struct af_part *part,
                struct text *why)
{
  double *row = must_allocate((size_t)one->rows * (size_t)one->row_length * sizeof *row), period;
  const double *end;
  int status;

  *s = (struct solution){ .rows = one->rows, .states = one->states, .parameters = one->parameters };
  s->par = must_allocate((size_t)(one->parameters + 1) * sizeof *s->par);
  s->value = must_allocate((size_t)one->rows * (size_t)(one->states + 1) * sizeof *s->value);
  s->state = must_allocate((size_t)(one->states + 1) * sizeof *s->state);
  s->parameter = must_allocate((size_t)(one->parameters + 1) * sizeof *s->parameter);
  for (int k = 0; k < s->states; k++) {
    char number[24];

    snprintf(number, sizeof number, "U(%d)", k + 1);
    s->state[k] = copy(part && k < part->states && part->state[k][0] ? part->state[k] : number);
  }
  for (int k = 0; k < s->parameters; k++)
    s->parameter[k] = copy(part && k < part->parameters ? part->parameter[k] : "");
  status = af_solution_rows(all, one, row, why);
  if (status == 0)
    status = af_solution_parameters(all, one, s->par, why);
  period = s->parameters > PAR_PERIOD ? s->par[PAR_PERIOD] : 1.;
  end = row + one->rows * one->row_length;
  for (const double *r = row; status == 0 && r < end; r += one->row_length) {
    double *to = s->value + (r - row) / one->row_length * (s->states + 1);

    to[0] = r[0] * period;
    memcpy(to + 1, r + 1, (size_t)s->states * sizeof *to);
  }
  free(row);
  return status;
}

int read_solution_or_say(const char *command, const struct run_files *files, const char *name, struct solution *solution)
{
  struct text why = TEXT_NONE, names = TEXT_NONE;
  struct af_solutions all = { 0 };
  struct af_branches branches = { 0 };
  const struct af_solution *one;

  *solution = (struct solution){ 0 };
  text_clear(&names);
  if (!files->s)
    text_add(&why, "%s has no file of solutions", files->name);
  else if (af_read(&branches, files->b, NULL, &why) == 0 && af_read_solutions(&all, files->s, &why) == 0) {
    one = find(&all, name, &names);
    if (!one)
      text_add(&why, "there is no solution '%s'; there are%s", name, names.length ? names.at : " none");
    else if (fill(solution, &all, one, branches.parts ? &branches.part[0] : NULL, &why) != 0)
      free_solution(solution);
  }
  if (why.length > 0)
    say_line(command, why.at);
  const int status = why.length > 0 ? 2 : 0;

  af_free_solutions(&all);
  af_free(&branches);
  text_free(&why);
  text_free(&names);
  return status;
}

void free_solution(struct solution *s)
{
  for (int k = 0; k < s->states && s->state; k++)
    free(s->state[k]);
  for (int k = 0; k < s->parameters && s->parameter; k++)
    free(s->parameter[k]);
  free(s->state);
  free(s->parameter);
  free(s->value);
  free(s->par);
  *s = (struct solution){ 0 };
}

void print_solution(const struct solution *s)
{
  struct text text = TEXT_NONE;

  for (int k = 0; k < s->parameters; k++) {
    const char *unit = unit_of(s->parameter[k]);

    if (!s->parameter[k][0])
      continue;
    text_add(&text, "%s%s = %.11g", text.length ? ", " : "# ", s->parameter[k], s->par[k]);
    if (unit && strcmp(unit, "-") != 0)
      text_add(&text, " %s", unit);
  }
  text_add(&text, "%s\n# t s; ", text.length ? "" : "#");
  add_units(&text, s->state, s->states);
  text_add(&text, "\nt");
  for (int k = 0; k < s->states; k++)
    text_add(&text, ",%s", s->state[k]);
  text_add(&text, "\n");
  for (long i = 0; i < s->rows; i++)
    for (int k = 0; k <= s->states; k++)
      text_add(&text, "%.11g%s", s->value[i * (s->states + 1) + k], k < s->states ? "," : "\n");
  fputs(text.at, stdout);
  text_free(&text);
}

double solution_parameter(const struct solution *s, const char *name)
{
  for (int k = 0; k < s->parameters; k++)
    if (strcmp(s->parameter[k], name) == 0)
      return s->par[k];
  return NAN;
}

int solution_column(const struct solution *s, const char *name)
{
  if (strcmp(name, "t") == 0)
    return 0;
  for (int k = 0; k < s->states; k++)
    if (strcmp(s->state[k], name) == 0)
      return k + 1;
  return -1;
}
