# passive.gp - what no passive device can do, from results/passive.csv (scripts/studies/passive.sh)
rows(words) = pick("results/passive.csv where=case=".words." columns=x,zeta")
required = log(4.) / (6. * pi) # a quarter of the amplitude after three cycles
delta(what) = number("passive zeta case=delta F_z=200e3 what=".what)
# best damped devices at 200 kN, b up to 300, by order
devices = "l1 l2 li1 li4 li2"
array order[5] = [1, 2, 3, 3, 3]
device(l) = value_of(sprintf("results/networks.csv where=quantity=zeta where=layout=%s columns=value", l))
array load[3] = ["180e3", "200e3", "220e3"]
array colour[3] = ["#2a9d5c", "#1f4fd8", "#d62728"]
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,640 font "DejaVu Sans,14" } \
  else { set terminal svg size 1500,640 font "DejaVu Sans,15" }
  set output picture(ending)
  set multiplot layout 1,2 margins 0.07,0.98,0.12,0.92 spacing 0.08
  set logscale y; set format y "10^{%T}"; set yrange [1e-5:0.3]
  set title "(a) any passive device"; set xlabel "order of the device"; set ylabel "least damping ratio ζ over V"
  set xrange [0.6:7.4]; set xtics 1; set key bottom right
  plot for [i=1:3] rows("order where=F_z=".load[i]) with linespoints lc rgb colour[i] lw 2 pt 7 \
         title "F_z = ".load[i][1:3]." kN", \
       for [i=1:3] rows("any where=F_z=".load[i]) with linespoints lc rgb colour[i] lw 1.5 dt (2,3) pt 6 title (i == 2 ? "with any static stiffness" : ""), \
       rows("fast where=F_z=200e3") with linespoints lc rgb colour[2] lw 1.5 dt (8,3) pt 4 title "200 kN, V from 10 m/s", \
       for [k=1:5] "+" using (order[k]):(device(word(devices, k))) every ::::0 with points pt 2 ps 1.2 lw 2 lc rgb "#000000" title (k == 1 ? "L1, L2, LI1, LI4, LI2" : ""), \
       required with lines lc rgb "#000000" dt (8,4) title "a quarter after three cycles, 0.0735", \
       delta("strut") with lines lc rgb "#7f7f7f" lw 1.5 title "the strut's own damping", \
       delta("locked") with lines lc rgb "#7f7f7f" dt (3,3) lw 1.5 title "wheels locked in torsion"
  set title "(b) another gear: solid the delta mode, best Z; dotted the best L1"
  set logscale x 2; set xrange [0.25:32]; set xtics auto; set xlabel "parameter / its value"; unset ylabel; set key bottom right
  names = "c_delta c_psi e l phi l_delta"
  plot for [k=1:6] rows(sprintf("gear 'where=what=%s any'", word(names, k))) with lines lc k lw 2 title word(names, k) noenhanced, \
       for [k=1:6] rows(sprintf("gear 'where=what=%s l1'", word(names, k))) with lines lc k lw 1.5 dt (2,3), \
       required with lines lc rgb "#000000" dt (8,4)
  unset multiplot; unset logscale x
}
