# demo.bats - does a folder from auto-demo.sh give the figure to someone who has AUTO alone?
#
# The folders lie outside the checkout, in a path with a blank, and are run with a copy of
# AUTO and an empty environment.  The points are compared with results/special_points.csv
# by a reader of this file's own.
#
# Needs   build/auto.mk, build/models, build/bin; MLG_AUTO_NEWEST=/path: upstream's newest
#         AUTO, built, for one more test
# Writes  build/tests/demo, and a folder of mktemp

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  export AWAY AUTO
  scratch demo
  cp -rp "$ROOT"/{LICENSE,results} .
  AWAY=$(mktemp -d)
  AUTO=$(sed -n 's/^AUTO_DIR = //p' build/auto.mk)
  mkdir "$AWAY/auto"
  cp -r "$AUTO"/{bin,cmds,include,lib,python} "$AWAY/auto"
  scripts/auto-demo.sh fig06 "$AWAY/a demo/fig06"
  scripts/auto-demo.sh fig07 "$AWAY/a demo/fig07"
}

teardown_file() { rm -rf "$AWAY"; }

setup() { cd "$SCRATCH" || return; }

# alone AUTO COMMAND...: with that AUTO and nothing else
alone() {
  env -i HOME="$AWAY" PATH="$1/bin:$1/cmds:/usr/bin:/bin" AUTO_DIR="$1" OMP_NUM_THREADS=1 "${@:2}"
}

# found RUN TYPE COLUMN: of all its points of that type, from AUTO's file here
found() {
  awk -v wanted="$2" -v column="$3" '
    /^ +0 +PT +TY/ { for (k = 1; k <= NF; k++) if ($k == column) place = k }
    $1 != 0 && $4 != 0 && ((wanted == "HB" && $3 == 3) || (wanted == "TR" && $3 == 8) || (wanted == "HH" && $3 % 10 == -3) || (wanted == "LP" && $3 % 10 == 2)) { print $place }
  ' "b.$1"
}

# The special points of record of a figure, to 6 digits.
as_of_record() { # FIGURE_NUMBER
  local run type V c_d n=0 i
  local -A seen=()
  while IFS=, read -r _ _ run type V c_d _; do
    [[ $type != UZ ]] || continue
    i=$((${seen[$run $type]:-0} + 1)) n=$((n + 1))
    seen[$run $type]=$i
    near "$(found "$run" "$type" V | sed -n ${i}p)" "$V" 2e-6 "V of $run $type $i" || return
    near "$(found "$run" "$type" c_d | sed -n ${i}p)" "$c_d" 2e-6 "c_d of $run $type $i" || return
  done < <(grep "^$1,l1," "$ROOT/results/special_points.csv")
  [ "$n" -ge 7 ]
}

# Branches end before they turn round or fall onto the zero solution.
ends_in_time() { # RUN V
  awk -v V="$2" '$1 != 0 { last = $5; type = $3; points++; if ($6 < 1e-3 && points > 3) zero = 1 }
    END { exit !(type == -4 && !zero && (last - V) ^ 2 < 0.5) }' "b.$1"
}

@test "Figure 6 by AUTO's shell commands, in a folder of its own" {
  cd "$AWAY/a demo/fig06"
  alone "$AWAY/auto" sh fig06.sh > log 2>&1
  [ "$(tail -n 1 log)" = "all values are as expected" ]
  as_of_record 6
  ends_in_time fig06.a.psi 33.8422
  ends_in_time fig06.a.delta 61.6176
  ends_in_time fig06.b.delta 50.6803
  ends_in_time fig06.c.psi 25.9574
}

@test "Figure 7 by AUTO's Python interface" {
  cd "$AWAY/a demo/fig07"
  alone "$AWAY/auto" auto fig07.auto > log 2>&1
  grep -qx "all values are as expected" log
  as_of_record 7
  # torus curves end beside the double Hopf points
  near "$(tail -n 1 b.fig07.torus_psi.up | awk '{ print $5 }')" 61882.6 2e-3
  near "$(tail -n 1 b.fig07.torus_delta.down | awk '{ print $5 }')" 32037.9 1e-2
  # gnuplot finds all curves; a Python without matplotlib says so
  gnuplot -d plot.gp 2> warnings
  [ ! -s warnings ]
  [ "$(wc -c < fig07.png)" -gt 20000 ]
  run python3 plot.py
  [ "$status" -eq 0 ] || [[ $output == "plot.py: this Python has no matplotlib; "* ]]
}

