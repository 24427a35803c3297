#!/usr/bin/env bash
# The paper's numbers against ours: tests/targets.csv joined with the tables of this run.
# Writes results/targets.csv and prints it readably; status 1 if a row fails.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
build build/bin/mlg
alone results
mlg targets || exit
