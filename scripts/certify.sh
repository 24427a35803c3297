#!/usr/bin/env bash
# Beyond linear theory: does shimmy live where straight rolling is stable?
#
#   scripts/certify.sh          runs, tables and picture
#   scripts/certify.sh runs [l1 | l2 | li1 | li2]     one region, or all
#   scripts/certify.sh tables | draw
#
# For the zero-shimmy interval of each layout at the paper's k_s and b:
#   - the criticality of every Hopf point of the curves that bound it
#   - the cycles (periodic solutions) that begin at these curves, along c_d at nine
#     speeds, and along V just outside the interval, up to 20 degrees of psi
#   - the folds of these cycles in the (V, c_d) plane
#   - what becomes of large disturbances inside the interval, by time integration
# Needs:  SUNDIALS and LAPACK, which make certify sees to.
# Writes: results/certified.csv (a row a region), results/cycles.csv, results/folds.csv,
#         results/criticality.csv, results/certify.png and .svg
# Expect: every Hopf point supercritical; folds of cycles only below the intervals,
#         the nearest at 0.73 of c_lo (L1); no cycle inside; every start falls.
. "$(dirname "$0")/lib.sh"
. scripts/boundary.sh
. scripts/curves.sh

readonly layouts="l1 l2 li1 li2"
readonly speeds="5 8 11 16 24 36 60 100 150" # m/s
readonly starts=400

# The region of a layout: k_s, b, and the widest interval of c_d there.
region() { # LAYOUT
  case $1 in
    l1) k_s=1e30 b=0 ;;
    l2) k_s=7.86e5 b=0 ;;
    li1) k_s=6.38e5 b=140 ;;
    li2) k_s=2.48e6 b=140 ;; # just below the k_s at which its delta region is born
  esac
  IFS=, read -r c_lo c_hi _ < <("build/bin/scan-$1" intervals k_s=$k_s b=$b | sed -n 2p)
}

# Hopf points along one parameter, from eigenvalues: "VALUE loses" or "VALUE regains".
hopf_points() { # LAYOUT PARAMETER FROM TO PARAMETER=VALUE
  "build/bin/eigen-$1" boundary free="$2" from="$3" to="$4" k_s="$k_s" b="$b" "$5" | awk 'NR > 1 { print $1, $4 }'
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
    c_d=$(awk -v side=$side -v lo="$c_lo" -v hi="$c_hi" 'BEGIN { printf "%.6g", side == "below" ? 0.98 * lo : 1.02 * hi }')
    n=0
    while read -r V way; do
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
  local k_s b c_lo c_hi list="build/runs/certify.$1.list" search="build/tables/search.$1.csv" stamp
  [ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent certify-programs
  region "$1"
  hopf_curves "$1" "certify.$1.hopf" k_s="$k_s" b="$b"
  : > "$list.new"
  cycles_in_c_d "$1"
  cycles_in_V "$1"
  folds "$1"
  mv "$list.new" "$list"
  stamp=$( { echo "$c_lo $c_hi $starts $k_s $b"; cat "build/bin/search-$1"; } | sha256sum)
  if [ "$(cat "$search.stamp" 2>/dev/null)" != "$stamp" ]; then
    "build/bin/search-$1" "$c_lo" "$c_hi" "$starts" k_s="$k_s" b="$b" > "$search.new"
    mv "$search.new" "$search"
    echo "$stamp" > "$search.stamp"
    echo "  search.$1: $(awk -F, 'NR > 1 { n[$NF]++ } END { for (v in n) printf "%d starts: %s ", n[v], v }' "$search")"
  fi
}

runs_l1() { certify_region l1; }
runs_l2() { certify_region l2; }
runs_li1() { certify_region li1; }
runs_li2() { certify_region li2; }
tables() { :; }
main certify "$@"
