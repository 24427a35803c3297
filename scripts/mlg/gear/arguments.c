/* arguments.c - the one set of rules for the words behind a command */
#include "arguments.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "gearfile.h"

enum { LINE = 1024, MOST_IN_RANGE = 1000000 };

/* A message stays one line whatever it quotes. */
static void say(const char *text)
{
  for (; *text; text++)
    fputc(iscntrl((unsigned char)*text) ? ' ' : *text, stderr);
  fputc('\n', stderr);
}

_Noreturn void fail(const char *command, int status, const char *text, ...)
{
  char line[LINE];
  int n = snprintf(line, sizeof line, "mlg %s: ", command);
  va_list values;

  va_start(values, text);
  vsnprintf(line + n, sizeof line - (size_t)n, text, values);
  va_end(values);
  say(line);
  exit(status);
}

_Noreturn void refuse_file(const char *file, int line, const char *text, va_list values)
{
  char message[LINE];

  vsnprintf(message, sizeof message, text, values);
  if (line > 0)
    fprintf(stderr, "%s:%d: ", file, line);
  else
    fprintf(stderr, "%s: ", file);
  say(message);
  exit(MLG_BAD_INPUT);
}

_Noreturn void refuse(const char *command, const char *word, const char *right, ...)
{
  char line[LINE];
  va_list values;

  va_start(values, right);
  vsnprintf(line, sizeof line, right, values);
  va_end(values);
  fail(command, MLG_BAD_INPUT, "'%.200s': %s", word, line);
}

bool is_number(const char *text, double *value)
{
  char *end;

  *value = strtod(text, &end);
  return end != text && *end == '\0' && isfinite(*value) && !strpbrk(text, "xXpPnN")
         && !isspace((unsigned char)*text);
}

double in_range(const char *command, const char *word, const char *unit, double least, double most,
                double value)
{
  if (!(value >= least && value <= most))
    refuse(command, word, "outside its range, %g to %g%s%s", least, most, *unit ? " " : "", unit);
  return value;
}

static bool is_called(const char *name, const char *word, size_t length)
{
  return strlen(name) == length && memcmp(name, word, length) == 0;
}

/* Notes the word that gave a value; one is enough. */
static void note(const struct arguments *a, const char **noted, const char *word)
{
  if (*noted)
    refuse(a->command, word, "given already, by '%.200s'", *noted);
  *noted = word;
}

static int number_of(const char *word, size_t length)
{
  for (int i = 0; i < NUMBERS; i++)
    if (is_called(libmlg_parameter_quantity(i)->name, word, length))
      return i;
  return LIBMLG_NONE;
}

static void set(struct arguments *a, const char *word, enum parameter_number n, double value)
{
  note(a, &a->word[n], word);
  a->par[n] = in_range(a->command, word, libmlg_parameter_quantity(n)->unit, libmlg_least(n),
                       libmlg_most(n), value);
}

void take_value(struct arguments *a, const char *word, size_t length, double value)
{
  const int n = number_of(word, length);

  for (struct option *o = a->option; o && o->name; o++)
    if (is_called(o->name, word, length)) {
      note(a, &o->word, word);
      if (!*o->unit && value != floor(value))
        refuse(a->command, word, "expected a whole number");
      o->value = in_range(a->command, word, o->unit, o->least, o->most, value);
      return;
    }
  if (n != LIBMLG_NONE) {
    set(a, word, n, n == NUMBER_K_S && value > MLG_RIGID ? MLG_RIGID : value);
  } else if (is_called("compliance", word, length)) {
    in_range(a->command, word, "1e-5 rad/(N m)", 0., 1e5, value);
    set(a, word, NUMBER_K_S, value > 0. ? fmin(MLG_RIGID, 1e5 / value) : MLG_RIGID);
  } else if (is_called("V_top", word, length)) {
    note(a, &a->V_top_word, word);
    a->V_top = in_range(a->command, word, "m/s", 1e-3, libmlg_most(NUMBER_V), value);
  } else if (is_called("F_z", word, length)) {
    note(a, &a->F_z_word, word);
    a->F_z = in_range(a->command, word, "N", 1e-3, 1e9, value);
  } else {
    refuse(a->command, word, "no such parameter (see models/mlg.h)");
  }
}

