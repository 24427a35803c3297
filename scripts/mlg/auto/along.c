/* along.c - columns of runs between AUTO's points: mlg at, mlg crossing, mlg peak */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "select.h"

/* Two columns of a run as arrays, up to n points; free both. */
struct graph { double *x, *y; long n; };

static void free_graph(struct graph *g)
{
  free(g->x);
  free(g->y);
  *g = (struct graph){ 0 };
}

/* 0, or 2 after one line on standard error. */
static int read_graph(const char *command, const char *run, const char *x, const char *y, struct graph *g)
{
  struct run_data data;
  const struct af_part *part;
  int status = read_run_or_say(command, run, &data);

  *g = (struct graph){ 0 };
  if (status == 0 && data.all.parts != 1) {
    fprintf(stderr, "%s: %s holds %d branches; one is wanted\n", command, run, data.all.parts);
    status = 2;
  }
  part = data.all.part;
  for (int k = 0; k < 2 && status == 0; k++)
    if (af_column(part, k ? y : x) < 0) {
      fprintf(stderr, "%s: %s has no column '%s'\n", command, run, k ? y : x);
      status = 2;
    }
  if (status == 0) {
    g->n = data.ending[0].kept;
    g->x = must_allocate((size_t)g->n * sizeof *g->x);
    g->y = must_allocate((size_t)g->n * sizeof *g->y);
    for (long i = 0; i < g->n; i++) {
      g->x[i] = af_value(part, i, af_column(part, x));
      g->y[i] = af_value(part, i, af_column(part, y));
    }
  }
  free_run_data(&data);
  return status;
}

/* --- mlg at ------------------------------------------------------------------------ */

/* The rows of one run where a column passes a value, linear between points. */
static int add_rows_at(const struct run_data *data, const char *name, double at, const struct columns *columns, struct text *out,
                       struct text *why)
{
  for (int j = 0; j < data->all.parts; j++) {
    const struct af_part *part = &data->all.part[j];
    const int x = af_column(part, name);

    if (x < 0) {
      text_add(why, "%s has no column '%s'", data->files.b, name);
      return -1;
    }
    for (int k = 0; k < columns->n; k++)
      if (strcmp(columns->column[k].name, "run") != 0 && !has_column(part, columns->column[k].name)) {
        text_add(why, "%s has no column '%s'", data->files.b, columns->column[k].name);
        return -1;
      }
    for (long i = 1; i < data->ending[j].kept; i++) {
      const double a = af_value(part, i - 1, x), b = af_value(part, i, x);

      /* a point that is met belongs to one step only */
      if (!((a - at) * (b - at) <= 0.) || a == b || (b == at && i + 1 < data->ending[j].kept))
        continue;
      for (int k = 0; k < columns->n; k++) {
        const struct column *c = &columns->column[k];

        if (k > 0)
          text_add(out, ",");
        if (strcmp(c->name, "run") == 0)
          text_add(out, "%s", data->files.name);
        else {
          const double from = number_at(data, j, i - 1, c->name), to = number_at(data, j, i, c->name);

          text_add(out, c->format, from + (at - a) / (b - a) * (to - from));
        }
      }
      text_add(out, "\n");
    }
  }
  return 0;
}

static int run_at(int argc, char *argv[])
{
  struct text why = TEXT_NONE, out = TEXT_NONE;
  struct columns columns = { NULL, 0 };
  const char *value = NULL;
  char name[32] = "";
  double at = 0.;
  int status = MLG_OK;

  for (int i = 1; i < argc && status == MLG_OK; i++) {
    const char *equals = strchr(argv[i], '=');

    if (strncmp(argv[i], "columns=", 8) == 0)
      status = read_columns(argv[i] + 8, &columns, &why) == 0 ? MLG_OK : MLG_BAD_INPUT;
    else if (equals && !strchr(argv[i], '/')) {
      if (value || equals == argv[i] || equals - argv[i] >= (int)sizeof name || !af_number(equals + 1, strlen(equals + 1), &at)) {
        text_add(&why, "'%s': expected one NAME=VALUE", argv[i]);
        status = MLG_BAD_INPUT;
      } else {
        value = equals + 1;
        memcpy(name, argv[i], (size_t)(equals - argv[i]));
      }
    }
  }
  if (status == MLG_OK && (!value || columns.n == 0)) {
    text_add(&why, "usage: mlg at RUN... NAME=VALUE columns=NAME[:FORMAT],...");
    status = MLG_BAD_INPUT;
  }
  for (int i = 1; i < argc && status == MLG_OK; i++) {
    struct run_data data;

    if (strchr(argv[i], '=') && !strchr(argv[i], '/'))
      continue;
    status = read_run_or_say("at", argv[i], &data);
    if (status == 0 && add_rows_at(&data, name, at, &columns, &out, &why) != 0)
      status = MLG_BAD_INPUT;
    free_run_data(&data);
  }
  if (status == MLG_OK && out.length > 0)
    fputs(out.at, stdout);
  if (why.length > 0)
    say_line("at", why.at);
  free_columns(&columns);
  text_free(&out);
  text_free(&why);
  return status;
}

