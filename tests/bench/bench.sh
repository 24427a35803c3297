#!/usr/bin/env bash
# bench.sh - times of this project beside others, as make bench prints them
#
#   tests/bench/bench.sh [PART...]    model jacobian output blas mesh growth fortran
#                                     xppaut python figures; all of them by default
#   PAIRS=N                           pairs of a short measurement, 11 by default
#   LONG_PAIRS=N                      pairs of whole reproductions, 3 by default
#
# Each row compares two commands.  They run in turn, ours first in every second
# pair.  ours and other are the medians of the wall times in seconds, ratio is
# the median over the pairs of other/ours, spread its least and largest value.
# mesh and growth have single runs, and processor seconds.
# Where both give the same numbers, these are compared first.
#
# Needs   the models; for its part each gfortran, xppaut, python3-numpy, valgrind,
#         auto-07p (Debian's packages) and git; what is missing is left out and said
# Writes  build/bench, nothing else
# Exit    0; 1 if a comparison has other numbers than ours; 2 bad input
# shellcheck disable=SC2317 # functions that compare calls
. "$(dirname "$(realpath "$0")")/../../scripts/auto/lib.sh"

readonly pairs=${PAIRS:-11} long_pairs=${LONG_PAIRS:-3} bench=build/bench
readonly first=496c6de # the first commit that makes all eight figures
readonly debian=/usr/lib/auto-07p

left_out() { echo "  left out: $1" >&2; }

seconds() { # COMMAND: its wall time
  local start=${EPOCHREALTIME/./}
  eval "$1" > "$bench/out" 2> "$bench/err" || true
  awk -v t=$((${EPOCHREALTIME/./} - start)) 'BEGIN { printf "%.6f\n", 1e-6 * t }'
}

compare() { # PAIRS WHAT OURS OTHER: two commands, each in one string
  local pair a b
  for ((pair = 0; pair < $1; pair++)); do
    if ((pair % 2)); then b=$(seconds "$4"); a=$(seconds "$3"); else a=$(seconds "$3"); b=$(seconds "$4"); fi
    echo "$a $b"
  done | awk -v what="$2" '
    function sorted(x,    i, j, t) { for (i = 2; i <= n; i++) for (j = i; j > 1 && x[j - 1] > x[j]; j--) { t = x[j]; x[j] = x[j - 1]; x[j - 1] = t } }
    function median(x) { return (x[int((n + 1) / 2)] + x[int((n + 2) / 2)]) / 2 }
    { ours[++n] = $1; other[n] = $2; ratio[n] = $2 / $1 }
    END {
      sorted(ours); sorted(other); sorted(ratio)
      printf "%-62s %8.3f %8.3f %6.2f   %.2f to %.2f\n", what, median(ours), median(other), median(ratio), ratio[1], ratio[n]
    }'
}

heading() { printf '\n%-62s %8s %8s %6s   %s\n' "$1" "ours/s" "other/s" ratio spread; }

# agree WHAT TOLERANCE OURS OTHER: files with a number a line
agree() {
  paste -d' ' "$3" "$4" | awk -v what="$1" -v tolerance="$2" '
    NF != 2 || ($1 - $2) ^ 2 > (tolerance * $1) ^ 2 { print what ": " $0 > "/dev/stderr"; wrong = 1 }
    END { exit wrong || !NR }' || fail "bench: $1 differs"
}

values() { # TYPE COLUMN FOLDER: of the points of a type
  mlg rows "$bench/$3/run" columns="$2:.9g" only="$1"
}

# A folder in which auto_in runs a model again and again.
prepare() { # FOLDER CONSTANTS FROM [KEY=VALUE ...]: FROM is such a folder, or -
  local folder=$bench/$1
  mkdir -p "$folder"
  mlg constants "constants/c.$2" "${@:4}" > "$folder/fort.2"
  echo "sv = 'run'" >> "$folder/fort.2"
  if [ "$3" != - ]; then
    cp "$bench/$3/s.run" "$folder/s.start"
    echo "s = 'start'" >> "$folder/fort.2"
  fi
}

auto_in() { # FOLDER MODEL
  (cd "$bench/$1" && exec "$OLDPWD/$2") > "$bench/$1.log" 2>&1
}

# --- the model ---------------------------------------------------------------

