# new-runs.bats - can users make runs and figures of their own, and read them?
#
# The examples of docs/new-runs.md and README.md, run as they are written there.
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

# nearest V < speeds
nearest() {
  awk -v V="$1" 'NR == 1 || ($1 - V) ^ 2 < (best - V) ^ 2 { best = $1 } END { print best }'
}

# oracle LAYOUT V NAME=VALUE...: the speed of the Hopf point nearest to V, from eigenvalues
oracle() {
  "build/bin/eigen-$1" boundary free=V from="$(awk "BEGIN { print 0.99 * $2 }")" to="$(awk "BEGIN { print 1.01 * $2 }")" \
    step="$(awk "BEGIN { print 0.001 * $2 }")" "${@:3}" | awk 'NR > 1 { print $1 }' | nearest "$2"
}

## The guide

# example N: the Nth block of the guide, as it is written; the pictures are there
example() {
  examples docs/new-runs.md "$1" "${2:-$1}" >example.sh
  [ -s example.sh ]
  bash -eu example.sh >example.out 2>&1 || { cat example.out; return 1; }
  cat example.out
  [[ $(<example.out) != *[Ww]arning* ]]
}

largest() { # COLUMN TABLE
  awk -F, -v column="$1" '/^#/ { next } !n++ { for (k = 1; k <= NF; k++) if ($k == column) place = k; next }
    $place > most { most = $place } END { print most }' "$2"
}

is_picture() { # FILE
  [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] && [ "$(wc -c <"$1")" -gt 8000 ]
}

@test "example 1: a slice at another c_d" {
  example 1
  is_picture build/slice.png
  grep -q 'slice.delta .* closed' example.out
  paste -d' ' <(values slice.straight HB V) <(build/bin/eigen-l1 boundary free=V from=0.1 to=200 c_d=1e4 | awk 'NR > 1 { print $1 }') |
    near_each 1e-7 "V at c_d = 1e4"
  # the number in the text
  near "$(largest dstar_max build/slice.delta.csv)" 0.0125 0.01 "largest dstar_max"
}

