# compare.awk - are two tables of branches the same curves?
#
#   awk -f compare.awk KEYS=2 committed.csv fresh.csv
#
# The first KEYS columns name the branch, the others are numbers, type and
# stable. Both files must have the same columns, branches, special points and
# changes of stability in the same order, and each row of one must lie within
# 2e-3 of the curve through the rows of the other, in units of the extent of
# that curve in each column. How many rows a curve has does not matter: straight
# pieces between them are 1e-3 off at most.
#
# Each difference gives a line (the first ten of them), and exit status 1.
BEGIN { FS = ","; tolerance = 2e-3 }

function complain(text) {
  if (++complaints <= 10) print text
}

FNR == 1 { side++; head = "" }

/^#/ { next }

head == "" {
  head = heads[side] = $0
  for (k = 1; k <= NF; k++) if (k > KEYS && $k != "type" && $k != "stable") number[k] = 1
    else if ($k == "type") type = k
    else if ($k == "stable") stable = k
  columns = NF
  next
}

{
  key = $1
  for (k = 2; k <= KEYS; k++) key = key "," $k
  if (!((side, key) in rows)) order[side] = order[side] " " key
  i = ++rows[side, key]
  for (k in number) {
    if ($k !~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/) complain(FILENAME ":" FNR ": '" $k "' is no number")
    x[side, key, i, k] = $k
    if (i == 1 || $k < least[side, key, k]) least[side, key, k] = $k
    if (i == 1 || $k > most[side, key, k]) most[side, key, k] = $k
  }
  if ($type != "") marks[side, key] = marks[side, key] " " $type
  else if (stable && $stable "" != was[side, key] "") {
    marks[side, key] = marks[side, key] " stable=" $stable
    was[side, key] = $stable
  }
}

# Squared distance of a row from a piece of the other side's curve
function distance(key, from, i, to, j,    k, scale, a, b, p, along, square, t, d) {
  along = square = d = 0
  for (k in number) {
    scale = most[1, key, k] - least[1, key, k]
    if (scale == 0) scale = 1
    a[k] = x[to, key, j, k] / scale
    b[k] = x[to, key, j + 1, k] / scale - a[k]
    p[k] = x[from, key, i, k] / scale - a[k]
    along += p[k] * b[k]
    square += b[k] ^ 2
  }
  t = square > 0 ? along / square : 0
  t = t < 0 ? 0 : t > 1 ? 1 : t
  for (k in number) d += (p[k] - t * b[k]) ^ 2
  return d
}

function compare(key, from, to,    i, j, d, nearest, k, text) {
  for (i = 1; i <= rows[from, key]; i++) {
    nearest = 1e30
    for (j = 1; j < rows[to, key]; j++) {
      d = distance(key, from, i, to, j)
      if (d < nearest) nearest = d
    }
    if (nearest > tolerance ^ 2) {
      text = ""
      for (k = KEYS + 1; k <= columns; k++) if (k in number) text = text " " x[from, key, i, k]
      complain(key ":" text " of the " (from == 1 ? "committed" : "fresh") " table is " \
               sprintf("%.2g", sqrt(nearest)) " away from the other")
    }
  }
}

END {
  if (side != 2 || heads[1] != heads[2]) complain("columns: " heads[1] " and " heads[2])
  if (order[1] == "" || order[1] != order[2]) complain("branches:" order[1] " and" order[2])
  n = split(order[1], keys, " ")
  for (m = 1; m <= n && !complaints; m++)
    if (marks[1, keys[m]] != marks[2, keys[m]])
      complain(keys[m] ": points" marks[1, keys[m]] " and" marks[2, keys[m]])
  for (m = 1; m <= n && !complaints; m++) {
    compare(keys[m], 1, 2)
    compare(keys[m], 2, 1)
  }
  if (complaints > 10) print "and " complaints - 10 " more"
  exit complaints > 0
}
