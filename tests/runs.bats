# runs.bats - are the runs of Figures 6 and 7 right, and stay they so?
#
# Makes all figures from nothing in a checkout of its own, and compares the
# points and curves of these two with the table of targets, with what is committed, and with
# eigenvalues from LAPACK (eigen-l1, tests/eigen.h). Then changes steps, mesh
# and gear, and repeats, interrupts and doubles runs.
#
# Needs   the models and build/bin/eigen-l1 (make test-programs)
# Writes  build/tests/runs

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch runs
  objects
  # what other targets make, the page shows as it is committed
  cp -rp "$ROOT/results" .
  rm results/{fig*,filmstrip.*,special_points.csv,targets.csv,versions.csv,README.md}
  sed -i -E '/^(l2|li1|li2),/d' results/{boundary_points,widths}.csv
  # What goes wrong here, the first test tells
  made_by_make -k -j2 figures >make.log 2>&1 && echo 0 >make.status || echo $? >make.status
}

setup() {
  cd "$SCRATCH" || return
}

oracle() {
  build/bin/eigen-l1 "$@"
}

# special_points RUN TYPE COLUMN...: from the table, by the names of its columns
special_points() {
  awk -F, -v run="$1" -v type="$2" -v columns="${*:3}" '
    /^#/ { next }
    $1 == "figure" { for (k = 1; k <= NF; k++) place[$k] = k; n = split(columns, wanted, " "); next }
    $3 == run && $4 == type { for (k = 1; k <= n; k++) printf "%s%s", $place[wanted[k]], (k < n ? " " : "\n") }
  ' results/special_points.csv
}

## The figures

@test "make figures makes pictures and tables, and leaves nothing half done" {
  local file
  cat make.log
  [ "$(<make.status)" -eq 0 ]
  for file in fig06.csv fig06.png fig06.svg fig07.csv fig07.png fig07.svg special_points.csv targets.csv; do
    [ -s "results/$file" ]
  done
  [ -z "$(find . -name '*.new' -o -name '*.part')" ]
}

@test "every target is met, judged anew" {
  awk -F, '
    function complain(text) { print $1 ": " text; wrong = 1 }
    function size(x) { return x < 0 ? -x : x }
    /^#/ || $1 == "id" { next }
    FILENAME ~ /^tests/ { wanted[$1] = $6; tolerance[$1] = $7; n++; next }
    !($1 in wanted) || seen[$1]++ { complain("is no target, or comes twice"); next }
    {
      m++
      if ($8 != "yes") complain("pass is " $8)
      if ($5 != wanted[$1]) complain("converged is " $5 ", not " wanted[$1])
      if (tolerance[$1] == "-") { if ($6 != wanted[$1]) complain($6 " is not " wanted[$1]) }
      else if ($6 !~ /^[0-9.]+(e-[0-9]+)?$/) complain($6 " is no number")
      else if (size($6 - wanted[$1]) > tolerance[$1] * (tolerance[$1] ~ / / ? 1 : wanted[$1]))
        complain($6 " is not " wanted[$1] " within " tolerance[$1])
    }
    END {
      if (!n || m != n) { print m + 0 " rows for " n + 0 " targets"; wrong = 1 }
      exit wrong
    }' tests/targets.csv results/targets.csv
}

@test "the Hopf curves of Figures 9, 12 and 14 have every boundary point of the algebra, and no other" {
  local figure layout panel b k_s n
  for figure in fig09:l2:9 fig12:li1:24 fig14:li2:14; do
    IFS=: read -r figure layout n <<<"$figure"
    awk -F, '!/^#/ && $1 != "panel" && !seen[$1, $3]++ { print $1, $2, $3 }' "results/$figure.csv" >planes
    [ "$(wc -l <planes)" -eq "$n" ]
    while read -r panel b k_s; do
      mlg boundary "$layout" b="$b" k_s="$k_s" V_least=0.1 |
        awk -F, '$4 ~ /^(min|max)$/ && $1 > 10 && $1 < 8e4 { print $1 }' | sort -g >exact
      awk -F, -v panel="$panel" -v k_s="$k_s" '$1 == panel && $3 == k_s && $6 == "LP" { print $8 }' "results/$figure.csv" | sort -g >drawn
      [ "$(wc -l <drawn)" -eq "$(wc -l <exact)" ] || { echo "$figure $panel, k_s = $k_s" && diff drawn exact; }
      [ ! -s exact ] || paste -d ' ' drawn exact | near_each 1e-6 "c_d of $figure $panel, k_s = $k_s"
    done <planes
  done
}

