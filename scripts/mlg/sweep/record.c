/* record.c - what is known of a case, as it stands in the file of a block; see record.h */
#include "record.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* FNV-1a of these bytes behind others. */
static uint32_t sum_of(uint32_t sum, const char *bytes, size_t n)
{
  for (size_t i = 0; i < n; i++)
    sum = (sum ^ (unsigned char)bytes[i]) * UINT32_C(16777619);
  return sum;
}

static int head_of(const struct record *r, char head[100])
{
  if (r->units)
    return snprintf(head, 100, "units ");
  return r->failed ? snprintf(head, 100, "failed %lld %d %d ", r->n, r->step, r->status)
                   : snprintf(head, 100, "ok %lld %d ", r->n, r->rows);
}

static uint32_t sum_of_record(const struct record *r)
{
  char head[100];
  const int n = head_of(r, head);

  return sum_of(sum_of(UINT32_C(2166136261), head, (size_t)n), r->text, r->length);
}

void add_record(struct text *text, const struct record *r)
{
  char head[100];

  text_append(text, head, (size_t)head_of(r, head));
  text_append(text, head, (size_t)snprintf(head, sizeof head, "%08x%s", sum_of_record(r), r->failed || r->units ? " " : "\n"));
  text_append(text, r->text, r->length);
  if (r->failed || r->units)
    text_append(text, "\n", 1);
}

/* That many lines from text on; 0: there are not so many. */
static const char *behind_lines(const char *text, const char *end, int lines)
{
  for (; lines > 0; lines--) {
    text = memchr(text, '\n', (size_t)(end - text));
    if (!text++)
      return NULL;
  }
  return text;
}

size_t read_record(const char *text, size_t length, struct record *r)
{
  const char *end = text + length, *line = memchr(text, '\n', length), *to;
  unsigned sum;
  char head[200];
  int n = 0;

  if (!line)
    return 0;
  snprintf(head, sizeof head, "%.*s", (int)(line - text < 150 ? line - text : 150), text);
  *r = (struct record){ .failed = head[0] == 'f', .units = head[0] == 'u' };
  if (r->units ? sscanf(head, "units %8x%n", &sum, &n) != 1 || head[n] != ' '
      : r->failed ? sscanf(head, "failed %lld %d %d %8x%n", &r->n, &r->step, &r->status, &sum, &n) != 4 || head[n] != ' '
                : sscanf(head, "ok %lld %d %8x%n", &r->n, &r->rows, &sum, &n) != 3 || text + n != line)
    return 0;
  r->text = text + n + 1;
  to = r->failed || r->units ? line : behind_lines(r->text, end, r->rows);
  if (!to || to < r->text)
    return 0;
  r->length = (size_t)(to - r->text);
  return sum_of_record(r) == sum ? (size_t)(to - text) + (r->failed || r->units) : 0;
}
