# shellcheck shell=bash
# sections.sh - the sections of a study's page, in Markdown; sourced by study.sh
#
# A further section is a function NAME_section, in a file of its own that study.sh sources, and
# its name in `sections`; its tables come from exact_layout (exact.sh) or from a job of cycles.sh.
# shellcheck disable=SC2154 # variables of study.sh

sections='head advice designs gear layouts last'

report() {
  local section
  for section in $sections; do "${section}_section"; done
}

head_section() {
  local layout
  echo "# $study: where this gear shimmies, and with which device it does not"
  echo
  echo "Layouts, each drawn in its section: $(for layout in $layouts; do printf '**%s** %s\n' "$(name_of "$layout")" "$(sed -n '1s/.*layout [^:]*: *//; 1s/ *(paper.*//; 1p' "models/$layout.c")"; done | paste -sd ';' | sed 's/;/; /g'). Speeds up to V_top = $top m/s; inertances up to b = $(number "$b_most") N m s²/rad. ψ is the torsion of the wheels about the strut, δ the lateral bending of the strut, δ* its deflection at the axle; c_d is the damper of the device, k_s the spring in series with it, b an inerter. Shimmy: straight rolling is unstable, and an oscillation of ψ or of δ grows by itself."
  echo
  echo "Regions, intervals, widths and damping ratios are exact (eigenvalue problems, nothing sampled)$([ "$exact" = yes ] || echo "; branches of shimmy and torus curves are by AUTO-07p")."
  echo
  if [ -s "$folder/unsure" ]; then
    echo "**Left out**, for there is no sure answer:"
    echo
    sort -u "$folder/unsure" | sed 's/^/- /'
    echo
  fi
}

# --- all designs --------------------------------------------------------------

designs_columns="layout=layout|design=design|k_s (N m/rad)=k_s:%.4g|b (N m s²/rad)=b:%.4g|from c_d=c_lo:%.5g|to c_d=c_hi:%.5g|width=width:%.4g|c_d=c_d:%.4g|least ζ=zeta:%.2e|at V=V:%.3g|mode=shimmy"

# The row of designs.csv with most of a column; of a layout, or of all.
best_row() { # width|zeta [LAYOUT]
  awk -F, -v by="$1" -v layout="${2:-}" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == by) at = i; next }
    $2 == "yours" || (layout != "" && $1 != layout) || $at == "" { next }
    { x = $at == "inf" ? 1e300 : $at + 0; if (x > most) { most = x; row = $0 } }
    END { print row }' "$folder/designs.csv"
}

designs_section() {
  echo "## All designs"
  echo
  [ -z "$(best_row zeta)" ] || { echo "The advice above goes by the tolerance of errors. Other wishes have other answers: the design that bears most errors, the one damped best and the one with the widest interval are seldom the same." && echo; }
  best_damped_words
  widest_words
  yours_words
  echo "All designs by the width of their interval; c_d in N m s/rad, V in m/s; least ζ is at the c_d beside it, the best damped one at that k_s and b, of the most tolerant design the advised one, of yours your own:"
  awk -F, -f scripts/study/ranked.awk "$folder/designs.csv" > "$folder/ranked.csv"
  table ranked.csv "$designs_columns"
  ! grep -q ',widest[^,]*,[0-9]' "$folder/designs.csv" || # none that is rigid
    echo "At the very k_s of a widest interval a region of shimmy is about to be born, or two bounds meet: keep k_s a few per cent off it. An interval says that nothing grows; how fast a disturbance dies is another matter, and the ratio ζ tells it."
  echo
  [ ! -s "$folder/widths.svg" ] || printf '![widest interval over b](widths.svg)\n\nThe largest width over k_s for each inertance up to b = %s N m s²/rad, three times J_zeta unless b_most is given.\n\n' "$(number "$b_most")"
}

best_damped_words() {
  local layout k_s b lo hi c_d zeta V mode t_5
  IFS=, read -r layout _ k_s b lo hi _ _ _ _ _ _ c_d zeta V _ mode t_5 < <(best_row zeta) || true
  [ -z "$layout" ] || {
    echo "**Best damped:** $(with_words "$layout" "$k_s" "$b") and c_d = $(number "$c_d") N m s/rad: $(decay_words "$zeta" "$V" "$mode" "$t_5"). Its interval: $(interval_words "$lo" "$hi"); $(margin_words "$c_d" "$lo" "$hi")$(bound_words "$b")."
    echo
  }
}

bound_words() { awk -v b="$1" -v most="$b_most" 'BEGIN { if (b > 0.999 * most) print "; b is at its bound, and a larger one may do more" }'; } # B

widest_words() {
  local layout k_s b lo hi width limit
  IFS=, read -r layout _ k_s b lo hi width _ _ _ _ limit _ < <(best_row width) || true
  [ -n "$layout" ] || return 0
  echo "**Widest interval of c_d:** $(with_words "$layout" "$k_s" "$b"): $(interval_words "$lo" "$hi") (width $(number "$width"))$([ -z "$limit" ] || echo "; $(limit_words "$limit")")$(bound_words "$b")."
  echo
}

