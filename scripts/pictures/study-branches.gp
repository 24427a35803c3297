# study-branches.gp - shimmy along V at a study's telling c_d: max psi and max delta*
# branches: 1 layout, 2 which, 3 c_d, 4 branch, 5 type, 6 V, 7 psi_max, 8 dstar_max, 9 stable
file = sprintf("%s/branches.csv", folder)
n = words(diagrams)
rows(d, b) = sprintf("< build/bin/mlg pick %s layout=%s which=%s branch=%s", file, layout, d, b)
all(d) = sprintf("< build/bin/mlg pick %s layout=%s which=%s", file, layout, d)
branches_of(d) = cell(sprintf("%s branch each layout=%s which=%s", file, layout, d))
c_d(d) = cell(sprintf("%s c_d layout=%s which=%s", file, layout, d))
name(d) = d[1:strstrt(d, ".") - 1]
is(type, y) = strcol(5) eq type ? y : NaN
stable(y) = column(9) == 1 ? y : NaN
set terminal svg size 900,(40 + 310*n) dynamic font "DejaVu Sans,14"
set output output
height = 40. + 310*n
set multiplot layout n,2 margins screen 0.09,0.985,55./height,(1. - 35./height) spacing screen 0.1,90./height
set xrange [0:V_top]; set xlabel "V (m/s)" offset 0,0.4
do for [i=1:n] {
  d = word(diagrams, i)
  b = branches_of(d)
  do for [k=1:2] {
    s = k == 1 ? 1. : 1000.
    set title name(d) . ": c_d = " . c_d(d) . " N m s/rad" offset 0,-0.6
    set ylabel (k == 1 ? "max ψ (deg)" : "max δ* (mm)") offset 0.5,0
    if (words(b) > 1) { set yrange [*:*] } else { set yrange [-0.1:1] }
    if (i == 1 && k == 1) { set key right top samplen 2 font ",12" } else { unset key }
    plot for [name_ in b] rows(d, name_) using 6:(s*column(6 + k)) with lines ls 2, \
         for [name_ in b] rows(d, name_) using 6:(stable(s*column(6 + k))) with lines ls 1, \
         all(d) using 6:(is("HB", s*column(6 + k))) with points ls 5, \
         all(d) using 6:(is("TR", s*column(6 + k))) with points ls 6, \
         all(d) using 6:(is("LP", s*column(6 + k))) with points pt 9 ps 0.9 lc rgb "#7b3fa0", \
         keyentry with lines ls 1 title "stable", keyentry with lines ls 2 title "unstable", \
         keyentry with points ls 5 title "Hopf", keyentry with points ls 6 title "torus", \
         keyentry with points pt 9 lc rgb "#7b3fa0" title "fold"
  }
}
unset multiplot
unset output
