#!/usr/bin/env bash
# Real joints and real dampers: what play, friction, orifice and relief valve do (docs/joints.md)
#
#   scripts/studies/joints.sh      all of it
#   scripts/studies/joints.sh runs [cycles | play | planes | friction | thresholds | dampers | starts] | tables | draw
#
# Needs:  results/damping.csv
# Writes: results/joints.csv, joints_play.csv, joints_planes.csv, joints_planes_cycles.csv, joints_planes_hopf.csv,
#         joints_friction.csv, joints_thresholds.csv, joints_device.csv, joints_dampers.csv,
#         joints_quadratic.csv, joints_starts.csv; joints.png, joints_planes.png,
#         joints_friction.png, joints_dampers.png, and .svg; build/tables/joints.*.csv
# Expect: with a quarter of a degree of play every design shimmies from 10 to 160 m/s
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

readonly degree=0.017453292519943295 # rad
readonly layouts="l1 l2 li1 li2 li3"

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
  mapfile -t files < <(sources "$2" models/libmlg/{balance,cycle,motion,poincare,integrate,eigenvalues}.c scripts/mlg/gear/{joints,grid}.c)
  [ "$4" != decay ] || files+=(scripts/mlg/gear/decay.c)
  made "joints.$1.$2" "${files[@]}" -- "${@:3}"
}

# c_2 of a damper without linear part whose mean damping at 1 degree and 11 Hz is c
quadratic() { awk -v c="$1" -v A=$degree 'BEGIN { pi = atan2(0, -1); printf "%.8g", 3 * pi * c / (8 * 2 * pi * 11 * A) }'; }

# Degrees of play in rad, for ranges
rad() { awk -v x="$1" -v d=$degree 'BEGIN { printf "%.12g", x * d }'; }

# Sets words: the gear of a choice, but c_d
words_of() { # LAYOUT CHOICE
  gear "$1" "$2"
  words=("$1" k_s="$k_s" b="$b")
}

# mlg joints with these words for each layout and choice, named by PREFIX and choice
for_choices() { # PREFIX WORD...
  local prefix=$1 layout choice k_s b c_d words
  shift
  for layout in $layouts; do
    for choice in middle best; do
      words_of "$layout" $choice
      of "$prefix$choice" "$layout" mlg joints "${words[@]}" c_d="$c_d" "$@" cycles=1
    done
  done
}

# Amplitudes over V and play
runs_cycles() { for_choices '' V=10:200:20 g_psi="$(rad 0.125):$(rad 1):8"; }

# Psi over a play so small that the gear is linear
runs_play() { for_choices small. V=5:200:40 g_psi="$(rad 0.02)"; }

# The parts of the Hopf curves beside which the gear without play is stable: piece,V,c_d
margin() { # WORD...
  local number V at piece=0 last=
  echo piece,V,c_d
  mlg plane "$@" V_least=0.5 c_least=500 c_most=5e4 | awk -F, '($2 == "open" || $2 == "closed") && $4 == "" {
      x = $5 / 200; y = log($6) / log(100) # in parts of the axes
      if ($1 == number && (x - last_x) ^ 2 + (y - last_y) ^ 2 < 0.005 ^ 2) next
      print $1, $5, $6; number = $1; last_x = x; last_y = y }' |
    while read -r number V at; do
      # its own mode is at the margin, to rounding
      if mlg damping "$@" V="$V" c_d="$at" | awk -F, 'NR == 2 { exit !($1 > -1e-7) }'; then
        [ "$last" = "$number" ] || piece=$((piece + 1))
        echo "$piece,$V,$at"
        last=$number
      else
        last=''
      fi
    done
}

runs_planes() {
  local layout k_s b c_d words
  for layout in $layouts; do
    words_of "$layout" middle
    of margin "$layout" margin "${words[@]}"
    of plane "$layout" mlg joints "${words[@]}" g_psi="$(rad 0.1)" V=5:200:40 c_d=500:5e4:40
    of plane.cycles "$layout" mlg joints "${words[@]}" g_psi="$(rad 0.1)" V=10:200:20 c_d=500:5e4:21 cycles=1
  done
}