yours_words() {
  local layout k_s b c_d zeta V mode t_5
  while IFS=, read -r layout _ k_s b _ _ _ _ _ _ _ _ c_d zeta V _ mode t_5; do
    if [ -z "$zeta" ]; then
      echo "**Your c_d = $(number "$c_d")**, $(with_words "$layout" "$k_s" "$b"): the gear diverges."
    elif awk -v z="$zeta" 'BEGIN { exit !(z > 0) }'; then
      echo "**Your c_d = $(number "$c_d")**, $(with_words "$layout" "$k_s" "$b"): no shimmy; $(decay_words "$zeta" "$V" "$mode" "$t_5")."
    else
      echo "**Your c_d = $(number "$c_d")**, $(with_words "$layout" "$k_s" "$b"): shimmy, most of all of the $mode mode at $(number "$V") m/s, whose damping ratio is $(number "$zeta" %.3g)."
    fi
    echo
  done < <(grep ',yours,' "$folder/designs.csv" | sort -u -t , -k 1,1 || true)
}

# --- the gear -----------------------------------------------------------------

gear_section() {
  local not_given
  echo "## The gear"
  echo
  mlg gear > "$folder/drawing.svg"
  printf '![the gear from the right, from behind and from above](drawing.svg)\n\nWhat the letters mean; not to scale.\n'
  # without the device's, and without laws of joints that there are none of
  awk -F, 'NR == 1 || ($1 != "V" && $1 != "c_d" && $1 != "k_s" && $1 != "b" && !($2 == 0 && $3 == 0 && !$5))' "$folder/gear.csv" > "$folder/parameters.csv"
  table parameters.csv "parameter=name|unit=unit|value=value:%.6g|the paper's=paper:%.6g|meaning=meaning"
  not_given=$(awk -F, 'NR > 1 && $5 == 0 { print $1 }' "$folder/parameters.csv" | list_of)
  [ -z "$not_given" ] || printf 'Not given, and therefore as in the paper: %s.\n' "$not_given"
  table facts.csv "fact=fact|value=value:%.5g|unit=unit|meaning=meaning"
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
  for layout in $layouts; do
    mlg intervals "$layout" "${gear[@]}" 2>&1 > /dev/null | sed -n 's/^mlg intervals: \(.* = .*\)/- Joints: in all that is exact here, \1./p'
  done | sort -u
  if [ "$exact" = yes ]; then
    echo "- Slip and lift-off of shimmy were not looked at: this is a study of the exact parts alone."
  elif [ "$(wc -l < "$folder/cycles.csv")" -lt 2 ]; then
    echo "- Slip and lift-off: no shimmy was computed that could be looked at."
  else
    slips=$(outside slip) rolls=$(outside roll)
    echo "- Tyre slip: $([ -n "$slips" ] && echo "shimmy **passes the slip angle alpha_m** on the branches $slips; there the law of the tyre has a kink and amplitudes are not to be trusted" || echo "no computed shimmy passes the slip angle alpha_m; the nearest reaches $(largest slip) of it")."
    echo "- Lift-off: $([ -n "$rolls" ] && echo "by the roll of the axle **a wheel would lift off** (a mu k_t/2 above F_z/2) on the branches $rolls; the model lets the ground pull it back" || echo "no computed shimmy unloads a wheel by roll; the nearest takes $(largest roll) of its load")."
  fi
  echo
}

largest() { # COLUMN of cycles.csv, in per cent
  awk -F, -v column="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) at = i; next } $at > x { x = $at } END { printf "%.0f %%", 100 * x }' "$folder/cycles.csv"
}

# --- each layout --------------------------------------------------------------

layouts_section() {
  local layout
  for layout in $layouts; do layout_section "$layout"; done
}

layout_section() { # LAYOUT
  local layout=$1 twin of
  get_base "$layout"
  twin=$(twin_of "$layout")
  echo "## $(name_of "$layout")"
  echo
  mlg draw "$layout" > "$folder/device.$layout.svg"
  printf '![the device of %s](device.%s.svg)\n\n' "$(name_of "$layout")" "$layout"
  echo "$(! has "$layout" k_s || echo "With a rigid k_s$(! has "$layout" b || echo " and b = 0"): ")$(intervals_words "$layout")." | sed 's/^\(\**\)./\U&/'
  echo
  table designs.csv "${designs_columns#*|}" layout="$layout"
  ! has "$layout" k_s || over_k_s_words
  if [ -n "$twin" ]; then
    of=$(! has "$layout" b || echo " and no b up to $(number "$b_most") N m s²/rad")
    if awk -F, -v layout="$layout" '$1 == layout && $7 != 0 { found = 1 } END { exit !found }' "$folder/designs.csv"; then
      echo "No k_s$of makes its interval wider than that of $(name_of "$twin"), and with a rigid k_s$(! has "$layout" b || echo " and b = 0") it is the same device: planes and diagrams are those of $(name_of "$twin")."
    else
      echo "No k_s$of gives it an interval. With a rigid k_s$(! has "$layout" b || echo " and b = 0") it is the same device as $(name_of "$twin"): planes and diagrams are those of $(name_of "$twin")."
    fi
    echo
    return
  fi
  ! has "$layout" k_s || printf 'Shown from here on, %s: %s: %s.\n\n' "$base_name" "$(device_words "$layout" "$base_k_s" "$base_b" %.6g)" "$(intervals_words "$layout" "${base[@]}")"
  plane_section
  [ "$exact" = no ] || return 0
  branches_section
  decay_section
}

