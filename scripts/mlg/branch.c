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

/* How far the multiplier that decides lies from the unit circle; that of them all
 * which is nearest to 1 is the trivial one. */
static double decisive_distance(const struct af_branches *all, const struct af_point *p)
{
  double nearest = INFINITY, largest = 0.;
  int trivial = 0;

  for (int k = 0; k < p->eigenvalues; k++) {
    const double *mu = &all->eigenvalue[p->eigenvalue + 2 * (size_t)k];
    const double distance = hypot(mu[0] - 1., mu[1]);

    if (distance < nearest)
      nearest = distance, trivial = k;
  }
  for (int k = 0; k < p->eigenvalues; k++) {
    const double *mu = &all->eigenvalue[p->eigenvalue + 2 * (size_t)k];

    if (k != trivial)
      largest = fmax(largest, hypot(mu[0], mu[1]));
  }
  return fabs(largest - 1.);
}

int point_stability(const struct af_branches *all, const struct af_part *part, long point)
{
  const struct af_point *p = &part->point[point];
  const double tolerance = 1e-5;

  if (is_curve(part) || part->constants.IPS == 0 || part->constants.ISP == 0)
    return -1;
  if (part->constants.IID > 0 && all->has_d && p->stable_count < 0)
    return -1;
  if (is_orbits(part) && p->eigenvalues > 1 && decisive_distance(all, p) < 1.5 * tolerance) /* d. has 6 digits */
    return -1;
  return p->stable;
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
