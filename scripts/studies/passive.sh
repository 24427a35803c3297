#!/usr/bin/env bash
# What no passive device can do: the largest damping ratio by order of the device, and which
# change of the gear would bring what is usually asked for (docs/networks.md)
#
#   scripts/studies/passive.sh      all of it
#   scripts/studies/passive.sh runs [180e3 | 200e3 | 220e3 | any_180e3 | any_200e3 | any_220e3 | fast | gears]
#   scripts/studies/passive.sh tables | draw
#
# The search over devices takes a minute or two for each load, N; what was found of each order stays.
#
# Writes: results/passive.csv, results/passive.png and .svg; build/tables/passive.*.csv
# Expect: at 200 kN 2.70e-5 for order 1 (L1), 2.93e-3 for order 4, near the strut's own 2.77e-3, and 3.18e-3 and 3.19e-3 for orders 6 and 7;
#         0.0735 far from all: c_delta of 27.5 times its value would be needed.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

gear=(models/{mlg,network,linearised}.h models/libmlg/{best_ratio,cma,crossing,crossing_roots}.c)
delta=("${gear[@]}" scripts/mlg/gear/deltamode.c)
search=("${gear[@]}" models/libmlg/{device_layout,device_text}.c scripts/mlg/gear/{passive.c,positive_real.c,positive_real.h,bfgs.c,bfgs.h})
readonly loads=(180e3 200e3 220e3) most=7 names=(c_delta c_psi e l phi l_delta)

# Order after order, each from the table of those below it: an interrupted search goes on there.
orders() { # NAME WORD...
  local n before=() from=()
  for ((n = 1; n <= most; n++)); do
    made "passive.$1.$n" "${search[@]}" "${before[@]}" -- mlg passive "${@:2}" order="$n" "${from[@]}"
    before=("build/tables/passive.$1.$n.csv") from=(from="build/tables/passive.$1.$n.csv")
  done
}

at_load() { # F_Z
  made "passive.$1.delta" "${delta[@]}" -- mlg deltamode F_z="$1"
  orders "$1.order" F_z="$1"
}

runs_180e3() { at_load 180e3; }
runs_200e3() { at_load 200e3; }
runs_220e3() { at_load 220e3; }
runs_any_180e3() { orders 180e3.any F_z=180e3 K_least=0; }
runs_any_200e3() { orders 200e3.any F_z=200e3 K_least=0; }
runs_any_220e3() { orders 220e3.any F_z=220e3 K_least=0; }
runs_fast() { orders 200e3.fast F_z=200e3 V_least=10; }

# Each parameter of the gear times a factor: what the delta mode and the best L1 come to
changed() {
  local name value factor zeta
  echo name,factor,value,strut,locked,any,l1
  for name in "${names[@]}"; do
    for factor in 0.25 0.5 1 2 4 8 16 32; do
      value=$(mlg gearinfo | awk -F, -v name="$name" -v factor=$factor '$1 == name { printf "%.10g", factor * $2 }')
      zeta=$(mlg deltamode "$name=$value" 2> /dev/null | awk -F, 'NR > 2 { printf "%s,", $2 }')
      echo "$name,$factor,$value,${zeta:-,,,}$(mlg damping l1 best "$name=$value" 2> /dev/null | awk -F, 'NR == 2 { print $2 }')"
    done
  done
}

runs_gears() { made passive.gears "${delta[@]}" "${algebra[@]}" -- changed; }

tables() {
  local F_z of
  begin_table results/passive.csv \
    "# The largest least damping ratio zeta over V in 0.3..200 m/s of any passive device behind k_psi (docs/networks.md)." \
    "# case order: of order n, with a static stiffness of at least k_d, x = n; any: with any static stiffness; fast: as order," \
    "# V from 10 m/s. zeta is at V, m/s, of the mode of frequency_hz and shimmy. met of starts came within 1 % of the best; which" \
    "# rows are of which starts: docs/networks.md. K static stiffness, Z dynamic stiffness at 17.5 Hz, N m/rad. delta: the delta" \
    "# mode alone, wheels locked in torsion (locked) or with the best complex Z (any), and the strut without tyre (strut). gear: a" \
    "# parameter of the gear times x, at 200 kN, for these and the best L1 (l1). F_z N. num, den: coefficients of Z, powers of s rising, SI."
  {
    echo case,F_z,what,x,zeta,V,frequency_hz,shimmy,K,Z_re,Z_im,met,starts,num,den
    for F_z in "${loads[@]}"; do
      for of in order any fast; do
        [ -f "build/tables/passive.$F_z.$of.$most.csv" ] || continue # fast at one load alone
        awk -F, -v OFS=, -v F_z="$F_z" -v of=$of '$1 ~ /^[1-9]/ { print of, F_z, "passive", $1, sprintf("%.5g,%.5g,%.6g", $2, $3, $4), $5,
          sprintf("%.6g,%.6g,%.6g", $6, $7, $8), $9, $10, $12, $13 }' "build/tables/passive.$F_z.$of.$most.csv"
      done
      awk -F, -v OFS=, -v F_z="$F_z" 'NR > 2 { print "delta", F_z, $1, "", sprintf("%.5g", $2), $1 == "strut" ? "" : sprintf("%.5g", $3), "", "delta", "",
        $1 == "any" ? sprintf("%.6g,%.6g", $4, $5) : ",", "", "", "", "" }' "build/tables/passive.$F_z.delta.csv"
    done
    awk -F, -v OFS=, 'NR == 1 { for (k = 4; k <= NF; k++) what[k] = $k; next }
      { for (k = 4; k <= NF; k++) if ($k != "") print "gear", "200e3", $1 " " what[k], $2, sprintf("%.5g", $k), "", "", "", "", "", "", "", "", "", "" }' \
      build/tables/passive.gears.csv
  } >> "$table.new"
  replace "$table"
}

main passive "$@"
