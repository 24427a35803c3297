#!/usr/bin/env bash
# setup.sh - see to it that the Debian packages this project needs are there.
#
#   scripts/setup.sh            those for the figures
#   scripts/setup.sh test       those for the figures and the tests
#   scripts/setup.sh pages      those for the figures and make check-pages
#
# It looks for each thing itself, not for its package, so that a compiler or
# a plotter that came another way will do, and says nothing if all is there.
# Otherwise apt-get installs what is missing, as root or through sudo; where
# neither will do, one line names the packages and the command to give.
#
# Needs   bash; apt-get if something is missing
# Writes  build/setup.log while apt-get runs, nothing else in the checkout
# Exit    0 all is there, 1 apt-get failed, 2 wrong use or no right to install
set -euo pipefail

# job      how       thing        package          what for
readonly table='
figures    command   gcc          gcc              compiles the models
figures    command   gfortran     gfortran         compiles AUTO, links the models
figures    header    stdlib.h     libc6-dev        the C library to compile with
figures    command   make         make             builds and runs everything
figures    terminal  pdfcairo     gnuplot-nox      draws the figures
figures    command   cmark-gfm    cmark-gfm        the results as a page in HTML
test       header    cmocka.h     libcmocka-dev    the tests in C
figures    header    lapacke.h    liblapacke-dev   eigenvalues of a gear (mlg)
figures    header    cvode/cvode.h libsundials-dev  integration in time (mlg)
test       command   bats         bats             the tests in shell
test       command   shellcheck   shellcheck       the test of the scripts themselves
test       command   python3      python3          the Python interface of AUTO
test       module    numpy        python3-numpy    the same, with arrays
test       module    sympy        python3-sympy    the equations derived again
test       command   git          git              is the tree clean after a run?
pages      command   bats         bats             the test of that page
pages      command   chromium     chromium         the browser it is tested in
'

say() {
  printf 'setup: %s\n' "$1" >&2
}

has_command() {
  command -v "$1"
}

has_header() {
  printf '#if !__has_include(<%s>)\n#error\n#endif\n' "$1" | gcc -E -
}

has_terminal() { # of gnuplot
  gnuplot -e "set terminal $1"
}

has_module() { # of Python; Debian's Python may not be the first on the PATH
  local python
  for python in /usr/bin/python3 python3; do
    "$python" -c "import importlib.util as u; raise SystemExit(u.find_spec('$1') is None)" && return
  done
}

missing_packages() { # job
  local job how thing package
  while read -r job how thing package _; do
    case $job in
    figures | "$1") "has_$how" "$thing" </dev/null >/dev/null 2>&1 || printf ' %s' "$package" ;;
    esac
  done <<<"$table"
}

may_install() {
  command -v apt-get && { [ "$(id -u)" -eq 0 ] || sudo -n true || { command -v sudo && [ -t 0 ]; }; }
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=120 "$@"
}

# An update that misses one source of many may still do
install_packages() {
  apt update || true
  apt install --no-install-recommends "$@"
}

main() {
  local job=${1:-figures} packages log
  case $#:$job in
  [01]:figures | 1:test | 1:pages) ;;
  *) say 'usage: scripts/setup.sh [figures|test|pages]' && exit 2 ;;
  esac
  packages=$(missing_packages "$job")
  [ -n "$packages" ] || return 0
  if ! may_install >/dev/null 2>&1; then
    say "missing$packages; as root: apt-get install --no-install-recommends$packages"
    exit 2
  fi
  say "installing$packages"
  log=$(dirname "$0")/../build/setup.log # nothing outside the checkout
  mkdir -p "$(dirname "$log")"
  # shellcheck disable=SC2086 # one word for each package
  if ! install_packages $packages >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    say "apt-get could not install$packages, it ends as above"
    rm -f "$log"
    exit 1
  fi
  rm -f "$log"
  packages=$(missing_packages "$job")
  [ -z "$packages" ] || { say "still missing after its installation: what is in$packages" && exit 1; }
}

main "$@"
