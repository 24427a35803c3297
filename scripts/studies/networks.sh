#!/usr/bin/env bash
# Every small network: its best designs, ranked (docs/networks.md)
#
#   scripts/studies/networks.sh      all of it
#   scripts/studies/networks.sh runs [width | small | larger | inertance] | tables | draw
#
# Searches for each network, up to half a minute; what was interrupted goes on with the networks that are left.
#
# Writes: results/networks.csv, results/networks_larger.csv, results/networks_b.csv, results/networks.svg, results/networks_larger.svg; build/tables/networks.*.csv
# Expect: 35 networks; width 264.6269 of L1, 10226.87 of L2, 11244.367 of LI1 at b = 140.4708,
#         and 22354 of LI2 at b = 300, which is the widest of all.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"

search=(models/{mlg,network}.h "${algebra[@]}" models/libmlg/{cma,device_layout,device_text,free,mode,tolerance}.c
  scripts/mlg/gear/{explore,explore_interval,explore_load,explore_tolerance,explorer,weakest}.c)

# NUMBER NETWORK LAYOUT of each, as mlg networks has them
each_network() {
  mlg networks | awk -F, '/^[0-9]/ { print $1, $2, $7 == "" ? "-" : $7 }'
}

runs_width() {
  local number network rest
  while read -r number network rest; do
    made "networks.width.$number" "${search[@]}" -- mlg explore "$network" width ratio
  done < <(each_network)
}

# From the widest intervals, which runs_width made, and from random places
runs_small() {
  local number network rest
  while read -r number network rest; do
    made "networks.$number" "${search[@]}" "build/tables/networks.width.$number.csv" -- \
      mlg explore "$network" zeta load tolerance starts=12 "begin=build/tables/networks.width.$number.csv"
  done < <(each_network)
}

# NUMBER NETWORK FREE of each of the larger family that differs from those before it, those of the largest zeta on record first
each_larger() {
  made networks.larger models/libmlg/device_text.c scripts/mlg/gear/{networks,network_same}.c -- mlg networks larger same >&2
  awk -F, '
    /^[0-9]/ && $5 == $1 { network[++n] = $1; row[$1] = $1 " " $2 " " $4 }
    $1 == "zeta" && $3 in row { print row[$3]; delete row[$3] }
    END { for (i = 1; i <= n; i++) if (network[i] in row) print row[network[i]] }' \
    build/tables/networks.larger.csv results/networks_larger.csv
}

# Designs to begin at: those of results/networks.csv of each smaller network that this one becomes at an end of an element, of
# tolerances, which take long, the best of them, and its own of the quantity that was searched before
begin_larger() { # NUMBER FREE QUANTITY
  local begin=build/tables/networks.begin.$3.$1.csv
  awk -F, -v OFS=, -v number="$1" -v free="$2" -v quantity="$3" '
    function low(element) { return element ~ /^k/ ? 1e4 : 10 }
    function high(element) { return element ~ /^k/ ? 1e9 : 1e7 }
    BEGIN { print "k_s,b,c_lo,c_hi," free }
    FILENAME ~ /limits/ { if ($1 == number) { m++; element[m] = $3; end[m] = $4 == "inf" ? high($3) : low($3); limit[m] = $5 } next }
    FILENAME ~ /results/ && ($1 == quantity || $1 == "zeta" && quantity == "load") {
      for (i = 1; i <= m; i++) if (limit[i] == $3) {
        k_s = $7 == "" ? 1e6 : $7; b = $8 + 0; lo = $9; hi = $10; other = end[i]
        if (element[i] == "k_s") { other = k_s; k_s = end[i] }
        if (element[i] == "c_d") { other = sqrt(lo * hi); lo = hi = end[i] }
        if (quantity != "tolerance") print k_s, b, lo, hi, other
        else if ($6 > most) { most = $6; best = k_s OFS b OFS lo OFS hi OFS other } } }
    FILENAME ~ /larger/ && ($1 == "zeta" || $1 == "load") { print $3 ~ /inf/ ? 1e6 : $3, $4, $5, $6, $10 }
    END { if (best != "") print best }' \
    build/tables/networks.limits.csv results/networks.csv "${@:4}" > "$begin.new"
  cmp -s "$begin.new" "$begin" || mv "$begin.new" "$begin"
  rm -f "$begin.new"
  echo "$begin"
}

