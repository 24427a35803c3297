# probability.gp - the probability of shimmy over V, results/probability.csv
# (scripts/studies/design.sh)
layouts = "l1 l2 li1 li2"
array title[4] = ["L1", "L2", "LI1", "LI2"]
array colour[4] = ["#000000", "#1f4fd8", "#2a9d5c", "#e08214"]
rows(layout, design) = pick(sprintf("results/probability.csv where=layout=%s where=design=%s 'where=V>0' columns=V,probability,lo,hi", layout, design))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,560 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,560 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set logscale y
  set xrange [0:80]; set yrange [1e-5:1]
  set xtics 10; set ytics ("10^{-5}" 1e-5, "10^{-4}" 1e-4, "10^{-3}" 1e-3, "10^{-2}" 1e-2, "10^{-1}" 0.1, "1" 1)
  set style fill transparent solid 0.3 noborder
  do for [panel=1:2] {
    design = panel == 1 ? "paper" : "tolerant"
    set lmargin at screen 0.065 + 0.48*(panel - 1); set rmargin at screen 0.485 + 0.48*(panel - 1)
    set tmargin at screen 0.92; set bmargin at screen 0.13
    set title (panel == 1 ? "(a) the paper's k_s, middle of its interval" : "(b) most tolerant") offset 0,-0.6
    set xlabel "V (m/s)" offset 0,0.3; set ylabel (panel == 1 ? "probability of shimmy" : "") offset 1,0
    if (panel == 1) { set key on top right } else { unset key }
    plot for [k=1:4] rows(word(layouts, k), design) using 1:($2 > 0 ? $2 : NaN):($1 - 0.5):($1 + 0.5):(real($3) > 1e-5 ? $3 : 1e-5):4 with boxxyerror lc rgb colour[k] notitle, \
         for [k=1:4] rows(word(layouts, k), design) using 1:($2 > 0 ? $2 : NaN) with lines lw 2 lc rgb colour[k] title title[k]
  }
  unset multiplot
  unset output
}
