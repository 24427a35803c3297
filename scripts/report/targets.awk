# targets.awk - the targets with what this run computed
#   awk -f targets.awk results/special_points.csv results/fig06.csv results/fig07.csv
#       results/boundary_points.csv results/fig12.csv results/widths.csv tests/targets.csv
BEGIN { FS = ","; CONVFMT = "%.9g" }

/^#/ { next }

# The k-th special point of that type in a run, in the order AUTO found them:
# point[run, type, k, column].
FILENAME ~ /special_points/ {
  if ($1 == "figure") { for (i = 1; i <= NF; i++) name[i] = $i; next }
  k = ++count[$3, $4]
  for (i = 5; i <= NF; i++) point[$3, $4, k, name[i]] = $i
  if ($4 == "UZ" && ($1 == 10 || $1 == 13) && $8 != "b") asked_c[$2, ++asked_points[$2]] = $6
  if ($4 == "UZ") for (i = 5; i <= NF; i++) point[$3, "V=" $5, 1, name[i]] = $i
  next
}

FILENAME ~ /fig06/ {
  if ($1 == "panel") next
  if ($2 != "straight") { if (!seen[$1, $2]++) branches[$1] = branches[$1] $2 " "; unstable[$1] += $7 == 0 }
  else if ($3 == "HB") hopf_points[$1]++
  next
}

# The torus run stops just short of a double Hopf point, whose row comes first
# and last in its curve: joined when what lies between is within 1 %.
FILENAME ~ /fig07/ {
  if ($1 ~ /^torus/ && $1 == curve && ($3 == "HH" || was == "HH") && near($4, V) && near($5, c_d)) ends[$1]++
  curve = $1; was = $3; V = $4; c_d = $5
  next
}

function near(x, y) { return (x - y) ^ 2 <= (0.01 * x) ^ 2 }

# Boundary points: the range of k_s in which a layout at one b has a delta
# region, and whether it is there at all; k_s inf counts as 1e30.
FILENAME ~ /boundary_points/ {
  if ($1 == "layout") next
  k_s = $6 == "inf" ? 1e30 : $6
  if ($11 == "delta") delta_at[$1, $2, ++deltas[$1, $2]] = k_s
  if ($4 == "onset") { onset[$1, $2] = k_s; born[$1, $2]++ }
  if ($4 == "meet") meet[$1, $2] = k_s
  if ($4 == "psi3" && $7 > third[$1, $2]) third[$1, $2] = $7
  if ($4 == "BP2_u" || $4 == "BP1") { n = ++rows[$1, $2, $4]; at[$1, $2, $4, n] = k_s; c[$1, $2, $4, n] = $7 }
  next
}

FILENAME ~ /widths/ {
  if ($1 == "layout") next
  width[$1, $2] = $6
  bound[$1, $2] = $9
  if (!($1 in largest) || $6 > largest[$1]) { largest[$1] = $6; best_b[$1] = $2; best_k_s[$1] = $3 }
  next
}

# A closed delta curve: its last point is its first.
FILENAME ~ /fig12/ {
  if ($1 == "panel" || $5 != "delta") next
  if ($2 SUBSEP $3 SUBSEP $4 != key) { key = $2 SUBSEP $3 SUBSEP $4; first = $7 "," $8 }
  else if ($7 "," $8 == first) closed_at[$2]++
  next
}

# c_d of a boundary point at one k_s, between AUTO's; empty outside its curve.
function c_at(layout, b, name, k_s,    i, n) {
  n = rows[layout, b, name]
  for (i = 1; i < n; i++)
    if ((at[layout, b, name, i] - k_s) * (at[layout, b, name, i + 1] - k_s) <= 0 && at[layout, b, name, i + 1] < 2 * at[layout, b, name, i])
      return c[layout, b, name, i] + (c[layout, b, name, i + 1] - c[layout, b, name, i]) * (k_s - at[layout, b, name, i]) / (at[layout, b, name, i + 1] - at[layout, b, name, i])
}

# The top of the delta region lies below BP1 at the first k_s, above it at the second.
function passes_BP1(b, below, above,    x, y) {
  x = c_at("li1", b, "BP2_u", below)
  y = c_at("li1", b, "BP2_u", above)
  return x != "" && y != "" && x < c_at("li1", b, "BP1", below) && y > c_at("li1", b, "BP1", above)
}

# No delta region for k_s between two values, but on both sides of them.
function without_delta(layout, b, from, to,    i, inside, below, above) {
  for (i = 1; i <= deltas[layout, b]; i++) {
    if (delta_at[layout, b, i] < from) below++
    else if (delta_at[layout, b, i] > to) above++
    else inside++
  }
  return !inside && above && (from == 0 || below) ? "yes" : "no"
}

function yes(x) { return x ? "yes" : "no" }

# c_d of the bounds at the k_s the paper names: the highest boundary point below
# the middle of the interval, the lowest above.
function asked(layout, which,    i, c, best) {
  for (i = 1; i <= asked_points[layout]; i++) {
    c = asked_c[layout, i]
    if (which == "lo" ? c < 8000 && (best == "" || c > best) : c > 8000 && (best == "" || c < best)) best = c
  }
  return best
}

