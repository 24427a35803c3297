# auto-demos.bats - is the AUTO-07p we build or are given a good one?
#
# Runs some of AUTO's own demos, through its shell commands and its Python
# interface, and compares all special points with those in test/hyper.all of
# AUTO's source (tolerances: demos/compare.awk) and with closed forms; a
# missing point, an MX or a NaN fails. Then feeds scripts/auto/build-auto.sh and
# scripts/setup.sh what they must refuse.
#
# Needs   bats 1.5, build/auto.mk or what scripts/auto/build-auto.sh needs
# Writes  build/tests/auto-demos

# shellcheck disable=SC2030,SC2031 # each test runs in a shell of its own
bats_require_minimum_version 1.5.0

setup_file() {
  export ROOT OMP_NUM_THREADS=1 AUTO TARBALL PATH
  unset MAKEFLAGS MAKELEVEL
  ROOT=$(realpath "$BATS_TEST_DIRNAME/..")
  TARBALL=$ROOT/build/auto-07p_0.9.2.orig.tar.gz
  cd "$ROOT" || return
  [ -e build/auto.mk ] || scripts/auto/build-auto.sh
  rm -rf build/tests/auto-demos
  mkdir -p build/tests/auto-demos
  # As seen from build/tests/auto-demos/<test>: AUTO does not stand blanks
  # in AUTO_DIR, and the path to the checkout may have some
  AUTO=$(sed -n 's/^AUTO_DIR = //p' build/auto.mk)
  case $AUTO in
  /*) ;;
  *) AUTO=../../../../$AUTO ;;
  esac
  # Debian's package has the commands on the PATH, and no demos
  PATH=$AUTO/cmds:$AUTO/bin:$PATH
}

setup() {
  mkdir "$ROOT/build/tests/auto-demos/$BATS_TEST_NUMBER"
  cd "$ROOT/build/tests/auto-demos/$BATS_TEST_NUMBER" || return
  export AUTO_DIR=$AUTO
}

# The files of a demo here, and what AUTO's authors got in a file "reference"
demo() { # name
  local from=$AUTO
  if ! [ -d "$AUTO/demos" ]; then
    from=../source
    if ! [ -d $from ]; then
      [ -e "$TARBALL" ] || skip "this AUTO comes without its demos"
      mkdir $from
      tar -xzf "$TARBALL" -C $from --strip-components=2
    fi
  fi
  cp "$from/demos/$1"/* .
  sed -n "/^Demo $1 is started/,/^Demo $1 is done/p" "$from/test/hyper.all" >reference
}

auto_python() { # script
  if command -v auto >/dev/null; then auto "$1"; else auto-07p "$1"; fi
}

agrees() { # with the reference; keep going so that all differences show
  awk -f "$ROOT/tests/demos/compare.awk" reference output
}

# value type n column: a number of the n-th point of that type
value() {
  awk -v type="$1" -v n="$2" -v column="$3" \
    '$3 == type && ++seen == n { print $(4 + column); found = 1; exit } END { exit !found }' output
}

is_close() { # number, expected, tolerance
  awk -v x="$1" -v y="$2" -v tol="$3" \
    'BEGIN { exit !(x ~ /^-?[0-9.]+E[-+][0-9]+$/ && x - y <= tol && y - x <= tol) }' ||
    { echo "$1 is not $2" && return 1; }
}

@test "lor by shell commands: a cascade of period doublings" {
  demo lor
  {
    @r lor 1 && @sv 1
    @r lor 2 1 && @sv 2
    @r lor 3 2
  } >output
  agrees
  # The distances of doublings shrink by Feigenbaum's 4.67 in the end
  awk '$3 == "PD" { at[++n] = $5 } END { r = (at[1] - at[2]) / (at[2] - at[3]); exit !(n == 3 && r > 4.4 && r < 5.2) }' output
}

@test "kdv, in C, by shell commands: a homoclinic orbit becomes a triple one" {
  local run
  demo kdv
  {
    @r kdv && @sv 1
    for run in 2 3 4 5 6 7; do
      @r kdv $run $((run - 1)) && @sv $run
    done
  } >output
  agrees
  # The first orbit is known: max r = 3 (b + 1/2), b = (sqrt(65) + 3) / 4
  is_close "$(value EP 1 3)" 9.796693 1e-5
}

@test "fnb, in C, by shell commands: a homoclinic orbit by homotopy" {
  demo fnb
  {
    @r fhn && @sv 1
    @r fhn 2 1 && @sv 2
    @r fhn 3 2 && @sv 3
    @r fhn 4 3
  } >everything
  # Beyond its fold the fourth run differs by machine and ends in MX
  sed '/ LP \| MX /,$d' everything >output
  sed -i '/ LP \| MX /,$d' reference
  agrees
  # The manual: a Belyakov point at (a, c) = (0.131812, 0.217166)
  is_close "$(value UZ 4 1)" 0.131812 2e-5
  is_close "$(value UZ 4 6)" 0.217166 2e-5
}

@test "ab through Python: equilibria, Hopf points, folds, periodic orbits" {
  demo ab
  auto_python ab.auto >output
  agrees
  [ "$(grep -c ' HB ' output)" -eq 7 ]
  [ "$(grep -c ' LP ' output)" -eq 4 ]
}

@test "bvp through Python: a boundary value problem and its branches" {
  local n
  demo bvp
  auto_python bvp.auto >output
  agrees
  # u'' + (n pi)^2 u = 0: zero bifurcates at n = 1, 2, ...
  for n in 1 2 3 4 5; do
    is_close "$(value BP $n 1)" $n 1e-5
  done
  # u'' = u^2, u(0) = u(1) = 0: the integral of u is
  # -6 I J, I and J those of 1 / sqrt(1 - s^3) and s / sqrt(1 - s^3) on 0..1
  awk '$3 == "UZ" && $4 == 10 && $5 ^ 2 < 1e-7 { print $9 }' output >integral
  is_close "$(cat integral)" -7.25521 1e-4
}

@test "lrz through Python: the Lorenz equations" {
  demo lrz
  auto_python lrz.auto >output
  is_close "$(value BP 1 1)" 1 1e-5
  # rho = sigma (sigma + beta + 3) / (sigma - beta - 1), z = rho - 1,
  # x = y = +-sqrt(beta z)
  is_close "$(value HB 1 1)" 24.736842 1e-4
  is_close "$(value HB 1 3)" 7.956020 1e-4
  is_close "$(value HB 2 4)" -7.956020 1e-4
  is_close "$(value HB 1 5)" 23.736842 1e-4
}

@test "a solution is read back through Python, with numpy if it is there" {
  if grep -q 'N\.bool,' "$AUTO/python/auto/Points.py" && ! [ "$AUTO" -ef "$ROOT/build/auto" ]; then
    skip "this AUTO does not go with numpy 1.24 and later"
  fi
  demo lrz
  cat >read.auto <<'END'
hopf = run("lrz")("HB1")
orbit = run(hopf, IPS=2, ICP=["rho", "PERIOD"], NMX=35, NPR=2, DS=0.5)
save(orbit, "orbit")
orbit = loadbd("orbit")(8)
print("%.5E %.5E" % (max(orbit["x"]), orbit["PERIOD"]))
END
  auto_python read.auto | tail -n 1 >solution
  is_close "$(cut -d' ' -f1 solution)" 8.24078 1e-3
  is_close "$(cut -d' ' -f2 solution)" 0.653196 1e-5
}

@test "a missing point, an MX, a NaN and a wrong number are noticed" {
  local change
  demo lor
  cp reference output
  agrees
  for change in '/ PD  *4 /d' 's/ PD  *4 / MX    4 /' \
    's/4\.80867E-01/        NaN/' 's/2\.29407E+02/2.29807E+02/'; do
    sed "$change" reference >output
    run -1 cmp -s reference output
    run -1 agrees
  done
  : >output
  run -1 agrees
}

## build/auto.mk and what it is made from

@test "build/auto.mk compiles and links a model in C" {
  local include fc link
  demo kdv
  include=$(sed -n 's/^AUTO_INCLUDE = //p' "$ROOT/build/auto.mk")
  fc=$(sed -n 's/^AUTO_FC = //p' "$ROOT/build/auto.mk")
  link=$(sed -n 's/^AUTO_LINK = //p' "$ROOT/build/auto.mk")
  # What our models take from AUTO besides its headers
  cat >uses.c <<'END'
void getmdmx_(void), dgeev_(void), dggev_(void);
void (*const uses[])(void) = {getmdmx_, dgeev_, dggev_};
END
  cd "$ROOT"
  gcc -O2 -std=c11 -isystem "$include" -c "$OLDPWD/kdv.c" -o "$OLDPWD/kdv.o"
  gcc -O2 -std=c11 -Wall -Wextra -Wpedantic -Werror -c "$OLDPWD/uses.c" -o "$OLDPWD/uses.o"
  # shellcheck disable=SC2086 # words of a command line
  "$fc" "$OLDPWD/kdv.o" "$OLDPWD/uses.o" $link -o "$OLDPWD/kdv.exe"
  cd "$OLDPWD"
  ./kdv.exe <c.kdv >output
  [ "$(value EP 1 1)" = 3.00000E+00 ]
}

# A checkout of its own, so that build/auto of this one stays as it is
checkout() {
  mkdir -p checkout/scripts/auto
  cp "$ROOT"/scripts/setup.sh checkout/scripts
  cp "$ROOT"/scripts/auto/{build-auto,tools}.sh checkout/scripts/auto
  unset AUTO_DIR AUTO_TARBALL
}

# refuses pattern command...: exit status 2 and one line that has the pattern
refuses() {
  local pattern=$1
  shift
  run -2 "$@"
  [ "${#lines[@]}" -eq 1 ]
  # shellcheck disable=SC2053 # a pattern
  [[ $output == $pattern ]]
  [ ! -e checkout/build/auto ]
  [ ! -e checkout/build/auto.mk ]
}

@test "a tarball that is not there is refused" {
  checkout
  AUTO_TARBALL=none.tar.gz refuses '*AUTO_TARBALL=*/none.tar.gz: no such file' \
    checkout/scripts/auto/build-auto.sh
}

