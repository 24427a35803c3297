# joints.bats - play, friction, orifice and relief valve, from the words to AUTO's branches
#
# The laws themselves are in test_elements.c and test_layout.c. Here: wrong values, what
# linear tools say, the cycles by three ways that share the equations only (integration
# with located corners, AUTO with rounded ones, describing functions), and random samples
# of the tables of record.
#
# Needs   the models (make models)
# Writes  build/tests/joints

# shellcheck disable=SC2016 # conditions of awk

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch joints
}

setup() {
  cd "$SCRATCH" || return
}

refuses() { # PATTERN COMMAND...: status 2 and one line that has the pattern
  local pattern=$1
  shift
  run -2 "$@"
  # shellcheck disable=SC2053 # a pattern
  if [ "${#lines[@]}" -ne 1 ] || [[ $output != $pattern ]]; then
    echo "$output"
    return 1
  fi
}

readonly worn="g_psi=0.004363 psi=0.05"

designs() { # the paper's, each in the middle of its interval
  echo "l1 c_d=2890"
  echo "l2 c_d=8000 k_s=7.86e5"
  echo "li1 c_d=7000 k_s=6.38e5 b=140"
  echo "li2 c_d=12000 k_s=2.48e6 b=140"
  echo "li3 c_d=8000 k_s=718567 b=28.77"
  echo "li4 c_d=8000 k_s=2.38e6 b=140"
  echo "li5 c_d=4000 k_s=5.4e5 b=100"
}

## Words

@test "values that make no law end in one line" {
  refuses "*'g_psi=-0.01': outside its range, 0 to 1 rad*" mlg simulate l1 orbit g_psi=-0.01 psi=0.1
  refuses "*T_f, T_psi) needs v_f above 0*" mlg cycle l1 T_psi=10 psi=0.1
  refuses "*T_f, T_psi) needs v_f above 0*" mlg joints li2 T_f=10
  refuses "*T_max) needs c_r above 0*" mlg simulate l2 orbit T_max=1000 psi=0.1
  refuses "*'g_s=0.001': layout l1 has no g_s*" mlg cycle l1 g_s=0.001 psi=0.1
  refuses "*'k_s3=1': layout l1 has no k_s3*" mlg joints l1 k_s3=1
  refuses "*g_psi = -0.01 rad is outside its range, 0 to 1*" mlg constants constants/c.l1.straight g_psi=-0.01
  refuses "*T_f, T_psi) needs v_f above 0*" mlg constants constants/c.l1.straight T_f=5
  refuses "*no orbit to start from, dat = 'nowhere.dat'*" auto_run a l1.orbit dat=nowhere.dat --
  refuses "*'V=-5:20:3': outside its range, 0 to 1000 m/s" mlg joints l1 V=-5:20:3
  refuses "*'V=20:2000:3': outside its range*" mlg joints l1 V=20:2000:3
  refuses "*T_f, T_psi) needs v_f above 0*" mlg joints l1 v_f=0:1:2 T_psi=0:100:2
  refuses "*delta=0 psi=3: an angle beyond pi/2" mlg cycle l1 V=60 psi=3
  run -1 mlg cycle l1 V=60 c_d=2890 psi=0.05 settle=1e3 # the paper's design without play
  [ "$output" = "mlg cycle: the oscillation dies out" ]
}

@test "play.sh refuses in one line, before it integrates, and leaves nothing" {
  local words="V=60 c_d=2890 corner=0.005 $worn"
  cd "$ROOT" || return
  # shellcheck disable=SC2086 # words
  {
    refuses "*there is no models/l9.c" scripts/play.sh wrong l9 along=T_psi to=300 $words
    refuses "*'to=2': to is given already" scripts/play.sh wrong l1 along=T_psi to=300 to=2 $words
    refuses "*T_psi = nan is not a finite number" scripts/play.sh wrong l1 along=T_psi to=nan v_f=0.05 $words
    refuses "*T_psi = -5 N m is outside its range*" scripts/play.sh wrong l1 along=T_psi to=-5 v_f=0.05 $words
    refuses "*T_f, T_psi) needs v_f above 0*" scripts/play.sh wrong l1 along=T_psi to=300 $words
    refuses "*'nosuch' is neither an AUTO constant nor a parameter*" scripts/play.sh wrong l1 along=nosuch to=3 $words
    run -1 scripts/play.sh wrong l1 along=T_psi to=300 v_f=0.05 V=60 c_d=2890 psi=0.05 settle=1e3 # dies out
  }
  [ -z "$(find build/tables build/runs -name 'wrong*')" ]
}

