# layouts.gp - layouts LI3 to LI7, a row each, from results/layouts.csv, layouts_planes.csv,
# layouts_branches.csv, boundary_points.csv and widths.csv
load "scripts/pictures/regions.gp"
layouts = system("build/bin/mlg pick results/layouts_planes.csv columns=panel | awk '!/^#|panel/ && !seen[$0]++'")
array colour[5] = ["#d62728", "#1f4fd8", "#2a9d5c", "#e08214", "#7b3fa0"]
rows = words(layouts)
name(l) = "LI" . l[3:3]
value_of(l, c) = number(sprintf("layouts_planes %s panel=%s", c, l))
# the widest interval in hand of layout l at k_s: c_lo and c_hi
bound(l, c) = number(sprintf("layouts %s layout=%s nearest:k_s=%s", c, l, cell("layouts_planes k_s panel=" . l)))
branch(l) = where("results/layouts_branches.csv", "layout", l)
plane(l) = pick(sprintf("layouts_planes panel=%s blocks=curve", l))
widths(l) = pick(sprintf("widths layout=%s 'width>0'", l))
is(type, y) = strcol(3) eq type ? y : NaN
# a third psi region's curve, or where there is none BP3, which is then drawn over it
third(l, b) = words(system(sprintf("build/bin/mlg pick %s layout=%s b=%s name=psi3 columns=layout | grep %s", points, l, b, l))) ? "psi3|meet" : "BP3|meet"
psi(s) = strcol(2) eq s ? column(5) : NaN
top(row) = 0.985 - 0.158*(row - 1)

do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,2500 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,2500 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  do for [i=1:rows] {
    l = word(layouts, i)
    set tmargin at screen top(i); set bmargin at screen top(i) - 0.108
    # (a) shimmy over V
    set lmargin at screen 0.06; set rmargin at screen 0.32
    set title sprintf("(a%d) %s: b = %g, k_s = %.3g MN m/rad", i, name(l), value_of(l, "b"), mega*value_of(l, "k_s")) offset 0,-0.6
    set xrange [0:100]; set xtics 20; set xlabel "V (m/s)" offset 0,0.6
    if (l eq "li6") { set yrange [-0.6:24] } else { set yrange [-0.4:16] }
    set ytics 5; set ylabel "max ψ (deg)"
    set label 1 "c_d = 3.6·10^4" at graph 0.97,0.92 right
    plot for [s in "straight psi delta"] branch(l) using 4:(psi(s)) with lines ls 2, \
         for [s in "straight psi delta"] branch(l) using 4:(column(7) == 1 ? psi(s) : NaN) with lines ls 1, \
         branch(l) using 4:(is("HB", column(5))) with points ls 5, \
         branch(l) using 4:(is("TR", column(5))) with points ls 6
    unset label 1
    # (b) the plane
    set lmargin at screen 0.4; set rmargin at screen 0.655
    set title sprintf("(b%d) %s: Hopf curves", i, name(l)) offset 0,-0.6
    set yrange [10:8e4]; set logscale y; set format y "10^{%T}"; set ytics auto; set ylabel "c_d (N m s/rad)"
    set object 1 rectangle from 0,bound(l, "c_lo") to 100,bound(l, "c_hi") fc rgb grey fs noborder behind
    set label 1 "no shimmy" at 72,sqrt(bound(l, "c_lo")*bound(l, "c_hi")) center
    plot plane(l) using 7:(strcol(5) eq "psi" ? column(8) : NaN) with lines ls 3, \
         plane(l) using 7:(strcol(5) eq "delta" ? column(8) : NaN) with lines ls 3 dt (6,3), \
         plane(l) using 7:(strcol(6) eq "LP" ? column(8) : NaN) with points ls 7
    unset object 1; unset label 1; unset logscale y; set format y "%h"
    # (c) boundary points and region over k_s
    set lmargin at screen 0.73; set rmargin at screen 0.985
    b = sprintf("%g", value_of(l, "b"))
    set title sprintf("(c%d) %s: boundary points, b = %s", i, name(l), b) offset 0,-0.6
    if (l eq "li4") { set xrange [0.8:4]; set xtics 0.8 } else { set xrange [0.3:1.2]; set xtics 0.2 }
    set xlabel "k_s (MN m/rad)" offset 0,0.6
    set yrange [0:25]; set ytics 5; set ylabel "c_d (kN m s/rad)"
    if (l eq "li3") {
      set label 1 "BP3" at 0.95,22 right tc ls 13; set label 2 "BP1" at 0.5,1.9 tc ls 11
      set label 3 "BP2_l, BP2_u" at 0.84,9 tc ls 12
    }
    if (l eq "li5") { set label 1 "third ψ region" at 1.17,3.3 right tc ls 14 }
    plot region(l, b, "results/layouts.csv") using (mega*$1):(kilo*$2):(kilo*$3) with filledcurves fc rgb grey, \
         curve(l, b, third(l, b)) using (mega*$6):(kilo*$7) with lines ls 14, \
         curve(l, b, "BP3|meet") using (mega*$6):(kilo*$7) with lines ls 13, \
         curve(l, b, "BP1|meet") using (mega*$6):(kilo*$7) with lines ls 11, \
         curve(l, b, "BP2_l|BP2_u|onset") using (mega*$6):(kilo*$7) with lines ls 12
    unset label
  }
  # (d) the widest interval over b
  set lmargin at screen 0.06; set rmargin at screen 0.985
  set tmargin at screen 0.185; set bmargin at screen 0.027
  set title "(d) largest width in damping over k_s" offset 0,-0.6
  set xrange [0:300]; set xtics 20; set xlabel "b (N m s^2/rad)" offset 0,0.6
  set yrange [0:27]; set ytics 5; set ylabel "width (kN m s/rad)"
  set key left top horizontal Left reverse samplen 2 autotitle
  L2 = number("widths width layout=li2 b=0")
  plot kilo*L2 with lines lc rgb "#808080" lw 2 title "L2", \
       widths("li1") using 2:(kilo*$6) with lines lc rgb "#808080" dt (2,3) lw 2 title "LI1", \
       widths("li2") using 2:(kilo*$6) with lines lc rgb "#808080" dt (8,4) lw 2 title "LI2", \
       for [i=1:rows] widths(word(layouts, i)) using 2:(kilo*$6) with linespoints lc rgb colour[i] lw 2 pt 7 ps 0.6 title name(word(layouts, i))
  set key noautotitle
  unset multiplot
  unset output
}
