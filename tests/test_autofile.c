/* test_autofile.c - the reader of AUTO's files and the judge, on files written here
 *
 * scripts/mlg/autofile.h and judge.h.  Files as AUTO writes them, with what it does
 * seldom (numbers of points that begin anew after 9999, several runs in a file, points
 * written because of NPR), then cut at every byte, with zeros and lost lines, and
 * changed at random: whatever the change, the file is read or refused with one line.
 *
 * FUZZ=n SEED=s build/tests/autofile  n random changes, other ones; 3000 if left out
 *
 * Writes build/tests/autofile.files
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "autofile.h"
#include "branch.h"
#include "ending.h"
#include "judge.h"
#include "judgepoints.h"
#include "sums.h"
#include "numbers.h"

#define FOLDER "build/tests/autofile.files"

static const char b_file[] = FOLDER "/b.run", d_file[] = FOLDER "/d.run", s_file[] = FOLDER "/s.run";

static void put(const char *file, const struct text *text)
{
  struct text why = TEXT_NONE;

  mkdir("build/tests", 0777);
  mkdir(FOLDER, 0777);
  assert_int_equal(write_file(file, text->at, text->length, &why), 0);
}

/* The head of a run in V with k further columns. */
static void add_head(struct text *b, int IPS, int ISP, int IID, int ILP, int columns, const char *more)
{
  text_add(b, "   0  -1.7976+308  1.7976+308 -1.7976+308  1.7976+308\n");
  text_add(b, "   0   EPSL= 1.0000E-09  EPSU = 1.0000E-09  EPSS = 1.0000E-09\n");
  text_add(b, "   0   NDIM=   7   IPS =%4d   IRS =   0   ILP =%4d\n", IPS, ILP);
  text_add(b, "   0   NTST=  30   NCOL=   4   IAD =   3   ISP =%4d\n", ISP);
  text_add(b, "   0   ISW =   1   IPLT=   0   NBC =   0   NINT=   0\n");
  text_add(b, "   0   NMX= 5000   NPR=    0   MXBF=   0   IID =%4d   IADS=   1\n", IID);
  text_add(b, "   0   parnames = {1: 'V', 2: 'c_d', 11: 'period'}\n   0   unames   = {1: 'delta', 2: 'ddelta'}\n%s", more);
  text_add(b, "   0   User-specified constants, where different from above:\n   0   NMX=    9   ISP =   9\n");
  text_add(b, "   0\n   0    PT  TY  LAB       V               L2-NORM      ");
  for (int k = 2; k < columns; k++)
    text_add(b, "       column%d     ", k);
  text_add(b, "   \n");
}

static void add_point(struct text *b, int branch, long number, int type, int label, int columns, double V)
{
  text_add(b, "%4d%6ld%4d%5d", branch, number < 0 ? -((-number - 1) % 9999 + 1) : (number - 1) % 9999 + 1, type, label);
  for (int k = 0; k < columns; k++) {
    char number_text[40], *e;

    snprintf(number_text, sizeof number_text, "%.10E", k ? 0.25 * k : V);
    e = strchr(number_text, 'E'); /* Fortran's three digits */
    text_add(b, "%*s%.*sE%c%03d", 14 - (int)(e - number_text), "", (int)(e - number_text), number_text, e[1], atoi(e + 2));
  }
  text_add(b, "\n");
}

static void add_block(struct text *d, long number, int stable, const char *words, double re)
{
  text_add(d, "\n   1%6ld         %s   Stable:%4d\n", number, words, stable);
  for (int k = 1; k <= 2; k++)
    text_add(d, "   1%6ld         Eigenvalue%3d:%14.5E%14.5E\n", number, k, re, k == 1 ? 3. : -3.);
}

/* A good run of n points: stable, HB at the third, then not. */
static void good_run(struct text *b, struct text *d, long n)
{
  add_head(b, 1, 2, 2, 0, 3, "");
  for (long i = 1; i <= n; i++) {
    add_point(b, 1, i <= 3 ? -i : i, i == 3 ? 3 : i == n ? -4 : i == 1 ? 9 : 0, i == 3 || i == n || i == 1 ? (int)i : 0, 3, (double)i);
    add_block(d, (i - 2) % 9999 + 2, 9, "Eigenvalues  :", 9.); /* a step on the way */
    add_block(d, i == 1 ? 1 : (i - 2) % 9999 + 2, i <= 3 ? 7 : 5, "Eigenvalues  :", i <= 3 ? -1. : 1.);
  }
  text_add(d, "\n Total Time    0.1E+00\n");
}

