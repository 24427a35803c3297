#!/usr/bin/env bash
# Designs under loads, tolerances and spreads, every layout (docs/design.md)
#
#   scripts/studies/design.sh      all of it
#   scripts/studies/design.sh runs [PART] | tables | draw
#
# PART: own, loads, over_b, largest, tolerance, map, elasticities, probability, advice, auto
#
# Writes: results/loads.csv, loads_auto.csv, elasticities.csv, tolerance.csv, tolerance_map.csv,
#         probability.csv;
#         results/loads.png, elasticities.png, tolerance.png, probability.png, and .svg;
#         results/advice.csv and advice.md (scripts/report/advice.sh)
# Expect: largest load with any zero-shimmy design, kN: L1 201.251, L2 204.505, LI1 214.151, LI2
#         253.544 at b <= 300; largest tolerance, %: L1 0.135, L2 0.486, LI1 1.48, LI2 3.32, LI3 2.18,
#         LI4 2.69, LI5 1.30, LI6 1.15, LI7 1.87; AUTO's
#         boundary points over the load agree with the exact ones to 1e-7.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
. scripts/report/advice.sh

mapfile -t layouts < <(layouts)
papers=(l1 l2 li1 li2) # paper_gear has their k_s and b
with_b=() others=()
for layout in "${layouts[@]}"; do
  case $layout in l1 | l2) ;; *) with_b+=("$layout") ;; esac
  [[ " ${papers[*]} " == *" $layout "* ]] || others+=("$layout")
done
is_papers() { [[ " ${papers[*]} " == *" $1 "* ]]; }

# words LAYOUT K_S B: the device for mlg
words() {
  case $1 in l1) ;; l2) echo "k_s=$2" ;; *) echo "k_s=$2 b=$3" ;; esac
}

# of NAME LAYOUT COMMAND...: made again when its answer may be another
of() {
  local files
  mapfile -t files < <(sources "$2" "${algebra[@]}" models/libmlg/{free,tolerance,tolerant,loads}.c)
  made "design.$1" "${files[@]}" scripts/mlg/gear/{designs,loads,elasticities,tolerance,probability}.c -- "${@:3}"
}

# prefixed PREFIX WORD...: what mlg says, without its head
prefixed() {
  mlg "${@:2}" | sed "/^#/d; /^[FkV]/d; s/^/$1,/"
}

# --- the designs that are looked at --------------------------------------------------------------

middle() { # LAYOUT K_S B: the middle of the widest interval there
  # shellcheck disable=SC2046
  mlg intervals "$1" $(words "$@") | awk -F, 'NR > 2 && $2 - $1 > w { w = $2 - $1; c = ($1 + $2) / 2 } END { printf "%.10g", c }'
}

# The widest interval over k_s and b at 200 kN
runs_own() {
  local layout
  for layout in "${others[@]}"; do
    of "own.$layout" "$layout" prefixed "$layout,own" loads "$layout" widest b_most=300 from=2e5 to=2.01e5 step=1e4
  done
}

# gear LAYOUT: sets the choice it is called, k_s and b: the paper's, or that of its own widest interval, 0.1 %
# below the k_s at which a region is born in it
gear() {
  choice=paper
  if is_papers "$1"; then
    paper_gear "$1"
  else
    IFS=, read -r _ choice _ k_s b _ < "build/tables/design.own.$1.csv"
    k_s=$(awk "BEGIN { printf \"%.6g\", 0.999 * $k_s }")
  fi
}

# design LAYOUT DESIGN: sets k_s, b and c_d as the table of tolerances has them
design() {
  IFS=, read -r _ _ k_s b c_d _ < <(cat build/tables/design.tolerance*."$1".csv | grep "^$1,$2,")
}

# The most tolerant design of a layout: its name
most_tolerant() { if [[ " ${with_b[*]} " == *" $1 "* ]]; then echo tolerant_b; else echo tolerant; fi; }

# --- over loads -----------------------------------------------------------------------------

loads_of() { # LAYOUT
  local layout=$1 choice b k_s
  gear "$layout"
  # shellcheck disable=SC2046
  prefixed "$layout,$choice" loads "$layout" $(words "$layout" "$k_s" "$b") c_d="$(middle "$layout" "$k_s" "$b")"
  is_papers "$layout" || return 0
  prefixed "$layout,widest" loads "$layout" widest b="$b"
  prefixed "$layout,damped" loads "$layout" damped b="$b" step=3e4
  prefixed "$layout,over" loads "$layout" over b="$b" from=1.8e5 to=2.1e5 step=5e3
}

