#!/usr/bin/env bash
# curves.sh - every Hopf curve in the (V, c_d) plane at one k_s and b
#
#   scripts/curves.sh LAYOUT NAME [gear=FILE] [PARAMETER=VALUE ...] [V_top=200] [c_least=10] [c_most=8e4]
#   scripts/curves.sh li1 plane k_s=6.38e5 b=140
#
# Sourced after lib.sh by the scripts of Figures 9, 12 and 14; by itself it makes
# the curves of a user's own values and gear, and tells where there is no shimmy.
# Needs:  `mlg curves`, which says how many curves there are, where one may start and
#         where c_d has extrema.
# Writes: build/tables/NAME.csv (curve, shimmy, type, V, c_d; type LP: an extremum
#         of c_d), runs NAME.1.start, NAME.1, NAME.2.start, ... in build/runs
# Expect: the number of curves and of closed ones.  An extremum that AUTO's curves lack,
#         or have beside those of mlg curves, ends with one line.

# Ends what begins at a Hopf point where there is none: with play or friction, of which
# `mlg hopf` says that it leaves them out.
no_play() { # WHO LAYOUT [PARAMETER=VALUE ...]
  local said
  said=$(mlg hopf "$2" "${@:3}" V=1 2>&1 > /dev/null | grep 'is left out: ') || return 0
  said=${said%%$'\n'*} said=${said#mlg hopf: }
  fail "$1: ${said/ is left out/}" 2
}

# A short straight run across a Hopf point at the speed V, which finds it as HB1.
hopf_start() { # NAME LAYOUT V [PARAMETER=VALUE ...]
  local from to
  read -r from to < <(awk -v V="$3" 'BEGIN { printf "%.12g %.12g\n", V - 0.001, V + 0.001 }')
  run "$1" "$2.straight" "${@:4}" V="$from" DS=0.00025 DSMAX=0.00025 UZSTOP="{'V': $to}" -- HB=1 UZ=1 > /dev/null
}

# follow_curve RUN DSMAX WORD...: in smaller steps, and without a search for other points
# on the way, where AUTO runs past a stop or off to another curve, so that the run is
# rejected or lacks an extremum.  kind and turns of hopf_curves say what it has to have.
follow_curve() {
  local name=$1 step=$2 cut status finer=() why=build/tables/$1.why
  shift 2
  for cut in 1 3 10; do
    status=0
    # shellcheck disable=SC2086 # a word or none
    { mlg run "$name" "$@" "${finer[@]}" DSMAX="$(awk -v step="$step" -v cut="$cut" 'BEGIN { printf "%.6g", step / cut }')" -- &&
      mlg curve "$name" extrema="$turns" ${kind/open/}; } > /dev/null 2> "$why" || status=$?
    finer=(ISP=0 NMX=50000)
    [ "$status" -eq 1 ] || break
  done
  [ "$status" -eq 0 ] || cat "$why" >&2
  rm -f "$why"
  [ "$status" -eq 0 ] || exit "$status"
}

# hopf_curves LAYOUT NAME [WORD ...]
# A curve takes two runs: a short straight one across its starting point, which
# finds the Hopf point there, then the curve, from edge to edge or once round.
hopf_curves() {
  local layout=$1 name=$2 word started=${EPOCHREALTIME/./} closed=0 table
  local V_least=0.1 V_top=200 c_least=10 c_most=8e4 values=()
  local number kind c_d from to small stop DS step at turns
  shift 2
  for word; do
    case $word in V_least=* | V_top=* | c_least=* | c_most=*) local "$word" ;; *) values+=("$word") ;; esac
  done
  table=build/tables/$name.curves
  mlg curves "$layout" "${values[@]}" V_least="$V_least" V_top="$V_top" c_least="$c_least" c_most="$c_most" > "$table" || exit $?
  use "$table"
  while IFS=, read -r number kind _ c_d _ from to small stop DS step at turns; do
    case $number in curve) continue ;; esac
    [ "$kind" = open ] || closed=$((closed + 1))
    run "$name.$number.start" "$layout.straight" "${values[@]}" c_d="$c_d" V="$from" DS="$small" DSMAX="$small" \
      UZSTOP="{'V': $to}" -- HB=1 UZ=1 > /dev/null
    # AUTO is to put a point on each extremum
    follow_curve "$name.$number" "$step" "$layout.hopf" from="$name.$number.start" "${values[@]}" DS="$DS" ILP=0 \
      UZR="{${at:+'V': [${at// /, }]}}" \
      UZSTOP="{'V': [$V_least, $V_top], 'c_d': [$c_least, $c_most]${stop:+, 'period': $stop}}"
  done < "$table"
  printf '  %-28s %5d ms  %d curves, %d closed\n' "$name" $(((${EPOCHREALTIME/./} - started) / 1000)) $(($(wc -l < "$table") - 1)) "$closed"
}

