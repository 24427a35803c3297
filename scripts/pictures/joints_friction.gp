# joints_friction.gp - friction against play, from results/joints_friction.csv,
# joints_thresholds.csv and joints_device.csv (scripts/studies/joints.sh)
load "scripts/pictures/joints_common.gp"
# a fixed play over V is V's steps of 20 from 10
over_V(layout) = picked(sprintf("results/joints_friction.csv where=layout=%s 'where=g_psi>0.004363' 'where=g_psi<0.004364' columns=V,T_psi,T_psi_balance", layout))
over_play(layout, V) = picked(sprintf("results/joints_friction.csv where=layout=%s where=V=%d 'where=g_psi!=%s' columns=g_psi,T_psi,T_psi_balance", layout, V, quarter))
quarter = system("build/bin/mlg pick results/joints_friction.csv where=layout=l1 where=V=10 columns=g_psi")
threshold(layout, V) = picked(sprintf("results/joints_thresholds.csv where=layout=%s where=V=%d columns=T_psi,release,balance", layout, V))
device(layout) = picked(sprintf("results/joints_device.csv where=layout=%s 'where=g_psi>0.004363' 'where=g_psi<0.004364' columns=T_f,psi_cycle,psi", layout))
left(k) = 0.06 + 0.325*k; right(k) = 0.325 + 0.325*k
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1000 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1000 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set key top right samplen 1.5
  set tmargin at screen 0.95; set bmargin at screen 0.585
  set lmargin at screen left(0); set rmargin at screen right(0)
  set title "(a) friction that stops play of 0.25 deg"; set xlabel "V (m/s)" offset 0,0.4; set ylabel "T_ψ (N m)"
  set logscale y; set xrange [0:200]; set xtics 50; set yrange [3:1000]; set ytics autofreq
  plot for [k=1:5] over_V(word(layouts, k)) using 1:2 with lines lw 2 lc rgb colour[k] title names[k], \
       for [k=1:5] over_V(word(layouts, k)) using 1:3 with lines lw 1.2 dt (4,3) lc rgb colour[k]
  unset logscale y; set yrange [0:*]
  set xlabel "play (deg)" offset 0,0.4; set xrange [0:1.05]; set xtics 0.25; unset key; set ylabel ""
  do for [panel=1:2] {
    set lmargin at screen left(panel); set rmargin at screen right(panel)
    V = panel == 1 ? 20 : 60
    set title sprintf("(%s) V = %d m/s: above the line it dies out", word("b c", panel), V)
    plot for [k=1:5] over_play(word(layouts, k), V) using ($1*degree):2 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[k], \
         for [k=1:5] over_play(word(layouts, k), V) using ($1*degree):3 with lines lw 1.2 dt (4,3) lc rgb colour[k]
  }
  set tmargin at screen 0.45; set bmargin at screen 0.08
  set xlabel "T_ψ (N m)"; set xtics autofreq; set logscale y; set yrange [0.02:1]
  set ytics ("0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1, "2" 2, "5" 5)
  do for [panel=1:2] {
    set lmargin at screen left(panel - 1); set rmargin at screen right(panel - 1)
    V = panel == 1 ? 20 : 60
    set xrange [0:(panel == 1 ? 350 : 90)]
    set title sprintf("(%s) V = %d m/s: the disturbance that goes on", word("d e", panel), V)
    set ylabel (panel == 1 ? "ψ (deg)" : "")
    plot for [k=1:5] threshold(word(layouts, k), V) using 1:2 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[k], \
         for [k=1:5] threshold(word(layouts, k), V) using 1:3 with lines lw 1.2 dt (4,3) lc rgb colour[k]
  }
  set lmargin at screen left(2); set rmargin at screen right(2)
  set title "(f) V = 60 m/s: friction of the device"; set xlabel "T_f (N m)"; set xrange [0:4000]; set xtics 1000; set yrange [0.3:3]; set ytics ("0.3" 0.3, "0.5" 0.5, "1" 1, "2" 2, "3" 3)
  plot for [k=1:5] device(word(layouts, k)) using 1:2 with lines lw 2 lc rgb colour[k], \
       for [k=1:5] device(word(layouts, k)) using 1:3 with lines lw 1.2 dt (4,3) lc rgb colour[k]
  unset logscale y
  unset multiplot
}
