/* worker.c - the cases of a sweep computed in a process of their own; see worker.h
 *
 * Two processes: the worker computes and puts records into a ring of shared memory, the
 * other takes them out into the file, watches the time and outlives whatever ends the
 * worker.  So a record costs neither a process nor a call of the system.
 */
#define _GNU_SOURCE
#include "worker.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "evaluate.h"
#include "record.h"

enum { RING = 1 << 22 };

struct shared {
  atomic_size_t head, tail;     /* bytes put in, taken out */
  atomic_long done;             /* cases whose record is in the ring */
  atomic_llong started;         /* ns: when the one behind them began; 0: none has */
  atomic_bool units;            /* have still to be told */
  atomic_int step;              /* which of its commands is at work, from 1 */
  char ring[RING];
};

static long long now_ns(void)
{
  struct timespec t;

  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1000000000LL * t.tv_sec + t.tv_nsec;
}

static void nap(double s)
{
  const struct timespec t = { (time_t)s, (long)(1e9 * (s - (double)(time_t)s)) };

  nanosleep(&t, NULL);
}

static void put_in(struct shared *shared, const char *bytes, size_t n)
{
  const size_t head = atomic_load(&shared->head), at = head % RING, first = n < RING - at ? n : RING - at;

  while (RING - (head - atomic_load(&shared->tail)) < n)
    nap(0.001);
  memcpy(shared->ring + at, bytes, first);
  memcpy(shared->ring, bytes + first, n - first);
  atomic_store(&shared->head, head + n);
}

static int take_out(struct shared *shared, struct sink sink)
{
  const size_t head = atomic_load(&shared->head);
  size_t tail = atomic_load(&shared->tail);

  while (tail < head) {
    const size_t at = tail % RING, n = head - tail < RING - at ? head - tail : RING - at;

    if (sink.take(sink.its, shared->ring + at, n) != 0)
      return -1;
    tail += n;
  }
  atomic_store(&shared->tail, tail);
  return 0;
}

/* The file system that runs of AUTO are made on, or where tables go, has no room left. */
static bool is_full(const char *folder)
{
  struct statvfs about;

  while (statvfs(folder, &about) != 0) {
    const char *slash = strrchr(folder, '/');
    static char above[4096];

    if (!slash || (size_t)(slash - folder) >= sizeof above)
      return false;
    memmove(above, folder, (size_t)(slash - folder));
    above[slash - folder] = '\0';
    folder = above;
  }
  return (double)about.f_bavail * (double)about.f_frsize < 4e6;
}

/* A command, or AUTO below it, that was killed: if that was the end of everything, this process too is killed
 * within a second, and the case has not failed. */
static void wait_for_end(int status, const char *reason)
{
  if (status >= 128 || (reason && (strstr(reason, "signal") || strstr(reason, "status 137") || strstr(reason, "status 143"))))
    nap(1.);
}

struct job {
  const struct sweep *sweep;
  const long long *cases;
  long n;
  const char *scratch;
  int complaints; /* a file of no name for what commands say on standard error */
  struct shared *shared;
  struct sink sink;
};

enum { DISK_FULL = 77 };

/* What the worker does. */
static _Noreturn void work(struct job *j, long from, pid_t parent, const sigset_t *signals)
{
  struct evaluator e;
  struct text text = TEXT_NONE;

  sigprocmask(SIG_SETMASK, signals, NULL);
  if (!begin_evaluator(&e, j->sweep, j->scratch, j->complaints, parent, &j->shared->step))
    _exit(1);
  for (long i = from; i < j->n; i++) {
    struct record record;

    atomic_store(&j->shared->started, now_ns());
    evaluate(&e, j->cases[i], &record);
    if (record.failed && is_full(j->scratch))
      _exit(DISK_FULL);
    if (record.failed)
      wait_for_end(record.status, record.text);
    text_clear(&text);
    if (!record.failed && atomic_load(&j->shared->units) && units_known(&e))
      add_record(&text, &(struct record){ .units = true, .text = e.units.at, .length = e.units.length });
    const size_t told = text.length;

    add_record(&text, &record);
    if (text.length > RING) {
      record = (struct record){ .n = record.n, .failed = true, .status = 1, .text = "an answer of more than 4 MB", .length = 27 };
      text_clear(&text);
      add_record(&text, &record);
    } else if (told > 0)
      atomic_store(&j->shared->units, false);
    put_in(j->shared, text.at, text.length);
    atomic_store(&j->shared->done, i + 1);
  }
  atomic_store(&j->shared->started, 0);
  _exit(0);
}

