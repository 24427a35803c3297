/* judge.h - is AUTO's run what it was meant to be?
 *
 * AUTO ends with status 0 whatever happens.  The judge reads what it wrote and
 * complains of
 *   - no convergence (MX), not-a-number, no solution, a last point without a label
 *   - the steps used up (EP), unless EP is expected; a stop at RL0, RL1, A0 or A1 is
 *     no complaint and is named; a start outside RL0..RL1 is one
 *   - a change of stability, a fold or an extremum that carries no label
 *   - a Hopf point of straight rolling that libmlg has along the run and AUTO has not
 *   - orbits that fell onto the zero solution, curves that run back over themselves
 *   - a parameter continued out of its range
 *   - another number of points than expected, and an expected absence of points that
 *     the run did not look for
 *   - files that are cut, garbled, or lack a point
 * and says what was found, or that nothing was, or what was not looked for.
 */
#ifndef MLG_JUDGE_H
#define MLG_JUDGE_H

#include "text.h"

/* A run to be judged. */
struct judged {
  const char *b, *s, *d; /* AUTO's files; s, d NULL where there is none */
  const char *log;       /* AUTO's output, or NULL */
  const char *layout;    /* "l1", or NULL for not known */
  char *const *expected; /* words TYPE=COUNT */
  int n_expected;
  int status;            /* AUTO's own, 0 for good */
};

/* A Hopf point of straight rolling: the value of the first parameter, and how far it is to the
 * next one, or to an end of the run. */
struct hopf_point { double at, gap; };

enum { MOST_HOPF_POINTS = 64 };

struct judgement {
  struct text found;      /* "HB 13.4308 HB 25.0861", "TR 30.7865 closed", "no special point" */
  struct text complaints; /* joined by "; ", empty when the run is good */
  struct text damage;     /* "FILE:LINE: what" when a file is cut or garbled */
  int missed;             /* how many Hopf points AUTO stepped over; if any, then all there are: */
  struct hopf_point hopf[MOST_HOPF_POINTS];
  int hopf_points;
  char hopf_along[32];    /* the first parameter */
  double start, step;     /* its first value, and how far the second is from it */
  int whole;              /* whether there was room for all that AUTO wrote, see below */
};

/* Judges; judgement_free ends it.  whole: on a full disk AUTO leaves out the rest and
 * goes on.  A run that it ended itself, with its time in the log, has a label on the
 * last point of b., whole solutions in s. and its time in d.; without a log only that
 * the files can be read is looked at. */
void judge_run(const struct judged *run, struct judgement *judgement);
void judgement_free(struct judgement *judgement);

/* Whether all words are TYPE=COUNT, TYPE one that points or branches can have (HB, HH,
 * closed, ...), none twice.  Returns 0, or -1 with a line in why. */
int check_expectations(char *const expected[], int n, struct text *why);

#endif
