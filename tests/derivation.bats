# derivation.bats - are the equations and the Jacobian in C those derived from
# energies and forces?
#
# Needs   build/lib/libmlg.so (make libmlg), the models, sympy
# Writes  build/tests/derivation, build/tests/derivation-misfit

bats_require_minimum_version 1.5.0
load scratch

setup() {
  cd "$BATS_TEST_DIRNAME/.." || return
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
  cp -r Makefile models scripts tests "$there"
  cd "$there"
  sed -i 's/ - C \* s;/ + C * s;/' models/mlg.h
  sed -i 's/mlg_k_d(par, u\[EPS\])/2. * &/' models/li2.c
  make -s libmlg
  tests/verify/derivation.sh short >rows
  run -1 outside rows
  diff <(cut -d , -f 1 <<<"$output" | sort) \
    <({ cut -d : -f 1 rows | sort -u | sed 's/$/: motion of delta (32)/'; echo 'li2: device'; } | sort)
}

@test "models/jacobian.h is what models/derive.py makes" {
  local made
  made=$(sed -n 's/.*with sympy \([0-9.]*[0-9]\).*/\1/p' models/jacobian.h)
  [ "$(python3 -c 'import sympy; print(sympy.__version__)')" = "$made" ] ||
    skip "another sympy than $made, which may order terms otherwise"
  python3 models/derive.py | diff models/jacobian.h -
}

@test "a run stops when mlg.h was changed and jacobian.h was not" {
  scratch derivation-misfit
  sed -i 's/ - C \* s;/ + C * s;/' models/mlg.h
  rm build/models/l1.exe
  made_by_make -s build/models/l1.exe
  run -1 auto_run straight l1.straight --
  grep -F 'models/jacobian.h does not fit models/mlg.h' <<<"$output"
  run auto_run straight l1.straight JAC=0 -- # without them AUTO runs; its Hopf points are not those of mlg
  [[ $output != *'does not fit'* ]]
}
