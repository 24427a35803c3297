# doubts.bats - do intervals, damping and AUTO follow the model's doubts (docs/doubts.md)?
#
# Boundary points, Hopf points and damping ratios of random (layout, doubts, k_s, b) against
# the eigenvalues of the full linearised equations (eigen-LAYOUT, tests/eigen.h); AUTO along
# each doubt by its name against the exact answer; the table of record.
#
# Needs   the models, build/bin/mlg and eigen-* (make test-programs)
# Writes  build/tests/doubts

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch doubts
  cp -rp "$ROOT/results" .
}

setup() {
  cd "$SCRATCH" || return
}

# nearest X < numbers: the one nearest to X
nearest() {
  awk -v x="$1" 'NR == 1 || ($1 - x) ^ 2 < (best - x) ^ 2 { best = $1 } END { print best }'
}

# cases N SPIN: lines LAYOUT K_S B zB_shared R_moves heading I_p N12_out; with SPIN = 0 I_p is 0
cases() {
  awk -v n="$1" -v spin="$2" 'BEGIN {
    srand(5054)
    split("l1 l2 li1 li2", layout, " ")
    for (i = 0; i < n; i++) {
      name = layout[i % 4 + 1]
      k_s = 1e5 / (0.02 + 0.25 * rand())
      printf "%s %s %.6g %.4f %.4f %.4f %.4f %d\n", name, (name == "l1" ? "1e30" : sprintf("%.8g", k_s)),
        (name ~ /^l[12]$/ ? 0 : 200 * rand()), rand(), rand(), rand(), spin * 20 * rand(), i % 2 }
  }'
}

words() { # K_S B DOUBT...
  echo "k_s=$1 b=$2 zB_shared=$3 R_moves=$4 heading=$5 I_p=$6 N12_out=$7"
}

# Each boundary point of the cases is an extremum by the eigenvalues, in c_d and, where the
# curve is flat, in V
are_folds() { # N SPIN LEAST
  local n=$1 spin=$2 least=$3 layout case points=0 c_d V extremum
  while read -r layout case; do
    # shellcheck disable=SC2046,SC2086 # words
    set -- $(words $case)
    while IFS=, read -r c_d V _ extremum _; do
      case $extremum in max | min) ;; *) continue ;; esac
      # shellcheck disable=SC2046 # two numbers
      set -- "${@:1:7}" $("build/bin/eigen-$layout" fold V="$V" c_d="$c_d" "${@:1:7}" | awk '$1 == "V" { V = $3 } $1 == "c_d" { c = $3 } END { print c, V }')
      near "$c_d" "$8" 3e-9 "c_d of $layout ${*:1:7}"
      near "$V" "$9" 1e-5 "V of $layout ${*:1:7}"
      points=$((points + 1))
    done < <(mlg boundary "$layout" "${@:1:7}" | sed 1,2d)
  done < <(cases "$n" "$spin")
  echo "$points points"
  [ "$points" -ge "$least" ]
}

@test "boundary points at 12 random (layout, doubts, k_s, b) are extrema by the eigenvalues" {
  are_folds 12 0 24
}

@test "and at 8 with wheels that spin" {
  are_folds 8 1 16
}

@test "random gears with doubts: no interval missed, none invented" {
  run -0 --separate-stderr "$ROOT/build/bin/random-compare" 10 doubts=7
  [[ ${lines[1]} =~ ^missed\ 0,\ invented\ 0,\ oracle\ wrong\ 0,\ undecided\ 0,\ refused\ 0 ]]
  run -0 --separate-stderr "$ROOT/build/bin/random-compare" 2 doubts=15
  [[ ${lines[1]} =~ ^missed\ 0,\ invented\ 0,\ oracle\ wrong\ 0,\ undecided\ 0,\ refused\ 0 ]]
}

@test "damping ratios with doubts are those of the eigenvalues" {
  local layout case
  while read -r layout case; do
    # shellcheck disable=SC2046,SC2086 # words
    set -- $(words $case) V=40 c_d=6e3
    near "$(cell zeta damping "$layout" "$@")" \
      "$("build/bin/eigen-$layout" eigenvalues "$@" | awk 'NR > 1 && $2 > 0 { z = -$1 / sqrt($1 ^ 2 + $2 ^ 2); if (least == "" || z < least) least = z } END { printf "%.10g", least }')" \
      1e-7 "zeta of $layout $*"
  done < <(cases 8 1)
}

# along NAME TOP STEP WAY: AUTO follows L1's boundary points along a doubt; its UZ points
along() {
  local i
  for i in 1 3; do
    mlg run "along.$1.$i" boundary.point model=l1.boundary "$(mlg starts l1 | sed -n ${i}p)" compliance=0 \
      ICP="['$1', 'V_1', 'c_1', 'f_1', 'ratio_1', 'kind_1']" DS="$3" DSMAX=0.1 UZR="{'$1': 0.25}" \
      UZSTOP="{'$1': [-1e-9, $2], 'V_1': [0.1, 200.0], 'c_1': [10.0, 1e6]}" -- >out
    mlg rows "along.$1.$i" columns="$1:.10g,c_1:.10g" only=UZ | tr , ' '
  done
}

