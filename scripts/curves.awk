# curves.awk - Hopf curves as rows of a table, their extrema checked
#   awk -v name=NAME -v check=FILE -f auto.awk -f curves.awk NAME.curves NAME.extrema
#       prefix=TEXT closed_curve=closed b.RUN  prefix=TEXT closed_curve= b.RUN ...
# NAME.curves is from curves-LAYOUT, NAME.extrema from scan-LAYOUT.
# Prints TEXT,type,V,c_d; type LP: c_d has an extremum along the curve.  Points on
# a straight line between others, to the width of a line in print, are left out.
# Adds name, curves, closed ones, extrema, largest relative difference of c_d to
# FILE.  Status 1 when AUTO's curves lack an extremum that NAME.curves or
# NAME.extrema has, or have one beside those of NAME.curves.

FILENAME ~ /\.curves$/ {
  n_cell = split($0, cell, ",")
  if (cell[1] != "curve" && cell[n_cell] != "")
    for (i = split(cell[n_cell], at_V, " "); i > 0; i--) { split(at_V[i], pair, ":"); known_V[++n_known] = pair[1]; known_c[n_known] = pair[2] }
  next
}

FILENAME ~ /\.extrema$/ {
  split($0, cell, ",")
  if (cell[4] ~ /m/ && cell[1] > 10 && cell[1] < 8e4 && cell[2] > 0.1) { scan_V[++n_scan] = cell[2]; scan_c[n_scan] = cell[1] }
  next
}

FILENAME != file { if (n) finish(); file = FILENAME; text = prefix; round_ = closed_curve != "" }
{ n++; V[n] = value["V"]; c[n] = value["c_d"] }

function finish(    i, before, after, wiggle) {
  curves++
  if (round_) { closed_curves++; n++; V[n] = V[1]; c[n] = c[1] } # back at the start
  for (i = 1; i <= n; i++) {
    before = i > 1 ? c[i - 1] : round_ ? c[n - 1] : c[i]
    after = i < n ? c[i + 1] : round_ ? c[2] : c[i]
    kind[i] = (c[i] - before) * (after - c[i]) < 0 && !(round_ && i == n) ? "LP" : ""
    # AUTO's own noise on a flat stretch is no extremum
    wiggle = (c[i] - before) ^ 2 < (1e-9 * c[i]) ^ 2 || (after - c[i]) ^ 2 < (1e-9 * c[i]) ^ 2
    if (kind[i] == "LP" && !match_known(i) && wiggle) kind[i] = ""
    if (kind[i] == "LP" && !matched) unknown = unknown sprintf(" (%.6g, %.6g)", V[i], c[i])
  }
  thin()
  n = 0
}

# Which known extremum is at point i?
function match_known(i,    k, difference) {
  matched = 0
  for (k = 1; k <= n_known; k++) {
    difference = c[i] / known_c[k] - 1
    if (difference < 0) difference = -difference
    if (difference < 1e-6 && (V[i] - known_V[k]) ^ 2 < 1e-8) {
      matched = k
      if (!seen[k]++) n_seen++
      if (difference > worst) worst = difference
    }
  }
  return matched
}

# Keeps a point when leaving it out would move the line: V over 100 m/s, c_d over
# 4e4 N m s/rad or over two decades.
function thin(    from, i, k) {
  row(1)
  for (from = 1; from < n; from = i) {
    for (i = from + 1; i < n && kind[i] == "" && i - from < 40; i++) {
      for (k = from + 1; k <= i; k++)
        if (off_line(k, from, i + 1, 0) > 3e-4 ^ 2 || off_line(k, from, i + 1, 1) > 3e-4 ^ 2) break
      if (k <= i) break
    }
    row(i)
  }
}

function height(i, logarithmic) { return logarithmic ? log(c[i]) / log(100) : c[i] / 4e4 }

# The square of the distance of point k from the line between i and j.
function off_line(k, i, j, logarithmic,    x, y, dx, dy, length2, t) {
  x = (V[k] - V[i]) / 100; y = height(k, logarithmic) - height(i, logarithmic)
  dx = (V[j] - V[i]) / 100; dy = height(j, logarithmic) - height(i, logarithmic)
  length2 = dx ^ 2 + dy ^ 2
  t = length2 > 0 ? (x * dx + y * dy) / length2 : 0
  t = t < 0 ? 0 : t > 1 ? 1 : t
  return (x - t * dx) ^ 2 + (y - t * dy) ^ 2
}

function row(i) {
  printf (kind[i] == "" ? "%s,%s,%.6g,%.6g\n" : "%s,%s,%.8g,%.8g\n"), text, kind[i], V[i], c[i]
}

END {
  if (n) finish()
  for (i = 1; i <= n_known; i++)
    if (!seen[i]) missing = missing sprintf(" (%.6g, %.6g)", known_V[i], known_c[i])
  printf "%s,%d,%d,%d,%.1e\n", name, curves, closed_curves, n_seen, worst >> check
  for (i = 1; i <= n_scan; i++) {
    for (k = 1; k <= n_known; k++)
      if ((scan_c[i] / known_c[k] - 1) ^ 2 < 1e-12 && (scan_V[i] - known_V[k]) ^ 2 < 1e-8) break
    if (k > n_known) missing = missing sprintf(" (%.6g, %.6g)", scan_V[i], scan_c[i])
  }
  if (missing != "") print name ": no curve has the extrema" missing > "/dev/stderr"
  if (unknown != "") print name ": extrema too many:" unknown > "/dev/stderr"
  exit missing unknown != ""
}
