# runs-made.bats - does mlg run, judge and read runs without a silent wrong answer?
#
# Each test is an input that was once answered wrongly with status 0, or damage that
# was carried on. The files of AUTO 0.9.2 and 0.9.4 in tests/autofiles are runs of L1:
# straight, V = 12 to 14 m/s with NPR=4; orbits, nine points from its Hopf point;
# appended, both in one file as @ap leaves them.
#
# Needs   the models and build/bin/mlg (make test-programs)
# Writes  build/tests/runs-made

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch runs-made
  cp -rp "$ROOT/tests/autofiles" .
  mlg run straight l1.straight -- HB=4
  mlg run psi l1.periodic from=straight -- TR=1 closed=1
}

setup() {
  cd "$SCRATCH" || return
}

# says STATUS PATTERN COMMAND...: that status, and a first line that has the pattern
says() {
  local status=$1 pattern=$2
  shift 2
  run "-$status" "$@"
  # shellcheck disable=SC2053 # a pattern
  if [[ ${lines[0]} != $pattern ]]; then
    printf 'expected  %s\ngot  %s\n' "$pattern" "$output"
    return 1
  fi
}

# refuses PATTERN COMMAND...: status 2, and one line
refuses() {
  says 2 "$@"
  [ "${#lines[@]}" -eq 1 ]
}

# column RUN NAME: of its branch
column() {
  mlg rows "$1" columns="$2" types=any
}

## What closes

@test "a branch that fell onto the zero solution is not closed" {
  local c_d
  for c_d in 4e4 3.5e4 3.62e4; do
    says 1 "x (*): *fell onto the zero solution at V = *, where straight rolling has no Hopf point*" \
      mlg run x l1.periodic from=straight IRS="'HB1'" c_d=$c_d
    [ ! -e build/runs/x ]
  done
}

@test "a branch that folds at finite amplitude is not cut" {
  mlg run s li1.straight V=0.5 k_s=6.38e5 b=140 c_d=100 ICP="['c_d','period','V']" DS=1 DSMAX=5 UZSTOP="{'c_d':2000}"
  mlg run c li1.cycles from=s IRS="'HB1'"
  says 0 "*LP 263.939 closed" mlg run c2 li1.cycles from=c IRS="'UZ1'" DS=-0.01 UZSTOP="{'c_d':[20.0,8e4],'psi_max':20}"
  # all of it, down to the Hopf point at c_d = 263.882
  [ "$(column c2 point | tail -n 1)" -gt 280 ]
  near "$(mlg rows c2 columns=c_d:.9g ends | tail -n 1)" 263.88242 1e-7 "c_d of the closing Hopf point"
}

@test "a branch closes on the Hopf point of the eigenvalues, whatever the step" {
  local dsmax
  for dsmax in 0.1 0.5 2.0; do
    mlg run closing l1.periodic from=straight DSMAX=$dsmax NMX=3000 -- closed=1
    near "$(mlg rows closing columns=V:.10g ends | tail -n 1)" "$(mlg point straight HB3 columns=V:.10g)" 1e-8 "V where it closes"
  done
}

@test "an orbit branch that ends where there is no Hopf point is not closed" {
  run -1 mlg judge psi -- closed=0
  sed 's/^\(.\{19\}\).\{19\}/\1  1.2345678900E+000/' build/runs/psi/b.psi > b.flat # V does not move
  mkdir -p flat
  grep -h '^   0' build/runs/psi/b.psi >flat/b.flat
  grep -v '^   0' b.flat >>flat/b.flat
  cp build/runs/psi/s.psi flat/s.flat
  run mlg judge flat/flat
  [[ $output != *closed* ]]
}

