# study-plane.gp - the (V, c_d) plane of a study: what grows where, Hopf and torus curves
# strips: 1 c_lo, 2 c_hi, 3 V_lo, 4 V_hi, 5 grows; plane: 1 curve, 2 kind, 3 shimmy, 4 type, 5 V,
# 6 c_d; torus, where there is one: 1 curve, 2 V, 3 c_d
# Wants c_lo, c_hi, telling (values of c_d), z_lo, z_hi (the interval), yours (c_d or 0).
strips = sprintf("%s/strips.%s.csv", folder, layout)
plane = sprintf("%s/plane.%s.csv", folder, layout)
torus = sprintf("%s/torus.%s.csv", folder, layout)
has_torus = system("test -s " . torus . " && echo 1") eq "1"
grows = "psi delta both divergence"
colours = "#c9d8f5 #fbdcb5 #dcc6e8 #bdbdbd"
titles = "ψ-shimmy δ-shimmy both divergence"
is_there(what) = real(system(sprintf("grep -c ',%s$' %s", what, strips))) > 0
has_point(type) = real(system(sprintf("grep -c ',%s,' %s", type, plane))) > 0
is(what, y) = strcol(5) eq what ? y : NaN
of(shimmy, y) = strcol(3) eq shimmy && strcol(4) ne "HH" && strcol(4) ne "LP" ? y : NaN
type(t, y) = strcol(4) eq t ? y : NaN
title_if(there, text) = there ? text : ""
set terminal svg size 640,560 fixed font "DejaVu Sans,14"
set output output
set xrange [0:V_top]; set yrange [c_lo:c_hi]; set logscale y; set format y "10^{%T}"
set xlabel "V (m/s)" offset 0,0.9; set ylabel "c_{d} (N m s/rad)"
set datafile missing NaN
set key below center horizontal samplen 1.5 width 1 maxrows 4
if (z_hi > z_lo) {
  set object 1 rectangle from 0,(z_lo > c_lo ? z_lo : c_lo) to V_top,(z_hi < c_hi ? z_hi : c_hi) fs solid 0.35 noborder fc rgb "#b7e3c0" behind
}
do for [i=1:words(telling)] { set arrow i from 0,real(word(telling, i)) to V_top,real(word(telling, i)) nohead dt 3 lw 1.2 lc rgb "#505050" front }
if (yours > 0) { set arrow 90 from 0,yours to V_top,yours nohead lw 2 lc rgb "#0a7d32" front }
set style fill solid 1.0 noborder
plot for [i=1:4] strips using (is(word(grows, i), 0.5*($3 + $4))):(sqrt($1*$2)):3:4:1:2 with boxxyerror fc rgb word(colours, i), \
     plane using 5:(of("psi", $6)) with lines lw 2 lc rgb "#1f4fd8" title title_if(has_point("psi"), "Hopf, ψ"), \
     plane using 5:(of("delta", $6)) with lines lw 2 lc rgb "#d9730d" title title_if(has_point("delta"), "Hopf, δ"), \
     (has_torus ? torus : "/dev/null") using 2:3 with lines ls 4 title title_if(has_torus, "torus"), \
     plane using 5:(type("LP", $6)) with points pt 7 ps 0.7 lc rgb "#d62728" title title_if(has_point("LP"), "boundary point"), \
     plane using 5:(type("HH", $6)) with points pt 7 ps 0.8 lc rgb "#000000" title title_if(has_point("HH"), "double Hopf"), \
     for [i=1:4] keyentry with boxes fc rgb word(colours, i) title title_if(is_there(word(grows, i)), word(titles, i)), \
     keyentry with boxes fc rgb "#d4eed9" title title_if(z_hi > z_lo, "no shimmy at any V"), \
     keyentry with lines dt 3 lc rgb "#505050" title title_if(words(telling) > 0, "diagrams below"), \
     keyentry with lines lw 2 lc rgb "#0a7d32" title title_if(yours > 0, "your c_{d}")
unset output
