# branch.awk - one AUTO run as rows of a table
#   awk -v prefix=a,psi -v columns="V psi_max dstar_max stable type"
#       [-v every=N] [-v hopf=FILE] [-v reverse=1] -f auto.awk -f branch.awk d.RUN b.RUN
# columns are AUTO's, and stable (1 yes, 0 no; a bifurcation point, where both
# meet, has 1) and type (HB, HH, TR, LP, ... or nothing).
# every keeps each Nth row only, beside the first, the last and labelled ones.
# hopf is a points table that holds the straight run: a branch of orbits that
# closes gets the Hopf point it closes on as its last row (amplitude 0), after a
# check that its amplitude squared does run linearly into it.
function row(shown, closing,    k, cell, text) {
  text = prefix
  for (k = 1; k <= n_columns; k++) {
    if (wanted[k] == "type") cell = shown
    else if (wanted[k] == "stable") cell = stable || shown != "" ? 1 : 0
    else if (closing == "") cell = sprintf("%.6g", value[wanted[k]])
    else cell = wanted[k] == "V" ? sprintf("%.6g", closing) : 0
    text = text "," cell
  }
  rows_out[++n_rows] = text
  special[n_rows] = shown != ""
}

BEGIN { n_columns = split(columns, wanted, " ") }

{
  shown = type ~ /^(HB|TR|LP|BP|GH)$/ ? type : type == "ZH" && double_hopf(point) ? "HH" : ""
  if (constant["IPS"] == 2 && constant["ISW"] == 1 && ++orbits == 1) shown = "HB"
  row(shown, "")
  before = last; last = value["V"]
  before_norm = norm; norm = value["L2-NORM"]
}

END {
  if (closed) {
    zero = last + norm ^ 2 * (last - before) / (before_norm ^ 2 - norm ^ 2)
    while ((getline line < hopf) > 0) {
      split(line, cell, ",")
      if (cell[4] == "HB" && (end == "" || (cell[5] - zero) ^ 2 < (end - zero) ^ 2)) end = cell[5]
    }
    if (end == "" || (end - zero) ^ 2 > 0.05 ^ 2) {
      print FILENAME ": the branch ends at V = " zero ", where the straight run has no Hopf point (nearest " end ")" > "/dev/stderr"
      exit 1
    }
    row("HB", end)
  }
  if (every < 1) every = 1
  for (k = 1; k <= n_rows; k++)
    if (k % every == 0 || k == 1 || k == n_rows || special[k]) kept[++n_kept] = rows_out[k]
  for (k = 1; k <= n_kept; k++) print kept[reverse ? n_kept + 1 - k : k]
}
