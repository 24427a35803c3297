/* axes.c - the values of a sweep's axes, and the cases that they make; see description.h */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "description.h"
#include "text.h"

#define MOST_CASES 1e15

int find_axis(const struct sweep *s, const char *name, size_t length)
{
  for (int i = 0; i < s->axes; i++)
    if (strlen(s->axis[i].name) == length && memcmp(s->axis[i].name, name, length) == 0)
      return i;
  return -1;
}

bool varies(const struct sweep *s, int axis)
{
  return s->count[s->axis[axis].dimension] > 1;
}

/* The range of what mlg takes beside the parameters of models/mlg.h (arguments.h). */
static const struct { const char *name, *unit; double least, most; } others[] = {
  { "compliance", "1e-5 rad/(N m)", 0., 1e5 }, { "F_z", "N", 1e-3, 1e9 }, { "V_top", "m/s", 1e-3, 1e3 }
};

enum { OTHERS = sizeof others / sizeof *others };

static bool range_of(const char *name, const char **unit, double *least, double *most)
{
  const int n = libmlg_parameter(name);

  for (int i = 0; i < OTHERS; i++)
    if (strcmp(others[i].name, name) == 0) {
      *unit = others[i].unit;
      *least = others[i].least;
      *most = others[i].most;
      return true;
    }
  if (n == LIBMLG_NONE)
    return false;
  *unit = libmlg_parameter_quantity(n)->unit;
  *least = libmlg_least(n);
  *most = libmlg_most(n);
  return true;
}

bool is_parameter(const char *name)
{
  const char *unit;
  double least, most;

  return range_of(name, &unit, &least, &most);
}

const char *parameter_unit(const char *name)
{
  const char *unit;
  double least, most;

  return range_of(name, &unit, &least, &most) && *unit && strcmp(unit, "-") != 0 ? unit : NULL;
}

/* Whether a number stands before something else, such as a unit. */
static bool begins_with_number(const char *text)
{
  char *end;

  strtod(text, &end);
  return end > text && *end;
}

void check_value(const struct sweep *s, const char *name, const char *value, int line)
{
  const char *unit;
  double least, most, x;

  const bool ranged = range_of(name, &unit, &least, &most);

  if (!*value && s->place)
    slip(s, line, value, "the cell is empty; expected a value of %s in each row", name);
  if (ranged && begins_with_number(value))
    slip(s, line, value, "expected a number by itself, %s in %s", name, unit);
  if (!*value || strpbrk(value, " \t\"{}"))
    slip(s, line, value, "expected a value of %s without blanks, quotes and braces", name);
  if (strlen(value) >= VALUE_SIZE)
    slip(s, line, value, "longer than %d characters", VALUE_SIZE - 1);
  if (strcmp(name, "layout") == 0 && libmlg_layout(value) == LIBMLG_NONE)
    slip(s, line, value, "no such layout; `mlg help` lists them");
  if (!ranged || (strcmp(name, "k_s") == 0 && strcmp(value, "inf") == 0))
    return;
  if (!is_number(value, &x))
    slip(s, line, value, "expected a number, %s in %s", name, unit);
  if (!(x >= least && x <= most))
    slip(s, line, value, "%s outside its range, %g to %g %s", name, least, most, unit);
}

static void check_ends(const struct sweep *s, const struct axis *a)
{
  char text[VALUE_SIZE];

  for (int end = 0; end < 2; end++) {
    snprintf(text, sizeof text, "%.10g", end ? a->to : a->from);
    check_value(s, a->name, text, a->line);
  }
}

struct axis *new_axis(struct sweep *s, const char *name, const char *given, int line)
{
  const int other = find_axis(s, name, strlen(name));

  if (other >= 0)
    slip(s, line, name, "given twice, also in line %d, %s", s->axis[other].line, s->axis[other].given);
  for (const char *const *own = (const char *const[]){ "case", "parameters", "at", "command", "status", "reason", NULL }; *own; own++)
    if (strcmp(name, *own) == 0)
      slip(s, line, name, "a name of its own: of a {word}, or of a column of failed.csv");
  if (s->axes == MOST_AXES)
    slip(s, line, name, "there are %d names already", MOST_AXES);
  struct axis *a = &s->axis[s->axes++];

  *a = (struct axis){ .name = strdup(name), .given = strdup(given), .line = line };
  return a;
}

int new_dimension(struct sweep *s, long long count)
{
  s->count[s->dimensions] = count;
  return s->dimensions++;
}

static void steps_of(struct sweep *s, struct axis *a, double n)
{
  if (!(a->from < a->to))
    slip(s, a->line, a->given, "the first value has to be below the second");
  if (!(n >= 2. && n <= 1e12 && n == floor(n)))
    slip(s, a->line, a->given, "expected a whole number of values, 2 or more");
  if (a->ratios && !(a->from > 0.))
    slip(s, a->line, a->given, "equal ratios (log) need values above 0");
  a->kind = AXIS_STEPS;
  a->dimension = new_dimension(s, (long long)n);
}

static void sample_of(struct sweep *s, struct axis *a)
{
  if (!(a->from < a->to))
    slip(s, a->line, a->given, "the first value has to be below the second");
  if (a->ratios && !(a->from > 0.))
    slip(s, a->line, a->given, "equal ratios (log) need values above 0");
  a->kind = AXIS_SAMPLE;
  a->coordinate = s->coordinates++;
  if (s->sample_dimension < 0)
    s->sample_dimension = new_dimension(s, 0);
  a->dimension = s->sample_dimension;
}

