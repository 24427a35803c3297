# shellcheck shell=bash
# compare.sh - two studies side by side; sourced by study.sh
# shellcheck disable=SC2154,SC2034 # variables of study.sh

compare() { # NAME NAME
  local name folder=build/studies first=${1:-} second=${2:-} layouts layout picture
  [ $# = 2 ] || fail "usage: scripts/study.sh compare NAME NAME" 2
  for name; do
    check_name "$name"
    [ -s "build/studies/$name/report.html" ] || fail "study: there is no study '$name'; scripts/study.sh $name makes it" 2
  done
  alone "study.$first.$second"
  layouts=$(cut -d , -f 1 "build/studies/$first/designs.csv" "build/studies/$second/designs.csv" | grep -v layout | awk '!seen[$1]++')
  {
    printf '# %s and %s side by side\n\n## What to build\n\n' "$first" "$second"
    for name; do
      printf '**%s.** %s\n\n' "$name" "$(sed -n '/^## What to build/,/^## /{ /^\*\*/p; }' "build/studies/$name/report.md" | sed '/^\*\*How/,$d; /^\*\*Why/d' | paste -sd ' ')"
    done
    printf '## Gears\n'
    side_by_side parameters.csv 1 "$first" "$second" 'parameter,unit' 4
    side_by_side facts.csv 1 "$first" "$second" 'fact,unit' 3
    printf '\n## Designs\n'
    for name; do
      printf '\n**%s**, by width\n' "$name"
      folder=build/studies/$name
      table ranked.csv "$designs_columns"
    done
    for layout in $layouts; do
      printf '\n## %s\n\n' "$(name_of "$layout")"
      for picture in plane regions; do
        for name; do
          [ ! -s "build/studies/$name/$picture.$layout.svg" ] ||
            printf '**%s**, %s:\n\n![%s of %s](%s/%s.%s.svg)\n\n' "$name" "$([ "$picture" = plane ] && echo 'what grows over V and c_d' || echo 'c_d free of shimmy over k_s')" "$picture" "$name" "$name" "$picture" "$layout"
        done
      done
    done
  } > "build/studies/$first.$second.md"
  page build/studies "mlg-shimmy: $first and $second" < "build/studies/$first.$second.md" > "build/studies/$first.$second.html.new"
  mv "build/studies/$first.$second.html.new" "build/studies/$first.$second.html"
  rm "build/studies/$first.$second.md"
  echo "  build/studies/$first.$second.html"
}

# What differs between a table of both, a row for each name.
side_by_side() { # TABLE KEY_COLUMN FIRST SECOND HEAD UNIT_COLUMN
  awk -F, -v unit="$6" -v head="$5" -v a="$3" -v b="$4" '
    FNR == 1 { next }
    NR == FNR { value[$1] = $2; units[$1] = $unit; order[++n] = $1; next }
    { other[$1] = $2; if (!($1 in value)) { order[++n] = $1; units[$1] = $unit } }
    END {
      split(head, h, ",")
      printf "\n| %s | %s | %s | %s |\n|---|---|---|---|\n", h[1], h[2], a, b
      for (i = 1; i <= n; i++) {
        k = order[i]
        if (value[k] != other[k]) { same = 1; printf "| %s | %s | %s | %s |\n", k, units[k], k in value ? sprintf("%.6g", value[k]) : "-", k in other ? sprintf("%.6g", other[k]) : "-" }
      }
      if (!same) print "| all the same | | | |"
      print ""
    }' "build/studies/$3/$1" "build/studies/$4/$1"
}