part_model() {
  local layout program ns total libm
  printf '\n%-62s %8s %8s %8s\n' "one right-hand side (median ns; instructions by callgrind)" ns instr. "% libm"
  for program in build/bench/rhs-*; do
    [ -x "$program" ] || continue # a .d file
    layout=${program##*-}
    ns=$(for _ in 1 2 3 4 5 6 7 8 9; do "$program" 300000; done | sort -n | sed -n 5p)
    total=- libm=-
    if command -v valgrind > /dev/null; then
      valgrind --tool=callgrind --toggle-collect='timed*' --callgrind-out-file="$bench/callgrind" \
        "$program" 10000 > "$bench/out" 2>&1
      read -r total libm < <(callgrind_annotate --auto=no --threshold=100 "$bench/callgrind" | awk '
        { gsub(/,/, "") }
        /PROGRAM TOTALS/ { total = $1 }
        /sysdeps|libm/ { libm += $1 }
        END { printf "%d %.0f\n", total / 1e4, 100 * libm / total }')
    fi
    printf '%-62s %8s %8s %8s\n' "$layout" "${ns% ns}" "$total" "$libm"
  done
  command -v valgrind > /dev/null || left_out "instructions; apt-get install valgrind"
}

# --- derivatives -------------------------------------------------------------

part_jacobian() {
  heading "derivatives, one run of AUTO (layout L1)"
  prepare straight l1.straight - c_d=3.6e4
  auto_in straight build/models/l1.exe
  jacobians psi l1.periodic straight IRS="'HB1'"
  jacobians delta l1.periodic straight IRS="'HB2'"
  jacobians hopf l1.hopf straight IRS="'HB2'" DS=-0.1
  prepare torus_start l1.torus_start psi
  auto_in torus_start build/models/l1.exe
  jacobians torus l1.torus torus_start
}

jacobians() { # FOLDER CONSTANTS FROM [KEY=VALUE ...]: its own JAC | the other ones
  local own jac
  own=$(sed -n 's/.*JAC *= *\(-*[0-9]\).*/\1/p' "constants/c.$2")
  prepare "$@"
  auto_in "$1" build/models/l1.exe
  values UZ V "$1" > "$bench/ours.values"
  for jac in 1 0 -1; do
    [ "$jac" != "$own" ] || continue
    prepare "$1.other" "${@:2}" JAC="$jac"
    auto_in "$1.other" build/models/l1.exe
    values UZ V "$1.other" > "$bench/other.values"
    agree "$1 with JAC=$jac" 1e-3 "$bench/ours.values" "$bench/other.values"
    compare "$pairs" "${2#*.} ($1): JAC=$own | JAC=$jac" "auto_in $1 build/models/l1.exe" "auto_in $1.other build/models/l1.exe"
  done
}

# --- AUTO's side ---------------------------------------------------------------

# Prepares the runs that the parts below vary: straight, psi, delta, hopf.
runs_of_l1() {
  local name
  prepare straight l1.straight - c_d=3.6e4
  auto_in straight build/models/l1.exe
  prepare psi l1.periodic straight IRS="'HB1'"
  prepare delta l1.periodic straight IRS="'HB2'"
  prepare hopf l1.hopf straight IRS="'HB2'" DS=-0.1
  for name in psi delta hopf; do auto_in $name build/models/l1.exe; done
}

part_output() {
  local name setting
  heading "AUTO's output (layout L1)"
  runs_of_l1
  for name in straight psi hopf; do
    for setting in 'IID = 0' 'IID = 3' 'NPR = 1'; do
      rm -rf "$bench/$name.other"
      cp -r "$bench/$name" "$bench/$name.other"
      echo "$setting" >> "$bench/$name.other/fort.2" # the last one counts
      compare "$pairs" "$name as in its file | $setting" "auto_in $name build/models/l1.exe" "auto_in $name.other build/models/l1.exe"
    done
  done
}

part_blas() {
  local file link=()
  heading "linear algebra"
  [ -e "$auto/lib/lapack.o" ] || { left_out "BLAS and LAPACK; $auto uses those of the system already"; return; }
  for file in "$auto"/lib/*.o "$auto"/lib/libauto_c.a; do
    case $file in */blas.o | */lapack.o) ;; *) link+=("$file") ;; esac
  done
  gfortran build/models/l1.o "${link[@]}" -llapack -lblas -o "$bench/blas.exe" 2> "$bench/err" ||
    { left_out "BLAS and LAPACK; apt-get install liblapack-dev, or libopenblas-dev"; return; }
  runs_of_l1
  for name in straight psi hopf; do
    compare "$pairs" "$name: AUTO's own | $(basename "$(realpath "$(ldd "$bench/blas.exe" | awk '/libblas/ { print $3 }')")")" \
      "auto_in $name build/models/l1.exe" "auto_in $name $bench/blas.exe"
  done
}

cpu() { # COMMAND: its processor seconds and largest memory, MB
  if [ -x /usr/bin/time ]; then
    /usr/bin/time -f '%U %S %M' -o "$bench/time" bash -c "$1" > "$bench/out" 2>&1
    awk '{ printf "%.2f %.1f\n", $1 + $2, $3 / 1024 }' "$bench/time"
  else
    local TIMEFORMAT='%U %S'
    { time bash -c "$1" > "$bench/out" 2>&1; } 2>&1 | awk '{ printf "%.2f -\n", $1 + $2 }'
  fi
}

