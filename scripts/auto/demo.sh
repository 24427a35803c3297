# shellcheck shell=bash
# demo.sh - how runs become a demo of AUTO's own kind; sourced after lib.sh by
# auto-demo.sh.
#
# What a run is stands in build/runs/RUN: all its constants in c.RUN, in origin its
# layout, its model and the constants file it was made from; what it found in AUTO's
# files, read by mlg.
# shellcheck disable=SC2154 # demo, part: of auto-demo.sh

runs=()                                                 # in the order of dependency
# shellcheck disable=SC2034 # stable_end: demo-plot.sh
declare -A equation start irs ipsw icp about closing ends stable_end # of each run

# All runs that these need, each behind the one it starts from.
order() { # RUN...
  local run
  for run; do
    [ -z "${equation[$run]:-}" ] || continue
    read_run "$run"
    [ -z "${start[$run]}" ] || order "${start[$run]}"
    runs+=("$run")
  done
}

read_run() { # RUN
  local file=build/runs/$1/c.$1 line words layout model constants='' ips='' isw='' handed=''
  check_name "$1"
  [ -f "$file" ] || fail "auto-demo: there is no run $1 in build/runs" 2
  start[$1]='' irs[$1]=0
  while IFS= read -r line; do
    case $line in
      "s = "*) line=${line#*\'} start[$1]=${line%\'} ;;
      "IRS = "*) line=${line#*= } irs[$1]=${line//\'/} ;;
      "ICP = "*) line=${line//[][,\']/ } && read -r words <<< "${line#*=}" && icp[$1]=$words ;;
      "IPS = "*) ips=${line#*= } ;;
      "ISW = "*) isw=${line#*= } ;;
    esac
  done < "$file"
  ipsw[$1]="$ips $isw"
  while IFS='=' read -r line words; do
    case $line in layout) layout=$words ;; model) model=$words ;; constants) constants=$words ;; words) handed=$words ;; esac
  done < "build/runs/$1/origin"
  equation[$1]=${model/./_}
  handed=$(sed "s/IRS='[^']*' *//; s/ *$//" <<< "$handed")
  about[$1]=$(head_of "$constants" "$layout" | head -n 1)${handed:+ With $handed.}
}

