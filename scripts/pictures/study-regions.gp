# study-regions.gp - zero-shimmy intervals of c_d over k_s, at the b of a study's base design
# areas: 1 k_s, 2 c_lo, 3 c_hi, 4 width
# Wants k_lo, k_hi, c_least, c_most (the axes), base_k_s (0: rigid), z_lo, z_hi (its interval).
areas = sprintf("< build/bin/mlg areas %s/regions.%s.csv", folder, layout)
set terminal svg size 640,440 fixed font "DejaVu Sans,14"
set output output
set logscale xy; set format x "10^{%T}"; set format y "10^{%T}"
if (k_hi < 100*k_lo) { set xtics () ; do for [e=-3:20] { do for [m in "1 2 5"] { set xtics add (m . "·10^{" . e . "}" m*10.**e) } } }
if (k_hi < 4*k_lo) { unset logscale x; set xtics autofreq; set format x "%.1t·10^{%T}" }
if (c_most < 100*c_least) { set ytics (); do for [e=-3:20] { do for [m in "1 2 5"] { set ytics add (m . "·10^{" . e . "}" m*10.**e) } } }
set xrange [k_lo:k_hi]; set yrange [c_least:c_most]
set xlabel "k_{s} (N m/rad)"; set ylabel "c_{d} (N m s/rad)"
set style fill solid 1.0 noborder
if (z_hi > z_lo && z_lo > 0) { set arrow 1 from (base_k_s > 0 ? base_k_s : k_hi),z_lo to (base_k_s > 0 ? base_k_s : k_hi),z_hi nohead lw 3 front }
plot areas using 1:($2 > c_least ? $2 : c_least):(strcol(3) eq "inf" || $3 > c_most ? c_most : $3) with filledcurves fc rgb "#b7e3c0"
unset output
