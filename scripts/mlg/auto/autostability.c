/* autostability.c - AUTO's d. files: the stability of the points of b.; see autofile.h */
#include "autoread.h"

#include <stdlib.h>
#include <string.h>

/* What d. says of the stability at points: blocks "Stable: n" with their eigenvalues.
 * The last one that stands there for a point is of the point itself, those before
 * belong to steps on the way. */
struct blocks { size_t n, room; struct block { int run, branch, count, eigenvalues; long number; size_t eigenvalue; } *at; };

static struct block *add_block(struct blocks *blocks)
{
  if (blocks->n == blocks->room) {
    blocks->room = 2 * blocks->room + 64;
    blocks->at = must_resize(blocks->at, blocks->room * sizeof *blocks->at);
  }
  return &blocks->at[blocks->n++];
}

enum { WORD = 19 }; /* where the words about stability stand in a line */

/* What stands behind the word at a place of a line, or NULL. */
static const char *behind(const char *line, size_t length, size_t from, const char *word)
{
  const size_t n = strlen(word);

  return length >= from + n && memcmp(line + from, word, n) == 0 ? line + from + n : NULL;
}

/* The count behind "Eigenvalues  :   Stable:" or "Multipliers:     Stable:", or NULL. */
static const char *behind_stable(const char *line, size_t length)
{
  const char *t = behind(line, length, WORD, "Eigenvalues  :   Stable:");

  return t ? t : behind(line, length, WORD, "Multipliers:     Stable:");
}

/* re and im, 14 characters each, behind the number of an eigenvalue, which has 3, and
 * one more character. */
static int read_eigenvalue(struct af_branches *all, size_t *n, size_t *room, const char *t, const char *end)
{
  double part[2];

  for (int k = 0; k < 2; k++)
    if (end - t < 4 + 14 * (k + 1) || !af_number(t + 4 + 14 * k, 14, &part[k]))
      return 0;
  if (*n + 2 > *room) {
    *room = 2 * *room + 1024;
    all->eigenvalue = must_resize(all->eigenvalue, *room * sizeof *all->eigenvalue);
  }
  all->eigenvalue[(*n)++] = part[0];
  all->eigenvalue[(*n)++] = part[1];
  return 1;
}

static int read_blocks(struct af_branches *all, struct blocks *blocks, const char *file, const struct text *text,
                       struct text *why)
{
  struct reader r = { file, text->at, text->at + text->length, reader_zero(text), why };
  size_t n = 0, room = 0, length;
  const char *line;
  int run = 0;

  if (r.line > 0)
    return reader_refuse(&r, "a zero byte");
  while (reader_line(&r, &line, &length)) {
    long branch, number, count;
    const char *t;

    if (r.at == r.end && text->at[text->length - 1] != '\n')
      return reader_refuse(&r, "the last line is cut");
    if (behind(line, length, 1, "Total Time")) {
      all->timed = 1;
      run++;
    } else if ((t = behind_stable(line, length))) {
      if (!reader_number(line, length, 0, 4, &branch) || !reader_number(line, length, 4, 10, &number)
          || !reader_number(t, (size_t)(line + length - t), 0, (size_t)(line + length - t) < 8 ? (size_t)(line + length - t) : 8, &count))
        return reader_refuse(&r, "no branch, point and number of stable eigenvalues");
      *add_block(blocks) = (struct block){ .run = run, .branch = (int)labs(branch), .count = (int)count,
                                           .number = (labs(number) - 1) % WRAP + 1, .eigenvalue = n };
    } else if (blocks->n > 0 && ((t = behind(line, length, WORD, "Eigenvalue")) || (t = behind(line, length, WORD, "Multiplier")))
               && reader_number(t, (size_t)(line + length - t), 0, 3, &number)) {
      if (!read_eigenvalue(all, &n, &room, t, line + length))
        return reader_refuse(&r, "no two numbers of an eigenvalue");
      blocks->at[blocks->n - 1].eigenvalues++;
    }
  }
  return 0;
}

/* Gives each point its last block.  Both files go through the same points in the same
 * order, and number them alike. */
static void join_blocks(struct af_branches *all, const struct blocks *blocks)
{
  size_t at = 0;

  for (int i = 0; i < all->parts; i++) {
    struct af_part *p = &all->part[i];

    for (long k = 0; k < p->points; k++) {
      struct af_point *point = &p->point[k];
      const long number = (point->number - 1) % WRAP + 1;
      size_t found = at;

      /* a point may have no block; then the next ones must not be passed over */
      while (found < blocks->n && found - at < 400
             && (blocks->at[found].branch != point->branch || blocks->at[found].number != number))
        found++;
      if (found == blocks->n || blocks->at[found].branch != point->branch || blocks->at[found].number != number)
        continue;
      while (found + 1 < blocks->n && blocks->at[found + 1].branch == point->branch
             && blocks->at[found + 1].number == number && blocks->at[found + 1].run == blocks->at[found].run)
        found++;
      point->stable_count = blocks->at[found].count;
      point->eigenvalues = blocks->at[found].eigenvalues;
      point->eigenvalue = blocks->at[found].eigenvalue;
      at = found + 1;
    }
  }
}

int read_stability(struct af_branches *all, const char *file, const struct text *text, struct text *why)
{
  struct blocks blocks = { 0, 0, NULL };
  const int status = read_blocks(all, &blocks, file, text, why);

  all->has_d = status == 0 && blocks.n > 0;
  if (status == 0)
    join_blocks(all, &blocks);
  free(blocks.at);
  return status;
}
