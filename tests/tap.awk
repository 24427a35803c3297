# tap.awk - shows and counts the TAP of one test program, as it comes
#
#   awk -v name=NAME -v counts=FILE -f tap.awk
#
# Reads TAP of cmocka or bats with all else the program prints, and last the lines "took
# N M", tenths of a second and of processor time, and "exit status N". Writes FILE: "PASSED FAILED SKIPPED", a line without
# more, then for each failure "0 0 0 NAME: test".
#
# A failure is shown with the lines around it: cmocka prints some of its message
# before "not ok", bats all of it after.

function line(word, text) { return sprintf("%-5s %-14s %s", word, name, text) }

function show() {
  if (shown != "") print shown
  fflush()
  shown = ""
}

function failure(text) {
  show()
  failed++
  list = list "0 0 0 " name ": " text "\n"
  shown = line("FAIL", text) noise
  noise = ""
}

function success(word) {
  show()
  noise = ""
  sub(/^(not )?ok [0-9]+( -)? *(# SKIP )?/, "")
  print line(word, $0)
  fflush()
}

/^1\.\.[0-9]+$/ { planned += substr($0, 4); next }

/^(not )?ok [0-9]+.* # [Ss][Kk][Ii][Pp]/ { seen++; skipped++; success("skip"); next }

/^ok [0-9]+/ { seen++; passed++; success("ok"); next }

/^not ok [0-9]+/ {
  seen++
  sub(/^not ok [0-9]+( -)? */, "")
  failure($0)
  next
}

/^took [0-9]+ [0-9]+$/ { took = $2; processor = $3; next }

/^exit status [0-9]+$/ { status = $3; ended = 1; next }

/^# (not )?ok - / { next } # cmocka, about the whole group

/^# / && shown != "" { shown = shown "\n      | " substr($0, 3); next }

{ noise = noise "\n      | " $0 }

END {
  missing = planned - seen
  if (status == 124) why = "stopped, it took too long"
  else if (!ended || status > 128) why = "crashed, status " status
  else if (!seen) why = "printed no test result, status " status
  else if (missing > 0) why = "ended with status " status " after " seen " of " planned " tests"
  else if (status && !failed) why = "ended with status " status " although no test failed"
  if (why != "") {
    failure(why)
    if (missing > 1) failed += missing - 1
  }
  show()
  printf "      %-14s %.1f s, %.1f s of a processor\n", name, took / 10, processor / 10
  printf "%d %d %d\n%s", passed, failed, skipped, list > counts
}
