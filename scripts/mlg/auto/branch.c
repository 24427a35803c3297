/* branch.c - what may be said of the points of a branch; see branch.h */
#include "branch.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

int is_orbits(const struct af_part *p)
{
  return p->constants.IPS == 2 && p->constants.ISW == 1;
}

int is_straight(const struct af_part *p)
{
  return p->constants.IPS == 1 && p->constants.ISW == 1;
}

int is_curve(const struct af_part *p)
{
  return abs(p->constants.ISW) == 2;
}

const char *point_type(const struct af_branches *all, const struct af_part *part, long point)
{
  const struct af_point *p = &part->point[point];
  const char *name = af_type_name(p->type);
  int on_axis = 0;

  if (strcmp(name, "ZH") != 0)
    return name;
  for (int k = 0; k < p->eigenvalues; k++) {
    const double re = all->eigenvalue[p->eigenvalue + 2 * (size_t)k], im = all->eigenvalue[p->eigenvalue + 2 * (size_t)k + 1];

    on_axis += im != 0. && re * re < 1e-8 * im * im;
  }
  return on_axis == 4 ? "HH" : name;
}

/* AUTO takes a multiplier up to 1 + 1e-5 for stable, and d. has six digits. */
static const double tolerance = 1.5e-5;

/* The multipliers of an orbit but the trivial one, which is the nearest to 1: how many lie
 * outside the unit circle, how many of these are real and above 1, how many cannot be
 * told, and whether a single one that cannot is real and near 1. */
struct multipliers { int outside, above_1, near, near_1; };

static struct multipliers multipliers(const struct af_branches *all, const struct af_point *p)
{
  struct multipliers m = { 0, 0, 0, 0 };
  double nearest = INFINITY;
  int trivial = 0;

  for (int k = 0; k < p->eigenvalues; k++) {
    const double *mu = &all->eigenvalue[p->eigenvalue + 2 * (size_t)k];
    const double distance = hypot(mu[0] - 1., mu[1]);

    if (distance < nearest)
      nearest = distance, trivial = k;
  }
  for (int k = 0; k < p->eigenvalues; k++) {
    const double *mu = &all->eigenvalue[p->eigenvalue + 2 * (size_t)k];
    const double beyond = hypot(mu[0], mu[1]) - 1.;

    if (k == trivial)
      continue;
    if (beyond > tolerance) {
      m.outside++;
      m.above_1 += mu[1] == 0. && mu[0] > 0.;
    } else if (beyond >= -tolerance) {
      m.near++;
      m.near_1 += fabs(mu[1]) < tolerance && mu[0] > 0.;
    }
  }
  return m;
}

int multipliers_are_clear(const struct af_branches *all, const struct af_point *p)
{
  return p->eigenvalues > 1 && multipliers(all, p).near == 0;
}

/* Whether the parameter has an extremum at a point, or that is labelled as one where a
 * real multiplier passes 1.  Where the orbit is smallest too there is no fold: the
 * branch has passed a Hopf point and comes back over the same orbits. */
static int passes_1(const struct af_part *part, long i)
{
  const char *type = af_type_name(part->point[i].type);
  const int size = size_column(part);

  if (strcmp(type, "LP") == 0 || strcmp(type, "BP") == 0)
    return 1;
  if (i == 0 || i + 1 == part->points
      || (af_value(part, i + 1, 0) - af_value(part, i, 0)) * (af_value(part, i, 0) - af_value(part, i - 1, 0)) > 0.)
    return 0;
  return !(af_value(part, i, size) < af_value(part, i - 1, size) && af_value(part, i, size) < af_value(part, i + 1, size));
}

/* On a branch of orbits a real multiplier passes 1 at folds and branch points only.  So
 * one that lies too near to 1 to be told is on the side that the next points tell: where
 * all multipliers are clear, the number of those above 1 is even or odd as here.
 * Returns 1 inside, 0 outside, -1 not known. */
static int side_of_1(const struct af_branches *all, const struct af_part *part, long point, int above_1)
{
  if (passes_1(part, point))
    return -1;
  for (int way = -1; way <= 1; way += 2)
    for (long i = point + way; i >= 0 && i < part->points && !passes_1(part, i); i += way) {
      const struct multipliers m = multipliers(all, &part->point[i]);

      if (part->point[i].eigenvalues > 1 && m.near == 0)
        return (m.above_1 - above_1) % 2 == 0;
    }
  return -1;
}

int point_stability(const struct af_branches *all, const struct af_part *part, long point)
{
  const struct af_point *p = &part->point[point];
  struct multipliers m;

  if (is_curve(part) || part->constants.IPS == 0 || part->constants.ISP == 0)
    return -1;
  if (part->constants.IID > 0 && all->has_d && p->stable_count < 0)
    return -1;
  if (!is_orbits(part))
    return p->stable;
  if (p->eigenvalues < 2) /* AUTO's sign alone, which takes multipliers beside 1 for stable */
    return -1;
  m = multipliers(all, p);
  if (m.outside > 0 || m.near == 0)
    return m.outside == 0;
  if (m.near == 1 && m.near_1 == 1)
    return side_of_1(all, part, point, m.above_1);
  if (m.near == 2 && m.near_1 == 0) { /* a complex pair, of which pvls may know more digits: the largest |mu| - 1 */
    const double torus = af_value(part, point, af_column(part, "torus"));

    return fabs(torus) > 1e-7 && fabs(torus) < tolerance * 2. ? torus < 0. : -1;
  }
  return -1;
}

int looks_for(const struct af_constants *c, const char *type)
{
  const int equilibria = c->IPS == -1 || c->IPS == 1 || c->IPS == 11, orbits = c->IPS == 2 || c->IPS == 7 || c->IPS == 12;
  int looks = 1;

  if (strcmp(type, "LP") == 0)
    looks = c->ILP != 0;
  else if (strcmp(type, "BP") == 0)
    looks = c->IPS < 2 || c->IPS == 5 || c->IPS == 11 ? c->ISP != 0 : abs(c->ISP) >= 2 && abs(c->ISP) != 4;
  else if (strcmp(type, "PD") == 0 || strcmp(type, "TR") == 0 || (type[0] == 'R' && isdigit((unsigned char)type[1])))
    looks = c->IPS == -1 ? c->ISP != 0 : (c->ISP == 2 || c->ISP == 4) && orbits;
  else if (strcmp(type, "UZ") != 0)
    looks = equilibria && c->ISP != 0 && c->ISP != 3;
  for (const char *t = c->SP; (t = strchr(t, '\'')); t++) { /* SP=['TR0', 'LP'] */
    if (strncmp(t + 1, type, strlen(type)) != 0 || isalpha((unsigned char)t[1 + strlen(type)]))
      continue;
    t += 1 + strlen(type);
    looks = !(t[0] == '0' && t[1] == '\'');
    if (*t == '\0')
      break;
  }
  return looks;
}

const char *types_of(const struct af_part *p)
{
  if (p->constants.IPS == 2)
    return is_curve(p) ? "R1 R2 R3 R4 LP BP" : "BP LP PD TR";
  if (is_curve(p))
    return "LP ZH";
  return p->constants.IPS == 1 ? "BP HB" : "BP LP"; /* straight rolling, the zero solution, has no fold */
}

int size_column(const struct af_part *p)
{
  const int norm = af_column(p, "L2-NORM");

  return norm >= 0 ? norm : p->columns > 1 && strncmp(p->column[1], "MAX ", 4) == 0 ? 1 : -1;
}
