# filmstrip.gp - solutions A and B over a period, from results/filmstrip.csv:
# the angles over time, below them the gear at eight instants, seen from above
# and from behind; and the same moving (.gif).
file = "results/filmstrip.csv"
turns = 5; bends = 10; shifts = 4 # psi, delta* and lambda are drawn so many times larger
gear(solution, view, part, choice) = sprintf("< build/bin/mlg strip %s solution=%s view=%s part=%s %s turns=%g bends=%g shifts=%g", file, solution, view, part, choice, turns, bends, shifts)
draw_gear = "plot gear(s, view, 'wheels', choice) with filledcurves closed fc rgb '#e4e4e4', gear(s, view, 'strut', choice) with lines ls 11, gear(s, view, 'contact', choice) with lines ls 12"
period(s) = number(sprintf("%s t solution=%s phase=1", file, s))
title(s) = sprintf("%s, %.1f Hz", s eq "A" ? "A: ψ-shimmy, V = 20 m/s" : "B: δ-shimmy, V = 40 m/s", 1. / period(s))
place(above, below) = sprintf("set tmargin at screen %g; set bmargin at screen %g", above, below)

red = "#d62728"; green = "#1a7f4b"
set style line 11 lc rgb "#000000" lw 2.5
set style line 12 lc rgb "#1f4fd8" lw 2.5
set style fill solid 1 border lc rgb "#000000"

do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,1250 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,1250 font "DejaVu Sans,13" }
  set output sprintf("results/filmstrip.%s.new", ending)
  set multiplot
  set label 1 sprintf("ψ is drawn %g times larger, δ* %g times, the tyres’ deflections %g times; blue: the tyres on the ground", turns, bends, shifts) at screen 0.5,0.017 center
  choice = "every=12 apart=1" # one metre of the gears' axis is an eighth of the period
  set lmargin at screen 0.065; set rmargin at screen 0.935
  do for [row=0:1] {
    s = row ? "B" : "A"
    above = 0.97 - 0.48 * row
    # the angles
    set datafile separator ","
    eval place(above, above - 0.115)
    set title title(s) offset 0,-0.6
    set border 15
    set xrange [-1./16:15./16]; set yrange [-4.5:4.5]; set y2range [-15:15]
    set xtics nomirror ("0" 0, "1/8" 1./8, "1/4" 2./8, "3/8" 3./8, "1/2" 4./8, "5/8" 5./8, "3/4" 6./8, "7/8" 7./8)
    set ytics nomirror (-4, -2, 0, 2, 4) tc rgb red
    set y2tics (-12, -6, 0, 6, 12) tc rgb green
    set xlabel "t / period" offset 0,0.6
    set ylabel "ψ (deg)" tc rgb red offset 1,0; set y2label "δ* (mm)" tc rgb green offset -1,0
    plot for [past=0:1] where(file, "solution", s) using ($2 - past):4 with lines lc rgb red lw 2, \
         for [past=0:1] where(file, "solution", s) using ($2 - past):(1e3 * $5) axes x1y2 with lines lc rgb green lw 2
    unset title; unset xtics; unset ytics; unset y2tics; unset xlabel; unset y2label; unset label 1
    # the gear, to scale but for what is drawn larger
    set datafile separator whitespace
    set border 0
    set xrange [-0.5:7.5]
    eval place(above - 0.163, above - 0.303)
    view = "top"; set yrange [-0.64:0.6]; set ylabel "from above" tc rgb "#000000" offset 0,0
    eval draw_gear
    eval place(above - 0.308, above - 0.443)
    view = "rear"; set yrange [-0.03:1.164]; set ylabel "from behind"
    eval draw_gear
  }
  unset multiplot
  unset output
}

set terminal gif animate delay 8 loop 0 size 480,440 font "DejaVu Sans,10"
set output "results/filmstrip.gif.new"
unset ylabel
set xrange [-0.6:0.6]
do for [k=0:92:4] {
  choice = sprintf("only=%d", k)
  set multiplot
  do for [row=0:1] {
    s = row ? "B" : "A"
    set lmargin at screen 0.5 * row + 0.02; set rmargin at screen 0.5 * row + 0.48
    set title title(s) offset 0,-0.6
    eval place(0.93, 0.5)
    view = "top"; set yrange [-0.64:0.6]
    eval draw_gear
    unset title
    eval place(0.46, 0.02)
    view = "rear"; set yrange [-0.03:1.164]
    eval draw_gear
  }
  unset multiplot
}
unset output
