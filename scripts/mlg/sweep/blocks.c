/* blocks.c - the blocks of a sweep and their files; see blocks.h */
#define _GNU_SOURCE
#include "blocks.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "child.h"
#include "worker.h"

enum { BLOCKS_IN_FOLDER = 1000, PATH = 4096 };

static const char *const ending[BLOCK_STATES] = { [BLOCK_PART] = "part", [BLOCK_FAILED] = "failed", [BLOCK_DONE] = "done" };

static void block_file(const struct blocks *b, long long k, enum block_state state, char path[PATH])
{
  snprintf(path, PATH, "%s/blocks/%lld/%lld.%s", b->folder, k / BLOCKS_IN_FOLDER, k, ending[state]);
}

static void note_files(const struct blocks *b, long long folder, unsigned char *state)
{
  char path[PATH], kind[16];
  struct dirent *entry;
  long long k;

  snprintf(path, sizeof path, "%s/blocks/%lld", b->folder, folder);
  DIR *d = opendir(path);

  while (d && (entry = readdir(d)) != NULL)
    if (sscanf(entry->d_name, "%lld.%15s", &k, kind) == 2 && k >= 1 && k <= b->n)
      for (int s = BLOCK_PART; s < BLOCK_STATES; s++)
        if (strcmp(kind, ending[s]) == 0 && s > state[k])
          state[k] = (unsigned char)s;
  if (d)
    closedir(d);
}

unsigned char *block_states(const struct blocks *b)
{
  unsigned char *state = must_allocate((size_t)b->n + 1);

  memset(state, BLOCK_NONE, (size_t)b->n + 1);
  for (long long folder = 0; folder <= b->n / BLOCKS_IN_FOLDER; folder++)
    note_files(b, folder, state);
  return state;
}

void free_block(struct block *block)
{
  free(block->record);
  text_free(&block->bytes);
}

static void index_records(const struct blocks *b, long long k, struct block *block)
{
  size_t n;

  block->first = (k - 1) * b->size + 1;
  block->cases = (long)(block->first + b->size - 1 <= b->sweep->cases ? b->size : b->sweep->cases - block->first + 1);
  block->record = must_allocate((size_t)block->cases * sizeof *block->record);
  memset(block->record, 0, (size_t)block->cases * sizeof *block->record);
  for (block->whole = 0; block->whole < block->bytes.length; block->whole += n) {
    struct record r;

    n = read_record(block->bytes.at + block->whole, block->bytes.length - block->whole, &r);
    if (n > 0 && r.units) {
      block->units = block->units.text ? block->units : r;
      continue;
    }
    if (n == 0 || r.n < block->first || r.n >= block->first + block->cases)
      break;
    struct record *known = &block->record[r.n - block->first];

    block->known += known->n == 0;
    block->failed += r.failed - (known->n != 0 && known->failed);
    *known = r; /* the last one counts: it may be a second attempt */
  }
}

int read_block(const struct blocks *b, long long k, enum block_state state, struct block *block, struct text *why)
{
  char path[PATH];

  *block = (struct block){ .bytes = TEXT_NONE };
  block_file(b, k, state, path);
  if (read_file(path, &block->bytes, why) != 0)
    return -1;
  index_records(b, k, block);
  if (state == BLOCK_PART || (block->whole == block->bytes.length && block->known == block->cases))
    return 0;
  text_add(why, "%s is damaged: %ld of its %ld cases can be read; remove it, and resume computes them", path, block->known,
           block->cases);
  return -1;
}

bool is_at_work(const struct blocks *b, long long k)
{
  char path[PATH];

  block_file(b, k, BLOCK_PART, path);
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  const bool locked = file >= 0 && flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;

  if (file >= 0)
    close(file);
  return locked;
}

struct output { int file; const char *path; off_t whole; };

static int append(void *its, const char *bytes, size_t n)
{
  struct output *o = its;

  for (size_t at = 0; at < n;) {
    const ssize_t written = write(o->file, bytes + at, n - at);

    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0) {
      fprintf(stderr, "mlg cases: %s: %s; what is done stays, and resume goes on from there\n", o->path, strerror(errno));
      if (ftruncate(o->file, o->whole) != 0) /* else the half is found when it is read */
        return -1;
      return -1;
    }
    at += (size_t)written;
  }
  o->whole += (off_t)n;
  return 0;
}

