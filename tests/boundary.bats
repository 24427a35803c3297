# boundary.bats - are the boundary points and the widest intervals right?
#
# AUTO's boundary points at random parameters, and the tables boundary_points.csv
# and widths.csv as they stand in results, against eigenvalues of the full
# linearised equations from LAPACK (eigen-LAYOUT, tests/eigen.h); the limits
# k_s rigid and b = 0 on Hopf points; each change of mechanism along the widest
# interval; and no wider interval than the one the runs in b follow.
#
# Needs   the models, build/bin/eigen-* and scan-* (make test-programs)
# Writes  build/tests/boundary

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch boundary
  cp -rp "$ROOT/results" .
}

setup() {
  cd "$SCRATCH" || return
}

# fold LAYOUT V C_D PARAMETER...: "c_d V" of the extremum there, by eigenvalues
fold() {
  local layout=$1 V=$2 c_d=$3
  shift 3
  "build/bin/eigen-$layout" fold V="$V" c_d="$c_d" "$@" \
    | awk '$1 == "V" { V = $3 } $1 == "c_d" { c = $3 } END { print c, V }'
}

# How many Hopf points the eigenvalues have over V in 0.1..200, in steps of 0.5
unstable_speeds() { # LAYOUT PARAMETER...
  local layout=$1
  shift
  "build/bin/eigen-$layout" boundary free=V from=0.1 to=200 step=0.5 "$@" | awk 'NR > 1' | wc -l
}

column() { # NAME of widths.csv, for the row LAYOUT B
  awk -F, -v name="$1" -v layout="$2" -v b="$3" '
    /^#/ { next }
    $1 == "layout" { for (k = 1; k <= NF; k++) if ($k == name) place = k; next }
    $1 == layout && $2 == b { print $place }' results/widths.csv
}

@test "boundary points that AUTO follows to 30 random (layout, k_s, b) are extrema by the eigenvalues" {
  local layout compliance b point n=0 cases=0 compared=0 U
  while read -r layout compliance b; do
    cases=$((cases + 1))
    while IFS=, read -r c_d V f _; do
      n=$((n + 1))
      U=$(awk -v V="$V" -v c="$c_d" -v f="$f" 'BEGIN {
        printf "{\047omega_1\047: %.12g, \047speed_1\047: %.12g, \047logc_1\047: %.12g}", f * 2 * atan2(0, -1) / 10, V / 10, log(c) / log(10) }')
      auto_run "random.$n" boundary.point model="$layout.boundary" U="$U" b="$b" \
        compliance="$(awk -v k="$compliance" 'BEGIN { print 0.97 * k }')" \
        STOP="['UZ1']" UZR="{'compliance': $compliance}" -- > /dev/null || { rm -rf "build/runs/random.$n.part"; continue; }
      point=$(value "random.$n" UZ c_1) # none where the curve folds before
      if [ -z "$point" ] || ! near "$(value "random.$n" UZ compliance)" "$compliance" 1e-9 > /dev/null; then continue; fi
      near "$point" "$(fold "$layout" "$(value "random.$n" UZ V_1)" "$point" b="$b" \
        k_s="$(awk -v k="$compliance" 'BEGIN { printf "%.15g", 1e5 / k }')" | cut -d ' ' -f 1)" 1e-7 "c_d of $layout at b = $b, compliance $compliance"
      compared=$((compared + 1))
    done < <("build/bin/scan-$layout" points b="$b" compliance="$(awk -v k="$compliance" 'BEGIN { print 0.97 * k }')" \
      | awk -F, 'NR > 1 && $4 != "edge" && $1 > 50 && $1 < 1e5 && $2 > 1')
  done < <(awk 'BEGIN {
    srand(408)
    for (i = 0; i < 30; i++) {
      layout = i % 3 == 0 ? "l2" : i % 3 == 1 ? "li1" : "li2"
      printf "%s %.6g %.6g\n", layout, 0.02 + 0.2 * rand(), (layout == "l2" ? 0 : 200 * rand()) }
  }')
  echo "$cases cases, $compared points"
  [ "$cases" -eq 30 ]
  [ "$compared" -ge 70 ]
}

@test "each interval of widths.csv has no Hopf point inside and the named bounds" {
  local layout b k_s c_lo c_hi V_lo V_hi n=0 # b where limits change is printed to 8 digits: 5e-7 in c_d
  while IFS=, read -r layout b k_s c_lo c_hi _ V_lo V_hi _; do
    n=$((n + 1))
    near "$c_lo" "$(fold "$layout" "$V_lo" "$c_lo" b="$b" k_s="$k_s" | cut -d ' ' -f 1)" 5e-7 "c_lo of $layout at b = $b"
    near "$c_hi" "$(fold "$layout" "$V_hi" "$c_hi" b="$b" k_s="$k_s" | cut -d ' ' -f 1)" 5e-7 "c_hi of $layout at b = $b"
    for c_d in "$(awk "BEGIN { print $c_lo * 1.01 }")" "$(awk "BEGIN { print sqrt($c_lo * $c_hi) }")" "$(awk "BEGIN { print $c_hi * 0.99 }")"; do
      [ "$(unstable_speeds "$layout" b="$b" k_s="$(awk "BEGIN { print $k_s * 0.9999 }")" c_d="$c_d")" -eq 0 ] \
        || { echo "$layout b = $b: Hopf points at c_d = $c_d"; return 1; }
    done
  done < <(awk -F, '!/^#/ && $1 != "layout" && $6 > 200' results/widths.csv)
  [ "$n" -ge 50 ]
}