# How much friction, of the wheels or of the device, how much play needs, by integration and by
# describing functions (mlg decay). LI2's shimmy dies, goes on and dies again,
# and where hangs on rounding, too.
runs_friction() {
  local layout k_s b c_d words
  for layout in $layouts; do
    words_of "$layout" middle
    [ "$layout" != li2 ] || words+=(steps=16)
    of friction.V "$layout" mlg decay "${words[@]}" c_d="$c_d" g_psi="$(rad 0.25)" v_f=0.01 V=10:170:9 T_psi=0:1000
    of friction.wheels "$layout" mlg decay "${words[@]}" c_d="$c_d" v_f=0.01 V=20:60:2 g_psi="$(rad 0.1):$(rad 1):4" T_psi=0:2000
    words_of "$layout" middle
    of friction.device "$layout" mlg joints "${words[@]}" c_d="$c_d" v_f=0.01 V=60 g_psi=0:"$(rad 1)":5 T_f=0:4000:11 cycles=1
  done
}

# Which disturbance less friction does not stop
runs_thresholds() {
  local layout k_s b c_d words
  for layout in $layouts; do
    words_of "$layout" middle
    words+=(c_d="$c_d" g_psi="$(rad 0.25)" v_f=0.01 release=0.01:5 steps=16)
    of threshold.60 "$layout" mlg decay "${words[@]}" V=60 T_psi=10:80:8
    of threshold.20 "$layout" mlg decay "${words[@]}" V=20 T_psi=40:320:8
  done
}

# The largest growth over V up to 200 m/s at psi of 1 degree for N quadratic dampers whose c_2 is
# that of FROM to TO: lines of c and growth
growth_over_c() { # FROM TO N WORD...
  mlg joints "${@:4}" c_d=1 at=1 V=2:200:67 c_2="$(quadratic "$1"):$(quadratic "$2"):$3" |
    awk -F, -v unit="$(quadratic 1)" 'NR > 1 { if (!($2 in most) || $3 > most[$2]) most[$2] = $3 }
      END { for (c in most) printf "%.6g %.4g\n", c / unit, most[c] }' | sort -g
}

# Of lines of c and growth the widest stretch without growth: the c before, of its ends, and after
free_stretch() {
  awk '{ c[NR] = $1; free = $2 <= 0 } free && !first { first = NR } !free { first = 0 }
    free && c[NR] / c[first] >= wide { wide = c[NR] / c[first]; lo = first; hi = NR }
    END { if (lo) print (lo > 1 ? c[lo - 1] : c[lo]), c[lo], c[hi], (hi < NR ? c[hi + 1] : c[hi]) }'
}

# The interval of c in which a quadratic damper lets no oscillation with psi of 1 degree grow at any
# V, looked for from NEAR / 4 to 100 NEAR, its ends to 1e-3; empty: there is none
left_of_region() { # NEAR WORD...
  local before lo='' hi='' after
  echo c_lo,c_hi
  read -r before lo hi after < <(growth_over_c "$(awk "BEGIN { print $1 / 4 }")" "$(awk "BEGIN { print $1 * 100 }")" 90 "${@:2}" | free_stretch) || true
  if [ -n "$lo" ]; then
    for _ in 1 2; do # each time a tenth of the step
      read -r before lo _ < <(growth_over_c "$before" "$lo" 11 "${@:2}" | free_stretch)
      read -r _ _ hi after < <(growth_over_c "$hi" "$after" 11 "${@:2}" | free_stretch)
    done
  fi
  echo "$lo,$hi"
}

