#!/usr/bin/env bash
# fresh.sh - do the two commands work on a machine that nobody prepared?
#
#   tests/fresh.sh [SUITE...]     bookworm and trixie by default; make check-fresh suite=trixie
#
# Each suite is installed bare (debootstrap --variant=minbase) into build/fresh, the
# tree as committed is cloned into it, and `make` and `make test` run there:
#   root   as root: the set-up installs what is missing
#   user   without rights, what root installed being there; first on the PATH a python3
#          and a gnuplot that lack all, and another awk: gawk, with original-awk in trixie
# The last lines and the times of each are shown; build/fresh/SUITE.CASE.log has all.
#
# case=root or case=user   one of the two; user needs a root before it
# mirror=URL               where the suite is from, as for noble (Ubuntu 24.04) on a Debian; by
#                          default the first of this machine's own that has it
# Needs   root, debootstrap, git, and the mirror; without these one line says what is skipped
# Writes  build/fresh, 2 GB for a suite, which stays for the next time
# Exit    0 all passed or skipped, 1 something failed
set -euo pipefail
. "$(dirname "$(realpath "$0")")/../scripts/auto/tools.sh"

readonly fresh=$PWD/build/fresh

skip() {
  echo "skip  $1"
  exit 0
}

# From the first of this machine's own sources that has the suite
install() { # SUITE
  local url root=$fresh/$1 script=()
  # an Ubuntu that is newer than this debootstrap
  [ -e "/usr/share/debootstrap/scripts/$1" ] || script=(/usr/share/debootstrap/scripts/gutsy)
  # shellcheck disable=SC2016 # apt's own
  for url in ${mirror:-$(apt-get indextargets --format '$(REPO_URI)' | awk '!seen[$0]++')}; do
    rm -rf "$root.part"
    debootstrap --variant=minbase "$1" "$root.part" "$url" "${script[@]}" >"$root.log" 2>&1 || continue
    # Ubuntu has gnuplot and AUTO's source in universe
    ! grep -q ubuntu "$root.part/etc/os-release" || echo "deb $url $1 main universe" >"$root.part/etc/apt/sources.list"
    chroot "$root.part" useradd --create-home --uid 1000 fresh
    mv "$root.part" "$root"
    return
  done
  rm -rf "$root.part"
  return 1
}

# Runs in the new root, as root or as the user: the two commands, each with its time
# shellcheck disable=SC2016 # for the shell there
readonly commands='
cd ~/mlg-shimmy
command -v make >/dev/null || bash scripts/setup.sh
for goal in "" test; do
  started=$SECONDS
  make $goal || echo "make $goal: status $?"
  printf "%s: %d s\n" "make $goal" $((SECONDS - started))
done
git status --short | sed "s/^/changed: /"'

one() { # SUITE CASE
  local root=$fresh/$1 log=$fresh/$1.$2.log home=/root as=() path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
  if [ "$2" = user ]; then
    home=/home/fresh
    as=(setpriv --reuid=1000 --regid=1000 --clear-groups)
    path=$home/hostile:$path
    hostile "$root$home/hostile" "$1"
  fi
  rm -rf "$root$home/mlg-shimmy"
  git clone -q "file://$PWD" "$root$home/mlg-shimmy"
  [ "$2" = root ] || chown -R 1000:1000 "$root$home"
  chroot "$root" "${as[@]}" env -i HOME="$home" PATH="$path" LANG=C.UTF-8 bash -c "$commands" >"$log" 2>&1 </dev/null || true
  echo "$1, $2: $(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' "$root/etc/os-release")"
  grep -E '^(make|changed:|Tests:|Failed:|  [a-z-]+: )' "$log" | sed 's/^/  /'
  grep -q '^Tests: [1-9][0-9]* passed, 0 failed' "$log" && ! grep -q '^make.*status' "$log"
}

# Tools that lack everything, before those that have it, and another awk
hostile() { # FOLDER SUITE
  local tool awk=gawk
  [ "$2" != trixie ] || awk=original-awk
  chroot "$fresh/$2" apt-get -qq -y --no-install-recommends install gawk original-awk >/dev/null 2>&1
  mkdir -p "$1"
  for tool in python3 python gnuplot; do
    printf '#!/bin/sh\nexit 1\n' >"$1/$tool"
    chmod +x "$1/$tool"
  done
  ln -sfn "/usr/bin/$awk" "$1/awk"
}

main() {
  local suite who failed=0
  [ "$(id -u)" -eq 0 ] || skip "check-fresh: chroot needs root"
  unshare --mount true 2>/dev/null || skip "check-fresh: nothing can be mounted here"
  command -v debootstrap >/dev/null || skip "check-fresh: no debootstrap here (Debian's package debootstrap)"
  # mounts and processes of its own: none is left, however this ends
  [ -n "${MLG_UNSHARED:-}" ] || MLG_UNSHARED=yes exec unshare --mount --pid --fork --kill-child "$PWD/tests/fresh.sh" "$@"
  trap 'exit 130' INT TERM
  mkdir -p "$fresh"
  [ $# -gt 0 ] || set -- bookworm trixie
  for suite; do
    if [ ! -d "$fresh/$suite" ] && ! install "$suite"; then
      echo "skip  check-fresh: $suite cannot be had from this machine's sources${mirror:+ nor from $mirror}; mirror=URL gives another"
      continue
    fi
    mount -t proc proc "$fresh/$suite/proc"
    ln -sfn /proc/self/fd "$fresh/$suite/dev/fd"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$fresh/$suite/dev/pts"
    ln -sf pts/ptmx "$fresh/$suite/dev/ptmx"
    cp /etc/resolv.conf "$fresh/$suite/etc"
    for who in ${case:-root user}; do one "$suite" "$who" || failed=1; done
    umount "$fresh/$suite/proc" "$fresh/$suite/dev/pts"
  done
  return "$failed"
}

main "$@"
exit
