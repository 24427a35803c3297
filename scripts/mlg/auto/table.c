/* table.c - mlg table: a branch or a solution of a run as a plain table */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "branch.h"
#include "command.h"
#include "ending.h"
#include "runs.h"
#include "solution.h"
#include "units.h"

/* The head of a branch's table: units and names. */
static void print_head(const struct af_part *part)
{
  struct text head = TEXT_NONE;

  text_add(&head, "# ");
  add_units(&head, part->column, part->columns);
  text_add(&head, "\npoint,label,type,name,stable");
  for (int k = 0; k < part->columns; k++)
    text_add(&head, ",%s", part->column[k]);
  puts(head.at);
  text_free(&head);
}

static int same_columns(const struct af_part *a, const struct af_part *b)
{
  if (a->columns != b->columns)
    return 0;
  for (int k = 0; k < a->columns; k++)
    if (strcmp(a->column[k], b->column[k]) != 0)
      return 0;
  return 1;
}

/* How often each type has been seen, for the names that IRS takes: HB1, HB2. */
struct seen { char type[8]; int n; };

static int times_seen(struct seen seen[], const char *type)
{
  int k = 0;

  while (seen[k].type[0] && strcmp(seen[k].type, type) != 0)
    k++;
  strcpy(seen[k].type, type);
  return ++seen[k].n;
}

static void print_part(const struct af_branches *all, const struct af_part *part, const struct run_files *files, int labels,
                       struct seen seen[])
{
  const struct ending e = find_ending(part, files->s, files->layout);

  for (long i = 0; i < e.kept; i++) {
    const struct af_point *p = &part->point[i];
    const char *type = af_type_name(p->type);
    const int stable = point_stability(all, part, i);
    struct text row = TEXT_NONE;

    text_add(&row, "%ld,", p->number);
    if (p->label > 0)
      text_add(&row, "%d", p->label);
    text_add(&row, ",%s,", point_type(all, part, i));
    if (p->label > 0 && *type)
      text_add(&row, "%s%d", type, times_seen(seen, type));
    text_add(&row, "%s", stable < 0 ? "," : stable ? ",1" : ",0");
    for (int k = 0; k < part->columns; k++)
      text_add(&row, ",%.11g", af_value(part, i, k));
    if (!labels || p->label > 0)
      puts(row.at);
    text_free(&row);
  }
}

/* Several branches of the same columns have a blank line between them, as gnuplot and
 * a reader want it; of different ones there can be no table. */
static int print_branches(const struct run_files *files, int labels)
{
  struct seen seen[64] = { { "", 0 } };
  struct text why = TEXT_NONE;
  struct af_branches all;
  int status = MLG_OK, first = -1;

  if (af_read(&all, files->b, files->d, &why) != 0) {
    say_line("table", why.at);
    text_free(&why);
    return MLG_BAD_INPUT;
  }
  for (int i = 0; i < all.parts; i++) {
    if (all.part[i].points == 0)
      continue;
    if (first < 0)
      first = i;
    else if (!same_columns(&all.part[first], &all.part[i])) {
      fprintf(stderr, "table: %s holds branches of different columns; save them one by one\n", files->b);
      status = MLG_BAD_INPUT;
    }
  }
  if (first < 0 && all.parts > 0)
    first = 0;
  if (first < 0) {
    fprintf(stderr, "table: %s holds no branch\n", files->b);
    status = MLG_BAD_INPUT;
  }
  if (status == MLG_OK)
    print_head(&all.part[first]);
  for (int i = 0; i < all.parts && status == MLG_OK; i++) {
    if (all.part[i].points == 0)
      continue;
    if (i > first)
      putchar('\n');
    print_part(&all, &all.part[i], files, labels, seen);
  }
  af_free(&all);
  text_free(&why);
  return status;
}

static int run(int argc, char *argv[])
{
  struct run_files files;
  int status;

  if (!(argc == 2 || (argc == 3 && strcmp(argv[2], "labels") == 0) || (argc == 4 && strcmp(argv[2], "solution") == 0))) {
    fputs("usage: mlg table RUN [labels | solution NAME]\n", stderr);
    return MLG_BAD_INPUT;
  }
  if (find_run_or_say("table", argv[1], &files) != 0)
    return MLG_BAD_INPUT;
  if (argc == 4) {
    struct solution solution;

    status = read_solution_or_say("table", &files, argv[3], &solution);
    if (status == 0) {
      print_solution(&solution);
      free_solution(&solution);
    }
  } else
    status = print_branches(&files, argc == 3);
  free_run(&files);
  return status;
}

const struct command command_table = {
  "table", "RUN [labels | solution NAME]",
  "a branch or a solution of a run as a plain table",
  "RUN is one of build/runs, also NAME.part for one that was rejected; FOLDER/NAME or a b.\n"
  "file for AUTO's own.  labels: only the points whose solutions AUTO kept.  solution NAME:\n"
  "one of these over time, NAME as in IRS (HB2) or AUTO's label.\n"
  "Comma separated; lines that begin with # hold the units, the next line the names.  A\n"
  "branch: point, label, type (HB Hopf, HH double Hopf, TR torus, LP fold, UZ asked for),\n"
  "name, stable (1 yes, 0 no, empty: not known), then AUTO's columns; several branches of a\n"
  "file have a blank line between them.  A solution: t in s, then the states; its\n"
  "parameters in the first line.  SI units, but psi_max in degrees.\n",
  run,
};
