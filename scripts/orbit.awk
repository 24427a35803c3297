# orbit.awk - a solution from scripts/table.sh at even steps of its phase
#
#   awk -F, -v solution=A -f orbit.awk
#
# Prints rows solution,phase,t,psi,dstar,lambda_L,lambda_R (results/filmstrip.csv).
BEGIN { steps = 96; degree = atan2(0, -1) / 180 }

/^# V = / { split($0, part, "l_delta = "); l_delta = part[2] + 0; next }
/^#/ { next }
!("t" in place) { for (i = 1; i <= NF; i++) place[$i] = i; next }
{
  n++
  t[n] = $place["t"]
  value["psi", n] = $place["psi"] / degree
  value["dstar", n] = $place["delta"] * l_delta
  value["lambda_L", n] = $place["lambda_L"]
  value["lambda_R", n] = $place["lambda_R"]
  psi = $place["psi"] ^ 2; delta = $place["delta"] ^ 2
  if (psi > most_psi) most_psi = psi
  if (delta > most_delta) most_delta = delta
}

END {
  large = most_psi > most_delta ? "psi" : "dstar"
  for (i = 1; i <= n; i++) if (!peak || value[large, i] > value[large, peak]) peak = i
  period = t[n] - t[1]
  for (k = 0; k <= steps; k++) {
    at = t[peak] + k % steps / steps * period
    if (at >= t[n]) at -= period
    for (i = 1; i < n - 1 && t[i + 1] <= at; i++) ;
    w = (at - t[i]) / (t[i + 1] - t[i])
    printf "%s,%.6f,%.7f", solution, k / steps, k / steps * period
    split("psi dstar lambda_L lambda_R", name, " ")
    for (j = 1; j <= 4; j++) printf ",%.4g", (1 - w) * value[name[j], i] + w * value[name[j], i + 1]
    printf "\n"
  }
}
