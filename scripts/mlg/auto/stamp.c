/* stamp.c - what a run was made of, and whether it still is that; see stamp.h */
#define _XOPEN_SOURCE 700
#include "stamp.h"

#include <stdlib.h>
#include <string.h>

#include "sums.h"

static const char *const kinds[STAMPED] = { "judge", "model", "start", "b", "d", "s", "c", "origin" };

static char *joined(const char *folder, const char *kind, const char *name)
{
  struct text t = TEXT_NONE;

  text_add(&t, "%s/%s%s%s", folder, kind, *kind ? "." : "", name);
  return t.at;
}

static char *copy(const char *text)
{
  struct text t = TEXT_NONE;

  text_add(&t, "%s", text);
  return t.at;
}

void stamp_begin(struct stamp *stamp, const char *folder, const char *name, const char *text, const char *model, const char *start)
{
  *stamp = (struct stamp){ TEXT_NONE, { NULL } };
  text_add(&stamp->text, "%s", text);
  stamp->file[STAMP_JUDGE] = copy("/proc/self/exe"); /* this program */
  stamp->file[STAMP_MODEL] = copy(model);
  stamp->file[STAMP_START] = copy(start ? start : "");
  for (int i = STAMP_B; i < STAMP_ORIGIN; i++)
    stamp->file[i] = joined(folder, kinds[i], name);
  stamp->file[STAMP_ORIGIN] = joined(folder, "", kinds[STAMP_ORIGIN]);
}

void stamp_free(struct stamp *stamp)
{
  text_free(&stamp->text);
  for (int i = 0; i < STAMPED; i++)
    free(stamp->file[i]);
}

/* The looks that stand in a folder, one a line; all "" when they are not there. */
static void read_looks(const char *folder, struct text *text, const char *look[STAMPED])
{
  char *file = joined(folder, "", "looks");
  struct text why = TEXT_NONE;
  char *t;

  for (int i = 0; i < STAMPED; i++)
    look[i] = "";
  if (read_file(file, text, &why) == 0)
    for (t = text->at; t && *t;) {
      char *end = strchr(t, '\n'), *blank = strchr(t, ' ');

      if (!end || !blank || blank > end)
        break;
      *end = *blank = '\0';
      for (int i = 0; i < STAMPED; i++)
        if (strcmp(t, kinds[i]) == 0)
          look[i] = blank + 1;
      t = end + 1;
    }
  text_free(&why);
  free(file);
}

static void write_looks(const struct stamp *stamp, const char *folder)
{
  char *file = joined(folder, "", "looks");
  struct text text = TEXT_NONE, why = TEXT_NONE;

  for (int i = 0; i < STAMPED; i++) {
    text_add(&text, "%s ", kinds[i]);
    look_of_file(stamp->file[i], &text);
    text_add(&text, "\n");
  }
  write_file(file, text.at, text.length, &why); /* without them the sums are taken */
  text_free(&text);
  text_free(&why);
  free(file);
}

/* The sum in "KIND SUM" at t, or -1: another kind, or garbled. */
static int sum_in(const char **t, const char *kind, uint64_t *sum)
{
  const size_t n = strlen(kind);
  const char *line = *t, *end = strchr(line, '\n');
  char *stop;

  if (!end || strncmp(line, kind, n) != 0 || line[n] != ' ' || (size_t)(end - line) != n + 17)
    return -1;
  *sum = strtoull(line + n + 1, &stop, 16);
  *t = end + 1;
  return stop == end ? 0 : -1;
}

/* Whether file i is as it was, by a look or else by its sum. */
static int same_file(const struct stamp *stamp, int i, const char *look, uint64_t sum, int *looked_new)
{
  struct text now = TEXT_NONE, why = TEXT_NONE;
  uint64_t sum_now = 0;
  int same;

  look_of_file(stamp->file[i], &now);
  same = strcmp(now.at, look) == 0;
  if (!same) {
    same = sum_of_file(stamp->file[i], &sum_now, &why) == 0 && sum_now == sum;
    *looked_new |= same;
  }
  text_free(&now);
  text_free(&why);
  return same;
}

enum stamp_state stamp_state(const struct stamp *stamp, const char *folder, struct text *what)
{
  char *file = joined(folder, "", "stamp");
  struct text text = TEXT_NONE, looks = TEXT_NONE, why = TEXT_NONE;
  const char *look[STAMPED], *t;
  enum stamp_state state = STAMP_FITS;
  int looked_new = 0;

  if (read_file(file, &text, &why) != 0 || text.length < stamp->text.length
      || memcmp(text.at, stamp->text.at, stamp->text.length) != 0 || text.at[stamp->text.length] != '\n')
    state = STAMP_OTHER;
  else {
    read_looks(folder, &looks, look);
    t = text.at + stamp->text.length + 1;
    for (int i = 0; i < STAMPED && (state == STAMP_FITS || state == STAMP_NEW_JUDGE); i++) {
      uint64_t sum;

      if (i == STAMP_START && !*stamp->file[i])
        continue;
      if (i == STAMP_ORIGIN && !*t)
        state = STAMP_NEW_JUDGE; /* of a version that did not look at it: once more, and stamped anew */
      else if (sum_in(&t, kinds[i], &sum) != 0)
        state = STAMP_OTHER; /* of an earlier version, or garbled */
      else if (same_file(stamp, i, look[i], sum, &looked_new))
        continue;
      else if (i == STAMP_JUDGE)
        state = STAMP_NEW_JUDGE;
      else if (i == STAMP_MODEL || i == STAMP_START)
        state = STAMP_OTHER;
      else {
        state = STAMP_DAMAGED;
        text_add(what, "%s", strrchr(stamp->file[i], '/') + 1);
      }
    }
    if ((state == STAMP_FITS || state == STAMP_NEW_JUDGE) && *t)
      state = STAMP_OTHER;
    if (state == STAMP_FITS && looked_new)
      write_looks(stamp, folder);
  }
  text_free(&text);
  text_free(&looks);
  text_free(&why);
  free(file);
  return state;
}

int stamp_write(const struct stamp *stamp, const char *folder, struct text *why)
{
  struct stamp moved = *stamp;
  struct text text = TEXT_NONE;
  char *file;
  int status = 0;

  for (int i = STAMP_B; i < STAMPED; i++) /* NAME.part is NAME soon */
    moved.file[i] = joined(folder, "", strrchr(stamp->file[i], '/') + 1);
  text_add(&text, "%s\n", stamp->text.at);
  for (int i = 0; i < STAMPED && status == 0; i++) {
    uint64_t sum;

    if (i == STAMP_START && !*stamp->file[i])
      continue;
    status = sum_of_file(moved.file[i], &sum, why);
    if (status == 0)
      text_add(&text, "%s %016llx\n", kinds[i], (unsigned long long)sum);
  }
  file = joined(folder, "", "stamp");
  if (status == 0)
    status = write_file(file, text.at, text.length, why);
  if (status == 0)
    write_looks(&moved, folder);
  free(file);
  for (int i = STAMP_B; i < STAMPED; i++)
    free(moved.file[i]);
  text_free(&text);
  return status;
}
