# shellcheck shell=bash
# words.sh - a study as a page: what its tables say, in words; sourced by study.sh
# shellcheck disable=SC2154 # variables of study.sh

# table FILE COLUMNS [NAME=VALUE ...]: rows as a Markdown table (markdown.awk)
table() {
  local words=() word
  for word in "${@:3}"; do words+=(-v "$word"); done
  LC_ALL=C.UTF-8 awk -v columns="$2" "${words[@]}" -f scripts/study/markdown.awk "$folder/$1"
}

stiffness() { case $1 in inf) echo "rigid" ;; *) echo "$(number "$1" "${2:-%.4g}") N m/rad" ;; esac; }

number() { awk -v x="$1" -v f="${2:-%.4g}" 'BEGIN { if (x == "inf") printf "infinity"; else printf f, x }'; }

name_of() { tr '[:lower:]' '[:upper:]' <<< "$1"; } # l1: L1

interval_words() { # LO HI
  case $1,$2 in
    0,inf) echo "every c_d is free of shimmy" ;;
    0,*) echo "no shimmy for c_d below $(number "$2") N m s/rad" ;;
    *,inf) echo "no shimmy for c_d above $(number "$1") N m s/rad" ;;
    *) echo "no shimmy for c_d from $(number "$1") to $(number "$2") N m s/rad" ;;
  esac
}

# The intervals of a layout at k_s and b, in words.
intervals_words() { # LAYOUT WORD...
  local rows lo hi n
  rows=$(mlg intervals "$1" "${gear[@]}" V_top="$top" "${@:2}")
  if grep -q diverges <<< "$rows"; then
    echo "the gear **diverges** at every speed and every c_d: a real root grows, the load F_z is more than its stiffness bears"
    return
  fi
  n=$(sed 1,2d <<< "$rows" | wc -l)
  case $n in
    0) echo "**shimmy at every c_d**, at one speed or another below $top m/s" ;;
    *)
      [ "$n" = 1 ] || printf '**%d separate intervals**: ' "$n"
      sed 1,2d <<< "$rows" | while IFS=, read -r lo hi _; do interval_words "$lo" "$hi"; done | paste -sd ';' | sed 's/;/; /g'
      ;;
  esac
}

# --- sections -----------------------------------------------------------------

head_section() {
  local layout
  echo "# $study: where this gear shimmies, and with which device it does not"
  echo
  echo "Layouts $(for layout in $layouts; do name_of "$layout"; done | paste -sd , | sed 's/,/, /g'); speeds up to V_top = $top m/s; inertances up to b = $(number "$b_most") N m s^2/rad. Regions, intervals, widths and damping ratios are exact (eigenvalue problems, nothing sampled); branches of shimmy are by AUTO-07p."
  echo
  if [ -s "$folder/unsure" ]; then
    echo "**Left out**, for there is no sure answer:"
    echo
    sed 's/^/- /' "$folder/unsure"
    echo
  fi
}

designs_columns="layout=layout|design=design|k_s (N m/rad)=k_s:%.4g|b (N m s²/rad)=b:%.4g|from c_d=c_lo:%.5g|to c_d=c_hi:%.5g|width=width:%.4g|best c_d=c_d:%.4g|least ζ=zeta:%.2e|at V=V:%.3g|mode=shimmy"

best_row() { # COLUMN: the design with most of it
  grep -v -e '^layout' -e ',yours,' "$folder/designs.csv" | awk -F, -v by="$1" '
    { x = by == "width" ? $7 : $16; if (x == "inf") x = 1e300 }
    x != "" && x > most + 0 { most = x; row = $0 }
    END { print row }'
}