@test "each run has found its special points, no more and no less" {
  diff <(awk -F, '$1 == 6 || $1 == 7 { print $1, $2, $3, $4 }' results/special_points.csv | sort | uniq -c | awk '{ $1 = $1 } 1') - <<'END'
1 6 l1 fig06.a.delta TR
1 6 l1 fig06.a.delta UZ
1 6 l1 fig06.a.psi TR
1 6 l1 fig06.a.psi UZ
4 6 l1 fig06.a.straight HB
1 6 l1 fig06.b.delta UZ
2 6 l1 fig06.b.straight HB
1 6 l1 fig06.c.psi UZ
2 6 l1 fig06.c.straight HB
2 7 l1 fig07.delta.down HH
1 7 l1 fig07.delta.down LP
1 7 l1 fig07.low.up LP
2 7 l1 fig07.psi.down HH
1 7 l1 fig07.psi.down LP
END
}

@test "the tables are free of NaN, and stability changes where it should" {
  run -1 grep -i -E 'nan|inf' results/fig06.csv results/fig07.csv
  # (a): both branches stable and unstable, changing at their torus points only;
  # (b), (c): stable throughout
  diff <(awk -F, '
    !/^#/ && $1 != "panel" && $2 != "straight" && $3 == "" && $7 "" != was[$1, $2] "" { print $1, $2, $7; was[$1, $2] = $7 }
    $3 == "TR" { print $1, $2, "TR" }' results/fig06.csv) - <<'END'
a psi 1
a psi TR
a psi 0
a delta 0
a delta TR
a delta 1
b delta 1
c psi 1
END
}

## Against what is committed

committed() { # file: into committed/
  git -C "$ROOT" rev-parse --verify -q HEAD >/dev/null || skip "not a git checkout"
  mkdir -p committed
  git -C "$ROOT" show "HEAD:results/$1" >"committed/$1"
}

@test "the committed special points are those of a fresh run" {
  committed special_points.csv
  paste -d' ' <(grep -v '^#' committed/special_points.csv) <(grep -v '^#' results/special_points.csv) >both
  awk '
    { n = split($1, x, ","); m = split($2, y, ",") }
    NF != 2 || n != m { print "row " NR ": " $0; wrong = 1; next }
    {
      for (k = 1; k <= n; k++)
        if (x[k] != y[k] && (k < 5 || x[k] !~ /[0-9]/ || y[k] !~ /[0-9]/ || (x[k] - y[k]) ^ 2 > (1e-6 * x[k]) ^ 2)) {
          print "committed: " $1 "\nfresh:     " $2
          wrong = 1
          break
        }
    }
    END { exit wrong || !NR }' both
}

@test "the committed curves are those of a fresh run" {
  local table
  committed fig06.csv
  committed fig07.csv
  for table in fig06.csv fig07.csv; do
    cmp -s committed/$table results/$table || awk -v KEYS=2 -f "$ROOT/tests/runs/compare.awk" committed/$table results/$table
  done
}

# Another libm, compiler or AUTO may round the last digit another way
@test "a fresh run leaves the tree clean" {
  local table same=1
  committed targets.csv
  for table in $(git -C "$ROOT" ls-tree --name-only HEAD:results); do
    # there was no table, so with what it was made is written anew
    case $table in versions.csv) continue ;; *.csv) ;; *) continue ;; esac
    committed "$table"
    cmp "committed/$table" "results/$table" || same=0
  done
  [ "$same" -eq 0 ] || return 0
  [ "$(uname -m)" = x86_64 ] && grep -q -w fma /proc/cpuinfo && [[ $(gcc -dumpfullversion) == 12.* ]] &&
    grep -q -x 'AUTO_DIR = build/auto' build/auto.mk ||
    skip "the last digits differ, as they may: not the machine, compiler and AUTO of the committed tables"
  for table in committed/*; do
    diff "$table" "results/${table##*/}" | head -n 10 || true
  done
  false
}

## Against eigenvalues

