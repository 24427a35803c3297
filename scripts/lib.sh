# shellcheck shell=bash
# lib.sh - making and judging AUTO runs; the figure scripts source it.
#
# A run lives in build/runs/NAME with AUTO's files c.NAME, b.NAME, s.NAME and
# d.NAME, as AUTO's own @sv would leave them.  It is made anew only when its
# constants, its executable, its starting solution or its judge changed; an
# interrupted or failed run leaves nothing behind that would count as made.

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/tools.sh"

# Ends with one line on standard error; status 1: a run failed, 2: bad input.
fail() { echo "$1" >&2; exit "${2:-1}"; }

# So does any other command that fails, a full disk under it for one.
set -E
trap '[ $BASHPID != $$ ] || fail "${BASH_SOURCE[0]}:$LINENO: failed: ${BASH_COMMAND%%$'"'\n'"'*}"' ERR

# The models and the constants checker, built when they are not up to date.
# Under make they are, and asking again would only cost time.
build() {
  [ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent models || exit 1
  MLG_BUILT=yes
}

# The values of a file of gear parameters, NAME=VALUE in a line each.  c.l1.hopf sets
# no parameters of its own.
gear_values() { # FILE
  local checked
  checked=$(build/bin/constants constants/c.l1.hopf gear="$1") || exit $?
  sed -n "s/^PAR = {\(.*\)}/\1/p" <<< "$checked" | tr -d "' " | tr ',:' '\n='
}

# Parts of a figure, its tables and its picture are asked for often and seldom have to
# be made again: build/tables/NAME.made has the sums of all files NAME hangs on.
is_made() { # NAME
  sha256sum --check --status "build/tables/$1.made" 2> /dev/null
}

# make_from NAME FUNCTION FILE...: what hangs on these files and on those that the
# function finds to use.  The sums of what one may edit meanwhile are taken before.
make_from() {
  uses=()
  sums=$(sha256sum "${@:3}")
  "$2"
  { echo "$sums"; sha256sum "${!uses[@]}"; } | sort -u > "build/tables/$1.made.$$"
  mv "build/tables/$1.made.$$" "build/tables/$1.made"
}

# How far all that was asked for has come, said on a terminal with each run that is
# made.  MLG_ASKED: the figures asked for; MLG_STARTED: when, s; both of make, or of
# main.  results/versions.csv knows how many runs they took last time, and how long.
[ -t 1 ] && terminal=yes || terminal=''

passed() { # RUN...: made, or found made
  [ -n "$terminal" ] && [ -n "${MLG_STARTED:-}" ] || return 0
  [ -f "build/runs/passed.$MLG_STARTED" ] || rm -f build/runs/passed.*
  printf '%s\n' "$@" >> "build/runs/passed.$MLG_STARTED"
}

progress() {
  local jobs=1
  [ -f "build/runs/passed.${MLG_STARTED:-}" ] || return 0
  [[ ! ${MAKEFLAGS:-} =~ (^|\ )-j([0-9]*) ]] || jobs=${BASH_REMATCH[2]:-$(nproc)}
  awk -F, -v asked=" $MLG_ASKED " -v elapsed=$((EPOCHSECONDS - MLG_STARTED)) -v jobs="$jobs" '
    FILENAME == ARGV[1] { if (index(asked, " " $1 " ")) { runs += $2; seconds += $3 }; next }
    !seen[$0]++ { n++ }
    END {
      printf "  [%d", n
      if (n <= runs) printf " of %d runs, %d s of about %d s", runs, elapsed, elapsed + seconds * (1 - n / runs) / jobs
      else printf " runs, %d s", elapsed
      printf "]" }' <(cat results/versions.csv 2> /dev/null) "build/runs/passed.$MLG_STARTED"
}

# The line of a run, or of several as one
report() { # NAME STARTED TEXT
  printf '  %-28s %5d ms  %s%s\n' "$1" $(((${EPOCHREALTIME/./} - $2) / 1000)) "$3" "$(progress)"
}

declare -A uses=()
use() { # FILE...
  local file
  for file; do uses["$file"]=1; done
}

use_run() { # RUN...
  local run
  for run; do use "build/runs/$run/"{b,d}".$run"; done
}

# Whether there was room for all that AUTO wrote: on a full disk it leaves out the
# rest, says nothing and goes on.  A run that AUTO ended itself, with its time in the
# log, has a labelled point last in b.NAME, whole solutions in s.NAME (the first line
# of each counts the others), and the time in d.NAME too, unless IID = 0 left that empty.
is_whole() { # FOLDER NAME
  awk '
    { kind = FILENAME; sub(/.*\//, "", kind); kind = substr(kind, 1, 2); lines[kind]++ }
    /Total Time/ { timed[kind] = 1 }
    kind == "b." { label = $4 }
    kind == "s." { if (left == 0) left = $9; else left-- }
    END {
      whole = label > 0 && left == 0 && (timed["d."] || !lines["d."])
      exit !(lines["au"] && (whole || !timed["au"]))
    }' "$1/auto.log" "$1/"{b,s,d}".$2"
}

# The part being made, with the first thing that is made for it
say_part() {
  [ -z "${announce:-}" ] || echo "$announce" >&2
  announce=''
}

# made NAME FILE... -- COMMAND...: the output of COMMAND as build/tables/NAME.csv, made
# again only when one of the files changed.
made() {
  local table=build/tables/$1.csv name=$1 files=() started=${EPOCHREALTIME/./}
  shift
  while [ "$1" != -- ]; do files+=("$1"); shift; done
  use "$table" "${files[@]}"
  if is_made "$name.csv"; then return; fi
  say_part
  "${@:2}" > "$table.new"
  mv "$table.new" "$table"
  sha256sum "$table" "${files[@]}" > "build/tables/$name.csv.made"
  report "$name" "$started" ''
}

# The gear whose interval the paper calls best, as "k_s b c_lo c_hi", c_lo to c_hi being
# that interval of c_d.  For LI2 it gives b only: k_s is just below the onset of the
# delta region, where the interval is widest.
paper_gear() { # LAYOUT
  local k_s b
  case $1 in
    l1) k_s=1e30 b=0 ;;
    l2) k_s=7.86e5 b=0 ;;
    li1) k_s=6.38e5 b=140 ;;
    li2) k_s=2.48e6 b=140 ;;
  esac
  "build/bin/scan-$1" intervals k_s=$k_s b=$b | awk -F, -v k_s=$k_s -v b=$b 'NR == 2 { print k_s, b, $1, $2 }'
}

