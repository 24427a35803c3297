#!/usr/bin/env bash
# What the paper's results hang on: intervals and damping along the model's doubts (docs/doubts.md)
#
#   scripts/studies/doubts.sh       all of it
#   scripts/studies/doubts.sh runs [zB_shared | R_moves | heading | I_p | tyre] | tables | draw
#
# Needs:  results/widths.csv, constants/gear.somieski
# Writes: results/doubts.csv, doubts_tyre.csv; results/doubts.png, doubts_tyre.png, and .svg
# Expect: L1's interval, 265 N m s/rad wide, is 28000 wide with one zB'' or with I_p = 1 kg m^2,
#         2960 with R_i differentiated, and gone with the heading's other term; with any of the
#         first two no k_s of L2 or LI2 is better than a rigid one.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

readonly blends="0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1" inertias="0 0.25 0.5 0.75 1 1.5 2 3 5"
names=doubt,value,layout,choice,b,k_s,c_lo,c_hi,width,limit,c_d,zeta,V,frequency_hz,shimmy

# The paper's layouts and those of results/widths.csv
studied() { echo l1 l2 "$(awk -F, '!/^#/ && $1 != "layout" && !seen[$1]++ { print $1 }' results/widths.csv | xargs)"; }

# Sets k_s and b: those of paper_gear, of the other layouts where they are widest
design() { # LAYOUT
  case $1 in
    l1 | l2 | li1 | li2) paper_gear "$1" ;;
    *) IFS=, read -r b k_s < <(mlg pick results/widths.csv where=layout="$1" columns=width,b,k_s | sort -t, -k1,1gr | sed -n '1s/^[^,]*,//p') ;;
  esac
}

# The widest interval at one k_s and b: c_lo,c_hi,width, nothing between without one
interval() { # LAYOUT WORD...
  mlg intervals "$@" | awk -F, 'NR > 2 && $5 > width { width = $5; found = $1 "," $2 "," $5 } END { print (found == "" ? ",,0" : found) }'
}

# c_d,zeta,V,frequency_hz,shimmy of the best c_d; nothing where mlg has no answer
damped() { # LAYOUT WORD...
  { mlg damping "$1" best "${@:2}" || true; } | awk -F, 'NR == 2 { found = $1 "," $2 "," $3 "," $4 "," $5 } END { print (found == "" ? ",,,," : found) }'
}

# Rows of a layout with the words that make the doubt: at its design, at the k_s of the widest
# interval, and for the paper's layouts at the best damped k_s; all at the b of the design
rows() { # DOUBT VALUE LAYOUT WORD...
  local k_s b c_lo c_hi width limit
  design "$3"
  local head=$1,$2,$3 words=("${@:4}")
  echo "$head,paper,$b,$k_s,$(interval "$3" k_s="$k_s" b="$b" "${words[@]}"),,$(damped "$3" k_s="$k_s" b="$b" "${words[@]}")"
  [ "$3" != l1 ] || return 0
  IFS=, read -r k_s c_lo c_hi _ _ width limit < <(mlg widest "$3" b="$b" "${words[@]}" | sed -n 3p)
  echo "$head,widest,$b,$k_s,$c_lo,$c_hi,$width,$limit,,,,,"
  case $3 in l2 | li[12]) ;; *) return 0 ;; esac
  echo "$head,damped,$b,$(mlg damping "$3" best b="$b" "${words[@]}" | sed 1d | awk -F, '{ print $1 ",,,,," $2 "," $3 "," $4 "," $5 "," $6 }')"
}

along() { # DOUBT VALUE...
  local value layout
  for value in "${@:2}"; do
    for layout in $(studied); do rows "$1" "$value" "$layout" "$1=$value"; done
  done
}