static int read_back(struct af_branches *all, const struct text *b, const struct text *d, struct text *why)
{
  put(b_file, b);
  if (d)
    put(d_file, d);
  return af_read(all, b_file, d ? d_file : NULL, why);
}

/* --- numbers ------------------------------------------------------------------- */

static void numbers_in_every_writing(void **state)
{
  static const struct { const char *text; double value; } good[] = {
    { "1.0-101", 1e-101 }, { "-1.7976+308", -1.7976e308 }, { "1.0d-1", 0.1 }, { "1D3", 1e3 }, { " 1.3430793676E+001 ", 13.430793676 },
    { "5", 5. }, { "-0.0000000000E+000", -0. }, { "1.0000000000E+030", 1e30 }, { ".5", .5 }, { "1e22", 1e22 }, { "-3.", -3. },
  };
  static const char *const bad[] = { "", " ", "E", "1E", "1E+", "--1", "1.2.3", "0x10", "1 2", "12a", "*******", "1e5e5", "+", "." };
  double x;

  (void)state;
  for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
    assert_int_equal(af_number(good[i].text, strlen(good[i].text), &x), 1);
    assert_memory_equal(&x, &good[i].value, sizeof x);
  }
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    if (af_number(bad[i], strlen(bad[i]), &x))
      fail_msg("'%s' was taken for %g", bad[i], x);
  assert_int_equal(af_number("NaN", 3, &x) && isnan(x), 1);
  assert_int_equal(af_number("Infinity", 8, &x) && isinf(x), 1);
  for (int i = 0; i < 100000; i++) { /* the nearest number, as strtod has it */
    char text[40];
    double expected;

    snprintf(text, sizeof text, "%.10E", uniform(-10., 10.) * pow(10., (int)uniform(-40., 40.)));
    expected = strtod(text, NULL);
    assert_int_equal(af_number(text, strlen(text), &x), 1);
    assert_memory_equal(&x, &expected, sizeof x);
  }
}

static void sums_are_xxh64(void **state)
{
  static const struct { const char *text; uint64_t sum; } known[] = {
    { "", 0xef46db3751d8e999u }, { "a", 0xd24ec4f1a98c6e5bu }, { "abc", 0x44bc2cf5ad770999u },
    { "Nobody inspects the spammish repetition", 0xfbcea83c8a378bf1u },
  };

  (void)state;
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    assert_true(sum_of(known[i].text, strlen(known[i].text)) == known[i].sum);
}

/* --- reading ---------------------------------------------------------------------- */

static void a_run_is_read(void **state)
{
  struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;
  const struct af_part *p;

  (void)state;
  good_run(&b, &d, 8);
  assert_int_equal(read_back(&all, &b, &d, &why), 0);
  assert_int_equal(all.parts, 1);
  p = &all.part[0];
  assert_int_equal(p->points, 8);
  assert_int_equal(p->columns, 3);
  assert_string_equal(p->column[1], "L2-NORM");
  assert_string_equal(p->parameter[10], "period");
  assert_string_equal(p->parameter[0], "V");
  assert_string_equal(p->state[0], "delta");
  assert_int_equal(p->constants.ISP, 2); /* not the 9 that was asked for */
  assert_int_equal(p->constants.NMX, 5000);
  assert_true(p->constants.RL0 < -1e308);
  assert_int_equal(p->point[2].stable_count, 7);
  assert_int_equal(p->point[3].stable_count, 5);
  assert_int_equal(p->point[3].eigenvalues, 2);
  assert_true(all.eigenvalue[p->point[3].eigenvalue] == 1.);
  assert_true(af_value(p, 4, 0) == 5. && af_value(p, 4, 2) == 0.5);
  assert_int_equal(p->gap, 0);
  assert_int_equal(all.timed, 1);
  af_free(&all);
  text_free(&b);
  text_free(&d);
}

