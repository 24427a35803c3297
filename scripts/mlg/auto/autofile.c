/* autofile.c - AUTO's b. files; see autofile.h
 *
 * A line of b. is branch, point, type and label in 4, 6, 4 and 5 characters, then
 * numbers in 19 each; large ones touch, so that a line is cut up by places and not by
 * blanks.  Branch 0 marks the lines of a head: the first one has the four bounds, the
 * last one names the columns, 19 characters each.
 */
#include "autoread.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { HEAD = 19, FIELD = 19, MOST_NAMES = 4096 };

int af_column(const struct af_part *part, const char *name)
{
  for (int k = 0; k < part->columns; k++)
    if (strcmp(part->column[k], name) == 0)
      return k;
  return -1;
}

double af_value(const struct af_part *part, long point, int column)
{
  return column < 0 ? (double)NAN : part->value[point * part->columns + column];
}

/* --- reading ------------------------------------------------------------------- */

int reader_refuse(const struct reader *r, const char *what)
{
  text_add(r->why, "%s:%ld: %s", r->file, r->line, what);
  return -1;
}

int reader_line(struct reader *r, const char **start, size_t *length)
{
  const char *end;

  if (r->at == r->end)
    return 0;
  *start = r->at;
  end = memchr(r->at, '\n', (size_t)(r->end - r->at));
  r->at = end ? end + 1 : r->end;
  *length = (size_t)((end ? end : r->end) - *start);
  if (*length > 0 && (*start)[*length - 1] == '\r')
    --*length;
  r->line++;
  return 1;
}

int reader_number(const char *line, size_t length, size_t from, size_t to, long *value)
{
  char copy[16];
  size_t n = 0;

  if (to > length)
    return 0;
  for (size_t i = from; i < to; i++)
    if (line[i] != ' ')
      copy[n++] = line[i];
  copy[n] = '\0';
  return n > 0 && whole_number(copy, INT32_MIN, INT32_MAX, value);
}

static char *copy_of(const char *text, size_t length)
{
  char *t = must_allocate(length + 1);

  memcpy(t, text, length);
  t[length] = '\0';
  return t;
}

static void set_name(char ***names, int *n, long slot, const char *text, size_t length)
{
  if (slot < 1 || slot > MOST_NAMES)
    return;
  if (slot > *n) {
    *names = must_resize(*names, (size_t)slot * sizeof **names);
    while (*n < slot)
      (*names)[(*n)++] = copy_of("", 0);
  }
  free((*names)[slot - 1]);
  (*names)[slot - 1] = copy_of(text, length);
}

static void free_names(char ***names, int *n)
{
  while (*n > 0)
    free((*names)[--*n]);
  free(*names);
  *names = NULL;
}

static void copy_names(char ***to, int *n_to, char **from, int n_from)
{
  free_names(to, n_to);
  for (int k = 0; k < n_from; k++)
    set_name(to, n_to, k + 1, from[k], strlen(from[k]));
}

/* {1: 'V', 2: 'c_d'} of a line of the head */
static void read_names(char ***names, int *n, const char *t, const char *end)
{
  free_names(names, n);
  while (t < end) {
    const char *digits = t, *quote, *close;
    long slot = 0;

    while (digits < end && !isdigit((unsigned char)*digits))
      digits++;
    for (quote = digits; quote < end && isdigit((unsigned char)*quote) && slot < MOST_NAMES; quote++)
      slot = 10 * slot + (*quote - '0');
    while (quote < end && *quote != '\'')
      quote++;
    close = quote < end ? memchr(quote + 1, '\'', (size_t)(end - quote - 1)) : NULL;
    if (!close)
      return;
    set_name(names, n, slot, quote + 1, (size_t)(close - quote - 1));
    t = close + 1;
  }
}

/* NAME= number, of a line of the head; the first of that name counts: what follows
 * "where different from above" is what was asked for. */
static void read_constant(struct af_constants *c, unsigned *seen, const char *name, size_t length, double x)
{
  static const char *const whole[] = { "NDIM", "IPS", "ILP", "ISP", "ISW", "IID", "NPR", "NMX" };
  int *const to[] = { &c->NDIM, &c->IPS, &c->ILP, &c->ISP, &c->ISW, &c->IID, &c->NPR };

  for (unsigned i = 0; i < 8; i++)
    if (strlen(whole[i]) == length && memcmp(whole[i], name, length) == 0 && !(*seen & 1u << i) && fabs(x) < 2e9) {
      if (i < 7)
        *to[i] = (int)x;
      else
        c->NMX = (long)x;
      *seen |= 1u << i;
    }
}

