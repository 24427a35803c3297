/* spread.c - reads files of spreads, and draws from them */
#include "spread.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "designs.h"

enum { MOST_TRIES = 100000 };

struct line { const char *file; int number; };

static _Noreturn void slip(const struct line *at, const char *format, ...)
{
  va_list values;

  va_start(values, format);
  refuse_file(at->file, at->number, format, values);
}

static int is_per_cent(const char *word)
{
  return word[strlen(word) - 1] == '%';
}

/* A number, or one with % of the design's value: `around` is added to it, or 0. */
static double number(const struct line *at, const char *word, double value, double around)
{
  char text[64];
  const size_t length = strlen(word);
  double x;

  if (length == 0 || length >= sizeof text)
    slip(at, "'%.40s' is no number", word);
  memcpy(text, word, length + 1);
  if (text[length - 1] == '%')
    text[length - 1] = '\0';
  if (!is_number(text, &x))
    slip(at, "'%.40s' is no finite number, nor one with %%", word);
  if (!is_per_cent(word))
    return x;
  if (!(value < MLG_RIGID) || value == 0.)
    slip(at, "'%.40s': per cent of a value that is %s", word, value == 0. ? "0" : "infinite");
  return around + x / 100. * fabs(value);
}

static double least_of(int parameter)
{
  return parameter == LIBMLG_F_Z ? 1e-3 : libmlg_least(parameter);
}

static double most_of(int parameter)
{
  return parameter == LIBMLG_F_Z ? 1e9 : libmlg_most(parameter);
}

/* M of this load, F_z/g - m_D, is in its range. */
static bool is_load(const double par[], double F_z)
{
  const double M = F_z / par[NUMBER_G] - par[NUMBER_M_D];

  return M >= libmlg_least(NUMBER_M) && M <= libmlg_most(NUMBER_M);
}

static void check_value(const struct line *at, const struct arguments *a, int parameter, double x)
{
  const char *const name = quantity_name(parameter), *const unit = quantity_unit(parameter);

  if (!(x >= least_of(parameter) && x <= most_of(parameter)))
    slip(at, "%s = %g %s is outside its range, %g to %g", name, x, unit, least_of(parameter), most_of(parameter));
  if (parameter == LIBMLG_F_Z && !is_load(a->par, x))
    slip(at, "F_z = %g N makes M = F_z/g - m_D = %g kg, outside its range, %g to %g kg", x,
         x / a->par[NUMBER_G] - a->par[NUMBER_M_D], libmlg_least(NUMBER_M), libmlg_most(NUMBER_M));
}

static struct spread read_line(const struct line *at, const struct arguments *a, char *text)
{
  char name[64], kind[64], first[64], second[64], rest[2];
  struct spread s = { .parameter = LIBMLG_F_Z };

  if (sscanf(text, "%63s %63s %63s %63s %1s", name, kind, first, second, rest) != 4)
    slip(at, "expected NAME uniform FROM TO, or NAME normal MEAN DEVIATION");
  if (strcmp(name, "F_z") != 0)
    s.parameter = libmlg_parameter(name);
  if (s.parameter == LIBMLG_NONE)
    slip(at, "'%s' is not a parameter (docs/model.md has them)", name);
  if (s.parameter == NUMBER_V)
    slip(at, "V is the axis of the answer");
  if (s.parameter != LIBMLG_F_Z && !libmlg_uses(a->layout, s.parameter))
    slip(at, "layout %s has no %s", libmlg_layout_name(a->layout), name);
  if (s.parameter >= NUMBER_G_PSI && s.parameter <= NUMBER_K_D3)
    slip(at, "%s: play, friction and the other laws of joints have no part in straight rolling; spread the gear's parameters", name);
  s.normal = strcmp(kind, "normal") == 0;
  if (!s.normal && strcmp(kind, "uniform") != 0)
    slip(at, "'%s': expected uniform or normal", kind);
  if (is_per_cent(first) != is_per_cent(second))
    slip(at, "%s %s %s %s: expected both in per cent of the design's value, or both in SI units", name, kind, first, second);
  const double value = libmlg_value(a->par, s.parameter);

