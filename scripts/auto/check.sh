# shellcheck shell=bash
# check.sh - how scripts/check.sh computes one point anew; sourced after lib.sh by it.
#
# A row is in layout, type, V, c_d, k_s, b, frequency, psi_max, a_5, tolerance, parameters.
# The function auto_TYPE prints what AUTO finds and exact_TYPE what the algebra gives, both as
# words "V c_d" or one of them; auto_TYPE starts from straight rolling over the whole range of
# speeds, so that a point that moved is found where it is.
# shellcheck disable=SC2154 # of scripts/check.sh

# TYPE: the values compared, first those that exact_TYPE prints, then those of AUTO alone.
declare -A values=([HB]="V" [HH]="V c_d" [LP]="V c_d" [GH]="V c_d a_5" [TR]="V psi_max" [UZ]="psi_max" [LPC]="c_d psi_max" [BP]="parameter" [ZH]="V parameter")
declare -A has_exact=([HB]=yes [HH]=yes [LP]=yes [GH]=yes [BP]=yes [ZH]=yes)
# GH: AUTO has no sure test for it, only the Hopf point there, and no a_5

check_row() {
  local value i=0 by_auto by_exact=() place expected off error
  place="check: $file: point $number"
  [ -n "${values[${type:-none}]:-}" ] || fail "$place: no type '$type'; there are ${!values[*]}" 2
  [ -f "models/$layout.c" ] || fail "$place: there is no models/$layout.c" 2
  for value in "$V" "$c_d"; do
    [[ $value =~ ^[0-9.]+([eE][-+]?[0-9]+)?$ ]] || fail "$place: '$value': expected a number for V and c_d" 2
  done
  given=(k_s="${k_s:-1e30}" b="${b:-0}")
  # shellcheck disable=SC2206 # words
  given+=($parameters)
  # of BP and ZH the first of the parameters is the one along which they lie
  along=${parameters%%=*} at=${parameters#*=}
  at=${at%% *}
  case $type in BP | ZH) [[ $at =~ ^-?[0-9.]+([eE][-+]?[0-9]+)?$ ]] || fail "$place: '$parameters': expected NAME=VALUE, where along NAME it is, first" 2 ;; esac
  tag=$(cksum <<< "$layout ${given[*]}")
  tag=$layout.${tag%% *}
  error=$(mlg eigenvalues "$layout" "${given[@]}" V="$V" c_d="$c_d" 2>&1 > /dev/null) || fail "$place: ${error%%$'\n'*}" 2
  [ -z "${has_exact[$type]:-}" ] || read -ra by_exact <<< "$("exact_$type" 2> build/check/exact.log || true)"
  read -ra by_auto <<< "$("auto_$type" 2> build/check/auto.log || true)"
  for value in ${values[$type]}; do
    case $value in V) expected=$V ;; c_d) expected=$c_d ;; psi_max) expected=$psi_max ;; a_5) expected=$a_5 ;; parameter) expected=$at ;; esac
    if [ -n "$expected" ]; then
      [ "$value" != a_5 ] || by_auto[i]=-
      off=$(largest_off "$expected" "${tolerance:-1e-6}" "${by_auto[i]:-none}" "${by_exact[i]-$([ -z "${has_exact[$type]:-}" ] || echo none)}") &&
        passed=$((passed + 1)) || failed=$((failed + 1))
      printf '%-44s %-8s %14.9g %14s %14s %s\n' "$layout $type V=$(short "$V") c_d=$(short "$c_d")$(beside)" "$value" "$expected" \
        "${by_auto[i]:-none}" "${by_exact[i]:-$([ -z "${has_exact[$type]:-}" ] && echo - || echo none)}" "$off"
      [ -n "${by_auto[i]:-}" ] || [ $i -gt 0 ] || sed 's/^/  | /' build/check/auto.log | grep -m 2 . || true
    fi
    i=$((i + 1))
  done
}

short() { printf '%.6g' "$1"; }

