#!/usr/bin/env bash
# What shimmy looks like: the solutions A and B of Figure 6 over one period
#
#   scripts/filmstrip.sh [runs | tables | draw]
#
# A: psi-shimmy at V = 20 m/s, B: delta-shimmy at V = 40 m/s; layout L1, c_d =
# 3.6e4 N m s/rad.
# Writes: results/filmstrip.csv, results/filmstrip.png, .svg and .gif
# Expect: in A psi swings by 3.67 degrees at 10.9 Hz, in B delta* by 12.2 mm at
#         17.5 Hz; the other angle hardly moves.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"

runs_orbits() { scripts/fig06.sh runs a; }

# One solution of a run, by its speed, over its period
orbit() { # SOLUTION RUN V
  mlg orbit "$2" "$(mlg point "$2" UZ where=V="$3" columns=label)" prefix="$1" >> "$table.new"
}

tables() {
  begin_table results/filmstrip.csv \
    "# A: psi-shimmy at V = 20 m/s, B: delta-shimmy at 40 m/s; L1, c_d = 3.6e4 N m s/rad. phase: t / period, 0 at the" \
    "# peak of the larger angle; t s; psi deg; dstar = l_delta delta, lambda_L, lambda_R m. 96 instants and the first" \
    "# again, linear between AUTO's mesh points, which is good to 1e-3 of an amplitude." \
    solution,phase,t,psi,dstar,lambda_L,lambda_R
  orbit A fig06.a.psi 20
  orbit B fig06.a.delta 40
  end_table
}

main filmstrip "$@"
