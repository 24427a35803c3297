#!/usr/bin/env bash
# auto-demo.sh - a figure, or runs of one's own, as a demo of AUTO's own kind
#
#   scripts/auto-demo.sh FIGURE FOLDER
#   scripts/auto-demo.sh NAME FOLDER runs=RUN,...
#   scripts/auto-demo.sh fig07 ~/fig07
#
# FOLDER, new or empty, gets all that AUTO-07p wants and nothing of this project: the
# equations with their headers, c.RUN for every run, NAME.auto for AUTO's Python
# interface, NAME.sh for its shell commands, the points to expect, two scripts that
# plot, and a README.  All of it is derived from the runs as they were made (build/runs)
# and from what the figure used (build/stamps): the figure's script runs first.
# With runs= it is these and the runs that they start from.
#
# Exit: 0, 1 a run failed, 2 bad input.  docs/auto.md says more.
folder=$(realpath -m -- "${2:-.}")
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
. scripts/auto/demo.sh
. scripts/auto/demo-plot.sh

usage="usage: scripts/auto-demo.sh FIGURE FOLDER, or NAME FOLDER runs=RUN,..."
[ $# = 2 ] || { [ $# = 3 ] && [[ $3 == runs=?* ]]; } || fail "$usage" 2
check_name "$1"
demo=$1
if [ -e "$folder" ] && [ -n "$(ls -A "$folder" 2>&1)" ]; then
  fail "auto-demo: $folder is there and not an empty folder" 2
fi

script=scripts/$demo.sh
[ $# = 3 ] || [ -f "$script" ] || script=scripts/studies/$demo.sh
if [ $# = 3 ]; then
  # shellcheck disable=SC2119 # all
  build
  asked=${3#runs=}
  mapfile -t asked <<< "${asked//,/$'\n'}"
else
  grep -qs "^main $demo " "$script" || fail "auto-demo: there is no figure '$demo'; $usage" 2
  "$script" > /dev/null
  mapfile -t asked < <(sed -n 's|^.*\tbuild/runs/\(.*\)/b\.\1$|\1|p' "build/stamps/$demo" | sort -V)
  [ -n "${asked[0]:-}" ] || fail "auto-demo: $demo has no runs of AUTO" 2
fi

order "${asked[@]}"
mkdir -p "$(dirname "$folder")"
part=$folder.part$$
trap 'rm -rf "$part"' EXIT
mkdir "$part"
write_demo
[ ! -d "$folder" ] || rmdir "$folder"
mv "$part" "$folder"
echo "  $folder: ${#runs[@]} runs, $(($(wc -l < "$folder/points.csv") - 1)) values to expect"
