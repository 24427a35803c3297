# shellcheck shell=bash
# advice.sh - a study's advice: of each layout the most tolerant design, and the page's words about
# them (scripts/report/advice.sh); sourced by study.sh
#
# In build/studies/NAME: tolerance.LAYOUT.csv, advice.csv.
# shellcheck disable=SC2154 # variables of study.sh
. scripts/report/advice.sh

# The most tolerant k_s and c_d at the inertance of the best damped design, or without an inerter.
tolerant_design() { # LAYOUT
  local layout=$1 b='' row
  ! has "$layout" b || b=$(of_design "$layout" 'best damped' b)
  rm -f "$folder/parts/$layout.advice"
  made "tolerance.$layout.csv" tolerance "$layout" best "${gear[@]}" V_top="$top" ${b:+b="$b"} sample=2000 2> /dev/null || {
    rm -f "$folder/tolerance.$layout.csv"* # none without shimmy
    return 0
  }
  row=$(sed 1,2d "$folder/tolerance.$layout.csv")
  advice_row "$layout" "$row" "${gear[@]}" V_top="$top" > "$folder/parts/$layout.advice"
}

tolerant_designs() {
  local layout
  for layout in $layouts; do job tolerant_design "$layout"; done
  wait
  {
    echo "$advice_head"
    for layout in $layouts; do cat "$folder/parts/$layout.advice" 2> /dev/null || echo "$layout,,,,0,,,,,,,,,,,,,,,,"; done
  } > "$folder/advice.csv"
}

advice_section() {
  echo "## Advice"
  echo
  advice_words "$folder/advice.csv"
  echo
  echo "c_d and k_s of each layout are those of the largest tolerance at the inertance of its best damped design; speeds up to $top m/s."
  echo
}
