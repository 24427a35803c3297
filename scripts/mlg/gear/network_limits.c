/* network_limits.c - the smaller networks that one of the larger family becomes at an end of an element
 *
 * At 0 a spring or damper is not there, or parts what it stands behind; at infinity it is rigid.  What the best
 * design of the limit has, the larger network has as well, or nearly so at the end of its range.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "networks.h"

double _Complex network_at(struct device_text *d, double k_s, double c_d, double other)
{
  const double _Complex s = 0.7 + 1.3 * I;
  double par[MLG_SLOTS] = { [PAR_K_PSI] = 1.1, [PAR_K_D] = 1.3, [PAR_K_S] = k_s, [PAR_C_D] = c_d, [PAR_B] = 2.3 };

  for (int i = 0; i < d->parts; i++)
    if (d->part[i].slot < 0 && d->part[i].text)
      d->part[i].value = other;
  const struct network Z = device_stiffness(d, par);

  return poly_value(&Z.num, s) / poly_value(&Z.den, s);
}

void print_limits(int number, struct device_text *d, struct device_text less[], int n)
{
  const double k = 1.7, c = 1.9, x = 3.1, end[2] = { 1e-10, 1e10 };
  const int is_damper = strstr(d->text, "c_2") != NULL;

  for (int exchanged = 0; exchanged < 2; exchanged++) /* k_s or c_d goes, and the other takes its place */
    for (int i = 0; i < 2; i++) {
      const double _Complex here = !exchanged ? network_at(d, k, c, end[i]) : is_damper ? network_at(d, k, end[i], x) : network_at(d, end[i], c, x);

      for (int l = 0; l < n; l++)
        if (cabs(here - network_at(&less[l], exchanged && !is_damper ? x : k, exchanged && is_damper ? x : c, 0.)) < 1e-7 * cabs(here))
          printf("%d,%s,%s,%s,%d,%s\n", number, d->text, exchanged ? (is_damper ? "c_d" : "k_s") : is_damper ? "c_2" : "k_2",
                 i ? "inf" : "0", l + 1, less[l].text);
    }
}