# The name of a run or a table is one of files, of AUTO's constants and of make's words.
check_name() { # NAME
  case $1 in
    '' | [.-]* | *[!A-Za-z0-9._-]*) fail "the name '$1': letters, digits, dot, _ and - only, and neither dot nor - first" 2 ;;
  esac
  [ ${#1} -le 100 ] || fail "the name '$1': longer than 100 characters" 2
}

# A run ends at these whatever it does: seconds of processor time, and MB of one file.
export MLG_TIME_LIMIT=${MLG_TIME_LIMIT:-600} MLG_SIZE_LIMIT=${MLG_SIZE_LIMIT:-256}
for limit in MLG_TIME_LIMIT MLG_SIZE_LIMIT; do
  [[ ${!limit} =~ ^[1-9][0-9]{0,5}$ ]] || fail "$limit=${!limit}: expected a whole number, 1 to 999999" 2
done

# An AUTO whose script is gone, killed, has to go too
bounded() { # MODEL
  # a user may have set lower ones
  ulimit -S -c 0 -t "$MLG_TIME_LIMIT" 2> /dev/null || true
  ulimit -S -f $((MLG_SIZE_LIMIT * 1024)) 2> /dev/null || true
  exec setpriv --pdeathsig TERM "$1"
}

# run NAME CONSTANTS [from=RUN] [model=MODEL] [gear=FILE] [KEY=VALUE ...] -- [TYPE=COUNT ...]
#   CONSTANTS   constants/c.CONSTANTS, else the one in build/constants, or a file's
#               path; its name begins with the layout (l1.straight runs
#               build/models/l1.exe)
#   model=MODEL build/models/MODEL.exe instead (li1.boundary)
#   from=RUN    start from the solutions of that run (IRS says which one)
#   KEY=VALUE   an AUTO constant or a parameter to hand over
#   TYPE=COUNT  how many points of that type the run has to find
run() {
  [ $# -ge 2 ] || fail "usage: run NAME CONSTANTS [from=RUN] [KEY=VALUE ...] -- [TYPE=COUNT ...]" 2
  local name=$1 constants=$2 from='' model='' settings=() dir="build/runs/$1"
  local file="constants/c.$2" base origin inputs text started found stamp status work
  check_name "$name"
  shift 2
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    case $1 in
      from=*) from=${1#from=} ;;
      model=*) model=${1#model=} ;;
      *) settings+=("$1") ;;
    esac
    shift
  done
  [ $# -eq 0 ] || shift
  build
  [ -f "$file" ] || [ ! -f "build/$file" ] || file=build/$file # made for this layout
  case $constants in */*) file=$constants ;; esac
  base=${file##*/}; base=${base#c.}
  base=${model:-${base%%.*}}
  model=build/models/$base.exe
  [ -f "$file" ] || fail "$name: no constants file $file" 2
  [ -x "$model" ] || fail "$name: $file is for the layout '${base%%.*}', but there is no models/${base%%.*}.c" 2
  origin=${from:+build/runs/$from/s.$from}
  [ -d build/runs ] || mkdir -p build/runs
  exec 9> "$dir.lock" # another script may be making this very run
  flock 9
  # Every process started costs a millisecond, and there are hundreds of runs.
  [ -z "$from" ] || [ -f "$origin" ] || fail "$name: starts from $from, which has not been made" 2
  inputs=$(sha256sum "$file" scripts/{auto,judge}.awk "$model" ${from:+"$origin"})
  sums+=$'\n'$inputs
  text=$(build/bin/constants "$file" "${settings[@]}") || exit $?
  if [ -n "$from" ]; then
    [[ $text =~ $'\n'"IRS = "[^0] ]] ||
      fail "$name: from=$from starts anew because IRS = 0 in $file; say which solution, as IRS=\"'HB1'\"" 2
    text+=$'\n'"s = '$from'"
  fi
  text+=$'\n'"sv = '$name'" # AUTO writes b.NAME, s.NAME and d.NAME itself
  use build/bin/constants "$dir/stamp"
  passed "$name"
  stamp="$*"$'\n'$text$'\n'${inputs#*$'\n'} # another comment in the constants file is no change
  if [ -f "$dir/stamp" ] && [ "$(< "$dir/stamp")" = "$stamp" ]; then
    exec 9>&-
    return
  fi
  say_part
  started=${EPOCHREALTIME/./}
  work=$dir.part
  [ ! -e "$work" ] || rm -rf "$work"
  mkdir "$work"
  echo "$text" > "$work/fort.2"
  [ -z "$from" ] || ln -s "../$from/s.$from" "$work/"
  status=0
  # bash would say itself that a signal ended it
  { (cd "$work" && bounded "../../../$model") > "$work/auto.log" 2>&1; } 2> /dev/null || status=$?
  : >> "$work/b.$name"
  : >> "$work/d.$name"
  : >> "$work/s.$name"
  case $status in
    152) found="FAIL met the limit of time, $MLG_TIME_LIMIT s of processor time; MLG_TIME_LIMIT gives another" ;;
    153) found="FAIL met the limit of size, $MLG_SIZE_LIMIT MB in one file; MLG_SIZE_LIMIT gives another" ;;
    *) found=$(awk -v expect="$*" -v status="$status" -f scripts/auto.awk -f scripts/judge.awk "$work/d.$name" "$work/b.$name") ;;
  esac
  [ "$status" -ne 0 ] || is_whole "$work" "$name" || found="FAIL what AUTO wrote is cut short (is the disk full?)"
  case $found in FAIL\ * | *$'\n'FAIL\ *)
    # first the models' own word, of a parameter that left its range, and AUTO's, of its start
    { echo "$name ($file): $(awk 'sub(/^FAIL /, "") || /^PAR\(|^ *Restart label .*not found|^The solution file .*not be found/ {
        gsub(/^ +|\.$/, ""); printf "%s%s", n++ ? "; " : "", $0 }' "$work/auto.log" - <<< "$found")"
      echo "  end of AUTO's output ($work/auto.log):"
      tail -n 6 "$work/auto.log" | sed 's/^/  | /'; } >&2
    exit 1 ;;
  esac
  mv "$work/fort.2" "$work/c.$name"
  echo "$stamp" > "$work/stamp"
  printf 'layout=%s\nfigure=%s\nms=%d\n' "${base%%.*}" "${figure:-}" $(((${EPOCHREALTIME/./} - started) / 1000)) > "$work/origin"
  [ ! -e "$dir" ] || rm -rf "$dir/stamp" "$dir" # half removed it must not count as made
  mv "$work" "$dir"
  exec 9>&-
  report "$name" "$started" "${found:-no special point}"
}

