/* drawings.c - many networks drawn on one page, with what is to be said of each below it */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "command.h"
#include "device_text.h"
#include "drawn.h"
#include "svg.h"

enum { COLUMNS = 5, MOST_DRAWINGS = 200, LINE = 400, CAPTIONS = 4 };

static const double cell_width = 250., drawing_height = 130., line_height = 17., margin = 12.; /* px */

struct drawing { char line[LINE], *caption[CAPTIONS]; int captions, layout; };

/* NETWORK,CAPTION,CAPTION...; 0 at the end of the input. */
static int read_drawing(const char *command, struct drawing *d)
{
  char wrong[200];

  if (!fgets(d->line, sizeof d->line, stdin))
    return 0;
  d->line[strcspn(d->line, "\n")] = '\0';
  for (char *at = strchr(d->line, ','); at && d->captions < CAPTIONS; at = strchr(at, ',')) {
    *at++ = '\0';
    d->caption[d->captions++] = at;
  }
  if (strpbrk(d->line, "<&") || (d->captions > 0 && strpbrk(d->caption[0], "<&")))
    refuse(command, d->line, "< and & have another meaning in SVG");
  d->layout = libmlg_network(d->line, wrong, sizeof wrong);
  if (d->layout == LIBMLG_NONE)
    refuse(command, d->line, "no network: %s", wrong);
  return 1;
}

/* The network without k_psi, as large as the cell allows. */
static void draw_cell(const struct drawing *d, double x, double y)
{
  const struct part *const network = device_of(d->layout)->network;
  const struct drawn_size s = drawn_size(network);
  const double scale = fmin(0.62, fmin((cell_width - 2. * margin) / s.width, drawing_height / (s.over + s.under)));
  const double left = x + 0.5 * (cell_width - scale * s.width), top = y + 0.5 * (drawing_height - scale * (s.over + s.under));

  printf("<g transform='translate(%.1f %.1f) scale(%.3f)'>\n", left, top, scale);
  draw_part(network, 0., s.over, s.width);
  svg_circle("solid", 0., s.over, 4.);
  svg_circle("solid", s.width, s.over, 4.);
  puts("</g>");
  for (int i = 0; i < d->captions; i++)
    svg_note(x + cell_width / 2., y + drawing_height + line_height * (i + 1), "middle", d->caption[i]);
}

static int run(int argc, char *argv[])
{
  static struct drawing drawing[MOST_DRAWINGS];
  int n = 0, lines = 0;

  if (argc > 1)
    refuse(argv[0], argv[1], "expected nothing behind the command");
  while (n < MOST_DRAWINGS && read_drawing(argv[0], &drawing[n])) {
    lines = drawing[n].captions > lines ? drawing[n].captions : lines;
    n++;
  }
  if (n == 0)
    fail(argv[0], MLG_BAD_INPUT, "expected lines NETWORK,CAPTION,... on standard input");

  const double cell_height = drawing_height + line_height * (lines + 1);

  svg_begin(COLUMNS * cell_width, ceil((double)n / COLUMNS) * cell_height + margin, "networks");
  for (int i = 0; i < n; i++)
    draw_cell(&drawing[i], i % COLUMNS * cell_width, margin + i / COLUMNS * cell_height);
  svg_end();
  return output_status(argv[0]);
}

const struct command command_drawings = {
  .name = "drawings",
  .usage = "",
  .summary = "many networks drawn on one page, as SVG",
  .details =
    "Lines NETWORK,CAPTION,CAPTION... of standard input, up to four captions each, which stand\n"
    "below it.  k_psi, behind which each of them stands, is left out.\n",
  .run = run,
};
