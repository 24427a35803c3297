# hopf.bats - is no Hopf point of straight rolling missed, whatever AUTO's steps, along any
# parameter, and does a closed Hopf curve stop where it closes?
#
# The Hopf points of a run are held against the exact ones of `mlg hopf`: along another
# parameter than V, at each of them V is one of the Hopf speeds, and the number of oscillations
# that grow, from LAPACK, changes there and nowhere else.
#
# Needs   build/auto.mk, build/models, build/bin
# Writes  build/tests/hopf

bats_require_minimum_version 1.5.0
load scratch

setup_file() { scratch hopf; }

setup() { cd "$SCRATCH" || return; }

# along PARAMETER FROM TO DSMAX WORD...: a straight run along it; its Hopf points
along() {
  auto_run own l1.straight ICP="['$1', 'period', 'V', 'c_d', 'hopf_psi', 'hopf_delta']" "$1=$2" UZSTOP="{'$1': $3}" DS="$4" DSMAX="$4" "${@:5}" -- > log || { cat log; return 1; }
  values own HB "$1"
}

# growing PARAMETER=VALUE WORD...: how many oscillations grow
growing() {
  build/bin/mlg eigenvalues l1 "$@" | awk -F, '$1 + 0 > 0 && $2 + 0 > 0 { n++ } END { print n + 0 }'
}

# exact PARAMETER FROM TO WORD... < values: each is a Hopf point, and there are no others
exact() {
  local name=$1 from=$2 to=$3 value last
  shift 3
  last=$from
  while read -r value; do
    near "$(build/bin/mlg hopf l1 "$name=$value" c_d=3.6e4 "$@" | awk -F, '$2 + 0 > 0 { d = ($2 - 20) ^ 2; if (b == "" || d < l) { l = d; b = $2 } } END { print b }')" 20 1e-6 "V at $name = $value" || return
    same "$name" "$last" "$value" "$@" || return
    last=$value
  done
  same "$name" "$last" "$to" "$@"
}

# same PARAMETER FROM TO WORD...: between two Hopf points the number that grows is the same
same() {
  local k x counts=
  for k in 0.001 0.2 0.4 0.6 0.8 0.999; do
    x=$(awk -v a="$2" -v b="$3" -v k=$k 'BEGIN { printf "%.12g", a + k * (b - a) }')
    counts+="$(growing "$1=$x" V=20 c_d=3.6e4 "${@:4}") "
  done
  [ "$(tr ' ' '\n' <<< "$counts" | sort -u | grep -c .)" -eq 1 ] || { echo "between $1 = $2 and $3: $counts"; return 1; }
}

@test "along e the Hopf points at 0.1402 and 0.1462 are found at any DSMAX" {
  local step n=0
  for step in 0.05 0.02 0.01 0.006 0.005 0.004 0.003 0.002; do
    along e 0.101 0.2 $step V=20 > found
    printf 'DSMAX %s: %s\n' "$step" "$(paste -sd ' ' found)"
    near_each 1e-8 "e at DSMAX $step" < <(paste -d ' ' found <(printf '%s\n' 0.14016862925 0.14617514440))
    n=$((n + 1))
  done
  [ $n -eq 8 ]
  exact e 0.101 0.2 < found
}

@test "along other parameters too: all that change the count, and no others" {
  local name from to step found=0
  while read -r name from to step; do
    along "$name" "$from" "$to" "$step" V=20 > found
    echo "$name: $(paste -sd ' ' found)"
    exact "$name" "$from" "$to" < found
    found=$((found + $(wc -l < found)))
  done << 'END'
l 0.05 1.5 0.3
h 0.01 0.6 0.1
phi -0.2 0.3 0.1
k_alpha 0.1 3 0.5
J_zeta 30 300 30
c_psi 0 3000 300
END
  [ "$found" -ge 6 ]
}

@test "two Hopf points side by side beside a double Hopf point, one ending and one beginning" {
  local step
  for step in 0.1 1; do
    along V 1 200 $step c_d=32037 > found
    near_each 1e-7 "V at DSMAX $step" < <(paste -d ' ' found <(build/bin/mlg hopf l1 c_d=32037 | awk -F, '$2 + 0 > 0 { print $2 }'))
    [ "$(wc -l < found)" -eq 4 ]
  done
}

