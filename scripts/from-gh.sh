#!/usr/bin/env bash
# from-gh.sh - the fold of cycles that begins at a generalised Hopf point
#
#   scripts/from-gh.sh LAYOUT NAME V=VALUE c_d=VALUE [PARAMETER=VALUE ...] [angle=VALUE]
#   scripts/from-gh.sh li1 mine V=0.716 c_d=526.6 k_s=6.38e5 b=140
#
# The point is the one of `mlg generalised` nearest to V and c_d.  Its fifth-order normal form
# says on which side of the Hopf curve the fold lies, and where, when the amplitude of psi is
# `angle` degrees (left out: so large that the fold is 1e-5 of c_d away from the Hopf curve;
# AUTO's ten digits tell no less than 5e-7); there AUTO follows the cycles along c_d to the
# fold, and goes on from it.
# Writes: the runs NAME.straight, NAME.cycles, NAME.start, and the curve of folds NAME.up and
#         NAME.down, of which one comes back to the point and ends where psi is a tenth
# Prints: CSV, the fold as predicted to leading order and as AUTO has it, psi in degrees; which
#         run comes back, and where it ends
# Exit:   0, 1 a run failed, 2 bad input
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/curves.sh

usage="usage: scripts/from-gh.sh LAYOUT NAME V=VALUE c_d=VALUE [PARAMETER=VALUE ...] [angle=VALUE]"
[ $# -ge 4 ] || fail "$usage" 2
layout=$1 name=$2 angle=0 V='' c_d='' seen=' ' given=()
[ -f "models/$layout.c" ] || fail "from-gh: there is no models/$layout.c" 2
check_name "$name"
for word in "${@:3}"; do
  case $word in
    V=* | c_d=* | angle=*)
      [[ $seen != *" ${word%%=*} "* ]] || fail "from-gh: '$word': ${word%%=*} is given already" 2
      is_above_0 "${word#*=}" || fail "from-gh: '$word': expected a number above 0" 2
      seen+="${word%%=*} "
      ;;&
    V=*) V=${word#*=} ;;
    c_d=*) c_d=${word#*=} ;;
    angle=*) angle=${word#*=} ;;
    *) given+=("$word") ;;
  esac
done
[[ -n $V && -n $c_d ]] || fail "$usage" 2
# shellcheck disable=SC2119 # all
build
export MLG_USES=/dev/null

no_play from-gh "$layout" "${given[@]}"
# Within a factor of 2
points=$(mlg generalised "$layout" "${given[@]}" V_least="$(awk -v V="$V" 'BEGIN { print V / 2 }')" V_top="$(awk -v V="$V" 'BEGIN { print V * 2 }')" \
  c_least="$(awk -v c="$c_d" 'BEGIN { print c / 2 }')" c_most="$(awk -v c="$c_d" 'BEGIN { print c * 2 }')") || exit
# the point, then where on the Hopf curve to begin, the fold's c_d less the Hopf point's, and its psi
read -r V_point c_point frequency V_start gap psi < <(awk -F, -v V="$V" -v c="$c_d" -v angle="$angle" '
  NR > 1 { d = ($1 / V - 1) ^ 2 + ($2 / c - 1) ^ 2; if (best == "" || d < least) { least = d; best = $0 } }
  END {
    if (best == "") exit
    split(best, p, ",")
    away = angle > 0 ? angle ^ 2 / p[11] : sqrt(1e-5 * p[2] / (p[10] < 0 ? -p[10] : p[10]))
    printf "%s %s %s %.10g %.6g %.6g\n", p[1], p[2], p[3], p[1] + (p[8] == "above" ? away : -away), p[10] * away ^ 2, sqrt(p[11] * away)
  }' <<< "$points") || fail "from-gh: no generalised Hopf point within a factor of 2 of V = $V, c_d = $c_d" 1
awk -v gap="$gap" -v c="$c_point" 'BEGIN { exit !(gap * gap > (5e-7 * c) ^ 2) }' ||
  fail "from-gh: angle=$angle: the fold would lie $gap N m s/rad beside the Hopf point, which AUTO's digits do not tell; a larger one does" 2
awk -v V="$V_start" 'BEGIN { exit !(V > 0 && V < 1000) }' || fail "from-gh: angle=$angle: the fold would lie at V = $V_start m/s, where the normal form no longer holds; a smaller one does" 2
c_start=$(mlg hopf "$layout" "${given[@]}" V="$V_start" | awk -F, -v f="$frequency" -v c="$c_point" '
  $1 + 0 > 0 && ($3 / f - 1) ^ 2 < 0.01 { d = ($1 / c - 1) ^ 2; if (best == "" || d < least) { least = d; best = $1 } } END { print best }')
[ -n "$c_start" ] || fail "from-gh: no Hopf point of $frequency Hz at V = $V_start: a smaller angle may do"
hopf_start "$name.straight" "$layout" "$V_start" "${given[@]}" c_d="$c_start"
# a hundredth of the amplitude a step, of which rates are the largest part
step=$(awk -v psi="$psi" -v f="$frequency" 'BEGIN { pi = atan2(0, -1); printf "%.3g", 0.01 * psi * pi / 180 * 2 * pi * f }')
mlg run "$name.cycles" "$layout.cycles" from="$name.straight" DS="$step" DSMAX="$step" EPSL=1e-10 EPSU=1e-10 \
  UZSTOP="{'psi_max': $(awk -v psi="$psi" 'BEGIN { print 1.5 * psi }')}" -- LP=1 > /dev/null || exit
read -r c_fold psi_fold < <(mlg rows "$name.cycles" only=LP columns=c_d:.10g,psi_max:.6g | tr , ' ')
run "$name.start" "$layout.fold_start" from="$name.cycles" DS="$step" DSMAX="$step" -- EP=1 > /dev/null
stop=$(awk -v psi="$psi_fold" 'BEGIN { print psi / 10 }')
for way in up down; do
  run "$name.$way" "$layout.fold" from="$name.start" DS="$([ $way = up ] || echo -)$step" DSMAX="$(awk -v s="$step" 'BEGIN { print 10 * s }')" \
    UZSTOP="{'c_d': [$(awk -v c="$c_d" 'BEGIN { printf "%.10g, %.10g", c / 2, c * 2 }')], 'V': [0.1, 200.0], 'psi_max': [$stop, 15.0]}" -- UZ=1 > /dev/null
done
IFS=, read -r V_end c_end _ back < <(mlg rows "$name.up" "$name.down" only=UZ columns=V:.10g,c_d:.10g,psi_max,run | sort -t , -gk 3 | head -n 1)
echo "V_GH,c_GH,V,c_Hopf,gap_predicted,gap,psi_predicted,psi,back,V_end,c_end"
echo "$V_point,$c_point,$V_start,$c_start,$gap,$(awk -v a="$c_fold" -v b="$c_start" 'BEGIN { printf "%.6g", a - b }'),$psi,$psi_fold,$back,$V_end,$c_end"
