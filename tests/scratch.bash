# shellcheck shell=bash
# scratch.bash - what the tests of runs share: a checkout to run in, made anew
# below build/tests, so that nothing of the real one is touched.

# scratch NAME: makes it, goes there, and exports ROOT and SCRATCH
scratch() {
  export ROOT SCRATCH MLG_BUILT=yes
  unset MAKEFLAGS MFLAGS MAKELEVEL AUTO_DIR AUTO_TARBALL
  . "$(realpath "$BATS_TEST_DIRNAME")/../scripts/auto/tools.sh"
  export -f layouts
  ROOT=$PWD
  SCRATCH=$ROOT/build/tests/$1
  rm -rf "$SCRATCH"
  mkdir -p "$SCRATCH"/build/{models,bin,runs} "$SCRATCH/tests"
  cd "$SCRATCH" || return
  cp -rp "$ROOT"/{Makefile,scripts,models,constants,CITATION.cff} .
  cp -p "$ROOT"/tests/targets.csv tests
  cp -p "$ROOT"/build/models/*.exe build/models
  find "$ROOT/build/bin" -type f -exec cp -p -t build/bin {} +
  cp -rp "$ROOT"/build/{auto.mk,constants} build
  ln -s "$ROOT/build/auto" build/auto
}

# objects: those of the real checkout, so that make in this one builds what changed
objects() {
  cp -rp "$ROOT"/build/{models,bin,lib,libmlg,mlg} build
}

# made_by_make TARGET...: make in the scratch checkout with the AUTO of the real one
made_by_make() {
  local auto
  auto=$(sed -n 's/^AUTO_DIR = //p' "$ROOT/build/auto.mk")
  case $auto in /*) export AUTO_DIR=$auto ;; esac
  env -u MLG_BUILT MLG_SET_UP=yes make --no-print-directory "$@"
}

mlg() {
  build/bin/mlg "$@"
}

# auto_run NAME CONSTANTS ...: a run as scripts/run.sh makes it
auto_run() {
  mlg run "$@"
}

# value RUN TYPE COLUMN [V]: that column at the run's first point of that type (with
# that speed; several columns as one word with blanks between them), as AUTO wrote it, read without the project's own reader
value() {
  values "$@" | head -n 1
}

values() { # the same of all such points
  local code
  case $2 in HB) code=3 ;; UZ) code=-4 ;; LP) code=2 ;; TR) code=8 ;; *) return 2 ;; esac
  awk -v code="$code" -v columns="$3" -v V="${4:-}" '
    BEGIN { n = split(columns, wanted, " ") }
    $1 == 0 && /PT +TY +LAB/ {
      for (k = 1; k * 19 < length($0); k++) {
        name = substr($0, 1 + 19 * k, 19)
        gsub(/ /, "", name)
        place[name] = 4 + k
      }
    }
    $1 != 0 && ($3 % 10 == code || (code == 2 && $3 % 10 == 5)) {
      if (V != "" && ($(place["V"]) - V) ^ 2 >= 1e-12) next
      for (k = 1; k <= n; k++) printf "%s%s", $place[wanted[k]], k < n ? " " : "\n"
    }
  ' "build/runs/$1/b.$1"
}

# cell COLUMN WORD...: that column of the first row of what mlg WORD... prints
cell() {
  local column=$1
  shift
  build/bin/mlg "$@" | awk -F, -v column="$column" '
    /^#/ { next }
    !n++ { for (k = 1; k <= NF; k++) if ($k == column) place = k; next }
    { print $place; exit }'
}

# ended_badly PID: waits for a job of this shell (which `run` would not, in a shell of its
# own), whose status is not to be 0
ended_badly() {
  local status=0
  wait "$1" || status=$?
  [ "$status" -ne 0 ] || { echo "process $1 ended with status 0" && return 1; }
}

# near X Y RELATIVE [WHAT]
near() {
  awk -v x="$1" -v y="$2" -v tolerance="$3" -v what="${4:-value}" 'BEGIN {
    number = "^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$"
    size = y < 0 ? -y : y
    if (x ~ number && y ~ number && x - y <= tolerance * size && y - x <= tolerance * size) exit 0
    printf "%s is %s, expected %s within %g of it\n", what, x, y, tolerance
    exit 1
  }'
}

# near_each TOLERANCE WHAT < lines "x y"
near_each() {
  awk -v tolerance="$1" -v what="$2" '
    function bad(text) { print what ", number " NR ", " text; exit wrong = 1 }
    BEGIN { number = "^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$" }
    $1 !~ number || $2 !~ number || NF != 2 { bad("is \"" $0 "\", expected two numbers") }
    ($1 - $2) ^ 2 > (tolerance * $2) ^ 2 { bad("is " $1 ", expected " $2 " within " tolerance " of it") }
    END { if (!wrong && !NR) bad("there is nothing to compare"); exit wrong }'
}

# examples FILE [FROM [TO]]: the code of its blocks ```bash, or of these only
examples() {
  awk -v from="${2:-1}" -v to="${3:-1e9}" '
    /^```bash$/ { n++; inside = 1; next }
    /^```$/ { inside = 0 }
    inside && n >= from && n <= to' "$ROOT/$1"
}
