# shellcheck shell=bash
# advice.sh - a study's advice: of each layout the most tolerant design, and the page's words about
# them (scripts/report/advice.sh); sourced by study.sh
#
# In build/studies/NAME: tolerance.LAYOUT.csv, advice.csv.
# shellcheck disable=SC2154 # variables of study.sh
. scripts/report/advice.sh

# The most tolerant c_d, k_s and b of a layout; a row of designs.csv too.
tolerant_design() { # LAYOUT
  local layout=$1 over_b=() row
  ! has "$layout" b || over_b=(b_most="$b_most")
  rm -f "$folder/parts/$layout".{advice,tolerant}
  made "tolerance.$layout.csv" tolerance "$layout" best "${gear[@]}" V_top="$top" "${over_b[@]}" sample=2000 2> /dev/null || {
    rm -f "$folder/tolerance.$layout.csv"* # none without shimmy
    return 0
  }
  row=$(sed 1,2d "$folder/tolerance.$layout.csv")
  advice_row "$layout" "$row" "${gear[@]}" V_top="$top" > "$folder/parts/$layout.advice"
  local k_s b c_d
  IFS=, read -r k_s b c_d _ <<< "$row"
  design "$layout" 'most tolerant' "$(rigid "${k_s:-inf}")" "${b:-0}" '' "$c_d" > "$folder/parts/$layout.tolerant"
}

gather_advice() {
  local layout
  {
    echo "$advice_head"
    for layout in $layouts; do cat "$folder/parts/$layout.advice" 2> /dev/null || echo "$layout,,,,0,,,,,,,,,,,,,,,,"; done
  } > "$folder/advice.csv"
}

advice_section() {
  echo "## What to build"
  echo
  if [ "$(awk -F, 'NR > 1 && $5 > 0' "$folder/advice.csv" | wc -l)" -gt 0 ]; then
    advice_words "$folder/advice.csv" "$b_most"
    echo
    echo "The c_d, k_s and b of each layout are those of its largest tolerance that a search up to b = $(number "$b_most") N m s²/rad finds; speeds up to $top m/s."
  else
    echo "**No device of these layouts keeps this gear free of shimmy** at all speeds up to $top m/s, not even exactly as designed."
    nearest_words
  fi
  echo
}

# Where no device will do: the one with which it grows most slowly, and the load that one can bear.
nearest_words() {
  local layout k_s b c_d zeta V f mode words load best=0 line
  IFS=, read -r layout _ k_s b _ _ _ _ _ _ _ _ c_d zeta V f mode _ < <(awk -F, '
    $2 != "yours" && $14 + 0 < 0 && (row == "" || $14 + 0 > most) { most = $14 + 0; row = $0 }
    END { print row }' "$folder/designs.csv") || true
  echo
  if [ -z "$layout" ]; then
    echo "It **diverges**: straight rolling falls over without oscillating, at any c_d (the checks below)."
  else
    mapfile -t words < <(device "$layout" "$k_s" "$b")
    echo "**Nearest to it** comes $(with_words "$layout" "$k_s" "$b") and c_d = $(number "$c_d") N m s/rad: what grows fastest is the $mode mode at $(number "$V" %.3g) m/s, tenfold in $(awk -v z="$zeta" -v f="$f" 'BEGIN { printf "%.2g", log(10) / (-z * 8 * atan2(1, 1) * f) }') s (ζ = $(number "$zeta" %.2e))$(
    mlg hopf "$layout" c_d="$c_d" "${gear[@]}" V_top="$top" "${words[@]}" | sed 1,2d | cut -d , -f 2 | awk '{ v[++n] = $1 } END { if (n) { printf "; the Hopf points with it are at"; for (i = 1; i <= n; i++) printf "%s %.3g", (i > 1 ? "," : ""), v[i]; printf " m/s" } }')."
  fi
  echo
  for layout in $layouts; do
    IFS=, read -r k_s b < <(awk -F, -v layout="$layout" '$1 == layout && $2 != "yours" { row = $3 "," $4 } END { print row }' "$folder/designs.csv")
    words=()
    ! has "$layout" b || words=(b="$b")
    IFS=, read -r load k_s b c_d < <(largest_load "$layout" "${words[@]}") || continue
    if awk "BEGIN { exit !($load > $best) }"; then
      best=$load
      line="$(with_words "$layout" "$k_s" "$b") and c_d = $(number "$c_d") N m s/rad, which is free of shimmy up to a load of $(awk "BEGIN { printf \"%.4g kN, %.0f %%\", $load / 1e3, 100 * $load / $(of_load) }") of this gear's"
    fi
  done
  if [ "$best" = 0 ]; then
    echo "At no lower load that was looked at, down to a thousandth, has any of these layouts a design without shimmy either: the gear itself has to change."
  else
    echo "**What helps** is a lower load, or another gear. The device for the largest load is $line."
  fi
}

# F_z,k_s,b,c_d of the largest load below the gear's own with a design; it is looked for at 13 loads, then
# at 13 below the first of these.
largest_load() { # LAYOUT WORD...
  local part
  for part in 1 0.08 0.006; do
    if mlg loads "$1" largest "${gear[@]}" V_top="$top" "${@:2}" from="$(times "$(of_load)" 0.001)" to="$(times "$(of_load)" "$part")" 2> /dev/null | sed 1,2d | grep .; then return; fi
  done
}

of_load() { awk -F, '$1 == "F_z" { printf "%.8g", $2 }' "$folder/facts.csv"; }