part_mesh() {
  local mesh name seconds
  printf '\n%-20s %8s %12s %12s %14s %14s\n' "orbits of Figure 6(a)" "cpu/s" "TR of psi" "psi_max, A" "TR of delta" "dstar_max, B"
  runs_of_l1
  for mesh in 10:4 15:3 15:4 15:5 20:4 30:4 40:4 80:4; do
    prepare psi.mesh l1.periodic straight IRS="'HB1'" NTST="${mesh%:*}" NCOL="${mesh#*:}"
    prepare delta.mesh l1.periodic straight IRS="'HB2'" NTST="${mesh%:*}" NCOL="${mesh#*:}"
    seconds=$(for name in psi delta; do cpu "cd $bench/$name.mesh && ../../models/l1.exe"; done | awk '{ t += $1 } END { print t }')
    printf 'NTST = %-3d NCOL = %d %8s %12s %12s %14s %14s\n' "${mesh%:*}" "${mesh#*:}" "$seconds" \
      "$(values TR V psi.mesh)" "$(at_V 20 psi_max psi.mesh)" "$(values TR V delta.mesh)" "$(at_V 40 dstar_max delta.mesh)"
  done
}

at_V() { # V COLUMN FOLDER: of the orbit asked for there
  paste -d' ' <(values UZ V "$3") <(values UZ "$2" "$3") | awk -v at="$1" '($1 - at) ^ 2 < 1e-12 { print $2; exit }'
}

part_growth() {
  local n cases
  printf '\n%-40s %8s %10s\n' "growth" "cpu/s" "memory/MB"
  runs_of_l1
  for n in 20 40 80 160 320; do
    prepare growth l1.periodic straight IRS="'HB1'" NTST="$n"
    grown "orbits, psi branch, NTST = $n" "cd $bench/growth && ../../models/l1.exe"
  done
  our_tree
  # shellcheck disable=SC2016 # for the shell that cpu starts
  for n in 1 2 4 8; do
    cases=$(seq -s ' ' 400000 20000 $((380000 + n * 20000)))
    grown "Hopf curves of LI1, b = 70, number of k_s: $n" "cd $bench/ours && rm -rf build/runs &&
      for k_s in $cases; do scripts/curves.sh li1 k\$k_s k_s=\$k_s b=70; done"
    grown "boundary points of LI1, number of b: $n" "cd $bench/ours && rm -rf build/runs && . scripts/auto/lib.sh && . scripts/auto/boundary.sh &&
      for b in $(seq -s ' ' 60 $((59 + n))); do boundary_curves li1 \$b; done"
  done
}

grown() { # WHAT COMMAND
  local seconds memory
  read -r seconds memory < <(cpu "$2")
  printf '%-46s %8s %10s\n' "$1" "$seconds" "$memory"
}

our_tree() { # a copy of this one with its models built
  tree ours -
  AUTO_DIR=$auto make -C "$bench/ours" models > "$bench/out"
}

# --- other tools ---------------------------------------------------------------

part_fortran() {
  local flags name
  command -v gfortran > /dev/null || { left_out "l1.f90; apt-get install gfortran"; return; }
  heading "layout L1 in C | as a Fortran equation file, JAC=0"
  flags=$(sed -n 's/^AUTO_LINK = //p' build/auto.mk)
  # shellcheck disable=SC2086 # a list of files
  gfortran -O2 tests/bench/l1.f90 $flags -o "$bench/fortran.exe"
  prepare straight l1.straight - c_d=3.6e4
  auto_in straight build/models/l1.exe
  prepare straight.f90 l1.straight - c_d=3.6e4 JAC=0
  prepare psi l1.periodic straight IRS="'HB1'" UZR="{'V': [20.0]}"
  prepare psi.f90 l1.periodic straight IRS="'HB1'" UZR="{'V': [20.0]}" JAC=0
  prepare hopf l1.hopf straight IRS="'HB2'" DS=-0.1
  prepare hopf.f90 l1.hopf straight IRS="'HB2'" DS=-0.1 JAC=0
  for name in straight psi hopf; do
    auto_in "$name" build/models/l1.exe
    auto_in "$name.f90" "$bench/fortran.exe"
    compare "$pairs" "$name" "auto_in $name build/models/l1.exe" "auto_in $name.f90 $bench/fortran.exe"
  done
  for name in "straight HB V 1e-6" "psi UZ period 1e-6" "hopf LP c_d 1e-6"; do
    # shellcheck disable=SC2086 # four words
    set -- $name
    values "$2" "$3" "$1" > "$bench/ours.values"
    values "$2" "$3" "$1.f90" > "$bench/other.values"
    agree "$3 at $2 of $1 in Fortran" "$4" "$bench/ours.values" "$bench/other.values"
  done
}

