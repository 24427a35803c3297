# solution.awk - the rows of scripts/table.sh for one solution over time
#   awk -v wanted=HB2 -f units.awk -f solution.awk -f auto.awk models/mlg.h models/*.c b.RUN s.RUN
# A solution in s. begins with a line of 16 numbers; of these 3 is the type, 4 the
# label, 7 the number of rows, 8 the length of a row (time from 0 to 1, then the
# states), 9 how many lines follow, 12 the number of parameters, which come last,
# 14 the number of states.  Rows and parameters stand 7 numbers to a line.
# Status 2, and one line that tells which solutions there are: none is called so.
FILENAME !~ /(^|\/)s\.[^\/]*$/ { next } # auto.awk gives its functions only

left == 0 {
  name = type_name($3)
  name = name (++seen[name])
  names = names " " name
  left = $9
  kept = name == wanted || $4 == wanted
  if (kept) { rows = $7; length_of_row = $8; states = $14; parameters = $12; n = 0 }
  next
}

{ left-- }
kept && (n < rows * length_of_row || left < int((parameters + 6) / 7)) {
  for (k = 1; k <= NF; k++) number[n++] = $k
}

END {
  if (!rows) {
    print "table: there is no solution '" wanted "'; there are" names > "/dev/stderr"
    exit 2
  }
  first = rows * length_of_row - 1 # PAR(slot) is number[first + slot]
  at = 0
  for (slot = 1; slot <= parameters; slot++)
    if (slot in parameter) {
      name = parameter[slot]
      at_text = at_text (at++ ? ", " : "# ") name sprintf(" = %.11g", number[first + slot]) (unit[name] ~ /^-?$/ ? "" : " " unit[name])
    }
  print at_text
  print "# t s; " units(state, states)
  line = "t"
  for (k = 1; k <= states; k++) line = line "," state[k]
  print line
  period = number[first + 11]
  for (row = 0; row < rows; row++) {
    line = sprintf("%.11g", number[row * length_of_row] * period)
    for (k = 1; k <= states; k++) line = line sprintf(",%.11g", number[row * length_of_row + k])
    print line
  }
}
