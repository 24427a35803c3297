/* points.c - mlg points: the special points of runs, rows of results/special_points.csv */
#include <math.h>
#include <string.h>

#include "mlg.h"
#include "branch.h"
#include "command.h"
#include "select.h"

/* A number, "inf" for a rigid k_s, or nothing where there is none. */
static void add_number(struct text *row, double x, int digits)
{
  if (isnan(x))
    text_add(row, ",");
  else if (x >= 1e29)
    text_add(row, ",inf");
  else
    text_add(row, ",%.*g", digits, x);
}

/* A point the user asked for, and not one that flanks a TR. */
static int is_asked(const struct run_data *data, int part, long point)
{
  const double torus = number_at(data, part, point, "torus");

  return is_orbits(&data->all.part[part]) && torus * torus > 1e-6;
}

/* Points on equilibria are exact to the digits shown; those of orbits carry the digits
 * that doubling the mesh leaves unchanged (docs/runs.md). */
static void add_point(struct text *out, const struct run_data *data, int part, long point, const char *prefix)
{
  const struct af_part *p = &data->all.part[part];
  const char *type = point_type(&data->all, p, point);
  const int digits = p->constants.IPS == 2 || strcmp(af_type_name(p->point[point].type), "ZH") == 0 ? 6 : 8;

  text_add(out, "%s,%s,%s", prefix, data->files.name, type);
  add_number(out, number_at(data, part, point, "V"), digits);
  add_number(out, number_at(data, part, point, "c_d"), digits);
  add_number(out, number_at(data, part, point, "k_s"), 8);
  add_number(out, number_at(data, part, point, "b"), 8);
  text_add(out, ",%.5f", number_at(data, part, point, "frequency"));
  add_number(out, number_at(data, part, point, "psi_max"), 6);
  add_number(out, number_at(data, part, point, "dstar_max"), 6);
  text_add(out, "\n");
}

/* The same of a boundary point (models/boundary.h). */
static void add_boundary_point(struct text *out, const struct run_data *data, int part, long point, const char *prefix)
{
  text_add(out, "%s,%s,%s,%.8g,%.8g,%.8g,%.8g,%.5f,,\n", prefix, data->files.name, point_type(&data->all, &data->all.part[part], point),
         number_at(data, part, point, "V_1"), number_at(data, part, point, "c_1"), number_at(data, part, point, "k_s"),
         number_at(data, part, point, "b"), number_at(data, part, point, "f_1"));
}

static void add_points(struct text *out, const struct run_data *data, const char *prefix, const struct choice *asked)
{
  for (int j = 0; j < data->all.parts; j++) {
    const int boundary = af_column(&data->all.part[j], "V_1") >= 0;

    for (long i = 0; i < data->ending[j].kept; i++) {
      const char *type = point_type(&data->all, &data->all.part[j], i);
      const int uz = strcmp(type, "UZ") == 0;

      if (boundary && (strcmp(type, "LP") == 0 || (uz && asked->conditions > 0 && is_chosen(asked, data, j, i))))
        add_boundary_point(out, data, j, i, prefix);
      else if (!boundary && (lists(",HB,HH,ZH,TR,LP,BP,GH,", type)
                             || (uz && (asked->conditions > 0 ? is_chosen(asked, data, j, i) : is_asked(data, j, i)))))
        add_point(out, data, j, i, prefix);
    }
  }
}

static int run_points(int argc, char *argv[])
{
  struct choice asked = { .types = ",any," };
  struct text why = TEXT_NONE, out = TEXT_NONE;
  const char *prefix = "";
  int status = MLG_OK, runs = 0;

  for (int i = 1; i < argc && status == MLG_OK; i++) {
    if (strncmp(argv[i], "prefix=", 7) == 0)
      prefix = argv[i] + 7;
    else if (strncmp(argv[i], "uz=", 3) == 0)
      status = read_condition(&asked, argv[i] + 3, &why) == 0 ? MLG_OK : MLG_BAD_INPUT;
    else
      runs++;
  }
  if (status == MLG_OK && runs == 0) {
    text_add(&why, "usage: mlg points RUN... [prefix=TEXT] [uz=NAME=VALUE]");
    status = MLG_BAD_INPUT;
  }
  for (int i = 1; i < argc && status == MLG_OK; i++) {
    struct run_data data;

    if (strncmp(argv[i], "prefix=", 7) == 0 || strncmp(argv[i], "uz=", 3) == 0)
      continue;
    status = read_run_or_say("points", argv[i], &data);
    if (status == 0)
      add_points(&out, &data, prefix, &asked);
    free_run_data(&data);
  }
  if (why.length > 0)
    say_line("points", why.at);
  else if (status == MLG_OK && out.length > 0)
    fputs(out.at, stdout);
  text_free(&out);
  text_free(&why);
  return status;
}

const struct command command_points = {
  "points", "RUN... [prefix=TEXT] [uz=NAME=VALUE]",
  "the special points of runs",
  "Prints prefix, run, type, V (m/s), c_d (N m s/rad), k_s (N m/rad, inf: rigid), b\n"
  "(N m s^2/rad), frequency (Hz), psi_max (deg), dstar_max (m): 8 digits for points of straight\n"
  "rolling, 6 for orbits and double Hopf points.  Of UZ, on a branch of orbits those that do\n"
  "not flank a torus point, of boundary points none; with uz=NAME=VALUE those alone.\n",
  run_points,
};