@test "the tolerance of a step is what rtol says" {
  local rough fine
  # shellcheck disable=SC2086 # words
  {
    rough=$(mlg cycle l1 V=60 c_d=2890 $worn rtol=1e-7 | awk -F, 'NR == 3 { print $1 }')
    fine=$(mlg cycle l1 V=60 c_d=2890 $worn | awk -F, 'NR == 3 { print $1 }')
  }
  [ "$rough" != "$fine" ]
  awk -v a="$rough" -v b="$fine" 'BEGIN { exit !((a / b - 1) ^ 2 < 1e-10) }'
}

@test "a law that lacks something ends AUTO's run, too" {
  sed 's/^PAR .*/PAR  = {"V": 1.0, "T_psi": 10.0}/; s/.c_d.: 3.6e4//' constants/c.l1.straight >fort.2
  : >fort.3
  build/models/l1.exe >auto.log 2>&1 || true
  grep -F 'needs v_f above 0' auto.log
}

@test "linear tools say what they took" {
  run --separate-stderr -0 mlg intervals l1 g_psi=0.004 T_psi=5 v_f=0.1 c_2=3
  # shellcheck disable=SC2154 # bats sets it
  [ "$(grep -c 'is left out: play and friction have no linearisation at rest' <<<"$stderr")" -eq 2 ]
  grep -q 'c_2 = 3 is taken as it is at rest' <<<"$stderr"
  [ "$output" = "$(mlg intervals l1)" ]
}

@test "no Hopf point of a straight run is stepped over, with friction, rounded play or an orifice either" {
  local gear="c_d=36557.98632 e=0.1377492718 l=0.2077959175 k_psi=310919.8512 M=24452.48573" c_psi
  # two points within a step, of which AUTO would label one
  # shellcheck disable=SC2086 # words
  auto_run rubs l1.straight $gear T_psi=0.01 v_f=0.05 DSMAX=0.2 UZSTOP="{'V': 60.0}" | grep 'that AUTO had stepped over'
  c_psi=300.2
  # shellcheck disable=SC2086
  near_each 1e-6 "the point" < <(paste -d ' ' <(values rubs HB V) <(mlg hopf l1 $gear c_psi=$c_psi V_top=60 | sed 1,2d | cut -d , -f 2))
  [ "$(values rubs HB V | wc -l)" -eq 3 ]
  auto_run rounded l1.straight c_d=3e4 k_psi=555744 g_psi=0.002 corner=3 c_2=100 DSMAX=0.5 UZSTOP="{'V': 100.0}" >/dev/null
  near_each 1e-6 "the point" < <(paste -d ' ' <(values rounded HB V) \
    <(mlg hopf l1 c_d=3e4 k_psi="$(awk 'BEGIN { printf "%.12g", 555744 * (1 - 1 / sqrt(10)) }')" V_top=100 | sed 1,2d | cut -d , -f 2))
}

