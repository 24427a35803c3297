"""check.py - do pictures draw what the tables say, each curve in its style and its units?

    python3 tests/pictures/check.py FOLDER FIGURE...

What each picture has to show is written here a second time, from FOLDER's tables; what it
shows is read out of FOLDER/FIGURE.svg (svg.py).  Of each kind of line, area and point every
drawn corner has to be one of the table's or lie on the line between two, and all of the
table's within the axes have to be drawn.  A line for each difference; status 1.
"""
import csv
import math
import sys

import svg

BLUE, RED, GREEN, ORANGE, PURPLE = "#1f4fd8", "#d62728", "#2a9d5c", "#e08214", "#7b3fa0"
BLACK, GREY = "#000000", "#d9d9d9"
folder, wrong = sys.argv[1], []


def table(name):
    with open("%s/%s.csv" % (folder, name), encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def number(text):
    return float(text) if text else math.nan


def some(of):
    """All, or of many about a hundred, evenly."""
    return of[::max(1, len(of) // 100)]


class Panel:
    """What one panel shows, in shares of its axes' lengths."""

    def __init__(self, name, drawn, x, y, log=""):
        self.name, self.drawn, self.x, self.y, self.log = name, drawn, x, y, log
        self.seen = set()

    def share(self, at):
        places = []
        for value, (low, high), axis in zip(at, (self.x, self.y), "xy"):
            if axis in self.log:
                value = math.log(value / low) / math.log(high / low) if value > 0 else math.nan
            else:
                value = (value - low) / (high - low)
            places.append(value)
        return tuple(places)

    def empty(self, curves):
        return not any(self.inside(self.share(at)) for curve in curves for at in curve)

    def inside(self, share, by=1e-3):
        return all(by < s < 1 - by for s in share)

    def off(self, share, lines):
        """How far a place is from some lines, each a list of places."""
        least = math.inf
        for line in lines:
            if len(line) == 1:
                least = min(least, math.dist(share, line[0]))
            for a, b in zip(line, line[1:]):
                length = math.dist(a, b) ** 2
                t = 0 if length == 0 else max(0, min(1, sum((s - p) * (q - p) for s, p, q in zip(share, a, b)) / length))
                least = min(least, math.dist(share, [p + t * (q - p) for p, q in zip(a, b)]))
        return least

    def shows(self, kind, colour, mark, curves, within=1.5e-3):
        """These curves, lists of (x, y) with None where the pen is lifted, and no others."""
        drawn = [d for d in self.drawn if (d.kind, d.colour) == (kind, colour) and mark(d.mark)]
        self.seen.update(id(d) for d in drawn)
        lines = []
        for curve in curves:
            lines.append([])
            for at in curve:
                if at is None or any(map(math.isnan, at)):
                    lines.append([])
                else:
                    lines[-1].append(self.share(at))
        lines = [line for line in lines if len(line) > (kind != "point")]
        strokes = [[self.share(at) for at in d.at] for d in drawn]
        what = "%s: %s %s" % (self.name, kind, colour)
        if not lines:
            wrong.append("%s: the table has none of it" % what)
        count = 0
        for d, stroke in zip(drawn, strokes):
            for share, edge in some(list(zip(stroke, d.edge))):
                if not edge and self.inside(share) and self.off(share, lines) > within:
                    wrong.append("%s: drawn at %.3f, %.3f of the axes, which is not in the table" % (what, *share))
                    return
                count += 1
        for line in lines:
            for share in some(line):
                if self.inside(share) and self.off(share, strokes) > within:
                    wrong.append("%s: not drawn at %.3f, %.3f of the axes" % (what, *share))
                    return
        if not count:
            wrong.append("%s: nothing is drawn" % what)

    def nothing_else(self):
        for d in self.drawn:
            if id(d) not in self.seen:
                wrong.append("%s: %s %s %s is not expected" % (self.name, d.kind, d.colour, d.mark))
                return


def solid(mark):
    return mark == ""


def dashed(mark):
    return "," in mark


def is_point(name):
    return lambda mark: mark == name


def is_fill(name):
    return lambda mark: mark == name


def curves_of(rows, keys, x, y):
    """A curve for each run of rows of the same keys, of (x(row), y(row))."""
    curves, last = [], None
    for row in rows:
        key = [row[k] for k in keys]
        if key != last:
            curves.append([])
            last = key
        curves[-1].append((x(row), y(row)))
    return curves


def fig06(panels):
    rows = table("fig06")
    tops = {"a": (4.5, 15), "b": (0.5, 12), "c": (10, 1)}
    for i, drawn in enumerate(panels):
        letter, column, factor = "abc"[i // 2], ("psi_max", "dstar_max")[i % 2], (1, 1000)[i % 2]
        top = tops[letter][i % 2]
        panel = Panel("fig06 (%s%d)" % (letter, i % 2 + 1), drawn, (0, 80), (-0.1 * top, top))
        mine = [r for r in rows if r["panel"] == letter]

        def at(r):
            return float(r["V"]), factor * number(r[column])

        branches = [[r for r in mine if r["branch"] == b] for b in ("straight", "psi", "delta")]
        panel.shows("line", RED, dashed, [[at(r) for r in b] for b in branches])
        panel.shows("line", BLUE, solid, [[at(r) if r["stable"] == "1" else None for r in b] for b in branches])
        for kind, colour, mark in ("HB", RED, "gpPt6"), ("TR", BLACK, "gpPt5"):
            if any(r["type"] == kind for r in mine):
                panel.shows("point", colour, is_point(mark), [[at(r)] for r in mine if r["type"] == kind])
        if letter == "a":
            panel.shows("point", BLACK, is_point("gpPt2"),
                        [[at(r)] for r in mine if (r["branch"], float(r["V"])) in (("psi", 20.0), ("delta", 40.0))])
        panel.nothing_else()


def fig07(panels):
    rows = table("fig07")

    def at(r):
        return float(r["V"]), 1e-3 * float(r["c_d"])

    def of(names):
        return [[at(r) for r in rows if r["curve"] == name] for name in names]

    ends = [1e-3 * max(float(r["c_d"]) for r in rows if r["curve"] == name and r["type"] == "LP") for name in ("low", "delta")]
    for name, drawn, x, y in zip(("fig07", "fig07 inset"), panels, ((0, 200), (0, 80)), ((0, 80), (2, 4))):
        panel = Panel(name, [d for d in drawn if d.colour != "#ffffff"], x, y)
        panel.drawn = [d for d in panel.drawn if not (d.kind == "line" and d.colour == BLACK)] # boxes of words, arrows
        for kind, colour in ("psi", ORANGE), ("delta", GREEN):
            curves = curves_of([r for r in rows if r["shimmy"] == kind and not r["curve"].startswith("torus")], ["curve"],
                               lambda r: float(r["V"]), lambda r: 1e-3 * float(r["c_d"]))
            # a filled curve is closed
            panel.shows("area", colour, is_fill("pattern"), [c + [c[0]] for c in curves])
        panel.shows("line", RED, solid, of(("psi", "delta", "low")))
        if name == "fig07":
            panel.shows("line", PURPLE, dashed, of(("torus_psi", "torus_delta")))
            panel.shows("point", BLACK, is_point("gpPt6"), [[at(r)] for r in rows if r["curve"] == "psi" and r["type"] == "HH"])
        panel.shows("line", BLUE, solid, [[(x[0], end), (x[1], end)] for end in ends])
        panel.nothing_else()


def stiffness(name):
    """The number in "4.8\u00b710" with its exponent."""
    if name == "\u221e":
        return math.inf
    parts = name.split("\u00b710")
    return float(parts[0]) * 10.0 ** float(parts[1]) if len(parts) == 2 else math.nan


def diagrams(name, panels, y):
    rows = table(name)
    letters = sorted({r["panel"] for r in rows})
    colours = {}
    if len(letters) != len(panels):
        wrong.append("%s: %d panels for %d letters" % (name, len(panels), len(letters)))
    for letter, drawn in zip(letters, panels):
        panel = Panel("%s (%s)" % (name, letter), drawn, (0, 100), y, "y")
        mine = [r for r in rows if r["panel"] == letter]
        for k_s in sorted({r["k_s"] for r in mine}, key=float):
            def curves(shimmy):
                return curves_of([r for r in mine if r["k_s"] == k_s and r["shimmy"] == shimmy], ["curve"],
                                 lambda r: float(r["V"]), lambda r: float(r["c_d"]))
            # one colour a k_s, whatever the panel: that of the lines which have its name
            tints = {d.colour for d in drawn if math.isclose(stiffness(d.name), float(k_s), rel_tol=1e-9)}
            if tints != {colours.setdefault(k_s, *tints)} if tints else not panel.empty(curves("psi")):
                wrong.append("%s: k_s = %s is drawn in %s" % (panel.name, k_s, " ".join(tints) or "nothing"))
                continue
            panel.shows("line", colours[k_s], solid, curves("psi"))
            if curves("delta"):
                panel.shows("line", colours[k_s], dashed, curves("delta"))
        panel.nothing_else()
    if "inf" in colours and colours["inf"] != BLACK:
        wrong.append("%s: the rigid one is not black" % name)


def boundary(layout, b, names):
    """Boundary points over k_s in MN m/rad and kN m s/rad, a list a curve."""
    rows = [r for r in table("boundary_points") if r["layout"] == layout and float(r["b"]) == b and r["name"] in names
            and r["k_s"] != "inf"]
    return curves_of(rows, ["curve"], lambda r: 1e-6 * float(r["k_s"]), lambda r: 1e-3 * float(r["c_d"]))


def intervals(name, layout, b):
    return [(1e-6 * number(r["k_s"]), 1e-3 * number(r["c_lo"]), 1e-3 * number(r["c_hi"]), 1e-3 * number(r["width"]))
            for r in table(name) if r["layout"] == layout and float(r["b"]) == b and r["c_lo"] and r["k_s"] != "inf"]


def near(panel, kind, colour, mark, places, within):
    """Every corner drawn is near one of these places, which are many."""
    drawn = [d for d in panel.drawn if (d.kind, d.colour) == (kind, colour) and mark(d.mark)]
    panel.seen.update(id(d) for d in drawn)
    shares = [panel.share(at) for at in places]
    corners = [panel.share(at) for d in drawn for at, edge in zip(d.at, d.edge) if not edge]
    if not corners:
        wrong.append("%s: %s %s: nothing is drawn" % (panel.name, kind, colour))
    for share in corners:
        if panel.inside(share) and min(math.dist(share, s) for s in shares) > within:
            wrong.append("%s: %s %s: drawn at %.3f, %.3f of the axes, which is not in the table" % (panel.name, kind, colour, *share))
            return
    lines = [[panel.share(at) for at in d.at] for d in drawn]
    for share in shares:
        if panel.inside(share) and panel.off(share, lines) > within:
            wrong.append("%s: %s %s: not drawn at %.3f, %.3f of the axes" % (panel.name, kind, colour, *share))
            return


def regions(panel, layout, b, name, third):
    """The region in grey and the boundary points in their colours, up to smoothing."""
    rows = intervals(name, layout, b)
    near(panel, "area", GREY, is_fill("solid"), [(k, lo) for k, lo, _, _ in rows] + [(k, hi) for k, _, hi, _ in rows], 4e-3)
    for colour, names in ((RED, {"BP3", "meet"}), (BLUE, {"BP1", "meet"}), (GREEN, {"BP2_l", "BP2_u", "onset"}), (ORANGE, {"psi3", "meet"})):
        if colour == ORANGE and not third:
            continue
        curves = boundary(layout, b, names)
        if any(sum(panel.inside(panel.share(at)) for at in c) > 1 for c in curves):
            panel.shows("line", colour, solid, curves, within=6e-3)


def fig10(panels):
    panel = Panel("fig10 (b)", panels[0], (0.4, 1.6), (0, 25))
    regions(panel, "l2", 0.0, "fig10", False)
    panel.nothing_else()
    panel = Panel("fig10 (c)", panels[1], (0.4, 2.4), (0, 11))
    rows = intervals("fig10", "l2", 0.0)
    onset = 1e-6 * max(float(r["k_s"]) for r in table("boundary_points") if r["layout"] == "l2" and r["name"] == "onset")
    near(panel, "line", BLACK, solid, [(k, w) for k, _, _, w in rows if k <= onset], 4e-3)
    near(panel, "line", GREEN, solid, [(k, w) for k, _, _, w in rows if k > onset], 4e-3)
    panel.drawn = [d for d in panel.drawn if d.mark == ""]
    panel.nothing_else()
    panel = Panel("fig10 (a)", panels[2], (0, 80), (0, 60))
    mine = [r for r in table("fig09") if r["panel"] == "a" and r["k_s"] == "1e6"]
    panel.shows("line", RED, solid, curves_of(mine, ["curve"], lambda r: float(r["V"]), lambda r: 1e-3 * float(r["c_d"])))
    panel.shows("point", BLACK, is_point("gpPt6"), [[(float(r["V"]), 1e-3 * float(r["c_d"]))] for r in mine if r["type"] == "LP"])
    panel.nothing_else()


def fig13(panels):
    widths = [r for r in table("widths") if r["layout"] == "li1"]
    for b, drawn in zip((20.0, 30.0, 70.0, 100.0, 130.0, 150.0), panels):
        panel = Panel("fig13, b = %g" % b, drawn, (0.3, 1.0), (0, 20))
        regions(panel, "li1", b, "fig13", True)
        panel.shows("line", BLACK, solid, [[(1e-6 * number(r["k_s"]), 1e-3 * number(r[c])) for c in ("c_lo", "c_hi")]
                                           for r in widths if float(r["b"]) == b])
        panel.nothing_else()
    panel = Panel("fig13 (b)", panels[6], (0, 200), (0, 13))

    def at(r):
        return float(r["b"]), 1e-3 * float(r["width"])

    panel.shows("line", BLUE, solid, [[at(r) for r in widths]])
    tens = [r for r in widths if float(r["b"]) % 10 == 0]
    others = [r for r in widths if float(r["b"]) % 10 != 0]
    panel.shows("point", BLUE, is_point("gpPt6"), [[at(r)] for r in tens])
    panel.shows("point", BLACK, is_point("gpPt5"), [[at(r)] for r in others])
    panel.shows("line", "#808080", dashed, [[at(r), (at(r)[0], 13)] for r in others])
    panel.shows("point", BLACK, is_point("gpPt2"), [[at(r)] for r in others if 140 < float(r["b"]) < 150])
    panel.nothing_else()


def fig15(panels):
    panel = Panel("fig15 (a)", panels[0], (0.45, 5), (0, 25), "x")
    widths = [r for r in table("widths") if r["layout"] == "li2"]
    for b, colour in zip((0.0, 50.0, 80.0, 100.0, 120.0, 140.0), (BLACK, BLUE, GREEN, "#d62ad6", ORANGE, RED)):
        rows = intervals("fig15", "li2", b)
        places = [(k, lo) for k, lo, _, _ in rows] + [(k, hi) for k, _, hi, _ in rows]
        near(panel, "area", colour, is_fill("solid"), places, 6e-3)
        panel.shows("line", colour, dashed, [[(1e-6 * number(r["k_s"]), 1e-3 * number(r[c])) for c in ("c_lo", "c_hi")]
                                             for r in widths if float(r["b"]) == b and r["k_s"]])
    panel = Panel("fig15 (b)", panels[1], (0, 300), (0, 24))
    at = [(float(r["b"]), 1e-3 * float(r["width"])) for r in widths]
    panel.shows("line", BLUE, solid, [at])
    panel.shows("point", BLUE, is_point("gpPt6"), [[a] for a in at])
    panel.shows("point", BLACK, is_point("gpPt2"), [[a] for a in at if a[0] == 140])
    panel.nothing_else()


FIGURES = {"fig06": fig06, "fig07": fig07, "fig10": fig10, "fig13": fig13, "fig15": fig15,
           "fig09": lambda panels: diagrams("fig09", panels, (1e3, 8e4)),
           "fig12": lambda panels: diagrams("fig12", panels, (100, 4e4)),
           "fig14": lambda panels: diagrams("fig14", panels, (1e3, 8e4))}

for figure in sys.argv[2:]:
    if figure not in FIGURES:
        sys.exit("check: no figure '%s'; there are %s" % (figure, " ".join(sorted(FIGURES))))
    FIGURES[figure](svg.read("%s/%s.svg" % (folder, figure)))
print("\n".join(wrong), end="\n" if wrong else "")
sys.exit(bool(wrong))
