#!/usr/bin/env bash
# Figure 15: zero-shimmy regions and largest width of layout LI2
#
#   scripts/fig15.sh [runs [low | high | widths] | tables | draw]
#
# Writes: results/fig15.csv (regions), results/fig15.png and .svg,
#         build/tables/boundary.fig15.csv, build/tables/widths.fig15.csv
# Expect: the widest interval over k_s is limited by the onset of the delta
#         region at every b, and grows with b: 19100 N m s/rad at b = 140.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/auto/boundary.sh

runs_low() { for b in 0 50 80; do boundary_curves li2 "$b"; done; }
runs_high() { for b in 100 120 140; do boundary_curves li2 "$b"; done; }

runs_widths() { follow_widths li2; }

tables() {
  local b
  begin_regions
  for b in 0 50 80 100 120 140; do
    boundary_points 15 li2 "$b"
  done
  width_rows li2
  end_regions
}

main fig15 "$@"
