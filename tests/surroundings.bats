# surroundings.bats - does what users have set for themselves, or another awk, change anything?
#
# Needs   the models (make models); the awks that are there
# Writes  build/tests/surroundings

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch surroundings
  cp -rp "$ROOT/docs" .
  scripts/fig06.sh runs
}

setup() {
  cd "$SCRATCH" || return
}

# as AWK: an awk of its own first on the PATH
as() {
  local awk
  case $1 in
  busybox) awk="$(command -v busybox) awk" ;;
  posix) awk="env POSIXLY_CORRECT=1 $(command -v gawk)" ;;
  *) awk=$(command -v "$1") ;;
  esac || skip "no $1 here"
  mkdir -p "awks/$1"
  printf '#!/bin/sh\nexec %s "$@"\n' "$awk" >"awks/$1/awk"
  chmod +x "awks/$1/awk"
  PATH=$PWD/awks/$1:$PATH
}

# All tables of Figure 6, the targets and the page come out as they are
tables_are_those_of_record() {
  local table
  rm -rf results build/tables
  mkdir -p results
  cp "$ROOT"/results/* results
  rm results/{fig06,targets}.csv
  scripts/fig06.sh tables
  scripts/report/targets.sh >targets
  cp "$ROOT"/results/versions.csv results # with what the tables were made is as it was
  scripts/report/summary.sh
  for table in fig06.csv targets.csv README.md; do
    cmp "results/$table" "$ROOT/results/$table"
  done
  scripts/run.sh slice l1.straight c_d=1e4 -- HB=2
  scripts/table.sh slice >slice.csv
  [ "$(cut -d , -f 3 slice.csv | grep -c HB)" -eq 2 ]
  scripts/curves.sh l1 plane >curves
  grep -q 'c_d from 2754.35[0-9]* to 3018.9[0-9]*' curves
}

@test "mawk" { as mawk && tables_are_those_of_record; }

@test "gawk" { as gawk && tables_are_those_of_record; }

@test "gawk as POSIXLY_CORRECT has it" { as posix && tables_are_those_of_record; }

@test "original-awk" { as original-awk && tables_are_those_of_record; }

@test "CDPATH and POSIXLY_CORRECT" {
  rm -rf build/runs/slice
  export CDPATH=$ROOT:/ POSIXLY_CORRECT=1
  (cd / && "$SCRATCH/scripts/run.sh" slice l1.straight -- HB=4)
  [ -d "$SCRATCH/build/runs/slice" ]
  run -0 bash scripts/run.sh slice l1.straight -- HB=4
  [ -z "$output" ]
  run -0 env -u MLG_BUILT make --no-print-directory help
  [[ $output == *'  make test '* ]]
}

@test "a locale in which i is not between a and z" {
  mkdir -p locale
  localedef -i tr_TR -f UTF-8 "$PWD/locale/tr_TR.UTF-8" 2>/dev/null || skip "no source of that locale here"
  rm -rf build/runs/slice
  export LOCPATH=$PWD/locale LC_ALL=tr_TR.UTF-8
  ! grep -q '[a-z]' <<<i || skip "it is, here"
  run -0 env -u MLG_BUILT make --no-print-directory help
  scripts/run.sh slice l1.straight -- HB=4
}

@test "a user's ~/.gnuplot changes no picture" {
  mkdir -p home results
  cp "$ROOT"/results/*.csv results
  for HOME in $PWD/none $PWD/home; do
    printf 'set title "mine"\nset terminal dumb\nset grid\n' >home/.gnuplot
    rm -f build/stamps/*
    HOME=$HOME GNUTERM=dumb scripts/fig06.sh draw
    cp results/fig06.svg "$(basename "$HOME").svg"
  done
  cmp none.svg home.svg
}

@test "a script works through a link" {
  rm -rf build/runs/linked
  ln -sfn "$SCRATCH/scripts/run.sh" mlg-run
  run -0 ./mlg-run linked l1.straight -- HB=4
  [[ $output == *linked* ]]
  (cd / && "$SCRATCH/mlg-run" linked l1.straight -- HB=4)
  ln -sfn "$ROOT/tests/run.sh" mlg-tests
  run -2 ./mlg-tests nonsense
  [[ $output == 'run.sh: no tests begin with "nonsense"'* ]]
}

@test "a clone with autocrlf has plain line ends" {
  git -C "$ROOT" rev-parse HEAD >/dev/null 2>&1 || skip "no git here"
  rm -rf clone
  git -c core.autocrlf=true clone -q --no-hardlinks "$ROOT" clone
  [ -z "$(find clone -path clone/.git -prune -o -type f ! -name '*.png' ! -name '*.gif' -exec grep -lI $'\r' {} +)" ]
  cmp clone/results/fig06.png <(git -C "$ROOT" show HEAD:results/fig06.png)
}

@test "a test program that does not build has failed and stops no other" {
  mkdir -p broken
  cp -r "$ROOT"/{Makefile,scripts,models,constants,tests} broken
  mkdir -p broken/build
  cp "$ROOT/build/auto.mk" broken/build
  ln -sfn "$ROOT/build/auto" broken/build/auto
  cd broken
  echo '#error broken' >>tests/test_model.c
  run env -u MLG_BUILT MLG_SET_UP=yes make --keep-going build/tests/model build/tests/criticality
  [ "$status" -eq 2 ]
  [ -x build/tests/criticality ]
  # an older program is not taken for it
  cp build/tests/criticality build/tests/model
  touch -d '1 hour ago' build/tests/model
  run env -u MLG_BUILT MLG_SET_UP=yes make build/tests/model
  [ "$status" -eq 2 ]
  MLG_BUILT=yes run -1 tests/run.sh model crit
  [[ $output == *'model: printed no test result, status 127'* ]]
}

# a tree in which build/tests/criticality is that script
with_test() {
  rm -rf tree
  mkdir -p tree/build/tests
  cp -r "$ROOT"/{scripts,models,tests} tree
  printf '#!/bin/bash\necho 1..1\n%s\n' "$1" >tree/build/tests/criticality
  chmod +x tree/build/tests/criticality
}

@test "two runs of the tests in one tree: the second waits for the first" {
  local pid
  with_test 'mkdir build/busy && sleep 0.5 && rmdir build/busy && echo ok 1 - alone || echo not ok 1 - beside another'
  cd tree
  tests/run.sh crit >one 2>&1 3>&- &
  pid=$!
  tests/run.sh crit >two 2>&1
  wait $pid
  [ "$(grep -h '^Tests: ' one two)" = $'Tests: 1 passed, 0 failed\nTests: 1 passed, 0 failed' ]
  [ "$(grep -c 'waiting for another' one two | cut -d : -f 2 | paste -s -d +)" = 0+1 ] || grep -q 'waiting for another' one
}

@test "tests that are stopped or killed take what they had begun with them" {
  local signal pid child
  with_test 'sleep 600 & echo $! >build/child; wait'
  cd tree
  for signal in TERM KILL; do
    rm -f build/child
    tests/run.sh crit >one 2>&1 3>&- &
    pid=$!
    until [ -s build/child ]; do kill -0 $pid && sleep 0.02; done
    child=$(<build/child)
    kill -$signal $pid
    ended_badly $pid
    for _ in {1..100}; do
      grep -q '^State:[[:space:]]*[^ZX]' "/proc/$child/status" 2>/dev/null || break
      sleep 0.05
    done
    run ! grep -q '^State:[[:space:]]*[^ZX]' "/proc/$child/status"
  done
  # and the next is not kept waiting
  printf '#!/bin/sh\necho 1..1\necho ok 1\n' >build/tests/criticality
  run -0 timeout 20 tests/run.sh crit
}
