#!/usr/bin/env bash
# Past the torus points of Figure 6(a): Poincare sections by time integration, L1
#
#   scripts/studies/sections.sh     runs, tables and picture
#   scripts/studies/sections.sh runs [branches|past|tori|elsewhere]   the runs only
#   scripts/studies/sections.sh tables | draw
#
# Shows: what follows where a periodic solution loses its stability at a torus point,
#        on the section psi' = 0, the maxima of psi (a periodic solution is a point
#        there, a torus a closed curve): starts beside the unstable orbit at V = 32 and
#        26.5, and the torus itself, which is unstable and lies between the torus points.
#        It is found by bisection between a start that settles on the psi-shimmy
#        and one that settles on the delta-shimmy.
# Needs:  the runs of Figure 6(a), and makes them.
# Writes: results/sections.csv, results/tori.csv, results/sections.png and .svg
# Expect: no stable torus: beyond each torus point the gear goes over to the other
#         oscillation (subcritical), here and at other c_d along the torus curves of
#         Figure 7; unstable tori from the delta orbit at V = 27.37 to the psi orbit at
#         30.79, at V = 29 with psi from 1.14 to 1.62 degrees on the section.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

past='32 26.5'
between='28 29 30'
stay_from=40 stay_to=140 # s: while the gear is beside the torus
degrees=57.295779513082323
beyond='3.4e4 28.4 psi=0.03
3.4e4 25.8 delta=0.006
3.6e4 32 psi=0.03
3.6e4 26.5 delta=0.01
4.5e4 43.2 psi=0.02
4.5e4 32.8 delta=0.01
5.5e4 54.5 psi=0.02
5.5e4 42.6 delta=0.01'

# simulated NAME WORD...: what mlg simulate l1 finds, as build/tables/sections.NAME.csv
simulated() {
  local files
  mapfile -t files < <(sources l1 models/libmlg/integrate.c scripts/mlg/gear/simulate.c)
  made "sections.$1" "${files[@]}" -- mlg simulate l1 "${@:2}"
}

section() { simulated "$1" section dpsi down c_d=3.6e4 "${@:2}"; } # NAME WORD...

runs_branches() {
  local V
  V=$(tr ' ' , <<< "$past $between")
  scripts/fig06.sh runs a
  run sections.psi l1.periodic from=fig06.a.straight IRS="'HB1'" "UZR={'torus': [-1e-5, 2e-5], 'V': [$V]}" -- TR=1 UZ=7 closed=1
  run sections.delta l1.periodic from=fig06.a.straight IRS="'HB2'" "UZR={'torus': [-1e-5, 2e-5], 'V': [$V]}" -- TR=1 UZ=7 closed=1
}

# Words STATE=VALUE, a state of AUTO's periodic solution
start() { # BRANCH V
  mlg orbit "sections.$1" "$(mlg point "sections.$1" UZ where=V="$2" columns=label)" start
}

# (1 - SHARE) of the first start and SHARE of the second, in $words
mixture() { # SHARE START START
  mapfile -t words < <(paste -d = <(echo "$2") <(echo "$3") \
    | awk -F= -v share="$1" '{ printf "%s=%.17g\n", $1, (1 - share) * $2 + share * $4 }')
}

# The periodic solutions on the section, and starts beside the unstable one by a
# thousandth of the other
runs_past() {
  local V branch other t_end words
  runs_branches
  for V in $past 29; do
    for branch in psi delta; do
      mapfile -t words < <(start "$branch" "$V")
      section "$branch.$V" V="$V" t_end=1 "${words[@]}"
    done
  done
  for V in $past; do
    if [ "$V" = 32 ]; then branch=psi other=delta t_end=900; else branch=delta other=psi t_end=250; fi
    mixture 0.001 "$(start "$branch" "$V")" "$(start "$other" "$V")"
    section "past.$V" V="$V" t_end="$t_end" "${words[@]}"
  done
}

# The share between the starts that go to either side: the gear moves to the torus,
# stays, and leaves it at last, the later the more digits.
runs_tori() {
  local V files
  runs_branches
  mapfile -t files < <(sources l1 models/libmlg/integrate.c scripts/mlg/gear/simulate.c)
  for V in $between; do
    made "sections.share.$V" "${files[@]}" build/runs/sections.{psi/s.sections.psi,delta/s.sections.delta} -- share "$V"
    mixture "$(< "build/tables/sections.share.$V.csv")" "$(start psi "$V")" "$(start delta "$V")"
    section "torus.$V" V="$V" t_end=488 "${words[@]}"
    simulated "torus.$V.ddelta" section ddelta down c_d=3.6e4 V="$V" t_end=488 "${words[@]}"
  done
}

