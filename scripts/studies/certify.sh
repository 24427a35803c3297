#!/usr/bin/env bash
# Beyond linear theory: does shimmy live where straight rolling is stable?
#
#   scripts/certify.sh          runs, tables and picture
#   scripts/certify.sh runs [l1 | l2 | li1 | li2]     one region, or all
#   scripts/certify.sh tables | draw
#
# For the zero-shimmy interval of each layout at the paper's k_s and b:
#   - the criticality of every Hopf point of the curves that bound it
#   - the cycles (periodic solutions) that begin at these curves, along c_d at ten
#     speeds, and along V just outside the interval, up to 15 degrees of psi
#   - the folds of these cycles in the (V, c_d) plane
#   - what becomes of large disturbances inside the interval, by time integration
# Needs:  SUNDIALS and LAPACK, which make certify sees to.
# Writes: results/certify.csv (a row a region), results/cycles.csv, results/folds.csv,
#         results/criticality.csv, results/certify.png and .svg
# Expect: no subcritical Hopf point but on a stretch of LI1 below 1 m/s and 560 N m s/rad,
#         between two points GH; folds of cycles only below the intervals, the nearest at
#         0.73 of c_lo (L1); no cycle inside; every start falls.
# shellcheck disable=SC2028 # text for awk
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
. scripts/curves.sh
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent models build/bin/eigen-{l1,l2,li1,li2}

readonly layouts="l1 l2 li1 li2"
readonly speeds="0.5 5 8 11 16 24 36 60 100 150" # m/s
readonly starts=400

# The region of a layout: k_s, b, and the interval of c_d there.
region() { # LAYOUT
  read -r k_s b c_lo c_hi < <(paper_gear "$1")
}

# Hopf points along one parameter, from eigenvalues: "VALUE FREQUENCY loses" or "... regains".
hopf_points() { # LAYOUT PARAMETER FROM TO PARAMETER=VALUE
  "build/bin/eigen-$1" boundary free="$2" from="$3" to="$4" k_s="$k_s" b="$b" "$5" | awk 'NR > 1 { print $1, $2, $4 }'
}

# Cycles along c_d from each Hopf point at one speed after the other.
cycles_in_c_d() { # LAYOUT
  local V c_d n name
  for V in $speeds; do
    n=0
    while read -r c_d _; do
      n=$((n + 1))
      name=certify.$1.V$V.$n
      hopf_start "$name.start" "$1" "$V" 0.001 k_s="$k_s" b="$b" c_d="$c_d"
      run "$name" "$1.cycles" from="$name.start" --
      echo "$name" >> "$list.new"
    done < <(hopf_points "$1" c_d 20 8e4 V="$V")
  done
}

# Cycles along V on either side of the interval, from each point where shimmy begins.
cycles_in_V() { # LAYOUT
  local side c_d V way n name
  for side in below above; do
    c_d=$(awk -v side=$side -v lo="$c_lo" -v hi="$c_hi" 'BEGIN { printf "%.6g", (side == "below" ? 0.98 * lo : 1.02 * hi) }')
    n=0
    while read -r V _ way; do
      [ "$way" = loses ] || continue
      n=$((n + 1))
      name=certify.$1.$side.$n
      hopf_start "$name.start" "$1" "$V" 0.001 k_s="$k_s" b="$b" c_d="$c_d"
      run "$name" "$1.periodic" from="$name.start" IRS="'HB1'" UZR="{'torus': [-1e-5, 2e-5]}" -- closed=1
      echo "$name" >> "$list.new"
    done < <(hopf_points "$1" V 0.2 200 c_d="$c_d")
  done
}