static void read_constants(struct af_constants *c, unsigned *seen, const char *t, const char *end)
{
  while (t < end) {
    const char *name, *name_end, *number;
    double x;

    while (t < end && !isupper((unsigned char)*t))
      t++;
    for (name = t; t < end && isalnum((unsigned char)*t); t++)
      ;
    name_end = t;
    while (t < end && *t == ' ')
      t++;
    if (t == end || *t != '=') {
      if (t < end && t == name_end)
        t++;
      continue;
    }
    for (t++; t < end && *t == ' '; t++)
      ;
    for (number = t; t < end && *t != ' '; t++)
      ;
    if (af_number(number, (size_t)(t - number), &x))
      read_constant(c, seen, name, (size_t)(name_end - name), x);
  }
}

/* What the lines of a head have told so far. */
struct head {
  struct af_part part; /* constants and names */
  unsigned seen;
};

static void read_columns(struct af_part *p, const char *line, size_t length)
{
  free_names(&p->column, &p->columns);
  while (length > 0 && line[length - 1] == ' ')
    length--;
  for (size_t from = HEAD; from < length; from += FIELD) {
    size_t to = from + FIELD < length ? from + FIELD : length, first = from;

    while (first < to && line[first] == ' ')
      first++;
    while (to > first && line[to - 1] == ' ')
      to--;
    set_name(&p->column, &p->columns, p->columns + 1, line + first, to - first);
  }
}

static int has(const char *line, size_t length, const char *word)
{
  const size_t n = strlen(word);

  for (size_t i = 0; i + n <= length; i++)
    if (memcmp(line + i, word, n) == 0)
      return 1;
  return 0;
}

static int begins(const char *line, size_t length, const char *word)
{
  size_t i = 4;

  while (i < length && line[i] == ' ')
    i++;
  return length - i >= strlen(word) && memcmp(line + i, word, strlen(word)) == 0;
}

/* A line of the head.  Returns 1 when it names the columns. */
static int read_head(struct head *h, const char *line, size_t length)
{
  struct af_constants *c = &h->part.constants;
  double bound[4];
  int bounds = length == 53; /* 5 and four times 12 characters: the first line */

  for (int k = 0; k < 4 && bounds; k++)
    bounds = af_number(line + 5 + 12 * k, 12, &bound[k]);
  if (bounds) {
    free(c->SP);
    *c = (struct af_constants){ .SP = copy_of("", 0), .RL0 = bound[0], .RL1 = bound[1], .A0 = bound[2], .A1 = bound[3] };
    free_names(&h->part.parameter, &h->part.parameters);
    free_names(&h->part.state, &h->part.states);
    h->seen = 0;
  } else if (has(line, length, "PT  TY  LAB")) {
    read_columns(&h->part, line, length);
    return 1;
  } else if (begins(line, length, "parnames"))
    read_names(&h->part.parameter, &h->part.parameters, line + 4, line + length);
  else if (begins(line, length, "unames"))
    read_names(&h->part.state, &h->part.states, line + 4, line + length);
  else if (begins(line, length, "SP=")) {
    free(c->SP);
    c->SP = copy_of(line + 4, length - 4);
  } else if (!has(line, length, "'") && !has(line, length, "{") && !has(line, length, "["))
    read_constants(c, &h->seen, line + 4, line + length);
  return 0;
}

static struct af_part *begin_part(struct af_branches *all, const struct head *h)
{
  struct af_part *p;

  all->part = must_resize(all->part, (size_t)(all->parts + 1) * sizeof *all->part);
  p = &all->part[all->parts++];
  *p = (struct af_part){ .constants = h->part.constants };
  p->constants.SP = copy_of(h->part.constants.SP, strlen(h->part.constants.SP));
  copy_names(&p->column, &p->columns, h->part.column, h->part.columns);
  copy_names(&p->parameter, &p->parameters, h->part.parameter, h->part.parameters);
  copy_names(&p->state, &p->states, h->part.state, h->part.states);
  return p;
}

/* Makes room for one point more. */
static struct af_point *add_point(struct af_part *p)
{
  if ((p->points & (p->points - 1)) == 0) { /* 0, 1, 2, 4, 8, ... */
    const size_t room = p->points ? 2 * (size_t)p->points : 1;

    p->point = must_resize(p->point, room * sizeof *p->point);
    p->value = must_resize(p->value, room * (size_t)p->columns * sizeof *p->value);
  }
  return &p->point[p->points++];
}

/* A point's number, which counts on where AUTO begins with 1 again after 9999. */
static long counted_on(long before, long number)
{
  const long was = (before - 1) % WRAP + 1;

  return number > was || was - number < WRAP / 2 ? before + number - was : before + number - was + WRAP;
}

/* A line of numbers.  *p is the part in hand; a new one begins where the numbers of
 * the points do. */