loads_over_b() { # LAYOUT
  prefixed "$1,widest_b" loads "$1" widest b_most=300 step=5e4
  prefixed "$1,damped_b" loads "$1" damped b_most=300 step=3e4
  prefixed "$1,over_b" loads "$1" over b_most=300 from=1.8e5 to=2.1e5 step=5e3
}

# largest_of CHOICE LAYOUT WORD
largest_of() { prefixed "$2,$1" loads "$2" largest "$3" | sed 's/,\([^,]*\)$/,,,0,,\1,,,/'; }

runs_loads() {
  local layout
  runs_own
  for layout in "${layouts[@]}"; do of "loads.$layout" "$layout" loads_of "$layout"; done
}

runs_over_b() {
  local layout
  for layout in "${with_b[@]}"; do of "loads_b.$layout" "$layout" loads_over_b "$layout"; done
}

runs_largest() {
  local layout k_s b
  for layout in "${papers[@]}"; do
    paper_gear "$layout"
    of "largest.$layout" "$layout" largest_of largest "$layout" b="$b"
  done
  for layout in "${with_b[@]}"; do of "largest_b.$layout" "$layout" largest_of largest_b "$layout" b_most=300; done
}

# --- tolerances -------------------------------------------------------------------------------

tolerances_of() { # LAYOUT
  local layout=$1 choice b k_s c_d best=()
  gear "$layout"
  # shellcheck disable=SC2046
  prefixed "$layout,$choice" tolerance "$layout" $(words "$layout" "$k_s" "$b")
  if is_papers "$layout"; then best=(b="$b"); else best=(b_most=300); fi
  if is_papers "$layout" && [ "$layout" != l1 ]; then
    k_s=$(mlg widest "$layout" b="$b" | sed -n 's/^\([0-9].*\)/\1/p' | cut -d, -f1)
    # shellcheck disable=SC2046
    prefixed "$layout,widest" tolerance "$layout" $(words "$layout" "$k_s" "$b")
  fi
  # the columns c_d, or k_s,c_d or b,k_s,c_d come first
  IFS=, read -r b k_s c_d < <(mlg damping "$layout" best "${best[@]}" | awk -F, -v OFS=, -v b="$b" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR == 2 { print ("b" in at ? $at["b"] : b), ("k_s" in at ? $at["k_s"] : "inf"), $at["c_d"] }')
  # shellcheck disable=SC2046
  prefixed "$layout,$(is_papers "$layout" && echo damped || echo damped_b)" tolerance "$layout" $(words "$layout" "$k_s" "$b") c_d="$c_d"
  ! is_papers "$layout" || prefixed "$layout,tolerant" tolerance "$layout" best "${best[@]}"
}

tolerance_over_b() { prefixed "$1,tolerant_b" tolerance "$1" best b_most=300; }

runs_tolerance() {
  local layout
  runs_own
  for layout in "${layouts[@]}"; do of "tolerance.$layout" "$layout" tolerances_of "$layout"; done
  for layout in "${with_b[@]}"; do of "tolerance_b.$layout" "$layout" tolerance_over_b "$layout"; done
}

runs_map() {
  of map.li1 li1 prefixed li1 tolerance li1 map k_s=1e5:1e6:17 b=0:160:17
  of map.li2 li2 prefixed li2 tolerance li2 map k_s=3e5:3e6:17 b=0:272:17
}

# --- elasticities and probabilities -------------------------------------------------------------

elasticities_of() { # LAYOUT
  local layout=$1 choice k_s b c_d
  gear "$layout"
  # shellcheck disable=SC2046
  prefixed_elasticities "$layout,$choice,$k_s,$b,$(middle "$layout" "$k_s" "$b")" elasticities "$layout" $(words "$layout" "$k_s" "$b")
  design "$layout" "$(most_tolerant "$layout")"
  # shellcheck disable=SC2046
  prefixed_elasticities "$layout,tolerant,$k_s,$b,$c_d" elasticities "$layout" $(words "$layout" "$k_s" "$b") c_d="$c_d"
}

prefixed_elasticities() { mlg "${@:2}" | sed "1,2d; s/^/$1,/"; }

probabilities_of() { # LAYOUT
  local layout=$1 choice k_s b c_d
  gear "$layout"
  # shellcheck disable=SC2046
  prefixed "$layout,$choice" probability "$layout" $(words "$layout" "$k_s" "$b") spread=docs/examples/spread
  design "$layout" "$(most_tolerant "$layout")"
  # shellcheck disable=SC2046
  prefixed "$layout,tolerant" probability "$layout" $(words "$layout" "$k_s" "$b") c_d="$c_d" spread=docs/examples/spread
}

# Of the designs that the tolerances found
runs_elasticities() {
  local layout
  runs_tolerance
  for layout in "${layouts[@]}"; do of "elasticities.$layout" "$layout" elasticities_of "$layout"; done
}

runs_probability() {
  local layout
  runs_tolerance
  use docs/examples/spread
  for layout in "${layouts[@]}"; do of "probability.$layout" "$layout" probabilities_of "$layout"; done
}

# Of each layout the most tolerant design, as a page sees it
advice_of() { # LAYOUT
  advice_row "$1" "$(cat build/tables/design.tolerance*."$1".csv | sed -n "s/^$1,$(most_tolerant "$1"),//p")"
}

runs_advice() {
  local layout
  runs_tolerance
  for layout in "${layouts[@]}"; do of "advice.$layout" "$layout" advice_of "$layout"; done
}

# --- AUTO over the load ---------------------------------------------------------------------------

# mass KN: the M of that load
mass() { awk "BEGIN { printf \"%.10g\", $1 * 1e3 / 9.81 - 500 }"; }

# Every boundary point of the paper's gear, followed over M from 200 kN to 100 and 250, or to where
# its region is born or meets another (fold = 0).
runs_auto() {
  local layout b k_s start n way at runs
  for layout in "${papers[@]}"; do
    paper_gear "$layout"
    at=(b="$b" k_s="$k_s")
    [ "$layout" != l1 ] || at=()
    runs=() n=0
    while read -r start; do
      n=$((n + 1))
      for way in up down; do
        runs+=("design.$layout.$n.$way")
        run "${runs[-1]}" boundary.point model="$layout.boundary" "$start" b="$b" compliance="$(awk -v k_s="$k_s" 'BEGIN { printf "%.15g", k_s == "inf" ? 0 : 1e5 / k_s }')" \
          ICP="['M', 'V_1', 'c_1', 'f_1', 'ratio_1', 'kind_1', 'b', 'compliance', 'fold']" THL="{'M': 1e-8}" \
          DS="$([ $way = up ] && echo 0.01 || echo -0.01)" DSMAX=0.02 \
          UZSTOP="{'M': [$(mass 100), $(mass 250)], 'V_1': [0.1, 200.0], 'c_1': [100.0, 1e6], 'fold': 0.0}" --
      done
    done < <(mlg starts "$layout" "${at[@]}" c_least=100 c_most=1e6)
    mlg agree "$layout" "${at[@]}" tolerance=1e-7 "${runs[@]}" > "build/tables/design.agree.$layout" ||
      fail "design: AUTO's boundary points of $layout over the load differ from the exact ones"
    printf '%s\n' "${runs[@]}" > "build/tables/design.runs.$layout"
  done
}

# --- tables -----------------------------------------------------------------------------------------

rows_of() { # NAME...: of build/tables/design.NAME.LAYOUT.csv, by layout, as the runs make them
  local layout name file
  for layout in "${layouts[@]}"; do
    for name; do
      case $name:$layout in
        *_b:l1 | *_b:l2) continue ;;
        map:li1 | map:li2) ;;
        map:*) continue ;;
        largest:*) is_papers "$layout" || continue ;;
      esac
      file=build/tables/design.$name.$layout.csv
      [ -s "$file" ] || fail "design: there is no $file; $0 runs makes it" 2
      cat "$file"
    done
  done
}

