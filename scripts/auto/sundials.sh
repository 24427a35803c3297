#!/usr/bin/env bash
# sundials.sh - with what to compile and link against SUNDIALS CVODE
#
# Prints the words.  SUNDIALS 7 keeps its context in a library of its own; one built
# with MPI, as Debian's, asks for that header too.
# Needs: libsundials-dev, or a CC that finds another
set -euo pipefail
. "$(dirname "$(realpath "$0")")/tools.sh"

# shellcheck disable=SC2086 # CC may have flags
preprocess() { ${CC:-gcc} -E -P - <<< "#include <sundials/sundials_$1.h>"$'\n'"${2:-}" 2> /dev/null; }

words=(-lsundials_cvode -lsundials_nvecserial)
if [ "$(preprocess config SUNDIALS_VERSION_MAJOR | tail -n 1)" -ge 7 ]; then words+=(-lsundials_core); fi
if ! preprocess types > /dev/null; then
  read -r _ mpi < <(mpicc -show)
  words+=("${mpi//-I/-isystem }")
fi
echo "${words[*]}"