# The comment at the head of a constants file: its first sentence, then the rest.
head_of() { # FILE LAYOUT
  local file=$1
  [ -f "$file" ] || return 0
  if [[ $(head -n 1 "$file") =~ ^"# "(constants/[^,]*)", made one" ]]; then file=${BASH_REMATCH[1]}; fi
  awk -v layout="${2^^}" '
    !/^#/ { exit }
    { sub(/^# */, ""); text = text (NR > 1 ? " " : "") $0 }
    END {
      gsub(/ \((docs|models)\/[a-z_0-9]*\.[a-z]*\)/, "", text)
      gsub(/layout L[0-9A-Z]*/, "layout " layout, text)
      if (match(text, /\. [A-Z]/)) text = substr(text, 1, RSTART) "\n" substr(text, RSTART + 2)
      print text
    }' "$file"
}

# Lines of at most 88 characters, each behind "# ".
comment() { fold -s -w 86 | sed 's/ *$//; s/^/# /'; }

# --- the files ----------------------------------------------------------------

write_demo() {
  local run
  cp LICENSE "$part"
  write_equations
  echo run,point,is,column,expected,tolerance > "$part/points.csv"
  for run in "${runs[@]}"; do
    expect "$run"
    close "$run"
    write_constants "$run"
  done
  write_python > "$part/$demo.auto"
  write_shell > "$part/$demo.sh"
  write_check > "$part/check.awk"
  [ ! -f "results/$demo.png" ] || cp "results/$demo.png" "$part/expected.png"
  write_plots
  write_readme > "$part/README.md"
}

# The layouts' files and all that they include, and the boundary problem around a device.
write_equations() {
  local name todo file
  for name in $(printf '%s\n' "${equation[@]}" | sort -u); do
    todo=("${name%_boundary}.c")
    if [[ $name == *_boundary ]]; then
      printf '%s\n' "/* $name.c - the algebraic problem of boundary.h around the device of ${todo[0]} */" \
        "#define MLG_BOUNDARY" "#include \"${todo[0]}\"" '#include "boundary.h"' '#include "unused.h"' > "$part/$name.c"
      todo+=(boundary.h unused.h)
    fi
    while [ ${#todo[@]} -gt 0 ]; do
      file=${todo[0]}
      todo=("${todo[@]:1}")
      if [ -f "models/$file" ] && [ ! -f "$part/$file" ]; then
        cp "models/$file" "$part"
        mapfile -t -O ${#todo[@]} todo < <(sed -n 's/^ *#include "\(.*\)"/\1/p' "models/$file")
      fi
    done
  done
}

# Rows of points.csv: the first two of ICP at every special point, of orbits the
# amplitude of psi too; not at the UZ on either side of a TR.
expect() { # RUN
  local run=$1 columns word list kind
  read -ra list <<< "${icp[$run]}"
  columns="${list[*]:0:2}"
  [[ ${ipsw[$run]} != "2 1" ]] || [[ " ${icp[$run]} " != *" psi_max "* ]] || columns+=" psi_max"
  kind=$columns
  [[ " ${icp[$run]} " != *" torus "* ]] || kind+=" torus"
  word=
  for list in $kind; do word+=,$list:.10g; done
  mlg rows "$run" only=HB,HH,ZH,TR,LP,BP,GH,UZ columns="name,type$word" |
    awk -F, -v run="$run" -v columns="$columns" '
      BEGIN { n = split(columns, name, " ") }
      $1 == "" { next }
      $1 ~ /^UZ/ && NF > 2 + n && $NF ^ 2 < 1e-6 { next }
      { for (k = 1; k <= n; k++) if ($(2 + k) != "")
          print run "," $1 "," ($2 == "" ? substr($1, 1, 2) : $2) "," name[k] "," $(2 + k) "," (k == 2 && $1 ~ /^LP/ ? 1e-5 : 1e-6) }' \
      >> "$part/points.csv"
}

# A branch of orbits that closes on a Hopf point: ends[RUN] is where, closing[RUN] where AUTO
# is to stop before it, or it would turn round or go on along the zero solution.  The
# square of the amplitude falls to zero in a straight line; it is stopped at an amplitude
# that no step can leap over and that AUTO still had an orbit beyond.
close() { # RUN
  local run=$1 x size=psi_max
  [[ ${ipsw[$run]} == "2 1" ]] && mlg judge "$run" | grep -qw closed || return 0
  read -r x _ <<< "${icp[$run]}"
  [ "$(mlg shimmy "$run")" = psi ] || size=dstar_max
  read -r closing["$run"] ends["$run"] stable_end["$run"] < <(mlg rows "$run" ends columns="type,$x:.10g,$size:.10g,stable:d" | awk -F, '
    function largest(p, q) { return p > q ? p : q }
    { x[NR] = $2; a[NR] = $3; stable[NR] = $4 }
    END {
      n = NR - 1
      size = largest(largest(a[n - 1] - a[n], a[n] - a[n - 1]), a[n - 2] - a[n - 1])
      size = largest(size, (a[n] + a[n - 1]) / 2)
      at = x[NR] + (x[n] - x[NR]) * (size / a[n]) ^ 2
      for (i = 2; i <= n; i++) crossed += (x[i] - at) * (x[i - 1] - at) < 0
      if (crossed > 1) at = 0
      printf "%.8g %.8g %d\n", at, x[NR], stable[n]
    }')
  [ "${closing[$run]}" != 0 ] || fail "auto-demo: $run passes the place where it closes more than once"
}

write_constants() { # RUN
  local run=$1 stop=${closing[$1]:-} x
  read -r x _ <<< "${icp[$run]}"
  {
    describe "$run"
    [ -z "$stop" ] || echo "The branch ends on the Hopf point at $x = ${ends[$run]}: AUTO is stopped shortly before it, at $stop." | comment
    awk -v x="$x" -v stop="$stop" '
      /^(s|sv) = / { next }
      /^UZSTOP = / && stop != "" {
        done = 1
        if (match($0, "\047" x "\047: *\\[")) $0 = substr($0, 1, RSTART + RLENGTH - 1) stop ", " substr($0, RSTART + RLENGTH)
        else if (match($0, "\047" x "\047: *[-+0-9.eE]+")) {
          value = substr($0, RSTART, RLENGTH)
          sub(/^.*: */, "", value)
          $0 = substr($0, 1, RSTART - 1) "\047" x "\047: [" stop ", " value "]" substr($0, RSTART + RLENGTH)
        } else sub(/}$/, (/\{ *}/ ? "" : ", ") "\047" x "\047: " stop "}")
      }
      { print }
      END { if (stop != "" && !done) print "UZSTOP = {\047" x "\047: " stop "}" }' "build/runs/$run/c.$run"
  } > "$part/c.${equation[$run]}.$run"
}

# What a run does and which points to expect, as a comment.
describe() { # RUN
  local run=$1 found
  found=$(awk -F, -v run="$run" '
    $1 == run && !seen[$2]++ { text = text (text == "" ? "" : "; ") $2 ($3 == substr($2, 1, 2) ? "" : " (" $3 ")") " at " $4 sprintf(" = %.6g", $5) }
    END { print text == "" ? "no special point" : text }' "$part/points.csv")
  {
    echo "$run: ${about[$run]:-a run of ${equation[$run]}.}"
    [ -z "${start[$run]}" ] || echo "From ${irs[$run]} of ${start[$run]}."
    echo "Expect $found."
  } | comment
}

variable() { # RUN: its name in Python
  local name=${1//[.+-]/_}
  case $name in [0-9]*) name=run_$name ;; esac
  echo "$name"
}

write_python() {
  local run irs_of
  cat << END
# $demo.auto - $demo, for AUTO-07p's Python interface:  auto $demo.auto
# README.md says more.
import os, sys

# AUTO rebuilds no program when only a header changed
for name in [$(printf '%s\n' "${equation[@]}" | sort -u | sed "s/.*/'&'/" | paste -sd ,)]:
    for ending in ['.o', '.exe']:
        if os.path.exists(name + ending):
            os.remove(name + ending)
# AUTO 0.9.2 reads solutions by numpy.bool, which numpy 1.24 and later lack
try:
    import numpy
    numpy.bool
except (ImportError, AttributeError):
    if 'numpy' in sys.modules:
        numpy.bool = bool
runs = {}
END
  for run in "${runs[@]}"; do
    echo
    describe "$run"
    irs_of=${irs[$run]}
    [[ $irs_of =~ ^[0-9]+$ ]] || irs_of="'$irs_of'"
    if [ -z "${start[$run]}" ]; then
      echo "$(variable "$run") = run(e='${equation[$run]}', c='${equation[$run]}.$run')"
    else
      echo "$(variable "$run") = run($(variable "${start[$run]}")($irs_of), e='${equation[$run]}', c='${equation[$run]}.$run')"
    fi
    echo "save($(variable "$run"), '$run')"
    echo "runs['$run'] = $(variable "$run")"
  done
  cat << 'END'

# Expected and found
failed = 0
print('%-28s %-5s %-9s %15s %15s %9s' % ('run', 'point', 'column', 'expected', 'found', 'relative'))
for line in open('points.csv').readlines()[1:]:
    name, point, kind, column, expected, tolerance = line.strip().split(',')
    expected = float(expected)
    try:
        found = runs[name](point)[column]
        difference = abs(found - expected) / max(abs(expected), 1e-9)
        passed = difference <= float(tolerance)
        text = '%15.9g %9.1e' % (found, difference)
    except Exception:
        passed, text = False, '%15s %9s' % ('none', '')
    failed += not passed
    print('%-28s %-5s %-9s %15.9g %s%s' % (name, point, column, expected, text, '' if passed else '  differs'))
print('%d of the values differ' % failed if failed else 'all values are as expected')
sys.stdout.flush()
if failed:
    os._exit(1)
END
}

write_shell() {
  local run
  cat << END
#!/bin/sh
# $demo.sh - $demo by AUTO-07p's shell commands:  AUTO_DIR=/path/of/auto sh $demo.sh
# README.md says more.
[ -r "\${AUTO_DIR:-/nowhere}/cmds/cmds.make" ] || [ -r "\${AUTO_DIR:-/nowhere}/cmds.make" ] ||
  { echo "say where AUTO-07p is: AUTO_DIR=/path/of/auto sh \$0" >&2; exit 2; }
cd "\$(dirname "\$0")" || exit
# AUTO does not stand blanks in AUTO_DIR
case \$AUTO_DIR in *' '*)
  link=\$(mktemp -d) && ln -s "\$AUTO_DIR" "\$link/auto" && AUTO_DIR=\$link/auto
  trap 'rm -r "\$link"' EXIT ;;
esac
export AUTO_DIR OMP_NUM_THREADS=1 PATH="\$AUTO_DIR/cmds:\$AUTO_DIR/bin:\$PATH"
unset MAKEFLAGS MFLAGS MAKELEVEL
# AUTO rebuilds no program when only a header changed, and runs an old one after an error
rm -f -- *.o *.exe
END
  for run in "${runs[@]}"; do
    echo
    describe "$run"
    echo "@r ${equation[$run]} $run${start[$run]:+ ${start[$run]}}"
    [ "$run" != "${runs[0]}" ] || echo "[ -x ${equation[$run]}.exe ] || { echo \"${equation[$run]}.c was not compiled\" >&2; exit 1; }"
    echo "@sv $run"
  done
  printf '\n%s\n' "# Expected and found" "LC_ALL=C awk -f check.awk points.csv"
}

write_check() {
  cat << 'CHECK'
# check.awk - the points of points.csv, expected and found in AUTO's files b.RUN
BEGIN { FS = ","; split("BP LP HB  LP BP PD TR EP", ahead, / /) }
FNR == 1 {
  printf "%-28s %-5s %-9s %15s %15s %9s\n", "run", "point", "column", "expected", "found", "relative"
  next
}
{
  if (!($1 in read)) look($1)
  found = value[$1, $2, $4]
  size = $5 < 0 ? -$5 : $5
  if (size < 1e-9) size = 1e-9
  difference = found == "" ? 1 : (found - $5) / size
  if (difference < 0) difference = -difference
  bad = found == "" || difference > $6
  failed += bad
  printf "%-28s %-5s %-9s %15.9g ", $1, $2, $4, $5
  if (found == "") printf "%15s %9s", "none", ""
  else printf "%15.9g %9.1e", found, difference
  print bad ? "  differs" : ""
}
END {
  print failed ? failed " of the values differ" : "all values are as expected"
  exit failed > 0
}

# All points with a label of one run
function look(run,   file, line, field, name, n, k, type, count) {
  read[run] = 1
  file = "b." run
  while ((getline line < file) > 0) {
    if (line ~ /^ +0 +PT +TY +LAB/) {
      n = 0
      for (k = 1; 19 * k < length(line); k++) {
        name[++n] = substr(line, 1 + 19 * k, 19)
        gsub(/ /, "", name[n])
      }
      continue
    }
    split(line, field, / +/)
    k = field[1] == "" ? 1 : 0
    if (field[1 + k] == 0 || field[4 + k] == 0) continue
    type = field[3 + k] % 10
    type = type == -4 ? "UZ" : type == -3 ? "ZH" : type > 0 ? ahead[type] : ""
    if (field[3 + k] == -32) type = "GH"
    count[type]++
    for (n in name) value[run, type count[type], name[n]] = field[4 + k + n]
  }
  close(file)
}
CHECK
}

write_readme() {
  local one=${runs[0]}
  cat << END
# $demo with AUTO-07p

A demo for AUTO-07p (0.9.2 or later) of the shimmy of an aircraft landing gear: all it wants
is in this folder. Y. Li, C. Howcroft, S. A. Neild and J. Z. Jiang, J. Sound Vib. 408 (2017)
234-251, [doi:10.1016/j.jsv.2017.07.028](https://doi.org/10.1016/j.jsv.2017.07.028).

    auto $demo.auto                          # by AUTO's Python interface
    AUTO_DIR=/path/of/auto sh $demo.sh       # the same by its shell commands

Either makes ${#runs[@]} runs, each with a comment that says what it does and which points
to expect, and ends with a table of expected and found; the status is 1 if one differs.

    gnuplot plot.gp                          # $demo.png
    python3 plot.py                          # the same, by matplotlib

END
  [ ! -f "$part/expected.png" ] || printf '%s\n\n' "![the picture to get](expected.png)" \
    "The picture to get; the scripts above draw the same curves more plainly."
  cat << END
| file | what it is |
|---|---|
$(for name in $(printf '%s\n' "${equation[@]}" | sort -u); do echo "| \`$name.c\` | equation file; its headers are beside it, \`mlg.h\` has the gear and the parameters |"; done)
| \`c.${equation[$one]}.$one\`, ... | constants, \`c.EQUATION.RUN\`: \`@r ${equation[$one]} $one\` |
| \`b.RUN\`, \`s.RUN\`, \`d.RUN\` | what AUTO makes |
| \`points.csv\`, \`check.awk\` | what is expected, and the comparison of the shell version |

A branch of orbits is stopped just before the Hopf point that it ends on, a curve of torus
points where the oscillation has nearly vanished, just before the double Hopf point; the
pictures go on to the points themselves.

Should something be in the way:

- \`AUTO_DIR\` must have no blank when the Python interface is used: make a link without one.
- \`SyntaxWarning\` of Python 3.12 or later comes from AUTO's own files and is harmless:
  \`PYTHONWARNINGS=ignore auto $demo.auto\` keeps it away.
- gcc 15 or later refuses AUTO's header unless the C is older: \`CFLAGS\` in
  \`\$AUTO_DIR/cmds/cmds.make\` wants \`-std=gnu11\`.
- After a change in a \`.h\` file delete \`*.o\` and \`*.exe\`: AUTO does not see it. The two
  scripts do so when they begin.
END
}
