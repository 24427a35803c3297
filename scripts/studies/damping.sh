#!/usr/bin/env bash
# Least damping ratios of straight rolling, every layout (docs/damping.md)
#
#   scripts/damping.sh [runs [planes | search] | tables | draw]
#
# Needs:  build/bin/mlg, scan-LAYOUT, results/widths.csv
# Writes: results/damping.csv, results/damping.png and .svg;
#         build/tables/damping.*.csv, the maps of the picture
# Expect: 2.7e-5 at best for L1, 9.6e-5 for L2, 1.7e-4 for LI1 and 7.9e-4 for LI2 at
#         b = 140 N m s^2/rad, always lost in the delta mode.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent build/bin/mlg

stiffness=compliance=0:0.35 damper=c_d=100:4e4 # where the best damped gear is looked for

# made of lib.sh, with the layout's programs, the widths and this script to hang on
of() { # NAME LAYOUT COMMAND...
  made "damping.$1" build/bin/mlg build/bin/scan-"$2" results/widths.csv scripts/damping.sh -- "${@:3}"
}

# The widest interval over k_s at every second b of widths.csv.
widest() { # LAYOUT
  awk -F, -v layout="$1" '$1 == layout && $2 % 20 == 0 && $6 > 0 { print $3, $2, $4, $5 }' results/widths.csv
}

# Rows of results/damping.csv without t_5, from lines "k_s b c_lo c_hi": the best
# damped c_d of each interval
best_in_interval() { # LAYOUT CHOICE
  local k_s b c_lo c_hi
  while read -r k_s b c_lo c_hi; do
    build/bin/mlg damping "$1" best k_s="$k_s" b="$b" c_d="$c_lo:$c_hi" \
      | awk -v row="$1,$2,$b,$k_s" 'NR == 2 { print row "," $0 }'
  done
}

# the same in the middle of the interval
middle() { # LAYOUT CHOICE
  local k_s b c_lo c_hi c_d
  while read -r k_s b c_lo c_hi; do
    c_d=$(awk -v lo="$c_lo" -v hi="$c_hi" 'BEGIN { printf "%.6g", (lo + hi) / 2 }')
    build/bin/mlg damping "$1" k_s="$k_s" b="$b" c_d="$c_d" \
      | awk -v row="$1,$2,$b,$k_s,$c_d" 'NR == 2 { print row "," $0 }'
  done
}

# and at each b over c_d and k_s
best_of_all() { # LAYOUT CHOICE B...
  local b
  for b in "${@:3}"; do
    build/bin/mlg damping "$1" best "$stiffness" "$damper" b="$b" \
      | awk -F, -v OFS=, -v row="$1,$2,$b" 'NR == 2 { k_s = sprintf("%.6g", 1e5 / $1); $1 = row "," k_s; print }'
  done
}

plane() { # LAYOUT K_S B
  build/bin/mlg damping "$1" k_s="$2" b="$3" c_d=100:8e4:160 V=0.5:200:160
}

runs_planes() {
  of l1 l1 plane l1 1e30 0
  of l1.c_d l1 build/bin/mlg damping l1 c_d=2700:3100:201
  of l2 l2 plane l2 4.755e5 0
  of li1 li1 plane li1 3.048e5 140
  of li2 li2 plane li2 1.4047e6 140
  of l2.k_s l2 build/bin/mlg damping l2 k_s=2.86e5:2e6:90 c_d=2e3:3e4:90
  of li1.k_s li1 build/bin/mlg damping li1 b=140 k_s=2.86e5:2e6:90 c_d=2e3:3e4:90
  of li2.k_s li2 build/bin/mlg damping li2 b=140 k_s=2.86e5:4e6:90 c_d=2e3:3e4:90
}

runs_search() {
  local layout
  for layout in l1 l2 li1 li2; do
    of "$layout.middle" "$layout" middle "$layout" middle < <(paper_gear "$layout")
    of "$layout.paper" "$layout" best_in_interval "$layout" paper < <(paper_gear "$layout")
  done
  of l2.best l2 best_of_all l2 best 0
  for layout in li1 li2; do
    of "$layout.widest" "$layout" best_in_interval "$layout" widest < <(widest "$layout")
  done
  of li1.best li1 best_of_all li1 best $(seq 0 20 180)
  of li2.best li2 best_of_all li2 best $(seq 0 20 300)
}

tables() {
  local table=results/damping.csv layout choice map
  printf '%s\n' \
    "# The least damping ratio zeta = -Re(s)/|s| over V in 0..200 m/s. choice: middle of the paper's zero-shimmy interval of" \
    "# c_d; paper, the best c_d in it; widest, the same at the k_s of the widest interval at that b; best, the best c_d and k_s" \
    "# from 2.86e5 N m/rad on. b N m s^2/rad, k_s N m/rad (1e30: rigid), c_d N m s/rad; V m/s, frequency_hz Hz and shimmy of" \
    "# that mode; t_5 s, the time in which it decays to 5 %." \
    layout,choice,b,k_s,c_d,zeta,V,frequency_hz,shimmy,t_5 > "$table.new"
  for layout in l1 l2 li1 li2; do
    for choice in middle paper widest best; do
      map=build/tables/damping.$layout.$choice.csv
      [ -f "$map" ] || continue
      use "$map"
      awk -F, -v OFS=, '{
        t = log(20) * sqrt(1 - $6 ^ 2) / ($6 * 8 * atan2(1, 1) * $8)
        print $1, $2, $3, $4, sprintf("%.7g,%.4g,%.4g,%.6g", $5, $6, $7, $8), $9, sprintf("%.4g", t) }' \
        "$map" >> "$table.new"
    done
  done
  replace "$table"
}

draw() {
  use build/tables/damping.*.csv
  picture
}

main damping "$@"
