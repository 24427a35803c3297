# transients.gp - peaks, settling times and damping ratios over V from
# results/transients.csv and build/tables/transients.*.csv (scripts/studies/transients.sh)
gears = "paper.l1 paper.l2 paper.li1 paper.li2 best.l2 best.li1 best.li2"
names = "L1 L2 LI1 LI2"
colours = "#000000 #1f4fd8 #2a9d5c #e08214"
# rows: 3 V, 5 psi_max, 6 dstar_max, 7 psi_5, 9 dstar_5
choice(i) = word(gears, i)[:strstrt(word(gears, i), ".") - 1]
layout(i) = word(gears, i)[strstrt(word(gears, i), ".") + 1:*]
rows(i, disturbance) = pick(sprintf("results/transients.csv where=choice=%s where=layout=%s where=disturbance=%s", choice(i), layout(i), disturbance))
# at every m/s: 1 V, 3 psi_max, 4 dstar_max
peaks(i, disturbance) = where(sprintf("build/tables/transients.%s.peaks.csv", word(gears, i)), "disturbance", disturbance)
zeta(i) = sprintf("build/tables/transients.%s.zeta.csv", word(gears, i))
do for [i=1:4] { set style line 30+i lw 2 lc rgb word(colours, i) }
do for [i=5:7] { set style line 30+i lw 2 lc rgb word(colours, i - 3) dt 2 }
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,950 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,950 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set xrange [0:200]; set xtics 40; set xlabel "V (m/s)" offset 0,0.3
  # the legend, above all panels
  do for [i=1:4] { set label 10+i word(names, i) at screen 0.02+0.06*i,0.978 tc rgb word(colours, i) }
  set arrow 11 from screen 0.36,0.978 to screen 0.39,0.978 nohead lw 2 lc rgb "#808080"
  set label 15 "k_s (and b) of the paper" at screen 0.395,0.978
  set arrow 12 from screen 0.575,0.978 to screen 0.605,0.978 nohead lw 2 dt 2 lc rgb "#808080"
  set label 16 "best damped k_s (b = 0 or 140), each at its best c_d" at screen 0.61,0.978
  do for [panel=1:5] {
    col = panel == 5 ? 2 : (panel - 1) % 2; row = (panel - 1) / 2
    set lmargin at screen 0.055 + 0.325*col; set rmargin at screen 0.32 + 0.325*col
    set tmargin at screen 0.92 - 0.48*(panel == 5 ? 0 : row); set bmargin at screen panel == 5 ? 0.07 : 0.55 - 0.48*row
    unset logscale; set format y "%h"; set ytics auto
    if (panel == 1) {
      set title "(a) peak after ψ' = 1 rad/s" offset 0,-0.6; set ylabel "max |ψ| (deg)" offset 1,0; set yrange [0.7:1.3]
      plot for [i=1:7] peaks(i, "psi") using 1:3 with lines ls 30+i
      unset label; unset arrow # the legend, once is enough
    }
    if (panel == 3) {
      set title "(c) peak after δ' = 0.45 rad/s" offset 0,-0.6; set ylabel "max |δ*| (mm)" offset 1,0; set yrange [3.03:3.1]
      plot for [i=1:7] peaks(i, "delta") using 1:(1e3*$4) with lines ls 30+i
    }
    if (panel == 2 || panel == 4) {
      set logscale y; set format y "10^{%T}"; set ylabel "settling time to 5 % (s)" offset 0.5,0
      if (panel == 2) {
        set title "(b) ψ settles after ψ'" offset 0,-0.6; set yrange [0.1:2e3]
        plot for [i=1:7] rows(i, "psi") using 3:7 with linespoints ls 30+i pt 7 ps 0.35
      } else {
        set title "(d) δ* settles after δ'" offset 0,-0.6; set yrange [1:1e4]
        set label 1 "1 hour" at graph 0.97,first 3600*1.3 right
        plot 3600 with lines lc rgb "#808080" dt 3, for [i=1:7] rows(i, "delta") using 3:9 with linespoints ls 30+i pt 7 ps 0.35
      }
      unset label 1
    }
    if (panel == 5) {
      set title "(e) least damping ratio" offset 0,-0.6; set ylabel "ζ" offset 4.5,0
      set logscale y; set format y "10^{%T}"; set yrange [1e-5:4e-3]
      plot for [i=1:7] zeta(i) using 1:2 with lines ls 30+i
    }
  }
  unset multiplot
  unset output
}