static void numbers_of_points_count_on(void **state)
{
  struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;

  (void)state;
  good_run(&b, &d, 25000);
  assert_int_equal(read_back(&all, &b, &d, &why), 0);
  assert_int_equal(all.parts, 1);
  assert_int_equal(all.part[0].points, 25000);
  for (long i = 0; i < 25000; i++) {
    assert_int_equal(all.part[0].point[i].number, i + 1);
    assert_int_equal(all.part[0].point[i].stable_count, i < 3 ? 7 : 5);
  }
  assert_int_equal(all.part[0].gap, 0);
  af_free(&all);
  text_free(&b);
  text_free(&d);
}

static void several_runs_in_a_file(void **state)
{
  struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;

  (void)state;
  good_run(&b, &d, 8);
  good_run(&b, &d, 5); /* @ap */
  add_head(&b, 2, 2, 0, 0, 5, "   0   SP=['TR0']\n");
  add_point(&b, 2, 1, 0, 0, 5, 1.);
  text_add(&b, "   0\n   0    PT  TY  LAB       V               L2-NORM      \n"); /* a switch of branches */
  add_point(&b, 3, 1, 0, 0, 2, 1.);
  add_point(&b, 3, 2, 0, 0, 2, 1.);
  add_point(&b, 3, 1, 0, 0, 2, 1.); /* merged without a head */
  assert_int_equal(read_back(&all, &b, &d, &why), 0);
  assert_int_equal(all.parts, 5);
  assert_int_equal(all.part[1].points, 5);
  assert_int_equal(all.part[1].point[3].stable_count, 5);
  assert_int_equal(all.part[2].columns, 5);
  assert_int_equal(all.part[2].constants.IPS, 2);
  assert_string_equal(all.part[2].constants.SP + 3, "SP=['TR0']");
  assert_int_equal(all.part[3].columns, 2);
  assert_int_equal(all.part[3].constants.IPS, 2);
  assert_int_equal(all.part[3].points, 2);
  assert_int_equal(all.part[4].points, 1);
  af_free(&all);
  text_free(&b);
  text_free(&d);
}

static void fields_that_touch(void **state)
{
  struct text b = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;

  (void)state;
  add_head(&b, 1, 2, 0, 0, 3, "");
  add_point(&b, 1, 1, -4, 12345, 3, 2.);
  add_point(&b, -123, -1, -32, 99999, 3, -2.);
  assert_int_equal(read_back(&all, &b, NULL, &why), 0);
  assert_int_equal(all.part[0].point[0].label, 12345);
  assert_string_equal(af_type_name(all.part[0].point[0].type), "UZ");
  assert_int_equal(all.part[1].point[0].label, 99999);
  assert_string_equal(af_type_name(all.part[1].point[0].type), "GH");
  assert_true(af_value(&all.part[1], 0, 0) == -2.);
  af_free(&all);
  text_free(&b);
}

static void types_have_AUTOs_names(void **state)
{
  static const struct { int type; const char *name; } known[] = {
    { 0, "" }, { 1, "BP" }, { 2, "LP" }, { 3, "HB" }, { 4, "" }, { -4, "UZ" }, { 5, "LP" }, { 6, "BP" }, { 7, "PD" }, { 8, "TR" },
    { 9, "EP" }, { -9, "MX" }, { -32, "GH" }, { 23, "LTR" }, { 88, "TTR" }, { 28, "LPD" }, { 77, "PTR" }, { -33, "ZH" }, { 94, "" },
  };

  (void)state;
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    assert_string_equal(af_type_name(known[i].type), known[i].name);
}

/* --- damage -------------------------------------------------------------------------- */

static int is_one_line(const struct text *why, const char *file)
{
  return why->length > strlen(file) && strncmp(why->at, file, strlen(file)) == 0 && !strchr(why->at, '\n');
}

static void a_file_cut_anywhere_is_refused(void **state)
{
  struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;

  (void)state;
  good_run(&b, &d, 6);
  for (size_t n = b.length; n-- > 0;) {
    const int whole_lines = n == 0 || b.at[n - 1] == '\n';
    struct text cut = TEXT_NONE;

    text_append(&cut, b.at, n);
    text_clear(&why);
    if (read_back(&all, &cut, &d, &why) == 0) {
      assert_true(whole_lines);
      af_free(&all);
    } else
      assert_true(!whole_lines && is_one_line(&why, b_file));
    text_free(&cut);
  }
  text_free(&b);
  text_free(&d);
  text_free(&why);
}

