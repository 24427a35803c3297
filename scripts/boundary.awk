# boundary.awk - runs of c.boundary.point as rows of results/boundary_points.csv
#   awk -v layout=li1 -v b=70 [-v every=N] -f auto.awk -f boundary.awk b.RUN...
# name: BP1 top of the low psi region, BP3 bottom of the high one, BP2_l and
# BP2_u bottom and top of a delta region, as in the paper's Fig. 10(a); psi3 top
# of a third psi region (it oscillates above 9 Hz, BP1 below); onset where a
# delta region is born, meet where two psi regions do; - any other.
function name(shimmy, extremum) {
  if (type == "LP") return shimmy == "delta" ? "onset" : "meet"
  if (shimmy == "delta") return extremum == "max" ? "BP2_u" : "BP2_l"
  if (value["c_1"] > 5e4) return "-"
  if (extremum == "max") return value["f_1"] < 9 ? "BP1" : "psi3"
  return value["f_1"] < 12 ? "BP3" : "-"
}

FILENAME != file {
  file = FILENAME
  curve = FILENAME
  sub(/.*\.b[0-9]+\./, "", curve)
  rows = 0
}

every == "" || ++rows % every == 1 || type != "" {
  k_s = value["compliance"] > 1e-8 ? sprintf("%.8g", 1e5 / value["compliance"]) : "inf"
  shimmy = value["ratio_1"] > 1 ? "delta" : "psi"
  extremum = value["kind_1"] > 0 ? "min" : "max"
  printf "%s,%s,%s,%s,%s,%s,%.8g,%.6g,%.7g,%s,%s\n", layout, b, curve, name(shimmy, extremum), \
    (type == "LP" || type == "UZ" ? type : ""), k_s, value["c_1"], value["V_1"], value["f_1"], extremum, shimmy
}
