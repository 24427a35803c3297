#!/usr/bin/env bash
# The results as one readable page: results/README.md, from the tables alone.
#
# Its text is results.md, with cells of the tables in {{ }} (mlg help fill); a new figure
# is one more section there.  page.sh makes the same page in HTML of it.
# Needs: results/*.csv (collect.sh, targets.sh) and the pictures
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
build build/bin/mlg
alone results
export MLG_USES=${MLG_USES:-/dev/null}
# what make figures only carries on
for study in verify=verification damping=damping certify={certify,criticality,cycles,folds} transients=transients \
  layouts={layouts,layouts_branches,layouts_planes} sections={sections,tori} sweeps={sweeps,sweeps_map,sweeps_play,sweeps_hopf}; do
  is_known "results/${study#*=}.csv" || put_back "results/${study#*=}.csv" ||
    fail "results/${study#*=}.csv is neither what was made here nor what is committed: make ${study%=*}, or git checkout results/${study#*=}.csv"
done
mlg fill scripts/report/results.md > results/README.md.new || { rm results/README.md.new; exit 1; }
replace results/README.md
