#!/usr/bin/env bash
# table.sh - a branch or a solution of a run as a plain table, on standard output
#
#   scripts/table.sh RUN                 the branch: a row for each of its points
#   scripts/table.sh RUN labels          those of its points whose solutions AUTO kept
#   scripts/table.sh RUN solution NAME   one of these over time: all states by name
#
# RUN is one of build/runs; FOLDER/RUN names AUTO's files b.RUN, d.RUN and s.RUN of
# a folder, seen from the checkout.  NAME is as in IRS, HB2 for the second Hopf
# point, or AUTO's label.
#
# Comma separated; lines that begin with # hold the units, the next line the names
# of the columns.  Those of a branch: point, label, type, name, stable, then AUTO's;
# type: HB Hopf, HH double Hopf, TR torus, LP fold, UZ asked for, ...; stable: 1
# yes, 0 no, by AUTO.  Those of a solution: t, s, then the states; at an equilibrium
# one row.  SI units, but psi_max in degrees.
#
#   scripts/table.sh fig06.a.psi > psi.csv
#   gnuplot -p -e "set datafile separator ','; plot 'psi.csv' using 'V':'psi_max' with lines"
#   Python: pandas.read_csv('psi.csv', comment='#')
#   MATLAB: readtable('psi.csv', 'CommentStyle', '#')
#   Julia:  CSV.read("psi.csv", DataFrame, comment = "#")
#
# Exit: 0, or 2 with one line: no such run, no such solution (and which there are),
# or files of AUTO's own that hold several branches with different columns.
. "$(dirname "$(realpath "$0")")/lib.sh"

usage="usage: scripts/table.sh RUN [labels | solution NAME]"
case $#,${2:-} in 1, | 2,labels | 3,solution) ;; *) fail "$usage" 2 ;; esac
case $1 in
  */*) folder=${1%/*} name=${1##*/} ;;
  *) folder=build/runs/$1 name=$1 ;;
esac
files=("$folder/d.$name" "$folder/b.$name")
[ -f "${files[1]}" ] || fail "table: there is no run '$1', no ${files[1]}" 2
[ -f "${files[0]}" ] || files[0]=/dev/null # one of AUTO's own, without @sv
if [ $# -eq 3 ]; then
  awk -v wanted="$3" -f scripts/units.awk -f scripts/solution.awk -f scripts/auto.awk \
    models/mlg.h models/*.c "${files[1]}" "$folder/s.$name" || exit $?
else
  awk -v labelled="${2:-}" -f scripts/units.awk -f scripts/auto.awk -f scripts/table.awk models/mlg.h models/*.c "${files[@]}" || exit $?
fi
