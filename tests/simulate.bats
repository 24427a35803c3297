# simulate.bats - is a simulation what its command says, and are slips refused?
#
# Known solutions, sections and restarts: test_integrate.c. Against AUTO:
# verify/integration.sh.
#
# Needs   the models and build/bin/mlg (make test-programs)
# Writes  build/tests/simulate

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch simulate
  cp -rp "$ROOT"/{docs,results} .
}

setup() {
  cd "$SCRATCH" || return
}

simulate() { # LAYOUT WORD...
  build/bin/mlg simulate "$@"
}

# numbers COLUMN... < CSV: these columns of all rows, by name
numbers() {
  awk -F, -v names="$*" '
    /^#/ { next }
    !n { n = split(names, name, " "); for (k = 1; k <= NF; k++) place[$k] = k; next }
    { for (k = 1; k <= n; k++) printf "%s%s", $place[name[k]], (k < n ? " " : "\n") }'
}

# refuses STATUS LINE LAYOUT WORD...
refuses() {
  run "-$1" --separate-stderr simulate "${@:3}"
  # shellcheck disable=SC2154 # set by run
  [ "$stderr" = "mlg simulate: $2" ] || { echo "$stderr" && return 1; }
}

@test "a history begins at its start and has a row every dt" {
  simulate li2 history V=40 b=100 k_s=1e6 psi=0.05 eps=-0.01 dchi=2 t_end=0.02 dt=0.004 >history.csv
  [[ $(head -n 1 history.csv) == '# V = 40 m/s, c_d = 36000 N m s/rad, k_s = 1000000 N m/rad, b = 100 '* ]]
  [ "$(sed -n 3p history.csv)" = t,delta,ddelta,psi,dpsi,lambda_L,lambda_R,eps,chi,dchi,dstar,T_d,event ]
  [ "$(numbers t psi eps dchi < history.csv | head -n 1)" = '0 0.05 -0.01 2' ]
  [ "$(numbers t < history.csv | xargs)" = '0 0.004 0.008 0.012 0.016 0.02' ]
  # T_d = k_psi (psi - eps - chi), delta* = l_delta delta
  numbers T_d psi eps chi < history.csv | awk '{ printf "%s %.12g\n", $1, 3.8e5 * ($2 - $3 - $4) }' | near_each 1e-8 T_d
  numbers dstar delta < history.csv | sed 1d | awk '{ printf "%s %.12g\n", $1, 0.75 * $2 }' | near_each 1e-9 'delta*'
}

@test "a mirrored start runs mirrored, through its limits" {
  simulate l1 history V=30 psi=0.3 lambda_L=0.02 t_end=0.5 dt=0.05 | numbers psi lambda_L eps event >one
  simulate l1 history V=30 psi=-0.3 lambda_R=-0.02 t_end=0.5 dt=0.05 | numbers psi lambda_R eps event >other
  [ "$(grep -c limit one)" -gt 1 ]
  paste -d ' ' one other | awk '{ for (k = 1; k <= 3; k++) printf "%s %.12g\n", $k, -$(NF / 2 + k) }' | near_each 1e-6 state
}

@test "a limit is a row of its own, at |lambda| = l tan(alpha_m)" {
  simulate l1 history V=40 psi=0.3 t_end=2 dt=0.01 >history.csv
  numbers event lambda_L lambda_R < history.csv | awk '
    $1 == "limit" { n++; l = 0.3 * sin(0.1745) / cos(0.1745); near = 0
      for (k = 2; k <= 3; k++) { x = $k < 0 ? -$k : $k; if (x - l < 1e-9 && l - x < 1e-9) near = 1 }
      if (!near) wrong = 1 }
    $1 != "limit" && NF == 3 { exit wrong = 1 }
    END { exit wrong || n < 2 || n % 2 }'
  # and where none is passed, there is none
  [ "$(simulate l1 history V=40 psi=0.01 t_end=2 dt=0.01 | grep -c limit)" -eq 0 ]
}

@test "a section is where the history has its maxima" {
  simulate l1 section dpsi down V=20 psi=0.05 t_end=1 >section.csv
  simulate l1 history V=20 psi=0.05 t_end=1 dt=0.0005 >history.csv
  numbers dpsi < section.csv | awk '$1 > 1e-8 || $1 < -1e-8 { exit 1 }'
  paste -d ' ' <(numbers psi < section.csv) \
    <(numbers psi < history.csv | awk 'NR > 2 && b > a && b >= $1 { print b } { a = b; b = $1 }') |
    near_each 2e-4 'maximum of psi'
  [ "$(simulate l1 section psi up V=20 psi=0.05 t_end=1 | numbers event | sort -u)" = section ]
}

@test "the orbit is one: started on it, it has closed after a period" {
  local start period
  simulate l1 orbit c_d=2e3 V=20 psi=0.05 >orbit.csv
  near "$(numbers psi_max < orbit.csv)" "$(mlg pick results/special_points.csv where=run=fig06.c.psi where=type=UZ columns=psi_max)" 1e-5 psi_max
  [ "$(numbers shimmy < orbit.csv)" = psi ]
  period=$(numbers period < orbit.csv)
  mapfile -t start < <(awk -F, 'NR == 3 { for (k = 10; k <= NF; k++) name[k] = $k } NR == 4 { for (k = 10; k <= NF; k++) print name[k] "=" $k }' orbit.csv)
  simulate l1 history c_d=2e3 V=20 "${start[@]}" t_end="$period" dt="$period" | numbers psi delta eps lambda_L >closed
  paste -d ' ' <(head -n 1 closed | xargs -n 1) <(tail -n 1 closed | xargs -n 1) | near_each 1e-5 'state after a period'
}