build_section() {
  local layout k_s b lo hi width c_d zeta V decay yours
  echo "## What to build"
  echo
  IFS=, read -r layout _ k_s b lo hi width _ _ _ _ limit _ < <(best_row width) || true
  if [ -n "$layout" ]; then
    echo "**Widest interval of c_d:** $(name_of "$layout") with k_s = $(stiffness "$k_s") and b = $(number "$b") N m s^2/rad: $(interval_words "$lo" "$hi") (width $(number "$width"))$([ -z "$limit" ] || echo "; what ends its growth over k_s: $limit")$(awk -v b="$b" -v most="$b_most" 'BEGIN { if (b > 0.999 * most) print "; b is at its bound, and a larger one may do more" }')."
  else
    echo "**No device of these layouts keeps this gear free of shimmy** at all speeds up to $top m/s."
  fi
  echo
  IFS=, read -r layout _ k_s b _ _ _ _ _ _ _ _ _ _ c_d zeta V _ mode decay < <(best_row zeta) || true
  if [ -n "$layout" ]; then
    echo "**Best damped:** $(name_of "$layout") with k_s = $(stiffness "$k_s"), b = $(number "$b"), c_d = $(number "$c_d"): the least damping ratio over all speeds is $(number "$zeta" %.3g), of the $mode mode at $(number "$V") m/s, which decays at $(number "$decay" %.3g) 1/s (to 5 % in $(awk "BEGIN { printf \"%.3g\", log(20) / $decay }") s)."
    echo
  fi
  yours=$(grep ',yours,' "$folder/designs.csv" | sort -u -t , -k 1,1 || true)
  if [ -n "$yours" ]; then
    while IFS=, read -r layout _ k_s b _ _ _ _ _ _ _ _ _ _ c_d zeta V _ mode _; do
      echo "**Your c_d = $(number "$c_d")**, $(name_of "$layout"): $(awk -v z="$zeta" 'BEGIN { print (z > 0 ? "no shimmy" : "shimmy") }'); the least damping ratio is $(number "${zeta:-nan}" %.3g), of the $mode mode at $(number "$V") m/s."
      echo
    done <<< "$yours"
  fi
  echo "By width; c_d in N m s/rad, V in m/s; least ζ is that of the best c_d at that k_s and b:"
  awk -F, -f scripts/study/ranked.awk "$folder/designs.csv" > "$folder/ranked.csv"
  table ranked.csv "$designs_columns"
  echo "\"widest\" is over k_s and b; at it a region is born or two bounds meet, so keep k_s a few per cent off it. An interval says that nothing grows; how fast a disturbance dies is the ratio ζ."
  echo
  [ ! -s "$folder/widths.svg" ] || printf '![widest interval over b](widths.svg)\n\nThe largest width over k_s for each inertance up to the bound b = %s, three times J_zeta unless given.\n\n' "$(number "$b_most")"
}

gear_section() {
  echo "## The gear"
  awk -F, 'NR == 1 || ($1 != "V" && $1 != "c_d" && $1 != "k_s" && $1 != "b")' "$folder/gear.csv" > "$folder/parameters.csv"
  table parameters.csv "parameter=name|unit=unit|value=value:%.6g|the paper's=paper:%.6g|meaning=meaning"
  table facts.csv "fact=fact|value=value:%.6g|unit=unit|meaning=meaning"
  checks
}

# What is outside the range of the model.
checks() {
  local layout diverges='' slips rolls
  for layout in $layouts; do
    ! intervals_words "$layout" | grep -q diverges || diverges+=" $(name_of "$layout")"
  done
  echo "Checks of what the model leaves out:"
  echo
  if [ -n "$diverges" ]; then
    echo "- **Divergence** with$diverges at a rigid k_s: straight rolling falls over without oscillating, at any c_d. No device can help; F_z must fall or k_delta, k_psi, k_d rise."
  else
    echo "- No divergence: the gear bears its load with every layout at a rigid k_s."
  fi
  [ "$exact" = no ] || { echo "- Slip and lift-off of shimmy were not looked at: this is a study of the exact parts alone."; echo; return; }
  slips=$(outside slip) rolls=$(outside roll)
  echo "- Tyre slip: $([ -n "$slips" ] && echo "shimmy **passes the slip angle alpha_m** on branches $slips; there the law of the tyre has a jump and amplitudes are not to be trusted" || echo "no computed shimmy passes the slip angle alpha_m")."
  echo "- Lift-off: $([ -n "$rolls" ] && echo "by the roll of the axle **a wheel would lift off** (a mu k_t/2 above F_z/2) on branches $rolls; the model lets the ground pull it back" || echo "no computed shimmy unloads a wheel by roll")."
  echo
}

