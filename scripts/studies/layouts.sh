#!/usr/bin/env bash
# Layouts LI3, LI4 and LI5, beyond the paper: diagrams, boundary points, widths
#
#   scripts/layouts.sh [runs [li3 | li4 | li5] | tables | draw]
#
# Writes: results/layouts.csv (regions over k_s), layouts_planes.csv (Hopf curves),
#         layouts_branches.csv (shimmy at c_d = 3.6e4), results/layouts.png and .svg,
#         build/tables/boundary.layouts.csv, build/tables/widths.layouts.csv
# Expect: largest width over k_s and b, N m s/rad: LI3 14101 at b = 28.77; LI4 grows
#         with b as LI2 does, 16859 at b = 140; LI5 7848 at b = 100.69, where the third
#         psi region takes over from BP1 as the lower bound.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
. scripts/auto/boundary.sh
. scripts/curves.sh

# Where the diagrams are: beside the largest width; LI4, which has none, at LI2's b.
declare -A b=([li3]=29 [li4]=140 [li5]=100) k_s=([li3]=7.16e5 [li4]=2.38e6 [li5]=5.35e5)

diagrams_of() { # LAYOUT
  boundary_curves "$1" "${b[$1]}"
  boundary_curves "$1" 0
  hopf_curves "$1" "layouts.$1" b="${b[$1]}" k_s="${k_s[$1]}"
  run "layouts.$1.straight" "$1.straight" b="${b[$1]}" k_s="${k_s[$1]}" c_d=3.6e4 -- HB=2
  run "layouts.$1.shimmy" "$1.periodic" from="layouts.$1.straight" IRS="'HB1'" -- closed=1
}

# LI3's interval grows on until it would end in a fold; after run 2 the stationary
# interval is another one, beyond a fold in b that is at its end.
runs_li3() {
  local p
  diagrams_of li3
  follow_widths li3 li3.look 1 DSMAX=0.2
  follow_widths li3 li3. 2 reports="$(peak_width layouts.width.li3.look1)"
  mapfile -t p < <(solution layouts.width.li3.2 last)
  run layouts.width.li3.turn boundary.width model=li3.boundary "$(unknowns "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}")" "${p[4]}" \
    closing=2 DS=-0.001 DSMAX=0.01 UZSTOP="{'b': 43.0}" -- UZ=1
  mapfile -t p < <(solution layouts.width.li3.turn last)
  widths li3 li3.3 boundary.width "${p[@]}" closing=2 "$(stop_at "'width': 100.0")"
}

runs_li4() {
  diagrams_of li4
  follow_widths li4 li4. 1
}

runs_li5() {
  diagrams_of li5
  follow_widths li5 li5.
}
# Drops from the rows in hand those of a layout that are narrower than one of its runs
# is at that b; the runs overlap where one mechanism takes over from another.
drop_narrower() { # LAYOUT RUN...
  local layout=$1 run files=()
  shift
  for run; do files+=("build/runs/$run/b.$run"); done
  awk -v layout="$layout" -v rows="$widths_table.new" -f scripts/auto.awk -f <(echo '
    FILENAME != file { file = FILENAME; first[++runs] = n + 1 }
    { b[++n] = value["b"]; w[n] = value["width"]; of[n] = runs }
    END {
      while ((getline row < rows) > 0) {
        split(row, cell, ",")
        widest = 1
        for (i = 2; i <= n && cell[1] == layout; i++)
          if (of[i] == of[i - 1] && (b[i] - cell[2]) * (b[i - 1] - cell[2]) <= 0 && b[i] != b[i - 1] &&
              w[i - 1] + (w[i] - w[i - 1]) * (cell[2] - b[i - 1]) / (b[i] - b[i - 1]) > 1.001 * cell[6]) widest = 0
        if (widest) print row
      }
    }') "${files[@]}" > "$widths_table.wide"
  mv "$widths_table.wide" "$widths_table.new"
}

tables() {
  local layout file
  begin_diagrams "# Hopf curves beside the largest width; panel: the layout." results/layouts_planes.csv
  for layout in li3 li4 li5; do curve_rows "$layout,${b[$layout]},${k_s[$layout]}," "layouts.$layout"; done
  end_diagrams

  begin_table results/layouts_branches.csv \
    "# Shimmy at c_d = 3.6e4 N m s/rad and the b and k_s of layouts_planes.csv. V m/s; psi_max deg; dstar_max m;" \
    "# stable: 1 yes, 0 no (a bifurcation point: 1); type: HB Hopf, TR torus" \
    layout,branch,type,V,psi_max,dstar_max,stable
  for layout in li3 li4 li5; do
    points layouts "layouts.$layout.straight"
    points layouts "layouts.$layout.shimmy"
    rows "$layout,straight" "type V psi_max dstar_max stable" 50 "layouts.$layout.straight"
    rows "$layout,$(shimmy_of "layouts.$layout.shimmy")" "type V psi_max dstar_max stable" 1 "layouts.$layout.shimmy"
  done
  end_table

  begin_regions
  for layout in li3 li4 li5; do boundary_points layouts "$layout" "${b[$layout]}"; done
  width_rows li3 layouts.width.li3.{1,2,3}
  drop_narrower li3 layouts.width.li3.{1,2,turn,3}
  no_interval li3 90
  width_rows li4 layouts.width.li4.1
  width_rows li5 layouts.width.li5.{1,2,3,4,5,6,7}
  drop_narrower li5 layouts.width.li5.{1,2,3,4,5,6,7}
  no_interval li5 150
  end_regions
}

main layouts "$@"
