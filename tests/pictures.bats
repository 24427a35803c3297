# pictures.bats - do the figures draw what their tables say?
#
# Each is drawn from the tables in results/ and read out of its SVG in the units of its
# axes (pictures/svg.py): every line, area and point in its style, at the table's values, and
# no other (pictures/check.py).
#
# Needs   build/bin/mlg, gnuplot, python3
# Writes  build/tests/pictures

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch pictures
  cp -rp "$ROOT/results" .
  mkdir -p build/{tables,stamps}
}

setup() {
  cd "$SCRATCH" || return
}

# draws FIGURE: that picture is drawn anew and shows what it should
draws() {
  rm -f results/"$1".{png,svg}
  scripts/"$1".sh draw
  python3 "$ROOT/tests/pictures/check.py" results "$1"
  # each file is what its name says
  [ "$(head -c 8 "results/$1.png" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]
  [[ $(head -n 1 "results/$1.svg") == '<?xml '* ]]
  grep -q '^<svg' "results/$1.svg"
}

@test "Figure 6: stable solid, unstable dashed, the points and solutions by name" { draws fig06; }

@test "Figure 7: psi- and delta-shimmy in their shading, curves, the zero-shimmy interval" { draws fig07; }

@test "Figure 9: the curves of each k_s in its colour, dashed for delta" { draws fig09; }

@test "Figure 10: regions, boundary points, width" { draws fig10; }

@test "Figure 12: the curves of each k_s in its colour, dashed for delta" { draws fig12; }

@test "Figure 13: regions, boundary points, largest width" { draws fig13; }

@test "Figure 14: the curves of each k_s in its colour, dashed for delta" { draws fig14; }

@test "Figure 15: regions, widest intervals, largest width" { draws fig15; }

@test "the committed pictures are those of the committed tables" {
  python3 "$ROOT/tests/pictures/check.py" "$ROOT/results" fig06 fig07 fig09 fig10 fig12 fig13 fig14 fig15
}

@test "words and marks of Figure 6 stand at their points" {
  scripts/fig06.sh draw
  # H_1, H_3, H_2, H_4 by speed in (a); T_1 on psi, T_2 on delta
  python3 - <<'END'
import csv, re
rows = [r for r in csv.DictReader(l for l in open("results/fig06.csv") if l[0] != "#") if r["panel"] == "a"]
text = open("results/fig06.svg", encoding="utf-8").read()
begin, end = text.index("gnuplot_plot_1a"), text.index("gnuplot_plot_1b")
found = re.findall(r'translate\(([\d.]+),([\d.]+)\)"[^>]*>\s*<text>(.*?)</text>', text[begin:end], re.S)
names = {}
for x, y, label in found:
    name = "".join(re.findall(r">([^<]*)<", ">" + label))
    if re.fullmatch(r"[HT]\d", name.strip()):
        names.setdefault(name.strip(), float(x))
hopf = sorted(float(r["V"]) for r in rows if r["branch"] == "straight" and r["type"] == "HB")
assert [n for n, _ in sorted(((n, x) for n, x in names.items() if n[0] == "H"), key=lambda p: p[1])] == ["H1", "H3", "H2", "H4"], names
tori = {r["branch"]: float(r["V"]) for r in rows if r["type"] == "TR"}
assert len(hopf) == 4 and (names["T1"] < names["T2"]) == (tori["psi"] < tori["delta"]), names
END
}