beside() { # what tells this gear from others
  [[ -z $k_s || $k_s =~ ^(inf|1e\+?30)$ ]] || printf ' k_s=%.6g' "$k_s"
  [ -z "$b" ] || [ "$b" = 0 ] || printf ' b=%.6g' "$b"
  [ -z "$parameters" ] || printf ' %s' "$parameters"
}

# The larger relative distance from what is expected, and its status.
largest_off() { # EXPECTED TOLERANCE VALUE...
  awk 'BEGIN {
    size = ARGV[1] < 0 ? -ARGV[1] : ARGV[1]
    for (k = 3; k < ARGC; k++) {
      if (ARGV[k] == "" || ARGV[k] == "-") continue
      off = ARGV[k] == "none" ? 1e9 : (ARGV[k] - ARGV[1]) / (size > 0 ? size : 1)
      if (off < 0) off = -off
      if (off > most) most = off
    }
    if (most >= 1e9) printf "    none  FAILS"
    else printf "%8.1e  %s", most, most <= ARGV[2] ? "pass" : "FAILS"
    exit !(most <= ARGV[2])
  }' "$@"
}

# Of lines "x y frequency" the one nearest to these; without a frequency that counts for nothing.
nearest() { # X Y
  awk -v X="$1" -v Y="$2" -v f="$frequency" '
    function off(p, q) { return q > 0 ? (p / q - 1) ^ 2 : 0 }
    NF { d = off($1, X) + off($2, Y) + (f > 0 && $3 > 0 ? off($3, f) : 0); if (best == "" || d < least) { least = d; best = $0 } }
    END { print best }'
}

# --- the exact ones -------------------------------------------------------------

# Hopf points as "V c_d frequency" at c_d=VALUE or V=VALUE.
hopf_points() {
  mlg hopf "$layout" "$1" "${given[@]}" | awk -F, '
    /^#/ { next }
    place["V"] == "" { for (k = 1; k <= NF; k++) place[$k] = k; next }
    { print $place["V"], $place["c_d"], $place["frequency_hz"] }'
}

exact_HB() { hopf_points "c_d=$c_d" | nearest "$V" ""; }

exact_LP() {
  mlg boundary "$layout" "${given[@]}" | awk -F, '/^[0-9]/ && $4 ~ /min|max/ { print $2, $1, $3 }' | nearest "$V" "$c_d"
}

exact_HH() { mlg unfolding "$layout" "${given[@]}" V="$V" c_d="$c_d" | awk -F, 'END { print $(NF - 1), $NF }'; }

# With the coefficient of fifth order; within a factor of 2 of where it is expected.
exact_GH() {
  local range
  read -ra range < <(awk -v V="$V" -v c="$c_d" 'BEGIN { printf "V_least=%.10g V_top=%.10g c_least=%.10g c_most=%.10g\n", V / 2, V * 2, c / 2, c * 2 }')
  mlg generalised "$layout" "${given[@]}" "${range[@]}" | awk -F, 'NR > 1 { print $1, $2, $3, $5 }' | nearest "$V" "$c_d" | cut -d ' ' -f 1,2,4
}

# A real eigenvalue passes 0: secants along the parameter.
exact_BP() {
  local here=$at last gap gap_last step=0
  last=$(awk -v x="$here" 'BEGIN { printf "%.14g", x * 1.00001 }')
  gap_last=$(real_at "$last") && gap=$(real_at "$here") || return
  while [ $step -lt 12 ]; do
    read -r here last gap_last < <(awk -v c="$here" -v l="$last" -v g="$gap" -v h="$gap_last" 'BEGIN {
      printf "%.14g %.14g %s\n", g == h ? c : c - g * (c - l) / (g - h), c, g }')
    gap=$(real_at "$here") || return
    awk -v c="$here" -v l="$last" 'BEGIN { exit !((c / l - 1) ^ 2 < 1e-22) }' && break
    step=$((step + 1))
  done
  printf '%.10g\n' "$here"
}

