/* shimmy.c - psi- or delta-shimmy: at a point of a run, and mlg shimmy, of a whole branch */
#include <stdlib.h>

#include "mlg.h"
#include "autofile.h"
#include "command.h"
#include "select.h"

/* The gear's inertias, of the first solution of the run.  0, or -1 with a line in why. */
static int find_inertia(const struct run_data *data, struct text *why)
{
  struct inertia *const inertia = data->inertia;
  struct af_solutions all = { 0 };
  int status = -1;

  if (inertia->known)
    return 0;
  if (!data->files.s || af_read_solutions(&all, data->files.s, why) != 0) {
    if (!data->files.s)
      text_add(why, "%s: shimmy needs the file of solutions too, for the gear", data->files.b);
    return -1;
  }
  if (all.n == 0 || all.solution[0].parameters <= PAR_M)
    text_add(why, "%s: has no solution with the gear's parameters", data->files.s);
  else {
    double *par = must_allocate((size_t)all.solution[0].parameters * sizeof *par);

    status = af_solution_parameters(&all, &all.solution[0], par, why);
    if (status == 0)
      *inertia = (struct inertia){ 1, par[PAR_J_XI], par[PAR_M_D], par[PAR_L_D], par[PAR_J_ZETA] };
    free(par);
  }
  af_free_solutions(&all);
  return status;
}

/* A parameter at a point: the run may have changed it. */
static double at_point(const struct run_data *data, int part, long point, const char *name, double value)
{
  const int column = af_column(&data->all.part[part], name);

  return column >= 0 ? af_value(&data->all.part[part], point, column) : value;
}

/* Amplitudes, rad, at a point of orbits.  0, or -1 with a line in why. */
static int amplitudes(const struct run_data *data, int part, long point, double *delta, double *psi, struct text *why)
{
  const struct af_part *p = &data->all.part[part];
  const int of_psi = af_column(p, "psi_max"), dstar = af_column(p, "dstar_max"), l = af_column(p, "l_delta");

  if (of_psi < 0 || dstar < 0 || l < 0) {
    text_add(why, "%s: shimmy needs the columns psi_max, dstar_max and l_delta, or ratio_1", data->files.b);
    return -1;
  }
  *psi = af_value(p, point, of_psi) * MLG_PI / 180.;
  *delta = af_value(p, point, dstar) / af_value(p, point, l);
  return 0;
}

const char *shimmy_at(const struct run_data *data, int part, long point, struct text *why)
{
  const struct inertia *const of_gear = data->inertia;
  const int ratio = af_column(&data->all.part[part], "ratio_1");
  double delta, psi, par[MLG_SLOTS];

  if (ratio >= 0)
    return af_value(&data->all.part[part], point, ratio) > 1. ? "delta" : "psi";
  if (amplitudes(data, part, point, &delta, &psi, why) != 0 || find_inertia(data, why) != 0)
    return NULL;
  par[PAR_J_XI] = at_point(data, part, point, "J_xi", of_gear->J_xi);
  par[PAR_M_D] = at_point(data, part, point, "m_D", of_gear->m_D);
  par[PAR_L_D] = at_point(data, part, point, "l_D", of_gear->l_D);
  par[PAR_J_ZETA] = at_point(data, part, point, "J_zeta", of_gear->J_zeta);
  return mlg_energy_ratio(par, delta / psi) > 1. ? "delta" : "psi";
}

/* Where the branch has its largest amplitude. */
static const char *shimmy_of(const struct run_data *data, struct text *why)
{
  double largest = 0.;
  const char *shimmy = NULL;

  for (int j = 0; j < data->all.parts; j++)
    for (long i = 0; i < data->ending[j].kept; i++) {
      double delta, psi;

      if (amplitudes(data, j, i, &delta, &psi, why) != 0)
        return NULL;
      if (psi * psi + delta * delta > largest) {
        largest = psi * psi + delta * delta;
        shimmy = shimmy_at(data, j, i, why);
        if (!shimmy)
          return NULL;
      }
    }
  if (!shimmy)
    text_add(why, "%s has no orbits", data->files.name);
  return shimmy;
}

static int run(int argc, char *argv[])
{
  struct text why = TEXT_NONE;
  struct run_data data;

  if (argc != 2) {
    fputs("usage: mlg shimmy RUN\n", stderr);
    return MLG_BAD_INPUT;
  }
  if (read_run_or_say("shimmy", argv[1], &data) != 0)
    return MLG_BAD_INPUT;
  const char *const shimmy = shimmy_of(&data, &why);

  if (shimmy)
    puts(shimmy);
  else
    say_line("shimmy", why.at);
  text_free(&why);
  free_run_data(&data);
  return shimmy ? MLG_OK : MLG_FAILED;
}

const struct command command_shimmy = {
  "shimmy", "RUN",
  "psi or delta, what a branch of orbits shows",
  "Which of them has more of the kinetic energy where the branch has its largest amplitude:\n"
  "delta where (J_xi + m_D l_D^2) delta^2 > J_zeta psi^2, of the largest angles over the period.\n"
  "Of the paper's gear the angles differ by a hundred times or more in psi-shimmy, and delta\n"
  "leads by 1.3 or more in the other.\n",
  run,
};
