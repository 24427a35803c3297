# regions.gp - functions shared by Figures 10, 13 and 15; loaded by them
# columns of boundary_points.csv: 1 layout, 2 b, 3 curve, 4 name, 5 type, 6 k_s,
# 7 c_d, 8 V, 9 frequency_hz, 10 extremum, 11 shimmy
kilo = 1e-3 # axes in kN m s/rad
mega = 1e-6 # and MN m/rad
points = "results/boundary_points.csv"
# the boundary points of these names, "BP1|meet", a block a curve
curve(layout, b, names) = pick(sprintf("%s layout=%s b=%s 'name=%s' k_s!=inf blocks=curve smooth=k_s,c_d", points, layout, b, names))
# the zero-shimmy intervals: 1 k_s, 2 c_lo, 3 c_hi, 4 width
region(layout, b, file) = sprintf("< build/bin/mlg areas %s layout=%s b=%s", file, layout, b)
set style line 11 lc rgb "#1f4fd8" lw 2   # BP1
set style line 12 lc rgb "#2a9d5c" lw 2   # BP2_l, BP2_u
set style line 13 lc rgb "#d62728" lw 2   # BP3
set style line 14 lc rgb "#e08214" lw 2   # third psi region
