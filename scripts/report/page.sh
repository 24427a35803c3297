#!/usr/bin/env bash
# results/README.md as one HTML page that needs nothing beside it: build/results.html
#
# cmark-gfm turns the Markdown into HTML, so both pages say the same. A picture
# NAME.png is put in as NAME.svg where there is one: sharper and smaller.
# Needs: results/README.md (scripts/summary.sh) and the pictures it shows
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
alone results

data_of() { # PICTURE, seen from results: as an address that holds it
  local file=results/$1 type
  [ ! -f "${file%.png}.svg" ] || file=${file%.png}.svg
  [ -f "$file" ] || fail "page: results/README.md shows $1, which is not there"
  case $file in *.svg) type=svg+xml ;; *) type=${file##*.} ;; esac
  echo "data:image/$type;base64,$(base64 --wrap=0 "$file")"
}

body=$(cmark-gfm --extension table --extension autolink results/README.md)
pictures=$(grep -o '<img src="[^"]*"' <<< "$body" | cut -d '"' -f 2 | sort -u)
{
  cat <<'HTML'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>mlg-shimmy: results</title>
<style>
body { margin: 0 auto; padding: 1rem; max-width: 62rem; background: #fff; color: #1a1a1a;
       font: 1rem/1.55 system-ui, "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
p, li { max-width: 46rem; }
p:has(img) { max-width: none; }
h1, h2, h3 { line-height: 1.25; }
h2 { margin-top: 3rem; border-bottom: 1px solid #ccc; padding-bottom: .3rem; }
h3 { margin-top: 2.2rem; }
img { max-width: 100%; height: auto; }
table { display: block; overflow-x: auto; border-collapse: collapse; font-size: .85rem; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid #ddd; text-align: left; }
td:nth-child(2) { min-width: 12rem; }
th { border-bottom: 2px solid #888; white-space: nowrap; }
code { font-size: .9em; background: #f3f3f3; padding: .1em .25em; }
a { color: #1f4fd8; }
</style>
</head>
<body>
HTML
  {
    while read -r picture; do echo "$picture $(data_of "$picture")"; done <<< "$pictures"
    echo "$body"
  } | awk '
    NF == 2 && $2 ~ /^data:/ { data["<img src=\"" $1 "\""] = "<img src=\"" $2 "\""; next }
    /^<h[23]>/ { # the names that code-hosting pages give to headings
      id = tolower($0)
      gsub(/<[^>]*>|&[a-z]*;|[^a-z0-9 _-]/, "", id)
      gsub(/ /, "-", id)
      sub(/>/, " id=\"" id "\">")
    }
    {
      for (img in data) while (i = index($0, img))
        $0 = substr($0, 1, i - 1) data[img] substr($0, i + length(img))
      print
    }'
  echo '</body>'
  echo '</html>'
} > build/results.html.new
replace build/results.html
echo "  build/results.html"
