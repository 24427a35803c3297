/* eigenvalues.c - straight rolling: the spectrum of the Jacobian at u = 0, by LAPACK */
#include <stdbool.h>

#include <lapacke.h>

#include "layout.h"

/* Whether state j is coupled to one that is kept, by its row or by its column. */
static bool row_is_coupled(int n, const double A[], const bool kept[], int j)
{
  for (int i = 0; i < n; i++)
    if (i != j && kept[i] && A[j + n * i] != 0.)
      return true;
  return false;
}

static bool column_is_coupled(int n, const double A[], const bool kept[], int j)
{
  for (int i = 0; i < n; i++)
    if (i != j && kept[i] && A[i + n * j] != 0.)
      return true;
  return false;
}

/* Leaves out, one after the other, the device's states that only follow: whose row or
 * column is 0 beside -MLG_FOLLOW on the diagonal.  The matrix is then triangular in
 * blocks, and the eigenvalues of what is kept are the others. */
static void leave_out_followers(int n, const double A[], bool kept[])
{
  bool changed = true;

  for (int i = 0; i < n; i++)
    kept[i] = true;
  while (changed) {
    changed = false;
    for (int j = GEAR_STATES; j < n; j++)
      if (kept[j] && A[j + n * j] == -MLG_FOLLOW
          && (!row_is_coupled(n, A, kept, j) || !column_is_coupled(n, A, kept, j))) {
        kept[j] = false;
        changed = true;
      }
  }
}

static bool before(double re1, double im1, double re2, double im2)
{
  return re1 > re2 || (!(re2 > re1) && im1 > im2);
}

static void sort(int n, double re[], double im[])
{
  for (int i = 1; i < n; i++)
    for (int j = i; j > 0 && before(re[j], im[j], re[j - 1], im[j - 1]); j--) {
      const double r = re[j], s = im[j];

      re[j] = re[j - 1], im[j] = im[j - 1];
      re[j - 1] = r, im[j - 1] = s;
    }
}

int libmlg_spectrum(const struct libmlg_layout *l, const double slots[], double re[], double im[])
{
  const double rest[LIBMLG_MOST_STATES] = { 0. };
  const int n = l->states;
  double f[LIBMLG_MOST_STATES], A[LIBMLG_MOST_STATES * LIBMLG_MOST_STATES];
  bool kept[LIBMLG_MOST_STATES];
  int m = 0, entries = 0;

  l->rhs(l, slots, rest, f);
  l->jacobian(l, slots, rest, f, A, NULL);
  for (int i = 0; i < n * n; i++)
    if (!isfinite(A[i]))
      return LIBMLG_FAILED;
  leave_out_followers(n, A, kept);
  for (int j = 0; j < n; j++) {
    m += kept[j];
    for (int i = 0; i < n; i++)
      if (kept[i] && kept[j])
        A[entries++] = A[i + n * j];
  }
  if (LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', m, A, m, re, im, NULL, m, NULL, m) != 0)
    return LIBMLG_FAILED;
  sort(m, re, im);
  return m;
}

int libmlg_eigenvalues(int layout, const double par[], double re[], double im[], int *n)
{
  const struct libmlg_layout *l = libmlg_find(layout);
  double slots[MLG_SLOTS];

  if (!l)
    return LIBMLG_NONE;
  libmlg_slots_at_rest(par, slots);
  const int found = libmlg_spectrum(l, slots, re, im);

  if (found < 0)
    return found;
  *n = found;
  return 0;
}

int libmlg_is_delta(const double par[], double delta_over_psi)
{
  double slots[MLG_SLOTS];

  libmlg_slots(par, slots);
  return mlg_energy_ratio(slots, delta_over_psi) > 1.;
}
