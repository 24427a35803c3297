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
. "$(dirname "$0")/lib.sh"
. scripts/boundary.sh

asked=0.156739811912226 # 1e5 / 6.38e5, where the paper gives its interval at b = 140

runs_low() { for b in 20 30 70; do boundary_curves li1 "$b"; done; }
runs_high() { for b in 100 130 150; do boundary_curves li1 "$b"; done; }

# The widest interval in b, limited in turn by (docs/boundary.md)
#  1 the onset of the delta region, until it is born below BP1,
#  2 BP2_u reaching BP1, until the interval above BP2_u is the wider,
#  3 the stationary width of that one, as long as it is wider than
#  4 BP2_u reaching BP1 again, until that is an onset again,
#  5 the onset, until the third psi region takes over from BP1,
#  6 the onset above the third psi region, until it is born below its top,
#  7 BP2_u reaching that top, until the region ends.
# Each run starts where the last one ended.
runs_widths() {
  local at p equal
  boundary_curves li1 140 UZR="{'compliance': $asked}"
  boundary_curves li1 0
  at=$(onset_of li1 0)
  mapfile -t p < <(solution "$at" LP)
  widths li1 1 boundary.width "${p[0]}" "$(low_and_high li1 0 "${p[1]}")" "${p[1]}" b=0 "$(stop_at "'gap': 0.0")"
  mapfile -t p < <(solution fig13.width.1 last)
  widths li1 2 boundary.width "${p[0]}" "${p[1]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=1 "$(stop_at "'slope_1': 0.0")"
  mapfile -t p < <(solution fig13.width.2 last)
  widths li1 3 boundary.width "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=2 DSMAX=0.01 "$(stop_at "'gap': 0.0")"
  mapfile -t p < <(solution fig13.width.3 last)
  # run 4 begins on the far side of the fold of run 3: first a look where it is the wider
  run fig13.width.equal boundary.width model=li1.boundary "$(unknowns "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}")" \
    "${p[4]}" closing=1 DS=0.001 DSMAX=0.001 NMX=60 -- EP=1
  equal=$(equal_widths fig13.width.3 fig13.width.equal)
  widths li1 4 boundary.width "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=1 DS=0.001 "$(stop_at "'fold': 0.0")" reports="$equal"
  mapfile -t p < <(solution fig13.width.4 last)
  widths li1 5 boundary.rival "${p[0]}" "$(third li1 "${p[4]#b=}" "${p[3]}")" "${p[1]}" "${p[2]}" "${p[3]}" "${p[4]}" "$(stop_at "'rival': 0.0")"
  mapfile -t p < <(solution fig13.width.5 last)
  widths li1 6 boundary.width "${p[0]}" "${p[1]}" "${p[3]}" "${p[4]}" "${p[5]}" "$(stop_at "'gap': 0.0")"
  mapfile -t p < <(solution fig13.width.6 last)
  widths li1 7 boundary.width "${p[0]}" "${p[1]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=1 DSMAX=0.1 "$(stop_at "'width': 100.0")"
}

tables() {
  local b
  begin_regions
  for b in 20 30 70 100 130 140 150; do
    boundary_points 13 li1 "$b"
  done
  width_rows li1 fig13.width.{1,2,3,4,5,6,7}
  no_interval li1 200
  end_regions
}

main fig13 "$@"