static int complain(const char *path)
{
  fprintf(stderr, "mlg cases: %s: %s\n", path, strerror(errno));
  return 1;
}

static int make_folders(const struct blocks *b, long long k)
{
  char path[PATH];

  for (int depth = 0; depth < 2; depth++) {
    snprintf(path, sizeof path, depth ? "%s/blocks/%lld" : "%s/blocks", b->folder, k / BLOCKS_IN_FOLDER);
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
      return complain(path);
  }
  return 0;
}

/* The part of a block, locked; -1: it is done, or cannot be opened (*status 1). */
static int open_part(const char *path, const char *done, const char *failed, int *status)
{
  for (;;) {
    struct stat here, there;
    const int file = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);

    *status = file < 0 ? complain(path) : 0;
    if (file < 0)
      return -1;
    while (flock(file, LOCK_EX) != 0 && errno == EINTR)
      ;
    const bool is_it = fstat(file, &here) == 0 && stat(path, &there) == 0 && here.st_ino == there.st_ino;

    if (access(done, F_OK) == 0 || access(failed, F_OK) == 0) {
      if (is_it)
        unlink(path);
      close(file);
      return -1;
    }
    if (is_it)
      return file;
    close(file);
  }
}

static int fill_part(const struct blocks *b, long long k, bool retry, struct output *o, struct block *block)
{
  long long *cases = must_allocate((size_t)block->cases * sizeof *cases);
  char scratch[PATH];
  const char *elsewhere = getenv("MLG_SCRATCH");
  long n = 0;

  for (long i = 0; i < block->cases; i++)
    if (block->record[i].n == 0 || (retry && block->record[i].failed))
      cases[n++] = block->first + i;
  if (b->sweep->keeps_files)
    snprintf(scratch, sizeof scratch, "%s/runs", b->folder);
  else
    snprintf(scratch, sizeof scratch, "%s/scratch.%lld", elsewhere && *elsewhere ? elsewhere : b->folder, k);
  const int status = n > 0 ? compute_cases(b->sweep, cases, n, scratch, block->units.text == NULL, (struct sink){ append, o }) : 0;

  if (!b->sweep->keeps_files)
    remove_folder(scratch);
  free(cases);
  return status;
}

static int close_block(const struct blocks *b, long long k, struct output *o, struct text *why)
{
  struct block block;
  char to[PATH];
  int status = 0;

  if (read_block(b, k, BLOCK_PART, &block, why) != 0 || block.known < block.cases) {
    fprintf(stderr, "mlg cases: %s: %s\n", o->path, why->length > 0 ? why->at : "not all that was written can be read");
    status = 1;
  }
  if (status == 0) {
    block_file(b, k, block.failed > 0 ? BLOCK_FAILED : BLOCK_DONE, to);
    if (fsync(o->file) != 0 || rename(o->path, to) != 0)
      status = complain(o->path);
  }
  free_block(&block);
  return status;
}

int compute_block(const struct blocks *b, long long k, bool retry)
{
  char part[PATH], done[PATH], failed[PATH];
  struct text why = TEXT_NONE;
  struct block block;
  int status;

  block_file(b, k, BLOCK_PART, part);
  block_file(b, k, BLOCK_DONE, done);
  block_file(b, k, BLOCK_FAILED, failed);
  if (make_folders(b, k) != 0)
    return 1;
  if (retry && rename(failed, part) != 0 && errno != ENOENT)
    return complain(failed);
  struct output o = { open_part(part, done, failed, &status), part, 0 };

  if (o.file < 0)
    return status;
  if (read_block(b, k, BLOCK_PART, &block, &why) == 0) {
    o.whole = (off_t)block.whole;
    status = ftruncate(o.file, o.whole) != 0 ? complain(part) : fill_part(b, k, retry, &o, &block);
    if (status == 0)
      status = close_block(b, k, &o, &why);
  } else
    status = (say_line("mlg cases", why.at), 1);
  free_block(&block);
  text_free(&why);
  close(o.file);
  return status;
}