@test "a header that changed is compiled, an error is not hidden, a wrong value is named" {
  cp -r "$AWAY/a demo/fig06" "$AWAY/changed"
  cd "$AWAY/changed"
  rm -f ./*.o ./b.* ./*.exe
  sed -i '/^@r.*fig06.a.psi\|^@sv fig06.a.psi\|fig06.[ab].delta\|fig06.[bc]/d' fig06.sh
  sed -i '/fig06.a.straight\|^run/!d' points.csv
  alone "$AWAY/auto" sh fig06.sh > log 2>&1
  sed -i 's/1\.09e5/1.0e5/' mlg.h
  run -1 alone "$AWAY/auto" sh fig06.sh
  [[ $output == *"fig06.a.straight"*HB1*"differs"* ]]
  echo "no C" >> l1.c
  run -1 alone "$AWAY/auto" sh fig06.sh
  [[ $output == *"l1.c was not compiled"* ]]
}

@test "the folder names nothing of the project or of this machine" {
  local file
  cd "$AWAY/a demo/fig07"
  run ! grep -rlF -e "$ROOT" -e "build/runs" -e "mlg run" --include='*.auto' --include='*.sh' --include='c.*' --include='*.md' .
  while read -r file; do
    [ "$file" = auto_f2c.h ] || [ -f "$file" ]
  done < <(sed -n 's/^ *#include "\(.*\)"/\1/p' ./*.[ch])
}

@test "Figure 9 to its end, and the first runs of Figure 10 (make check-demos has all eight)" {
  scripts/auto-demo.sh fig09 "$AWAY/fig09"
  scripts/auto-demo.sh fig10 "$AWAY/fig10"
  cd "$AWAY/fig09"
  alone "$AWAY/auto" sh fig09.sh > log 2>&1
  [ "$(tail -n 1 log)" = "all values are as expected" ]
  [ "$(wc -l < points.csv)" -gt 100 ]
  [ "$(grep -c "^@sv" fig09.sh)" -ge 40 ]
  cd "$AWAY/fig10"
  # the first two runs and the check of their points
  awk '/^@sv/ { n++ } n < 2 || /^@sv/ && n == 2 || /^(# Expected|LC_ALL)/' fig10.sh > two.sh
  head -n 1 points.csv > points
  grep -F "$(sed -n 's/^@sv //p' two.sh | sed 's/$/,/')" points.csv >> points && mv points points.csv
  alone "$AWAY/auto" sh two.sh > log 2>&1
  [ "$(tail -n 1 log)" = "all values are as expected" ]
  [ "$(wc -l < points.csv)" -gt 4 ]
}

@test "runs of one's own, with those that they start from" {
  auto_run own.straight l1.straight c_d=1e4 -- HB=2 > /dev/null
  auto_run own.delta l1.periodic from=own.straight IRS="'HB1'" -- > /dev/null
  scripts/auto-demo.sh own "$AWAY/own" runs=own.delta
  cd "$AWAY/own"
  alone "$AWAY/auto" auto own.auto > log 2>&1
  grep -qx "all values are as expected" log
  grep -q "With c_d=1e4" own.auto
  ends_in_time own.delta 59.2936
}

@test "slips end with one line, and no folder is touched" {
  run -2 scripts/auto-demo.sh fig99 "$AWAY/none"
  [ "${#lines[@]}" -eq 1 ] && [[ $output == *"no figure 'fig99'"* ]]
  run -2 scripts/auto-demo.sh own "$AWAY/none" runs=nothing
  [ "${#lines[@]}" -eq 1 ] && [[ $output == *"no run nothing"* ]]
  run -2 scripts/auto-demo.sh fig06 "$AWAY/auto"
  [ "${#lines[@]}" -eq 1 ] && [[ $output == *"not an empty folder"* ]]
  run -2 scripts/auto-demo.sh fig06
  [ "${#lines[@]}" -eq 1 ]
  [ ! -e "$AWAY/none" ]
}

@test "upstream's newest AUTO gives Figure 7, by both ways" {
  [ -n "${MLG_AUTO_NEWEST:-}" ] || skip "MLG_AUTO_NEWEST=/path of upstream's newest AUTO, built, is not given"
  cp -r "$AWAY/a demo/fig07" "$AWAY/newest"
  cd "$AWAY/newest"
  rm -f b.* s.* d.*
  alone "$MLG_AUTO_NEWEST" sh fig07.sh > log 2>&1
  [ "$(tail -n 1 log)" = "all values are as expected" ]
  as_of_record 7
  alone "$MLG_AUTO_NEWEST" auto fig07.auto > log 2>&1
  grep -qx "all values are as expected" log
}
