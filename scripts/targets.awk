# targets.awk - the targets with what this run computed
#   awk -f targets.awk results/special_points.csv results/fig06.csv results/fig07.csv tests/targets.csv
BEGIN { FS = "," }

/^#/ { next }

# The k-th special point of that type in a run, in the order AUTO found them:
# point[run, type, k, column].
FILENAME ~ /special_points/ {
  if ($1 == "figure") { for (i = 1; i <= NF; i++) name[i] = $i; next }
  k = ++count[$3, $4]
  for (i = 5; i <= NF; i++) point[$3, $4, k, name[i]] = $i
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