@test "every law can be given and continued by its name, in every layout" {
  local design layout law value lasting
  while read -r design; do
    layout=${design%% *}
    for law in g_psi:0.005 g_s:0.004363 T_f:5 T_psi:5 c_2:500 T_max:1900 k_s3:1e8 k_d3:1e8 corner:0.3 v_f:0.2 c_r:200; do
      value=${law#*:} law=${law%:*}
      case $layout.$law in l1.g_s | l1.k_s3) continue ;; esac
      lasting="V=60 corner=0.2 v_f=0.1 c_r=100 T_max=2000 T_psi=2"
      [ "$law" != g_s ] || lasting+=" g_s=0.002"
      # shellcheck disable=SC2086 # words
      # shellcheck disable=SC2046,SC2086
      scripts/play.sh every "$layout" along="$law" to="$value" ${design#* } $(tr ' ' '\n' <<<"$lasting $worn" | grep -v "^$law=") \
        NPR=0 rtol=1e-8 $([[ $law =~ ^(corner|v_f|c_r|g_psi|T_max|T_psi|g_s)$ ]] && tr ' ' '\n' <<<"$lasting $worn" | grep "^$law=") >play.out 2>&1 ||
        { echo "$layout $law"; cat play.out; return 1; }
      near "$(tail -n 1 build/tables/every.csv | cut -d, -f6)" "$value" 1e-6 "$layout along $law"
    done
  done < <(designs | sed -n '4p;7p')
}

## Cycles

@test "the command of the guide: from a history to a branch, with its fold" {
  examples docs/joints.md 1 1 >example.sh
  bash -eu example.sh > play.out
  near "$(value worn LP T_psi)" 84.0 0.01 "friction at the fold"
  grep -q '^  fold at T_psi = 84.0' play.out
  # beyond the fold it becomes small, and no longer reaches the ends of the gap
  grep -q '^  grazing between T_psi = [78].* and [78].*: 4 passages of the ends of the gap become 0' play.out
  grep -vE '^(#|label)' <(mlg grazing worn T_psi) | awk -F, '
    $3 != (last == "" ? $3 : last) { changes++; if (before * $4 > 0) exit wrong = 1 }
    { last = $3; before = $4 } END { exit wrong || !changes }'
  near "$(mlg grazing worn T_psi | sed -n 3p | cut -d , -f 3)" "$(cell corners cycle l1 V=60 c_d=2890 g_psi=0.004363 psi=0.05)" 0 passages
}

@test "AUTO's cycles with rounded corners are those of integration with sharp ones, to 1e-4 and better" {
  local design layout words sharp rounded n=0
  while read -r design; do
    layout=${design%% *}
    words="${design#* } $worn"
    # the end of a branch: its first point is the integrated orbit itself
    # shellcheck disable=SC2086 # words
    {
      sharp=$(mlg cycle "$layout" V=45 $words | awk -F, 'NR == 3 { print $1, $3 }')
      scripts/play.sh round "$layout" along=V to=45 V=40 $words corner=0.003 >/dev/null
    }
    rounded=$(mlg pick build/tables/round.csv columns=period,psi_max | tail -n 1 | tr , ' ')
    near "${rounded% *}" "${sharp% *}" 5e-5 "period of $design"
    near "${rounded#* }" "${sharp#* }" 5e-5 "psi of $design"
    n=$((n + 1))
  done < <(designs | sed -n '1,5p')
  [ "$n" -eq 5 ]
}

@test "as the corners become sharp AUTO's cycle goes to the sharp one, nearly as the square of their width" {
  local sharp corner psi
  sharp=$(cell psi_max cycle l1 V=60 c_d=2890 g_psi=0.004363 psi=0.05)
  scripts/play.sh sharper l1 along=corner to=0.001 V=60 c_d=2890 corner=0.02 g_psi=0.004363 psi=0.05 NTST=120 DSMAX=0.05 \
    UZR="{'corner': [0.01, 0.005]}" > /dev/null
  while IFS=, read -r corner psi; do
    awk -v a="$psi" -v b="$sharp" -v corner="$corner" 'BEGIN { x = (a / b - 1) / corner ^ 2; print corner, x; exit !(x > 0.9 && x < 2.5) }'
  done < <(mlg pick build/tables/sharper.csv where=type=UZ columns=corner,psi_max)
  near "$(mlg pick build/tables/sharper.csv columns=psi_max | tail -n 1)" "$sharp" 1e-5 "psi at 0.001"
}

@test "a branch ends where integration says, along play, friction, orifice and damping" {
  local along to last
  while read -r along to; do
    # shellcheck disable=SC2086 # words
    scripts/play.sh there l2 along="$along" to="$to" V=60 c_d=8000 k_s=7.86e5 v_f=0.05 corner=0.01 $worn >/dev/null
    last=$(mlg pick build/tables/there.csv columns=psi_max | tail -n 1)
    # shellcheck disable=SC2046,SC2086
    near "$(cell psi_max cycle l2 settle=60 "$along=$to" $(printf '%s\n' V=60 c_d=8000 k_s=7.86e5 v_f=0.05 corner=0.01 $worn |
      grep -v "^$along="))" "$last" 5e-5 "psi at $along = $to"
  done <<'EOF'