  s.a = number(at, first, value, value);
  s.b = number(at, second, value, s.normal ? 0. : value);
  if (s.normal ? !(s.b > 0.) : !(s.a < s.b))
    slip(at, "%s %s %s %s: %s", name, kind, first, second, s.normal ? "expected a deviation above 0" : "expected FROM below TO");
  check_value(at, a, s.parameter, s.a);
  if (!s.normal)
    check_value(at, a, s.parameter, s.b);
  else if (s.b > most_of(s.parameter) - least_of(s.parameter))
    slip(at, "%s normal %s %s: its deviation is larger than its range, %g to %g %s", name, first, second, least_of(s.parameter),
         most_of(s.parameter), quantity_unit(s.parameter));
  return s;
}

int read_spreads(const char *file, const struct arguments *a, struct spread spread[MOST_SPREADS])
{
  struct line at = { file, 0 };
  FILE *f = fopen(file, "r");
  char text[512];
  int n = 0;

  if (!f)
    slip(&at, "%s; expected a file of spreads", strerror(errno));
  while (fgets(text, sizeof text, f)) {
    at.number++;
    if (!strchr(text, '\n') && !feof(f))
      slip(&at, "longer than %zu characters, or holds a zero byte", sizeof text - 2);
    text[strcspn(text, "#\n")] = '\0';
    if (text[strspn(text, " \t\r")] == '\0')
      continue;
    const struct spread s = read_line(&at, a, text);

    for (int i = 0; i < n; i++) {
      if (spread[i].parameter == s.parameter)
        slip(&at, "%s is given twice", quantity_name(s.parameter));
      if ((spread[i].parameter == LIBMLG_F_Z && s.parameter == NUMBER_M) || (spread[i].parameter == NUMBER_M && s.parameter == LIBMLG_F_Z))
        slip(&at, "F_z and M are one parameter; give one of them");
    }
    spread[n++] = s;
  }
  at.number = 0;
  if (ferror(f))
    slip(&at, "%s; expected a file of spreads", strerror(errno));
  fclose(f);
  if (n == 0)
    slip(&at, "holds no spread; expected NAME uniform FROM TO, or NAME normal MEAN DEVIATION");
  return n;
}

/* Vigna's xorshift64*: 0 to 1, never 0. */
static double uniform(struct random *r)
{
  r->state ^= r->state >> 12;
  r->state ^= r->state << 25;
  r->state ^= r->state >> 27;
  return ((double)((r->state * 2685821657736338717u) >> 11) + 0.5) / 9007199254740992.;
}

static double one_of(struct random *r, const struct spread *s)
{
  const double u = uniform(r), v = uniform(r);

  if (s->normal)
    return s->a + s->b * sqrt(-2. * log(u)) * cos(2. * MLG_PI * v);
  return s->a + (s->b - s->a) * u;
}

/* F_z last: it hangs on m_D and g. */
void draw_spreads(struct random *r, const struct spread spread[], int n, double par[])
{
  for (int load = 0; load < 2; load++)
    for (int i = 0; i < n; i++) {
      const int parameter = spread[i].parameter;
      int tries = 0;
      double x;

      if ((parameter == LIBMLG_F_Z) != load)
        continue;
      do {
        if (tries++ == MOST_TRIES)
          fail("probability", MLG_BAD_INPUT, "%s: none of %d draws was in its range; expected a narrower spread%s",
               quantity_name(parameter), MOST_TRIES, load ? ", of m_D and g, too" : "");
        x = one_of(r, &spread[i]);
      } while (!(x >= least_of(parameter) && x <= most_of(parameter)) || (load && !is_load(par, x)));
      libmlg_set(par, parameter, x);
    }
}
