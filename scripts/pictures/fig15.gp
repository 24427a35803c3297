# fig15.gp - Figure 15 from results/fig15.csv and widths.csv
load "scripts/pictures/regions.gp"
file = "results/fig15.csv"
bs = "0 50 80 100 120 140"
colours = "#000000 #1f4fd8 #2a9d5c #d62ad6 #e08214 #d62728"
widths = pick("widths layout=li2")
at(b) = pick("widths layout=li2 b=" . b)
bounds(b) = sprintf("< build/bin/mlg areas %s layout=li2 b=%s bounds", file, b)
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1200,1150 font "DejaVu Sans,13" } \
  else { set terminal svg size 1200,1150 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  set lmargin at screen 0.08; set rmargin at screen 0.97; set tmargin at screen 0.955; set bmargin at screen 0.46
  set title "(a) zero-shimmy regions" offset 0,-0.6
  set label 1 "dashed: the widest interval, where a δ region is born" at graph 0.985,0.05 right
  set logscale x
  set xrange [0.45:5]; set yrange [0:25]
  set xtics (0.5, 0.7, 1, 1.5, 2, 3, 4, 5)
  set xlabel "k_s (MN m/rad)"; set ylabel "c_d (kN m s/rad)"
  set key at graph 0.02,0.97 left top title "b (N m s^2/rad)" samplen 2
  plot for [i=1:6] region("li2", word(bs,i), file) using (mega*$1):(kilo*$2):(kilo*$3) with filledcurves fs transparent solid 0.10 noborder fc rgb word(colours,i) notitle, \
       for [i=1:6] bounds(word(bs,i)) using (mega*$1):(kilo*$2) with lines lw 2 lc rgb word(colours,i) title word(bs,i), \
       for [i=1:6] at(word(bs,i)) using (mega*$3):(kilo*$4):(0):(kilo*($5-$4)) with vectors nohead lw 2 dt (4,4) lc rgb word(colours,i) notitle
  unset key; unset label; unset logscale x
  set tmargin at screen 0.37; set bmargin at screen 0.065
  set title "(b) largest width in damping over k_s, limited by the onset of δ-shimmy at every b" offset 0,-0.6
  set xrange [0:300]; set yrange [0:24]; set xtics 20; set ytics 4
  set xlabel "b (N m s^2/rad)"; set ylabel "width (kN m s/rad)"
  set label 1 cell("format=%.0f widths width layout=li2 b=140") . " at b = 140" at 143,18.2 left
  plot widths using 2:(kilo*$6) with linespoints pt 7 ps 0.8 lw 2 lc rgb "#1f4fd8", \
       at("140") using 2:(kilo*$6) with points ls 8
  unset label
  unset multiplot
  unset output
}
