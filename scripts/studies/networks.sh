#!/usr/bin/env bash
# Every small network: its best designs, ranked (docs/networks.md)
#
#   scripts/studies/networks.sh      all of it
#   scripts/studies/networks.sh runs [small | larger] | tables | draw
#
# One search for each network, up to a minute; what was interrupted goes on with the networks that are left.
#
# Writes: results/networks.csv, results/networks_larger.csv, results/networks.svg; build/tables/networks.*.csv
# Expect: 35 networks; width 264.6269 of L1, 10226.87 of L2, 11244.367 of LI1 at b = 140.4708,
#         and 22354 of LI2 at b = 300, which is the widest of all.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

search=(models/{mlg,network,linearised}.h
  models/libmlg/{best_ratio,boundary_points,climb,cma,crossing,crossing_extrema,crossing_roots,device_layout,device_text,free,mode,tolerance,widest}.c
  scripts/mlg/gear/{explore,explore_interval,explore_load,explore_tolerance,explorer,weakest}.c)

# NUMBER NETWORK PATH LAYOUT of each, as mlg networks has them
each_network() {
  mlg networks | awk -F, '/^[0-9]/ { print $1, $2, $4, $7 == "" ? "-" : $7 }'
}

runs_small() {
  local number network rest
  while read -r number network rest; do
    made "networks.$number" "${search[@]}" -- mlg explore "$network" starts=12
  done < <(each_network)
}

# NUMBER NETWORK FREE of each of the larger family that differs from those before it
each_larger() {
  made networks.larger models/libmlg/device_text.c scripts/mlg/gear/{networks,network_same}.c -- mlg networks larger same >&2
  awk -F, '/^[0-9]/ && $5 == $1 { print $1, $2, $4 }' build/tables/networks.larger.csv
}

# Two dampers, or two springs beside k_d: two starts
runs_larger() {
  local number network free
  while read -r number network free; do
    made "networks.larger.$number" "${search[@]}" -- \
      mlg explore "$network" zeta width free="$free" starts=2
  done < <(each_larger)
}

# Rows of one quantity by falling value, with rank, network, layout and static stiffness
ranked() { # QUANTITY
  local number network path layout
  while read -r number network path layout; do
    awk -F, -v OFS=, -v quantity="$1" -v number="$number" -v network="$network" -v path="$path" -v layout="${layout#-}" '
      $1 == quantity {
        k_d = 1.09e5
        k = path == "k_d" ? k_d : path == "k_s" ? $3 : path == "k_d|k_s" ? k_d + $3 : k_d * $3 / (k_d + $3)
        print number, network, layout, sprintf("%.7g", $2), $3 == "inf" ? "" : sprintf("%.7g", $3),
          network ~ /(^|[^_a-z])b($|[^_a-z])/ ? sprintf("%.6g", $4) : "", sprintf("%.7g", $5), sprintf("%.7g", $6),
          sprintf("%.6g", k), $7, $8, ($7 > 1 || ($8 == 1 && quantity ~ /width|ratio/) ? "yes" : "no") }' "build/tables/networks.$number.csv"
  done < <(each_network) | sort -t, -k4,4gr -k1,1n | awk -v OFS=, -v quantity="$1" '{ print quantity, NR, $0 }'
}

# The same of the larger family
ranked_larger() { # QUANTITY
  local number network free
  while read -r number network free; do
    [ -e "build/tables/networks.larger.$number.csv" ] || continue # not searched yet
    awk -F, -v OFS=, -v quantity="$1" -v number="$number" -v network="$network" -v free="$free" '
      $1 == quantity {
        sub(/=[0-9.e]+/, "", network)
        print number, network, free, sprintf("%.7g", $2), $3 == "inf" ? "" : sprintf("%.7g", $3),
          network ~ /(^|[^_a-z])b($|[^_a-z])/ ? sprintf("%.6g", $4) : "", sprintf("%.7g", $10), sprintf("%.7g", $5),
          sprintf("%.7g", $6), $7, $8, ($7 > 1 ? "yes" : "no") }' "build/tables/networks.larger.$number.csv"
  done < <(each_larger) | sort -t, -k4,4gr -k1,1n | awk -v OFS=, -v quantity="$1" '{ print quantity, NR, $0 }'
}

tables() {
  local quantity
  begin_table results/networks.csv \
    "# Every series-parallel network of k_d, c_d and at most one of each of k_s and b that has a path of springs, behind k_psi" \
    "# (docs/networks.md): the best designs by a search over k_s from 1e4 (k_d, where k_s carries alone) to 1e9 N m/rad, b from 0" \
    "# to 300 N m s^2/rad and all c_d, ranked. quantity: width, N m s/rad, and ratio of the zero-shimmy interval c_lo to c_hi where" \
    "# that is largest, exact over k_s, b to 1e-8 of its range; zeta, the largest least damping ratio over V in 0.3..200 m/s," \
    "# good to 0.1 %; load, N, the largest static load at which a design has no shimmy; tolerance p, %, by all corners. static" \
    "# N m/rad, without k_psi. met of starts: how many came within 1 % of the best, of a load within 0.1 %; converged: two at" \
    "# least, or there is nothing to start from but c_d and k_s; else the value is a bound from below."
  {
    echo quantity,rank,number,network,layout,value,k_s,b,c_lo,c_hi,static,met,starts,converged
    for quantity in width ratio zeta load tolerance; do ranked $quantity; done
  } >> "$table.new"
  replace "$table"

  begin_table results/networks_larger.csv \
    "# Series-parallel networks with a second damper c_2, or with a spring k_2 beside k_s, of those with the same dynamic stiffnesses" \
    "# the first (docs/networks.md), searched as results/networks.csv: k_2 as k_s, c_2 as c_d. number: of mlg networks larger." \
    "# other: c_2 N m s/rad, k_2 N m/rad; width: of c_d, the other damper held, inf where no c_d is too large; of damping ratios" \
    "# above 0 alone. met of two starts; converged: both. Searched: $(find build/tables -name 'networks.larger.[0-9]*.csv' | wc -l) of $(each_larger | wc -l)."
  {
    echo quantity,rank,number,network,free,value,k_s,b,other,c_lo,c_hi,met,starts,converged
    for quantity in zeta width; do ranked_larger $quantity; done
  } >> "$table.new"
  replace "$table"
}

draw() {
  awk -F, '
    /^#/ || $1 == "quantity" { next }
    { value[$1, $3] = $6; if ($1 == "zeta") { text[$3] = $4; layout[$3] = toupper($5) } }
    $1 == "width" { order[++m] = $3; wide[$3] = 1 }
    $1 == "zeta" && !($3 in wide) { order[++m] = $3 }
    END {
      for (i = 1; i <= m; i++) {
        k = order[i]
        printf "%s,%d. %s %s,width %s; zeta %.3g,load %.1f kN%s\n", text[k], i, text[k], layout[k],
          ("width" SUBSEP k) in value ? sprintf("%.6g", value["width", k]) : "none", value["zeta", k], value["load", k] / 1e3,
          ("tolerance" SUBSEP k) in value ? sprintf("; tolerance %.3g %%", value["tolerance", k]) : "" } }' \
    results/networks.csv | mlg drawings > build/networks.svg
  mv build/networks.svg results/networks.svg
}

main networks "$@"
