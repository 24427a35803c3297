#!/usr/bin/env bash
# convergence.sh - the special orbits of Figure 6 on finer meshes
#
#   tests/verify/convergence.sh [short]
#
# The torus points and the solutions A and B with twice the mesh intervals, with seven
# collocation points (AUTO's most) and tolerances a tenth; short: only the first.
# ours: results/special_points.csv, to be right to half a unit of the last digit shown.
# Needs:  the run fig06.a.straight, and makes it.
# Prints: rows what,unit,ours,oracle,tolerance (no header)
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/auto/lib.sh"

shown() { # RUN TYPE COLUMN
  mlg pick results/special_points.csv where=run="$1" where=type="$2" columns="$3"
}

found() { # RUN TYPE COLUMN [V]
  mlg point "$1" "$2" columns="${3/_hz/}:.10g" ${4:+where=V="$4"} || echo nan
}

# row WHAT UNIT OURS ORACLE: to half a unit of the last digit of OURS
row() {
  awk -v row="$1,$2,$3,$4" -v ours="$3" -v unit="$2" 'BEGIN {
    match(ours, /[.][0-9]*/)
    printf "%s,%.2g %s\n", row, 0.501 * 10 ^ (1 - RLENGTH), unit }'
}

run fig06.a.straight l1.straight c_d=3.6e4 -- HB=4 >&2
meshes="NTST=40"
[ "${1:-}" = short ] || meshes="NTST=40 NCOL=7"
for mesh in $meshes; do
  for branch in psi:HB1:20:A delta:HB2:40:B; do
    IFS=: read -r shimmy start V name <<< "$branch"
    fine=verify.$shimmy.${mesh/=/}
    run "$fine" l1.periodic from=fig06.a.straight IRS="'$start'" "$mesh" EPSL=1e-9 EPSU=1e-9 EPSS=1e-8 -- TR=1 closed=1 >&2
    for quantity in V:m/s psi_max:deg dstar_max:m frequency_hz:Hz; do
      IFS=: read -r column unit <<< "$quantity"
      row "torus point on the $shimmy branch ($mesh): $column" "$unit" \
        "$(shown "fig06.a.$shimmy" TR "$column")" "$(found "$fine" TR "$column")"
      [ "$column" = V ] || row "solution $name at V = $V ($mesh): $column" "$unit" \
        "$(shown "fig06.a.$shimmy" UZ "$column")" "$(found "$fine" UZ "$column" "$V")"
    done
  done
done
