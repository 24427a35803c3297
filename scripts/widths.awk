# widths.awk - a run of c.boundary.width or c.boundary.rival as rows of widths.csv
#   awk -v layout=li1 -f auto.awk -f widths.awk b.RUN
# The points that AUTO labels: multiples of 10 of b, and where another limit takes
# over.  limit, by closing: what ends the growth of the width over k_s.
# After the largest b the stationary width is a minimum; those rows are left out.
function name(i) {
  if (value["ratio_" i] > 1) return value["kind_" i] < 0 ? "BP2_u" : "BP2_l"
  if (value["kind_" i] > 0) return "BP3"
  return value["f_" i] < 9 ? "BP1" : "psi3"
}

function row(b) {
  return sprintf("%s,%s,%.10g,%.10g,%.10g,%.8g,%.6g,%.6g,%s,%s,%s", layout, b, 1e5 / value["compliance"], \
    value["c_" (n - 1)], value["c_" n], value["width"], value["V_" (n - 1)], value["V_" n], name(n - 1), name(n), \
    limit[value["closing"] + 0])
}

BEGIN {
  limit[0] = "onset of the delta region"
  limit[1] = "BP2_u reaches the lower bound"
  limit[2] = "none: the width is stationary"
}

{
  for (n = 1; ("V_" (n + 1)) in value; n++) ;
  b = value["b"]
  if (rows++ > 0 && b < b_was) turned = 1
  b_was = b
  tens = int(b / 10 + 0.5) * 10
  whole = (b - tens) ^ 2 < 1e-12
  if (!turned && (type == "UZ" || (type == "EP" && whole))) print row(whole ? tens : sprintf("%.8g", b))
}