# The curves of NAME as rows PREFIX,curve,shimmy,type,V,c_d of the open table.
curve_rows() { # PREFIX NAME
  local number kind shimmy turns
  while IFS=, read -r number kind shimmy _ _ _ _ _ _ _ _ _ turns; do
    case $number in curve) continue ;; esac
    # shellcheck disable=SC2086 # a word or none
    mlg curve "$2.$number" prefix="$1$number,$shimmy," extrema="$turns" ${kind/open/} >> "$table.new" || exit $?
  done < "build/tables/$2.curves"
}

# --- Figures 9, 12 and 14: panels of one b and several k_s ---------------------

# diagrams LAYOUT B K_S...: their curves; diagram_rows PANEL B K_S...: their rows.
diagrams() {
  local layout=$1 b=$2 k_s
  shift 2
  for k_s; do hopf_curves "$layout" "$figure.b$b.k$k_s" k_s="$k_s" b="$b"; done
}

diagram_rows() {
  local panel=$1 b=$2 k_s
  shift 2
  for k_s; do curve_rows "$panel,$b,$k_s," "$figure.b$b.k$k_s"; done
}

begin_diagrams() { # LINE [TABLE]
  begin_table "${2:-results/$figure.csv}" "$1" \
    "# curve: number at that b (N m s^2/rad) and k_s (N m/rad; inf: rigid); shimmy: what it bounds, psi or delta;" \
    "# V m/s; c_d N m s/rad; type LP: boundary point, an extremum of c_d along the curve. V from 0.1 to 200, c_d from" \
    "# 10 to 8e4; a closed curve ends on its first point." \
    panel,b,k_s,curve,shimmy,type,V,c_d
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
  . "$(dirname "$(realpath "$0")")/auto/lib.sh"
  [ $# -ge 2 ] || fail "usage: scripts/curves.sh LAYOUT NAME [gear=FILE] [PARAMETER=VALUE ...]" 2
  layout=$1 name=$2
  shift 2
  [ -f "models/$layout.c" ] || fail "curves: there is no models/$layout.c" 2
  check_name "$name"
  # shellcheck disable=SC2119 # all
  build
  alone "$name"
  MLG_USES=/dev/null
  top=200 others=()
  for word; do case $word in V_top=*) top=${word#*=} ;; V_least=* | c_least=* | c_most=*) ;; *) others+=("$word") ;; esac; done
  hopf_curves "$layout" "$name" "$@"
  table=build/tables/$name.csv
  printf '%s\n' "# Hopf curves of layout $layout: $*" "# V m/s, c_d N m s/rad; type: LP extremum of c_d" \
    curve,shimmy,type,V,c_d > "$table.new"
  curve_rows "" "$name"
  replace "$table"
  echo "  rows in $table"
  mlg intervals "$layout" "${others[@]}" V_top="$top" | while IFS=, read -r lo hi _; do
    case $lo in \#* | c_lo) ;; *) echo "  no shimmy from V = 0 to $top m/s: c_d from $lo to $hi N m s/rad" ;; esac
  done | grep . || echo "  no c_d is free of shimmy from V = 0 to $top m/s"
fi