runs_dampers() {
  local layout k_s b c_d words size
  for layout in $layouts; do
    words_of "$layout" middle
    of quadratic "$layout" mlg joints "${words[@]}" c_d=1 c_2="$(quadratic "$c_d")" V=10:200:20 cycles=1
    for size in 0.1 1 5; do
      of "at$size" "$layout" mlg joints "${words[@]}" c_d=1 c_2="$(quadratic "$c_d")" at="$size" V=5:200:40
    done
    of relief "$layout" mlg decay "${words[@]}" c_d="$c_d" T_max=2000 c_r="$(awk -v c="$c_d" 'BEGIN { print c / 100 }')" \
      V=10:100:10 release=0.1:15 size=0.2
    of left "$layout" left_of_region "$c_d" "${words[@]}"
  done
}

# Large starts again, with play and friction on
runs_starts() {
  local layout k_s b c_lo c_hi files
  for layout in $layouts; do
    k_s=718567 b=28.77 # LI3's
    paper_gear "$layout"
    mapfile -t files < <(sources "$layout" models/libmlg/{integrate,eigenvalues}.c scripts/mlg/gear/search.c)
    made "joints.starts.$layout" "${files[@]}" -- mlg search "$layout" k_s="$k_s" b="$b" c_lo="$c_lo" c_hi="$c_hi" \
      g_psi="$(rad 0.25)" corner=0.02 T_psi=300 v_f=0.05 starts=40 longest=120
  done
}

# take NAME LAYOUT CELLS COLUMNS: the table build/tables/joints.NAME.LAYOUT.csv with CELLS before
take() { mlg pick "build/tables/joints.$1.$2.csv" columns="$4" | sed "s/^/$3,/" >> "$table.new"; }

# As a table over g_psi rad: psi in units of the play, inf and nothing as they are
over_play() { # PLAY (deg) NAME LAYOUT CELLS COLUMNS, the amplitudes last and the ones before them
  mlg pick "build/tables/joints.$2.$3.csv" columns="$5" | awk -F, -v OFS=, -v before="$4" -v g="$1" '
    function ratio(psi) { return psi == "" || psi == "inf" ? psi : sprintf("%.5g", psi / g) }
    { $NF = ratio($NF); $(NF - 1) = ratio($(NF - 1)); for (k = 1; k < NF - 1; k++) $k = sprintf("%.6g", $k); print before, $0 }' >> "$table.new"
}

table_of_cycles() {
  local layout choice
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
}

table_of_play() {
  local layout choice
  begin_table results/joints_play.csv \
    "# The play from which on psi is more than 0.1 degree beyond it, g deg, at V m/s: 0.1/(ratio_cycle - 1), for while amplitudes are" \
    "# small psi goes in proportion to the play; empty: at none up to 10 degrees. ratio, ratio_cycle: psi over a play of 0.02 degrees, by" \
    "# describing functions and by integration (joints.csv); 0: no cycle." \
    layout,choice,V,ratio,ratio_cycle,g
  for layout in $layouts; do
    for choice in middle best; do
      over_play 0.02 small.$choice "$layout" "$layout,$choice" V,psi,psi_cycle
    done
  done
  awk -F, -v OFS=, '/^l/ && !/^layout/ { $6 = $5 > 1.01 ? sprintf("%.4g", 0.1 / ($5 - 1)) : "" } { print }' "$table.new" > "$table.more"
  mv "$table.more" "$table.new"
  replace "$table"
}

