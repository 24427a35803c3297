# tolerance.gp - tolerances over k_s and b, and of every layout's designs, results/tolerance_map.csv and
# tolerance.csv (scripts/studies/design.sh)
set datafile separator whitespace # of gnuplot's own contours
layouts = layouts_of("results/tolerance.csv")
n = words(layouts)
picked(words) = pick(words)." | tr , ' '"
map(layout) = picked(sprintf("results/tolerance_map.csv where=layout=%s columns=b,k_s,p blocks=b", layout))
designs(layout, design) = picked(sprintf("results/tolerance.csv where=layout=%s where=design=%s columns=k_s,b,p", layout, design))
# p of a design, over the place of its layout
place(layout) = sum [i=1:n] (word(layouts, i) eq layout ? i : 0)
every(design) = picked(sprintf("results/tolerance.csv where=design=%s columns=layout,p", design))
set palette maxcolors 8 defined (0 "#e3edf8", 1 "#9fc5e8", 2 "#3f7fbf", 3 "#0b2f66")
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1300,1060 font "DejaVu Sans,13" } \
  else { set terminal svg size 1300,1060 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot
  do for [panel=1:2] {
    layout = panel == 1 ? "li1" : "li2"
    set lmargin at screen 0.07 + 0.48*(panel - 1); set rmargin at screen 0.42 + 0.48*(panel - 1)
    set tmargin at screen 0.96; set bmargin at screen 0.53
    set title (panel == 1 ? "(a) LI1: tolerance p (%)" : "(b) LI2: tolerance p (%)") offset 0,-0.6
    set xrange [log10(panel == 1 ? 1e5 : 3e5):log10(panel == 1 ? 1e6 : 3e6)]
    set yrange [-5:(panel == 1 ? 165 : 280)]
    set xtics ("0.1" 5, "0.2" log10(2e5), "0.3" log10(3e5), "0.5" log10(5e5), "1" 6, "2" log10(2e6), "3" log10(3e6))
    if (panel == 1) { set ytics 20 } else { set ytics 50 }
    set cbrange [0:(panel == 1 ? 1.6 : 3.6)]
    set xlabel "k_s (MN m/rad)" offset 0,0.3; set ylabel "b (N m s^2/rad)" offset 0,0
    set colorbox user origin screen 0.43 + 0.48*(panel - 1),0.53 size screen 0.012,0.43
    plot map(layout) using (log10($2)):1:($3 > 0 ? $3 : NaN) with image, \
         designs(layout, "tolerant_b") using (log10($1)):2 with points pt 3 ps 1.6 lw 2 lc rgb "#d62728", \
         designs(layout, "tolerant") using (log10($1)):2 with points pt 1 ps 1.4 lw 2 lc rgb "#d62728", \
         designs(layout, "widest") using (log10($1)):2 with points pt 6 ps 1.4 lw 2 lc rgb "#d62728"
  }
  set lmargin at screen 0.07; set rmargin at screen 0.85; set tmargin at screen 0.43; set bmargin at screen 0.06
  set title "(c) tolerance p (%) of every layout's designs" offset 0,-0.6
  unset xtics; unset ytics; unset xlabel; set ylabel "p (%)"
  set xtics scale 0; do for [i=1:n] { set xtics add (layout_name(word(layouts, i)) i) }
  set xrange [0.5:n + 0.5]; set logscale y; set yrange [1e-4:10]
  set ytics ("0.0001" 1e-4, "0.001" 1e-3, "0.01" 1e-2, "0.1" 0.1, "1" 1, "10" 10)
  set grid y lc rgb "#dddddd"
  set key on at screen 0.995,0.42 top right Left reverse samplen 1
  plot every("tolerant_b") using (place(strcol(1))):2 with points pt 3 ps 1.6 lw 2 lc rgb "#d62728" title "most tolerant", \
       every("tolerant") using (place(strcol(1))):2 with points pt 1 ps 1.4 lw 2 lc rgb "#d62728" title "at one b", \
       every("damped") using (place(strcol(1))):2 with points pt 7 ps 1.1 lc rgb "#2a9d5c" title "best damped", \
       every("damped_b") using (place(strcol(1))):2 with points pt 7 ps 1.1 lc rgb "#2a9d5c" notitle, \
       every("widest") using (place(strcol(1))):2 with points pt 6 ps 1.4 lw 2 lc rgb "#1f4fd8" title "widest", \
       every("own") using (place(strcol(1))):2 with points pt 6 ps 1.4 lw 2 lc rgb "#1f4fd8" notitle, \
       every("paper") using (place(strcol(1))):2 with points pt 4 ps 1.3 lw 2 lc rgb "#000000" title "the paper's"
  unset logscale y; unset grid; unset key
  unset multiplot
  unset output
}
