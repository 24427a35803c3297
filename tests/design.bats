# design.bats - designs under loads, tolerances and spreads (docs/design.md)
#
# Answers of mlg loads, elasticities, tolerance and probability against the eigenvalue oracle
# (tests/eigen.c), which shares nothing with them, and against differences of other commands.
#
# Needs   make test-programs
# Writes  build/tests/design

bats_require_minimum_version 1.5.0

setup_file() {
  load scratch
  scratch design
}

setup() {
  load scratch
  cd "$SCRATCH" || return
}

# oracle_shimmies LAYOUT WORD...: whether some eigenvalue has its real part above 0 at some V from
# 0.1 to 200, or from LEAST to MOST, by the oracle
oracle_shimmies() {
  local layout=$1
  shift
  [ "$("build/bin/eigen-$layout" boundary free=V from="${LEAST:-0.1}" to="${MOST:-200}" step="${STEP:-0.2}" "$@" | sed 1d | wc -l)" -gt 0 ] ||
    "build/bin/eigen-$layout" eigenvalues V="${LEAST:-100}" "$@" | awk 'NR > 1 && $1 > 1e-9 { n++ } END { exit !n }'
}

oracle_is_free() { if oracle_shimmies "$@"; then echo "shimmy at $*"; return 1; fi; }

value_of() { # NAME: the default of models/mlg.h
  case $1 in F_z) echo 200000 ;; *) mlg gearinfo | awk -F, -v name="$1" '$1 == name { print $2 }' ;; esac
}

# corner_words P DESIGN... -- CORNER: the words of the gear at the corner "F_z+ k_t- ..." of the box of P %
corner_words() {
  local p=$1 design=' ' part name value word
  shift
  while [ "$1" != -- ]; do design+="$1 "; shift; done
  shift
  for part in "$@"; do
    name=${part%[+-]}
    case $design in *" $name="*) value=${design#*" $name="} value=${value%% *} ;; *) value=$(value_of "$name") ;; esac
    value=$(awk -v x="$value" -v p="$p" -v s="${part: -1}" 'BEGIN { printf "%.15g", x * (1 + (s == "+" ? p : -p) / 100) }')
    [ "$name" != F_z ] || { name=M value=$(awk -v F="$value" 'BEGIN { printf "%.15g", F / 9.81 - 500 }'); }
    echo "$name=$value"
  done
  for word in $design; do
    case " $* " in *" ${word%%=*}"[+-]" "*) ;; *) echo "$word" ;; esac
  done
}

@test "elasticities are the differences of intervals and of the least damping ratio" {
  local case layout words name value lo hi zeta c_d others sign at word n=0
  for case in "l1" "l2 k_s=5e5" "li1 k_s=6e5 b=140" "li2 k_s=1.5e6 b=100"; do
    read -r layout words <<< "$case"
    # shellcheck disable=SC2086 # one word for each parameter
    mlg elasticities "$layout" $words > table
    c_d=$(sed -n '1s/.*c_d = //p' table)
    while IFS=, read -r name value _ lo hi zeta; do
      [ -n "$lo" ] || continue
      n=$((n + 1))
      [ $((n % 3)) = 0 ] || [ "$name" = F_z ] || continue # a third of them, others for each layout
      [ "$name" != g ] || continue # differenced with M fixed it is F_z and what hangs on m_D
      others=''
      for word in $words; do case $word in "$name="*) ;; *) others+="$word " ;; esac; done
      for sign in - +; do
        at=$(awk -v x="$value" -v s="$sign" 'BEGIN { printf "%.15g", x * (1 + (s == "+" ? 1 : -1) * 1e-5) }')
        # shellcheck disable=SC2086
        {
          mlg intervals "$layout" $others "$name=$at" | sed -n 3p > "interval$sign"
          mlg damping "$layout" $others "$name=$at" c_d="$c_d" V_least=0.3 | sed -n 2p > "best$sign"
        }
      done
      paste -d , interval- interval+ best- best+ | awk -F, -v name="$layout $name" -v lo="$lo" -v hi="$hi" -v zeta="$zeta" '
        function log_slope(a, b) { return (b - a) / (a + b) / 1e-5 }
        function far(x, y, least) { return (x - y) ^ 2 > (2e-3 * (x < 0 ? -x : x) + least) ^ 2 }
        { a = log_slope($1, $8); b = log_slope($2, $9); z = log_slope($15, $20) }
        far(lo, a, 2e-4) || far(hi, b, 2e-4) || far(zeta, z, 2e-3 * (zeta > 1 || zeta < -1 ? 1 : 1)) {
          print name ": " lo " " hi " " zeta ", differences " a " " b " " z; bad = 1 }
        END { exit bad || NR != 1 }'
    done < <(sed 1,2d table)
  done
}

