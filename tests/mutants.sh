#!/usr/bin/env bash
# mutants.sh - would the tests notice?  Changes made on purpose, one by one
#
#   tests/mutants.sh               all of tests/mutants, as make mutants does
#   tests/mutants.sh judge csv     those whose names begin so
#   jobs=1 tests/mutants.sh        one at a time; else one per processor
#   tests/mutants.sh check         do all apply, and name tests that there are?  Seconds
#
# A file NAME.patch begins with one line
#   WHAT IT BREAKS | TESTS [FILTER] | ...
# TESTS is a file tests/TESTS.bats, of which those tests run whose names match FILTER, or
# a program build/tests/TESTS.  In place of tests: "equivalent: WHY", for a change that no
# test can notice.
#
# Each is applied to a copy of the tree with all that was built, build/mutants/tree.N, what
# changed is built there, and the tests run: "killed" when one fails, "survived" when all
# pass.  On the tree as it is they have to pass, or their failure says nothing ("unsound").
# A patch "does not apply" when what it changes has become another; one "does not build".
#
# What was killed stays so in build/mutants, by the sum of the patch and of the files that it
# changes: an interrupted run goes on, and all others are tried again.  After a change that
# may make tests weaker, `rm -r build/mutants` first.
#
# Exit    0 all killed or equivalent, 1 not so, 2 no such patches
set -euo pipefail
. "$(dirname "$(realpath "$0")")/../scripts/auto/tools.sh"

readonly home=build/mutants limit=300 # seconds for the tests of a file
root=$PWD
jobs=${jobs:-$(processors)}

