/* run.c - mlg run: one AUTO run, made when it is not up to date, and judged
 *
 * A run lives in build/runs/NAME with AUTO's files c.NAME, b.NAME, s.NAME and d.NAME, as
 * AUTO's own @sv would leave them.  It is made in NAME.part and moved when it is good;
 * one that was rejected stays there for a look.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "libmlg.h"
#include "child.h"
#include "command.h"
#include "constants.h"
#include "judge.h"
#include "making.h"

/* One line on standard error; the status for bad input. */
__attribute__((format(printf, 1, 2))) static int refuse(const char *format, ...)
{
  char line[1024];
  va_list args;

  va_start(args, format);
  vsnprintf(line, sizeof line, format, args);
  va_end(args);
  say_line(NULL, line);
  return MLG_BAD_INPUT;
}

static int is_file(const char *file)
{
  struct stat about;

  return stat(file, &about) == 0 && S_ISREG(about.st_mode);
}

static void free_request(struct request *r)
{
  free(r->word);
  free(r->file);
  free(r->layout);
  free(r->program);
  free(r->exe);
  free(r->folder);
  free(r->part);
  free(r->start);
  text_free(&r->text);
}

/* Takes the words apart. */
static int read_words(struct request *r, int argc, char *argv[])
{
  struct text why = TEXT_NONE;
  int i;

  if (argc < 3 || strcmp(argv[1], "--") == 0 || strcmp(argv[2], "--") == 0)
    return refuse("usage: mlg run NAME CONSTANTS [from=RUN] [model=MODEL] [gear=FILE] [KEY=VALUE ...] [-- TYPE=COUNT ...]");
  r->name = argv[1];
  r->constants = argv[2];
  r->word = must_allocate((size_t)argc * sizeof *r->word);
  for (i = 3; i < argc && strcmp(argv[i], "--") != 0; i++) {
    const char **one = strncmp(argv[i], "from=", 5) == 0 ? &r->from : strncmp(argv[i], "model=", 6) == 0 ? &r->model : NULL;

    if (one && *one)
      return refuse("%s: '%s': %s is given twice", r->name, argv[i], one == &r->from ? "from" : "model");
    if (one)
      *one = strchr(argv[i], '=') + 1;
    else if (strncmp(argv[i], "s=", 2) == 0 || strncmp(argv[i], "sv=", 3) == 0)
      return refuse("%s: '%s': a run saves under its own name; from=RUN says where it starts", r->name, argv[i]);
    else
      r->word[r->words++] = argv[i];
  }
  r->expected = argv + i + (i < argc);
  r->n_expected = argc - i - (i < argc);
  if (!is_name(r->name))
    return refuse("run: NAME '%s': %s", r->name, NAME_RULE);
  if (strlen(r->name) > 5 && strcmp(r->name + strlen(r->name) - 5, ".part") == 0)
    return refuse("run: NAME '%s': .part at its end is for runs that are being made", r->name);
  if (r->from && !is_name(r->from))
    return refuse("run: from='%s': %s", r->from, NAME_RULE);
  if (r->model && !is_name(r->model))
    return refuse("run: model='%s': %s", r->model, NAME_RULE);
  if (check_expectations(r->expected, r->n_expected, &why) != 0) {
    say_line(r->name, why.at);
    text_free(&why);
    return MLG_BAD_INPUT;
  }
  if (time_limit() < 0)
    return refuse("run: MLG_TIME_LIMIT='%s': expected a whole number of seconds from 1 to 1000000", getenv("MLG_TIME_LIMIT"));
  if (size_limit() < 0)
    return refuse("run: MLG_SIZE_LIMIT='%s': expected a whole number of MB from 1 to 1000000", getenv("MLG_SIZE_LIMIT"));
  return MLG_OK;
}

