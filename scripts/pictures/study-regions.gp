# study-regions.gp - zero-shimmy intervals of c_d over k_s, at the b of a study's base design
# areas: 1 k_s, 2 c_lo, 3 c_hi, 4 width
areas = sprintf("< build/bin/mlg areas %s/regions.%s.csv", folder, layout)
set terminal svg size 900,460 dynamic font "DejaVu Sans,15"
set output output
set logscale xy; set format x "10^{%T}"; set format y "10^{%T}"
set xlabel "k_s (N m/rad)"; set ylabel "c_d (N m s/rad)"
set style fill solid 1.0 noborder
finite(x) = x > 0 && x < 1e20
if (base_k_s > 0 && z_hi > z_lo && z_lo > 0) { set arrow 1 from base_k_s,z_lo to base_k_s,z_hi nohead lw 2 front }
plot areas using (finite($1) ? $1 : NaN):($2 > 0 ? $2 : 1e-3):(finite($3) ? $3 : 1e12) with filledcurves fc rgb "#b7e3c0"
unset output
