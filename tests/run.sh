#!/usr/bin/env bash
# run.sh - run the tests and count them
#
#   tests/run.sh             every test, as make test does
#   tests/run.sh runs fail   those of the files whose names begin so
#
# What they need is built first, unless MLG_BUILT says that it is.  A program that does
# not build has failed and stops no other.
#
# The files: tests/*.bats, and the C programs build/tests/NAME that make builds
# from tests/test_NAME.c, one layout-LAYOUT for each layout from
# tests/test_layout.c. All speak TAP, and run side by side, one per processor:
# each writes below build/tests/NAME only.
#
# A line for each test as it ends, a failed one with all it had to say, and one for each
# file with the seconds it took and those of a processor. A program that crashes, hangs, says nothing or less than
# it announced has failed too. On a terminal each file that is begun says how far the
# tests are. The last line is "Tests: N passed, N failed[, N skipped]".
#
# One at a time runs in a tree, another waits for it.  However it ends, what it had begun
# ends with it.
#
# Exit    0 all passed, 1 some failed, 2 no such tests
set -euo pipefail
. "$(dirname "$(realpath "$0")")/../scripts/auto/tools.sh"
export CMOCKA_MESSAGE_OUTPUT=TAP

readonly limit=${TEST_TIMEOUT:-600} # seconds for one file
readonly counts=build/tests/counts
readonly took=build/tests/took # seconds of the last run of every test
readonly alive=build/tests/alive # a pipe that is open as long as this runs
# Those that take longest begin first, so that no processor waits for one in the end.
readonly longest='runs layouts boundary verify surroundings new-runs transients damping certify simulate scripts failures derivation'

all_names() {
  local file name
  for name in $longest; do [ ! -f "tests/$name.bats" ] || echo "$name"; done
  for file in tests/*.bats; do
    name=${file#tests/}
    case " $longest " in *" ${name%.bats} "*) ;; *) echo "${name%.bats}" ;; esac
  done
  for file in tests/test_*.c; do
    file=${file#tests/test_}
    [ "$file" = layout.c ] || echo "${file%.c}"
  done
  layouts | sed 's/^/layout-/'
}

# chosen [BEGINNING...]: the names that begin so; each has to mean something
chosen() {
  local names name beginning found
  names=$(all_names)
  [ $# -gt 0 ] || set -- ''
  for beginning; do
    found=
    for name in $names; do
      case $name in "$beginning"*) found=1 && echo "$name" ;; esac
    done
    if [ -z "$found" ]; then
      printf 'run.sh: no tests begin with "%s"; there are %s\n' "$beginning" "$(xargs <<<"$names")" >&2
      return 2
    fi
  done | awk '!seen[$0]++'
}

build() {
  make --no-print-directory --silent test-set-up 8>&- 9>&- || exit
  MLG_SET_UP=yes make --no-print-directory --keep-going test-programs 8>&- 9>&- || built=no
}

# TAP on standard output, and last the time taken and the exit status.  timeout makes it
# a process group, which is ended whole: by a stop, behind its last test, and by itself
# when the pipe is closed because this script is no more.
tap_of() { # name
  local command=("build/tests/$1") pid status=0 began=${EPOCHREALTIME/./}
  [ ! -e "tests/$1.bats" ] || command=(bats --formatter tap "tests/$1.bats")
  # shellcheck disable=SC2016 # for that shell
  timeout --kill-after=10 "$limit" bash -c '{ read -r || kill -KILL 0; } <"$0" >/dev/null 2>&1 & exec "$@"' \
    "$alive" "${command[@]}" </dev/null 2>&1 &
  pid=$!
  trap 'kill "$pid"' TERM
  wait "$pid" || status=$?
  kill -KILL -- "-$pid" 2>/dev/null || true
  times >"build/tests/$1.times" # of its own and, below, of what it began
  echo "took $(((${EPOCHREALTIME/./} - began + 50000) / 100000)) $(
    awk -F '[ms ]+' 'NR == 2 { printf "%.0f", 600 * ($1 + $3) + 10 * ($2 + $4) }' "build/tests/$1.times")"
  echo "exit status $status"
}

# One at a time in this tree, and the pipe that says that it still runs
alone() {
  mkdir -p build/tests
  exec 9>build/tests/lock
  flock -n 9 || { echo "run.sh: waiting for another tests/run.sh in this tree" >&2 && flock 9; }
  rm -f "$alive"
  mkfifo "$alive"
  exec 8<>"$alive"
}

stop() {
  trap - EXIT
  # shellcheck disable=SC2046 # one word for each job
  kill $(jobs -p) 2>/dev/null || true
  wait
  exit 130
}

# On a terminal: how many files have been begun, the time since the start, and the
# time all will take if it is known.
progress() { # BEGUN OF
  local about=''
  [ -t 1 ] || return 0
  [ "$whole" = no ] || [ ! -f "$took" ] || about=" of about $(<"$took") s"
  echo "  [file $1 of $2, $SECONDS s$about]"
}

main() {
  local names name n=0 whole=no built=yes processors
  processors=$(processors)
  [ $# -gt 0 ] || whole=yes
  names=$(chosen "$@")
  alone
  [ -n "${MLG_BUILT:-}" ] || build
  export MLG_BUILT=yes
  rm -rf "$counts"
  mkdir -p "$counts"
  [ "$built" = yes ] || echo "0 1 0 programs: not all were built, see above" >"$counts/programs"
  trap stop INT TERM
  for name in $names; do
    while [ "$(jobs -rp | wc -l)" -ge "$processors" ]; do
      wait -n || true
    done
    n=$((n + 1))
    progress "$n" "$(wc -w <<<"$names")"
    echo "0 1 0 $name: ended before it was counted" >"$counts/$name"
    tap_of "$name" 8>&- 9>&- | awk -v name="$name" -v counts="$counts/$name" -f tests/tap.awk 8>&- 9>&- &
  done
  wait
  [ "$whole" = no ] || echo "$SECONDS" >"$took"
  awk '
    { passed += $1; failed += $2; skipped += $3 }
    NF > 3 && !said++ { print "Failed:" }
    NF > 3 { sub(/^[0-9]+ [0-9]+ [0-9]+ /, ""); print "  " $0 }
    END {
      printf "Tests: %d passed, %d failed%s\n", passed, failed, skipped ? ", " skipped " skipped" : ""
      exit failed > 0 || !passed
    }' "$counts"/*
}

main "$@"
