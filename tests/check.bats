# check.bats - does scripts/check.sh find the known points, and see what moved?
#
# Needs   build/auto.mk, build/models, build/bin, tests/points.csv
# Writes  build/tests/check

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch check
  cp -p "$ROOT/tests/points.csv" tests
}

setup() { cd "$SCRATCH" || return; }

# some FILE PATTERN...: the rows of record that have the patterns
some() {
  local pattern
  sed -n '/^#/p; /^layout/p' tests/points.csv > "$1"
  for pattern in "${@:2}"; do grep -m 1 -e "$pattern" tests/points.csv >> "$1"; done
}

@test "the points of record are where they were, by AUTO and exactly" {
  run -0 scripts/check.sh
  [[ ${lines[-1]} == "all "*" values are as expected" ]]
  # types with an exact value have it
  [ "$(printf '%s\n' "${lines[@]}" | grep -cE '^(l1|l2|li1|li2) (HB|HH|LP|GH) .* pass$')" -ge 30 ]
  [ "$(printf '%s\n' "${lines[@]}" | grep -cE '^l1 (TR|UZ|LPC) .* -  .* pass$')" -ge 8 ]
  [ "$(printf '%s\n' "${lines[@]}" | grep -cE '^li1 GH .* a_5 .* pass$')" -eq 2 ]
  [ "$(printf '%s\n' "${lines[@]}" | grep -cE '^l1 (BP|ZH) .* pass$')" -eq 6 ]
  run ! grep -E ' (HB|HH|LP|GH|BP|ZH) .* -  ' < <(printf '%s\n' "${lines[@]}" | grep -v ' a_5 ')
}

@test "a constant changed in a constants file: AUTO's value moves, the exact one does not, the row is named" {
  some few.csv '^l1,HB,13.43' '^l1,LP,36.0'
  cp constants/c.l1.straight kept
  sed -i "s/'c_d': 3.6e4}/'c_d': 3.6e4, 'e': 0.121}/" constants/c.l1.straight
  run -1 scripts/check.sh few.csv # LP as well
  cp kept constants/c.l1.straight
  [[ ${lines[1]} == "l1 HB V=13.4308 c_d=36000 "*FAILS ]]
  read -r _ _ _ _ _ expected auto exact _ <<< "${lines[1]}"
  [[ ${lines[-1]} == "check: "*" values differ" ]]
  near "$exact" "$expected" 1e-8 "the exact V"
  run ! near "$auto" "$expected" 1e-6
  scripts/check.sh few.csv > /dev/null
}

@test "a flipped sign in a device is seen, and in which layout" {
  some few.csv '^l1,HB,13.43' '^l2,LP,11.6'
  objects
  sed -i 's/T_d - mlg_k_d/T_d + mlg_k_d/' models/l1.c
  grep -q 'T_d + mlg_k_d' models/l1.c
  made_by_make build/models/l1.exe > /dev/null
  run -1 scripts/check.sh few.csv
  cp -p "$ROOT"/models/l1.c models
  cp -p "$ROOT"/build/models/l1.exe build/models
  grep -q '^l1 HB V=13.4308 c_d=36000 .*FAILS$' <<< "$output"
  run ! grep -q '^l2 .*FAILS$' <<< "$output"
}

@test "runs are recorded, and pass" {
  auto_run own.straight l1.straight c_d=1e4 e=0.13 -- > /dev/null
  auto_run own.curve l1.hopf from=own.straight IRS="'HB1'" DS=-0.1 -- > /dev/null
  run -0 --separate-stderr scripts/check.sh record own.straight own.curve
  printf '%s\n' "$output" > own.csv
  grep -q '^l1,HB,.*,1e-6,e=0.13,own.straight$' own.csv
  grep -q '^l1,LP,.*,1e-6,e=0.13,own.curve$' own.csv
  scripts/check.sh own.csv
  # along another parameter: its value at each point is in the row
  auto_run own.stiffness l1.straight V=20 h=0.11 ICP="['k_delta', 'period', 'V', 'c_d', 'k_s', 'b']" THL="{'k_delta': 1e-12}" DS=-0.003 DSMAX=0.03 \
    UZSTOP="{'k_delta': 1.3e5}" -- HB=2 BP=1 > /dev/null
  run -0 --separate-stderr scripts/check.sh record own.stiffness
  printf '%s\n' "$output" > own.csv
  [ "$(grep -c '^l1,HB,20,.*,1e-6,k_delta=[0-9.]* h=0.11,own.stiffness$' own.csv)" -eq 2 ]
  grep -q '^l1,BP,20,.*,1e-6,k_delta=13370[0-9.]* h=0.11,own.stiffness$' own.csv
  scripts/check.sh own.csv
}

