/* draw.c - the device of a layout as the field draws it
 *
 * Wheels left, strut right; zigzag: spring, piston: damper, box in a bracket: inerter.
 */
#include <string.h>

#include "arguments.h"
#include "command.h"
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

/* What a network takes up: its width, and its height over and under its line. */
struct size { double width, over, under; };

/* The branches between two rails: first over the first one's line, last under
 * the last one's.  Parallel parts of a parallel network are branches of it. */
struct branches { double width, height, first, last; };

static struct size size(const struct part *n);

static struct branches branches(const struct part *n)
{
  if (n->kind != PARALLEL) {
    const struct size s = size(n);

    return (struct branches){ s.width, s.over + s.under, s.over, s.under };
  }
  const struct branches a = branches(n->a), b = branches(n->b);
  return (struct branches){ fmax(a.width, b.width), a.height + b.height, a.first, b.last };
}

static struct size size(const struct part *n)
{
  if (n->kind == SERIES) {
    const struct size a = size(n->a), b = size(n->b);

    return (struct size){ a.width + b.width, fmax(a.over, b.over), fmax(a.under, b.under) };
  }
  if (n->kind == PARALLEL) {
    const struct branches s = branches(n);
    const double rail = s.height - s.first - s.last;

    return (struct size){ s.width + 2. * lead, s.first + rail / 2., s.last + rail / 2. };
  }
  return (struct size){ element, above, below };
}

static const char *name(const char *text)
{
#define X(slot, id, name, ...) if (strcmp(text, "par[PAR_" #id "]") == 0) return name;
  MLG_PARAMETERS(X)
#undef X
  return text;
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
  svg_name(middle, y - 22., "middle", name(n->text));
}

static void draw(const struct part *n, double x, double y, double width);

/* Branches one below the other, from top downwards. */
static void draw_branches(const struct part *n, double x, double top, double width)
{
  if (n->kind == PARALLEL) {
    draw_branches(n->a, x, top, width);
    draw_branches(n->b, x, top + branches(n->a).height, width);
  } else
    draw(n, x, top + size(n).over, width);
}

/* A network from x on, its line at y, stretched to width. */
static void draw(const struct part *n, double x, double y, double width)
{
  if (n->kind == SERIES) {
    const double a = size(n->a).width * width / size(n).width;

    draw(n->a, x, y, a);
    draw(n->b, x + a, y, width - a);
  } else if (n->kind == PARALLEL) {
    const struct branches s = branches(n);
    const double top = y - size(n).over, bottom = top + s.height;

    draw_branches(n, x + lead, top, width - 2. * lead);
    svg_path("", "M%.1f %.1fh%.1fM%.1f %.1fV%.1f", x, y, lead, x + lead, top + s.first, bottom - s.last);
    svg_path("", "M%.1f %.1fh%.1fM%.1f %.1fV%.1f", x + width, y, -lead, x + width - lead,
             top + s.first, bottom - s.last);
  } else
    draw_element(n, x, y, width);
}

static int run(int argc, char *argv[])
{
  struct arguments a;
  const struct drawn *drawn = NULL;
  char title[80];

  read_arguments(&a, argc < 2 ? argc : 2, argv, NULL);
  if (argc > 2)
    refuse(argv[0], argv[2], "expected nothing behind the layout");
  for (size_t i = 0; i < sizeof drawings / sizeof *drawings; i++)
    if (strcmp(drawings[i]->layout, argv[1]) == 0)
      drawn = drawings[i];
  if (!drawn)
    refuse(argv[0], argv[1], "there is no drawing of this layout");

  const struct part device = drawn->device();
  const struct size s = size(&device);
  const double margin = 74., y = 12. + s.over, wall = margin + s.width;

  snprintf(title, sizeof title, "the device of layout %s", argv[1]);
  svg_begin(s.width + 2. * margin, s.over + fmax(s.under, 44.) + 12., title);
  draw(&device, margin, y, s.width);
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
