/* child.h - AUTO as a process of its own, with bounds */
#ifndef MLG_CHILD_H
#define MLG_CHILD_H

#include "text.h"

/* Runs a model in a folder, its output in auto.log there.  It ends with this program,
 * also when that is killed, and when it has taken MLG_TIME_LIMIT seconds of processor time
 * (600) or writes a file of more than MLG_SIZE_LIMIT MB (256).  A signal to end (INT, TERM, HUP) ends it, removes
 * the folder and then ends this program by the same signal.
 * Returns AUTO's status, 128 and more for a signal; a bound that was met stands in why. */
int run_model(const char *model, const char *folder, struct text *why);

/* The seconds MLG_TIME_LIMIT allows, or -1: it is no whole number from 1 to 1000000. */
long time_limit(void);

/* The MB of MLG_SIZE_LIMIT, likewise. */
long size_limit(void);

/* Removes a folder and all in it.  Returns 0, or -1 with errno set. */
int remove_folder(const char *folder);

#endif
