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
  local layout zh k_range b_layouts=''
  rm -f "$folder"/*.svg
  for layout in $layouts; do
    get_base "$layout"
    draw_plane
    zh=${hi:-0}
    k_range=$(range_of_k_s)
    [ -z "$k_range" ] || picture "regions.$layout" "$layout" regions "$k_range" "base_k_s=${base_k_s/inf/0}" "z_lo=${lo:-0}" "z_hi=${zh/inf/1e300}"
    ! grep -q ',[0-9.e+]*,[a-z ]*$' "$folder/limits.$layout.csv" 2> /dev/null || b_layouts+=" $layout"
  done
  [ -z "$b_layouts" ] || picture widths '' widths "layouts='${b_layouts# }'" "b_most=$b_most"
}

# That of the layout's base design, unless it is that of a layout before.
draw_plane() {
  local c_lo c_hi zh=${hi:-0} c_d
  [ -z "$(twin_of "$layout")" ] || return 0
  read -r c_lo c_hi < <(range_of_c_d)
  c_d=$(sed 1d "$folder/telling.$layout.csv" | cut -d , -f 2 | tr '\n' ' ')
  picture "plane.$layout" "$layout" plane "c_lo=$c_lo" "c_hi=$c_hi" "telling='$c_d'" "z_lo=${lo:-0}" "z_hi=${zh/inf/1e300}" "yours=${own_c_d:-0}"
}

# Where the intervals of the layout are over k_s, with some room: settings for the picture.
range_of_k_s() {
  [ -s "$folder/regions.$layout.csv" ] || return 0
  awk -F, -v k_psi="$(of_gear k_psi 1)" -v base="${base_k_s/inf/0}" '
    NR <= 3 { next }
    $3 == "inf" { rigid = 1 }
    $3 != "inf" { if (!lo) lo = $3; hi = $3 }
    { if (!least || ($4 > 0 && $4 + 0 < least)) least = $4; if ($4 > most) most = $4; if ($5 != "inf" && $5 + 0 > most) most = $5; if ($5 == "inf") open = 1 }
    END {
      if (!lo) exit
      if (base > 0 && base < lo) lo = base
      if (rigid) hi = lo < 10 * k_psi ? 100 * k_psi : 1999 * k_psi
      else hi = 1.2 * (base > hi ? base : hi)
      if (!most) most = k_psi
      if (!(least > 0)) least = most / 100
      printf "k_lo=%.6g; k_hi=%.6g; c_least=%.6g; c_most=%.6g", lo / 1.2, hi, least / 1.3, most * (open ? 10 : 1.3)
    }' "$folder/regions.$layout.csv"
}

draw_cycles() {
  local layout what diagram
  for layout in $layouts; do
    get_base "$layout"
    [ ! -s "$folder/torus.$layout.csv" ] || draw_plane
    for what in psi dstar; do
      [ ! -s "$folder/history.$layout.csv" ] || picture "history.$layout.$what" "$layout" history "what='$what'"
      for diagram in $(diagrams_of "$layout"); do
        picture "branches.$layout.$diagram.$what" "$layout" branches "diagram='$diagram'" "what='$what'"
      done
    done
  done
}

# The diagrams of a layout that show a branch, in the order of telling.LAYOUT.csv.
diagrams_of() { # LAYOUT
  awk -F, -v layout="$1" '$1 == layout && $4 != "straight" && !seen[$2]++ { print $2 }' "$folder/branches.csv" | sort -t . -k 2n
}
