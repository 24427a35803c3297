# failures.bats - does each wrong input, and each failed run, say so in its line?
#
# Wrong input ends with status 2 and one line that names the file, the value,
# and what would be right; a failed run with status 1 and one line that names
# the run, its constants file and the reason, with the end of AUTO's output
# below it. Neither touches the results that are there.
#
# Needs   the models (make models)
# Writes  build/tests/failures

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch failures
  auto_run straight l1.straight -- HB=4
  auto_run psi l1.periodic from=straight -- TR=1 closed=1
}

setup() {
  cd "$SCRATCH" || return
}

# refuses PATTERN command...: status 2 and one line that has the pattern
refuses() {
  local pattern=$1
  shift
  run -2 "$@"
  # shellcheck disable=SC2053 # a pattern
  if [ "${#lines[@]}" -ne 1 ] || [[ $output != $pattern ]]; then
    printf 'expected the one line  %s\ngot  %s\n' "$pattern" "$output"
    return 1
  fi
}

# refuses_file LINE PATTERN SED: a c.l1.straight that sed changed, at that line
refuses_file() {
  mkdir -p build/tmp
  sed -E "$3" constants/c.l1.straight >build/tmp/c.l1.bad
  run -1 cmp -s build/tmp/c.l1.bad constants/c.l1.straight
  refuses "build/tmp/c.l1.bad:$1: $2" auto_run bad build/tmp/c.l1.bad -- HB=4
  [ ! -e build/runs/bad ]
}

# line WORD: number of the line of c.l1.straight that begins so
line() {
  grep -n "^$1" constants/c.l1.straight | cut -d: -f1
}

# fails PATTERN NAME CONSTANTS ...: status 1, the first line has the pattern and
# the names of the run and its file, the others end as AUTO's output ended
fails() {
  local pattern=$1 log=build/runs/$2.part/auto.log
  shift
  run -1 auto_run "$@"
  # shellcheck disable=SC2053 # a pattern
  if [[ ${lines[0]} != "$1 (constants/c.$2): "$pattern ]] ||
    [[ ${lines[1]} != *"AUTO's output ($log)"* ]] || [ "${#lines[@]}" -gt 8 ] || [ ! -f "$log" ]; then
    printf 'expected  %s (constants/c.%s): %s\ngot  %s\n' "$1" "$2" "$pattern" "$output"
    return 1
  fi
  if [ -s "$log" ]; then
    [[ ${lines[-1]} == *"$(grep . "$log" | tail -n 1)" ]]
  fi
  [ ! -e "build/runs/$1/stamp" ] || [ -n "${made_before:-}" ]
}

## Constants files

@test "a constant AUTO does not know" {
  refuses_file "$(line DS)" "'DSX' is not an AUTO constant*" 's/^DS  *=/DSX =/'
}

@test "a constant given twice" {
  refuses_file "$(line DS)" "DS is given twice*" 's/^(DS *=.*)/\1, DS = 1/'
}

@test "a name that is no parameter, wherever one may stand" {
  refuses_file "$(line ICP)" "ICP: 'c_q' is not a name of parnames" "/^ICP/s/'c_d'/'c_q'/"
  refuses_file "$(line PAR)" "PAR: 'c_q' is not a name of parnames" "/^PAR/s/'c_d'/'c_q'/"
  refuses_file "$(line UZSTOP)" "UZSTOP: 'W' is not a name of parnames" "/^UZSTOP/s/'V'/'W'/"
  refuses_file "$(line UZSTOP)" "UZR: 'W' is not a name of parnames" "s/^UZSTOP.*/UZR = {'W': 1.0}/"
  refuses_file "$(line THL)" "THL: 'perod' is not a name of parnames" "/^THL/s/period/perod/"
}

@test "a parameter under a wrong slot, or under another name" {
  refuses_file "$(line parnames)" "parnames: c_d stands under 1; it is PAR(2)" \
    "/^parnames/s/1: 'V', 2: 'c_d'/1: 'c_d', 2: 'V'/"
  refuses_file "$(line parnames)" "parnames: PAR(2) is called 'c_q'; its name is c_d" "/^parnames/s/'c_d'/'c_q'/"
}

