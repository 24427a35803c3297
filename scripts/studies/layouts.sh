#!/usr/bin/env bash
# Layouts LI3 to LI7, beyond the paper: diagrams, boundary points, widths
#
#   scripts/studies/layouts.sh [runs [li3 | li4 | li5 | li6 | li7] | tables | draw]
#
# Writes: results/layouts.csv (regions over k_s), layouts_planes.csv (Hopf curves),
#         layouts_branches.csv (shimmy at c_d = 3.6e4), results/layouts.png and .svg,
#         build/tables/boundary.layouts.csv, build/tables/widths.layouts.csv
# Expect: largest width over k_s and b, N m s/rad: LI3 14101 at b = 28.78; LI4 grows
#         with b as LI2 does, 16859 at b = 140; LI5 7848 at b = 100.69, where the third
#         psi region takes over from BP1 as the lower bound; LI6 13766 at b = 254.25; LI7 10246 at b = 27.04.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
. scripts/auto/boundary.sh
. scripts/curves.sh

# Where the diagrams are: beside the largest width; LI4, which has none, at LI2's b.
declare -A b=([li3]=29 [li4]=140 [li5]=100 [li6]=250 [li7]=27)
declare -A k_s=([li3]=7.16e5 [li4]=2.38e6 [li5]=5.35e5 [li6]=5.48e5 [li7]=6.48e5)
beyond=$(sed -n 's/^parts_layouts := //p' Makefile)
# Of LI6 a second psi mode, of 3 to 4 Hz, shimmies there.
declare -A HB=([li6]=3) branches=([li6]="shimmy slow")

diagrams_of() { # LAYOUT
  boundary_curves "$1" "${b[$1]}"
  hopf_curves "$1" "layouts.$1" b="${b[$1]}" k_s="${k_s[$1]}"
  run "layouts.$1.straight" "$1.straight" b="${b[$1]}" k_s="${k_s[$1]}" c_d=3.6e4 -- HB="${HB[$1]:-2}"
  run "layouts.$1.shimmy" "$1.periodic" from="layouts.$1.straight" IRS="'HB1'" -- closed=1
}

runs_li3() { diagrams_of li3; follow_widths li3 li3.; }
runs_li4() { diagrams_of li4; follow_widths li4 li4.; }
runs_li5() { diagrams_of li5; follow_widths li5 li5.; }
runs_li6() {
  diagrams_of li6
  # ends at the Hopf point at 0.73 m/s, past which AUTO would go round again
  run layouts.li6.slow li6.periodic from=layouts.li6.straight IRS="'HB2'" ILP=1 STOP="['LP3']" -- TR=1 LP=2 closed=1
  follow_widths li6 li6.
}
runs_li7() { diagrams_of li7; follow_widths li7 li7.; }

tables() {
  local layout branch
  begin_diagrams "# Hopf curves beside the largest width; panel: the layout." results/layouts_planes.csv
  for layout in $beyond; do curve_rows "$layout,${b[$layout]},${k_s[$layout]}," "layouts.$layout"; done
  end_table

  begin_table results/layouts_branches.csv \
    "# Shimmy at c_d = 3.6e4 N m s/rad and the b and k_s of layouts_planes.csv, a branch after another. V m/s; psi_max deg; dstar_max m;" \
    "# stable: 1 yes, 0 no (a bifurcation point: 1); type: HB Hopf, TR torus, LP fold" \
    layout,branch,type,V,psi_max,dstar_max,stable
  for layout in $beyond; do
    points "layouts,$layout" "layouts.$layout.straight"
    branch_rows "$layout" straight straight every=50
    for branch in ${branches[$layout]:-shimmy}; do
      points "layouts,$layout" "layouts.$layout.$branch"
      branch_rows "$layout" "$(mlg shimmy "layouts.$layout.$branch")" "$branch" ends
    done
  done
  end_table

  begin_regions
  for layout in $beyond; do
    boundary_points layouts "$layout" "${b[$layout]}"
    [ "$layout" != li6 ] || no_interval li6 50
    width_rows "$layout"
    case $layout in li3) no_interval li3 90 ;; li5) no_interval li5 150 ;; li7) no_interval li7 90 ;; esac
  done
  end_regions
}

branch_rows() { # LAYOUT SHIMMY RUN WORD
  rows "layouts.$1.$3" prefix="$1,$2" columns=type,V,psi_max,dstar_max,stable:d bifurcations=stable "$4"
}

main layouts "$@"
