/* drawn.c - the device of one layout as a tree to draw
 *
 * Compiled once per layout, -DLAYOUT='"l1.c"' -DNAME=l1: the words of network.h,
 * which elsewhere make a stiffness, here make the tree of drawn.h.
 */
#include "drawn.h"

#include <stdio.h>
#include <stdlib.h>

#define MLG_NETWORK_H
#define network part
#define spring(value) element_of(SPRING, value, #value)
#define damper(value) element_of(DAMPER, value, #value)
#define inerter(value) element_of(INERTER, value, #value)
#define damper_and_inerter(c, b) series(damper(c), inerter(b))

static const struct part *kept(struct part part)
{
  struct part *copy = malloc(sizeof *copy);

  if (!copy) {
    fputs("mlg draw: out of memory\n", stderr);
    exit(1);
  }
  *copy = part;
  return copy;
}

static struct part element_of(enum part_kind kind, double value, const char *text);

static inline struct part parallel(struct part a, struct part b)
{
  return (struct part){ .kind = PARALLEL, .a = kept(a), .b = kept(b) };
}

static inline struct part series(struct part a, struct part b)
{
  return (struct part){ .kind = SERIES, .a = kept(a), .b = kept(b) };
}

#define MLG_NO_AUTO
#include LAYOUT

/* The name of a parameter in place of what stands for it in a layout file. */
static struct part element_of(enum part_kind kind, double value, const char *text)
{
#define X(number, id, called, ...) \
  if (strcmp(text, "par[PAR_" #id "]") == 0) return (struct part){ .kind = kind, .text = called, .slot = PAR_##id };
  MLG_PARAMETERS(X)
#undef X
  return (struct part){ .kind = kind, .text = text, .slot = -1, .value = value };
}

static struct part device_drawn(void)
{
  const double par[MLG_SLOTS] = { 0. };

  return device_network(par);
}

#define TEXT_OF(name) #name
#define TEXT(name) TEXT_OF(name)
#define ENTRY_OF(name) drawn_##name
#define ENTRY(name) ENTRY_OF(name)

const struct drawn ENTRY(NAME) = { TEXT(NAME), device_drawn };
