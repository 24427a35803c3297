# shellcheck shell=bash
# boundary.sh - runs of the algebraic boundary problem (models/boundary.h);
# sourced after lib.sh by the scripts of Figures 10, 13 and 15.
# shellcheck disable=SC2154,SC2028 # variables of lib.sh; text for awk and AUTO

# The points of scan-LAYOUT at one compliance and b, without the edges, as
# "V c_d frequency extremum shimmy" a line, by rising c_d.
scan_points() { # LAYOUT COMPLIANCE B
  build
  "build/bin/scan-$1" points compliance="$2" b="$3" \
    | awk -F, 'NR > 1 && $4 != "edge" { print $2, $1, $3, $4, $5 }'
}

# U of the boundary problem from points "V c_d frequency" and more unknowns.
unknowns() { # "POINT" ... [NAME=VALUE ...]
  printf '%s\n' "$@" | awk '
    /=/ { split($0, pair, "="); text = text sprintf(", \047%s\047: %s", pair[1], pair[2]); next }
    { n++
      text = text sprintf("%s\047omega_%d\047: %.12g, \047speed_%d\047: %.12g, \047logc_%d\047: %.12g",
        n > 1 ? ", " : "", n, $3 * 2 * atan2(0, -1) / 10, n, $1 / 10, n, log($2) / log(10)) }
    END { print "U={" text "}" }'
}

