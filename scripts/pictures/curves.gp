# curves.gp - panels of Hopf curves from results/figNN.csv; loaded by the figure's
# own file, which has set
#   panels   their letters, columns, rows, width, height of the picture in pixels
#   title_X  the heading of panel X
#   key_y    top of the key, as a fraction of the panel's height
#   left_margin, bottom_margin, top_margin, gap_x, gap_y   of the screen; V_tics
#   c_lo, c_hi   range of the c_d axis, logarithmic; V_hi range of V
#   note_X   how many words panel X carries, note_X_1, ... "text|V|c_d" each
# One colour is one k_s within a figure, from blue for a soft to red for a stiff
# one, black for an infinite one; solid lines bound psi-, dashed ones delta-shimmy.
file = sprintf("results/%s.csv", figure)
# columns of the table: 1 panel, 2 b, 3 k_s, 4 curve, 5 shimmy, 6 type, 7 V, 8 c_d
list(what) = cell(sprintf("%s k_s each %s", file, what))
all_k = list("")
of_panel(p, kind) = list(sprintf("panel=%s shimmy=%s", p, kind))
rows(p, k, kind) = pick(file, sprintf("panel=%s k_s=%s shimmy=%s blocks=curve", p, k, kind))

palette = "#2b3a9f #2f7fd6 #1aa6a6 #3a9d3a #a5a500 #ef8a17 #d9372b #8e1a6b"
place(k) = sum [j=1:words(all_k)] (word(all_k, j) eq k ? j : 0)
finite = words(all_k) - (word(all_k, words(all_k)) eq "1e30")
shade(n) = word(palette, finite < 2 ? 1 : 1 + int(0.5 + (n - 1.) * (words(palette) - 1) / (finite - 1)))
colour(k) = k eq "1e30" ? "#000000" : shade(place(k))
power(k) = k eq "1e30" ? "∞" : (e = strstrt(k, "e"), sprintf("%s·10^{%s}", k[1:e-1], k[e+1:*]))

do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size width,height font "DejaVu Sans,14" } \
  else { set terminal svg size width,height font "DejaVu Sans,16" }
  set output picture(ending)
  set multiplot layout rows,columns margins left_margin,0.975,bottom_margin,top_margin spacing gap_x,gap_y
  do for [i = 1:words(panels)] {
    p = word(panels, i)
    set xrange [0:V_hi]; set yrange [c_lo:c_hi]; set logscale y
    set xtics V_tics; set mxtics 2
    set format y "10^{%T}"; set mytics 10
    set title value("title_" . p) offset 0,-0.6
    if (i > words(panels) - columns) { set xlabel "V (m/s)" offset 0,0.3 } else { unset xlabel }
    if (i % columns == 1 % columns) { set ylabel "c_d (N m s/rad)" offset 0.3,0 } else { unset ylabel }
    unset label
    do for [n = 1:value("note_" . p)] {
      note = value(sprintf("note_%s_%d", p, n))
      bar = strstrt(note, "|")
      where_ = note[bar + 1:*]
      bar_ = strstrt(where_, "|")
      set label n note[1:bar - 1] at real(where_[1:bar_ - 1]),real(where_[bar_ + 1:*]) center front font ",14"
    }
    set key at graph 0.985,key_y right top samplen 1.6 spacing 1.05 font ",12" title "k_s (N m/rad)" font ",12"
    if (of_panel(p, "delta") eq "") {
      plot for [k in of_panel(p, "psi")] rows(p, k, "psi") using 7:8 with lines lw 2 lc rgb colour(k) title power(k)
    } else {
      plot for [k in of_panel(p, "psi")] rows(p, k, "psi") using 7:8 with lines lw 2 lc rgb colour(k) title power(k), \
           for [k in of_panel(p, "delta")] rows(p, k, "delta") using 7:8 with lines lw 2 dt (6,3) lc rgb colour(k)
    }
  }
  unset multiplot
  unset output
}
