# study-history.gp - psi or delta* after psi' = 1 rad/s with a study's recommended design
# Wants what ("psi" or "dstar").
file = sprintf("%s/history.%s.csv", folder, layout)
psi = what eq "psi"
set terminal svg size 460,300 fixed font "DejaVu Sans,13"
set output output
set xlabel "t (s)" offset 0,0.4
set ylabel (psi ? "ψ (deg)" : "δ* (mm)")
plot file using (column("t")):(psi ? column("psi")*180/pi : 1e3*column("dstar")) with lines lw 1.5 lc rgb (psi ? "#1f4fd8" : "#d9730d")
unset output
