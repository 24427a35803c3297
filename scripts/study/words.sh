# shellcheck shell=bash
# words.sh - what the tables of a study say, in sentences; sourced by study.sh
# shellcheck disable=SC2154 # variables of study.sh

# table FILE COLUMNS [NAME=VALUE ...]: rows as a Markdown table (markdown.awk)
table() {
  local words=() word
  for word in "${@:3}"; do words+=(-v "$word"); done
  LC_ALL=C.UTF-8 awk -v columns="$2" "${words[@]}" -f scripts/study/markdown.awk "$folder/$1"
}

number() { awk -v x="$1" -v f="${2:-%.4g}" 'BEGIN { if (x == "inf") printf "infinity"; else printf f, x }'; }

name_of() { tr '[:lower:]' '[:upper:]' <<< "$1"; } # l1: L1

list_of() { tr ' ' '\n' | sed '/^$/d' | paste -sd , | sed 's/,/, /g'; } # words on standard input

# "k_s = 7.87e+05 N m/rad, b = 0", of what the layout has
device_words() { # LAYOUT K_S B [FORMAT]
  local spring='' inerter=''
  ! has "$1" k_s || case $2 in inf) spring="k_s rigid (no spring)" ;; *) spring="k_s = $(number "$2" "${4:-%.4g}") N m/rad" ;; esac
  ! has "$1" b || inerter="b = $(number "$3" "${4:-%.4g}") N m s²/rad"
  echo "$spring${inerter:+, $inerter}"
}

with_words() { # LAYOUT K_S B: "L2 with k_s = ...", "L1"
  local device
  device=$(device_words "$@")
  echo "$(name_of "$1")${device:+ with $device}"
}

interval_words() { # LO HI
  case $1,$2 in
    0,inf) echo "every c_d is free of shimmy" ;;
    0,*) echo "no shimmy for c_d below $(number "$2") N m s/rad" ;;
    *,inf) echo "no shimmy for c_d above $(number "$1") N m s/rad" ;;
    *) echo "no shimmy for c_d from $(number "$1") to $(number "$2") N m s/rad" ;;
  esac
}

# The intervals of a layout at k_s and b.
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

# What ends the growth of the widest interval over k_s (mlg widest).
limit_words() { # LIMIT
  case $1 in
    onset) echo "beyond that k_s a region of shimmy is born inside it" ;;
    equal) echo "beyond that k_s another region of shimmy bounds it from below" ;;
    "equal above") echo "beyond that k_s another region of shimmy bounds it from above" ;;
    stationary) echo "over k_s its width has a maximum there" ;;
    rigid) echo "the stiffer k_s, the wider" ;;
    soft) echo "the softer k_s, the wider, down to where it was looked for" ;;
    unbounded) echo "it has no upper bound" ;;
  esac
}

# How far c_d may be off: "c_d may be 12 % less or 30 % more"
margin_words() { # C_D LO HI
  awk -v c="$1" -v lo="$2" -v hi="$3" 'BEGIN {
    less = 100 * (1 - lo / c)
    if (hi == "inf") printf "c_d may be %.2g %% less, and as much more as one likes", less
    else printf "c_d may be %.2g %% less or %.2g %% more", less, 100 * (hi / c - 1)
    if (hi != "inf" && lo > 0 && hi / lo < 1.1) printf ", for the whole interval is **narrow**"
    else if (less < 5 || (hi != "inf" && hi / c < 1.05)) printf ", which is **tight**: the middle of the interval, c_d = %.4g, is damped less but forgives more", \
      (hi == "inf" ? 2 * lo : lo > 0 ? sqrt(lo * hi) : hi / 2)
  }'
}

# Of a damping ratio: when the slowest disturbance is down to 5 %.
decay_words() { # ZETA V MODE T_5
  echo "its least damping ratio over all speeds is $(number "$1" %.3g), of the $3 mode at $(number "$2" %.3g) m/s, which takes $(number "$4" %.3g) s to die to 5 %"
}

outside() { # COLUMN: branches on which it is above 1
  awk -F, -v column="$1" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
    $at > 1 { sub(/\..*/, "", $2); printf "%s%s %s, c_d = %.4g (%.3g times)", n++ ? "; " : "", toupper($1), $2, $3, $at }' "$folder/cycles.csv"
}

plane_words() { # LAYOUT
  awk -F, '
    /^#/ || $1 == "curve" || NF < 6 { next }
    $4 == "HH" { hh = hh (n_hh++ ? "; " : "") sprintf("%.4g m/s, c_d = %.4g", $5, $6); next }
    $4 == "LP" { lp = lp (n_lp++ ? "; " : "") sprintf("c_d = %.5g at %.3g m/s (%s, %.3g Hz)", $6, $5, $3, $7); next }
    !($1 in seen) { seen[$1] = 1; curves++; if ($2 == "closed") closed++ }
    END {
      if (!curves) { print "There is no Hopf curve in this plane: nothing changes with V or c_d."; exit }
      printf "%d Hopf curve%s%s. ", curves, (curves > 1 ? "s" : ""), (closed ? ", " closed " of them closed" : "")
      if (n_lp) printf "%s, where c_d along a curve is least or largest: %s. ", (n_lp > 1 ? n_lp " boundary points" : "A boundary point"), lp
      if (n_hh) printf "%s, where two oscillations set in together: %s.\n", (n_hh > 1 ? "Double Hopf points" : "A double Hopf point"), hh
      else print "No double Hopf points."
    }' "$folder/plane.$1.csv"
}

