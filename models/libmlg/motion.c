/* motion.c - what an oscillation does in the long term: periodic, a torus, irregular, slow?
 *
 * The run is watched at the maxima of psi, u_0, u_1, ... of its Poincare map, together with
 * a neighbour that is brought back to a small distance each time (Benettin et al., Meccanica
 * 15 (1980) 9-30): the mean growth of that distance is the largest Lyapunov exponent of the
 * map.  Over the time watched the distance of neighbours on a torus stays of its size, near a
 * stable orbit it falls, in irregular motion it grows.  On a torus with two frequencies all
 * lines in the spectrum of the maxima are multiples of one, the rotation number.
 */
#include <math.h>
#include <string.h>

#include "poincare.h"

enum { WATCHED = 400, MOST_MAXIMA = 64, HARMONICS = 6, BINS = 2 };

const char *libmlg_motion_name(enum libmlg_motion_kind kind)
{
  static const char *const name[] = { "periodic", "dies_out", "settling", "quasi_periodic", "irregular", "undecided" };

  return kind >= LIBMLG_PERIODIC && kind <= LIBMLG_UNDECIDED ? name[kind] : NULL;
}

/* What is noted at each maximum. */
struct watch {
  double u[WATCHED][LIBMLG_MOST_STATES], size[WATCHED];
  double growth, grown; /* ln of the growth of the neighbour's distance, and over how many s */
  double time;
  long corners; /* of laws, in the second half */
};

/* The neighbour's distance, brought back to eps from u in the direction of its image. */
static void bring_back(const struct poincare *m, const double u[], const double image[], double eps, double by,
                       double neighbour[])
{
  for (int i = 0; i < m->n; i++)
    neighbour[i] = u[i] + (i == DPSI ? 0. : (image[i] - u[i]) * (eps / by));
}

static int take_watch(const struct poincare *m, struct watch *w)
{
  double u[LIBMLG_MOST_STATES], neighbour[LIBMLG_MOST_STATES], image[LIBMLG_MOST_STATES], time, passed;
  const double eps = 1e-5;

  memcpy(u, m->run->u, sizeof u);
  memcpy(neighbour, u, sizeof u);
  for (int i = 0; i < m->n; i++)
    neighbour[i] += i == DPSI ? 0. : eps * poincare_size(m, u) * m->size[i];
  w->growth = w->grown = w->time = 0.;
  w->corners = 0;
  for (int k = 0; k < WATCHED; k++) {
    if (!poincare_image(m, neighbour, 1, image, &passed) || !poincare_image(m, u, 1, u, &time))
      return 0;
    w->corners += k >= WATCHED / 2 ? m->run->corners : 0;
    w->time += time;
    memcpy(w->u[k], u, sizeof u);
    w->size[k] = poincare_size(m, u);

    const double by = poincare_distance(m, u, image), factor = by / eps;

    /* beyond that the neighbour has a maximum more or less on its way */
    if (by > 0. && factor < 1e3) {
      if (k >= WATCHED / 10)
        w->growth += log(factor), w->grown += time;
      bring_back(m, u, image, eps, by, neighbour);
    } else
      bring_back(m, u, w->u[k > 0 ? k - 1 : 0], eps, poincare_distance(m, u, w->u[k > 0 ? k - 1 : 0]) + 1e-300, neighbour);
  }
  return 1;
}

/* The range of psi at the maxima from one to another. */
static double range_of(const struct watch *w, int from, int to, double *least, double *most)
{
  *least = INFINITY, *most = -INFINITY;
  for (int k = from; k < to; k++) {
    *least = fmin(*least, w->u[k][PSI]);
    *most = fmax(*most, w->u[k][PSI]);
  }
  return *most - *least;
}

/* The least number of maxima after which the second half is back each time; 0: none. */
static int recurrence(const struct poincare *m, const struct watch *w, double nearly)
{
  for (int k = 1; k <= MOST_MAXIMA; k++) {
    double far = 0.;

    for (int i = WATCHED / 2; i + k < WATCHED && far < nearly; i++)
      far = fmax(far, poincare_distance(m, w->u[i], w->u[i + k]));
    if (far < nearly)
      return k;
  }
  return 0;
}

