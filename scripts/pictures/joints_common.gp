# joints_common.gp - what the pictures of scripts/studies/joints.sh share
set datafile separator whitespace # of gnuplot's own contours, and so of all that is read here
# an empty cell is no number, and not the one after it
picked(words) = pick(words)." | sed 's/^,/NaN,/; s/,$/,NaN/; s/,,/,NaN,/g; s/,,/,NaN,/g' | tr , ' '"
layouts = "l1 l2 li1 li2 li3"
degree = 180. / pi
array names[5] = ["L1", "L2", "LI1", "LI2", "LI3"]
array colour[5] = ["#000000", "#1f4fd8", "#2a9d5c", "#e08214", "#7b3fa0"]
array shade[4] = ["#9fc5e8", "#3f7fbf", "#0b2f66", "#000000"]