# Each curve, of which shimmy, and why it ends; and what follows past it.
torus_words() { # LAYOUT
  [ -s "$folder/torus.$1.csv" ] || return 0
  local kinds
  kinds=$(awk -F, '!/^#/ && $1 != "curve" && $3 != "" && $4 != "HH" { print $3 }' "$folder/plane.$1.csv" | sort -u | paste -sd ' ')
  awk -F, -v kinds="$kinds" '
    function ends(first, last) { return first == last ? "both ends " why[first] : "the first end " why[first] ", the last " why[last] }
    BEGIN {
      why["double Hopf"] = "at a double Hopf point"
      why["vanishes"] = "where the orbit vanishes"
      why["angle"] = "where the torus angle has come to 0, on a curve of folds or of branch points"
      why["edge"] = "at the edge of the plane"
      why["AUTO"] = "where AUTO found no more of it"
    }
    FNR == 1 { next }
    FILENAME ~ /ends/ { text[$1] = sprintf(" (%s)", ends($4, $5)); shimmy[$1] = $2; next }
    NF == 3 { if (!($1 in from)) { order[++n] = $1; from[$1] = sprintf("(%.4g m/s, %.4g)", $2, $3) } to[$1] = sprintf("(%.4g m/s, %.4g)", $2, $3) }
    END {
      printf "Torus curves (dashed), across which a second frequency grows on a computed shimmy, or dies out: "
      for (i = 1; i <= n; i++) { k = order[i]; printf "%sof %s-shimmy from %s to %s%s", (i > 1 ? "; " : ""), shimmy[k], from[k], to[k], text[k] }
      if (kinds == "psi" || kinds == "delta") printf ". Only %s-shimmy grows in this plane: past the curve it goes on, modulated.\n", kinds
      else print ". Where the other shimmy grows too, the gear as a rule goes over to it; where not, the shimmy goes on, modulated."
    }' "$folder/torus_ends.$1.csv" "$folder/torus.$1.csv"
}

# Do the computed branches bear out the names by which the plane is shaded?
names_words() { # LAYOUT
  awk -F, -v layout="$1" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $1 == layout {
      n++
      if ($at["born"] != $5) other = other sprintf("%s%s-shimmy at c_d = %.4g goes over into %s-shimmy as it grows", other == "" ? "" : "; ", $at["born"], $3, $5)
    }
    END {
      if (!n) exit
      if (other == "") printf "Regions are named by the mode that grows; the %s computed below show%s the same.\n", (n > 1 ? n " branches" : "branch"), (n > 1 ? "" : "s")
      else printf "Regions are named by the mode that grows; of the %d branches computed below, %s.\n", n, other
    }' "$folder/cycles.csv"
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
  awk -F, -v layout="$1" -v top="$top" -v unstable=" $(unstable_throughout "$1")" '
    function list(text) { gsub(" ", ", ", text); return text }
    function points(text) { n_points = split(text, junk, " "); return n_points > 1 ? "points" : "point" }
    BEGIN {
      end["V_top"] = " and on"
      end["V_least"] = " and on to lower V"
      end["psi_max"] = ", followed to 60 degrees"
      end["dstar_max"] = ", followed to δ* = 0.3 m"
      end["branch point"] = " (**in part**: AUTO stopped at a branch point; the shimmy beyond was not followed)"
      end["AUTO"] = " (**in part**: AUTO went no further)"
    }
    FNR == 1 { next }
    FILENAME ~ /telling/ { name = $1 "." (FNR - 1); order[++n] = name; c[name] = $2; hopf[name] = $3; next }
    $1 == layout {
      count[$2]++
      shape = $13 && $14 ? "stable in part" : $14 ? "unstable" : "stable"
      text[$2] = text[$2] sprintf("; %s-shimmy from %.4g to %.4g m/s%s, at most %.3g deg and %.3g mm, %s%s%s%s", $5, $7, $8, end[$19], $9, 1e3 * $10, shape,
        $11 == "" ? "" : ", torus " points($11) " at " list($11) " m/s", $12 == "" ? "" : ", fold" (points($12) == "points" ? "s" : "") " at " list($12) " m/s",
        $20 == "" ? "" : ", branch " points($20) " at " list($20) " m/s, where another shimmy branches off that was not followed")
    }
    END {
      for (i = 1; i <= n; i++) {
        name = order[i]
        what = name; sub(/\..*/, "", what)
        if (count[name]) printf "- %s, c_d = %.5g: %d branch%s%s.\n", what, c[name], count[name], (count[name] > 1 ? "es" : ""), text[name]
        else if (hopf[name] == 0 && index(unstable, " " c[name] " ")) printf "- %s, c_d = %.5g: no Hopf point, for straight rolling is **unstable at every speed** up to V_top.\n", what, c[name]
        else if (hopf[name] == 0) printf "- %s, c_d = %.5g: no Hopf point, straight rolling is stable at every speed up to V_top.\n", what, c[name]
        else printf "- %s, c_d = %.5g: %d Hopf points, no branch computed.\n", what, c[name], hopf[name]
      }
    }' "$folder/telling.$1.csv" "$folder/cycles.csv"
}

critical_words() { # LAYOUT
  awk -F, 'NR > 1 { printf "%s%s at %.4g m/s, c_d = %.5g (a = %.3g 1/(s rad²))", n++ ? "; " : "", $5 < 0 ? "supercritical" : "**subcritical**", $1, $2, $5 }
    END { if (n) print "."; else print "" }' "$folder/critical.$1.csv"
}