outside() { # COLUMN: branches on which it is above 1
  awk -F, -v column="$1" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
    $at > 1 { sub(/\..*/, "", $2); printf "%s%s at c_d = %.4g (%.2g times)", n++ ? ", " : "", toupper($1), $3, $at }' "$folder/cycles.csv"
}

plane_words() { # LAYOUT
  awk -F, '
    /^#/ || $1 == "curve" || NF < 6 { next }
    $4 == "HH" { hh = hh (hh == "" ? "" : ", ") sprintf("(%.4g m/s, %.4g)", $5, $6); next }
    $4 == "LP" { lp = lp (lp == "" ? "" : ", ") sprintf("%.5g (%s, %.3g m/s, %.3g Hz)", $6, $3, $5, $7); next }
    !($1 in seen) { seen[$1] = 1; if ($2 == "closed") closed++; n[$3]++ }
    END {
      if (n["psi"] + n["delta"] == 0) { print "No Hopf curve in this plane."; exit }
      printf "%d Hopf curves of psi and %d of delta%s. ", n["psi"], n["delta"], closed ? ", " closed " of them closed" : ""
      if (lp != "") printf "Boundary points, c_d in N m s/rad: %s. ", lp
      printf "%s\n", hh == "" ? "No double Hopf points." : "Double Hopf points, where two oscillations set in together and torus curves begin: " hh "."
    }' "$folder/plane.$1.csv"
}

# The telling c_d without a Hopf point at which straight rolling is unstable at all speeds.
unstable_throughout() { # LAYOUT
  local c_d hopf
  while IFS=, read -r _ c_d hopf; do
    [ "$hopf" = 0 ] || continue
    mlg damping "$1" "${gear[@]}" "${base[@]}" c_d="$c_d" V="$(times "$top" 0.5)" | awk -F, -v c_d="$c_d" 'NR == 2 && !($1 > 0) { printf "%s ", c_d }'
  done < "$folder/telling.$1.csv"
}

branches_words() { # LAYOUT
  awk -F, -v layout="$1" -v unstable=" $(unstable_throughout "$1")" '
    function list(text) { gsub(" ", ", ", text); return text }
    FNR == 1 { next }
    FILENAME ~ /telling/ { name = $1 "." (FNR - 1); order[++n] = name; c[name] = $2; hopf[name] = $3; next }
    $1 == layout {
      count[$2]++
      shape = $13 && $14 ? "stable in part" : $14 ? "unstable" : "stable"
      text[$2] = text[$2] sprintf("; %s-shimmy from %.4g to %.4g m/s, at most %.3g deg and %.3g mm, %s%s%s%s", $5, $7, $8, $9, 1e3 * $10, shape,
        $11 == "" ? "" : ", torus point at " list($11) " m/s", $12 == "" ? "" : ", fold at " list($12) " m/s", $6 ? "" : ", not followed to its end")
    }
    END {
      for (i = 1; i <= n; i++) {
        name = order[i]
        what = name; sub(/\..*/, "", what)
        if (count[name]) printf "- %s, c_d = %.5g: %d branch%s%s.\n", what, c[name], count[name], (count[name] > 1 ? "es" : ""), text[name]
        else if (hopf[name] == 0 && index(unstable, " " c[name] " ")) printf "- %s, c_d = %.5g: no Hopf point, for straight rolling is **unstable at every speed** up to the top.\n", what, c[name]
        else if (hopf[name] == 0) printf "- %s, c_d = %.5g: no Hopf point, straight rolling keeps its stability from 0 to the top.\n", what, c[name]
        else printf "- %s, c_d = %.5g: %d Hopf points, no branch computed.\n", what, c[name], hopf[name]
      }
    }' "$folder/telling.$1.csv" "$folder/cycles.csv"
}

