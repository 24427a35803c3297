#!/usr/bin/env bash
# The results as a page: results/README.md (summary.sh) and the same as one HTML page that
# needs nothing beside it, build/results.html; both only when something behind them changed.
#
# cmark-gfm turns the Markdown into HTML; head.html goes before it, and mlg embed puts the
# pictures in.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
build build/bin/mlg
if mlg stamp fits page > /dev/null; then exit; fi
mkdir -p build/stamps
export MLG_USES=build/stamps/page.$$.uses
trap 'rm -f "$MLG_USES"' EXIT
printf '%s\n' "$0" scripts/report/{summary.sh,head.html} scripts/auto/*.sh build/bin/mlg > "$MLG_USES"
touch build/stamps/page.began
scripts/report/summary.sh || exit
alone results
{
  cat scripts/report/head.html
  cmark-gfm --extension table --extension autolink results/README.md | mlg embed results
  printf '</body>\n</html>\n'
} > build/results.html.new
replace build/results.html
mlg stamp write page
echo "  build/results.html"