@test "AUTO continues boundary points along each doubt by its name, to the exact ones" {
  local name top step at c n=0
  while read -r name top step; do
    along "$name" "$top" "$step" >points
    while read -r at c; do
      near "$c" "$(mlg boundary l1 "$name=$at" | sed 1,2d | cut -d, -f1 | nearest "$c")" 1e-8 "c_d along $name at $at"
      n=$((n + 1))
    done <points
  done <<'END'
zB_shared 1.0 0.02
R_moves 1.0 0.02
heading 0.5 0.02
I_p 5.0 0.1
END
  [ "$n" -eq 16 ]
}

@test "the delta region of L1 is gone at the fold of its boundary point along zB_shared and I_p" {
  local name at
  for name in zB_shared I_p; do
    mlg run "fold.$name" boundary.point model=l1.boundary "$(mlg starts l1 | sed -n 2p)" compliance=0 \
      ICP="['$name', 'V_1', 'c_1', 'f_1', 'ratio_1', 'kind_1']" DS=0.02 DSMAX=0.1 \
      UZSTOP="{'$name': [-1e-9, 1.0], 'V_1': [0.1, 200.0], 'c_1': [10.0, 1e6]}" -- LP=1 >out
    at=$(mlg rows "fold.$name" columns="$name:.10g" only=LP)
    [ "$(mlg boundary l1 "$name=$(awk "BEGIN { print 0.999 * $at }")" | grep -c delta)" -eq 2 ]
    [ "$(mlg boundary l1 "$name=$(awk "BEGIN { print 1.001 * $at }")" | grep -c delta)" -eq 0 ]
  done
}

@test "AUTO continues a Hopf point of the whole equations along each doubt by its name" {
  local name top V
  mlg run start l1.straight c_d=3.6e4 STOP="['HB1']" -- HB=1 >out
  while read -r name top; do
    mlg run "hopf.$name" l1.hopf from=start ICP="['$name', 'V', 'period']" THL='{}' DS=0.02 DSMAX=0.1 \
      UZSTOP="{'$name': [-1e-9, $top], 'V': [0.1, 200.0]}" -- UZ=1 >out
    V=$(value "hopf.$name" UZ V)
    near "$V" "$(mlg hopf l1 c_d=3.6e4 "$name=$top" | sed 1,2d | cut -d, -f2 | nearest "$V")" 1e-7 "V along $name"
  done <<'END'
zB_shared 1.0
R_moves 1.0
heading 1.0
I_p 5.0
END
}

@test "N12_out does nothing to straight rolling, and makes solution B of Figure 6 larger by 1.1 %" {
  local with without
  diff <(mlg intervals li1 k_s=6.38e5 b=140) <(mlg intervals li1 k_s=6.38e5 b=140 N12_out=1)
  for n in 0 1; do
    mlg run "B.$n.straight" l1.straight c_d=3.6e4 N12_out=$n -- HB=4 >out
    mlg run "B.$n" l1.periodic from="B.$n.straight" IRS="'HB2'" -- >out
  done
  with=$(value B.0 UZ dstar_max 40) without=$(value B.1 UZ dstar_max 40)
  near "$(awk "BEGIN { print $without / $with - 1 }")" 0.011 0.1 "the difference"
}

@test "whole curves of a gear whose wheels spin are refused, and what grows where is known" {
  run -1 mlg curves l1 I_p=5
  [ "$output" = "mlg curves: whole curves are not known with I_p; \`mlg plane LAYOUT regions\`, hopf, boundary and intervals take it" ]
  run -1 mlg plane l1 I_p=5
  [ "${output#mlg plane: }" = "whole curves are not known with I_p; \`mlg plane LAYOUT regions\`, hopf, boundary and intervals take it" ]
  # strips of c_d within the zero-shimmy interval, and no others, grow nowhere
  mlg plane l1 regions I_p=5 >strips
  IFS=, read -r lo hi _ < <(mlg intervals l1 I_p=5 | sed -n 3p)
  awk -F, -v lo="$lo" -v hi="$hi" 'NR > 2 { middle = sqrt($1 * $2); n++; if ($5 != "none") grows[$1] = 1; at[$1] = middle }
    END { for (c in at) if ((at[c] > lo && at[c] < hi) == (c in grows)) { print c; exit wrong = 1 } exit wrong || n < 300 }' strips
}

@test "a crossing found twice is one, beside an antiresonance too, where V has few digits" {
  # LI4 with spinning wheels: at c_d of some hundred N m s/rad two starts ended 3e-10 apart in V
  local c_d
  mlg damping li4 best k_s=4322097 b=300 I_p=5 >found
  c_d=$(sed -n 2p found | cut -d, -f1)
  near "$(mlg damping li4 k_s=4322097 b=300 I_p=5 c_d="$c_d" | sed -n 2p | cut -d, -f1)" "$(sed -n 2p found | cut -d, -f2)" 1e-6 zeta
  near "$(sed -n 2p found | cut -d, -f2)" 0.00199293 1e-5 zeta
}

