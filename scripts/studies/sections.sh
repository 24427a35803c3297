#!/usr/bin/env bash
# Past the torus points of Figure 6(a): Poincare sections by time integration, L1
#
#   scripts/sections.sh            runs, tables and picture
#   scripts/sections.sh runs [branches|past|tori|elsewhere]   the runs only
#   scripts/sections.sh tables | draw
#
# Shows: what follows where a periodic solution loses its stability at a torus point,
#        on the section psi' = 0, the maxima of psi (a periodic solution is a point
#        there, a torus a closed curve): starts beside the unstable orbit at V = 32 and
#        26.5, and the torus itself, which is unstable and lies between the torus points.
#        It is found by bisection between a start that settles on the psi-shimmy
#        and one that settles on the delta-shimmy.
# Needs:  build/bin/mlg; the runs of Figure 6(a), and makes them.
# Writes: results/sections.csv, results/tori.csv, results/sections.png and .svg
# Expect: no stable torus: beyond each torus point the gear goes over to the other
#         oscillation (subcritical), here and at other c_d along the torus curves of
#         Figure 7; unstable tori from the delta orbit at V = 27.37 to the psi orbit at
#         30.79, at V = 29 with psi from 1.14 to 1.62 degrees on the section.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent build/bin/mlg

past='32 26.5'
between='28 29 30'
stay_from=40 stay_to=140 # s: while the gear is beside the torus
beyond='3.4e4 28.4 psi=0.03
3.4e4 25.8 delta=0.006
3.6e4 32 psi=0.03
3.6e4 26.5 delta=0.01
4.5e4 43.2 psi=0.02
4.5e4 32.8 delta=0.01
5.5e4 54.5 psi=0.02
5.5e4 42.6 delta=0.01'

simulate() { use build/bin/mlg; build/bin/mlg simulate l1 "$@"; }

section() { simulate section dpsi down c_d=3.6e4 "$@"; } # WORD...

runs_branches() {
  local V
  V=$(tr ' ' , <<< "$past $between")
  scripts/fig06.sh runs a
  run sections.psi l1.periodic from=fig06.a.straight IRS="'HB1'" "UZR={'torus': [-1e-5, 2e-5], 'V': [$V]}" -- TR=1 UZ=7 closed=1
  run sections.delta l1.periodic from=fig06.a.straight IRS="'HB2'" "UZR={'torus': [-1e-5, 2e-5], 'V': [$V]}" -- TR=1 UZ=7 closed=1
}

