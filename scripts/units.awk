# units.awk - units of parameters, results and states by their names
#   awk -f units.awk ... models/mlg.h models/*.c ...
# from the tables in these files, lines X(..., "name", "unit", ...
BEGIN { unit["period"] = "s"; unit["torus_angle"] = "rad" }

FILENAME ~ /models\/[^\/]*$/ {
  if (/X\(.*, *"/) { split($0, quoted, "\""); unit[quoted[2]] = quoted[4] }
  next
}

function unit_of(name) {
  sub(/^(MAX|MIN) /, "", name)
  return unit[name]
}

# "V m/s; c_d N m s/rad" of list[1] to list[n], as far as they have a unit
function units(list, n,    k, text) {
  for (k = 1; k <= n; k++)
    if (unit_of(list[k]) != "") text = text (text == "" ? "" : "; ") list[k] " " unit_of(list[k])
  return text
}

# AUTO's dictionaries of names, in the head of b.
$1 == "0" && ($2 == "parnames" || $2 == "unames") {
  split($0, quoted, "'")
  for (k = 1; k in quoted; k += 2)
    if (match(quoted[k], /[0-9]+:/)) {
      slot = substr(quoted[k], RSTART, RLENGTH - 1) + 0
      if ($2 == "unames") state[slot] = quoted[k + 1]
      else parameter[slot] = quoted[k + 1]
    }
}
