#!/usr/bin/env bash
# verify.sh - AUTO's values against oracles that do without AUTO, as one table
#
#   tests/verify.sh                  every oracle: make verify
#   tests/verify.sh short            the quick checks of each
#   tests/verify.sh [short] PART...  some of them: a PART is a script of tests/verify
#
# A part prints rows what,unit,ours,oracle,tolerance.  ours is what the project
# shows, in results/ or from a run of AUTO; the tolerance is relative, or absolute
# where it names its unit.  Parts run side by side, one per processor.
#
# Writes: build/tests/verify/PART.csv; the full form results/verification.csv
# Status: 0 all rows pass, 1 a row or a part failed, 2 no such part
set -euo pipefail
. "$(dirname "$(realpath "$0")")/../scripts/auto/tools.sh"

form=full
if [ "${1:-}" = short ]; then form=short; shift; fi
mapfile -t all < <(basename -s .sh tests/verify/*.sh)
[ $# -gt 0 ] && parts=("$@") || parts=("${all[@]}")
for part in "${parts[@]}"; do
  [ -f "tests/verify/$part.sh" ] || { echo "verify: no part '$part'; there are ${all[*]}" >&2; exit 2; }
done
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent test-programs
export MLG_BUILT=yes

rows=build/tests/verify
mkdir -p "$rows"

one() { # PART
  local started=${EPOCHREALTIME/./} words=()
  if [ "$form" = short ]; then words=(short); fi
  if "tests/verify/$1.sh" "${words[@]}" > "$rows/$1.new" 2> "$rows/$1.log"; then
    mv "$rows/$1.new" "$rows/$1.csv"
  else
    # a part that broke off is a row that failed
    echo "the part ended early (see $rows/$1.log),-,nan,nan,0" | cat "$rows/$1.new" - > "$rows/$1.csv"
  fi
  printf '  %-14s %4d rows %6.1f s\n' "$1" "$(wc -l < "$rows/$1.csv")" "$(((${EPOCHREALTIME/./} - started) / 100000))e-1" >&2
}

processors=$(processors)
for part in "${parts[@]}"; do
  while [ "$(jobs -rp | wc -l)" -ge "$processors" ]; do wait -n; done
  one "$part" &
done
wait

for part in "${parts[@]}"; do sed "s/^/$part,/" "$rows/$part.csv"; done | awk -F, '
  BEGIN { print "part,what,unit,ours,oracle,difference,tolerance,pass" }
  {
    number = "^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$"
    difference = $4 - $5
    if (difference < 0) difference = -difference
    split($6, limit, " ")
    if (limit[2] == "" && $5 + 0 != 0) difference /= $5 < 0 ? -$5 : $5
    pass = NF == 6 && $4 ~ number && $5 ~ number && limit[1] ~ number && difference <= limit[1]
    printf "%s,%s,%s,%s,%s,%.1e,%s,%s\n", $1, $2, $3, $4, $5, difference, $6, pass ? "yes" : "no"
  }' > "$rows/table"

awk -F, 'NR == 1 { next } { printf "%-12s %-64s %-12s %14s %14s %9s  %-14s %s\n", $1, $2, $3, $4, $5, $6, $7, $8; n++; failed += $8 != "yes" }
  END { printf "%d checks, %d failed\n", n, failed; exit failed > 0 || !n }' "$rows/table" || status=1

if [ "$form" = full ] && [ "${#parts[@]}" -eq "${#all[@]}" ] && [ -z "${status:-}" ]; then
  { echo "# AUTO's values (ours) against oracles that do without AUTO (tests/verify); difference: relative, or in the unit"
    echo "# where the tolerance names it."
    cat "$rows/table"; } > results/verification.csv.new
  mv results/verification.csv.new results/verification.csv
  mkdir -p build/tables
  cp results/verification.csv build/tables/verification.csv.kept # keep of scripts/auto/lib.sh
  md5sum < results/verification.csv > build/tables/verification.csv.sum
fi
exit "${status:-0}"
