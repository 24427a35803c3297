# sweeps.gp - load x tolerance x layout, and zeta over caster and relaxation length,
# and shimmy with play (results/sweeps.csv, sweeps_map.csv, sweeps_play.csv; scripts/studies/sweeps.sh)
picked(words) = pick(words." | tr , ' '")
share(layout) = where("sweeps", "layout", layout)
map(layout) = pick(sprintf("sweeps_map layout=%s blocks=e", layout))
of_friction(T) = pick(sprintf("sweeps_play T_f=%s", "".T))
layouts = "l1 l2 li1 li2"
names = "L1 L2 LI1 LI2"
array device[4] = ["", "k_s = 786 kN m/rad", "k_s = 638 kN m/rad, b = 140 N m s^2/rad", "k_s = 2480 kN m/rad, b = 140 N m s^2/rad"]
set palette maxcolors 7 defined (-5.5 "#e3edf8", -4.5 "#9fc5e8", -3.5 "#3f7fbf", -2 "#0b2f66")
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1350 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1350 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  do for [panel=1:8] {
    col = (panel - 1) % 4; row = (panel - 1) / 4
    layout = word(layouts, col + 1)
    set lmargin at screen 0.06 + 0.222*col; set rmargin at screen 0.24 + 0.222*col
    set tmargin at screen 0.95 - 0.345*row; set bmargin at screen 0.695 - 0.345*row
    set title sprintf("(%s%d) %s\n{/*0.8 %s}", row ? "b" : "a", col + 1, word(names, col + 1), device[col + 1]) offset 0,-0.6
    if (row == 0) {
      unset colorbox
      set xlabel "static load F_z (kN)" offset 0,0.3
      set ylabel (col == 0 ? "gears free of shimmy (%)" : "") offset 1,0
      set xrange [140:260]; set yrange [0:100]; set xtics 20; set ytics 20
      set arrow 1 from 200,0 to 200,100 nohead lc rgb "grey" dt 3
      if (col == 0) { set label 1 "at some c_d\nof its own" at 186,86 left; set label 2 "at the one\nbest c_d" at 144,42 left tc ls 1 }
      plot share(layout) using (1e-3*$2):4 with lines lw 1.5 lc rgb "black" dt (6,4), \
           share(layout) using (1e-3*$2):6 with lines ls 1
      unset arrow 1
      unset label
    } else {
      set xlabel "caster e (m)" offset 0,0.3
      set ylabel (col == 0 ? "relaxation length l (m)" : "") offset 0.3,0
      set xrange [0.015:0.225]; set yrange [0.145:0.455]; set xtics 0.05; set ytics 0.05
      set cbrange [-5.5:-2]
      if (col == 3) {
        set colorbox user origin screen 0.93,0.35 size screen 0.014,0.255
        set cbtics ("10^{-5}" -5, "10^{-4}" -4, "10^{-3}" -3, "10^{-2}" -2)
        set label 1 "least ζ" at screen 0.93,0.622
      } else { unset colorbox }
      plot map(layout) using 4:5:($7 > 0 ? log10($7) : NaN) with image, \
           "+" using (0.12):(0.3) every ::::0 with points pt 3 ps 1.4 lw 2 lc rgb "#d62728"
      unset label
    }
  }
  unset colorbox
  set lmargin at screen 0.06; set rmargin at screen 0.46
  set tmargin at screen 0.26; set bmargin at screen 0.05
  set title "(c1) L1, V = 20 m/s: shimmy with play and a damper's friction T_f" offset 0,-0.6
  set xlabel "half-width of the play g_ψ (mrad)"; set ylabel "max ψ (deg)" offset 0,0
  set xrange [0.8:5.6]; set yrange [0:*]; set xtics 1; set ytics auto
  plot for [T=0:500:100] of_friction(T) using (1e3*$1):3 with linespoints lw 1.5 pt 7 ps 0.6 lc rgb word("#000000 #1f4fd8 #2a9d5c #e08214 #d62728 #7b3fa0", 1 + T/100), \
       for [T=0:500:100] of_friction(sprintf("%d g_psi=0.005", T)) using (1e3*$1):3:(sprintf("%d%s", T, T ? "" : " N m")) with labels left offset 0.5,0 font ",11"
  set lmargin at screen 0.53; set rmargin at screen 0.9
  set title "(c2) the same: max ψ over g_ψ" offset 0,-0.6
  set xlabel "half-width of the play g_ψ (mrad)"; set ylabel "friction T_f (N m)" offset -0.5,0
  set xrange [0.5:5.5]; set yrange [-50:550]; set ytics 100; set cbrange [0:12]
  set palette maxcolors 12 defined (0 "#e3edf8", 3 "#9fc5e8", 8 "#3f7fbf", 12 "#0b2f66")
  set colorbox user origin screen 0.93,0.05 size screen 0.014,0.21; set cbtics 2
  set label 1 "max ψ/g_ψ" at screen 0.92,0.28
  plot pick("sweeps_play blocks=T_f") using (1e3*$1):2:($3*pi/180/$1) with image
  unset label
  unset multiplot
  unset output
}