@test "no corner shimmies a little inside the tolerance, by the oracle, and the named one does outside" {
  local case layout words p V corner sign random outside inside
  for case in "l1 c_d=2774" "l2 k_s=4.954e5 c_d=6292" "li2 k_s=989006 b=98 c_d=8016"; do
    read -r layout words <<< "$case"
    # shellcheck disable=SC2086
    {
      IFS=, read -r _ _ _ p V _ corner _ < <(mlg tolerance "$layout" $words sample=0 | sed 1,2d)
      outside=$(corner_words "$(awk "BEGIN { print 1.01 * $p }")" $words -- $corner)
      inside=$(corner_words "$(awk "BEGIN { print 0.99 * $p }")" $words -- $corner)
    }
    # shellcheck disable=SC2086
    LEAST=$(awk "BEGIN { print $V - 3 }") MOST=$(awk "BEGIN { print $V + 3 }") STEP=0.01 oracle_shimmies "$layout" $outside
    # shellcheck disable=SC2086
    LEAST=$(awk "BEGIN { print $V - 3 }") MOST=$(awk "BEGIN { print $V + 3 }") STEP=0.01 oracle_is_free "$layout" $inside
    for random in 1 2 3; do
      sign=$(awk -v seed="$random" -v text="$corner" 'BEGIN { srand(seed); n = split(text, part, " ")
        for (i = 1; i <= n; i++) { sub(/[+-]$/, "", part[i]); printf "%s%s ", part[i], rand() < 0.5 ? "+" : "-" } }')
      # shellcheck disable=SC2086,SC2046
      oracle_is_free "$layout" $(corner_words "$(awk "BEGIN { print 0.99 * $p }")" $words -- $sign)
    done
  done
}

@test "the design of the largest tolerance: as found once, and none beside it is better" {
  local k_s b c_d p f g
  near "$(cell p tolerance l1 best sample=0)" 0.135135 1e-5 "p of L1"
  near "$(cell p tolerance l2 best sample=0)" 0.486101 1e-5 "p of L2"
  # LI2 at b = 140 is searched for in study.bats; here the design of record over b
  IFS=, read -r k_s b c_d p < <(awk -F, '$1 == "li2" && $2 == "tolerant_b" { print $3 "," $4 "," $5 "," $6 }' "$ROOT/results/tolerance.csv")
  near "$(cell p tolerance li2 b="$b" sample=0 k_s="$k_s" c_d="$c_d")" "$p" 1e-6 "p of LI2 over b"
  while read -r f g; do
    awk -v p="$p" -v other="$(cell p tolerance li2 b="$b" sample=0 k_s="$(awk "BEGIN { print $f * $k_s }")" c_d="$(awk "BEGIN { print $g * $c_d }")")" \
      'BEGIN { print p, other; exit !(other < p) }'
  done <<< $'1.02 1\n1 0.98\n0.99 1.01'
}

@test "where every c_d is free the best damped one stands for the interval" {
  local c_d
  mlg intervals l1 M=500 | sed -n 3p | grep -q '^0,inf,'
  c_d=$(cell c_d damping l1 best M=500)
  near "$(mlg elasticities l1 M=500 | sed -n '1s/.*c_d = //p')" "$c_d" 1e-6 c_d
  near "$(mlg tolerance l1 M=500 sample=0 | sed -n 3p | cut -d, -f3)" "$c_d" 1e-6 c_d
  echo "PAR = {'M': 500.0 kg}" > light
  near "$(mlg loads l1 gear=light from=1e4 to=1.1e4 | sed -n 3p | cut -d, -f8)" "$c_d" 1e-6 c_d
}

