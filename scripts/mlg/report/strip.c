/* strip.c - mlg strip: the gear at instants of a period as polylines, for a picture
 *
 * The gear is the one of models/mlg.h, without rake; a tyre is 0.16 m wide.  Points are in
 * metres, x to the right, y forward (top) or up from the ground (rear).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cell.h"
#include "command.h"
#include "csv.h"
#include "libmlg.h"

static const double tyre = 0.16, ahead = 0.4; /* m: its width, what is drawn of the line before it */

static const char *const columns[] = { "solution", "phase", "psi", "dstar", "lambda_L", "lambda_R" };

enum { SOLUTION, PHASE, PSI, DSTAR, LAMBDA_LEFT, LAMBDA_RIGHT, COLUMNS };

struct strip {
  const char *solution, *view, *part;
  double every, apart, only, turns, bends, shifts;
  double a, e, R, l_delta, h, l; /* of the gear */
  /* at one instant: */
  double x0, psi, dstar, lambda[2];
  double px, py, cos_a, sin_a; /* where something stands, turned clockwise */
};

static void point(const struct strip *s, double across, double along)
{
  printf("%.4f %.4f\n", s->x0 + across, along);
}

static void turned(const struct strip *s, double u, double v)
{
  point(s, s->px + u * s->cos_a + v * s->sin_a, s->py - u * s->sin_a + v * s->cos_a);
}

static void line(const struct strip *s, double u, double v, double to_u, double to_v)
{
  turned(s, u, v);
  turned(s, to_u, to_v);
  putchar('\n');
}

/* A rectangle, from its lower left corner. */
static void box(const struct strip *s, double u, double v, double width, double height)
{
  turned(s, u, v);
  turned(s, u + width, v);
  turned(s, u + width, v + height);
  turned(s, u, v + height);
  turned(s, u, v);
  putchar('\n');
}

static void top(struct strip *s)
{
  s->cos_a = cos(s->psi);
  s->sin_a = sin(s->psi);
  s->px = -s->dstar; /* C */
  s->py = 0.;
  for (int i = 0; i < 2; i++) {
    const double side = (i - 0.5) * s->a;

    if (strcmp(s->part, "wheels") == 0)
      box(s, side - tyre / 2., -s->e - s->R, tyre, 2. * s->R);
    else if (strcmp(s->part, "contact") == 0) {
      for (int k = 0; k <= 10; k++)
        turned(s, side + s->lambda[i] * exp(-k / 10. * ahead / s->l), -s->e + s->h + k / 10. * ahead);
      putchar('\n');
    }
  }
  if (strcmp(s->part, "strut") == 0) {
    line(s, -s->a / 2., -s->e, s->a / 2., -s->e);
    line(s, 0., -s->e, 0., 0.);
  }
}

static void rear(struct strip *s)
{
  s->px = 0.; /* B; delta turns C to the left */
  s->py = s->R + s->l_delta;
  s->cos_a = cos(s->dstar / s->l_delta);
  s->sin_a = sin(s->dstar / s->l_delta);
  for (int i = 0; i < 2; i++) {
    const double side = (i - 0.5) * s->a, left = side - tyre / 2., right = side + tyre / 2.;
    const double foot = -s->l_delta * s->sin_a + side * s->cos_a + s->lambda[i];

    if (strcmp(s->part, "contact") == 0) {
      point(s, foot - tyre / 2., 0.);
      point(s, foot + tyre / 2., 0.);
      putchar('\n');
    } else if (strcmp(s->part, "wheels") == 0) {
      turned(s, left, -s->l_delta);
      turned(s, left, -s->l_delta + s->R);
      turned(s, right, -s->l_delta + s->R);
      turned(s, right, -s->l_delta);
      point(s, foot + tyre / 2., 0.);
      point(s, foot - tyre / 2., 0.);
      turned(s, left, -s->l_delta);
      putchar('\n');
    }
  }
  if (strcmp(s->part, "strut") == 0) {
    line(s, -s->a / 2., -s->l_delta, s->a / 2., -s->l_delta);
    line(s, 0., -s->l_delta, 0., 0.);
  }
}

static double of_gear(const char *name)
{
  return libmlg_default(libmlg_parameter(name));
}