@test "a value that is off fails in its row alone" {
  some few.csv '^l1,HB,13.43' '^l1,HB,25.09'
  sed -i 's/25.09079031/25.0909/' few.csv
  run -1 --separate-stderr scripts/check.sh few.csv
  [[ ${lines[1]} == *pass && ${lines[2]} == "l1 HB V=25.0909"*FAILS ]]
  # shellcheck disable=SC2154 # of run
  [ "$stderr" = "check: 1 of 2 values differ" ]
}

@test "slips end with one line and status 2" {
  local row
  head -n 3 tests/points.csv > head.csv
  for row in 'l9,HB,1,1,,,,,,,,' 'l1,XX,1,1,,,,,,,,' 'l1,HB,fast,1,,,,,,,,' 'l1,HB,1,1,,,,,,,h=tall,' 'l1,BP,1,1,,,,,,,,' 'l1,ZH,1,1,,,,,,,e,'; do
    { cat head.csv && echo "$row"; } > slip.csv
    run -2 --separate-stderr scripts/check.sh slip.csv
    [[ $stderr == *"slip.csv: point 1"* ]]
  done
  run -2 scripts/check.sh head.csv
  [[ $output == *"has no points"* ]]
  run -2 scripts/check.sh nothing.csv
  [ "${#lines[@]}" -eq 1 ]
  run -2 scripts/check.sh record
  run -2 scripts/check.sh record nothing
  [ "${#lines[@]}" -eq 1 ]
}

# normal_form V C_D MODE COLUMN
normal_form() {
  build/bin/mlg unfolding l1 V="$1" c_d="$2" | awk -F, -v mode="$3" -v column="$4" '
    NR == 1 { for (k = 1; k <= NF; k++) if ($k == column) place = k }
    $1 == mode { print $place }'
}

@test "the normal form of a double Hopf point has the torus curves that AUTO follows" {
  local torus V c_d mode='' slope
  # the slopes from the point to the second and third orbit beside it in the table of Figure 7,
  # in a straight line to the point
  while read -r torus V c_d slope; do
    mode=1
    [ "$torus" = torus_psi ] || mode=2
    near "$(normal_form "$V" "$c_d" $mode torus_dV_dc_d)" "$slope" 0.01 "$torus at $V"
    [ "$(normal_form "$V" "$c_d" $mode unfolding)" = "simple I" ]
  done < <(awk -F, '
    BEGIN { at[24] = "24.83819403 32037.91103"; at[60] = "60.97764568 61882.60298" }
    { row[NR] = $0 }
    /^torus_.*,HH,/ { point[++n] = NR }
    END {
      for (k = 1; k <= n; k++) {
        split(row[point[k]], here, ",")
        split(at[int(here[4])], exact, " ")
        for (i = 2; i <= 3; i++) {
          split(row[point[k] + (k % 2 ? i : -i)], there, ",")
          away[i] = there[4] - exact[1]
          slope[i] = away[i] / (there[5] - exact[2])
        }
        print here[1], exact[1], exact[2], slope[2] + (slope[2] - slope[3]) * away[2] / (away[3] - away[2])
      }
    }' "$ROOT/results/fig07.csv")
  [ -n "$mode" ]
  # each of the two is the criticality of a Hopf point by itself
  near "$(normal_form 24.83819403 32037.91103 1 a_own)" \
    "$(echo 24.83819403,32037.91103,1e30,0,11.2 | build/bin/mlg criticality l1 | awk -F, 'END { print $5 }')" 1e-6
  run -1 build/bin/mlg unfolding l1 V=60 c_d=61882.6
  [[ $output == *"no double Hopf point"* ]]
}
