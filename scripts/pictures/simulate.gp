# simulate.gp - a history from build/tables/NAME.csv; scripts/simulate.sh says figure='NAME'
file = sprintf("build/tables/%s.csv", figure)
set datafile commentschars "#"
deg = 180. / pi
limits = where(file, "event", "limit") # strcol would keep the last word where event is empty
# gnuplot warns of a plot without points; columns 6 and 7: lambda_L, lambda_R
dots = system(sprintf("grep -c ',limit$' %s", file)) == 0 ? "" : \
  ", for [k=6:7] limits using 1:(1000*column(k)) with points ls 5 title k == 6 ? 'a slip angle passes α_m' : ''"
set terminal pngcairo size 1200,900 font "DejaVu Sans,13"
set output sprintf("build/tables/%s.png.new", figure)
set multiplot layout 3,1 margins 0.08,0.98,0.07,0.97 spacing 0.1,0.03
set autoscale xfix
set format x ""
set ylabel "ψ (deg)" offset 1,0
plot file using "t":(deg*column("psi")) with lines ls 1
set ylabel "δ* (mm)"
plot file using "t":(1000*column("dstar")) with lines ls 1
set format x "%h"
set xlabel "t (s)" offset 0,0.4
set ylabel "tyre deflection (mm)"
set key top right
plot file using "t":(1000*column("lambda_L")) with lines ls 1 title "λ_L", \
     file using "t":(1000*column("lambda_R")) with lines lc rgb "#2a9d5c" lw 2 dt (12,12) title "λ_R" @dots
unset multiplot
unset output
