# damping.gp - least damping ratios from results/damping.csv and the maps
# build/tables/damping.*.csv (scripts/studies/damping.sh)
set datafile separator whitespace # of gnuplot's own contours, and so of all that is read here
picked(words) = pick(words)." | tr , ' '"
map(name) = sprintf("build/tables/damping.%s.csv", name)
# a map, a block for each value of its first column
blocks(name, first) = picked(sprintf("%s blocks=%s", map(name), first))
# rows of the table: 3 b, 4 k_s, 5 c_d, 6 zeta, 7 V
rows(layout, choice) = picked(sprintf("results/damping.csv where=layout=%s where=choice=%s", layout, choice))
best(layout) = layout eq "l1" ? rows(layout, "paper") : rows(layout, "best")
shown(b, layout) = b == (layout eq "l1" ? 0 : b_of(layout))
# the zero-shimmy intervals of c_d over k_s, and the widest of them
figure_of(layout) = layout eq "l2" ? "fig10" : layout eq "li1" ? "fig13" : "fig15"
b_of(layout) = layout eq "l2" ? "0" : "140"
region(layout) = picked(sprintf("results/%s.csv where=layout=%s where=b=%s 'where=k_s!=inf' columns=k_s,c_lo,c_hi", figure_of(layout), layout, b_of(layout)))
widest(layout) = picked(sprintf("results/widths.csv where=layout=%s where=b=%s columns=k_s,c_lo,c_hi", layout eq "l2" ? "li2" : layout, b_of(layout)))
layouts = "l1 l2 li1 li2"
array title[8] = ["(a1) L1", "(a2) L2, k_s = 475.5 kN m/rad", "(a3) LI1, k_s = 304.8 kN m/rad,\nb = 140 N m s^2/rad", "(a4) LI2, k_s = 1405 kN m/rad,\nb = 140 N m s^2/rad", \
                  "(b1) L1", "(b2) L2", "(b3) LI1, b = 140 N m s^2/rad", "(b4) LI2, b = 140 N m s^2/rad"]
