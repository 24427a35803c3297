# tables.bats - mlg cell, pick, areas, fill: what is read out of the tables of results/
#
# Needs   build/bin/mlg
# Writes  build/tests/tables

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch tables
  cat > "$SCRATCH/t.csv" <<'END'
# a comment
layout,b,k_s,c_lo,c_hi,width
l1,0,1e5,1,9,8
l1,0,2e5,1,9,8
l1,0,2.001e5,1,4,3
l1,0,2.001e5,6,9,3
l1,10,inf,2,5,3
l2,10,4e5,,,
END
}

setup() {
  cd "$SCRATCH" || return
}

is() { # TEXT WORD...: what mlg cell says
  run -0 mlg cell "${@:2}"
  [ "$output" = "$1" ] || { echo "$output" && return 1; }
}

refuses() { # STATUS LINE WORD...
  run -"$1" --separate-stderr mlg "${@:3}"
  # shellcheck disable=SC2154 # set by run
  [ "$stderr" = "$2" ] || { echo "$stderr" && return 1; }
}

@test "a cell: the first row that fits, the n-th, the largest, the nearest, between two, all" {
  is 8 ./t.csv width layout=l1
  is 3 ./t.csv width k_s=200100
  is 6 ./t.csv c_lo k_s=2.001e5 nth=2
  is 10 ./t.csv b layout=l1 largest=k_s
  is 1e5 ./t.csv k_s layout=l1 largest=width
  is 2e5 ./t.csv k_s layout=l1 nearest:k_s=1.9e5
  is 150000 ./t.csv k_s layout=l1 width=8 at:k_s=1.5e5
  is '0, 10, 10' ./t.csv b 'k_s>=2.001e5' c_lo!=1 list
  is '1e5 2e5 2.001e5' ./t.csv k_s b=0 each
  is 1 ./t.csv count k_s=inf
  is 3 ./t.csv count 'layout=l[12]' b%10=0 'width<8'
  is 3 ./t.csv count 'width<=3'
  is 0 ./t.csv count 'width<3'
  is 5 ./t.csv count 'width>=3'
}

@test "cells may be reckoned with and compared" {
  is 5 ./t.csv width layout=l1 - ./t.csv width k_s=inf
  is 166.67 format=%.2f ./t.csv width layout=l1 over ./t.csv width k_s=inf
  is yes ./t.csv count layout=l1 = 5 and ./t.csv width k_s=inf '<' 4
  is no ./t.csv layout b=10 = l2
  is 2 '(' ./t.csv width k_s=1e5 - 2 ')' / ./t.csv width k_s=inf
}

@test "what is not there, or wrong, ends with one line" {
  refuses 1 'cell: MISSING(./t.csv b layout=l3)' cell ./t.csv b layout=l3
  refuses 2 'cell: ./t.csv has no column c' cell ./t.csv c layout=l3
  refuses 2 "cell: 'layout': expected COLUMN=VALUE or another condition" cell ./t.csv b layout
  refuses 2 'cell: ./none.csv: No such file or directory' cell ./none.csv b
  refuses 2 "pick: 'every=0': expected a whole number from 1 to 1000000" pick ./t.csv every=0
  printf 'a,b\n1\n' > short.csv
  refuses 2 'pick: ./short.csv:2: 1 cells, the table has 2 columns' pick ./short.csv
  printf '{{./t.csv b layout=l3}}\n' > page.md
  refuses 1 'fill: page.md:1: MISSING(./t.csv b layout=l3)' fill page.md
}

@test "rows: by text and number, columns in a format, blocks, every other one" {
  diff <(mlg pick ./t.csv 'where=layout=l*' 'k_s<1e30' c_lo!= columns=k_s*1e-5:.3f,width blocks=c_hi head) - <<'END'
k_s,width
1.000,8
2.000,8

2.001,3

2.001,3
END
  [ "$(mlg pick ./t.csv first=b columns=b,layout | tr '\n' ' ')" = '0,l1 10,l1 ' ]
  [ "$(mlg pick ./t.csv every=2 columns=k_s | tr '\n' ' ')" = '1e5 2.001e5 inf ' ]
}

@test "a smooth curve passes its rows and, through a power law, everything between" {
  awk 'BEGIN { print "x,y"; for (i = 0; i < 6; i++) printf "%.12g,%.12g\n", 2^i, 3 * 4^i }' > power.csv
  mlg pick ./power.csv smooth=x,y | awk -F, '{ n++; if (($2 / (3 * $1^2) - 1)^2 > 1e-10) exit 1 } END { exit n != 46 }'
}

@test "a smooth curve goes round a bend, where x has no way on, and is the same from both ends" {
  printf 'x,y\n1,1\n2,1\n2,2\n1,2\n' > hook.csv
  mlg pick ./hook.csv smooth=x,y > bend
  # between the second and the third row: beyond x = 2, highest in the middle, mirrored in log y
  sed -n '11,18p' bend | awk -F, '{ x[NR] = $1; y[NR] = $2 } END {
    for (i = 1; i <= 4; i++) if (!(x[i] > 2 && x[i] < 2.3 && (x[i] / x[9 - i] - 1) ^ 2 < 1e-12 && (y[i] * y[9 - i] / 2 - 1) ^ 2 < 1e-12)) exit 1
    exit !(x[4] > x[1]) }'
}

