/* hopf_along.c - Hopf points of straight rolling along any one parameter
 *
 * Along V and c_d they are the roots of one polynomial (crossing.h).  Along another parameter
 * they are looked for between two values at which the complex eigenvalues are known: where
 * these agree in number, and no real part changes by half of its distance to 0, nothing
 * happens between them; else in halves.  So they are where a law of joints or damper is on,
 * along any parameter: its slope at rest, rounded or within a gap, is differenced, and good
 * to 1e-7.
 */
#include <stdlib.h>
#include <string.h>

#include "layout.h"

enum { MOST = LIBMLG_MOST_STATES, NODES = 200 };

/* The complex pairs at one value: those above the axis by falling frequency. */
struct node { double x, re[MOST], im[MOST]; int pairs, growing; };

struct search {
  int layout, parameter, n, most, laws;
  double par[LIBMLG_MOST_PARAMETERS], tolerance;
  double *at;
};

/* With the laws as they are at rest, which libmlg_eigenvalues() leaves out. */
static int spectrum_with_laws(const struct search *s, double re[], double im[], int *n)
{
  double slots[MLG_SLOTS];

  libmlg_slots(s->par, slots);
  *n = libmlg_spectrum(libmlg_find(s->layout), slots, re, im);
  return *n < 0 ? *n : 0;
}

static int look(struct search *s, double x, struct node *node)
{
  double re[MOST], im[MOST];
  int n, status;

  s->par[s->parameter] = x;
  status = s->laws ? spectrum_with_laws(s, re, im, &n) : libmlg_eigenvalues(s->layout, s->par, re, im, &n);
  *node = (struct node){ .x = x };
  for (int i = 0; i < n && status == 0; i++) {
    int k = node->pairs;

    if (im[i] <= 0.)
      continue;
    for (; k > 0 && node->im[k - 1] < im[i]; k--)
      node->re[k] = node->re[k - 1], node->im[k] = node->im[k - 1];
    node->re[k] = re[i], node->im[k] = im[i];
    node->pairs++;
    node->growing += re[i] > 0.;
  }
  return status;
}

static int nothing_between(const struct node *a, const struct node *b)
{
  if (a->pairs != b->pairs || a->growing != b->growing)
    return 0;
  for (int i = 0; i < a->pairs; i++)
    if (fabs(a->re[i] - b->re[i]) > 0.5 * fmin(fabs(a->re[i]), fabs(b->re[i])))
      return 0;
  return 1;
}

/* A law that sets in at once, as a gap does at g_psi = 0, lets real parts jump over 0: how many
 * pairs are on the axis indeed. */
static int on_axis(const struct node *node)
{
  int n = 0;

  for (int i = 0; i < node->pairs; i++)
    n += fabs(node->re[i]) < 1e-5 * node->im[i];
  return n;
}

static int between(struct search *s, const struct node *a, const struct node *b)
{
  struct node middle;
  int status;

  if (nothing_between(a, b))
    return 0;
  if (fabs(b->x - a->x) <= s->tolerance) {
    /* where their number changes a pair meets on the real axis, or leaves it: no Hopf point */
    const int changes = a->pairs == b->pairs ? abs(b->growing - a->growing) : 0;

    for (int k = s->laws && on_axis(a) < changes ? 0 : changes; k > 0; k--, s->n++)
      if (s->n < s->most)
        s->at[s->n] = 0.5 * (a->x + b->x);
    return 0;
  }
  status = look(s, 0.5 * (a->x + b->x), &middle);
  if (status == 0)
    status = between(s, a, &middle);
  return status == 0 ? between(s, &middle, b) : status;
}

/* From the exact ones. */
static int along_axis(const double par[], int layout, int along_V, double lo, double hi, double at[], int most)
{
  struct libmlg_point point[LIBMLG_MOST_POINTS];
  int kept = 0;
  const int n = along_V ? libmlg_hopf_at_c_d(layout, par, 0., lo, hi, point, LIBMLG_MOST_POINTS)
                        : libmlg_hopf_at_V(layout, par, 0., point, LIBMLG_MOST_POINTS);

  for (int i = 0; i < n && i < LIBMLG_MOST_POINTS; i++) {
    const double x = along_V ? point[i].V : point[i].c_d;

    if (x > lo && x < hi && kept++ < most)
      at[kept - 1] = x;
  }
  return n < 0 ? n : kept;
}

/* Whether the parameter switches a law on. */
static int parameter_is_law(int parameter)
{
  double par[LIBMLG_MOST_PARAMETERS], slots[MLG_SLOTS];

  libmlg_defaults(par);
  par[parameter] = 0.5 * libmlg_most(parameter);
  libmlg_slots(par, slots);
  return mlg_has_laws(slots);
}

int libmlg_hopf_along(int layout, const double par[], int parameter, double from, double to, double at[], int most)
{
  struct search s = { .layout = layout, .parameter = parameter, .most = most, .at = at };
  const double lo = fmin(from, to), hi = fmax(from, to);
  const int in_ratio = lo > 0. && hi > 10. * lo;
  double slots[MLG_SLOTS];
  struct node a, b;
  int status;

  if (!libmlg_find(layout) || parameter < 0 || parameter >= libmlg_parameters())
    return LIBMLG_NONE;
  if (!(lo < hi))
    return 0;
  libmlg_slots(par, slots);
  s.laws = mlg_has_laws(slots) || parameter_is_law(parameter);
  if (!s.laws && parameter == libmlg_parameter("V") && lo >= 0.)
    return along_axis(par, layout, 1, lo, hi, at, most);
  if (!s.laws && parameter == libmlg_parameter("c_d") && lo >= 0.)
    return along_axis(par, layout, 0, lo, hi, at, most);
  memcpy(s.par, par, (size_t)libmlg_parameters() * sizeof *par);
  status = look(&s, lo, &a);
  for (int i = 1; i <= NODES && status == 0; i++) {
    const double t = (double)i / NODES, x = i == NODES ? hi : in_ratio ? lo * pow(hi / lo, t) : lo + t * (hi - lo);

    s.tolerance = (s.laws ? 1e-8 : 1e-11) * fmax(fabs(x), x - a.x);
    status = look(&s, x, &b);
    if (status == 0)
      status = between(&s, &a, &b);
    a = b;
  }
  return status == 0 ? s.n : status;
}
