# shellcheck shell=bash
# torus.sh - torus curves of a study in the plane of each base design; sourced by study.sh
#
# From every torus point of the diagrams that lies on none yet, both ways, to the double Hopf
# points or the edges of the plane.  In build/studies/NAME: torus.LAYOUT.csv, a block for each;
# torus_ends.LAYOUT.csv, of which shimmy each is, and where and why it ends.
# shellcheck disable=SC2154 # variables of study.sh

# The torus points of a layout, those in the middle of V first: c_d, V, the branch's run, how
# many-th of it, psi there.
torus_points() { # LAYOUT
  awk -F, -v layout="$1" -v top="$top" '$1 == layout && $5 == "TR" {
    run = $1 "." $2 "." $4
    print ($6 - top / 2) ^ 2, $3, $6, run, ++n[run], $7
  }' "$folder/branches.csv" | sort -g | cut -d " " -f 2-
}

# Does a curve pass that point, within 1 % of V_top?
on_a_curve() { # C_D V
  awk -F, -v c="$1" -v V="$2" -v near="$(times "$top" 0.01)" '
    NF == 3 && n == $1 && ($3 - c) * (last_c - c) <= 0 {
      x = $3 == last_c ? $2 : last_V + ($2 - last_V) * (c - last_c) / ($3 - last_c)
      if ((x - V) ^ 2 < near ^ 2) found = 1
    }
    { n = $1; last_V = $2; last_c = $3 }
    END { exit !found }' "$part.torus"
}

# One way along a curve: to where the orbit vanishes, to the edge of the plane, or to where the
# torus angle has come to 0, and the curve ends on one of folds.  At pi it goes on: by the mirror
# symmetry half a period has multipliers of its own, which pass i there.
# Sharp orbits want a fine mesh; the smaller the orbit, the finer the steps to its end.
along_torus() { # MESH STEP END
  local sign='' c_lo c_hi words
  [ "$way" = up ] || sign=-
  end=$(times "$psi" "$3")
  read -r c_lo c_hi < <(range_of_c_d)
  words=(NTST="$1" DSMAX="$(times "$top" "$2")" THL="{'c_d': $(awk "BEGIN { print 1e3 / $c_d ^ 2 }"), 'period': 0.0, 'torus_angle': 0.0}")
  run_or_note "$name.start.$1" "$layout.torus_start" from="$run" IRS="'TR$which'" DS="$(times "$top" 2e-4)" "${words[@]}" -- EP=1 &&
    run_or_note "$name.$way" "$layout.torus" from="$name.start.$1" NMX=800 DS="$sign$(times "$top" 2e-4)" "${words[@]}" \
      UZSTOP="{'psi_max': $end, 'torus_angle': [0.03, 6.25], 'V': [$(times "$top" 1e-3), $top], 'c_d': [$c_lo, $c_hi]}" --
}

# Rows of one way, and the double Hopf point that it ends just short of; into $part.why the end's
# reason: double Hopf, vanishes, angle (of the torus, 0), edge (of the plane).
torus_rows() { # RUN PSI_MAX_AT_ITS_END
  mlg rows "$1" columns=V,c_d,psi_max,torus_angle | awk -F, -v OFS=, -v n="$n" -v end="$2" -v near="$(times "$top" 0.05)" -v why="$part.why" '
    FILENAME == "-" { print n, $1, $2; V = $1; c = $2; vanishes = $3 < 1.01 * end; angle = $4 < 0.0301 || $4 > 6.2499; next }
    vanishes && !HH && $4 == "HH" && ($5 - V) ^ 2 < near ^ 2 && $6 < 1.5 * c && $6 > c / 1.5 { print n, $5, $6; HH = 1 }
    END { print (HH ? "double Hopf" : vanishes ? "vanishes" : angle ? "angle" : "edge") > why }' - "$folder/plane.$layout.csv"
}

# Of a way that the judge rejects the points up to where AUTO found none any more.
torus_part() { # RUN
  echo AUTO > "$part.why"
  { mlg rows "$1" columns=V,c_d,type types=MX 2> /dev/null || true; } | awk -F, -v OFS=, -v n="$n" '$3 == "MX" || $1 $2 ~ /nan|inf/ { exit } { print n, $1, $2 }'
}

torus_curves() { # LAYOUT
  local layout=$1 part=$folder/parts/$1.curves c_d V run which psi n=0 name way end shimmy ends
  : > "$part.failures"
  : > "$part.torus"
  : > "$part.ends"
  while read -r c_d V run which psi; do
    ! on_a_curve "$c_d" "$V" || continue
    n=$((n + 1)) name=$layout.torus.$n ends=''
    for way in up down; do
      rm -rf "$MLG_RUNS/$name.$way.part"
      if try_each "$name.$way" along_torus < <(printf '%s\n' '15 5e-3 0.1' '15 1e-3 0.1' '40 2e-3 0.2'); then
        torus_rows "$name.$way" "$end" > "$part.$way"
      else
        torus_part "$name.$way.part" > "$part.$way"
      fi
      ends+="${ends:+,}$(cat "$part.why")"
    done
    # of a start that led nowhere there is nothing to show
    [ "$(cat "$part.up" "$part.down" | wc -l)" -ge 4 ] || continue
    { tac "$part.up"; cat "$part.down"; echo; } >> "$part.torus"
    shimmy=$(awk -F, -v run="$run" '$1 "." $2 "." $4 == run { print $5; exit }' "$folder/cycles.csv")
    echo "$n,$shimmy,$(cat "$part.up" "$part.down" | wc -l),$ends" >> "$part.ends"
  done < <(torus_points "$layout")
  [ ! -s "$part.torus" ] || {
    { echo curve,V,c_d; cat "$part.torus"; } > "$folder/torus.$layout.csv"
    { echo curve,shimmy,points,first_end,last_end; cat "$part.ends"; } > "$folder/torus_ends.$layout.csv"
  }
}
