# fig07.gp - Figure 7 from results/fig07.csv
file = "results/fig07.csv"
# columns of the table: 1 curve, 2 shimmy, 3 type, 4 V, 5 c_d
curve(name) = where(file, "curve", name)
shimmy(kind) = pick(sprintf("%s shimmy=%s blocks=curve", file, kind))
is(type, y) = strcol(3) eq type ? y : NaN
# the zero-shimmy interval: from the LP of the low psi curve to that of the delta curve
stats curve("low") using (is("LP", $5)) name "low" nooutput
stats curve("delta") using (is("LP", $5)) name "delta" nooutput
c_lo = low_max
c_hi = delta_max
kilo = 1e-3 # the axis is in kN m s/rad

set style textbox opaque noborder fillcolor rgb "white" margins 0.6,0.4
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1200,900 font "DejaVu Sans,14" } \
  else { set terminal svg size 1200,900 font "DejaVu Sans,16" }
  set output picture(ending)
  set multiplot
  do for [panel in "plane inset"] {
    if (panel eq "plane") {
      set lmargin at screen 0.085; set rmargin at screen 0.975
      set bmargin at screen 0.095; set tmargin at screen 0.975
      set xrange [0:200]; set yrange [0:80]
      set xtics 20; set ytics 10
      set xlabel "V (m/s)"; set ylabel "c_d (kN m s/rad)" offset 0.5,0
      set label 1 "ψ-shimmy" at 17,74 center front boxed
      set label 2 "δ-shimmy" at 42,22 center front boxed
      set label 3 "no shimmy" at 130,68 center front boxed
      set label 4 "both" at 43,74 center front boxed
      set label 5 "ψ-shimmy" at 70,7.5 center front boxed
      set arrow 1 from 63,6 to 50,0.7 front
      set object 1 rectangle from graph 0,0 to graph 1,1 fs solid fc rgb grey behind
      set label 6 "T_δ" at 39,52.5 center front font ",12" boxed
      set label 7 "T_ψ" at 54,38 center front font ",12" boxed; set arrow 2 from 52.5,39.3 to 44.2,44.6 front
      set key at 197,63.5 right top Left reverse samplen 2.5 width -6 opaque
    } else {
      unset label; unset arrow; unset key
      set object 1 rectangle from screen 0.475,0.155 to screen 0.965,0.60 fs solid fc rgb "white" behind
      set lmargin at screen 0.55; set rmargin at screen 0.95
      set bmargin at screen 0.245; set tmargin at screen 0.575
      set xrange [0:80]; set yrange [2:4]
      set xtics 20; set ytics 0.5; set xlabel "V (m/s)" offset 0,0.5; set ylabel "c_d (kN m s/rad)" offset 1,0
      set label 1 "ψ-shimmy" at 11.5,2.25 center front boxed
      set label 2 "δ-shimmy" at 36,3.55 center front boxed
      set label 3 "zero-shimmy region" at 58,2.885 center front boxed
      set label 4 sprintf("%.2f < c_d < %.2f", c_lo, c_hi) at 58,2.62 center front boxed
      set object 2 rectangle from graph 0,0 to graph 1,1 fs solid fc rgb grey behind
    }
    plot for [name in "psi delta low"] curve(name) using 4:(kilo*$5) with filledcurves closed fc rgb "white" fs solid noborder, \
         shimmy("psi") using 4:(kilo*$5) with filledcurves closed fc rgb "#e08214" fs transparent pattern 5 noborder, \
         shimmy("delta") using 4:(kilo*$5) with filledcurves closed fc rgb "#2a9d5c" fs transparent pattern 4 noborder, \
         for [name in "psi delta low"] curve(name) using 4:(kilo*$5) with lines ls 3, \
         for [name in "torus_psi torus_delta"] curve(name) using 4:(kilo*$5) with lines ls 4, \
         kilo*c_lo with lines ls 9, kilo*c_hi with lines ls 9, \
         curve("psi") using 4:(is("HH", kilo*$5)) with points ls 7, \
         curve("psi") using 4:(is("HH", kilo*$5)):("HH") with labels offset 2.2,-0.5 boxed, \
         keyentry with lines ls 3 title "Hopf curves", \
         keyentry with lines ls 4 title "torus curves, T_ψ of ψ-, T_δ of δ-shimmy", \
         keyentry with lines ls 9 title "ends of the zero-shimmy interval"
  }
  unset multiplot
  unset object 2
  unset output
}
