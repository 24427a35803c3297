#!/usr/bin/env bash
# Figure 6: one-parameter bifurcation diagrams in V, layout L1 (paper 3.1.1)
#
#   scripts/fig06.sh            runs, tables and picture
#   scripts/fig06.sh runs [a|b|c]   the runs only, of one panel or of all
#   scripts/fig06.sh tables | draw  from what the runs, the tables left
#
# Panels: a c_d = 3.6e4, b 5e3, c 2e3 N m s/rad.
# Writes: results/fig06.csv, results/fig06.png and .svg, build/tables/points.fig06.csv
# Expect: (a) a psi branch from 13.43 to 33.84 m/s with a torus point at 30.79,
#         a delta branch from 25.09 to 61.62 with one at 27.37; A (V = 20):
#         psi 3.67 degrees; B (V = 40): delta* 12.2 mm.  (b) one stable delta
#         branch.  (c) one stable psi branch.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"

runs_a() {
  run fig06.a.straight l1.straight c_d=3.6e4 -- HB=4 UZ=1
  run fig06.a.psi   l1.periodic from=fig06.a.straight IRS="'HB1'" -- TR=1 UZ=3 closed=1
  run fig06.a.delta l1.periodic from=fig06.a.straight IRS="'HB2'" -- TR=1 UZ=3 closed=1
}

runs_b() {
  run fig06.b.straight l1.straight c_d=5e3 -- HB=2 UZ=1
  run fig06.b.delta l1.periodic from=fig06.b.straight IRS="'HB1'" -- TR=0 UZ=1 closed=1
}

runs_c() {
  run fig06.c.straight l1.straight c_d=2e3 -- HB=2 UZ=1
  run fig06.c.psi l1.periodic from=fig06.c.straight IRS="'HB1'" -- TR=0 UZ=1 closed=1
}

tables() {
  local panel branch
  local -A branches=([a]="psi delta" [b]=delta [c]=psi)
  begin_table results/fig06.csv \
    "# Figure 6. panel: a c_d = 3.6e4, b 5e3, c 2e3 N m s/rad; V m/s; psi_max deg; dstar_max m;" \
    "# stable: 1 yes, 0 no (a bifurcation point: 1); type: HB Hopf, TR torus" \
    panel,branch,type,V,psi_max,dstar_max,stable
  for panel in a b c; do
    points 6,l1 "fig06.$panel.straight"
    branch_rows "$panel" straight every=50
    for branch in ${branches[$panel]}; do
      [ "$(mlg shimmy "fig06.$panel.$branch")" = "$branch" ] || fail "fig06.$panel.$branch is no $branch-shimmy"
      points 6,l1 "fig06.$panel.$branch"
      branch_rows "$panel" "$branch" ends
    done
  done
  end_table
}

branch_rows() { # PANEL BRANCH WORD
  rows "fig06.$1.$2" prefix="$1,$2" columns=type,V,psi_max,dstar_max,stable:d bifurcations=stable "$3"
}

main fig06 "$@"
