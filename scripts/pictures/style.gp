# style.gp - one look for every figure; loaded before the figure's own file.
# Lines: stable solid blue, unstable dashed red; Hopf curves red, torus curves
# purple.  Points: Hopf filled red, torus open circle, double Hopf black.
# Call with figure='figNN'; draws results/figNN.png.new and .svg.new, which draw of
# lib.sh puts in place when they are whole.
if (!exists("figure")) { print "style.gp: say which figure, as in gnuplot -e \"figure='fig06'\""; exit status 2 }
picture(ending) = sprintf("results/%s.%s.new", figure, ending)
set encoding utf8
set datafile separator ","
set style line 1 lc rgb "#1f4fd8" lw 2             # stable
set style line 2 lc rgb "#d62728" lw 1.6 dt (6,4)  # unstable
set style line 3 lc rgb "#d62728" lw 2             # Hopf curve
set style line 4 lc rgb "#7b3fa0" lw 2 dt (10,4)   # torus curve
set style line 5 lc rgb "#d62728" pt 7 ps 0.9      # Hopf point
set style line 6 lc rgb "#000000" pt 6 ps 1.2 lw 1.5 # torus point
set style line 7 lc rgb "#000000" pt 7 ps 1.0      # double Hopf point
set style line 8 lc rgb "#000000" pt 3 ps 1.3 lw 1.5 # solutions A, B
set style line 9 lc rgb "#1f4fd8" lw 1.5           # bounds of the zero-shimmy region
grey = "#d9d9d9"
set border lw 1
set tics nomirror out
set format "%h" # without the leading blank of gnuplot's own, which shifts the labels
set key noautotitle

# Rows of a table of results/, "fig09 panel=a k_s=1e6 blocks=curve", and one of its cells (mlg
# help pick, mlg help cell).
pick(words) = "< build/bin/mlg pick ".words
cell(words) = system("build/bin/mlg cell " . words)
number(words) = real(cell("format=%.10e " . words)) # of "4e5" gnuplot makes none
where(file, column, value) = pick(sprintf("%s '%s=%s'", file, column, value))
value_of(words) = real(system("build/bin/mlg pick ".words)) # not of "4e5", see number

# The layouts of a table, in its order; their names, and a colour for each
layouts_of(file) = system("build/bin/mlg pick ".file." columns=layout | grep -v '^#' | awk '!seen[$0]++' | tr '\\n' ' '")
layout_name(layout) = system("echo ".layout." | tr a-z A-Z")
colours = "#000000 #1f4fd8 #2a9d5c #e08214 #b5179e #8c564b #7f7f7f #17a2b8 #a8a81c #d62728 #5a7f5a #7b3fa0"
colour_of(layouts, k) = word(colours, (k - 1) % words(colours) + 1)
