#!/usr/bin/env bash
# Least damping ratios of straight rolling, every layout (docs/damping.md)
#
#   scripts/studies/damping.sh      all of it
#   scripts/studies/damping.sh runs [planes | search] | tables | draw
#
# Needs:  results/widths.csv
# Writes: results/damping.csv, results/damping.png and .svg;
#         build/tables/damping.*.csv, the maps of the picture
# Expect: 2.7e-5 at best for L1, 9.6e-5 for L2, 1.7e-4 for LI1 and 7.9e-4 for LI2 at
#         b = 140 N m s^2/rad, over b 2.7e-4 for LI1 at b = 99 and 9.9e-4 for LI2 at 300, always
#         lost in the delta mode.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

# made NAME for layouts: made again when their damping may be another
of() { # NAME LAYOUT[,LAYOUT...] COMMAND...
  local files=() layout
  for layout in ${2//,/ }; do
    mapfile -t -O ${#files[@]} files < <(sources "$layout" "${algebra[@]}" models/libmlg/{damping,eigenvalues}.c)
  done
  made "damping.$1" "${files[@]}" scripts/mlg/gear/{damping,designs}.c -- "${@:3}"
}

plane() { # LAYOUT K_S B
  of "$1" "$1" mlg damping "$1" k_s="$2" b="$3" c_d=100:8e4:160 V=0.5:200:160
}

runs_planes() {
  plane l1 inf 0
  plane l2 4.755e5 0
  plane li1 3.048e5 140
  plane li2 1.4046e6 140
  of l1.c_d l1 mlg damping l1 c_d=2700:3100:201
  of l2.k_s l2 mlg damping l2 k_s=2.86e5:2e6:90 c_d=2e3:3e4:90
  of li1.k_s li1 mlg damping li1 b=140 k_s=2.86e5:2e6:90 c_d=2e3:3e4:90
  of li2.k_s li2 mlg damping li2 b=140 k_s=2.86e5:4e6:90 c_d=2e3:3e4:90
}

names=layout,choice,b,k_s,c_d,zeta,V,frequency_hz,shimmy,t_5

# Rows of these names: what is in CELLS, then what `mlg damping WORD...` prints
row() { # CELLS WORD...
  mlg damping "${@:2}" | sed "1d; s/^/$1,/"
}

best() {
  local b
  echo $names
  row l2,best,0 l2 best
  for b in $(seq 0 20 180); do row "li1,best,$b" li1 best b="$b"; done
  row li1,over_b li1 best b_most=300
  for b in $(seq 0 20 300); do row "li2,best,$b" li2 best b="$b"; done
  row li2,over_b li2 best b_most=300
}

runs_search() { of best l2,li1,li2 best; }

# The gears of one layout whose k_s is known
known() { # LAYOUT
  local k_s b c_lo c_hi c_d
  paper_gear "$1"
  c_d=$(awk -v lo="$c_lo" -v hi="$c_hi" 'BEGIN { printf "%.6g", (lo + hi) / 2 }')
  row "$1,middle,$b,$k_s,$c_d" "$1" k_s="$k_s" b="$b" c_d="$c_d"
  row "$1,paper,$b,$k_s" "$1" best k_s="$k_s" b="$b"
  while IFS=, read -r b k_s; do
    [[ ! $b =~ ^[0-9]*[02468]0$|^0$ ]] || row "$1,widest,$b,$k_s" "$1" best k_s="$k_s" b="$b"
  done < <(mlg pick results/widths.csv where=layout="$1" where='width>0' columns=b,k_s)
}

tables() {
  local layout all=build/tables/damping.rows.csv
  begin_table results/damping.csv \
    "# The least damping ratio zeta = -Re(s)/|s| over V in 0.3..200 m/s, exactly. choice: middle of the paper's zero-shimmy" \
    "# interval of c_d; paper, the best c_d at the paper's k_s; widest, that at the k_s of the widest interval at that b;" \
    "# best, the best c_d and k_s; over_b, the best c_d, k_s and b in 0..300. b N m s^2/rad, k_s N m/rad (inf: rigid)," \
    "# c_d N m s/rad; V m/s, frequency_hz Hz and shimmy of that mode, of that of delta where two share zeta; t_5 s, the time" \
    "# in which it decays to 5 %."
  {
    echo $names
    for layout in l1 l2 li1 li2; do
      known "$layout"
      mlg pick build/tables/damping.best.csv where=layout=$layout
    done
  } > "$all"
  mlg pick "$all" head columns=layout,choice,b,k_s,c_d:.7g,zeta:.4g,V:.4g,frequency_hz:.6g,shimmy,t_5:.4g >> "$table.new"
  replace "$table"
}

main damping "$@"
