# shellcheck shell=bash
# demo-plot.sh - the two scripts of a demo that plot what AUTO found, for gnuplot and
# for matplotlib; sourced by auto-demo.sh.
#
# Panels: the curves in the plane of two parameters where there are any, one panel for
# each layout and b, boundary points and widths likewise; else the branches, two panels
# for each straight run that they start from.
# shellcheck disable=SC2154 # of demo.sh and auto-demo.sh

declare -A kind # of each run: straight branch hopf start torus points widths

# Lines PANEL|RUN|STYLE|X|Y|X_END|Y_END, the place where the curve ends beyond its last
# point, if there is one.
pictures=

write_plots() {
  local run first second to curves=no
  for run in "${runs[@]}"; do
    kind[$run]=$(kind_of "$run")
    [[ ${kind[$run]} != [htpw]* ]] || curves=yes
  done
  for run in "${runs[@]}"; do
    read -r first second _ <<< "${icp[$run]}"
    case ${kind[$run]} in
      hopf) picture "Hopf and torus curves, $(panel_of "$run")" hopf "$second" "$first" '|' ;;
      torus) picture "Hopf and torus curves, $(panel_of "$run")" torus "$second" "$first" "$(double_hopf "$run" "$second" "$first")" ;;
      points) picture "boundary points, $(panel_of "$run")" hopf "$first" c_1 '|' ;;
      widths) picture "widest interval, ${equation[$run]%_boundary}" hopf "$first" width '|' ;;
      straight | branch)
        to="${ends[$run]:-}|${ends[$run]:+0}"
        if [ $curves = no ] && { [ "${kind[$run]}" = branch ] || used "$run"; }; then
          picture "$(root_of "$run"), psi" stability "$first" psi_max "$to"
          picture "$(root_of "$run"), delta*" stability "$first" dstar_max "$to"
        fi
        ;;
    esac
  done
  pictures=$(sort -sV -t '|' -k 1,1 <<< "${pictures%$'\n'}")
  mapfile -t panels < <(cut -d '|' -f 1 <<< "$pictures" | uniq)
  write_gnuplot > "$part/plot.gp"
  write_matplotlib > "$part/plot.py"
}

# AUTO writes the column of an ICP name as it is; a run without it has no picture.
picture() { # PANEL STYLE X Y X_END|Y_END, of $run
  [[ " ${icp[$run]} " != *" $3 "* ]] || [[ " ${icp[$run]} " != *" $4 "* ]] || pictures+="$1|$run|$2|$3|$4|$5"$'\n'
}

kind_of() { # RUN
  case "${equation[$1]} ${ipsw[$1]}" in
    *_boundary*) if [[ " ${icp[$1]} " == *" width "* ]]; then echo widths; else echo points; fi ;;
    *" 1 1") echo straight ;;
    *" 1 "*) echo hopf ;;
    *" 2 1") echo branch ;;
    *) if used "$1"; then echo start; else echo torus; fi ;;
  esac
}

# Whether a run along the same first parameter starts from this one.
used() { # RUN
  local other
  for other in "${runs[@]}"; do
    [ "${start[$other]}" != "$1" ] || [ "${icp[$other]%% *}" != "${icp[$1]%% *}" ] || return 0
  done
  return 1
}

root_of() { # RUN
  local run=$1
  while [ -n "${start[$run]}" ]; do run=${start[$run]}; done
  echo "$run"
}

panel_of() { # RUN: its layout and its b
  local root b
  root=$(root_of "$1")
  b=$(sed -n "s/^PAR = .*'b': \([-+.0-9e]*\).*/\1/p" "build/runs/$root/c.$root")
  echo "${equation[$1]%_boundary}, b = ${b:-0}"
}

# The double Hopf point that a torus curve ends beside, as X|Y.
double_hopf() { # RUN X Y
  awk -F, -v run="$1" -v x="$2" -v y="$3" '
    $1 == run && $4 == x { here_x = $5 }
    $1 == run && $4 == y { here_y = $5 }
    $3 == "HH" && $4 == x { at_x[$1, $2] = $5 }
    $3 == "HH" && $4 == y { at_y[$1, $2] = $5 }
    END {
      least = 1e-3
      for (i in at_x) if (here_x != "" && here_y != "" && (i in at_y)) {
        distance = (at_x[i] / here_x - 1) ^ 2 + (at_y[i] / here_y - 1) ^ 2
        if (distance < least) { least = distance; best = at_x[i] "|" at_y[i] }
      }
      print best == "" ? "|" : best
    }' "$part/points.csv"
}

# The places of columns in b.RUN, from 1 on.
columns_of() { # RUN NAME...
  awk -v names="${*:2}" '
    /^ +0 +PT +TY +LAB/ {
      for (k = 1; 19 * k < length($0); k++) {
        name = substr($0, 1 + 19 * k, 19)
        gsub(/ /, "", name)
        place[name] = 4 + k
      }
      n = split(names, want, " ")
      for (k = 1; k <= n; k++) printf "%d%s", place[want[k]], k < n ? " " : "\n"
      exit
    }' "build/runs/$1/b.$1"
}