@test "a run with friction has the points of the damper that friction is at rest" {
  auto_run own.friction l1.straight T_psi=50 v_f=0.5 -- HB=4 > /dev/null
  near_each 1e-6 V < <(paste -d ' ' <(values own.friction HB V) <(mlg hopf l1 c_d=3.6e4 c_psi=400 | sed 1,2d | cut -d , -f 2))
}

@test "a point beside which another pair is nearer to the axis, where AUTO looks at that alone" {
  auto_run near l2.straight k_s=7.86e5 c_d=2e4 DSMAX=1 -- HB=2 | grep 'stepped over'
  near "$(values near HB V | tail -n 1)" 38.54453075 1e-7
}

@test "AUTO alone misses them, which mlg judge says; with UZR on the test functions it finds them" {
  local exe=$PWD/build/models/l1.exe step uzr
  mkdir plain
  for step in 0.005 0.003; do
    for uzr in "{}" "{'hopf_psi': [-1e-6, 1e-6], 'hopf_delta': [-1e-6, 1e-6]}"; do
      build/bin/mlg constants constants/c.l1.straight layout=l1 V=20 e=0.1 ICP="['e', 'period', 'V', 'c_d', 'hopf_psi', 'hopf_delta']" \
        UZSTOP="{'e': 0.2}" DS=$step DSMAX=$step UZR="$uzr" > plain/fort.2
      (cd plain && : > fort.3 && "$exe" > log && mv fort.7 b.one && mv fort.8 s.one && mv fort.9 d.one)
      if [ "$uzr" = "{}" ]; then
        run -1 build/bin/mlg judge plain/one
        [[ $output == *"stepped over the Hopf point"*" at e = 0.1401686"* ]]
      else
        run -0 build/bin/mlg judge plain/one
        [[ $output == "HB 0.140169 HB 0.146175" ]]
      fi
    done
  done
  # two that lie side by side too, with long steps
  for step in 0.1 3; do
    build/bin/mlg constants constants/c.l1.straight layout=l1 c_d=61880 DS=0.01 DSMAX=$step UZR="$uzr" > plain/fort.2
    (cd plain && : > fort.3 && "$exe" > log && mv fort.7 b.one && mv fort.8 s.one && mv fort.9 d.one)
    run -0 build/bin/mlg judge plain/one
    [[ $output == "HB 7.23086 HB 26.0764 HB 60.9757 HB 60.9777" ]]
  done
}

@test "the test functions are the eigenvalues of the two kinds of shimmy, negative where none grows" {
  local V psi delta n=0
  auto_run own.V l1.straight -- HB=4 > /dev/null
  while IFS=, read -r V psi delta; do
    n=$((n + 1))
    # at c_d = 3.6e4 the pair of 17.5 Hz is delta's; of psi's, two at low speed, the nearer to 0
    near_each 1e-5 "hopf_psi and hopf_delta at V = $V" < <(build/bin/mlg eigenvalues l1 V="$V" c_d=3.6e4 |
      awk -F, -v psi="$psi" -v delta="$delta" '
        $2 + 0 > 0 { d = $2 > 95; if (!n[d]++ || $1 ^ 2 < near[d] ^ 2) near[d] = $1 }
        END { print psi, near[0]; print delta, near[1] }')
  done < <(build/bin/mlg rows own.V columns=V:.12g,hopf_psi:.10g,hopf_delta:.10g every=97 types=BP)
  [ "$n" -ge 15 ]
}

@test "a closed Hopf curve stops where it closes, both ways, from both sides, at any DSMAX" {
  local name way step n=0
  auto_run own.start li2.straight k_s=8e5 b=100 c_d=6000 -- > /dev/null
  for name in $(build/bin/mlg rows own.start only=HB where='frequency>16' columns=name); do
    for way in 0.1 -0.1; do
      for step in 0.1 0.5 3; do
        auto_run own.closed li2.hopf from=own.start IRS="'$name'" DS=$way DSMAX=$step -- closed=1 UZ=1 > /dev/null
        near "$(value own.closed UZ V)" "$(build/bin/mlg rows own.start only=HB columns=name,V:.12g | sed -n "s/^$name,//p")" 1e-7 "V of $name"
        near "$(value own.closed UZ c_d)" 6000 1e-7
        # once round: it passes c_d = 6000 once more between its ends
        [ "$(build/bin/mlg rows own.closed columns=c_d:.12g | awk 'NR > 2 && (c - 6000) * ($1 - 6000) < -1 { n++ } { c = $1 } END { print n + 0 }')" -eq 1 ]
        n=$((n + 1))
      done
    done
  done
  [ $n -eq 12 ]
}
