/* network.h - dynamic stiffness of a device composed of springs, dampers, inerters
 *
 * A layout writes its device down as it is drawn, for example
 *   series(spring(k_psi), parallel(spring(k_d), damper(c_d)))
 * The dynamic stiffness Z(s) = torque / twist comes out as a quotient of two
 * polynomials in s without poles of its own.  An element stands in it once, so
 * both are affine in each c_d, b and compliance 1/k: a rigid spring
 * (k infinite) is a regular case.
 */
#ifndef MLG_NETWORK_H
#define MLG_NETWORK_H

#include <complex.h>
#undef complex /* the name of a type in AUTO's header */

enum { POLY_TERMS = 16 };

/* coefficient[i] belongs to s^i */
struct poly { double coefficient[POLY_TERMS]; };

/* Z = num / den, N m/rad */
struct network { struct poly num, den; };

/* 0 for a constant.  Leaving out the zeros above it is exact and halves the time. */
static inline int poly_degree(const struct poly *a)
{
  int n = POLY_TERMS - 1;

  while (n > 0 && a->coefficient[n] == 0.)
    n--;
  return n;
}

static inline struct poly poly_sum(struct poly a, struct poly b)
{
  for (int i = 0; i < POLY_TERMS; i++)
    a.coefficient[i] += b.coefficient[i];
  return a;
}

static inline struct poly poly_scaled(struct poly a, double factor)
{
  for (int i = 0; i < POLY_TERMS; i++)
    a.coefficient[i] *= factor;
  return a;
}

/* The product; terms past POLY_TERMS do not arise with devices of up to six elements. */
static inline struct poly poly_product(struct poly a, struct poly b)
{
  struct poly p = { { 0. } };
  const int n = poly_degree(&b);

  for (int i = 0; i < POLY_TERMS; i++)
    if (a.coefficient[i] != 0.)
      for (int j = 0; j <= n && i + j < POLY_TERMS; j++)
        p.coefficient[i + j] += a.coefficient[i] * b.coefficient[j];
  return p;
}

static inline double _Complex poly_value(const struct poly *a, double _Complex s)
{
  double _Complex value = 0.;

  for (int i = poly_degree(a); i >= 0; i--)
    value = value * s + a->coefficient[i];
  return value;
}

static inline double _Complex poly_derivative(const struct poly *a, double _Complex s)
{
  double _Complex value = 0.;

  for (int i = poly_degree(a); i >= 1; i--)
    value = value * s + i * a->coefficient[i];
  return value;
}

/* k, N m/rad; infinite is rigid */
static inline struct network spring(double k)
{
  return (struct network){ { { 1. } }, { { 1. / k } } };
}

/* c, N m s/rad */
static inline struct network damper(double c)
{
  return (struct network){ { { 0., c } }, { { 1. } } };
}

/* b, N m s^2/rad */
static inline struct network inerter(double b)
{
  return (struct network){ { { 0., 0., b } }, { { 1. } } };
}

/* c and b one behind the other, without the power of s that series() would leave in both
 * polynomials; without either nothing carries. */
static inline struct network damper_and_inerter(double c, double b)
{
  return (struct network){ { { 0., 0., b * c } }, { { c > 0. || b > 0. ? c : 1., b } } };
}

/* The same twist, torques add. */
static inline struct network parallel(struct network a, struct network b)
{
  return (struct network){
    poly_sum(poly_product(a.num, b.den), poly_product(b.num, a.den)),
    poly_product(a.den, b.den),
  };
}

/* The same torque, twists add. */
static inline struct network series(struct network a, struct network b)
{
  return (struct network){
    poly_product(a.num, b.num),
    poly_sum(poly_product(a.num, b.den), poly_product(b.num, a.den)),
  };
}

#endif
