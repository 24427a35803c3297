# joints.gp - what play, friction and real dampers do, from results/joints*.csv
# (scripts/studies/joints.sh)
set datafile separator whitespace # of gnuplot's own contours, and so of all that is read here
# an empty cell is no number, and not the one after it
picked(words) = pick(words)." | sed 's/,$/,NaN/; s/,,/,NaN,/g; s/,,/,NaN,/g' | tr , ' '"
layouts = "l1 l2 li1 li2 li3"
degree = 180. / pi
# V and psi of one play of choice middle; values of play as they stand in the table
plays(layout) = system(sprintf("build/bin/mlg pick results/joints.csv where=layout=%s where=choice=middle where=V=10 columns=g_psi | xargs", layout))
cycles(layout, choice, play) = picked(sprintf("results/joints.csv where=layout=%s where=choice=%s where=g_psi=%s columns=V,psi_cycle,psi", layout, choice, play))
plane(layout) = picked(sprintf("results/joints_planes.csv where=layout=%s blocks=V columns=V,c_d,ratio", layout))." | sed 's/inf/1e3/; s/ 0$/ 0.5/'"
dampers(layout, what, column) = picked(sprintf("results/joints_dampers.csv where=layout=%s where=what=%s columns=V,%s", layout, what, column))
friction(layout) = picked(sprintf("results/joints_friction.csv where=layout=%s where=what=T_decay where=T_psi!= columns=V,T_psi", layout))
hidden(layout) = picked(sprintf("results/joints_friction.csv where=layout=%s where=what=map columns=g_psi,T_psi,psi", layout))
array names[5] = ["L1", "L2", "LI1", "LI2", "LI3"]
array colour[5] = ["#000000", "#1f4fd8", "#2a9d5c", "#e08214", "#7b3fa0"]
array shade[4] = ["#9fc5e8", "#3f7fbf", "#0b2f66", "#000000"]
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1600,1300 font "DejaVu Sans,13" } \
  else { set terminal svg size 1600,1300 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  do for [panel=1:5] {
    layout = word(layouts, panel)
    set lmargin at screen 0.05 + 0.19*(panel-1); set rmargin at screen 0.208 + 0.19*(panel-1)
    # (a) amplitude over V
    set tmargin at screen 0.955; set bmargin at screen 0.72
    set title "(a".panel.") ".names[panel]; set xlabel "V (m/s)" offset 0,0.4; set ylabel (panel == 1 ? "psi (deg)" : "") offset 1.5,0; set xtics 50
    set logscale y; set xrange [0:200]; set yrange [0.1:20]; set ytics ("0.1" 0.1, "0.3" 0.3, "1" 1, "3" 3, "10" 10)
    if (panel == 1) { set key top right samplen 1.5 title "play, deg" } else { set key noautotitle; unset key }
    plot for [k=1:4] cycles(layout, "middle", word(plays(layout), int(2**(k-1)))) using 1:2 with lines lw 2 lc rgb shade[k] \
           title sprintf("%.3g", real(word(plays(layout), int(2**(k-1))))*degree), \
         for [k=1:4] cycles(layout, "middle", word(plays(layout), int(2**(k-1)))) using 1:3 with lines lw 1.5 dt (3,3) lc rgb shade[k]
    unset key
  }
  unset logscale y
  left(k) = 0.05 + 0.32*k; right(k) = 0.31 + 0.32*k
  array whole[2] = ["l1", "li1"]; array which[2] = [1, 3]
  # (b) the plane
  set tmargin at screen 0.635; set bmargin at screen 0.40
  do for [panel=1:2] {
    layout = whole[panel]
    set lmargin at screen left(panel-1); set rmargin at screen right(panel-1)
    do for [k=1:4] {
      set contour base; unset surface; set cntrparam levels discrete (k == 4 ? 100 : 1 + 0.1/(k == 1 ? 0.1 : k == 2 ? 0.25 : 0.5))
      if (k == 1) { set table $level1 }; if (k == 2) { set table $level2 }; if (k == 3) { set table $level3 }; if (k == 4) { set table $level4 }
      set autoscale
      splot plane(layout) using 1:(log10($2)):3
      unset table; unset contour; set surface
    }
    set title sprintf("(b%d) %s: psi 0.1 deg beyond the play", panel, names[which[panel]])
    set ylabel (panel == 1 ? "c_d (kN m s/rad)" : ""); set xlabel "V (m/s)"
    set xrange [0:200]; set yrange [log10(500):log10(5e4)]
    set ytics ("0.5" log10(500), "1" 3, "3" log10(3e3), "10" 4, "30" log10(3e4))
    set key top right samplen 1.5 opaque title "play, deg"
    plot $level1 using 1:2 with lines lw 2 lc rgb shade[1] title "0.1", $level2 using 1:2 with lines lw 2 lc rgb shade[2] title "0.25", \
         $level3 using 1:2 with lines lw 2 lc rgb shade[3] title "0.5", $level4 using 1:2 with lines ls 3 title "grows without"
  }
  set key title ""
  # (c) friction that hides a quarter of a degree
  set lmargin at screen left(2); set rmargin at screen right(2)
  set title "(c) friction that stops play of 0.25 deg"; set ylabel "T_{psi} (N m)" offset 0.5,0; set ytics autofreq; set yrange [0:600]
  set key top right samplen 1.5
  plot for [k=1:2] friction(whole[k]) using 1:2 with lines lw 2 lc rgb colour[which[k]] title names[which[k]]
  set tmargin at screen 0.315; set bmargin at screen 0.07
  # (d) the plane of friction and play
  set lmargin at screen left(0); set rmargin at screen right(0)
  set title "(d) V = 60 m/s, L1: where it dies out"; set xlabel "play (deg)"; set xtics autofreq; set xrange [0:1.05]; set yrange [-10:560]
  set key top left opaque samplen 1 horizontal
  plot hidden("l1") using ($1*degree):($3 > 0 ? $2 : NaN) with points pt 7 ps 0.9 lc rgb "#d62728" title "shimmies", \
       hidden("l1") using ($1*degree):($3 == 0 ? $2 : NaN) with points pt 6 ps 0.9 lc rgb "#1f4fd8" title "dies out"
  set key vertical
  # (e) a quadratic damper, (f) a relief valve
  set lmargin at screen left(1); set rmargin at screen right(1)
  set title "(e) quadratic damper: its shimmy"; set xlabel "V (m/s)"; set ylabel "psi (deg)"; set xrange [0:200]; set logscale y
  set yrange [1e-2:30]; set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
  set key top right samplen 1.5
  plot for [k=2:2] dampers(whole[k], "quadratic", "psi_cycle") using 1:($2 > 0 ? $2 : NaN) with lines lw 2 lc rgb colour[which[k]] title names[which[k]]
  set lmargin at screen left(2); set rmargin at screen right(2)
  set title "(f) relief at 2 kN m: from where it grows"; set yrange [0.3:40]; set ytics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30)
  plot for [k=1:2] dampers(whole[k], "relief", "threshold") using 1:($2 > 0 ? $2 : NaN) with lines lw 2 lc rgb colour[which[k]] title names[which[k]]
  unset multiplot
  unset logscale y
}