# Those of the points that lie on no curve of the runs at that compliance.
unknown_points() { # COMPLIANCE "POINTS" RUN...
  local at=$1 points=$2 run files=()
  shift 2
  for run; do files+=("build/runs/$run/b.$run"); done
  points="$points" awk -v at="$at" -f scripts/auto.awk -f <(echo '
    function log10(x) { return log(x) / log(10) }
    BEGIN { n = split(ENVIRON["points"], candidate, "\n") }
    { k = value["compliance"]; c = log10(value["c_1"]); f = value["f_1"]
      if (FILENAME == file && (k - at) * (k_was - at) <= 0 && k != k_was) {
        t = (at - k_was) / (k - k_was)
        for (i = 1; i <= n; i++) {
          if (split(candidate[i], p, " ") < 3) continue
          if ((c_was + t * (c - c_was) - log10(p[2])) ^ 2 < 1e-5 && (f_was + t * (f - f_was) - p[3]) ^ 2 < 1e-3) found[i] = 1
        }
      }
      file = FILENAME; k_was = k; c_was = c; f_was = f }
    END { for (i = 1; i <= n; i++) if (!found[i] && candidate[i] != "") print candidate[i] }') "${files[@]}" < /dev/null
}

# All curves of boundary points of one layout and b over the compliance: from
# every point of a scan at several compliances that is on no curve yet, both
# ways.  build/runs/boundary.LAYOUT.bB.curves lists their runs.
boundary_curves() { # LAYOUT B [KEY=VALUE ...]
  local layout=$1 b=$2 compliance points point run n=0 curves=()
  local list=build/runs/boundary.$1.b$2.curves
  shift 2
  for compliance in 0 0.02 0.05 0.1 0.15 0.2 0.25 0.3 0.34; do
    points=$(scan_points "$layout" "$compliance" "$b")
    points=$(unknown_points "$compliance" "$points" "${curves[@]}")
    while [ -n "$points" ]; do
      point=${points%%$'\n'*}
      n=$((n + 1))
      for way in up down; do
        [ "$way" = up ] || [ "$compliance" != 0 ] || continue
        run=boundary.$layout.b$b.$n.$way
        run "$run" boundary.point model="$layout.boundary" "$(unknowns "$point")" \
          compliance="$compliance" b="$b" DS="$([ $way = up ] && echo 0.002 || echo -0.002)" "$@" --
        curves+=("$run")
      done
      points=$(unknown_points "$compliance" "${points#"$point"}" "${curves[@]}")
    done
  done
  printf '%s\n' "${curves[@]}" > "$list"
  use "build/bin/scan-$layout" "$list"
}

curves_of() { # LAYOUT B: the b. files of its curves
  local list="build/runs/boundary.$1.b$2.curves"
  [ -f "$list" ] || fail "$figure: the boundary points of $1 at b = $2 have not been made; scripts/$figure.sh runs makes them"
  sed 's|.*|build/runs/&/b.&|' "$list"
}

# A run from a boundary point, "V c_d frequency", to the one of the damping ratio ZETA:
# its UZ.  zeta is weighted like logc, so that a step moves both.
to_damping_ratio() { # RUN LAYOUT "POINT" ZETA [PARAMETER=VALUE ...]
  run "$1" boundary.point model="$2.boundary" "$(unknowns "$3")" "${@:5}" \
    ICP="['zeta', 'V_1', 'c_1', 'f_1', 'ratio_1', 'compliance']" THL="{'zeta': 1e6}" DS=1e-4 DSMAX=2e-3 \
    UZSTOP="{'zeta': $4}" -- UZ=1
}

# --- tables -------------------------------------------------------------------

# Opens results/FIGURE.csv for regions, and the figure's parts of
# boundary_points.csv and widths.csv; end_regions puts all in place.
begin_regions() {
  begin_table "results/$figure.csv" \
    "# Zero-shimmy intervals of c_d over V in 0..200 m/s. b N m s^2/rad; k_s N m/rad (inf: rigid); c_lo, c_hi," \
    "# width N m s/rad; V_lo, V_hi m/s, where the bounds are. From AUTO's curves, each row tested by Routh over V." \
    layout,b,k_s,c_lo,c_hi,V_lo,V_hi,width
  boundary_table=build/tables/boundary.$figure.csv
  widths_table=build/tables/widths.$figure.csv
  : > "$boundary_table.new"
  : > "$widths_table.new"
}

end_regions() {
  end_table
  replace "$boundary_table"
  replace "$widths_table"
}

# The curves of one layout and b: their rows, their special points, the regions.
boundary_points() { # FIGURE_NUMBER LAYOUT B
  local files
  mapfile -t files < <(curves_of "$2" "$3")
  use "build/bin/scan-$2" "build/runs/boundary.$2.b$3.curves" "${files[@]}"
  awk -v layout="$2" -v b="$3" -v every=2 -f scripts/auto.awk -f scripts/boundary.awk "${files[@]}" \
    >> "$boundary_table.new"
  awk -v figure="$1" -v layout="$2" -v b="$3" -f scripts/auto.awk -f <(echo '
    type == "LP" || (type == "UZ" && asked > 0 && (value["compliance"] - asked) ^ 2 < 1e-18) {
      run = FILENAME; sub(/.*\/b\./, "", run)
      printf "%s,%s,%s,%s,%.8g,%.8g,%.8g,%s,%.5f,,\n", figure, layout, run, type, value["V_1"], value["c_1"], 1e5 / value["compliance"], b, value["f_1"]
    }') asked="${asked:-0}" "${files[@]}" >> "$points_table.new"
  awk -f scripts/auto.awk -f <(echo '
    FILENAME != file { curve++; file = FILENAME }
    { printf "%d,%.14g,%.14g,%.14g,%.14g\n", curve, value["compliance"], value["c_1"], value["V_1"], value["f_1"] }') \
    "${files[@]}" | "build/bin/scan-$2" regions b="$3" \
    | awk -F, -v layout="$2" -v b="$3" 'NR > 1 { print layout "," b "," $2 "," $3 "," $4 "," $5 "," $6 "," $7 }' \
    >> "$table.new"
}

# The points "V c_d frequency" of one labelled solution of a run, one a line,
# then "kappa=..": TYPE=LP the first LP, TYPE=last the last solution.
solution() { # RUN TYPE
  awk -v want="$2" -f scripts/auto.awk -f <(echo '
    want == "last" || (type == want && !n) {
      n = 0
      for (i = 1; ("V_" i) in value; i++)
        place[++n] = sprintf("%.14g %.14g %.14g", value["V_" i], value["c_" i], value["f_" i])
      kappa = value["compliance"]; b = value["b"]
    }
    END { for (i = 1; i <= n; i++) print place[i]; printf "kappa=%.14g\nb=%.14g\n", kappa, b }') \
    "build/runs/$1/b.$1"
}

# --- the widest interval over k_s, in b --------------------------------------

# The run of boundary_curves on which the delta region is born that limits the
# interval from above in k_s: the onset with the largest k_s.
onset_of() { # LAYOUT B
  local files
  mapfile -t files < <(curves_of "$1" "$2")
  awk -f scripts/auto.awk -f <(echo '
    type == "LP" && value["ratio_1"] > 1 && (best == "" || value["compliance"] < best) { best = value["compliance"]; file = FILENAME }
    END { sub(/.*\/b\./, "", file); print file }') "${files[@]}"
}

# BP1 and BP3 at kappa=COMPLIANCE, as two lines.
low_and_high() { # LAYOUT B kappa=COMPLIANCE
  scan_points "$1" "${3#kappa=}" "$2" | awk '
    $4 == "max" && $5 == "psi" && $3 < 9 { low = $1 " " $2 " " $3 }
    $4 == "min" && $5 == "psi" && !high { high = $1 " " $2 " " $3 }
    END { print low; print high }'
}

# The top of the third psi region at kappa=COMPLIANCE.
third() { # LAYOUT B kappa=COMPLIANCE
  scan_points "$1" "${3#kappa=}" "$2" | awk '$4 == "max" && $5 == "psi" && $3 > 9 { print $1, $2, $3; exit }'
}

# Stops of a run in b: at the end of the range, and where a test passes zero.
stop_at() { # TEST: ZERO
  echo "UZSTOP={'b': 300.0, $1}"
}

# The b, to 0.001, from which on the second of two runs in b has the larger width.
equal_widths() { # RUN RUN
  awk -f scripts/auto.awk -f <(echo '
    { b = value["b"]; w = value["width"] }
    FILENAME == ARGV[1] {
      if (n && b < first_b[n]) turned = 1
      if (!turned) { first_b[++n] = b; first_w[n] = w }
      next
    }
    {
      for (i = 1; i < n && first_b[i + 1] < b; i++) ;
      if (i == n || b < first_b[1]) next
      other = first_w[i] + (first_w[i + 1] - first_w[i]) * (b - first_b[i]) / (first_b[i + 1] - first_b[i])
      gap = w - other
      if (seen++ && gap > 0 && gap_was <= 0) { printf "%.3f", b_was + (b - b_was) * gap_was / (gap_was - gap); exit }
      gap_was = gap; b_was = b
    }') "build/runs/$1/b.$1" "build/runs/$2/b.$2"
}

# The b, to 0.001, at which the width of a run in b is largest, by a parabola through
# AUTO's points.
peak_width() { # RUN
  awk -f scripts/auto.awk -f <(echo '
    { b[NR] = value["b"]; w[NR] = value["width"]; if (w[NR] > w[at]) at = NR; last = NR }
    END {
      for (i = 1; i <= last; i++) if (i in b) { x[++n] = b[i]; y[n] = w[i]; if (i == at) k = n }
      left = (y[k] - y[k - 1]) / (x[k] - x[k - 1]); right = (y[k + 1] - y[k]) / (x[k + 1] - x[k])
      printf "%.3f", (x[k - 1] + x[k] - left * (x[k + 1] - x[k - 1]) / (right - left)) / 2
    }') "build/runs/$1/b.$1"
}

# A run in b from points and unknowns; it reports the multiples of 10, and the b
# of reports=B.
widths() { # LAYOUT NUMBER CONSTANTS "POINT"... kappa=.. b=.. [KEY=VALUE ...]
  local layout=$1 name=$figure.width.$2 constants=$3 start=() settings=() reports=''
  shift 3
  while [ $# -gt 0 ]; do
    case $1 in
      kappa=*) start+=("$1") ;;
      reports=*) reports=", ${1#reports=}" ;;
      *=*) settings+=("$1") ;;
      *) start+=("$1") ;;
    esac
    shift
  done
  mapfile -t start < <(printf '%s\n' "${start[@]}")
  run "$name" "$constants" model="$layout.boundary" "$(unknowns "${start[@]}")" "${settings[@]}" \
    UZR="{'b': [$(seq -s ', ' 0 10 290)$reports]}" --
}

# The widest interval in b, as $figure.width.PREFIXn, from the curves at b = 0;
# limited in turn by (docs/boundary.md)
#  1 the onset of the delta region, until it is born below BP1,
#  2 BP2_u reaching BP1, until the interval above BP2_u is the wider,
#  3 the stationary width of that one, as long as it is wider than
#  4 BP2_u reaching BP1 again, until that is an onset again,
#  5 the onset, until the third psi region takes over from BP1,
#  6 the onset above the third psi region, until it is born below its top,
#  7 BP2_u reaching that top, until the region ends.
# Each run starts where the last one ended.  LAST is the last one, where a layout goes
# on otherwise; reports=B is for run 1.
follow_widths() { # LAYOUT [PREFIX] [LAST] [reports=B]
  local layout=$1 n=${2:-} last=${3:-7} at p equal
  at=$(onset_of "$layout" 0)
  mapfile -t p < <(solution "$at" LP)
  widths "$layout" "${n}1" boundary.width "${p[0]}" "$(low_and_high "$layout" 0 "${p[1]}")" "${p[1]}" b=0 "$(stop_at "'gap': 0.0")" "${@:4}"
  [ "$last" -gt 1 ] || return 0
  mapfile -t p < <(solution "$figure.width.${n}1" last)
  widths "$layout" "${n}2" boundary.width "${p[0]}" "${p[1]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=1 "$(stop_at "'slope_1': 0.0")"
  [ "$last" -gt 2 ] || return 0
  mapfile -t p < <(solution "$figure.width.${n}2" last)
  widths "$layout" "${n}3" boundary.width "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=2 DSMAX=0.01 "$(stop_at "'gap': 0.0")"
  mapfile -t p < <(solution "$figure.width.${n}3" last)
  # run 4 begins on the far side of the fold of run 3: first a look where it is the wider
  run "$figure.width.${n}equal" boundary.width model="$layout.boundary" "$(unknowns "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}")" \
    "${p[4]}" closing=1 DS=0.001 DSMAX=0.001 NMX=600 -- EP=1
  equal=$(equal_widths "$figure.width.${n}3" "$figure.width.${n}equal")
  widths "$layout" "${n}4" boundary.width "${p[1]}" "${p[0]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=1 DS=0.001 "$(stop_at "'fold': 0.0")" reports="$equal"
  mapfile -t p < <(solution "$figure.width.${n}4" last)
  widths "$layout" "${n}5" boundary.rival "${p[0]}" "$(third "$layout" "${p[4]#b=}" "${p[3]}")" "${p[1]}" "${p[2]}" "${p[3]}" "${p[4]}" "$(stop_at "'rival': 0.0")"
  mapfile -t p < <(solution "$figure.width.${n}5" last)
  widths "$layout" "${n}6" boundary.width "${p[0]}" "${p[1]}" "${p[3]}" "${p[4]}" "${p[5]}" "$(stop_at "'gap': 0.0")"
  mapfile -t p < <(solution "$figure.width.${n}6" last)
  widths "$layout" "${n}7" boundary.width "${p[0]}" "${p[1]}" "${p[2]}" "${p[3]}" "${p[4]}" closing=1 DSMAX=0.1 "$(stop_at "'width': 100.0")"
}

# Rows of widths.csv from runs in b: the multiples of 10 and the points where the
# limit changes hands.  Every interval is tested
# by Routh over V, a hair on the softer side of the onset that limits it.
width_rows() { # LAYOUT RUN...
  local layout=$1 run row b k_s c_lo c_hi
  shift
  use_run "$@"
  for run; do
    awk -v layout="$layout" -f scripts/auto.awk -f scripts/widths.awk "build/runs/$run/b.$run"
  done > "$widths_table.rows"
  while read -r row; do
    IFS=, read -r _ b k_s c_lo c_hi _ <<< "$row"
    "build/bin/scan-$layout" check "$c_lo" "$c_hi" b="$b" k_s="$(awk -v k="$k_s" 'BEGIN { printf "%.12g", k * (1 - 1e-7) }')" \
      || fail "widths of $layout, b = $b: ($c_lo, $c_hi) at k_s = $k_s is not a zero-shimmy interval"
    echo "$row"
  done < "$widths_table.rows" >> "$widths_table.new"
  rm "$widths_table.rows"
}

# A row of widths.csv for a b at which no k_s has a zero-shimmy interval.
no_interval() { # LAYOUT B
  local width
  width=$("build/bin/scan-$1" widest b="$2" | awk -F, 'NR == 2 { print $7 }')
  [ "$width" = 0 ] || fail "widths of $1: at b = $2 there is an interval of $width"
  echo "$1,$2,,,,0,,,,,no interval at any k_s" >> "$widths_table.new"
}
