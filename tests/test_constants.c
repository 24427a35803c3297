/* test_constants.c - the constants checker on random input, under ASan and UBSan
 *
 * scripts/mlg/auto/constants.h, with its files in the hands of this test, so that it runs
 * thousands of times a second.  An input is a text of up to three parts with a line
 * "%" between them: the constants file, the gear file, and the words of the command
 * line, one a line.
 *
 * Whatever the input: status 0, no complaint, and an output that is accepted and
 * printed again as it is; or status 2, no output, and one line of complaint.
 *
 *   build/tests/constants                all of tests/corpus, then 200000 changes of it
 *   FUZZ=n SEED=s build/tests/constants  n changes, other ones
 *
 * Each input stands in build/tests/constants.input while it is tried: after a crash
 * the one that did it.
 */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <dirent.h>
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

#include "text.h"

static char *part[3]; /* of the input at hand */

/* Files are the parts: "file", and any other is the gear. */
static int read_part(const char *file, struct text *text, struct text *why)
{
  const char *from = part[strcmp(file, "file") == 0 ? 0 : 1];

  (void)why;
  text_clear(text);
  text_append(text, from, strlen(from));
  return 0;
}

#define read_file read_part
#include "conparse.c"
#include "gearfile.c"
#undef read_file

enum { ROOM = 1 << 13, MOST_WORDS = 32, MOST_SEEDS = 200 };

static const char *wrong(int status, const struct text *out, const struct text *why)
{
  if (status == 0)
    return why->length ? "status 0, but a complaint" : NULL;
  if (status != 2)
    return "a status that is neither 0 nor 2";
  if (out->length)
    return "an output beside a complaint";
  for (size_t i = 0; i < why->length; i++)
    if (iscntrl((unsigned char)why->at[i]) && why->at[i] != '\x80')
      return "a complaint that is not one line";
  return why->length == 0 ? "no complaint" : NULL;
}

/* Hands over the words in part[2]. */
static int run_program(const struct constants_use *use, struct text *out, struct text *why)
{
  char *word[MOST_WORDS];
  int words = 0;

  text_clear(out);
  text_clear(why);
  for (char *w = strtok(part[2], "\n"); w && words < MOST_WORDS; w = strtok(NULL, "\n"))
    word[words++] = w;
  return hand_over("file", word, words, use, out, why);
}

/* Tries one input; ends the test when something is wrong. */
static void try(const char *input)
{
  static const struct constants_use uses[] = { { NULL, 0, 0 }, { "l1", 0, 0 }, { "li1", 0, 1 }, { "l2", 1, 0 } };
  static char text[ROOM];
  static char none[] = "";
  static unsigned tried;
  const struct constants_use *use = &uses[tried++ % 4];
  struct text out = TEXT_NONE, again = TEXT_NONE, why = TEXT_NONE;
  char *t = text;
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
  status = run_program(use, &out, &why);
  what = wrong(status, &out, &why);
  if (what)
    fail_msg("%s:\n%s%s\nof\n%s", what, out.at, why.at, input);
  if (status == 0) {
    part[0] = out.at;
    part[1] = part[2] = none;
    status = run_program(use, &again, &why);
    if (status != 0 || strcmp(out.at, again.at) != 0)
      fail_msg("its own output is taken otherwise:\n%s%s\nof\n%s", again.at, why.at, input);
  }
  text_free(&out);
  text_free(&again);
  text_free(&why);
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
  FILE *f = fopen("build/tests/constants.input", "w+");

  if (!f || ftruncate(fileno(f), ROOM) != 0
      || (input = mmap(NULL, ROOM, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(f), 0)) == MAP_FAILED) {
    perror("build/tests/constants.input");
    return 2;
  }
  read_corpus();
  return cmocka_run_group_tests_name("constants", tests, NULL, NULL);
}
