#!/usr/bin/env bash
# build-auto.sh - provide AUTO-07p and write down how to compile against it.
#
#   scripts/auto/build-auto.sh                  build AUTO-07p 0.9.2 into build/auto
#   AUTO_TARBALL=file scripts/auto/build-auto.sh    the same from a tarball at hand
#   AUTO_DIR=folder scripts/auto/build-auto.sh      use the AUTO in that folder instead
#
# The source is the upstream tarball of Debian's source package auto-07p,
# fetched with the machine's own apt through private lists (no root, nothing
# outside the checkout) and checked against a fixed sum. AUTO_DIR may name an
# AUTO 0.9.2 built elsewhere, Debian's binary package (/usr/lib/auto-07p) or
# a newer upstream AUTO.
#
# Needs   gcc gfortran make (scripts/setup.sh installs them), apt-get to fetch
# Writes  build/auto.mk, lines NAME = value for make and sed:
#           AUTO_DIR AUTO_VERSION AUTO_FC   the AUTO, its version, its compiler
#           AUTO_INCLUDE                    the folder of auto_f2c.h
#           AUTO_LINK                       what AUTO_FC links a model with
#         and, unless AUTO_DIR is given, build/auto, the tarball and the log
#         build/auto-build.log. Paths to build/auto are relative to the
#         checkout, so that blanks in the path to it do no harm.
# Exit    0 AUTO is there, 1 fetching or building it failed, 2 bad input
set -euo pipefail

readonly version=0.9.2
readonly sha256=892d53c0b3cb0a20049ec69d100b5c0b880185e81063f59e7b1c6e158bf82285
readonly kept=build/auto-07p_0.9.2.orig.tar.gz # a rebuild needs no network
readonly home=build/auto
readonly tmp=build/auto.tmp
readonly log=build/auto-build.log

# The optimisation is given in full: configure's own -O would come last and
# undo it in C, and without -march results do not depend on the machine.
# gfortran 10 and later refuse the old parts of AUTO without -std=legacy; gcc
# 15 refuses the prototypes of auto_f2c.h unless C is older than C23. Without
# OpenMP the results are the same to the last bit; a run is faster than with
# OpenMP on one thread, and far faster than on all threads of a busy machine.
readonly opt=-O2
readonly flags=(
  --without-openmp --with-optimization-flags="$opt"
  CC=gcc CFLAGS="$opt -std=gnu11" FC=gfortran FCFLAGS=-std=legacy
  --disable-plaut --disable-plaut04 --disable-gui --disable-tek2ps --without-x
)

fail() { # status, message
  printf 'build-auto: %s\n' "$2" >&2
  exit "$1"
}

# stage name command...: one line with the seconds it took, output to the log
stage() {
  local name=$1 start=$SECONDS status
  shift
  printf 'AUTO-07p %s: %-9s ' "$version" "$name"
  set +e # in a condition, set -e would not work inside the command
  (set -e && "$@") >>"$log" 2>&1 </dev/null
  status=$?
  set -e
  if [ "$status" -ne 0 ]; then
    printf 'failed\n'
    tail -n 20 "$log" >&2
    fail 1 "$name of AUTO-07p failed, $log ends as above${hint:+; $hint}"
  fi
  printf '%3d s\n' $((SECONDS - start))
}

sum_is_right() { # file
  printf '%s  %s\n' "$sha256" "$1" | sha256sum --check --status
}

# The machine's apt sources, each deb turned into deb-src
copy_sources() { # folder
  local list parts file
  eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
  for file in "$list" "$parts"/*.list "$parts"/*.sources; do
    [ -r "$file" ] || continue
    case $file in
    *.list) sed -E 's/^[[:space:]]*deb[[:space:]]/deb-src /' "$file" ;;
    *) sed -E 's/^Types:.*/Types: deb-src/I' "$file" ;;
    esac >"$1/${file##*/}"
  done
}

# Many sources may be given, and one out of reach does not matter as long as
# the tarball arrives. The options come after the machine's own settings.
fetch() {
  local apt=$PWD/$tmp/apt
  mkdir -p "$apt"/{sources,lists/partial,cache/archives/partial,get}
  copy_sources "$apt/sources"
  printf '%s "%s";\n' >"$apt/conf" \
    Dir::Etc::SourceList /dev/null Dir::Etc::SourceParts "$apt/sources" \
    Dir::State::Lists "$apt/lists" Dir::Cache "$apt/cache" \
    APT::Sandbox::User root Acquire::Languages none
  apt-get -q -c "$apt/conf" update || true
  cd "$apt/get"
  apt-get -q -c "$apt/conf" source --tar-only auto-07p
  mv auto-07p_*.orig.tar.* ../../tarball
  rm -rf "$apt"
}

get_tarball() {
  local hint='without a network give the tarball as AUTO_TARBALL=file'
  if [ -n "$tarball" ]; then
    cp -- "$tarball" "$tmp/tarball"
    mv "$tmp/tarball" "$kept"
  elif ! [ -e "$kept" ]; then
    command -v apt-get >/dev/null ||
      fail 2 'no apt-get here to fetch AUTO-07p: give its tarball as AUTO_TARBALL=file'
    stage fetch fetch
    mv "$tmp/tarball" "$kept"
  fi
  if ! sum_is_right "$kept"; then
    rm "$kept"
    fail 2 "the tarball is not AUTO-07p $version and was thrown away, its sha256 sum is not $sha256; the next run fetches it"
  fi
}