@test "a branch closes on the Hopf point of its own gear and frequency, or not at all" {
  local file
  # `ends` adds the Hopf point that closes the branch
  rows_of() { mlg rows elsewhere/other columns=V "$@" | wc -l; }
  mkdir -p elsewhere
  for file in b d s; do cp build/runs/psi/$file.psi elsewhere/$file.other; done
  [ "$(rows_of ends)" -eq "$(($(rows_of) + 1))" ]
  # the same of c_d = 3.7e4, whose Hopf points are 0.1 m/s and more away
  for file in b s; do sed 's/3\.6000000000E+004/3.7000000000E+004/g' build/runs/psi/$file.psi >elsewhere/$file.other; done
  [ "$(rows_of ends)" -eq "$(rows_of)" ]
  [ "$(rows_of)" -gt 60 ]
  # the same orbits with 1.3 times their period; a column of another name is none of the solutions'
  cp build/runs/psi/s.psi elsewhere/s.other
  awk '/PT  TY  LAB/ { for (k = 0; 20 + 19 * k < length($0); k++) if (substr($0, 20 + 19 * k, 19) ~ /period/) at = 20 + 19 * k
      sub(/period/, "PERIOD") }
    at && $1 != 0 { x = sprintf("%18.10E", 1.3 * substr($0, at, 19)); sub(/E[-+]/, "&0", x)
      $0 = substr($0, 1, at - 1) x substr($0, at + 19) } 1' build/runs/psi/b.psi >elsewhere/b.other
  [ "$(rows_of ends)" -eq "$(rows_of)" ]
  [ "$(rows_of)" -gt 60 ]
  # and with their own period under that name it closes
  sed 's/  period /  PERIOD /' build/runs/psi/b.psi >elsewhere/b.other
  [ "$(rows_of ends)" -eq "$(($(rows_of) + 1))" ]
}

@test "a torus curve ends where its orbit vanishes, and is not followed further" {
  mlg run ts l1.torus_start from=psi -- EP=1
  says 1 'torus (*): fell onto the zero solution at c_d = 31309.3*' mlg run torus l1.torus from=ts DS=-0.1
  # in another parameter it came back over the same points
  says 1 'torus (*): the curve runs back over itself from M = 19094.5, where the orbit vanishes*' \
    mlg run torus l1.torus from=ts DS=-0.1 ICP="['M', 'V', 'period', 'torus_angle', 'psi_max']" \
    THL="{'M': 1e-6, 'period': 0, 'torus_angle': 0}" UZSTOP="{'M': 1e5}"
  mlg run torus l1.torus from=ts DS=0.1
}

## Stability

@test "the stability of cycles beside a multiplier of 1 is told by the branch, or not" {
  mlg run s li1.straight V=0.5 k_s=6.38e5 b=140 c_d=100 ICP="['c_d','period','V']" DS=1 DSMAX=5 UZSTOP="{'c_d':2000}"
  mlg run c li1.cycles from=s IRS="'HB1'"
  # unstable before the fold, though AUTO's sign says stable up to 0.88 degrees
  [ "$(mlg rows c columns=stable 'where=psi_max>0.02' 'where=psi_max<2.8' | sort -u)" = 0 ]
  [ -z "$(mlg point c LP columns=stable)" ]
  [ "$(mlg rows c columns=stable 'where=psi_max>3.0' 'where=psi_max<5' | sort -u)" = 1 ]
  # without the multipliers there is nothing to tell it by
  mlg run c li1.cycles from=s IRS="'HB1'" IID=0
  [ -z "$(mlg rows c columns=stable | sort -u)" ]
}

@test "no stability and no claim where AUTO computed nothing" {
  says 0 '*no special point looked for' mlg run isp l1.straight ISP=0
  [ -z "$(column isp stable | sort -u)" ]
  mlg run l2s l2.straight k_s=1e6 c_d=1e4
  says 0 '*no special point looked for' mlg run l2h l2.hopf from=l2s IRS="'HB1'" NMX=100 -- EP=1
  says 1 '*expected 0 HB, but the run did not look for it*' mlg judge isp -- HB=0
  says 0 '*no special point (not looked for: LP)' mlg run ilp l1.hopf from=straight IRS="'HB1'" ILP=0
  says 1 '*expected 0 TR, but*' mlg judge psi -- TR=0 || [[ $output == *'expected 0 TR, found 1'* ]]
}

@test "folds that ILP = 0 hides are named" {
  mlg run low l1.straight c_d=1000
  says 1 '*become*without a label*(a fold, which ILP = 0 hides: ILP=1)*' mlg run lows l1.periodic from=low
  says 0 '*LP 31.93*LP 16.17*TR 18.16*closed' mlg run lows l1.periodic from=low ILP=1 -- LP=2 TR=1 closed=1
}

