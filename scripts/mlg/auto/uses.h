/* uses.h - which files a figure hangs on */
#ifndef MLG_USES_H
#define MLG_USES_H

/* Adds a file to the list that MLG_USES names, if it does. */
void note_use(const char *file);

#endif
