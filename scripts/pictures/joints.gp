# joints.gp - sustained shimmy with play, from results/joints.csv and joints_play.csv
# (scripts/studies/joints.sh)
load "scripts/pictures/joints_common.gp"
# V and psi of one play of choice middle; values of play as they stand in the table
plays(layout) = system(sprintf("build/bin/mlg pick results/joints.csv where=layout=%s where=choice=middle where=V=10 columns=g_psi | xargs", layout))
cycles(layout, play) = picked(sprintf("results/joints.csv where=layout=%s where=choice=middle where=g_psi=%s columns=V,psi_cycle,psi", layout, play))
useful(layout, choice) = picked(sprintf("results/joints_play.csv where=layout=%s where=choice=%s columns=V,g", layout, choice))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1600,900 font "DejaVu Sans,13" } \
  else { set terminal svg size 1600,900 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set logscale y; set xrange [0:200]; set xtics 50; set xlabel "V (m/s)" offset 0,0.4
  do for [panel=1:5] {
    layout = word(layouts, panel)
    set lmargin at screen 0.05 + 0.19*(panel-1); set rmargin at screen 0.208 + 0.19*(panel-1)
    set tmargin at screen 0.945; set bmargin at screen 0.56
    set title "(a".panel.") ".names[panel]; set ylabel (panel == 1 ? "ψ (deg)" : "") offset 1.5,0
    set yrange [0.1:20]; set ytics ("0.1" 0.1, "0.3" 0.3, "1" 1, "3" 3, "10" 10)
    if (panel == 1) { set key top right samplen 1.5 title "play, deg" } else { set key noautotitle; unset key }
    plot for [k=1:4] cycles(layout, word(plays(layout), int(2**(k-1)))) using 1:($2 > 0.1 ? $2 : NaN) with lines lw 2 lc rgb shade[k] \
           title sprintf("%.3g", real(word(plays(layout), int(2**(k-1))))*degree), \
         for [k=1:4] cycles(layout, word(plays(layout), int(2**(k-1)))) using 1:($3 > 0.1 ? $3 : NaN) with lines lw 1.5 dt (3,3) lc rgb shade[k]
    unset key
  }
  set key title ""
  array heading[2] = ["(b1) middle of the interval: play that shimmies 0.1 deg beyond itself", "(b2) best damped"]
  do for [panel=1:2] {
    set lmargin at screen 0.05 + 0.49*(panel-1); set rmargin at screen 0.48 + 0.49*(panel-1)
    set tmargin at screen 0.435; set bmargin at screen 0.075
    set title heading[panel]; set ylabel (panel == 1 ? "play (deg)" : "") offset 2.5,0
    set yrange [1e-3:2]; set ytics ("0.001" 1e-3, "0.01" 1e-2, "0.1" 0.1, "1" 1)
    set key bottom right samplen 1.5
    plot for [k=1:5] useful(word(layouts, k), word("middle best", panel)) using 1:2 with lines lw 2 lc rgb colour[k] title names[k]
  }
  unset multiplot
  unset logscale y
}