share() { # V
  local psi delta lo=0 hi=1 share i words
  psi=$(start psi "$1") delta=$(start delta "$1")
  for i in {1..24}; do
    share=$(awk -v lo="$lo" -v hi="$hi" 'BEGIN { printf "%.17g", (lo + hi) / 2 }')
    mixture "$share" "$psi" "$delta"
    # whether psi-shimmy is left in the end: the last maxima of psi, above 1 degree or not
    if mlg simulate l1 section dpsi down c_d=3.6e4 V="$1" t_end=$((200 + 12 * i)) "${words[@]}" | tail -n 40 \
      | awk -F, '$4 > 0.0175 { found = 1 } END { exit !found }'; then lo=$share; else hi=$share; fi
  done
  echo "$share"
}

# Beyond the torus curves of Figure 7, where the starts pass near the unstable orbit
runs_elsewhere() {
  local c_d V start
  while read -r c_d V start; do
    simulated "elsewhere.$c_d.$V" orbit c_d="$c_d" V="$V" "$start"
  done <<< "$beyond"
}

# Rows V,t,psi,dstar of a section, one in EVERY of the times between FROM and TO
points_of() { # PART V EVERY FROM TO NAME
  mlg pick "build/tables/sections.$6.csv" where="t>$4" where="t<$5" every="$3" columns=t:.6g,psi*$degrees:.5g,dstar:.5g \
    | sed "s/^/$1,$2,/" >> "$table.new"
}

# The largest VALUE of a section from FROM to TO
largest() { # NAME COLUMN FROM TO
  mlg pick "build/tables/sections.$1.csv" where="t>$3" where="t<$4" columns="$2" | sort -g | tail -n 1
}

# A row of results/tori.csv, from the time that the gear spends beside the torus
torus() { # V
  local middle=$(((stay_from + stay_to) / 2))
  awk -v V="$1" -v first="$(largest "torus.$1" "psi*$degrees:.17g" $stay_from $middle)" \
    -v second="$(largest "torus.$1" "psi*$degrees:.17g" $middle $stay_to)" \
    -v dstar="$(largest "torus.$1.ddelta" dstar $stay_from $stay_to)" 'BEGIN {
      printf "36000,%s,between,torus,%.4g,%.4g,%.1e\n", V, (first > second ? first : second), dstar, second / first - 1 }' >> "$table.new"
}

tables() {
  local V c_d start
  begin_table results/sections.csv \
    "# Past the torus points of Figure 6(a): layout L1, c_d = 3.6e4 N m s/rad, at maxima of psi (the section psi' = 0)." \
    "# part: past, from a start beside the unstable periodic solution (AUTO's, with a thousandth of the other one)," \
    "# one maximum in 5; torus, the unstable torus, while the gear stays beside it, one in 2; psi, delta: the periodic solutions." \
    "# V m/s, t s, psi deg, dstar m. By CVODE, relative tolerance of a step 1e-10." \
    part,V,t,psi,dstar
  for V in $past; do points_of past "$V" 5 0 901 "past.$V"; done
  points_of torus 29 2 "$stay_from" "$stay_to" torus.29
  for V in $past 29; do
    for start in psi delta; do points_of "$start" "$V" 1000 0 1 "$start.$V"; done
  done
  replace "$table"
  begin_table results/tori.csv \
    "# What the gear comes to beyond torus points, layout L1. start: psi or delta, a start of that oscillation, V beyond" \
    "# its torus curve; between: on the edge between the two. found: the oscillation it settles on (psi, delta), or" \
    "# torus, unstable, while the gear stays beside it. c_d N m s/rad, V m/s, psi_max deg, dstar_max m;" \
    "# change: what it still moves, relative: of an oscillation to t = infinity, of psi_max on a torus in $((stay_to / 2 - stay_from / 2)) s." \
    c_d,V,start,found,psi_max,dstar_max,change
  while read -r c_d V start; do
    mlg pick "build/tables/sections.elsewhere.$c_d.$V.csv" columns=shimmy,psi_max:.6g,dstar_max:.6g,change \
      | sed "s/^/$(printf %.0f "$c_d"),$V,${start%=*},/" >> "$table.new"
  done <<< "$beyond"
  for V in $between; do torus "$V"; done
  replace "$table"
}

main sections "$@"
