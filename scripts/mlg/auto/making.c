/* making.c - a run that is made, judged and put in its place; see making.h */
#define _GNU_SOURCE
#include "making.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "child.h"
#include "command.h"
#include "judge.h"
#include "progress.h"
#include "stamp.h"
#include "uses.h"

char *joined(const char *a, const char *b, const char *c, const char *d)
{
  struct text t = TEXT_NONE;

  text_add(&t, "%s%s%s%s", a, b, c, d);
  return t.at;
}

static double ms_since(const struct timespec *began)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e3 * (double)(now.tv_sec - began->tv_sec) + 1e-6 * (double)(now.tv_nsec - began->tv_nsec);
}

/* Whatever goes wrong with files here: one line, status 1. */
static int fail(const struct request *r, const char *what)
{
  fprintf(stderr, "%s: %s\n", r->name, what);
  return MLG_FAILED;
}

static void judge_files(const struct request *r, const char *folder, int status, struct judgement *judgement)
{
  char *b = joined(folder, "/b.", r->name, ""), *s = joined(folder, "/s.", r->name, "");
  char *d = joined(folder, "/d.", r->name, ""), *log = joined(folder, "/auto.log", "", "");
  const struct judged judged = { b, s, d, log, r->layout, r->expected, r->n_expected, status };

  judge_run(&judged, judgement);
  free(b);
  free(s);
  free(d);
  free(log);
}

/* What the model and AUTO said themselves of a failure: of a parameter that left its
 * range, of the start. */
static void own_words(const struct text *log, struct text *words)
{
  for (const char *t = log->at; t && *t; t = strchr(t, '\n') ? strchr(t, '\n') + 1 : NULL) {
    size_t length = strcspn(t, "\n"), blanks = strspn(t, " ");
    struct text line = TEXT_NONE;

    while (length > blanks && (t[length - 1] == ' ' || t[length - 1] == '.'))
      length--;
    text_append(&line, t + blanks, length > blanks ? length - blanks : 0);
    if (strncmp(t, "PAR(", 4) == 0 || (strncmp(line.at, "Restart label ", 14) == 0 && strstr(line.at, "not found"))
        || (strncmp(t, "The solution file ", 18) == 0 && strstr(line.at, "not be found"))
        || (strncmp(line.at, "The solution file ", 18) == 0 && strstr(line.at, "not be found")))
      text_add(words, "%s; ", line.at);
    text_free(&line);
  }
}

/* Why the run was rejected, and the end of AUTO's output. */
static void say_rejected(const struct request *r, const char *complaints)
{
  char *file = joined(r->part, "/auto.log", "", "");
  struct text log = TEXT_NONE, words = TEXT_NONE, why = TEXT_NONE;
  size_t from;
  int lines = 0;

  text_clear(&words);
  if (read_file(file, &log, &why) != 0)
    text_clear(&log);
  own_words(&log, &words);
  fprintf(stderr, "%s (%s): %s%s\n  end of AUTO's output (%s):\n", r->name, r->file, words.at, complaints, file);
  while (log.length > 0 && log.at[log.length - 1] == '\n')
    log.at[--log.length] = '\0';
  for (from = log.length; from > 0 && !(log.at[from - 1] == '\n' && ++lines == 6); from--)
    ;
  for (char *t = log.at + from; *t;) {
    const size_t length = strcspn(t, "\n");

    fprintf(stderr, "  | %.*s\n", (int)length, t);
    t += length + (t[length] != '\0');
  }
  free(file);
  text_free(&log);
  text_free(&words);
  text_free(&why);
}

/* Where the run is made: an empty folder with the constants and the start. */
static int prepare(const struct request *r, struct text *why)
{
  char *file = joined(r->part, "/fort.2", "", ""), *link = NULL, *to = NULL;
  int status = 0;

  if ((remove_folder(r->part) != 0 && errno != ENOENT) || mkdir(r->part, 0777) != 0) {
    text_add(why, "%s: %s", r->part, strerror(errno));
    status = -1;
  } else if (write_file(file, r->text.at, r->text.length, why) != 0)
    status = -1;
  else if (r->from || r->orbit) {
    link = r->from ? joined(r->part, "/s.", r->from, "") : joined(r->part, "/start.dat", "", "");
    to = r->from ? joined("../", r->from, "/s.", r->from) : joined(r->start, "", "", "");
    if (symlink(to, link) != 0) {
      text_add(why, "%s: %s", link, strerror(errno));
      status = -1;
    }
  }
  free(file);
  free(link);
  free(to);
  return status;
}

