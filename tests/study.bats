# study.bats - does scripts/study.sh say what is true of any gear, and fail for none?
#
# The paper's gear with AUTO; others by the exact parts alone, their intervals from
# the eigenvalue oracle (build/bin/eigen-LAYOUT) and from tests/random.
#
# Needs   the models, build/bin/eigen-* (make test-programs)
# Writes  build/tests/study

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch study
  cp -rp "$ROOT/results" .
}

setup() {
  cd "$SCRATCH" || return
}

# of NAME LAYOUT DESIGN COLUMN: a cell of a study's designs.csv, of its first interval
of() {
  awk -F, -v layout="$2" -v design="$3" -v name="$4" '
    NR == 1 { for (k = 1; k <= NF; k++) if ($k == name) place = k; next }
    $1 == layout && $2 == design { print $place; exit }' "build/studies/$1/designs.csv"
}

says() { # NAME TEXT
  grep -q -- "$2" "build/studies/$1/report.md" || { cat "build/studies/$1/report.md"; return 1; }
}

# An unstable speed at that c_d by the eigenvalues, over V in steps of 0.5
shimmies() { # LAYOUT PARAMETER...
  [ "$("build/bin/eigen-$1" boundary free=V from=0.1 to=200 step=0.5 "${@:2}" | awk 'NR > 1' | wc -l)" -gt 0 ]
}

steady() { if shimmies "$@"; then return 1; fi; }

# V at c_d = 5e4 on a curve: rows curve,V,c_d
on_curve() { # FILE CURVE
  awk -F, -v curve="$2" '
    index($1, curve) != 1 || NF != 3 { next }
    last && ($3 - 5e4) * (c - 5e4) <= 0 { print V + ($2 - V) * (5e4 - c) / ($3 - c); exit }
    { V = $2; c = $3; last = 1 }' "$1"
}

study() { scripts/study.sh "$@" > study.log 2>&1 || { cat study.log; return 1; }; }

