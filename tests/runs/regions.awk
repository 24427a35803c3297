# regions.awk - do the Hopf curves bound exactly what the eigenvalues say?
#
#   awk -f regions.awk fig07.csv map.csv
#
# map.csv: the oracle's rows V,c_d,unstable_pairs, from any number of calls
# eigen-l1 map with c_d_n=3, so at three values of c_d close together. The
# number of unstable pairs at the middle one has to be the number of regions of
# the figure that hold the point; a Hopf curve, closed along the edge of the
# plane, is the border of one. Points nearer to a curve than its rows may be
# off are left out: within 0.2 m/s of it, or with different numbers at the
# three values of c_d.
#
# Each difference gives a line (the first ten of them), and exit status 1.
BEGIN { FS = "," }

/^#/ || $1 == "curve" { next }

FILENAME ~ /fig07/ {
  if ($1 ~ /^torus/) next
  if (!($1 in n)) curve[++curves] = $1
  n[$1]++
  V[$1, n[$1]] = $4
  c_d[$1, n[$1]] = $5
  next
}

$1 == "V" { finish(); next } # the head of a map

{ rows++; speed[rows] = $1; damping[rows] = $2; pairs[rows] = $3 }

# The speeds at which a curve passes c
function find_crossings(m, c,    i, j, name) {
  name = curve[m]
  crossings[m] = 0
  for (i = 1; i <= n[name]; i++) {
    j = i % n[name] + 1
    if ((c_d[name, i] < c) != (c_d[name, j] < c))
      crossing[m, ++crossings[m]] = V[name, i] + (V[name, j] - V[name, i]) * (c - c_d[name, i]) / (c_d[name, j] - c_d[name, i])
  }
}

# The regions that hold (v, c); -1 near a border
function regions(v,    m, i, before, sum) {
  for (m = 1; m <= curves; m++) {
    before = 0
    for (i = 1; i <= crossings[m]; i++) {
      if ((v - crossing[m, i]) ^ 2 < 0.2 ^ 2) return -1
      before += crossing[m, i] < v
    }
    sum += before % 2
  }
  return sum + 0
}

function finish(    third, i, m, here, inside) {
  third = rows / 3
  for (m = 1; m <= curves; m++) find_crossings(m, damping[1 + third])
  for (i = 1; i <= third; i++) {
    all++
    here = pairs[i + third]
    if (pairs[i] != here || pairs[i + 2 * third] != here) continue
    inside = regions(speed[i])
    if (inside < 0) continue
    tested++
    found[here]++
    if (inside != here && ++complaints <= 10)
      printf "V = %s, c_d = %s: %d unstable pairs, in %d regions\n", speed[i], damping[i + third], here, inside
  }
  rows = 0
}

END {
  finish()
  if (complaints > 10) print "and " complaints - 10 " more"
  printf "%d points tested of %d: %d without shimmy, %d with one, %d with two unstable pairs\n", \
         tested, all, found[0], found[1], found[2]
  if (!all || tested < 0.95 * all || !found[0] || !found[1] || !found[2]) {
    print "too few points tested, or none of a kind"
    complaints++
  }
  exit complaints > 0
}