@test "values of a form that AUTO does not read" {
  refuses_file "$(line NMX)" "NMX = 50.5 is not a whole number" '/^NMX/s/5000/50.5/'
  refuses_file "$(line UZSTOP)" "UZSTOP: V = abc is not a finite number" '/^UZSTOP/s/200.0/abc/'
  refuses_file "$(line UZSTOP)" "UZSTOP: V has no value*" '/^UZSTOP/s/200.0//'
  refuses_file "$(line UZSTOP)" "UZSTOP = \['V'\] is no dictionary*" "s/^UZSTOP.*/UZSTOP = ['V']/"
  refuses_file "$(line UZSTOP)" "STOP: 'HX1' is no type of point*" "s/^UZSTOP.*/STOP = ['HX1']/"
  refuses_file "$(line PAR)" "PAR: V is given twice" "/^PAR/s/'c_d'/'V'/"
  refuses_file "$(line ICP)" "ICP names no parameter*" "s/^ICP.*/ICP = []/"
}

@test "room for fewer parameters than the model has" {
  refuses_file "$(line NMX)" "NPAR = 36 is too few; the model has parameters up to PAR(55)" 's/NPAR = 55/NPAR = 36/'
  # where nothing is said the checker adds it
  sed 's/, NPAR = [0-9]*//' constants/c.l1.straight >build/tmp/c.l1.few
  run ! grep -q NPAR build/tmp/c.l1.few
  mlg constants build/tmp/c.l1.few | grep -qx 'NPAR = 55'
  auto_run roomy build/tmp/c.l1.few -- HB=4
  cmp <(sed 1,19d build/runs/roomy/b.roomy) <(sed 1,19d build/runs/straight/b.straight)
}

@test "AUTO by itself without room for all parameters: the model ends at once" {
  mkdir -p build/tmp/hand
  sed 's/, NPAR = [0-9]*//' constants/c.l1.straight >build/tmp/hand/fort.2
  cd build/tmp/hand
  : >fort.3
  run -2 ../../models/l1.exe
  [[ $output == *"NPAR = 36: this model has parameters up to PAR(55); its constants file has to say NPAR = 55"* ]]
  sed 's/NPAR = 85/NPAR = 84/' ../../../constants/c.boundary.point >fort.2
  run -2 ../../models/l1.boundary.exe
  [[ $output == *"NPAR = 84: this model has parameters up to PAR(85); its constants file has to say NPAR = 85"* ]]
}

@test "an older solution, with 36 parameters, starts a run" {
  auto_run straight l1.straight -- HB=4
  python3 - build/runs/straight/s.straight >build/tmp/s.old <<'EOF'
import sys
lines = open(sys.argv[1]).read().split('\n')[:-1]
while lines:
    head = lines[0].split()
    rows, parameters = int(head[8]), int(head[11])
    first = rows - (parameters + 6) // 7 + 1
    head[8], head[11] = str(rows - 2), '36'
    print(' '.join(head))
    numbers = ' '.join(lines[first:rows + 1]).split()
    print('\n'.join(lines[1:first]))
    print('\n'.join(' '.join(numbers[k:k + 7]) for k in range(0, 36, 7)))
    lines = lines[rows + 1:]
EOF
  mkdir -p build/tmp/old
  cp constants/c.l1.periodic build/tmp/old/fort.2
  cp build/tmp/s.old build/tmp/old/fort.3
  (cd build/tmp/old && ../../models/l1.exe >auto.log)
  cmp <(grep -v '^   0' build/tmp/old/fort.7) <(grep -v '^   0' build/runs/psi/b.psi)
}

@test "states that are not as many as NDIM" {
  refuses_file "$(line NDIM)" "NDIM = 8, but unames names 7 states" '/^NDIM/s/7/8/'
}

@test "brackets and quotes left open" {
  refuses_file "$(line ICP)" "ICP: a bracket or quote is left open" '/^ICP/s/]//'
  refuses_file "$(line PAR)" "PAR: a bracket or quote is left open" '/^PAR/s/}//'
  refuses_file "$(line ICP)" "ICP: a bracket or quote is left open" "/^ICP/s/'V'/'V/"
}

@test "no file, no layout, no such run to start from" {
  refuses 'a: no constants file constants/c.l1.none' auto_run a l1.none --
  refuses 'a: no constants file build/tmp/none' auto_run a build/tmp/none --
  mkdir -p build/tmp
  cp constants/c.l1.straight build/tmp/c.l9.straight
  refuses "a: build/tmp/c.l9.straight *'l9'*no models/l9.c" auto_run a build/tmp/c.l9.straight -- HB=4
  refuses 'a: starts from none, which has not been made' auto_run a l1.periodic from=none -- closed=1
}