g_psi 0.012
T_psi 40
T_f 100
c_2 3000
c_d 15000
V 90
EOF
}

@test "what no periodic orbit is: a torus, irregular, at rest within the gap, or too many steps" {
  local middle="k_s=2.48e6 b=140 c_d=12600.6" best="k_s=1404610 b=140 c_d=15288.4"
  # shellcheck disable=SC2086 # words
  {
    run -1 mlg cycle li2 $middle V=150 g_psi=0.0130899694 psi=0.05 rtol=1e-8
    [[ $output == "mlg cycle: the oscillation is quasi-periodic, a torus: maxima of psi from 0.68"*", modulated at 0.69"*" Hz;"* ]]
    run -0 mlg cycle li2 motion $best V=50 g_psi=0.015271631 psi=0.05 rtol=1e-8
    [[ ${lines[2]} == irregular,* ]]
    awk -F, '{ exit !($6 > 0.5 && $3 > 2 * 0.875) }' <<<"${lines[2]}" # it leaves the gap
    run -1 mlg cycle li2 $best V=170 g_psi=0.002181661565 psi=0.05 rtol=1e-8
    [[ $output == "mlg cycle: the oscillation dies out: maxima of psi from 0.0"* ]] # slowly, in a gap of 0.125 degrees
    run -1 mlg cycle l1 V=60 c_d=2890 $worn steps=1000
    [[ $output == "mlg cycle: t = "*" s: the steps are used up (steps= allows more)" ]]
  }
}

@test "an orbit is of its least period, and its multipliers do not hang on the tolerance" {
  local multiplier
  # the run comes back within 0.02 after four maxima before it does after one
  [ "$(cell maxima cycle l1 V=20 c_d=2886.7 g_psi=0.001 T_f=100 v_f=0.01 psi=0.05)" = 1 ]
  multiplier=$(cell multiplier cycle li2 k_s=2.48e6 b=140 c_d=12600.6 V=110 g_psi=0.002181661565 psi=0.05)
  near "$(cell multiplier cycle li2 k_s=2.48e6 b=140 c_d=12600.6 V=110 g_psi=0.002181661565 psi=0.05 rtol=1e-8)" "$multiplier" 1e-4 multiplier
}

@test "the torus begins where AUTO's multipliers leave the unit circle" {
  local V
  scripts/play.sh torus li2 along=V to=140 V=130 k_s=2.48e6 b=140 c_d=12600.6 g_psi=0.0174532925 corner=0.02 psi=0.05 > play.out
  V=$(sed -n 's/.*torus point between V = //p' play.out)
  near "${V% and *}" 135.3 5e-3 "the torus point, or just before"
  near "${V#* and }" 135.3 1e-2 "the torus point, or just behind"
  run -0 mlg cycle li2 motion k_s=2.48e6 b=140 c_d=12600.6 g_psi=0.0174532925 corner=0.02 psi=0.02 rtol=1e-8 V=140
  awk -F, '{ exit !($2 > 0.85 && $2 < 0.99 * $3) }' <<<"${lines[2]}" # a torus, or locked on it
  [ "$(cell maxima cycle li2 k_s=2.48e6 b=140 c_d=12600.6 g_psi=0.0174532925 corner=0.02 psi=0.02 rtol=1e-8 V=130)" = 1 ]
}

