/* hopfcurve.c - mlg curve: a Hopf curve that AUTO followed, as rows of a table, its extrema
 * checked
 *
 * The extrema of c_d along a curve are known exactly (mlg curves); AUTO puts a point on
 * each.  An extremum that the curve lacks, or has beside these, is an error.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "select.h"

enum { MOST_EXTREMA = 16, MOST_LEFT_OUT = 40 };

struct curve {
  const char *run, *prefix;
  int closed, n, known, found;
  double *V, *c, *known_V, *known_c;
  char *is_extremum;
  double worst; /* largest relative difference of c_d from the known ones */
};

/* "V:c V:c ..." of mlg curves. */
static int read_known(struct curve *k, const char *text)
{
  for (char *end; *text; text = end) {
    double V = strtod(text, &end), c;

    if (end == text || *end != ':')
      return -1;
    text = end + 1;
    c = strtod(text, &end);
    if (end == text || k->known == MOST_EXTREMA)
      return -1;
    k->known_V[k->known] = V;
    k->known_c[k->known++] = c;
    end += strspn(end, " ");
  }
  return 0;
}

/* Which known extremum is at point i, or -1. */
static int match(struct curve *k, int i)
{
  for (int j = 0; j < k->known; j++) {
    const double difference = fabs(k->c[i] / k->known_c[j] - 1.);

    if (difference < 1e-6 && fabs(k->V[i] - k->known_V[j]) < 1e-4) {
      k->worst = fmax(k->worst, difference);
      return j;
    }
  }
  return -1;
}

/* Marks the extrema; those missing or too many into why. */
static void find_extrema(struct curve *k, struct text *why)
{
  char seen[MOST_EXTREMA] = { 0 };

  for (int i = 0; i < k->n; i++) {
    const double before = i > 0 ? k->c[i - 1] : k->closed ? k->c[k->n - 2] : k->c[i];
    const double after = i + 1 < k->n ? k->c[i + 1] : k->closed ? k->c[1] : k->c[i];
    const double noise = 1e-9 * k->c[i]; /* AUTO's own, on a flat stretch */
    int j;

    if (!((k->c[i] - before) * (after - k->c[i]) < 0.) || (k->closed && i + 1 == k->n))
      continue;
    j = match(k, i);
    if (j < 0 && (fabs(k->c[i] - before) < noise || fabs(after - k->c[i]) < noise))
      continue;
    k->is_extremum[i] = 1;
    if (j < 0)
      text_add(why, "%s an extremum too many at (%.6g, %.6g)", why->length ? "," : "", k->V[i], k->c[i]);
    else if (!seen[j]++)
      k->found++;
  }
  for (int j = 0; j < k->known; j++)
    if (!seen[j])
      text_add(why, "%s no extremum at (%.6g, %.6g)", why->length ? "," : "", k->known_V[j], k->known_c[j]);
}

/* In print: V over 100 m/s, c_d over 4e4 N m s/rad or over two decades. */
static double height(const struct curve *k, int i, int logarithmic)
{
  return logarithmic ? log(k->c[i]) / log(100.) : k->c[i] / 4e4;
}

/* How far point i lies from the line between a and b. */
static double off_line(const struct curve *k, int i, int a, int b, int logarithmic)
{
  const double x = (k->V[i] - k->V[a]) / 100., y = height(k, i, logarithmic) - height(k, a, logarithmic);
  const double dx = (k->V[b] - k->V[a]) / 100., dy = height(k, b, logarithmic) - height(k, a, logarithmic);
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0. ? fmax(0., fmin(1., (x * dx + y * dy) / length2)) : 0.;

  return hypot(x - t * dx, y - t * dy);
}

/* Whether all points between a and b may be left out: to the width of a line. */
static int is_straight_line(const struct curve *k, int a, int b)
{
  for (int i = a + 1; i < b; i++)
    if (off_line(k, i, a, b, 0) > 3e-4 || off_line(k, i, a, b, 1) > 3e-4)
      return 0;
  return 1;
}

