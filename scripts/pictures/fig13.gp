# fig13.gp - Figure 13 from results/fig13.csv, boundary_points.csv, widths.csv
load "scripts/pictures/regions.gp"
file = "results/fig13.csv"
bs = "20 30 70 100 130 150"
widths(kind) = pick("widths layout=li1 " . kind)
tens = "b%10=0"
best = "'b>140' 'b<150'" # where the third psi region takes over: the largest of all
# what limits the width in turn (docs/boundary.md), and the b where it changes
changes = cell("widths b layout=li1 b%10!=0 each")
change(i) = i < 1 ? 0. : i > words(changes) ? 200. : real(word(changes, i))
limits = "'1  onset of the δ region' '2  BP2_u reaches BP1' '3  stationary above BP2_u' '4  BP2_u reaches BP1' '5  onset of the δ region' '6  the same, above the third ψ region' '7  BP2_u reaches the third ψ region'"
largest(column) = number(sprintf("widths %s layout=li1 largest=width", column))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,1300 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,1300 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  # the legend, above all panels
  set label 11 "BP3" at screen 0.15,0.983 tc ls 13; set label 12 "BP1" at screen 0.25,0.983 tc ls 11
  set label 13 "BP2_l, BP2_u" at screen 0.35,0.983 tc ls 12
  set label 14 "third ψ region" at screen 0.50,0.983 tc ls 14
  set label 15 "widest" at screen 0.68,0.983; set label 16 "zero-shimmy region" at screen 0.78,0.983 tc rgb "#808080"
  do for [i=1:6] {
    b = word(bs, i)
    col = (i - 1) % 3; row = (i - 1) / 3
    set lmargin at screen 0.07 + 0.32*col; set rmargin at screen 0.325 + 0.32*col
    set tmargin at screen 0.93 - 0.305*row; set bmargin at screen 0.705 - 0.305*row
    set title sprintf("(a%d) b = %s N m s^2/rad", i, b) offset 0,-0.6
    set xrange [0.3:1.0]; set yrange [0:20]; set xtics 0.2; set ytics 5
    set xlabel "k_s (MN m/rad)" offset 0,0.3; set ylabel "c_d (kN m s/rad)" offset 0,0
    plot region("li1", b, file) using (mega*$1):(kilo*$2):(kilo*$3) with filledcurves fc rgb grey, \
         curve("li1", b, "BP3|meet") using (mega*$6):(kilo*$7) with lines ls 13, \
         curve("li1", b, "BP1|meet") using (mega*$6):(kilo*$7) with lines ls 11, \
         curve("li1", b, "BP2_l|BP2_u|onset") using (mega*$6):(kilo*$7) with lines ls 12, \
         curve("li1", b, "psi3|meet") using (mega*$6):(kilo*$7) with lines ls 14, \
         widths("b=" . b) using (mega*$3):(kilo*$4):(0):(kilo*($5-$4)) with vectors nohead lc rgb "black" lw 2
    unset label # the legend, once is enough
  }
  set lmargin at screen 0.065; set rmargin at screen 0.965
  set tmargin at screen 0.31; set bmargin at screen 0.055
  set title "(b) largest width in damping over k_s" offset 0,-0.6
  set xrange [0:200]; set yrange [0:13]; set xtics 20; set ytics 2
  set xlabel "b (N m s^2/rad)"; set ylabel "width (kN m s/rad)" offset 0,0
  do for [i=1:7] {
    set label i sprintf("%d", i) at 0.5*(change(i - 1) + change(i)),12.3 center font ",12"
    set label 10 + i word(limits, i) at 62 + 52*((i - 1) / 4),5.3 - 1.1*((i - 1) % 4) left font ",12"
  }
  set label 20 sprintf("largest: %.1f at b = %.2f, k_s = %.4g MN m/rad", largest("width"), largest("b"), mega*largest("k_s")) at 118,7.2 center font ",12"
  plot widths("") using 2:(kilo*$6) with lines lc rgb "#1f4fd8" lw 2, \
       widths(tens) using 2:(kilo*$6) with points pt 7 ps 0.8 lc rgb "#1f4fd8", \
       widths("b%10!=0") using 2:(kilo*$6):(0):(13 - kilo*$6) with vectors nohead lc rgb "#808080" dt (3,4), \
       widths("b%10!=0") using 2:(kilo*$6) with points pt 6 ps 1.2 lw 1.5 lc rgb "#000000", \
       widths(best) using 2:(kilo*$6) with points ls 8
  unset label
  unset multiplot
  unset output
}
