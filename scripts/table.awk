# table.awk - the rows of scripts/table.sh for a branch
#   awk [-v labelled=labels] -f units.awk -f auto.awk -f table.awk models/mlg.h models/*.c d.RUN b.RUN
function head(    k, text) {
  text = "point,label,type,name,stable"
  for (k = 1; k <= columns; k++) text = text "," column[k]
  return "# " units(column, columns) "\n" text
}

head() != heading {
  if (heading != "") {
    print "table: " FILENAME " holds branches of different columns; save them one by one" > "/dev/stderr"
    exit 2
  }
  print heading = head()
}

# AUTO counts no stable eigenvalues on curves of bifurcation points (ISW = 2)
constant["ISW"] ^ 2 == 4 || constant["IPS"] == 0 { stable = "" }

{
  name = label > 0 ? type (++seen[type]) : ""
  shown = type == "ZH" && double_hopf(point) ? "HH" : type
}

!labelled || label > 0 {
  row = point "," (label > 0 ? label : "") "," shown "," name "," stable
  for (k = 1; k <= columns; k++) row = row sprintf(",%.11g", value[column[k]])
  print row
}
