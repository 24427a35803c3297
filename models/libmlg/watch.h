/* watch.h - how far a long search has come; private to libmlg and the commands */
#ifndef LIBMLG_WATCH_H
#define LIBMLG_WATCH_H

/* From now on searches tell what they are at, "grid over k_s and b", and that step i of n begins;
 * NULL: nobody. */
void watch_searches(void told(const char *what, int i, int n));

void watch_tell(const char *what, int i, int n);

#endif
