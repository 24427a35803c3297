/* progress.h - the line of a run, and how far all that was asked for has come */
#ifndef MLG_PROGRESS_H
#define MLG_PROGRESS_H

/* On a terminal, where MLG_STARTED (s since 1970) says when all began: notes that a run
 * was made or found made. */
void note_passed(const char *run);

/* Prints "  NAME   123 ms  TEXT" and on a terminal how many runs are done of those that
 * the figures in MLG_ASKED took last time (results/versions.csv), and the time. */
void report_run(const char *name, double ms, const char *text);

#endif
