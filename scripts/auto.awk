# auto.awk - reads AUTO's d. and b. file, in this order; further awk programs build
# on it.  Every solution line of b. reaches them taken apart into
#   point, type, label, stable (AUTO's sign of PT), value["column name"]
# stable_count[point] is the number of stable eigenvalues or multipliers and
# eigenvalues[point] the list "re im re im ..." of them, from d.
# constant["IPS"], constant["ISW"], ... are the run's constants; left_out lists the
# types of points it is not to look for (SP).
#
# A branch of orbits that closes on a second Hopf point shrinks to nothing
# there.  AUTO then labels BP, or goes on along the zero solution, or turns and
# retraces the branch.  Each means the same, once the orbit has become small:
# closed is set, and what follows is left out.

# AUTO's numbers of labelled points (LBTYPE in its support.f90).
function type_name(code,    n, names) {
  if (code == -32) return "GH"
  if (code == 23 || code == 83) return "LTR"
  if (code == 77 || code == 87) return "PTR"
  if (code == 28 || code == 78) return "LPD"
  if (code == 88) return "TTR"
  split("MX R4 R3 R2 R1 UZ ZH CP BT - BP LP HB UZ LP BP PD TR EP", names, " ")
  n = code % 10
  return code == 0 || names[n + 10] == "-" ? "" : names[n + 10]
}

function trim(s) { gsub(/^ +| +$/, "", s); return s }

# d.: what stands there last for a point is of the point itself
FILENAME ~ /(^|\/)d\.[^\/]*$/ {
  if ($0 ~ /Stable:/) { stable_count[$2] = $NF; eigenvalues[$2] = "" }
  if ($0 ~ /Eigenvalue +[0-9]+:/) eigenvalues[$2] = eigenvalues[$2] " " $(NF - 1) " " $NF
  next
}

# b.: header lines start with branch 0; the constants, then the column names, which
# stand 19 characters apart.
$1 == "0" {
  line = substr($0, 5)
  if (line ~ /PT  TY  LAB/) {
    sub(/ +$/, "")
    columns = int((length($0) - 19 + 18) / 19)
    for (k = 1; k <= columns; k++) column[k] = trim(substr($0, 20 + 19 * (k - 1), 19))
  } else if (line ~ /^ *SP=/) {
    left_out = line
  } else if (line !~ /[{'\[]/)
    while (match(line, /[A-Z]+ *= *[^ ]+/)) {
      entry = substr(line, RSTART, RLENGTH)
      line = substr(line, RSTART + RLENGTH)
      split(entry, pair, / *= */)
      if (!(pair[1] in constant)) constant[pair[1]] = pair[2]
    }
  next
}

{
  point = $2 < 0 ? -$2 : $2
  stable = $2 < 0
  type = type_name($3)
  label = $4
  for (k = 1; k <= columns; k++) value[column[k]] = $(4 + k)
}

constant["IPS"] == 2 && constant["ISW"] == 1 {
  size = value["L2-NORM"]
  if (size > largest_size) largest_size = size
  moved = value[column[1]] - at
  turned = rows > 1 && moved * moved_before < 0
  if (rows > 0 && size < 0.3 * largest_size && (size < 1e-6 || type == "BP" || turned)) closed = 1
  rows++; at = value[column[1]]; moved_before = moved
}
closed { next }

# Four eigenvalues on the imaginary axis and off zero: AUTO calls every change
# of the stable count on a Hopf curve ZH.
function double_hopf(point,    n, i, on_axis, part) {
  n = split(eigenvalues[point], part, " ")
  for (i = 1; i < n; i += 2)
    if (part[i + 1] != 0 && part[i] ^ 2 < 1e-8 * part[i + 1] ^ 2) on_axis++
  return on_axis == 4
}
