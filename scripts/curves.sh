#!/usr/bin/env bash
# curves.sh - every Hopf curve in the (V, c_d) plane at one k_s and b
#
#   scripts/curves.sh LAYOUT NAME [gear=FILE] [PARAMETER=VALUE ...]
#   scripts/curves.sh li1 plane k_s=6.38e5 b=140
#
# Sourced after lib.sh by the scripts of Figures 9, 12 and 14; by itself it makes
# the curves of a user's own values and gear, and tells where there is no shimmy.
# Needs:  curves-LAYOUT (scripts/curves.c), which says how many curves there are,
#         where one may start and where c_d has extrema; scan-LAYOUT to compare.
# Writes: build/tables/NAME.csv (curve, shimmy, type, V, c_d; type LP: an extremum
#         of c_d), runs NAME.1.start, NAME.1, NAME.2.start, ... in build/runs
# Expect: the number of curves, of closed ones and of extrema, and by how much c_d
#         of AUTO's differs from those of curves-LAYOUT: 1e-9 or so.  An extremum
#         that AUTO's curves lack, or have beside these, ends with one line.

# A short straight run across a Hopf point at speed V, which finds it as HB1.
hopf_start() { # NAME LAYOUT V REACH [PARAMETER=VALUE ...]
  local name=$1 layout=$2 settings
  mapfile -t settings < <(awk -v V="$3" -v reach="$4" 'BEGIN {
    printf "V=%.12g\nDS=%g\nDSMAX=%g\nUZSTOP={\047V\047: %.12g}\n", V - reach, reach / 4, reach / 4, V + reach }')
  shift 4
  run "$name" "$layout.straight" "$@" "${settings[@]}" -- HB=1 UZ=1 > /dev/null
}

# hopf_curves LAYOUT NAME [PARAMETER=VALUE ...]
# A curve takes two runs: a short straight one across its starting point, which
# finds the Hopf point there, then the curve, from edge to edge or once round.
hopf_curves() {
  local layout=$1 name=$2 started curves closed at
  local number way stop c_d V range step turns settings stops
  shift 2
  started=${EPOCHREALTIME/./}
  build
  mkdir -p build/tables
  "build/bin/curves-$layout" "$@" > "build/tables/$name.curves" || exit $?
  "build/bin/scan-$layout" points "$@" > "build/tables/$name.extrema" || exit $?
  use "build/bin/"{curves,scan}"-$layout" "build/tables/$name."{curves,extrema}
  while IFS=, read -r number _ _ c_d V way stop range step turns; do
    [ "$number" != curve ] || continue
    mapfile -t settings < <(awk -v range="$range" -v step="$step" -v way="$way" 'BEGIN {
      # so near that no other Hopf point disturbs the search for this one
      printf "%g\nDS=%g\nDSMAX=%g\n", (range < 1 ? range / 1000 : 0.001), way * (step < 0.1 ? step / 10 : 0.01), step }')
    hopf_start "$name.$number.start" "$layout" "$V" "${settings[0]}" "$@" c_d="$c_d"
    stops="'V': [0.1, 200.0], 'c_d': [10.0, 8e4]"
    # AUTO is to put a point on each extremum of c_d
    at=$(awk '{ gsub(/:[^ ]*/, ""); gsub(/ /, ", "); print }' <<< "$turns")
    run "$name.$number" "$layout.hopf" from="$name.$number.start" "$@" "${settings[@]:1}" \
      ILP=0 UZR="{${at:+'V': [$at]}}" UZSTOP="{$stops${stop:+, 'period': $stop}}" -- > /dev/null
  done < "build/tables/$name.curves"
  curves=$(($(wc -l < "build/tables/$name.curves") - 1))
  closed=$(grep -c ,closed, "build/tables/$name.curves" || true)
  report "$name" "$started" "$curves curves, $closed closed"
}