critical_words() { # LAYOUT
  awk -F, 'NR > 1 { printf "%s at %.4g m/s, c_d = %.5g (a = %.3g 1/(s rad^2))", (n++ ? "; " : "") ($5 < 0 ? "supercritical" : "**subcritical**"), $1, $2, $5 }
    END { if (n) print "." ; else print "" }' "$folder/critical.$1.csv"
}

layout_section() { # LAYOUT
  local layout=$1 words
  get_base "$layout"
  echo "## $(name_of "$layout")"
  echo
  echo "Rigid k_s, no inerter: $(intervals_words "$layout")."
  echo
  if has "$layout" k_s; then
    echo "Shown from here on, $base_name: k_s = $(stiffness "$base_k_s" %.6g)$(! has "$layout" b || echo ", b = $(number "$base_b" %.6g) N m s^2/rad"): $(intervals_words "$layout" "${base[@]}")."
    echo
  fi
  table designs.csv "${designs_columns#*|}" layout="$layout"
  [ ! -s "$folder/plane.$layout.svg" ] || printf '![the V, c_d plane](plane.%s.svg)\n\n%s\n\n' "$layout" "$(plane_words "$layout")"
  if [ -s "$folder/regions.$layout.svg" ]; then
    printf '![intervals over k_s](regions.%s.svg)\n\nGreen: c_d free of shimmy over k_s, at b = %s; the line: the design shown.\n\n' "$layout" "$(number "$base_b")"
  elif has "$layout" k_s && [ -n "$layouts" ]; then
    printf 'No k_s looked at has a zero-shimmy interval at b = %s.\n\n' "$(number "$base_b")"
  fi
  words=$(critical_words "$layout")
  [ -z "$words" ] || printf 'The Hopf points that bound the interval: %s %s\n\n' "$words" \
    "$(grep -q subcritical <<< "$words" && echo 'Subcritical: beside the bound a large disturbance may go on as shimmy although straight rolling is stable; keep away from it.' || echo 'Shimmy begins small there, on the side of shimmy.')"
  [ "$exact" = no ] || return 0
  [ ! -s "$folder/branches.$layout.svg" ] || printf '![shimmy along V](branches.%s.svg)\n\n' "$layout"
  branches_words "$layout"
  echo
  if grep -q "^$layout," "$folder/transients.csv"; then
    echo "After a disturbance (psi' = 1 or delta' = 0.45 rad/s) at the design shown and its $([ -n "$own_c_d" ] && echo "c_d, yours" || echo "best damped c_d"), integrated for 20 s; psi_5 and dstar_5 are the times to 5 %:"
    table transients.csv "V (m/s)=V:%.4g|disturbance=disturbance|c_d=c_d:%.4g|max ψ (deg)=psi_max:%.3g|max δ* (m)=dstar_max:%.3g|psi_5 (s)=psi_5|dstar_5 (s)=dstar_5|linear decay (1/s)=rate:%.3g" layout="$layout"
    [ ! -s "$folder/history.$layout.svg" ] || printf '![decay](history.%s.svg)\n\nThe first two seconds after psi'"'"' = 1 rad/s.\n\n' "$layout"
  fi
}

last_section() {
  echo "## What failed, and what this is made of"
  echo
  if [ "$exact" = no ]; then
    if [ "$(wc -l < "$folder/failures.csv")" -gt 1 ]; then
      echo "Runs of AUTO that failed; what they would show is missing above:"
      table failures.csv "run=run|reason=reason"
    else
      echo "No run failed."
      echo
    fi
  fi
  echo "Tables beside this page: designs.csv, gear.csv, facts.csv, cycles.csv, branches.csv, transients.csv, plane.\*.csv, strips.\*.csv, regions.\*.csv, limits.\*.csv. What each part says and by which rules: docs/study.md. The limits of the model: docs/model.md; zero shimmy means that straight rolling is linearly stable."
}

report() {
  local layout
  head_section
  build_section
  gear_section
  for layout in $layouts; do layout_section "$layout"; done
  last_section
}
