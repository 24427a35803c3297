/* progress.c - the line of a run, and how far all has come; see progress.h */
#define _XOPEN_SOURCE 700
#include "progress.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "text.h"

/* build/runs/passed.STARTED, or NULL where there is nothing to tell. */
static char *passed_file(void)
{
  const char *started = getenv("MLG_STARTED");
  struct text file = TEXT_NONE;
  long at;

  if (!started || !whole_number(started, 1, 99999999999L, &at) || !isatty(1))
    return NULL;
  text_add(&file, "%s/passed.%s", runs_folder(), started);
  return file.at;
}

/* Those of earlier times are of no use. */
static void remove_others(void)
{
  DIR *folder = opendir(runs_folder());
  struct dirent *entry;

  while (folder && (entry = readdir(folder)))
    if (strncmp(entry->d_name, "passed.", 7) == 0)
      unlinkat(dirfd(folder), entry->d_name, 0);
  if (folder)
    closedir(folder);
}

void note_passed(const char *run)
{
  char *file = passed_file();
  int descriptor;

  if (!file)
    return;
  if (access(file, F_OK) != 0)
    remove_others();
  descriptor = open(file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor >= 0) {
    dprintf(descriptor, "%s\n", run); /* in one piece, so that runs side by side do not mix */
    close(descriptor);
  }
  free(file);
}

static int by_text(const void *a, const void *b)
{
  return strcmp(*(char *const *)a, *(char *const *)b);
}

/* How many different lines a text has; it is cut up. */
static long different_lines(char *text)
{
  char **line = NULL;
  size_t n = 0;
  long different = 0;

  for (char *t = strtok(text, "\n"); t; t = strtok(NULL, "\n")) {
    line = must_resize(line, (n + 1) * sizeof *line);
    line[n++] = t;
  }
  if (n > 0)
    qsort(line, n, sizeof *line, by_text);
  for (size_t i = 0; i < n; i++)
    different += i == 0 || strcmp(line[i], line[i - 1]) != 0;
  free(line);
  return different;
}

/* How many runs the figures asked for took last time. */
static double runs_last_time(void)
{
  const char *asked = getenv("MLG_ASKED");
  struct text file = TEXT_NONE, text = TEXT_NONE, why = TEXT_NONE, list = TEXT_NONE;
  double runs = 0.;

  text_add(&file, "%sresults/versions.csv", checkout());
  text_add(&list, " %s ", asked ? asked : "");
  if (read_file(file.at, &text, &why) == 0)
    for (char *t = strtok(text.at, "\n"); t; t = strtok(NULL, "\n")) {
      struct text word = TEXT_NONE;

      text_add(&word, " %.*s ", (int)strcspn(t, ","), t);
      if (t[strcspn(t, ",")] && strstr(list.at, word.at))
        runs += strtod(t + strcspn(t, ",") + 1, NULL);
      text_free(&word);
    }
  text_free(&file);
  text_free(&text);
  text_free(&why);
  text_free(&list);
  return runs;
}

static void print_progress(void)
{
  char *file = passed_file();
  struct text text = TEXT_NONE, why = TEXT_NONE;
  double runs, n, elapsed;

  if (file && read_file(file, &text, &why) == 0) {
    n = (double)different_lines(text.at);
    elapsed = difftime(time(NULL), (time_t)strtol(getenv("MLG_STARTED"), NULL, 10));
    runs = runs_last_time();
    if (n > 0. && n <= runs)
      printf("  [%.0f of %.0f runs, %.0f s of about %.0f s]", n, runs, elapsed, elapsed * runs / n);
    else
      printf("  [%.0f runs, %.0f s]", n, elapsed);
  }
  text_free(&text);
  text_free(&why);
  free(file);
}

void report_run(const char *name, double ms, const char *text)
{
  printf("  %-28s %5.0f ms  %s", name, ms, text);
  print_progress();
  putchar('\n');
}