@test "a map is the tolerance of its designs" {
  local k_s c_d p n=0
  mlg tolerance l2 map k_s=4.9e5:1e6:4 > nodes
  while IFS=, read -r k_s _ c_d p; do
    [ "$p" != 0 ] || continue
    near "$(cell p tolerance l2 k_s="$k_s" c_d="$c_d" sample=0)" "$p" 1e-3 "p at k_s = $k_s"
    n=$((n + 1))
  done < <(sed 1,2d nodes)
  [ "$n" -gt 2 ]
}

@test "loads: intervals at a load, the design of a range, the largest load" {
  local F c_d k_s best f
  near "$(mlg loads l2 k_s=7e5 from=150e3 to=190e3 step=20e3 | sed -n 4p | cut -d, -f4)" \
    "$(cell c_lo intervals l2 k_s=7e5 F_z=170e3)" 1e-9 "c_lo at 170 kN"
  # a gear file's own load is in no way
  printf 'PAR = {"F_z": 150000 N}\n' | tr '"' "'" > gear
  mlg loads l2 gear=gear k_s=7e5 c_d=8e3 from=150e3 to=190e3 step=20e3 > rows
  mlg loads l2 k_s=7e5 c_d=8e3 from=150e3 to=190e3 step=20e3 | cmp - rows
  mlg loads l1 largest gear=gear > rows
  mlg loads l1 largest | cmp - rows
  # at its largest load a layout bears, and no more
  F=$(cell F_z loads l1 largest)
  near "$F" 201251.17 1e-7 "largest load of L1"
  near "$(cell F_z loads l2 largest)" 204504.53 1e-7 "largest load of L2"
  near "$(cell F_z loads li1 largest b=140)" 207774.71 1e-6 "largest load of LI1 at b = 140"
  c_d=$(cell c_d loads l1 largest)
  oracle_shimmies l1 c_d="$c_d" M="$(awk "BEGIN { printf \"%.12g\", 1.001 * $F / 9.81 - 500 }")"
  oracle_is_free l1 c_d="$c_d" M="$(awk "BEGIN { printf \"%.12g\", 0.999 * $F / 9.81 - 500 }")"
  # the least ratio over a range of loads, and no c_d beside has a better one
  mlg loads l2 over from=180e3 to=200e3 step=1e3 > rows
  best=$(sed 1,2d rows | cut -d, -f9 | sort -g | head -n 1)
  IFS=, read -r _ k_s _ _ _ _ _ c_d _ < <(sed -n 3p rows)
  for f in 0.99 1.01; do
    awk -v best="$best" -v other="$(mlg loads l2 k_s="$k_s" c_d="$(awk "BEGIN { print $f * $c_d }")" from=180e3 to=200e3 step=1e3 | sed 1,2d | cut -d, -f9 | sort -g | head -n 1)" \
      'BEGIN { print best, other; exit !(other < best) }'
  done
}

@test "the probability of shimmy is that of the intervals and Hopf points it is made of" {
  local c_lo c_hi at hopf edge F
  IFS=, read -r c_lo c_hi _ < <(mlg intervals l2 k_s=7e5 | sed -n 3p)
  printf 'c_d uniform 2e3 3e4\n' > spread
  mlg probability l2 k_s=7e5 c_d=8e3 spread=spread samples=20000 V_step=25 > table
  awk -F, -v lo="$c_lo" -v hi="$c_hi" '$1 == "any" { p = 1 - (hi - lo) / 28e3; print p, $0; exit !($4 < p && p < $5) }' table
  # V = 50: shimmy above the Hopf point in c_d
  IFS=, read -r at _ _ _ _ < <(mlg hopf l2 k_s=7e5 V=50 | sed 1,2d | awk -F, '$1 > 2e3 && $1 < 3e4')
  hopf=$(mlg hopf l2 k_s=7e5 V=50 | sed 1,2d | awk -F, '$1 > 2e3 && $1 < 3e4 { n++; row = $0 } END { print n == 1 ? row : "none" }')
  [ "$hopf" = none ] || awk -F, -v at="$at" -v side="${hopf##*,}" '$1 == "50" {
    p = side == "above" ? (3e4 - at) / 28e3 : (at - 2e3) / 28e3; print p, $0; exit !($4 < p && p < $5) }' table
  # a normal spread of the load: shimmy above the load that the device bears
  printf '# of the load\nF_z normal 0%% 1%%\n' > spread
  mlg probability l1 c_d=2774 spread=spread samples=20000 V_step=100 > table
  edge=$(for F in $(seq 200000 50 202000); do mlg intervals l1 F_z="$F" | sed 1,2d | awk -F, -v F="$F" '$1 < 2774 && 2774 < $2 { print F }'; done | tail -n 1)
  awk -F, -v edge="$edge" '
    function normal(x,  i, sum, term) { # 1/2 + integral from 0 to x of the density
      for (i = 0; i < 2000; i++) sum += exp(-((i + 0.5) * x / 2000) ^ 2 / 2) * x / 2000
      return 0.5 + sum / sqrt(2 * 3.14159265358979)
    }
    $1 == "any" { p = 1 - normal((edge + 25 - 200000) / 2000); print p, $0; exit !($4 - 0.005 < p && p < $5 + 0.005) }' table
}

