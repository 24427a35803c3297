# study-history.gp - psi and delta* after psi' = 1 rad/s at a study's base design
file = sprintf("%s/history.%s.csv", folder, layout)
set terminal svg size 900,380 dynamic font "DejaVu Sans,14"
set output output
set multiplot layout 1,2 margins screen 0.09,0.985,0.15,0.95 spacing screen 0.11,0.1
set xlabel "t (s)" offset 0,0.4
set ylabel "ψ (deg)"
plot file using (column("t")):(column("psi")*180/pi) with lines lw 1.5 lc rgb "#1f4fd8"
set ylabel "δ* (mm)"
plot file using (column("t")):(1e3*column("dstar")) with lines lw 1.5 lc rgb "#d9730d"
unset multiplot
unset output