# nothing where the table lacks what is to divide by
function ratio(x, y) { return y == 0 ? "" : x / y }

function gain(x, y) { return y == 0 ? "" : 100 * (x / y - 1) }

function value(run, type, k, column) { return point[run, type, k, column] }

function one_stable_branch(panel, kind) {
  return branches[panel] == kind " " && hopf_points[panel] == 2 && unstable[panel] == 0 ? "yes" : "no"
}

function joined(    c, n) { for (c in ends) n += ends[c] == 2; return n + 0 }

function computed(id) {
  if (id == "V-H1") return value("fig06.a.straight", "HB", 1, "V")
  if (id == "V-H2") return value("fig06.a.straight", "HB", 3, "V")
  if (id == "V-H3") return value("fig06.a.straight", "HB", 2, "V")
  if (id == "V-H4") return value("fig06.a.straight", "HB", 4, "V")
  if (id == "V-T1") return value("fig06.a.psi", "TR", 1, "V")
  if (id == "V-T2") return value("fig06.a.delta", "TR", 1, "V")
  if (id == "A-psi") return value("fig06.a.psi", "V=20", 1, "psi_max")
  if (id == "A-delta") return value("fig06.a.psi", "V=20", 1, "dstar_max")
  if (id == "B") return value("fig06.a.delta", "V=40", 1, "dstar_max")
  if (id == "S-b") return one_stable_branch("b", "delta")
  if (id == "S-c") return one_stable_branch("c", "psi")
  if (id == "Z-L1.lo") return value("fig07.low.up", "LP", 1, "c_d")
  if (id == "Z-L1.hi") return value("fig07.delta.down", "LP", 1, "c_d")
  if (id == "HH1.V") return value("fig07.psi.down", "HH", 1, "V")
  if (id == "HH1.c_d") return value("fig07.psi.down", "HH", 1, "c_d")
  if (id == "HH2.V") return value("fig07.psi.down", "HH", 2, "V")
  if (id == "HH2.c_d") return value("fig07.psi.down", "HH", 2, "c_d")
  if (id == "HH.torus") return joined()
  if (id == "D-L2") return without_delta("l2", 0, 0, 5.9e5)
  if (id == "M-L2") return meet["l2", 0]
  if (id == "I-L2") return onset["l2", 0]
  if (id == "Z-L2.lo") return asked("l2", "lo")
  if (id == "Z-L2.hi") return asked("l2", "hi")
  if (id == "W-L2") return asked("l2", "hi") - asked("l2", "lo")
  if (id == "W-L2.ratio") return ratio(asked("l2", "hi") - asked("l2", "lo"), value("fig07.delta.down", "LP", 1, "c_d") - value("fig07.low.up", "LP", 1, "c_d"))
  if (id == "W-L2.max") return width["li2", 0] # LI2 without inerter is L2
  if (id == "Z-LI1.lo") return asked("li1", "lo")
  if (id == "Z-LI1.hi") return asked("li1", "hi")
  if (id == "W-LI1") return largest["li1"]
  if (id == "W-LI1.b") return best_b["li1"]
  if (id == "W-LI1.k_s") return best_k_s["li1"]
  if (id == "W-LI1.gain") return gain(largest["li1"], width["li1", 0])
  if (id == "N-LI1.strip") return yes(passes_BP1(30, 3.8e5, 5e5))
  if (id == "N-LI1.closed") return yes(born["li1", 70] == 1 && closed_at[70])
  if (id == "N-LI1.third") return yes(third["li1", 20] < 100 && third["li1", 30] < 100 && third["li1", 70] > 100 && third["li1", 100] > 100 && third["li1", 130] > 100 && third["li1", 150] > 100)
  if (id == "N-LI1.limit") return yes(bound["li1", 150] == "psi3" && bound["li1", 130] == "BP1")
  if (id == "W-LI2") return width["li2", 140]
  if (id == "W-LI2.gain") return gain(width["li2", 140], width["li2", 0])
  if (id == "N-LI2") return without_delta("li2", 100, 8.6e5, 1.99e6)
}

function passes(x, converged, tolerance,    scale, t) {
  if (x == "") return "no"
  if (tolerance == "-") return x == converged ? "yes" : "no"
  split(tolerance, t, " ")
  scale = t[2] == "" ? (converged < 0 ? -converged : converged) : 1
  return (x - converged) ^ 2 <= (t[1] * scale) ^ 2 ? "yes" : "no"
}

$1 == "id" {
  print "# Paper against this run. paper: what its text says (figure: shown, not printed); converged: the value to reach;"
  print "# computed: this run; tolerance: relative, or in the unit where it names it."
  print "id,quantity,unit,paper,converged,computed,tolerance,pass"
  next
}

{
  x = computed($1)
  print $1 "," $3 "," $4 "," $5 "," $6 "," x "," $7 "," passes(x, $6, $7)
}
