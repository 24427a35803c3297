/* worker.h - the cases of a sweep computed, one after the other, in a process of their own */
#ifndef MLG_WORKER_H
#define MLG_WORKER_H

#include "description.h"

/* Where records go: bytes of whole ones.  Returns 0, or -1 and says why itself. */
struct sink { int (*take)(void *its, const char *bytes, size_t n); void *its; };

/* Computes these cases, n of them, in another process; another takes its place when a case
 * ends it, and when one takes longer than the sweep allows.  Commands that may be called
 * again in a process are called there, any other in a process of its own.
 *   scratch  a folder for runs of AUTO, removed behind each case unless the sweep keeps it
 *   units    whether a record of the columns' units goes before the first good case
 * Records reach the sink within 0.2 s of their case.  This process may be killed at any
 * time: the others end with it.  A signal to end (INT, TERM, HUP) ends it by that signal.
 * Returns 0, or 1: the sink has failed, or the disk is full, after a line that says so. */
int compute_cases(const struct sweep *sweep, const long long cases[], long n, const char *scratch, bool units, struct sink sink);

#endif
