#!/usr/bin/env bash
# from-hh.sh - the torus curves that begin at a double Hopf point
#
#   scripts/from-hh.sh LAYOUT NAME V=VALUE c_d=VALUE [PARAMETER=VALUE ...] [angle=0.5] [both]
#   scripts/from-hh.sh l1 mine V=24.84 c_d=32038
#
# The point is the double Hopf point within 1 % of V and c_d.  `mlg unfolding` says where the
# cycle of each of its two oscillations turns into a torus when its amplitude, of psi or of
# delta, is `angle` degrees; there AUTO finds the torus point, and goes on from it.
# Writes: for each oscillation, psi or delta (12: the lower frequency first if both are alike),
#         the runs NAME.psi.straight, NAME.psi.cycles, NAME.psi.start, NAME.psi.to, back to the
#         point until the cycle is a fifth of its size, and, with the word both, NAME.psi.away
# Prints: CSV, the torus point as predicted to leading order and as AUTO has it
# Exit:   0, 1 a run failed, 2 bad input
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/curves.sh

usage="usage: scripts/from-hh.sh LAYOUT NAME V=VALUE c_d=VALUE [PARAMETER=VALUE ...] [angle=0.5] [both]"
[ $# -ge 4 ] || fail "$usage" 2
layout=$1 name=$2 angle='' both='' given=() place=()
[ -f "models/$layout.c" ] || fail "from-hh: there is no models/$layout.c" 2
check_name "$name"
for word in "${@:3}"; do
  case $word in
    V=* | c_d=*) place+=("$word") ;;
    angle=*)
      [ -z "$angle" ] || fail "from-hh: '$word': angle is given already" 2
      angle=${word#*=}
      is_above_0 "$angle" || fail "from-hh: '$word': expected degrees above 0" 2
      ;;
    both) both=yes ;;
    *) given+=("$word") ;;
  esac
done
[ ${#place[@]} = 2 ] || fail "$usage" 2
angle=${angle:-0.5}
# shellcheck disable=SC2119 # all
build
export MLG_USES=/dev/null

# Where the cycle of one oscillation is a torus point, to leading order: "V c_d".
predicted() { # TORUS_V TORUS_C_D
  awk -v V="$V_point" -v c="$c_point" -v tV="$1" -v tc="$2" -v angle="$angle" 'BEGIN {
    r = angle * atan2(0, -1) / 180
    printf "%.10g %.10g\n", V + tV * r * r, c + tc * r * r }'
}

no_play from-hh "$layout" "${given[@]}"
unfolding=$(mlg unfolding "$layout" "${given[@]}" "${place[@]}") || exit
echo "oscillation,V_predicted,V,c_d,amplitude_predicted,amplitude,unit"
seen=''
while IFS=, read -r mode frequency oscillation _ _ _ _ _ torus_V torus_c_d _ _ V_point c_point; do
  [ "$mode" != mode ] || continue
  [ "$seen" != "$oscillation" ] || oscillation+=$mode
  seen=$oscillation
  own=$name.$oscillation
  read -r V c_d < <(predicted "$torus_V" "$torus_c_d")
  V_hopf=$(mlg hopf "$layout" "${given[@]}" c_d="$c_d" | awk -F, -v f="$frequency" -v V="$V" '
    $1 + 0 > 0 && ($3 / f - 1) ^ 2 < 0.01 { d = ($2 - V) ^ 2; if (best == "" || d < least) { least = d; best = $2 } } END { print best }')
  [ -n "$V_hopf" ] || fail "from-hh: no Hopf point of $frequency Hz beside V = $V at c_d = $c_d: a smaller angle may do"
  hopf_start "$own.straight" "$layout" "$V_hopf" "${given[@]}" c_d="$c_d"
  # a third of the amplitude a step, of which rates are the largest part, and half as far again
  read -r step stop < <(awk -v V="$V" -v H="$V_hopf" -v angle="$angle" -v f="$frequency" 'BEGIN {
    pi = atan2(0, -1); printf "%.3g %.10g\n", 0.3 * angle * pi / 180 * 2 * pi * f, H + 1.5 * (V - H) }')
  mlg run "$own.cycles" "$layout.periodic" from="$own.straight" DS="$step" DSMAX="$step" UZR="{'torus': [-1e-5, 2e-5]}" \
    UZSTOP="{'V': $stop}" -- TR=1 > /dev/null ||
    fail "from-hh: at angle=$angle AUTO has no torus point where the normal form has one: a larger one lies clear of AUTO's tolerance, 1e-5 of the unit circle, a smaller one nearer"
  size=psi_max unit=deg
  [ "${oscillation%%[12]}" = psi ] || size=dstar_max unit=m
  read -r found amplitude psi lever < <(mlg rows "$own.cycles" only=TR columns=V:.8g,$size:.6g,psi_max:.6g,l_delta | tr , ' ')
  awk -v name="$oscillation" -v V="$V" -v found="$found" -v c="$c_d" -v angle="$angle" -v a="$amplitude" -v unit=$unit -v l="$lever" 'BEGIN {
    printf "%s,%.8g,%s,%s,%.6g,%s,%s\n", name, V, found, c, unit == "m" ? angle * atan2(0, -1) / 180 * l : angle, a, unit }'
  run "$own.start" "$layout.torus_start" from="$own.cycles" DS=0.01 DSMAX=0.05 -- EP=1 > /dev/null
  # AUTO begins towards larger c_d
  if awk -v t="$torus_c_d" 'BEGIN { exit !(t > 0) }'; then to=- away=''; else to='' away=-; fi
  stop=$(awk -v p="$psi" 'BEGIN { print p / 5 }')
  run "$own.to" "$layout.torus" from="$own.start" DS="${to}0.01" DSMAX=0.1 UZSTOP="{'psi_max': $stop}" -- UZ=1 > /dev/null
  [ -z "$both" ] || run "$own.away" "$layout.torus" from="$own.start" DS="${away}0.01" DSMAX=0.3 NMX=2000 UZSTOP="{'psi_max': $stop}" -- UZ=1 > /dev/null
done <<< "$unfolding"