/* What is read of a file in which `from` becomes `to`. */
static int with_change(const struct text *b, const char *from, const char *to, struct text *why)
{
  struct text changed = TEXT_NONE;
  struct af_branches all;
  const char *at = strstr(b->at, from);
  int status;

  assert_non_null(at);
  text_append(&changed, b->at, (size_t)(at - b->at));
  text_append(&changed, to, strlen(to));
  text_append(&changed, at + strlen(from), strlen(at) - strlen(from));
  text_clear(why);
  status = read_back(&all, &changed, NULL, why);
  text_free(&changed);
  if (status == 0) {
    text_add(why, "gap %ld nan %ld", all.part[0].gap, all.part[0].nan);
    af_free(&all);
  }
  return status;
}

static void damage_is_noticed(void **state)
{
  struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE, line = TEXT_NONE;
  struct af_branches all;

  (void)state;
  good_run(&b, &d, 6);
  add_point(&line, 1, 5, 0, 0, 3, 5.);
  assert_int_equal(with_change(&b, line.at, "", &why), 0); /* a line lost */
  assert_true(strncmp(why.at, "gap 17 ", 7) == 0);
  assert_int_equal(with_change(&b, "4.0000000000E+000", "              NaN", &why), 0);
  assert_true(strstr(why.at, "nan 16"));
  assert_int_equal(with_change(&b, "4.0000000000E+000", "4.0000x00000E+000", &why), -1);
  assert_string_equal(why.at, FOLDER "/b.run:16: no number in one of the columns");
  assert_int_equal(with_change(&b, "PT  TY  LAB", "PX  TY  LAB", &why), -1);
  assert_string_equal(why.at, FOLDER "/b.run:13: a point before the names of the columns");
  assert_int_equal(with_change(&b, "\n   1     4", "\n  x1     4", &why), -1);
  assert_string_equal(why.at, FOLDER "/b.run:16: neither a point nor a line of the head");
  assert_int_equal(with_change(&b, "\n   1     4   0    0", "\n   1     4 500    0", &why), -1);
  memset(strstr(b.at, "\n   1     4"), 0, 60); /* a block of zeros */
  put(b_file, &b);
  text_clear(&why);
  assert_int_equal(af_read(&all, b_file, NULL, &why), -1);
  assert_string_equal(why.at, FOLDER "/b.run:15: a zero byte");
  text_free(&b);
  text_free(&d);
  text_free(&line);
  text_free(&why);
}

static void files_that_are_none(void **state)
{
  struct text why = TEXT_NONE;
  struct af_solutions solutions;
  struct af_branches all;

  (void)state;
  assert_int_equal(af_read(&all, "build/tests/none", NULL, &why), -1);
  assert_true(is_one_line(&why, "build/tests/none: No such file"));
  text_clear(&why);
  assert_int_equal(af_read(&all, "build/tests", NULL, &why), -1);
  assert_string_equal(why.at, "build/tests: is a folder");
  text_clear(&why);
  assert_int_equal(af_read_solutions(&solutions, "/dev/null", &why), -1);
  assert_string_equal(why.at, "/dev/null: is no regular file");
  text_free(&why);
}

/* --- solutions --------------------------------------------------------------------------- */

static void add_solution(struct text *s, int label, int rows, int states, int parameters)
{
  const int lines = rows * ((states + 7) / 7) + (parameters + 6) / 7;

  text_add(s, "%6d%6d%6d%6d%6d%6d%8d%6d%8d%5d%5d%5d%5d%5d%5d%5d\n", 1, label, 3, label, 1, 1, rows, states + 1, lines, 1, 0, parameters, 0,
           states, 1, 0);
  for (int i = 0; i < rows; i++)
    for (int k = 0; k <= states; k++)
      text_add(s, "%s%19.10E%s", k % 7 == 0 ? "    " : "", i + 0.01 * k, k % 7 == 6 || k == states ? "\n" : "");
  for (int k = 0; k < parameters; k++)
    text_add(s, "%s%19.10E%s", k % 7 == 0 ? "    " : "", 100. + k, k % 7 == 6 || k == parameters - 1 ? "\n" : "");
}