/* Finds the files. */
static int find_files(struct request *r)
{
  const char *base;

  if (strchr(r->constants, '/'))
    r->file = joined(r->constants, "", "", "");
  else {
    r->file = joined(checkout(), "constants/c.", r->constants, "");
    if (!is_file(r->file)) { /* made for this layout? */
      char *made = joined(checkout(), "build/constants/c.", r->constants, "");

      if (is_file(made)) {
        free(r->file);
        r->file = made;
      } else
        free(made);
    }
  }
  if (!is_file(r->file))
    return refuse("%s: no constants file %s", r->name, r->file);
  base = strrchr(r->file, '/') ? strrchr(r->file, '/') + 1 : r->file;
  base += strncmp(base, "c.", 2) == 0 ? 2 : 0;
  r->program = joined(r->model ? r->model : base, "", "", "");
  if (!r->model)
    r->program[strcspn(r->program, ".")] = '\0';
  r->layout = joined(r->program, "", "", "");
  r->layout[strcspn(r->layout, ".")] = '\0';
  r->exe = joined(checkout(), "build/models/", r->program, ".exe");
  if (access(r->exe, X_OK) != 0)
    return refuse(libmlg_layout(r->layout) == LIBMLG_NONE ? "%s: %s is for the layout '%s', but there is no models/%s.c"
                                                          : "%s: %s is for the layout '%s', but there is no build/models/%s.exe (make models)",
                  r->name, r->file, r->layout, libmlg_layout(r->layout) == LIBMLG_NONE ? r->layout : r->program);
  r->folder = joined(runs_folder(), "/", r->name, "");
  r->part = joined(r->folder, ".part", "", "");
  if (r->from) {
    char *folder = joined(runs_folder(), "/", r->from, "");

    r->start = joined(folder, "/s.", r->from, "");
    free(folder);
  }
  return MLG_OK;
}

/* The run that this one starts from is there, of the same layout and problem. */
static int check_start(const struct request *r)
{
  struct text origin = TEXT_NONE, why = TEXT_NONE;
  int status = MLG_OK;

  if (!r->from)
    return MLG_OK;
  if (!is_file(r->start))
    return refuse("%s: starts from %s, which has not been made", r->name, r->from);
  char *file = joined(runs_folder(), "/", r->from, "/origin");
  if (read_file(file, &origin, &why) == 0) {
    char layout[128] = "", program[128] = "";

    for (char *t = strtok(origin.at, "\n"); t; t = strtok(NULL, "\n")) {
      sscanf(t, "layout=%127s", layout);
      sscanf(t, "model=%127s", program);
    }
    if (*layout && strcmp(layout, r->layout) != 0)
      status = refuse("%s: starts from %s, a run of the layout %s; this one is of %s", r->name, r->from, layout, r->layout);
    else if (*program && strcmp(program, r->program) != 0)
      status = refuse("%s: starts from %s, a run of the model %s; this one is of %s", r->name, r->from, program, r->program);
  }
  free(file);
  text_free(&origin);
  text_free(&why);
  return status;
}

/* An orbit to start from, dat=FILE, which stays where it is: AUTO sees a link in its folder. */
static int take_orbit(struct request *r)
{
  char *dat = strstr(r->text.at, "\ndat = "), *end, *file;
  struct text text = TEXT_NONE;

  if (!dat)
    return MLG_OK;
  dat += strlen("\ndat = ");
  end = dat + strcspn(dat, "\n");
  file = must_allocate((size_t)(end - dat) + 1);
  memcpy(file, dat, (size_t)(end - dat));
  file[end - dat] = '\0';
  if (*file == '\'' || *file == '"') {
    memmove(file, file + 1, strlen(file));
    file[strcspn(file, "'\"")] = '\0';
  }
  if (r->from) {
    free(file);
    return refuse("%s: both from=%s and dat: a run starts from one of them", r->name, r->from);
  }
  r->start = realpath(file, NULL);
  if (!r->start && !strchr(file, '/')) { /* or among the runs */
    char *among = joined(runs_folder(), "/", file, "");

    r->start = realpath(among, NULL);
    free(among);
  }
  if (!r->start || !is_file(r->start)) {
    refuse("%s: no orbit to start from, dat = '%s' (mlg cycle LAYOUT orbit makes one)", r->name, file);
    free(file);
    return MLG_BAD_INPUT;
  }
  r->orbit = 1;
  text_append(&text, r->text.at, (size_t)(dat - r->text.at));
  text_add(&text, "'start.dat'%s", end);
  text_free(&r->text);
  r->text = text;
  free(file);
  return MLG_OK;
}

