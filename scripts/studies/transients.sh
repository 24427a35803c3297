#!/usr/bin/env bash
# Straight rolling after a disturbance, every layout of the paper (docs/damping.md)
#
#   scripts/studies/transients.sh   all of it
#   scripts/studies/transients.sh runs [paper | best] | tables | draw
#
# Needs:  results/damping.csv (scripts/studies/damping.sh)
# Writes: results/transients.csv, results/transients.png and .svg;
#         build/tables/transients.*.csv
# Expect: delta* of L1 takes a quarter of an hour to settle at V = 36 m/s; with the best damped
#         LI2 half a minute.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

# The gears of results/damping.csv: paper is the best c_d of the paper's k_s, best that of all
# k_s too, at b = 140 as in the paper.
disturbed() { # CHOICE LAYOUT...
  local name layout c_d k_s b files gear
  for layout in "${@:2}"; do
    name=transients.$1.$layout
    case $layout in li*) b=140 ;; *) b=0 ;; esac
    IFS=, read -r c_d k_s < <(mlg pick results/damping.csv where=layout="$layout" where=choice="$1" where="b=$b" columns=c_d,k_s)
    gear=("$layout" c_d="$c_d" k_s="$k_s" b="$b")
    mapfile -t files < <(sources "$layout" models/libmlg/{integrate,best_ratio,crossing,damping,eigenvalues}.c scripts/mlg/gear/transients.c)
    made "$name" "${files[@]}" -- mlg transients "${gear[@]}"
    made "$name.peaks" "${files[@]}" -- mlg transients "${gear[@]}" step=1 t_end=1
    made "$name.zeta" "${files[@]}" scripts/mlg/gear/damping.c -- mlg damping "${gear[@]}" V=5:200:2000
  done
}

runs_paper() { disturbed paper l1 l2 li1 li2; }
runs_best() { disturbed best l2 li1 li2; }

tables() {
  local run
  begin_table results/transients.csv \
    "# Peaks and settling times after a disturbance of straight rolling at V m/s. choice: a gear of results/damping.csv." \
    "# disturbance psi: psi' = 1 rad/s, delta: delta' = 0.45 rad/s, 50 J each. psi_max deg, dstar_max m: largest |psi|, |delta*|;" \
    "# psi_5, dstar_5 s: from then on it stays below 5 % of that, integrated; psi_end, dstar_end 1/s: decay rate seen from 5 %" \
    "# to 2 %; rate 1/s, zeta: of the least damped mode, linear. V: 5, 10, ... 200 and where zeta is least between two of them." \
    choice,layout,V,disturbance,psi_max,dstar_max,psi_5,psi_end,dstar_5,dstar_end,rate,zeta,limits
  for run in paper.{l1,l2,li1,li2} best.{l2,li1,li2}; do
    [ -f "build/tables/transients.$run.csv" ] || fail "$figure: there is no build/tables/transients.$run.csv; $0 runs makes it"
    mlg pick "build/tables/transients.$run.csv" | sed "s/^/${run/./,},/" >> "$table.new"
  done
  replace "$table"
}

main transients "$@"