## Points

# marked NAME: the Hopf curve of setup_hopf with what sed or awk made of b.hopf, d.hopf in marked/
marked() {
  mkdir -p marked
  for file in b d s; do [ -s "marked/$file.marked" ] || cp "build/runs/hopf/$file.hopf" "marked/$file.marked"; done
}

@test "an LP that is no extremum, a fold without a label, a double Hopf point that is none" {
  mlg run hopf l1.hopf from=straight IRS="'HB1'" DS=-0.1 -- LP=1 ZH=2 HH=2
  # the label of the LP a point later: columns BR PT TY LAB
  rm -rf marked
  mkdir marked
  awk '{ type = $3; label = $4 }
    $1 == 2 && $3 == 32 { moved = $4; $0 = substr($0, 1, 10) "  30   0" substr($0, 19) }
    $1 == 2 && moved && $2 == 96 { $0 = substr($0, 1, 10) "  32" sprintf("%5d", moved) substr($0, 20) } 1' build/runs/hopf/b.hopf >marked/b.marked
  marked
  says 1 'marked: fold without a label near c_d = 31588 *LP at c_d = 315* is not an extremum*' mlg judge marked/marked
  # the second pair of eigenvalues off the axis by a thousandth of its frequency
  rm -rf marked
  mkdir marked
  sed 's/^\(   2   131         Eigenvalue  [34]:  \) [-0-9.]*E-[0-9]*/\1-7.00000E-02/; s/^\(   2   131         Eigenvalue  [12]:  \) [-0-9.]*E-[0-9]*/\1 1.00000E-12/' \
    build/runs/hopf/d.hopf >marked/d.marked
  marked
  run -1 mlg judge marked/marked -- LP=1 ZH=2 HH=2
  [[ $output == *'expected 2 HH, found 1'* ]]
}

@test "a point written because of NPR is none of UZ" {
  mlg run npr l1.straight NPR=500 UZR="{'V': 70.05}" -- UZ=2
  near "$(mlg point npr UZ1 columns=V)" 70.05 1e-6 "V of UZ1"
  near "$(mlg table npr labels | awk -F, '$4 == "UZ1" { print $6 }')" 70.05 1e-6 "V of UZ1 in the table"
  says 1 '*expected 5 UZ, found 2*' mlg judge npr -- UZ=5
  # AUTO starts there, too
  grep -v '^PAR' constants/c.l1.straight >c.l1.on
  mlg run from-uz ./c.l1.on from=npr IRS="'UZ1'" NMX=2 -- EP=1
  near "$(mlg point from-uz first columns=V)" 70.05 1e-6 "where the run from UZ1 starts"
}

@test "more than 9999 points" {
  mlg run long l1.straight DS=0.01 DSMAX=0.01 NMX=30000 -- HB=4
  [ "$(column long point | wc -l)" -gt 19000 ]
  [ "$(column long point | tail -n 1)" -eq "$(column long point | wc -l)" ]
  [ "$(mlg rows long columns=stable 'where=V>10' 'where=V<13.4' | sort -u)" = 1 ]
}

@test "a stop at a bound, and a start beyond one" {
  says 1 'b1 (*): the start, V = 1, lies outside RL0 = 10' mlg run b1 l1.straight RL0=10 RL1=100
  says 0 '*HB 13.4308 HB 25.0908 ended at RL1 = 30' mlg run b2 l1.straight RL1=30
  says 1 '*ended at EP: the steps (NMX) were used up*-- EP=1*' mlg run b3 l1.straight NMX=50
  mlg run b3 l1.straight NMX=50 -- EP=1
}

@test "a parameter continued out of its range" {
  mlg run lb li1.straight V=20 c_d=1e4 k_s=1e6 b=10 UZSTOP="{'V': 20.5}"
  says 1 '*b = -* N m s^2/rad is outside its range, 0 to 1e+09*' \
    mlg run leaves li1.straight V=20 c_d=1e4 k_s=1e6 b=1 ICP="['b', 'period']" DS=-0.5 DSMAX=1 UZSTOP="{'b': -20}" ISP=0
}

