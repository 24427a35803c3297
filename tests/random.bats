# random.bats - the library's zero-shimmy intervals against an oracle that shares nothing with it
#
# A sample of make prove (tests/random/README.md).
#
# Needs   make test-programs
# Writes  the folder that bats gives each test

bats_require_minimum_version 1.5.0

setup_file() {
  export ROOT LC_ALL=C OMP_NUM_THREADS=1
  ROOT=$(realpath "$BATS_TEST_DIRNAME/..")
}

setup() {
  cd "$BATS_TEST_TMPDIR" || return
}

compare() {
  "$ROOT/build/bin/random-compare" "$@"
}

oracle() {
  "$ROOT/build/bin/random-oracle" "$@"
}

@test "60 random gears in every layout: no interval missed, none invented" {
  run -0 --separate-stderr compare 60
  [[ ${lines[0]} =~ ^60\ gears,\ 540\ answers ]]
  [[ ${lines[1]} =~ ^missed\ 0,\ invented\ 0,\ oracle\ wrong\ 0,\ undecided\ 0,\ refused\ 0 ]]
}

@test "gears that were hard" {
  run -0 compare hard "$ROOT/tests/random/hard.csv"
}

@test "the paper's gear in other units of force, time and length" {
  run -0 compare units 10
  run -0 oracle units 5
}

@test "the oracle is what samples of V and c_d say" {
  run -0 --separate-stderr oracle brute case=1 layout=l2
  [[ ${lines[0]} =~ ,\ 0\ differ$ ]]
  run -0 --separate-stderr oracle brute case=0 layout=li3
}

@test "a case again by its seed and number is the same row" {
  oracle table 3 seed=5 | grep '^2,li1' >three
  oracle table case=2 layout=li1 seed=5 | grep '^2,li1' >one
  cmp three one
}

@test "a wrong interval in the table is noticed" {
  sed '/^paper-l1,/s/,2754.35/,2754.36/' "$ROOT/tests/random/hard.csv" >wrong.csv
  run -1 compare hard wrong.csv
  [[ $output == *'paper-l1: the oracle has'* ]]
  [[ $output == *'paper-l1 layout=l1: oracle: '* ]]
  sed '/^edge-at-V_top,/s/,200,1,.*/,200,0,,,,,,/' "$ROOT/tests/random/hard.csv" >wrong.csv
  run -1 compare hard wrong.csv
  [[ $output == *'edge-at-V_top: the oracle has 1 intervals, the table 0'* ]]
}

# one line on standard error, status 2
# shellcheck disable=SC2154 # bats sets stderr_lines
refused() {
  run -2 --separate-stderr "$@"
  [ "${#stderr_lines[@]}" = 1 ]
}

@test "bad input is one line and status 2" {
  refused oracle
  refused oracle table 0
  refused oracle table x
  refused oracle table spread=-1
  refused oracle table layout=l9
  refused oracle table seed=1.5
  refused oracle gear l9
  refused oracle gear l1 k_psi=-4
  refused oracle gear l1 nothing=1
  refused oracle growth l1 -3
  refused compare 1e99
  refused compare hard
  refused compare hard nowhere.csv
  echo 'a,l1,1,2,3' >short.csv
  refused compare hard short.csv
  : >empty.csv
  refused compare hard empty.csv
}