# The real eigenvalue nearest to 0 at a value of the parameter.
real_at() { # VALUE
  mlg eigenvalues "$layout" V="$V" c_d="$c_d" "${given[@]:0:2}" "$along=$1" "${given[@]:3}" | awk -F, '
    $2 + 0 == 0 && $3 == 0 { d = $1 < 0 ? -$1 : $1; if (best == "" || d < least) { least = d; best = $1 } }
    END { if (best == "") exit 1; print best }'
}

# There, a Hopf point of other eigenvalues.
exact_ZH() {
  local here
  here=$(exact_BP) && [ -n "$here" ] || return
  echo "$(mlg hopf "$layout" c_d="$c_d" "${given[@]:0:2}" "$along=$here" "${given[@]:3}" | awk -F, '$2 + 0 > 0 { print $2, "", $3 }' |
    nearest "$V" "" | cut -d ' ' -f 1) $here"
}

# --- AUTO's ----------------------------------------------------------------------

# Straight rolling at a c_d over all speeds; only made once.
straight() { # C_D
  straight=$tag.$(short "$1")
  local from to step
  # where two Hopf points lie close to each other AUTO steps over one: then in small steps, here alone
  for step in 0.1 0.03 0.001; do
    read -r from to < <(awk -v V="$V" -v step=$step 'BEGIN { if (step < 0.01) print V - 0.3, V + 0.3; else print (V < 1.5 ? V / 2 : 1), 200 }')
    mlg run "$straight" "$layout.straight" "${given[@]}" c_d="$1" V="$from" DS=$step DSMAX=$step NMX=20000 UZSTOP="{'V': $to}" -- > /dev/null && return
  done
  return 1
}

# Points of a run as "V c_d frequency NAME", and more columns.
points_of() { # RUN TYPES [COLUMN]
  mlg rows "$1" only="$2" columns="V:.10g,c_d:.10g,frequency:.10g,name${3:+,$3:.10g}" | tr , ' '
}

auto_HB() { straight "$c_d" && points_of "$straight" HB | nearest "$V" "" | sed 's/ .*//'; }

auto_GH() {
  local at
  read -r _ at _ <<< "$(exact_GH)"
  [ -n "$at" ] && straight "$at" && points_of "$straight" HB | nearest "$V" "" | awk -v c="$at" '{ print $1, c }'
}

auto_LP() { on_curve LP; }
auto_HH() { on_curve HH; }

# On the Hopf curve through the Hopf point beside this point, followed both ways; c_d a
# little above or below, wherever the curve is.
on_curve() { # TYPE
  local beside way name step least most found=''
  read -r least most < <(awk -v c="$c_d" 'BEGIN { printf "%.10g %.10g", c * 0.9, c * 1.1 }')
  for beside in 1.02 0.98; do
    beside=$(awk -v c="$c_d" -v r=$beside 'BEGIN { printf "%.10g", c * r }')
    straight "$beside" || continue
    name=$(points_of "$straight" HB | nearest "$V" "" | cut -d ' ' -f 4)
    [ -n "$name" ] || continue
    for way in + -; do
      for step in 0.1 0.03 0.01; do # AUTO's search for a fold may end beside it
        mlg run "$straight.$name.$way" "$layout.hopf" from="$straight" IRS="'$name'" DS="${way#+}0.01" DSMAX=$step ILP=1 ISP=2 IID=2 NMX=20000 \
          UZSTOP="{'V': [0.1, 300.0], 'c_d': [$least, $most]}" -- > /dev/null && break
      done
      found+=$(points_of "$straight.$name.$way" "$1")$'\n'
    done
    [ -z "${found//$'\n'/}" ] || break
  done
  nearest "$V" "$c_d" <<< "$found" | cut -d ' ' -f 1-2
}