tables() {
  local layout name
  begin_table results/loads.csv \
    "# Zero-shimmy intervals and damping over the static load. choice: paper, the paper's k_s and b with c_d in the middle" \
    "# of its interval at 200 kN; own, of layouts without that, the same of their widest interval over k_s and b in 0..300 at" \
    "# 200 kN, with 0.999 of its k_s; widest, at each load the k_s of the widest interval, c_d the best damped one there; damped, at each load the" \
    "# best damped k_s and c_d; over, the one k_s and c_d whose least zeta over 180 to 210 kN is largest; these at the paper's" \
    "# b. largest: the largest load with any zero-shimmy design, at that b. With _b: the same over b in 0..300." \
    "# F_z N; k_s N m/rad (inf: rigid), b N m s^2/rad; c_lo, c_hi, width N m s/rad of the widest interval, ratio c_hi/c_lo;" \
    "# zeta: least over V in 0.3..200 m/s at c_d, V m/s and mode of it, below 0: shimmy. Exact in V and c_d; k_s, b: mlg help loads." \
    layout,choice,F_z,k_s,b,c_lo,c_hi,width,ratio,c_d,zeta,V,shimmy
  rows_of loads loads_b largest largest_b >> "$table.new"
  end_table

  begin_table results/elasticities.csv \
    "# d log(c_lo), d log(c_hi) and d log(zeta) per d log(parameter), exact; zeta: least over V in 0.3..200 m/s at c_d." \
    "# design: paper and own (loads.csv), c_d in the middle of the interval; tolerant, that of tolerance.csv over b where the" \
    "# layout has one. k_s N m/rad, b N m s^2/rad, c_d" \
    "# N m s/rad; value in the parameter's unit." \
    layout,design,k_s,b,c_d,parameter,value,unit,c_lo,c_hi,zeta
  rows_of elasticities >> "$table.new"
  end_table

  begin_table results/tolerance.csv \
    "# p: F_z, k_t, e, l, h, k_lambda, k_alpha, c_delta, c_psi, k_delta, k_psi, c_d, k_s and b within +-p % at once give no" \
    "# shimmy at any corner, each tested exactly. design: paper, widest over k_s at the paper's b, and own (loads.csv), c_d in" \
    "# the middle of the interval; damped, the best damped k_s and c_d, tolerant, those of the largest p, at the paper's b; with" \
    "# _b over b in 0..300 as well." \
    "# k_s N m/rad, b N m s^2/rad, c_d N m s/rad; V m/s and shimmy: what grows beyond p; corner: the first that does;" \
    "# failing: of so many points of a Halton sequence in the box." \
    layout,design,k_s,b,c_d,p,V,shimmy,corner,corners,sample,failing
  rows_of tolerance tolerance_b >> "$table.new"
  end_table

  begin_table results/tolerance_map.csv \
    "# The tolerance p, %, of tolerance.csv at the c_d of the largest p, over k_s N m/rad and b N m s^2/rad; 0: no zero-shimmy" \
    "# interval. All corners tested at p." \
    layout,k_s,b,c_d,p
  rows_of map >> "$table.new"
  end_table

  begin_table results/probability.csv \
    "# Probability of shimmy when the parameters spread as docs/examples/spread says (assumed): 100000 samples, each decided" \
    "# exactly; lo, hi: Wilson's interval at 95 %. V m/s, any: at one speed or another up to 200 m/s. design: as in" \
    "# elasticities.csv." \
    layout,design,V,count,probability,lo,hi
  rows_of probability >> "$table.new"
  end_table

  begin_table results/loads_auto.csv \
    "# AUTO's boundary points over the load (M), from the paper's gear at 200 kN both ways; every tenth, and the ends. All of" \
    "# them against the exact ones: $(for layout in "${papers[@]}"; do printf '%s %s; ' "$layout" "$(cat "build/tables/design.agree.$layout")"; done)relative in c_d." \
    "# F_z N, c_d N m s/rad, V m/s, frequency_hz Hz, extremum of c_d along the Hopf curve." \
    layout,curve,F_z,c_d,V,frequency_hz,extremum
  for layout in "${papers[@]}"; do
    while read -r name; do
      mlg rows "$name" prefix="$layout,${name#design."$layout".}" columns=M:.10g,c_1:.8g,V_1:.6g,f_1:.7g,kind_1 every=10
    done < "build/tables/design.runs.$layout"
  done | awk -F, -v OFS=, '{ $3 = sprintf("%.7g", ($3 + 500) * 9.81); $7 = $7 > 0 ? "min" : "max"; print }' >> "$table.new"
  end_table

  begin_table results/advice.csv \
    "# What advice.md is made of: of each layout the most tolerant design (tolerance.csv), with its interval c_lo to c_hi of c_d" \
    "# N m s/rad, least damping ratio zeta over V in 0.3..200 m/s (at zeta_V m/s, of the mode zeta_shimmy), the loads F_from to" \
    "# F_to N around its own F_z that it bears, in steps of 0.5 %, and the parameter, but the load, that moves a bound most," \
    "# with its elasticity. Other columns and units as in tolerance.csv." \
    $advice_head
  rows_of advice >> "$table.new"
  end_table
  {
    cat << 'END'
# Advice: which device for this gear

The paper's gear, every layout of models/, b up to 300 N m s²/rad. Made by `make design` from
[advice.csv](advice.csv); what the words mean: [docs/design.md](../docs/design.md).

END
    advice_words results/advice.csv
  } > results/advice.md.new
  replace results/advice.md
}

draw() {
  local figure
  for figure in loads elasticities tolerance probability; do draw_picture; done
}

main design "$@"