@test "expected words that are slips" {
  refuses "x: 'XX=0': expected TYPE=COUNT*" mlg run x l1.straight -- XX=0
  refuses "x: 'HB=99999999999': *" mlg run x l1.straight -- HB=99999999999
  refuses "x: 'HB=1' and 'HB=2': *" mlg run x l1.straight -- HB=1 HB=2
}

## Constants

@test "what is handed over is merged, and refused when it comes twice" {
  local file=constants/c.l1.straight
  [ "$(mlg constants $file c_d=1e4 PAR="{'V': 2.0}" | grep ^PAR)" = "PAR = {'V': 2.0, 'c_d': 1e4}" ]
  printf "PAR = {'e': 0.15 m, 'M': 2e4 kg}\n" >gear
  [ "$(mlg constants $file gear=gear PAR="{'V': 2.0}" | grep ^PAR)" = "PAR = {'V': 2.0, 'c_d': 3.6e4, 'e': 0.15, 'M': 2e4}" ]
  [ "$(mlg constants $file M=1e4 gear=gear | grep ^PAR)" = "PAR = {'V': 1.0, 'c_d': 3.6e4, 'M': 1e4, 'e': 0.15}" ]
  refuses "$file: PAR: c_d is given twice" mlg constants $file c_d=1e3 c_d=5e3
  refuses "$file: PAR: c_d is given twice, as 2 too" mlg constants $file PAR="{'c_d': 1e4, 2: 5e3}"
  refuses "$file: DS is given twice, as 1 and 2" mlg constants $file DS=1 DS=2
  printf "PAR = {'e': 0.15, 'e': 0.2}\n" >gear
  refuses "gear:1: PAR: e is given twice" mlg constants $file gear=gear
}

@test "a layout has the parameters of its device, and its number of states" {
  local file=constants/c.l1.straight
  refuses "$file: k_s = 1e6: the device of l1 has no k_s; leave it at inf" mlg run x l1.straight k_s=1e6
  refuses "$file: b = 10: the device of l1 has no b; leave it at 0" mlg run x l1.straight b=10
  refuses "constants/c.l2.straight: b = 10: *" mlg run x l2.straight b=10
  refuses "*ICP: the device of l1 has no b; it cannot be continued" mlg run x l1.straight ICP="['b', 'period']"
  [ "$(mlg constants $file k_s=inf b=0 | grep ^PAR)" = "PAR = {'V': 1.0, 'c_d': 3.6e4, 'k_s': 1e30, 'b': 0}" ]
  sed "s/, 7: 'eps'/, 7: 'eps', 8: 'deps'/; s/NDIM = 7/NDIM = 8/" $file >c.l1.eight
  refuses "./c.l1.eight:*: NDIM = 8, but the layout l1 has 7 states" mlg run x ./c.l1.eight
  refuses "x: starts from straight, a run of the layout l1; this one is of l2" mlg run x l2.hopf from=straight IRS="'HB1'"
}

@test "the load stands for the mass" {
  mlg run loaded l1.straight F_z=1e5 STOP="['HB1']"
  near "$(awk '/^PAR/ { print $NF }' build/runs/loaded/c.loaded | tr -d '}')" "$(awk 'BEGIN { printf "%.15g", 1e5 / 9.81 - 500 }')" 1e-12 M
  refuses "*: PAR: both M and F_z*" mlg run x l1.straight F_z=1e5 M=1e4
  refuses "*: F_z = -1 N gives M = *" mlg run x l1.straight F_z=-1
  refuses "*: PAR: F_z is the load*give M" mlg run x l1.periodic from=straight F_z=1e5
}