static int draw(struct strip *s, const struct csv *t, struct text *why)
{
  const double degree = acos(-1.) / 180.;
  int column[COLUMNS], n = 0;

  for (int i = 0; i < COLUMNS; i++)
    if ((column[i] = csv_column(t, columns[i])) < 0) {
      text_add(why, "%s has no column %s", t->file, columns[i]);
      return -1;
    }
  s->a = of_gear("a");
  s->e = of_gear("e");
  s->R = of_gear("R");
  s->l_delta = of_gear("l_delta");
  s->h = of_gear("h");
  s->l = of_gear("l");
  for (int row = 0; row < t->rows; row++) {
    int k;

    if (strcmp(csv_cell(t, row, column[SOLUTION]), s->solution) != 0)
      continue;
    k = n++;
    if (s->only >= 0. ? k != s->only : fmod(k, s->every) != 0. || csv_number(t, row, column[PHASE]) >= 1.)
      continue;
    s->x0 = s->only >= 0. ? 0. : k / s->every * s->apart;
    s->psi = s->turns * csv_number(t, row, column[PSI]) * degree;
    s->dstar = s->bends * csv_number(t, row, column[DSTAR]);
    s->lambda[0] = s->shifts * csv_number(t, row, column[LAMBDA_LEFT]);
    s->lambda[1] = s->shifts * csv_number(t, row, column[LAMBDA_RIGHT]);
    if (strcmp(s->view, "top") == 0)
      top(s);
    else
      rear(s);
  }
  return 0;
}

static int read_word(struct strip *s, const char *word, struct text *why)
{
  struct { const char *name; double *number, least; const char **text; } const words[] = {
    { "solution=", NULL, 0., &s->solution }, { "view=", NULL, 0., &s->view }, { "part=", NULL, 0., &s->part },
    { "every=", &s->every, 1., NULL }, { "apart=", &s->apart, 0., NULL }, { "only=", &s->only, 0., NULL },
    { "turns=", &s->turns, 0., NULL }, { "bends=", &s->bends, 0., NULL }, { "shifts=", &s->shifts, 0., NULL },
  };

  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    const size_t n = strlen(words[i].name);

    if (strncmp(word, words[i].name, n) != 0)
      continue;
    if (words[i].text) {
      *words[i].text = word + n;
      return 0;
    }
    if (csv_is_number(word + n, words[i].number) && *words[i].number >= words[i].least)
      return 0;
    text_add(why, "'%s': expected a number from %g on", word, words[i].least);
    return -1;
  }
  text_add(why, "'%s': expected solution=, view=, part=, every=, apart=, only=, turns=, bends= or shifts=", word);
  return -1;
}

static int is_one_of(const char *word, const char *list)
{
  const char *t = strstr(list, word);

  return *word && t && (t == list || t[-1] == ' ') && strchr(" ", t[strlen(word)]);
}

static int run(int argc, char *argv[])
{
  struct strip s = { .solution = "A", .view = "top", .part = "wheels", .every = 12., .apart = 1., .only = -1.,
                     .turns = 1., .bends = 1., .shifts = 1. };
  struct text why = TEXT_NONE, file = TEXT_NONE;
  struct csv t = { .file = NULL };
  int status = 0;

  if (argc < 2) {
    fputs("usage: mlg strip TABLE [solution=A] [view=top|rear] [part=wheels|strut|contact] [NAME=NUMBER ...]\n", stderr);
    return MLG_BAD_INPUT;
  }
  for (int i = 2; i < argc && status == 0; i++)
    status = read_word(&s, argv[i], &why);
  if (status == 0 && (!is_one_of(s.view, "top rear") || !is_one_of(s.part, "wheels strut contact"))) {
    text_add(&why, "view=%s part=%s: expected top or rear; wheels, strut or contact", s.view, s.part);
    status = -1;
  }
  if (status == 0) {
    add_table_file(&file, argv[1]);
    status = csv_read(file.at, &t, &why);
    if (status == 0)
      status = draw(&s, &t, &why);
    csv_free(&t);
  }
  if (status != 0)
    say_line("strip", why.at);
  text_free(&why);
  text_free(&file);
  return status == 0 ? MLG_OK : MLG_BAD_INPUT;
}

const struct command command_strip = {
  "strip", "TABLE [solution=A] [view=top|rear] [part=wheels|strut|contact] [NAME=NUMBER ...]",
  "the gear at instants of a period as polylines, for a picture",
  "TABLE: filmstrip, or another with its columns.  every=12 apart=1: one gear every 12 instants, a\n"
  "metre to the right of the last; or only=K: instant K.  turns=, bends=, shifts= multiply psi,\n"
  "delta* and lambda.  Prints \"x y\" in metres, an empty line behind a polyline.  contact: the middle\n"
  "lines of the tyres before their leading contact points (top), where they stand on the ground\n"
  "(rear).\n",
  run,
};
