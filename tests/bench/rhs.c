/* rhs - the time of one right-hand side of a layout
 *
 *   rhs-LAYOUT [CALLS]
 *
 * Prints nanoseconds a call, over 256 states of the size that shimmy has.  For
 * instructions a call, which do not hang on the load of the machine:
 *   valgrind --tool=callgrind --toggle-collect='timed*' rhs-LAYOUT 10000
 * Built with -DLAYOUT='"l1.c"'.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define MLG_NO_AUTO
#include LAYOUT

enum { STATES = 256 };

/* du[NDIM] of u[NDIM]; one function of its own, so that callgrind finds it. */
__attribute__((noinline, noclone)) static void timed(const double par[], const double u[], double du[])
{
  right_hand_side(par, u, du);
}

static double seconds(void)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(int argc, char **argv)
{
  const long calls = argc > 1 ? atol(argv[1]) : 2000000;
  double par[MLG_SLOTS], u[STATES][NDIM], du[NDIM], sum = 0.;

  if (calls <= 0) {
    fprintf(stderr, "rhs: CALLS = %s is not above 0\n", argv[1]);
    return 2;
  }
  mlg_defaults(par);
  par[PAR_V] = 30.;
  par[PAR_K_S] = 6e5;
  par[PAR_B] = 100.;
  srand(1);
  for (int k = 0; k < STATES; k++)
    for (int i = 0; i < NDIM; i++) {
      const double size = i == DDELTA || i == DPSI ? 2. : i == LAMBDA_L || i == LAMBDA_R ? 0.02 : 0.05;

      u[k][i] = size * (2. * rand() / RAND_MAX - 1.);
    }
  const double start = seconds();

  for (long k = 0; k < calls; k++) {
    timed(par, u[k % STATES], du);
    sum += du[DDELTA];
  }
  printf("%.1f ns\n", 1e9 * (seconds() - start) / (double)calls);
  return !(sum < 0. || sum >= 0.); /* the sum has to be computed, and to be a number */
}
