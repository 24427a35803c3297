#!/usr/bin/env bash
# Figure 13: boundary points, zero-shimmy regions and largest width of layout LI1
#
#   scripts/fig13.sh [runs [low | high | widths] | tables | draw]
#
# Writes: results/fig13.csv (regions), results/fig13.png and .svg,
#         build/tables/boundary.fig13.csv, build/tables/widths.fig13.csv
# Expect: the widest interval over k_s at each b, 11244.1 N m s/rad at b = 140
#         N m s^2/rad; the largest of all where the third psi region takes over
#         from BP1 as the lower bound.
# Widths: follow_widths of scripts/auto/boundary.sh, one run of AUTO a stretch of b.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/auto/boundary.sh

asked=0.156739811912226 # 1e5 / 6.38e5, where the paper gives its interval at b = 140

runs_low() { for b in 20 30 70; do boundary_curves li1 "$b"; done; }
runs_high() { for b in 100 130 150; do boundary_curves li1 "$b"; done; }

runs_widths() {
  boundary_curves li1 140 UZR="{'compliance': $asked}"
  boundary_curves li1 0
  follow_widths li1
}

tables() {
  local b
  begin_regions
  for b in 20 30 70 100 130 140 150; do
    boundary_points 13 li1 "$b"
  done
  width_rows li1
  no_interval li1 200
  end_regions
}

main fig13 "$@"
