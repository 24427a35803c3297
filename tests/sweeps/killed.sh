#!/usr/bin/env bash
# killed.sh - is the table of a sweep that is killed and resumed that of an undisturbed one?
#
#   tests/sweeps/killed.sh FILE JOBS SECONDS...
#
# Computes the sweep twice: as it is, and killed with -9, all of it at once, after each of
# these times, then resumed.  Both tables have to be the same byte for byte below their first
# line, which names the description, and no case may have been computed twice.
# Writes: build/sweeps/NAME.whole, NAME.killed and their descriptions in build
# Exit:   0 the same, 1 not
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/../.."

# A process and all that it began, those first that began others.
tree() { # PID
  local child
  echo "$1"
  for child in $(ps -o pid= --ppid "$1"); do tree "$child"; done
}

kill_tree() { # PID
  # shellcheck disable=SC2046 # one word for each process
  kill -KILL $(tree "$1") 2> /dev/null || true
  wait "$1" 2> /dev/null || true
}

# Times that a case was computed: records in the files of the blocks.
records() { # NAME
  find "build/sweeps/$1/blocks" -type f -exec cat {} + | grep -caE '^(ok [0-9]+ [0-9]+ [0-9a-f]{8}|failed [0-9]+ [0-9]+ [0-9]+ [0-9a-f]{8} .*)$' || true
}

same() { # FILE, of both
  cmp <(sed 1d "build/sweeps/$name.whole/$1" 2> /dev/null) <(sed 1d "build/sweeps/$name.killed/$1" 2> /dev/null)
}

name=$(basename "$1" .sweep) jobs=$2 file=$1
shift 2
rm -rf "build/sweeps/$name.whole" "build/sweeps/$name.killed"
for kind in whole killed; do cp "$file" "build/$name.$kind.sweep"; done

began=$EPOCHREALTIME
scripts/sweep.sh run "build/$name.whole.sweep" jobs="$jobs"
awk "BEGIN { printf \"  undisturbed: %.1f s\n\", $EPOCHREALTIME - $began }"

for seconds; do
  scripts/sweep.sh run "build/$name.killed.sweep" jobs="$jobs" > /dev/null 2>&1 &
  sleep "$seconds"
  kill_tree $!
  printf '  killed after %s s: ' "$seconds"
  scripts/sweep.sh status "build/$name.killed.sweep" || true
done
began=$EPOCHREALTIME
scripts/sweep.sh resume "build/$name.killed.sweep" jobs="$jobs"
awk "BEGIN { printf \"  resumed: %.1f s\n\", $EPOCHREALTIME - $began }"

same table.csv
same failed.csv
echo "  records: $(records "$name.whole") and $(records "$name.killed"); $(md5sum < <(sed 1d "build/sweeps/$name.whole/table.csv") | cut -c 1-8) both"
[ "$(records "$name.whole")" = "$(records "$name.killed")" ]