@test "what AUTO takes is taken: 80 values, 1.0d-1, TY, HomCont; what would never end is not" {
  local word file=constants/c.l1.straight
  mlg run many l1.straight UZR="{'V': [$(seq -s ', ' 1 80)]}" DS=0.1d0 -- UZ=80
  for word in TY="'HB4'" IPS=9 NUNSTAB=1 NSTAB=2 IEQUIB=0 ITWIST=0 ISTART=5 IREV=[] 'IFIXED=[1]' IPSI=[]; do
    mlg constants $file "$word" >/dev/null
  done
  for word in NCOL=1 NCOL=8 ITNW=0 NTST=0 NMX=-1 NMX=1000000 DSMAX=0 EPSU=0 DSMIN=-1; do
    refuses "$file:*: ${word%=*} = ${word#*=} *" mlg constants $file "$word" || refuses "$file: ${word%=*} = ${word#*=} *" mlg constants $file "$word"
  done
  refuses "$file: UZR is longer than AUTO reads*" mlg constants $file UZR="{'V': [$(seq -s ', ' 1 900)]}"
}

## Names

@test "the name of a run is a name" {
  local name
  mkdir -p victim.part
  for name in ../../victim "a'b" 'a b' -d .a '' $'a\nb' a/b; do
    refuses "run: NAME '*': letters*" mlg run "$name" l1.straight
    refuses "run: from='*': letters*" mlg run x l1.straight from="$name"
  done
  [ -d victim.part ]
  refuses "run: NAME 'x.part': *" mlg run x.part l1.straight
  refuses "table: 'a*b' is no name of a run: *" mlg table 'a*b'
  refuses "table: there is no run 'a=b/psi', no a=b/b.psi" mlg table a=b/psi
  mkdir -p a=b
  cp build/runs/psi/[bds].psi a=b
  mlg table a=b/psi | diff - <(mlg table psi | sed '/^[0-9]/!b')
}

## Damage

@test "AUTO's files are looked at before they are used, and made anew when they do not fit" {
  local damage file n=0
  mlg run small l1.straight RL1=20
  # shellcheck disable=SC2016 # sed's last line
  for damage in '12,$d' '30d' 's/E+00/E-00/20' '10s/1/2/3'; do
    for file in b d s c; do
      cp -p build/runs/small/$file.small kept
      sed -i "$damage" build/runs/small/$file.small
      if cmp -s kept build/runs/small/$file.small; then continue; fi
      n=$((n + 1))
      says 0 "  small: $file.small is not what AUTO wrote; it is made anew" mlg run small l1.straight RL1=20
      [ "${#lines[@]}" -eq 2 ]
      run -0 mlg run small l1.straight RL1=20
      [ -z "$output" ]
    done
  done
  [ "$n" -ge 10 ]
  # the same size and time, other bytes: only a sum can tell, and a touch asks for it
  cp -p build/runs/psi/b.psi kept
  sed -i '60s/1/7/4' build/runs/psi/b.psi
  touch -r kept build/runs/psi/b.psi
  says 0 "  psi: b.psi is not what AUTO wrote*" mlg run psi l1.periodic from=straight -- TR=1 closed=1
  rm build/runs/psi/s.psi
  says 0 "  psi: s.psi is not what AUTO wrote*" mlg run psi l1.periodic from=straight -- TR=1 closed=1
}

@test "a run is made anew for another model, start or expectation, and judged anew by another judge" {
  # again WORD...: what the second of two runs says; both are up to date before
  # shellcheck disable=SC2119,SC2120 # says calls it with words
  again() { mlg run second l1.periodic from=first IRS="'HB1'" NMX=30 -- EP=1 "$@"; }
  mlg run first l1.straight RL1=20
  again
  run -0 again
  [ -z "$output" ]
  # of the model another byte at its end, which runs as before; then the same one back
  cp -p build/models/l1.exe l1.exe
  printf ' ' >>build/models/l1.exe
  says 0 '  second * ms *' again
  run -0 again
  [ -z "$output" ]
  cp -p l1.exe build/models/l1.exe
  says 0 '  second * ms *' again
  # another start of the same name
  mlg run first l1.straight RL1=20 c_d=3.61e4
  says 0 '  second * ms *' again
  # another expectation, one that it meets and one that it does not
  says 0 '  second * ms *' again BP=0
  says 1 'second (*expected 1 TR, found 0*' again TR=1
  # a judge that finds fault where the one before found none: seen by a run of that judge's stamp
  mlg run third l1.straight RL1=20
  sed -i 's/^judge .*/judge 0000000000000000/' build/runs/third/stamp
  rm build/runs/third/looks
  cp -p build/runs/third/stamp stamp.before
  run -0 mlg run third l1.straight RL1=20
  [ -z "$output" ]
  run ! cmp -s stamp.before build/runs/third/stamp # judged, and stamped anew
}

