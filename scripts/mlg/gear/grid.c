/* grid.c - a row for each gear of one or two ranges NAME=FROM:TO:N of a command */
#include "grid.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"

void grid_word(struct grid *g, const char *word)
{
  if (!strchr(word, ':')) {
    take_word(g->a, word);
    return;
  }
  if (g->ranges == MOST_RANGES)
    refuse(g->a->command, word, "there are two ranges already");
  g->range[g->ranges++] = take_range(g->a, word);
}

/* In equal steps, over a factor of 50 and more in equal ratios. */
static void set_range(struct grid *g, int k, int i)
{
  const struct range *r = &g->range[k];
  const double t = (double)i / (r->n - 1);

  g->value[k] = r->from > 0. && r->to / r->from >= 50. ? r->from * pow(r->to / r->from, t) : r->from + (r->to - r->from) * t;
  retake_value(g->a, r->text, range_name_length(r), g->value[k]);
  if (libmlg_lacks(g->a->par))
    fail(g->a->command, MLG_BAD_INPUT, "%s", libmlg_lacks(g->a->par));
}

void grid_check(struct grid *g)
{
  for (int end = 0; end < 2; end++)
    for (int k = 0; k < g->ranges; k++)
      set_range(g, k, end ? g->range[k].n - 1 : 0);
}

void grid_head(const struct grid *g)
{
  for (int k = 0; k < g->ranges; k++)
    printf("%.*s,", (int)range_name_length(&g->range[k]), g->range[k].text);
}

static void rows(struct grid *g, int k, void point(void *data), void fresh(void *data), void *data)
{
  if (k == g->ranges) {
    for (int i = 0; i < k; i++)
      printf("%.10g,", g->value[i]);
    point(data);
    return;
  }
  if (fresh)
    fresh(data);
  for (int i = 0; i < g->range[k].n; i++) {
    set_range(g, k, i);
    rows(g, k + 1, point, fresh, data);
  }
}

void grid_rows(struct grid *g, void point(void *data), void fresh(void *data), void *data)
{
  rows(g, 0, point, fresh, data);
}