# The curves of NAME as rows PREFIX,curve,shimmy,type,V,c_d of the open table.
# Compares their extrema and adds a row to $table.check: name, curves, closed ones,
# extrema, largest relative difference.
curve_rows() { # PREFIX NAME
  local name=$2 files
  mapfile -t files < <(awk -F, -v prefix="$1" -v name="$name" 'NR > 1 {
    printf "prefix=%s%s,%s\nclosed_curve=%s\n", prefix, $1, $3, ($2 == "closed" ? "closed" : "")
    printf "build/runs/%s.%s/b.%s.%s\n", name, $1, name, $1 }' "build/tables/$name.curves")
  use "build/tables/$name."{curves,extrema} "build/runs/$name."*/b.*
  awk -v name="$name" -v check="$table.check" -f scripts/auto.awk -f scripts/curves.awk \
    "build/tables/$name.curves" "build/tables/$name.extrema" "${files[@]}" >> "$table.new"
}

# --- Figures 9, 12 and 14: panels of one b and several k_s ---------------------

# diagrams LAYOUT B K_S...: their curves; diagram_rows PANEL B K_S...: their rows.
diagrams() {
  local layout=$1 b=$2 k_s
  shift 2
  for k_s; do hopf_curves "$layout" "$figure.b$b.k$k_s" k_s="$k_s" b="$b"; done
}

diagram_rows() {
  local panel=$1 b=$2 k_s
  shift 2
  for k_s; do curve_rows "$panel,$b,$k_s," "$figure.b$b.k$k_s"; done
}

begin_diagrams() { # LINE [TABLE]
  begin_table "${2:-results/$figure.csv}" "$1" \
    "# curve: number at that b (N m s^2/rad) and k_s (N m/rad; 1e30 is infinite); shimmy: what it bounds, psi or delta;" \
    "# V m/s; c_d N m s/rad; type LP: boundary point, an extremum of c_d along the curve. V from 0.1 to 200, c_d from" \
    "# 10 to 8e4; a closed curve ends on its first point." \
    panel,b,k_s,curve,shimmy,type,V,c_d
  echo name,curves,closed,extrema,largest_difference > "$table.check"
}

end_diagrams() {
  end_table
  mv "$table.check" "build/tables/check.$figure.csv"
  use "build/tables/check.$figure.csv"
  awk -F, 'NR > 1 { n++; curves += $2; closed += $3; extrema += $4; if ($5 + 0 > worst) worst = $5 + 0 }
    END { printf "  %d diagrams, %d curves, %d closed; %d boundary points met to %.0e\n", n, curves, closed, extrema, worst }' \
    "build/tables/check.$figure.csv"
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
  . "$(dirname "$(realpath "$0")")/lib.sh"
  [ $# -ge 2 ] || fail "usage: scripts/curves.sh LAYOUT NAME [gear=FILE] [PARAMETER=VALUE ...]" 2
  layout=$1 name=$2
  shift 2
  values=()
  for word; do
    case $word in
      gear=*)
        build
        gear=$(gear_values "${word#gear=}") || exit $?
        mapfile -t -O "${#values[@]}" values <<< "$gear" ;;
      *) values+=("$word") ;;
    esac
  done
  set -- "${values[@]}"
  [ -f "models/$layout.c" ] || fail "curves: there is no models/$layout.c" 2
  check_name "$name"
  case " $*" in *" k_s="*) ;; *) set -- "$@" k_s=1e30 ;; esac
  case " $*" in *" b="*) ;; *) set -- "$@" b=0 ;; esac
  hopf_curves "$layout" "$name" "$@"
  table=build/tables/$name.csv
  : > "$table.check"
  printf '%s\n' "# Hopf curves of layout $layout: $*" "# V m/s, c_d N m s/rad; type: LP extremum of c_d" \
    curve,shimmy,type,V,c_d > "$table.new"
  curve_rows "" "$name"
  replace "$table"
  awk -F, -v table="$table" '{ printf "  %s curves, %s closed, %s extrema of c_d met to %s; rows in %s\n", $2, $3, $4, $5, table }' "$table.check"
  "build/bin/scan-$layout" intervals "$@" | awk -F, '
    NR > 1 { printf "  no shimmy from V = 0 to 200 m/s: c_d from %s to %s N m s/rad\n", $1, $2 }
    END { if (NR < 2) print "  no c_d is free of shimmy from V = 0 to 200 m/s" }'
fi