## Values

@test "values outside their range, in a file or handed over" {
  refuses_file "$(line PAR)" 'c_d = -1 N m s/rad is outside its range, 0 to 1e+09' '/^PAR/s/3.6e4/-1/'
  refuses '*c.l1.straight*: c_d = -1 N m s/rad is outside its range, 0 to 1e+09' auto_run a l1.straight c_d=-1 --
  refuses '*c.l1.straight*: V = -1 m/s is outside its range, 0 to 1000' auto_run a l1.straight V=-1 --
  refuses '*c.l1.straight*: k_s = 0 N m/rad is outside its range, 1 to inf; 1e30 is rigid' auto_run a l1.straight k_s=0 --
  refuses '*c.l1.straight*: l = 0 m is outside its range, 0.001 to 100' auto_run a l1.straight l=0 --
  refuses '*c.l1.straight*: V = 1e300 m/s is outside its range, 0 to 1000' auto_run a l1.straight V=1e300 --
  refuses '*c.l1.straight*: c_d = 1e10 N m s/rad is outside its range, 0 to 1e+09' auto_run a l1.straight c_d=1e10 --
  refuses '*c.l1.straight*: k_d = -1e5 N m/rad is outside its range, 1 to 1e+12' auto_run a l1.straight k_d=-1e5 --
  refuses '*c.l1.periodic*: k_psi = 0 N m/rad is outside its range, 1 to 1e+12' auto_run a l1.periodic from=straight k_psi=0 --
}

@test "the ends of a range are not outside it" {
  auto_run ends l1.straight c_d=0 V=0 -- HB=2
  auto_run ends l1.straight c_d=1e9 k_s=1e30 -- HB=4
}

@test "values outside their range on the command lines of the commands that look over the plane" {
  local command
  for command in boundary intervals regions widest limits curves; do
    refuses "mlg $command: 'c_psi=-1': outside its range, 0 to 1e+09 N m s/rad" mlg $command li1 c_psi=-1
    refuses "mlg $command: 'k_psi=0': outside its range, 1 to 1e+12 N m/rad" mlg $command li1 k_psi=0
    refuses "mlg $command: 'compliance=-1': outside its range, 0 to 100000 1e-5 rad/(N m)" mlg $command li1 compliance=-1
    refuses "mlg $command: 'R=nan': expected NAME=NUMBER" mlg $command li1 R=nan
    refuses "mlg $command: 'R': expected NAME=NUMBER; \`mlg help $command\` has its other words" mlg $command li1 R
    refuses "mlg $command: 'c_q=1': no such parameter*" mlg $command li1 c_q=1
    refuses "mlg $command: 'V=20': *" mlg $command li1 V=20
    refuses "mlg $command: 'c_d=1e3': *" mlg $command li1 c_d=1e3
  done
  refuses "mlg curves: 'c_d=1e3': *" scripts/curves.sh l1 a c_d=1e3
}

@test "a result taken for a parameter" {
  refuses '*c.l1.straight*: PAR: psi_max is a result (maximum of psi over the period); it cannot be set' auto_run a l1.straight psi_max=3 --
  refuses "*c.l1.straight*: ICP: F_z is a result *; it cannot be continued" auto_run a l1.straight ICP="['F_z', 'V']" --
  refuses "*c.l1.hopf*: ICP: psi_max is a result *; it cannot be continued" auto_run a l1.hopf from=straight ICP="['V', 'psi_max']" --
}

@test "a parameter given by its slot" {
  refuses '*c.l1.straight*: c_d = -1 N m s/rad is outside its range*' auto_run a l1.straight PAR="{1: 1.0, 2: -1}" --
  auto_run slot l1.straight PAR="{1: 1.0, 2: 5e3}" -- HB=2
}

@test "values that are no finite numbers" {
  local value
  for value in nan NaN inf -inf 1e999 0x10 one 1,2 '1 2'; do
    refuses "*c.l1.straight*: c_d = $value is not a finite number" auto_run a l1.straight "c_d=$value" --
  done
  refuses_file "$(line PAR)" "c_d = nan is not a finite number" '/^PAR/s/3.6e4/nan/'
  refuses '*c.l1.straight*: NMX = many is not a finite number' auto_run a l1.straight NMX=many --
}