# Tables.  begin_table FILE LINE... opens a table with these head lines, and the
# figure's table of special points; rows and points add to them; end_table puts
# both in place if they changed, so that what depends on them can tell.
begin_table() {
  table=$1
  points_table=build/tables/points.$figure.csv
  shift
  mkdir -p build/tables results
  printf '%s\n' "$@" > "$table.new"
  : > "$points_table.new"
}

rows() { # PREFIX COLUMNS EVERY RUN [reverse]
  use_run "$4"
  awk -v prefix="$1" -v columns="$2" -v every="$3" -v reverse="${5:+1}" -v hopf="$points_table.new" \
    -f scripts/auto.awk -f scripts/branch.awk "build/runs/$4/d.$4" "build/runs/$4/b.$4" >> "$table.new"
}

points() { # FIGURE RUN
  local layout
  use_run "$2"
  layout=$(sed -n 's/^layout=//p' "build/runs/$2/origin")
  awk -v figure="$1" -v layout="$layout" -v run="$2" -f scripts/auto.awk -f scripts/points.awk \
    "build/runs/$2/d.$2" "build/runs/$2/b.$2" >> "$points_table.new"
}

# Whether an oscillation is psi- or delta-shimmy: which angle is larger where
# the branch has its largest amplitude.
shimmy_of() { # RUN
  awk -f scripts/auto.awk -f scripts/shimmy.awk "build/runs/$1/d.$1" "build/runs/$1/b.$1"
}

