/* device_text.h - a device written as text, and as a tree of its elements; private to
 * models/libmlg and the commands of mlg
 *
 *   network = branch { "|" branch }      side by side: the same twist
 *   branch  = element { "-" element }    one behind the other: the same torque
 *   element = k_d | k_s | c_d | b | NAME=VALUE | "(" network ")"
 *
 * as in "k_s-(k_d|c_d|b)", which is LI1: what stands behind k_psi.  The first letter of
 * NAME says what it is, k, c or b: "c_2=300".  Values in SI units.
 */
#ifndef LIBMLG_DEVICE_TEXT_H
#define LIBMLG_DEVICE_TEXT_H

#include "layout.h"
#include "part.h"

/* Each damper gives the device one state, each inerter two: so many with one behind the
 * other are more than the polynomials of crossing.h hold. */
enum { DEVICE_ELEMENTS = 10, DEVICE_ORDER = 6, DEVICE_TEXT = 160 };

/* A device as it was read: `network` is what stands behind k_psi, part of `whole`. */
struct device_text {
  char text[DEVICE_TEXT], word[DEVICE_ELEMENTS][24];
  struct part part[2 * DEVICE_ELEMENTS + 2];
  int parts, words;
  const struct part *network, *whole;
  struct network rational; /* where there is no network: num/den of what stands beside c_d behind k_psi */
  int common; /* powers of s that num and den of `whole` share, whatever the values */
  int order;  /* degree of den without them: the number of its states */
};

/* Reads text; 0, or LIBMLG_NONE with one line in error[] that says where it ends to make
 * sense.  The struct holds pointers into itself: it may not be copied. */
int device_read(struct device_text *d, const char *text, char error[], size_t size);

/* Its dynamic stiffness at par[] (AUTO's slots), with k_psi. */
struct network device_stiffness(const struct device_text *d, const double par[]);

/* The tree as text, into text[size]; its length, as snprintf. */
int device_write(const struct part *tree, char text[], size_t size);

/* The device of a layout number that libmlg_network() gave, or NULL. */
const struct device_text *device_of(int layout);

/* The number of a device that is no network but any dynamic stiffness, `rational` beside c_d:
 * its owner sets that, with at most `order` powers of s in den, 1, s, ..., as often as it
 * likes.  LIBMLG_NONE: out of memory. */
int device_rational(int order);

/* The same for a search that changes the values of its elements, while nobody else asks. */
struct device_text *device_writable(int layout);

/* The element NAME=VALUE of such a network, NULL where there is none of that name or another with it;
 * `wrong` then is what to say. */
struct part *device_element(int layout, const char *name, const char **wrong);

#endif
