# fig06.gp - Figure 6 from results/fig06.csv
file = "results/fig06.csv"
panel(p) = where(file, "panel", p)
# columns of the table: 1 panel, 2 branch, 3 type, 4 V, 5 psi_max, 6 dstar_max, 7 stable
stable(y) = column(7) == 1 ? y : NaN
is(type, y) = strcol(3) eq type ? y : NaN
at(V, branch, y) = abs(column(4) - V) < 1e-6 && strcol(2) eq branch ? y : NaN

# the points of Figure 6 by their names: those of straight rolling by V, then those of a branch
at_rest(p) = pick(sprintf("%s panel=%s branch=straight type=HB", file, p))
name_at_rest(p, n) = p eq "a" ? word("H_1 H_3 H_2 H_4", n + 1) : word("H_1 H_2", n + 1)
tori(p) = p eq "a" ? 2 : 0
torus(branch) = pick(sprintf("%s panel=a branch=%s type=TR", file, branch))
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1200,1350 font "DejaVu Sans,13" } \
  else { set terminal svg size 1000,1125 font "DejaVu Sans,13" }
  set output picture(ending)
  set multiplot layout 3,2 margins 0.09,0.98,0.055,0.955 spacing 0.11,0.085
  set xrange [0:80]
  set xlabel "V (m/s)" offset 0,0.4
  do for [p in "a b c"] {
    c_d = p eq "a" ? "3.6×10^4" : p eq "b" ? "5.0×10^3" : "2.0×10^3"
    do for [i=1:2] {
      set title sprintf("(%s%d)  c_d = %s N m s/rad", p, i, c_d) offset 0,-0.6
      set ylabel i == 1 ? "max ψ (deg)" : "max δ* (mm)" offset 0,0
      s = i == 1 ? 1. : 1000.
      k = 4 + i
      top = i == 1 ? (p eq "a" ? 4.5 : p eq "b" ? 0.5 : 10) : (p eq "a" ? 15 : p eq "b" ? 12 : 1)
      set yrange [-0.1*top:top]
      if (p eq "a") {
        set label 1 "A" at 20, (i == 1 ? 3.669 + 0.32 : 0.457 + 0.9) center
        set label 2 "B" at 40, (i == 1 ? 0.527 + 0.32 : 12.15 + 0.9) center
      } else { unset label 1; unset label 2 }
      if (p eq "b" && i == 1) { set key at graph 0.985,0.95 right top samplen 2.5 spacing 1.15 width -1 font ",12" } else { unset key }
      plot for [b in "straight psi delta"] panel(p) using (strcol(2) eq b ? column(4) : NaN):(s*column(k)) with lines ls 2, \
           for [b in "straight psi delta"] panel(p) using (strcol(2) eq b ? column(4) : NaN):(stable(s*column(k))) with lines ls 1, \
           panel(p) using 4:(is("HB", s*column(k))) with points ls 5, \
           panel(p) using 4:(is("TR", s*column(k))) with points ls 6, \
           panel(p) using 4:(p eq "a" ? at(20, "psi", s*column(k)) : NaN) with points ls 8, \
           panel(p) using 4:(p eq "a" ? at(40, "delta", s*column(k)) : NaN) with points ls 8, \
           for [n=0:(p eq "a" ? 3 : 1)] at_rest(p) every ::n::n using 4:(s*column(k)):(name_at_rest(p, n)) with labels offset 0,-0.8 font ",12", \
           for [n=1:tori(p)] torus(word("psi delta", n)) using 4:(s*column(k)):(sprintf("T_%d", n)) with labels offset (n == 1 ? 1.5 : -1.4),0.7 font ",12", \
           keyentry with lines ls 1 title "stable", keyentry with lines ls 2 title "unstable", \
           keyentry with points ls 5 title "Hopf point H", keyentry with points ls 6 title "torus point T", keyentry with points ls 8 title "solutions A, B"
    }
  }
  unset multiplot
  unset output
}