set style line 21 lc rgb "#d62728" pt 3 ps 1.4 lw 2 # the best damped gear
set style line 22 lc rgb "#e08214" lw 2 pt 7 ps 0.8 # LI2
set style line 23 lc rgb "#2a9d5c" lw 2 pt 7 ps 0.8 # LI1
set style line 24 lc rgb "#000000" lw 1.5 dt (8,4)  # L1
set palette maxcolors 6 defined (-5.5 "#e3edf8", -4.5 "#9fc5e8", -3.5 "#3f7fbf", -2.5 "#0b2f66")
mark = "best(layout) using (log10(row ? $4 : $7)):(shown($3, layout) ? log10($5) : NaN) with points ls 21"
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1300 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1300 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  do for [panel=1:8] {
    col = (panel - 1) % 4; row = (panel - 1) / 4
    layout = word(layouts, col + 1)
    set lmargin at screen 0.055 + 0.222*col; set rmargin at screen 0.235 + 0.222*col
    set tmargin at screen 0.955 - 0.34*row; set bmargin at screen 0.72 - 0.34*row
    set title title[panel] offset 0,-0.6
    if (panel == 5) {
      unset colorbox
      set xrange [2.7:3.1]; set yrange [-2:4]; set xtics 0.1; set ytics 1
      set xlabel "c_d (kN m s/rad)" offset 0,0.3; set ylabel "least ζ over V (10^{-5})" offset 1.5,0
      plot 0 with lines ls 3, \
           picked(map("l1.c_d")) using (1e-3*$1):(1e5*$2) with lines lw 2 lc rgb "#000000", \
           best("l1") using (1e-3*$5):(1e5*$6) with points ls 21
    } else {
      i = row ? 1 : 2; j = row ? 2 : 1
      table = row ? layout.".k_s" : layout
      first = row ? "k_s" : "c_d"
      set contour base; unset surface; set cntrparam levels discrete 0
      set table $zero
      set autoscale
      splot blocks(table, first) using (log10(column(i))):(log10(column(j))):3
      unset table
      unset contour; set surface
      set cbrange [-5.5:-2.5]
      set ylabel (col == 0 || row ? "c_d (kN m s/rad)" : "") offset (row ? 0.75 : 1.5),0
      set ytics ("0.1" 2, "0.3" log10(300), "1" 3, "3" log10(3e3), "10" 4, "30" log10(3e4))
      if (row) {
        set xrange [log10(2.86e5):log10(col == 3 ? 4e6 : 2e6)]; set yrange [log10(2e3):log10(3e4)]
        set xtics ("0.3" log10(3e5), "0.5" log10(5e5), "1" 6, "2" log10(2e6), "4" log10(4e6))
        set xlabel "k_s (MN m/rad)" offset 0,0.3
      } else {
        set xrange [0:log10(200)]; set yrange [2:log10(8e4)]
        set xtics ("1" 0, "3" log10(3), "10" 1, "30" log10(30), "100" 2)
        set xlabel "V (m/s)" offset 0,0.3
      }
      if (panel == 4) {
        set colorbox user origin screen 0.925,0.46 size screen 0.014,0.495
        set cbtics ("10^{-5}" -5, "3·10^{-5}" -4.5, "10^{-4}" -4, "3·10^{-4}" -3.5, "10^{-3}" -3)
        set label 1 "least ζ" at screen 0.925,0.972
        set label 2 "ζ = 0" at screen 0.948,0.44
        set label 3 "best" at screen 0.933,0.415 point ls 21 offset 1.6,0
        set label 4 "widest\ninterval" at screen 0.948,0.39
        set arrow 1 from screen 0.925,0.44 to screen 0.942,0.44 nohead ls 3
        set arrow 2 from screen 0.933,0.373 to screen 0.933,0.397 nohead lc rgb "black" lw 2
      } else { unset colorbox }
      if (row) {
        plot blocks(table, first) using (log10(column(i))):(log10(column(j))):($3 > 0 ? log10($3) : NaN) with image, \
             for [k=2:3] region(layout) using (log10($1)):(log10(column(k))) with points pt 7 ps 0.3 lc rgb "#d62728", \
             widest(layout) using (log10($1)):(log10($2)):(0):(log10($3/$2)) with vectors nohead lc rgb "black" lw 2, \
             @mark
      } else {
        plot blocks(table, first) using (log10(column(i))):(log10(column(j))):($3 > 0 ? log10($3) : NaN) with image, \
             $zero using 1:2 with lines ls 3, @mark
      }
      unset label; unset arrow
    }
  }
  unset colorbox
  set lmargin at screen 0.065; set rmargin at screen 0.98
  set tmargin at screen 0.29; set bmargin at screen 0.055
  set title "(c) the best least ζ over V, by the choice of c_d and k_s" offset 0,-0.6
  set logscale y
  set xrange [0:300]; set yrange [4e-6:2e-3]; set xtics 20
  set ytics ("10^{-5}" 1e-5, "10^{-4}" 1e-4, "10^{-3}" 1e-3)
  set xlabel "b (N m s^2/rad)"; set ylabel "least ζ over V" offset 0.2,0
  stats best("l1") using 6 name "l1" nooutput
  set label 1 "L1" at 293,1.2*l1_max right
  set label 2 "L2 (b = 0)" at 2,4.4e-5 tc rgb "#1f4fd8"
  set label 3 "LI2, best damped" at 200,1.15e-3 center tc ls 22
  set label 4 "LI2, widest interval" at 240,7.4e-5 center tc ls 22
  set label 5 "LI1, best damped" at 130,2.7e-4 left tc ls 23
  set label 6 "LI1, widest interval" at 174,2.2e-5 left tc ls 23
  plot l1_max with lines ls 24, \
       rows("li1", "widest") using 3:6 with linespoints ls 23 dt (4,3), \
       rows("li2", "widest") using 3:6 with linespoints ls 22 dt (4,3), \
       rows("li1", "best") using 3:6 with linespoints ls 23, \
       rows("li2", "best") using 3:6 with linespoints ls 22
  unset label; unset logscale y
  unset multiplot
  unset output
}
