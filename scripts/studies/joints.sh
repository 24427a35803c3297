#!/usr/bin/env bash
# Real joints and real dampers: what play, friction, orifice and relief valve do (docs/joints.md)
#
#   scripts/studies/joints.sh      all of it
#   scripts/studies/joints.sh runs [l1 | l2 | li1 | li2 | li3] | tables | draw
#
# Needs:  results/damping.csv
# Writes: results/joints.csv, joints_planes.csv, joints_friction.csv, joints_dampers.csv,
#         joints_starts.csv, joints.png and .svg; build/tables/joints.*.csv
# Expect: with a quarter of a degree of play every design shimmies from 10 to 160 m/s
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

readonly degree=0.017453292519943295 # rad
readonly layouts="l1 l2 li1 li2 li3"
readonly whole="l1 li1" # with planes, friction and dampers, too

# Sets k_s, b, c_d: the middle of the paper's interval (LI3's: docs/layouts.md), or the best damped
gear() { # LAYOUT CHOICE
  case $1.$2 in
    li3.middle) k_s=718567 b=28.77 c_d=10455 ;;
    li3.best) IFS=, read -r k_s c_d _ < <(mlg damping li3 best b=28.77 | sed 1d) && b=28.77 ;;
    *.middle) IFS=, read -r k_s b c_d < <(mlg pick results/damping.csv where=layout="$1" where=choice=middle columns=k_s,b,c_d) ;;
    l1.best) IFS=, read -r k_s b c_d < <(mlg pick results/damping.csv where=layout=l1 where=choice=paper columns=k_s,b,c_d) ;;
    *.best)
      b=140
      if [ "$1" = l2 ]; then b=0; fi
      IFS=, read -r k_s c_d < <(mlg pick results/damping.csv where=layout="$1" where=choice=best where="b=$b" columns=k_s,c_d)
      ;;
  esac
}

of() { # NAME LAYOUT COMMAND...
  local files
  mapfile -t files < <(sources "$2" models/libmlg/{balance,cycle,motion,poincare,integrate,eigenvalues}.c scripts/mlg/gear/joints.c)
  made "joints.$1.$2" "${files[@]}" -- "${@:3}"
}

# c_2 of a damper without linear part whose mean damping at 1 degree and 11 Hz is c
quadratic() { awk -v c="$1" -v A=$degree 'BEGIN { pi = atan2(0, -1); printf "%.8g", 3 * pi * c / (8 * 2 * pi * 11 * A) }'; }

# Degrees of play in rad, for ranges
rad() { awk -v x="$1" -v d=$degree 'BEGIN { printf "%.12g", x * d }'; }

laws_of() { # LAYOUT
  local choice k_s b c_d words play c_2
  for choice in middle best; do
    gear "$1" $choice
    words=("$1" k_s="$k_s" b="$b")
    of "$choice" "$1" mlg joints "${words[@]}" c_d="$c_d" V=10:200:20 g_psi="$(rad 0.125):$(rad 1):8" cycles=1
  done
  case " $whole " in *" $1 "*) ;; *) return 0 ;; esac
  gear "$1" middle
  words=("$1" k_s="$k_s" b="$b")
  of plane "$1" mlg joints "${words[@]}" g_psi="$(rad 0.1)" V=5:200:40 c_d=500:5e4:40
  of friction "$1" mlg joints "${words[@]}" c_d="$c_d" g_psi="$(rad 0.25)" v_f=0.01 V=10:200:20 T_psi=0:600:41
  of hidden "$1" mlg joints "${words[@]}" c_d="$c_d" V=60 v_f=0.01 g_psi="$(rad 0.1):$(rad 1):10" T_psi=0:500:11
  c_2=$(quadratic "$c_d")
  [ "$1" = l1 ] || of quadratic "$1" mlg joints "${words[@]}" c_d=0 c_2="$c_2" V=5:200:40 cycles=1
  for play in 0.1 1 5; do of "at$play" "$1" at_amplitude "$play" "${words[@]}" c_2="$c_2"; done
  of relief "$1" mlg joints "${words[@]}" c_d="$c_d" T_max=2000 c_r="$(awk -v c="$c_d" 'BEGIN { print c / 100 }')" corner=0.05 V=5:200:40
  starts "$1"
}

# The least c_d in the mean over V, and where the oscillation of that amplitude grows
at_amplitude() { # DEGREES LAYOUT WORD...
  local V near
  echo V,growth_psi,growth_delta,c_d_psi,c_d_delta
  for V in $(seq 5 5 200); do
    for near in 8 17.5; do
      mlg joints "${@:2}" c_d=0 V="$V" at="$1" near="$near" 2> /dev/null | sed -n 3p | cut -d, -f2,8
    done | paste -sd, | awk -F, -v V="$V" '{ print V "," $1 "," $3 "," $2 "," $4 }'
  done
}

# Large starts again, with play and friction on
starts() { # LAYOUT
  local k_s b c_lo c_hi files
  paper_gear "$1"
  mapfile -t files < <(sources "$1" models/libmlg/{integrate,eigenvalues}.c scripts/mlg/gear/search.c)
  made "joints.starts.$1" "${files[@]}" -- mlg search "$1" k_s="$k_s" b="$b" c_lo="$c_lo" c_hi="$c_hi" \
    g_psi="$(rad 0.25)" corner=0.02 T_psi=300 v_f=0.05 starts=10
}

for layout in $layouts; do eval "runs_$layout() { laws_of $layout; }"; done

