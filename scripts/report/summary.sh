#!/usr/bin/env bash
# The results as one readable page: results/README.md, from the tables alone.
# scripts/page.sh makes the same page in HTML of it.
# Needs: results/*.csv (scripts/collect.sh, scripts/targets.sh) and the pictures
# A new figure is one call of `picture` below.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
alone results

# number FORMAT TABLE COLUMN [KEY=VALUE ...]: that column of results/TABLE.csv in
# the first row whose columns KEY have these values
number() {
  local format=$1 table=results/$2.csv column=$3
  shift 3
  awk -F, -v format="$format" -v column="$column" -v keys="$*" '
    /^#/ { next }
    !known { for (i = 1; i <= NF; i++) place[$i] = i; known = 1; n = split(keys, key, " "); next }
    {
      for (k = 1; k <= n; k++) {
        split(key[k], pair, "=")
        if ($place[pair[1]] != pair[2]) next
      }
      printf format, $place[column]
      found = 1
      exit
    }
    END { if (!found) printf "MISSING(%s %s %s)", FILENAME, column, keys }' "$table"
}

gain() { # LAYOUT B: its largest width over that of L2, per cent
  awk -v x="$(number %s widths width layout="$1" b="$2")" -v y="$(number %s widths width layout=li2 b=0)" \
    'BEGIN { if (x y ~ /MISSING/) print x y; else printf "%.2f", 100 * (x / y - 1) }'
}

# The b of LI1 at which another limit takes over.
handovers() {
  awk -F, '$1 == "li1" && $2 % 10 != 0 { printf "%s%.5g", n++ ? ", " : "", $2 }' results/widths.csv
}

# The b at which a layout has its largest width.
best() { # LAYOUT
  awk -F, -v layout="$1" '$1 == layout && $6 > w { w = $6; b = $2 } END { print b }' results/widths.csv
}

# Between which b a layout is wider than L2, on straight lines between the rows.
wider_than_l2() { # LAYOUT
  awk -F, -v layout="$1" -v l2="$(number %s widths width layout=li2 b=0)" '
    $1 == layout {
      if (n++ && (w > l2) != ($6 > l2)) ends = ends sprintf("%s%.0f", ends ? " to " : "", b + ($2 - b) * (l2 - w) / ($6 - w))
      b = $2; w = $6
    }
    END { print ends }' results/widths.csv
}