@test "Hopf points of Figure 6 are those of the eigenvalues" {
  local panel c_d expected
  for panel in a:3.6e4:4 b:5e3:2 c:2e3:2; do
    IFS=: read -r panel c_d expected <<<"$panel"
    oracle boundary free=V from=0.1 to=200 c_d="$c_d" | awk 'NR > 1 { print $1, $2 }' >expected.txt
    [ "$(wc -l <expected.txt)" -eq "$expected" ]
    [ "$(special_points "fig06.$panel.straight" HB V | wc -l)" -eq "$expected" ]
    paste -d' ' <(special_points "fig06.$panel.straight" HB V) <(cut -d' ' -f1 expected.txt) |
      near_each 1e-7 "V in panel $panel"
    paste -d' ' <(special_points "fig06.$panel.straight" HB frequency_hz) <(cut -d' ' -f2 expected.txt) |
      near_each 1e-6 "frequency in panel $panel"
  done
}

# oracle_at COMMAND V c_d: V and c_d of the oracle's point near that guess
oracle_at() {
  oracle "$1" V="$2" c_d="$3" | awk '$1 == "V" { V = $3 } $1 == "c_d" { print V, $3 }'
}

@test "double Hopf points are those of the eigenvalues, the same on both curves" {
  local run V c_d
  for run in fig07.psi.down fig07.delta.down; do
    [ "$(special_points "$run" HH V | wc -l)" -eq 2 ]
    special_points "$run" HH V c_d >points
    while read -r V c_d; do
      read -r V_oracle c_d_oracle <<<"$(oracle_at hh "$V" "$c_d")"
      near "$V" "$V_oracle" 2e-6 "V on $run"
      near "$c_d" "$c_d_oracle" 2e-6 "c_d on $run"
    done <points
  done
}

@test "the boundary points (LP) are folds of the eigenvalues" {
  local run V c_d
  for run in fig07.psi.down fig07.delta.down fig07.low.up; do
    special_points "$run" LP V c_d >points
    [ "$(wc -l <points)" -eq 1 ]
    while read -r V c_d; do
      read -r V_oracle c_d_oracle <<<"$(oracle_at fold "$V" "$c_d")"
      near "$V" "$V_oracle" 1e-4 "V on $run" # along the curve c_d is flat here
      near "$c_d" "$c_d_oracle" 1e-6 "c_d on $run"
    done <points
  done
}

@test "the zero-shimmy interval is the only one of the eigenvalues, whatever the speed" {
  oracle interval V_lo=0.5 step=0.25 c_d_steps=60 | awk '$1 > 100.1 && $1 < 9.99e4 && $2 != "-" { print $1 }' >expected.txt
  paste -d' ' <({ special_points fig07.low.up LP c_d; special_points fig07.delta.down LP c_d; }) expected.txt |
    near_each 1e-6 "end of the interval"
}

@test "no region of shimmy is missed in the plane of Figure 7" {
  local lo hi
  awk 'BEGIN { for (i = 0; i < 80; i++) { c = 10 * 8000 ^ ((i + 0.5) / 80); print 0.998 * c, 1.002 * c } }' |
    while read -r lo hi; do
      oracle map V_lo=0.5 V_hi=200 V_n=400 c_d_lo="$lo" c_d_hi="$hi" c_d_n=3
    done >map.csv
  awk -f "$ROOT/tests/runs/regions.awk" results/fig07.csv map.csv
}

## Steps, mesh, gear

# branches DIR SETTING...: both branches of Figure 6(a) with other settings
branches() {
  local prefix=$1
  shift
  auto_run "$prefix.psi" l1.periodic from=fig06.a.straight IRS="'HB1'" "$@" -- TR=1 closed=1
  auto_run "$prefix.delta" l1.periodic from=fig06.a.straight IRS="'HB2'" "$@" -- TR=1 closed=1
}

@test "torus points are found whatever the step" {
  local dsmax branch
  for dsmax in 0.05 0.2 0.5 1.0 2.0; do
    branches "torus.$dsmax" DSMAX="$dsmax" NMX=3000
    for branch in psi delta; do
      near "$(value "torus.$dsmax.$branch" TR V)" "$(value "fig06.a.$branch" TR V)" 1e-6 "V of TR at DSMAX=$dsmax"
    done
  done
}

# Half a unit of the sixth digit, the last one shown
@test "twice the mesh and a tenth of the tolerances change no digit shown" {
  local column
  branches fine NTST=40 EPSL=1e-9 EPSU=1e-9 EPSS=1e-8
  for column in V period psi_max dstar_max; do
    near "$(value fig06.a.psi TR "$column")" "$(value fine.psi TR "$column")" 5e-7 "$column of TR, psi"
    near "$(value fig06.a.delta TR "$column")" "$(value fine.delta TR "$column")" 5e-7 "$column of TR, delta"
  done
  for column in period psi_max dstar_max; do
    near "$(value fig06.a.psi UZ "$column" 20)" "$(value fine.psi UZ "$column" 20)" 5e-7 "$column of A"
    near "$(value fig06.a.delta UZ "$column" 40)" "$(value fine.delta UZ "$column" 40)" 5e-7 "$column of B"
  done
}

