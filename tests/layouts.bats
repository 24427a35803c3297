# layouts.bats - is a layout one file, and do its constants follow from it?
#
# The template is added in a checkout of its own by the commands of docs/layouts.md,
# as they stand there.
#
# Needs   the models and libmlg (make models libmlg)
# Writes  build/tests/layouts

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch layouts
  cp -rp "$ROOT"/{docs,tests} .
  objects
  mkdir -p build/tests
  cp -rp "$ROOT"/build/tests/libmlg{,.a} build/tests 2>/dev/null || true # compiled here where it is not there
}

setup() {
  cd "$SCRATCH" || return
}

@test "the constants files of a layout name its states, as many as NDIM" {
  local file layout
  for file in constants/c.l*; do
    layout=${file#*c.}
    diff <(build/bin/mlg constants "$file" layout="${layout%%.*}") <(build/bin/mlg constants "$file")
  done
}

@test "those of LI1 and LI2 are those of L2 but for the values of PAR" {
  local layout constants
  for layout in li1 li2; do
    for constants in straight hopf; do
      diff <(build/bin/mlg constants constants/c.l2.$constants layout=$layout | grep -v '^PAR ') \
        <(build/bin/mlg constants constants/c.$layout.$constants | grep -v '^PAR ')
    done
  done
}

@test "a run that a layout has no constants file for takes one made of L1's" {
  auto_run straight li2.straight c_d=3.6e4 k_s=inf b=0 -- HB=4
  [ "$(build/bin/mlg rows straight columns=k_s | sort -u)" = inf ]
  auto_run psi li2.periodic from=straight -- TR=1 closed=1
  near "$(value psi TR V)" 30.7865 1e-5 "V of the torus point of L1"
  grep -q "^NDIM = 9$" build/runs/psi/c.psi
}

@test "a layout that is none" {
  run -2 build/bin/mlg constants constants/c.l1.straight layout=l9
  [ "$output" = "constants/c.l1.straight: layout=l9: there is no models/l9.c" ]
  run -2 build/bin/mlg constants constants/gear.printed layout=l1
  [ "$output" = "constants/gear.printed: expected NDIM, the number of states of a layout" ]
}

## The guide

# as_written BEGINNING: the block of docs/layouts.md whose first line begins so
as_written() {
  local block
  block=$(awk -v begin="    $1" '
    index($0, begin) == 1 { on = 1 }
    on && !/^    / { exit }
    on { print substr($0, 5) }' docs/layouts.md)
  [ -n "$block" ] || { echo "docs/layouts.md has no '$1'" && return 1; }
  bash -c "set -e; $block"
}

@test "the template is a layout after nothing but the commands of the guide" {
  unset MLG_BUILT
  AUTO_DIR=$(sed -n 's/^AUTO_DIR = //p' "$ROOT/build/auto.mk")
  case $AUTO_DIR in /*) export AUTO_DIR ;; *) unset AUTO_DIR ;; esac
  as_written 'cp docs/examples'
  as_written 'make build/tests'
  as_written 'build/bin/mlg widest' >output
  near "$(sed -n '/^k_s,/{n;s/,.*//p}' output | head -n 1)" 1.99e6 2e-3 "k_s of the guide" # is that of the widest interval
  [ "$(grep -c ',LP,' build/tables/plane.csv)" -ge 2 ]
  as_written 'scripts/run.sh'
  [ -s build/runs/mine.shimmy/b.mine.shimmy ]
  as_written 'make drawings'
  grep -q 'c<tspan[^>]*>s<' docs/drawings/mine.svg
  as_written 'mkdir' >output
  grep -q ' EP ' output
}

@test "a layout whose name is no name" {
  unset MLG_BUILT
  cp docs/examples/layout.c models/my-layout.c
  run -2 make models
  rm models/my-layout.c
  [[ $output == *"models/my-layout.c: the name of a layout has letters, digits and _, a letter first"* ]]
  [ "${#lines[@]}" -eq 1 ]
  # nor is one executed that is a command
  # shellcheck disable=SC2016 # a name, not to be expanded
  cp docs/examples/layout.c 'models/`touch ran`.c'
  run -2 make models
  # shellcheck disable=SC2016
  rm 'models/`touch ran`.c'
  [[ $output == *"the name of a layout has letters"* ]]
  [ -z "$(find . -name ran)" ]
}

@test "no layout is longer than 40 lines without its comments" {
  local file
  for file in models/l*[0-9].c docs/examples/layout.c; do
    grep -q '^#include "plugin.h"' "$file"
    [ "$(gcc -fpreprocessed -dD -E -P "$file" | grep -vc '^ *$')" -lt 40 ] || { echo "$file" && return 1; }
  done
}

## Those beyond the paper

# numbers FILE: those of its rows for LI3 to LI7, one a line
numbers() {
  grep '^li[3-7],' "$1" | tr , '\n' | grep -E '^[0-9.]+(e[+-]?[0-9]+)?$'
}

@test "scripts/studies/layouts.sh makes the tables of record" {
  local table recorded made
  cp -rp "$ROOT/results" recorded
  scripts/studies/layouts.sh runs
  scripts/studies/layouts.sh tables
  for table in layouts layouts_planes layouts_branches widths; do
    recorded=recorded/$table.csv made=results/$table.csv
    [ "$table" != widths ] || made=build/tables/widths.layouts.csv
    [ "$(grep -c '^li[3-7],' "$recorded")" -eq "$(grep -c '^li[3-7],' "$made")" ]
    paste -d ' ' <(numbers "$made") <(numbers "$recorded") >pairs
    awk -v made="$made" '($1 - $2) ^ 2 > (1e-4 * $2) ^ 2 + 1e-12 { print made, $0; bad = 1 } END { exit bad || !NR }' pairs
  done
}
