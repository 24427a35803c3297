#!/usr/bin/env bash
# criticality.sh - super- or subcritical: AUTO's small cycles against the normal form
#
#   tests/verify/criticality.sh [short]
#
# Beside a Hopf point at c_d = c_0 the cycle whose largest psi is r has
# c_d = c_0 + c_2 r^2 + ...; the normal form gives c_2 = -a / (d sigma/d c_d)
# (models/libmlg/normal_form.c).  AUTO follows the cycles through the first small amplitudes,
# and two of them extrapolate (c_d - c_0) / r^2 to r = 0.
# Prints: rows what,unit,ours,oracle,tolerance (no header): ours AUTO's c_2.
#         Last, how many boundary points of results/boundary_points.csv with c_d from 100
#         to 8e4 N m s/rad and V above 0.2 m/s are subcritical: none.
#         short: the two bounds of layout L1 only.
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/auto/lib.sh"
. scripts/curves.sh
build

# check LAYOUT K_S B V N: the Nth Hopf point in c_d at that speed
check() {
  local layout=$1 k_s=$2 b=$3 V=$4 c_d frequency name="verify.$1.V$4.$5" a slope
  IFS=, read -r c_d _ frequency _ < <(mlg hopf "$1" V="$V" k_s="$k_s" b="$b" | awk -F, -v n="$5" 'NR > 2 && $1 > 20 && ++i == n')
  hopf_start "$name.start" "$layout" "$V" k_s="$k_s" b="$b" c_d="$c_d" >&2
  run "$name" "$layout.cycles" from="$name.start" DS=0.02 DSMAX=0.02 NMX=9 EPSL=1e-10 EPSU=1e-10 -- EP=1 >&2
  IFS=, read -r _ _ _ _ a slope < <(echo "$V,$c_d,$k_s,$b,$frequency" | mlg criticality "$1" | sed 1d)
  # of the points 1, 5 and 9
  mlg rows "$name" columns=c_d:.17g,psi_max:.17g every=4 phase=1 | awk -F, -v what="c_2 at V = $V; c_d = $(printf %.6g "$c_d") ($layout; b = $b)" \
    -v limit="$(awk -v a="$a" -v slope="$slope" 'BEGIN { printf "%.8g", -a / slope }')" '
    { r = $2 * atan2(0, -1) / 180; square[NR] = r ^ 2; if (NR == 1) c_0 = $1; else y[NR] = ($1 - c_0) / square[NR] }
    END { printf "%s,N m s/rad,%.8g,%s,1e-5\n", what, (y[2] * square[3] - y[3] * square[2]) / (square[3] - square[2]), limit }'
}

check l1 inf 0 11 1
check l1 inf 0 36 2
[ "${1:-}" != short ] || exit 0
check l1 inf 0 16 2
check l2 7.86e5 0 11 1
check l2 7.86e5 0 16 2
check li1 6.38e5 140 5 3
check li1 6.38e5 140 24 1
check li2 2.48e6 140 11 1
check li2 2.48e6 140 20 2

for layout in l2 li1 li2; do
  mlg pick results/boundary_points.csv where=layout=$layout where=type= where='c_d>99.99' where='c_d<8e4' where='V>0.2' \
    columns=V,c_d,k_s,b,frequency_hz | mlg criticality $layout
done | awk -F, '$1 + 0 > 0 { n++; subcritical += !($5 < 0) } END {
  printf "subcritical ones of %d boundary points over k_s and b,points,%d,0,0 points\n", n, subcritical }'
