#!/usr/bin/env bash
# setup.sh - see to it that the Debian packages this project needs are there.
#
#   scripts/setup.sh            those for the figures
#   scripts/setup.sh test       those for the figures and the tests
#   scripts/setup.sh pages      those for the figures and make check-pages
#   scripts/setup.sh sweeps     those for the figures and scripts/sweep.sh run
#   scripts/setup.sh slurm      those for the figures and scripts/sweep.sh slurm
#
# It looks for each thing itself, not for its package, so that a compiler or
# a plotter that came another way will do, and says nothing if all is there.
# Otherwise apt-get installs what is missing, as root or through sudo; where
# neither will do, one line names the packages and the command to give.
#
# A Python may lack sympy and a gnuplot its terminals: of these the first on the PATH
# that has all a job asks of it is used, else that of /usr/bin, where apt-get puts it.
# build/tools has a command of that name, first on the PATH of every script (tools.sh).
#
# Needs   bash; apt-get if something is missing
# Writes  build/tools; build/setup.log while apt-get runs; nothing else in the checkout
# Exit    0 all is there, 1 apt-get failed, 2 wrong use or no right to install
set -euo pipefail
. "$(dirname "$(realpath "$0")")/auto/tools.sh"

# job      how       thing        package          what for
readonly table='
figures    command   gcc          gcc              compiles the models
figures    command   gfortran     gfortran         compiles AUTO, links the models
figures    header    stdlib.h     libc6-dev        the C library to compile with
figures    command   make         make             builds and runs everything
figures    command   awk          mawk             reads what AUTO writes
figures    gnuplot   pngcairo     gnuplot-nox      draws the figures
figures    command   cmark-gfm    cmark-gfm        the results as a page in HTML
test       command   g++          g++              the test of the C header in C++
test       header    cmocka.h     libcmocka-dev    the tests in C
figures    header    lapacke.h    liblapacke-dev   eigenvalues of a gear (mlg)
figures    header    cvode/cvode.h libsundials-dev  integration in time (mlg)
test       command   bats         bats             the tests in shell
test       command   shellcheck   shellcheck       the test of the scripts themselves
test       python3   sys          python3          the Python interface of AUTO
test       python3   numpy        python3-numpy    the same, with arrays
test       python3   sympy        python3-sympy    the equations derived again
test       command   git          git              is the tree clean after a run?
test       gnu       parallel     parallel         sweeps on two jobs
sweeps     gnu       parallel     parallel         sweeps on this machine
slurm      command   sbatch       slurm-wlm        sweeps on a cluster, and their test
pages      command   bats         bats             the test of that page
pages      command   chromium     chromium         the browser it is tested in
'

say() {
  printf 'setup: %s\n' "$1" >&2
}

# Each prints nothing: status 0 it is there, 1 it is not, 3 it cannot be told, since what
# was asked has failed in another way (too little memory, say).
has_command() { # THING
  command -v "$1" >/dev/null
}

# Of moreutils there is another parallel.
has_gnu() { # THING
  [[ "$("$1" --version 2>/dev/null)" = GNU\ * ]]
}

# shellcheck disable=SC2086 # CC may have flags
has_header() {
  [ -z "${CC:-}" ] || command -v ${CC%% *} >/dev/null || return 3
  said ${CC:-gcc} -E - < <(printf '#if __has_include(<%s>)\nthere\n#else\nmissing\n#endif\n' "$1")
}

has_gnuplot() { # TERMINAL [GNUPLOT]
  said "${2:-gnuplot}" -d -e "set print '-'; print strstrt(' '.GPVAL_TERMINALS.' ', ' $1 ') ? 'there' : 'missing'"
}

has_python3() { # MODULE [PYTHON]
  said "${2:-python3}" -c "import importlib.util as u; print('missing' if u.find_spec('$1') is None else 'there')"
}

said() { # COMMAND...: its last line is one of two words, or it cannot be told
  local text status=0
  text=$("$@" 2>/dev/null) || status=$?
  case $status:${text##*$'\n'} in 0:there) return 0 ;; 0:missing | 127:*) return 1 ;; *) return 3 ;; esac
}

# asked JOB [HOW]: the rows of the table for that job
asked() {
  local job how rest
  while read -r job how rest; do
    case $job:$how in
    "figures:${2:-$how}" | "$1:${2:-$how}") echo "$how $rest" ;;
    esac
  done <<<"$table"
}

has_all() { # JOB NAME TOOL
  local thing
  while read -r _ thing _; do
    "has_$2" "$thing" "$3" </dev/null >/dev/null 2>&1 || return
  done < <(asked "$1" "$2")
}

choose() { # JOB NAME: the tool of that name in build/tools
  local tool
  [ -n "$(asked "$1" "$2")" ] || return 0
  while read -r tool; do
    case $tool in */build/tools/*) continue ;; esac # a choice made before
    if has_all "$1" "$2" "$tool"; then break; fi
  done < <(type -aP "$2"; echo "/usr/bin/$2")
  tool=${tool:-/usr/bin/$2} # none has all: packages can complete this one alone
  if [ "$(tail -n 1 "build/tools/$2" 2>/dev/null)" != "$(printf 'exec %q "$@"' "$tool")" ]; then
    mkdir -p build/tools
    printf '#!/bin/sh\nexec %q "$@"\n' "$tool" >"build/tools/$2.$$"
    chmod +x "build/tools/$2.$$"
    mv "build/tools/$2.$$" "build/tools/$2"
  fi
}

missing_packages() { # JOB
  local how thing package status
  choose "$1" gnuplot
  choose "$1" python3
  # AUTO's own command takes python where there is one
  [ ! -e build/tools/python3 ] || ln -sf python3 build/tools/python
  while read -r how thing package _; do
    status=0
    "has_$how" "$thing" </dev/null || status=$?
    case $status in
    0) ;;
    1) printf ' %s' "$package" ;;
    *) say "cannot tell whether $thing is there: ${how/header/${CC:-gcc}} fails; nothing was installed" && exit 1 ;;
    esac
  done < <(asked "$1")
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
  apt install --no-remove --no-install-recommends "$@"
}

main() {
  local job=${1:-figures} packages log
  case $#:$job in
  [01]:figures | 1:test | 1:pages | 1:sweeps | 1:slurm) ;;
  *) say 'usage: scripts/setup.sh [figures|test|pages|sweeps|slurm]' && exit 2 ;;
  esac
  packages=$(missing_packages "$job")
  [ -n "$packages" ] || return 0
  if ! may_install >/dev/null 2>&1; then
    say "missing$packages; as root: apt-get install --no-install-recommends$packages"
    exit 2
  fi
  say "installing$packages"
  log=build/setup.log
  mkdir -p build
  # shellcheck disable=SC2086 # one word for each package
  if ! install_packages $packages >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    say "apt-get could not install$packages, it ends as above"
    rm -f "$log"
    exit 1
  fi
  rm -f "$log"
  packages=$(missing_packages "$job")
  [ -z "$packages" ] || { say "still missing after its installation: what is in$packages, for $(command -v "${CC:-gcc}" gnuplot python3 | xargs)" && exit 1; }
}

main "$@"
