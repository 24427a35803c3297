#!/usr/bin/env bash
# The results as one readable page: results/README.md, from the tables alone.
# Needs: results/*.csv (scripts/collect.sh, scripts/targets.sh)
. "$(dirname "$0")/lib.sh"
alone results

# width COLUMN LAYOUT B: a cell of widths.csv (1 layout, 2 b, 3 k_s, 6 width)
width() {
  awk -F, -v c="$1" -v layout="$2" -v b="$3" '$1 == layout && $2 == b { print $c }' results/widths.csv
}

# The b of LI1 at which another limit takes over.
handovers() {
  awk -F, '$1 == "li1" && $2 % 10 != 0 { printf "%s%.5g", n++ ? ", " : "", $2 }' results/widths.csv
}

rounded() { awk -v x="$1" -v f="$2" 'BEGIN { printf f, x }'; }

best() { # COLUMN: of the largest width of LI1
  awk -F, -v c="$1" '$1 == "li1" && $6 > w { w = $6; x = $c } END { print x }' results/widths.csv
}

picture() { # NUMBER CAPTION
  printf '### Figure %d\n\n%s\n\n![Figure %d](fig%02d.png)\n\n' "$1" "$2" "$1" "$1"
}

{
  cat <<TEXT
# Results

Made by \`make\` from AUTO's runs; every number here is read from the tables
beside this page. \`docs/runs.md\` says how they come about and what their columns
are.

## Paper against computed

\`paper\` is what its text says ("figure": shown there, not printed), \`converged\`
the value computed without AUTO or on a refined mesh, \`computed\` this run.

| id | quantity | unit | paper | converged | computed | tolerance | pass |
|---|---|---|---|---|---|---|---|
TEXT
  awk -F, '!/^#/ && $1 != "id" { gsub(/,/, " | "); print "| " $0 " |" }' results/targets.csv
  cat <<TEXT

## Where the paper's account differs

- **BP1 and BP3.** Section 3.2 names them "of the upper and lower psi-shimmy
  regions, respectively". Its Figure 10 and all that follows need the reverse: BP1
  is the top of the lower psi region, BP3 the bottom of the upper one.
- **L2.** The width still grows beyond the k_s = 7.86e5 N m/rad of the paper, up to
  the onset of the delta region at $(rounded "$(width 3 li2 0)" %.2f) N m/rad: $(rounded "$(width 6 li2 0)" %.1f)
  instead of 10218.6 N m s/rad. The gains below refer to this largest width.
- **LI1, b = 20.** The paper finds it like L2, with the first qualitative change at
  b = 30. Here the delta region is born below BP1 from b = 17.64 on: at b = 20 the
  width goes on growing after the onset, until BP2_u reaches BP1
  (k_s = $(rounded "$(width 3 li1 20)" %.0f) N m/rad).
- **LI1, b = 21.5 to 47.8.** The paper says of b = 30 that the region is bounded by BP1
  and BP3 and largest just before BP2_u exceeds BP1. The interval between BP2_u and BP3
  goes on growing beyond that, until its width is stationary over k_s:
  $(rounded "$(width 6 li1 30)" %.1f) N m s/rad at b = 30 and k_s = $(rounded "$(width 3 li1 30)" %.0f) N m/rad.
- **LI1, which mechanism limits the width at which b.** In turn: the onset of the delta
  region; BP2_u reaching BP1; the stationary width above BP2_u; BP2_u reaching BP1
  again; the onset again, above BP1; the onset above the third psi region; BP2_u
  reaching the top of that region. They change at b = $(handovers).
  At the last of these only 100 N m s/rad are left: the third psi region has nearly
  reached BP3. At b = 200 there is no zero-shimmy interval at any k_s.
- **LI1, third psi region.** The paper sees it for b = 70 to 150. It is there at b = 30
  too, with its top below c_d = 62 N m s/rad. Its top rises with b, and falls with k_s.
- **LI1, the optimum.** Largest at b = $(rounded "$(best 2)" %.4f) N m s^2/rad and k_s = $(rounded "$(best 3)" %.1f) N m/rad,
  where the third psi region takes over from BP1 as the lower bound: $(rounded "$(best 6)" %.2f)
  N m s/rad, $(awk -v x="$(best 6)" -v y="$(width 6 li2 0)" 'BEGIN { printf "%.2f", 100 * (x / y - 1) }') % more than L2. The paper's b = 140 is the nearest multiple of 10, and its 9.8 % is
  1.12/1.02.
- **LI2.** "This growth trend ends with b = 140" is a choice of the paper, not a
  property of the gear: the width grows on, to $(rounded "$(width 6 li2 200)" %.0f) N m s/rad at b = 200 and
  $(rounded "$(width 6 li2 300)" %.0f) at b = 300, always limited by the onset of the delta region. At b = 140
  it is $(rounded "$(width 6 li2 140)" %.1f), $(awk -v x="$(width 6 li2 140)" -v y="$(width 6 li2 0)" 'BEGIN { printf "%.2f", 100 * (x / y - 1) }') % more than L2 (the paper's 87.2 % is about 1.91/1.02).

## Figures

TEXT
  picture 6 "One-parameter diagrams in V, layout L1. Blue solid: stable, red dashed: unstable; red dots: Hopf points, open circles: torus points; A and B: the solutions at V = 20 and 40 m/s."
  picture 7 "The (V, c_d) plane, layout L1. Red: Hopf curves; purple: torus curves between the double Hopf points HH; blue: the zero-shimmy interval; grey: no shimmy. Hatched: straight rolling is unstable to psi, delta or both; which oscillation is stable there, the torus curves tell."
  picture 9 "Hopf curves of layout L2 for several k_s; psi regions solid, delta regions dashed."
  picture 10 "Layout L2: (a) the four boundary points, (b) their c_d over k_s and the zero-shimmy region, (c) its width."
  picture 12 "Hopf curves of layout LI1 for several k_s and b; psi regions solid, delta regions dashed."
  picture 13 "Layout LI1: (a) boundary points and zero-shimmy regions from k_s = 2.86e5 N m/rad on, (b) largest width over k_s."
  picture 14 "Hopf curves of layout LI2 for several k_s, b = 50 and 100; psi regions solid, delta regions dashed."
  picture 15 "Layout LI2: (a) zero-shimmy regions; vertical lines: the widest interval, where a delta region is born, (b) largest width over k_s."
} > results/README.md.new
replace results/README.md
