# stamps.bats - is what was made from something made again when that changed, or was damaged?
#
# The stamps of figures (mlg stamp), damage to the files of a run, of a table and of a
# picture, and the rows of a curve (mlg curve).
#
# Needs   the models and build/bin/mlg (make test-programs)
# Writes  build/tests/stamps

# shellcheck disable=SC2030,SC2031 # each test runs in a shell of its own
bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch stamps
  cp -rp "$ROOT/results" .
  scripts/fig06.sh >first.log
}

setup() {
  cd "$SCRATCH" || return
}

## mlg stamp

# stamped NAME FILE...: begins and writes a stamp as a script does
stamped() {
  mkdir -p build/stamps
  touch "build/stamps/$1.began"
  mlg stamp write "$@"
}

@test "a stamp fits until one of its files is another, is gone, or is back" {
  echo one >a
  echo two >b
  stamped mine a b
  run -0 mlg stamp fits mine
  [ -z "$output" ]
  touch a # looked at again, and the same
  run -0 mlg stamp fits mine
  echo One >a
  run -1 mlg stamp fits mine
  [ "$output" = mine ]
  echo one >a
  run -0 mlg stamp fits mine
  # the same size and time, other bytes
  cp -p a kept
  printf 'onE\n' >a
  touch -r kept a
  rm kept
  run -1 mlg stamp fits mine
  echo one >a
  rm b
  run -1 mlg stamp fits mine
  echo two >b
  run -0 mlg stamp fits mine
}

@test "of several names those are printed that do not fit" {
  echo one >a
  echo two >b
  stamped first a
  stamped second b
  stamped third a b
  echo 2 >b
  run -1 mlg stamp fits first second third never
  [ "$output" = $'second\nthird\nnever' ]
}

@test "a stamp that is cut, empty or garbled fits nothing" {
  local damage
  echo one >a
  stamped mine a
  cp build/stamps/mine whole
  for damage in 's/end//' '/end/d' '1d' 's/^./z/' 's/\t.*/\tb/' 'd'; do
    sed "$damage" whole >build/stamps/mine
    case $damage in 1d) echo 'x' >>build/stamps/mine ;; esac
    run -1 mlg stamp fits mine || { echo "$damage" && return 1; }
  done
  cp whole build/stamps/mine
  mlg stamp fits mine
}

@test "a script that is edited while it runs is not taken for the one that ran" {
  mkdir -p build/stamps scripts
  echo 'echo one' >scripts/mine.sh
  touch build/stamps/mine.began
  sleep 0.01
  echo 'echo two' >scripts/mine.sh
  run -0 mlg stamp write mine scripts/mine.sh
  run -1 mlg stamp fits mine
  # what the script itself makes is no edit
  echo table >build/made
  mlg stamp write mine build/made
  mlg stamp fits mine
}

@test "what commands read stands in the list of MLG_USES, and in the stamp" {
  : >journal
  # shellcheck disable=SC2094
  MLG_USES=journal mlg rows fig06.a.straight columns=V >of.it
  MLG_USES=journal mlg run again l1.straight -- HB=4
  grep -q 'b.fig06.a.straight$' journal
  grep -q 'constants/c.l1.straight$' journal
  grep -q 'build/models/l1.exe$' journal
  touch build/stamps/mine.began
  MLG_USES=journal mlg stamp write mine
  mlg stamp fits mine
  cp -p build/runs/again/b.again kept
  sed -i '60,$d' build/runs/again/b.again
  run -1 mlg stamp fits mine
  cp -p kept build/runs/again/b.again
  mlg stamp fits mine
}

@test "no list, no files, no name: one line" {
  run -1 mlg stamp write mine
  [ "$output" = 'stamp: mine: no files' ]
  MLG_USES=none run -1 mlg stamp write mine scripts/run.sh
  [ "$output" = 'stamp: mine: no files: none: No such file or directory' ]
  run -1 mlg stamp write mine not-there
  [ "$output" = 'stamp: not-there: No such file or directory' ]
  run -2 mlg stamp fits a/b
  [[ $output == "stamp: NAME 'a/b': letters"* ]]
  run -2 mlg stamp
  [[ $output == 'usage: mlg stamp '* ]]
}

## Damage

# made_anew LINE...: fig06.sh works again, says these lines, leaves what was there, and is
# then content
made_anew() {
  local line
  run -0 scripts/fig06.sh
  for line; do
    [[ $'\n'$output$'\n' == *$'\n'$line$'\n'* ]] || { echo "$output" && return 1; }
  done
  sha256sum --check --quiet sums
  run -0 scripts/fig06.sh
  [ -z "$output" ]
}

