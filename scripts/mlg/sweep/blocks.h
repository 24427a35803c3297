/* blocks.h - the blocks of cases that a sweep is computed in, and their files
 *
 * Block k of size B has the cases (k-1) B + 1 to k B.  Its one file in FOLDER/blocks/k:1000/
 * is k.part while it is computed, with a record behind every case, and in the end k.done, or
 * k.failed when some of its cases have failed.  A part is gone on with where it ends.
 */
#ifndef MLG_BLOCKS_H
#define MLG_BLOCKS_H

#include "description.h"
#include "record.h"

struct blocks {
  const struct sweep *sweep;
  const char *folder;
  long long size, n; /* cases in a block; blocks */
};

enum block_state { BLOCK_NONE, BLOCK_PART, BLOCK_FAILED, BLOCK_DONE, BLOCK_STATES };

/* The state of every block, by its number; to be freed. */
unsigned char *block_states(const struct blocks *blocks);

/* The records of a block. */
struct block {
  long long first;       /* case */
  long cases;
  struct record *record; /* by case - first; n = 0: none */
  long known, failed;    /* how many have one; and of these have failed */
  struct record units;   /* of its columns; text NULL: no record says them */
  size_t whole;          /* bytes of the file up to where it ends or is damaged */
  struct text bytes;
};

/* Reads the file of a block in that state.  Returns 0, or -1 with a line in why. */
int read_block(const struct blocks *blocks, long long k, enum block_state state, struct block *block, struct text *why);
void free_block(struct block *block);

/* Whether a process computes block k, of which there is a part. */
bool is_at_work(const struct blocks *blocks, long long k);

/* Computes what block k lacks; with retry what has failed once more.  Waits while another
 * process is at it.  Returns 0, or 1 after a line that says why. */
int compute_block(const struct blocks *blocks, long long k, bool retry);

#endif
