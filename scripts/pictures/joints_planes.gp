# joints_planes.gp - where play shimmies over V and c_d, from results/joints_planes.csv and
# joints_planes_cycles.csv (scripts/studies/joints.sh)
load "scripts/pictures/joints_common.gp"
# log10 of psi over the play; 3: it grows without play, too
table(name, layout, column) = picked(sprintf("results/%s.csv where=layout=%s blocks=V columns=V,c_d,ratio,%s", name, layout, column))
level(ratio, grows) = grows eq "inf" ? 3 : ratio > 0 ? log10(ratio) : -0.3
array play[3] = [0.1, 0.25, 0.5]
array by[2] = ["joints_planes", "joints_planes_cycles"]
array column_of[2] = ["ratio", "ratio_cycle"]
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,1000 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,1000 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  do for [panel=1:5] {
    layout = word(layouts, panel)
    x = (panel - 1) % 3; y = (panel - 1) / 3
    set lmargin at screen 0.06 + 0.32*x; set rmargin at screen 0.33 + 0.32*x
    set tmargin at screen 0.95 - 0.49*y; set bmargin at screen 0.57 - 0.49*y
    unset xlabel; unset ylabel; unset title; unset key
    do for [k=1:2] {
      do for [p=1:3] {
        set contour base; unset surface; set cntrparam levels discrete log10(1 + 0.1/play[p])
        set autoscale
        if (k == 1 && p == 1) { set table $b1 }; if (k == 1 && p == 2) { set table $b2 }; if (k == 1 && p == 3) { set table $b3 }
        if (k == 2 && p == 1) { set table $c1 }; if (k == 2 && p == 2) { set table $c2 }
        if (k == 2 && p == 3) { set table $c3 }
        splot table(by[k], layout, column_of[k]) using 1:(log10($2)):(level($4, strcol(3)))
        unset table
      }
    }
    unset contour; set surface
    set title names[panel] offset 0,-0.5
    set ylabel (x == 0 ? "c_d (kN m s/rad)" : ""); set xlabel (y == 1 || panel == 3 ? "V (m/s)" : "") offset 0,0.4
    set xrange [0:200]; set xtics 50; set yrange [log10(500):log10(5e4)]
    set ytics ("0.5" log10(500), "1" 3, "3" log10(3e3), "10" 4, "30" log10(3e4))
    if (panel == 5) { set key at screen 0.69,0.4 left top Left reverse samplen 3 spacing 1.4 }
    plot $c1 using 1:2 with lines lw 2.5 lc rgb shade[1] title "ψ over 0.2 deg at a play of 0.1 deg", \
         $c2 using 1:2 with lines lw 2.5 lc rgb shade[2] title "ψ over 0.35 deg at 0.25 deg", $c3 using 1:2 with lines lw 2.5 lc rgb shade[3] title "ψ over 0.6 deg at 0.5 deg", \
         $b1 using 1:2 with lines lw 1.4 dt (5,3) lc rgb shade[1], $b2 using 1:2 with lines lw 1.4 dt (5,3) lc rgb shade[2], \
         $b3 using 1:2 with lines lw 1.4 dt (5,3) lc rgb shade[3], \
         NaN with lines lw 1.4 dt (5,3) lc rgb shade[2] title "the same by describing functions", \
         picked(sprintf("results/joints_planes_hopf.csv where=layout=%s blocks=piece columns=V,c_d", layout)) using 1:(log10($2)) with lines ls 3 title "without play: shimmy begins"
    unset key
  }
  unset multiplot
}