layouts() { grep -l '^#include "plugin.h"' models/*.c | sed 's|.*/||; s|\.c$||'; }

# picture NAME TITLE CAPTION SEE: results/NAME.png, what it is and what to see in it
picture() {
  [ -f "results/$1.png" ] || fail "summary: there is no results/$1.png; its script's word draw makes it"
  printf '### %s\n\n![%s](%s.png)\n\n%s\n\n**What to see.** %s\n\n' "$2" "$2" "$1" "$3" "$4"
}

best=$(best li1)

{
  cat <<TEXT
# Results

Made by \`make\` from AUTO's runs; of the figures beyond the paper, damping, transients,
certify and sections come from targets of these names (LAPACK, SUNDIALS), which \`make\`
alone does not repeat. Every number in the table and in the texts is read from
the tables beside this page. \`docs/runs.md\` says how they come about and what their
columns are. Units are SI, psi in degrees; delta* = l_delta delta is the deflection of the
strut's end in metres.

- [The gear and its devices](#the-gear-and-its-devices)
- [What shimmy is](#what-shimmy-is)
- [Figures of the paper](#figures-of-the-paper)
- [Beyond the paper](#beyond-the-paper)
- [Paper against computed](#paper-against-computed)
- [Checks without AUTO](#checks-without-auto)
- [Where the paper's account differs](#where-the-papers-account-differs)
- [Versions and times](#versions-and-times)

## The gear and its devices

![The gear from the right, from behind and from above](../docs/drawings/gear.svg)

The strut hinges at B and bends sideways by delta; the wheels turn about it by psi. A device
between strut and wheels is to keep both still. Its damping c_d is what the figures below
vary, its stiffness k_s and inertance b what they optimise; k_psi stands for the torque
links.

| layout | device |
|---|---|
$(for layout in $(layouts); do echo "| ${layout^^} | ![${layout^^}](../docs/drawings/$layout.svg) |"; done)

## What shimmy is

TEXT
  picture filmstrip "Psi-shimmy and delta-shimmy" \
    "Solutions A and B of Figure 6 over one period, layout L1 at c_d = 3.6e4 N m s/rad: the angles over time, below them the gear at eight instants. Blue: where the tyres stand on the ground. The angles and the tyres' deflections are drawn larger by the factors in the picture." \
    "In psi-shimmy the wheels turn about the strut, $(number %.2f special_points psi_max run=fig06.a.psi type=UZ) degrees to either side, $(number %.1f special_points frequency_hz run=fig06.a.psi type=UZ) times a second, and the strut hardly bends. In delta-shimmy the strut bends sideways by $(number %.4f special_points dstar_max run=fig06.a.delta type=UZ) m at its end, $(number %.1f special_points frequency_hz run=fig06.a.delta type=UZ) times a second, and the wheels hardly turn. Both feed on the tyres: these follow late, so their forces push the way the gear already moves."
  cat <<TEXT
![The same, moving](filmstrip.gif)

## Figures of the paper

TEXT
  picture fig06 "Figure 6: shimmy over the speed, layout L1" \
    "One-parameter diagrams in V at three dampings c_d; left the largest psi, right the largest delta*. Blue solid: stable, red dashed: unstable; red dots: Hopf points, open circles: torus points; A and B: the solutions at V = 20 and 40 m/s." \
    "Too much damping and too little both let the gear shimmy. At c_d = 3.6e4 (a) straight rolling gives way to psi-shimmy at $(number %.2f special_points V run=fig06.a.straight) m/s, which ends in a torus point at $(number %.2f special_points V run=fig06.a.psi type=TR) m/s; the delta-shimmy on the other branch is stable from $(number %.2f special_points V run=fig06.a.delta type=TR) m/s on, so between the two torus points a disturbance decides which one is seen. At 5e3 (b) delta-shimmy alone is left, at 2e3 (c) psi-shimmy alone."
  picture fig07 "Figure 7: where layout L1 shimmies" \
    "The (V, c_d) plane. Red: Hopf curves; purple: torus curves between the double Hopf points HH; blue: the zero-shimmy interval; grey: no shimmy. Hatched: straight rolling is unstable to psi, delta or both; which oscillation is stable there, the torus curves tell." \
    "Figure 6 is three horizontal cuts through this plane. Only in the strip between the two blue lines, c_d from $(number %.2f special_points c_d run=fig07.low.up type=LP) to $(number %.2f special_points c_d run=fig07.delta.down type=LP) N m s/rad, is there no shimmy at any speed: above the lower psi region and below the delta region. That is the shimmy damper's whole margin."
  picture fig09 "Figure 9: a spring in series with the damper, layout L2" \
    "Hopf curves for several k_s; psi regions solid, delta regions dashed. k_s infinite is L1." \
    "As k_s falls (a) the delta region shrinks to a point and is gone, and the room between the two psi regions is free. As k_s falls further (b) the psi regions approach and merge, and no damping avoids shimmy."
  picture fig10 "Figure 10: the best k_s of layout L2" \
    "(a) The four boundary points, the extrema of c_d along the Hopf curves; (b) their c_d over k_s and the zero-shimmy region; (c) its width." \
    "The region opens where the psi regions part, k_s = $(number %.0f special_points k_s figure=10 type=LP) N m/rad, and is widest just before the delta region is born inside it: $(number %.1f widths width layout=li2 b=0) N m s/rad at k_s = $(number %.0f widths k_s layout=li2 b=0) N m/rad. The edge is sharp: a slightly stiffer spring costs half of it."
  picture fig12 "Figure 12: an inerter beside spring and damper, layout LI1" \
    "Hopf curves for several k_s and b; psi regions solid, delta regions dashed." \
    "At b = 20 the delta region is a small closed curve; at 30 it reaches down to small c_d. From b = 70 on a third psi region rises from below: at 130, with the k_s shown, its top is still under that of the lower psi region, at 150 it is above and bounds the shimmy-free room."
  picture fig13 "Figure 13: the best b and k_s of layout LI1" \
    "(a) Boundary points and zero-shimmy regions from k_s = 2.86e5 N m/rad on, (b) largest width over k_s, and what limits it." \
    "A little inertance harms: the width falls to $(number %.1f widths width layout=li1 b=40) N m s/rad at b = 40, less than half of L2's, and grows again. It exceeds L2's only for b about $(wider_than_l2 li1), and not by much: the largest width, $(number %.1f widths width layout=li1 b="$best") N m s/rad at b = $(number %.2f widths b layout=li1 b="$best") N m s^2/rad and k_s = $(number %.0f widths k_s layout=li1 b="$best") N m/rad, is $(gain li1 "$best") % more than L2 reaches. Beyond, the third psi region takes it away; at b = 200 nothing is left."
  picture fig14 "Figure 14: an inerter beside the series spring, layout LI2" \
    "Hopf curves for several k_s, b = 50 and 100; psi regions solid, delta regions dashed." \
    "At b = 100 a delta region at small k_s shrinks and is gone as k_s grows (b1), and another one is born at large k_s (b2). Between the two the whole room between the psi regions is free, and it is wider than with L2."
  picture fig15 "Figure 15: the best k_s of layout LI2" \
    "(a) Zero-shimmy regions; vertical lines: the widest interval, where a delta region is born; (b) largest width over k_s." \
    "More inertance moves the region to stiffer springs and widens it: $(number %.1f widths width layout=li2 b=140) N m s/rad at b = 140, $(gain li2 140) % more than L2, and still growing at b = 300."
  cat <<TEXT
## Beyond the paper

TEXT
  picture damping "How well the shimmy-free gear is damped" \
    "The least damping ratio zeta = -Re(s)/|s| of straight rolling. (a) Over V and c_d at the best k_s of each layout; (b) the least over V from 0 to 200 m/s, L1 over c_d, the others over k_s and c_d, with the widest interval; (c) the best over b, as zeta and at the widest interval." \
    "A wide interval is no sign of good damping: where it is widest the delta region is about to be born, and the delta mode is damped by nearly nothing. The best c_d and k_s give $(number %.1e damping zeta layout=l1 choice=paper) with L1, $(number %.1e damping zeta layout=l2 choice=best) with L2, $(number %.1e damping zeta layout=li1 choice=best b=140) with LI1 and $(number %.1e damping zeta layout=li2 choice=best b=140) with LI2 at b = 140 N m s^2/rad."
  picture transients "After a disturbance" \
    "Straight rolling after a kick of 50 J, to psi (a, b) or to delta (c, d), over V: the largest angle, and the time until it stays below 5 % of that, integrated to its end. (e) The least damping ratio ([more](../docs/damping.md))." \
    "The devices hardly change the first peak, but how long it lasts. At V = 35 m/s delta* takes $(number %.0f transients dstar_5 choice=paper layout=l1 V=35 disturbance=delta) s to settle with L1, and $(number %.0f transients dstar_5 choice=best layout=li2 V=35 disturbance=delta) s with the best damped LI2: no shimmy does not mean no long ringing."
  picture certify "Large shimmy beside the zero-shimmy interval" \
    "The largest psi of the cycles that begin at the Hopf curves, over c_d at ten speeds ([how](../docs/certification.md)). Blue solid: stable, red dashed: unstable; black dots: folds of cycles; small numbers: V in m/s, where there is room; grey: the zero-shimmy interval. (e) The fold nearest to the interval over V; (f) the criticality of the bounding Hopf points." \
    "No branch of cycles enters the grey interval, as far as it was followed (15 degrees). The branches below turn back at folds, the nearest with L1 at c_d = $(number %.0f certify fold_c_d layout=l1) N m s/rad, where rolling is unstable anyhow; the interval begins at $(number %.0f certify c_lo layout=l1). Only LI1 has, below 1 m/s and c_d = $(number %.0f certify subcritical_c_d layout=li1), cycles over stable rolling."
  picture sections "Past the torus points of Figure 6" \
    "Layout L1, c_d = 3.6e4 N m s/rad, by time integration; psi and delta* at the maxima of psi, where a periodic solution is a point and a torus a closed curve. (a), (b) starts beside the unstable solution, coloured by time; (c) the unstable torus at V = 29 m/s; (d) the tori between the two torus points." \
    "Past a torus point no stable torus is left behind: the gear goes over to the other shimmy, but takes minutes for it. Between the torus points both shimmies are stable and an unstable torus lies between them: a start on either side of it settles on another shimmy."
  picture layouts "Three more devices: layouts LI3, LI4 and LI5" \
    "(a) Shimmy along V at c_d = 3.6e4 N m s/rad; blue solid: stable, red dashed: unstable; red dots: Hopf points; (b) Hopf curves and zero-shimmy interval (grey), black dots: boundary points; (c) boundary points and zero-shimmy region over k_s; (d) largest width over k_s, beside the paper's layouts ([more](../docs/layouts.md))." \
    "An inerter across the whole device (LI3) needs little inertance: $(number %.1f widths width layout=li3 b="$(best li3)") N m s/rad, $(gain li3 "$(best li3)") % more than L2, at b = $(number %.2f widths b layout=li3 b="$(best li3)") N m s^2/rad, and nothing is left at b = 90. LI4 goes on growing as LI2 does, a little below it. LI5 goes the way of LI1 and stays below L2: at most $(number %.1f widths width layout=li5 b="$(best li5)"), at b = $(number %.2f widths b layout=li5 b="$(best li5)")."
  cat <<TEXT
## Paper against computed

\`paper\` is what its text says ("figure": shown there, not printed), \`converged\`
the value computed without AUTO or on a refined mesh, \`computed\` this run.

| id | quantity | unit | paper | converged | computed | tolerance | pass |
|---|---|---|---|---|---|---|---|
TEXT
  awk -F, '!/^#/ && $1 != "id" { gsub(/,/, " | "); print "| " $0 " |" }' results/targets.csv
  cat <<TEXT

## Checks without AUTO

What \`make verify\` compares: the values above and many more with oracles that do not use
AUTO, and its own on finer meshes. Each row is in [verification.csv](verification.csv).

| oracle | checks | failed | largest difference over its tolerance |
|---|---|---|---|
TEXT
  awk -F, '
    /^#/ || $1 == "part" { next }
    { n[$1]++; failed[$1] += $8 != "yes"; split($7, limit, " "); if (limit[1] > 0 && $6 / limit[1] > worst[$1]) worst[$1] = $6 / limit[1] }
    END { for (part in n) printf "| %s | %d | %d | %.2f |\n", part, n[part], failed[part], worst[part] }' \
    results/verification.csv | sort
  cat <<TEXT

## Where the paper's account differs

- **BP1 and BP3.** Section 3.2 names them "of the upper and lower psi-shimmy
  regions, respectively". Its Figure 10 and all that follows need the reverse: BP1
  is the top of the lower psi region, BP3 the bottom of the upper one.
- **L2.** The width still grows beyond the k_s = 7.86e5 N m/rad of the paper, up to
  the onset of the delta region at $(number %.2f widths k_s layout=li2 b=0) N m/rad: $(number %.1f widths width layout=li2 b=0)
  instead of 10218.6 N m s/rad. The gains below refer to this largest width.
- **LI1, b = 20.** The paper finds it like L2, with the first qualitative change at
  b = 30. Here the delta region is born below BP1 from b = 17.64 on: at b = 20 the
  width goes on growing after the onset, until BP2_u reaches BP1
  (k_s = $(number %.0f widths k_s layout=li1 b=20) N m/rad).
- **LI1, b = 21.5 to 47.8.** The paper says of b = 30 that the region is bounded by BP1
  and BP3 and largest just before BP2_u exceeds BP1. The interval between BP2_u and BP3
  goes on growing beyond that, until its width is stationary over k_s:
  $(number %.1f widths width layout=li1 b=30) N m s/rad at b = 30 and k_s = $(number %.0f widths k_s layout=li1 b=30) N m/rad.
- **LI1, which mechanism limits the width at which b.** In turn: the onset of the delta
  region; BP2_u reaching BP1; the stationary width above BP2_u; BP2_u reaching BP1
  again; the onset again, above BP1; the onset above the third psi region; BP2_u
  reaching the top of that region. They change at b = $(handovers).
  At the last of these only 100 N m s/rad are left: the third psi region has nearly
  reached BP3. At b = 200 there is no zero-shimmy interval at any k_s.
- **LI1, third psi region.** The paper sees it for b = 70 to 150. It is there at b = 30
  too, with its top below c_d = 62 N m s/rad. Its top rises with b, and falls with k_s.
- **LI1, the optimum.** Largest at b = $(number %.4f widths b layout=li1 b="$best") N m s^2/rad and k_s = $(number %.1f widths k_s layout=li1 b="$best") N m/rad,
  where the third psi region takes over from BP1 as the lower bound: $(number %.2f widths width layout=li1 b="$best")
  N m s/rad, $(gain li1 "$best") % more than L2. The paper's b = 140 is the nearest multiple of 10, and its 9.8 % is
  1.12/1.02.
- **LI2.** "This growth trend ends with b = 140" is a choice of the paper, not a
  property of the gear: the width grows on, to $(number %.0f widths width layout=li2 b=200) N m s/rad at b = 200 and
  $(number %.0f widths width layout=li2 b=300) at b = 300, always limited by the onset of the delta region. At b = 140
  it is $(number %.1f widths width layout=li2 b=140), $(gain li2 140) % more than L2 (the paper's 87.2 % is about 1.91/1.02).

## Versions and times

With what the runs of each figure were made when its table last changed. Seconds are the
wall time of its AUTO runs, one after the other, on a machine that may have had other work;
drawing and comparing come on top. mlg-shimmy $(sed -n 's/^version: //p' CITATION.cff).

$(awk -F, '
  /^#/ { next }
  { gsub(/,/, " | "); print "| " $0 " |" }
  !n++ { gsub(/[^|]+/, "---"); print "|" $0 "|" }' results/versions.csv)
TEXT
} > results/README.md.new
if grep -o 'MISSING(.*)' results/README.md.new >&2; then fail "summary: these cells are not in the tables"; fi
replace results/README.md
