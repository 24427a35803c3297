/* gather.c - the tables of a sweep, out of the files of its blocks; see gather.h */
#define _GNU_SOURCE
#include "gather.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What both tables begin with. */
static void print_head(const struct sweep *s, const char *what, FILE *f)
{
  fprintf(f, "# %s of the %lld cases of %s.", what, s->cases, s->file);
  if (s->gear)
    fprintf(f, " gear = %s.", s->gear);
  for (int i = 0; i < s->axes; i++)
    if (!varies(s, i)) {
      char value[VALUE_SIZE];

      fprintf(f, " %s = %s.", s->axis[i].name, axis_value(s, i, 1, value));
    }
  fputc('\n', f);
  for (int i = 0; i < s->steps; i++) {
    fprintf(f, "# %d:", i + 1);
    for (int k = 0; k < s->step[i].words; k++)
      fprintf(f, " %s", s->step[i].word[k]);
    fputc('\n', f);
  }
}

static void print_names(const struct sweep *s, FILE *f)
{
  fprintf(f, "case");
  for (int i = 0; i < s->axes; i++)
    if (varies(s, i))
      fprintf(f, ",%s", s->axis[i].name);
}

/* "12,l1,0.3,": a case and what it is */
static void print_case(const struct sweep *s, long long n, FILE *f)
{
  char value[VALUE_SIZE];

  fprintf(f, "%lld,", n);
  for (int i = 0; i < s->axes; i++)
    if (varies(s, i)) {
      fputs(axis_value(s, i, n, value), f);
      fputc(',', f);
    }
}

static void print_rows(const struct sweep *s, const struct record *r, FILE *f)
{
  const char *at = r->text;

  for (int row = 0; row < r->rows; row++) {
    const char *end = strchr(at, '\n') + 1;

    print_case(s, r->n, f);
    fwrite(at, 1, (size_t)(end - at), f);
    at = end;
  }
}

static void print_failure(const struct sweep *s, const struct record *r, FILE *f)
{
  print_case(s, r->n, f);
  fprintf(f, "%d,%s,%d,%.*s\n", r->step, r->step > 0 ? s->step[r->step - 1].command->name : "", r->status, (int)r->length,
          r->text);
}

/* Of what varies, and of the kept columns as the commands have said them; both tables of two
 * engines have the same, for a unit does not hang on the case. */
static void print_units(const struct blocks *b, const unsigned char *state, FILE *f)
{
  const struct sweep *s = b->sweep;
  struct text units = TEXT_NONE, why = TEXT_NONE;
  bool found = false;

  for (int i = 0; i < s->axes; i++)
    if (varies(s, i) && parameter_unit(s->axis[i].name))
      text_add(&units, "%s%s %s", units.length > 0 ? "; " : "", s->axis[i].name, parameter_unit(s->axis[i].name));
  for (long long k = 1; k <= b->n && !found; k++) {
    struct block block;

    if (state[k] == BLOCK_NONE)
      continue;
    if (read_block(b, k, (enum block_state)state[k], &block, &why) == 0 && block.units.text) {
      found = true;
      if (block.units.length > 0)
        text_add(&units, "%s%.*s", units.length > 0 ? "; " : "", (int)block.units.length, block.units.text);
    }
    free_block(&block);
  }
  if (units.length > 0)
    fprintf(f, "# %s\n", units.at);
  text_free(&units);
  text_free(&why);
}

static void print_answer_head(const struct blocks *b, const unsigned char *state, FILE *f)
{
  const struct sweep *s = b->sweep;

  print_head(s, "Answers", f);
  print_units(b, state, f);
  print_names(s, f);
  for (int i = 0; i < s->steps; i++)
    for (int k = 0; k < s->step[i].keeps; k++)
      fprintf(f, ",%s", s->step[i].keep[k].as);
  fputc('\n', f);
}

static void print_failed_head(const struct sweep *s, FILE *f)
{
  print_head(s, "Failures", f);
  print_names(s, f);
  fprintf(f, ",at,command,status,reason\n");
}

/* Calls for every record of the blocks in those states, by rising case. */
typedef void visit(const struct sweep *s, const struct record *record, void *its);

static int visit_records(const struct blocks *b, const unsigned char *state, bool in_state(enum block_state), visit *visit,
                         void *its)
{
  struct text why = TEXT_NONE;

  for (long long k = 1; k <= b->n; k++) {
    struct block block;

    if (!in_state((enum block_state)state[k]))
      continue;
    if (read_block(b, k, (enum block_state)state[k], &block, &why) != 0) {
      say_line("mlg cases", why.at);
      free_block(&block);
      text_free(&why);
      return MLG_FAILED;
    }
    for (long i = 0; i < block.cases; i++)
      if (block.record[i].n != 0)
        visit(b->sweep, &block.record[i], its);
    free_block(&block);
  }
  return MLG_OK;
}

