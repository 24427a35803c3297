/* solution.h - a solution of a run over time, its states by name */
#ifndef MLG_SOLUTION_H
#define MLG_SOLUTION_H

#include "autofile.h"
#include "runs.h"

struct solution {
  long rows;
  int states;
  char **state;       /* their names, "U(3)" where unames has none */
  double *value;      /* row i: t in s, then the states: value[i * (states + 1) + k] */
  double *par;        /* PAR(1) to PAR(parameters) */
  int parameters;
  char **parameter;   /* their names, "" for none */
};

/* The solution of a name as IRS takes it (HB2), or of AUTO's label.  Returns 0, or 2
 * after one line on standard error, which tells the solutions that there are. */
int read_solution_or_say(const char *command, const struct run_files *files, const char *name, struct solution *solution);
void free_solution(struct solution *solution);

/* Prints it: a line of parameters, a line of units, names, then the rows. */
void print_solution(const struct solution *solution);

/* Value of a parameter by its name, or NaN. */
double solution_parameter(const struct solution *solution, const char *name);

/* Column of a state in value[], or -1; 0 is t. */
int solution_column(const struct solution *solution, const char *name);

#endif
