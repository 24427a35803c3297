#!/usr/bin/env bash
# Beyond linear theory: does shimmy live where straight rolling is stable?
#
#   scripts/studies/certify.sh      runs, tables and picture
#   scripts/studies/certify.sh runs [l1 | l2 | li1 | li2]     one region, or all
#   scripts/studies/certify.sh tables | draw
#
# For the zero-shimmy interval of each layout at the paper's k_s and b:
#   - the criticality of every Hopf point of the curves that bound it
#   - the cycles (periodic solutions) that begin at these curves, along c_d at ten
#     speeds, and along V just outside the interval, up to 15 degrees of psi
#   - the folds of these cycles in the (V, c_d) plane
#   - what becomes of large disturbances inside the interval, by time integration
# Writes: results/certify.csv (a row a region), results/cycles.csv, results/folds.csv,
#         results/criticality.csv, results/certify.png and .svg
# Expect: no subcritical Hopf point but on a stretch of LI1 below 1 m/s and 560 N m s/rad,
#         between two points GH; folds of cycles only below the intervals, the nearest at
#         0.73 of c_lo (L1); no cycle inside; every start falls.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
. scripts/curves.sh

readonly layouts="l1 l2 li1 li2"
readonly speeds="0.5 5 8 11 16 24 36 60 100 150" # m/s
readonly starts=400

# The branches of cycles, a line "BRANCH CONSTANTS V C_D" for the Hopf point where each begins:
# along c_d from every one at one speed after the other, along V on either side of the
# interval from each where shimmy begins.
branches() { # LAYOUT
  local V c_d side n
  for V in $speeds; do
    n=0
    while IFS=, read -r c_d _; do echo "V$V.$((++n)) cycles $V $c_d"; done \
      < <(mlg hopf "$1" V="$V" k_s="$k_s" b="$b" | awk -F, 'NR > 2 && $1 > 20 && $1 < 8e4')
  done
  for side in below above; do
    n=0
    c_d=$(awk -v side=$side -v lo="$c_lo" -v hi="$c_hi" 'BEGIN { printf "%.6g", (side == "below" ? 0.98 * lo : 1.02 * hi) }')
    while IFS=, read -r _ V _; do echo "$side.$((++n)) periodic $V $c_d"; done \
      < <(mlg hopf "$1" c_d="$c_d" V_least=0.2 k_s="$k_s" b="$b" | grep ',above$')
  done
}

cycles() { # LAYOUT
  local branch constants V c_d
  while read -r branch constants V c_d; do
    hopf_start "certify.$1.$branch.start" "$1" "$V" k_s="$k_s" b="$b" c_d="$c_d"
    case $constants in
      cycles) set -- "$1" -- ;;
      periodic) set -- "$1" IRS="'HB1'" UZR="{'torus': [-1e-5, 2e-5]}" -- closed=1 ;;
    esac
    run "certify.$1.$branch" "$1.$constants" from="certify.$1.$branch.start" "${@:2}"
  done < <(branches "$1")
}

# Of lines C_D,... the one nearest to the interval
nearest() {
  awk -F, -v lo="$c_lo" -v hi="$c_hi" '{ gap = $1 < lo ? lo / $1 : $1 / hi; if (NR == 1 || gap < least) { least = gap; row = $0 } }
    END { if (NR) print row }'
}

# The nearest fold of cycles, followed both ways.  Where a branch turns round at its closing
# Hopf point AUTO labels LP too; a fold has a size.
folds() { # LAYOUT
  local names name number
  mapfile -t names < <(branches "$1" | sed "s/^\([^ ]*\) .*/certify.$1.\1/")
  IFS=, read -r _ name number < <(mlg rows "${names[@]}" only=LP where='size>0.1' columns=c_d:.10g,run,name | nearest) || return 0
  run "certify.$1.fold.start" "$1.fold_start" from="$name" IRS="'$number'" -- EP=1
  run "certify.$1.fold.up" "$1.fold" from="certify.$1.fold.start" -- UZ=1
  run "certify.$1.fold.down" "$1.fold" from="certify.$1.fold.start" DS=-0.01 -- UZ=1
}

certify_region() { # LAYOUT
  local k_s b c_lo c_hi files
  paper_gear "$1"
  hopf_curves "$1" "certify.$1.hopf" k_s="$k_s" b="$b"
  cycles "$1"
  folds "$1"
  mapfile -t files < <(sources "$1" models/libmlg/integrate.c scripts/mlg/gear/search.c)
  made "search.$1" "${files[@]}" -- mlg search "$1" c_lo="$c_lo" c_hi="$c_hi" starts=$starts k_s="$k_s" b="$b"
}

runs_l1() { certify_region l1; }
runs_l2() { certify_region l2; }
runs_li1() { certify_region li1; }
runs_li2() { certify_region li2; }

# --- tables --------------------------------------------------------------------

# The criticality of every point of the region's Hopf curves, as AUTO has them, then the
# points GH between them where it changes sign.
criticality_rows() { # LAYOUT
  local number curves
  mapfile -t curves < <(mlg pick "build/tables/certify.$1.hopf.curves" columns=curve)
  for number in "${curves[@]}"; do criticality "$1" "$number" "$number,"; done
  for number in "${curves[@]}"; do criticality "$1" "$number" -,GH GH; done
}

