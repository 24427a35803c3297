/* cases.c - mlg cases: the cases of a sweep, counted, computed in blocks, gathered */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <time.h>

#include "arguments.h"
#include "blocks.h"
#include "child.h"
#include "command.h"
#include "gather.h"
#include "worker.h"

static const char name[] = "cases";

enum { SHOWN = 3, MOST_LISTED = 6 };

/* --- what a description means ----------------------------------------------------------- */

/* As they stand: they need not rise. */
static void print_list(const struct axis *a, long long n)
{
  for (long long i = 0; i < n; i++)
    if (n <= MOST_LISTED || i < MOST_LISTED - 2 || i == n - 1)
      printf("%s%s", i == 0 ? "" : i == n - 1 && n > MOST_LISTED ? ", ..., " : ", ", a->text[i]);
  printf("%s", n > MOST_LISTED ? "" : "\n");
  if (n > MOST_LISTED)
    printf(": %lld values\n", n);
}

static void print_axes(const struct sweep *s)
{
  for (int i = 0; i < s->axes; i++) {
    char first[VALUE_SIZE], last[VALUE_SIZE];
    const struct axis *a = &s->axis[i];
    const long long n = s->count[a->dimension];

    printf("  %-12s ", a->name);
    if (n == 1)
      printf("%s\n", axis_value(s, i, 1, first));
    else if (a->kind == AXIS_SAMPLE)
      printf("%.10g to %.10g%s, %lld points of a sample\n", a->from, a->to, a->ratios ? " by ratios" : "", n);
    else if (a->kind == AXIS_LIST)
      print_list(a, n);
    else
      printf("%s to %s, %lld values\n", axis_value(s, i, 1, first), axis_value(s, i, s->cases, last), n);
  }
}

static void print_commands(const struct sweep *s, long long n)
{
  static struct words words;

  for (int i = 0; i < s->steps; i++) {
    const int argc = fill_words(s, &s->step[i], n, &words);

    if (i == 0)
      printf("  case %lld:\n", n);
    printf("    mlg");
    for (int k = 0; k < argc; k++)
      printf(" %s", words.argv[k]);
    printf("\n");
  }
}

static void show(const struct sweep *s)
{
  printf("%s: %lld cases\n", s->file, s->cases);
  print_axes(s);
  for (long long n = 1; n <= SHOWN && n <= s->cases; n++)
    print_commands(s, n);
  if (s->cases > SHOWN)
    print_commands(s, s->cases);
}

static void print_files(const struct sweep *s)
{
  printf("%s\n", s->file);
  if (s->gear)
    printf("%s\n", s->gear);
  if (s->table)
    printf("%s\n", s->table);
  for (int i = 0; i < s->steps; i++)
    if (strcmp(s->step[i].command->name, "run") == 0)
      printf("run\n");
}

/* --- what it costs ---------------------------------------------------------------------- */

struct taken { struct text text; };

static int take(void *its, const char *bytes, size_t n)
{
  text_append(&((struct taken *)its)->text, bytes, n);
  return 0;
}

