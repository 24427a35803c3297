# shellcheck shell=bash
# cycles.sh - what a study has from AUTO: shimmy along V at the telling c_d of each base
# design, and by integration the decay of the best; sourced by study.sh
#
# In build/studies/NAME: branches.csv (points of the branches), cycles.csv (a row for each
# branch), failures.csv (runs that failed, and why), transients.csv, history.LAYOUT.csv.
# Each diagram is a job of its own, one for each processor.
# shellcheck disable=SC2154 # variables of study.sh

# Settings of the runs from the exact Hopf speeds: AUTO is to step over no two of them.
run_settings() { # FINER < speeds of Hopf points, one a line
  awk -v top="$top" -v finer="$1" '
    { V[++n] = $1 }
    END {
      step = finer * top / 2000
      from = n && V[1] / 2 < top / 200 ? V[1] / 2 : top / 200
      if (n && (V[1] - from) / 3 < step) step = (V[1] - from) / 3
      for (i = 2; i <= n; i++) if ((V[i] - V[i - 1]) / 3 < step) step = (V[i] - V[i - 1]) / 3
      if (step < top / 40000) step = top / 40000
      printf "V=%.8g DS=%.8g DSMAX=%.8g NMX=%d\n", from, step, step, 2 * top / step + 1000
    }'
}

