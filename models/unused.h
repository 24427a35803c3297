/* unused.h - what AUTO wants to be there, of problems that have none of it: boundary
 * conditions, integral conditions and an objective
 *
 * Included behind AUTO's header.
 */
#ifndef MLG_UNUSED_H
#define MLG_UNUSED_H

int bcnd(integer ndim, const doublereal *par, const integer *icp, integer nbc,
         const doublereal *u0, const doublereal *u1, integer ijac, doublereal *f, doublereal *dbc)
{
  (void)ndim, (void)par, (void)icp, (void)nbc, (void)u0, (void)u1, (void)ijac, (void)f, (void)dbc;
  return 0;
}

int icnd(integer ndim, const doublereal *par, const integer *icp, integer nint,
         const doublereal *u, const doublereal *uold, const doublereal *udot,
         const doublereal *upold, integer ijac, doublereal *f, doublereal *dint)
{
  (void)ndim, (void)par, (void)icp, (void)nint, (void)u, (void)uold, (void)udot, (void)upold;
  (void)ijac, (void)f, (void)dint;
  return 0;
}

int fopt(integer ndim, const doublereal *u, const integer *icp, const doublereal *par,
         integer ijac, doublereal *f, doublereal *dfdu, doublereal *dfdp)
{
  (void)ndim, (void)u, (void)icp, (void)par, (void)ijac, (void)f, (void)dfdu, (void)dfdp;
  return 0;
}

#endif