plane_section() {
  local words
  [ ! -s "$folder/plane.$layout.svg" ] || printf '![the V, c_d plane](plane.%s.svg)\n\n%s %s %s\n\n' "$layout" "$(plane_words "$layout")" "$([ "$exact" = yes ] || names_words "$layout")" "$(torus_words "$layout")"
  words=$(critical_words "$layout")
  [ -z "$words" ] || printf 'The Hopf points that bound the interval are %s %s\n\n' "$words" \
    "$(grep -q subcritical <<< "$words" && echo 'Subcritical: beside the bound a large disturbance may go on as shimmy although straight rolling is stable; keep away from it.' || echo 'Supercritical: shimmy sets in small, and only on the side where straight rolling is unstable.')"
}

# A pair of pictures for each diagram, which stand side by side where there is room.
branches_section() {
  local diagram
  echo "Shimmy along V at the values of c_d that tell most, as the largest ψ and the largest δ* over a period: blue stable, dashed red unstable; red dots Hopf points, rings torus points, triangles folds, squares branch points; each branch has its name at its largest$(awk -F, -v layout="$layout" '$1 == layout && $18 == 0 { part = 1 } END { exit part }' "$folder/cycles.csv" || echo "; on grey, the part of a branch up to where AUTO went no further")."
  echo
  for diagram in $(diagrams_of "$layout"); do
    printf '![ψ along V](branches.%s.%s.psi.svg) ![δ* along V](branches.%s.%s.dstar.svg)\n\n' "$layout" "$diagram" "$layout" "$diagram"
  done
  branches_words "$layout"
  echo
}

over_k_s_words() {
  if [ -s "$folder/regions.$layout.svg" ]; then
    printf '![intervals over k_s](regions.%s.svg)\n\nGreen: c_d free of shimmy over k_s%s%s%s.\n\n' "$layout" "$(! has "$layout" b || echo ", at b = $(number "$base_b") N m s²/rad")" "$(awk -F, 'NR > 3 && $3 == "inf" { rigid = 1 } END { if (rigid) print ", rigid at the right edge" }' "$folder/regions.$layout.csv")" "$([ "$base_k_s" = inf ] || echo '; the line: the design shown')"
  else
    printf 'No k_s from %s to %s N m/rad has a zero-shimmy interval%s.\n\n' "$(of_gear k_psi 0.02)" "$(of_gear k_psi 2000)" "$(! has "$layout" b || echo " at b = $(number "$base_b") N m s²/rad")"
  fi
}

decay_section() {
  grep -q "^$layout," "$folder/transients.csv" || return 0
  local k_s b c_d
  IFS=, read -r k_s b c_d < <(recommended "$layout")
  echo "After a disturbance (ψ' = 1 or δ' = 0.45 rad/s) with $([ -n "$own_k_s$own_b$own_c_d" ] && echo "your device" || echo "the most tolerant device"), $(with_words "$layout" "$k_s" "$b"), c_d = $(number "$c_d"), integrated for 20 s:"
  table transients.csv "V (m/s)=V:%.4g|disturbance=disturbance|max ψ (deg)=psi_max:%.3g|max δ* (mm)=dstar_max*1000:%.3g|ψ to 5 % (s)=psi_5:%.3g|δ* to 5 % (s)=dstar_5:%.3g|slowest decay (1/s)=rate:%.3g" layout="$layout"
  [ ! -s "$folder/history.$layout.psi.svg" ] || printf '![decay of psi](history.%s.psi.svg) ![decay of delta](history.%s.dstar.svg)\n\nThe first two seconds after ψ'"'"' = 1 rad/s, at the first of these speeds.\n\n' "$layout" "$layout"
}

# ------------------------------------------------------------------------------

last_section() {
  echo "## What failed, and what this is made of"
  echo
  if [ "$exact" = no ]; then
    if [ "$(wc -l < "$folder/failures.csv")" -gt 1 ]; then
      echo "Runs of AUTO that failed, or stopped where they could not be led on (layout.diagram.branch); a branch is shown up to where its run was good, on grey where AUTO failed, and what lies beyond is missing:"
      table failures.csv "run=run|reason=reason"
    else
      echo "No run failed."
      echo
    fi
  fi
  echo "Tables beside this page: gear.csv, facts.csv, designs.csv, ranked.csv, and for each layout plane, strips, regions, widest, limits, best, telling and critical; of AUTO's runs branches.csv, cycles.csv, torus.\*.csv, failures.csv; in time transients.csv, history.\*.csv. What each part says and by which rules: docs/study.md. The limits of the model: docs/model.md; zero shimmy means that straight rolling is linearly stable."
}
