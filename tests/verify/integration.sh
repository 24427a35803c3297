#!/usr/bin/env bash
# integration.sh - time integration as an oracle for AUTO's periodic solutions and
# Hopf points, and for the eigenvalues
#
#   tests/verify/integration.sh [short]
#
# Needs:  build/bin/mlg and eigen-l1 (make test-programs); the full form makes the
#         runs of Figure 6(a), if they are not there, and two from them.
# Prints: rows what,unit,ours,oracle,tolerance (no header).  ours: AUTO's, from
#         results/special_points.csv or those runs; of growth rates the eigenvalue.
#         oracle: what simulate settled on or measured, nan where it failed (it then
#         says why on standard error).  tolerance: relative, or with its unit
#         absolute.  short: the quickest of them.
# Status: 0 the rows stand, 1 a run of AUTO failed, 2 bad input.
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/auto/lib.sh"

case $#,${1:-} in 0, | 1,short) ;; *) fail "usage: tests/verify/integration.sh [short]" 2 ;; esac
build test-programs

# The first value of a column of a table where all words hold; nan without one
value() { # TABLE NAME [where=COLUMN=VALUE ...]
  mlg pick "$1" columns="$2" "${@:3}" | sed -n 1p | grep . || echo nan
}

special() { # NAME COLUMN=VALUE...
  local words=("${@:2}")
  value results/special_points.csv "$1" "${words[@]/#/where=}"
}

simulated() { # WORD...: the table of mlg simulate as $table; empty if it fails, which it says
  table=build/tests/verify/simulated.csv
  mlg simulate l1 "$@" > "$table" || true
}

# orbit WHAT AUTO WORD...: rows of the solution that simulate settles on, against
# what the function AUTO gives for a column
orbit() {
  local what=$1 auto=$2 table name unit
  shift 2
  simulated orbit "$@"
  while read -r name unit; do
    printf '%s: %s,%s,%s,%s,1e-4\n' "$what" "$name" "$unit" "$($auto "$name")" "$(value "$table" "$name")"
  done <<< 'psi_max deg
dstar_max m
frequency_hz Hz'
}

# growth WHAT RATE FREQUENCY TOLERANCE WORD...: rows of a small oscillation
growth() {
  local what=$1 rate=$2 frequency=$3 tolerance=$4 table
  shift 4
  simulated growth "$@"
  printf '%s: growth rate,1/s,%s,%s,%s\n' "$what" "$rate" "$(value "$table" rate)" "$tolerance"
  printf '%s: frequency,Hz,%s,%s,1e-5\n' "$what" "$frequency" "$(value "$table" frequency_hz)"
}

# eigenvalue WHAT STATE=VALUE PARAMETER=VALUE...: growth against the eigenvalue
# furthest to the right
eigenvalue() {
  local what=$1 start=$2 rate frequency
  shift 2
  read -r rate _ frequency < <(build/bin/eigen-l1 eigenvalues "$@" | sed 1d)
  growth "$what" "$rate" "$frequency" 1e-4 "$start" t_end=40 "$@"
}

A() { special "$1" run=fig06.a.psi type=UZ V=20; }
B() { special "$1" run=fig06.a.delta type=UZ V=40; }
b() { special "$1" run=fig06.b.delta type=UZ V=40; }
c() { special "$1" run=fig06.c.psi type=UZ V=20; }

# the solution at V = 29 on a branch of Figure 6(a), between its torus points
between() { # BRANCH NAME
  mlg point "verify.$1" UZ where=V=29 columns="${2/_hz/}:.8g" || echo nan
}
between_psi() { between psi "$1"; }
between_delta() { between delta "$1"; }

V=$(special V run=fig06.a.straight type=HB) # the first: psi
growth "Hopf point V = $V (6a)" 0 "$(special frequency_hz run=fig06.a.straight type=HB V="$V")" \
  '1e-5 1/s' V="$V" psi=1e-6 t_end=120
V=$(special V run=fig06.b.straight type=HB)
growth "Hopf point V = $V (6b)" 0 "$(special frequency_hz run=fig06.b.straight type=HB V="$V")" \
  '1e-6 1/s' c_d=5e3 V="$V" delta=1e-6 t_end=40
eigenvalue 'psi at V = 13 (6a)' psi=1e-6 V=13
eigenvalue 'psi at V = 14 (6a)' psi=1e-6 V=14
orbit 'A: V = 20 (6a)' A psi=0.05 V=20
orbit 'V = 20 (6c)' c psi=0.05 c_d=2e3 V=20
[ $# -eq 0 ] || exit 0

eigenvalue 'delta at V = 25 (6b)' delta=1e-6 c_d=5e3 V=25
eigenvalue 'delta at V = 26 (6b)' delta=1e-6 c_d=5e3 V=26
orbit 'B: V = 40 (6a)' B delta=0.01 V=40
orbit 'V = 40 (6b)' b delta=0.01 c_d=5e3 V=40
scripts/fig06.sh runs a >&2
UZR="UZR={'torus': [-1e-5, 2e-5], 'V': [29.0]}"
run verify.psi l1.periodic from=fig06.a.straight IRS="'HB1'" "$UZR" -- TR=1 UZ=3 closed=1 >&2
run verify.delta l1.periodic from=fig06.a.straight IRS="'HB2'" "$UZR" -- TR=1 UZ=3 closed=1 >&2
orbit 'psi at V = 29 (6a)' between_psi psi=0.05 V=29
orbit 'delta at V = 29 (6a)' between_delta delta=0.01 V=29