const struct command command_at = {
  "at", "RUN... NAME=VALUE columns=NAME[:FORMAT],...",
  "columns of runs where one of them has a value",
  "A row each time a run passes the value, linear between AUTO's points; run is a column too.\n",
  run_at,
};

/* --- mlg crossing, mlg peak ----------------------------------------------------------- */

/* x=NAME y=NAME of the last two words. */
static int read_axes(int argc, char *argv[], int runs, const char **x, const char **y)
{
  if (argc != runs + 3 || strncmp(argv[runs + 1], "x=", 2) != 0 || strncmp(argv[runs + 2], "y=", 2) != 0) {
    fprintf(stderr, "usage: mlg %s RUN%s x=NAME y=NAME\n", argv[0], runs > 1 ? " RUN" : "");
    return MLG_BAD_INPUT;
  }
  *x = argv[runs + 1] + 2;
  *y = argv[runs + 2] + 2;
  return MLG_OK;
}

/* y of a graph whose x rises, at x; NaN outside. */
static double height(const struct graph *g, double x)
{
  long i = 0;

  if (g->n < 2 || !(x >= g->x[0] && x <= g->x[g->n - 1]))
    return NAN;
  while (i < g->n - 2 && g->x[i + 1] < x)
    i++;
  return g->y[i] + (g->y[i + 1] - g->y[i]) * (x - g->x[i]) / (g->x[i + 1] - g->x[i]);
}

static int run_crossing(int argc, char *argv[])
{
  struct graph first = { 0 }, second = { 0 };
  const char *x, *y;
  double gap_was = NAN, x_was = NAN;
  int status = read_axes(argc, argv, 2, &x, &y);

  if (status == MLG_OK)
    status = read_graph("crossing", argv[1], x, y, &first);
  if (status == MLG_OK)
    status = read_graph("crossing", argv[2], x, y, &second);
  for (long i = 1; i < first.n; i++)
    if (first.x[i] < first.x[i - 1]) /* what follows has turned back */
      first.n = i;
  for (long i = 0; i < second.n && status == MLG_OK; i++) {
    const double gap = second.y[i] - height(&first, second.x[i]);

    if (isnan(gap))
      continue;
    if (gap > 0. && gap_was <= 0.) {
      printf("%.3f\n", x_was + (second.x[i] - x_was) * gap_was / (gap_was - gap));
      break;
    }
    gap_was = gap;
    x_was = second.x[i];
    if (i == second.n - 1) {
      fprintf(stderr, "crossing: %s does not pass %s\n", argv[2], argv[1]);
      status = MLG_FAILED;
    }
  }
  free_graph(&first);
  free_graph(&second);
  return status;
}

const struct command command_crossing = {
  "crossing", "RUN RUN x=NAME y=NAME",
  "from which x on the second of two runs has the larger y",
  "To 0.001, linear between AUTO's points, on the first run up to where x turns back.\n"
  "Status 1: they do not cross.\n",
  run_crossing,
};

static int run_peak(int argc, char *argv[])
{
  struct graph g = { 0 };
  const char *x, *y;
  long k = 0;
  int status = read_axes(argc, argv, 1, &x, &y);

  if (status == MLG_OK)
    status = read_graph("peak", argv[1], x, y, &g);
  for (long i = 1; i < g.n; i++)
    if (g.y[i] > g.y[k])
      k = i;
  if (status == MLG_OK && (k == 0 || k == g.n - 1)) {
    fprintf(stderr, "peak: %s of %s is largest at an end\n", y, argv[1]);
    status = MLG_FAILED;
  } else if (status == MLG_OK) {
    const double left = (g.y[k] - g.y[k - 1]) / (g.x[k] - g.x[k - 1]), right = (g.y[k + 1] - g.y[k]) / (g.x[k + 1] - g.x[k]);

    printf("%.3f\n", (g.x[k - 1] + g.x[k] - left * (g.x[k + 1] - g.x[k - 1]) / (right - left)) / 2.);
  }
  free_graph(&g);
  return status;
}

const struct command command_peak = {
  "peak", "RUN x=NAME y=NAME",
  "the x at which a run has its largest y",
  "To 0.001, by a parabola through AUTO's points.  Status 1: it is largest at an end.\n",
  run_peak,
};