@test "a stamp that is cut, or times that are lost" {
  head -c 900 build/runs/psi/stamp >part.of.it
  mv part.of.it build/runs/psi/stamp
  says 0 '  psi * ms  TR 30.7865 closed' mlg run psi l1.periodic from=straight -- TR=1 closed=1
  rm build/runs/psi/looks
  run -0 mlg run psi l1.periodic from=straight -- TR=1 closed=1
  [ -z "$output" ]
  [ -s build/runs/psi/looks ]
}

@test "a table of a damaged file is one line, not half a table" {
  local damage
  mkdir -p damaged
  for damage in '60s/.\{40\}$//' '60s/E/x/' 's/PT  TY/PX  TY/' '60s/^ *[-0-9]* *[-0-9]*/   z/'; do
    sed "$damage" build/runs/psi/b.psi >damaged/b.damaged
    refuses "table: damaged/b.damaged:*" mlg table damaged/damaged
    refuses "rows: damaged/b.damaged:*" mlg rows damaged/damaged columns=V
    run -1 mlg judge damaged/damaged
  done
  head -c 5000 build/runs/psi/b.psi >damaged/b.damaged
  refuses "table: damaged/b.damaged:*: the last line is cut" mlg table damaged/damaged
  cp build/runs/psi/b.psi damaged/b.damaged
  dd if=/dev/zero of=damaged/b.damaged bs=1 seek=6000 count=200 conv=notrunc status=none
  refuses "table: damaged/b.damaged:*: a zero byte" mlg table damaged/damaged
  cp build/runs/psi/b.psi damaged/b.damaged
  head -c 20000 build/runs/psi/s.psi >damaged/s.damaged
  refuses "table: damaged/s.damaged:*: the solution of label * is cut: *" mlg table damaged/damaged solution UZ1
  sed '50d' build/runs/psi/b.psi >damaged/b.damaged
  cp build/runs/psi/s.psi damaged/s.damaged
  says 1 'damaged: *a point is missing before it*' mlg judge damaged/damaged
}

## Bounds on AUTO

@test "AUTO's time and the size of its files are bounded, and the message says which" {
  cp build/models/l1.exe l1.exe
  printf '#!/bin/sh\nwhile :; do :; done\n' >build/models/l1.exe
  MLG_TIME_LIMIT=1 says 1 'slow (*): AUTO had not ended after 1 s (MLG_TIME_LIMIT)' mlg run slow l1.straight
  printf '#!/bin/bash\nexec truncate -s 2G b.big\n' >build/models/l1.exe
  says 1 "big (*): a file of AUTO's grew to 256 MB (MLG_SIZE_LIMIT)" mlg run big l1.straight
  MLG_SIZE_LIMIT=2 says 1 "big (*): a file of AUTO's grew to 2 MB (MLG_SIZE_LIMIT)" mlg run big l1.straight
  cp l1.exe build/models/l1.exe
  rm -rf build/runs/big.part
  MLG_SIZE_LIMIT=0 refuses "run: MLG_SIZE_LIMIT='0': *" mlg run slow l1.straight
  MLG_TIME_LIMIT=soon refuses "run: MLG_TIME_LIMIT='soon': *" mlg run slow l1.straight
}

@test "a run that is stopped leaves nothing, and no AUTO behind" {
  local signal pid auto tries
  for signal in INT TERM HUP KILL; do
    env --default-signal=INT build/bin/mlg run stopped l1.periodic from=straight DSMAX=0.002 NMX=50000 >/dev/null 2>&1 3>&- &
    pid=$!
    until [ -s build/runs/stopped.part/b.stopped ]; do
      kill -0 $pid || return
      sleep 0.02
    done
    auto=$(ps -o pid= --ppid $pid)
    kill -$signal $pid
    ended_badly $pid
    for tries in {1..100}; do
      grep -q '^State:[[:space:]]*[^ZX]' /proc/$((auto))/status 2>/dev/null || break
      sleep 0.05
    done
    [ "$tries" -lt 100 ]
    [ ! -e build/runs/stopped ]
    [ $signal = KILL ] || [ ! -e build/runs/stopped.part ]
  done
  mlg run stopped l1.periodic from=straight -- closed=1
  [ ! -e build/runs/stopped.part ]
}

