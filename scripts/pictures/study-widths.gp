# study-widths.gp - the largest width over k_s as b grows, each layout with an inerter
# limits: 2 b, 6 width
colours = "#1f4fd8 #e08214 #2a9d5c #d62728 #7b3fa0"
set terminal svg size 640,380 fixed font "DejaVu Sans,14"
set output output
set xrange [0:b_most]; set yrange [0:*]
set xlabel "b (N m s²/rad)"; set ylabel "largest width over k_{s} (N m s/rad)"
set key below
plot for [i=1:words(layouts)] sprintf("%s/limits.%s.csv", folder, word(layouts, i)) using ($2 >= 0 ? $2 : NaN):6 with lines lw 2 lc rgb word(colours, i) title system("echo " . word(layouts, i) . " | tr a-z A-Z")
unset output
