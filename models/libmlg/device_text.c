/* device_text.c - devices written as text: reading, writing, stiffness; see device_text.h */
#include "device_text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- reading ------------------------------------------------------------------------- */

/* What may stand in a text by name, once each; k_psi stands before every device. */
static const struct { const char *name; enum part_kind kind; int slot; } named[] = {
  { "k_psi", SPRING, PAR_K_PSI }, { "k_d", SPRING, PAR_K_D }, { "k_s", SPRING, PAR_K_S },
  { "c_d", DAMPER, PAR_C_D }, { "b", INERTER, PAR_B },
};

enum { K_PSI, NAMED = sizeof named / sizeof *named };

/* error[] is empty as long as all goes well. */
struct reader { struct device_text *d; const char *at; char *error; size_t size; int seen[NAMED], damper, order; };

static const struct part *wrong(struct reader *r, const char *right)
{
  if (r->error[0] == '\0')
    snprintf(r->error, r->size, "at '%.20s': %s", r->at, right);
  return NULL;
}

static void skip_blanks(struct reader *r)
{
  while (*r->at == ' ')
    r->at++;
}

static const struct part *add(struct reader *r, struct part part)
{
  struct part *place = &r->d->part[r->d->parts++];

  *place = part;
  return place;
}

static const struct part *add_group(struct reader *r, enum part_kind kind, const struct part *a, const struct part *b)
{
  return a && b ? add(r, (struct part){ .kind = kind, .slot = -1, .a = a, .b = b }) : NULL;
}

static const struct part *add_element(struct reader *r, const char *word, size_t length, struct part part)
{
  char *copy = r->d->word[r->d->words];

  if (r->d->words == DEVICE_ELEMENTS - 1)
    return wrong(r, "more than nine elements");
  if (length >= sizeof r->d->word[0])
    return wrong(r, "a value with fewer digits is expected");
  r->order += part.kind == DAMPER ? 1 : part.kind == INERTER ? 2 : 0;
  if (r->order > DEVICE_ORDER)
    return wrong(r, "one element too many: six states are most, one for each damper and two for each inerter");
  memcpy(copy, word, length);
  copy[length] = '\0';
  r->d->words++;
  r->at += length;
  part.text = copy;
  return add(r, part);
}

static const char letters[] = "kcb"; /* in the order of enum part_kind */

/* The same wide ranges as those of k_d, c_d and b in mlg.h, without what is nothing to rounding. */
static const struct { double least, most; const char *text; } ranges[] = {
  { 1., 1e12, "1 to 1e12 N m/rad" }, { 1e-6, 1e9, "1e-6 to 1e9 N m s/rad" }, { 1e-6, 1e9, "1e-6 to 1e9 N m s^2/rad" },
};

/* NAME=VALUE, value points behind the = */
static const struct part *read_number(struct reader *r, const char *value)
{
  char *end;
  const double number = strtod(value, &end);
  const int kind = (int)(strchr(letters, *r->at) - letters), is_digit = isdigit((unsigned char)value[*value == '.']);
  char right[80];

  if (!is_digit || value[1] == 'x' || value[1] == 'X' || !(number >= ranges[kind].least && number <= ranges[kind].most)) {
    snprintf(right, sizeof right, "a number from %s is expected behind the =", ranges[kind].text);
    return wrong(r, right);
  }
  return add_element(r, r->at, (size_t)(end - r->at), (struct part){ .kind = (enum part_kind)kind, .slot = -1, .value = number });
}

static const struct part *read_group(struct reader *r);

static const struct part *read_element(struct reader *r)
{
  size_t length = 0;

  skip_blanks(r);
  if (*r->at == '(') {
    r->at++;
    const struct part *const inside = read_group(r);

    if (!inside)
      return NULL;
    if (*r->at != ')')
      return wrong(r, "expected |, - or )");
    r->at++;
    skip_blanks(r);
    return inside;
  }
  while (isalnum((unsigned char)r->at[length]) || r->at[length] == '_')
    length++;
  for (int i = 0; i < NAMED; i++)
    if (strlen(named[i].name) == length && memcmp(named[i].name, r->at, length) == 0 && r->at[length] != '=') {
      if (r->seen[i]++)
        return wrong(r, i == K_PSI ? "k_psi stands before every device by itself" : "given already, and an element stands once");
      r->damper |= named[i].slot == PAR_C_D;
      const struct part *const element = add_element(r, r->at, length, (struct part){ .kind = named[i].kind, .slot = named[i].slot });

      skip_blanks(r);
      return element;
    }
  if (length > 0 && r->at[length] == '=' && strchr(letters, *r->at)) {
    const struct part *const element = read_number(r, r->at + length + 1);

    skip_blanks(r);
    return element;
  }
  return wrong(r, "expected k_d, k_s, c_d, b, k=VALUE, c=VALUE, b=VALUE or (");
}

