# derivation.bats - are the equations in C those derived from energies and forces?
#
# Needs   build/lib/libmlg.so (make libmlg), sympy
# Writes  build/tests/derivation

bats_require_minimum_version 1.5.0

setup() {
  cd "$BATS_TEST_DIRNAME/.."
  export MLG_BUILT=yes
  unset MAKEFLAGS MFLAGS MAKELEVEL
}

# rows FILE: those outside their tolerance; fails if there are any, or no rows at all
outside() {
  awk -F , '
    { difference = $3 - $4; if (difference < 0) difference = -difference }
    NF != 5 || !(difference <= $5) { print; bad++ }
    END { exit !NR || bad }' "$1"
}

@test "the right-hand sides of all layouts are those derived symbolically" {
  mkdir -p build/tests/derivation
  tests/verify/derivation.sh >build/tests/derivation/rows
  [ "$(wc -l <build/tests/derivation/rows)" -ge 20 ]
  outside build/tests/derivation/rows
}

@test "a flipped sign in mlg.h and a wrong spring in a device are found, and said where" {
  local there=build/tests/derivation/broken
  rm -rf "$there"
  mkdir -p "$there"
  cp -r Makefile models tests "$there"
  cd "$there"
  sed -i 's/ - C \* s;/ + C * s;/' models/mlg.h
  sed -i 's/- k_d \* u\[EPS\]/- 2. * k_d * u[EPS]/' models/li1.c
  make -s libmlg
  tests/verify/derivation.sh short >rows
  run -1 outside rows
  [ "$(cut -d , -f 1 <<<"$output")" = "l1: motion of delta (32)
l2: motion of delta (32)
li1: motion of delta (32)
li1: device
li2: motion of delta (32)" ]
}