@test "describing functions are near the cycles, nearer where the motion is one harmonic" {
  local exact
  exact=$(cell psi_max cycle l1 V=60 c_d=2890 g_psi=0.004363 psi=0.05)
  near "$(cell psi joints l1 V=60 c_d=2890 g_psi=0.004363)" "$exact" 0.1 "psi beside a gap"
  # an orifice on the gear of Figure 6: smooth, and nearly one harmonic
  exact=$(cell psi_max cycle l1 V=20 c_d=1000 c_2=2000 psi=0.05 settle=60)
  near "$(cell psi joints l1 V=20 c_d=1000 c_2=2000)" "$exact" 0.1 "psi with an orifice"
}

@test "the equivalent gear of one amplitude has the closed forms" {
  local psi=0.0174532925199433 w
  w=$(cell frequency_hz joints l1 at=1 V=60 T_psi=100 v_f=1e-3 c_d=3000)
  near "$(cell c_psi joints l1 at=1 V=60 T_psi=100 v_f=1e-3 c_d=3000)" \
    "$(awk "BEGIN { pi = atan2(0, -1); print 300 + 4 * 100 / (pi * 2 * pi * $w * $psi) }")" 1e-3 "friction: 4 T A a cycle"
  # an orifice without linear part, c_2 of the mean damping 8/(3 pi) c_2 w A
  awk -v c="$(cell c_d joints l1 at=1 V=60 c_d=0 c_2=2000)" 'BEGIN { exit !(c > 1000 && c < 8 / (3 * 3.14159) * 2000 * 2 * 3.14159 * 9 * 0.01745) }'
  # twice the play at twice the amplitude is the same gear
  near "$(cell k_psi joints l2 at=2 V=60 k_s=7.86e5 c_d=8000 g_psi=0.02)" \
    "$(cell k_psi joints l2 at=1 V=60 k_s=7.86e5 c_d=8000 g_psi=0.01)" 1e-9 "k_psi"
}

## What is looked for by halving

@test "decay refuses in one line, and says what happens at the ends" {
  refuses "*expected NAME=FROM:TO, the value that is looked for*" mlg decay l1 V=60
  refuses "*'T_psi=5:1': expected NAME=FROM:TO, FROM below TO" mlg decay l1 T_psi=5:1 v_f=0.1
  refuses "*'T_psi=0:9' is looked for already" mlg decay l1 T_psi=0:9 release=1:2 v_f=0.1
  refuses "*T_f, T_psi) needs v_f above 0*" mlg decay l1 T_psi=0:9
  refuses "*'release=1:200': outside its range*" mlg decay l1 release=1:200
  refuses "*'cycles=1': at= asks for one amplitude*" mlg joints l1 V=10:20:2 at=1 cycles=1
  refuses "*'cycles=1': goes with a range NAME=FROM:TO:N; *" mlg joints l1 cycles=1
  refuses "*'near=3': goes with at=DEGREES" mlg joints l1 near=3
  refuses "*'settle=3': goes with cycles=1" mlg joints l1 V=20:60:2 settle=3
  refuses "*'psi_most=1': at= asks for one amplitude*" mlg joints l1 at=1 psi_most=1
  refuses "*'points=20': goes with ?mlg cycle LAYOUT orbit?" mlg cycle l1 motion psi=0.05 points=20
  refuses "*'motoin': expected NAME=NUMBER; ?mlg help cycle? has its other words" mlg cycle l1 motoin psi=0.05
  refuses "*'steps=0': outside its range, 1 to 1e+12" mlg cycle l1 motion psi=0.05 steps=0
  refuses "*'longest=29': outside its range, 30 to 1e+06 s" mlg search l1 c_lo=1e3 c_hi=1e4 longest=29
  refuses "*'along=F_z': not a parameter of AUTO's*" scripts/play.sh odd l1 along=F_z to=2e5 psi=0.05
  refuses "*'along=NMX': not a parameter of AUTO's*" scripts/play.sh odd l1 along=NMX to=5 psi=0.05
  run -0 --separate-stderr mlg decay l1 V=170 c_d=2890 g_psi=0.004363 v_f=0.01 T_psi=100:200 # it dies out at both
  [ "${lines[1]}" = ",dies,dies,,dies,dies" ] && [ -z "$stderr" ]
  [ "$(mlg decay l1 T_psi=100:200 V=150:170:2 c_d=2890 g_psi=0.004363 v_f=0.01 | tail -n 1)" = "170,,dies,dies,,dies,dies" ] # in any order
  # AUTO's fold of cycles, of the same v_f (docs/joints.md)
  near "$(cell T_psi decay l1 V=60 c_d=2890 g_psi=0.004363 v_f=0.05 T_psi=83.5:84.5)" 84.0 2e-3 "friction from which on it dies"
}

