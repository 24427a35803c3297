# loads.gp - intervals of c_d and damping over the static load, results/loads.csv
# (scripts/studies/design.sh)
layouts = layouts_of("results/loads.csv")
n = words(layouts)
rows(layout, choice) = pick(sprintf("results/loads.csv where=layout=%s where=choice=%s columns=F_z,c_lo,c_hi,width,ratio,c_d,zeta", layout, choice))
with_width(layout, choice) = pick(sprintf("results/loads.csv where=layout=%s where=choice=%s 'where=width>0' columns=F_z,c_lo,c_hi,width,ratio,c_d,zeta", layout, choice))
by_auto(layout) = pick(sprintf("results/loads_auto.csv where=layout=%s columns=F_z,c_d", layout))
followed(layout) = system(sprintf("grep -c '^%s,' results/loads_auto.csv", layout)) + 0 # by AUTO
has(layout, choice) = system(sprintf("grep -c '^%s,%s,' results/loads.csv", layout, choice)) + 0
# the paper's design or, where it has none, that of its own widest interval; b searched where there is one
given(layout) = has(layout, "paper") ? "paper" : "own"
searched(layout, choice) = has(layout, choice."_b") ? choice."_b" : choice
b_of(layout) = number(sprintf("loads b layout=%s choice=%s F_z=200000", layout, given(layout)))
kind(layout) = layout_name(layout).(b_of(layout) > 0 ? sprintf(", b = %.4g", b_of(layout)) : "")
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1440 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1440 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set xrange [100:250]; set xtics 50; set mxtics 5
  set logscale y
  do for [panel=1:n] {
    layout = word(layouts, panel)
    row = (panel - 1)/5; column = (panel - 1)%5
    set lmargin at screen 0.05 + 0.193*column; set rmargin at screen 0.21 + 0.193*column
    set tmargin at screen 0.97 - 0.325*row; set bmargin at screen 0.715 - 0.325*row
    set title sprintf("(a%d) ", panel).kind(layout) offset 0,-0.6
    set yrange [1e3:1e5]
    if (column == 0) { set ytics ("1" 1e3, "3" 3e3, "10" 1e4, "30" 3e4, "100" 1e5) } \
    else { set ytics ("" 1e3, "" 3e3, "" 1e4, "" 3e4, "" 1e5) }
    set xlabel "F_z (kN)" offset 0,0.5
    set ylabel (column == 0 ? "c_d (kN m s/rad)" : "") offset 1,0
    set arrow 1 from 200, graph 0 to 200, graph 1 nohead lc rgb "#999999" dt (2,3)
    plot with_width(layout, given(layout)) using (1e-3*$1):2:3 with filledcurves fc rgb "#dcefdc" notitle, \
         with_width(layout, given(layout)) using (1e-3*$1):2 with lines ls 9, \
         with_width(layout, given(layout)) using (1e-3*$1):3 with lines ls 9, \
         (followed(layout) ? by_auto(layout) : with_width(layout, given(layout))) using (1e-3*$1):(followed(layout) ? $2 : NaN) with points pt 6 ps 0.5 lc rgb "#d62728"
    unset arrow 1
  }
  unset logscale y
  array what[3] = ["given", "damped", "over"]
  array heading[3] = ["(b) k_s, b as in (a), middle of its interval", "(c) at each load the best c_d, k_s and b", "(d) the best over 180 to 210 kN"]
  do for [panel=1:3] {
    set lmargin at screen 0.06 + 0.3*(panel - 1); set rmargin at screen 0.3 + 0.3*(panel - 1)
    set tmargin at screen 0.31; set bmargin at screen 0.05
    set title heading[panel] offset 0,-0.6
    set xrange [100:250]
    if (panel == 3) { set xrange [180:210]; set xtics 10 } else { set xtics 50 }
    set yrange [-1e-3:(panel == 1 ? 2e-3 : panel == 2 ? 2.5e-3 : 1.25e-3)]
    set ytics ("-1" -1e-3, "-0.5" -5e-4, "0" 0, "0.5" 5e-4, "1" 1e-3, "1.5" 1.5e-3, "2" 2e-3, "2.5" 2.5e-3)
    set ylabel (panel == 1 ? "least ζ over V (10^{-3})" : "") offset 1,0
    if (panel == 3) { set key at screen 0.995,0.3 top right Left reverse samplen 1.5 } else { unset key }
    set arrow 1 from 200, graph 0 to 200, graph 1 nohead lc rgb "#999999" dt (2,3)
    plot 0 with lines lc rgb "#d62728" lw 1 notitle, \
         for [k=1:n] rows(word(layouts, k), panel == 1 ? given(word(layouts, k)) : searched(word(layouts, k), what[panel])) using (1e-3*$1):7 \
           with lines lw 2 lc rgb colour_of(layouts, k) dt 1 + (k > 4) title layout_name(word(layouts, k))
  }
  unset multiplot
  unset output
}