@test "the gear as printed moves the upper end of the interval by 1.5 percent" {
  local gear=gear=constants/gear.printed end as_printed
  auto_run printed.straight l1.straight "$gear" c_d=3.6e4 -- HB=4
  auto_run printed.hopf l1.hopf from=printed.straight IRS="'HB2'" DS=-0.1 -- LP=1
  end=$(special_points fig07.delta.down LP c_d)
  as_printed=$(value printed.hopf LP c_d)
  awk -v x="$as_printed" -v y="$end" 'BEGIN { print x, y, 100 * (x - y) / y " %"; exit !((x - y) ^ 2 > (0.014 * y) ^ 2 && (x - y) ^ 2 < (0.016 * y) ^ 2) }'
  oracle fold V=36 c_d="$as_printed" phi=0.0524 M=19900 >expected.txt
  near "$as_printed" "$(awk '$1 == "c_d" { print $3 }' expected.txt)" 1e-6 "c_d with the gear as printed"
}

## Making runs again

@test "a run is made again only when its inputs change" {
  auto_run again l1.straight c_d=2.5e3 -- HB=2
  touch -d '1 hour ago' build/runs/again/stamp
  run -0 auto_run again l1.straight c_d=2.5e3 -- HB=2
  [ -z "$output" ]
  [ -z "$(find build/runs/again/stamp -mmin -30)" ]
  # Another word in a comment is no change, another value or expectation is
  sed 's/^# From/# Starts from/' constants/c.l1.straight >c.l1.straight
  run -0 auto_run again ./c.l1.straight c_d=2.5e3 -- HB=2
  [ -z "$output" ]
  run -0 auto_run again l1.straight c_d=2.4e3 -- HB=2
  [[ $output == *again*HB* ]]
  run -0 auto_run again l1.straight c_d=2.4e3 -- HB=2 UZ=1
  [[ $output == *again*HB* ]]
  # and so is another start, though its name is the same
  run -0 auto_run after l1.hopf from=again -- UZ=1
  run -0 auto_run again l1.straight c_d=2.5e3 -- HB=2
  run -0 auto_run after l1.hopf from=again -- UZ=1
  [[ $output == *after* ]]
  run -0 auto_run after l1.hopf from=again -- UZ=1
  [ -z "$output" ]
}

@test "make figures a second time makes no run" {
  run -0 made_by_make figures
  run -1 grep ' ms ' <<<"$output"
}

# damage KIND FILE
damage() {
  local size
  size=$(stat -c %s "$2")
  case $1 in
  cut) truncate -s $((size * 2 / 3)) "$2" ;;
  empty) : >"$2" ;;
  zeros) dd if=/dev/zero of="$2" bs=1 seek=$((size / 2)) count=$((size / 8)) conv=notrunc status=none ;;
  digit) sed -i "$(awk -v from="$(($(wc -l <"$2") * 2 / 3))" 'NR >= from && /[1-9]/ { print NR; exit }' "$2")y/123456789/234567891/" "$2" ;;
  esac
}

@test "damage under build and results is made good" {
  local kind kinds=(cut zeros empty digit) round n files=(
    build/runs/fig06.a.psi/{b,s,c,d}.fig06.a.psi build/runs/fig06.b.straight/{stamp,origin} build/runs/fig09.b0.k1e6.1/b.fig09.b0.k1e6.1
    build/runs/fig13.width.2/s.fig13.width.2 build/runs/fig06.c.straight/b.fig06.c.straight
    build/tables/points.fig06.csv build/tables/widths.fig13.csv build/tables/fig09.b0.k3e6.curves build/stamps/fig06
    results/fig06.csv results/fig09.csv results/special_points.csv results/boundary_points.csv results/widths.csv results/targets.csv
    results/README.md build/results.html
  )
  local binary=(build/bin/mlg build/models/{l1,l2.boundary}.exe build/models/gear.o build/lib/libmlg.a build/mlg/auto/text.o results/fig06.png)
  sha256sum build/bin/mlg build/models/*.exe build/lib/libmlg.a results/*.{csv,png,svg} build/tables/*.csv build/runs/*/[bsc].fig* >good.sums
  # each file in two ways, neighbours in different ones
  for round in 0 2; do
    for n in "${!files[@]}"; do
      kind=${kinds[(n + round) % 4]}
      cp -p "${files[n]}" before
      damage "$kind" "${files[n]}"
      run -1 cmp -s before "${files[n]}"
    done
    for n in "${!binary[@]}"; do damage "${kinds[(n + round) % 3]}" "${binary[n]}"; done
    run -0 made_by_make figures
    [[ $output == *'fig06.a.psi: '?'.fig06.a.psi is not what AUTO wrote; it is made anew'* ]]
    [[ $output == *'build/bin/mlg is not what was built; it is made anew'* ]]
    sha256sum --check --quiet good.sums
  done
}

