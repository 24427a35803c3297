# shellcheck shell=bash
# boundary.sh - runs of the algebraic boundary problem (models/boundary.h); sourced after
# lib.sh by the scripts of Figures 10, 13 and 15 and of layouts.
#
# Where a curve begins, how many there are and what limits an interval comes from the
# exact algebra (mlg starts, limits); AUTO follows; mlg agree holds its points against the
# exact ones.
# shellcheck disable=SC2154 # variables of lib.sh

# Where curves are looked for that are followed from no other place: 1e5/k_s. Those of the
# paper's figures, k_s from rigid to 2.9e5 N m/rad, and c_d from 10 to 1e6 N m s/rad.
compliances="0 0.02 0.05 0.1 0.15 0.2 0.25 0.3 0.34"

# All curves of boundary points of one layout and b over the compliance, both ways from
# every point that is on no curve yet.  build/tables/curves.LAYOUT.bB lists their runs.
boundary_curves() { # LAYOUT B [gear=FILE] [KEY=VALUE ...]
  local layout=$1 b=$2 compliance start way word n=0 curves=() gear=()
  shift 2
  for word; do case $word in [A-Z][A-Z]*=*) ;; *) gear+=("$word") ;; esac; done # AUTO's constants are for AUTO alone
  for compliance in $compliances; do
    while start=$(mlg starts "$layout" b="$b" compliance="$compliance" "${gear[@]}" c_least=10 c_most=1e6 "${curves[@]}" | sed -n 1p) && [ -n "$start" ]; do
      n=$((n + 1))
      for way in up down; do
        [ "$way" = up ] || [ "$compliance" != 0 ] || continue
        curves+=("boundary.$layout.b$b.$n.$way")
        run "${curves[-1]}" boundary.point model="$layout.boundary" "$start" compliance="$compliance" b="$b" \
          DS="$([ $way = up ] && echo 0.002 || echo -0.002)" "$@" --
      done
    done
  done
  printf '%s\n' "${curves[@]}" > "build/tables/curves.$layout.b$b"
}

# A run from a boundary point, U={...}, to the one of the damping ratio ZETA: its UZ.
# zeta is weighted like logc, so that a step moves both.
to_damping_ratio() { # RUN LAYOUT U ZETA [PARAMETER=VALUE ...]
  run "$1" boundary.point model="$2.boundary" "$3" "${@:5}" \
    ICP="['zeta', 'V_1', 'c_1', 'f_1', 'ratio_1', 'compliance']" THL="{'zeta': 1e6}" DS=1e-4 DSMAX=2e-3 \
    UZSTOP="{'zeta': $4}" -- UZ=1
}

# The widest interval over k_s, followed in b: a run $figure.width.PREFIXn for each
# stretch of b with one limit (mlg limits), to where the event that ends it passes zero, or
# to where another interval becomes the wider or another limit is met; there that one is
# followed back, as is one before which there is none, to a width of 100.  Runs report the
# multiples of 10, and where the width is largest.
follow_widths() { # LAYOUT [PREFIX]
  local layout=$1 prefix=$figure.width.${2:-} number from to at peak limit constants event start settings stop back='' ended=0
  made "stretches.$layout" build/bin/mlg -- build/bin/mlg limits "$layout" stretches tolerance=0.02
  : > "build/tables/widths.$layout"
  while IFS=, read -r number from to at peak limit constants event start; do
    [[ $number =~ ^[0-9]+$ ]] || continue
    [ "$from" = "$ended" ] || back="'width': 100.0" # there was no interval before
    ended=$to
    [ -n "$constants" ] || continue
    start=${start#\"} start=${start%\"}
    settings=("$constants" model="$layout.boundary" "$start" b="$at")
    case $limit in
      onset) settings+=(closing=0) ;;
      equal) settings+=(closing=1) ;;
      'equal above') settings+=(closing=3) ;;
      stationary) settings+=(closing=2 DSMAX=0.01) ;;
    esac
    if [ -n "$back" ]; then
      run "$prefix$number.back" "${settings[@]}" DS=-0.001 UZSTOP="{$back}" -- UZ=1
      echo "$prefix$number.back" >> "build/tables/widths.$layout"
      back=''
    fi
    case $event in
      b) stop="'b': $to" ;;
      wider) stop="'b': 300.0" settings+=(RL1="$to") back=$(awk "BEGIN { printf \"'b': %.3f\", $to + 5e-4 }") ;;
      *) stop="'b': 300.0, '$event': 0.0" ;;
    esac
    run "$prefix$number" "${settings[@]}" DS=0.001 UZSTOP="{$stop, 'width': 100.0}" \
      UZR="{'b': [$(seq -s ', ' 0 10 290)${peak:+, $peak}]}" --
    echo "$prefix$number" >> "build/tables/widths.$layout"
  done < "build/tables/stretches.$layout.csv"
}

# --- tables -------------------------------------------------------------------

# Opens results/FIGURE.csv for regions, and the figure's parts of
# boundary_points.csv and widths.csv; end_regions puts all in place.
begin_regions() {
  begin_table "results/$figure.csv" \
    "# Zero-shimmy intervals of c_d over V in 0..200 m/s, exact (mlg regions). b N m s^2/rad; k_s N m/rad (inf: rigid);" \
    "# c_lo, c_hi, width N m s/rad; V_lo, V_hi m/s, where the bounds are." \
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
  local curves
  [ -f "build/tables/curves.$2.b$3" ] || fail "$figure: the boundary points of $2 at b = $3 have not been made; scripts/$figure.sh runs makes them"
  mapfile -t curves < "build/tables/curves.$2.b$3"
  mlg agree "$2" b="$3" "${curves[@]}" > /dev/null || exit $?
  mlg rows "${curves[@]}" prefix="$2,$3" columns=curve,bp,type,k_s:.8g,c_1:.8g,V_1,f_1:.7g,extremum,shimmy every=2 phase=1 types=LP,UZ keep=any \
    >> "$boundary_table.new"
  points "$1,$2" "${curves[@]}" ${asked:+uz=compliance="$asked"}
  mlg regions "$2" b="$3" | sed '/^#/d; /^layout/d' >> "$table.new"
}

# Rows of widths.csv from the runs in b, each an interval without shimmy.
width_rows() { # LAYOUT
  local runs
  mapfile -t runs < "build/tables/widths.$1"
  mlg agree "$1" "${runs[@]}" > /dev/null || exit $?
  mlg widths "${runs[@]}" prefix="$1" | sort -t , -k 2,2g -u >> "$widths_table.new"
}

# A row of widths.csv for a b at which no k_s has a zero-shimmy interval.
no_interval() { # LAYOUT B
  mlg widest "$1" b="$2" | grep -q ',no interval at any k_s$' || fail "widths of $1: at b = $2 there is an interval"
  echo "$1,$2,,,,0,,,,,no interval at any k_s" >> "$widths_table.new"
}
