# doubts.gp - widths of the widest zero-shimmy interval along each doubt, from
# results/doubts.csv (scripts/studies/doubts.sh)
rows(doubt, layout, choice) = pick(sprintf("results/doubts.csv where=doubt=%s where=layout=%s where=choice=%s columns=value,width", doubt, layout, choice))
array doubt[4] = ["zB_shared", "R_moves", "heading", "I_p"]
array label[4] = ["(a) one z_B''", "(b) R_i differentiated", "(c) heading with -δ sin φ", "(d) polar inertia of the wheels"]
layouts = "l1 l2 li1 li2"
name(l) = l eq "l1" ? "L1" : l eq "l2" ? "L2" : l eq "li1" ? "LI1" : "LI2"
colour(l) = l eq "l1" ? "#000000" : l eq "l2" ? "#3f7fbf" : l eq "li1" ? "#2a9d5c" : "#e08214"
best(l) = l eq "l1" ? "paper" : "widest"
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,520 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,520 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot layout 1,4 margins 0.055,0.99,0.15,0.9 spacing 0.035,0
  set yrange [0:33]
  do for [i=1:4] {
    set title label[i]
    set xrange [0:(i == 4 ? 5 : 1)]
    set xlabel i == 4 ? "I_p (kg m²)" : doubt[i] noenhanced
    set ylabel i == 1 ? "width (kN m s/rad)" : "" offset -0.3,0
    if (i == 3) { set key top right Right samplen 2 } else { unset key }
    plot for [l in layouts] rows(doubt[i], l, best(l)) using 1:(1e-3*$2) with linespoints lw 2 pt 7 ps 0.7 lc rgb colour(l) title name(l), \
         for [l in "l2 li1 li2"] rows(doubt[i], l, "paper") using 1:(1e-3*$2) with linespoints lw 1.5 dt 2 pt 6 ps 0.7 lc rgb colour(l) title name(l)." of the paper"
  }
  unset multiplot
}
