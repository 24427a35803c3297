#!/usr/bin/env bash
# random.sh - studies of random gears: none fails, and the eigenvalues contradict none
#
#   tests/study/random.sh [N [SEED [exact]]]   10 gears, without AUTO where exact; make study-check
#
# Each parameter of the paper's gear times 2^(-0.7..0.7); e of either sign; every fifth gear
# has phi = 0.  Every interval of designs.csv: by build/bin/eigen-LAYOUT (differences of the
# nonlinear model, LAPACK) no Hopf point in its middle, and some 2 % outside of each bound;
# at each telling c_d as many Hopf points as the study says.
#
# After a stop it goes on where it was: what a gear was found to do stands in
# build/tests/random-studies/NAME.found while mlg, the scripts of studies and this one are the same.
#
# Needs   the models, build/bin/eigen-*
# Writes  build/studies/random-SEED-*, and removes those that are right; build/tests/random-studies
. "$(dirname "$(realpath "$0")")/../../scripts/auto/lib.sh"

n=${1:-10} seed=${2:-1} how=(${3:+exact}) wrong=0 asked=0 made=0 failed=0

gear() { # NUMBER
  awk -F, -v seed="$((1000 * seed + $1))" '
    BEGIN { srand(seed); rand() }
    NR > 1 && $1 !~ /^(V|c_d|k_s|b|g|alpha_m|l_D)$/ {
      x = $3 * 2 ^ (1.4 * rand() - 0.7)
      if ($1 == "e" && rand() < 0.4) x = -x
      if ($1 == "phi" && seed % 5 == 0) x = 0
      printf "%s\047%s\047: %.6g", n++ ? ", " : "PAR = {", $1, x
    }
    END { print "}" }' "$folder/paper.csv"
}

# shellcheck disable=SC2207 # a word each
hopf_points() { # LAYOUT K_S B C_D: how many over V, by the oracle
  local words=(c_d="$4")
  [ "$1" = l1 ] || words+=(k_s="${2/inf/1e30}" b="$3")
  words+=($(sed "s/PAR = {//; s/}//; s/'//g; s/: /=/g; s/,//g" "$file"))
  "build/bin/eigen-$1" boundary free=V from=0.002 to="$top" step=0.1 "${words[@]}" | awk 'NR > 1' | wc -l
}

judge() { # WHAT LAYOUT K_S B C_D none|some
  local found
  asked=$((asked + 1))
  found=$(hopf_points "${@:2:4}")
  case $6,$found in none,0 | some,[1-9]*) return ;; esac
  [ "$6" != "$found" ] || return 0
  echo "  $name: $1 of $2 at k_s = $3, b = $4, c_d = $5: $found Hopf points by the eigenvalues, expected $6"
  wrong=$((wrong + 1))
}

times() { awk "BEGIN { printf \"%.12g\", $1 * $2 }"; }

check() { # what designs.csv of the study says
  local layout design k_s b lo hi lower upper middle which c_d points
  while IFS=, read -r layout design k_s b lo hi _ _ _ lower upper _; do
    case $design in design | yours) continue ;; esac
    if [ -n "$lo" ]; then
      if [ "$lo" = 0 ] && [ "$hi" = inf ]; then middle=2e3; elif [ "$lo" = 0 ]; then middle=$(times "$hi" 0.5); elif [ "$hi" = inf ]; then middle=$(times "$lo" 2); else middle=$(awk "BEGIN { printf \"%.12g\", sqrt($lo * $hi) }"); fi
      judge "the middle" "$layout" "$k_s" "$b" "$middle" none
      case $lower in none | V_least) ;; *) judge "below c_lo" "$layout" "$k_s" "$b" "$(times "$lo" 0.98)" some ;; esac
      case $upper in none | V_least) ;; *) judge "above c_hi" "$layout" "$k_s" "$b" "$(times "$hi" 1.02)" some ;; esac
    fi
  done < "build/studies/$name/designs.csv"
  for layout in l1 li2; do # the diagrams: as many Hopf points as the study says
    ! grep -q "^$layout:" "build/studies/$name/unsure" 2> /dev/null || continue # left out, as the page says
    { read -r k_s; read -r b; } < "build/studies/$name/base.$layout"
    while IFS=, read -r which c_d points; do
      [ "$which" = which ] || judge "$which" "$layout" "$k_s" "$b" "$c_d" "$points"
    done < "build/studies/$name/telling.$layout.csv"
  done
}

# A study and all that is said of it: its line, and last the counts asked, wrong, runs, failed.
one_gear() { # NUMBER
  local asked=0 wrong=0 runs=0 bad=0
  gear "$1" > "$file"
  if scripts/study.sh "$name" gear="$file" layouts=l1,li2 V_top="$top" "${how[@]}" > "$folder/$1.log" 2>&1 && [ -s "build/studies/$name/report.html" ]; then
    check
    runs=$(find "build/studies/$name/runs" -mindepth 1 -maxdepth 1 -type d | wc -l) bad=$(($(wc -l < "build/studies/$name/failures.csv") - 1))
    printf '  %-14s %d runs, %d failed; %s\n' "$name" "$runs" "$bad" "$(grep -m 1 -e '^\*\*' "build/studies/$name/report.md" | cut -c 1-90)"
    sed '1d; s/^/    /' "build/studies/$name/failures.csv"
    [ "$wrong" != 0 ] || rm -r "build/studies/$name"
  else
    echo "  $name failed: $(tail -n 1 "$folder/$1.log")"
    wrong=1
  fi
  echo "$asked $wrong $runs $bad"
}

folder=build/tests/random-studies top=120
mkdir -p "$folder"
build
mlg gearinfo > "$folder/paper.csv"
made_by="$(cat build/bin/mlg scripts/study.sh scripts/study/* "$0" | cksum) ${how[*]}"
for ((i = 1; i <= n; i++)); do
  name=random-$seed-$i file=$folder/gear.$seed.$i
  found=$folder/$name.found
  if [ "$(head -n 1 "$found" 2> /dev/null)" != "$made_by" ]; then
    { echo "$made_by"; one_gear "$i"; } > "$found.new"
    mv "$found.new" "$found"
  fi
  sed '1d; $d' "$found"
  read -r more_asked more_wrong more_made more_failed < <(tail -n 1 "$found")
  asked=$((asked + more_asked)) wrong=$((wrong + more_wrong)) made=$((made + more_made)) failed=$((failed + more_failed))
done
echo "  $n studies, $asked statements held against the eigenvalues, $wrong wrong; $made runs of AUTO, $failed failed"
[ "$wrong" = 0 ]
