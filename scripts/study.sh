#!/usr/bin/env bash
# study.sh - the paper's whole analysis for any gear, as one page (docs/study.md)
#
#   scripts/study.sh NAME [gear=FILE] [layouts=l1,l2,li1,li2] [V_top=200] [b_most=VALUE]
#                    [c_d=VALUE] [at=C_D,C_D,...] [exact] [PARAMETER=VALUE ...]
#   scripts/study.sh compare NAME NAME
#
# c_d: the user's own damper, to be judged; k_s and b, there or in the gear file: his own
# device.  at: where the diagrams in V are, instead of by `mlg telling`.  exact: what comes
# from the algebra alone, without AUTO.
# Writes: build/studies/NAME: report.html, its pictures, its tables as CSV, the runs; compare:
#         build/studies/NAME.NAME.html
# Expect: the planes and the widest intervals after a few seconds, the page within a minute.  A run
#         that fails is listed in the page.  Repeated, only what changed is made anew.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
here=$OLDPWD
export MLG_USES=/dev/null MLG_TIME_LIMIT=${MLG_TIME_LIMIT:-60}
. scripts/study/exact.sh
. scripts/study/cycles.sh
. scripts/study/torus.sh
. scripts/study/pictures.sh
. scripts/study/words.sh
. scripts/study/sections.sh
. scripts/study/advice.sh
. scripts/study/compare.sh

usage="usage: scripts/study.sh NAME [gear=FILE] [layouts=l1,l2,...] [V_top=200] [b_most=VALUE] [c_d=VALUE] [at=C_D,...] [exact] [PARAMETER=VALUE ...]; scripts/study.sh compare NAME NAME"

# The words into layouts, at, exact, top, b_most and parameters; a gear file need not stand in
# the checkout.
read_words() {
  local word seen=' '
  layouts='l1 l2 li1 li2' at='' exact=no top=200 b_most='' parameters=()
  for word; do
    case $word in
      layouts=* | at=* | V_top=* | b_most=*)
        [[ $seen != *" ${word%%=*} "* ]] || fail "study: '$word': ${word%%=*} is given already" 2
        seen+="${word%%=*} "
        ;;
    esac
    case $word in
      layouts=*) layouts=${word#*=} layouts=${layouts//,/ } ;;
      at=*) at=${word#*=} at=${at//,/ } ;;
      exact) exact=yes ;;
      V_top=*) top=${word#*=} ;;
      b_most=*) b_most=${word#*=} ;;
      [vV]_[tT][oO][pP]=* | [lL]ayouts=* | [bB]_most=* | [aA]t=*) fail "study: '$word': written V_top=, layouts=, b_most=, at=" 2 ;;
      gear=) fail "study: 'gear=': expected gear=FILE" 2 ;;
      gear=/*) parameters+=("$word") ;;
      gear=*) parameters+=("gear=$(realpath -ms --relative-to=. "$here/${word#*=}")") ;;
      *=*) parameters+=("$word") ;;
      *) fail "study: '$word': expected NAME=VALUE; $usage" 2 ;;
    esac
  done
}

# What AUTO and the exact parts would refuse later ends here, in one line.
check_words() {
  local layout value
  for layout in $layouts; do
    { [ -f "models/$layout.c" ] && mlg boundary "$layout" > /dev/null 2>&1; } || fail "study: layouts=: there is no layout '$layout'; \`mlg help\` lists them" 2
  done
  [ -n "$layouts" ] || fail "study: layouts=: expected one or more, as l1,l2" 2
  [ "$(tr ' ' '\n' <<< "$layouts" | sort | uniq -d | wc -l)" = 0 ] || fail "study: layouts=: a layout is given twice" 2
  for value in $at; do is_above_0 "$value" || fail "study: at=: '$value': expected values of c_d above 0, N m s/rad" 2; done
  [ -z "$b_most" ] || is_above_0 "$b_most" || fail "study: 'b_most=$b_most': expected an inertance above 0, N m s^2/rad" 2
}

# A line of progress, and on a terminal the time since the start.
say() { printf '  %-52s %4d s\n' "$1" $((EPOCHSECONDS - MLG_STARTED)); }

study() { # NAME WORD...
  local used
  study=$1
  check_name "$study"
  case $study in *.*) fail "the name '$study': a study's has no point" 2 ;; esac
  shift
  read_words "$@"
  folder=build/studies/$study
  export MLG_STARTED=$EPOCHSECONDS MLG_FIGURE=study.$study MLG_ASKED=study.$study
  check_words
  alone "study.$study"
  read_gear
  mkdir -p "$folder"/{runs,keys}
  export MLG_RUNS=$folder/runs MLG_USES=$folder/uses
  printf '%s\n' scripts/study.sh scripts/study/* scripts/report/advice.sh scripts/auto/*.sh scripts/pictures/{style,study-*}.gp scripts/report/head.html build/bin/mlg > "$MLG_USES"
  trap 'end_jobs; trap - INT; kill -INT $$' INT
  trap 'end_jobs; exit 143' TERM HUP
  settle_request <<< "$layouts; at $at; $exact; V_top $top; b_most $b_most; own $own_k_s $own_b $own_c_d; $(cat "$folder/gear")"
  if mlg stamp fits "study.$study" > /dev/null && [ -s "$folder/report.html" ]; then
    echo "  $folder/report.html is up to date"
    return
  fi
  touch "build/stamps/study.$study.began"
  exact_parts
  draw_exact
  say "exact parts: $folder/*.plane.svg, designs.csv"
  cycles
  draw_cycles
  report > "$folder/report.md"
  page "$folder" "mlg-shimmy: $study" < "$folder/report.md" > "$folder/report.html.new"
  replace "$folder/report.html"
  # a run that failed leaves none of its files
  while read -r used; do [ ! -e "$used" ] || echo "$used"; done < "$MLG_USES" | sort -u > "$MLG_USES.new"
  mv "$MLG_USES.new" "$MLG_USES"
  mlg stamp write "study.$study" "$folder/report.html"
  rm -f "$MLG_USES"
  say "$folder/report.html"
}

# Standard input into FILE, if it differs.
settle() { # FILE
  cat > "$1.new"
  replace "$1"
}

# What was asked for; of other questions the runs' settings that helped are forgotten.
settle_request() {
  cat > "$folder/request.new"
  cmp -s "$folder/request.new" "$folder/request" || rm -f "$folder"/keys/run.*
  replace "$folder/request"
}

# Markdown on standard input as a page with its pictures in it.
page() { # FOLDER TITLE
  sed "s|<title>.*</title>|<title>$2</title>|; s|^</style>|th, td { white-space: nowrap; }\ntd:nth-child(2) { min-width: 0; }\ntd:last-child { white-space: normal; }\n&|" scripts/report/head.html
  cmark-gfm --extension table | mlg embed "$1"
  printf '</body>\n</html>\n'
}

[ $# -ge 1 ] || fail "$usage" 2
case $1 in help | --help | -h) echo "$usage; docs/study.md" && exit ;; esac

case " ${*:2} " in *" exact "*) build build/bin/mlg ;; *) build models ;; esac
case $1 in
  compare) shift && compare "$@" ;;
  *=*) fail "study: '$1': expected a name first; $usage" 2 ;;
  *) study "$@" ;;
esac