configure() {
  tar -xzf "$kept" -C "$tmp" --no-same-owner --strip-components=2
  cd "$tmp"
  chmod -R go+rX .
  # Debian left tek2ps out of the tarball, and configure asks for this
  mkdir -p tek2ps
  : >tek2ps/Makefile.in
  # numpy.bool is gone since numpy 1.24, arrays compared with [] since 2.2
  sed -i 's/N\.bool,/bool,/' python/auto/Points.py
  sed -i 's/fdata == \[\] or //' python/auto/parseS.py
  # Python 3.12 warns of a backslash that escapes nothing
  sed -i -E "/r'|"'\\\\/!s/\\([s.#*w])/\\\\\1/g' python/auto/{interactiveBindings,parseD,runAUTO,runDemo}.py
  ./configure "${flags[@]}"
}

recipe() {
  printf '%s\n' "$sha256" "${flags[@]}" "$(declare -f configure)" \
    "gcc $(gcc -dumpfullversion)" "gfortran $(gfortran -dumpfullversion)"
}

build() {
  local tool
  for tool in gcc gfortran make; do
    command -v "$tool" >/dev/null || fail 2 "$tool is missing: scripts/setup.sh installs it"
  done
  if [ -n "$tarball" ]; then
    [ -f "$tarball" ] || fail 2 "AUTO_TARBALL=$tarball: no such file"
    sum_is_right "$tarball" ||
      fail 2 "AUTO_TARBALL=$tarball is not AUTO-07p $version, its sha256 sum is not $sha256"
  fi
  if [ -e "$home/recipe" ] && [ "$(<"$home/recipe")" = "$(recipe)" ]; then
    return
  fi
  rm -rf "$tmp"
  mkdir "$tmp"
  trap 'rm -rf "$tmp"' EXIT
  : >"$log"
  unset MAKEFLAGS MFLAGS GNUMAKEFLAGS MAKELEVEL CONFIG_SITE CPPFLAGS LDFLAGS LIBS FFLAGS
  get_tarball
  stage configure configure
  stage compile make -C "$tmp" # serially, AUTO's makefile lacks a dependency
  recipe >"$tmp/recipe"
  rm -rf "$home"
  mv "$tmp" "$home"
}

# The version stands in the change log, which Debian's package keeps elsewhere
version_of() { # folder
  local package
  if [ -e "$1/CHANGELOG" ]; then
    sed -n '1s/:.*//p' "$1/CHANGELOG"
  elif package=$(dpkg-query -S "$(realpath "$1/lib/main.o")" 2>/dev/null); then
    dpkg-query -W -f '${source:Upstream-Version}\n' "${package%%: *}" | sed 's/[+~].*//'
  else
    echo unknown
  fi
}

describe() { # folder: the lines of build/auto.mk
  local dir=$1 include fc link
  for include in "$dir/include" "$(realpath -m "$dir/../../include")" ''; do
    [ ! -e "$include/auto_f2c.h" ] || break
  done
  if [ -z "$include" ] || ! [ -e "$dir/lib/main.o" ]; then
    fail 2 "AUTO_DIR=$dir holds no AUTO-07p that is built: no lib/main.o or no auto_f2c.h"
  fi
  case $dir in
  *[[:space:]\$\#\'\"\`\\\;\&\|\<\>\(\)\*\?\[\]\{\}:%=]*)
    fail 2 "AUTO_DIR=$dir is no path for make, give a link to it without blanks and signs of the shell" ;;
  esac
  fc=$(sed -n 's/^FC[[:space:]]*=[[:space:]]*//p' "$dir/cmds/cmds.make" 2>/dev/null || true)
  link="$dir/lib/*.o"
  [ ! -e "$dir/lib/libauto_c.a" ] || link+=" $dir/lib/libauto_c.a"
  [ -e "$dir/lib/lapack.o" ] || link+=' -llapack -lblas'
  if grep -q GOMP_ "$dir"/lib/*.o; then
    link+=' -fopenmp'
  fi
  printf '%s = %s\n' AUTO_DIR "$dir" AUTO_VERSION "$(version_of "$dir")" \
    AUTO_FC "${fc:-gfortran}" AUTO_INCLUDE "$include" AUTO_LINK "$link"
}

# A path as the caller sees it, for use from the checkout
absolute() {
  [ -z "$1" ] || realpath -ms -- "$1"
}

main() {
  local dir tarball text
  [ $# -eq 0 ] || fail 2 'takes no arguments, see the head of the script'
  dir=$(absolute "${AUTO_DIR:-}")
  tarball=$(absolute "${AUTO_TARBALL:-}")
  . "$(dirname "$(realpath "$0")")/tools.sh"
  { mkdir -p build && [ -w build ]; } 2>/dev/null ||
    fail 2 "nothing can be written to $PWD/build: copy the checkout to where you may write"
  exec 9>build/auto.lock
  flock -n 9 || { echo 'waiting for another build of AUTO-07p' && flock 9; }
  # Somebody who works with build/auto by hand has it in AUTO_DIR
  if [ -z "$dir" ] || [ "$(realpath -m -- "$dir")" = "$(realpath -m "$home")" ]; then
    build
    dir=$home
  fi
  text=$(describe "$dir")
  if ! [ -e build/auto.mk ] || [ "$text" != "$(<build/auto.mk)" ]; then
    printf '%s\n' "$text" >build/auto.mk.tmp
    mv build/auto.mk.tmp build/auto.mk
  fi
}

main "$@"
