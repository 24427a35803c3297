/* sums.h - sums of files, to notice damage and change */
#ifndef MLG_SUMS_H
#define MLG_SUMS_H

#include <stdint.h>

#include "text.h"

/* XXH64 of Y. Collet with seed 0, as `xxhsum -H1` prints it: fast, and a change by
 * chance goes unnoticed once in 2^64. */
uint64_t sum_of(const void *bytes, size_t length);

/* That of a file.  Returns 0, or -1 with a line in why. */
int sum_of_file(const char *file, uint64_t *sum, struct text *why);

/* What a look at a file tells without reading it: "SIZE MTIME INODE", or "-" when it
 * is not there. */
void look_of_file(const char *file, struct text *look);

#endif