@test "example 2: Hopf curves over speed and load" {
  local point way F_z
  example 2
  is_picture build/load.png
  for point in HB1 HB2; do
    for way in up down; do
      near "$(awk "BEGIN { printf \"%.11g\", ($(value load.$point.$way UZ M) + 500) * 9.81 }")" "$(value load.$point.$way UZ F_z)" 1e-9 "F_z at the end of load.$point.$way"
      near "$(value load.$point.$way UZ V)" "$(oracle l1 "$(value load.$point.$way UZ V)" c_d=3.6e4 M="$(value load.$point.$way UZ M)")" 1e-7 "V there"
    done
  done
  # the numbers in the text
  for F_z in 183:HB1 188:HB2; do
    near "$(values "load.${F_z#*:}.down" LP F_z)" "${F_z%:*}e3" 3e-3 "least F_z"
  done
}

@test "example 3: the stability diagram of one's own gear" {
  example 3
  is_picture build/mine.png
  [ "$(grep '^  no shimmy' example.out)" = "$(grep '^ *no shimmy' "$ROOT/docs/new-runs.md" | sed 's/^ */  /')" ]
  paste -d' ' <(build/bin/eigen-l1 interval V_lo=0.5 step=0.25 c_d_steps=60 l=0.33 k_psi=3.2e5 M=18000 | awk '$1 > 100.1 && $1 < 9.99e4 && $2 != "-" { print $1 }') \
    <(grep -m 1 '^  no shimmy' example.out | grep -oE '[0-9]{4,}\.[0-9]+') | near_each 1e-6 "end of the interval"
}

@test "a unit that is not that of the parameter" {
  printf "PAR = {'l': 330 mm}\n" >build/gear.bad
  run -2 scripts/run.sh a l1.straight gear=build/gear.bad
  [ "$output" = 'build/gear.bad:1: PAR: l is in mm here; it has to be in m' ]
  run -2 scripts/curves.sh l1 a gear=build/gear.bad
  [ "$output" = 'build/gear.bad:1: PAR: l is in mm here; it has to be in m' ]
  printf "PAR = {'k_t': 9e5 N/m, 'm_D':450\n kg, 'e': 0.1}\n" >build/gear.good
  scripts/run.sh a l1.straight gear=build/gear.good
  grep -qx "PAR = {'V': 1.0, 'c_d': 3.6e4, 'k_t': 9e5, 'm_D': 450, 'e': 0.1}" build/runs/a/c.a
}

@test "the runs in the guide's table of what to ask for" {
  scripts/run.sh slice.straight l1.straight c_d=1e4
  scripts/run.sh slice.delta l1.periodic from=slice.straight IRS="'HB1'"
  # shellcheck disable=SC2016 # code
  sed -n 's/^| \(a sweep\) | a loop: `\([^`]*\)`.* |$/\2/p' "$ROOT/docs/new-runs.md" >row.sh
  grep -q sweep row.sh
  bash -eu row.sh
  near "$(value sweep.0.16 HB V)" "$(oracle li1 "$(value sweep.0.16 HB V)" c_d=1e4 k_s=6.38e5 b=140 e=0.16)" 1e-7 "V at e = 0.16"
  # shellcheck disable=SC2016 # code
  sed -n 's/^| straight rolling along .*: `\(.*\)` |$/scripts\/run.sh along.phi l1.straight \1/p
    s/^| shimmy along .*: `\(.*\)` |$/scripts\/run.sh along.e l1.periodic \1/p' "$ROOT/docs/new-runs.md" >row.sh
  [ "$(wc -l <row.sh)" -eq 2 ]
  bash -eu row.sh
  near "$(value along.phi UZ phi)" -0.06 1e-7 phi
  near "$(value along.e UZ e)" 0.16 1e-7 e
  [ "$(value along.e UZ psi_max)" != 0.0000000000E+000 ]
}

@test "AUTO's own commands and Python interface, as the guide has them" {
  [ "$(sed -n 's/^AUTO_DIR = //p' build/auto.mk)" = build/auto ] || skip "AUTO is not in build/auto"
  [[ $ROOT != *[[:space:]]* ]] || skip "AUTO does not stand blanks in its path"
  objects
  unset MLG_BUILT
  example 4 5
  grep -q 'TR .* 3.07865E+01' example.out
  near "$(awk '/^largest/ { print $3 }' example.out)" 12.5086 1e-5 "largest delta*"
  near "$(largest dstar_max build/hand/shimmy.csv)" 0.0125086 1e-5 "the same in the table"
}

@test "the examples of README.md" {
  examples README.md >readme.sh
  [ -s readme.sh ]
  bash -eu readme.sh
}

## Parameters

# Name and default of each parameter of a layout that is not on an axis; k_s and b where
# its device has them; without those of laws (joints.bats) and doubts (doubts.bats)
parameters() { # LAYOUT
  awk -F'"' '/^#define MLG_RESULTS/ { exit }
    /^ *X\( *[0-9]/ && substr($1, index($1, "(") + 1) + 0 <= 36 && $2 !~ /^(V|c_d|k_s|b|phi|M)$/ { split($5, x, ","); print $2, x[2] }
    END { print "phi", 0.0524; print "M", 2e4 }' models/mlg.h
  case $1 in l1) ;; *) echo "k_s 1e6" ;; esac
  case $1 in l1 | l2) ;; *) echo "b 100" ;; esac
}

# Those that are tried: all with the paper's layouts, every fourth with another, other ones with each
tried() { # LAYOUT NUMBER
  case $1 in
    l1 | l2 | li1 | li2) parameters "$1" ;;
    *) parameters "$1" | awk -v number="$2" '(NR + number) % 4 == 0' ;;
  esac
}

