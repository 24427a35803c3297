/* telling.c - the values of c_d at which a diagram in V tells most about a gear */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "names.h"
#include "plane.h"

/* Between neighbouring boundary points nothing changes but the speeds. */
struct band { double lo, hi, c_d; int hopf; };

enum { MOST_BANDS = LIBMLG_MOST_POINTS + 1 };

/* The middle of a band by ratio; of an unbounded one 1.2 times off its bound. */
static double middle(double lo, double hi, double scale)
{
  if (!(lo > 0.))
    return isinf(hi) ? scale : hi / 1.2;
  return isinf(hi) ? 1.2 * lo : sqrt(lo * hi);
}

static int hopf_points(struct arguments *a, double c_d)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];

  a->par[NUMBER_C_D] = c_d;
  return checked(a->command, libmlg_hopf_at_c_d(a->layout, a->par, 0., 0., a->V_top, point, LIBMLG_MOST_POINTS));
}

static int bands_of(struct arguments *a, struct band band[MOST_BANDS])
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  const int n = checked(a->command, libmlg_boundary_points(a->layout, a->par, 0., 0., a->V_top, point, LIBMLG_MOST_POINTS));
  int bands = 0;

  for (int i = 0; i <= n; i++) {
    struct band *b = &band[bands];

    b->lo = i > 0 ? point[i - 1].c_d : 0.;
    b->hi = i < n ? point[i].c_d : INFINITY;
    if (!(b->hi > b->lo * (1. + 1e-9)))
      continue;
    b->c_d = middle(b->lo, b->hi, scale_of_c_d(a));
    b->hopf = hopf_points(a, b->c_d);
    bands++;
  }
  return bands;
}

/* Another c_d of the band. */
static void move_to(struct arguments *a, struct band *b, double c_d)
{
  b->c_d = c_d;
  b->hopf = hopf_points(a, c_d);
}

static int chosen[MOST_BANDS];

static void choose(const struct band band[], int i, const char *which)
{
  if (!chosen[i])
    printf("%s,%.6g,%d\n", which, band[i].c_d, band[i].hopf);
  chosen[i] = 1;
}

/* The band with most Hopf points within two decades of the device's scale. */
static int busiest(const struct band band[], int bands, double scale)
{
  int best = -1;

  for (int i = 0; i < bands; i++)
    if (band[i].c_d > scale / 100. && band[i].c_d < scale * 100. && (best < 0 || band[i].hopf > band[best].hopf))
      best = i;
  return best < 0 ? 0 : best;
}

/* Without an interval: from soft to hard, where they show something. */
static void choose_without(const struct band band[], int bands, double scale)
{
  choose(band, 0, "low");
  choose(band, busiest(band, bands, scale), "overlap");
  choose(band, bands - 1, "high");
}

/* The next band that way which is not a sliver, of less than 5 % of c_d; else that beside it. */
static int beside(const struct band band[], int bands, int i, int way)
{
  for (int k = i + way; k >= 0 && k < bands; k += way)
    if (!(band[k].lo > 0.) || band[k].hi > 1.05 * band[k].lo)
      return k;
  return i + way;
}

static void choose_about(struct arguments *a, struct band band[], int bands, const struct libmlg_interval *z)
{
  int first = 0, last, below, above, busy = busiest(band, bands, scale_of_c_d(a));

  while (first + 1 < bands && band[first].hi <= z->lo.c_d * (1. + 1e-9))
    first++;
  last = first;
  while (last + 1 < bands && band[last].hi < z->hi.c_d * (1. - 1e-9))
    last++;
  below = beside(band, bands, first, -1);
  above = beside(band, bands, last, 1);
  if (below >= 0) {
    if (busy != below || band[busy].hopf < 4)
      move_to(a, &band[below], fmax(band[below].c_d, z->lo.c_d / 2.));
    choose(band, below, "below");
  }
  choose(band, first, "inside");
  if (above < bands) {
    if (busy != above || band[busy].hopf < 4)
      move_to(a, &band[above], fmin(band[above].c_d, z->hi.c_d * 2.));
    choose(band, above, "above");
  }
  if (band[busy].hopf >= 4 && band[busy].c_d > scale_of_c_d(a) / 100.)
    choose(band, busy, "overlap");
}

static int run(int argc, char *argv[])
{
  struct libmlg_interval interval[LIBMLG_MOST_POINTS], *widest = interval;
  struct band band[MOST_BANDS];
  struct arguments a;

  read_arguments(&a, argc, argv, NULL);
  refuse_given(&a, NUMBER_V, "a diagram in V is asked for");
  refuse_given(&a, NUMBER_C_D, "values of c_d are asked for");
  printf("which,c_d,hopf_points\n");
  if (libmlg_diverges(a.layout, a.par))
    return output_status(argv[0]);
  const int bands = bands_of(&a, band);
  const int n = checked(argv[0], libmlg_intervals(a.layout, a.par, 0., 0., a.V_top, interval, LIBMLG_MOST_POINTS));

  for (int i = 1; i < n; i++)
    if (interval[i].hi.c_d - interval[i].lo.c_d > widest->hi.c_d - widest->lo.c_d)
      widest = &interval[i];
  if (n > 0)
    choose_about(&a, band, bands, widest);
  else
    choose_without(band, bands, scale_of_c_d(&a));
  return output_status(argv[0]);
}

const struct command command_telling = {
  .name = "telling",
  .usage = "LAYOUT [NAME=VALUE ...]",
  .summary = "values of c_d at which a diagram in V tells most",
  .details =
    "The boundary points divide c_d into bands in which the Hopf points stay the same in number.\n"
    "Of a band the middle by ratio is taken; of an unbounded one 1.2 times off its bound.  About\n"
    "the widest zero-shimmy interval:\n"
    "  below, inside, above   the bands beside it that span 5 % or more, at most twice off it,\n"
    "                         and the interval\n"
    "  overlap                the band with most Hopf points within two decades of\n"
    "                         k_d sqrt(J_zeta/k_psi), where that is another one and has four\n"
    "                         or more\n"
    "Without an interval: low, overlap, high, the first band, that with most Hopf points and the\n"
    "last.  None for a gear that diverges.  CSV: which; c_d, N m s/rad; hopf_points there.\n",
  .run = run,
};
