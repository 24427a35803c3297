# shimmy.awk - psi- or delta-shimmy?  Which of the two angles is larger where
# the branch of orbits has its largest amplitude; they differ by a hundred
# times or more in the first case, and delta leads by 1.7 or more in the second.
#   awk -f auto.awk -f shimmy.awk d.RUN b.RUN
BEGIN { degree = atan2(0, -1) / 180 }

{
  psi = value["psi_max"] * degree
  delta = value["dstar_max"] / value["l_delta"]
  if (psi ^ 2 + delta ^ 2 > largest) { largest = psi ^ 2 + delta ^ 2; shimmy = delta > psi ? "delta" : "psi" }
}

END { print shimmy }