@test "the same seed gives the same samples, another one others; no sample with shimmy is no certainty" {
  printf 'c_d uniform -1%% 1%%\nF_z uniform -0.5%% 0.5%%\n' > spread
  mlg probability l2 k_s=5e5 c_d=6300 spread=spread samples=2000 V_step=50 > one
  mlg probability l2 k_s=5e5 c_d=6300 spread=spread samples=2000 V_step=50 | cmp - one
  mlg probability l2 k_s=5e5 c_d=6300 spread=spread samples=2000 V_step=50 seed=2 > two
  run ! cmp -s one two
  awk -F, '$1 == 200 { exit !($2 == 0 && $3 == 0 && $4 == 0 && $5 > 0.0015 && $5 < 0.0025) }' one
}

@test "slips are refused in one line with status 2" {
  local slip
  printf 'c_d uniform 1 2\n' > spread
  printf 'c_d uniform 2 1\n' > backwards
  printf 'x uniform 1 2\n' > unknown
  printf 'c_d gauss 1 2\n' > kind
  printf 'c_d normal 1 0\n' > deviation
  printf 'V uniform 1 2\n' > speed
  printf 'c_d uniform 1 2\nc_d uniform 1 2\n' > twice
  printf 'F_z uniform 1e5 2e5\nM uniform 1e4 2e4\n' > load
  printf 'k_s uniform -1%% 1%%\n' > rigid
  printf '# nothing\n' > nothing
  printf 'c_d uniform 1\n' > short
  printf 'c_d uniform -5 2e3\n' > outside
  printf 'k_t normal 7e5 1e13\n' > wide
  printf 'F_z uniform 1e3 2e3\n' > light
  printf 'm_D uniform 9e5 1e6\nF_z normal 2e5 1\n' > heavy
  printf 'g_psi normal 0.01 0.001\n' > play
  printf 'c_delta normal 0 10%%\n' > mixed
  while read -r slip; do
    # shellcheck disable=SC2086 # one word for each argument
    run --separate-stderr build/bin/mlg $slip
    # shellcheck disable=SC2154 # set by run
    [ "$status" -eq 2 ] && [ "${#stderr_lines[@]}" -eq 1 ] && [ -z "$output" ] || { echo "$slip: status $status, $stderr, $output"; return 1; }
  done <<'END'
loads l1 from=2e5 to=1e5
loads l1 step=0
loads l1 step=1e-3
loads l1 F_z=2e5
loads l1 M=2e4
loads l1 V=3
loads l1 b_most=100
loads l2 widest k_s=5e5
loads l2 damped c_d=5e5
loads l2 over b_most=10
loads li1 widest b=3 b_most=10
loads li1 widest b_least=3
loads li1 largest b_least=3 b_most=2
loads l1 V_least=300
loads l1 best
elasticities l1 V=3
elasticities l1 x=3
elasticities l1 V_least=300
tolerance l1 V=3
tolerance l1 best c_d=3e3
tolerance l2 best k_s=3e5
tolerance l2 best b_most=3
tolerance li2 best b=3 b_most=4
tolerance li2 best b_least=3
tolerance li2 best b_least=3 b_most=2
tolerance li2 b_most=3
tolerance l1 sample=-1
tolerance l1 map
tolerance l2 map
tolerance l2 map k_s=1:2
tolerance l2 map k_s=2:1:5
tolerance l2 map k_s=0:1:5
tolerance l2 map k_s=1:2:500
tolerance l2 map k_s=1e5:2e5:3 b=0:1:3
tolerance l2 map k_s=1e5:2e5:3 k_s=1e5:2e5:3
tolerance l2 map k_s=1e5:2e5:3 c_d=3
tolerance l2 map e=0.1:0.2:3
tolerance li1 map b=0:2:3
probability l1
probability l1 spread=none
probability l1 spread=spread spread=spread
probability l1 spread=spread samples=0
probability l1 spread=spread seed=0
probability l1 spread=spread V_step=201
probability l1 spread=spread V_step=1e-3
probability l1 spread=spread V=3
probability l1 spread=backwards
probability l1 spread=unknown
probability l1 spread=kind
probability l1 spread=deviation
probability l1 spread=speed
probability l1 spread=twice
probability l1 spread=load
probability l1 spread=rigid
probability l2 c_d=5e3 k_s=inf spread=rigid
probability l1 spread=nothing
probability l1 spread=short
probability l1 spread=outside
probability l1 spread=wide
probability l1 spread=light
probability l1 spread=heavy
probability l1 spread=play
probability l1 spread=mixed
probability l1 spread=.
END
}

