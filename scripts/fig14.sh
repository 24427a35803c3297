#!/usr/bin/env bash
# Figure 14: the (V, c_d) plane of layout LI2 for b = 50 and 100, several k_s (paper 4.3)
#
#   scripts/fig14.sh            runs, tables and picture
#   scripts/fig14.sh runs [b50|b100]   the runs only, for one b or both
#   scripts/fig14.sh tables | draw
#
# Panels: a1, a2 b = 50 at small and large k_s; b1, b2 b = 100 N m s^2/rad.
#         Curves are made for V up to 200 m/s and c_d from 10 to 8e4; the picture
#         shows V up to 100 and c_d from 1e3 to 8e4 on a logarithmic axis.
# Writes: results/fig14.csv, results/fig14.png and .svg, build/tables/check.fig14.csv
# Expect: b = 50: a delta region from k_s = 1.392e6 on; b = 100: one below 8.58e5 (at
#         8e5 from c_d = 2416 to 11538), none at 1e6, another from 1.998e6 on.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/curves.sh

small_50="6e5 8e5 1e6" large_50="1.4e6 2e6 3e6"
small_100="6e5 8e5 8.4e5 1e6" large_100="1.4e6 2e6 2.1e6 3e6"

# shellcheck disable=SC2086 # a word for each k_s
{
  runs_b50() { diagrams li2 50 $small_50 $large_50; }
  runs_b100() { diagrams li2 100 $small_100 $large_100; }

  tables() {
    begin_diagrams "# Figure 14. panel: a1, a2 b = 50, b1, b2 b = 100, each at small and large k_s; layout LI2."
    diagram_rows a1 50 $small_50
    diagram_rows a2 50 $large_50
    diagram_rows b1 100 $small_100
    diagram_rows b2 100 $large_100
    end_table
  }
}

main fig14 "$@"