static const struct part *read_branch(struct reader *r)
{
  const struct part *p = read_element(r);

  while (p && *r->at == '-') {
    r->at++;
    p = add_group(r, SERIES, p, read_element(r));
  }
  return p;
}

static const struct part *read_group(struct reader *r)
{
  const struct part *p = read_branch(r);

  while (p && *r->at == '|') {
    r->at++;
    p = add_group(r, PARALLEL, p, read_branch(r));
  }
  return p;
}

/* --- stiffness ------------------------------------------------------------------------ */

static struct network stiffness(const struct part *p, const double par[])
{
  const double value = p->slot >= 0 ? par[p->slot] : p->value;

  switch (p->kind) {
  case SPRING: return spring(value >= MLG_RIGID ? INFINITY : value);
  case DAMPER: return damper(value);
  case INERTER: return inerter(value);
  case PARALLEL: return parallel(stiffness(p->a, par), stiffness(p->b, par));
  default: return series(stiffness(p->a, par), stiffness(p->b, par));
  }
}

/* Two dampers or inerters one behind the other leave a power of s in num and den. */
static struct poly without(struct poly p, int powers)
{
  struct poly q = { { 0. } };

  memcpy(q.coefficient, p.coefficient + powers, (size_t)(POLY_TERMS - powers) * sizeof *q.coefficient);
  return q;
}

struct network device_stiffness(const struct device_text *d, const double par[])
{
  if (!d->whole)
    return series(spring(par[PAR_K_PSI]), parallel(damper(par[PAR_C_D]), d->rational));
  const struct network Z = stiffness(d->whole, par);

  return (struct network){ without(Z.num, d->common), without(Z.den, d->common) };
}

/* What hangs on the form alone: at values that no two terms of which cancel. */
static void settle_form(struct device_text *d)
{
  double par[MLG_SLOTS] = { [PAR_K_PSI] = 1.1, [PAR_K_D] = 1.3, [PAR_K_S] = 1.7, [PAR_C_D] = 1.9, [PAR_B] = 2.3 };
  const struct network Z = stiffness(d->whole, par);

  for (d->common = 0; Z.num.coefficient[d->common] == 0. && Z.den.coefficient[d->common] == 0.;)
    d->common++;
  d->order = poly_degree(&Z.den) - d->common;
}

int device_read(struct device_text *d, const char *text, char error[], size_t size)
{
  struct reader r = { .d = d, .error = error, .size = size };

  memset(d, 0, sizeof *d);
  error[0] = '\0';
  if (strlen(text) >= sizeof d->text) {
    snprintf(error, size, "longer than %d letters", DEVICE_TEXT - 1);
    return LIBMLG_NONE;
  }
  strcpy(d->text, text);
  r.at = d->text;
  r.seen[K_PSI] = 1;
  d->network = read_group(&r);
  if (d->network && *r.at != '\0')
    wrong(&r, *r.at == ')' ? "no ( belongs to it" : "expected | or -");
  if (d->network && error[0] == '\0' && !r.damper)
    snprintf(error, size, "c_d is not in it, which all questions are about");
  if (error[0] != '\0')
    return LIBMLG_NONE;
  d->whole = add_group(&r, SERIES, add(&r, (struct part){ .kind = SPRING, .text = "k_psi", .slot = PAR_K_PSI }), d->network);
  settle_form(d);
  return 0;
}

/* --- writing -------------------------------------------------------------- */

static int is_k_psi(const struct part *p)
{
  return p->kind == SPRING && strcmp(p->text, "k_psi") == 0;
}

int device_write(const struct part *p, char text[], size_t size)
{
  char part[2][DEVICE_TEXT];

  if (p->kind != PARALLEL && p->kind != SERIES)
    return snprintf(text, size, "%s", p->text);
  for (int i = 0; i < 2; i++) {
    const struct part *const q = i ? p->b : p->a;
    const int inside = q->kind != p->kind && (q->kind == PARALLEL || q->kind == SERIES);
    int n = inside ? sprintf(part[i], "(") : 0;

    n += device_write(q, part[i] + n, sizeof part[i] - (size_t)n);
    if (n > DEVICE_TEXT - 2)
      n = DEVICE_TEXT - 2;
    strcpy(part[i] + n, inside ? ")" : "");
  }
  if (is_k_psi(p->a)) /* what stands behind it, without parentheses */
    return device_write(p->b, text, size);
  return snprintf(text, size, "%s%c%s", part[0], p->kind == SERIES ? '-' : '|', part[1]);
}
