# certify.gp - beyond linear theory, from results/cycles.csv, folds.csv, certify.csv,
# criticality.csv and fig07.csv
kilo = 1e-3 # axes in kN m s/rad
# cycles.csv: 1 layout, 4 branch, 5 type, 6 V, 7 c_d, 8 psi_max, 10 stable.  The orbits of a
# layout along c_d, a block a branch, and the first of each branch
cycles(layout) = pick(sprintf("results/cycles.csv where=layout=%s 'where=branch=V*' blocks=branch", layout))
begins(layout) = pick(sprintf("results/cycles.csv where=layout=%s 'where=branch=V*' first=branch | sort -t, -g -k7", layout))
folds(layout) = pick(sprintf("results/cycles.csv where=layout=%s where=type=LP 'where=psi_max>1'", layout))
unknown(layout) = pick(sprintf("results/cycles.csv where=layout=%s 'where=branch=V*' where=stable= where=type!=LP 'where=psi_max>0'; echo ,,,,,,1e-9,1e-9", layout)) # and one that does not show, for gnuplot warns of none
# y on the stretches of a branch of that stability, 1 or 0, up to and with the first orbit of
# the other; a fold, or where it is not known, belongs to both sides
now = block = before = -2
of_kind(y, kind) = (before = column(-1) == block ? now : -2, block = column(-1), now = valid(10) ? column(10) : -1, \
                    now == kind || before == kind || now == -1 ? y : NaN)
# y where there is room for a label, c_d rising
last = 0
with_room(y) = (column(7) > 1.2*last ? (last = column(7), y) : NaN)
curve(name) = where("results/fig07.csv", "curve", name)
bound(layout, name) = value_of(sprintf("results/certify.csv where=layout=%s columns=%s", layout, name))
array layouts[4] = ["l1", "l2", "li1", "li2"]
array titles[4] = ["(a) L1", "(b) L2, k_s = 7.86·10^5 N m/rad", "(c) LI1, k_s = 6.38·10^5 N m/rad, b = 140 N m s^2/rad", "(d) LI2, k_s = 2.48·10^6 N m/rad, b = 140 N m s^2/rad"]
array colours[4] = ["#000000", "#1f4fd8", "#2a9d5c", "#e08214"]

set style textbox opaque noborder fillcolor rgb "white" margins 0.4,0.3

do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,1500 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,1500 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot layout 3,2 margins 0.075,0.985,0.05,0.965 spacing 0.1,0.085
  set logscale xy
  set xrange [0.1:80]; set yrange [0.05:25]
  set xlabel "c_d (kN m s/rad)"; set ylabel "largest ψ of the cycle (deg)"
  set xtics (0.1,0.2,0.5,1,2,5,10,20,50); set ytics (0.05,0.1,0.2,0.5,1,2,5,10,20)
  do for [i = 1:4] {
    set title titles[i]
    c_lo = kilo * bound(layouts[i], "c_lo"); c_hi = kilo * bound(layouts[i], "c_hi")
    set object 1 rectangle from c_lo, graph 0 to c_hi, graph 1 fs solid noborder fc rgb grey behind
    set label 1 "zero-shimmy" at sqrt(c_lo * c_hi), (i == 1 ? 20 : 0.064) center rotate by 0 front boxed
    last = 0
    set key at graph 0.795,0.62 samplen 2 font ",11"
    plot cycles(layouts[i]) using (kilo*$7):(of_kind($8, 1)) with lines ls 1 title (i == 4 ? "stable" : ""), \
         cycles(layouts[i]) using (kilo*$7):(of_kind($8, 0)) with lines ls 2 title (i == 4 ? "unstable" : ""), \
         unknown(layouts[i]) using (kilo*$7):8 with points pt 6 ps 1.1 lw 1.5 lc rgb "#808080" title (i == 4 ? "not known" : ""), \
         folds(layouts[i]) using (kilo*$7):8 with points ls 7 title (i == 4 ? "fold" : ""), \
         begins(layouts[i]) using (kilo*$7):(with_room(0.135)):6 with labels rotate by 90 font ",10" right
    unset key; set key noautotitle
  }
  unset object 1; unset label 1; unset logscale
  set title "(e) L1: folds of cycles in the plane of Figure 7"
  set xrange [0:100]; set yrange [0:4]
  set xtics 20; set ytics 1
  set xlabel "V (m/s)"; set ylabel "c_d (kN m s/rad)"
  set object 1 rectangle from graph 0, first kilo*bound("l1", "c_lo") to graph 1, first kilo*bound("l1", "c_hi") fs solid noborder fc rgb grey behind
  set label 1 "zero-shimmy" at 80, kilo*(bound("l1", "c_lo") + bound("l1", "c_hi"))/2 center front
  set label 2 "folds of cycles" at 16,0.95 front boxed
  set label 3 "ψ-shimmy begins" at 27,2.05 front boxed
  set label 4 "δ-shimmy begins" at 36,3.5 center front boxed
  plot for [name in "low delta"] curve(name) using 4:(kilo*$5) with lines ls 3, \
       where("results/folds.csv", "layout", "l1") using 4:(kilo*$5) with lines lc rgb "#000000" lw 1.8
  unset object 1; unset label
  set title "(f) criticality of the bounding Hopf points"
  set xrange [0:100]; set yrange [0.1:1000]; set logscale y
  set ytics auto; set format y "−10^{%T}"
  set xlabel "V (m/s)"; set ylabel "a (1/s per rad² of ψ)"
  set key default; set key noautotitle bottom right
  plot for [i = 1:4] pick(sprintf("results/criticality.csv where=layout=%s where=type!=GH blocks=curve", layouts[i])) \
       using 6:(-$10) with lines lw 1.6 lc rgb colours[i] title (i == 1 ? "L1" : i == 2 ? "L2" : i == 3 ? "LI1" : "LI2")
  unset multiplot
  unset logscale; unset key; set format "%h"; unset title
  unset output
}
