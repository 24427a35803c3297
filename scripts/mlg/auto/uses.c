/* uses.c - mlg stamp: with what a figure was made, and whether that still is so (stamp.c: the
 * same of a run)
 *
 * While MLG_USES names a file that is there, every command of mlg adds to it the files that it read or
 * made (note_use).  `mlg stamp write` takes their sums at the end, `mlg stamp fits`
 * compares: a file that looks as it did is taken for the same, of another the sum decides.
 */
#define _XOPEN_SOURCE 700
#include "uses.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "sums.h"
#include "text.h"

void note_use(const char *file)
{
  const char *journal = getenv("MLG_USES");
  struct text line = TEXT_NONE;
  int to;

  if (!journal || !*journal || !file || !*file)
    return;
  to = open(journal, O_WRONLY | O_APPEND | O_CLOEXEC);
  if (to < 0)
    return; /* without a stamp the figure is made again */
  text_add(&line, "%s\n", file);
  if (write(to, line.at, line.length) != (ssize_t)line.length) {
    perror(journal);
    unlink(journal); /* half a list would be taken for all */
  }
  close(to);
  text_free(&line);
}

static char *stamp_file(const char *name)
{
  struct text file = TEXT_NONE;

  text_add(&file, "%sbuild/stamps/%s", checkout(), name);
  return file.at;
}

static int by_text(const void *a, const void *b)
{
  return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Whether a file that people write was changed since the figure was begun. */
static int is_edited(const char *file, const char *began)
{
  struct stat then, now;

  if (strncmp(file, "build/", 6) == 0 || strncmp(file, "results/", 8) == 0 || stat(began, &then) != 0
      || stat(file, &now) != 0)
    return 0;
  return now.st_mtim.tv_sec > then.st_mtim.tv_sec
         || (now.st_mtim.tv_sec == then.st_mtim.tv_sec && now.st_mtim.tv_nsec > then.st_mtim.tv_nsec);
}

/* A line "SUM LOOK\tFILE" for each file, each once. */
static int write_stamp(const char *name, char *files[], int n)
{
  char *file = stamp_file(name);
  struct text text = TEXT_NONE, why = TEXT_NONE, began = TEXT_NONE;
  int status = MLG_OK;

  text_add(&began, "%s.began", file);
  qsort(files, (size_t)n, sizeof *files, by_text);
  for (int i = 0; i < n && status == MLG_OK; i++) {
    uint64_t sum;

    if (i > 0 && strcmp(files[i], files[i - 1]) == 0)
      continue;
    if (is_edited(files[i], began.at)) {
      remove(file);
      goto done; /* what is there was made with the file as it was: next time again */
    }
    if (sum_of_file(files[i], &sum, &why) != 0)
      status = MLG_FAILED;
    text_add(&text, "%016llx ", (unsigned long long)sum);
    look_of_file(files[i], &text);
    text_add(&text, "\t%s\n", files[i]);
  }
  text_add(&text, "end\n");
  if (status == MLG_OK && write_file(file, text.at, text.length, &why) != 0)
    status = MLG_FAILED;
  if (status != MLG_OK)
    fprintf(stderr, "stamp: %s\n", why.at);
done:
  text_free(&text);
  text_free(&why);
  text_free(&began);
  free(file);
  return status;
}

/* Whether one line still holds; only_made: or is of no file in build/tables. */
static int line_fits(char *line, int only_made)
{
  char *tab = strchr(line, '\t'), *blank = strchr(line, ' '), *end;
  struct text look = TEXT_NONE, why = TEXT_NONE;
  uint64_t sum, now;
  int fits;

  if (!tab || !blank || blank > tab)
    return 0;
  *tab = *blank = '\0';
  sum = strtoull(line, &end, 16);
  if (*end)
    return 0;
  if (only_made && strncmp(tab + 1, "build/tables/", strlen("build/tables/")) != 0)
    return 1;
  look_of_file(tab + 1, &look);
  fits = strcmp(look.at, blank + 1) == 0 || (sum_of_file(tab + 1, &now, &why) == 0 && now == sum);
  text_free(&look);
  text_free(&why);
  return fits;
}

static int fits(const char *name, int only_made)
{
  char *file = stamp_file(name);
  struct text text = TEXT_NONE, why = TEXT_NONE;
  int whole = 0, good = read_file(file, &text, &why) == 0;

  for (char *t = text.at, *next; good && t && *t; t = next) {
    next = strchr(t, '\n');
    if (!next)
      break;
    *next++ = '\0';
    if (strcmp(t, "end") == 0)
      whole = !*next;
    else
      good = line_fits(t, only_made);
  }
  text_free(&text);
  text_free(&why);
  free(file);
  return good && whole;
}

/* The words and the lines of the journal. */
static int write_with_journal(const char *name, char *files[], int n)
{
  const char *journal = getenv("MLG_USES");
  struct text text = TEXT_NONE, why = TEXT_NONE;
  char **all = must_allocate((size_t)(n + 1) * sizeof *all);
  int status;

  memcpy(all, files, (size_t)n * sizeof *all);
  if (journal && *journal && read_file(journal, &text, &why) != 0)
    n = 0;
  else
    for (char *t = text.at, *next; t && (next = strchr(t, '\n')); t = next + 1) {
      *next = '\0';
      all = must_resize(all, (size_t)(n + 2) * sizeof *all);
      all[n++] = t;
    }
  if (n > 0)
    status = write_stamp(name, all, n);
  else {
    fprintf(stderr, "stamp: %s: no files%s%s\n", name, why.length ? ": " : "", why.length ? why.at : "");
    status = MLG_FAILED;
  }
  free(all);
  text_free(&text);
  text_free(&why);
  return status;
}

static int run(int argc, char *argv[])
{
  const int write = argc > 2 && strcmp(argv[1], "write") == 0, whole = argc > 2 && strcmp(argv[1], "whole") == 0;
  int status = MLG_OK;

  if (argc < 3 || (!write && !whole && strcmp(argv[1], "fits") != 0)) {
    fputs("usage: mlg stamp fits NAME... | mlg stamp whole NAME... | mlg stamp write NAME [FILE...]\n", stderr);
    return MLG_BAD_INPUT;
  }
  for (int i = 2; i < (write ? 3 : argc); i++)
    if (!is_name(argv[i])) {
      fprintf(stderr, "stamp: NAME '%s': %s\n", argv[i], NAME_RULE);
      return MLG_BAD_INPUT;
    }
  if (write)
    return write_with_journal(argv[2], argv + 3, argc - 3);
  for (int i = 2; i < argc; i++)
    if (!fits(argv[i], whole)) {
      puts(argv[i]);
      status = MLG_FAILED;
    }
  return status;
}

const struct command command_stamp = {
  "stamp", "fits NAME... | whole NAME... | write NAME [FILE...]",
  "with what a figure was made, and whether that still is so",
  "write: build/stamps/NAME gets the sums of each FILE and of all files that commands of mlg\n"
  "used since MLG_USES names their list.  fits: prints each NAME of whose files one is no\n"
  "longer what it was; status 1 when there is such a NAME.  whole: of the files in build/tables\n"
  "alone, whatever became of what they were made of.\n",
  run,
};
