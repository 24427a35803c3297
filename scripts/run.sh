#!/usr/bin/env bash
# run.sh - one AUTO run, made and judged
#
#   scripts/run.sh NAME CONSTANTS [from=RUN] [gear=FILE] [KEY=VALUE ...] [-- TYPE=COUNT ...]
#   scripts/run.sh slice.straight l1.straight c_d=1e4 -- HB=2
#
# `build/bin/mlg run`, built first; `mlg help run` and docs/new-runs.md say more.
# Writes: build/runs/NAME, on standard output the time taken and the points found
# Exit:   0, 1 the run failed, 2 bad input
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
# shellcheck disable=SC2119
build
exec build/bin/mlg run "$@"