@test "past a torus point the gear goes over to the other orbit, as results/tori.csv says" {
  local row
  row=$(grep '^45000,32.8,delta,psi,' results/tori.csv)
  simulate l1 orbit c_d=4.5e4 V=32.8 delta=0.01 >orbit.csv
  near "$(numbers psi_max < orbit.csv)" "$(cut -d, -f5 <<<"$row")" 1e-5 psi_max
  near "$(numbers dstar_max < orbit.csv)" "$(cut -d, -f6 <<<"$row")" 1e-5 dstar_max
}

@test "layouts that coincide move alike: LI1 and LI2 at b = 0 as L2" {
  local layout
  for layout in l2 li1 li2; do
    simulate "$layout" history V=20 k_s=7e5 psi=0.05 t_end=0.5 dt=0.1 | numbers psi delta lambda_L | sed 1d >"in-$layout"
  done
  for layout in li1 li2; do
    paste -d ' ' <(xargs -n 1 <"in-$layout") <(xargs -n 1 <in-l2) | near_each 1e-4 "$layout, state"
  done
}

@test "growth is the eigenvalue" {
  read -r rate _ frequency < <(build/bin/eigen-li1 eigenvalues V=15 k_s=6e5 b=20 | sed 1d)
  simulate li1 growth V=15 k_s=6e5 b=20 psi=1e-7 t_end=3 >growth.csv
  near "$(numbers rate < growth.csv)" "$rate" 1e-4 rate
  near "$(numbers frequency_hz < growth.csv)" "$frequency" 1e-5 frequency
}

@test "the example of docs/simulate.md prints what it says" {
  awk '/^## /{ on = /Example/ } on && /^    / { print substr($0, 5); next } on && code && !/^ / { on = 2 }' docs/simulate.md >lines
  bash <(sed -n '1,/^done/p' lines) | diff - <(sed '1,/^done/d' lines)
}

@test "the picture of a history: one line makes it, a slip leaves it" {
  scripts/simulate.sh l1 mine V=40 psi=0.3 t_end=1
  [ "$(head -c 4 build/tables/mine.png | tail -c 3)" = PNG ]
  cp build/tables/mine.csv kept.csv
  run -2 scripts/simulate.sh l1 mine V=40 ps=0.3
  [ "$output" = "mlg simulate: 'ps=0.3': no such parameter (see models/mlg.h)" ]
  cmp build/tables/mine.csv kept.csv
  run -2 scripts/simulate.sh l9 mine psi=0.3
  [ "$output" = "simulate: there is no layout 'l9', no models/l9.c" ]
  run -2 scripts/simulate.sh l1 ../mine psi=0.3
  [ "$output" = "the name '../mine': letters, digits, . _ - and +, a letter or a digit first, at most 100" ]
}

@test "the picture has a dot for each tyre at each limit, and none elsewhere" {
  local start limits
  mkdir -p build/tables
  sed -i 's/^set terminal .*/set terminal svg/; s/\.png\.new/.svg/' scripts/pictures/simulate.gp
  for start in 0.3 0.01; do
    build/bin/mlg simulate l1 history V=40 psi=$start t_end=1 >build/tables/dots.csv
    limits=$(grep -c ',limit$' build/tables/dots.csv) || [ "$limits" -eq 0 ]
    run -0 env LC_ALL=C.UTF-8 gnuplot -d -e "figure='dots'" scripts/pictures/style.gp scripts/pictures/simulate.gp
    [ -z "$output" ] || { echo "$output" && return 1; }
    # one more in the key
    [ "$(grep -c "<use xlink:href='#gpPt6'" build/tables/dots.svg)" -eq $((limits ? 2 * limits + 1 : 0)) ]
  done
  cp "$ROOT/scripts/pictures/simulate.gp" scripts/pictures
}

@test "bad input: one line, status 2" {
  local usage='expected LAYOUT history|orbit|growth|section STATE up|down [NAME=VALUE ...]'
  refuses 2 "$usage" l1
  refuses 2 "$usage" l1 orbits psi=0.1
  refuses 2 "$usage" l1 section psi
  refuses 2 "$usage" l1 section psi sideways psi=0.1
  refuses 2 "'chi': no state of layout l1" l1 section chi up psi=0.1
  refuses 2 "'chi=0.1': no such parameter (see models/mlg.h)" l1 history chi=0.1
  refuses 2 "'psi=x': expected NAME=NUMBER" l1 history psi=x
  refuses 2 "'psi=nan': expected NAME=NUMBER" l1 history psi=nan
  refuses 2 "'V=-1': outside its range, 0 to 1000 m/s" l1 history psi=0.1 V=-1
  refuses 2 "'dt=0': outside its range, 1e-09 to 1e+09 s" l1 history psi=0.1 dt=0
  refuses 2 'delta=0 psi=2: an angle beyond pi/2' l1 history psi=2
  refuses 2 'the gear starts straight and stays so: give a state, as psi=0.05' l1 history V=20
}

@test "what does not end as asked says why: one line, status 1" {
  refuses 1 'fewer than 4 maxima of psi between t = 0.05 and 0.1 s' l1 growth psi=1e-5 t_end=0.1
  run -1 --separate-stderr simulate l1 orbit V=5 psi=0.01
  [[ $stderr == 'mlg simulate: t = '*' s: the oscillation has died out' ]]
  run -1 --separate-stderr simulate l1 orbit V=20 psi=0.05 t_end=20
  [[ $stderr == 'mlg simulate: not settled at t = 20 s, after '*' maxima of psi: it still changes by '*' of its size in a period' ]]
  run -1 --separate-stderr simulate l1 history V=10 psi=1.5 dpsi=200
  [[ $stderr == 'mlg simulate: t = '*' s: an angle passes pi/2, or the rates are not finite' ]]
}
