# shellcheck shell=bash
# pictures.sh - the pictures of a study, as SVG; sourced by study.sh
# shellcheck disable=SC2154 # variables of study.sh

# picture NAME LAYOUT PROGRAM [SETTING ...]: a gnuplot program with these variables set
picture() {
  local name=$1 layout=$2 program=$3 output=$folder/$1.svg settings
  shift 3
  settings=$(printf '; %s' "figure='study'" "folder='$folder'" "layout='$layout'" "V_top=$top" "output='$output.new'" "$@")
  if ! LC_ALL=C.UTF-8 gnuplot -d -e "${settings#; }" scripts/pictures/style.gp "scripts/pictures/study-$program.gp" 2> "$folder/gnuplot.log" ||
    ! tail -c 12 "$output.new" 2> /dev/null | grep -q '</svg>'; then
    rm -f "$output.new" "$output"
    echo "picture $name: $(grep -m 1 -e ' line [0-9]*: ' "$folder/gnuplot.log" || echo 'half a picture; is the disk full?')" >> "$folder/unsure"
    return
  fi
  mv "$output.new" "$output"
}

draw_exact() {
  local layout c_d c_lo c_hi zh b_layouts=''
  rm -f "$folder"/*.svg
  for layout in $layouts; do
    get_base "$layout"
    read -r c_lo c_hi < <(sed -n '1s/.*plane [^,]*,[^,]*,\([^,]*\),\(.*\)/\1 \2/p' "$folder/plane.$layout.csv")
    zh=${hi:-0}
    c_d=$(sed 1d "$folder/telling.$layout.csv" | cut -d , -f 2 | tr '\n' ' ')
    picture "plane.$layout" "$layout" plane "c_lo=$c_lo" "c_hi=$c_hi" "telling='$c_d'" "z_lo=${lo:-0}" "z_hi=${zh/inf/1e300}" "yours=${own_c_d:-0}"
    if [ -s "$folder/regions.$layout.csv" ] && [ "$(wc -l < "$folder/regions.$layout.csv")" -gt 5 ]; then
      picture "regions.$layout" "$layout" regions "base_k_s=${base_k_s/inf/0}" "z_lo=${lo:-0}" "z_hi=${zh/inf/0}"
    fi
    ! grep -q ',[0-9.e+]*,[a-z ]*$' "$folder/limits.$layout.csv" 2> /dev/null || b_layouts+=" $layout"
  done
  [ -z "$b_layouts" ] || picture widths '' widths "layouts='${b_layouts# }'" "b_most=$b_most"
}

draw_cycles() {
  local layout diagrams
  for layout in $layouts; do
    diagrams=$(awk -F, -v layout="$layout" '$1 == layout && !seen[$2]++ { print $2 }' "$folder/branches.csv" | sort -t . -k 2n | tr '\n' ' ')
    [ -z "$diagrams" ] || picture "branches.$layout" "$layout" branches "diagrams='${diagrams% }'"
    [ ! -s "$folder/history.$layout.csv" ] || picture "history.$layout" "$layout" history
  done
}
