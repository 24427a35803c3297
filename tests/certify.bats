# certify.bats - does the search tell falling from sustained, and do page, table of
# regions and tables of record say the same?
#
# Needs   build/bin/mlg (make test-programs); the tables in results/
# Writes  build/tests/certify

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch certify
  cp -rp "$ROOT"/{results,docs} .
}

setup() {
  cd "$SCRATCH" || return
}

# verdicts C_D STARTS: how many starts fall and how many are sustained
verdicts() {
  build/bin/mlg search l1 c_lo="$1" c_hi="$1" starts="$2" | awk -F, 'NR > 1 { n[$NF]++ } END { print n["falls"] + 0, n["sustained"] + 0 }'
}

@test "large starts fall inside the interval, and are sustained in delta-shimmy" {
  [ "$(verdicts 2900 6)" = "6 0" ]
  # the first start is at V = 50.75 m/s
  [ "$(verdicts 3.6e4 1)" = "0 1" ]
}

@test "slips of the search are refused in one line with status 2" {
  local words
  for words in "" c_lo=2900 "c_lo=0 c_hi=3000" "c_lo=3000 c_hi=2900" "c_lo=2900 c_hi=3000 starts=0" "c_lo=2900 c_hi=3000 c_q=1" \
    "c_lo=2900 c_hi=3000 k_d=-1" "c_lo=2900 c_hi=3000 V=3" "c_lo=2900 c_hi=3000 c_d=3e3" "c_lo=2900 c_hi=3000 V_top=1"; do
    # shellcheck disable=SC2086 # words
    run -2 build/bin/mlg search l1 $words
    [ "${#lines[@]}" -eq 1 ]
  done
}

# cell LAYOUT COLUMN of certify.csv
cell() {
  awk -F, -v layout="$1" -v column="$2" '
    /^#/ { next }
    $1 == "layout" { for (k = 1; k <= NF; k++) if ($k == column) place = k; next }
    $1 == layout { print $place }' results/certify.csv
}

@test "the table of regions is what the tables of record say" {
  local layout
  for layout in l1 l2 li1 li2; do
    [ "$(cell $layout sustained)" = 0 ]
    [ "$(awk -F, -v l=$layout '$1 == l && $10 > 0' results/criticality.csv | wc -l)" = "$(cell $layout subcritical)" ]
    [ "$(awk -F, -v l=$layout -v lo="$(cell $layout c_lo)" -v hi="$(cell $layout c_hi)" \
      '$1 == l && $7 > lo && $7 < hi' results/cycles.csv | wc -l)" = 0 ]
    [ "$(awk -F, -v l=$layout '$1 == l' results/cycles.csv | wc -l)" = "$(cell $layout cycles)" ]
    near "$(awk -F, -v l=$layout '$1 == l && $5 > c { c = $5 } END { print c }' results/folds.csv)" "$(cell $layout fold_c_d)" 1e-3 "fold of $layout"
    near "$(build/bin/scan-$layout intervals k_s="$(cell $layout k_s)" b="$(cell $layout b)" | awk -F, 'NR == 2 { print $1 }')" "$(cell $layout c_lo)" 1e-8
  done
}

@test "the page has the numbers of the table" {
  local layout name line
  for layout in l1 l2 li1 li2; do
    name=${layout^^}
    grep -q "^| $name | .* $(printf '%.2f to %.2f' "$(cell $layout c_lo)" "$(cell $layout c_hi)") |\$" docs/certification.md
    grep -q "^| $name | $(cell $layout starts) | $(printf %.1f "$(cell $layout psi_start)") | 0.042 | [0-9]* | $(cell $layout seconds) | $(cell $layout sustained) |\$" docs/certification.md
    [ $layout = li1 ] || grep -q "^| $name | $(cell $layout fold_c_d) | $(printf %.1f "$(cell $layout fold_V)") |" docs/certification.md
  done
  awk -F, '$5 == "GH" { printf "| %.4f | %.4g |\n", $6, $7 }' results/criticality.csv >points
  [ "$(wc -l <points)" -eq 2 ]
  while read -r line; do grep -q -F "$line" docs/certification.md; done <points
}

@test "a cycle of record is what time integration settles on" {
  local V c_d psi_max
  IFS=, read -r V c_d psi_max < <(awk -F, '$1 == "l1" && $4 == "V8.1" && $10 == 1 && $8 > 6 { print $6 "," $7 "," $8; exit }' results/cycles.csv)
  build/bin/mlg simulate l1 orbit V="$V" c_d="$c_d" psi=0.1 >orbit.csv
  near "$psi_max" "$(awk -F, '/^#/ { next } !k { for (i = 1; i <= NF; i++) if ($i == "psi_max") k = i; next } { print $k; exit }' orbit.csv)" 1e-5 psi_max
}