# rows NAME LAYOUT CELLS COLUMNS: the table build/tables/joints.NAME.LAYOUT.csv with CELLS before
take() { mlg pick "build/tables/joints.$1.$2.csv" columns="$4" | sed "s/^/$3,/" >> "$table.new"; }

tables() {
  local layout choice play k_s b c_d
  begin_table results/joints.csv \
    "# Shimmy about the play g_psi (half-width, rad) of the torque links at V m/s. choice: middle of the zero-shimmy interval, or" \
    "# the best damped (best). psi deg, frequency_hz Hz: the largest stable cycle by describing functions (mlg joints);" \
    "# psi_cycle, hz_cycle, multiplier: by integration with located ends of the gap, rtol 1e-8, Newton's method 1e-8; empty: not periodic," \
    "# motion says what (mlg help cycle), psi_most deg is the largest maximum of psi then. 0: it dies out." \
    layout,choice,V,g_psi,psi,frequency_hz,psi_cycle,hz_cycle,multiplier,motion,psi_most
  for layout in $layouts; do
    for choice in middle best; do take $choice "$layout" "$layout,$choice" V,g_psi,psi,frequency_hz,psi_cycle,hz_cycle,multiplier,motion,psi_most; done
  done
  replace "$table"
  begin_table results/joints_planes.csv \
    "# The plane of V (m/s) and c_d (N m s/rad) at the k_s and b of choice middle: ratio, psi of the largest stable cycle over g_psi," \
    "# by describing functions, the gear linear: the same for any play. 0: no cycle, inf: it grows without play, too." \
    layout,V,c_d,ratio
  for layout in $whole; do
    mlg pick "build/tables/joints.plane.$layout.csv" columns=V,c_d,psi | awk -F, -v layout="$layout" \
      '{ printf "%s,%s,%.6g,%s\n", layout, $1, $2, $3 == "inf" ? "inf" : sprintf("%.5g", $3 / 0.1) }' >> "$table.new"
  done
  replace "$table"
  begin_table results/joints_friction.csv \
    "# What friction T_psi (N m, v_f 0.01 rad/s) of the wheel assembly is needed at V m/s so that the play g_psi (rad) sustains no" \
    "# shimmy (T_decay: the least of 41 values up to 600 where no cycle is left, empty: none), by describing functions; and at V = 60" \
    "# psi deg of the largest stable cycle for each T_psi and g_psi, by describing functions; 0: it dies out." \
    layout,what,V,g_psi,T_psi,psi
  for layout in $whole; do
    mlg pick "build/tables/joints.friction.$layout.csv" columns=V,T_psi,psi | awk -F, -v layout="$layout" -v g="$(rad 0.25)" '
      $1 != V { if (NR > 1) print layout ",T_decay," V "," g "," T ","; V = $1; T = "" }
      $3 != "0" { T = "" } $3 == "0" && T == "" { T = $2 }
      END { print layout ",T_decay," V "," g "," T "," }' >> "$table.new"
    take hidden "$layout" "$layout,map,60" g_psi,T_psi,psi
  done
  replace "$table"
  begin_table results/joints_dampers.csv \
    "# quadratic: a damper c_2 without linear part, in the mean the c_d of choice middle at 1 degree and 11 Hz; its stable cycle" \
    "# psi deg over V m/s by describing functions, psi_cycle by integration. at0.1, at1, at5: growth 1/s of the psi and the delta" \
    "# mode at that amplitude of psi, deg. relief: c_d of choice middle with a valve that opens at 2000 N m (c_r = c_d/100, corner" \
    "# 0.05); threshold deg: psi from which on it grows, 0: from none up to 30 degrees, empty: not found." \
    layout,what,V,psi,psi_cycle,threshold,growth_psi,growth_delta
  for layout in $whole; do
    [ "$layout" = l1 ] || mlg pick "build/tables/joints.quadratic.$layout.csv" columns=V,psi,psi_cycle | sed "s/^/$layout,quadratic,/; s/$/,,,/" >> "$table.new"
    for play in 0.1 1 5; do
      mlg pick "build/tables/joints.at$play.$layout.csv" columns=V,growth_psi,growth_delta |
        awk -F, -v name="$layout,at$play" '{ print name "," $1 ",,,," $2 "," $3 }' >> "$table.new"
    done
    mlg pick "build/tables/joints.relief.$layout.csv" columns=V,psi,threshold |
      awk -F, -v name="$layout,relief" '{ print name "," $1 ",,," ($2 == "inf" && $3 == 0 ? "" : $3) ",," }' >> "$table.new"
  done
  replace "$table"
  begin_table results/joints_starts.csv \
    "# mlg search: 10 large starts in each interval of the paper, with play 0.25 degrees (corner 0.02) and T_psi = 300 N m (v_f 0.05)." \
    "# sustained: did not fall below a tenth of 15 degrees and 0.03 m, or not any more; largest psi_end deg after that." \
    layout,starts,sustained,psi_start,psi_end,seconds
  for layout in $whole; do
    mlg pick "build/tables/joints.starts.$layout.csv" columns=verdict,psi_start,psi_end,seconds | awk -F, -v layout="$layout" '
      { n++; s += $1 != "falls"; for (k = 2; k <= 4; k++) if ($k + 0 > most[k] + 0) most[k] = $k }
      END { print layout "," n "," s + 0 "," most[2] "," most[3] "," most[4] }' >> "$table.new"
  done
  replace "$table"
}

main joints "$@"
