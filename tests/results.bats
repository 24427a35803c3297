# results.bats - the results page and what it is made of; progress; the version
bats_require_minimum_version 1.5.0

setup_file() {
  load scratch
  scratch results
  cp -rp "$ROOT"/{results,docs} .
}

setup() {
  load scratch
  cd "$SCRATCH" || return
}

@test "the committed page is that of the committed tables" {
  cp results/README.md committed.md
  scripts/report/summary.sh
  diff committed.md results/README.md || { echo "make page makes it anew" && false; }
}

@test "a cell or a picture that is not there ends with one line, and the old page stays" {
  cp results/README.md before.md
  sed -i.kept '/^li2,140,/d' results/widths.csv
  run -1 scripts/report/summary.sh
  [[ $output == *"MISSING(results/widths.csv width layout=li2 b=140)"* ]]
  mv results/widths.csv.kept results/widths.csv
  mv results/fig10.png fig10.png
  run -1 scripts/report/summary.sh
  [[ $output == *"there is no results/fig10.png"* ]]
  mv fig10.png results
  cmp before.md results/README.md
}

@test "a newer table that is committed keeps its rows beside older ones of another figure's runs" {
  mkdir -p build/tables
  cp results/special_points.csv newer.csv
  rm -f build/tables/points.* build/tables/special_points.csv.*
  # an older state of Figure 7, where Figure 6 is the one that is made
  grep '^7,' newer.csv | sed '1s/,[0-9]/,7/' > build/tables/points.fig07.csv
  grep '^6,' newer.csv > build/tables/points.fig06.csv
  run ! cmp -s build/tables/points.fig07.csv <(grep '^7,' newer.csv)
  MLG_FIGURE=fig06 scripts/report/collect.sh
  cmp newer.csv results/special_points.csv
  [ ! -e build/tables/points.fig07.csv ] # and so it is made anew
  # what was made here goes before what stands in the table
  sed '1s/,[0-9]/,7/' build/tables/points.fig06.csv > build/tables/points.fig07.csv
  MLG_FIGURE=fig07 scripts/report/collect.sh
  grep -q -x -F "$(head -n 1 build/tables/points.fig07.csv)" results/special_points.csv
  cp newer.csv results/special_points.csv
  rm build/tables/points.* build/tables/special_points.csv.*
}

@test "the page in HTML says the same, with its pictures in it" {
  local number
  scripts/report/page.sh
  while read -r number; do
    grep -q -F "<td>$number</td>" build/results.html || { echo "$number is not there" && false; }
  done < <(awk -F, '!/^#/ && $1 != "id" { print $6 }' results/targets.csv)
  [ "$(grep -o 'src="data:image/' build/results.html | wc -l)" -eq "$(grep -o '!\[[^]]*\](' results/README.md | wc -l)" ]
  cp build/results.html again.html
  scripts/report/page.sh
  cmp again.html build/results.html
}

@test "the strip shows solutions A and B, each half of a period the mirror of the other" {
  awk -F, -v rows=97 '
    /^#/ || $1 == "solution" { next }
    FILENAME ~ /special/ { if ($4 == "UZ" && $3 == "fig06.a.psi") peak["A"] = $10
                           if ($4 == "UZ" && $3 == "fig06.a.delta") peak["B"] = 1000 * $11
                           next }
    { k = n[$1]++; v[$1, k, 1] = $4; v[$1, k, 2] = 1000 * $5; v[$1, k, 3] = 1000 * $6; v[$1, k, 4] = 1000 * $7
      size = $1 == "A" ? $4 : 1000 * $5
      if (size > most[$1]) most[$1] = size }
    function off(x, y, by) { return (x - y) ^ 2 > by ^ 2 }
    END {
      split("1 2 4 3", mirror, " ")
      for (s in peak) {
        if (n[s] != rows) { print s " has " n[s] " rows"; wrong = 1 }
        if (off(most[s], peak[s], 1e-3 * peak[s])) { print s " peaks at " most[s] ", not " peak[s]; wrong = 1 }
        for (k = 0; k < 48; k++) for (j = 1; j <= 4; j++)
          if (off(v[s, k, j], -v[s, k + 48, mirror[j]], 0.03)) { print s, k, j, v[s, k, j], v[s, k + 48, mirror[j]]; wrong = 1 }
      }
      exit wrong || !("A" in peak) || !("B" in peak)
    }' results/special_points.csv results/filmstrip.csv
}

@test "a tyre without deflection is drawn straight, one with it is shifted where it stands" {
  strip() { # WHAT LAMBDA_R: the corners of the wheels
    printf '%s\n' solution,phase,t,psi,dstar,lambda_L,lambda_R "A,0,0,0,0,0,$2" > instant.csv
    mlg strip ./instant.csv view=rear part="$1" every=1 shifts=2
  }
  diff <(strip contact 0.01) - <<'END'
-0.3300 0.0000
-0.1700 0.0000

0.1900 0.0000
0.3500 0.0000

END
  strip wheels 0 | awk 'NF { if ($1 != -0.33 && $1 != -0.17 && $1 != 0.17 && $1 != 0.33) exit 1; n++ } END { exit n != 14 }'
}

@test "a run says on a terminal how far all have come, and elsewhere nothing of it" {
  local shown
  printf '%s\n' figure,runs fig06,2 > results/versions.csv
  shown=$(env -u MLG_STARTED -u MLG_ASKED script -qec "scripts/fig06.sh runs c" /dev/null)
  [[ $shown =~ fig06\.c\.straight.*\[1\ of\ 2\ runs,\ [0-9]+\ s\ of\ about\ [0-9.]+\ s\] ]]
  [[ $shown =~ fig06\.c\.psi.*\[2\ of\ 2\ runs, ]]
  rm -rf build/runs build/tables
  env -u MLG_STARTED -u MLG_ASKED scripts/fig06.sh runs c >quiet 2>&1
  grep -q fig06.c.psi quiet
  run -1 grep -e '\[' quiet
}

@test "versions are written with a table that changed, and left alone otherwise" {
  local row='^fig06,7,[0-9.]+,[0-9.]+,[0-9.]+,[^,]+,[0-9.]+,[^,]+,[^,]+$'
  rm results/versions.csv
  scripts/fig06.sh runs
  scripts/fig06.sh tables
  grep -q -E "$row" results/versions.csv
  sed -i 's/^fig06,7,/fig06,70,/' results/versions.csv
  rm -f build/stamps/*
  scripts/fig06.sh tables
  grep -q '^fig06,70,' results/versions.csv
  sed -i '$d' results/fig06.csv
  rm -f build/stamps/*
  scripts/fig06.sh tables
  grep -q -E "$row" results/versions.csv
}

@test "the version stands in CITATION.cff, and the change log begins with it" {
  local version
  version=$(sed -n 's/^version: //p' "$ROOT/CITATION.cff")
  [[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]]
  [[ $(grep -m 1 '^## ' "$ROOT/CHANGELOG.md") == "## $version"* ]]
  grep -q -F "mlg-shimmy $version." "$ROOT/results/README.md"
}
