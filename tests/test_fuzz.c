/* test_fuzz.c - the constants checker on random input, under ASan and UBSan
 *
 * scripts/constants.c is compiled in, with its files, its memory and its end in
 * the hands of this test, so that it runs thousands of times a second.  An input
 * is a text of up to three parts with a line "%" between them: the constants file,
 * the gear file, and the words of the command line, one a line.
 *
 * Whatever the input: status 0, nothing on standard error, and an output that is
 * accepted and printed again as it is; or status 2, nothing on standard output, and
 * one line on standard error.
 *
 *   build/tests/fuzz                all of tests/corpus, then 200000 changes of it
 *   FUZZ=n SEED=s build/tests/fuzz  n changes, other ones
 *
 * Each input stands in build/tests/fuzz.input while it is tried: after a crash the
 * one that did it.
 */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmocka.h>

enum { ROOM = 1 << 13, MOST_WORDS = 32, MOST_SEEDS = 200, MOST_BLOCKS = 4096 };

static jmp_buf end_of_program;
static char *part[3]; /* of the input at hand */
static void *block[MOST_BLOCKS];
static int blocks;

static _Noreturn void end_program(int status)
{
  longjmp(end_of_program, status + 1);
}

static void *allocate(size_t size)
{
  void *p = malloc(size);

  assert_true(p && blocks < MOST_BLOCKS);
  return block[blocks++] = p;
}

static FILE *open_part(const char *name, const char *mode)
{
  char *text = strcmp(name, "file") == 0 ? part[0] : part[1];

  return fmemopen(text, strlen(text), mode);
}

#define main constants_main
#define exit end_program
#define malloc allocate
#define fopen open_part
#include "../scripts/constants.c"
#undef main
#undef exit
#undef malloc
#undef fopen

/* Runs the program on part[]; its output and its complaint, for free(). */
static int run_program(char **output, char **complaint)
{
  FILE *const real_output = stdout, *const real_error = stderr;
  char *argv[MOST_WORDS + 3] = { "constants", "file" };
  size_t n[2];
  int argc = 2, status;

  for (char *word = strtok(part[2], "\n"); word && argc < MOST_WORDS; word = strtok(NULL, "\n"))
    argv[argc++] = word;
  stdout = open_memstream(output, &n[0]);
  stderr = open_memstream(complaint, &n[1]);
  status = setjmp(end_of_program);
  status = status ? status - 1 : constants_main(argc, argv);
  fclose(stdout);
  fclose(stderr);
  stdout = real_output;
  stderr = real_error;
  while (blocks > 0)
    free(block[--blocks]);
  return status;
}

static const char *wrong(int status, const char *output, const char *complaint)
{
  const size_t lines = strcspn(complaint, "\n");

  if (status == 0)
    return *complaint ? "status 0, but a complaint" : NULL;
  if (status != STATUS_BAD_INPUT)
    return "a status that is neither 0 nor 2";
  if (*output)
    return "an output beside a complaint";
  return lines == 0 || strcmp(complaint + lines, "\n") != 0 ? "a complaint that is not one line" : NULL;
}

/* Tries one input; ends the test when something is wrong. */
static void try(const char *input)
{
  static char text[ROOM];
  static char none[] = "";
  char *output, *complaint, *again, *t = text;
  const char *what;
  int status;

  snprintf(text, sizeof text, "%s", input);
  for (int i = 0; i < 3; i++) {
    char *end = strstr(t, "\n%\n");

    part[i] = t;
    if (end)
      *end = '\0', t = end + 3;
    else
      t = none;
  }
  status = run_program(&output, &complaint);
  what = wrong(status, output, complaint);
  if (what)
    fail_msg("%s:\n%s%sof\n%s", what, output, complaint, input);
  free(complaint);
  if (status == 0) {
    part[0] = output;
    part[1] = part[2] = none;
    status = run_program(&again, &complaint);
    if (status != 0 || strcmp(output, again) != 0)
      fail_msg("its own output is taken otherwise:\n%s%sof\n%s", again, complaint, input);
    free(again);
    free(complaint);
  }
  free(output);
}