# Straight rolling along the parameter, 3 % to either side.
auto_BP() {
  local low high weight
  read -r low high weight < <(awk -v x="$at" 'BEGIN { a = 0.97 * x; b = 1.03 * x; printf "%.10g %.10g %.4g\n", (x > 0 ? a : b), (x > 0 ? b : a), 1 / x ^ 2 }')
  mlg run "$tag.$along.V$(short "$V")" "$layout.straight" "${given[@]:0:2}" "$along=$low" "${given[@]:3}" V="$V" c_d="$c_d" ICP="['$along', 'period', 'V', 'c_d']" \
    THL="{'$along': $weight}" DS=0.001 DSMAX=0.003 UZSTOP="{'$along': $high}" -- > /dev/null
  mlg rows "$tag.$along.V$(short "$V")" only=BP columns="$along:.10g" | awk -v x="$at" 'NF { d = ($1 / x - 1) ^ 2; if (b == "" || d < l) { l = d; b = $1 } } END { print b }'
}

# The Hopf curve in that parameter and V, from 3 % above. AUTO would label the point BP.
auto_ZH() {
  local start=$tag.$along from range weight name way
  read -r from range weight < <(awk -v x="$at" 'BEGIN { a = 0.97 * x; b = 1.06 * x
    printf "%.10g %.10g,%.10g %.4g\n", 1.03 * x, (x > 0 ? a : b), (x > 0 ? b : a), 1 / x ^ 2 }')
  mlg run "$start" "$layout.straight" "${given[@]:0:2}" "$along=$from" "${given[@]:3}" c_d="$c_d" V="$(awk -v V="$V" 'BEGIN { print V / 2 }')" \
    UZSTOP="{'V': $(awk -v V="$V" 'BEGIN { print V * 2 }')}" -- > /dev/null
  name=$(points_of "$start" HB | nearest "$V" "" | cut -d ' ' -f 4)
  for way in '' -; do
    mlg run "$start.$way" "$layout.hopf" from="$start" IRS="'$name'" ICP="['$along', 'V', 'period', 'c_d']" THL="{'$along': $weight}" DS="${way}0.001" DSMAX=0.01 \
      ILP=0 ISP=2 IID=2 SP="['GH0', 'BP0']" NMX=20000 UZSTOP="{'$along': [${range/,/, }], 'V': [0.1, 300.0]}" -- > /dev/null || true
    mlg rows "$start.$way" only=ZH columns="V:.10g,$along:.10g,frequency:.10g" | tr , ' '
  done | nearest "$V" "$at" | cut -d ' ' -f 1-2
}

# Orbits along V, from every Hopf point of about this frequency.
along_V() { # TYPES WORD...
  local types=$1 name
  shift
  straight "$c_d"
  while read -r _ _ _ name _; do
    mlg run "$straight.$name.V.${tag_of:-}" "$layout.periodic" from="$straight" IRS="'$name'" "$@" -- > /dev/null || continue
    points_of "$straight.$name.V.${tag_of:-}" "$types" psi_max
  done < <(points_of "$straight" HB | awk -v f="$frequency" '!(f > 0) || ($3 / f - 1) ^ 2 < 0.04')
}

auto_TR() { along_V TR | nearest "$V" "" | awk '{ print $1, $5 }'; }

auto_UZ() {
  local tag_of=$V
  along_V UZ UZR="{'torus': [-1e-5, 2e-5], 'V': [$V]}" |
    awk -v V="$V" -v psi="$psi_max" '($1 / V - 1) ^ 2 < 1e-12 { d = ($5 / psi - 1) ^ 2; if (best == "" || d < least) { least = d; best = $5 } } END { print best }'
}

