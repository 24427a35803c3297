/* answer.h - what a command printed, as rows of a sweep's table */
#ifndef MLG_ANSWER_H
#define MLG_ANSWER_H

#include "description.h"
#include "text.h"

/* Rows of kept cells with commas between them, each with its line's end. */
struct answer { struct text text; int rows; };

/* Takes the rows that a step keeps out of its output, which is cut up.  An answer to a step
 * before is there already: then each has one row at most, and they stand side by side.
 * Returns 0, or -1 with the reason in why. */
int take_answer(const struct sweep *sweep, const struct step *step, char *output, struct answer *answer, struct text *why);

/* A row of empty cells where nothing was found: no row is an answer too. */
void complete_answer(const struct sweep *sweep, struct answer *answer);

#endif
