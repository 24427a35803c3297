# pages.bats - build/results.html and the page of a study in headless Chromium; make check-pages
# runs it

bats_require_minimum_version 1.5.0

setup() {
  cd "$BATS_TEST_DIRNAME/../.." || return
  page=$PWD/build/results.html
  scratch=$PWD/build/tests/pages
  mkdir -p "$scratch"
}

browser() { # OPTION...: as root without its sandbox, and without looking for a network
  local profile root=()
  profile=$(mktemp -d "$scratch/profile.XXXXXX")
  [ "$(id -u)" -ne 0 ] || root=(--no-sandbox)
  timeout 120 chromium --headless "${root[@]}" --disable-gpu --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --allow-file-access-from-files --user-data-dir="$profile" "$@" 2>"$scratch/browser.log"
  rm -rf "$profile"
}

measure() { # PAGE WIDTH: lines "name value" (frames.html)
  browser --window-size=1400,900 --virtual-time-budget=20000 --dump-dom \
    "file://$BATS_TEST_DIRNAME/frames.html?$1,$2" |
    sed -n '/<pre id="report">/,/<\/pre>/ { s/.*">//; s/<.*//; /./p }' >"$scratch/report"
  [ -s "$scratch/report" ] || { tail -n 5 "$scratch/browser.log" && false; }
}

value() { awk -v name="$1" '$1 == name { print $2 }' "$scratch/report"; }

is() { # NAME VALUE: of the last measurement
  [ "$(value "$1")" = "$2" ] || { echo "$1 is $(value "$1"), expected $2" && false; }
}

@test "the page needs nothing beside it, no script and no network" {
  run -1 grep -n -i -o -E '<(script|link|iframe)|(src|srcset)="[^d][^"]{0,60}|url\(|@import' "$page"
}

@test "at the widths of a phone and of a desk the page is whole and does not overflow" {
  local width
  for width in 390 1280; do
    measure "$page" $width
    is overflow 0
    is images "$(grep -o '!\[[^]]*\](' results/README.md | wc -l)"
    is broken 0
    is tables "$(grep -c '^|---' results/README.md)"
    is rows "$(awk '/^\|---/ { body = 1; next } !/^\|/ { body = 0 } body' results/README.md | wc -l)"
    is paper "$(grep -c -v -e '^#' -e '^id,' results/targets.csv)"
    is empty 0
    is lost 0
  done
}

@test "every picture of results is on the page" {
  local picture
  for picture in results/*.png; do
    grep -q "](${picture#results/})" results/README.md || { echo "$picture is not" && false; }
  done
}

@test "a page with a broken picture, an empty cell or too wide a line is found" {
  sed 's|<h2 id="figures-of-the-paper">|<img src="data:image/png;base64,AAAA"><p style="width: 500px">wide</p>&|
    s|<td>yes</td>|<td></td>|; s|href="#what-shimmy-is"|href="#nowhere"|' "$page" >"$scratch/broken.html"
  measure "$scratch/broken.html" 390
  is broken 1
  [ "$(value overflow)" -gt 0 ]
  [ "$(value empty)" -gt 0 ]
  is lost 1
}

@test "the page of a study, at both widths: whole, without overflow, nothing beside it" {
  local width study=$BATS_TEST_DIRNAME/../../build/studies/page/report.html
  scripts/study.sh page layouts=l1,li1
  run -1 grep -n -i -o -E '<(script|link|iframe)|(src|srcset)="[^d][^"]{0,60}|url\(|@import' "$study"
  for width in 390 1280; do
    measure "$(realpath "$study")" $width
    is overflow 0
    is images "$(grep -o '!\[[^]]*\](' build/studies/page/report.md | wc -l)"
    is broken 0
    is tables "$(grep -c '^|---' build/studies/page/report.md)"
  done
}
