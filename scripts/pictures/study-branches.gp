# study-branches.gp - shimmy along V at one of a study's telling c_d: largest psi or delta*
# branches: 1 layout, 2 which, 3 c_d, 4 branch, 5 type, 6 V, 7 psi_max, 8 dstar_max, 9 stable, 10 whole
# Wants diagram, what ("psi" or "dstar").
file = sprintf("%s/branches.csv", folder)
rows(b) = sprintf("< build/bin/mlg pick %s layout=%s which=%s branch=%s", file, layout, diagram, b)
all = sprintf("< build/bin/mlg pick %s layout=%s which=%s", file, layout, diagram)
branches = cell(sprintf("%s branch each layout=%s which=%s", file, layout, diagram))
size = what eq "psi" ? 7 : 8
s = what eq "psi" ? 1. : 1000.
is(type, y) = strcol(5) eq type ? y : NaN
part(y) = column(10) == 0 ? y : NaN
stable(y) = column(9) == 1 ? y : NaN
set terminal svg size 460,330 fixed font "DejaVu Sans,13"
set output output
set xrange [0:V_top]; set xlabel "V (m/s)" offset 0,0.4
set title diagram[1:strstrt(diagram, ".") - 1] . sprintf(", c_{d} = %s N m s/rad", cell(sprintf("%s c_d layout=%s which=%s", file, layout, diagram)))
set ylabel (what eq "psi" ? "max ψ (deg)" : "max δ* (mm)")
set yrange [0:*]
# each branch has the name of its shimmy at its largest
name(b) = cell(sprintf("%s/cycles.csv shimmy layout=%s which=%s branch=%s", folder, layout, diagram, b))
do for [b in branches] {
  if (b ne "straight") {
    stats rows(b) using 6:(s*column(size)) nooutput
    set label (name(b) eq "psi" ? "ψ" : name(b) eq "delta" ? "δ" : name(b)) at STATS_pos_max_y,STATS_max_y offset 0.8,0.6 front
  }
}
plot for [b in branches] rows(b) using 6:(part(s*column(size))) with lines lw 6 lc rgb "#d0d0d0", \
     for [b in branches] rows(b) using 6:(s*column(size)) with lines ls 2, \
     for [b in branches] rows(b) using 6:(stable(s*column(size))) with lines ls 1, \
     all using 6:(is("HB", s*column(size))) with points ls 5, \
     all using 6:(is("TR", s*column(size))) with points ls 6, \
     all using 6:(is("BP", s*column(size))) with points pt 5 ps 0.7 lc rgb "#000000", \
     all using 6:(is("LP", s*column(size))) with points pt 9 ps 0.9 lc rgb "#7b3fa0"
unset output
