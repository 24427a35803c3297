# ranked.awk - designs.csv by falling width, the same device in several layouts as one row
function value(width) { return width == "inf" ? 1e300 : width + 0 }
NR == 1 { print; next }
{
  key = $2
  for (i = 3; i <= 11; i++) key = key "," sprintf("%.6g", $i)
  if (key in at) { name[at[key]] = name[at[key]] " " $1; next }
  at[key] = ++n
  name[n] = $1
  row[n] = substr($0, length($1) + 1)
  width[n] = value($7)
}
END {
  while (n) {
    best = 0
    for (i = 1; i <= n; i++) if (!(i in done) && (!best || width[i] > width[best])) best = i
    if (!best) break
    done[best] = 1
    print name[best] row[best]
  }
}
