/* gears.h - random gears, each reproducible from a seed and a number
 *
 * Case k of a seed does not hang on the cases before it: splitmix64 starts at a hash of
 * both.  Every parameter of oracle.h is drawn as said in gears.c.
 */
#ifndef GEARS_H
#define GEARS_H

#include <stdint.h>

#include "oracle.h"

/* splitmix64 (public domain, S. Vigna) */
struct stream { uint64_t state; };

double stream_next(struct stream *stream);                        /* in [0, 1) */
double stream_between(struct stream *stream, double lo, double hi);

/* A gear like the paper's, its parameters each times 2^(-spread..spread). */
struct oracle_gear random_gear(uint64_t seed, int number, double spread);

/* Its doubts: those of the choices that are bits of kinds (1 zB_shared, 2 R_moves, 4 heading,
 * 8 I_p) each between 0 and 1 or, of a third of the gears, 1; I_p up to 20 kg m^2. */
void random_doubts(struct oracle_gear *gear, uint64_t seed, int number, int kinds);

/* The paper's gear with its k_s (0: rigid) and b, in other units: the factors of force, time
 * and length are each 1e-4 to 1e4.  *c_unit is what c_d is multiplied by. */
struct oracle_gear gear_in_units(uint64_t seed, int number, double k_s, double b, double *c_unit);

/* A row of parameters, comma-separated, with the names oracle.h gives them. */
void print_gear_names(void);
void print_gear(const struct oracle_gear *gear);

/* Options NAME=VALUE of a command line. */
struct options {
  int cases, first;      /* N; case=K alone, or first=K: N from there */
  uint64_t seed;
  double spread;
  int layout;            /* or -1: all */
  int doubts;            /* kinds of random_doubts() */
};

/* The layout of that name, of an argument; a wrong one is one line on stderr and status 2. */
int read_layout(const char *argument, const char *name);

/* Reads N and options; a wrong one is one line on stderr and status 2. */
struct options read_options(int n, char **argument, int cases);

/* Reads one gear from a CSV line of values in the order of print_gear_names(); *rest is what
 * follows.  false: not so many numbers. */
bool read_gear(const char *text, struct oracle_gear *gear, const char **rest);

#endif
