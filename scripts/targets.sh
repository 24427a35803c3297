#!/usr/bin/env bash
# The paper's numbers against ours: tests/targets.csv joined with the tables of
# this run. Writes results/special_points.csv (every figure's points) and
# results/targets.csv, prints the latter readably; status 1 if a row fails.
# "computed" is read from the tables the runs left, never from the targets.
. "$(dirname "$0")/lib.sh"

replace_from() { cat > "$1.new"; replace "$1"; }

{ echo "# Special points of the runs in build/runs. V m/s, c_d N m s/rad, k_s N m/rad (inf: rigid), b N m s^2/rad,"
  echo "# frequency_hz Hz, psi_max deg, dstar_max m (orbits only). type: HB Hopf, HH double Hopf, TR torus,"
  echo "# LP extremum of c_d along a Hopf curve (boundary point), UZ a speed asked for."
  echo figure,layout,run,type,V,c_d,k_s,b,frequency_hz,psi_max,dstar_max
  cat build/tables/points.fig*.csv; } | replace_from results/special_points.csv

{ echo "# Boundary points over k_s: extrema of c_d along the Hopf curves of the (V, c_d) plane (models/boundary.h)."
  echo "# b N m s^2/rad, k_s N m/rad (inf: rigid), c_d N m s/rad, V m/s. name: BP1 top of the low psi region, BP3 bottom"
  echo "# of the high one, BP2_l and BP2_u bottom and top of a delta region, psi3 top of a third psi region, onset: birth"
  echo "# of a delta region, meet: of two psi regions' meeting; type LP there. Every fourth point of AUTO's."
  echo layout,b,curve,name,type,k_s,c_d,V,frequency_hz,extremum,shimmy
  cat build/tables/boundary.fig*.csv; } | replace_from results/boundary_points.csv

{ echo "# The widest zero-shimmy interval over k_s: b N m s^2/rad, k_s N m/rad, c_lo to c_hi and width N m s/rad, V_lo and"
  echo "# V_hi m/s at the bounds, lower and upper: which boundary point bounds it, limit: what ends its growth over k_s."
  echo "# Between the multiples of 10 stand the b where limit or lower change hands; each interval is tested by Routh."
  echo layout,b,k_s,c_lo,c_hi,width,V_lo,V_hi,lower,upper,limit
  cat build/tables/widths.fig*.csv; } | replace_from results/widths.csv

awk -f scripts/targets.awk results/special_points.csv results/fig06.csv results/fig07.csv tests/targets.csv \
  | replace_from results/targets.csv

awk -F, '
  /^#/ { next }
  { printf "%-10s %-48s %-11s %14s %14s %14s  %-10s %s\n", $1, $2, $3, $4, $5, $6, $7, $8 }
  $8 == "no" { missed++ }
  END { if (missed) { print missed " target(s) missed" > "/dev/stderr"; exit 1 } }' results/targets.csv
