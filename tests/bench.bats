# bench.bats - do the programs that make bench compares with compute the same?
#
# The Fortran equation file and, where it is installed, XPPAUT: bench.sh compares
# their numbers with ours and ends with status 1 where these differ. No time is looked at.
#
# Needs   the models (make models), gfortran
# Writes  build/tests/bench

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch bench
  cp -rp "$ROOT/tests/bench" tests
}

setup() {
  cd "$SCRATCH" || return
}

@test "the Fortran equation file and XPPAUT have our Hopf points, periods, folds and amplitude" {
  run -0 env PAIRS=1 tests/bench/bench.sh fortran xppaut
  [[ $output == *hopf* ]]
}

@test "another model in Fortran is noticed" {
  sed -i 's/k_t = 7d5/k_t = 7.01d5/' tests/bench/l1.f90
  run -1 env PAIRS=1 tests/bench/bench.sh fortran
  [[ $output == *'bench: V at HB of straight in Fortran differs'* ]]
}

@test "a part that does not exist is answered with those there are" {
  run -2 tests/bench/bench.sh none
  [[ $output == "bench: no part 'none'; there are model "* ]]
}