@test "no wider interval is to be had over k_s" {
  local layout b
  for case in "li1 0" "li1 20" "li1 40" "li1 60" "li1 100" "li1 140" "li1 170" "li1 190" "li2 50" "li2 140" "li2 300" \
    "li3 30" "li3 60" "li4 140" "li5 30" "li5 110"; do
    read -r layout b <<< "$case"
    near "$(column width "$layout" "$b")" "$("build/bin/scan-$layout" widest b="$b" | awk -F, 'NR == 2 { print $7 }')" 1e-6 "width of $layout at b = $b"
  done
  # two equal maxima, of which the search follows one
  near "$(column width li1 47.842)" "$(build/bin/scan-li1 widest b=47.842 | awk -F, 'NR == 2 { print $7 }')" 2e-6 "width of li1 at b = 47.842"
  [ "$(build/bin/scan-li1 widest b=200 | awk -F, 'NR == 2 { print $7 }')" = 0 ]
}

@test "where the onset falls below BP1 its c_d is that of BP1" {
  local b=17.638779 k_s c_lo onset
  k_s=$(column k_s li1 $b) c_lo=$(column c_lo li1 $b)
  onset=$(build/bin/eigen-li1 centre free=k_s V=36.5 c_d="$c_lo" k_s="$k_s" b=$b)
  near "$k_s" "$(awk '$1 == "k_s" { print $3 }' <<< "$onset")" 1e-6 k_s
  near "$c_lo" "$(awk '$1 == "c_d" { print $3 }' <<< "$onset")" 1e-5 c_d
}

@test "where the stationary interval takes over its width is stationary" {
  local b=21.460839 k_s lo hi
  k_s=$(column k_s li1 $b) c_lo=$(column c_lo li1 $b) c_hi=$(column c_hi li1 $b)
  width() { # at k_s times this: BP3 less BP2_u
    lo=$(fold li1 36.8 "$c_lo" b=$b k_s="$(awk "BEGIN { print $k_s * $1 }")") 
    hi=$(fold li1 "$(column V_hi li1 $b)" "$c_hi" b=$b k_s="$(awk "BEGIN { print $k_s * $1 }")")
    awk -v lo="$lo" -v hi="$hi" 'BEGIN { split(lo, l, " "); split(hi, h, " "); printf "%.9g", h[1] - l[1] }'
  }
  near "$(width 1)" "$(width 1.001)" 3e-6 "width beside the handover"
  near "$(width 1)" "$(width 0.999)" 3e-6 "width beside the handover"
}

@test "where the third psi region takes over it has the c_d of BP1" {
  local b=140.47075 k_s c_lo
  k_s=$(column k_s li1 $b) c_lo=$(column c_lo li1 $b)
  near "$(fold li1 26.6 "$c_lo" b=$b k_s="$k_s" | cut -d ' ' -f 1)" "$(fold li1 4.96 "$c_lo" b=$b k_s="$k_s" | cut -d ' ' -f 1)" 1e-6 "third psi region"
  [ "$(column lower li1 140)" = BP1 ]
  [ "$(column lower li1 150)" = psi3 ]
}

@test "LI1 and LI2 without inerter have the Hopf points of L2, and L2 with a rigid k_s those of L1" {
  local layout
  auto_run l1 l1.straight c_d=3.6e4 -- HB=4 > /dev/null
  for layout in l2 li1 li2; do
    auto_run "$layout.rigid" "$layout.straight" c_d=3.6e4 k_s=1e30 b=0 -- > /dev/null
    paste -d ' ' <(values "$layout.rigid" HB V) <(values l1 HB V) | near_each 1e-9 "Hopf point of $layout"
    auto_run "$layout.soft" "$layout.straight" c_d=2e4 k_s=9e5 b=0 DSMAX=0.02 NMX=20000 -- > /dev/null
    paste -d ' ' <(values "$layout.soft" HB V) <(values l2.soft HB V) | near_each 1e-9 "Hopf point of $layout"
  done
}

@test "a delta region that has just been born is found, and none before" {
  # the onset is at k_s = 786523.74; there the region is 36 mm/s wide
  [ "$(build/bin/curves-l2 k_s=786525 | grep -c ',closed,delta,')" -eq 1 ]
  [ "$(build/bin/curves-l2 k_s=786522 | grep -c ',delta,')" -eq 0 ]
  bash scripts/curves.sh l2 island k_s=786525
  [ "$(awk -F, '$2 == "delta" && $3 == "LP"' build/tables/island.csv | wc -l)" -eq 2 ]
}
