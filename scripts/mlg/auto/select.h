/* select.h - points of runs chosen, and their columns written as a table's cells */
#ifndef MLG_SELECT_H
#define MLG_SELECT_H

#include "autofile.h"
#include "ending.h"
#include "runs.h"

/* A run in hand: its files, what they hold, and where its branch ends. */
struct run_data {
  struct run_files files;
  struct af_branches all;
  struct ending *ending; /* of each part */
  struct inertia { int known; double J_xi, m_D, l_D, J_zeta; } *inertia; /* shimmy.c */
};

/* Reads a run for a command.  Returns 0, or 2 after one line on standard error. */
int read_run_or_say(const char *command, const char *word, struct run_data *data);
void free_run_data(struct run_data *data);

/* A column that was asked for: NAME or NAME:FORMAT, FORMAT as ".8g" (default .6g).  NAME
 * is one of AUTO's or
 *   point, label, type, name, stable, run    name: as IRS takes it, HB2
 *   number      of the run, 1, 2, ... in the order given
 *   frequency   1/period in Hz
 *   k_s         N m/rad, of 1e5/compliance in runs of models/boundary.h; inf: rigid
 *   size        of an orbit over the largest of its branch
 *   shimmy      psi or delta, which of them has more of the kinetic energy
 *   extremum    min or max, of c_d at a boundary point; curve: what is behind .bN. in the run's name
 *   bp          BP1, BP2_l, BP2_u, BP3, psi3, onset, meet as in the paper's Figure 10(a), or -
 */
struct column { char name[32], format[12]; };
struct columns { struct column *column; int n; };

/* Of "A,B:.8g".  Returns 0, or -1 with a line in why. */
int read_columns(const char *list, struct columns *columns, struct text *why);
void free_columns(struct columns *columns);

/* Which points. */
struct choice {
  const char *types; /* ",HB,LP,": the types that the column type shows; ",any,": all */
  const char *kept;  /* the types kept whatever `every` says; NULL: those shown */
  const char *only;  /* none but these types; NULL: all */
  struct condition { char name[32]; char relation; double value; } where[8]; /* < > or = */
  int conditions;
  int bifurcations_stable; /* stable is 1 where a type is shown: both sides meet there */
  int ends;                /* the Hopf points at which a branch of orbits begins and closes */
};

/* "V>20", "V=20" (to 1e-6 relative).  Returns 0, or -1 with a line in why. */
int read_condition(struct choice *choice, const char *text, struct text *why);

/* Whether a column is there: one of AUTO's, or one that is made of these. */
int has_column(const struct af_part *part, const char *name);

/* What the paper's Figure 10(a) calls boundary point i of a run of models/boundary.h, by
 * what oscillates, how fast and which extremum it is: BP1, BP2_l, BP2_u, BP3, psi3 for a
 * third psi region; "-" for any other. */
const char *paper_name(const struct run_data *data, int part, long point, int i);

/* The value of a column that is a number, or NaN. */
double number_at(const struct run_data *data, int part, long point, const char *name);

/* psi or delta, what a point of orbits or of boundary points shows (mlg_energy_ratio, mlg.h);
 * NULL after a line in why. */
const char *shimmy_at(const struct run_data *data, int part, long point, struct text *why);

/* Whether the choice has the point. */
int is_chosen(const struct choice *choice, const struct run_data *data, int part, long point);

/* The type that is shown of a point, or "". */
const char *shown_type(const struct choice *choice, const struct run_data *data, int part, long point);

/* Whether a list ",HB,LP," has a type; ",any," has all that are not "". */
int lists(const char *list, const char *type);

/* Adds a cell.  point: the number of points for the closing Hopf point.  number: of the
 * run.  Returns 0, or -1 with a line in why: there is no such column. */
int add_cell(struct text *row, const struct choice *choice, const struct run_data *data, int part, long point,
             const struct column *column, int number, struct text *why);

#endif
