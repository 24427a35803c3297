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
. "$(dirname "$(realpath "$0")")/auto/lib.sh"

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
  local psi delta low
  psi=$(mlg shimmy fig06.a.psi)
  delta=$(mlg shimmy fig06.a.delta)
  low=$(mlg shimmy fig06.c.psi)
  begin_table results/fig07.csv \
    "# Figure 7. curve; shimmy: what the region bounded by a Hopf curve shows, psi or delta; V m/s;" \
    "# c_d N m s/rad; type: HH double Hopf, LP boundary point. A curve runs from edge to edge, or HH to HH." \
    curve,shimmy,type,V,c_d
  curve "psi,$psi" fig07.psi every=3
  curve "delta,$delta" fig07.delta every=3
  curve "low,$low" fig07.low every=3
  torus_curve torus_psi
  torus_curve torus_delta
  end_table
}

# Both halves of a curve as one
curve() { # PREFIX RUN [WORD]
  rows "$2.up" prefix="$1" columns=type,V,c_d reverse "${@:3}"
  rows "$2.down" prefix="$1" columns=type,V,c_d "${@:3}"
  points 7,l1 "$2.up" "$2.down"
}

# A torus run stops just short of the double Hopf points, which the table adds.
torus_curve() { # NAME
  double_hopf 2 "$1"
  curve "$1," "fig07.$1"
  double_hopf 1 "$1"
}

double_hopf() { # WHICH NAME: a row for the first or second HH of the psi curve
  mlg rows fig07.psi.down only=HH prefix="$2," columns=type,V,c_d | sed -n "$1p" >> "$table.new"
}

main fig07 "$@"
