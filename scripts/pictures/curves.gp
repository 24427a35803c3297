# curves.gp - panels of Hopf curves from results/figNN.csv; loaded by the figure's
# own file, which has set
#   panels   their letters, columns, rows, width, height of the picture in pixels
#   title_X  the heading of panel X
#   key_y    top of the key, as a fraction of the panel's height
#   left_margin, bottom_margin, top_margin, gap_x, gap_y   of the screen; V_tics
#   c_lo, c_hi   range of the c_d axis, logarithmic; V_hi range of V
#   note_X   how many words panel X carries, note_X_1, ... "text|V|c_d" each
# One colour is one k_s in every figure, from blue for a soft to red for a stiff one,
# black for an infinite one; solid lines bound psi-, dashed ones delta-shimmy.
file = sprintf("results/%s.csv", figure)
# columns of the table: 1 panel, 2 b, 3 k_s, 4 curve, 5 shimmy, 6 type, 7 V, 8 c_d
list(what) = cell(sprintf("%s k_s each %s", file, what))
of_panel(p, kind) = list(sprintf("panel=%s shimmy=%s", p, kind))
rows(p, k, kind) = pick(sprintf("%s panel=%s k_s=%s shimmy=%s blocks=curve", file, p, k, kind))

# the k_s of Figures 9, 12 and 14; another one gets a shade between these
all_k = "4e5 4.4e5 4.6e5 4.8e5 5e5 5.2e5 5.4e5 5.9e5 6e5 6.2e5 6.7e5 7e5 8e5 8.4e5 1e6 1.4e6 1.5e6 2e6 2.1e6 3e6"
palette = "2b3a9f 2f7fd6 1aa6a6 3a9d3a a5a500 ef8a17 d9372b 8e1a6b"
stiffness(k) = real(k[1:strstrt(k, "e") - 1])*10**real(k[strstrt(k, "e") + 1:*]) # of "4e5" gnuplot makes no number
below(k) = sum [j=1:words(all_k)] (stiffness(word(all_k, j)) < 0.999*stiffness(k))
digit(t) = strstrt("0123456789abcdef", t) - 1
part(j, c) = 16*digit(substr(word(palette, j), 2*c - 1, 2*c - 1)) + digit(substr(word(palette, j), 2*c, 2*c)) # red, green or blue
mix(x, c) = (j = int(x) < words(palette) ? int(x) : words(palette) - 1, int(part(j, c) + (x - j)*(part(j + 1, c) - part(j, c))))
tint(x, light) = light ? int(x + 0.4*(255 - x)) : int(0.85*x) # neighbours are light and dark
shade(x, light) = sprintf("#%02x%02x%02x", tint(mix(x, 1), light), tint(mix(x, 2), light), tint(mix(x, 3), light))
colour(k) = k eq "inf" ? "#000000" : shade(1 + (words(palette) - 1.)*below(k)/(words(all_k) - 1.), int(below(k)) % 2)
power(k) = k eq "inf" ? "∞" : (e = strstrt(k, "e"), sprintf("%s·10^{%s}", k[1:e-1], k[e+1:*]))

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
