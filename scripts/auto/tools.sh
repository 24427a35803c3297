# shellcheck shell=bash
# tools.sh - the surroundings that every script works in; sourced first, it goes to
# the checkout.
#
# build/tools, where setup.sh puts the tools it chose, comes first on the PATH: what
# was looked for is what is used.  What users set for themselves, and what would
# change the tools' answers, is left outside.

unset CDPATH POSIXLY_CORRECT AWKPATH GREP_OPTIONS GNUTERM GNUPLOT_LIB
export LC_ALL=C OMP_NUM_THREADS=1
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." || exit
case $PATH in "$PWD/build/tools":*) ;; *) export PATH="$PWD/build/tools:$PATH" ;; esac

# Every layout: the models that end by including plugin.h, as the Makefile finds them.
layouts() { grep -l '^#include "plugin.h"' models/*.c | sed 's|.*/||; s|\.c$||'; }

# How many jobs run side by side: nproc alone heeds OMP_NUM_THREADS.
processors() { env -u OMP_NUM_THREADS nproc; }
