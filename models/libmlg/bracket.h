/* bracket.h - a root between two places by regula falsi, in the manner of Illinois; private to libmlg */
#ifndef LIBMLG_BRACKET_H
#define LIBMLG_BRACKET_H

/* Two places and the values there, of which one is above 0 and the other is not. */
struct bracket { double lo, hi, at_lo, at_hi; };

/* Where a straight line through both is 0. */
static inline double bracket_secant(const struct bracket *b)
{
  return b->lo + (b->hi - b->lo) * b->at_lo / (b->at_lo - b->at_hi);
}

/* Takes a place between them with its value for the end of its sign; the value at the other end is
 * halved, so that no end stays for ever. */
static inline void bracket_narrow(struct bracket *b, double x, double value)
{
  if ((value > 0.) == (b->at_hi > 0.)) {
    b->hi = x;
    b->at_hi = value;
    b->at_lo *= 0.5;
  } else {
    b->lo = x;
    b->at_lo = value;
    b->at_hi *= 0.5;
  }
}

#endif
