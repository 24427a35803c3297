# shellcheck shell=bash
# lib.sh - how a figure is made; the scripts of figures and studies source it.
#
# A figure's script defines runs_PART for its runs, tables, and what is special about
# it; `main FIGURE` does the rest: runs by `mlg run`, which makes only what is not up
# to date, then the tables, then the picture.  What a figure was made from, and the sums
# of all that, stand in build/stamps/FIGURE (mlg stamp); while they hold there is
# nothing to do.

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/tools.sh"

# Ends with one line on standard error; status 1: a run failed, 2: bad input.
fail() { echo "$1" >&2; exit "${2:-1}"; }

# So does any other command that fails, a full disk under it for one.
set -E
trap '[ $BASHPID != $$ ] || fail "${BASH_SOURCE[0]}:$LINENO: failed: ${BASH_COMMAND%%$'"'\n'"'*}"' ERR

# The models and mlg, built when they are not up to date.  Under make they are, and
# asking again would only cost time.
# shellcheck disable=SC2120 # some scripts do
build() { # [TARGET]
  [ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent "${1:-models}" || exit 1
  export MLG_BUILT=yes
}

# A decimal number above 0, below 1e12.
is_above_0() { [[ $1 =~ ^[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$ ]] && awk -v x="$1" 'BEGIN { exit !(x > 0 && x < 1e12) }'; }

# What gives runs and tables their names and is no such name ends here (mlg stamp).
check_name() { # NAME
  [[ $1 =~ ^[A-Za-z0-9][A-Za-z0-9._+-]{0,99}$ ]] ||
    fail "the name '$1': letters, digits, . _ - and +, a letter or a digit first, at most 100" 2
}

mlg() { build/bin/mlg "$@"; }

# run NAME CONSTANTS [from=RUN] [KEY=VALUE ...] [-- TYPE=COUNT ...]: `mlg help run`
run() { mlg run "$@" || exit $?; }

# Tables.  begin_table FILE LINE... opens a table with these head lines, and the
# figure's table of special points; rows and points add to them; end_table puts
# both in place if they changed, so that what depends on them can tell.
begin_table() {
  table=$1
  points_table=build/tables/points.$figure.csv
  shift
  printf '%s\n' "$@" > "$table.new"
  : > "$points_table.new"
}

rows() { mlg rows "$@" >> "$table.new" || exit $?; } # `mlg help rows`

points() { # FIGURE_NUMBER,LAYOUT RUN...
  local prefix=$1
  shift
  mlg points "$@" prefix="$prefix" >> "$points_table.new" || exit $?
}

end_table() {
  case $table in results/*) record ;; esac
  replace "$table"
  replace "$points_table"
}

replace() { # FILE: by FILE.new, unless they are the same; the table that was begun by one that has rows
  if [[ $1 == results/*.csv && $1 == "${table:-}" ]] && [ "$(grep -vc '^#' "$1.new")" -lt 2 ]; then
    rm "$1.new"
    fail "$figure: there are no rows for $1; \`$0 runs\` makes what they come from" 2
  fi
  use "$1"
  if cmp -s "$1.new" "$1"; then rm "$1.new"; else mv "$1.new" "$1"; fi
  case $1 in results/*.csv) keep "$1" ;; esac
}

# keep FILE: a table of results/ as it was made, and its sum; is_known FILE: it is what was
# made here, or what git has (where there is neither, any); put_back FILE: by the one kept.
keep() {
  local kept=build/tables/${1##*/}
  cp "$1" "$kept.kept"
  md5sum < "$1" > "$kept.sum"
}

is_known() {
  local kept=build/tables/${1##*/}
  [ "$(md5sum < "$1")" != "$(cat "$kept.sum" 2> /dev/null)" ] || return 0
  if git ls-files --error-unmatch "$1" > /dev/null 2>&1; then git diff --quiet HEAD -- "$1"; else [ ! -e "$kept.sum" ]; fi
}

put_back() {
  local kept=build/tables/${1##*/}
  [ -e "$kept.kept" ] && [ "$(md5sum < "$kept.kept")" = "$(cat "$kept.sum" 2> /dev/null)" ] || return
  cp "$kept.kept" "$1"
  echo "  $1 is not what was made; it is put back" >&2
}

# Notes a file that the figure hangs on and no command of mlg reads.
use() { printf '%s\n' "$@" >> "${MLG_USES:-/dev/null}"; }

# What takes minutes is not made again because mlg was linked anew.
# made NAME FILE... -- COMMAND...: the output of COMMAND as build/tables/NAME.csv, made
# again when its words or one of the files changed, or the table itself (mlg stamp).  Of two
# at once the second waits, and finds it made.
made() {
  local table=build/tables/$1.csv words=build/tables/$1.words stamp=made.$1 files=() started=${EPOCHREALTIME/./} lock
  exec {lock}> "build/stamps/made.$1.lock"
  flock "$lock"
  make_it "$@"
  exec {lock}>&-
}

make_it() { # as made; in its variables
  shift
  while [ "$1" != -- ]; do files+=("$1"); shift; done
  shift
  use "$table"
  echo "$*" > "$words.new"
  cmp -s "$words.new" "$words" || mv "$words.new" "$words"
  rm -f "$words.new"
  if mlg stamp fits "$stamp" > /dev/null; then return; fi
  touch "build/stamps/$stamp.began"
  "$@" > "$table.new" || exit $?
  mv "$table.new" "$table"
  MLG_USES='' mlg stamp write "$stamp" "$table" "$words" "${files[@]}"
  printf '  %-28s %5d ms\n' "$(basename "$table" .csv)" $(((${EPOCHREALTIME/./} - started) / 1000))
}

# Whether the tables that `made` made for the figure are still that: a cut one would be left out unseen.
check_made() {
  local stamp stamps=() damaged
  for stamp in "build/stamps/made.$figure".*; do
    case $stamp in *.began | *.lock | *'*') ;; *) stamps+=("${stamp#build/stamps/}") ;; esac
  done
  damaged=$([ ${#stamps[@]} -eq 0 ] || mlg stamp whole "${stamps[@]}") && return
  damaged=${damaged%%$'\n'*}
  fail "build/tables/${damaged#made.}.csv is not what was made; \`$0 runs\` makes it again" 2
}

# sources LAYOUT FILE...: the equations of a layout and these, for made
sources() {
  printf '%s\n' models/{mlg,elements,network,gear,jacobian}.h models/gear.c "models/$1.c" models/libmlg/{libmlg,layout}.c "${@:2}"
}

# What boundary points, widest intervals and best damped devices come from, for made
# shellcheck disable=SC2034 # for who asks
algebra=(models/linearised.h
  models/libmlg/{best_damped,best_ratio,boundary_points,climb,crossing,crossing_extrema,crossing_roots,crossing_spin,golden,places,slopes,widest}.c)

# Sets k_s, b, c_lo, c_hi: the gear whose interval c_lo to c_hi of c_d the paper calls best.
# For LI2 the paper gives b only: k_s is just below the onset of the delta region, where the
# interval is widest.
# shellcheck disable=SC2034 # for who asks
paper_gear() { # LAYOUT
  case $1 in
    l1) k_s=inf b=0 ;;
    l2) k_s=7.86e5 b=0 ;;
    li1) k_s=6.38e5 b=140 ;;
    li2) k_s=2.48e6 b=140 ;;
  esac
  IFS=, read -r c_lo c_hi _ < <(mlg intervals "$1" k_s="$k_s" b="$b" | sed -n 3p)
}

