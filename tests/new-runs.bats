# new-runs.bats - can users make runs and figures of their own, and read them?
#
# Every parameter, fixed and continued by its name in every layout, against
# eigenvalues; tables of a branch and of a solution (scripts/table.sh), against
# AUTO's files.
#
# Needs   the models and build/bin/eigen-LAYOUT (make test-programs)
# Writes  build/tests/new-runs

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch new-runs
  auto_run straight l1.straight -- HB=4
  auto_run psi l1.periodic from=straight -- TR=1 closed=1
}

setup() {
  cd "$SCRATCH" || return
}

# cell TABLE NAME COLUMN: of the row that has this name
cell() {
  awk -F, -v name="$2" -v column="$3" '
    /^#/ { next }
    !n++ { for (k = 1; k <= NF; k++) place[$k] = k; next }
    $place["name"] == name { print $place[column] }' "$1"
}

## Parameters

layouts() {
  grep -l '^#include "plugin.h"' models/*.c | sed 's|.*/||; s|\.c$||'
}

# Name and default of each parameter that is not on an axis; k_s and b as in a device
parameters() {
  awk -F'"' '/^#define MLG_RESULTS/ { exit }
    /^ *X\( *[0-9]/ && $2 !~ /^(V|c_d|k_s|b|phi|M)$/ { split($5, x, ","); print $2, x[2] }
    END { print "k_s", 1e6; print "b", 100; print "phi", 0.0524; print "M", 2e4 }' models/mlg.h
}

# nearest V < speeds
nearest() {
  awk -v V="$1" 'NR == 1 || ($1 - V) ^ 2 < (best - V) ^ 2 { best = $1 } END { print best }'
}

# oracle LAYOUT V NAME=VALUE...: the speed of the Hopf point nearest to V, from eigenvalues
oracle() {
  "build/bin/eigen-$1" boundary free=V from="$(awk "BEGIN { print 0.99 * $2 }")" to="$(awk "BEGIN { print 1.01 * $2 }")" \
    step="$(awk "BEGIN { print 0.001 * $2 }")" "${@:3}" | awk 'NR > 1 { print $1 }' | nearest "$2"
}

@test "every parameter can be fixed and continued by its name, in every layout" {
  local layout case="c_d=3.6e4 k_s=1e6 b=100" name value at V n=0
  for layout in $(layouts); do
    # shellcheck disable=SC2016,SC2086 # a script of its own; words
    parameters | bash -c '. scripts/lib.sh
      layout=$1
      run "every.$layout" "$layout.straight" "${@:2}" STOP="[\"HB1\"]" -- HB=1
      while read -r name value; do
        ends=$(awk "BEGIN { print 0.9 * $value \", \" 1.1 * $value }")
        run "every.$layout.$name" "$layout.hopf" from="every.$layout" ICP="[\"$name\", \"V\", \"period\"]" \
          THL="{\"$name\": $(awk "BEGIN { print 1 / $value ^ 2 }")}" DS=0.02 DSMAX=0.05 \
          UZSTOP="{\"$name\": [$ends], \"V\": [0.1, 200.0]}" -- UZ=1
      done' every "$layout" $case >every.out
    while read -r name value; do
      V=$(value "every.$layout.$name" UZ V)
      at=$(value "every.$layout.$name" UZ "$name")
      awk "BEGIN { exit !(($at - $value) ^ 2 > (0.09 * $value) ^ 2) }"
      # shellcheck disable=SC2086 # words
      {
        near "$V" "$(oracle "$layout" "$V" $case "$name=$at")" 1e-7 "V of $layout along $name"
        auto_run fixed "$layout.straight" $case "$name=$at" V="$(awk "BEGIN { print 0.999 * $V }")" DS=0.001 DSMAX=0.001 \
          UZSTOP="{'V': $(awk "BEGIN { print 1.001 * $V }")}" -- >every.out
      }
      near "$(values fixed HB V | nearest "$V")" "$V" 1e-7 "V of $layout with another $name"
      n=$((n + 1))
    done < <(parameters)
  done
  [ "$n" -eq $((25 * $(layouts | wc -l))) ]
}

## Tables

@test "the table of a branch has AUTO's points, columns and stability" {
  local column
  scripts/table.sh psi >psi.csv
  [ "$(grep -c '^#' psi.csv)" -eq 1 ]
  [[ $(head -n 1 psi.csv) == *'V m/s; '*'c_d N m s/rad; '*'psi_max deg; dstar_max m; '* ]]
  [ "$(sed -n 2p psi.csv)" = point,label,type,name,stable,V,L2-NORM,period,c_d,k_s,b,psi_max,dstar_max,torus,l_delta ]
  for column in V period c_d psi_max dstar_max; do
    near "$(cell psi.csv TR1 "$column")" "$(value psi TR "$column")" 1e-10 "$column of TR1"
    near "$(cell psi.csv UZ1 "$column")" "$(value psi UZ "$column" 20)" 1e-6 "$column of UZ1"
  done
  [ "$(cell psi.csv UZ1 stable)" = 1 ]
  [ "$(cell psi.csv UZ3 stable)" = 0 ] # behind the torus point
  # as many fields in each row, none of them empty but label, type and name
  awk -F, '/^#/ { next } !n++ { wanted = NF } NF != wanted { exit 1 }
    n > 1 { for (k = 5; k <= NF; k++) if ($k !~ /[0-9]/) exit 1 }' psi.csv
}

@test "the labelled points are listed alone, with the names that IRS takes" {
  [ "$(scripts/table.sh straight labels | cut -d, -f4 | tail -n +3 | xargs)" = 'EP1 HB1 HB2 HB3 HB4 UZ1' ]
  auto_run from-HB3 l1.hopf from=straight IRS="'HB3'" NMX=2 -- EP=1
  near "$(scripts/table.sh from-HB3 | awk -F, 'NR == 2 { for (k = 1; k <= NF; k++) if ($k == "V") v = k } NR == 3 { print $v }')" \
    "$(cell <(scripts/table.sh straight) HB3 V)" 1e-9 "V where the run from HB3 starts"
}

@test "the table of a solution is an orbit: closed, of that period and peak, psi' = dpsi" {
  scripts/table.sh psi solution UZ1 >orbit.csv
  [[ $(head -n 1 orbit.csv) == '# V = 20'*' m/s, c_d = 36000 N m s/rad, '*'phi = 0.0523'*' rad, '* ]]
  [ "$(sed -n 2p orbit.csv)" = '# t s; delta rad; ddelta rad/s; psi rad; dpsi rad/s; lambda_L m; lambda_R m; eps rad' ]
  [ "$(sed -n 3p orbit.csv)" = t,delta,ddelta,psi,dpsi,lambda_L,lambda_R,eps ]
  awk -F, -v period="$(value psi UZ period 20)" -v psi_max="$(value psi UZ psi_max 20)" '
    function off(x, y, tolerance) { return x - y > tolerance || y - x > tolerance }
    NR < 4 { next }
    NR == 4 { for (k = 2; k <= NF; k++) first[k] = $k }
    NR > 4 { # the trapezium rule
      rise += ($5 + dpsi) / 2 * ($1 - t)
      if (off($4 - first[4], rise, 1e-3)) { print "psi and dpsi at t = " $1; exit wrong = 1 }
    }
    { t = $1; dpsi = $5; if ($4 > peak) peak = $4; for (k = 2; k <= NF; k++) last[k] = $k }
    END {
      if (wrong || NR != 3 + 81 || off(t, period, 1e-9) || off(peak * 57.29578, psi_max, 0.01)) { print NR, t, peak; exit 1 }
      for (k in first) if (off(first[k], last[k], 1e-6)) { print "column " k " does not close"; exit 1 }
    }' orbit.csv
  # by AUTO's label, and from files that lie elsewhere
  mkdir -p elsewhere
  cp build/runs/psi/[bsd].psi elsewhere
  scripts/table.sh elsewhere/psi solution "$(cell <(scripts/table.sh psi) UZ1 label)" | diff orbit.csv -
}

@test "a straight solution is one row, a torus curve has its states only" {
  [ "$(scripts/table.sh straight solution HB1 | tail -n 1)" = 0,0,0,0,0,0,0,0 ]
  auto_run start l1.torus_start from=psi -- EP=1
  scripts/table.sh start solution EP1 >start.csv
  [ "$(sed -n 3p start.csv)" = t,delta,ddelta,psi,dpsi,lambda_L,lambda_R,eps ]
  [ "$(awk -F, 'NR > 2 { print NF }' start.csv | sort -u)" = 8 ]
  # its stability says nothing, and is not given
  [ -z "$(cell <(scripts/table.sh start) EP1 stable)" ]
}

@test "no such run, solution or word: one line, status 2" {
  run -2 scripts/table.sh none
  [ "$output" = "table: there is no run 'none', no build/runs/none/b.none" ]
  run -2 scripts/table.sh straight solution HB5
  [ "$output" = "table: there is no solution 'HB5'; there are EP1 HB1 HB2 HB3 HB4 UZ1" ]
  cat build/runs/{straight/b.straight,psi/b.psi} >elsewhere/b.both
  run -2 --separate-stderr scripts/table.sh elsewhere/both
  # shellcheck disable=SC2154 # set by run
  [ "$stderr" = 'table: elsewhere/b.both holds branches of different columns; save them one by one' ]
  for words in '' 'straight solution' 'straight HB1' 'straight labels HB1'; do
    # shellcheck disable=SC2086 # words
    run -2 scripts/table.sh $words
    [ "$output" = 'usage: scripts/table.sh RUN [labels | solution NAME]' ]
  done
}
