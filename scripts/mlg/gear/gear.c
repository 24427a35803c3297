/* gear.c - the landing gear and what its letters mean: side, rear and top view
 *
 * x points forward, y to the right, z down, as in models/mlg.h; not to scale, rake and
 * angles larger than they are.
 */
#include "arguments.h"
#include "command.h"
#include "svg.h"

struct at { double x, y; }; /* on the page, px */

static const double l_delta = 215., l_D = 150., R = 74., e = 56., a = 170., tread = 40.; /* px */
static const double top = 74., foot = 410.; /* B in the side and the rear view; the notes */

/* from p, by u along the direction at this angle to the page's y, and v to its right */
static struct at moved(struct at p, double angle, double u, double v)
{
  return (struct at){ p.x + u * sin(angle) + v * cos(angle), p.y + u * cos(angle) - v * sin(angle) };
}

static void line(const char *look, struct at p, struct at q) { svg_line(look, p.x, p.y, q.x, q.y); }
static void dimension(struct at p, struct at q) { svg_dimension(p.x, p.y, q.x, q.y); }
static void dot(const char *look, struct at p, double r) { svg_circle(look, p.x, p.y, r); }

/* A bar from p to q. */
static void bar(struct at p, struct at q, double width)
{
  const double angle = atan2(q.x - p.x, q.y - p.y);
  const struct at p1 = moved(p, angle, 0., -width / 2.), p2 = moved(p, angle, 0., width / 2.);
  const struct at q1 = moved(q, angle, 0., -width / 2.), q2 = moved(q, angle, 0., width / 2.);

  svg_path("solid", "M%.1f %.1fL%.1f %.1fL%.1f %.1fL%.1f %.1fz", p1.x, p1.y, q1.x, q1.y, q2.x, q2.y, p2.x, p2.y);
}

/* A dimension beside p to q, offset to the right, with its name. */
static void beside(struct at p, struct at q, double offset, const char *name)
{
  const double angle = atan2(q.x - p.x, q.y - p.y), past = offset < 0. ? -5. : 5.;
  const struct at p1 = moved(p, angle, 0., offset), q1 = moved(q, angle, 0., offset);

  line("thin", moved(p, angle, 0., past), moved(p1, angle, 0., past));
  line("thin", moved(q, angle, 0., past), moved(q1, angle, 0., past));
  dimension(p1, q1);
  const struct at middle = moved((struct at){ (p1.x + q1.x) / 2., (p1.y + q1.y) / 2. }, angle, 0., past * 2.);
  svg_name(middle.x, middle.y + 5., fabs(sin(angle)) > 0.7 ? "middle" : offset < 0. ? "end" : "start", name);
}

/* A wheel seen along its plane: a rounded rectangle about p, turned clockwise. */
static void wheel(const char *look, struct at p, double angle)
{
  printf("<g transform='translate(%.1f %.1f) rotate(%.2f)'>", p.x, p.y, angle * 180. / acos(-1.));
  svg_path(look, "M%.1f %.1fq0 -14 14 -14h%.1fq14 0 14 14v%.1fq0 14 -14 14h%.1fq-14 0 -14 -14z",
           -tread / 2., -R + 14., tread - 28., 2. * R - 28., 28. - tread);
  puts("</g>");
}

static void axes(double x, double y, double dx, const char *right, double dy, const char *other)
{
  svg_arrow(x, y, x + dx, y);
  svg_name(x + dx + 5., y + 5., "start", right);
  svg_arrow(x, y, x, y + dy);
  svg_name(x, y + dy + (dy > 0. ? 16. : -6.), "middle", other);
}

static void body(struct at B)
{
  svg_path("tyre", "M%.1f %.1fh120v-34h-120z", B.x - 60., B.y - 8.);
  svg_name(B.x, B.y - 19., "middle", "M");
}

static void side_view(double x0)
{
  const double phi = 0.29;
  const struct at B = { x0, top };
  const struct at C = moved(B, phi, l_delta, 0.), D = moved(B, phi, l_D, 0.);
  const struct at axle = moved(C, phi, 0., -e), trail = moved(C, phi, 40., 0.), links = moved(B, phi, 182., 0.);
  const double ground = axle.y + R;

  body(B);
  dot("tyre", axle, R);
  bar(axle, C, 9.);
  bar(B, moved(C, phi, 7., 0.), 17.);
  dot("solid", axle, 7.);
  dot("solid", B, 5.);
  dot("head", C, 2.5);
  dot("head", D, 4.);
  svg_hatching(axle.x + 125., ground, axle.x - 85., ground);
  line("dash", B, (struct at){ B.x, B.y + 150. });
  svg_arc(B.x, B.y, 112., acos(0.), acos(0.) - phi + 0.076);
  svg_name(B.x + 11., B.y + 103., "middle", "phi");
  beside(B, C, 84., "l_delta");
  beside(B, D, 44., "l_D");
  line("thin", moved(axle, phi, 5., 0.), moved(axle, phi, 46., 0.));
  line("thin", moved(C, phi, 10., 0.), moved(trail, phi, 6., 0.));
  dimension(moved(axle, phi, 40., 0.), trail);
  svg_name(axle.x + 20., axle.y + 62., "middle", "e");
  const struct at rim = moved(axle, -0.95, R, 0.);
  svg_arrow(axle.x, axle.y, rim.x, rim.y);
  svg_name(axle.x - 38., axle.y + 17., "middle", "R");
  /* torsion about the strut: its front half passes the viewer from right to left */
  const struct at right = moved(links, phi, 0., 24.), left = moved(links, phi, 0., -24.);
  svg_path("thin", "M%.1f %.1fA24 8 %.1f 0 1 %.1f %.1f", right.x, right.y, -phi * 180. / acos(-1.), left.x, left.y);
  svg_head(left.x, left.y, -2.0);
  svg_name(left.x - 10., left.y + 4., "end", "psi");
  svg_name(B.x - 14., B.y + 18., "end", "B");
  svg_name(D.x - 14., D.y - 1., "end", "D");
  svg_name(C.x + 24., C.y + 9., "start", "C");
  svg_arrow(B.x + 66., B.y - 25., B.x + 112., B.y - 25.);
  svg_name(B.x + 90., B.y - 32., "middle", "V");
  axes(x0 - 105., top + 62., 28., "x", 28., "z");
  svg_note(x0 + 20., foot, "middle", "(a) from the right");
}