@test "what is only carried on and is not what is committed is refused" {
  # shellcheck disable=SC2016 # for that shell
  run -1 bash -c '. scripts/auto/lib.sh; git() { [ "$1" != diff ]; }; . scripts/report/summary.sh' scripts/report/summary.sh
  [ "$output" = 'results/verification.csv is neither what was made here nor what is committed: make verify, or git checkout results/verification.csv' ]
}

@test "what a killed make or figure left goes" {
  local gone=999999999
  touch build/bin/mlg.$gone build/models/l1.exe.$gone build/stamps/fig06.$gone.uses build/bin/mlg.$$
  made_by_make build/bin/mlg
  [ -z "$(find build -name "*.$gone*")" ]
  rm build/bin/mlg.$$
}

# slow NAME: a run of a second or two
slow_run=(l1.periodic from=fig06.b.straight DSMAX=0.03 NMX=5000 -- closed=1)

slow() {
  auto_run "$1" "${slow_run[@]}"
}

# Starts slow NAME as the leader of a process group, and waits until AUTO is at it
start_slow() {
  local tries
  setsid build/bin/mlg run "$1" "${slow_run[@]}" >"$1.log" 2>&1 3>&- &
  pid=$!
  for tries in {1..200}; do
    [ ! -s "build/runs/$1.part/b.$1" ] || return 0
    sleep 0.02
  done
  echo "the run does not start after $tries looks: $(<"$1.log")"
  return 1
}

@test "an interrupted run does not count, and is made again" {
  start_slow cut
  kill -TERM -- "-$pid"
  ended_badly "$pid"
  [ ! -e build/runs/cut ]
  run -2 auto_run after l1.torus_start from=cut -- EP=1
  run -0 slow cut
  [[ $output == *cut*closed* ]]
  run -0 slow cut
  [ -z "$output" ]
}

@test "a run whose script alone was killed is made again" {
  start_slow orphan
  kill -KILL "$pid"
  ended_badly "$pid"
  run -0 slow orphan # waits for the orphan
  [[ $output == *orphan*closed* ]]
}

@test "an interrupted run leaves the one before as it was" {
  auto_run old l1.periodic from=fig06.b.straight -- closed=1
  sha256sum build/runs/old/* >old.sums
  start_slow old
  kill -TERM -- "-$pid"
  ended_badly "$pid"
  sha256sum --check --quiet old.sums
}

@test "two scripts that want the same run make it once" {
  local first second
  slow both >both.1 2>&1 3>&- &
  first=$!
  slow both >both.2 2>&1 3>&- &
  second=$!
  wait "$first"
  wait "$second"
  cat both.1 both.2
  [ "$(cat both.1 both.2 | wc -l)" -eq 1 ]
  [[ $(cat both.1 both.2) == *closed* ]]
  [ ! -e build/runs/both.part ]
}

## A user's own slice

@test "another c_d in a copy of a constants file gives a new slice" {
  mkdir -p build/tmp
  sed "s/'c_d': 3.6e4/'c_d': 1e4/" constants/c.l1.straight >build/tmp/c.l1.mine
  auto_run mine build/tmp/c.l1.mine -- UZ=1
  auto_run mine.orbits l1.periodic from=mine -- closed=1
  [ "$(values mine HB c_d | sort -u)" = "$(value mine.orbits UZ c_d)" ]
  near "$(value mine HB c_d)" 1e4 0 c_d
  paste -d' ' <(values mine HB V) <(oracle boundary free=V from=0.1 to=200 c_d=1e4 | awk 'NR > 1 { print $1 }') |
    near_each 1e-7 "V at c_d = 1e4"
}
