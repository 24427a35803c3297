#!/usr/bin/env bash
# criticality.sh - super- or subcritical: AUTO's small cycles against the normal form
#
#   tests/verify/criticality.sh [short]
#
# Beside a Hopf point at c_d = c_0 the cycle whose largest psi is r has
# c_d = c_0 + c_2 r^2 + ...; the normal form gives c_2 = -a / (d sigma/d c_d)
# (models/libmlg/normal_form.c).  AUTO follows the cycles through the first small amplitudes,
# and two of them extrapolate (c_d - c_0) / r^2 to r = 0.
# Needs:  eigen-LAYOUT, build/bin/mlg (make test-programs)
# Prints: rows what,unit,ours,oracle,tolerance (no header): ours AUTO's c_2.
#         Last, how many boundary points of results/boundary_points.csv with c_d from 100
#         to 8e4 N m s/rad and V above 0.2 m/s are subcritical: none.
#         short: the two bounds of layout L1 only.
# shellcheck disable=SC2028 # text for awk
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/lib.sh"
. scripts/curves.sh
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent test-programs

# check LAYOUT K_S B V N: the Nth Hopf point in c_d at that speed
check() {
  local layout=$1 k_s=$2 b=$3 V=$4 c_d frequency name="verify.$1.V$4.$5" a slope
  read -r c_d frequency < <("build/bin/eigen-$1" boundary free=c_d from=20 to=8e4 V="$V" k_s="$k_s" b="$b" \
    | awk -v n="$5" 'NR == n + 1 { print $1, $2 }')
  hopf_start "$name.start" "$layout" "$V" 0.001 k_s="$k_s" b="$b" c_d="$c_d" >&2
  run "$name" "$layout.cycles" from="$name.start" DS=0.02 DSMAX=0.02 NMX=9 EPSL=1e-10 EPSU=1e-10 -- EP=1 >&2
  IFS=, read -r _ _ _ _ a slope < <(echo "$V,$c_d,$k_s,$b,$frequency" | build/bin/mlg criticality "$1" | sed 1d)
  awk -v what="c_2 at V = $V; c_d = $(printf %.6g "$c_d") ($layout; b = $b)" -v a="$a" -v slope="$slope" -f scripts/auto.awk -f <(echo '
    { n++; c = value["c_d"]; r = value["psi_max"] * atan2(0, -1) / 180; if (n == 1) c_0 = c; else { square[n] = r ^ 2; y[n] = (c - c_0) / square[n] } }
    END {
      if (n < 9) print "criticality: AUTO made " n " steps only" > "/dev/stderr"
      printf "%s,N m s/rad,%.8g,%.8g,1e-5\n", what, (y[5] * square[9] - y[9] * square[5]) / (square[9] - square[5]), -a / slope
    }') "build/runs/$name/b.$name"
}

check l1 1e30 0 11 1
check l1 1e30 0 36 2
[ "${1:-}" != short ] || exit 0
check l1 1e30 0 16 2
check l2 7.86e5 0 11 1
check l2 7.86e5 0 16 2
check li1 6.38e5 140 5 3
check li1 6.38e5 140 24 1
check li2 2.48e6 140 11 1
check li2 2.48e6 140 20 2

for layout in l2 li1 li2; do
  awk -F, -v layout="$layout" '$1 == layout && $5 == "" && $7 >= 100 && $7 <= 8e4 && $8 > 0.2 {
    print $8 "," $7 "," ($6 == "inf" ? 1e30 : $6) "," $2 "," $9 }' results/boundary_points.csv \
    | build/bin/mlg criticality "$layout"
done | awk -F, '$1 + 0 > 0 { n++; subcritical += !($5 < 0) } END {
  printf "subcritical ones of %d boundary points over k_s and b,points,%d,0,0 points\n", n, subcritical }'
