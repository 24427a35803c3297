#!/usr/bin/env bash
# Figure 7: two-parameter bifurcation diagram in (V, c_d), layout L1 (paper 3.1.2)
#
#   scripts/fig07.sh            runs, tables and picture
#   scripts/fig07.sh runs [hopf|torus_psi_up|torus_psi_down|torus_delta]   the runs only
#   scripts/fig07.sh tables | draw
#
# Needs:  the runs of Figure 6, and makes them if they are not there.
# Writes: results/fig07.csv, results/fig07.png and .svg, build/tables/points.fig07.csv
# Expect: double Hopf points HH at (24.84, 3.204e4) and (60.98, 6.188e4), each
#         found on both Hopf curves; boundary points (LP) at c_d = 2754.35,
#         3018.98 and 31588; two torus curves between the HH points.
. "$(dirname "$(realpath "$0")")/lib.sh"

runs_hopf() {
  scripts/fig06.sh runs a
  scripts/fig06.sh runs c
  run fig07.psi.up     l1.hopf from=fig06.a.straight IRS="'HB1'" -- UZ=1
  run fig07.psi.down   l1.hopf from=fig06.a.straight IRS="'HB1'" DS=-0.1 -- LP=1 ZH=2 UZ=1
  run fig07.delta.up   l1.hopf from=fig06.a.straight IRS="'HB2'" -- UZ=1
  run fig07.delta.down l1.hopf from=fig06.a.straight IRS="'HB2'" DS=-0.1 -- LP=1 ZH=2 UZ=1
  run fig07.low.up     l1.hopf from=fig06.c.straight IRS="'HB1'" -- LP=1 UZ=1
  run fig07.low.down   l1.hopf from=fig06.c.straight IRS="'HB1'" DS=-0.1 -- UZ=1
}

# From the torus point of a branch of Figure 6 to the double Hopf points on
# either side.
torus_runs() { # BRANCH up|down...
  local branch=$1 way
  scripts/fig06.sh runs a
  run "fig07.torus_$branch.start" l1.torus_start from="fig06.a.$branch" -- EP=1
  shift
  for way; do
    case $way in up) set -- DS=0.1 ;; down) set -- DS=-0.05 DSMAX=0.2 ;; esac
    run "fig07.torus_$branch.$way" l1.torus from="fig07.torus_$branch.start" "$@" -- UZ=1
  done
}

runs_torus_psi_up() { torus_runs psi up; }
runs_torus_psi_down() { torus_runs psi down; }
runs_torus_delta() { torus_runs delta up down; }

tables() {
  local psi delta low # alone, so that a failure ends the script
  use_run fig06.a.psi fig06.a.delta fig06.c.psi
  psi=$(shimmy_of fig06.a.psi)
  delta=$(shimmy_of fig06.a.delta)
  low=$(shimmy_of fig06.c.psi)
  begin_table results/fig07.csv \
    "# Figure 7. curve; shimmy: what the region bounded by a Hopf curve shows, psi or delta; V m/s;" \
    "# c_d N m s/rad; type: HH double Hopf, LP boundary point. A curve runs from edge to edge, or HH to HH." \
    curve,shimmy,type,V,c_d
  curve "psi,$psi" fig07.psi
  curve "delta,$delta" fig07.delta
  curve "low,$low" fig07.low
  curve torus_psi, fig07.torus_psi
  curve torus_delta, fig07.torus_delta
  end_table
}

# Both halves of a curve as one; a torus run stops just short of the double
# Hopf points, which the table adds.
curve() { # PREFIX RUN
  local every=3
  case $2 in *torus*) every=1; double_hopf 2 "$1" ;; esac
  rows "$1" "type V c_d" "$every" "$2.up" reverse
  rows "$1" "type V c_d" "$every" "$2.down"
  case $2 in *torus*) double_hopf 1 "$1" ;; esac
  points 7 "$2.up"
  points 7 "$2.down"
}

double_hopf() { # WHICH PREFIX: a row for the first or second HH of the psi curve
  awk -F, -v which="$1" -v prefix="$2" '$3 == "fig07.psi.down" && $4 == "HH" && ++n == which {
    printf "%s,HH,%.6g,%.6g\n", prefix, $5, $6 }' "$points_table.new" >> "$table.new"
}

main fig07 "$@"