# One quantity of networks NUMBER NETWORK FREE of standard input: starts at random beside those at designs that are given
search_larger() { # QUANTITY STARTS
  local quantity=$1 starts=$2 number network free begin before
  while read -r number network free; do
    case $quantity in zeta) before=() ;; tolerance) before=("build/tables/networks.larger.load.$number.csv") ;; *) before=("build/tables/networks.larger.zeta.$number.csv") ;; esac
    begin=$(begin_larger "$number" "$free" "$quantity" "${before[@]}")
    made "networks.larger.$quantity.$number" "${search[@]}" "$begin" -- \
      mlg explore "$network" "$quantity" free="$free" starts="$starts" begin="$begin"
  done
}

# NETWORK with another VALUE of its element NAME=VALUE
with_value() { # NETWORK NAME VALUE
  local behind=${1#*"$2"=}
  echo "${1%%"$2"=*}$2=$3${behind#"${behind%%[!0-9.e]*}"}"
}

# mlg loads as far as its answers are sure, which where c_d is 1e7 they may not be at the last one
sure_loads() {
  mlg loads "$@" || [ $? -eq 1 ]
}

# Loads, 1 kN apart, below the largest that a design bears: at which of them does it shimmy?
loads_larger() {
  local number network free load k_s b c_d other words
  while read -r number network free; do
    IFS=, read -r load k_s b c_d other < <(awk -F, -v OFS=, '$1 == "load" { print $2, $3, $4, $5, $10 }' "build/tables/networks.larger.load.$number.csv") || continue
    words=(c_d="$c_d")
    case $network in *k_s*) words+=(k_s="$k_s") ;; esac
    case "($network)" in *[\(\)\|-]b[\(\)\|-]*) words+=(b="$b") ;; esac
    made "networks.larger.loads.$number" models/libmlg/free.c scripts/mlg/gear/loads.c -- \
      sure_loads "$(with_value "$network" "$free" "$other")" "${words[@]}" step=1e3 to="$load" \
      from="$(awk "BEGIN { printf \"%.10g\", $load - 1e3 * int($load / 1e3 - 20) }")"
  done
}

# The least of these loads from which on it does not, N
load_from() { # NUMBER
  [ -e "build/tables/networks.larger.loads.$1.csv" ] || return 0
  awk -F, '/^[0-9]/ { if (!($9 > -1e-7)) from = ""; else if (from == "") from = $1 } END { print from }' "build/tables/networks.larger.loads.$1.csv"
}

# Of networks NUMBER NETWORK FREE those whose value of a quantity is above LEAST, by falling value
larger_above() { # QUANTITY LEAST
  local number network free
  while read -r number network free; do
    awk -F, -v quantity="$1" -v least="$2" -v number="$number" -v network="$network" -v free="$free" '
      $1 == quantity && $2 > least { print number, network, free, $2 }' "build/tables/networks.larger.$1.$number.csv"
  done | sort -k4,4gr -k1,1n | cut -d ' ' -f 1-3
}

# Two dampers, or two springs beside k_d: zeta of all, width where a damping ratio is above 0, load and hi/lo of the best damped,
# tolerance of those that bear 224 kN, nearly what LI3 does
runs_larger() {
  local damped=build/tables/networks.damped.txt best=build/tables/networks.best.txt strong=build/tables/networks.strong.txt
  made networks.limits models/libmlg/device_text.c scripts/mlg/gear/{networks,network_limits}.c -- mlg networks larger limits
  each_larger | search_larger zeta 10
  each_larger | larger_above zeta 0 > $damped
  search_larger width 3 < $damped
  head -n 60 $damped > $best
  search_larger load 5 < $best
  loads_larger < $best
  larger_above load 224e3 < $best > $strong
  search_larger tolerance 2 < $strong
  search_larger ratio 2 < $best
}

# With how little inertance: LI2, LI3 and the best of the larger family with b up to each of these, N m s^2/rad
inertances=(10 20 30 50 100 300)

# NETWORK and the element that is free, or nothing
each_inertance() {
  printf '%s\n' '(k_s|b)-(k_d|c_d) -' '(k_s-(k_d|c_d))|b -' '((k_s-b)|k_2=2e6)-(k_d|c_d) k_2'
}

