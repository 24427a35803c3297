#!/usr/bin/env bash
# Figure 9: the (V, c_d) plane of layout L2 for several k_s (paper 3.2)
#
#   scripts/fig09.sh            runs, tables and picture
#   scripts/fig09.sh runs [a|b]     the runs only, of one panel or of both
#   scripts/fig09.sh tables | draw
#
# Panels: (a) k_s from infinity down to 8e5, (b) from 5.9e5 down to 4.6e5 N m/rad.
#         Curves are made for V up to 200 m/s and c_d from 10 to 8e4; the picture
#         shows V up to 100 and c_d from 1e3 to 8e4 on a logarithmic axis.
# Writes: results/fig09.csv, results/fig09.png and .svg, build/tables/check.fig09.csv
# Expect: (a) the delta region shrinks, at 1e6 it is closed; (b) no delta region;
#         at 5.9e5 no shimmy from 4451.9 to 10692.6, at 4.6e5 the two psi regions
#         have met: no extremum of c_d is left.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/curves.sh

large="inf 3e6 1.5e6 1e6 8e5"
small="5.9e5 5.2e5 4.8e5 4.6e5"

# shellcheck disable=SC2086 # a word for each k_s
{
  runs_a() { diagrams l2 0 $large; }
  runs_b() { diagrams l2 0 $small; }

  tables() {
    begin_diagrams "# Figure 9. panel: a large k_s, b small k_s; layout L2."
    diagram_rows a 0 $large
    diagram_rows b 0 $small
    end_table
  }
}

main fig09 "$@"