static void solutions_are_read(void **state)
{
  struct text s = TEXT_NONE, why = TEXT_NONE;
  struct af_solutions all;
  double par[36], row[5 * 8];

  (void)state;
  add_solution(&s, 1, 1, 7, 36);
  add_solution(&s, 2, 5, 7, 36);
  put(s_file, &s);
  assert_int_equal(af_read_solutions(&all, s_file, &why), 0);
  assert_int_equal(all.n, 2);
  assert_int_equal(all.solution[1].rows, 5);
  assert_int_equal(all.solution[1].states, 7);
  assert_int_equal(af_solution_parameters(&all, &all.solution[1], par, &why), 0);
  assert_true(par[0] == 100. && par[35] == 135.);
  assert_int_equal(af_solution_rows(&all, &all.solution[1], row, &why), 0);
  assert_true(row[0] == 0. && row[7] == 0.07 && row[39] == 4.07);
  af_free_solutions(&all);
  for (size_t n = s.length; n-- > 1;) { /* cut anywhere */
    struct text cut = TEXT_NONE;

    text_append(&cut, s.at, n);
    put(s_file, &cut);
    text_clear(&why);
    if (af_read_solutions(&all, s_file, &why) == 0) {
      assert_int_equal(all.n, 1); /* behind the first one */
      af_free_solutions(&all);
    } else
      assert_true(is_one_line(&why, s_file));
    text_free(&cut);
  }
  text_free(&s);
  text_free(&why);
}

/* --- what may be said ----------------------------------------------------------------- */

static void the_judge_says_what_was_not_looked_for(void **state)
{
  static const struct { int IPS, ISP, IID, ILP; const char *found; } known[] = {
    { 1, 2, 2, 0, "no special point" }, { 1, 0, 2, 0, "no special point looked for" }, { 2, 2, 2, 1, "no special point" },
    { 2, 2, 2, 0, "no special point (not looked for: LP)" }, { 2, 0, 0, 1, "no special point (not looked for: BP, PD, TR)" },
    { 0, 0, 0, 1, "no special point (not looked for: BP)" },
  };

  (void)state;
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    struct text b = TEXT_NONE;
    struct judgement judgement;
    const struct judged run = { b_file, NULL, NULL, NULL, NULL, NULL, 0, 0 };

    add_head(&b, known[i].IPS, known[i].ISP, known[i].IID, known[i].ILP, 3, "");
    for (int k = 1; k <= 3; k++)
      add_point(&b, 1, k, k == 3 ? -4 : 0, k == 3, 3, k);
    put(b_file, &b);
    judge_run(&run, &judgement);
    assert_string_equal(judgement.found.at, known[i].found);
    assert_string_equal(judgement.complaints.at, "");
    judgement_free(&judgement);
    text_free(&b);
  }
}

static void no_stability_where_AUTO_computed_none(void **state)
{
  struct text b = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;

  (void)state;
  add_head(&b, 1, 0, 2, 0, 3, "");
  add_point(&b, 1, 1, 0, 0, 3, 1.);
  assert_int_equal(read_back(&all, &b, NULL, &why), 0);
  assert_int_equal(point_stability(&all, &all.part[0], 0), -1);
  af_free(&all);
  text_free(&b);
}

/* Multipliers of a branch of orbits whose largest is `mu` at each point. */
static void add_multipliers(struct text *d, long number, double mu)
{
  text_add(d, "\n   1%6ld         Multipliers:     Stable:%4d\n", number, mu <= 1.00001 ? 3 : 2);
  text_add(d, "   1%6ld         Multiplier  1 %14.5E%14.5E  Abs. Val.%14.5E\n", number, 1., 0., 1.);
  text_add(d, "   1%6ld         Multiplier  2 %14.5E%14.5E  Abs. Val.%14.5E\n", number, mu, 0., mu);
  text_add(d, "   1%6ld         Multiplier  3 %14.5E%14.5E  Abs. Val.%14.5E\n", number, 0.5, 0., 0.5);
}

