"""svg.py - what a picture of gnuplot's draws, read out of its SVG in the units of its axes

read(file) gives the panels in the order of drawing, each a list of Drawn: the style of a
line, a filled area or a point and its corners as numbers (x, y) of the axes.  Of what has a
name in the key only lines of more than two corners are: the others may be its samples there.
"""
import math
import re
from collections import namedtuple

# kind: line, area or point; colour "#rrggbb"; mark: dashes of a line, "solid" or the pattern of
# an area, gnuplot's name of a point; at: corners; edge: whether a corner lies on the frame
# name: in the key, or ""
Drawn = namedtuple("Drawn", "kind colour mark at edge name", defaults=("",))

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def colour(text):
    numbers = re.findall(r"\d+", text)
    if text.startswith("rgb") and len(numbers) == 3:
        return "#%02x%02x%02x" % tuple(map(int, numbers))
    return {"black": "#000000", "white": "#ffffff"}.get(text, text)


def corners(path):
    """The corners of each stroke of a path."""
    strokes = []
    for move, x, y in re.findall(r"([ML]|(?<=[\d]) ) ?(-?[\d.]+),(-?[\d.]+)", path):
        if move == "M" or not strokes:
            strokes.append([])
        strokes[-1].append((float(x), float(y)))
    return strokes


def value(label):
    """The number that a label of an axis shows; 10^n in two sizes of type."""
    texts = re.findall(r"<tspan[^>]*>([^<]*)</tspan>", label)
    texts = [t.replace("\u2212", "-").strip() for t in texts if t.strip()]
    if len(texts) >= 2 and texts[0] == "10":
        return 10.0 ** float(texts[1])
    return float(texts[0]) if len(texts) == 1 and NUMBER.fullmatch(texts[0]) else None


class Axes:
    """From places on the page to numbers on the axes, by the labels at their ticks."""

    def __init__(self, text):
        ticks = re.findall(r"M([\d.]+),([\d.]+) L([\d.]+),([\d.]+)  '/>\s*<g transform=\"translate[^>]*>(.*?)</g>",
                           text, re.S)
        x, y = {}, {}
        for x0, y0, x1, y1, label in ticks:
            number = value(label)
            if number is None:
                continue
            if x0 == x1:
                x[float(x0)] = number
            elif y0 == y1:
                y[float(y0)] = number
        self.x, self.y = self.map(x), self.map(y)
        frame = re.findall(r"<path stroke='black'  d='M([\d.]+),([\d.]+) L([\d.]+),([\d.]+) L([\d.]+),([\d.]+) L([\d.]+),([\d.]+) L[\d.]+,[\d.]+ Z  '/>", text)
        box = [float(t) for t in frame[-1]]
        self.left, self.right = min(box[0::2]), max(box[0::2])
        self.top, self.bottom = min(box[1::2]), max(box[1::2])

    @staticmethod
    def map(ticks):
        """Linear in the number or in its logarithm, as the ticks in the middle tell."""
        (p, a), (q, b) = min(ticks.items()), max(ticks.items())

        def line(place):
            return a + (b - a) * (place - p) / (q - p)

        def power(place):
            return a * (b / a) ** ((place - p) / (q - p))

        def off(f):
            return max(abs(f(place) - number) for place, number in ticks.items())

        if not (a > 0 and b > 0):
            return line
        few = len(ticks) == 2 and max(a, b) >= 10 * min(a, b)
        return power if few or off(power) < off(line) else line

    def numbers(self, at):
        return [(self.x(px), self.y(py)) for px, py in at]

    def on_edge(self, at):
        return [min(abs(px - self.left), abs(px - self.right), abs(py - self.top), abs(py - self.bottom)) < 0.2 for px, py in at]


def drawn_in(group, axes):
    for element in re.finditer(r"<(path|polygon|use)\b([^>]*)>", group):
        word, rest = element.groups()
        values = dict(re.findall(r"([\w:-]+) ?= ?['\"]([^'\"]*)['\"]", rest))
        if word == "use":
            x, y = map(float, re.search(r"translate\(([-\d.]+),([-\d.]+)\)", values["transform"]).groups())
            before = group[:element.start()]
            tint = values.get("color") or (re.findall(r'color="([^"]*)"', before) or ["black"])[-1]
            yield Drawn("point", colour(tint), values["xlink:href"].lstrip("#"), axes.numbers([(x, y)]), axes.on_edge([(x, y)]))
            continue
        fill = values.get("fill", "none")
        strokes = corners(values.get("d", "")) if word == "path" else [
            [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+),(-?[\d.]+)", values["points"])]]
        for at in strokes:
            if fill != "none":
                pattern = re.search(r"url\(#(\w+)\)", fill)
                tint = fill
                if pattern:
                    inside = re.search(r"<pattern id='%s'.*?</pattern>" % pattern.group(1), group, re.S)
                    tint = re.search(r"stroke[=:]['\"]?(rgb\([^)]*\)|#\w+)", inside.group(0)).group(1)
                yield Drawn("area", colour(tint), "pattern" if pattern else "solid", axes.numbers(at), axes.on_edge(at))
            elif len(at) > 1:
                yield Drawn("line", colour(values.get("stroke", "black")), values.get("stroke-dasharray", ""), axes.numbers(at), axes.on_edge(at))


def read(file):
    text = open(file, encoding="utf-8").read()
    # every plot is opened twice, the second time without content
    begins = [m for m in re.finditer(r'<g id="gnuplot_plot_(\d+)([a-z]+)" ?><title>([^<]*)</title>', text)]
    panels, before = [], 0
    for i, m in enumerate(begins):
        end = begins[i + 1].start() if i + 1 < len(begins) else len(text)
        letter = m.group(2)
        if not panels or panels[-1][0] != letter:
            axes = Axes(text[before:m.start()])
            panels.append((letter, axes, []))
        content = text[m.start():end]
        # the group ends where all that it opened has been closed
        depth = 0
        for tag in re.finditer(r"<(/?)g\b[^>]*?(/?)>", content):
            depth += -1 if tag.group(1) else 0 if tag.group(2) else 1
            if depth == 0:
                content = content[:tag.end()]
                break
        before = m.start() + len(content)
        name = "" if m.group(3).startswith("gnuplot_plot_") else m.group(3)
        panels[-1][2].extend(d._replace(name=name) for d in drawn_in(content, panels[-1][1])
                             if not name or (d.kind == "line" and len(d.at) > 2))
    return [drawn for _, _, drawn in panels]