criticality() { # LAYOUT CURVE CELLS [GH]
  mlg rows "certify.$1.hopf.$2" columns=V:.12g,c_d:.12g,frequency:.12g | sed "s/,[^,]*$/,$k_s,$b&/" \
    | mlg criticality "$1" digits=6 "${@:4}" | sed "1d; s/,[^,]*$//; s/^/$1,$k_s,$b,$3,/" >> "$table.new"
}

# Every sixth orbit and each fold
cycle_rows() { # LAYOUT
  local branch
  while read -r branch _; do
    rows "certify.$1.$branch" prefix="$1,$k_s,$b,$branch" columns=type,V,c_d:.8g,psi_max,dstar_max,stable types=LP,BP every=6 phase=1
  done < <(branches "$1")
}

fold_rows() { # LAYOUT
  [ -d "build/runs/certify.$1.fold.up" ] || return 0
  rows "certify.$1.fold.up" prefix="$1,$k_s,$b" columns=V,c_d:.8g,psi_max,dstar_max reverse
  rows "certify.$1.fold.down" prefix="$1,$k_s,$b" columns=V,c_d:.8g,psi_max,dstar_max
}

# The row of a region: what the tables and the search say of it.
certified_row() { # LAYOUT
  local search=build/tables/search.$1.csv
  {
    printf '%s\n' "$1" "$k_s" "$b" "$c_lo" "$c_hi"
    of "$1" criticality where='type!=GH' columns=V | wc -l
    of "$1" criticality where='a>0' columns=V | wc -l
    { of "$1" criticality where='a>0' columns=c_d; of "$1" criticality where=type=GH columns=c_d; } | largest
    of "$1" cycles columns=V | wc -l
    of "$1" cycles where="c_d>$c_lo" where="c_d<$c_hi" columns=V | wc -l
    of "$1" cycles columns=psi_max | largest
    of "$1" cycles columns=dstar_max | largest
    of "$1" folds columns=c_d,V:.3g,c_d:.4g | nearest | sed 's/^[^,]*,//'
    mlg pick "$search" columns=V | wc -l
    for column in psi_start dstar_start seconds psi_end dstar_end; do mlg pick "$search" columns="$column" | largest; done
    mlg pick "$search" where=verdict!=falls columns=V | wc -l
  } | paste -sd , >> "$table.new"
}

of() { mlg pick "results/$2.csv" where=layout="$1" "${@:3}"; } # LAYOUT TABLE WORD...
largest() { sort -g | tail -n 1 | grep . || echo; }

# Fills the table with what a function has of each region
regions() { # FUNCTION
  local layout k_s b c_lo c_hi
  for layout in $layouts; do
    paper_gear "$layout"
    "$1" "$layout"
  done
  replace "$table"
}

tables() {
  begin_table results/criticality.csv \
    "# Hopf points of the curves that bound the zero-shimmy regions. V m/s, c_d N m s/rad, a 1/s per rad^2 of psi:" \
    "# r' = sigma r + a r^3 for the amplitude r of psi beside the point; a < 0 supercritical (mlg criticality). type GH: a changes sign." \
    layout,k_s,b,curve,type,V,c_d,frequency_hz,delta_over_psi,a
  regions criticality_rows
  begin_table results/cycles.csv \
    "# Cycles that begin at these curves: along c_d at one speed (branch V8.1: the first Hopf point at 8 m/s), along V" \
    "# below and above the interval. type LP: fold of cycles, BP: branch point, where a run ends. V m/s, c_d N m s/rad," \
    "# psi_max deg, dstar_max m; stable 1, 0, empty: not known, the multiplier that decides is within AUTO's tolerance of 1." \
    layout,k_s,b,branch,type,V,c_d,psi_max,dstar_max,stable
  regions cycle_rows
  begin_table results/folds.csv \
    "# Folds of cycles in the plane of V (m/s) and c_d (N m s/rad), the fold nearest to each zero-shimmy interval followed" \
    "# both ways; psi_max deg, dstar_max m." \
    layout,k_s,b,V,c_d,psi_max,dstar_max
  regions fold_rows
  begin_table results/certify.csv \
    "# Evidence for each zero-shimmy interval c_lo to c_hi (N m s/rad) beyond linear theory (docs/certification.md)." \
    "# hopf_points on the curves, how many subcritical and up to which c_d; cycles computed, how many inside the interval," \
    "# up to psi_max deg and dstar_max m; the nearest fold of cycles; starts inside, up to psi_start deg and dstar_start m" \
    "# in their first 2 s, down to psi_end and dstar_end within so many seconds; how many were sustained." \
    layout,k_s,b,c_lo,c_hi,hopf_points,subcritical,subcritical_c_d,cycles,cycles_inside,psi_max,dstar_max,fold_V,fold_c_d,starts,psi_start,dstar_start,seconds,psi_end,dstar_end,sustained
  regions certified_row
}

main certify "$@"
