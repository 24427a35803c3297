/* evaluate.c - the commands of one case of a sweep; see evaluate.h
 *
 * glibc lets stdout be any stream: a command that may be called again writes into memory.
 */
#define _GNU_SOURCE
#include "evaluate.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "child.h"
#include "unitline.h"

static void bound(int resource, rlim_t most)
{
  struct rlimit room;

  if (getrlimit(resource, &room) == 0 && (room.rlim_cur == RLIM_INFINITY || room.rlim_cur > most)) {
    room.rlim_cur = most;
    setrlimit(resource, &room);
  }
}

bool begin_evaluator(struct evaluator *e, const struct sweep *sweep, const char *scratch, int complaints, pid_t parent,
                     atomic_int *step)
{
  const int nothing = open("/dev/null", O_RDONLY);
  char seconds[32];

  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent || dup2(nothing, 0) < 0 || dup2(complaints, 2) < 0)
    return false;
  *e = (struct evaluator){ .sweep = sweep, .scratch = scratch, .complaints = complaints, .step = step };
  text_clear(&e->answer.text);
  text_clear(&e->why);
  for (int i = 0; i < sweep->steps; i++)
    e->makes_runs = e->makes_runs || !sweep->step[i].again || sweep->step[i].into;
  bound(RLIMIT_CORE, 0);
  if (sweep->memory_limit)
    bound(RLIMIT_AS, (rlim_t)sweep->memory_limit << 20);
  if (sweep->time_limit > 0. && !getenv("MLG_TIME_LIMIT")) {
    snprintf(seconds, sizeof seconds, "%.0f", ceil(sweep->time_limit));
    setenv("MLG_TIME_LIMIT", seconds, 1);
  }
  e->output = open_memstream(&e->printed, &e->room);
  return e->output != NULL;
}

void first_complaint(int complaints, struct text *text)
{
  char line[1000];
  const ssize_t n = pread(complaints, line, sizeof line - 1, 0);

  text_clear(text);
  line[n > 0 ? n : 0] = '\0';
  const size_t whole = strcspn(line, "\n");

  line[whole] = '\0';
  if (n == sizeof line - 1 && whole == (size_t)n && strrchr(line, ' ')) /* cut between words */
    strcpy(strrchr(line, ' ') < line + n - 4 ? strrchr(line, ' ') : line + n - 4, " ...");
  for (char *t = line; *t; t++)
    *t = *t == ',' ? ';' : iscntrl((unsigned char)*t) || *t == '"' ? ' ' : *t;
  text_add(text, "%s", *line ? line : "no reason was given");
}

static void forget_complaints(int complaints)
{
  if (lseek(complaints, 0, SEEK_CUR) > 0 && ftruncate(complaints, 0) == 0)
    lseek(complaints, 0, SEEK_SET);
}

/* The command in this process; it may end it. */
static int call(struct evaluator *e, const struct step *step, int argc)
{
  FILE *const own = stdout;
  int status;

  stdout = e->output;
  status = step->command->run(argc, e->words.argv);
  stdout = own;
  return status;
}

/* The command in a process of its own, its output into e->output. */
static int call_apart(struct evaluator *e, const struct step *step, int argc)
{
  const int output = memfd_create("output", MFD_CLOEXEC);
  const pid_t self = getpid(), child = output < 0 ? -1 : fork();
  char buffer[4096];
  ssize_t n;
  int status = 0;

  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != self || dup2(output, 1) < 0)
      _exit(1);
    status = step->command->run(argc, e->words.argv);
    fflush(stdout);
    _exit(status);
  }
  if (child < 0) {
    dprintf(2, "mlg cases: %s\n", strerror(errno));
    return MLG_FAILED;
  }
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  for (off_t at = 0; (n = pread(output, buffer, sizeof buffer, at)) > 0; at += n)
    fwrite(buffer, 1, (size_t)n, e->output);
  close(output);
  if (WIFSIGNALED(status))
    dprintf(2, "killed by signal %d (%s)\n", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/* What a command printed, as a file beside the runs of the case, where run's dat= finds it. */
static int put_into(struct evaluator *e, const char *name, size_t length)
{
  const char *const folder = getenv("MLG_RUNS");
  struct text path = TEXT_NONE;
  FILE *file;
  int status = MLG_FAILED;

  for (const char *t = folder; t && *t; t += strcspn(t, "/"), t += strspn(t, "/")) { /* each folder above it */
    text_clear(&path);
    text_append(&path, folder, (size_t)(t - folder) + strcspn(t, "/"));
    mkdir(path.at, 0777);
  }
  text_add(&path, "/%s", name);
  if ((file = fopen(path.at, "w")) != NULL) {
    status = fwrite(e->printed, 1, length, file) == length ? MLG_OK : MLG_FAILED;
    status = fclose(file) == 0 ? status : MLG_FAILED;
  }
  if (status != MLG_OK)
    dprintf(2, "%s: %s\n", path.at, strerror(errno));
  text_free(&path);
  return status;
}

bool units_known(struct evaluator *e)
{
  text_clear(&e->units);
  for (int i = 0; i < e->sweep->steps; i++) {
    if (e->sweep->step[i].asks && !e->has_units[i])
      return false;
    if (e->unit[i].length > 0)
      text_add(&e->units, "%s%s", e->units.length > 0 ? "; " : "", e->unit[i].at);
  }
  return true;
}

/* Returns the status of the first command that fails. */
static int take_steps(struct evaluator *e, long long n)
{
  for (int i = 0; i < e->sweep->steps; i++) {
    const struct step *step = &e->sweep->step[i];
    const int argc = fill_words(e->sweep, step, n, &e->words);
    int status;

    atomic_store(e->step, i + 1);
    fseeko(e->output, 0, SEEK_SET);
    status = step->again ? call(e, step, argc) : call_apart(e, step, argc);
    if (status == 0 && fflush(e->output) == 0 && step->into)
      status = put_into(e, step->into, (size_t)ftello(e->output));
    if (status != 0) {
      first_complaint(e->complaints, &e->why);
      return status;
    }
    const off_t length = ftello(e->output);

    e->printed[length] = '\0';
    if (step->asks && !e->has_units[i])
      e->has_units[i] = read_unit_line(step, e->printed, &e->unit[i]);
    if (step->asks && take_answer(e->sweep, step, e->printed, &e->answer, &e->why) != 0)
      return MLG_BAD_INPUT;
  }
  return MLG_OK;
}

void evaluate(struct evaluator *e, long long n, struct record *record)
{
  char folder[4096];

  forget_complaints(e->complaints);
  if (e->makes_runs) {
    snprintf(folder, sizeof folder, e->sweep->keeps_files ? "%s/%lld" : "%s", e->scratch, n);
    remove_folder(folder);
    setenv("MLG_RUNS", folder, 1);
  }
  text_clear(&e->answer.text);
  text_clear(&e->why);
  e->answer.rows = 0;
  const int status = take_steps(e, n);

  if (status == 0) {
    complete_answer(e->sweep, &e->answer);
    *record = (struct record){ .n = n, .rows = e->answer.rows, .text = e->answer.text.at, .length = e->answer.text.length };
  } else
    *record = (struct record){ .n = n, .failed = true, .step = atomic_load(e->step), .status = status, .text = e->why.at,
                               .length = e->why.length };
  if (e->makes_runs && !e->sweep->keeps_files)
    remove_folder(folder);
}
