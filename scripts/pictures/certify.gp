# certify.gp - beyond linear theory, from results/cycles.csv, folds.csv, certify.csv,
# criticality.csv and fig07.csv
kilo = 1e-3 # axes in kN m s/rad
# cycles.csv: 1 layout, 4 branch, 5 type, 6 V, 7 c_d, 8 psi_max, 10 stable.  The orbits of
# one layout with that stability along c_d, a block for each unbroken stretch.
cycles(layout, stable) = sprintf("< awk -F, '$1==\"%s\"&&$4~/^V/{if($4!=branch||($10!=%d))print \"\"; if($4==branch&&$10==%d&&was!=%d)print last; if($10==%d)print; branch=$4; was=$10; last=$0}' results/cycles.csv", layout, stable, stable, stable, stable)
# the first orbit of each of its branches along c_d, at the speed of column 6; where they
# crowd, one of them
speeds(layout) = sprintf("< awk -F, '$1==\"%s\"&&$4~/^V/&&$4!=branch{print; branch=$4}' results/cycles.csv | sort -t, -g -k7 | awk -F, '$7>1.15*last{print; last=$7}'", layout)
curve(name) = where("results/fig07.csv", "curve", name)
bound(layout, column) = real(system(sprintf("awk -F, '$1==\"%s\"{print $%d}' results/certify.csv", layout, column)))
array layouts[4] = ["l1", "l2", "li1", "li2"]
array titles[4] = ["(a) L1", "(b) L2, k_s = 7.86·10^5 N m/rad", "(c) LI1, k_s = 6.38·10^5 N m/rad, b = 140 N m s^2/rad", "(d) LI2, k_s = 2.48·10^6 N m/rad, b = 140 N m s^2/rad"]
array colours[4] = ["#000000", "#1f4fd8", "#2a9d5c", "#e08214"]

set style textbox opaque noborder fillcolor rgb "white" margins 0.4,0.3

do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,1500 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,1500 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot layout 3,2 margins 0.075,0.985,0.045,0.965 spacing 0.1,0.085
  set logscale xy
  set xrange [0.1:80]; set yrange [0.05:25]
  set xlabel "c_d (kN m s/rad)"; set ylabel "largest ψ of the cycle (deg)"
  set xtics (0.1,0.2,0.5,1,2,5,10,20,50); set ytics (0.05,0.1,0.2,0.5,1,2,5,10,20)
  do for [i = 1:4] {
    set title titles[i]
    c_lo = kilo * bound(layouts[i], 4); c_hi = kilo * bound(layouts[i], 5)
    set object 1 rectangle from c_lo, graph 0 to c_hi, graph 1 fs solid noborder fc rgb grey behind
    set label 1 "zero-shimmy" at sqrt(c_lo * c_hi), (i == 1 ? 20 : 0.064) center rotate by 0 front boxed
    plot cycles(layouts[i], 1) using (kilo*$7):8 with lines ls 1, \
         cycles(layouts[i], 0) using (kilo*$7):8 with lines ls 2, \
         sprintf("< awk -F, '$1==\"%s\"&&$5==\"LP\"&&$8>1' results/cycles.csv", layouts[i]) using (kilo*$7):8 with points ls 7, \
         speeds(layouts[i]) using (kilo*$7):(0.135):6 with labels rotate by 90 font ",10" right
  }
  unset object 1; unset label 1; unset logscale
  set title "(e) L1: folds of cycles in the plane of Figure 7"
  set xrange [0:100]; set yrange [0:4]
  set xtics 20; set ytics 1
  set xlabel "V (m/s)"; set ylabel "c_d (kN m s/rad)"
  set object 1 rectangle from graph 0, first kilo*bound("l1", 4) to graph 1, first kilo*bound("l1", 5) fs solid noborder fc rgb grey behind
  set label 1 "zero-shimmy" at 80, kilo*(bound("l1", 4) + bound("l1", 5))/2 center front
  set label 2 "folds of cycles" at 16,0.95 front boxed
  set label 3 "ψ-shimmy begins" at 27,2.05 front boxed
  set label 4 "δ-shimmy begins" at 36,3.5 center front boxed
  plot for [name in "low delta"] curve(name) using 4:(kilo*$5) with lines ls 3, \
       "< awk -F, '$1==\"l1\"' results/folds.csv" using 4:(kilo*$5) with lines lc rgb "#000000" lw 1.8
  unset object 1; unset label
  set title "(f) criticality of the bounding Hopf points"
  set xrange [0:100]; set yrange [0.1:1000]; set logscale y
  set ytics auto; set format y "−10^{%T}"
  set xlabel "V (m/s)"; set ylabel "a (1/s per rad² of ψ)"
  set key bottom right
  plot for [i = 1:4] sprintf("< awk -F, '$1==\"%s\"&&$5==\"\"{if($4!=last)print \"\"; last=$4; print}' results/criticality.csv", layouts[i]) \
       using 6:(-$10) with lines lw 1.6 lc rgb colours[i] title (i == 1 ? "L1" : i == 2 ? "L2" : i == 3 ? "LI1" : "LI2")
  unset multiplot
  unset logscale; unset key; set format "%h"; unset title
  unset output
}