static bool is_begun(enum block_state s) { return s != BLOCK_NONE; }
static bool has_some_to_count(enum block_state s) { return s == BLOCK_PART || s == BLOCK_FAILED; }

static void count(const struct sweep *s, const struct record *r, void *its)
{
  struct tally *t = its;

  (void)s;
  t->known++;
  t->failed += r->failed;
}

int count_cases(const struct blocks *b, struct tally *t)
{
  unsigned char *state = block_states(b);

  *t = (struct tally){ .known = 0 };
  for (long long k = 1; k <= b->n; k++) {
    t->blocks[state[k]]++;
    t->at_work += state[k] == BLOCK_PART && is_at_work(b, k);
    if (state[k] == BLOCK_DONE)
      t->known += k < b->n ? b->size : b->sweep->cases - (b->n - 1) * b->size;
  }
  const int status = visit_records(b, state, has_some_to_count, count, t);

  free(state);
  return status;
}

struct tables { FILE *answers, *failed; long long known, failures; };

static void print_record(const struct sweep *s, const struct record *r, void *its)
{
  struct tables *t = its;

  t->known++;
  t->failures += r->failed;
  if (r->failed && t->failed)
    print_failure(s, r, t->failed);
  if (!r->failed && t->answers)
    print_rows(s, r, t->answers);
}

int print_failed(const struct blocks *b)
{
  unsigned char *state = block_states(b);
  struct tables t = { NULL, stdout, 0, 0 };

  print_failed_head(b->sweep, stdout);
  const int status = visit_records(b, state, has_some_to_count, print_record, &t);

  free(state);
  return status;
}

/* Closes a table and puts it in place, or removes it. */
static int put_in_place(FILE *f, const char *from, const char *to, bool wanted)
{
  const bool bad = fflush(f) != 0 || ferror(f) || (wanted && fsync(fileno(f)) != 0);
  int status = MLG_OK;

  if (fclose(f) != 0 || bad || (wanted && rename(from, to) != 0)) {
    fprintf(stderr, "mlg cases: %s: %s\n", to, strerror(errno));
    status = MLG_FAILED;
  }
  if (!wanted || status != MLG_OK)
    unlink(from);
  return status;
}

static char *named(const struct blocks *b, const char *name)
{
  struct text path = TEXT_NONE;

  text_add(&path, "%s/%s", b->folder, name);
  return path.at;
}

int gather(const struct blocks *b)
{
  unsigned char *state = block_states(b);
  char *table = named(b, "table.csv"), *partial = named(b, "partial.csv"), *failed = named(b, "failed.csv");
  char *new_table = named(b, "table.csv.new"), *new_failed = named(b, "failed.csv.new");
  struct tables t = { fopen(new_table, "w"), fopen(new_failed, "w"), 0, 0 };
  int status = MLG_FAILED;

  if (t.answers && t.failed) {
    print_answer_head(b, state, t.answers);
    print_failed_head(b->sweep, t.failed);
    status = visit_records(b, state, is_begun, print_record, &t);
  } else
    fprintf(stderr, "mlg cases: %s: %s\n", new_table, strerror(errno));
  const bool whole = status == MLG_OK && t.known == b->sweep->cases, good = status == MLG_OK;

  if (good && whole)
    unlink(partial);
  if (t.answers && put_in_place(t.answers, new_table, whole ? table : partial, good) != MLG_OK)
    status = MLG_FAILED;
  if (good && t.failures == 0)
    unlink(failed);
  if (t.failed && put_in_place(t.failed, new_failed, failed, good && t.failures > 0) != MLG_OK)
    status = MLG_FAILED;
  if (status == MLG_OK)
    printf("  %s: %lld of %lld cases", whole ? table : partial, t.known - t.failures, b->sweep->cases);
  if (status == MLG_OK && t.failures > 0)
    printf("; %lld failed: %s", t.failures, failed);
  if (status == MLG_OK && !whole)
    printf("; %lld not computed yet", b->sweep->cases - t.known);
  if (status == MLG_OK)
    putchar('\n');
  free(state);
  for (char **name = (char *[]){ table, partial, failed, new_table, new_failed, NULL }; *name; name++)
    free(*name);
  return status == MLG_OK && !whole ? MLG_FAILED : status;
}