@test "the paper's gear, L1: interval, double Hopf points, branches, criticality, the page" {
  study paper layouts=l1
  near "$(of paper l1 rigid c_lo)" 2754.352 1e-6
  near "$(of paper l1 rigid c_hi)" 3018.979 1e-6
  near "$(of paper l1 rigid zeta)" 2.7e-5 1e-2
  says paper "Double Hopf points.*: 24.84 m/s, c_d = 3.204e+04; 60.98 m/s, c_d = 6.188e+04"
  says paper "^- inside, .*no Hopf point"
  says paper "^- above, .*delta-shimmy"
  says paper "^- overlap, .*2 branches; psi-shimmy.*torus point at .*; delta-shimmy.*torus point"
  says paper "supercritical at 10.79 m/s"
  says paper "Regions are named by the mode that grows; the 4 branches computed below show the same"
  # the torus curves of Figure 7, from one double Hopf point to the other, and where those pass c_d = 5e4
  says paper "Torus curves.*from (60.98 m/s, 6.188e+04) to (24.84 m/s, 3.204e+04)"
  for n in 1 2; do
    near "$(on_curve build/studies/paper/torus.l1.csv $n)" "$(sed -n "/^torus_$([ $n = 1 ] && echo psi || echo delta),/p" results/fig07.csv | awk -F, '{ print $1 "," $4 "," $5 }' | on_curve - torus_)" 2e-3
  done
  says paper "No run failed"
  [ "$(grep -c '<img src="data:image/svg' build/studies/paper/report.html)" -ge 3 ]
  [ "$(grep -c 'src="[^d]' build/studies/paper/report.html)" -eq 0 ]
  # again: nothing to do
  run scripts/study.sh paper layouts=l1
  [ "$output" = "  build/studies/paper/report.html is up to date" ]
}

@test "the paper's gear, L2 and LI2: the widest intervals, the most tolerant design" {
  study wide layouts=l2,li2 exact b_most=140
  says wide "Take LI2 .* b = 9[678]"
  # which has a row among all designs
  near "$(of wide li2 'most tolerant' c_d)" "$(awk -F, '$1 == "li2" { print $4 }' build/studies/wide/advice.csv)" 1e-6
  near "$(awk -F, '$1 == "li2" { print $5 }' build/studies/wide/advice.csv)" "$(awk -F, '$1 == "li2" && $2 ~ /^tolerant/ && $6 + 0 > p { p = $6 } END { print p }' results/tolerance.csv)" 1e-3
  near "$(of wide l2 'widest at b = 0' width)" 10226.87 1e-6
  near "$(of wide l2 'widest at b = 0' k_s)" 786523.74 1e-6
  near "$(of wide li2 widest width)" 19089.11 1e-6
  says wide "Widest interval of c_d:\*\* LI2.*b is at its bound"
  near "$(of wide l2 'best damped' zeta)" 9.618e-5 1e-3
}

@test "the gear as rounded in print, with a device of its own, and two studies side by side" {
  sed "s|}|, 'k_s': 7.86e5 N m/rad, 'c_d': 5e3}|" constants/gear.printed > gear.own
  study printed gear=gear.own layouts=l1,l2 exact
  says printed "your own device: k_s = 786000"
  says printed "Your c_d = 5000\*\*, L1: shimmy"
  says printed "Your c_d = 5000\*\*, L2 with k_s = 7.86e+05 N m/rad: no shimmy"
  steady l2 phi=0.0524 M=19900 k_s=7.86e5 c_d=5e3
  shimmies l1 phi=0.0524 M=19900 c_d=5e3
  study wide layouts=l2,li2 exact b_most=140
  scripts/study.sh compare printed wide
  grep -q "<td>phi</td>" build/studies/printed.wide.html
}

@test "a light gear with delta at 55 Hz" {
  echo "PAR = {'J_xi': 20.0, 'J_eta': 25.0, 'J_zeta': 10.0, 'm_D': 50.0, 'c_psi': 94.87, 'c_delta': 94.87, 'M': 20337.0}" > gear.light
  study light gear=gear.light layouts=l1 exact
  near "$(of light l1 rigid c_lo)" 870.97 1e-5
  near "$(of light l1 rigid c_hi)" 950.33 1e-5
  near "$(awk -F, '$1 == "delta_locked_hz" { print $2 }' build/studies/light/facts.csv)" 55.5 1e-2
}

@test "e behind: shimmy at every c_d; phi = 0; almost no load; divergence; several intervals" {
  study behind e=-0.1 layouts=l1,l2 exact
  says behind "No device of these layouts keeps this gear free of shimmy"
  shimmies l1 e=-0.1 c_d=9e3
  study upright phi=0 g_psi=0.001 layouts=l1 exact
  says upright "Joints: in all that is exact here, g_psi = 0.001 is left out"
  near "$(of upright l1 rigid c_lo)" 3087.8218 1e-6
  shimmies l1 phi=0 c_d=3080
  steady l1 phi=0 c_d=3090
  study empty M=10 layouts=l1,l2 exact
  says empty "every c_d is free of shimmy"
  study heavy M=1e6 layouts=l1,li2 exact
  says heavy "Divergence\*\* with L1 LI2"
  says heavy "It \*\*diverges\*\*"
  says heavy "largest load is LI2 .* up to a load of 204.5 kN, 2 %" # that of the paper's gear
  study fast J_xi=22.2222222222 J_eta=27.7777777778 J_zeta=11.1111111111 m_D=55.5555555556 c_psi=100 c_delta=100 \
    g=88.29 M=2209.706875 k_s=7.87e5 layouts=l2 exact
  says fast "2 separate intervals.*from 1271 to 2920 .*from 3203 to 4682"
}

@test "bad input: one line, status 2, and no study" {
  local words
  echo "PAR = {'F_z': 60 kN}" > gear.load
  while IFS='|' read -r words pattern; do
    # shellcheck disable=SC2086 # words
    run -2 scripts/study.sh $words
    # shellcheck disable=SC2053 # a pattern
    [ "${#lines[@]}" -eq 1 ] && [[ $output == $pattern ]] || { echo "$words: $output"; return 1; }
  done << 'END'
bad gear=none|none: No such file*
bad gear=|study: 'gear=': expected gear=FILE
bad gear=gear.load|*gear.load:1: PAR: F_z is in kN here; it has to be in N
bad c_q=1|study: 'c_q=1': no such parameter*
bad layouts=l9|study: layouts=: there is no layout 'l9'*
bad layouts=gear|study: layouts=: there is no layout 'gear'*
bad layouts=k_d-c_d|study: layouts=: there is no layout 'k_d-c_d'*
bad layouts=l1,l1|study: layouts=: a layout is given twice
bad at=3e3,x|study: at=: 'x': expected values of c_d*
bad V=3|study: V is the axis*
bad V_top=-1|study: 'V_top=-1': outside its range*
bad layouts=l1 layouts=l2|study: 'layouts=l2': layouts is given already
bad v_top=75|study: 'v_top=75': written V_top=*
bad layouts=l1 b=10|study: b=10: none of the layouts l1 has a b
bad layouts=l1 k_s=1e6|study: k_s=1000000: none of the layouts l1 has a k_s
bad quick|study: 'quick': expected NAME=VALUE*
a.b|the name 'a.b': a study's has no point
../bad|the name '../bad'*
compare none paper|study: there is no study 'none'*
compare paper|usage: scripts/study.sh compare NAME NAME
END
  [ ! -e build/studies/bad ]
  for words in help -h --help; do scripts/study.sh $words | grep -q '^usage: scripts/study.sh NAME'; done
}

@test "branches of shimmy in a study: stable and unstable points, folds, slip; designs by falling width" {
  # from 10 m/s unstable to a fold at 8, then stable to 20; an orbit with slip at a third of alpha_m
  printf '%s\n' HB,10,0,0, ,9,1,0.001,0 LP,8,2,0.002, ,12,3,0.003,1 ,16,4,0.004,1 HB,20,0,0, orbit,0,0,4,0.004,0.03,-0.06 > branch
  awk -v row=x,psi,1 -v born=psi,1 -v e='0.05 2 0.5 7e5 2e5 0.3 0.6' -f scripts/study/cycle.awk branch > row
  [ "$(<row)" = 'x,psi,1,8,20,4,0.004,,8,2,1,0.329,0.00959,psi,1,Hopf point,' ] # slip atan2(0.06, 0.3) of 0.6; roll mu = sin 0.05 sin 4 deg + cos 0.05 sin 0.002 cos 4 deg
  printf '%s\n' layout,design,k_s,b,c_lo,c_hi,width,zeta,V,f,shimmy,d l1,rigid,inf,0,1,2,5,1,1,1,psi,x l2,widest,1e6,0,1,2,50,1,1,1,psi,x li1,widest,1e6,0,1,2,50,1,1,1,psi,x l2,none,1e6,0,0,inf,inf,1,1,1,psi,x > designs
  [ "$(awk -F, -f scripts/study/ranked.awk designs | cut -d , -f 1 | tail -n +2 | tr '\n' /)" = 'l2/l2 li1/l1/' ]
}

@test "why a branch ends; an unstable one is nowhere stable; of which shimmy torus curves are" {
  local row end
  while IFS='|' read -r row end; do
    [ "$(printf '%s\n' HB,1,0,0,1 ,2,5,0.01,0 "$row" | awk -v row=l1,x,1,1,psi,0 -v born=psi,1 -v top=75 -v V_least=0.5 -f scripts/study/cycle.awk | cut -d , -f 13,14,19,20)" = "$end" ] || { echo "$row"; return 1; }
  done << 'END'
BP,14.28,12,0.004,1|0,1,branch point,14.28
,75,12,0.004,0|0,2,V_top,
,0.5,12,0.004,0|0,2,V_least,
,14.28,60,0.004,0|0,2,psi_max,
,14.28,12,0.3,0|0,2,dstar_max,
END
  . scripts/study/cycles.sh
  . scripts/study/words.sh
  # shellcheck disable=SC2030,SC2034
  folder=. top=75
  [ "$(printf '%s\n' l,w,1,1,HB,1,0,0,1,1 l,w,1,1,,2,1,1,0,1 l,w,1,1,TR,3,1,1,1,1 l,w,1,1,,4,1,1,1,1 | without_false_stability | cut -d , -f 9 | xargs)" = "0 0 1 1" ]
  printf '%s\n' which,c_d,hopf_points low,142.6,1 > telling.l1.csv
  printf '%s\n' head 'l1,low.1,142.6,1,psi,0,1,38.8,22,0.007,,,9,9,1,0,psi,1,branch point,14.3 38.8' > cycles.csv
  unstable_throughout() { :; }
  branches_words l1 | grep -F 'psi-shimmy from 1 to 38.8 m/s (**in part**: AUTO stopped at a branch point; the shimmy beyond was not followed)'
  printf '%s\n' curve,V,c_d 1,1,2 1,3,4 > torus.l1.csv
  printf '%s\n' curve,shimmy,points,first_end,last_end 1,psi,2,angle,edge > torus_ends.l1.csv
  printf '%s\n' curve,kind,shimmy,type,V,c_d 1,open,psi,,1,2 > plane.l1.csv
  torus_words l1 | grep 'of psi-shimmy from (1 m/s, 2) to (3 m/s, 4) (the first end where the torus angle has come to 0.*Only psi-shimmy grows'
  printf '%s\n' 2,open,delta,,1,2 >> plane.l1.csv
  torus_words l1 | grep 'Where the other shimmy grows too'
}

@test "after Ctrl-C nothing goes on, and a repeated study makes again no run that was done" {
  local pid n=0
  timeout -s INT 300 scripts/study.sh stopped layouts=l1 at=38000,6000 > /dev/null 2>&1 &
  pid=$!
  while [ -z "$(find build/studies/stopped/runs -name 'b.*.[0-9]' ! -path '*.part/*' 2> /dev/null)" ]; do
    sleep 0.05
    n=$((n + 1))
    [ "$n" -lt 4000 ]
  done
  kill -INT $pid
  wait $pid || true
  [ ! -e build/studies/stopped/report.html ]
  sleep 0.3
  [ -z "$(find build/studies/stopped/runs -name '*.part')" ]
  find build/studies/stopped/runs -name 'b.*' -printf '%p %i %T@\n' | sort > before
  study stopped layouts=l1 at=38000,6000
  find build/studies/stopped/runs -name 'b.*' -printf '%p %i %T@\n' | sort > all
  [ -z "$(comm -23 before all)" ]
  [ "$(wc -l < before)" -lt "$(wc -l < all)" ]
  says stopped "No run failed"
}

@test "a nose gear published elsewhere: shimmy at every c_d, which the eigenvalues bear out" {
  study nose gear=constants/gear.nose layouts=l1,l2 exact
  says nose "No device of these layouts keeps this gear free of shimmy"
  says nose "No k_s gives it an interval. With a rigid k_s it is the same device as L1"
  # what it does have: where it grows least, and what load a device would bear
  says nose "Nearest to it.* tenfold in"
  # a Hopf curve that is of delta below and of psi above has both names
  [ "$(sed -n 's/^2,open,\([a-z]*\),.*/\1/p' build/studies/nose/plane.l1.csv | uniq | xargs)" = "delta psi" ]
  says nose "largest load is L1 with\|largest load is L[12].* free of shimmy up to a load of\|At no lower load that was looked at"
  near "$(awk -F, '$1 == "F_z" { print $2 }' build/studies/nose/facts.csv)" 160e3 1e-6
  near "$(awk -F, '$4 == "LP" { print $6 }' build/studies/nose/plane.l1.csv | sort -g | head -n 1)" 1562.132 1e-6
  for c_d in 1e3 1562 1570 1e4 7e4 1e5; do
    # shellcheck disable=SC2046 # words
    shimmies l1 $(sed -n 's/PAR = {//; s/^ *//; s/}//; s/,/\n/g; /^#/!p' constants/gear.nose | awk -F "'|: " 'NF > 2 { split($4, value, " "); print $2 "=" value[1] }') c_d=$c_d
  done
}

@test "a run that fails is listed with its reason, and the study goes on" {
  MLG_TIME_LIMIT=0.001 study slow layouts=l1
  says slow "Runs of AUTO that failed"
  says slow "^- overlap, .*4 Hopf points, no branch computed"
}

@test "of a branch whose run is rejected the good part is shown, and said to be one" {
  sed -i "/'5e-4 2.5e-3 1500'/s/1500\|4000/40/g" scripts/study/cycles.sh
  study cut layouts=l1 at=6000
  says cut "2 branches; delta-shimmy from 23.* (\*\*in part\*\*: AUTO went no further)"
  says cut "^| l1.asked.1.1 | .*the steps (NMX) were used up"
  says cut "on grey, the part of a branch"
  [ "$(grep -c '^l1,asked.1,6000,1,.*,0$' build/studies/cut/branches.csv)" -ge 40 ]
  # what AUTO had found, up to where it found nothing more
  printf '%s\n' l1,x,1,1,,9,1,0.1,1 l1,x,1,1,LP,8,2,0.2,1 l1,x,1,1,MX,7,3,0.3, > rows
  [ "$(. scripts/study/cycles.sh && good_part 0 < rows | cut -d , -f 5-6,10 | tr '\n' ' ')" = ',9,0 LP,8,0 ' ]
}
