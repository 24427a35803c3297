/* widths.c - mlg widths: runs of c.boundary.width or c.boundary.rival as rows of widths.csv */
#include <math.h>
#include <string.h>

#include "branch.h"
#include "command.h"
#include "select.h"

/* A column of the boundary point i, "ratio_2". */
static double of_point(const struct run_data *data, long at, const char *what, int i)
{
  char name[32];

  snprintf(name, sizeof name, "%s_%d", what, i);
  return number_at(data, 0, at, name);
}

/* By the parameter closing: what ends the growth of the width over k_s. */
static const char *limit_of(double closing)
{
  static const char *const limits[] = { "onset of the delta region", "BP2_u reaches the lower bound", "none: the width is stationary",
                                        "another region reaches the upper bound" };

  return closing >= 0. && closing < 4. ? limits[(int)closing] : "";
}

static void add_row(struct text *out, const struct run_data *data, long at, const char *prefix, const char *b)
{
  int n = 1;

  while (af_column(&data->all.part[0], n == 1 ? "V_2" : n == 2 ? "V_3" : n == 3 ? "V_4" : "") >= 0)
    n++;
  text_add(out, "%s%s%s,%.10g,%.10g,%.10g,%.8g,%.6g,%.6g,%s,%s,%s\n", prefix, *prefix ? "," : "", b, number_at(data, 0, at, "k_s"),
           of_point(data, at, "c", n - 1), of_point(data, at, "c", n), number_at(data, 0, at, "width"), of_point(data, at, "V", n - 1),
           of_point(data, at, "V", n), paper_name(data, 0, at, n - 1), paper_name(data, 0, at, n), limit_of(number_at(data, 0, at, "closing")));
}

/* The points that AUTO labels: multiples of 10 of b, and where another limit takes over.
 * After the largest b the stationary width is a minimum; those rows are left out. */
static void add_rows(struct text *out, const struct run_data *data, const char *prefix)
{
  double b_was = NAN, way = 0.;

  for (long i = 0; i < data->all.part[0].points; i++) {
    const char *type = point_type(&data->all, &data->all.part[0], i);
    const double b = number_at(data, 0, i, "b"), tens = trunc(b / 10. + 0.5) * 10.;
    const int whole = (b - tens) * (b - tens) < 1e-12;
    char text[32];

    if ((b - b_was) * way < 0.)
      return;
    way = i > 0 ? b - b_was : 0.;
    b_was = b;
    snprintf(text, sizeof text, whole ? "%.0f" : "%.8g", whole ? tens : b);
    if (strcmp(type, "UZ") == 0 || (strcmp(type, "EP") == 0 && whole))
      add_row(out, data, i, prefix, text);
  }
}

static int run(int argc, char *argv[])
{
  struct text out = TEXT_NONE;
  const char *prefix = "";
  int status = MLG_OK, runs = 0;

  for (int i = 1; i < argc; i++) {
    if (strncmp(argv[i], "prefix=", 7) == 0)
      prefix = argv[i] + 7;
    else
      runs++;
  }
  if (runs == 0) {
    fputs("usage: mlg widths RUN... [prefix=TEXT]\n", stderr);
    return MLG_BAD_INPUT;
  }
  for (int i = 1; i < argc && status == MLG_OK; i++) {
    struct run_data data;

    if (strncmp(argv[i], "prefix=", 7) == 0)
      continue;
    status = read_run_or_say("widths", argv[i], &data);
    if (status == 0 && (data.all.parts != 1 || af_column(&data.all.part[0], "width") < 0 || af_column(&data.all.part[0], "V_2") < 0
                        || af_column(&data.all.part[0], "closing") < 0)) {
      fprintf(stderr, "widths: %s is no run of c.boundary.width or c.boundary.rival\n", argv[i]);
      status = MLG_BAD_INPUT;
    } else if (status == 0)
      add_rows(&out, &data, prefix);
    free_run_data(&data);
  }
  if (status == MLG_OK && out.length > 0)
    fputs(out.at, stdout);
  text_free(&out);
  return status;
}

const struct command command_widths = {
  "widths", "RUN... [prefix=TEXT]",
  "the widest interval over k_s, from runs in b",
  "Prints prefix, b (N m s^2/rad), k_s (N m/rad), c_lo, c_hi, width (N m s/rad), V_lo, V_hi\n"
  "(m/s), the bounds' names and what limits the growth: at multiples of 10 of b and where\n"
  "another limit takes over, up to where b turns back.\n",
  run,
};
