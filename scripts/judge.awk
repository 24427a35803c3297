# judge.awk - is AUTO's run what it was meant to be?
#   awk -v expect="HB=4 TR=1" -f auto.awk -f judge.awk d.RUN b.RUN
# Prints the special points; each complaint goes on a line that begins with
# "FAIL ".  AUTO itself ends with status 0 whatever happens, so this looks for:
# MX, NaN, no solution at all, a last point without a label, the steps used up before the stopping point,
# a change of stability or a fold of ICP(1) that carries no label (stepped
# over), and numbers of points other than expected.  EP at the first point is
# where the run starts and does not count.  "closed" counts as a type.
function fail(text) { print "FAIL " text }

# UZ, EP and MX may stand anywhere and explain no change of stability
function bifurcation(type) { return type != "" && type !~ /^(UZ|EP|MX)$/ }

BEGIN { free = 1 } # the column of ICP(1)

/[Nn][Aa][Nn]|[Ii]nfinity/ { nan++ }

{
  solutions++
  if (type != "" && !(type == "EP" && solutions == 1)) {
    found[type]++
    if (type != "EP" && type != "UZ")
      listed = listed sprintf(" %s %.6g", type, value[column[free]])
  }
}

# Whether straight rolling has no eigenvalue near the imaginary axis there; on it
# the count of stable ones is up to rounding.
function clear_of_axis(point,    n, i, part) {
  n = split(eigenvalues[point], part, " ")
  for (i = 1; i < n; i += 2)
    if (part[i] ^ 2 < 1e-12) return 0
  return n > 0
}

# the number of stable eigenvalues or multipliers, where AUTO counts them; at a
# Hopf point, where orbits begin, it does not.  AUTO looks for no bifurcation in its
# first step.
constant["ISW"] == 1 && constant["ISP"] > 0 && left_out !~ /TR0/ {
  count = stable_count[point]
  if ((solutions > 2 || (solutions == 2 && clear_of_axis(1))) && count != was_count && !bifurcation(type) && !bifurcation(was_type))
    fail(was_count " stable eigenvalues become " count " without a label between " column[free] " = " was_free " and " value[column[free]] " (try another " (solutions == 2 ? "start" : "DSMAX") ")")
  was_count = count
}

# folds, where AUTO is asked for them: its search for the fold can end beside it
constant["ILP"] > 0 && solutions > 2 {
  turns = (value[column[free]] - was_free) * (was_free - before_free) < 0
  if (turns && was_type != "LP")
    fail("fold without a label near " column[free] " = " was_free " (try another DSMAX)")
  if (!turns && was_type == "LP")
    fail("LP at " column[free] " = " was_free " is not an extremum")
}

{ before_free = was_free; was_type = type; was_free = value[column[free]] }

END {
  if (solutions && !closed && type == "") fail("AUTO broke off at " column[free] " = " was_free)
  if (closed) found["closed"] = 1
  if (status) fail("AUTO stopped with status " status)
  if (!solutions) fail("AUTO computed no solution")
  if (nan) fail("not-a-number in the solution")
  n = split(expect, want, " ")
  for (i = 1; i <= n; i++) {
    split(want[i], pair, "=")
    wanted[pair[1]] = 1
    if (found[pair[1]] + 0 != pair[2])
      fail("expected " pair[2] " " pair[1] ", found " found[pair[1]] + 0)
  }
  if (found["MX"]) fail("MX: no convergence")
  if (found["EP"] && !wanted["EP"]) fail("ended at EP: the steps (NMX) were used up")
  print substr(listed (closed ? " closed" : ""), 2)
}