@test "a figure of which nothing changed is left alone" {
  run -0 scripts/fig06.sh
  [ -z "$output" ]
}

@test "damage to a file of a run is repaired by the next make, with a line" {
  local damage run file lines_of=()
  sha256sum results/fig06.* build/tables/points.fig06.csv >sums
  # shellcheck disable=SC2016 # sed's last line
  while read -r file damage; do
    run=${file#*.}
    sed -i "$damage" "build/runs/$run/$file"
    lines_of+=("  $run: $file is not what AUTO wrote; it is made anew")
  done <<'END'
b.fig06.a.psi 60,$d
b.fig06.b.delta 40s/1/2/5
s.fig06.c.psi 100d
d.fig06.a.delta 20,$d
c.fig06.c.straight s/DSMAX = /DSMAX = 1/
END
  made_anew "${lines_of[@]}"
  rm build/runs/fig06.b.delta/s.fig06.b.delta
  dd if=/dev/zero of=build/runs/fig06.a.psi/b.fig06.a.psi bs=1 seek=6000 count=200 conv=notrunc status=none
  rm -r build/runs/fig06.c.psi
  made_anew '  fig06.b.delta: s.fig06.b.delta is not what AUTO wrote; it is made anew' \
    '  fig06.a.psi: b.fig06.a.psi is not what AUTO wrote; it is made anew'
}

@test "damage to a table or a picture is repaired by the next make" {
  sha256sum results/fig06.* build/tables/points.fig06.csv >sums
  sed -i '50,$d' results/fig06.csv
  made_anew
  sed -i '60s/1/2/' results/fig06.csv
  : >results/fig06.png
  made_anew
  rm results/fig06.svg
  sed -i '3d' build/tables/points.fig06.csv
  made_anew
}

@test "another script, picture or constants file makes a figure anew, a comment in one too" {
  local file
  sha256sum results/fig06.* build/tables/points.fig06.csv >sums
  for file in scripts/fig06.sh scripts/auto/lib.sh scripts/pictures/fig06.gp scripts/pictures/style.gp constants/c.l1.straight; do
    cp -p "$file" kept
    echo '# more' >>"$file"
    run -1 mlg stamp fits fig06
    mv kept "$file"
    mlg stamp fits fig06
  done
  echo '# more' >>scripts/pictures/fig06.gp
  made_anew
}

## mlg curve

@test "the rows of a curve: both ends, every extremum, and none too many" {
  local V c
  scripts/curves.sh l2 plane k_s=1e6
  mlg curves l2 k_s=1e6 | sed 1d >curves.csv
  [ "$(wc -l <curves.csv)" -eq 3 ]
  while IFS=, read -r number kind _ _ _ _ _ _ _ _ _ _ turns; do
    # shellcheck disable=SC2086 # a word or none
    mlg curve "plane.$number" prefix="x," ${kind/open/} extrema="$turns" >rows
    [ "$(cut -d , -f 1 rows | sort -u)" = x ]
    [ "$(cut -d , -f 2 rows | grep -c LP)" -eq "$(wc -w <<<"$turns")" ]
    awk -F, '$2 == "LP" { print $4 }' rows | sort -g >made
    tr ' ' '\n' <<<"$turns" | sed 's/.*://' | sort -g | paste -d ' ' made - | near_each 1e-6 "extremum of c_d"
    [ "$kind" = open ] || [ "$(sed -n '1s/^x,[A-Z]*,//p' rows)" = "$(sed -n '$s/^x,[A-Z]*,//p' rows)" ]
    # one that the curve lacks, one that is not asked for
    V=${turns%%:*} c=${turns#*:} c=${c%% *}
    # shellcheck disable=SC2086
    run -1 mlg curve "plane.$number" ${kind/open/} extrema="$turns $V:$(awk "BEGIN { print 1.01 * $c }")"
    [[ $output == *"plane.$number:"*" no extremum at ("* ]]
    # one a hundred-thousandth off is missing, and that of the curve one too many
    # shellcheck disable=SC2086
    run -1 mlg curve "plane.$number" ${kind/open/} extrema="$V:$(awk "BEGIN { printf \"%.12g\", (1 + 1e-5) * $c }")${turns#"$V:$c"}"
    [[ $output == *" an extremum too many at ("*" no extremum at ("* ]]
    # shellcheck disable=SC2086
    run -1 mlg curve "plane.$number" ${kind/open/} extrema=
    [[ $output == *"plane.$number:"*" an extremum too many at ("* ]]
  done <curves.csv
  run -2 mlg curve
  [[ $output == 'usage: mlg curve '* ]]
  run -2 mlg curve nothing
  [[ $output == "curve: there is no run 'nothing'"* ]]
}
