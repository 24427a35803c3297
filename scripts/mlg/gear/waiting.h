/* waiting.h - a line of progress while a search is long */
#ifndef MLG_WAITING_H
#define MLG_WAITING_H

/* On a terminal at standard error the searches of libmlg say there how far they are, in one line that
 * goes away at the end or at a row of the output; nothing elsewhere. */
void show_searches(void);

/* Takes the line away, before a row is printed. */
void hide_search(void);

#endif