# The fold of cycles nearest to the interval: "RUN LPn V c_d".  Where a branch turns
# round at its closing Hopf point AUTO labels LP too; a fold has a size.
nearest_fold() { # RUN...
  local run files=()
  for run; do files+=("build/runs/$run/b.$run"); done
  awk -v lo="$c_lo" -v hi="$c_hi" -f scripts/auto.awk -f <(echo '
    function finish(    i) {
      for (i = 1; i <= n; i++)
        if (size_at[i] > 0.1 * biggest && (best == "" || ratio[i] < nearest)) { best = found[i]; nearest = ratio[i] }
    }
    FILENAME != file { finish(); file = FILENAME; biggest = n = 0; run = FILENAME; sub(/.*\/b\./, "", run) }
    value["L2-NORM"] > biggest { biggest = value["L2-NORM"] }
    type == "LP" {
      c = value["c_d"]; size_at[++n] = value["L2-NORM"]; ratio[n] = c < lo ? lo / c : c / hi
      found[n] = sprintf("%s LP%d %.6g %.6g", run, n, value["V"], c)
    }
    END { finish(); print best }') "${files[@]}"
}

# That fold, followed both ways.
folds() { # LAYOUT
  local name number names
  mapfile -t names < "$list.new"
  read -r name number _ < <(nearest_fold "${names[@]}")
  [ -n "$name" ] || return 0
  run "certify.$1.fold.start" "$1.fold_start" from="$name" IRS="'$number'" -- EP=1
  run "certify.$1.fold.up" "$1.fold" from="certify.$1.fold.start" -- UZ=1
  run "certify.$1.fold.down" "$1.fold" from="certify.$1.fold.start" DS=-0.01 -- UZ=1
}

certify_region() { # LAYOUT
  local k_s b c_lo c_hi list="build/runs/certify.$1.list"
  region "$1"
  use build/bin/mlg "build/bin/"{scan,eigen}"-$1" "$list"
  hopf_curves "$1" "certify.$1.hopf" k_s="$k_s" b="$b"
  : > "$list.new"
  cycles_in_c_d "$1"
  cycles_in_V "$1"
  folds "$1"
  mv "$list.new" "$list"
  made "search.$1" build/bin/mlg "build/bin/scan-$1" scripts/certify.sh \
    -- build/bin/mlg search "$1" c_lo="$c_lo" c_hi="$c_hi" starts="$starts" k_s="$k_s" b="$b"
}

runs_l1() { certify_region l1; }
runs_l2() { certify_region l2; }
runs_li1() { certify_region li1; }
runs_li2() { certify_region li2; }
# --- tables --------------------------------------------------------------------

# The criticality of every point of the region's Hopf curves, as AUTO has them, and the
# points GH between them where it changes sign.
criticality_rows() { # LAYOUT
  local file files
  files=$(awk -F, -v name="certify.$1.hopf" 'NR > 1 { printf "build/runs/%s.%s/b.%s.%s\n", name, $1, name, $1 }' \
    "build/tables/certify.$1.hopf.curves")
  for file in $files; do
    use "$file"
    awk -v k_s="$k_s" -v b="$b" -f scripts/auto.awk -f <(echo '
      { printf "%.12g,%.12g,%s,%s,%.12g\n", value["V"], value["c_d"], k_s, b, 1 / value["period"] }') "$file" \
      | build/bin/mlg criticality "$1" \
      | awk -F, -v head="$1,$k_s,$b,${file##*.}" 'NR > 1 { printf "%s,,%.6g,%.6g,%.6g,%.6g,%.6g\n", head, $1, $2, $3, $4, $5 }'
  done | awk -F, '
    { print }
    NR > 1 && $4 == curve && $10 * a < 0 { print "between", V, c, a, $6, $7 > "/dev/stderr" }
    { curve = $4; V = $6; c = $7; a = $10 }' 2> "build/tables/certify.$1.signs"
  while read -r _ V c a V_1 c_1; do generalised_hopf "$1" "$V" "$c" "$a" "$V_1" "$c_1"; done < "build/tables/certify.$1.signs"
}

# The row of the point GH between two Hopf points at V and V_1, by bisection in V; a is
# the criticality at V.
generalised_hopf() { # LAYOUT V C_D A V_1 C_D_1
  local V=$2 V_1=$5 middle c_d row i
  for ((i = 0; i < 30; i++)); do
    middle=$(awk -v x="$V" -v y="$V_1" 'BEGIN { printf "%.12g", (x + y) / 2 }')
    # of the Hopf points at this speed the one on the curve
    c_d=$(hopf_points "$1" c_d 1 8e4 V="$middle" | awk -v lo="$3" -v hi="$6" '
      (lo < hi && $1 > lo && $1 < hi) || (lo > hi && $1 > hi && $1 < lo) { print $1 "," $2 }')
    row=$(echo "$middle,${c_d%,*},$k_s,$b,${c_d#*,}" | build/bin/mlg criticality "$1" | sed 1d)
    if awk -v a="$4" -v here="${row#*,*,*,*,}" 'BEGIN { split(here, part, ","); exit !(a * part[1] > 0) }'; then V=$middle; else V_1=$middle; fi
  done
  awk -F, -v head="$1,$k_s,$b,-,GH" '{ printf "%s,%.6g,%.6g,%.6g,%.6g,0\n", head, $1, $2, $3, $4 }' <<< "$row"
}

# Rows of a region's cycles, every sixth orbit and each fold.
cycle_rows() { # LAYOUT
  local name
  while read -r name; do
    use_run "$name"
    awk -v head="$1,$k_s,$b,${name#certify."$1".}" -f scripts/auto.awk -f <(echo '
      { shown = type == "LP" ? "LP" : ""; last = "" }
      function text() { return sprintf("%s,%s,%.6g,%.8g,%.6g,%.6g,%d", head, shown, value["V"], value["c_d"], value["psi_max"], value["dstar_max"], stable) }
      n++ % 6 == 0 || shown { print text(); next }
      { last = text() }
      END { if (last != "") print last }') "build/runs/$name/d.$name" "build/runs/$name/b.$name"
  done < "build/runs/certify.$1.list"
}

fold_rows() { # LAYOUT
  local half
  for half in "up reverse" down; do
    [ -f "build/runs/certify.$1.fold.${half% *}/b.certify.$1.fold.${half% *}" ] || continue
    # shellcheck disable=SC2086 # one or two words
    set -- "$1" $half
    use_run "certify.$1.fold.$2"
    awk -v reverse="${3:-}" -v head="$1,$k_s,$b" -f scripts/auto.awk -f <(echo '
      { row[++n] = sprintf("%s,%.6g,%.8g,%.6g,%.6g", head, value["V"], value["c_d"], value["psi_max"], value["dstar_max"]) }
      END { for (i = 1; i <= n; i++) print row[reverse ? n + 1 - i : i] }') \
      "build/runs/certify.$1.fold.$2/b.certify.$1.fold.$2"
  done
}

# The row of a region: what the tables and the search say of it.
certified_row() { # LAYOUT
  awk -F, -v layout="$1" -v k_s="$k_s" -v b="$b" -v c_lo="$c_lo" -v c_hi="$c_hi" '
    FILENAME ~ /search/ {
      if (FNR == 1) next
      starts++
      if ($3 > psi_start) psi_start = $3
      if ($4 > dstar_start) dstar_start = $4
      if ($10 != "falls") sustained++
      if ($6 > seconds) seconds = $6
      if ($7 > psi_end) psi_end = $7
      if ($8 > dstar_end) dstar_end = $8
      next
    }
    $1 != layout { next }
    FILENAME ~ /criticality/ { if ($5 != "GH") hopf++; if ($10 > 0) subcritical++; if (($10 > 0 || $5 == "GH") && $7 > c_most) c_most = $7; next }
    FILENAME ~ /folds/ {
      gap = $5 < c_lo ? c_lo / $5 : $5 / c_hi
      if (nearest == "" || gap < nearest) { nearest = gap; fold_V = $4; fold_c = $5 }
      next
    }
    { cycles++; if ($7 > c_lo && $7 < c_hi) inside++; if ($8 > psi) psi = $8; if ($9 > dstar) dstar = $9 }
    END {
      printf "%s,%s,%s,%s,%s,%d,%d,%s,%d,%d,%s,%s,%s,%s,%d,%s,%s,%s,%s,%s,%d\n", layout, k_s, b, c_lo, c_hi, hopf, subcritical, c_most,
        cycles, inside, psi, dstar, nearest == "" ? "" : sprintf("%.3g", fold_V), nearest == "" ? "" : sprintf("%.4g", fold_c), starts, psi_start, dstar_start, seconds, psi_end, dstar_end, sustained
    }' "build/tables/search.$1.csv" "$criticality.new" "$folds.new" "$cycles.new"
}

tables() {
  local layout k_s b c_lo c_hi
  local criticality=results/criticality.csv cycles=results/cycles.csv folds=results/folds.csv certify=results/certify.csv
  printf '%s\n' "# Hopf points of the curves that bound the zero-shimmy regions. V m/s, c_d N m s/rad, a 1/s per rad^2 of psi:" \
    "# r' = sigma r + a r^3 for the amplitude r of psi beside the point; a < 0 supercritical (mlg criticality). type GH: a changes sign." \
    layout,k_s,b,curve,type,V,c_d,frequency_hz,delta_over_psi,a > "$criticality.new"
  printf '%s\n' "# Cycles that begin at these curves: along c_d at one speed (branch V8.1: the first Hopf point at 8 m/s), along V" \
    "# below and above the interval. type LP: fold of cycles. V m/s, c_d N m s/rad, psi_max deg, dstar_max m; stable 1 or 0." \
    layout,k_s,b,branch,type,V,c_d,psi_max,dstar_max,stable > "$cycles.new"
  printf '%s\n' "# Folds of cycles in the plane of V (m/s) and c_d (N m s/rad), the fold nearest to each zero-shimmy interval followed" \
    "# both ways; psi_max deg, dstar_max m." layout,k_s,b,V,c_d,psi_max,dstar_max > "$folds.new"
  for layout in $layouts; do
    [ -f "build/runs/certify.$layout.list" ] || fail "certify: the runs of $layout have not been made; scripts/certify.sh runs makes them"
    region "$layout"
    use build/bin/mlg "build/bin/"{scan,eigen}"-$layout" "build/runs/certify.$layout.list" "build/tables/search.$layout.csv"
    criticality_rows "$layout" >> "$criticality.new"
    cycle_rows "$layout" >> "$cycles.new"
    fold_rows "$layout" >> "$folds.new"
  done
  printf '%s\n' "# Evidence for each zero-shimmy interval c_lo to c_hi (N m s/rad) beyond linear theory (docs/certification.md)." \
    "# hopf_points on the curves, how many subcritical and up to which c_d; cycles computed, how many inside the interval," \
    "# up to psi_max deg and dstar_max m; the nearest fold of cycles; starts inside, up to psi_start deg and dstar_start m" \
    "# in their first 2 s, down to psi_end and dstar_end within so many seconds; how many were sustained." \
    layout,k_s,b,c_lo,c_hi,hopf_points,subcritical,subcritical_c_d,cycles,cycles_inside,psi_max,dstar_max,fold_V,fold_c_d,starts,psi_start,dstar_start,seconds,psi_end,dstar_end,sustained \
    > "$certify.new"
  for layout in $layouts; do
    region "$layout"
    certified_row "$layout" >> "$certify.new"
  done
  for layout in "$criticality" "$cycles" "$folds" "$certify"; do replace "$layout"; done
}

main certify "$@"
