/* text.c - texts that grow, files read whole, and the names of runs; see text.h */
#define _POSIX_C_SOURCE 200809L
#include "text.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static _Noreturn void out_of_memory(void)
{
  fputs("mlg: out of memory\n", stderr);
  exit(1);
}

void *must_resize(void *block, size_t size)
{
  void *p = realloc(block, size ? size : 1);

  if (!p)
    out_of_memory();
  return p;
}

void *must_allocate(size_t size)
{
  return must_resize(NULL, size);
}

static void make_room(struct text *text, size_t more)
{
  if (more >= SIZE_MAX / 4 - text->length)
    out_of_memory();
  if (text->length + more + 1 > text->room) {
    text->room = 2 * (text->length + more + 1);
    text->at = must_resize(text->at, text->room);
  }
}

void text_append(struct text *text, const char *bytes, size_t length)
{
  make_room(text, length);
  memcpy(text->at + text->length, bytes, length);
  text->length += length;
  text->at[text->length] = '\0';
}

void text_add(struct text *text, const char *format, ...)
{
  va_list args;
  int n;

  make_room(text, 120); /* nearly always enough */
  va_start(args, format);
  n = vsnprintf(text->at + text->length, text->room - text->length, format, args);
  va_end(args);
  if (n < 0)
    out_of_memory();
  if ((size_t)n >= text->room - text->length) {
    make_room(text, (size_t)n);
    va_start(args, format);
    vsnprintf(text->at + text->length, text->room - text->length, format, args);
    va_end(args);
  }
  text->length += (size_t)n;
}

void text_clear(struct text *text)
{
  make_room(text, 0);
  text->length = 0;
  text->at[0] = '\0';
}

void text_free(struct text *text)
{
  free(text->at);
  *text = (struct text)TEXT_NONE;
}

int read_file(const char *file, struct text *text, struct text *why)
{
  struct stat about;
  const int descriptor = open(file, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* a pipe shall not hang */
  ssize_t n = 0;

  text_clear(text);
  if (descriptor < 0 || fstat(descriptor, &about) != 0) {
    text_add(why, "%s: %s", file, strerror(errno));
    if (descriptor >= 0)
      close(descriptor);
    return -1;
  }
  if (!S_ISREG(about.st_mode)) {
    text_add(why, "%s: %s", file, S_ISDIR(about.st_mode) ? "is a folder" : "is no regular file");
    close(descriptor);
    return -1;
  }
  make_room(text, (size_t)about.st_size);
  for (;;) {
    make_room(text, 1); /* it may still grow */
    n = read(descriptor, text->at + text->length, text->room - text->length - 1);
    if (n > 0)
      text->length += (size_t)n;
    else if (n == 0 || errno != EINTR)
      break;
  }
  text->at[text->length] = '\0';
  if (n < 0)
    text_add(why, "%s: %s", file, strerror(errno));
  close(descriptor);
  return n < 0 ? -1 : 0;
}

int write_file(const char *file, const char *bytes, size_t length, struct text *why)
{
  struct text part = TEXT_NONE;
  FILE *f;
  int good;

  text_add(&part, "%s.new", file);
  f = fopen(part.at, "w");
  good = f && fwrite(bytes, 1, length, f) == length;
  good = f && fclose(f) == 0 && good;
  good = good && rename(part.at, file) == 0;
  if (!good) {
    text_add(why, "%s: cannot be written: %s", file, strerror(errno));
    if (f)
      unlink(part.at);
  }
  text_free(&part);
  return good ? 0 : -1;
}

void say_line(const char *who, const char *what)
{
  struct text line = TEXT_NONE;

  text_add(&line, "%s%s%s", who ? who : "", who ? ": " : "", what);
  for (char *t = line.at; *t; t++)
    if (iscntrl((unsigned char)*t))
      *t = ' ';
  fprintf(stderr, "%s\n", line.at);
  text_free(&line);
}

int is_name(const char *name)
{
  static const char first[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+";
  const size_t length = strlen(name);

  return length > 0 && length <= 100 && !strchr("._-+", name[0]) && strspn(name, first) == length;
}

int whole_number(const char *text, long least, long most, long *value)
{
  char *end;

  if (!strchr("-0123456789", text[0]) || !text[0])
    return 0;
  errno = 0;
  *value = strtol(text, &end, 10);
  return end != text && *end == '\0' && errno == 0 && *value >= least && *value <= most;
}

const char *checkout(void)
{
  static char root[PATH_MAX + 2];
  static int known;
  const char *given = getenv("MLG_ROOT");
  struct stat here, there;
  ssize_t n = -1;

  if (known)
    return root;
  known = 1;
  if (given && strlen(given) < PATH_MAX)
    strcpy(root, given);
  else if ((n = readlink("/proc/self/exe", root, PATH_MAX)) > 0) {
    root[n] = '\0';
    for (int i = 0; i < 3; i++) { /* ROOT/build/bin/mlg */
      char *slash = strrchr(root, '/');

      if (slash)
        *slash = '\0';
    }
  }
  if (stat(".", &here) == 0 && stat(root, &there) == 0 && here.st_dev == there.st_dev
      && here.st_ino == there.st_ino)
    root[0] = '\0';
  else if (root[0])
    strcat(root, "/");
  return root;
}

const char *runs_folder(void)
{
  static struct text folder = TEXT_NONE;
  const char *given = getenv("MLG_RUNS");

  if (folder.length == 0)
    text_add(&folder, "%s%s", given && *given ? "" : checkout(), given && *given ? given : "build/runs");
  return folder.at;
}
