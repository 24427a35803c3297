# fig10.gp - Figure 10 from results/fig09.csv, fig10.csv, boundary_points.csv
load "scripts/pictures/regions.gp"
file = "results/fig10.csv"
# the diagram in (a): 4 curve, 5 shimmy, 6 type, 7 V, 8 c_d of results/fig09.csv, a block a curve
shown = pick("fig09 panel=a k_s=1e6 blocks=curve")
extremum(y) = strcol(6) eq "LP" ? y : NaN
bp(shimmy, V, c) = shimmy eq "psi" ? (c < 8000 ? "BP1" : "BP3") : (c < 12000 ? "BP2_l" : "BP2_u")
widest = number("widths width layout=li2 b=0")
stats curve("l2", "0", "onset") using 6 name "onset" nooutput
stats curve("l2", "0", "meet") using 6 name "meet" nooutput
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1200,1000 font "DejaVu Sans,13" } \
  else { set terminal svg size 1200,1000 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  # (b) the boundary points over k_s
  set lmargin at screen 0.53; set rmargin at screen 0.98; set bmargin at screen 0.56; set tmargin at screen 0.95
  set title "(b) boundary points and zero-shimmy region" offset 0,-0.5
  set xrange [0.4:1.6]; set yrange [0:25]
  set xlabel "k_s (MN m/rad)"; set ylabel "c_d (kN m s/rad)"
  set label 1 "BP3" at 1.45,21.4 tc ls 13; set label 2 "BP1" at 1.45,2.0 tc ls 11
  set label 3 "BP2_u" at 0.915,23 tc ls 12; set label 4 "BP2_l" at 1.15,5.6 tc ls 12
  set label 5 sprintf("%.4g MN m/rad", mega*meet_max) at mega*meet_max+0.02,3.2
  set label 6 sprintf("%.4g MN m/rad", mega*onset_max) at mega*onset_max+0.02,9.2
  plot region("l2", "0", file) using (mega*$1):(kilo*$2):(kilo*$3) with filledcurves fc rgb grey, \
       curve("l2", "0", "BP1|meet") using (mega*$6):(kilo*$7) with lines ls 11, \
       curve("l2", "0", "BP3|meet") using (mega*$6):(kilo*$7) with lines ls 13, \
       curve("l2", "0", "BP2_l|BP2_u|onset") using (mega*$6):(kilo*$7) with lines ls 12
  unset label
  # (c) the width
  set lmargin at screen 0.08; set rmargin at screen 0.98; set bmargin at screen 0.08; set tmargin at screen 0.44
  set title "(c) width in damping of the zero-shimmy region" offset 0,-0.5
  set xrange [0.4:2.4]; set yrange [0:11]
  set ylabel "width (kN m s/rad)"
  set label 1 "BP1 to BP3" at 0.64,8.5 right; set label 2 "BP2_u to BP3" at 0.735,2.6 right tc ls 12
  set label 3 "BP1 to BP2_l" at 1.0,1.9 left tc ls 12; set arrow 1 from 0.74,2.6 to 0.797,2.6
  set arrow 2 from mega*onset_max,kilo*widest to mega*onset_max,0 nohead dt 3
  plot region("l2", "0", file) using (mega*$1):($1 <= onset_max ? kilo*$4 : NaN) with lines lc rgb "black" lw 2, \
       region("l2", "0", file) using (mega*$1):($1 > onset_max ? kilo*$4 : NaN) with lines ls 12
  unset label; unset arrow
  # (a) the four boundary points in the (V, c_d) plane
  set lmargin at screen 0.08; set rmargin at screen 0.45; set bmargin at screen 0.56; set tmargin at screen 0.95
  set title "(a) boundary points, k_s = 1 MN m/rad" offset 0,-0.5
  set xrange [0:80]; set yrange [0:60]
  set xlabel "V (m/s)"; set ylabel "c_d (kN m s/rad)"
  set label 1 "ψ-shimmy" at 18,45 center; set label 2 "δ-shimmy" at 38.5,19 center rotate by 90; set label 3 "ψ-shimmy" at 13,1.2 center font ",10"
  plot shown using 7:(kilo*$8) with lines ls 3, \
       shown using 7:(extremum(kilo*$8)) with points ls 7, \
       shown using 7:(extremum(kilo*$8)):(bp(strcol(5), $7, $8)) with labels offset 0,0.9
  unset label
  unset multiplot
  unset output
}