void take_word(struct arguments *a, const char *word)
{
  const char *equals = strchr(word, '=');
  double value;

  if (equals && strncmp(word, "gear=", 5) == 0) {
    if (!equals[1])
      refuse(a->command, word, "expected gear=FILE");
    note(a, &a->gear_word, word);
    return;
  }
  if (equals && (strcmp(word, "k_s=inf") == 0))
    value = MLG_RIGID;
  else if (!equals && *word)
    refuse(a->command, word, "expected NAME=NUMBER; `mlg help %s` has its other words", a->command);
  else if (!equals || equals == word || !is_number(equals + 1, &value))
    refuse(a->command, word, "expected NAME=NUMBER");
  take_value(a, word, (size_t)(equals - word), value);
}

static void take_gear(struct arguments *a)
{
  struct text why = TEXT_NONE;
  struct gear gear;

  if (read_gear(a->gear_word + strlen("gear="), &gear, &why) != 0) {
    say(why.at);
    exit(MLG_BAD_INPUT);
  }
  for (int k = 0; k < gear.n; k++) {
    const struct gear_value *v = &gear.value[k];

    if (v->parameter == LIBMLG_F_Z) {
      if (!a->word[NUMBER_M] && !a->F_z_word) {
        a->F_z_word = a->gear_word;
        a->F_z = v->value;
      }
    } else if (!a->word[v->parameter] && !(v->parameter == NUMBER_M && a->F_z_word)) {
      a->word[v->parameter] = a->gear_word;
      a->par[v->parameter] = v->value;
    }
  }
}

/* The M that F_z stands for. */
static void settle_load(struct arguments *a)
{
  const double M = a->F_z / a->par[NUMBER_G] - a->par[NUMBER_M_D];

  if (!a->F_z_word)
    return;
  if (a->word[NUMBER_M])
    refuse(a->command, a->F_z_word, "M is given already, by '%.200s'", a->word[NUMBER_M]);
  if (!(M >= libmlg_least(NUMBER_M) && M <= libmlg_most(NUMBER_M)))
    refuse(a->command, a->F_z_word, "%smakes M = F_z/g - m_D = %g kg, outside its range, %g to %g kg", a->F_z_word == a->gear_word ? "its F_z " : "", M,
           libmlg_least(NUMBER_M), libmlg_most(NUMBER_M));
  a->par[NUMBER_M] = M;
}

/* Whether the device cannot tell this value from none. */
static bool is_neutral(enum parameter_number n, double value)
{
  return (n == NUMBER_K_S && value >= MLG_RIGID) || ((n == NUMBER_B || n >= NUMBER_G_PSI) && value == 0.);
}

/* Commands that run the laws of elements.h as they are. */
static bool runs_laws(const char *command)
{
  static const char *const names[] = { "simulate", "search", "transients", "cycle", "joints", "decay" };

  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    if (strcmp(command, names[i]) == 0)
      return true;
  return false;
}

/* What a linear tool takes in the place of a law, said in a line for each. */
static void leave_laws_out(struct arguments *a)
{
  static const enum parameter_number none[] = { NUMBER_G_PSI, NUMBER_G_S, NUMBER_T_F, NUMBER_T_PSI };
  static const enum parameter_number linear[] = { NUMBER_C_2, NUMBER_T_MAX, NUMBER_K_S3, NUMBER_K_D3 };

  for (size_t i = 0; i < sizeof none / sizeof *none; i++)
    if (a->par[none[i]] > 0.)
      fprintf(stderr, "mlg %s: %s = %g is left out: play and friction have no linearisation at rest\n", a->command,
              libmlg_parameter_quantity(none[i])->name, a->par[none[i]]);
  for (size_t i = 0; i < sizeof linear / sizeof *linear; i++)
    if (a->par[linear[i]] > 0.)
      fprintf(stderr, "mlg %s: %s = %g is taken as it is at rest: it adds nothing there\n", a->command,
              libmlg_parameter_quantity(linear[i])->name, a->par[linear[i]]);
}

