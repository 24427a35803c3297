# cycle.awk - one branch of shimmy as a row of cycles.csv (cycles.sh)
#   lines type,V,psi_max,dstar_max,stable: its points; orbit,phase,t,psi,dstar,lambda_L,lambda_R
#   (degrees, metres): orbits on it.  row: the cells before; born: the mode of its Hopf point,
#   and 1, or 0 for a part of a branch; e: phi l_delta a k_t F_z l alpha_m; top, V_least: the
#   speeds at which a branch is left
# stable, unstable: its points without a type; end: why it goes no further (Hopf point, V_top,
#   V_least, psi_max, dstar_max, branch point; AUTO: nothing more was found)
# slip: largest slip angle over alpha_m; roll: largest unloading a mu k_t/2 over F_z/2, mu of (16)
BEGIN {
  FS = OFS = ","
  split(e, v, " ")
  degree = atan2(0, -1) / 180
}
function size(x) { return x < 0 ? -x : x }
$1 == "orbit" {
  mu = sin(v[1]) * sin($4 * degree) + cos(v[1]) * sin($5 / v[2]) * cos($4 * degree)
  mu = atan2(mu, sqrt(1 - mu * mu))
  if (size(v[3] * mu * v[4] / v[5]) > roll) roll = size(v[3] * mu * v[4] / v[5])
  for (k = 6; k <= 7; k++) if (size(atan2($k, v[6])) / v[7] > slip) slip = size(atan2($k, v[6])) / v[7]
  next
}
{
  if (!n++) from = to = $2
  if ($2 + 0 < from + 0) from = $2
  if ($2 + 0 > to + 0) to = $2
  if ($3 + 0 > psi) psi = $3 + 0
  if ($4 + 0 > dstar) dstar = $4 + 0
  if ($1 == "TR") torus = torus (torus == "" ? "" : " ") $2
  if ($1 == "BP") branch_points = branch_points (branch_points == "" ? "" : " ") $2
  if ($1 == "LP") folds = folds (folds == "" ? "" : " ") $2
  if ($1 == "" && $5 == 1) stable++
  if ($1 == "" && $5 == 0 && $5 != "") unstable++
  type = $1
  V = $2
  last_psi = $3
  last_dstar = $4
}
function end() {
  if (born ~ /,0$/) return "AUTO"
  if (row ~ /,1$/) return "Hopf point"
  if (V > 0.9999 * top) return "V_top"
  if (V < 1.0001 * V_least) return "V_least"
  if (last_psi > 59.99) return "psi_max"
  if (last_dstar > 0.29999) return "dstar_max"
  return type == "BP" ? "branch point" : "AUTO"
}
END {
  if (n) print row, from, to, psi, dstar, torus, folds, stable + 0, unstable + 0, sprintf("%.3g", slip), sprintf("%.3g", roll), born, end(), branch_points
}
