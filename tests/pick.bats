# pick.bats - does mlg pick pick what was asked for, and is what takes minutes made again
# when, and only when, what it hangs on changed?
#
# Needs   build/bin/mlg (make test-programs)
# Writes  build/tests/pick

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch pick
}

setup() {
  cd "$SCRATCH" || return
  cat > table.csv <<'END'
# a head
curve,type,V,c_d,stable
a,HB,1.0,2e3,1
a,,2,3000,
b,LP,3,inf,0
b,,-4,5,1
END
}

# picks LINES WORD...: the lines with / for their ends
picks() {
  run -0 --separate-stderr mlg pick ./table.csv "${@:2}"
  [ "$(tr '\n' / <<< "$output")" = "$1/" ] || { echo "$output" && return 1; }
}

@test "rows by text, pattern, number and order" {
  picks 'a,HB,1.0,2e3,1/a,,2,3000,' where=curve=a
  picks 'a,HB,1.0,2e3,1' where=curve=a where=c_d=2000
  picks 'a,HB,1.0,2e3,1/b,LP,3,inf,0' 'where=type=[HL]?'
  picks 'a,,2,3000,/b,,-4,5,1' where=type=
  picks 'a,HB,1.0,2e3,1/b,LP,3,inf,0' where=type!=
  picks 'b,,-4,5,1' 'where=V<1'
  picks 'a,,2,3000,/b,LP,3,inf,0' 'where=V>1'
  picks 'b,LP,3,inf,0' where=c_d=inf
  picks 'a,HB,1.0,2e3,1/a,,2,3000,/b,,-4,5,1' where=c_d!=inf
  picks '' where=curve=c
  # a cell that is no number is neither above nor below
  picks '' 'where=stable>-1' where=stable=
}

@test "columns, factors, formats, blocks, firsts" {
  picks 'V,curve/1.0,a/2,a/3,b/-4,b' head columns=V,curve
  picks '2,HB/3,' columns='c_d*1e-3,type' where=curve=a
  picks '2000.0/3000.0/inf/5.0' columns=c_d:.1f
  picks '1/2//3/-4' columns=V:.3g blocks=curve
  picks '1.0/3' columns=V first=curve
  picks '1.0/3' columns=V every=2
}

@test "what cannot be picked is one line and status 2" {
  local words
  while read -r words; do
    # shellcheck disable=SC2086 # words
    run -2 --separate-stderr mlg pick $words
    # shellcheck disable=SC2154 # set by run
    [ "${#stderr_lines[@]}" -eq 1 ] && [ -z "$output" ] || { echo "$words: $stderr" && return 1; }
  done <<'END'

none.csv
./table.csv where=q=1
./table.csv where=V
./table.csv where=V!3
./table.csv columns=q
./table.csv columns=V:6
./table.csv columns=V*x
./table.csv every=0
./table.csv ./table.csv
./table.csv what=1
END
  echo a,LP,1 >> table.csv
  run -2 --separate-stderr mlg pick ./table.csv
  [ "$stderr" = 'pick: ./table.csv:7: 3 cells, the table has 5 columns' ]
  : > table.csv
  run -2 mlg pick ./table.csv
}

@test "what takes minutes is made again when its words, a file or the table changed" {
  mkdir -p build/tables build/stamps
  cat > ask <<'END'
. scripts/auto/lib.sh
MLG_USES=build/uses
slow() { echo once >> count; echo "$*"; }
made slow input -- slow "$@"
END
  : > count
  echo 1 > input
  times() { # N WORD...: made N times by now
    bash ask "${@:2}" > /dev/null
    [ "$(wc -l < count)" -eq "$1" ]
    [ "$(< build/tables/slow.csv)" = "${*:2}" ]
  }
  times 1 a b
  times 1 a b
  touch input build/bin/mlg
  times 1 a b
  times 2 a c
  echo 2 > input
  times 3 a c
  echo damage >> build/tables/slow.csv
  times 4 a c
  times 4 a c
  # one that failed leaves the table, and counts as not made
  sed -i 's/^slow().*/slow() { echo half; return 3; }/' ask
  run -3 bash ask a d
  [ "$(< build/tables/slow.csv)" = 'a c' ]
}

@test "the side on which a mode grows is that of the eigenvalues" {
  local c_d V grows sign n=0
  while IFS=, read -r c_d V _ _ grows; do
    n=$((n + 1))
    sign=$(build/bin/eigen-li1 eigenvalues k_s=6.38e5 b=80 c_d="$c_d" V="$(awk "BEGIN { print $V * 1.0001 }")" | awk 'NR == 2 { print ($1 > 0 ? "above" : "below") }')
    [ "$sign" = "$grows" ]
  done < <(mlg hopf li1 c_d=1e4 k_s=6.38e5 b=80 | sed 1,2d)
  [ "$n" -eq 2 ]
  [ "$(mlg hopf li1 c_d=1e4 k_s=6.38e5 b=80 zeta=1e-6 | sed 1,2d | cut -d , -f 5 | sort -u)" = '' ]
}