@test "what has no answer says so with status 1" {
  local none
  while read -r none; do
    # shellcheck disable=SC2086
    run --separate-stderr build/bin/mlg $none
    # shellcheck disable=SC2154
    [ "$status" -eq 1 ] && [ "${#stderr_lines[@]}" -eq 1 ] || { echo "$none: status $status, $stderr"; return 1; }
  done <<'END'
elasticities l1 F_z=2.1e5
elasticities l1 c_d=9e3
tolerance l1 F_z=2.1e5
tolerance l1 best F_z=2.1e5
loads l1 c_delta=0
loads l1 largest to=1.2e5 c_delta=0
END
}

# --- the tables of record -------------------------------------------------------------------------

# sampled FILE N SEED [WHERE...]: so many random rows of a table of results/, without its head
sampled() {
  mlg pick "$ROOT/results/$1" "${@:4}" | grep -v '^#' | awk -v n="$2" -v seed="$3" '
    BEGIN { srand(seed) } { row[++rows] = $0 } END { for (i = 0; i < n; i++) print row[1 + int(rand() * rows)] }'
}

device_words() { # LAYOUT K_S B
  case $1 in l1) ;; l2) echo "k_s=${2/inf/1e30}" ;; *) echo "k_s=${2/inf/1e30} b=$3" ;; esac
}

@test "random rows of results/loads.csv: the oracle finds shimmy outside the interval and none inside" {
  local layout F k_s b c_lo c_hi zeta c_d
  while IFS=, read -r layout _ F k_s b c_lo c_hi _ _ c_d zeta _; do
    mass="M=$(awk "BEGIN { printf \"%.12g\", $F / 9.81 - 500 }")"
    # shellcheck disable=SC2046
    {
      oracle_is_free "$layout" "$mass" c_d="$(awk "BEGIN { print $c_lo * 1.001 }")" $(device_words "$layout" "$k_s" "$b")
      STEP=0.1 oracle_shimmies "$layout" "$mass" c_d="$(awk "BEGIN { print $c_lo * 0.99 }")" $(device_words "$layout" "$k_s" "$b")
      [ -z "$zeta" ] || near "$(mlg damping "$layout" F_z="$F" c_d="$c_d" $(device_words "$layout" "$k_s" "$b") | sed -n 2p | cut -d, -f1)" "$zeta" 1e-4 "zeta at F_z = $F of $layout"
    }
  done < <(for choice in widest widest_b; do sampled loads.csv 1 1 'where=width>0' where=choice=$choice columns=layout,choice,F_z,k_s,b,c_lo,c_hi,width,ratio,c_d,zeta,V; done)
}

