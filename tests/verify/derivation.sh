#!/usr/bin/env bash
# derivation.sh - the right-hand sides in C against their symbolic derivation
#
#   tests/verify/derivation.sh [short]
#
# Prints rows what,unit,ours,oracle,tolerance; short takes a tenth of the samples.
# tests/derivation.py says what they mean and what is needed.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/auto/tools.sh"
[ -n "${MLG_BUILT:-}" ] || make --no-print-directory --silent libmlg
exec python3 tests/derivation.py "$@"
