#!/usr/bin/env bash
# Figure 12: the (V, c_d) plane of layout LI1 for several b and k_s (paper 4.2)
#
#   scripts/fig12.sh            runs, tables and picture
#   scripts/fig12.sh runs [b20_30|b70_100|b130_150]   the runs only, for two b or all
#   scripts/fig12.sh tables | draw
#
# Panels: a to f, b = 20, 30, 70, 100, 130, 150 N m s^2/rad.
#         Curves are made for V up to 200 m/s and c_d from 10 to 8e4; the picture
#         shows V up to 100 and c_d from 100 to 4e4 on a logarithmic axis.
# Writes: results/fig12.csv, results/fig12.png and .svg, build/tables/check.fig12.csv
# Expect: b = 30: a delta strip from c_d < 10 up to 3669 (k_s = 4e5, BP1 = 3825), to
#         12398 at 7e5; b = 70: a small closed delta curve at 4.4e5; a third psi
#         region, its top at 304 (b = 70) to 3287 (b = 150) at k_s = 5e5, there above BP1.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/curves.sh

declare -A stiffnesses=(
  [20]="4e5 5e5 6e5 7e5" [30]="4e5 5e5 6e5 7e5"
  [70]="4e5 4.4e5 5e5 7e5" [100]="5e5 5.4e5 6e5 7e5"
  [130]="5e5 6e5 6.2e5 7e5" [150]="5e5 6e5 6.7e5 7e5"
)

# shellcheck disable=SC2086 # a word for each k_s
{
  of() { local b; for b; do diagrams li1 $b ${stiffnesses[$b]}; done; }

  runs_b20_30() { of 20 30; }
  runs_b70_100() { of 70 100; }
  runs_b130_150() { of 130 150; }

  tables() {
    local b panels=(a b c d e f) n=0
    begin_diagrams "# Figure 12. panel: a to f, b = 20, 30, 70, 100, 130, 150; layout LI1."
    for b in 20 30 70 100 130 150; do diagram_rows "${panels[n++]}" $b ${stiffnesses[$b]}; done
    end_table
  }
}

main fig12 "$@"