runs_inertance() {
  local network free b n=0 words
  while read -r network free; do
    n=$((n + 1)) words=()
    if [ "$free" != - ]; then words=(free="$free"); fi
    for b in "${inertances[@]}"; do
      made "networks.inertance.$n.$b" "${search[@]}" -- mlg explore "$network" zeta tolerance b_most="$b" starts=5 "${words[@]}"
    done
  done < <(each_inertance)
}

# Rows of one quantity by falling value, with rank, network, layout and static stiffness
ranked() { # QUANTITY
  local number network layout
  while read -r number network layout; do
    awk -F, -v OFS=, -v quantity="$1" -v number="$number" -v network="$network" -v layout="${layout#-}" '
      $1 == quantity {
        print number, network, layout, sprintf("%.7g", $2), $3 == "inf" ? "" : sprintf("%.7g", $3),
          network ~ /(^|[^_a-z])b($|[^_a-z])/ ? sprintf("%.6g", $4) : "", sprintf("%.7g", $5), sprintf("%.7g", $6),
          sprintf("%.6g", $10), $7, $8, ($7 > 1 || ($8 == 1 && quantity ~ /width|ratio/) ? "yes" : "no") }' build/tables/networks.{width.,}"$number.csv"
  done < <(each_network) | sort -t, -k4,4gr -k1,1n | awk -v OFS=, -v quantity="$1" '{ print quantity, NR, $0 }'
}

# The same of the larger family, with the load from which on a design of a largest load is free of shimmy
ranked_larger() { # QUANTITY
  local number network free found from
  while read -r number network free; do
    found=build/tables/networks.larger.$1.$number.csv from=
    [ -e "$found" ] || continue # not searched
    if [ "$1" = load ]; then from=$(load_from "$number"); fi
    awk -F, -v OFS=, -v quantity="$1" -v number="$number" -v network="$network" -v free="$free" -v from="$from" '
      $1 == quantity {
        sub(/=[0-9.e]+/, "", network)
        print number, network, free, sprintf("%.7g", $2), $3 == "inf" ? "" : sprintf("%.7g", $3),
          network ~ /(^|[^_a-z])b($|[^_a-z])/ ? sprintf("%.6g", $4) : "", sprintf("%.7g", $10), sprintf("%.7g", $5),
          sprintf("%.7g", $6), sprintf("%.6g", $11), from == "" ? "" : sprintf("%.6g", from), $7, $8, ($7 > 1 ? "yes" : "no") }' "$found"
  done < <(each_larger) | sort -t, -k4,4gr -k1,1n | awk -v OFS=, -v quantity="$1" '{ print quantity, NR, $0 }'
}

# Rows of what inertance buys
by_inertance() { # QUANTITY
  local network free b n=0
  while read -r network free; do
    n=$((n + 1))
    for b in "${inertances[@]}"; do
      awk -F, -v OFS=, -v quantity="$1" -v network="$network" -v free="${free#-}" -v b="$b" '
        $1 == quantity {
          sub(/=[0-9.e]+/, "", network)
          print quantity, network, free, b, sprintf("%.7g", $2), sprintf("%.7g", $3), sprintf("%.6g", $4), free == "" ? "" : sprintf("%.7g", $10),
            sprintf("%.7g", $5), sprintf("%.6g", $NF), $7, $8 }' "build/tables/networks.inertance.$n.$b.csv"
    done
  done < <(each_inertance)
}

larger_searched() { # QUANTITY
  find build/tables -name "networks.larger.$1.[0-9]*.csv" | wc -l
}

lines() { # damped, best or strong
  wc -l < "build/tables/networks.$1.txt"
}