@test "every parameter can be fixed and continued by its name, in every layout" {
  local layout case name value ends at V moved from to step word words n=0 number=0
  for layout in $(layouts); do
    number=$((number + 1))
    case="c_d=3.6e4 $(parameters "$layout" | sed -n 's/^\(k_s\|b\) /\1=/p' | xargs)"
    # shellcheck disable=SC2086 # words
    mlg run "every.$layout" "$layout.straight" $case STOP="['HB1']" -- HB=1 >every.out
    while read -r name value; do
      ends=$(awk "BEGIN { print 0.9 * $value \", \" 1.1 * $value }")
      mlg run "every.$layout.$name" "$layout.hopf" from="every.$layout" ICP="['$name', 'V', 'period']" \
        THL="{'$name': $(awk "BEGIN { print 1 / $value ^ 2 }")}" DS=0.02 DSMAX=0.05 \
        UZSTOP="{'$name': [$ends], 'V': [0.1, 200.0]}" -- UZ=1 >every.out
    done < <(tried "$layout" $number)
    while read -r name value; do
      read -r V at <<<"$(value "every.$layout.$name" UZ "V $name")"
      read -r moved from to step <<<"$(awk -v V="$V" -v at="$at" -v value="$value" \
        'BEGIN { print ((at - value) ^ 2 > (0.09 * value) ^ 2), 0.999 * V, 1.001 * V, 1e-4 * V }')"
      [ "$moved" -eq 1 ]
      # the parameter itself in place of the value it had
      read -ra words <<<" $case "
      for word in "${!words[@]}"; do case ${words[word]} in "$name"=*) unset "words[$word]" ;; esac; done
      words+=("$name=$at")
      "build/bin/eigen-$layout" boundary free=V from="$from" to="$to" step="$step" "${words[@]}" | awk 'NR > 1 { print $1 }' >speeds
      near "$V" "$(nearest "$V" <speeds)" 1e-7 "V of $layout along $name"
      mlg run fixed "$layout.straight" "${words[@]}" V="$from" DS=0.001 DSMAX=0.001 UZSTOP="{'V': $to}" -- >every.out
      near "$(values fixed HB V | nearest "$V")" "$V" 1e-7 "V of $layout with another $name"
      n=$((n + 1))
    done < <(tried "$layout" $number)
  done
  [ "$n" -ge $((4 * 25 - 3 + 6 * ($(layouts | wc -l) - 4))) ]
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
  # as many fields in each row, none of them empty but label, type and name; and stable
  # where it changes
  awk -F, '/^#/ { next } !n++ { wanted = NF } NF != wanted { exit 1 }
    n > 1 { for (k = $3 == "TR" || $1 == 1 ? 6 : 5; k <= NF; k++) if ($k !~ /[0-9]/) exit 1 }' psi.csv
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
  awk -F, -v rows="$(awk '$1 == "NTST" { n = $3 } $1 == "NCOL" { print n * $3 + 1 }' build/runs/psi/c.psi)" -v period="$(value psi UZ period 20)" -v psi_max="$(value psi UZ psi_max 20)" '
    function off(x, y, tolerance) { return x - y > tolerance || y - x > tolerance }
    NR < 4 { next }
    NR == 4 { for (k = 2; k <= NF; k++) first[k] = $k }
    NR > 4 { # the trapezium rule
      rise += ($5 + dpsi) / 2 * ($1 - t)
      if (off($4 - first[4], rise, 2e-3)) { print "psi and dpsi at t = " $1; exit wrong = 1 }
    }
    { t = $1; dpsi = $5; if ($4 > peak) peak = $4; for (k = 2; k <= NF; k++) last[k] = $k }
    END {
      if (wrong || NR != 3 + rows || off(t, period, 1e-9) || off(peak * 57.29578, psi_max, 0.01)) { print NR, t, peak; exit 1 }
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
  mkdir -p elsewhere
  cat build/runs/{straight/b.straight,psi/b.psi} >elsewhere/b.both
  run -2 --separate-stderr scripts/table.sh elsewhere/both
  # shellcheck disable=SC2154 # set by run
  [ "$stderr" = 'table: elsewhere/b.both holds branches of different columns; save them one by one' ]
  for words in '' 'straight solution' 'straight HB1' 'straight labels HB1'; do
    # shellcheck disable=SC2086 # words
    run -2 scripts/table.sh $words
    [ "$output" = 'usage: mlg table RUN [labels | solution NAME]' ]
  done
}