static int read_point(struct reader *r, struct af_branches *all, struct af_part **p, const struct head *h,
                      const char *line, size_t length)
{
  long branch, number, type, label;
  struct af_point *point;
  long n;

  if (!reader_number(line, length, 0, 4, &branch) || !reader_number(line, length, 4, 10, &number)
      || !reader_number(line, length, 10, 14, &type) || !reader_number(line, length, 14, 19, &label))
    return reader_refuse(r, length < HEAD ? "a line that is cut" : "no branch, point, type and label");
  if (!*p)
    return reader_refuse(r, "a point before the names of the columns");
  if (labs(type) > 99)
    return reader_refuse(r, "no type of a point");
  n = labs(number);
  if ((*p)->points > 0) {
    const struct af_point *last = &(*p)->point[(*p)->points - 1];

    n = counted_on(last->number, labs(number));
    if (labs(branch) != last->branch || n <= last->number) {
      *p = begin_part(all, h);
      n = labs(number);
    } else if (n > last->number + 1 && !(*p)->gap)
      (*p)->gap = r->line;
  } else if (n > 1)
    (*p)->gap = r->line;
  point = add_point(*p);
  *point = (struct af_point){ .branch = (int)labs(branch), .number = n, .type = (int)type, .label = (int)label,
                              .stable = number < 0, .stable_count = -1, .line = r->line };
  for (int k = 0; k < (*p)->columns; k++) {
    double *x = &(*p)->value[((*p)->points - 1) * (*p)->columns + k];
    const size_t from = HEAD + (size_t)k * FIELD;

    if (from + 2 > length)
      return reader_refuse(r, "a line that is cut: fewer numbers than columns");
    if (!af_number(line + from, from + FIELD < length ? FIELD : length - from, x))
      return reader_refuse(r, "no number in one of the columns");
    if (isnan(*x) && !(*p)->nan)
      (*p)->nan = r->line;
  }
  for (size_t i = HEAD + (size_t)(*p)->columns * FIELD; i < length; i++)
    if (line[i] != ' ')
      return reader_refuse(r, "more numbers than columns");
  return 0;
}

static void free_head(struct head *h)
{
  free(h->part.constants.SP);
  free_names(&h->part.column, &h->part.columns);
  free_names(&h->part.parameter, &h->part.parameters);
  free_names(&h->part.state, &h->part.states);
}

long reader_zero(const struct text *text)
{
  const char *zero = memchr(text->at, '\0', text->length);
  long line = 1;

  for (const char *t = text->at; zero && t < zero; t++)
    line += *t == '\n';
  return zero ? line : 0;
}

static int read_b(struct af_branches *all, const struct text *text, struct text *why)
{
  struct reader r = { all->file, text->at, text->at + text->length, reader_zero(text), why };
  struct head h = { .part.constants.SP = copy_of("", 0) };
  struct af_part *part = NULL;
  const char *line;
  size_t length;
  int status = r.line > 0 ? reader_refuse(&r, "a zero byte") : 0;

  r.line = 0;
  while (status == 0 && reader_line(&r, &line, &length)) {
    long branch;

    if (r.at == r.end && text->at[text->length - 1] != '\n')
      status = reader_refuse(&r, "the last line is cut");
    else if (length >= 4 && memcmp(line, "   0", 4) == 0) {
      if (read_head(&h, line, length)) {
        if (h.part.columns == 0)
          status = reader_refuse(&r, "no names of columns");
        else
          part = begin_part(all, &h);
      }
    } else if (!reader_number(line, length, 0, 4, &branch))
      status = reader_refuse(&r, "neither a point nor a line of the head");
    else
      status = read_point(&r, all, &part, &h, line, length);
  }
  free_head(&h);
  return status;
}

int af_read(struct af_branches *all, const char *b, const char *d, struct text *why)
{
  struct text text = TEXT_NONE, none = TEXT_NONE;
  int status;

  *all = (struct af_branches){ .file = copy_of(b, strlen(b)), .timed = 1 };
  status = read_file(b, &text, why);
  if (status == 0)
    status = read_b(all, &text, why);
  if (status == 0 && d && read_file(d, &text, &none) == 0 && text.length > 0) {
    all->timed = 0;
    status = read_stability(all, d, &text, why);
  }
  text_free(&text);
  text_free(&none);
  if (status != 0)
    af_free(all);
  return status;
}

void af_free(struct af_branches *all)
{
  for (int i = 0; i < all->parts; i++) {
    struct af_part *p = &all->part[i];

    free(p->constants.SP);
    free_names(&p->column, &p->columns);
    free_names(&p->parameter, &p->parameters);
    free_names(&p->state, &p->states);
    free(p->point);
    free(p->value);
  }
  free(all->part);
  free(all->eigenvalue);
  free(all->file);
  *all = (struct af_branches){ 0 };
}