/* The constants as AUTO gets them. */
static int make_constants(struct request *r)
{
  const struct constants_use use = { r->layout, strcmp(r->program, r->layout) != 0, r->from != NULL };
  struct text why = TEXT_NONE;
  const char *irs;
  int status = hand_over(r->file, r->word, r->words, &use, &r->text, &why);

  if (status != 0) {
    say_line(NULL, why.at);
    text_free(&why);
    return status;
  }
  text_free(&why);
  irs = strncmp(r->text.at, "IRS = ", 6) == 0 ? r->text.at : strstr(r->text.at, "\nIRS = ");
  if (r->from && (!irs || strchr("0", *(strchr(irs, '=') + 2)) || strncmp(strchr(irs, '=') + 2, "'0'", 3) == 0))
    return refuse("%s: from=%s starts anew because IRS = 0 in %s; say which solution, as IRS=\"'HB1'\"", r->name, r->from, r->file);
  if (r->from)
    text_add(&r->text, "s = '%s'\n", r->from);
  if (take_orbit(r) != MLG_OK)
    return MLG_BAD_INPUT;
  text_add(&r->text, "sv = '%s'\n", r->name); /* AUTO writes b.NAME, s.NAME and d.NAME itself */
  return MLG_OK;
}

/* Makes the folder of the runs and those above it. */
static int make_runs_folder(const struct request *r)
{
  char *path = joined(runs_folder(), "", "", "");
  int status = MLG_OK;

  for (char *t = path + 1; status == MLG_OK; t++) {
    const char here = *t;

    if (here != '/' && here != '\0')
      continue;
    *t = '\0';
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
      fprintf(stderr, "%s: %s: %s\n", r->name, path, strerror(errno));
      status = MLG_FAILED;
    }
    *t = here;
    if (here == '\0')
      break;
  }
  free(path);
  return status;
}

/* One at a time makes or looks at a run of that name. */
static int with_lock(struct request *r)
{
  char *file = joined(r->folder, ".lock", "", "");
  int lock = open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0666), status;

  if (lock < 0 && errno == ENOENT && make_runs_folder(r) == MLG_OK)
    lock = open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) {
    fprintf(stderr, "%s: %s: %s\n", r->name, file, strerror(errno));
    free(file);
    return MLG_FAILED;
  }
  free(file);
  while (flock(lock, LOCK_EX) != 0 && errno == EINTR)
    ;
  clock_gettime(CLOCK_MONOTONIC, &r->began);
  status = check_start(r);
  if (status == MLG_OK)
    status = make_if_needed(r);
  close(lock);
  return status;
}

static int run(int argc, char *argv[])
{
  struct request r = { 0 };
  int status = read_words(&r, argc, argv);

  if (status == MLG_OK)
    status = find_files(&r);
  if (status == MLG_OK)
    status = check_start(&r);
  if (status == MLG_OK)
    status = make_constants(&r);
  if (status == MLG_OK)
    status = with_lock(&r);
  free_request(&r);
  return status;
}

const struct command command_run = {
  "run", "NAME CONSTANTS [from=RUN] [model=MODEL] [gear=FILE] [KEY=VALUE ...] [-- TYPE=COUNT ...]",
  "one AUTO run, made when it is not up to date, and judged",
  "NAME: the run lives in build/runs/NAME with AUTO's files c.NAME, b.NAME, s.NAME, d.NAME.\n"
  "CONSTANTS: l1.straight is constants/c.l1.straight or build/constants/c.l1.straight;\n"
  "anything with a / is a path.  The first part of its name after c. is the layout.\n"
  "from=RUN starts from that run's solutions, IRS says from which; dat=FILE from an orbit\n"
  "(mlg cycle LAYOUT orbit), also one that lies beside the runs; model=MODEL runs\n"
  "build/models/MODEL.exe; gear=FILE and KEY=VALUE as for mlg constants.\n"
  "TYPE=COUNT: the run fails unless it has so many points of that type (mlg judge).\n"
  "Prints a line with the time taken and the points found when it made the run, nothing\n"
  "when it is up to date.  It is made anew when its constants, its model, its start, what\n"
  "is expected or AUTO's files changed.  A rejected run stays as NAME.part.\n"
  "MLG_RUNS: another folder than build/runs.  MLG_TIME_LIMIT, MLG_SIZE_LIMIT: seconds of\n"
  "processor time AUTO may take, 600, and MB it may write in one file, 256.\n"
  "Status 1: the run failed, and why; 2: bad input.\n",
  run,
};
