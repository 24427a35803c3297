#!/usr/bin/env bash
# check.sh - known points computed anew, by AUTO and by the exact algebra
#
#   scripts/check.sh [FILE]               tests/points.csv if left out
#   scripts/check.sh record RUN... > FILE
#
# For those who changed an equation, a constants file, a compiler or AUTO itself: what
# moved?  A row of FILE is a point (docs/auto.md has the columns and types); record
# writes such rows from runs.
# Writes: a table on standard output; AUTO's runs in build/check, made anew
# Exit:   0 all pass, 1 some do not, 2 bad input
[ "${1:-}" = record ] || file=$(realpath -m -- "${1:-$(dirname "$(realpath "$0")")/../tests/points.csv}")
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/auto/check.sh
# shellcheck disable=SC2119 # all
build

columns=layout,type,V,c_d,k_s,b,frequency_hz,psi_max,a_5,tolerance,parameters,run

if [ "${1:-}" = record ]; then
  shift
  [ $# -gt 0 ] || fail "usage: scripts/check.sh record RUN... > FILE" 2
  rows=$(for run; do record_run "$run" || exit; done) || exit
  printf '%s\n' "# Known points, for scripts/check.sh. V m/s, c_d N m s/rad, k_s N m/rad, b N m s^2/rad, psi_max deg; a_5 1/s per rad^4;" \
    "# tolerance relative; parameters: NAME=VALUE ..., those that differ from the defaults; run: where it comes from." \
    "$columns" "$rows"
  exit
fi

[ $# -le 1 ] || fail "usage: scripts/check.sh [FILE], or record RUN... > FILE" 2
[ -f "$file" ] || fail "check: $file: no such file" 2
[ "$(grep -v '^#' "$file" | head -n 1)" = "$columns" ] || fail "check: $file: expected the columns $columns" 2
export MLG_RUNS=build/check
rm -rf "$MLG_RUNS"
mkdir -p "$MLG_RUNS"
failed=0 passed=0 number=0
printf '%-44s %-8s %14s %14s %14s %8s\n' point value expected AUTO exact off
while IFS=, read -r layout type V c_d k_s b frequency psi_max a_5 tolerance parameters _; do
  number=$((number + 1))
  check_row
done < <(grep -v '^#' "$file" | sed 1d)
[ "$number" -gt 0 ] || fail "check: $file has no points" 2
if [ "$failed" -gt 0 ]; then fail "check: $failed of $((failed + passed)) values differ"; fi
echo "all $passed values are as expected"
