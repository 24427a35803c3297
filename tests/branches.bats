# branches.bats - the branches that begin at double Hopf and generalised Hopf points: are they
# begun by one command, and where the normal forms have them?
#
# The torus curves of Figure 7 and LI1's fold of cycles are held against what from-hh.sh and
# from-gh.sh find, AUTO's distances from a point against the normal form, in a row of distances.
#
# Needs   build/auto.mk, build/models, build/bin, results/fig07.csv
# Writes  build/tests/branches

bats_require_minimum_version 1.5.0
load scratch

setup_file() { scratch branches; }

setup() { cd "$SCRATCH" || return; }

@test "the torus curves of Figure 7 begin at its double Hopf point by one command, and reach the other" {
  local torus V c_d
  scripts/from-hh.sh l1 hh V=24.84 c_d=32040 both > found.csv
  [ "$(wc -l < found.csv)" -eq 3 ]
  # the torus points lie on the curves of record, between two of their points
  while IFS=, read -r torus _ V c_d _; do
    [ "$torus" != oscillation ] || continue
    near "$(awk -F, -v curve="torus_$torus" -v c="$c_d" '
      $1 == curve { if (n++ && (c - c_0) * (c - $5) <= 0) { print V_0 + ($4 - V_0) * (c - c_0) / ($5 - c_0); exit } V_0 = $4; c_0 = $5 }' \
      "$ROOT/results/fig07.csv")" "$V" 2e-3 "V of the torus curve of $torus"
    # back to the point, and on to the other
    near "$(value "hh.$torus.to" UZ V)" 24.83819 5e-3
    near "$(value "hh.$torus.to" UZ c_d)" 32037.911 5e-3
    near "$(value "hh.$torus.away" UZ V)" 60.97765 5e-2
    near "$(value "hh.$torus.away" UZ c_d)" 61882.603 2e-2
  done < found.csv
}

@test "the nearer to a double Hopf point, the nearer its torus points are to those of the normal form" {
  local V c_d angle
  while read -r V c_d; do
    for angle in 0.4 0.3 0.25; do
      scripts/from-hh.sh l1 hh V="$V" c_d="$c_d" angle=$angle | sed "1d; s/^/$angle,/"
    done > points.csv
    [ "$(wc -l < points.csv)" -eq 6 ]
    build/bin/mlg unfolding l1 V="$V" c_d="$c_d" > form.csv
    # the slopes from the point, over the square of the angle, extrapolated to 0
    awk -F, 'FNR == 1 { for (k = 1; FILENAME == "form.csv" && k <= NF; k++) place[$k] = k; if (FILENAME == "form.csv") next }
      FILENAME == "form.csv" { slope[$place["angle"]] = $place["torus_dV_dc_d"]; V = $place["V"]; c = $place["c_d"]; next }
      { n[$2]++; x[$2, n[$2]] = $1 ^ 2; y[$2, n[$2]] = ($4 - V) / ($5 - c) }
      END { for (o in slope) { s = 0
          for (i = 1; i <= 3; i++) { t = y[o, i]; for (j = 1; j <= 3; j++) if (j != i) t *= x[o, j] / (x[o, j] - x[o, i]); s += t }
          print s, slope[o] } }' form.csv points.csv > slopes
    cat slopes
    near_each 1e-3 "the slope of a torus curve" < slopes
    [ "$(wc -l < slopes)" -eq 2 ]
  done <<< "24.83819403 32037.91103
60.97764568 61882.60298"
}

@test "LI1's fold of cycles begins at its generalised Hopf point by one command, where the fifth order says" {
  local angle _ V predicted gap psi_predicted psi V_end c_end ratios=''
  for angle in 1 0.7; do
    IFS=, read -r _ _ V _ predicted gap psi_predicted psi _ V_end c_end \
      < <(scripts/from-gh.sh li1 gh V=0.716 c_d=526 k_s=6.38e5 b=140 angle=$angle | tail -n 1)
    near "$psi" "$psi_predicted" 2e-2 "psi at the fold"
    ratios+="$V $gap $predicted "
    # back at the point
    near "$V_end" 0.7161356 1e-3
    near "$c_end" 526.59033 2e-3
  done
  # to leading order in the distance from the point: the ratio goes to 1 in a straight line
  # shellcheck disable=SC2086 # words
  set -- $ratios
  near "$(awk -v V1="$1" -v r1="$2" -v p1="$3" -v V2="$4" -v r2="$5" -v p2="$6" 'BEGIN {
    d1 = 0.7161356387 - V1; d2 = 0.7161356387 - V2; r1 /= p1; r2 /= p2; print r2 + (r2 - r1) * d2 / (d1 - d2) }')" 1 5e-3 "the fold's distance"
  # on the other side of the other point
  IFS=, read -r _ _ V _ predicted gap _ < <(scripts/from-gh.sh li1 gh V=0.31 c_d=22.7 k_s=6.38e5 b=140 | tail -n 1)
  near "$gap" "$predicted" 0.1
  awk -v V="$V" 'BEGIN { exit !(V > 0.3105917558) }'
}