@test "a rejected run can be looked at by its name" {
  says 1 'few (*' mlg run few l1.periodic from=straight NMX=10
  [ "$(mlg rows few.part columns=V | wc -l)" -eq 10 ]
  mlg table few.part | grep -q '^10,'
  mlg table few.part solution EP1 | grep -q '^t,delta'
}

@test "the judge changed: what is there is judged again, and AUTO does not run" {
  local before
  before=$(stat -c %Y.%i build/runs/straight/b.straight)
  cp build/bin/mlg other
  printf ' ' >>other
  MLG_ROOT=$PWD run -0 ./other run straight l1.straight -- HB=4
  [ -z "$output" ]
  [ "$(stat -c %Y.%i build/runs/straight/b.straight)" = "$before" ]
}

## Columns

@test "columns that are reckoned: frequency, shimmy, name; the closing point; halves joined" {
  local period frequency
  period=$(mlg rows psi columns=period:.10g only=TR)
  near "$(mlg rows psi columns=frequency:.10g only=TR)" "$(awk -v T="$period" 'BEGIN { printf "%.10g", 1 / T }')" 1e-9 frequency
  # a Hopf point closes the branch, of the frequency of straight rolling there
  frequency=$(build/bin/mlg hopf l1 c_d=3.6e4 | awk -F, '$4 == "psi" { f = $3 } END { print f }')
  near "$(mlg rows psi columns=frequency:.10g ends | tail -n 1)" "$frequency" 1e-6 "frequency where it closes"
  [ "$(mlg rows psi columns=type,psi_max ends | tail -n 1)" = HB,0 ]
  # the names by which IRS calls them
  [ "$(mlg rows straight columns=name only=HB | xargs)" = 'HB1 HB2 HB3 HB4' ]
  near "$(mlg rows straight columns=V:.10g only=HB | sed -n 3p)" "$(mlg point straight HB3 columns=V:.10g)" 1e-12 HB3
  [ "$(mlg shimmy psi)" = psi ]
  mlg run delta l1.periodic from=straight IRS="'HB2'" -- closed=1
  [ "$(mlg shimmy delta)" = delta ]
  [ "$(mlg rows psi columns=shimmy only=TR),$(mlg rows delta columns=shimmy only=TR)" = psi,delta ]
  diff <(mlg rows psi columns=point,V) <(mlg rows psi columns=point,V reverse | tac)
  run ! cmp -s <(mlg rows psi columns=point) <(mlg rows psi columns=point reverse)
}

## Files of AUTO's own

@test "files of AUTO 0.9.2 and 0.9.4, and several branches in one" {
  local version
  for version in 0.9.2 0.9.4; do
    says 0 'HB 13.4308' mlg judge autofiles/$version/straight -- HB=1 UZ=1
    [ "$(mlg table autofiles/$version/straight labels | cut -d, -f4 | tail -n +3 | xargs)" = 'EP1 HB1 UZ1' ]
    [ "$(mlg table autofiles/$version/orbits | grep -c '^[0-9]')" -eq 9 ]
    [ "$(mlg table autofiles/$version/orbits | cut -d, -f5 | sed -n '4,11p' | sort -u)" = 1 ]
    refuses 'table: *holds branches of different columns; save them one by one' mlg table autofiles/$version/appended
    [ "$(mlg rows autofiles/$version/appended columns=V | wc -l)" -eq 21 ]
    mkdir -p twice
    cat autofiles/$version/b.straight autofiles/$version/b.straight >twice/b.twice
    [ "$(mlg table twice/twice | grep -c '^[0-9]')" -eq 24 ]
    [ "$(mlg table twice/twice | grep -c '^$')" -eq 1 ]
  done
  mlg table autofiles/0.9.2/straight | diff - <(mlg table autofiles/0.9.4/straight)
}
