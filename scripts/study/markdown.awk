# markdown.awk - rows of a table as a Markdown table
#   columns: HEADING=COLUMN:FORMAT or HEADING=COLUMN*FACTOR:FORMAT joined by |; layout: rows of that one only; without: rows
#   whose design is none of these words joined by |
function shown(x, format) {
  if (x == "") return "-"
  if (format == "" || x !~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/) return x == "inf" ? "∞" : x
  return sprintf(format, x)
}
BEGIN { FS = ","; n = split(columns, spec, "|") }
/^#/ { next }
!head {
  head = 1
  for (i = 1; i <= NF; i++) place[$i] = i
  for (i = 1; i <= n; i++) {
    split(spec[i], part, "=")
    heading = heading "| " part[1] " "
    line = line "|---"
    split(part[2], what, ":")
    scale[i] = split(what[1], factor, "*") > 1 ? factor[2] : 1
    column[i] = factor[1]
    format[i] = what[2]
  }
  next
}
layout != "" && $place["layout"] != layout { next }
without != "" && index("|" without "|", "|" $place["design"] "|") { next }
{
  for (i = 1; i <= NF; i++) cell[i] = $i
  if (match($0, /"[^"]*"$/)) cell[split(substr($0, 1, RSTART), junk, ",")] = substr($0, RSTART + 1, RLENGTH - 2)
  if (!rows++) print "\n" heading "|\n" line "|"
  for (i = 1; i <= n; i++) printf "| %s ", column[i] == "layout" ? toupper(cell[place["layout"]]) : shown(scale[i] == 1 ? cell[place[column[i]]] : scale[i] * cell[place[column[i]]], format[i])
  print "|"
}
END { print "" }