# chosen [BEGINNING...]: the names that begin so; each has to mean something
chosen() {
  local beginning found
  [ $# -gt 0 ] || set -- ''
  for beginning; do
    found=("tests/mutants/$beginning"*.patch)
    [ -e "${found[0]}" ] || { echo "mutants.sh: no patch in tests/mutants begins with '$beginning'" >&2 && exit 2; }
    printf '%s\n' "${found[@]}"
  done | sed 's|.*/||; s|\.patch$||' | awk '!seen[$0]++'
}

# fields NAME: what it breaks, then a line each for what should notice
fields() { head -n 1 "tests/mutants/$1.patch" | sed 's/ *| */\n/g'; }

changed_files() { sed -n 's|^+++ b/||p' "tests/mutants/$1.patch"; }

sum_of() { # NAME
  local files
  mapfile -t files < <(changed_files "$1")
  cat "tests/mutants/$1.patch" "${files[@]}" 2> /dev/null | md5sum | cut -c 1-32
}

# A copy of the tree with what was built, in which nothing is to be built at first
copy() { # FOLDER
  rm -rf "$1"
  mkdir -p "$1"/build/tests
  cp -rp Makefile README.md CHANGELOG.md CITATION.cff scripts models constants tests results docs "$1"
  cp -rp build/{auto.mk,bin,models,constants,lib,libmlg,mlg,tools} "$1/build"
  cp -rp build/tests/libmlg{,.a} "$1/build/tests"
  find build/tests -maxdepth 1 -type f -exec cp -p -t "$1/build/tests" {} +
  ln -s "$root/build/auto" "$1/build/auto"
}

made() { # TARGET...: in the copy; AUTO is that of the tree
  env -u MLG_BUILT -u MAKEFLAGS -u MAKELEVEL MLG_SET_UP=yes make --no-print-directory --silent "$@"
}

# notices TEST [FILTER]: whether it fails in the copy; status 2 where it is no test
notices() {
  local output status=0
  if [ -f "tests/$1.bats" ]; then
    output=$(timeout "$limit" bats --formatter tap "tests/$1.bats" ${2:+-f "$2"} 2>&1 < /dev/null) || status=$?
    [[ $output != *1..0* && $output == *1..* ]] || return 2
  elif [ -f "build/tests/$1" ]; then
    made "build/tests/$1" > /dev/null 2>&1 || return 3
    timeout "$limit" "build/tests/$1" > /dev/null 2>&1 < /dev/null || status=$?
  else
    return 2
  fi
  [ "$status" -ne 0 ]
}

# passes TEST [FILTER]: in a copy of the tree as it is, asked once
passes() {
  local known status=0
  known=$root/$home/passes/$(printf '%s\n' "$@" | cat - "tests/$1.bats" 2> /dev/null | md5sum | cut -c 1-32)
  [ ! -e "$known" ] || return 0
  (cd "$root/$home/tree.0" && exec 8> ../lock.0 && flock 8 && notices "$@" 8>&-) || status=$?
  [ "$status" -eq 1 ] && touch "$known"
}

# verdict NAME: in the copy, where the patch is applied
verdict() {
  local test filter status seen=no
  made build/bin/mlg build/models/*.exe > build.log 2>&1 || { echo "does not build"; return; }
  while read -r test filter; do
    seen=yes status=0
    notices "$test" "$filter" || status=$?
    case $status in
      0) echo killed && return ;;
      2) echo "unsound: there is no test '$test $filter'" && return ;;
      3) echo "does not build" && return ;;
    esac
  done < <(fields "$1" | sed 1d)
  if [ $seen = yes ]; then echo survived; else echo "unsound: names no test"; fi
}

# apply NAME [-R]: a patch in the copy, whatever repository it lies in
apply() { GIT_DIR=/nonexistent git apply --unidiff-zero "${@:2}" "$root/tests/mutants/$1.patch" 2> /dev/null; }

try() { # NAME
  local test filter
  case $(fields "$1" | sed -n 2p) in equivalent:*)
    if apply "$1" && apply "$1" -R; then echo equivalent; else echo "does not apply"; fi
    return ;;
  esac
  while read -r test filter; do
    passes "$test" "$filter" || { echo "unsound: '$test $filter' does not pass as it is" && return; }
  done < <(fields "$1" | sed 1d)
  apply "$1" || { echo "does not apply" && return; }
  verdict "$1"
  apply "$1" -R
}

worker() { # N NAME...
  local tree=$home/tree.$1 name sum result began
  shift
  copy "$tree"
  for name; do
    mkdir "$home/taken/$name" 2> /dev/null || continue
    sum=$(sum_of "$name")
    began=$SECONDS
    result=$(cd "$tree" && try "$name")
    printf '%s %s\n' "$sum" "$result" > "$home/$name.result"
    say "$name" "$result" $((SECONDS - began))
  done
}

say() { # NAME RESULT SECONDS
  printf '  %-10s %4d s  %-28s %s\n' "$2" "$3" "$1" "[$(find "$home/taken" -mindepth 1 -maxdepth 1 | wc -l) of $of]"
}

# is_test TEST [FILTER]
is_test() {
  if [ -f "tests/$1.bats" ]; then
    sed -n 's/^@test "\(.*\)" {.*/\1/p' "tests/$1.bats" | grep -qE -- "${2:-}"
  else
    [ -f "tests/test_${1%%-*}.c" ] && [ -z "${2:-}" ]
  fi
}

check() {
  local name test filter bad=0 tree=$home/tree.check
  rm -rf "$tree"
  mkdir -p "$tree"
  cp -rp Makefile scripts models constants tests "$tree"
  while read -r name; do
    (cd "$tree" && apply "$name" && apply "$name" -R) || { echo "  $name: does not apply" && bad=1; }
    fields "$name" | sed -n 2p | grep -q . || { echo "  $name: names no test" && bad=1; }
    while read -r test filter; do
      [ "$test" = equivalent: ] || is_test "$test" "$filter" || { echo "  $name: there is no test '$test $filter'" && bad=1; }
    done < <(fields "$name" | sed 1d)
  done < <(chosen)
  rm -rf "$tree"
  return $bad
}

main() {
  local names name left=() i
  if [ "$*" = check ]; then mkdir -p "$home" && check && exit || exit 1; fi
  mapfile -t names < <(chosen "$@")
  [ ${#names[@]} -gt 0 ] || exit 2
  mkdir -p "$home/passes"
  exec 9> "$home/lock"
  flock -n 9 || { echo "mutants.sh: waiting for another in this tree" >&2 && flock 9; }
  rm -rf "$home"/taken
  mkdir -p "$home/taken"
  for name in "${names[@]}"; do
    case $(cat "$home/$name.result" 2> /dev/null) in
      "$(sum_of "$name") "killed | "$(sum_of "$name") "equivalent) ;;
      *) left+=("$name") ;;
    esac
  done
  of=${#left[@]}
  trap 'trap - EXIT; kill 0' INT TERM
  [ "$of" -eq 0 ] || copy "$home/tree.0"
  for ((i = 1; i <= jobs && i <= of; i++)); do worker "$i" "${left[@]}" 9>&- & done
  wait
  rm -rf "$home"/tree.*
  report "${names[@]}"
}

# What came out, those first that are to be looked at last seen
report() {
  local name result killed=0 equivalent=0 others=()
  for name; do
    result=$(cut -d ' ' -f 2- "$home/$name.result")
    case $result in
      killed) killed=$((killed + 1)) ;;
      equivalent) equivalent=$((equivalent + 1)) ;;
      *) others+=("  $name: $result") ;;
    esac
  done
  [ ${#others[@]} -eq 0 ] || printf '%s\n' "${others[@]}"
  echo "Mutants: $killed killed, ${#others[@]} not, $equivalent equivalent"
  [ ${#others[@]} -eq 0 ]
}

main "$@"