@test "a map at one amplitude has the mode that grows fastest" {
  local growth
  growth=$(mlg joints l1 V=20:60:2 c_d=1 c_2=3000 at=1 | sed -n 2p)
  near "$(cut -d, -f2 <<<"$growth")" "$(cell growth joints l1 V=20 c_d=1 c_2=3000 at=1 near="$(cut -d, -f3 <<<"$growth")")" 1e-5
}

## Tables of record

# Sets c_d, and words: the gear of choice middle but for it, and these
middle() { # LAYOUT [WORD...]
  local k_s b
  case $1 in
    li3) k_s=718567 b=28.77 c_d=10455 ;;
    *) IFS=, read -r k_s b c_d < <(mlg pick "$ROOT/results/damping.csv" where=layout="$1" where=choice=middle columns=k_s,b,c_d) ;;
  esac
  words=("$1" k_s="$k_s" b="$b" "${@:2}")
}

rad() { awk "BEGIN { printf \"%.10g\", $1 * atan2(0, -1) / 180 }"; }

# c_2 of a damper that has in the mean c at 1 degree and 11 Hz
quadratic() { awk "BEGIN { print 3 * $1 / (8 * 2 * 11) * 180 / atan2(0, -1) }"; }

# The largest psi in the last second of so many after a release of psi, DEGREES
after() { # SECONDS DEGREES WORD...
  mlg simulate "${words[0]}" history "${words[@]:1}" "${@:3}" psi="$(rad "$2")" t_end="$1" dt=0.005 rtol=1e-9 | awk -F, -v end="$1" '
    /^#/ { next } !place { for (k = 1; k <= NF; k++) if ($k == "psi") place = k; next }
    $1 > end - 1 && $place * $place > most { most = $place * $place } END { print sqrt(most) }'
}

sample() { # N TABLE CONDITION (of awk): rows of results/TABLE.csv, others with another SEED
  awk -F, "/^l[1-9i]/ && ($3)" "$ROOT/results/$2.csv" | shuf -n "$1" --random-source=<(yes "${SEED:-1}")
}

@test "samples of the amplitudes of record, by integration from another start" {
  local layout V g psi n=0
  while IFS=, read -r layout _ V g _ _ psi _; do
    middle "$layout"
    near "$(cell psi_max cycle "${words[@]}" c_d="$c_d" V="$V" g_psi="$g" psi=0.03 settle=60)" "$psi" 3e-4 "psi of $layout at V = $V, play $g"
    n=$((n + 1))
  done < <(sample 4 joints '$2 == "middle" && $7 > 0 && $3 >= 50 && $3 <= 130')
  [ "$n" -eq 4 ]
}

@test "samples of the play that shimmies 0.1 degree beyond itself, and of the planes, by integration at other plays" {
  local layout V at ratio g n=0
  while IFS=, read -r layout _ V _ _ g; do
    middle "$layout"
    near "$(cell psi_max cycle "${words[@]}" c_d="$c_d" V="$V" g_psi="$(rad "$g")" psi=0.03 settle=40)" "$(awk "BEGIN { print $g + 0.1 }")" 0.02 "psi of $layout at V = $V, play $g"
    n=$((n + 1))
  done < <(sample 2 joints_play '$2 == "middle" && $3 >= 40 && $6 > 0')
  while IFS=, read -r layout V at _ ratio; do
    middle "$layout"
    near "$(cell psi_max cycle "${words[@]}" c_d="$at" V="$V" g_psi="$(rad 0.3)" psi=0.02 settle=40)" "$(awk "BEGIN { print 0.3 * $ratio }")" 0.02 "psi of $layout at V = $V, c_d = $at"
    n=$((n + 1))
  done < <(sample 3 joints_planes_cycles '$4 != "inf" && $5 > 1 && $5 < 2.2 && $2 > 30')
  [ "$n" -eq 5 ]
}