tables_of_planes() {
  local layout
  begin_table results/joints_planes.csv \
    "# The plane of V (m/s) and c_d (N m s/rad) at the k_s and b of choice middle: ratio, psi of the largest stable cycle over g_psi," \
    "# by describing functions, the gear linear: the same for any play. 0: no cycle, inf: it grows without play, too." \
    layout,V,c_d,ratio
  for layout in $layouts; do
    mlg pick "build/tables/joints.plane.$layout.csv" columns=V,c_d,psi | awk -F, -v layout="$layout" \
      '{ printf "%s,%s,%.6g,%s\n", layout, $1, $2, $3 == "inf" ? "inf" : sprintf("%.5g", $3 / 0.1) }' >> "$table.new"
  done
  replace "$table"

  begin_table results/joints_planes_cycles.csv \
    "# The same plane in other steps with a play of 0.1 degree: ratio, psi over the play by describing functions; ratio_cycle, by" \
    "# integration as in joints.csv. 0: no cycle, inf: it grows without play, too, empty: no periodic orbit in 20 s." \
    layout,V,c_d,ratio,ratio_cycle
  for layout in $layouts; do over_play 0.1 plane.cycles "$layout" "$layout" V,c_d,psi,psi_cycle; done
  replace "$table"

  begin_table results/joints_planes_hopf.csv \
    "# The Hopf curves of the plane without play, exactly (mlg plane), where shimmy begins: the parts beside which the gear is" \
    "# stable. V m/s, c_d N m s/rad." \
    layout,piece,V,c_d
  for layout in $layouts; do take margin "$layout" "$layout" piece,V:.6g,c_d:.6g; done
  replace "$table"
}

tables_of_friction() {
  local layout
  begin_table results/joints_friction.csv \
    "# Friction T_psi, N m, of the wheel assembly (v_f 0.01 rad/s) above which play g_psi, rad, sustains no shimmy at V m/s, released" \
    "# at psi of 5 degrees: by integration and by describing functions (balance), to 1e-3 (mlg decay); empty: none up to 1000 N m" \
    "# (V in steps of 20), 2000 N m (V 20 and 60). choice middle. LI2: the last of the changes that 16 steps show, no sharp bound." \
    layout,V,g_psi,T_psi,T_psi_balance
  for layout in $layouts; do
    mlg pick "build/tables/joints.friction.V.$layout.csv" columns=V,T_psi,balance | sed "s/,/,$(rad 0.25),/; s/^/$layout,/" >> "$table.new"
    take friction.wheels "$layout" "$layout" V,g_psi,T_psi,balance
  done
  replace "$table"

  begin_table results/joints_device.csv \
    "# Shimmy at V = 60 m/s over friction T_f, N m, of the device (v_f 0.01 rad/s) and play g_psi, rad; choice middle. psi deg," \
    "# frequency_hz, psi_cycle, hz_cycle, multiplier: as in joints.csv; 0: none." \
    layout,V,g_psi,T_f,psi,frequency_hz,psi_cycle,hz_cycle,multiplier
  for layout in $layouts; do take friction.device "$layout" "$layout,60" g_psi,T_f,psi,frequency_hz,psi_cycle,hz_cycle,multiplier; done
  replace "$table"

  begin_table results/joints_thresholds.csv \
    "# The disturbance from which on friction T_psi, N m, of the wheel assembly (v_f 0.01 rad/s) no longer stops shimmy of a play of 0.25" \
    "# degrees, choice middle: release deg, the least psi released with all else at rest from which it goes on, by integration;" \
    "# balance deg, psi of the unstable cycle by describing functions; both to 1e-3 between 0.01 and 5 degrees (mlg decay), empty:" \
    "# from and balance_from say what happens at 0.01 degrees, to and balance_to at 5: dies, goes on." \
    layout,V,T_psi,release,from,to,balance,balance_from,balance_to
  for layout in $layouts; do
    take threshold.20 "$layout" "$layout,20" T_psi,release,from,to,balance,balance_from,balance_to
    take threshold.60 "$layout" "$layout,60" T_psi,release,from,to,balance,balance_from,balance_to
  done
  replace "$table"
}

