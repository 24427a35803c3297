#!/usr/bin/env bash
# sound.sh - are the programs, objects and constants files that make built still what they
# were?  Beside each FILE stands its sum, FILE.sum (Makefile).
#
# One that is not looks old from here on, so that make builds it anew; a line says so.  What
# a make or a figure that was killed left half done goes: FILE.PID, PID no more.
shopt -s nullglob globstar
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." || exit

for file in build/{bin,models,lib,libmlg,mlg,constants}/**/*.[0-9]* build/stamps/*.[0-9]*.uses; do
  pid=${file%.uses} pid=${pid##*.}
  case $pid in *[!0-9]*) ;; *) [ -e "/proc/$pid" ] || rm -f "$file" ;; esac
done

sums=(build/{bin,models,lib,libmlg,mlg,constants}/**/*.sum)
[ ${#sums[@]} -gt 0 ] || exit 0
cat "${sums[@]}" | md5sum --check --quiet 2>/dev/null | while IFS= read -r line; do
  file=${line%: FAILED*}
  case $line in *': FAILED') ;; *) continue ;; esac # is not there, and is built
  if [[ $file == *.d ]]; then # which headers an object hangs on
    rm -f "$file"
    touch -c -d @0 "${file%.d}".o "${file%.d}"
  else
    touch -c -d @0 "$file"
  fi
  echo "  $file is not what was built; it is made anew" >&2
done