static void list_of(struct sweep *s, struct axis *a, const char *values)
{
  long n = 0;

  a->kind = AXIS_LIST;
  for (const char *at = values;; at++) {
    const size_t length = strcspn(at, ",");
    char *value = strndup(at, length), *from = value;

    while (isspace((unsigned char)*from))
      from++;
    for (size_t k = strlen(from); k > 0 && isspace((unsigned char)from[k - 1]); k--)
      from[k - 1] = '\0';
    check_value(s, a->name, from, a->line);
    for (long i = 0; i < n; i++)
      if (strcmp(a->text[i], from) == 0)
        slip(s, a->line, from, "stands twice in the list of %s", a->name);
    a->text = must_resize(a->text, (size_t)(n + 1) * sizeof *a->text);
    a->text[n++] = strdup(from);
    free(value);
    at += length;
    if (!*at)
      break;
  }
  a->dimension = new_dimension(s, n);
}

/* The n numbers of a form such as "%lf : %lf : %lf", and "log" behind them. */
static bool reads(const char *text, int n, const char *form, double x[3], bool *ratios)
{
  char whole_form[80];
  int end = 0;

  snprintf(whole_form, sizeof whole_form, "%s %%n", form);
  const int found = n == 3 ? sscanf(text, whole_form, &x[0], &x[1], &x[2], &end)
                           : sscanf(text, whole_form, &x[0], &x[1], &end);

  *ratios = end > 0 && strcmp(text + end, "log") == 0;
  return found == n && end > 0 && (*ratios || text[end] == '\0');
}

void add_axis(struct sweep *s, const char *name, const char *values, int line)
{
  struct axis *a = new_axis(s, name, values, line);
  double x[3] = { 0., 0., 0. };
  bool ratios = false;

  if (reads(values, 3, "%lf : %lf : %lf", x, &ratios)) {
    a->from = x[0], a->to = x[1], a->ratios = ratios;
    steps_of(s, a, x[2]);
  } else if (reads(values, 3, "%lf : %lf by %lf", x, &ratios) && !ratios && x[2] > 0.) {
    const double n = floor((x[1] - x[0]) / x[2] + 1e-9);

    a->from = x[0], a->to = x[0] + n * x[2];
    steps_of(s, a, n + 1.);
  } else if (reads(values, 2, "%lf ~ %lf", x, &ratios)) {
    a->from = x[0], a->to = x[1], a->ratios = ratios;
    sample_of(s, a);
  } else if (reads(values, 2, "%lf +- %lf %%", x, &ratios) && !ratios) {
    a->from = x[0] - 0.01 * fabs(x[0]) * x[1], a->to = x[0] + 0.01 * fabs(x[0]) * x[1];
    sample_of(s, a);
  } else if (strpbrk(values, ":~%") || strstr(values, "+-")) {
    slip(s, line, values, "expected FROM : TO : N [log], FROM : TO by STEP, FROM ~ TO [log], X +- P %%, or a list A, B, ...");
  } else {
    list_of(s, a, values);
    return;
  }
  check_ends(s, a);
}

/* The points of the sample: coordinate k of point i is i/g^(k+1) mod 1, shifted by a half,
 * where g > 1 solves g^(d+1) = g + 1 for d coordinates.  That polynomial is irreducible
 * (Selmer 1956), so 1, 1/g, ..., 1/g^d are a basis of a number field and badly approximable
 * by rationals: every beginning of the sequence is spread evenly (M. Roberts 2018, R_d).
 * In whole numbers, 2^64 for 1, so that it is the same everywhere. */
static void settle_sample(struct sweep *s)
{
  long double g = 2.L, step = 18446744073709551616.L;

  for (int n = 0; n < 64; n++)
    g = powl(1.L + g, 1.L / (s->coordinates + 1));
  for (int k = 0; k < s->coordinates; k++)
    s->stride[k] = (uint64_t)(step /= g);
  s->count[s->sample_dimension] = s->sample;
}

static double sampled(const struct sweep *s, int k, long long i)
{
  return (double)(((uint64_t)i * s->stride[k] + (UINT64_C(1) << 63)) >> 11) * 0x1p-53;
}

void settle_axes(struct sweep *s)
{
  double cases = 1.;

  if (s->sample && !s->coordinates)
    slip(s, s->sample_line, "sample", "sample = N wants a NAME = FROM ~ TO or X +- P %%");
  for (int i = 0; i < s->axes && !s->sample; i++)
    if (s->axis[i].kind == AXIS_SAMPLE)
      slip(s, s->axis[i].line, s->axis[i].given, "FROM ~ TO and X +- P %% want a line sample = N, the number of points");
  if (s->sample)
    settle_sample(s);
  s->cases = 1;
  for (int d = 0; d < s->dimensions; d++) {
    cases *= (double)s->count[d];
    if (cases > MOST_CASES)
      slip(s, 0, NULL, "more than %g cases", MOST_CASES);
    s->cases *= s->count[d];
  }
}

static double between(const struct axis *a, double t)
{
  return a->ratios ? a->from * pow(a->to / a->from, t) : a->from + t * (a->to - a->from);
}

const char *axis_value(const struct sweep *s, int axis, long long n, char buffer[VALUE_SIZE])
{
  const struct axis *a = &s->axis[axis];
  long long i = n - 1;

  for (int d = s->dimensions - 1; d > a->dimension; d--)
    i /= s->count[d];
  i %= s->count[a->dimension];
  if (a->kind == AXIS_LIST)
    return a->text[i];
  const double t = a->kind == AXIS_SAMPLE ? sampled(s, a->coordinate, i)
                                          : (double)i / (double)(s->count[a->dimension] - 1);

  snprintf(buffer, VALUE_SIZE, "%.10g", t == 1. ? a->to : between(a, t));
  return buffer;
}
