# new-runs.bats - can users make runs and figures of their own, and read them?
#
# Tables of a branch and of a solution (scripts/table.sh), against AUTO's files.
#
# Needs   the models (make models)
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
