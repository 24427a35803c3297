/* explorer.h - the best design of a layout or network, by a global search (explorer.c) */
#ifndef MLG_EXPLORER_H
#define MLG_EXPLORER_H

#include "arguments.h"
#include "box.h"
#include "cma.h"
#include "device_text.h"

enum {
  EXPLORE_OTHERS = BOX_ELEMENTS, EXPLORE_VARIABLES = EXPLORE_OTHERS + 3, EXPLORE_GIVEN = 40, EXPLORE_STARTS = 100 + EXPLORE_GIVEN,
  EXPLORE_CORNERS = 256
};

/* Places to begin at, before random ones. */
struct places { double x[EXPLORE_GIVEN][EXPLORE_VARIABLES]; int n; };

/* Corners of the box of tolerances (libmlg_box_of) that are asked, of many the few that fail first. */
struct corners { struct libmlg_box box; unsigned corner[EXPLORE_CORNERS]; int n; };

/* A place is x[] in the unit box: k_s, b, other elements, each if there is one, then c_d. */
struct explorer {
  int layout, has_k_s, has_b, others;
  double par[LIBMLG_MOST_PARAMETERS], k_least, b_most, V_least, V_top;
  struct part *other[EXPLORE_OTHERS];
  struct places given;
  struct corners corners; /* of explore_tolerance() */
  double load;            /* of explore_load(): that of the gear, N */
  int of_ratio;           /* of explore_interval(): hi/lo, not hi - lo */
};

/* The best design, and how often it was met. */
struct found {
  double value, k_s, b, lo, hi; /* c_d: lo = hi, but of an interval */
  double other[EXPLORE_OTHERS], x[EXPLORE_VARIABLES];
  int met, starts, asked;
};

/* Where so many starts came to: the value and the place of each. */
struct starts { int n; double value[EXPLORE_STARTS], x[EXPLORE_STARTS][EXPLORE_VARIABLES]; };

struct weakest; /* weakest.h */

/* All values but those that are searched stay as in par[]. */
void explore_begin(struct explorer *e, int layout, const double par[], double b_most, double V_least, double V_top);

/* Lets the element NAME=VALUE of the network be searched too; what is wrong, or NULL. */
const char *explore_free(struct explorer *e, const char *name);

/* The designs of begin=FILE to begin at; or the end of the program with a line (explore_begin.c). */
void explore_begin_at(struct explorer *e, const char *word);

/* How many variables a place has. */
int explore_variables(const struct explorer *e);

/* The place of a design, other elements at the values they have. */
void explore_place(const struct explorer *e, double k_s, double b, double c_d, double x[]);

/* A c_d for an interval of it. */
double explore_middle(double lo, double hi);

/* A place more to begin at, unless there are EXPLORE_GIVEN. */
void explore_give(struct explorer *e, const double x[]);

/* The values of a place into par[]: k_s, b and others, and c_d too. */
void explore_set(struct explorer *e, const double x[]);
void explore_set_all(struct explorer *e, const double x[]);

/* k_s from 0 to 1 as those of a place. */
double explore_spring(const struct explorer *e, double x);

/* cma_largest(), or the end of the program with a line. */
int explore_climb(double f(const double x[], void *context), void *context, int n, double x[], double sigma,
                  struct cma_random *random, int most, double *best);

/* One start from each place that is given and n from random ones, to where top() leads, which
 * returns the value there and makes x[] the place. */
void explore_starts(struct weakest *w, double top(struct weakest *w, double x[], int *asked), int n, struct starts *starts,
                    int *asked);

/* The best of them, which is set, and how many came within the part `same` of it. */
void explore_best(struct explorer *e, const struct starts *starts, double same, struct found *found);

/* The k_s, b, other elements and c_d that are set, as those found. */
void explore_take(const struct explorer *e, struct found *found);

/* How many of the results come to the best. */
int explore_met(const double result[], int n, double best, double same);

/* The largest least damping ratio; the widest zero-shimmy interval, or that of the largest
 * hi/lo; the largest load, N; the largest tolerance, per cent: the best of so many starts beside
 * those from the places that are given.  The value is -INFINITY, or 0 of a load or tolerance,
 * where there is none. */
void explore_zeta(struct explorer *e, int starts, struct found *found);
void explore_interval(struct explorer *e, int of_ratio, int starts, struct found *found);
void explore_load(struct explorer *e, int starts, struct found *found);
void explore_tolerance(struct explorer *e, int starts, struct found *found);

#endif
