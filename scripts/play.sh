#!/usr/bin/env bash
# play.sh - from a history to a continued branch: shimmy that no Hopf point leads to
#
#   scripts/play.sh NAME LAYOUT along=PARAMETER to=VALUE [NAME=VALUE ...]
#
# The gear starts from a state (psi=0.05) and settles for settle=20 s; the orbit it comes
# to (mlg cycle) is AUTO's start, and AUTO continues it along the parameter to its value,
# both with the corners that corner= says (docs/joints.md). NAME=VALUE is a parameter, a
# state at t = 0, settle, or a constant of AUTO in capitals.
#
# Example  scripts/play.sh worn l1 along=T_psi to=300 V=60 c_d=2890 g_psi=0.004363 corner=0.005 v_f=0.05 psi=0.05
# Writes   build/tables/NAME.dat, the run build/runs/NAME, build/tables/NAME.csv
# Exit     1: no orbit, or AUTO failed; 2: bad input
. "$(dirname "${BASH_SOURCE[0]}")/auto/lib.sh"

[ $# -ge 4 ] || fail "usage: scripts/play.sh NAME LAYOUT along=PARAMETER to=VALUE [NAME=VALUE ...]" 2
name=$1 layout=$2 along='' to=''
check_name "$name"
[ -f "models/$layout.c" ] || fail "play.sh: there is no models/$layout.c" 2
shift 2
cycle=() constants=()
build
states=" $(awk -F"'" '/^unames/ { for (k = 2; k < NF; k += 2) print $k }' <(mlg constants constants/c.l1.orbit layout="$layout") | xargs) settle rtol "
for word; do
  case $word in
    along=*) [ -z "$along" ] || fail "play.sh: '$word': along is given already" 2 ;;&
    to=*) [ -z "$to" ] || fail "play.sh: '$word': to is given already" 2 ;;&
    along=*) along=${word#*=} ;;
    to=*) to=${word#*=} ;;
    [A-Z][A-Z]*=*) constants+=("$word") ;;
    *)
      cycle+=("$word")
      case $states in *" ${word%%=*} "*) ;; *) constants+=("$word") ;; esac
      ;;
  esac
done
[[ -n $along && -n $to ]] || fail "play.sh: along=PARAMETER and to=VALUE say where the branch goes" 2
# what the end of the branch would be refused for later: its range, friction without v_f
others=()
for word in ${constants[@]+"${constants[@]}"}; do [[ $word == "$along="* ]] || others+=("$word"); done
there=$(mlg constants constants/c.l1.orbit layout="$layout" ${others[@]+"${others[@]}"} "$along=$to") || exit $?
[[ $there =~ $'\nPAR = '[^$'\n']*"'$along':" ]] || fail "play.sh: 'along=$along': not a parameter of AUTO's, along which a branch could go (F_z: along=M)" 2
mkdir -p build/tables
mlg cycle "$layout" orbit ${cycle[@]+"${cycle[@]}"} > "build/tables/$name.dat.new" || {
  status=$?
  rm -f "build/tables/$name.dat.new"
  exit $status
}
mv "build/tables/$name.dat.new" "build/tables/$name.dat"

# where it begins, and which way it goes; a step is a hundredth of the way at most
read -r from step weight <<< "$(mlg constants "constants/c.l1.orbit" layout="$layout" ${constants[@]+"${constants[@]}"} |
  awk -v along="$along" -v to="$to" '
    /^PAR = / && match($0, "\047" along "\047: *[^,}]*") { from = substr($0, RSTART, RLENGTH); sub(/.*: */, "", from) }
    END {
      far = to - from
      print from + 0, far < 0 ? -0.002 : 0.002, far == 0 ? 0 : 1 / far ^ 2
    }')"
[ "$weight" != 0 ] || fail "play.sh: '$along=$to' is where the branch begins; to= says where it goes" 2
defaults=(ICP="['$along', 'period', 'psi_max', 'dstar_max', 'torus']" THL="{'$along': $weight, 'period': 0.0}"
  DS="$step" DSMAX=0.02 NPR=1 UZSTOP="{'$along': $to}")
for word in ${constants[@]+"${constants[@]}"}; do # those that are given take their place
  for k in "${!defaults[@]}"; do [[ ${defaults[k]} != "${word%%=*}="* ]] || unset "defaults[k]"; done
done
run "$name" "$layout.orbit" dat="build/tables/$name.dat" ${constants[@]+"${constants[@]}"} "${defaults[@]}" --
mlg table "$name" > "build/tables/$name.csv"
# its folds, and between which points a pair of multipliers leaves the unit circle (beside a fold
# the trivial one and another look like a pair)
awk -F, -v along="$along" '
  /^#/ { next }
  !names++ { for (k = 1; k <= NF; k++) place[$k] = k; next }
  { x = $place[along]; torus = $place["torus"] }
  $3 == "LP" { printf "  fold at %s = %.7g\n", along, x; torus = -1 }
  rows++ && torus * last < 0 && torus > -0.1 && last > -0.1 { printf "  torus point between %s = %.6g and %.6g\n", along, before, x }
  { before = x; last = torus }' "build/tables/$name.csv"
# where a cycle just touches an end of the gap: between solutions that pass its ends so many times
last=$(awk -F, '$2 > 0 { label = $2 } END { print label + 0 }' "build/tables/$name.csv")
mlg grazing "$name" "$along" | awk -F, -v along="$along" -v last="$last" '
  /^#/ || !names++ || $1 > last { next }
  rows++ && $3 != passages { printf "  grazing between %s = %.6g and %.6g: %d passages of the ends of the gap become %d\n", along, before, $2, passages, $3 }
  { before = $2; passages = $3 }'
echo "  $along from $from: build/tables/$name.csv"
