# elasticities.gp - tornado charts of results/elasticities.csv (scripts/studies/design.sh)
set datafile missing ""
layouts = "l1 l2 li1 li2"
array title[4] = ["L1", "L2", "LI1", "LI2"]
array heading[3] = ["the paper's", "most tolerant", "most tolerant: least ζ"]
designs = "paper tolerant tolerant"
array most[3] = [7, 7, 150] # of an axis, %
# the parameters by the largest effect on a bound of c_d of the most tolerant LI2; M and g are F_z
order = system("build/bin/mlg pick results/elasticities.csv where=layout=li2 where=design=tolerant columns=parameter,c_lo,c_hi | awk -F, '$2 != \"\" && $1 != \"M\" && $1 != \"g\" { a = $2 < 0 ? -$2 : $2; b = $3 < 0 ? -$3 : $3; if (a > b) b = a; if (b > 1e-6) print b, $1 }' | sort -g | awk '{ printf \"%s \", $2 }'")
n = words(order)
place(name) = sum [i=1:n] (word(order, i) eq name ? i : 0)
at(name, shift) = place(name) > 0 ? place(name) + shift : NaN
rows(layout, design) = pick(sprintf("results/elasticities.csv where=layout=%s where=design=%s columns=parameter,c_lo,c_hi,zeta", layout, design))
cut(x, most) = abs(x) > most ? sgn(x)*most : x
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1500 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1500 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set style fill solid 0.85 noborder
  set yrange [0.3:n + 0.7]
  do for [row=1:3] { do for [panel=1:4] {
    data = rows(word(layouts, panel), word(designs, row))
    limit = most[row]
    set lmargin at screen 0.075 + 0.235*(panel - 1); set rmargin at screen 0.285 + 0.235*(panel - 1)
    set tmargin at screen 0.97 - 0.33*(row - 1); set bmargin at screen 0.705 - 0.33*(row - 1)
    set title title[panel].", ".heading[row] offset 0,-0.6
    set xrange [-limit:limit]
    if (row < 3) { set xtics 2 } else { set xtics 100 }
    set xlabel (row < 3 ? "% of c_d for 1 %" : "% of ζ for 1 %") offset 0,0.5
    unset ytics
    if (panel == 1) { set ytics noenhanced scale 0; do for [i=1:n] { set ytics add (word(order, i) i) } } \
    else { set ytics scale 0; do for [i=1:n] { set ytics add ("" i) } }
    set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb "#999999"
    if (panel == 2 && row < 3) { set key on bottom right Left reverse samplen 1 } else { unset key }
    if (row < 3) {
      plot data using (cut($2, limit)/2.):(at(strcol(1), 0.18)):(abs(cut($2, limit))/2.):(0.16) with boxxyerror lc rgb "#1f4fd8" title "lower bound", \
           data using (cut($3, limit)/2.):(at(strcol(1), -0.18)):(abs(cut($3, limit))/2.):(0.16) with boxxyerror lc rgb "#e08214" title "upper bound", \
           data using (abs($2) > limit ? -sgn($2)*0.12*limit : NaN):(at(strcol(1), 0.18)):(sprintf("%.0f", $2)) with labels font ",10" notitle, \
           data using (abs($3) > limit ? -sgn($3)*0.25*limit : NaN):(at(strcol(1), -0.18)):(sprintf("%.0f", $3)) with labels font ",10" notitle
    } else {
      plot data using (cut($4, limit)/2.):(at(strcol(1), 0)):(abs(cut($4, limit))/2.):(0.3) with boxxyerror lc rgb "#2a9d5c" notitle, \
           data using (abs($4) > limit ? -sgn($4)*0.15*limit : NaN):(at(strcol(1), 0)):(sprintf("%.0f", $4)) with labels font ",10" notitle
    }
  } }
  unset multiplot
  unset output
}
