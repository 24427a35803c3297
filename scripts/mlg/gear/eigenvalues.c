/* eigenvalues.c - the eigenvalues of straight rolling at one set of parameters */
#include <stdio.h>

#include "arguments.h"
#include "command.h"

static int run(int argc, char *argv[])
{
  double re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES];
  struct arguments a;
  int n;

  read_arguments(&a, argc, argv, NULL);
  if (libmlg_eigenvalues(a.layout, a.par, re, im, &n) != 0)
    fail(argv[0], MLG_FAILED, "no eigenvalues: the Jacobian is not finite");
  printf("real_part,imaginary_part,frequency_hz\n");
  for (int i = 0; i < n; i++)
    printf("%.16e,%.16e,%.12g\n", re[i], im[i], im[i] / (2. * MLG_PI));
  return output_status(argv[0]);
}

const struct command command_eigenvalues = {
  .name = "eigenvalues",
  .usage = "LAYOUT [NAME=VALUE ...]",
  .summary = "eigenvalues of straight rolling",
  .details =
    "Prints CSV, a row for each eigenvalue of the linearised equations, by falling real part:\n"
    "  real_part, imaginary_part  1/s\n"
    "  frequency_hz               Hz\n",
  .run = run,
};
