/* runs.h - where the files of a run are */
#ifndef MLG_RUNS_H
#define MLG_RUNS_H

#include "text.h"

/* A run's files.  d, s, log: NULL where there is none; layout: NULL where not known. */
struct run_files { char *name, *b, *d, *s, *log, *layout; };

/* What a user calls a run:
 *   NAME          build/runs/NAME with b.NAME, d.NAME, s.NAME
 *   NAME.part     one that the judge rejected, as it was left
 *   FOLDER/NAME   these files in any folder
 *   FOLDER        its only b. file, or fort.7, fort.9 and fort.8
 *   FILE          a b. file, or fort.7, by its own name
 * Returns 0, or -1 with a line in why. */
int find_run(const char *word, struct run_files *files, struct text *why);
void free_run(struct run_files *files);

/* Finds and says, for a command: 0, or 2 after "COMMAND: why" on standard error. */
int find_run_or_say(const char *command, const char *word, struct run_files *files);

#endif