@test "areas: an interval that is divided goes on in one of its parts, the other begins" {
  diff <(mlg areas ./t.csv layout=l1) - <<'END'
1e5,1,9,8
2e5,1,9,8
2.001e5,1,4,3

2.001e5,6,9,3

END
  [ "$(mlg areas ./t.csv layout=l1 bounds | grep -c '^$')" -eq 5 ] # the upper bound jumps
  # two that become one: it goes on in the wider of them, wherever that stands
  printf 'k_s,c_lo,c_hi,width\n1e5,1,5,4\n1e5,6,9,3\n2e5,1,9,8\n' > join.csv
  diff <(mlg areas ./join.csv) - <<'END'
1e5,1,5,4
2e5,1,9,8

1e5,6,9,3

END
}

@test "what is no number is no number of a table: one line and status 2, nothing printed" {
  printf 'k_s,c_lo,c_hi,width\n1e5,1,9,8\n2e5,nan,9,8\n' > nan.csv
  printf 'k_s,c_lo,c_hi,width\n1e5,1,9,8\n2e5,2,,8\n' > empty.csv
  printf 'k_s,c_lo,c_hi,width\n1e5,1,9,8\ninf,2,7,5\n2e5,-2,7,x\n' > text.csv
  refuses 2 "areas: ./nan.csv: row 2 has 'nan' in column c_lo, expected a number" areas ./nan.csv
  refuses 2 "areas: ./empty.csv: row 2 has '' in column c_hi, expected a number" areas ./empty.csv bounds
  refuses 2 "areas: ./text.csv: row 3 has 'x' in column width, expected a number" areas ./text.csv
  [ -z "$output" ]
  [ "$(mlg areas ./text.csv k_s!=2e5)" = 1e5,1,9,8 ] # k_s = inf is no place on an axis
  refuses 2 "pick: ./nan.csv: row 2 has 'nan' in column c_lo, expected a number above 0" pick ./nan.csv smooth=k_s,c_lo
  refuses 2 "pick: ./text.csv: row 3 has '-2' in column c_lo, expected a number above 0" pick ./text.csv smooth=k_s,c_lo columns=width
  [ -z "$output" ]
  mlg pick ./nan.csv smooth=k_s,c_hi
  { echo k_s,c_lo,c_hi,width && for i in {1..33}; do echo "1e5,$i,$i.5,0.5"; done; } > many.csv
  refuses 2 'areas: ./many.csv: more than 32 intervals at k_s = 1e5' areas ./many.csv
  # of a column without numbers none is the largest, and a text is not below a number
  refuses 1 'cell: MISSING(./t.csv k_s largest=layout)' cell ./t.csv k_s largest=layout
  refuses 1 'cell: MISSING(./t.csv k_s nearest:layout=3)' cell ./t.csv k_s nearest:layout=3
  is 1e5 ./nan.csv k_s largest=c_lo
  refuses 1 "cell: 'nan' < '3': expected numbers" cell ./nan.csv c_lo k_s=2e5 '<' 3
  refuses 1 "cell: '3' >= '': expected numbers" cell 3 '>=' ./empty.csv c_hi k_s=2e5
}

@test "torus curves joined with double Hopf points, closed curves" {
  local V c_d
  curves() { # V C_D: the second curve ends so, its HH is at 40, 5e4
    printf '%s\n' curve,shimmy,type,V,c_d torus_a,,HH,20,3e4 torus_a,,,20.1,3.01e4 torus_a,,,39.8,4.98e4 torus_a,,HH,40,5e4 \
      torus_b,,HH,20,3e4 torus_b,,,20.1,3.01e4 "torus_b,,,$1,$2" torus_b,,HH,40,5e4 psi,psi,HH,20,3e4 psi,psi,,20,3e4 psi,psi,HH,20,3e4 > fig.csv
  }
  curves 39.7 4.97e4
  is 2 ./fig.csv joined
  # a curve that ends 2 % from its point is not joined
  for V in 39.1 40.9; do curves $V 4.97e4 && is 1 ./fig.csv joined; done
  for c_d in 4.89e4 5.11e4; do curves 39.7 $c_d && is 1 ./fig.csv joined; done
  printf '%s\n' k_s,curve,V,c_d 1e5,1,2,3 1e5,1,4,5 1e5,1,2,3 1e5,2,2,3 1e5,2,4,5 1e5,2,2,3.01 1e5,3,2,3 1e5,3,4,5 1e5,3,2.01,3 2e5,1,2,3 2e5,1,4,5 2e5,1,2,3 > closed.csv
  is 2 ./closed.csv closed
  is 1 ./closed.csv closed k_s=2e5
}

@test "no table has AUTO's number for a rigid k_s" {
  run ! grep -lE '1e\+?30' "$ROOT"/results/*.csv "$ROOT"/results/*.md
  [ "$(mlg gearinfo | awk -F, '$1 == "k_s" { print $2, $3 }')" = "inf inf" ]
  [ "$(mlg criticality l1 <<< 10,2700,inf,0,11)" = "$(mlg criticality l1 <<< 10,2700,1e30,0,11)" ]
}