static double seconds(void)
{
  struct timespec t;

  timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Times more and more cases from all over the sweep, a second or two.  When all fail, and
 * there are some or it is by bad input, the first tells of a slip in the description. */
static int plan(const struct sweep *s, const char *folder)
{
  struct taken taken = { TEXT_NONE };
  struct record r, slip_of = { .n = 0 };
  long m = 1, cases = 0, failed = 0;
  char scratch[4096];
  double time = 0.;
  size_t n;

  snprintf(scratch, sizeof scratch, "%s/scratch.try", folder);
  while (time < 1. && cases < s->cases && m <= 65536) {
    long long *list = must_allocate((size_t)m * sizeof *list);

    for (long i = 0; i < m; i++)
      list[i] = m == s->cases ? i + 1 : 1 + (long long)(fmod(0.6180339887498949 * (double)i, 1.) * (double)s->cases);
    text_clear(&taken.text);
    const double began = seconds();

    if (compute_cases(s, list, m, scratch, false, (struct sink){ take, &taken }) != 0)
      return MLG_FAILED;
    time = seconds() - began;
    cases = m;
    m = m * 4 < s->cases ? m * 4 : (long)s->cases;
    free(list);
  }
  remove_folder(scratch);
  for (const char *at = taken.text.at, *end = at + taken.text.length; (n = read_record(at, (size_t)(end - at), &r)) > 0; at += n)
    if (r.failed) {
      failed++;
      if (slip_of.n == 0)
        slip_of = r;
    }
  const bool tells_line = slip_of.length > strlen(s->file) && memcmp(slip_of.text, s->file, strlen(s->file)) == 0
                          && slip_of.text[strlen(s->file)] == ':';

  if (failed == cases && tells_line) {
    struct text why = TEXT_NONE;

    text_add(&why, "%.*s", (int)slip_of.length, slip_of.text);
    say_line(NULL, why.at);
    exit(MLG_BAD_INPUT);
  }
  if (failed == cases && (cases >= 4 || cases == s->cases || slip_of.status == MLG_BAD_INPUT))
    slip(s, slip_of.step > 0 ? s->step[slip_of.step - 1].line : 0, slip_of.step > 0 ? s->step[slip_of.step - 1].command->name : NULL,
         "all %ld cases that were tried fail, case %lld with status %d: %.*s", cases, slip_of.n, slip_of.status,
         (int)slip_of.length, slip_of.text);
  printf("tried=%ld\nfailed=%ld\nseconds=%.3g\nbytes=%.0f\n", cases, failed, time / (double)cases,
         (double)taken.text.length / (double)cases + 40.);
  if (failed > 0)
    printf("why=case %lld, command %d, status %d: %.*s\n", slip_of.n, slip_of.step, slip_of.status, (int)slip_of.length,
           slip_of.text);
  text_free(&taken.text);
  return MLG_OK;
}

/* --- its blocks ------------------------------------------------------------------------- */

static int todo(const struct blocks *b, bool retry)
{
  unsigned char *state = block_states(b);

  for (long long k = 1; k <= b->n; k++)
    if (state[k] < BLOCK_FAILED || (retry && state[k] == BLOCK_FAILED))
      printf("%lld\n", k);
  free(state);
  return MLG_OK;
}

static int print_status(const struct blocks *b)
{
  struct tally t;

  if (count_cases(b, &t) != 0)
    return MLG_FAILED;
  printf("  %lld of %lld cases, %lld of %lld blocks", t.known, b->sweep->cases, t.blocks[BLOCK_DONE] + t.blocks[BLOCK_FAILED], b->n);
  if (t.blocks[BLOCK_PART] > 0)
    printf(", %lld begun", t.blocks[BLOCK_PART]);
  if (t.blocks[BLOCK_PART] > 0)
    printf(", %lld of them being computed now", t.at_work);
  if (t.failed > 0)
    printf("; %lld cases failed", t.failed);
  printf("\n");
  return MLG_OK;
}

struct request {
  const char *file, *what, *folder;
  long size, block;
  bool retry;
};

static const char *const words_known = "expected show, files, plan, block=K, todo, status, gather, failed, retry, size=N or folder=DIR";

static struct request read_request(int argc, char *argv[])
{
  static const char *const what[] = { "show", "files", "plan", "todo", "status", "gather", "failed" };
  struct request r = { .folder = NULL };

  for (int i = 1; i < argc; i++) {
    const char *w = argv[i];
    bool known = i == 1;

    if (i == 1)
      r.file = w;
    for (size_t k = 0; i > 1 && k < sizeof what / sizeof *what; k++)
      if (strcmp(w, what[k]) == 0 && !r.what)
        known = true, r.what = w;
    if (i > 1 && strcmp(w, "retry") == 0)
      known = r.retry = true;
    else if (i > 1 && strncmp(w, "folder=", 7) == 0 && w[7])
      known = true, r.folder = w + 7;
    else if (i > 1 && strncmp(w, "size=", 5) == 0)
      known = whole_number(w + 5, 1, 1000000000, &r.size);
    else if (i > 1 && strncmp(w, "block=", 6) == 0 && !r.what)
      known = whole_number(w + 6, 1, 1000000000000, &r.block), r.what = "block";
    if (!known)
      refuse(name, w, "%s", words_known);
  }
  if (!r.file)
    fail(name, MLG_BAD_INPUT, "expected a sweep's description; `mlg help cases` says more");
  r.what = r.what ? r.what : "show";
  return r;
}

static int run_cases(int argc, char *argv[])
{
  static struct sweep sweep;
  const struct request r = read_request(argc, argv);

  read_sweep(r.file, &sweep);
  if (strcmp(r.what, "show") == 0)
    return show(&sweep), MLG_OK;
  if (strcmp(r.what, "files") == 0)
    return print_files(&sweep), MLG_OK;
  if (!r.folder)
    fail(name, MLG_BAD_INPUT, "%s wants folder=DIR, where the sweep's files are", r.what);
  if (strcmp(r.what, "plan") == 0)
    return plan(&sweep, r.folder);
  if (r.size == 0)
    fail(name, MLG_BAD_INPUT, "%s wants size=N, the cases in a block", r.what);
  const struct blocks blocks = { &sweep, r.folder, r.size, (sweep.cases + r.size - 1) / r.size };

  if (r.block > blocks.n)
    fail(name, MLG_BAD_INPUT, "there are %lld blocks, and no block %ld", blocks.n, r.block);
  if (strcmp(r.what, "block") == 0 && prctl(PR_SET_PDEATHSIG, SIGTERM) != 0)
    fail(name, MLG_FAILED, "cannot ask to be told of the end of its parent");
  if (strcmp(r.what, "block") == 0)
    return compute_block(&blocks, r.block, r.retry);
  if (strcmp(r.what, "todo") == 0)
    return todo(&blocks, r.retry);
  if (strcmp(r.what, "status") == 0)
    return print_status(&blocks);
  return strcmp(r.what, "gather") == 0 ? gather(&blocks) : print_failed(&blocks);
}

const struct command command_cases = {
  .name = name,
  .usage = "FILE [show | files | plan | block=K | todo | status | gather | failed]\n     [folder=DIR] [size=N] [retry]",
  .summary = "the cases of a sweep: shown, computed in blocks, gathered",
  .details =
    "FILE: the description of a sweep (docs/sweeps.md).  scripts/sweep.sh gives the rest:\n"
    "  show     the number of cases, what varies, the commands of the first three and the last\n"
    "  files    the files it hangs on\n"
    "  plan     tries cases from all over it for a second: seconds and bytes of a case\n"
    "  block=K  computes the block of cases (K-1) N + 1 to K N into DIR/blocks, or goes on with it;\n"
    "           it ends, in order, with the process that began it\n"
    "  todo     the numbers of the blocks that are not done; retry: and of those with failed cases\n"
    "  status   how many are done, and whether some are being computed now\n"
    "  gather   DIR/table.csv and failed.csv, or partial.csv while some are not done (status 1)\n"
    "  failed   the failed cases, with the number of the command, its status and the reason\n"
    "retry: block=K computes its failed cases once more.  A block's file is written as it goes;\n"
    "whatever is killed and when, no case is computed twice and none is half there.\n",
  .run = run_cases,
};