@test "random largest loads of results/loads.csv: free of shimmy a little below, by the oracle" {
  local layout F k_s b c_d
  while IFS=, read -r layout F k_s b c_d; do
    # shellcheck disable=SC2046
    oracle_is_free "$layout" M="$(awk "BEGIN { printf \"%.12g\", 0.9995 * $F / 9.81 - 500 }")" c_d="$c_d" $(device_words "$layout" "$k_s" "$b")
  done < <(for choice in largest largest_b; do sampled loads.csv 1 6 where=choice=$choice columns=layout,F_z,k_s,b,c_d; done)
}

@test "random rows of results/tolerance.csv: free inside, shimmy beyond the corner that is named" {
  local layout k_s b c_d p V corner
  while IFS=, read -r layout _ k_s b c_d p V _ corner _; do
    # shellcheck disable=SC2046,SC2086
    {
      LEAST=$(awk "BEGIN { print $V - 2 }") MOST=$(awk "BEGIN { print $V + 2 }") STEP=0.01 \
        oracle_shimmies "$layout" $(corner_words "$(awk "BEGIN { print 1.02 * $p }")" $(device_words "$layout" "$k_s" "$b") c_d="$c_d" -- $corner)
      oracle_is_free "$layout" $(corner_words "$(awk "BEGIN { print 0.98 * $p }")" $(device_words "$layout" "$k_s" "$b") c_d="$c_d" -- $corner)
    }
  done < <(sampled tolerance.csv 2 2)
}

@test "random rows of results/elasticities.csv, tolerance_map.csv and probability.csv" {
  local layout k_s b c_d name lo hi p V count
  while IFS=, read -r layout _ k_s b c_d name _ _ lo hi _; do
    # shellcheck disable=SC2046
    mlg elasticities "$layout" $(device_words "$layout" "$k_s" "$b") c_d="$c_d" | awk -F, -v name="$name" -v lo="$lo" -v hi="$hi" '
      $1 == name { n++; bad = ($4 - lo) ^ 2 > 1e-8 * (1 + lo * lo) || ($5 - hi) ^ 2 > 1e-8 * (1 + hi * hi); print } END { exit bad || n != 1 }'
  done < <(sampled elasticities.csv 3 3)
  while IFS=, read -r layout k_s b c_d p; do # the first shimmy is not before p, and is a little beyond it
    # shellcheck disable=SC2046
    near "$(cell p tolerance "$layout" $(device_words "$layout" "$k_s" "$b") c_d="$c_d" sample=0)" "$p" 2e-3 "p of $layout at k_s = $k_s, b = $b"
  done < <(sampled tolerance_map.csv 1 4 'where=p>0')
  # as many of other samples, within five deviations
  while IFS=, read -r layout _ V count _; do
    # shellcheck disable=SC2046
    IFS=, read -r _ k_s b c_d _ < <(mlg pick "$ROOT/results/tolerance.csv" where=layout="$layout" where=design="$(case $layout in li*) echo tolerant_b ;; *) echo tolerant ;; esac)" \
      columns=layout,k_s,b,c_d,p | grep -v '^#' | tail -n 1)
    # shellcheck disable=SC2046
    mlg probability "$layout" $(device_words "$layout" "$k_s" "$b") c_d="$c_d" spread="$ROOT/docs/examples/spread" samples=1000 seed=9 | awk -F, -v V="$V" -v count="$count" '
      $1 == V { p = count / 1e5; n++; print $0 ", of record " p; bad = ($3 - p) ^ 2 > 25 * (p * (1 - p) + 1e-4) / 1000 } END { exit bad || n != 1 }'
  done < <(sampled probability.csv 1 5 where=design=tolerant where=V=36)
}

@test "advice is what its table says, and says when there is none" {
  # shellcheck source=scripts/report/advice.sh
  . scripts/report/advice.sh
  advice_words "$ROOT/results/advice.csv" > words
  sed -n '6,$p' "$ROOT/results/advice.md" | cmp - words
  best=$(grep -v '^[#l][a ]' "$ROOT/results/advice.csv" | sort -t, -k5,5g | tail -n 1)
  grep -q "^\*\*Take $(tr '[:lower:]' '[:upper:]' <<< "${best%%,*}") with" words
  printf '%s\n%s\n' "$advice_head" 'l1,,,,0,,,,,,,,,,,,,,,,' > none
  advice_words none | grep -q "No device here"
}