/* c.NAME, and files that AUTO did not come to write. */
static void complete(const struct request *r)
{
  static const char *const kinds[] = { "/b.", "/d.", "/s." };
  char *from = joined(r->part, "/fort.2", "", ""), *to = joined(r->part, "/c.", r->name, "");

  if (rename(from, to) != 0)
    perror(to);
  free(from);
  free(to);
  for (int i = 0; i < 3; i++) {
    char *file = joined(r->part, kinds[i], r->name, "");
    const int descriptor = open(file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);

    if (descriptor >= 0)
      close(descriptor);
    free(file);
  }
}

static int write_origin(const struct request *r, double ms, struct text *why)
{
  const char *figure = getenv("MLG_FIGURE");
  struct text text = TEXT_NONE;
  char *file = joined(r->part, "/origin", "", "");
  int status;

  text_add(&text, "layout=%s\nmodel=%s\nfigure=%s\nms=%.0f\nconstants=%s\nwords=", r->layout, r->program, figure ? figure : "",
           ms, r->file);
  for (int i = 0; i < r->words; i++) {
    text_add(&text, "%s", i > 0 ? " " : "");
    for (const char *t = r->word[i]; *t; t++)
      text_append(&text, *t == '\n' ? " " : t, 1);
  }
  text_add(&text, "\n");
  status = write_file(file, text.at, text.length, why);
  free(file);
  text_free(&text);
  return status;
}

/* NAME.part becomes NAME in one step; what was there before goes. */
static int publish(const struct request *r, struct text *why)
{
  if (rename(r->part, r->folder) == 0)
    return 0;
  if (renameat2(AT_FDCWD, r->part, AT_FDCWD, r->folder, RENAME_EXCHANGE) == 0) {
    remove_folder(r->part);
    return 0;
  }
  /* a file system that cannot exchange; half removed the old one must not count as made */
  char *stamp = joined(r->folder, "/stamp", "", "");
  unlink(stamp);
  free(stamp);
  if (remove_folder(r->folder) == 0 && rename(r->part, r->folder) == 0)
    return 0;
  text_add(why, "%s: %s", r->folder, strerror(errno));
  return -1;
}

/* Puts text in front of what stands behind the key of a constants line, or a line KEY = {text}
 * behind all. */
static void insert_point_list(const struct text *constants, const char *name, const char *values, struct text *out)
{
  static const char uzr[] = "\nUZR = {";
  const char *line = strstr(constants->at, uzr), *place = line ? line + strlen(uzr) : NULL;
  struct text key = TEXT_NONE;

  text_add(&key, "'%s': ", name);
  const char *given = line ? strstr(line, key.at) : NULL;

  if (!line)
    text_add(out, "%sUZR = {%s[%s]}\n", constants->at, key.at, values);
  else if (given && given < line + 1 + strcspn(line + 1, "\n")) { /* one value or a list of them is there */
    place = given + key.length;
    const size_t one = strcspn(place, ",}");

    text_append(out, constants->at, (size_t)(place - constants->at));
    if (*place == '[')
      text_add(out, "[%s, %s", values, place + 1);
    else
      text_add(out, "[%s, %.*s]%s", values, (int)one, place, place + one);
  } else {
    text_append(out, constants->at, (size_t)(place - constants->at));
    text_add(out, "%s[%s]%s%s", key.at, values, *place == '}' ? "" : ", ", place);
  }
  text_free(&key);
}

/* The constants with a point asked for, UZR, on either side of each Hopf point, at that part of
 * the way to the next one, or of a hundredth of its value: so that each lies in a step of its
 * own, and so near that the pair on the axis is the nearest to it, for AUTO looks at no other;
 * and a first step so small that none is in the first two, in which AUTO looks for nothing. */
static void ask_beside(const struct text *constants, const struct judgement *judgement, double part, struct text *out)
{
  struct text values = TEXT_NONE, shorter = TEXT_NONE;
  const char *line = strstr(constants->at, "\nDS = ");
  double nearest = INFINITY;

  for (int i = 0; i < judgement->hopf_points; i++) {
    const struct hopf_point *p = &judgement->hopf[i];
    const double beside = part * fmin(p->gap, 1e-2 * fabs(p->at));

    text_add(&values, "%s%.15g, %.15g", i ? ", " : "", p->at - beside, p->at + beside);
    nearest = fmin(nearest, fabs(p->at - judgement->start));
  }
  if (line && judgement->step > 0.1 * nearest) {
    text_append(&shorter, constants->at, (size_t)(line + 6 - constants->at));
    text_add(&shorter, "%.6g%s", 0.1 * nearest / judgement->step * strtod(line + 6, NULL), line + 6 + strcspn(line + 6, "\n"));
  } else
    text_add(&shorter, "%s", constants->at);
  insert_point_list(&shorter, judgement->hopf_along, values.at, out);
  text_free(&values);
  text_free(&shorter);
}

