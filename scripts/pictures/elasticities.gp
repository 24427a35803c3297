# elasticities.gp - tornado charts of results/elasticities.csv (scripts/studies/design.sh)
set datafile missing ""
layouts = "l1 l2 li1 li2"
designs = "paper tolerant"
array title[4] = ["L1", "L2", "LI1", "LI2"]
# the parameters by their largest effect on a bound of the most tolerant LI2, one order for all
order = system("build/bin/mlg pick results/elasticities.csv where=layout=li2 where=design=tolerant columns=parameter,c_lo,c_hi | awk -F, '$2 != \"\" { a = $2 < 0 ? -$2 : $2; b = $3 < 0 ? -$3 : $3; if (a > b) b = a; if (b > 1e-6) print b, $1 }' | sort -g | awk '{ printf \"%s \", $2 }'")
n = words(order)
place(name) = sum [i=1:n] (word(order, i) eq name ? i : 0)
rows(layout, design) = pick(sprintf("results/elasticities.csv where=layout=%s where=design=%s columns=parameter,c_lo,c_hi,zeta", layout, design))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1150 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1150 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set style fill solid 0.85 noborder
  set yrange [0.3:n + 0.7]
  do for [row=1:2] { do for [panel=1:4] {
    layout = word(layouts, panel); design = word(designs, row)
    set lmargin at screen 0.075 + 0.235*(panel - 1); set rmargin at screen 0.285 + 0.235*(panel - 1)
    set tmargin at screen 0.955 - 0.49*(row - 1); set bmargin at screen 0.56 - 0.49*(row - 1)
    set title title[panel].(row == 1 ? ", the paper's" : ", most tolerant") offset 0,-0.6
    set xrange [-7:7]; set xtics 2
    set xlabel "% of c_d for 1 % of the parameter" offset 0,0.5
    unset ytics
    if (panel == 1) { set for [i=1:n] ytics (word(order, i) i) ; set for [i=1:n] ytics add (word(order, i) i) }
    set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb "#999999"
    if (panel == 1 && row == 1) { set key on bottom left Left reverse } else { unset key }
    plot rows(layout, design) using ($2/2.):(place(strcol(1)) > 0 ? place(strcol(1)) + 0.18 : NaN):(abs($2)/2.):(0.16) with boxxyerror lc rgb "#1f4fd8" title "lower bound", \
         rows(layout, design) using ($3/2.):(place(strcol(1)) > 0 ? place(strcol(1)) - 0.18 : NaN):(abs($3)/2.):(0.16) with boxxyerror lc rgb "#e08214" title "upper bound", \
         rows(layout, design) using (abs($2) > 6.9 ? ($2 > 0 ? 6.6 : -6.6) : NaN):(place(strcol(1)) + 0.18):(sprintf("%.0f", $2)) with labels font ",9" tc rgb "white" notitle, \
         rows(layout, design) using (abs($3) > 6.9 ? ($3 > 0 ? 6.5 : -6.5) : NaN):(place(strcol(1)) - 0.18):(sprintf("%.0f", $3)) with labels font ",9" tc rgb "white" notitle
  } }
  unset multiplot
  unset output
}
