/* waiting.c - see waiting.h */
#define _POSIX_C_SOURCE 200809L /* isatty, clock_gettime */
#include "waiting.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "watch.h"

static int shown;

static double seconds(void)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void show(const char *what, int i, int n)
{
  static double first = 0., last = 0.;
  const double now = seconds();

  if (!(first > 0.))
    first = now;
  if (now - last < 0.2)
    return;
  last = now;
  shown = 1;
  fprintf(stderr, "\r\033[K%s: %d of %d, %.0f s", what, i + 1, n, now - first);
}

void hide_search(void)
{
  if (shown)
    fputs("\r\033[K", stderr);
  shown = 0;
}

void show_searches(void)
{
  if (!isatty(STDERR_FILENO))
    return;
  watch_searches(show);
  atexit(hide_search);
}