@test "a tarball with a wrong sum is refused, ours are thrown away" {
  local kept=checkout/build/${TARBALL##*/}
  checkout
  echo junk >junk.tar.gz
  AUTO_TARBALL=junk.tar.gz refuses '*junk.tar.gz is not AUTO-07p*sha256 sum*' \
    checkout/scripts/auto/build-auto.sh
  [ -e junk.tar.gz ]
  [ ! -e "$kept" ]
  cp junk.tar.gz "$kept"
  refuses '*thrown away*sha256 sum*' checkout/scripts/auto/build-auto.sh
  [ ! -e "$kept" ]
}

@test "no network: the fetch fails, and the tarball one may give is named" {
  checkout
  # a proxy that refuses; apt has no other way out
  printf 'Acquire::%s::Proxy "http://127.0.0.1:9";\n' http https >conf
  printf 'Acquire::Retries "0";\n' >>conf
  APT_CONFIG=$PWD/conf run -1 checkout/scripts/auto/build-auto.sh
  [[ ${lines[-1]} == 'build-auto: fetch of AUTO-07p failed, '*'without a network give the tarball as AUTO_TARBALL=file' ]]
  [ ! -e checkout/build/auto ]
  [ ! -e checkout/build/auto.tmp ]
  [ ! -e "checkout/build/${TARBALL##*/}" ]
}

@test "half a tarball is thrown away, given or kept" {
  local kept=checkout/build/${TARBALL##*/}
  [ -e "$TARBALL" ] || skip "no tarball in build/"
  checkout
  mkdir checkout/build
  head -c 100000 "$TARBALL" >half.tar.gz
  AUTO_TARBALL=half.tar.gz refuses '*half.tar.gz is not AUTO-07p*' checkout/scripts/auto/build-auto.sh
  cp half.tar.gz "$kept"
  refuses '*thrown away*; the next run fetches it' checkout/scripts/auto/build-auto.sh
  [ ! -e "$kept" ]
}

@test "a checkout that cannot be written to is refused" {
  local as=()
  if [ "$(id -u)" -eq 0 ]; then
    as=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    "${as[@]}" test -x "$PWD" || skip "another user cannot reach this checkout"
  fi
  checkout
  chmod a-w checkout
  refuses '*nothing can be written to */checkout/build: copy the checkout*' "${as[@]}" checkout/scripts/auto/build-auto.sh
  chmod u+w checkout
}

@test "an AUTO_DIR without AUTO is refused" {
  checkout
  AUTO_DIR=. refuses '*AUTO_DIR=* holds no AUTO-07p that is built*' \
    checkout/scripts/auto/build-auto.sh
  AUTO_DIR=nowhere refuses '*AUTO_DIR=*/nowhere holds no AUTO-07p that is built*' \
    checkout/scripts/auto/build-auto.sh
}

@test "AUTO_DIR is followed wherever it goes" {
  local one=$BATS_TEST_TMPDIR/one two=$BATS_TEST_TMPDIR/two mk=checkout/build/auto.mk
  ln -s "$(realpath "$AUTO")" "$one"
  mkdir -p "$two"/{lib,include,cmds}
  touch "$two/lib/main.o" "$two/include/auto_f2c.h"
  echo 'FC = other-fortran' >"$two/cmds/cmds.make"
  checkout
  AUTO_DIR=$one checkout/scripts/auto/build-auto.sh
  grep -qx "AUTO_DIR = $one" $mk
  grep -qx "AUTO_VERSION = $(sed -n 's/^AUTO_VERSION = //p' "$ROOT/build/auto.mk")" $mk
  AUTO_DIR=$two checkout/scripts/auto/build-auto.sh
  grep -qx "AUTO_DIR = $two" $mk
  grep -qx "AUTO_INCLUDE = $two/include" $mk
  grep -qx "AUTO_FC = other-fortran" $mk
  touch -d yesterday $mk
  AUTO_DIR=$two/../two/ checkout/scripts/auto/build-auto.sh
  [ -z "$(find $mk -mmin -60)" ] # not written again
}

@test "a compiler that fails stops the build and shows why" {
  [ -e "$TARBALL" ] || skip "no tarball in build/"
  checkout
  mkdir bin
  printf '#!/bin/sh\necho no licence\nexit 1\n' >bin/gfortran
  chmod +x bin/gfortran
  PATH=$PWD/bin:$PATH AUTO_TARBALL=$TARBALL run -1 checkout/scripts/auto/build-auto.sh
  [[ $output == *'configure of AUTO-07p failed'* ]]
  [ ! -e checkout/build/auto ]
  [ ! -e checkout/build/auto.tmp ]
}

## scripts/setup.sh

@test "the set-up has nothing to say when all is there" {
  run -0 "$ROOT/scripts/setup.sh" test
  [ -z "$output" ]
}

# hostile: a python3 without modules and a gnuplot without terminals, first on the PATH
hostile() {
  local tool
  mkdir -p hostile
  for tool in python3 python gnuplot; do
    printf '#!/bin/sh\necho "hostile %s" >&2\nexit 1\n' $tool >hostile/$tool
    chmod +x hostile/$tool
  done
  PATH=$PWD/hostile:$PATH
}

@test "what the set-up found is what is used, not what stands first on the PATH" {
  hostile
  checkout
  run -0 checkout/scripts/setup.sh test
  [ -z "$output" ]
  # shellcheck disable=SC2016 # for that shell
  run -0 bash -c '. checkout/scripts/auto/tools.sh; python3 -c "import numpy, sympy; print(1)"; python -c "print(2)"
    gnuplot -d -e "set terminal pngcairo; print 3" 2>&1'
  [[ $output == 1$'\n'2$'\n'*3 ]]
}

@test "a tool that has all is taken from the PATH" {
  local python
  checkout
  mkdir first
  python=$(command -v python3)
  printf '#!/bin/sh\nexec "%s" "$@" # first\n' "$python" >first/python3
  chmod +x first/python3
  PATH=$PWD/first:$PATH checkout/scripts/setup.sh test
  grep -F first/python3 checkout/build/tools/python3
}

@test "the set-up names what is missing where nobody may install it" {
  local tool
  checkout
  mkdir bin
  for tool in bash cat chmod dirname env ln mkdir mv realpath tail; do
    ln -s "$(command -v $tool)" bin
  done
  printf '#!/bin/sh\necho 1000\n' >bin/id
  chmod +x bin/id
  PATH=$PWD/bin refuses '*missing gcc gfortran *; as root: apt-get install *cmark-gfm*' \
    bash checkout/scripts/setup.sh
  PATH=$PWD/bin refuses '*missing gcc *g++ *libcmocka-dev *bats *' \
    bash checkout/scripts/setup.sh test
  run -2 "$ROOT/scripts/setup.sh" nonsense
}

# only TOOL...: a bin of these alone, where an apt-get writes down what it is asked for
only() {
  local tool
  mkdir bin
  for tool in bash cat chmod dirname env ln mkdir mv realpath tail rm xargs "$@"; do
    ln -s "$(command -v "$tool")" bin
  done
  printf '#!/bin/sh\necho 0\n' >bin/id
  printf '#!/bin/sh\necho "$@" >>"%s"\n' "$PWD/asked" >bin/apt-get
  chmod +x bin/id bin/apt-get
}

@test "apt-get is to take nothing away" {
  checkout
  only
  PATH=$PWD/bin run -1 bash checkout/scripts/setup.sh
  grep -q ' install --no-remove --no-install-recommends gcc ' asked
}

@test "a probe that fails in another way installs nothing" {
  local tool
  for tool in gcc gnuplot python3; do
    rm -rf bin asked checkout
    checkout
    only awk make gfortran cmark-gfm gcc gnuplot python3
    rm bin/$tool
    printf '#!/bin/sh\necho "out of memory" >&2\nexit 1\n' >bin/$tool
    chmod +x bin/$tool
    PATH=$PWD/bin run -1 bash checkout/scripts/setup.sh test
    # the one of /usr/bin is asked for what the first on the PATH lacks
    [ $tool = gcc ] || { [[ $output == *'setup: installing '* ]] && continue; }
    [[ $output == 'setup: cannot tell whether '*' is there: '*' fails; nothing was installed' ]]
    [ ! -e asked ]
  done
  CC='nonesuch -O2' run -1 checkout/scripts/setup.sh
  [ "$output" = 'setup: cannot tell whether stdlib.h is there: nonesuch -O2 fails; nothing was installed' ]
}

@test "an AUTO_DIR of signs that a shell or make reads is refused, and nothing of it runs" {
  local name
  checkout
  cp -r "$ROOT"/{Makefile,models,constants} checkout
  # shellcheck disable=SC2016 # names, not to be expanded
  for name in "it's" 'a$(touch ran)' '`touch ran`' 'a;touch ran' 'a"b' 'a&b' 'a=b'; do
    mkdir -p "$name/lib" "$name/include"
    cp "$AUTO"/lib/*.o "$name/lib"
    cp "$AUTO/include/auto_f2c.h" "$name/include"
    AUTO_DIR=$PWD/$name run -2 make -C checkout --no-print-directory setup
    [[ $output == *'build-auto: AUTO_DIR='*' is no path for make, give a link to it '* ]]
    [ -z "$(find . -name ran)" ]
  done
}
