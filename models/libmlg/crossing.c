/* crossing.c - F on a ray, its condition G and their values; see crossing.h */
#include <math.h>
#include <string.h>

#include "crossing_parts.h"
#include "linearised.h"

/* --- F ----------------------------------------------------------------------------- */

/* The device as [0] + [1] c/c_unit.  A rigid spring has no compliance at all. */
static void device(const struct libmlg_layout *layout, const double par[], double c_unit, struct network Z[2])
{
  double p[MLG_SLOTS];

  memcpy(p, par, sizeof p);
  if (p[PAR_K_S] >= MLG_RIGID)
    p[PAR_K_S] = INFINITY;
  p[PAR_C_D] = 0.;
  Z[0] = layout->network(layout, p);
  p[PAR_C_D] = c_unit;
  Z[1] = layout->network(layout, p);
  Z[1].num = poly_sum(Z[1].num, poly_scaled(Z[0].num, -1.));
  Z[1].den = poly_sum(Z[1].den, poly_scaled(Z[0].den, -1.));
}

int crossing_degree(const double p[T])
{
  int n = T - 1;

  while (n > 0 && p[n] == 0.)
    n--;
  return n;
}

void crossing_add_product(double r[T], double sign, const double p[T], const double q[T])
{
  const int n = crossing_degree(p), m = crossing_degree(q);

  for (int i = 0; i <= n; i++)
    for (int j = 0; j <= m && i + j < T; j++)
      r[i + j] += sign * p[i] * q[j];
}

/* a + i q b on the ray from F. */
static void split(struct crossing *x)
{
  const double root = sqrt(1. - x->zeta * x->zeta);

  memset(x->a, 0, sizeof x->a);
  memset(x->b, 0, sizeof x->b);
  for (int v = 0; v <= x->speeds; v++)
    for (int k = 0; k < 2; k++) {
      double re = 1., im = 0.; /* ray^i */

      for (int i = 0; i <= x->order; i++) {
        const double next = -x->zeta * re - root * im;

        if (x->squared)
          (i % 2 ? x->b : x->a)[v][k][i / 2] = x->F[v][k][i] * (i / 2 % 2 ? -1. : 1.);
        else {
          x->a[v][k][i] = x->F[v][k][i] * re;
          if (i > 0)
            x->b[v][k][i - 1] = x->F[v][k][i] * im;
        }
        im = root * re - x->zeta * im;
        re = next;
      }
    }
}

void crossing_quadratic(const struct crossing *x, double A[T], double B[T], double C[T])
{
  memset(A, 0, T * sizeof *A);
  memset(B, 0, T * sizeof *B);
  memset(C, 0, T * sizeof *C);
  crossing_add_product(A, 1., x->a[0][1], x->b[1][1]);
  crossing_add_product(A, -1., x->a[1][1], x->b[0][1]);
  crossing_add_product(B, 1., x->a[0][0], x->b[1][1]);
  crossing_add_product(B, 1., x->a[0][1], x->b[1][0]);
  crossing_add_product(B, -1., x->a[1][0], x->b[0][1]);
  crossing_add_product(B, -1., x->a[1][1], x->b[0][0]);
  crossing_add_product(C, 1., x->a[0][0], x->b[1][0]);
  crossing_add_product(C, -1., x->a[1][0], x->b[0][0]);
}

struct crossing crossing_of(const struct libmlg_layout *layout, const double par[], double zeta)
{
  const struct gear_matrix g = gear_matrix(par);
  struct crossing x = { .order = 0, .speeds = gear_speeds(par) };
  struct poly whole[GEAR_SPEEDS], minor[GEAR_SPEEDS];
  struct network Z[2];
  double largest = 0.;

  /* between the frequencies of the two modes; of l and k_d, k_psi */
  x.omega_unit = pow(fabs(par[PAR_K_DELTA] / g.A11.coefficient[2] * par[PAR_K_PSI] / g.A22.coefficient[2]), 0.25);
  x.V_unit = x.omega_unit * par[PAR_L];
  x.c_unit = sqrt(par[PAR_K_D] * par[PAR_K_PSI]) / x.omega_unit;
  gear_determinants(par, whole, minor);
  device(layout, par, x.c_unit, Z);
  for (int v = 0; v <= x.speeds; v++)
    for (int k = 0; k < 2; k++) {
      const struct poly f = poly_sum(poly_product(Z[k].den, whole[v]), poly_product(Z[k].num, minor[v]));
      double unit = pow(x.V_unit, v);

      for (int i = 0; i < POLY_TERMS; i++, unit *= x.omega_unit) {
        x.F[v][k][i] = f.coefficient[i] * unit;
        largest = fmax(largest, fabs(x.F[v][k][i]));
      }
    }
  for (int v = 0; v <= x.speeds; v++)
    for (int k = 0; k < 2; k++) {
      for (int i = 0; i < POLY_TERMS; i++)
        x.F[v][k][i] /= largest;
      if (crossing_degree(x.F[v][k]) > x.order)
        x.order = crossing_degree(x.F[v][k]);
    }
  return crossing_on(&x, zeta);
}