# run_or_note NAME ...: a run; one that fails is noted, with its reason.
run_or_note() {
  local error
  error=$(mlg run "$@" 2>&1 > /dev/null) && return
  echo "$1,\"$(head -n 1 <<< "${error//\"/}" | sed 's/^[^:]*: *//; s/; where that is meant.*//')\"" >> "$part.failures"
  return 1
}

# try_each RUN COMMAND: the command with the words of each line of standard input, until its runs
# pass the judge.  That which did is the first to be tried when the study is repeated.  Of the
# rest only the last failure is kept.
try_each() {
  local memory=$folder/keys/run.$1 noted tries k first=''
  noted=$(cat "$part.failures")
  mapfile -t tries
  [ ! -e "$memory" ] || first=$(cat "$memory")
  for k in $first "${!tries[@]}"; do
    settle_failures "$noted"
    # shellcheck disable=SC2086 # words
    if "$2" ${tries[k]} < /dev/null; then
      echo "$k" > "$memory"
      return
    fi
  done
  return 1
}

settle_failures() { printf '%s' "$1${1:+$'\n'}" > "$part.failures"; }

# One diagram: straight rolling, and every branch of shimmy that begins at one of its Hopf
# points and has not ended another.
diagram() { # LAYOUT WHICH C_D
  local layout=$1 which=$2 c_d=$3 part name speeds i n=0 start
  part=$folder/parts/$layout.$which name=$layout.$which
  : > "$part.failures"
  : > "$part.branches"
  : > "$part.cycles"
  mlg hopf "$layout" c_d="$c_d" "${gear[@]}" V_top="$top" "${base[@]}" | sed 1,2d > "$part.hopf"
  mapfile -t speeds < <(cut -d , -f 2 "$part.hopf")
  try_each "$name.straight" straight < <(printf '%s\n' 1 0.37 0.13) || return 0
  rows_of "$name.straight" straight every=50 | sed 's/$/,1/' >> "$part.branches"
  local ended=' '
  for ((i = 1; i <= ${#speeds[@]}; i++)); do
    [[ $ended != *" $i "* ]] || continue
    n=$((n + 1))
    if try_each "$name.$n" branch < <(printf '%s\n' '5e-4 2.5e-3 1500' '5e-5 2.5e-3 1500' '1e-4 8e-4 4000'); then
      show_branch "$name.$n" "$n" "$i" 1
    else
      show_branch "$name.$n.part" "$n" "$i" 0
    fi
  done
}

# The branch of a run, or the good part of one that the judge rejects: its rows of branches.csv and
# cycles.csv, and the Hopf point that it ends on.
show_branch() { # RUN BRANCH HOPF_POINT WHOLE
  rows_of "$1" "$2" ends types=HB,HH,TR,LP,BP,GH,MX 2> /dev/null | good_part "$4" > "$part.rows" || return 0
  without_false_folds "$part.rows" | without_false_stability >> "$part.branches"
  [ "$4" = 0 ] || ended+="$(ended_at "$3") "
  cycle "$@"
}

# Rows up to where AUTO found no solution any more, or fell onto straight rolling; 1: there are none.
good_part() { # WHOLE
  awk -F, -v OFS=, -v whole="$1" '
    $5 == "MX" || $6 $7 $8 ~ /nan|inf/ || ($7 == 0 && most > 0 && !whole) { exit }
    { if ($7 + 0 > most) most = $7 + 0; print $0, whole; n++ }
    END { exit !n }'
}

# Shimmy from Hopf point i.  A small branch wants a small first step, a sharp fold a fine one;
# beside such a fold AUTO's search takes many iterations.  The constants file stops at the first
# branch point, for a branch that closes ends on one; where another kind stops it (an orbit loses
# its mirror symmetry there), it is made again through as many as it takes.
branch() { # FIRST_STEP LARGEST POINTS, of V_top
  local passes=$folder/keys/run.$name.$n.passes stop=1 at='' noted
  [ ! -e "$passes" ] || stop=$(cat "$passes")
  noted=$(cat "$part.failures")
  while :; do
    run_or_note "$name.$n" "$layout.periodic" from="$name.straight" IRS="'HB$i'" ILP=1 NPR=10 NMX="$3" ITMX=200 STOP="['BP$stop']" \
      DS="$(times "$top" "$1")" DSMAX="$(times "$top" "$2")" UZR="{'torus': [-1e-5, 2e-5]}" \
      UZSTOP="{'V': [$(times "$start" 0.5), $top], 'psi_max': 60.0, 'dstar_max': 0.3}" -- || { [ -n "$at" ] && break || return; }
    at=$(rows_of "$name.$n" "$n" ends types=any | awk -F, '{ type = $5; V = $6 } END { if (type == "BP") print V }')
    [ -n "$at" ] || return 0
    echo "$stop" > "$passes"
    stop=$((stop + 1))
    [ "$stop" -le 6 ] || break
  done
  # the last good one stands
  settle_failures "$noted"
  echo "$name.$n,\"AUTO stopped at the branch point at V = $at; the shimmy beyond was not followed\"" >> "$part.failures"
}

# Straight rolling.  AUTO may step over a Hopf point at one step and not at another.
straight() { # FINER
  local settings
  read -ra settings < <(printf '%s\n' "${speeds[@]}" | sed '/^$/d' | run_settings "$1")
  start=${settings[0]#V=}
  run_or_note "$name.straight" "$layout.straight" "${gear[@]}" "${base[@]}" c_d="$c_d" "${settings[@]}" \
    UZSTOP="{'V': $top}" -- HB="${#speeds[@]}"
}

rows_of() { # RUN BRANCH WORD
  mlg rows "$1" prefix="$layout,$which,$c_d,$2" columns=type,V,psi_max,dstar_max,stable:d bifurcations=stable "${@:3}"
}

# The end of a branch, where AUTO turns round on a Hopf point, is no fold.
without_false_folds() { # ROWS
  awk -F, -v OFS=, '
    NR == FNR { if ($7 > psi) psi = $7; if ($8 > dstar) dstar = $8; next }
    $5 == "LP" && $7 < 0.05 * psi && $8 < 0.05 * dstar { $5 = "" }
    { print }' "$1" "$1"
}

# At a bifurcation both sides meet, and it counts as stable for the lines in the pictures; not where
# neither side is, as where a second Hopf point begins a branch that is unstable.
without_false_stability() {
  awk -F, -v OFS=, '
    { row[NR] = $0; stable[NR] = $9 }
    END {
      for (i = 1; i <= NR; i++) {
        $0 = row[i]
        if ($5 != "" && stable[i - 1] + 0 == 0 && stable[i + 1] + 0 == 0) $9 = 0
        print
      }
    }'
}

# The number of the Hopf point, other than that where it began, that the branch n ends on.
ended_at() { # NUMBER
  local last
  last=$(grep "^$layout,$which,$c_d,$n,HB," "$part.branches" | tail -n 1 | cut -d , -f 6)
  printf '%s\n' "${speeds[@]}" | awk -v last="${last:-x}" -v began="$1" -v top="$top" '
    NR != began && last != "x" && ($1 - last) ^ 2 < (1e-3 * top) ^ 2 { print NR; exit }'
}

# A row of cycles.csv: how large it is, where it is stable, and how far it leaves what the model
# holds for, from all orbits that AUTO kept.
cycle() { # RUN BRANCH NUMBER WHOLE
  local closed=0 shimmy label
  ! mlg judge "$1" 2> /dev/null | grep -q closed || closed=1
  shimmy=$(mlg shimmy "$1" 2> /dev/null) || shimmy='?'
  {
    sed -n "s/^$layout,$which,$c_d,$2,//p" "$part.branches"
    for label in $(mlg table "$1" labels | awk -F, '!/^#/ && $1 + 0 { print $2 }'); do
      mlg orbit "$1" "$label" phases=48 prefix=orbit 2> /dev/null || true
    done
  } | awk -v row="$layout,$which,$c_d,$2,$shimmy,$closed" -v born="$(sed -n "$3p" "$part.hopf" | cut -d , -f 4),$4" -v e="$(gear_values)" -v top="$top" -v V_least="$(times "$start" 0.5)" -f scripts/study/cycle.awk >> "$part.cycles"
}

gear_values() { awk -F, '{ v[$1] = $2 } END { print v["phi"], v["l_delta"], v["a"], v["k_t"], (v["M"] + v["m_D"]) * v["g"], v["l"], v["alpha_m"] }' "$folder/gear.csv"; }

# What is to be built of a layout: the user's own device, or else that of the advice, the most tolerant.
recommended() { # LAYOUT: k_s,b,c_d,zeta,V, or nothing where that is shimmy
  awk -F, -v layout="$1" -v own="$own_c_d" -v k_s="$([ -z "$own_k_s$own_b" ] || echo "$base_k_s")" -v b="$base_b" '
    $1 != layout || (own != "" && $2 != "yours") || (k_s != "" && ($3 != k_s || $4 != b)) || (!(own != "" || k_s != "") && $2 != "most tolerant") || $14 + 0 <= most { next }
    { most = $14 + 0; row = $3 "," $4 "," $13 "," $14 "," $15 }
    END { if (row != "") print row }' "$folder/designs.csv"
}

# Peaks and settling after the standard disturbances, at the speed of the least ratio and at half
# of V_top.
decay() { # LAYOUT
  local layout=$1 k_s b c_d V words part=$folder/parts/$1.decay
  : > "$part.transients"
  IFS=, read -r k_s b c_d _ V < <(recommended "$layout") || return 0
  mapfile -t words < <(device "$layout" "$k_s" "$b")
  awk -v V="$V" -v top="$top" 'BEGIN { exit !(V > top / 1000) }' || V=$(times "$top" 0.005)
  mlg simulate "$layout" history "${gear[@]}" "${words[@]}" c_d="$c_d" V="$V" dpsi=1 t_end=2 dt=0.002 > "$folder/history.$layout.csv"
  for V in "$V" "$(times "$top" 0.5)"; do
    mlg transients "$layout" "${gear[@]}" V_top="$top" "${words[@]}" c_d="$c_d" V="$V" t_end=20 2> /dev/null |
      sed "1d; s/^/$layout,$c_d,/" >> "$part.transients" || return 0
  done
}

# The jobs, side by side; on a terminal a line for each that begins.
run_jobs() { # COMMAND...
  local one layout n=0
  for one; do
    read -r _ layout _ <<< "$one"
    get_base "$layout"
    # shellcheck disable=SC2086 # words
    job $one
    n=$((n + 1))
    [ ! -t 1 ] || say "[$n of $#] ${one/diagram /}"
  done
  wait
}

# First what takes longest; torus curves begin at points of the diagrams.
cycles() {
  local layout which c_d jobs=() after=() decays=() n runs
  for layout in $layouts; do
    ! has "$layout" k_s || jobs+=("best_damped $layout")
    after+=("tolerant_design $layout")
  done
  for layout in $layouts; do
    [ "$exact" = no ] || continue
    [ -z "$(twin_of "$layout")" ] || continue
    n=0
    while IFS=, read -r which c_d _; do
      [ "$which" = which ] || jobs+=("diagram $layout $which.$n $c_d")
      n=$((n + 1))
    done < "$folder/telling.$layout.csv"
    after+=("torus_curves $layout") decays+=("decay $layout")
  done
  rm -f "$folder"/{history,torus,torus_ends}.*.csv
  run_jobs "${jobs[@]}"
  say "best damped designs$([ "$exact" = yes ] || echo ", diagrams over V")"
  gather branches layout,which,c_d,branch,type,V,psi_max,dstar_max,stable,whole
  gather cycles layout,which,c_d,branch,shimmy,closed,V_from,V_to,psi_max,dstar_max,torus,folds,stable,unstable,slip,roll,born,whole,end,branch_points
  find "$folder/parts" -name '*.best' | sort | xargs -r cat >> "$folder/designs.csv"
  run_jobs "${after[@]}"
  say "most tolerant designs$([ "$exact" = yes ] || echo ", torus curves")"
  find "$folder/parts" -name '*.tolerant' | sort | xargs -r cat >> "$folder/designs.csv"
  run_jobs "${decays[@]}"
  gather_advice
  gather transients layout,c_d,V,disturbance,psi_max,dstar_max,psi_5,psi_end,dstar_5,dstar_end,rate,zeta,limits
  gather failures run,reason
  runs=$(find "$folder/runs" -mindepth 1 -maxdepth 1 -type d ! -name '*.part' | wc -l)
  [ "$exact" = yes ] || say "AUTO: $runs runs, $(($(wc -l < "$folder/cycles.csv") - 1)) branches, $(($(wc -l < "$folder/failures.csv") - 1)) runs failed"
}

gather() { # TABLE HEAD
  {
    echo "$2"
    find "$folder/parts" -name "*.$1" | sort | xargs -r cat
  } > "$folder/$1.csv"
}