# start BRANCH V: words STATE=VALUE, a state of AUTO's periodic solution there
start() {
  local label
  use_run "sections.$1"
  use "build/runs/sections.$1/s.sections.$1"
  label=$(scripts/table.sh "sections.$1" labels | awk -F, -v V="$2" '
    /^#/ { next }
    !n++ { for (k = 1; k <= NF; k++) place[$k] = k; next }
    ($place["V"] - V) ^ 2 < 1e-12 && $place["type"] == "UZ" { print $place["label"] }')
  scripts/table.sh "sections.$1" solution "$label" | awk -F, '
    /^#/ { next }
    ++n == 1 { for (k = 2; k <= NF; k++) name[k] = $k }
    n == 2 { for (k = 2; k <= NF; k++) print name[k] "=" $k }'
}

# mixture SHARE FILE FILE: (1 - SHARE) of the first start and SHARE of the second
mixture() {
  awk -F= -v share="$1" 'NR == FNR { first[$1] = $2; next }
    { printf "%s=%.17g\n", $1, (1 - share) * first[$1] + share * $2 }' "$2" "$3"
}

# The periodic solutions on the section, and starts beside the unstable one by a
# thousandth of the other
runs_past() {
  local V branch other t_end work
  runs_branches
  for V in $past 29; do
    for branch in psi delta; do
      mapfile -t words < <(start "$branch" "$V")
      section V="$V" t_end=1 "${words[@]}" > "build/tables/sections.$branch.$V.csv"
      use "build/tables/sections.$branch.$V.csv"
    done
  done
  for V in $past; do
    work=build/tables/sections.past.$V
    if [ "$V" = 32 ]; then branch=psi other=delta t_end=900; else branch=delta other=psi t_end=250; fi
    start "$branch" "$V" > "$work.start"
    start "$other" "$V" > "$work.other"
    mapfile -t words < <(mixture 0.001 "$work.start" "$work.other")
    section V="$V" t_end="$t_end" "${words[@]}" > "$work.csv"
    use "$work.csv"
  done
}

# Whether psi-shimmy is left in the end: the last maxima of psi, above 1 degree or not
goes_to_psi() { # < section
  tail -n 40 | awk -F, '$4 > largest { largest = $4 } END { exit !(largest > 0.0175) }'
}

# The share between the starts that go to either side: the gear moves to the torus,
# stays, and leaves it at last, the later the more digits.
runs_tori() {
  local V work lo hi share i
  runs_branches
  for V in $between; do
    work=build/tables/sections.torus.$V
    start psi "$V" > "$work.psi"
    start delta "$V" > "$work.delta"
    lo=0 hi=1
    for i in {1..24}; do
      share=$(awk -v lo="$lo" -v hi="$hi" 'BEGIN { printf "%.17g", (lo + hi) / 2 }')
      mapfile -t words < <(mixture "$share" "$work.psi" "$work.delta")
      section V="$V" t_end=$((200 + 12 * i)) "${words[@]}" > "$work.csv"
      if goes_to_psi < "$work.csv"; then lo=$share; else hi=$share; fi
    done
    simulate section ddelta down c_d=3.6e4 V="$V" t_end=488 "${words[@]}" > "$work.ddelta.csv"
    use "$work.csv" "$work.ddelta.csv"
  done
}

# Beyond the torus curves of Figure 7, where the starts pass near the unstable orbit
runs_elsewhere() {
  local c_d V start
  while read -r c_d V start; do
    simulate orbit c_d="$c_d" V="$V" "$start" > "build/tables/sections.elsewhere.$c_d.$V.csv"
    use "build/tables/sections.elsewhere.$c_d.$V.csv"
  done <<< "$beyond"
}

# points PART V EVERY FROM TO FILE: rows V,t,psi,dstar of a section, one in EVERY, of
# the times FROM to TO
points_of() {
  use "$6"
  awk -F, -v part="$1" -v V="$2" -v every="$3" -v from="$4" -v to="$5" '
    /^#/ { next }
    !n++ { for (k = 1; k <= NF; k++) place[$k] = k; next }
    $1 >= from && $1 <= to && row++ % every == 0 {
      printf "%s,%s,%.6g,%.5g,%.5g\n", part, V, $1, $place["psi"] * 45 / atan2(1, 1), $place["dstar"] }' "$6" >> "$table.new"
}

# torus V: a row of results/tori.csv, from the time that the gear spends beside it
torus() {
  local work=build/tables/sections.torus.$1
  use "$work.csv" "$work.ddelta.csv"
  awk -F, -v V="$1" -v from="$stay_from" -v to="$stay_to" '
    FNR == 1 { file++ }
    /^#/ { next }
    $1 == "t" { for (k = 1; k <= NF; k++) place[$k] = k; next }
    $1 < from || $1 > to { next }
    file == 1 { half = 1 + ($1 > (from + to) / 2); if ($place["psi"] > psi[half]) psi[half] = $place["psi"] }
    file == 2 && $place["dstar"] > dstar { dstar = $place["dstar"] }
    END {
      psi_max = psi[1] > psi[2] ? psi[1] : psi[2]
      printf "36000,%s,between,torus,%.4g,%.4g,%.1e\n", V, psi_max * 45 / atan2(1, 1), dstar, psi[2] / psi[1] - 1
    }' "$work.csv" "$work.ddelta.csv" >> "$table.new"
}

tables() {
  local V c_d start work
  begin_table results/sections.csv \
    "# Past the torus points of Figure 6(a): layout L1, c_d = 3.6e4 N m s/rad, at maxima of psi (the section psi' = 0)." \
    "# part: past, from a start beside the unstable periodic solution (AUTO's, with a thousandth of the other one)," \
    "# one maximum in 5; torus, the unstable torus, while the gear stays beside it, one in 2; psi, delta: the periodic solutions." \
    "# V m/s, t s, psi deg, dstar m. By CVODE, relative tolerance of a step 1e-10." \
    part,V,t,psi,dstar
  for V in $past; do points_of past "$V" 5 0 900 "build/tables/sections.past.$V.csv"; done
  points_of torus 29 2 "$stay_from" "$stay_to" build/tables/sections.torus.29.csv
  for V in $past 29; do
    for start in psi delta; do points_of "$start" "$V" 1000 0 1 "build/tables/sections.$start.$V.csv"; done
  done
  replace "$table"
  begin_table results/tori.csv \
    "# What the gear comes to beyond torus points, layout L1. start: psi or delta, a start of that oscillation, V beyond" \
    "# its torus curve; between: on the edge between the two. found: the oscillation it settles on (psi, delta), or" \
    "# torus, unstable, while the gear stays beside it. c_d N m s/rad, V m/s, psi_max deg, dstar_max m;" \
    "# change: what it still moves, relative: of an oscillation to t = infinity, of psi_max on a torus in $((stay_to / 2 - stay_from / 2)) s." \
    c_d,V,start,found,psi_max,dstar_max,change
  while read -r c_d V start; do
    work=build/tables/sections.elsewhere.$c_d.$V.csv
    use "$work"
    awk -F, -v prefix="$(awk -v c_d="$c_d" 'BEGIN { print c_d + 0 }'),$V,${start%=*}" '
      match($0, / l_delta = [0-9.]+/) { l_delta = substr($0, RSTART + 11, RLENGTH - 11) }
      /^#/ { next }
      !n++ { for (k = 1; k <= NF; k++) place[$k] = k; next }
      {
        psi = $place["psi_max"] * atan2(1, 1) / 45
        printf "%s,%s,%.6g,%.6g,%s\n", prefix, ($place["dstar_max"] / l_delta > psi ? "delta" : "psi"),
          $place["psi_max"], $place["dstar_max"], $place["change"]
      }' "$work" >> "$table.new"
  done <<< "$beyond"
  for V in $between; do torus "$V"; done
  replace "$table"
}

main sections "$@"