part_xppaut() {
  command -v xppaut > /dev/null || { left_out "l1.ode; apt-get install xppaut"; return; }
  heading "solution A of Figure 6"
  prepare straight l1.straight - c_d=3.6e4
  auto_in straight build/models/l1.exe
  prepare a l1.periodic straight IRS="'HB1'"
  compare "$pairs" "AUTO: straight rolling, all orbits | XPPAUT: 200 s at V = 20" \
    "auto_in straight build/models/l1.exe; auto_in a build/models/l1.exe" \
    "(cd $bench && xppaut ../../tests/bench/l1.ode -silent)"
  awk '$4 > most { most = $4 } END { printf "%.9g\n", most * 45 / atan2(1, 1) }' "$bench/output.dat" > "$bench/other.values"
  values UZ psi_max a | head -n 1 > "$bench/ours.values"
  agree "psi_max of XPPAUT" 1e-4 "$bench/ours.values" "$bench/other.values"
}

part_python() {
  local python=python3
  "$python" -c 'import numpy' 2> /dev/null || { left_out "map.py; apt-get install python3-numpy"; return; }
  heading "stability of straight rolling over (V, c_d), layout L1"
  export OPENBLAS_NUM_THREADS=1
  python="$python tests/bench/map.py 400 400"
  compare "$long_pairs" "eigen-l1 map, 400 x 400 | numpy, the same" "build/bin/eigen-l1 map" "$python"
  compare "$long_pairs" "mlg curves: every Hopf curve, extrema to rounding | numpy" "build/bin/mlg curves l1" "$python"
  compare "$long_pairs" "mlg intervals: zero-shimmy interval to rounding | numpy" "build/bin/mlg intervals l1" "$python"
  build/bin/eigen-l1 map > "$bench/ours.values"
  $python > "$bench/other.values"
  cmp "$bench/ours.values" "$bench/other.values" || fail "bench: map.py differs from eigen-l1 map"
}

# --- the whole -----------------------------------------------------------------

tree() { # FOLDER COMMIT: its files, or with - the work tree's
  rm -rf "${bench:?}/$1"
  mkdir -p "$bench/$1"
  if [ "$2" = - ]; then
    tar -c --exclude=./build --exclude=./.git . | tar -x -C "$bench/$1"
  else
    git archive "$2" | tar -x -C "$bench/$1"
  fi
}

# A reproduction from warm AUTO and models: runs, tables, pictures.
reproduce() { # FOLDER JOBS
  rm -rf "$bench/$1"/build/{runs,tables}
  make -k -C "$bench/$1" -j"$2" figures
}

part_figures() {
  local jobs ours
  jobs=$(getconf _NPROCESSORS_ONLN)
  ours="AUTO_DIR=$auto reproduce ours"
  heading "every figure and table"
  our_tree
  compare "$long_pairs" "make -j$jobs figures | make -j1 figures" "$ours $jobs" "$ours 1"
  compare "$long_pairs" "make figures, nothing changed | make -j1 figures" \
    "AUTO_DIR=$auto make -C $bench/ours figures" "$ours 1"
  git cat-file -e "$first^{commit}" 2> /dev/null || { left_out "the first state; it needs the git history, commit $first"; return; }
  [ -d "$debian" ] || { left_out "the first state; apt-get install auto-07p for $debian"; return; }
  tree first "$first"
  sed -i 's/JAC = -1/JAC = 0/' "$bench"/first/constants/c.*
  AUTO_DIR=$debian make -C "$bench/first" models > "$bench/out"
  compare "$long_pairs" "make -j$jobs figures | first state, Debian's AUTO, JAC=0, -j1" \
    "$ours $jobs" "AUTO_DIR=$debian reproduce first 1"
}

all=(model jacobian output blas mesh growth fortran xppaut python figures)
[ $# -gt 0 ] || set -- "${all[@]}"
for part; do
  declare -F "part_$part" > /dev/null || fail "bench: no part '$part'; there are ${all[*]}" 2
done
auto=$(realpath "$(sed -n 's/^AUTO_DIR = //p' build/auto.mk)")
mkdir -p "$bench"
unset MAKEFLAGS MFLAGS MAKELEVEL
export MLG_BUILT=yes # the copies of this tree have no AUTO of their own
echo "$(uname -m), $(getconf _NPROCESSORS_ONLN) processors, load $(cut -d' ' -f1 /proc/loadavg); $(gcc --version | head -n 1); AUTO-07p $(sed -n 's/^AUTO_VERSION = //p' build/auto.mk)"
for part; do "part_$part"; done