tables_of_dampers() {
  local layout size
  begin_table results/joints_dampers.csv \
    "# quadratic: a damper c_2 with c_d = 1 N m s/rad, in the mean the c_d of choice middle at 1 degree and 11 Hz of its own; its" \
    "# stable cycle psi deg over V m/s by describing functions (inf: at 30 degrees it grows), psi_cycle by integration. at0.1, at1, at5: growth 1/s of the mode" \
    "# that grows fastest at that amplitude of psi, deg, with frequency_hz Hz. relief: c_d of choice middle with a sharp valve that" \
    "# opens at 2000 N m (c_r = c_d/100); threshold deg: psi released from which on it grows by integration (to 15 degrees), psi" \
    "# that of the unstable cycle by describing functions; empty: there is none." \
    layout,what,V,psi,psi_cycle,threshold,growth,frequency_hz
  for layout in $layouts; do
    mlg pick "build/tables/joints.quadratic.$layout.csv" columns=V,psi,psi_cycle | sed "s/^/$layout,quadratic,/; s/$/,,,/" >> "$table.new"
    for size in 0.1 1 5; do
      mlg pick "build/tables/joints.at$size.$layout.csv" columns=V,growth,frequency_hz |
        awk -F, -v name="$layout,at$size" '{ print name "," $1 ",,,," $2 "," $3 }' >> "$table.new"
    done
    mlg pick "build/tables/joints.relief.$layout.csv" columns=V,balance,release |
      awk -F, -v name="$layout,relief" '{ print name "," $1 "," $2 ",," $3 ",," }' >> "$table.new"
  done
  replace "$table"

  begin_table results/joints_quadratic.csv \
    "# What a quadratic damper leaves of the zero-shimmy interval: c_lo to c_hi, N m s/rad, in which no oscillation with psi of so many" \
    "# degrees grows at any V = 2, 5, ... 200 m/s, by describing functions, to 1e-3; empty: none is left. c: the damping in the mean at 1" \
    "# degree and 11 Hz of the damper, c_2 = 3 pi c / (8 w A). Computed at 1 degree; only c times the amplitude counts. middle: c_d of" \
    "# choice middle; linear_lo, linear_hi: the interval of c_d." \
    layout,psi,c_lo,c_hi,middle,linear_lo,linear_hi
  for layout in $layouts; do rows_left "$layout"; done >> "$table.new"
  replace "$table"
}

table_of_starts() {
  local layout
  begin_table results/joints_starts.csv \
    "# mlg search: 40 large starts in each interval of the paper, LI3 in that of docs/layouts.md, with play 0.25 degrees (corner 0.02)" \
    "# and T_psi = 300 N m (v_f 0.05). V m/s, c_d N m s/rad; psi_start, psi_end deg in the first and last two seconds; verdict:" \
    "# falls below a tenth of 15 degrees and 0.03 m, or is sustained, that is not there after 120 s or does not fall." \
    layout,V,c_d,psi_start,psi_end,seconds,verdict
  for layout in $layouts; do take starts "$layout" "$layout" V,c_d,psi_start,psi_end,seconds,verdict; done
  replace "$table"
}

rows_left() { # LAYOUT
  local k_s b c_d lo hi words
  words_of "$1" middle
  IFS=, read -r lo hi _ < <(mlg intervals "${words[@]}" | sed -n 3p)
  sed 1d "build/tables/joints.left.$1.csv" | awk -F, -v layout="$1" -v m="$c_d" -v lo="$lo" -v hi="$hi" '
    { n = split("0.1 1 5", psi, " ")
      for (k = 1; k <= n; k++) {
        if ($1 == "") printf "%s,%s,,", layout, psi[k]; else printf "%s,%s,%.5g,%.5g", layout, psi[k], $1 / psi[k], $2 / psi[k]
        printf ",%s,%.7g,%.7g\n", m, lo, hi
      } }'
}

tables() {
  table_of_cycles
  table_of_play
  tables_of_planes
  tables_of_friction
  tables_of_dampers
  table_of_starts
}

draw() {
  local figure
  use scripts/pictures/joints_common.gp
  for figure in joints joints_planes joints_friction joints_dampers; do draw_picture; done
}

main joints "$@"