end_table() {
  case $table in results/*) record ;; esac
  replace "$table"
  replace "$points_table"
}

# The figure's row of results/versions.csv: with what its runs were made, and the wall
# time they took one after the other.  It is written with the table, so runs that find
# the same table leave it as it is.
record() {
  local file=results/versions.csv
  if cmp -s "$table.new" "$table" && grep -q "^$figure," "$file" 2> /dev/null; then return; fi
  exec 7> build/tables/versions.lock
  flock 7
  {
    echo "# With what the runs of a figure were made when its table last changed; seconds: wall time of its AUTO runs, one"
    echo "# after the other, on a machine that may have had other work."
    echo figure,runs,seconds,AUTO,cc,gfortran,libc,gnuplot,system,processor
    {
      grep -v -e '^#' -e '^figure,' -e "^$figure," "$file" 2> /dev/null || true
      awk -F= -v figure="$figure" '
        $1 == "figure" { ours = $2 == figure }
        $1 == "ms" && ours { n++; ms += $2 }
        END { printf "%s,%d,%.1f,", figure, n, ms / 1000 }' build/runs/*/origin
      printf '%s,' "$(sed -n 's/^AUTO_VERSION = //p' build/auto.mk)" "$(${CC:-gcc} -dumpfullversion)" \
        "$(gfortran -dumpfullversion)" "$(getconf GNU_LIBC_VERSION)" \
        "$(gnuplot --version | awk '{ print $2 "." $4 }')" "$(. /etc/os-release && echo "$NAME $VERSION_ID")"
      uname -m
    } | sort
  } > "$file.new"
  mv "$file.new" "$file"
  exec 7>&-
}