/* A branch that begins unstable, with a multiplier that AUTO's tolerance takes for
 * stable, and is stable behind its fold. */
static void stability_near_1_is_told_by_the_branch(void **state)
{
  static const double mu[] = { 1.000004, 1.000008, 1.00004, 1.00004, 1.000002, 1., 0.999998, 0.9999, 0.999 };
  static const double V[] = { 1., 2., 3., 4., 5., 5.1, 5., 4., 3. };
  static const int stable[] = { 0, 0, 0, 0, 0, -1, 1, 1, 1 };
  struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE;
  struct af_branches all;

  (void)state;
  add_head(&b, 2, 2, 2, 1, 3, "");
  for (int i = 0; i < 9; i++) {
    add_point(&b, 1, mu[i] <= 1.00001 ? -(i + 1) : i + 1, i == 5 ? 5 : 0, i == 5, 3, V[i]);
    add_multipliers(&d, i + 1, mu[i]);
  }
  assert_int_equal(read_back(&all, &b, &d, &why), 0);
  for (int i = 0; i < 9; i++)
    assert_int_equal(point_stability(&all, &all.part[0], i), stable[i]);
  af_free(&all);
  text_free(&b);
  text_free(&d);
}

/* Orbits that are born unstable: AUTO counts them stable until their multiplier has left 1
 * by its tolerance, which is no bifurcation stepped over; one beyond clear orbits is. */
static void a_count_within_tolerance_is_no_change(void **state)
{
  static const double born[] = { 1.000001, 1.000004, 1.00002, 1.00008 }, stepped_over[] = { 0.9, 0.99, 1.000004, 1.01 };

  (void)state;
  for (int missed = 0; missed < 2; missed++) {
    struct text b = TEXT_NONE, d = TEXT_NONE, why = TEXT_NONE;
    struct judgement out = { .found = TEXT_NONE, .complaints = TEXT_NONE, .damage = TEXT_NONE };
    struct af_branches all;

    add_head(&b, 2, 2, 2, 1, 3, "");
    for (int i = 0; i < 4; i++) {
      const double mu = missed ? stepped_over[i] : born[i];

      add_point(&b, 1, i + 1, 0, 0, 3, 1. + i);
      add_multipliers(&d, i + 1, mu);
    }
    assert_int_equal(read_back(&all, &b, &d, &why), 0);
    check_stability(&all, &out, &all.part[0], 4);
    assert_int_equal(out.complaints.length > 0, missed);
    if (missed)
      assert_non_null(strstr(out.complaints.at, "3 stable multipliers become 2 without a label between"));
    judgement_free(&out);
    af_free(&all);
    text_free(&b);
    text_free(&d);
  }
}

static void expected_words(void **state)
{
  char *good[] = { "HB=4", "closed=1", "EP=0" }, *unknown[] = { "XX=0" }, *large[] = { "HB=99999999999" }, *twice[] = { "HB=1", "HB=2" };
  struct text why = TEXT_NONE;

  (void)state;
  assert_int_equal(check_expectations(good, 3, &why), 0);
  assert_int_equal(check_expectations(unknown, 1, &why), -1);
  assert_int_equal(check_expectations(large, 1, &why), -1);
  assert_int_equal(check_expectations(twice, 2, &why), -1);
  text_free(&why);
}

static void names_of_runs(void **state)
{
  static const char *const good[] = { "a", "fig06.a.psi", "k7.86e5", "1e+5", "A_b-c" };
  static const char *const bad[] = { "", ".a", "-a", "a/b", "../x", "a b", "a'b", "a\nb", "a=b", "\xc3\xa4", "+a" };
  char longest[102];

  (void)state;
  for (size_t i = 0; i < sizeof good / sizeof *good; i++)
    assert_true(is_name(good[i]));
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    assert_false(is_name(bad[i]));
  memset(longest, 'a', 101);
  longest[101] = '\0';
  assert_false(is_name(longest));
  assert_true(is_name(longest + 1));
}

/* --- random changes --------------------------------------------------------------- */

