# sections.gp - past the torus points, from results/sections.csv, tori.csv, fig06.csv
file = "results/sections.csv"
rows(part, V) = pick(sprintf("%s where=part=%s where=V=%s", file, part, V))
branch(name) = pick(sprintf("results/fig06.csv where=panel=a where=branch=%s", name))
tori = where("results/tori.csv", "found", "torus")
# columns: sections 3 t, 4 psi, 5 dstar; tori 2 V, 5 psi_max; fig06 3 type, 4 V, 5 psi_max, 7 stable
mm = 1000.
if_stable(y, yes) = (column(7) == 1) == yes ? y : NaN
stable = 'pt 7 ps 1.6 lc rgb "#1f4fd8"'
unstable = 'pt 6 ps 1.6 lw 2 lc rgb "#d62728"'
set palette defined (0 "#fde725", 0.35 "#35b779", 0.65 "#31688e", 1 "#440154")

do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,1050 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,1050 font "DejaVu Sans,13" }
  set output picture(ending)
  unset ytics; set ytics nomirror out
  set multiplot layout 2,2 margins 0.07,0.93,0.065,0.955 spacing 0.145,0.105
  set xlabel "δ* (mm), at the maxima of ψ" offset 0,0.4
  set ylabel "ψ (deg)" offset 0.8,0
  set key top right opaque box lc rgb "#bbbbbb" width 1
  set xrange [-7.5:7.5]
  do for [V in "26.5 32"] {
    from = V eq "32" ? "psi" : "delta"
    to = V eq "32" ? "delta" : "psi"
    set title sprintf("(%s)  V = %s m/s: from the %s orbit to the %s orbit", V eq "32" ? "b" : "a", V, \
                      from eq "psi" ? "ψ" : "δ", to eq "psi" ? "ψ" : "δ") offset 0,-0.6
    set yrange [-1:V eq "32" ? 2 : 3.5]
    set cbrange [0:V eq "32" ? 800 : 200]; set cbtics V eq "32" ? 200 : 50
    set label 1 "t (s)" at graph 1.055,1.035 center
    plot rows("past", V) using (mm*$5):4:3 with points pt 7 ps 0.35 lc palette, \
         rows(from, V) using (mm*$5):4 with points @unstable title "unstable", \
         rows(to, V) using (mm*$5):4 with points @stable title "stable"
  }
  unset colorbox; unset label 1
  set title "(c)  V = 29 m/s: two stable orbits, an unstable torus" offset 0,-0.6
  set yrange [0:3]
  plot rows("torus", "29") using (mm*$5):4 with points pt 7 ps 0.3 lc rgb "#7b3fa0", \
       NaN with points pt 7 ps 1.1 lc rgb "#7b3fa0" title "unstable torus", \
       rows("psi", "29") using (mm*$5):4 with points @stable title "stable", \
       rows("delta", "29") using (mm*$5):4 with points @stable
  set title "(d)  the tori between the torus points, c_d = 3.6×10^4 N m s/rad" offset 0,-0.6
  set xlabel "V (m/s)"; set ylabel "max ψ (deg)" offset -0.3,0
  set xrange [25:34.5]; set yrange [-0.1:4]; set ytics 1
  plot for [b in "psi delta"] branch(b) using 4:(if_stable($5, 1)) with lines ls 1, \
       for [b in "psi delta"] branch(b) using 4:(if_stable($5, 0)) with lines ls 2, \
       for [b in "psi delta"] branch(b) using 4:(strcol(3) eq "TR" ? $5 : NaN) with points ls 6, \
       tori using 2:5 with points pt 7 ps 1.1 lc rgb "#7b3fa0" title "unstable torus", \
       NaN with points ls 6 title "torus point", NaN with lines ls 1 title "stable orbit", NaN with lines ls 2 title "unstable orbit"
  set colorbox
  unset multiplot
  unset output
}