of() { # NAME COMMAND...
  local files=() layout
  for layout in $(studied); do
    mapfile -t -O ${#files[@]} files < <(sources "$layout" "${algebra[@]}")
  done
  made "doubts.$1" "${files[@]}" scripts/studies/doubts.sh -- "${@:2}"
}

# shellcheck disable=SC2086 # a list of values
runs_zB_shared() { of zB_shared along zB_shared $blends; }
# shellcheck disable=SC2086
runs_R_moves() { of R_moves along R_moves $blends; }
# shellcheck disable=SC2086
runs_heading() { of heading along heading $blends; }
# shellcheck disable=SC2086
runs_I_p() { of I_p along I_p $inertias; }

# The other tyre, and it with what else there is for realistic wheels
tyre() {
  local layout
  for layout in $(studied); do
    rows tyre 1 "$layout" gear=constants/gear.somieski
  done
}

# The tyres of the planes: the paper's, of realistic size with a moment that L1 bears, and another gear's
readonly tyres="paper half somieski"
words_of() { # TYRE
  case $1 in half) echo k_lambda=1.19 k_alpha=0.3 ;; somieski) echo gear=constants/gear.somieski ;; esac
}

# Every fourth point of the Hopf curves, and where they turn
planes() {
  local layout tyre
  for tyre in $tyres; do
    for layout in l1 l2 li1 li2; do
      design "$layout"
      # shellcheck disable=SC2046
      mlg plane "$layout" k_s="$k_s" b="$b" $(words_of "$tyre") c_least=500 c_most=1e5 |
        awk -F, -v head="$tyre,$layout" '!/^[1-9]/ || $4 == "HH" { n = 0; next } $4 != "" || n++ % 4 == 0 { print head "," $0 }'
    done
  done
}

runs_tyre() {
  of tyre tyre
  of k_lambda along k_lambda 3
  of planes planes
}

tables() {
  begin_table results/doubts.csv \
    "# Zero-shimmy intervals and least damping ratios along the doubts of docs/doubts.md: doubt at value (0 the paper;" \
    "# I_p kg m^2; tyre: constants/gear.somieski; k_lambda 1/rad), the others 0. choice: paper, at the paper's k_s and b (LI2: k_s is ours; LI3" \
    "# to LI7: their widest); widest, at the k_s of the widest interval at that b, limit: what ends its growth; damped, at" \
    "# the best k_s. c_lo to c_hi and width N m s/rad, width 0 without an interval; c_d the best, zeta the least over V in 0.3..200" \
    "# m/s there, at V m/s with frequency_hz Hz. k_s N m/rad (inf: rigid), b N m s^2/rad. All exact, by mlg intervals," \
    "# widest and damping; an empty zeta is no answer."
  {
    echo $names
    # the k_s of no interval says nothing
    awk -F, -v OFS=, '$4 == "widest" && $9 == 0 { $6 = $7 = $8 = "" } 1' build/tables/doubts.{zB_shared,R_moves,heading,I_p,tyre,k_lambda}.csv
  } > build/tables/doubts.rows.csv
  mlg pick build/tables/doubts.rows.csv head columns=doubt,value,layout,choice,b:.7g,k_s:.7g,c_lo:.8g,c_hi:.8g,width:.7g,limit,c_d:.6g,zeta:.4g,V:.4g,frequency_hz:.5g,shimmy >> "$table.new"
  replace "$table"

  begin_table results/doubts_tyre.csv \
    "# Hopf curves in the (V, c_d) plane with other tyres, at the paper's k_s and b (docs/doubts.md). tyre: paper; half, k_lambda =" \
    "# 1.19 and k_alpha = 0.3; somieski, constants/gear.somieski. Exact, every fourth point of \`mlg plane\`; type LP: c_d has an" \
    "# extremum along the curve. V m/s, c_d N m s/rad, from 500 to 1e5, frequency_hz Hz; curve, kind and shimmy: mlg help plane." \
    tyre,layout,curve,kind,shimmy,type,V,c_d,frequency_hz
  cat build/tables/doubts.planes.csv >> "$table.new"
  end_table
}

draw() {
  local figure
  for figure in doubts doubts_tyre; do draw_picture; done
}

main doubts "$@"