@test "values with which AUTO never ends" {
  refuses '*c.l1.straight: ITNW = 0 is outside what AUTO can do, 1 to 999' auto_run a l1.straight ITNW=0 --
  refuses '*c.l1.periodic: NCOL = 8 is outside what AUTO can do, 2 to 7' auto_run a l1.periodic from=straight NCOL=8 --
  refuses '*c.l1.periodic: NCOL = 1 is outside what AUTO can do, 2 to 7' auto_run a l1.periodic from=straight NCOL=1 --
  refuses '*c.l1.periodic: DSMAX = 0 has to be above 0' auto_run a l1.periodic from=straight DSMAX=0 --
  refuses_file "$(line NMX)" 'NMX = -5 is outside what AUTO can do, 0 to 99999' '/^NMX/s/5000/-5/'
}

@test "names that are none" {
  local name
  for name in "it's" a/b 'a b' .a -a ''; do
    refuses "run: NAME '$name': letters, digits, . _ - and +, a letter or a digit first, at most 100" auto_run "$name" l1.straight -- HB=4
    refuses "the name '$name': *" scripts/curves.sh l1 "$name"
  done
  [ -z "$(find build/runs -name "*'*" -o -name '* *')" ]
}

@test "words that are no settings" {
  refuses "*c.l1.straight: 'c_q' is neither an AUTO constant nor a parameter*" auto_run a l1.straight c_q=1 --
  refuses "*c.l1.straight: 'c_d': expected NAME=VALUE" auto_run a l1.straight c_d --
  refuses "*c.l1.straight: 'c_d=': expected NAME=VALUE" auto_run a l1.straight c_d= --
  refuses '*c.l1.straight*ICP*left open*' auto_run a l1.straight "ICP=['V', 'period'" --
}

@test "a file of parameters that is none" {
  refuses 'none: No such file*' auto_run a l1.straight gear=none --
  refuses "constants/c.l1.hopf:*: expected one constant, PAR*" auto_run a l1.straight gear=constants/c.l1.hopf --
  sed 's/phi/psi/' constants/gear.printed >build/tmp.gear
  refuses "build/tmp.gear:*: PAR: 'psi' is not a parameter*" auto_run a l1.straight gear=build/tmp.gear --
}

@test "words the figure scripts do not know" {
  refuses "fig06: no runs 'z'; there are a b c" scripts/fig06.sh runs z
  refuses 'usage: scripts/fig06.sh *' scripts/fig06.sh all-of-it
}

## Runs

@test "no convergence (MX)" {
  fails '*MX: no convergence*' mx l1.straight EPSU=1e-30 EPSL=1e-30 -- HB=4
  fails '*MX: no convergence*' mx l1.hopf from=straight DS=100 DSMIN=100 DSMAX=100 -- UZ=1
  fails '*MX: no convergence*' mx l1.periodic from=straight EPSU=1e-30 EPSL=1e-30 -- closed=1
}

@test "a parameter that is continued out of its range" {
  fails 'PAR(30) alpha_m = -* rad must be above 0;*' left l1.periodic from=straight ICP="['alpha_m', 'period']" DS=-0.01 UZR={} UZSTOP={} --
  fails 'PAR(28) l = -* m must be above 0;*MX: no convergence' left l1.straight V=20 ICP="['l', 'period']" DS=-0.01 DSMAX=0.02 UZSTOP={} --
}

@test "steps used up" {
  fails '*ended at EP: the steps (NMX) were used up*' few l1.straight NMX=50 -- HB=0
  fails '*ended at EP: the steps (NMX) were used up*' few l1.periodic from=straight NMX=10 -- TR=0
}

@test "a Hopf point in the first step, where AUTO does not look" {
  run -0 scripts/run.sh first l1.straight V=13.4 -- HB=4
  [[ $output == *'HB 13.4308 HB 25.0908 HB 33.8422 HB 61.6176, with points asked for beside those that AUTO had stepped over' ]]
}

@test "points missing or too many" {
  fails 'expected 5 HB, found 4*' wrong l1.straight -- HB=5
  fails 'expected 3 HB, found 4*' wrong l1.straight -- HB=3
  fails 'expected 2 TR, found 1*' wrong l1.periodic from=straight -- TR=2 closed=1
  fails '*expected 1 closed, found 0*' wrong l1.straight -- HB=4 closed=1
}

@test "a start that is not in the solutions" {
  fails 'Restart label HB9 not found; AUTO computed no solution; expected 1 closed, found 0' start l1.periodic from=straight IRS="'HB9'" -- closed=1
  fails 'The solution file * could not be found; AUTO computed no solution; expected 1 UZ, found 0' start l1.hopf -- UZ=1
}

@test "an IRS that names no solution, and a STOP that no point ends" {
  local wrong
  for wrong in "'HB0'" "'HB'" HB "'HB-1'" "'HB1x'" "'hb1'" "['HB1']" 1.5 00 -0 "''"; do
    refuses "*constants/c.l1.periodic: IRS = $(printf %q "$wrong"): expected a label, or a type of point*" \
      auto_run a l1.periodic from=straight IRS="$wrong" --
  done
  refuses "*STOP: 'HB0' is no type of point*" auto_run a l1.periodic from=straight STOP="['HB0']" --
  refuses "*SP: 'HB1x' is no type of point*" auto_run a l1.periodic from=straight SP="['HB1x']" --
  [ ! -e build/runs/a ]
}

@test "a run to start from, and IRS = 0, which starts anew" {
  local why="a: from=straight starts anew because IRS = 0 in *; say which solution, as IRS=\"'HB1'\""
  refuses "${why/\*/constants/c.l1.straight}" auto_run a l1.straight from=straight --
  refuses "${why/\*/constants/c.l1.periodic}" auto_run a l1.periodic from=straight IRS=0 --
  mkdir -p build/tmp
  sed "s/ IRS = 'HB1',//" constants/c.l1.hopf >build/tmp/c.l1.none # 0 is AUTO's default
  refuses "${why/\*/build/tmp/c.l1.none}" auto_run a build/tmp/c.l1.none from=straight --
  [ ! -e build/runs/a ]
}

@test "where there is no shimmy a run says that it found no point" {
  auto_run calm l1.straight c_d=2900 >found
  [[ $(<found) == '  calm '*' ms  no special point' ]]
}

# judge SED: judges the psi branch with its b. file changed
judge() {
  mkdir -p changed
  cp build/runs/psi/[ds].psi changed
  sed -E "$1" build/runs/psi/b.psi >changed/b.psi
  mlg judge changed/psi -- TR=1 closed=1
}

@test "the judge passes a good run and finds what is wrong with others" {
  run -0 judge ''
  [ "$output" = 'TR 30.7865 closed' ]
  run -1 judge '30s/[0-9.]+E[-+][0-9]+/NaN/3'
  [[ $output == *'no number in one of the columns'* ]]
  # the label of the torus point taken away
  run -1 judge 's/^( +-?[0-9]+ +-?[0-9]+ +)8 /\10 /'
  [[ $output == *'7 stable multipliers become 5 without a label between V = 3'* ]]
  [[ $output == *'expected 1 TR, found 0'* ]]
  # shellcheck disable=SC2016 # sed's last line
  run -1 judge '55,$d'
  [[ $output == *'AUTO broke off at V = '* ]]
  run -1 judge '/^ +[1-9-]/d'
  [[ $output == *'AUTO computed no solution'* ]]
}

@test "AUTO that stops with a status of its own" {
  local code
  cp build/models/l1.exe l1.exe
  for code in 3 139; do
    printf '#!/bin/sh\necho something broke\nexit %s\n' $code >build/models/l1.exe
    run auto_run stops l1.straight -- HB=4
    cp l1.exe build/models/l1.exe
    [ "$status" -eq 1 ]
    [[ $output == *"stops (constants/c.l1.straight): "*"status $code"* ]]
    [[ $output == *'something broke'* ]]
  done
}

# A full disk is played with ulimit -f: no file may grow beyond so many kB.
@test "a disk that is full while AUTO writes" {
  local file
  cp build/models/l1.exe l1.exe
  for file in b.full s.full d.full auto.log; do
    printf '#!/bin/sh\n%s/l1.exe\nhead -c 4000 %s >part && cat part >%s\n' "$SCRATCH" $file $file >build/models/l1.exe
    [ $file != auto.log ] || printf '#!/bin/sh\ntrue\n' >build/models/l1.exe
    run auto_run full l1.straight --
    cp l1.exe build/models/l1.exe
    [ "$status" -eq 1 ]
    [ "${lines[0]}" = "full (constants/c.l1.straight): what AUTO wrote is cut short (is the disk full?)" ]
    [ ! -e build/runs/full ]
  done
}

# full KB command...
full() {
  (trap '' XFSZ && ulimit -f "$1" && shift && "$@")
}

@test "a disk that is full while tables and pictures are written leaves the ones before" {
  local kb step
  scripts/fig06.sh
  cp -r "$ROOT/docs" .
  cp "$ROOT"/results/*.{csv,png,gif} results
  rm build/tables/*.{kept,sum} # they are those made here
  sed -i '$d' results/targets.csv # or it is left as it is
  sha256sum results/* build/tables/*.csv >kept.sums
  for kb in 2 8 32; do
    rm -f build/stamps/*
    run -1 full $kb scripts/fig06.sh draw
    [ "${lines[-1]}" = "fig06: gnuplot wrote half a picture, results/fig06.png or .svg (is the disk full?); those before are kept" ]
    sha256sum --check --quiet kept.sums
  done
  # one of the two pictures is whole
  mkdir -p build/tools
  for step in png svg; do
    rm -f build/stamps/*
    printf '#!/bin/sh\n%s "$@"\ntruncate -s 50000 results/fig06.%s.new\n' "$(command -v gnuplot)" $step >build/tools/half
    chmod +x build/tools/half
    mv build/tools/half build/tools/gnuplot
    run -1 scripts/fig06.sh draw
    rm build/tools/gnuplot
    [[ ${lines[-1]} == 'fig06: gnuplot wrote half a picture'* ]]
    sha256sum --check --quiet kept.sums
  done
  for step in 'fig06.sh tables' report/collect.sh report/targets.sh report/summary.sh; do
    rm -f build/stamps/*
    # shellcheck disable=SC2086 # a script and its argument
    run -1 full 1 scripts/$step
    [[ $output == *'File too large'* ]] || { echo "$step: $output" && return 1; }
    sha256sum --check --quiet kept.sums
  done
  # and with room again all is as before
  scripts/fig06.sh draw
  sha256sum --check --quiet kept.sums
  rm -r build/runs/fig06.* # other tests want none
  rm -f results/*.new build/tables/*.new
}

@test "a picture without its table is not drawn" {
  mkdir -p results
  rm -f results/fig07.csv
  refuses 'fig07: there is no results/fig07.csv to draw; scripts/fig07.sh tables makes it' scripts/fig07.sh draw
}

@test "commands say that they cannot write" {
  local program
  for program in 'intervals l1' 'curves l1' 'boundary l1' 'regions l2' 'constants constants/c.l1.straight' 'table psi' 'rows psi columns=V' 'points psi' 'judge psi'; do
    # shellcheck disable=SC2086 # a program and its arguments
    run -1 bash -c "build/bin/mlg $program >/dev/full"
    [ "$output" = "mlg ${program%% *}: cannot write the output: No space left on device" ]
  done
}

## What was there before

@test "a run that fails or is refused leaves the one before as it was" {
  made_before=yes
  auto_run kept l1.straight c_d=5e3 -- HB=2
  sha256sum build/runs/kept/* >kept.sums
  fails 'expected 3 HB, found 2*' kept l1.straight c_d=5e3 -- HB=3
  sha256sum --check --quiet kept.sums
  run -2 auto_run kept l1.straight c_d=-5e3 -- HB=2
  sha256sum --check --quiet kept.sums
  # and it still counts as made
  run -0 auto_run kept l1.straight c_d=5e3 -- HB=2
  [ -z "$output" ]
}

@test "tables that cannot be made leave the ones before as they were" {
  local part
  rm -rf build/runs/fig06.* results build/tables
  mkdir -p results build/tables
  cp "$ROOT"/results/*.csv results
  : >build/tables/points.fig06.csv
  sha256sum results/* build/tables/* >kept.sums
  run ! scripts/fig06.sh tables # no runs
  sha256sum --check --quiet kept.sums
  run ! scripts/fig07.sh tables
  sha256sum --check --quiet kept.sums
  # one run of many missing
  scripts/fig06.sh runs
  cp -rp build/runs all
  for part in fig06.a.psi fig06.c.psi fig06.b.straight; do
    rm -r "build/runs/$part"
    run ! scripts/fig06.sh tables
    sha256sum --check --quiet kept.sums
    cp -rp "all/$part" build/runs
  done
}

@test "a study without its runs leaves the tables of record as they were" {
  local study
  rm -rf results build/tables build/stamps
  mkdir -p results build/tables
  cp "$ROOT"/results/*.csv results
  sha256sum results/* >kept.sums
  for study in scripts/studies/*.sh; do
    run ! "$study" tables
    sha256sum --check --quiet kept.sums || { echo "$study" && false; }
  done
  refuses 'design: there is no build/tables/design.loads.l1.csv; scripts/studies/design.sh runs makes it' scripts/studies/design.sh tables
}

# begin NAME COMMAND...: in the background, until AUTO has begun on that run
begin() {
  local name=$1
  shift
  rm -rf "build/runs/$name.part"
  setsid env --default-signal=INT "$@" >stopped 2>&1 3>&- &
  pid=$!
  until [ -s "build/runs/$name.part/auto.log" ]; do
    kill -0 $pid
    sleep 0.02
  done
}

# A run to be stopped takes minutes: a short one may be over before the signal is there
# on a busy machine, and bash goes on where its command had ended by itself.
readonly minutes=(DSMAX=1e-6 NMX=99999)

@test "a run stopped by Ctrl-C, or killed, and started again" {
  local signal pid
  for signal in INT KILL; do
    rm -rf build/runs/stopped.* build/tables/*
    # shellcheck disable=SC2016 # for that shell
    begin stopped.psi bash -c '. scripts/auto/lib.sh
      run stopped.straight l1.straight -- HB=4
      run stopped.psi l1.periodic from=stopped.straight "$@" --' bash "${minutes[@]}"
    kill -$signal -- -$pid
    ended_badly $pid
    [ ! -e build/runs/stopped.psi ]
    run -0 auto_run stopped.straight l1.straight -- HB=4
    [ -z "$output" ] # made before
    run -0 auto_run stopped.psi l1.periodic from=stopped.straight -- TR=1 closed=1
    [ "${#lines[@]}" -eq 1 ]
    [ ! -e build/runs/stopped.psi.part ]
    cmp <(tail -n +20 build/runs/psi/b.psi) <(tail -n +20 build/runs/stopped.psi/b.stopped.psi)
  done
}

@test "a script that is ended takes its AUTO with it" {
  local signal pid auto
  for signal in TERM HUP KILL; do
    begin stopped.alone scripts/run.sh stopped.alone l1.periodic from=straight "${minutes[@]}" --
    auto=$(find /proc -maxdepth 2 -path '/proc/[0-9]*/exe' -lname "$SCRATCH/build/models/l1.exe" 2>/dev/null) || true
    [ -e "$auto" ]
    kill -$signal $pid
    ended_badly $pid
    for _ in {1..100}; do [ -e "$auto" ] || break; sleep 0.05; done
    [ ! -e "$auto" ]
    [ ! -e build/runs/stopped.alone ]
  done
}

@test "two scripts at once in one tree" {
  local pid
  rm -rf build/runs/fig06.* build/tables/* results
  scripts/fig06.sh >one 2>&1 3>&- &
  pid=$!
  scripts/fig06.sh >two 2>&1
  wait $pid
  cmp results/fig06.csv "$ROOT/results/fig06.csv"
  [ "$(cat one two | grep -c ' ms ')" -eq 7 ] # each run by one of them
  [ -z "$(find build/runs build/tables results -name '*.new' -o -name 'fig06.*.part')" ] # other tests' runs fail
  rm -r build/runs/fig06.* # other tests want none
}

@test "two scripts at once that make one table: the second waits for the first and finds it" {
  local slow pid
  slow='. scripts/auto/lib.sh; made slow -- sh -c "seq 1 2000; sleep 1; seq 2001 4000"'
  mkdir -p build/tables build/stamps
  MLG_BUILT=yes bash -c "$slow" >one 2>&1 3>&- &
  pid=$!
  sleep 0.3
  MLG_BUILT=yes bash -c "$slow" >two 2>&1
  wait $pid
  cmp <(seq 1 4000) build/tables/slow.csv
  [ "$(cat one two | grep -c ' ms$')" -eq 1 ] && [ "$(cat one two | wc -l)" -eq 1 ]
}

@test "a table that was cut since it was made does not go into those of results/" {
  local damage table='. scripts/auto/lib.sh; tables() { echo these > results/cut; }; runs_all() { made cut.one models/mlg.h -- seq 9; }; main cut'
  mkdir -p results
  for damage in 'head -n 3 build/tables/cut.one.csv > cut && mv cut build/tables/cut.one.csv' ': > build/tables/cut.one.csv' 'rm build/tables/cut.one.csv' \
    ': > build/stamps/made.cut.one'; do
    MLG_BUILT=yes bash -c "$table runs"
    MLG_BUILT=yes bash -c "$table tables"
    echo those > results/cut
    eval "$damage"
    run -2 env MLG_BUILT=yes bash -c "$table tables"
    [[ $output == "build/tables/cut.one.csv is not what was made; \`"*" runs\` makes it again" ]] || { echo "$output"; false; }
    [ "$(cat results/cut)" = those ]
  done
  MLG_BUILT=yes bash -c "$table runs"
  touch models/mlg.h && echo >> models/mlg.h # of other sources: whole all the same
  MLG_BUILT=yes bash -c "$table tables"
  [ "$(cat results/cut)" = these ]
  cp "$ROOT/models/mlg.h" models/
}

@test "two makes at once in one tree; a header that changed" {
  local pid made=(build/bin/mlg build/models/l1.exe)
  objects
  rm "${made[@]}" build/mlg/auto/text.o build/models/l1.o
  made_by_make --silent "${made[@]}" >one 2>&1 3>&- &
  pid=$!
  made_by_make --silent "${made[@]}"
  wait $pid
  [ -z "$(find build/bin build/models -name '*.[0-9]*')" ]
  touch scripts/mlg/auto/progress.h models/plugin.h
  made_by_make --silent "${made[@]}"
  [ build/bin/mlg -nt scripts/mlg/auto/progress.h ]
  [ build/models/l1.exe -nt models/plugin.h ]
}

@test "a checkout under a path with blanks" {
  mkdir -p 'a b'
  cp -r scripts models constants 'a b'
  mkdir -p 'a b/build/models' 'a b/build/bin'
  cp build/models/l1.exe 'a b/build/models'
  cp build/bin/mlg 'a b/build/bin'
  (cd / && "$SCRATCH/a b/scripts/run.sh" slice l1.straight -- HB=4)
  [ -e 'a b/build/runs/slice/stamp' ]
}

@test "the shimmy of a region is not guessed when its orbits are missing" {
  scripts/fig06.sh runs
  scripts/fig07.sh runs hopf
  cp -rp build/runs/fig06.c.psi c.psi
  # torus curves: any will do here
  for curve in torus_psi torus_delta; do
    for way in up down; do
      mkdir -p "build/runs/fig07.$curve.$way"
      for file in b d; do
        cp "build/runs/fig07.low.up/$file.fig07.low.up" "build/runs/fig07.$curve.$way/$file.fig07.$curve.$way"
      done
      cp build/runs/fig07.low.up/origin "build/runs/fig07.$curve.$way"
    done
  done
  run -0 scripts/fig07.sh tables
  cp results/fig07.csv kept.csv
  rm -r build/runs/fig06.c.psi
  run ! scripts/fig07.sh tables
  cmp kept.csv results/fig07.csv
}

@test "the table of targets is not replaced by half of one" {
  mkdir -p results
  cp "$ROOT"/results/*.csv results
  rm results/fig07.csv
  sha256sum results/*.csv >kept.sums
  run ! scripts/report/targets.sh
  sha256sum --check --quiet kept.sums
}

@test "a target that is missed is said to be, with status 1" {
  rm -rf results
  cp -r "$ROOT"/results .
  scripts/report/targets.sh >met
  grep -q '^V-H1,.*,yes$' results/targets.csv
  cp results/targets.csv met.csv
  sed -i '/^6,l1,fig06.a.straight,HB,/s/13\.4307[0-9]*/13.45/' results/special_points.csv
  run -1 scripts/report/targets.sh
  [ "$(diff met.csv results/targets.csv | grep '^>')" = "$(grep '^V-H1,.*,13.45,.*,no$' results/targets.csv | sed 's/^/> /')" ]
  # without a table none is judged
  cp results/targets.csv met.csv
  rm results/widths.csv
  run ! scripts/report/targets.sh
  [ "${lines[-1]}" = 'targets: tests/targets.csv: W-L2.max: results/widths.csv: No such file or directory' ]
  cmp met.csv results/targets.csv
}

## Models

@test "a model that does not compile stops a script, and no old one runs" {
  sed -i 's/T_d = mlg_links(par/T_d = mlg_links(pra/' models/l1.c
  run ! env -u MLG_BUILT MLG_SET_UP=yes scripts/fig06.sh runs c
  [[ $output == *pra* ]]
  [ ! -e build/runs/fig06.c.straight/stamp ] || [ -e all ]
  cp "$ROOT/models/l1.c" models
}