void end_arguments(struct arguments *a)
{
  if (a->gear_word)
    take_gear(a);
  settle_load(a);
  for (int n = 0; n < NUMBERS; n++)
    if (a->word[n] && !is_neutral(n, a->par[n]) && !libmlg_uses(a->layout, n))
      refuse(a->command, a->word[n], "layout %s has no %s", libmlg_layout_name(a->layout),
             libmlg_parameter_quantity(n)->name);
  if (libmlg_lacks(a->par))
    fail(a->command, MLG_BAD_INPUT, "%s", libmlg_lacks(a->par));
  if (!runs_laws(a->command))
    leave_laws_out(a);
}

void retake_value(struct arguments *a, const char *word, size_t length, double value)
{
  for (int n = 0; n < NUMBERS; n++)
    if (a->word[n] == word)
      a->word[n] = NULL;
  for (struct option *o = a->option; o && o->name; o++)
    if (o->word == word)
      o->word = NULL;
  if (a->V_top_word == word)
    a->V_top_word = NULL;
  if (a->F_z_word == word)
    a->F_z_word = NULL;
  take_value(a, word, length, value);
  settle_load(a);
}

/* A network written as text, which no layout's name looks like but for one element. */
static bool is_network(const char *word)
{
  return strpbrk(word, "|-=(") || number_of(word, strlen(word)) != LIBMLG_NONE;
}

void begin_arguments(struct arguments *a, int argc, char *argv[], struct option option[])
{
  char known[LINE] = "", wrong[LINE];
  size_t n = 0;

  *a = (struct arguments){ .command = argv[0], .V_top = MLG_V_TOP, .option = option };
  libmlg_defaults(a->par);
  if (argc < 2)
    fail(argv[0], MLG_BAD_INPUT, "expected a layout; `mlg help %s` says more", argv[0]);
  a->layout = libmlg_layout(argv[1]);
  if (a->layout == LIBMLG_NONE && is_network(argv[1])) {
    a->layout = libmlg_network(argv[1], wrong, sizeof wrong);
    if (a->layout == LIBMLG_NONE)
      refuse(argv[0], argv[1], "no network: %s", wrong);
  }
  if (a->layout != LIBMLG_NONE)
    return;
  if (argc > 2 && (libmlg_layout(argv[2]) != LIBMLG_NONE || strpbrk(argv[2], "|(")))
    refuse(argv[0], argv[1], "the layout comes first: mlg %s %.200s %.200s", argv[0], argv[2], argv[1]);
  for (int i = 0; i < libmlg_layouts() && n < sizeof known; i++)
    n += (size_t)snprintf(known + n, sizeof known - n, "%s %s", i ? "," : "", libmlg_layout_name(i));
  refuse(argv[0], argv[1], "no such layout; there are%.500s", known);
}

void read_arguments(struct arguments *a, int argc, char *argv[], struct option option[])
{
  begin_arguments(a, argc, argv, option);
  for (int i = 2; i < argc; i++)
    take_word(a, argv[i]);
  end_arguments(a);
}

void refuse_given(const struct arguments *a, enum parameter_number n, const char *right)
{
  if (a->word[n])
    refuse(a->command, a->word[n], "%s", right);
}

int output_status(const char *command)
{
  if (fflush(stdout) == 0 && !ferror(stdout))
    return MLG_OK;
  fprintf(stderr, "mlg %s: cannot write the output: %s\n", command, strerror(errno));
  return MLG_FAILED;
}

struct range take_range(struct arguments *a, const char *text)
{
  struct range r = { .text = text };
  const char *at = strchr(text, '=');
  double part[3];
  int n = 0;

  for (bool more = at != NULL; more && n < 3; n++) {
    char number[64] = "";
    const size_t length = strcspn(++at, ":");

    if (length < sizeof number)
      memcpy(number, at, length);
    if (!is_number(number, &part[n]))
      break;
    at += length;
    more = *at == ':';
  }
  if (n < 3 || *at || !(part[0] < part[1]) || !(part[2] >= 2. && part[2] <= MOST_IN_RANGE && part[2] == floor(part[2])))
    refuse(a->command, text, "expected NAME=FROM:TO:N, FROM below TO and N a whole number from 2 to %d", MOST_IN_RANGE);
  r.from = part[0], r.to = part[1], r.n = (int)part[2];
  take_value(a, text, range_name_length(&r), r.to);
  return r;
}

size_t range_name_length(const struct range *r)
{
  return strcspn(r->text, "=");
}