/* The case that has ended the worker gets its record. */
static int note_end(struct job *j, const char *reason, int status)
{
  const long i = atomic_load(&j->shared->done);
  struct text text = TEXT_NONE, said = TEXT_NONE;

  if (!reason)
    first_complaint(j->complaints, &said);
  const struct record record = { .n = j->cases[i], .failed = true, .step = atomic_load(&j->shared->step), .status = status,
                                 .text = reason ? reason : said.at, .length = strlen(reason ? reason : said.at) };

  add_record(&text, &record);
  const int result = j->sink.take(j->sink.its, text.at, text.length);

  atomic_store(&j->shared->done, i + 1);
  text_free(&text);
  text_free(&said);
  return result;
}

/* The worker has ended by itself. */
static int judge_end(struct job *j, int status)
{
  char reason[80];

  if (take_out(j->shared, j->sink) != 0)
    return -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return 0;
  if (WIFEXITED(status) && WEXITSTATUS(status) == DISK_FULL) {
    say_line("mlg cases", "the disk is full; what is done stays, and resume goes on when there is room");
    return -1;
  }
  if (WIFEXITED(status))
    return note_end(j, NULL, WEXITSTATUS(status));
  const int signal = WTERMSIG(status);

  if (signal == SIGTERM || signal == SIGINT || signal == SIGHUP) {
    raise(signal);
    return -1;
  }
  wait_for_end(128 + signal, NULL);
  snprintf(reason, sizeof reason, "killed by signal %d (%s)", signal, strsignal(signal));
  return note_end(j, reason, 128 + signal);
}

/* Waits for the end of the worker, empties the ring meanwhile.  Returns 0, -1: it is over. */
static int watch(struct job *j, pid_t worker, const sigset_t *wanted, const sigset_t *before)
{
  const struct timespec tick = { 0, 100000000 };
  char reason[80];

  for (;;) {
    const int signal = sigtimedwait(wanted, NULL, &tick);
    const long long started = atomic_load(&j->shared->started);
    const long done = atomic_load(&j->shared->done);
    int status;

    if (waitpid(worker, &status, WNOHANG) == worker) {
      sigprocmask(SIG_SETMASK, before, NULL);
      return judge_end(j, status);
    }
    const bool stop = signal == SIGINT || signal == SIGTERM || signal == SIGHUP, bad = take_out(j->shared, j->sink) != 0;
    const bool late = j->sweep->time_limit > 0. && started > 0 && done < j->n && done == atomic_load(&j->shared->done)
                      && started == atomic_load(&j->shared->started) && 1e-9 * (double)(now_ns() - started) > j->sweep->time_limit;

    if (!stop && !bad && !late)
      continue;
    kill(worker, SIGKILL);
    waitpid(worker, &status, 0);
    sigprocmask(SIG_SETMASK, before, NULL);
    if (!bad && take_out(j->shared, j->sink) != 0)
      return -1;
    if (stop)
      raise(signal);
    if (stop || bad)
      return -1;
    if (atomic_load(&j->shared->done) == done) {
      snprintf(reason, sizeof reason, "took longer than %g s (time)", j->sweep->time_limit);
      return note_end(j, reason, 124);
    }
    return 0;
  }
}

int compute_cases(const struct sweep *sweep, const long long cases[], long n, const char *scratch, bool units, struct sink sink)
{
  struct job j = { sweep, cases, n, scratch, memfd_create("complaints", MFD_CLOEXEC), NULL, sink };
  sigset_t wanted, before;
  int status = 0;

  j.shared = mmap(NULL, sizeof *j.shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (j.shared == MAP_FAILED || j.complaints < 0) {
    say_line("mlg cases", strerror(errno));
    return 1;
  }
  atomic_store(&j.shared->units, units);
  sigemptyset(&wanted);
  for (const int *s = (const int[]){ SIGCHLD, SIGINT, SIGTERM, SIGHUP, 0 }; *s; s++)
    sigaddset(&wanted, *s);
  fflush(stdout);
  while (status == 0 && atomic_load(&j.shared->done) < n) {
    const pid_t self = getpid();

    sigprocmask(SIG_BLOCK, &wanted, &before);
    atomic_store(&j.shared->started, 0);
    const pid_t worker = fork();

    if (worker == 0)
      work(&j, atomic_load(&j.shared->done), self, &before);
    if (worker > 0)
      status = watch(&j, worker, &wanted, &before);
    else {
      sigprocmask(SIG_SETMASK, &before, NULL);
      say_line("mlg cases", strerror(errno));
      status = -1;
    }
  }
  munmap(j.shared, sizeof *j.shared);
  close(j.complaints);
  return status != 0;
}