tables() {
  local quantity
  begin_table results/networks.csv \
    "# Every series-parallel network of k_d, c_d and at most one of each of k_s and b that has a path of springs, behind k_psi" \
    "# (docs/networks.md): the best designs by a search over k_s from 1e4 (k_d, where k_s carries alone) to 1e9 N m/rad, b from 0" \
    "# to 300 N m s^2/rad and all c_d, ranked. quantity: width, N m s/rad, and ratio of the zero-shimmy interval c_lo to c_hi where" \
    "# that is largest, exact over k_s, b to 1e-8 of its range; zeta, the largest least damping ratio over V in 0.3..200 m/s;" \
    "# load, N, the largest static load at which a design has no shimmy; tolerance p, %, by all corners; these where met good to" \
    "# 1e-6. static N m/rad, without k_psi. met of starts: how many came within 1 % of the best, of a load within 0.1 %;" \
    "# converged: two at least, or there is nothing to start from but c_d and k_s; else the value is a bound from below."
  {
    echo quantity,rank,number,network,layout,value,k_s,b,c_lo,c_hi,static,met,starts,converged
    for quantity in width ratio zeta load tolerance; do ranked $quantity; done
  } >> "$table.new"
  replace "$table"

  begin_table results/networks_larger.csv \
    "# Series-parallel networks with a second damper c_2, or with a spring k_2 beside k_s, of those with the same dynamic stiffnesses" \
    "# the first (docs/networks.md), searched as results/networks.csv: k_2 as k_s, c_2 as c_d. number: of mlg networks larger." \
    "# other: c_2 N m s/rad, k_2 N m/rad. width, ratio: of c_d, the other damper held, inf where no c_d is too large, or for the" \
    "# ratio too small. zeta of all, width where that is above 0, ratio and load of the 60 best damped, tolerance of those that bear" \
    "# 224 kN; it is one of c_2 or k_2 as well. from, N: of the loads 1 kN apart the least from which on the design has no shimmy" \
    "# up to its largest. met of starts, ten for zeta, five for load, two or three for all else at random, the others from the" \
    "# designs of smaller networks and of other quantities; converged: two met. Searched: zeta of $(larger_searched zeta) of" \
    "# $(each_larger | wc -l), width $(larger_searched width) of $(lines damped), ratio $(larger_searched ratio) and load $(larger_searched load) of $(lines best), tolerance $(larger_searched tolerance) of $(lines strong)."
  {
    echo quantity,rank,number,network,free,value,k_s,b,other,c_lo,c_hi,static,from,met,starts,converged
    for quantity in zeta width ratio load tolerance; do ranked_larger $quantity; done
  } >> "$table.new"
  replace "$table"

  begin_table results/networks_b.csv \
    "# Least damping ratio zeta over V in 0.3..200 m/s and tolerance p, %, of the best designs with an inertance b up to b_most, N m s^2/rad:" \
    "# networks of results/networks.csv, and with a spring k_2 more of results/networks_larger.csv, searched likewise; tolerance of" \
    "# k_2, other, too. k_s, other, static N m/rad, without k_psi; c_d N m s/rad; met of starts: within 1 % of the best."
  {
    echo quantity,network,free,b_most,value,k_s,b,other,c_d,static,met,starts
    for quantity in zeta tolerance; do by_inertance $quantity; done
  } >> "$table.new"
  replace "$table"
}

# NETWORK,CAPTION... of those of the larger family that are among the first five by a damping ratio, a finite width, a load or a
# tolerance, by falling load
best_larger() {
  awk -F, '
    /^#/ || $1 == "quantity" || $6 == "inf" { next }
    { value[$1, $3] = $6; if (++n[$1] <= 5 && $1 != "ratio") chosen[$3] = 1 }
    $1 == "load" { text[$3] = $4; drawn[$3] = $4; sub($5, sprintf("%s=%.2g", $5, $9), drawn[$3]); order[++m] = $3 }
    function of(quantity, k, format, factor) {
      return (quantity SUBSEP k) in value ? sprintf(format, value[quantity, k] * factor) : "-" }
    END {
      for (i = 1; i <= m; i++) if ((k = order[i]) in chosen)
        printf "%s,%d. %s,load %s kN; tolerance %s %%,zeta %s; width %s\n", drawn[k], ++shown, text[k], of("load", k, "%.1f", 1e-3),
          of("tolerance", k, "%.3g", 1), of("zeta", k, "%.3g", 1), of("width", k, "%.6g", 1) }' results/networks_larger.csv
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
  best_larger | mlg drawings | sed 's/>2=[^<]*</>2</' > build/networks_larger.svg # designs differ by quantity
  mv build/networks_larger.svg results/networks_larger.svg
}

main networks "$@"
