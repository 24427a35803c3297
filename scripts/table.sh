#!/usr/bin/env bash
# table.sh - a branch or a solution of a run as a plain table, on standard output
#
#   scripts/table.sh RUN                 the branch: a row for each of its points
#   scripts/table.sh RUN labels          those of its points whose solutions AUTO kept
#   scripts/table.sh RUN solution NAME   one of these over time: all states by name
#
# `build/bin/mlg table`; `mlg help table` says what the columns are.
#
#   scripts/table.sh fig06.a.psi > psi.csv
#   gnuplot -p -e "set datafile separator ','; plot 'psi.csv' using 'V':'psi_max' with lines"
#   Python: pandas.read_csv('psi.csv', comment='#')
#   MATLAB: readtable('psi.csv', 'CommentStyle', '#')
#   Julia:  CSV.read("psi.csv", DataFrame, comment = "#")
#
# Exit: 0, or 2 with one line: no such run, no such solution (and which there are)
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
# shellcheck disable=SC2119
build
exec build/bin/mlg table "$@"