# Orbits along c_d, from the Hopf points at this speed.
auto_LPC() {
  local start c name
  start=$tag.V$(short "$V")
  while read -r _ c _; do
    name=$start.$(short "$c")
    mlg run "$name.start" "$layout.straight" "${given[@]}" c_d="$c" V="$(awk -v V="$V" 'BEGIN { printf "%.10g", V - 0.001 }')" DS=5e-4 DSMAX=5e-4 \
      UZSTOP="{'V': $(awk -v V="$V" 'BEGIN { printf "%.10g", V + 0.001 }')}" -- HB=1 > /dev/null || continue
    mlg run "$name" "$layout.cycles" from="$name.start" -- > /dev/null || continue
    points_of "$name" LP psi_max
  done < <(hopf_points "V=$V") | awk -v c="$c_d" -v psi="$psi_max" '
    NF { d = ($2 / c - 1) ^ 2 + (psi > 0 ? ($5 / psi - 1) ^ 2 : 0); if (best == "" || d < least) { least = d; best = $2 " " $5 } } END { print best }'
}

# --- record ----------------------------------------------------------------------

record_run() { # RUN
  local run=$1 layout boundary=no root text others columns name along
  check_name "$run"
  [ -f "build/runs/$run/c.$run" ] || fail "check: there is no run $run in build/runs" 2
  text=$(<"build/runs/$run/c.$run")
  layout=$(sed -n 's/^layout=//p' "build/runs/$run/origin")
  root=$run
  while [ -n "$(start_of "$root")" ]; do root=$(start_of "$root"); done
  # parameters of the start that have no column, and the one continued if it has none
  others=$(sed -n 's/^PAR = {\(.*\)}$/\1/p' "build/runs/$root/c.$root" | tr ',' '\n' | sed "s/^ *'\(.*\)': */\1=/" |
    grep -v -e '^V=' -e '^c_d=' -e '^k_s=' -e '^b=' -e '^compliance=' -e '^$' | xargs || true)
  ! grep -q "'V_1'" <<< "$text" || boundary=yes
  # along another parameter than these its value at the point comes first
  along=$(sed -n "s/^ICP = \['\([A-Za-z_]*\)'.*/\1/p" <<< "$text")
  case $along in V | c_d | k_s | b | compliance) along='' ;; *) others=$(tr ' ' '\n' <<< "$others" | grep -v "^$along=" | xargs || true) ;; esac
  if [ $boundary = yes ]; then columns=type,V_1:.10g,c_1:.10g,k_s:.10g,b:.10g,f_1:.10g; else
    columns=type,V:.10g,c_d:.10g,k_s:.10g,b:.10g,frequency:.10g
    for name in psi_max torus; do if grep -q "^ICP.*'$name'" <<< "$text"; then columns+=,$name:.10g; else columns+=,name; fi; done
    columns+=,name${along:+,$along:.10g}
  fi
  mlg rows "$run" only=HB,HH,ZH,BP,TR,LP,UZ columns="$columns" | awk -F, -v layout="$layout" -v others="$others" -v run="$run" -v boundary=$boundary -v along="$along" \
    -v orbits="$(grep -c '^IPS = 2' <<< "$text")" '
    { type = $1 == "" ? substr($9, 1, 2) : $1 }
    boundary == "yes" && $1 == "" { print layout ",LP," $2 "," $3 "," $4 "," $5 "," $6 ",,,1e-6," others "," run }
    boundary == "yes" { next }
    orbits && $8 == $9 && type != "LP" { next } # curves of torus points
    type == "UZ" && (!orbits || $8 ^ 2 < 1e-6 || $2 == "") { next }
    type == "LP" && orbits { type = "LPC" }
    type == "LP" && along != "" { next } # an extremum of another parameter than c_d
    type == "BP" && (orbits || along == "") { next }
    type == "ZH" && along == "" { next }
    { first = along == "" ? "" : along "=" $NF (others == "" ? "" : " ") }
    { print layout "," type "," $2 "," $3 "," $4 "," $5 "," $6 "," (orbits ? $7 : "") ",," (orbits ? "1e-5" : "1e-6") "," first others "," run }'
}

start_of() { sed -n "s/^s = '\(.*\)'$/\1/p" "build/runs/$1/c.$1"; }
