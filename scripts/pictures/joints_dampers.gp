# joints_dampers.gp - quadratic dampers and relief valves, from results/joints_dampers.csv and
# joints_quadratic.csv (scripts/studies/joints.sh)
load "scripts/pictures/joints_common.gp"
dampers(layout, what, columns) = picked(sprintf("results/joints_dampers.csv where=layout=%s where=what=%s columns=V,%s", layout, what, columns))
left_over(layout, psi) = picked(sprintf("results/joints_quadratic.csv where=layout=%s where=psi=%s columns=c_lo,c_hi,middle,linear_lo,linear_hi", layout, psi))
left(k) = 0.06 + 0.325*k; right(k) = 0.325 + 0.325*k
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,560 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,560 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set tmargin at screen 0.91; set bmargin at screen 0.13
  set lmargin at screen left(0); set rmargin at screen right(0)
  set title "(a) a quadratic damper: its shimmy"; set xlabel "V (m/s)"; set ylabel "ψ (deg)"; set xrange [0:200]; set xtics 50
  set logscale y; set yrange [1e-2:5]; set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1)
  set key top right samplen 1.5
  plot for [k=1:5] dampers(word(layouts, k), "quadratic", "psi_cycle,psi") using 1:($2 > 0 ? $2 : NaN) with lines lw 2 lc rgb colour[k] title names[k], \
       for [k=1:5] dampers(word(layouts, k), "quadratic", "psi_cycle,psi") using 1:($3 > 0 ? $3 : NaN) with lines lw 1.2 dt (4,3) lc rgb colour[k]
  unset logscale y; unset key
  set lmargin at screen left(1) + 0.02; set rmargin at screen right(1) + 0.02
  set title "(b) c that lets nothing grow at that ψ"; set xlabel "c at 1 deg, 11 Hz (kN m s/rad)"; set ylabel ""
  set logscale x; set xrange [0.5:3e3]; set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000)
  set yrange [-0.5:4.6]; set ytics ("LI3" 0, "LI2" 1, "LI1" 2, "L2" 3, "L1" 4)
  set key top right samplen 2
  plot for [k=1:5] left_over(word(layouts, k), "1") using (1e-3*$4):(5-k+0.3):(1e-3*($5-$4)):(0) with vectors nohead lw 6 lc rgb "#bbbbbb" title (k == 1 ? "linear damper" : ""), \
       for [s=1:3] for [k=1:5] left_over(word(layouts, k), word("0.1 1 5", s)) using (1e-3*$1):(5-k+0.3-0.17*s):(1e-3*($2-$1)):(0) \
         with vectors nohead lw 5 lc rgb shade[s] title (k == 1 ? "ψ ".word("0.1 1 5", s)." deg" : ""), \
       for [k=1:5] left_over(word(layouts, k), "1") using (1e-3*$3):(5-k+0.05):(0):(0.3) with vectors nohead lw 1.5 lc rgb "#d62728" title (k == 1 ? "middle" : "")
  unset logscale x; unset key
  set lmargin at screen left(2) + 0.025; set rmargin at screen right(2) + 0.015
  set title "(c) relief at 2 kN m: from where it grows"; set xlabel "V (m/s)"; set ylabel "ψ (deg)" offset 1,0; set xrange [0:110]; set xtics 20
  set logscale y; set yrange [0.5:30]; set ytics ("0.5" 0.5, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20)
  plot for [k=1:5] dampers(word(layouts, k), "relief", "threshold,psi") using 1:2 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[k], \
       for [k=1:5] dampers(word(layouts, k), "relief", "threshold,psi") using 1:3 with lines lw 1.2 dt (4,3) lc rgb colour[k]
  unset logscale y
  unset multiplot
}
