/* gather.h - the tables of a sweep, out of the files of its blocks */
#ifndef MLG_GATHER_H
#define MLG_GATHER_H

#include "blocks.h"

struct tally { long long blocks[BLOCK_STATES], known, failed, at_work; };

/* How far a sweep is, and how many of its blocks are being computed. */
int count_cases(const struct blocks *blocks, struct tally *tally);

/* FOLDER/table.csv and, if some have failed, failed.csv, each put in place as a whole; with
 * cases still to be computed partial.csv instead of table.csv and status 1. */
int gather(const struct blocks *blocks);

/* The failed cases on standard output. */
int print_failed(const struct blocks *blocks);

#endif
