#!/usr/bin/env bash
# Straight rolling after a disturbance, every layout of the paper (docs/damping.md)
#
#   scripts/transients.sh [runs [paper | best] | tables | draw]
#
# Needs:  build/bin/mlg, results/damping.csv
# Writes: results/transients.csv, results/transients.png and .svg;
#         build/tables/transients.*.csv
# Expect: delta* of L1 takes a quarter of an hour to settle at V = 36 m/s; with the best damped
#         LI2 half a minute.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent build/bin/mlg

# The gears of results/damping.csv: paper is the best c_d of the paper's interval, best
# that of all k_s too, at b = 140 as in the paper.
gear() { # CHOICE LAYOUT: its parameters
  awk -F, -v choice="$1" -v layout="$2" '
    $1 == layout && $2 == choice && ($3 == 0 || $3 == 140) { gear = "c_d=" $5 " k_s=" $4 " b=" $3 }
    END { print gear }' results/damping.csv
}

disturbed() { # CHOICE LAYOUT...
  local choice=$1 layout gear
  shift
  for layout; do
    read -ra gear < <(gear "$choice" "$layout")
    made "transients.$choice.$layout" build/bin/mlg results/damping.csv scripts/transients.sh \
      -- build/bin/mlg transients "$layout" "${gear[@]}"
    made "transients.$choice.$layout.zeta" build/bin/mlg results/damping.csv scripts/transients.sh \
      -- build/bin/mlg damping "$layout" V=5:200:300 "${gear[@]}"
  done
}

runs_paper() { disturbed paper l1 l2 li1 li2; }
runs_best() { disturbed best l2 li1 li2; }

tables() {
  local table=results/transients.csv run part
  printf '%s\n' \
    "# Peaks and settling times after a disturbance of straight rolling at V m/s. choice: a gear of results/damping.csv." \
    "# disturbance psi: psi' = 1 rad/s, delta: delta' = 0.45 rad/s, 50 J each. psi_max deg, dstar_max m: largest |psi|, |delta*|;" \
    "# psi_5, dstar_5 s: until it stays below 5 % of that, integrated; psi_end, dstar_end 1/s: decay rate seen from 5 % to 2 %;" \
    "# rate 1/s, zeta: of the least damped mode, linear. V: 5, 10, ... 200 and the minima of zeta they enclose." \
    choice,layout,V,disturbance,psi_max,dstar_max,psi_5,psi_end,dstar_5,dstar_end,rate,zeta,limits > "$table.new"
  for run in paper.{l1,l2,li1,li2} best.{l2,li1,li2}; do
    part=build/tables/transients.$run.csv
    [ -f "$part" ] || fail "$figure: there is no $part; scripts/$figure.sh runs makes it"
    use "$part"
    awk -v gear="${run/./,}" 'NR > 1 { print gear "," $0 }' "$part" >> "$table.new"
  done
  replace "$table"
}

draw() {
  use build/tables/transients.*.zeta.csv
  picture
}

main transients "$@"
