#!/usr/bin/env bash
# Three sweeps of use, and one that holds AUTO against the algebra (docs/sweeps.md)
#
#   scripts/studies/sweeps.sh [runs [load | map | play | hopf] | tables | draw]
#
# Writes: results/sweeps.csv (load x tolerance x layout), sweeps_map.csv (zeta over e and l),
#         sweeps_play.csv (shimmy with play and friction), sweeps_hopf.csv (AUTO and the algebra),
#         results/sweeps.png and .svg; build/sweeps
# Expect: at the paper's load no c_d keeps more than 45 % (L1) to 53 % (LI2) of the gears within
#         10 % of the drawing free of shimmy, at 0.7 of it nearly all.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

sweep() { scripts/sweep.sh run "constants/sweeps/$1.sweep" || exit $?; }

runs_load() { sweep load; }
runs_map() { sweep map; }
runs_play() { sweep play; }
runs_hopf() { sweep hopf; }

answers() { # NAME: rows of a sweep's table, names first
  local table=build/sweeps/$1/table.csv
  [ -s "$table" ] || fail "sweeps: there is no $table; scripts/studies/sweeps.sh runs $1 makes it" 2
  use "$table"
  grep -v '^#' "$table"
}

tables() {
  begin_table results/sweeps.csv \
    "# Which share of the gears a c_d keeps free of shimmy at every speed (constants/sweeps/load.sweep): 10 000 gears around" \
    "# the drawing for each layout and static load. F_z N; some %: of them with any interval of c_d; c_d N m s/rad, the best," \
    "# and share %, of those in whose widest interval it is; c90_lo, c90_hi: the c_d around it that keep 90 % or more; c50." \
    layout,F_z,gears,some,c_d,share,c50_lo,c50_hi,c90_lo,c90_hi
  answers load | coverage >> "$table.new"
  end_table

  begin_table results/sweeps_map.csv \
    "# The best damping ratio over caster and relaxation length (constants/sweeps/map.sweep). e, l m; c_d N m s/rad: the best;" \
    "# zeta: the least of all oscillations at V = 0.3 to 200 m/s there, below 0 with shimmy; V m/s, where; shimmy: the mode." \
    layout,k_s,b,e,l,c_d,zeta,V,shimmy
  answers map | sed 1d | cut -d , -f 2- >> "$table.new"
  end_table

  begin_table results/sweeps_play.csv \
    "# Shimmy that play keeps alive, layout L1 at V = 20 m/s and c_d = 2886.7 N m s/rad (constants/sweeps/play.sweep). g_psi rad:" \
    "# half-width of the play of the torque links; T_f N m: friction of the damper; psi_max deg, dstar_max m, frequency_hz of AUTO's" \
    "# branch in T_f (corner 0.005, 150 intervals; 1e-4 and better beside mlg cycle) from the periodic orbit that a start of 0.05 rad" \
    "# leads to at T_f = 0; stable: 1, 0; type: EP that orbit, UZ asked for, LP a fold." \
    g_psi,T_f,psi_max,dstar_max,frequency_hz,stable,type
  answers play | sed 1d | cut -d , -f 2- >> "$table.new"
  end_table

  begin_table results/sweeps_hopf.csv \
    "# The first Hopf point along V, 1 to 60 m/s, of 10 000 gears of layout L1 by a run of AUTO (DSMAX = 0.2 m/s) and by" \
    "# mlg hopf (constants/sweeps/hopf.sweep). difference: the largest, relative; rejected: a point was stepped over, and missed again." \
    outcome,gears,difference
  { answers hopf && if [ -s build/sweeps/hopf/failed.csv ]; then grep -v '^#' build/sweeps/hopf/failed.csv | sed '1d; s/^/failed,/'; fi; } |
    outcomes >> "$table.new"
  end_table
}

# A row for each layout and load: the ends of intervals in order, each the beginning or the
# end of one gear's; how many are open there is how many gears that c_d keeps free.
coverage() {
  awk -F, '
    NR == 1 { for (k = 1; k <= NF; k++) place[$k] = k; next }
    { at = $place["layout"] "," $place["F_z"]; print at ",0,0"
      if ($place["c_lo"] != "") { print at "," $place["c_lo"] ",1"; print at "," ($place["c_hi"] == "inf" ? 1e99 : $place["c_hi"]) ",-1" } }' |
    sort -t , -k 1,1 -k 2,2g -k 3,3g -k 4,4gr |
    awk -F, '
      function ends(level,   k, from, to) { # of the range around the best that keeps that share
        if (share[best] < level) return ","
        for (from = best; from > 1 && share[from - 1] >= level; from--) ;
        for (to = best; to <= n && share[to] >= level; to++) ;
        return sprintf("%.6g,%.6g", c[from], c[to])
      }
      function row(   k) {
        best = 1
        for (k = 1; k <= n; k++) { share[k] *= 100 / gears; if (share[k] > share[best]) best = k }
        printf "%s,%d,%.2f,%.6g,%.2f,%s,%s\n", last, gears, 100 * some / gears, n ? c[best] : 0, n ? share[best] : 0, ends(50), ends(90)
      }
      { at = $1 "," $2 }
      at != last { if (last != "") row(); last = at; n = gears = some = open = 0 }
      $4 == 0 { gears++; next }
      { open += $4; some += $4 > 0; c[++n] = $3; share[n] = open }
      END { row() }'
}

outcomes() {
  awk -F, '
    NR == 1 { for (k = 1; k <= NF; k++) place[$k] = k; next }
    $1 == "failed" { failed++; next }
    { auto = $place["V_auto"]; exact = $place["V_exact"]; d = exact != "" ? (auto - exact) / exact : 0; if (d < 0) d = -d }
    exact == "" && auto == "" { none++; next }
    (exact == "") != (auto == "") { other++; next }
    d < 1e-6 { same++; if (d > most) most = d; next }
    { other++ }
    END {
      printf "the same point,%d,%.1e\nno point,%d,\n", same, most, none
      printf "the run was rejected,%d,\n", failed
      printf "another point,%d,\n", other }'
}

main sweeps "$@"
