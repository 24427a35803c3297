/* damping.c - the least damped oscillation of a gear that rolls straight at one speed */
#include "layout.h"

/* A root that does not oscillate counts when it grows only. */
static double damping_ratio(double re, double im)
{
  return re == 0. && im == 0. ? 0. : -re / hypot(re, im);
}

int libmlg_modes(int layout, const double par[], struct libmlg_mode mode[], int most, int *grows)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS], re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES];
  int modes = 0;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  const int n = libmlg_spectrum(l, slots, re, im);

  *grows = 0;
  for (int i = 0; i < n; i++) {
    *grows |= im[i] == 0. && re[i] > 0.;
    if (im[i] > 0. && modes < most) {
      if (libmlg_mode_near(l, slots, re[i], im[i], &mode[modes], NULL, NULL) != 0)
        return LIBMLG_FAILED;
      mode[modes++].V = slots[PAR_V];
    }
  }
  return n < 0 ? n : modes;
}

int libmlg_least_damped(int layout, const double par[], struct libmlg_mode *mode)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS], re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES], least = HUGE_VAL;
  int n, at = 0;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  n = libmlg_spectrum(l, slots, re, im);
  if (n < 0)
    return n;
  for (int i = 0; i < n; i++) {
    const double zeta = damping_ratio(re[i], im[i]);

    if (im[i] >= 0. && zeta < least) {
      least = zeta;
      at = i;
    }
  }
  n = libmlg_mode_near(l, slots, re[at], im[at], mode, NULL, NULL);
  mode->zeta = least; /* of the eigenvalue alone, which has more digits */
  return n;
}
