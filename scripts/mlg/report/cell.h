/* cell.h - what a table of results/ says, by an expression of words
 *
 *   EXPRESSION  SIDE, or SIDE RELATION SIDE [and SIDE RELATION SIDE ...], which is yes or no
 *   SIDE        TERM, TERM - TERM, TERM / TERM, or TERM over TERM: by how many per cent
 *               the first is above the second
 *   TERM        NUMBER, or TEXT, or ( EXPRESSION ), or a cell: TABLE COLUMN [CONDITION ...]
 *   CONDITION   of csv.h; several rows may fit, and the first counts, but for these words:
 *     nth=N            the N-th
 *     largest=COLUMN   the one with the largest number there; least=COLUMN
 *     nearest:COLUMN=TERM  the one with the nearest number there
 *     at:COLUMN=TERM   between the two neighbouring rows around that number, in a straight line
 *     list             all of them, with commas between
 *     each             every number once, by size, with blanks between
 *
 * TABLE is results/TABLE.csv, or a file when there is a slash in it.  Beside its own
 * columns a table has `count`, how many rows fit; one of Hopf curves `closed`, how many
 * curves among these end on their first point; fig07 `joined`, how many torus curves end
 * within 1 % of two double Hopf points.
 */
#ifndef MLG_CELL_H
#define MLG_CELL_H

#include "text.h"

enum { CELL_MISSING = -1, CELL_WRONG = -2 };

/* The value of the expression in words: a cell as it stands in the table, a number that was
 * reckoned to 9 digits, yes or no.  format: NULL, or one for numbers, "%.2f".  Returns 0;
 * CELL_MISSING with a line in why: no row fits; CELL_WRONG with a line in why. */
int cell_value(char *word[], int words, const char *format, struct text *value, struct text *why);

/* The same of one text, its words with blanks between. */
int cell_value_of(const char *text, const char *format, struct text *value, struct text *why);

/* Whether a text is % with a number of decimals and e, f or g, as "%.2f". */
int is_number_format(const char *format);

/* Where a table's name leads: results/NAME.csv of the checkout, or itself with a slash. */
void add_table_file(struct text *file, const char *name);

#endif