# The figure's row of results/versions.csv: with what its runs were made.  It is written
# with the table, so runs that find the same table leave it as it is.
record() {
  if cmp -s "$table.new" "$table" && has_version; then return; fi
  write_version
}

has_version() { grep -qE "^$figure(,[^,]+){8}\$" results/versions.csv 2> /dev/null; }

write_version() {
  local file=results/versions.csv runs
  exec 7> build/tables/versions.lock
  flock 7
  runs=$({ grep -lx "figure=$figure" build/runs/*/origin 2> /dev/null || true; } | wc -l)
  {
    echo "# With what the runs of a figure were made when its table last changed."
    echo figure,runs,AUTO,cc,gfortran,libc,gnuplot,system,processor
    {
      grep -E '^[a-z0-9]+(,[^,]+){8}$' "$file" 2> /dev/null | grep -v -e '^figure,' -e "^$figure," || true
      echo "$figure,$runs,$(sed -n 's/^AUTO_VERSION = //p' build/auto.mk),$(cc -dumpfullversion),$(gfortran -dumpfullversion),$(
        getconf GNU_LIBC_VERSION),$(gnuplot --version | cut -d ' ' -f 2,4 | tr ' ' .),$(. /etc/os-release && echo "$NAME $VERSION_ID"),$(uname -m)"
    } | sort
  } > "$file.new"
  mv "$file.new" "$file"
  exec 7>&-
}

# The picture of results/NAME.csv, and all of a script's, which may have several.
draw() { draw_picture; }

# On a full disk gnuplot ends with status 0.
draw_picture() {
  local picture=results/$figure
  [ -s "$picture.csv" ] || fail "$figure: there is no $picture.csv to draw; scripts/$figure.sh tables makes it" 2
  rm -f "$picture".{png,svg,gif}.new
  LC_ALL=C.UTF-8 gnuplot -d -e "figure='$figure'" scripts/pictures/style.gp "scripts/pictures/$figure.gp"
  if ! tail -c 12 "$picture.png.new" | grep -aq IEND || ! tail -c 12 "$picture.svg.new" | grep -q '</svg>'; then
    fail "$figure: gnuplot wrote half a picture, $picture.png or .svg (is the disk full?); those before are kept"
  fi
  use scripts/pictures/{style,"$figure"}.gp "$picture.csv"
  replace "$picture.png"
  replace "$picture.svg"
  [ ! -f "$picture.gif.new" ] || replace "$picture.gif"
  echo "  results/$figure.png"
}

# From here on one script at a time works on NAME.
alone() { # NAME
  mkdir -p build/tables build/stamps results
  exec 8> "build/tables/$1.lock"
  flock 8
}

# What every figure script does with its arguments.
main() { # FIGURE [runs [PART...] | tables | draw]
  export MLG_FIGURE=$1 MLG_STARTED=${MLG_STARTED:-$EPOCHSECONDS} MLG_ASKED=${MLG_ASKED:-$1}
  local step=${2:-all} part parts
  figure=$1
  mapfile -t parts < <(declare -F | sed -n 's/^declare -f runs_//p')
  case $step in runs | tables | draw | all) ;; *) fail "usage: $0 [runs [PART] | tables | draw]" 2 ;; esac
  for part in "${@:3}"; do
    case " ${parts[*]} " in *" $part "*) ;; *) fail "$figure: no runs '$part'; there are ${parts[*]}" 2 ;; esac
  done
  # shellcheck disable=SC2119 # all
  build
  # parts of one figure may run side by side, its tables and its picture not
  if [ "$step" = runs ]; then mkdir -p build/tables build/stamps results; else alone "$figure"; fi
  if [ "$step" = all ] && mlg stamp fits "$figure" > /dev/null; then return; fi
  export MLG_USES=build/stamps/$figure.$$.uses
  trap 'rm -f "$MLG_USES"' EXIT
  printf '%s\n' "$0" scripts/auto/*.sh build/bin/mlg > "$MLG_USES"
  touch "build/stamps/$figure.began"
  if [ $# -lt 3 ]; then set -- "$figure" "$step" "${parts[@]}"; fi
  case $step in runs | all) for part in "${@:3}"; do "runs_$part"; done ;; esac
  if [ "$step" = tables ]; then check_made; fi
  case $step in tables | all) tables ;; esac
  if [ "$step" = all ]; then scripts/report/collect.sh; fi
  case $step in draw | all) draw ;; esac
  if [ "$step" = all ]; then mlg stamp write "$figure"; fi
}
