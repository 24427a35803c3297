/* svg.h - strokes and names of the drawings (draw.c, gear.c), as SVG on standard output
 *
 * Lengths are pixels, y downwards.  A name is written as the constants files
 * have it, "k_psi", and drawn in italics with its subscript: Greek words become
 * letters.
 */
#ifndef MLG_SVG_H
#define MLG_SVG_H

#include <math.h>
#include <stdio.h>
#include <string.h>

static void svg_begin(double width, double height, const char *title)
{
  printf("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %g %g' width='%g' height='%g'>\n"
         "<title>%s</title>\n"
         "<style>path{fill:none;stroke:#000;stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round}"
         ".thin{stroke-width:.9}.dash{stroke-width:.9;stroke-dasharray:6 3 1 3}.ghost{stroke:#1f4fd8;stroke-width:1.2}"
         ".bold{stroke-width:3}.tyre{fill:#eeeeee}.solid{fill:#fff}.head{fill:#000;stroke-width:.5}"
         "text{font:17px 'DejaVu Serif',Georgia,'Times New Roman',serif;paint-order:stroke;stroke:#fff;stroke-width:3px}"
         ".i{font-style:italic}.note{font-size:14px}</style>\n"
         "<rect width='%g' height='%g' fill='#fff'/>\n",
         width, height, width, height, title, width, height);
}

static void svg_end(void) { puts("</svg>"); }

/* A path of SVG's own language, printf like.  look: a class above, or "". */
#define svg_path(look, ...) \
  (printf("<path class='%s' d='", (look)), printf(__VA_ARGS__), puts("'/>"))

static inline void svg_line(const char *look, double x1, double y1, double x2, double y2)
{
  svg_path(look, "M%.1f %.1fL%.1f %.1f", x1, y1, x2, y2);
}

static inline void svg_circle(const char *look, double x, double y, double r)
{
  svg_path(look, "M%.1f %.1fa%.1f %.1f 0 1 0 %.1f 0a%.1f %.1f 0 1 0 %.1f 0z",
           x - r, y, r, r, 2. * r, r, r, -2. * r);
}

/* The tip of an arrow at (x, y) that flies along the angle, rad. */
static inline void svg_head(double x, double y, double angle)
{
  const double size = 9., half = 0.3;

  svg_path("head", "M%.1f %.1fL%.1f %.1fL%.1f %.1fz", x, y,
           x - size * cos(angle - half), y - size * sin(angle - half),
           x - size * cos(angle + half), y - size * sin(angle + half));
}

static inline void svg_arrow(double x1, double y1, double x2, double y2)
{
  svg_line("thin", x1, y1, x2, y2);
  svg_head(x2, y2, atan2(y2 - y1, x2 - x1));
}

/* A dimension: arrows at both ends. */
static inline void svg_dimension(double x1, double y1, double x2, double y2)
{
  svg_arrow(x1, y1, x2, y2);
  svg_head(x1, y1, atan2(y1 - y2, x1 - x2));
}

/* An arc about (x, y), its arrow at angle b; radians, clockwise as y is down. */
static inline void svg_arc(double x, double y, double r, double a, double b)
{
  const double bent = 4.5 / r; /* a straight head looks right if turned by half its length */

  svg_path("thin", "M%.1f %.1fA%.1f %.1f 0 %d %d %.1f %.1f", x + r * cos(a), y + r * sin(a), r, r,
           fabs(b - a) > acos(-1.), b > a, x + r * cos(b), y + r * sin(b));
  svg_head(x + r * cos(b), y + r * sin(b), b > a ? b + acos(0.) - bent : b - acos(0.) + bent);
}

/* Hatching of something fixed, along a line from (x1, y1); it lies left of it. */
static inline void svg_hatching(double x1, double y1, double x2, double y2)
{
  const double length = hypot(x2 - x1, y2 - y1), step = 9.;
  const double ux = (x2 - x1) / length, uy = (y2 - y1) / length;

  svg_line("", x1, y1, x2, y2);
  for (double s = step / 2.; s < length; s += step)
    svg_line("thin", x1 + s * ux, y1 + s * uy, x1 + (s - 6.) * ux + 9. * uy,
             y1 + (s - 6.) * uy - 9. * ux);
}

static inline void svg_letters(const char *word, size_t length)
{
  static const char *const greek[][2] = {
    { "psi", "ψ" }, { "delta", "δ" }, { "phi", "φ" }, { "lambda", "λ" },
    { "theta", "θ" }, { "xi", "ξ" }, { "eta", "η" }, { "zeta", "ζ" },
  };

  for (size_t i = 0; i < sizeof greek / sizeof *greek; i++)
    if (strlen(greek[i][0]) == length && strncmp(greek[i][0], word, length) == 0) {
      fputs(greek[i][1], stdout);
      return;
    }
  printf("%.*s", (int)length, word);
}

/* anchor: start, middle or end of the name stands at x */
static inline void svg_name(double x, double y, const char *anchor, const char *name)
{
  const size_t stem = strcspn(name, "_*");

  printf("<text class='i' x='%.1f' y='%.1f' text-anchor='%s'>", x, y, anchor);
  svg_letters(name, stem);
  if (name[stem] == '_') {
    printf("<tspan dy='5' font-size='12'>");
    svg_letters(name + stem + 1, strlen(name) - stem - 1);
    printf("</tspan>");
  } else
    printf("%s", name + stem);
  puts("</text>");
}

static inline void svg_note(double x, double y, const char *anchor, const char *text)
{
  printf("<text class='note' x='%.1f' y='%.1f' text-anchor='%s'>%s</text>\n", x, y, anchor, text);
}

#endif
