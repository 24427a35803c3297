# loads.gp - intervals of c_d and damping over the static load, results/loads.csv
# (scripts/studies/design.sh)
layouts = "l1 l2 li1 li2"
array title[4] = ["(a1) L1", "(a2) L2", "(a3) LI1, b = 140 N m s^2/rad", "(a4) LI2, b = 140 N m s^2/rad"]
rows(layout, choice) = pick(sprintf("results/loads.csv where=layout=%s where=choice=%s columns=F_z,c_lo,c_hi,width,ratio,c_d,zeta", layout, choice))
with_width(layout, choice) = pick(sprintf("results/loads.csv where=layout=%s where=choice=%s 'where=width>0' columns=F_z,c_lo,c_hi,width,ratio,c_d,zeta", layout, choice))
by_auto(layout) = pick(sprintf("results/loads_auto.csv where=layout=%s columns=F_z,c_d", layout))
array colour[4] = ["#000000", "#1f4fd8", "#2a9d5c", "#e08214"]
largest(layout, choice) = value_of(sprintf("results/loads.csv where=layout=%s where=choice=%s columns=F_z", layout, choice))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1000 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1000 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set xrange [100:250]; set xtics 50; set mxtics 5
  set logscale y
  do for [panel=1:4] {
    layout = word(layouts, panel)
    set lmargin at screen 0.055 + 0.24*(panel - 1); set rmargin at screen 0.255 + 0.24*(panel - 1)
    set tmargin at screen 0.955; set bmargin at screen 0.56
    set title title[panel] offset 0,-0.6
    set yrange [1e3:1e5]
    set ytics ("1" 1e3, "3" 3e3, "10" 1e4, "30" 3e4, "100" 1e5)
    set xlabel "F_z (kN)" offset 0,0.5
    set ylabel (panel == 1 ? "c_d (kN m s/rad)" : "") offset 1,0
    set arrow 1 from 200, graph 0 to 200, graph 1 nohead lc rgb "#999999" dt (2,3)
    set label 1 "no shimmy" at 110,6e3 front tc rgb "#5a7f5a"
    plot with_width(layout, "paper") using (1e-3*$1):2:3 with filledcurves fc rgb "#dcefdc" notitle, \
         with_width(layout, "paper") using (1e-3*$1):2 with lines ls 9, \
         with_width(layout, "paper") using (1e-3*$1):3 with lines ls 9, \
         by_auto(layout) using (1e-3*$1):2 with points pt 6 ps 0.5 lc rgb "#d62728"
    unset label 1; unset arrow 1
  }
  unset logscale y
  array what[3] = ["paper", "damped", "over"]
  array heading[3] = ["(b) the paper's k_s, middle of its interval", "(c) at each load the best k_s and c_d", "(d) the best over 180 to 210 kN"]
  do for [panel=1:3] {
    set lmargin at screen 0.07 + 0.325*(panel - 1); set rmargin at screen 0.325 + 0.325*(panel - 1)
    set tmargin at screen 0.44; set bmargin at screen 0.075
    set title heading[panel] offset 0,-0.6
    set xrange [100:250]
    if (panel == 3) { set xrange [180:210]; set xtics 10 } else { set xtics 50 }
    set yrange [-1e-3:(panel == 3 ? 1.5e-3 : 2e-3)]
    set ytics ("-1" -1e-3, "-0.5" -5e-4, "0" 0, "0.5" 5e-4, "1" 1e-3, "1.5" 1.5e-3, "2" 2e-3)
    set ylabel (panel == 1 ? "least ζ over V (10^{-3})" : "") offset 1,0
    if (panel == 1) { set key on bottom left Left reverse } else { unset key }
    set arrow 1 from 200, graph 0 to 200, graph 1 nohead lc rgb "#999999" dt (2,3)
    plot 0 with lines lc rgb "#d62728" lw 1 notitle, \
         for [k=1:4] rows(word(layouts, k), what[panel]) using (1e-3*$1):7 with lines lw 2 lc rgb colour[k] title (k < 3 ? (k == 1 ? "L1" : "L2") : (k == 3 ? "LI1" : "LI2")), \
         for [k=3:(panel > 1 ? 4 : 2)] rows(word(layouts, k), what[panel]."_b") using (1e-3*$1):7 with lines lw 1.5 dt 2 lc rgb colour[k] notitle
  }
  unset multiplot
  unset output
}
