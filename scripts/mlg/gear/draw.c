/* draw.c - the device of a layout as the field draws it
 *
 * Wheels left, strut right; zigzag: spring, piston: damper, box in a bracket: inerter.
 */
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "device_text.h"
#include "drawn.h"
#include "svg.h"

#define L(name) extern const struct drawn drawn_##name;
#include "layouts.h"
#undef L

static const struct drawn *const drawings[] = {
#define L(name) &drawn_##name,
#include "layouts.h"
#undef L
};

static const double element = 104., lead = 14., above = 42., below = 18.; /* px */

/* The branches between two rails: first over the first one's line, last under
 * the last one's.  Parallel parts of a parallel network are branches of it. */
struct branches { double width, height, first, last; };

static struct branches branches(const struct part *n)
{
  if (n->kind != PARALLEL) {
    const struct drawn_size s = drawn_size(n);

    return (struct branches){ s.width, s.over + s.under, s.over, s.under };
  }
  const struct branches a = branches(n->a), b = branches(n->b);
  return (struct branches){ fmax(a.width, b.width), a.height + b.height, a.first, b.last };
}

struct drawn_size drawn_size(const struct part *n)
{
  if (n->kind == SERIES) {
    const struct drawn_size a = drawn_size(n->a), b = drawn_size(n->b);

    return (struct drawn_size){ a.width + b.width, fmax(a.over, b.over), fmax(a.under, b.under) };
  }
  if (n->kind == PARALLEL) {
    const struct branches s = branches(n);
    const double rail = s.height - s.first - s.last;

    return (struct drawn_size){ s.width + 2. * lead, s.first + rail / 2., s.last + rail / 2. };
  }
  return (struct drawn_size){ element, above, below };
}

/* One element on its line y between x and x + width. */
static void draw_element(const struct part *n, double x, double y, double width)
{
  const double middle = x + width / 2., left = middle - 27., right = middle + 27.;

  svg_line("", x, y, n->kind == DAMPER ? middle + 2. : left, y);
  svg_line("", n->kind == DAMPER ? middle + 20. : right, y, x + width, y);
  if (n->kind == SPRING)
    svg_path("", "M%.1f %.1fl4.5 -10l9 20l9 -20l9 20l9 -20l9 20l4.5 -10", left, y);
  else if (n->kind == DAMPER) {
    svg_path("", "M%.1f %.1fh40v24h-40", middle - 20., y - 12.);
    svg_line("bold", middle + 2., y - 8., middle + 2., y + 8.);
  } else {
    svg_path("", "M%.1f %.1fh36v18h-36z", left, y - 9.);
    svg_path("", "M%.1f %.1fh34v28h-34", right - 34., y - 14.);
  }
  svg_name(middle, y - 22., "middle", n->text);
}

/* Branches one below the other, from top downwards. */
static void draw_branches(const struct part *n, double x, double top, double width)
{
  if (n->kind == PARALLEL) {
    draw_branches(n->a, x, top, width);
    draw_branches(n->b, x, top + branches(n->a).height, width);
  } else
    draw_part(n, x, top + drawn_size(n).over, width);
}

/* A network from x on, its line at y, stretched to width. */
void draw_part(const struct part *n, double x, double y, double width)
{
  if (n->kind == SERIES) {
    const double a = drawn_size(n->a).width * width / drawn_size(n).width;

    draw_part(n->a, x, y, a);
    draw_part(n->b, x + a, y, width - a);
  } else if (n->kind == PARALLEL) {
    const struct branches s = branches(n);
    const double top = y - drawn_size(n).over, bottom = top + s.height;

    draw_branches(n, x + lead, top, width - 2. * lead);
    svg_path("", "M%.1f %.1fh%.1fM%.1f %.1fV%.1f", x, y, lead, x + lead, top + s.first, bottom - s.last);
    svg_path("", "M%.1f %.1fh%.1fM%.1f %.1fV%.1f", x + width, y, -lead, x + width - lead,
             top + s.first, bottom - s.last);
  } else
    draw_element(n, x, y, width);
}

const struct drawn *drawn_of(const char *layout)
{
  for (size_t i = 0; i < sizeof drawings / sizeof *drawings; i++)
    if (strcmp(drawings[i]->layout, layout) == 0)
      return drawings[i];
  return NULL;
}

static int run(int argc, char *argv[])
{
  const struct drawn *drawn;
  struct part device;
  struct arguments a;
  char title[200];

  read_arguments(&a, argc < 2 ? argc : 2, argv, NULL);
  if (argc > 2)
    refuse(argv[0], argv[2], "expected nothing behind the layout");
  drawn = drawn_of(argv[1]);
  if (!drawn && !device_of(a.layout))
    refuse(argv[0], argv[1], "there is no drawing of this layout");
  device = drawn ? drawn->device() : *device_of(a.layout)->whole;

  const struct drawn_size s = drawn_size(&device);
  const double margin = 74., y = 12. + s.over, wall = margin + s.width;

  snprintf(title, sizeof title, drawn ? "the device of layout %s" : "the device %s", argv[1]);
  svg_begin(s.width + 2. * margin, s.over + fmax(s.under, 44.) + 12., title);
  draw_part(&device, margin, y, s.width);
  svg_circle("solid", margin, y, 4.);
  svg_arrow(margin - 46., y, margin - 10., y);
  svg_name(margin - 30., y - 10., "middle", "psi");
  svg_note(margin - 30., y + 22., "middle", "wheels");
  svg_hatching(wall, y - 30., wall, y + 30.);
  svg_note(wall + 14., y + 5., "start", "strut");
  svg_end();
  return output_status(argv[0]);
}

const struct command command_draw = {
  .name = "draw",
  .usage = "LAYOUT",
  .summary = "a drawing of the layout's device, as SVG",
  .details =
    "What it draws is device_network() of the layout.  An element is called by the parameter\n"
    "it is written with, or else as it is written: par[PAR_K_S] is k_s, and c_s is c_s.\n"
    "Wheels left, strut right; zigzag: spring, piston: damper, box in a bracket: inerter.\n",
  .run = run,
};
