#!/usr/bin/env bash
# Figure 10: boundary points and zero-shimmy region of layout L2 over k_s
#
#   scripts/fig10.sh [runs | tables | draw]
#
# Needs:  results/fig09.csv for the diagram in (a).
# Writes: results/fig10.csv (regions), results/fig10.png and .svg,
#         build/tables/boundary.fig10.csv (boundary points)
# Expect: the two psi regions meet at k_s = 4.737e5 N m/rad, the delta region
#         is born at 7.865e5; at 7.86e5 the interval is (3813.91, 14032.51).
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/auto/boundary.sh

asked=0.127226463104325 # 1e5 / 7.86e5, where the paper gives its interval

runs_l2() { boundary_curves l2 0 UZR="{'compliance': $asked}"; }

tables() {
  begin_regions
  boundary_points 10 l2 0
  end_regions
}

main fig10 "$@"
