#!/usr/bin/env bash
# eigenvalues.sh - special points and boundary points against LAPACK's eigenvalues
#
#   tests/verify/eigenvalues.sh [short]
#
# Needs:  eigen-LAYOUT (tests/eigen.h: Newton's method on eigenvalues of straight
#         rolling); ours is read from results/special_points.csv, boundary_points.csv,
#         fig09.csv, fig12.csv and fig14.csv, c_d from 100 to 8e4 N m s/rad.
# Prints: rows what,unit,ours,oracle,tolerance (no header); short: Figures 6 and 7, and
#         every twentieth point of the others.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/auto/tools.sh"
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent test-programs
every=1
[ "${1:-}" != short ] || every=20

# row of special_points.csv: figure,layout,run,type,V,c_d,k_s,b,frequency_hz,...
points() { # FIGURE TYPE
  awk -F, -v figure="$1" -v type="$2" '$1 == figure && $4 == type' results/special_points.csv
}

value() { awk -v name="$1" '$1 == name { print $3; found = 1; exit } END { if (!found) print "nan" }'; } # NAME < eigen's lines

while IFS=, read -r _ layout run _ V c_d _ _ frequency _; do
  build/bin/eigen-"$layout" boundary free=V from="$(awk -v V="$V" 'BEGIN { print V - 0.5 }')" \
    to="$(awk -v V="$V" 'BEGIN { print V + 0.5 }')" c_d="$c_d" > build/tests/verify/hopf
  echo "Hopf point at c_d = $c_d ($run): V,m/s,$V,$(awk 'NR == 2 { print $1 }' build/tests/verify/hopf),1e-6"
  echo "Hopf point at c_d = $c_d ($run): frequency,Hz,$frequency,$(awk 'NR == 2 { print $2 }' build/tests/verify/hopf),1e-6"
done < <(points 6 HB)

for type in HH LP; do
  case $type in HH) command=hh name="double Hopf point" ;; LP) command=fold name="boundary point" ;; esac
  while IFS=, read -r _ layout run _ V c_d _; do
    build/bin/eigen-"$layout" "$command" V="$V" c_d="$c_d" > build/tests/verify/point || true
    # where c_d is extreme, V is not sharp
    [ $type = LP ] || echo "$name ($run): V,m/s,$V,$(value V < build/tests/verify/point),1e-6"
    echo "$name ($run): c_d,N m s/rad,$c_d,$(value c_d < build/tests/verify/point),1e-6"
  done < <(points 7 $type)
done

drawn() { awk -v c="$1" 'BEGIN { exit !(c >= 100 && c <= 8e4) }'; } # C_D

# folds WHAT LAYOUT < V,c_d,k_s,b: the largest relative difference of c_d of them all,
# less what the rounding of k_s to 8 digits explains: next to a fold over k_s, much
folds() {
  awk -v every="$every" 'NR % every == 0 || every == 1' > build/tests/verify/guesses
  [ -s build/tests/verify/guesses ] || return 0
  awk -F, -v OFS=, '{ print; $3 *= 1 + 5e-8; $3 = sprintf("%.12g", $3); print }' build/tests/verify/guesses \
    | build/bin/eigen-"$2" folds | sed 1d | paste -d, - - | paste -d, build/tests/verify/guesses - | awk -F, -v what="$1" '
    function size(x) { return x < 0 ? -x : x }
    { d = $6 == "" || $8 == "" ? 1 : size($2 / $6 - 1) - size($8 / $6 - 1); if (d > worst) worst = d }
    END { printf "%s: %d points: largest difference of c_d,relative,%.2e,0,1e-6 relative\n", what, NR, worst }'
}

# of boundary_points.csv: all but the points where a region is born or two meet
while IFS=, read -r layout b; do
  awk -F, -v layout="$layout" -v b="$b" '$1 == layout && $2 == b && $5 == "" && $7 >= 100 && $7 <= 8e4 {
    print $8 "," $7 "," ($6 == "inf" ? 1e30 : $6) "," b }' results/boundary_points.csv | folds "boundary points over k_s; $layout; b = $b" "$layout"
done < <(awk -F, '/^l/ && $1 != "layout" && !seen[$1, $2]++ { print $1 "," $2 }' results/boundary_points.csv)

for figure in 09:l2 12:li1 14:li2; do
  awk -F, '$6 == "LP" && $8 >= 100 { print $7 "," $8 "," ($3 == "inf" ? 1e30 : $3) "," $2 }' "results/fig${figure%:*}.csv" | folds "boundary points of Figure ${figure%:*}" "${figure#*:}"
done

[ "$every" -eq 1 ] || exit 0

# where a region is born or two meet, over k_s
for figure in 10 13 15; do
  while IFS=, read -r _ layout run _ V c_d k_s b _; do
    drawn "$c_d" || continue
    build/bin/eigen-"$layout" centre free=k_s V="$V" c_d="$c_d" k_s="$k_s" b="$b" > build/tests/verify/point || true
    echo "regions born or meeting ($run): k_s,N m/rad,$k_s,$(value k_s < build/tests/verify/point),1e-6"
  done < <(points $figure LP)
  while IFS=, read -r _ layout run _ V c_d k_s b _; do
    drawn "$c_d" || continue
    build/bin/eigen-"$layout" fold V="$V" c_d="$c_d" k_s="$k_s" b="$b" > build/tests/verify/point || true
    echo "boundary point at k_s = $k_s ($run): c_d,N m s/rad,$c_d,$(value c_d < build/tests/verify/point),1e-6"
  done < <(points $figure UZ)
done
