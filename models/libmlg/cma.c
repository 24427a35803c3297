/* cma.c - see cma.h; names are those of the tutorial */
#include "cma.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

double cma_uniform(struct cma_random *r)
{
  unsigned long long z = (r->state += 0x9e3779b97f4a7c15ULL); /* Steele, Lea and Flood's splitmix64 */

  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return ((double)((z ^ (z >> 31)) >> 11) + 0.5) / 9007199254740992.;
}

double cma_normal(struct cma_random *r)
{
  const double radius = sqrt(-2. * log(cma_uniform(r)));

  return radius * cos(6.283185307179586 * cma_uniform(r));
}

/* Back into 0 to 1, as by mirrors. */
static double reflected(double x)
{
  x = fabs(fmod(x, 2.));
  return x > 1. ? 2. - x : x;
}

enum { N = CMA_MOST, MOST_LAMBDA = 4 * CMA_MOST };

struct offspring { double value, y[N]; };

static int by_value(const void *a, const void *b)
{
  const double x = ((const struct offspring *)a)->value, y = ((const struct offspring *)b)->value;

  return (x < y) - (x > y); /* the largest first */
}

struct strategy {
  int n, lambda, mu;
  double weight[MOST_LAMBDA], mu_eff, c_c, c_sigma, c_1, c_mu, d_sigma, chi_n;
  double mean[N], sigma, p_c[N], p_sigma[N], C[N * N], B[N * N], D[N]; /* C = B diag(D^2) B' */
};

static void begin(struct strategy *s, int n, const double x[], double sigma)
{
  double sum = 0., squares = 0.;

  memset(s, 0, sizeof *s);
  s->n = n;
  s->lambda = 4 + (int)(3. * log(n));
  s->mu = s->lambda / 2;
  for (int i = 0; i < s->mu; i++)
    sum += s->weight[i] = log(0.5 * (s->lambda + 1.)) - log(i + 1.);
  for (int i = 0; i < s->mu; i++) {
    s->weight[i] /= sum;
    squares += s->weight[i] * s->weight[i];
  }
  s->mu_eff = 1. / squares;
  s->c_c = (4. + s->mu_eff / n) / (n + 4. + 2. * s->mu_eff / n);
  s->c_sigma = (s->mu_eff + 2.) / (n + s->mu_eff + 5.);
  s->c_1 = 2. / ((n + 1.3) * (n + 1.3) + s->mu_eff);
  s->c_mu = fmin(1. - s->c_1, 2. * (s->mu_eff - 2. + 1. / s->mu_eff) / ((n + 2.) * (n + 2.) + s->mu_eff));
  s->d_sigma = 1. + 2. * fmax(0., sqrt((s->mu_eff - 1.) / (n + 1.)) - 1.) + s->c_sigma;
  s->chi_n = sqrt(n) * (1. - 1. / (4. * n) + 1. / (21. * n * n));
  s->sigma = sigma;
  memcpy(s->mean, x, (size_t)n * sizeof *x);
  for (int i = 0; i < n; i++)
    s->C[i * n + i] = s->B[i * n + i] = s->D[i] = 1.;
}

static int decompose(struct strategy *s)
{
  const int n = s->n;

  for (int i = 0; i < n; i++)
    for (int k = 0; k < i; k++)
      s->C[i * n + k] = s->C[k * n + i];
  memcpy(s->B, s->C, (size_t)(n * n) * sizeof *s->C);
  if (LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', n, s->B, n, s->D) != 0)
    return -1;
  for (int i = 0; i < n; i++)
    s->D[i] = sqrt(fmax(s->D[i], 1e-30));
  return 0;
}

static void update(struct strategy *s, const struct offspring o[], int generation)
{
  const int n = s->n;
  double y_w[N] = { 0. }, along[N], norm = 0.;

  for (int i = 0; i < s->mu; i++)
    for (int k = 0; k < n; k++)
      y_w[k] += s->weight[i] * o[i].y[k];
  for (int k = 0; k < n; k++)
    s->mean[k] = reflected(s->mean[k] + s->sigma * y_w[k]);
  for (int j = 0; j < n; j++) { /* B' y_w / D */
    along[j] = 0.;
    for (int k = 0; k < n; k++)
      along[j] += s->B[j * n + k] * y_w[k];
    along[j] /= s->D[j];
  }
  for (int k = 0; k < n; k++) {
    double white = 0.;

    for (int j = 0; j < n; j++)
      white += s->B[j * n + k] * along[j];
    s->p_sigma[k] = (1. - s->c_sigma) * s->p_sigma[k] + sqrt(s->c_sigma * (2. - s->c_sigma) * s->mu_eff) * white;
    norm += s->p_sigma[k] * s->p_sigma[k];
  }
  norm = sqrt(norm);

  const int h = norm / sqrt(1. - pow(1. - s->c_sigma, 2. * (generation + 1))) < (1.4 + 2. / (n + 1.)) * s->chi_n;
  const double left = 1. - s->c_1 - s->c_mu + (h ? 0. : s->c_1 * s->c_c * (2. - s->c_c));

  for (int k = 0; k < n; k++)
    s->p_c[k] = (1. - s->c_c) * s->p_c[k] + (h ? sqrt(s->c_c * (2. - s->c_c) * s->mu_eff) * y_w[k] : 0.);
  for (int a = 0; a < n; a++)
    for (int b = a; b < n; b++) {
      double C = left * s->C[b * n + a] + s->c_1 * s->p_c[a] * s->p_c[b];

      for (int i = 0; i < s->mu; i++)
        C += s->c_mu * s->weight[i] * o[i].y[a] * o[i].y[b];
      s->C[b * n + a] = C;
    }
  s->sigma *= exp(fmin(1., s->c_sigma / s->d_sigma * (norm / s->chi_n - 1.)));
}

int cma_largest(double f(const double x[], void *context), void *context, int n, double x[], double sigma,
                struct cma_random *random, int most, double enough, double *best)
{
  struct strategy *s = malloc(sizeof *s);
  struct offspring *o = malloc(MOST_LAMBDA * sizeof *o);
  int asked = 1, status = s && o ? 0 : -1;
  double place[N];

  *best = f(x, context);
  if (status == 0)
    begin(s, n, x, sigma);
  for (int generation = 0; status == 0 && asked < most && !(*best > enough); generation++) {
    double longest = 0.;

    for (int i = 0; i < s->lambda && !(*best > enough); i++) {
      double z[N];

      for (int j = 0; j < n; j++)
        z[j] = s->D[j] * cma_normal(random);
      for (int k = 0; k < n; k++) {
        o[i].y[k] = 0.;
        for (int j = 0; j < n; j++)
          o[i].y[k] += s->B[j * n + k] * z[j];
        place[k] = reflected(s->mean[k] + s->sigma * o[i].y[k]);
      }
      o[i].value = f(place, context);
      if (o[i].value > *best) {
        *best = o[i].value;
        memcpy(x, place, (size_t)n * sizeof *x);
      }
    }
    asked += s->lambda;
    if (*best > enough)
      break;
    qsort(o, (size_t)s->lambda, sizeof *o, by_value);
    update(s, o, generation);
    status = decompose(s);
    for (int k = 0; k < n; k++)
      longest = fmax(longest, s->D[k]);
    if (s->sigma * longest < 1e-12)
      break;
  }
  free(s);
  free(o);
  return status == 0 ? asked : -1;
}