@test "samples of the plane by describing functions: again, and by integration" {
  local layout V at ratio psi n=0
  while IFS=, read -r layout V at ratio; do
    middle "$layout"
    near "$(cell psi joints "${words[@]}" c_d="$at" V="$V" g_psi="$(rad 0.2)")" "$(awk "BEGIN { print 0.2 * $ratio }")" 1e-4 "psi of $layout at V = $V, c_d = $at"
    psi=$(cell psi_max cycle "${words[@]}" c_d="$at" V="$V" g_psi="$(rad 0.1)" psi=0.01 settle=40)
    near "$psi" "$(awk "BEGIN { print 0.1 * $ratio }")" 0.3 "psi of $layout at V = $V, c_d = $at by integration"
    n=$((n + 1))
  done < <(sample 3 joints_planes '$4 > 0 && $4 < 4 && $2 > 30 && $2 < 140')
  [ "$n" -eq 3 ]
}

@test "samples of where shimmy begins without play: one eigenvalue at the margin, no other beyond it" {
  local layout V at k_s b n=0
  while IFS=, read -r layout _ V at; do
    middle "$layout"
    case $layout in l1) set -- ;; *) set -- "${words[@]:1}" ;; esac
    "$ROOT/build/bin/eigen-$layout" eigenvalues "$@" V="$V" c_d="$at" | awk -v at="$layout at V = $V, c_d = $at" '
      NR == 2 || (NR > 2 && $1 > most) { most = $1 } END { if (!(NR > 5 && most ^ 2 < 1e-6)) { print at ": " most; exit 1 } }'
    n=$((n + 1))
  done < <(sample 8 joints_planes_hopf '$3 > 0')
  [ "$n" -eq 8 ]
}

@test "samples of the friction of record: with a little less shimmy goes on, with a little more it dies out" {
  local layout V g T n=0
  while IFS=, read -r layout V g T _; do
    middle "$layout" V="$V" g_psi="$g" v_f=0.01
    awk -v less="$(after 20 5 c_d="$c_d" T_psi="$(awk "BEGIN { print 0.95 * $T }")")" -v more="$(after 20 5 c_d="$c_d" T_psi="$(awk "BEGIN { print 1.05 * $T }")")" \
      -v g="$g" 'BEGIN { exit !(less > g && more < g / 2) }' || { echo "$layout V=$V g=$g T=$T"; return 1; }
    n=$((n + 1))
  done < <(sample 4 joints_friction '$1 != "li2" && $4 > 20')
  [ "$n" -eq 4 ]
}

@test "samples of friction of the device and of quadratic dampers, by integration from another start" {
  local layout V g T psi n=0
  while IFS=, read -r layout V g T _ _ psi _; do
    middle "$layout"
    near "$(cell psi_max cycle "${words[@]}" c_d="$c_d" V="$V" g_psi="$g" T_f="$T" v_f=0.01 psi=0.04 settle=40)" "$psi" 2e-3 "psi of $layout at T_f = $T, play $g"
    n=$((n + 1))
  done < <(sample 2 joints_device '$3 > 0 && $7 > 0 && $9 < 0.997')
  while IFS=, read -r layout _ V _ psi _; do
    middle "$layout"
    near "$(cell psi_max cycle "${words[@]}" c_d=1 c_2="$(quadratic "$c_d")" V="$V" psi=0.01 settle=40)" "$psi" 2e-3 "psi of $layout with a quadratic damper at V = $V"
    n=$((n + 1))
  done < <(sample 2 joints_dampers '$2 == "quadratic" && $5 > 0.1 && $3 > 20')
  [ "$n" -eq 4 ]
}

