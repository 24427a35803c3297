/* stamp.h - what a run was made of, and whether it still is that
 *
 * build/runs/NAME/stamp holds what the run was made of, text and sums of files, and the
 * sums of what AUTO wrote and of origin; build/runs/NAME/looks what a look at these files told
 * (size, time), so that a file is read again only when it looks different.
 */
#ifndef MLG_STAMP_H
#define MLG_STAMP_H

#include <stdint.h>

#include "text.h"

/* Files in the order in which they stand in the stamp. */
enum stamped { STAMP_JUDGE, STAMP_MODEL, STAMP_START, STAMP_B, STAMP_D, STAMP_S, STAMP_C, STAMP_ORIGIN, STAMPED };

enum stamp_state {
  STAMP_FITS,       /* nothing changed */
  STAMP_NEW_JUDGE,  /* only the judge did: what is there may be judged again */
  STAMP_OTHER,      /* no stamp, or made of something else */
  STAMP_DAMAGED     /* a file of AUTO's is not what it wrote */
};

/* A run's stamp.  file[i]: its path, "" for none (no start). */
struct stamp { struct text text; char *file[STAMPED]; };

/* text: all that is no file (what is expected, the constants). */
void stamp_begin(struct stamp *stamp, const char *folder, const char *name, const char *text, const char *model,
                 const char *start);
void stamp_free(struct stamp *stamp);

/* Compares with the stamp in the folder.  STAMP_DAMAGED: the name of the file in what. */
enum stamp_state stamp_state(const struct stamp *stamp, const char *folder, struct text *what);

/* Writes stamp and looks into a folder, with the sums of the files as they are now; those
 * of AUTO are looked for there.  Returns 0, or -1 with a line in why. */
int stamp_write(const struct stamp *stamp, const char *folder, struct text *why);

#endif
