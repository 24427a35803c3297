/* child.c - AUTO as a process of its own, with bounds; see child.h */
#define _GNU_SOURCE
#include "child.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Of a variable that gives a whole number up to a million, or -1. */
static long limit_of(const char *name, long otherwise)
{
  const char *given = getenv(name);
  long value = otherwise;

  return !given || !*given || whole_number(given, 1, 1000000, &value) ? value : -1;
}

long time_limit(void)
{
  return limit_of("MLG_TIME_LIMIT", 600);
}

long size_limit(void)
{
  return limit_of("MLG_SIZE_LIMIT", 256);
}

/* No more than that of a resource; what is less already stays. */
static void bound(int resource, rlim_t most)
{
  struct rlimit room;

  if (getrlimit(resource, &room) == 0 && (room.rlim_cur == RLIM_INFINITY || room.rlim_cur > most)) {
    room.rlim_cur = most;
    setrlimit(resource, &room);
  }
}

static int remove_one(const char *path, const struct stat *about, int kind, struct FTW *where)
{
  (void)about, (void)kind, (void)where;
  return remove(path);
}

int remove_folder(const char *folder)
{
  return nftw(folder, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

/* What the new process does; it does not come back. */
static _Noreturn void become_model(const char *model, const char *folder, const sigset_t *signals, pid_t parent)
{
  int log;

  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(127);
  bound(RLIMIT_FSIZE, (rlim_t)size_limit() << 20);
  bound(RLIMIT_CPU, (rlim_t)time_limit());
  sigprocmask(SIG_SETMASK, signals, NULL);
  if (chdir(folder) != 0 || (log = open("auto.log", O_WRONLY | O_CREAT | O_TRUNC, 0666)) < 0 || dup2(log, 1) < 0
      || dup2(log, 2) < 0)
    _exit(127);
  setenv("OMP_NUM_THREADS", "1", 1); /* two threads gain little, and lose much on a busy machine */
  setenv("LC_ALL", "C", 1);
  execl(model, model, (char *)NULL);
  dprintf(2, "%s: %s\n", model, strerror(errno));
  _exit(127);
}

/* Seconds from now on that clock. */
static double seconds_to(const struct timespec *end)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)(end->tv_sec - now.tv_sec) + 1e-9 * (double)(end->tv_nsec - now.tv_nsec);
}

int run_model(const char *model, const char *folder, struct text *why)
{
  const long limit = time_limit();
  const pid_t self = getpid();
  char *whole = realpath(model, NULL); /* seen from the folder */
  sigset_t wanted, before;
  struct timespec end;
  int status = 0, ended = 0;
  pid_t child;

  sigemptyset(&wanted);
  sigaddset(&wanted, SIGCHLD);
  sigaddset(&wanted, SIGINT);
  sigaddset(&wanted, SIGTERM);
  sigaddset(&wanted, SIGHUP);
  sigprocmask(SIG_BLOCK, &wanted, &before);
  clock_gettime(CLOCK_MONOTONIC, &end);
  end.tv_sec += 20 * limit; /* on a machine that hardly comes to it */
  child = whole ? fork() : -1;
  if (child == 0)
    become_model(whole, folder, &before, self);
  free(whole);
  if (child < 0) {
    text_add(why, "cannot start %s: %s", model, strerror(errno));
    sigprocmask(SIG_SETMASK, &before, NULL);
    return 127;
  }
  while (!ended) {
    const double left = seconds_to(&end);
    const struct timespec wait = { left > 0. ? (time_t)left : 0, left > 0. ? (long)(1e9 * (left - (double)(time_t)left)) : 0 };
    int signal;

    if (waitpid(child, &status, WNOHANG) == child)
      break;
    signal = sigtimedwait(&wanted, NULL, &wait);
    if (signal == SIGCHLD || (signal < 0 && errno == EINTR))
      continue;
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    if (signal > 0) { /* this program shall end */
      remove_folder(folder);
      sigprocmask(SIG_SETMASK, &before, NULL);
      raise(signal);
      _exit(128 + signal); /* where it is ignored */
    }
    text_add(why, "AUTO had not ended after %ld s (MLG_TIME_LIMIT)", limit);
    ended = 1;
  }
  sigprocmask(SIG_SETMASK, &before, NULL);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ)
    text_add(why, "a file of AUTO's grew to %ld MB (MLG_SIZE_LIMIT)", size_limit());
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    text_add(why, "AUTO had not ended after %ld s (MLG_TIME_LIMIT)", limit);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
