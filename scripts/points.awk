# points.awk - the special points of one AUTO run, as rows of special_points.csv
#   awk -v figure=6 -v layout=l1 -v run=NAME -f auto.awk -f points.awk d.RUN b.RUN
# Points on equilibria are exact to the digits shown; those of orbits carry the
# digits that doubling the mesh leaves unchanged (docs/runs.md).
function number(x, digits) { return x == "" ? "" : x >= 1e29 ? "inf" : sprintf("%." digits "g", x) }

type ~ /^(HB|ZH|TR|LP|BP|GH)$/ || (type == "UZ" && user_point()) {
  digits = constant["IPS"] == 2 || type == "ZH" ? 6 : 8
  kind = type == "ZH" && double_hopf(point) ? "HH" : type
  print figure "," layout "," run "," kind "," number(value["V"], digits) "," \
        number(value["c_d"], digits) "," number(value["k_s"], 8) "," number(value["b"], 8) "," \
        sprintf("%.5f", 1 / value["period"]) "," number(value["psi_max"], 6) "," number(value["dstar_max"], 6)
}

# A point the user asked for, and not a helper on either side of a TR.
function user_point() {
  return constant["IPS"] == 2 && constant["ISW"] == 1 && value["torus"] ^ 2 > 1e-6
}
