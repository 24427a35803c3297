#!/usr/bin/env bash
# damping.sh - least damping ratios and decay rates against LAPACK's eigenvalues of the
# full linearised equations, and the best damped L1 against AUTO
#
#   tests/verify/damping.sh [short]
#
# Needs:  eigen-LAYOUT (make test-programs); ours is read from results/damping.csv and
#         results/transients.csv. The full form makes two runs of c.boundary.point.
# Prints: rows what,unit,ours,oracle,tolerance (no header); short: four of them.
# Status: 0 the rows stand, 1 a run of AUTO failed, 2 bad input.
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/auto/lib.sh"
. scripts/auto/boundary.sh

case $#,${1:-} in 0, | 1,short) ;; *) fail "usage: tests/verify/damping.sh [short]" 2 ;; esac
build test-programs

# The least damping ratio of the eigenvalues, and its decay rate, 1/s
least() { # LAYOUT PARAMETER...
  "build/bin/eigen-$1" eigenvalues "${@:2}" | awk 'NR > 1 && $2 > 0 {
    zeta = -$1 / sqrt($1 ^ 2 + $2 ^ 2)
    if (least == "" || zeta < least) { least = zeta; rate = -$1 }
  } END { printf "%.8g %.8g\n", least, rate }'
}

# at that V, a minimum: 5e-4 of it moves zeta by 1e-4 at most, four digits are printed
ratios() { # CHOICE...
  local layout choice b k_s c_d zeta V oracle
  while IFS=, read -r layout choice b k_s c_d zeta V _; do
    read -r oracle _ < <(least "$layout" V="$V" c_d="$c_d" k_s="$k_s" b="$b")
    echo "$layout $choice b = $b: least damping ratio,-,$zeta,$oracle,2e-3"
  done < <(for choice; do mlg pick results/damping.csv where=choice="$choice"; done)
}

# decay rates after psi' = 1 rad/s, measured from 5 % to 2 % of the peak: at these speeds
# the psi mode has died by then
rates() {
  local choice layout V measured c_d k_s b oracle
  while IFS=, read -r choice layout V _ _ _ _ _ _ measured _; do
    case $layout in li*) b=140 ;; *) b=0 ;; esac
    IFS=, read -r k_s c_d < <(mlg pick results/damping.csv where=layout="$layout" where=choice="$choice" where=b="$b" columns=k_s,c_d)
    read -r _ oracle < <(least "$layout" V="$V" c_d="$c_d" k_s="$k_s" b="$b")
    echo "$layout $choice: decay rate of delta* at V = $V,1/s,$measured,$oracle,1e-4"
  done < <(for V in 100 150; do mlg pick results/transients.csv where=disturbance=psi where='dstar_end!=' where=V=$V; done)
}

ratios middle
[ $# -eq 0 ] || exit 0
ratios paper best over_b widest
rates

# L1's best c_d is where the boundaries of that ratio meet, of psi from below and delta
# from above; zeta of delta hardly changes with c_d, 5e-9 of it by 0.05 N m s/rad
IFS=, read -r c_d zeta _ < <(mlg damping l1 best | sed 1d)
mapfile -t points < <(mlg starts l1)
for i in 0 1; do
  name=verify.damping.$i
  to_damping_ratio "$name" l1 "${points[i]}" "$zeta" b=0 compliance=0 >&2
  echo "l1 paper: c_d of boundary $((i + 1)) of that ratio by AUTO,N m s/rad,$c_d,$(mlg point "$name" UZ columns=c_1:.9g),1e-6"
done
