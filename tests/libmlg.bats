# libmlg.bats - is libmlg the model that AUTO runs, and do its examples run as written?
#
# The commands come out of docs/libmlg.md. That the rates are those of func() is
# tested for each layout in test_layout.c.
#
# Needs   build/lib/libmlg.* (make libmlg), the models
# Writes  build/tests/libmlg

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch libmlg
  cp -rp "$ROOT/docs" .
  mkdir -p build/lib
  cp -p "$ROOT"/build/lib/libmlg.{a,so} build/lib
}

setup() {
  cd "$SCRATCH" || return
}

# command BEGINNING: the line of docs/libmlg.md that begins so, run as it stands
command_of_guide() {
  local line
  line=$(sed -n "s|^    \($1.*\)|\1|p" docs/libmlg.md)
  [ -n "$line" ] && bash -c "$line"
}

@test "the example in C, built and run as written, shimmies like solution A" {
  command_of_guide 'gcc '
  command_of_guide 'build/rhs ' >output
  grep -qxF "$(cat output)" <(grep -o 'psi_max [^`]*mm' docs/libmlg.md)
  auto_run straight l1.straight -- HB=4
  auto_run psi l1.periodic from=straight -- TR=1 closed=1
  near "$(awk '{ print $2 }' output)" "$(value psi UZ psi_max 20)" 1e-4 psi_max
  near "$(awk '{ print $5 / 1e3 }' output)" "$(value psi UZ dstar_max 20)" 2e-3 dstar_max
}

@test "the example in C compiles as C++ and without the rest of the project" {
  mkdir -p alone
  cp docs/examples/rhs.c models/libmlg/libmlg.h build/lib/libmlg.a alone
  cd alone
  gcc -std=c11 -Wall -Wextra -Wpedantic -Werror rhs.c libmlg.a -lm -o rhs
  echo '#include "libmlg.h"' >include.cc
  g++ -std=c++11 -Wall -Wextra -Wpedantic -Werror -fsyntax-only include.cc
}

@test "a slip on the command line of the example" {
  command_of_guide 'gcc '
  run -2 build/rhs l9
  [ "$output" = "rhs: 'l9': expected a layout, such as l1" ]
  run -2 build/rhs l1 c_q=1
  [ "$output" = "rhs: 'c_q': no such parameter" ]
  run -2 build/rhs l1 c_d=-1
  [ "$output" = "rhs: 'c_d': outside its range" ]
}

@test "the example in Python, run as written, has every parameter and the rates of L1" {
  command_of_guide 'python3 ' >output
  sed -n '/define MLG_PARAMETERS/,/^$/s|^ *X([^"]*"\([^"]*\)", *"\([^"]*\)".*|\1 \2|p' models/mlg.h >expected
  [ "$(wc -l <expected)" -ge 27 ]
  diff <(head -n "$(wc -l <expected)" output | awk '{ NF--; print }' | sed 's/ *$//') expected
  [ "$(awk '$1 == "psi" || $1 == "eps" { print $1, $2, $3 }' output)" = "psi rad 0
eps rad 0.184229199" ] # k_psi psi / c_d, psi = pi/180
}

@test "the library exports what its header declares, and nothing else" {
  diff <(nm -D --defined-only build/lib/libmlg.so | awk '{ print $3 }' | sort) \
    <(grep -o 'libmlg_[A-Za-z_]*(' models/libmlg/libmlg.h | grep -v '_outside does' | tr -d '(' | sort -u)
}