static void add_row(const struct curve *k, int i, struct text *out)
{
  text_add(out, k->is_extremum[i] ? "%s%s,%.8g,%.8g\n" : "%s%s,%.6g,%.6g\n", k->prefix, k->is_extremum[i] ? "LP" : "", k->V[i],
           k->c[i]);
}

static void thin(const struct curve *k, struct text *out)
{
  add_row(k, 0, out);
  for (int a = 0, i; a < k->n - 1; a = i) {
    for (i = a + 1; i < k->n - 1 && !k->is_extremum[i] && i - a < MOST_LEFT_OUT && is_straight_line(k, a, i + 1); i++)
      ;
    add_row(k, i, out);
  }
}

static int read_curve(struct curve *k)
{
  struct run_data data;
  int n = 0;

  if (read_run_or_say("curve", k->run, &data) != 0)
    return MLG_BAD_INPUT;
  for (int j = 0; j < data.all.parts; j++)
    n += (int)data.ending[j].kept;
  k->V = must_allocate((size_t)(n + 1) * sizeof *k->V);
  k->c = must_allocate((size_t)(n + 1) * sizeof *k->c);
  k->is_extremum = must_allocate((size_t)n + 1);
  memset(k->is_extremum, 0, (size_t)n + 1);
  for (int j = 0; j < data.all.parts; j++)
    for (long i = 0; i < data.ending[j].kept; i++, k->n++) {
      k->V[k->n] = number_at(&data, j, i, "V");
      k->c[k->n] = number_at(&data, j, i, "c_d");
    }
  free_run_data(&data);
  if (k->n < 2 || isnan(k->V[0]) || isnan(k->c[0])) {
    fprintf(stderr, "curve: %s is no curve in V and c_d\n", k->run);
    return MLG_BAD_INPUT;
  }
  if (k->closed) { /* back at the start */
    k->V[k->n] = k->V[0];
    k->c[k->n++] = k->c[0];
  }
  return MLG_OK;
}

static int run(int argc, char *argv[])
{
  double known[2][MOST_EXTREMA];
  struct curve k = { .prefix = "", .known_V = known[0], .known_c = known[1] };
  struct text out = TEXT_NONE, why = TEXT_NONE;
  int status = argc < 2 ? MLG_BAD_INPUT : MLG_OK;

  for (int i = 2; i < argc && status == MLG_OK; i++)
    if (strncmp(argv[i], "prefix=", 7) == 0)
      k.prefix = argv[i] + 7;
    else if (strcmp(argv[i], "closed") == 0)
      k.closed = 1;
    else if (strncmp(argv[i], "extrema=", 8) != 0 || read_known(&k, argv[i] + 8) != 0)
      status = MLG_BAD_INPUT;
  if (status != MLG_OK) {
    fputs("usage: mlg curve RUN [prefix=TEXT] [closed] [extrema=\"V:C_D ...\"]\n", stderr);
    return status;
  }
  k.run = argv[1];
  status = read_curve(&k);
  if (status == MLG_OK) {
    find_extrema(&k, &why);
    thin(&k, &out);
    fputs(out.at, stdout);
    if (why.length > 0) {
      fprintf(stderr, "%s:%s\n", k.run, why.at);
      status = MLG_FAILED;
    }
  }
  free(k.V);
  free(k.c);
  free(k.is_extremum);
  text_free(&out);
  text_free(&why);
  return status;
}

const struct command command_curve = {
  "curve", "RUN [prefix=TEXT] [closed] [extrema=\"V:C_D ...\"]",
  "a Hopf curve of a run as rows, its extrema of c_d checked",
  "Prints prefix, type (LP: an extremum of c_d along the curve), V (m/s), c_d (N m s/rad);\n"
  "points on a straight line between others, to the width of a line in print, are left out.\n"
  "closed: the curve ends on its first point.  extrema: where it must have them, from\n"
  "`mlg curves`.  Status 1 and one line: it lacks one of them, or has one beside these.\n",
  run,
};
