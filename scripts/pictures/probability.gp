# probability.gp - the probability of shimmy over V, results/probability.csv
# (scripts/studies/design.sh)
layouts = layouts_of("results/probability.csv")
n = words(layouts)
has(layout, design) = system(sprintf("grep -c '^%s,%s,' results/probability.csv", layout, design)) + 0
given(layout) = has(layout, "paper") ? "paper" : "own"
rows(layout, design) = pick(sprintf("results/probability.csv where=layout=%s where=design=%s 'where=V>0' columns=V,probability,lo,hi", layout, design))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1400,620 font "DejaVu Sans,13" } \
  else { set terminal svg size 1400,620 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set logscale y
  set xrange [0:80]; set yrange [1e-5:1]
  set xtics 10; set ytics ("10^{-5}" 1e-5, "10^{-4}" 1e-4, "10^{-3}" 1e-3, "10^{-2}" 1e-2, "10^{-1}" 0.1, "1" 1)
  set style fill transparent solid 0.25 noborder
  do for [panel=1:2] {
    set lmargin at screen 0.06 + 0.445*(panel - 1); set rmargin at screen 0.455 + 0.445*(panel - 1)
    set tmargin at screen 0.93; set bmargin at screen 0.12
    set title (panel == 1 ? "(a) k_s, b of the paper or of the widest interval, its middle" : "(b) most tolerant") offset 0,-0.6
    set xlabel "V (m/s)" offset 0,0.3; set ylabel (panel == 1 ? "probability of shimmy" : "") offset 1,0
    if (panel == 2) { set key at screen 0.995,0.92 top right Left reverse samplen 1.5 } else { unset key }
    plot for [k=1:n] rows(word(layouts, k), panel == 1 ? given(word(layouts, k)) : "tolerant") using 1:($2 > 0 ? $2 : NaN):($1 - 0.5):($1 + 0.5):(real($3) > 1e-5 ? $3 : 1e-5):4 \
           with boxxyerror lc rgb colour_of(layouts, k) notitle, \
         for [k=1:n] rows(word(layouts, k), panel == 1 ? given(word(layouts, k)) : "tolerant") using 1:($2 > 0 ? $2 : NaN) with lines lw 2 lc rgb colour_of(layouts, k) \
           dt 1 + (k > 4) title layout_name(word(layouts, k))
  }
  unset multiplot
  unset output
}