/* The strongest line of psi's maxima in cycles for each, 0: none; *share: how much of their
 * power is in that and its multiples. */
static double strongest_line(const struct watch *w, double *share)
{
  enum { N = WATCHED, HALF = N / 2 };
  double power[HALF + 1], mean = 0., sum = 0., own = 0.;
  int own_bin[HALF + 1] = { 0 }, line = 2;

  for (int k = 0; k < N; k++)
    mean += w->u[k][PSI] / N;
  for (int f = 0; f <= HALF; f++) {
    double re = 0., im = 0.;

    for (int k = 0; k < N; k++) { /* Hann's window */
      const double x = (w->u[k][PSI] - mean) * (1. - cos(2. * MLG_PI * (k + 0.5) / N)), at = 2. * MLG_PI * f * k / N;

      re += x * cos(at);
      im += x * sin(at);
    }
    power[f] = re * re + im * im;
  }
  for (int f = 2; f <= HALF; f++)
    line = power[f] > power[line] ? f : line;
  const double a = sqrt(power[line - 1]), b = sqrt(power[line]), c = line < HALF ? sqrt(power[line + 1]) : 0.;
  const double at = line + (c > a ? 2. - 3. / (1. + c / b) : 3. / (1. + a / b) - 2.); /* of Hann's window, exactly */

  for (int h = 1; h <= HARMONICS; h++) {
    double alias = fmod(h * at, N);

    alias = alias > HALF ? N - alias : alias;
    for (int f = (int)lround(alias) - BINS; f <= (int)lround(alias) + BINS; f++)
      if (f >= 0 && f <= HALF)
        own_bin[f] = 1;
  }
  for (int f = 0; f <= HALF; f++) {
    sum += power[f];
    own += own_bin[f] ? power[f] : 0.;
  }
  *share = sum > 0. ? own / sum : 0.;
  return sum > 0. ? at / N : 0.;
}

/* How large it is in its second and in its last quarter. */
static void sizes(const struct watch *w, double size[2])
{
  size[0] = size[1] = 0.;
  for (int k = 0; k < WATCHED / 4; k++) {
    size[0] = fmax(size[0], w->size[WATCHED / 4 + k]);
    size[1] = fmax(size[1], w->size[3 * WATCHED / 4 + k]);
  }
}

static enum libmlg_motion_kind kind_of(const struct poincare *m, const struct watch *w, double share, double growth)
{
  double least, most, size[2];
  const double before = range_of(w, WATCHED / 4, WATCHED / 2, &least, &most);
  const double range = range_of(w, 3 * WATCHED / 4, WATCHED, &least, &most);

  sizes(w, size);
  if (m->gap > 0. && w->corners == 0 && most < m->gap && size[1] < 1.05 * size[0]) /* within the gap for good */
    return LIBMLG_DIES_OUT;
  if (size[1] < 0.5 * size[0])
    return LIBMLG_SETTLING;
  if (growth > 5.)
    return LIBMLG_IRREGULAR;
  if (growth < -5. || range < 0.8 * before || range > 1.25 * before)
    return LIBMLG_SETTLING;
  return share > 0.95 ? LIBMLG_QUASI_PERIODIC : LIBMLG_UNDECIDED;
}

int poincare_watch(const struct poincare *m, struct libmlg_motion *motion)
{
  struct watch w;
  double share;

  *motion = (struct libmlg_motion){ .kind = LIBMLG_UNDECIDED };
  if (!take_watch(m, &w))
    return 0;
  const double line = strongest_line(&w, &share);

  motion->watched = WATCHED;
  motion->time = w.time;
  range_of(&w, 0, WATCHED, &motion->psi_least, &motion->psi_most);
  motion->frequency_hz = WATCHED / w.time;
  motion->modulation_hz = line * motion->frequency_hz;
  motion->exponent = w.grown > 0. ? w.growth / w.grown : 0.;
  motion->maxima = recurrence(m, &w, 1e-2);
  motion->kind = recurrence(m, &w, 1e-6) ? LIBMLG_PERIODIC : kind_of(m, &w, share, motion->exponent * w.time);
  memcpy(motion->u, w.u[WATCHED - 1], sizeof motion->u);
  return 1;
}
