/* damping.c - the least damped oscillation of a gear that rolls straight */
#include "golden.h"
#include "layout.h"

/* A root that does not oscillate counts when it grows only. */
static double damping_ratio(double re, double im)
{
  return re == 0. && im == 0. ? 0. : -re / hypot(re, im);
}

/* The eigenvalue of the least damping ratio at slots; 0 or LIBMLG_FAILED. */
static int least_damped(const struct libmlg_layout *l, const double slots[], struct libmlg_mode *mode)
{
  double re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES];
  const int n = libmlg_spectrum(l, slots, re, im);

  if (n < 0)
    return n;
  *mode = (struct libmlg_mode){ .V = slots[PAR_V], .zeta = HUGE_VAL };
  for (int i = 0; i < n; i++) {
    const double zeta = damping_ratio(re[i], im[i]);

    if (im[i] >= 0. && zeta < mode->zeta) {
      mode->zeta = zeta;
      mode->re = re[i];
      mode->im = im[i];
    }
  }
  return 0;
}

/* Adds to a mode what its eigenvector says. */
static int complete(const struct libmlg_layout *l, double slots[], struct libmlg_mode *mode)
{
  const double zeta = mode->zeta;

  slots[PAR_V] = mode->V;
  const int status = libmlg_mode_near(l, slots, mode->re, mode->im, mode, NULL, NULL);

  mode->zeta = zeta;
  return status;
}

int libmlg_modes(int layout, const double par[], struct libmlg_mode mode[], int most, int *grows)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS], re[LIBMLG_MOST_STATES], im[LIBMLG_MOST_STATES];
  int modes = 0;

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
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

struct at { const struct libmlg_layout *l; double slots[MLG_SLOTS]; int status; };

static double negative_zeta(double V, void *data)
{
  struct at *at = data;
  struct libmlg_mode mode;

  at->slots[PAR_V] = V;
  if (least_damped(at->l, at->slots, &mode) != 0) {
    at->status = LIBMLG_FAILED;
    return 0.;
  }
  return -mode.zeta;
}

int libmlg_least_damped(int layout, const double par[], struct libmlg_mode *mode)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots(par, slots);
  return least_damped(l, slots, mode) == 0 ? complete(l, slots, mode) : LIBMLG_FAILED;
}

/* Where zeta is least between two speeds, one minimum lying there. */
static int bottom(struct at *at, double V_lo, double V_hi, struct libmlg_mode *mode)
{
  at->slots[PAR_V] = summit(negative_zeta, at, V_lo, V_hi);
  return at->status == 0 ? least_damped(at->l, at->slots, mode) : at->status;
}

int libmlg_least_damped_between(int layout, const double par[], double V_lo, double V_hi,
                                struct libmlg_mode *mode)
{
  struct at at = { libmlg_find(layout), { 0. }, 0 };

  if (!at.l)
    return LIBMLG_NONE;
  libmlg_slots(par, at.slots);
  return bottom(&at, V_lo, V_hi, mode) == 0 ? complete(at.l, at.slots, mode) : LIBMLG_FAILED;
}

/* Samples that are dense at low speed, and each minimum between them refined. */
int libmlg_least_damped_to(int layout, const double par[], double V_top, struct libmlg_mode *mode)
{
  enum { SAMPLES = 60 }; /* twice as many change no zeta by 1e-8 of itself (docs/damping.md) */
  struct at at = { libmlg_find(layout), { 0. }, 0 };
  struct libmlg_mode sample[3], least;

  if (!at.l)
    return LIBMLG_NONE;
  libmlg_slots(par, at.slots);
  mode->zeta = HUGE_VAL;
  for (int i = 1; i <= SAMPLES; i++) {
    sample[0] = sample[1];
    sample[1] = sample[2];
    at.slots[PAR_V] = V_top * i * i / (SAMPLES * SAMPLES);
    if (least_damped(at.l, at.slots, &sample[2]) != 0)
      return LIBMLG_FAILED;
    if (sample[2].zeta < mode->zeta)
      *mode = sample[2];
    if (i > 2 && sample[1].zeta <= sample[0].zeta && sample[1].zeta <= sample[2].zeta) {
      if (bottom(&at, sample[0].V, sample[2].V, &least) != 0)
        return LIBMLG_FAILED;
      if (least.zeta < mode->zeta)
        *mode = least;
    }
  }
  return complete(at.l, at.slots, mode);
}