@test "samples of the disturbances of record: a little less dies, a little more goes on" {
  local layout V T release c_r n=0
  while IFS=, read -r layout V T release _; do
    middle "$layout" V="$V" g_psi="$(rad 0.25)" v_f=0.01 T_psi="$T"
    awk -v less="$(after 20 "0.97 * $release" c_d="$c_d")" -v more="$(after 20 "1.03 * $release" c_d="$c_d")" -v g="$(rad 0.25)" \
      'BEGIN { exit !(less < g / 2 && more > g) }' || { echo "$layout V=$V T=$T"; return 1; }
    n=$((n + 1))
  done < <(sample 2 joints_thresholds '$4 > 0')
  while IFS=, read -r layout _ V _ _ release _; do # of relief valves
    middle "$layout" V="$V" T_max=2000
    c_r=$(awk "BEGIN { print $c_d / 100 }")
    awk -v less="$(after 10 "0.97 * $release" c_d="$c_d" c_r="$c_r")" -v more="$(after 10 "1.03 * $release" c_d="$c_d" c_r="$c_r")" 'BEGIN { exit !(more > 3 * less) }'
    n=$((n + 1))
  done < <(sample 1 joints_dampers '$2 == "relief" && $6 > 0')
  [ "$n" -eq 3 ]
}

@test "what a quadratic damper leaves: nothing grows within, at each of the three amplitudes, and the growth is the eigenvalues'" {
  local layout psi lo hi c growth row V hz n=0
  while IFS=, read -r layout psi lo hi _; do
    middle "$layout"
    while read -r c growth; do
      row=$(mlg joints "${words[@]}" c_d=1 c_2="$(quadratic "$c")" at="$psi" V=2:200:67 | sed 1d | sort -t, -g -k2 | tail -n 1)
      awk -v growth="$growth" -v x="$(cut -d, -f2 <<<"$row")" 'BEGIN { exit !(growth * x > 0) }' || { echo "$layout, psi $psi, c $c: $row"; return 1; }
    done < <(awk "BEGIN { print 0.99 * $lo, 1; print 1.01 * $lo, -1; print 0.99 * $hi, -1; print 1.01 * $hi, 1 }")
    # the equivalent gear of the last row, whose eigenvalue is its growth
    IFS=, read -r V growth hz _ <<<"$row"
    c=$(cell c_d joints "${words[@]}" c_d=1 c_2="$(quadratic "$(awk "BEGIN { print 1.01 * $hi }")")" at="$psi" V="$V" near="$hz")
    near "$(mlg eigenvalues "${words[@]}" c_d="$c" V="$V" | awk -F, -v hz="$hz" 'NR > 1 && ($3 - hz) ^ 2 < 1e-4 { print $1; exit }')" "$growth" 1e-3 "growth"
    n=$((n + 1))
  done < <(sample 1 joints_quadratic '$3 > 0')
  [ "$n" -eq 1 ]
}

@test "the starts of record: the first of each layout again, and as many as certification's 40" {
  local layout
  for layout in l1 l2 li1 li2 li3; do [ "$(grep -c "^$layout," "$ROOT/results/joints_starts.csv")" -eq 40 ] || return 1; done
  layout=$(printf '%s\n' l1 l2 li1 li2 | shuf -n 1 --random-source=<(yes "${SEED:-1}"))
  . scripts/auto/lib.sh
  paper_gear "$layout"
  near_each 1e-3 "a start of $layout" < <(mlg search "$layout" k_s="$k_s" b="$b" c_lo="$c_lo" c_hi="$c_hi" g_psi="$(rad 0.25)" corner=0.02 T_psi=300 v_f=0.05 \
    starts=1 longest=120 | tail -n 1 | tr , '\n' | sed -n '1p;2p;3p' | paste -d' ' - <(grep "^$layout," "$ROOT/results/joints_starts.csv" | head -n 1 | tr , '\n' | sed -n '2,4p'))
}
