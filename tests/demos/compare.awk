# compare.awk - are the special points in two outputs of AUTO the same?
#
#   awk -f compare.awk reference output
#
# A special point is a line of AUTO's tables with a type (EP, LP, HB, ...).
# Both files must have the same ones in the same order: branch, type and label
# alike, and each number within 1e-3 of the reference, of its size or 1e-5 in
# all. A column MAX or MIN may differ by 1e-2: AUTO takes the extreme over the
# mesh points, and where these lie depends on rounding. The place of a point
# in its branch (PT) is not compared, it counts steps.
#
# Each difference gives a line, and exit status 1.

/^ *BR +PT +TY +LAB / {
  gsub(/(MAX|MIN|INTEGRAL) /, "&_")
  gsub(/ _/, "_")
  for (i = 5; i <= NF; i++)
    name[i - 4] = $i
}

/^ +-?[0-9]+ +-?[0-9]+ +[A-Z][A-Z] +[0-9]+ / {
  n = ++points[FILENAME == ARGV[1]]
  if (FILENAME == ARGV[1]) {
    id[n] = $1 " " $3 " " $4
    for (i = 5; i <= NF; i++)
      value[n, i - 4] = $i
    columns[n] = NF - 4
  } else if ($1 " " $3 " " $4 != id[n])
    differ("point " n, id[n], $1 " " $3 " " $4)
  else if (NF - 4 != columns[n])
    differ("columns of " id[n], columns[n], NF - 4)
  else
    for (i = 5; i <= NF; i++)
      if (!close_to(value[n, i - 4], $i, name[i - 4] ~ /^(MAX|MIN)_/ ? 1e-2 : 1e-3))
        differ(id[n] " " name[i - 4], value[n, i - 4], $i)
}

function close_to(want, have, tolerance,   size, off) {
  if (have !~ /^-?[0-9]+\.[0-9]+E?[-+][0-9]+$/)
    return 0
  want = number(want)
  size = want < 0 ? -want : want
  off = number(have) - want
  return (off < 0 ? -off : off) <= (size * tolerance > 1e-5 ? size * tolerance : 1e-5)
}

function number(text) { # Fortran leaves the E out before three digits
  if (text !~ /E/)
    sub(/[-+]...$/, "E&", text)
  return +text
}

function differ(what, want, have) {
  printf "%s: %s, not %s\n", what, have, want
  wrong = 1
}

END {
  if (points[0] != points[1] || points[1] == 0)
    differ("special points", points[1] + 0, points[0] + 0)
  exit wrong
}
