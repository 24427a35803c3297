# elasticities.gp - tornado charts of results/elasticities.csv (scripts/studies/design.sh): a row for each
# layout, the paper's design or that of its own widest interval and the most tolerant one
set datafile missing ""
layouts = layouts_of("results/elasticities.csv")
rows_of = words(layouts)
has(layout, design) = system(sprintf("grep -c '^%s,%s,' results/elasticities.csv", layout, design)) + 0
given(layout) = has(layout, "paper") ? "paper" : "own"
array heading[3] = ["", "most tolerant", "most tolerant: least ζ"]
array most[3] = [7, 7, 150] # of an axis, %
# the parameters by the largest effect on a bound of c_d of the most tolerant LI2; M and g are F_z
order = system("build/bin/mlg pick results/elasticities.csv where=layout=li2 where=design=tolerant columns=parameter,c_lo,c_hi | awk -F, '$2 != \"\" && $1 != \"M\" && $1 != \"g\" { a = $2 < 0 ? -$2 : $2; b = $3 < 0 ? -$3 : $3; if (a > b) b = a; if (b > 1e-6) print b, $1 }' | sort -g | awk '{ printf \"%s \", $2 }'")
n = words(order)
place(name) = sum [i=1:n] (word(order, i) eq name ? i : 0)
at(name, shift) = place(name) > 0 ? place(name) + shift : NaN
rows(layout, design) = pick(sprintf("results/elasticities.csv where=layout=%s where=design=%s columns=parameter,c_lo,c_hi,zeta", layout, design))
cut(x, most) = abs(x) > most ? sgn(x)*most : x
height = 0.985/rows_of
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,400*rows_of font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,400*rows_of font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set style fill solid 0.85 noborder
  set yrange [0.3:n + 0.7]
  do for [row=1:rows_of] { do for [panel=1:3] {
    layout = word(layouts, row)
    data = rows(layout, panel == 1 ? given(layout) : "tolerant")
    limit = most[panel]
    set lmargin at screen 0.085 + 0.315*(panel - 1); set rmargin at screen 0.365 + 0.315*(panel - 1)
    set tmargin at screen 0.993 - height*(row - 1); set bmargin at screen 0.993 - height*(row - 0.17)
    set title layout_name(layout).", ".(panel > 1 ? heading[panel] : given(layout) eq "paper" ? "the paper's" : "its widest interval") offset 0,-0.7
    set xrange [-limit:limit]
    if (panel < 3) { set xtics 2 } else { set xtics 50 }
    if (row == rows_of) { set xlabel (panel < 3 ? "% of c_d for 1 %" : "% of ζ for 1 %") offset 0,0.6 } else { unset xlabel }
    unset ytics
    if (panel == 1) { set ytics noenhanced scale 0 font ",11"; do for [i=1:n] { set ytics add (word(order, i) i) } } \
    else { set ytics scale 0; do for [i=1:n] { set ytics add ("" i) } }
    set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb "#999999"
    if (panel == 2 && row == 1) { set key on bottom right Left reverse samplen 1 } else { unset key }
    if (panel < 3) {
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
