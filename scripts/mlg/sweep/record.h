/* record.h - what is known of a case, as it stands in the file of a block
 *
 *   ok CASE ROWS SUM          and that many rows of kept cells
 *   failed CASE STEP STATUS SUM REASON
 *   units SUM TEXT            before the first good case: the units of the kept columns
 *
 * SUM is of all else in the record: half a record, or a damaged one, is none.
 */
#ifndef MLG_RECORD_H
#define MLG_RECORD_H

#include <stdbool.h>

#include "text.h"

struct record {
  long long n;      /* the case */
  bool failed;
  bool units;       /* it is of no case (n = 0), and text says units */
  int step, status; /* of a failed one: the number of its command, from 1, and the exit status as a shell's */
  int rows;         /* of a good one */
  const char *text; /* the rows, or the reason */
  size_t length;    /* of it */
};

void add_record(struct text *text, const struct record *record);

/* The record at text, of which there are length bytes.  Returns its length, 0: no whole one. */
size_t read_record(const char *text, size_t length, struct record *record);

#endif