/* AUTO's run in r->part, judged; its status, or -1 with a line in why. */
static int compute(const struct request *r, struct judgement *judgement, struct text *why)
{
  int status;

  if (prepare(r, why) != 0)
    return -1;
  status = run_model(r->exe, r->part, why);
  complete(r);
  judge_files(r, r->part, status, judgement);
  return status;
}

static int make(const struct request *r, const struct stamp *stamp)
{
  struct text why = TEXT_NONE;
  struct judgement judgement;
  int status = compute(r, &judgement, &why);

  if (status == 0 && judgement.missed > 0) {
    static const double part[] = { 0.1, 0.02, 0.3, 0.001 };
    struct judgement first = judgement;
    struct request again = *r;

    for (size_t i = 0; i < sizeof part / sizeof *part && status == 0 && judgement.missed > 0; i++) {
      again.text = (struct text)TEXT_NONE;
      ask_beside(&r->text, &first, part[i], &again.text);
      if (i > 0)
        judgement_free(&judgement);
      status = compute(&again, &judgement, &why);
      text_free(&again.text);
    }
    judgement_free(&first);
    if (status == 0 && judgement.missed == 0)
      text_add(&judgement.found, ", with points asked for beside those that AUTO had stepped over");
  }
  if (status == -1) {
    status = fail(r, why.at);
    text_free(&why);
    return status;
  }
  if (why.length > 0 || (status == 0 && !judgement.whole)) {
    say_rejected(r, why.length > 0 ? why.at : "what AUTO wrote is cut short (is the disk full?)");
    if (why.length == 0 && judgement.damage.length > 0)
      fprintf(stderr, "  %s\n", judgement.damage.at);
    status = MLG_FAILED;
  } else if (judgement.complaints.length > 0) {
    say_rejected(r, judgement.complaints.at);
    status = MLG_FAILED;
  } else {
    const double ms = ms_since(&r->began);

    text_clear(&why);
    if (write_origin(r, ms, &why) == 0 && stamp_write(stamp, r->part, &why) == 0 && publish(r, &why) == 0) {
      report_run(r->name, ms_since(&r->began), judgement.found.at);
      status = MLG_OK;
    } else
      status = fail(r, why.at);
  }
  judgement_free(&judgement);
  text_free(&why);
  return status;
}

/* A run that fits but for its judge is judged again where it is. */
static int passes_again(const struct request *r, const struct stamp *stamp)
{
  struct judgement judgement;
  struct text why = TEXT_NONE;
  int good;

  judge_files(r, r->folder, 0, &judgement);
  good = judgement.whole && judgement.complaints.length == 0 && stamp_write(stamp, r->folder, &why) == 0;
  judgement_free(&judgement);
  text_free(&why);
  return good;
}

int make_if_needed(const struct request *r)
{
  struct text text = TEXT_NONE, what = TEXT_NONE;
  struct stamp stamp;
  enum stamp_state state;
  int status = MLG_OK;

  text_add(&text, "expected");
  for (int i = 0; i < r->n_expected; i++)
    text_add(&text, " %s", r->expected[i]);
  text_add(&text, "\n%s", r->text.at); /* another comment in the constants file is no change */
  stamp_begin(&stamp, r->folder, r->name, text.at, r->exe, r->start);
  state = stamp_state(&stamp, r->folder, &what);
  if (state == STAMP_NEW_JUDGE && passes_again(r, &stamp))
    state = STAMP_FITS;
  if (state == STAMP_DAMAGED)
    fprintf(stderr, "  %s: %s is not what AUTO wrote; it is made anew\n", r->name, what.at);
  note_passed(r->name);
  if (state != STAMP_FITS)
    status = make(r, &stamp);
  note_use(r->file);
  note_use(r->exe);
  for (int i = STAMP_B; i < STAMPED; i++)
    note_use(stamp.file[i]);
  stamp_free(&stamp);
  text_free(&text);
  text_free(&what);
  return status;
}
