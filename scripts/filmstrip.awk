# filmstrip.awk - the gear at one instant as polylines, for scripts/filmstrip.gp
#
#   awk -F, -v solution=A -v view=top|rear -v part=wheels|strut|contact \
#       -v every=12 -v apart=1 [-v only=K] -v turns=.. -v bends=.. -v shifts=.. \
#       -f filmstrip.awk models/mlg.h results/filmstrip.csv
#
# Every so many instants one gear, APART metres to the right of the last; or
# only instant K, at 0.  turns, bends and shifts multiply psi, delta* and lambda.
# Prints "x y" in metres, x to the right and y forward (top) or up from the ground
# (rear); a blank line ends a polyline.  contact: the middle lines of the tyres from
# the leading contact points forward (top), where they stand on the ground (rear).
# The gear is the one of models/mlg.h, without rake; a tyre is 0.16 m wide.

function point(across, along) { printf "%.4f %.4f\n", x0 + across, along }

# across and along the axes of something that stands at (px, py), turned clockwise
function turned(u, v) { point(px + u * cos_a + v * sin_a, py - u * sin_a + v * cos_a) }

function top(    side, k) {
  cos_a = cos(psi); sin_a = sin(psi)
  for (side = -1; side <= 1; side += 2) {
    px = -dstar; py = 0 # C
    if (part == "wheels") {
      turned(side * a / 2 - w / 2, -e - R); turned(side * a / 2 + w / 2, -e - R)
      turned(side * a / 2 + w / 2, -e + R); turned(side * a / 2 - w / 2, -e + R)
      turned(side * a / 2 - w / 2, -e - R)
      print ""
    } else if (part == "contact") {
      for (k = 0; k <= 10; k++) turned(side * a / 2 + lambda[side] * exp(-k / 10 * 0.4 / l), -e + h + k / 10 * 0.4)
      print ""
    }
  }
  if (part == "strut") {
    turned(-a / 2, -e); turned(a / 2, -e); print ""
    turned(0, -e); turned(0, 0); print ""
  }
}

function rear(    side, foot) {
  px = 0; py = R + l_delta # B; delta turns C to the left
  cos_a = cos(dstar / l_delta); sin_a = sin(dstar / l_delta)
  for (side = -1; side <= 1; side += 2) {
    foot = -l_delta * sin_a + side * a / 2 * cos_a + lambda[side]
    if (part == "contact") { point(foot - w / 2, 0); point(foot + w / 2, 0); print "" }
    if (part != "wheels") continue
    turned(side * a / 2 - w / 2, -l_delta); turned(side * a / 2 - w / 2, -l_delta + R)
    turned(side * a / 2 + w / 2, -l_delta + R); turned(side * a / 2 + w / 2, -l_delta)
    point(foot + w / 2, 0); point(foot - w / 2, 0)
    turned(side * a / 2 - w / 2, -l_delta)
    print ""
  }
  if (part == "strut") {
    turned(-a / 2, -l_delta); turned(a / 2, -l_delta); print ""
    turned(0, -l_delta); turned(0, 0); print ""
  }
}

BEGIN { w = 0.16 }

FILENAME ~ /mlg\.h$/ { # X(15, A, "a", "m", 0.5, ...
  if (/^ *X\( *[0-9]+,/) { gsub(/[ "]/, "", $3); gear[$3] = $5 + 0 }
  next
}
FNR == 1 { a = gear["a"]; e = gear["e"]; R = gear["R"]; l_delta = gear["l_delta"]; h = gear["h"]; l = gear["l"] }

/^#/ || $1 != solution { next }

{
  k = n++
  if (only != "" ? k != only : k % every || $2 >= 1) next
  x0 = only != "" ? 0 : k / every * apart
  psi = turns * $4 * atan2(0, -1) / 180; dstar = bends * $5
  lambda[-1] = shifts * $6; lambda[1] = shifts * $7
  if (view == "top") top(); else rear()
}