struct crossing crossing_on(const struct crossing *other, double zeta)
{
  struct crossing x = *other;
  double A[T], B[T], C[T];

  x.zeta = zeta;
  x.squared = zeta == 0.;
  split(&x);
  if (x.speeds > 1) /* G is not of degree 2 in c: crossing_spin.c */
    return x;
  crossing_quadratic(&x, A, B, C);
  x.degree = crossing_degree(A);
  if (crossing_degree(B) > x.degree)
    x.degree = crossing_degree(B);
  if (crossing_degree(C) > x.degree)
    x.degree = crossing_degree(C);
  return x;
}

double crossing_omega(const struct crossing *x, double t)
{
  return x->omega_unit * (x->squared ? sqrt(t) : t);
}

/* --- values --------------------------------------------------------------------------- */

struct value crossing_value(const double p[T], int n, double t)
{
  struct value v = { 0., 0., 0. };

  for (int i = n; i >= 0; i--) {
    v.dd = v.dd * t + 2. * v.d;
    v.d = v.d * t + v.p;
    v.p = v.p * t + p[i];
  }
  return v;
}

static struct value sum(struct value p, struct value q, double c)
{
  return (struct value){ p.p + q.p * c, p.d + q.d * c, p.dd + q.dd * c };
}

struct parts crossing_parts(const struct crossing *x, double t, double c)
{
  const int n = x->squared ? x->order / 2 : x->order;
  struct parts f = {
    .alpha_c = crossing_value(x->a[0][1], n, t), .gamma_c = crossing_value(x->a[1][1], n, t),
    .beta_c = crossing_value(x->b[0][1], n, t), .eta_c = crossing_value(x->b[1][1], n, t),
  };

  f.alpha = sum(crossing_value(x->a[0][0], n, t), f.alpha_c, c);
  f.gamma = sum(crossing_value(x->a[1][0], n, t), f.gamma_c, c);
  f.beta = sum(crossing_value(x->b[0][0], n, t), f.beta_c, c);
  f.eta = sum(crossing_value(x->b[1][0], n, t), f.eta_c, c);
  return f;
}

struct jet_of_G crossing_jet(const struct parts *f)
{
  return (struct jet_of_G){
    .G = f->alpha.p * f->eta.p - f->gamma.p * f->beta.p,
    .t = f->alpha.d * f->eta.p + f->alpha.p * f->eta.d - f->gamma.d * f->beta.p - f->gamma.p * f->beta.d,
    .c = f->alpha_c.p * f->eta.p + f->alpha.p * f->eta_c.p - f->gamma_c.p * f->beta.p - f->gamma.p * f->beta_c.p,
    .tt = f->alpha.dd * f->eta.p + 2. * f->alpha.d * f->eta.d + f->alpha.p * f->eta.dd
          - f->gamma.dd * f->beta.p - 2. * f->gamma.d * f->beta.d - f->gamma.p * f->beta.dd,
    .tc = f->alpha_c.d * f->eta.p + f->alpha.d * f->eta_c.p + f->alpha_c.p * f->eta.d + f->alpha.p * f->eta_c.d
          - f->gamma_c.d * f->beta.p - f->gamma.d * f->beta_c.p - f->gamma_c.p * f->beta.d - f->gamma.p * f->beta_c.d,
    .size = fabs(f->alpha.p * f->eta.p) + fabs(f->gamma.p * f->beta.p),
    .size_t_ = fabs(f->alpha.d * f->eta.p) + fabs(f->alpha.p * f->eta.d) + fabs(f->gamma.d * f->beta.p)
               + fabs(f->gamma.p * f->beta.d),
  };
}

double crossing_speed(const struct parts *f)
{
  return fabs(f->gamma.p) > fabs(f->eta.p) ? -f->alpha.p / f->gamma.p : -f->beta.p / f->eta.p;
}

double crossing_curvature(const struct crossing *x, const struct crossing_at *p)
{
  if (x->speeds > 1)
    return spin_curvature(x, p);
  const struct parts f = crossing_parts(x, p->t, p->c);
  const struct jet_of_G j = crossing_jet(&f);

  return -j.tt / j.c;
}

double crossing_slope(const struct crossing *x, const struct crossing_at *p)
{
  if (x->speeds > 1)
    return spin_slope(x, p);
  const struct parts f = crossing_parts(x, p->t, p->c);
  /* a = alpha + gamma V = 0 and b = beta + eta V = 0, differentiated by t and c */
  const double a_t = f.alpha.d + f.gamma.d * p->V, b_t = f.beta.d + f.eta.d * p->V;
  const double a_c = f.alpha_c.p + f.gamma_c.p * p->V, b_c = f.beta_c.p + f.eta_c.p * p->V;

  return -(a_c * b_t - b_c * a_t) / (f.gamma.p * b_t - f.eta.p * a_t);
}