@test "random points of the Hopf curves with other tyres have an eigenvalue on the imaginary axis" {
  local tyre layout V c_d frequency k_s b words n=0
  while IFS=, read -r tyre layout V c_d frequency; do
    case $layout in l1) k_s=inf b=0 ;; l2) k_s=7.86e5 b=0 ;; li1) k_s=6.38e5 b=140 ;; li2) k_s=2.48e6 b=140 ;; esac
    case $tyre in paper) words=() ;; half) words=(k_lambda=1.19 k_alpha=0.3) ;; somieski) words=(k_lambda=2.857142857142857 k_alpha=2) ;; esac
    "build/bin/eigen-$layout" eigenvalues V="$V" c_d="$c_d" k_s="${k_s/inf/1e30}" b="$b" "${words[@]}" |
      awk -v f="$frequency" 'NR > 1 { x = $2 / (8 * atan2(1, 1)); if ((x / f - 1) ^ 2 < 1e-8 && ($1 / $2) ^ 2 < 1e-10) n++ } END { exit !n }'
    n=$((n + 1))
  done < <(mlg pick results/doubts_tyre.csv columns=tyre,layout,V,c_d,frequency_hz | awk -F, 'BEGIN { srand(142) } /^[phs]/ && rand() < 0.03')
  [ "$n" -ge 20 ]
}

@test "random rows of the table of record, computed anew" {
  local doubt value layout b k_s c_lo c_hi width n=0 word digits
  while IFS=, read -r doubt value layout b k_s c_lo c_hi width; do
    word=$doubt=$value
    [ "$doubt" != tyre ] || word=gear=constants/gear.somieski
    mlg intervals "$layout" k_s="$k_s" b="$b" "$word" | sed 1,2d | sort -t, -k5,5gr | head -n 1 >one
    if [ "$width" = 0 ]; then
      [ ! -s one ]
    else
      digits=1e-6
      [[ $layout != li[3-7] ]] || digits=3e-6 # their k_s is rounded to seven digits
      near "$c_lo" "$(cut -d, -f1 one)" $digits "$doubt=$value $layout"
      near "$c_hi" "$(cut -d, -f2 one)" $digits "$doubt=$value $layout"
    fi
    n=$((n + 1))
  done < <(mlg pick results/doubts.csv where=choice=paper columns=doubt,value,layout,b,k_s,c_lo,c_hi,width | 
    awk -F, 'BEGIN { srand(14) } ($3 !~ /li[3-7]/ || $2 != 0) && rand() < 0.1') # without doubts those stand at an onset: the last digit of k_s decides
  [ "$n" -ge 15 ]
  # every zeta is the least one at its c_d
  [ "$(mlg pick results/doubts.csv where=zeta= where=choice=paper columns=doubt | grep -c '^[zRhIt]')" -eq 0 ]
  while IFS=, read -r doubt value layout b k_s c_d zeta; do
    word=$doubt=$value
    [ "$doubt" != tyre ] || word=gear=constants/gear.somieski
    near "$(mlg damping "$layout" k_s="$k_s" b="$b" c_d="$c_d" "$word" | sed -n 2p | cut -d, -f1)" "$zeta" 1e-2 "zeta of $doubt=$value $layout"
  done < <(mlg pick results/doubts.csv where=choice=damped columns=doubt,value,layout,b,k_s,c_d,zeta | awk -F, 'BEGIN { srand(141) } rand() < 0.1')
}

# free_of LAYOUT C_D WORD...: no Hopf point over V at c_d, by the eigenvalues
free_of() {
  "build/bin/eigen-$1" boundary free=V from=0.1 to=200 step=0.5 c_d="$2" "${@:3}" | awk 'NR > 1 && !/no Hopf point/ { exit found = 1 } END { exit found }'
}

@test "random widest intervals of the table of record, by the eigenvalues too" {
  local doubt value layout b k_s c_lo c_hi width word n=0 part
  while IFS=, read -r doubt value layout b k_s c_lo c_hi width; do
    word=$doubt=$value
    near "$width" "$(cell width widest "$layout" b="$b" "$word")" 1e-6 "width of $layout with $word"
    # beside k_s, which may be where a region is born
    word="$word b=$b k_s=$(awk -v k_s="$k_s" 'BEGIN { print (k_s == "inf" ? 1e30 : 0.9999 * k_s) }')"
    for part in 0.02 0.5 0.98; do
      # shellcheck disable=SC2086 # words
      free_of "$layout" "$(awk "BEGIN { print $c_lo * ($c_hi / $c_lo) ^ $part }")" $word
    done
    for part in -0.02 1.02; do
      # shellcheck disable=SC2086
      run ! free_of "$layout" "$(awk "BEGIN { print $c_lo * ($c_hi / $c_lo) ^ $part }")" $word
    done
    n=$((n + 1))
  done < <(mlg pick results/doubts.csv where=choice=widest columns=doubt,value,layout,b,k_s,c_lo,c_hi,width |
    awk -F, 'BEGIN { srand(14) } $1 ~ /^(zB_shared|R_moves|heading)$/ && $8 > 0 && $3 != "l2" && rand() < 0.05')
  [ "$n" -ge 6 ]
}