/* Changes a text at random: bytes, lines out, lines twice, an end cut off. */
static void change(struct text *text)
{
  static const char odd[] = "0123456789.+-E \nNx\t'{}";

  for (int n = 1 + (int)uniform(0., 4.); n > 0 && text->length > 2; n--) {
    const size_t at = (size_t)uniform(0., (double)text->length - 1.);
    const size_t length = (size_t)uniform(0., 80.) < text->length - at ? (size_t)uniform(0., 80.) : 0;

    switch ((int)uniform(0., 5.)) {
    case 0:
      text->at[at] = odd[(size_t)uniform(0., sizeof odd - 1.)];
      break;
    case 1:
      text->at[at] = (char)(int)uniform(0., 256.);
      break;
    case 2:
      if (at + length <= text->length) {
        memmove(text->at + at, text->at + at + length, text->length - at - length);
        text->length -= length;
      }
      break;
    case 3:
      if (at + 2 * length <= text->length)
        memcpy(text->at + at + length, text->at + at, length);
      break;
    default:
      if (uniform(0., 1.) < 0.2)
        text->length = at;
    }
    text->at[text->length] = '\0';
  }
}

static void any_change_is_read_or_refused(void **state)
{
  const char *given = getenv("FUZZ"), *seed = getenv("SEED");
  const long n = given ? strtol(given, NULL, 10) : 3000;
  struct text file[3] = { TEXT_NONE, TEXT_NONE, TEXT_NONE };

  (void)state;
  for (long i = seed ? strtol(seed, NULL, 10) : 0; i > 0; i--)
    uniform(0., 1.);
  good_run(&file[0], &file[1], 12);
  add_solution(&file[2], 1, 1, 7, 36);
  add_solution(&file[2], 12, 5, 7, 36);
  for (long i = 0; i < n; i++) {
    static const char *const name[3] = { b_file, d_file, s_file };
    const struct judged run = { b_file, s_file, d_file, NULL, "l1", NULL, 0, 0 };
    struct judgement judgement;
    struct text why = TEXT_NONE;
    struct af_solutions solutions;

    for (int k = 0; k < 3; k++) {
      struct text changed = TEXT_NONE;

      text_append(&changed, file[k].at, file[k].length);
      if (uniform(0., 3.) < 2.)
        change(&changed);
      put(name[k], &changed);
      text_free(&changed);
    }
    judge_run(&run, &judgement);
    assert_true(judgement.found.length + judgement.complaints.length > 0);
    assert_null(strchr(judgement.complaints.at, '\n'));
    judgement_free(&judgement);
    if (af_read_solutions(&solutions, s_file, &why) == 0) {
      for (int k = 0; k < solutions.n; k++) {
        const struct af_solution *one = &solutions.solution[k];

        if (one->rows * one->row_length < 100000) {
          double *value = malloc((size_t)(one->rows * one->row_length + one->parameters + 1) * sizeof *value);

          assert_non_null(value);
          af_solution_rows(&solutions, one, value, &why);
          af_solution_parameters(&solutions, one, value, &why);
          free(value);
        }
      }
      af_free_solutions(&solutions);
    } else
      assert_true(is_one_line(&why, s_file));
    text_free(&why);
  }
  for (int k = 0; k < 3; k++)
    text_free(&file[k]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(numbers_in_every_writing),
    cmocka_unit_test(sums_are_xxh64),
    cmocka_unit_test(a_run_is_read),
    cmocka_unit_test(numbers_of_points_count_on),
    cmocka_unit_test(several_runs_in_a_file),
    cmocka_unit_test(fields_that_touch),
    cmocka_unit_test(types_have_AUTOs_names),
    cmocka_unit_test(a_file_cut_anywhere_is_refused),
    cmocka_unit_test(damage_is_noticed),
    cmocka_unit_test(files_that_are_none),
    cmocka_unit_test(solutions_are_read),
    cmocka_unit_test(the_judge_says_what_was_not_looked_for),
    cmocka_unit_test(no_stability_where_AUTO_computed_none),
    cmocka_unit_test(stability_near_1_is_told_by_the_branch),
    cmocka_unit_test(a_count_within_tolerance_is_no_change),
    cmocka_unit_test(expected_words),
    cmocka_unit_test(names_of_runs),
    cmocka_unit_test(any_change_is_read_or_refused),
  };

  return cmocka_run_group_tests(tests, NULL, NULL);
}