replace() { # FILE: by FILE.new, unless they are the same
  use "$1"
  if cmp -s "$1.new" "$1"; then rm "$1.new"; else mv "$1.new" "$1"; fi
}

draw() { picture; }

picture() {
  local picture=results/$figure
  [ -s "$picture.csv" ] || fail "$figure: there is no $picture.csv to draw; scripts/$figure.sh tables makes it" 2
  rm -f "$picture".{png,svg,gif}.new
  LC_ALL=C.UTF-8 gnuplot -d -e "figure='$figure'" scripts/style.gp "scripts/$figure.gp"
  # on a full disk gnuplot ends with status 0
  if ! tail -c 12 "$picture.png.new" | grep -aq IEND || ! tail -c 12 "$picture.svg.new" | grep -q '</svg>'; then
    fail "$figure: gnuplot wrote half a picture, $picture.png or .svg (is the disk full?); those before are kept"
  fi
  replace "$picture.png"
  replace "$picture.svg"
  [ ! -f "$picture.gif.new" ] || replace "$picture.gif"
  echo "  results/$figure.png"
}

# From here on one script at a time writes the tables and pictures of NAME.
alone() { # NAME
  mkdir -p build/tables
  exec 8> "build/tables/$1.lock"
  flock 8
}

# What every figure script does with its arguments.
main() { # FIGURE [runs [PART] | tables | draw]
  figure=$1
  local part parts made
  export MLG_STARTED=${MLG_STARTED:-$EPOCHSECONDS} MLG_ASKED=${MLG_ASKED:-$figure}
  mapfile -t parts < <(declare -F | sed -n 's/^declare -f runs_//p')
  case ${2:-all} in
    runs)
      for part in "${@:3}"; do
        declare -F "runs_$part" > /dev/null || fail "$figure: no runs '$part'; there are ${parts[*]}" 2
      done
      [ $# -gt 2 ] || set -- "$figure" runs "${parts[@]}"
      build
      mkdir -p build/tables
      for part in "${@:3}"; do
        if is_made "$figure.$part"; then
          mapfile -t made < <(sed -n 's|.* build/runs/\(.*\)/stamp$|\1|p' "build/tables/$figure.$part.made")
          passed "${made[@]}"
          continue
        fi
        announce="$figure: $part, part $(printf '%s\n' "${parts[@]}" | grep -nx "$part" | cut -d : -f 1) of ${#parts[@]}"
        make_from "$figure.$part" "runs_$part" scripts/*.{sh,awk}
      done ;;
    tables)
      alone "$figure"
      if is_made "$figure.tables"; then return; fi
      make_from "$figure.tables" tables scripts/*.{sh,awk} ;;
    draw)
      alone "$figure"
      if is_made "$figure.draw"; then return; fi
      make_from "$figure.draw" draw scripts/*.{gp,awk} results/*.csv ;;
    all) main "$figure" runs; main "$figure" tables; scripts/collect.sh; main "$figure" draw ;;
    *) fail "usage: scripts/$figure.sh [runs [PART] | tables | draw]" 2 ;;
  esac
}