static void rear_view(double x0)
{
  const double delta = -0.15; /* C moves to the left */
  const struct at B = { x0, top }, straight = { x0, top + l_delta };
  const struct at C = moved(B, delta, l_delta, 0.);
  const struct at left = moved(C, delta, 0., -a / 2.), right = moved(C, delta, 0., a / 2.);
  const double ground = left.y + R + 3.;

  body(B);
  wheel("tyre", left, -delta);
  wheel("tyre", right, -delta);
  bar(left, right, 9.);
  bar(B, C, 13.);
  dot("solid", B, 5.);
  dot("head", C, 2.5);
  printf("<rect x='%.1f' y='%.1f' width='270' height='60' fill='#fff'/>\n", C.x - 135., ground);
  svg_hatching(C.x + 135., ground, C.x - 135., ground);
  line("dash", B, (struct at){ straight.x, straight.y + 60. });
  svg_arc(B.x, B.y, 86., acos(0.) - 0.3, acos(0.) - delta - 0.1);
  svg_name(B.x + 30., B.y + 88., "start", "delta");
  svg_dimension(C.x, C.y + 30., straight.x, C.y + 30.);
  line("thin", C, (struct at){ C.x, C.y + 36. });
  svg_name((C.x + straight.x) / 2., C.y + 50., "middle", "delta*");
  beside(left, right, 104., "a");
  svg_name(B.x - 14., B.y + 18., "end", "B");
  svg_name(C.x - 14., C.y - 12., "end", "C");
  svg_name(left.x - 34., left.y + 5., "end", "L");
  svg_name(right.x + 34., right.y + 5., "start", "R");
  axes(x0 + 66., top + 30., 28., "y", 28., "z");
  svg_note(x0, foot, "middle", "(b) from behind");
}

static void top_view(double x0)
{
  const double psi = 0.24, lambda = 15., h = 27., l = 56.; /* turned to the right */
  const double back = -psi; /* the way back from C, as an angle to the page's y */
  const struct at C = { x0, top + 52. };
  const struct at axle = moved(C, back, e + 30., 0.);
  const struct at hub[2] = { moved(axle, back, 0., -a / 2.), moved(axle, back, 0., a / 2.) };
  const double outside[2] = { -1., 1. };

  svg_line("dash", C.x, C.y + 6., C.x, C.y + 210.);
  for (int i = 0; i < 2; i++)
    wheel("tyre", hub[i], psi);
  bar(hub[0], hub[1], 9.);
  bar(C, axle, 9.);
  dot("solid", C, 9.);
  for (int i = 0; i < 2; i++) {
    const struct at lead = moved(hub[i], back, -h, lambda), rear = { lead.x, lead.y + 2. * h * cos(psi) };

    line("dash", moved(hub[i], back, -R - 14., 0.), moved(hub[i], back, R + 14., 0.));
    svg_path("ghost", "M%.1f %.1fL%.1f %.1f", rear.x, rear.y, lead.x, lead.y);
    printf("<path class='ghost' style='stroke-dasharray:3 3' d='M%.1f %.1f", lead.x, lead.y);
    for (double s = 4.; s <= 2. * l; s += 4.) { /* the string before the contact */
      const struct at p = moved(hub[i], back, -h - s, lambda * exp(-s / l));

      printf("L%.1f %.1f", p.x, p.y);
    }
    puts("'/>");
    dot("ghost", lead, 2.);
    const struct at plane = moved(hub[i], back, -h, 0.), far = moved(hub[i], back, -h, outside[i] * 52.);
    line("thin", plane, far);
    line("thin", lead, far);
    svg_name(far.x + 4. * outside[i], far.y + 2., i ? "start" : "end", i ? "lambda_R" : "lambda_L");
  }
  line("dash", axle, moved(C, back, 178., 0.));
  beside(moved(hub[1], back, -h, 16.), moved(hub[1], back, 0., 16.), 20., "h");
  svg_arc(C.x, C.y, 150., acos(0.), acos(0.) + psi - 0.06);
  svg_name(C.x - 17., C.y + 170., "middle", "psi");
  svg_name(C.x + 18., C.y + 6., "start", "C");
  svg_arrow(C.x, C.y - 12., C.x, C.y - 58.);
  svg_name(C.x + 10., C.y - 40., "start", "V");
  axes(x0 + 106., top + 275., 28., "y", -28., "x");
  svg_note(x0, foot, "middle", "(c) from above");
}

static int gear(int argc, char *argv[])
{
  if (argc > 1)
    refuse(argv[0], argv[1], "expected nothing behind the command");
  svg_begin(960., 426., "the landing gear");
  side_view(130.);
  rear_view(470.);
  top_view(800.);
  svg_end();
  return output_status(argv[0]);
}

const struct command command_gear = {
  .name = "gear",
  .usage = "",
  .summary = "a drawing of the landing gear with its letters, as SVG",
  .details = "Side, rear and top view, not to scale: docs/drawings/gear.svg.\n",
  .run = gear,
};
