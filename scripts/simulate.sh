#!/usr/bin/env bash
# simulate.sh - a layout in time, as a table and a picture
#
#   scripts/simulate.sh LAYOUT NAME [PARAMETER=VALUE ...] STATE=VALUE ...
#   scripts/simulate.sh l1 kick V=40 psi=0.3 t_end=2
#
# Needs:  build/bin/mlg; `mlg help simulate` says what the words may be.
# Writes: build/tables/NAME.csv, its history, and build/tables/NAME.png: psi, delta*
#         and the tyres' deflections over time; red: a slip angle passes alpha_m.
# Exit:   that of mlg simulate: 1 the integration failed, 2 bad input; one line
#         says why, and what was there before stays.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"

[ $# -ge 2 ] || fail "usage: scripts/simulate.sh LAYOUT NAME [PARAMETER=VALUE ...] STATE=VALUE ..." 2
layout=$1 name=$2
shift 2
[ -f "models/$layout.c" ] || fail "simulate: there is no layout '$layout', no models/$layout.c" 2
check_name "$name"
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent build/bin/mlg
mkdir -p build/tables
work=build/tables/$name
build/bin/mlg simulate "$layout" history "$@" > "$work.csv.new" || exit $?
mv "$work.csv.new" "$work.csv"
LC_ALL=C.UTF-8 gnuplot -d -e "figure='$name'" scripts/pictures/style.gp scripts/pictures/simulate.gp
mv "$work.png.new" "$work.png"
echo "  $work.csv, $work.png"