@test "generalised Hopf points are where AUTO's small cycles change sides, and none is invented" {
  local V side c_d from to layout
  build/bin/mlg generalised li1 k_s=6.38e5 b=140 > gh.csv
  [ "$(wc -l < gh.csv)" -eq 3 ]
  # the first orbit beside a Hopf point between the two points is on the other side of it
  for V in 0.3 0.5 0.75; do
    c_d=$(build/bin/mlg hopf li1 V=$V k_s=6.38e5 b=140 | sed -n '3s/,.*//p')
    read -r from to < <(awk -v V=$V 'BEGIN { print V - 0.001, V + 0.001 }')
    auto_run gh.$V.start li1.straight k_s=6.38e5 b=140 c_d="$c_d" V="$from" DS=2.5e-4 DSMAX=2.5e-4 UZSTOP="{'V': $to}" -- HB=1 > /dev/null || return
    auto_run gh.$V.cycles li1.cycles from=gh.$V.start EPSL=1e-10 EPSU=1e-10 UZSTOP="{'psi_max': 0.4}" DS=0.01 DSMAX=0.01 ILP=0 -- > /dev/null || return
    side=$(awk -v c="$c_d" '$1 != 0 { last = $5 } END { print (last > c ? "above" : "below") }' "build/runs/gh.$V.cycles/b.gh.$V.cycles")
    echo "$V $side"
    case $V in 0.5) [ "$side" = above ] ;; *) [ "$side" = below ] ;; esac
  done
  for layout in l1 "l2 k_s=7.86e5" "li2 k_s=2.48e6 b=140"; do
    # shellcheck disable=SC2086 # words
    [ "$(build/bin/mlg generalised $layout | wc -l)" -eq 1 ]
  done
}

@test "slips end with one line" {
  run -2 scripts/from-hh.sh l1 hh V=24.84
  [ "${#lines[@]}" -eq 1 ]
  run -1 --separate-stderr scripts/from-hh.sh l1 hh V=40 c_d=32038
  # shellcheck disable=SC2154 # of run
  [[ $stderr == *"no double Hopf point within 1 % of V = 40, c_d = 32038" ]]
  run -2 scripts/from-hh.sh l9 hh V=24.84 c_d=32038
  run -1 --separate-stderr scripts/from-gh.sh l1 gh V=20 c_d=3000
  [[ $stderr == "from-gh: no generalised Hopf point within a factor of 2 of V = 20, c_d = 3000" ]]
  run -2 scripts/from-gh.sh li1 gh V=0.716 c_d=526 k_s=6.38e5 b=140 angle=0.1
  [[ $output == *"a larger one does"* ]]
  run -2 build/bin/mlg generalised l1 V=3
  local words right
  while IFS='|' read -r words right; do
    # shellcheck disable=SC2086 # words
    run -2 scripts/$words
    # shellcheck disable=SC2053 # a pattern
    if [ "${#lines[@]}" -ne 1 ] || [[ $output != $right ]]; then
      echo "$words: $output"
      return 1
    fi
  done <<'END'
from-hh.sh l1 hh V=24.84 c_d=32038 angle=0|from-hh: 'angle=0': expected degrees above 0
from-hh.sh l1 hh V=24.84 c_d=32038 angle=1 angle=2|from-hh: 'angle=2': angle is given already
from-hh.sh l1 hh V=24.84 c_d=32038 g_psi=0.004|from-hh: g_psi = 0.004: play and friction have no linearisation at rest
from-gh.sh li1 gh V=0.7 c_d=526 k_s=6.38e5 b=140 V=3|from-gh: 'V=3': V is given already
from-gh.sh li1 gh V=0 c_d=526 k_s=6.38e5 b=140|from-gh: 'V=0': expected a number above 0
from-gh.sh li1 gh V=0.7 k_s=6.38e5 b=140|usage: *
from-gh.sh li1 gh V=0.7 c_d=526 k_s=6.38e5 b=140 T_f=5 v_f=1|from-gh: T_f = 5: play and friction have no linearisation at rest
from-gh.sh li1 gh V=0.716 c_d=526 k_s=6.38e5 b=140 angle=1000|from-gh: angle=1000: the fold would lie at V = -*
END
}