static char *seed[MOST_SEEDS];
static int seeds;

static void read_corpus(void)
{
  static const char *const folder[] = { "tests/corpus", "constants" };

  for (int i = 0; i < 2; i++) {
    DIR *d = opendir(folder[i]);
    struct dirent *entry;

    assert_non_null(d);
    while ((entry = readdir(d)) && seeds < MOST_SEEDS) {
      char path[600];
      FILE *f;

      if (entry->d_name[0] == '.')
        continue;
      snprintf(path, sizeof path, "%s/%s", folder[i], entry->d_name);
      f = fopen(path, "r");
      assert_non_null(f);
      seed[seeds] = calloc(1, ROOM);
      (void)!fread(seed[seeds++], 1, ROOM - 1, f);
      fclose(f);
    }
    closedir(d);
  }
}

static char *input; /* a file, so that a crash leaves it behind */

static void corpus(void **state)
{
  (void)state;
  for (int i = 0; i < seeds; i++) {
    strcpy(input, seed[i]);
    try(input);
  }
  assert_true(seeds > 40);
}

static uint64_t random_state;

static size_t below(size_t n)
{
  random_state ^= random_state << 13;
  random_state ^= random_state >> 7;
  random_state ^= random_state << 17;
  return (size_t)(random_state >> 11) % n;
}

/* One change: a byte, a word, a piece removed, doubled, or taken from another seed. */
static void change(void)
{
  static const char *const word[] = {
    "'", "\"", "[", "]", "{", "}", ",", ":", "=", "\n", "#", " ", "-", "\n%\n", "1e300", "nan", "0", "99999999999999999999",
    "'V'", "'c_d'", "PAR = {", "parnames = {", "unames = {", "ICP = [", "gear=g", "layout=li1", "layout=l9", "NDIM = ", "\\", "\x80",
  };
  char piece[256];
  const size_t n = strlen(input), at = below(n + 1);
  size_t length = 0, removed = 0;

  switch (below(5)) {
  case 0:
    removed = 1, length = 1, piece[0] = (char)(1 + below(255));
    break;
  case 1:
    length = strlen(strcpy(piece, word[below(sizeof word / sizeof *word)]));
    break;
  case 2:
    removed = below(64);
    break;
  case 3:
    length = below(sizeof piece), memcpy(piece, input + below(n + 1), length);
    length = strnlen(piece, length);
    break;
  default: {
    const char *other = seed[below((size_t)seeds)];

    length = below(sizeof piece);
    memcpy(piece, other + below(strlen(other) + 1), length);
    length = strnlen(piece, length);
    removed = below(64);
  }
  }
  removed = removed < n - at ? removed : n - at;
  if (n - removed + length >= ROOM - 256)
    return;
  memmove(input + at + length, input + at + removed, n - at - removed + 1);
  memcpy(input + at, piece, length);
}

static void changes_of_the_corpus(void **state)
{
  const char *count = getenv("FUZZ"), *start = getenv("SEED");

  (void)state;
  random_state = 0x9E3779B97F4A7C15u + (start ? strtoull(start, NULL, 10) : 0);
  for (long i = count ? atol(count) : 200000; i > 0; i--) {
    strcpy(input, seed[below((size_t)seeds)]);
    for (size_t k = 1 + below(6); k > 0; k--)
      change();
    try(input);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(corpus),
    cmocka_unit_test(changes_of_the_corpus),
  };
  FILE *f = fopen("build/tests/fuzz.input", "w+");

  if (!f || ftruncate(fileno(f), ROOM) != 0
      || (input = mmap(NULL, ROOM, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(f), 0)) == MAP_FAILED) {
    perror("build/tests/fuzz.input");
    return 2;
  }
  read_corpus();
  return cmocka_run_group_tests_name("fuzz", tests, NULL, NULL);
}