write_gnuplot() {
  local rows=$(((${#panels[@]} + 1) / 2)) across=2 height panel run style x y to_x to_y at_x at_y head end
  if [ ${#panels[@]} = 1 ]; then across=1 height=800; else height=$((420 * rows)); fi
  cat << END
# plot.gp - $demo.png from AUTO's files b.RUN:  gnuplot plot.gp
if (strstrt(GPVAL_TERMINALS, 'pngcairo')) { set terminal pngcairo size 1200,$height } \\
else { set terminal png size 1200,$height }
set output '$demo.png'
set key off
set style line 1 lc rgb '#1f4fd8' lw 2            # stable
set style line 2 lc rgb '#d62728' lw 1.6 dt (6,4) # unstable
set style line 3 lc rgb '#d62728' lw 2            # Hopf curves, boundary points
set style line 4 lc rgb '#7b3fa0' lw 2 dt (10,4)  # torus curves
set style line 5 lc rgb '#000000' pt 7 ps 0.8     # special points
# the first number of a line is 0 at the head of AUTO's files, the second below 0 where
# all is stable, the third the type of a point: UZ is -4, EP 9
all(x) = \$1 == 0 ? NaN : x
stable(x) = \$1 != 0 && \$2 < 0 ? x : NaN
special(x) = \$1 != 0 && word('0 1 1 1 0 1 1 1 1 0', int(abs(\$3)) % 10 + 1) eq '1' ? x : NaN
set multiplot layout $rows,$across
END
  for panel in "${panels[@]}"; do
    head=
    while IFS='|' read -r _ run style x y to_x to_y; do
      read -r at_x at_y < <(columns_of "$run" "$x" "$y")
      if [ -z "$head" ]; then
        head="set title '$panel' noenhanced; set xlabel '$x' noenhanced; set ylabel '$y' noenhanced"
        case "$x $y" in "V c_d") head+="; set xrange [0:100]; set yrange [0:8e4]" ;; *c_1) head+="; set yrange [0:4e4]" ;; *) head+="; set autoscale" ;; esac
        printf '\n%s\nplot \\\n' "$head"
      fi
      end=1
      case $style in
        hopf) echo "  'b.$run' using (all(\$$at_x)):$at_y with lines ls 3, \\" ;;
        torus) echo "  'b.$run' using (all(\$$at_x)):$at_y with lines ls 4, \\" && end=4 ;;
        stability)
          echo "  'b.$run' using (all(\$$at_x)):$at_y with lines ls 2, \\"
          [ "${stable_end[$run]:-1}" = 1 ] || end=2
          echo "  'b.$run' using (stable(\$$at_x)):$at_y with lines ls 1, \\"
          ;;
      esac
      [ -z "$to_x" ] || echo "  \"< tail -n 1 'b.$run' | awk '{ print \$$at_x, \$$at_y; print $to_x, $to_y }'\" with lines ls $end, \\"
      echo "  'b.$run' using (special(\$$at_x)):$at_y with points ls 5, \\"
    done < <(grep -F "$panel|" <<< "$pictures")
    echo "  NaN"
  done
  echo "unset multiplot"
}

write_matplotlib() {
  local panel run style x y to_x to_y
  cat << END
# plot.py - $demo.png from AUTO's files b.RUN, by matplotlib:  python3 plot.py
import sys

try:
    import matplotlib
except ImportError:
    sys.exit('plot.py: this Python has no matplotlib; gnuplot plot.gp draws the same')
matplotlib.use('Agg')
import matplotlib.pyplot as plt

# panel, run, style, x, y, where the curve ends beyond its last point
pictures = [
END
  while IFS='|' read -r panel run style x y to_x to_y; do
    [ -z "$run" ] || echo "    ('$panel', '$run', '$style', '$x', '$y', [${to_x:+$to_x, $to_y}]),"
  done <<< "$pictures"
  cat << END
]


def read(run, x, y):
    """Rows of b.RUN as x, y, stable, type."""
    rows, names = [], []
    for line in open('b.' + run):
        field = line.split()
        if field[:4] == ['0', 'PT', 'TY', 'LAB']:
            names = [line[k:k + 19].strip() for k in range(19, len(line) - 1, 19)]
        elif field and field[0] != '0' and names:
            at = [float(field[4 + names.index(name)]) for name in (x, y)]
            rows.append((at[0], at[1], int(field[1]) < 0, int(field[2])))
    return rows


panels = []
for picture in pictures:
    if picture[0] not in panels:
        panels.append(picture[0])
across = 1 if len(panels) == 1 else 2
down = (len(panels) + across - 1) // across
figure, axes = plt.subplots(down, across, figsize=(12, 8 if down == 1 else 4.2 * down), squeeze=False)
for k in range(len(panels), down * across):
    axes[k // across][k % across].set_visible(False)
for panel, run, style, x, y, end in pictures:
    k = panels.index(panel)
    axis = axes[k // across][k % across]
    rows = read(run, x, y)
    at = [[row[i] for row in rows] for i in (0, 1)]
    if style == 'stability':
        axis.plot(at[0], at[1], '--', color='#d62728')
        axis.plot(at[0], [row[1] if row[2] else float('nan') for row in rows], '-', color='#1f4fd8')
    else:
        axis.plot(at[0], at[1], '-' if style == 'hopf' else '--', color='#d62728' if style == 'hopf' else '#7b3fa0')
    if end:
        stable = rows[-1][2] and style != 'torus'
        axis.plot([at[0][-1], end[0]], [at[1][-1], end[1]], '-' if stable else '--',
                  color='#7b3fa0' if style == 'torus' else '#1f4fd8' if stable else '#d62728')
    special = [row for row in rows if abs(row[3]) % 10 not in (0, 4, 9)]
    axis.plot([row[0] for row in special], [row[1] for row in special], 'k.')
    axis.set_title(panel)
    axis.set_xlabel(x)
    axis.set_ylabel(y)
    if (x, y) == ('V', 'c_d'):
        axis.set_xlim(0, 100)
        axis.set_ylim(0, 8e4)
    elif y == 'c_1':
        axis.set_ylim(0, 4e4)
figure.tight_layout()
figure.savefig('$demo.png', dpi=100)
END
}
