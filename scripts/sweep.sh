#!/usr/bin/env bash
# sweep.sh - a parameter study of any size, by GNU parallel here or by Slurm on a cluster
#
#   scripts/sweep.sh show   FILE                  what it is, a few cases, time and disk it takes
#   scripts/sweep.sh run    FILE [jobs=N]         computes it here, on all cores
#   scripts/sweep.sh slurm  FILE [retry] [tasks=1000] [SBATCH_OPTION ...]    as a job array
#   scripts/sweep.sh status FILE                  how far it is
#   scripts/sweep.sh resume FILE [retry] [jobs=N] goes on here; retry: also what has failed
#   scripts/sweep.sh gather FILE                  its table; run and resume end with it
#   scripts/sweep.sh failed FILE                  what has failed, and why
#
# FILE describes it (docs/sweeps.md); constants/sweeps has some.
# Writes: build/sweeps/NAME, for NAME.sweep: table.csv, failed.csv, a file for each block of
#         cases.  MLG_SCRATCH: where runs of AUTO are made meanwhile, a disk of the node's own.
# Exit:   0; 1 not all is computed, or something could not be written; 2 bad input.
#         A case that fails is an answer: it is in failed.csv and the status is 0.
. "$(dirname "$(realpath "$0")")/auto/lib.sh"
here=$OLDPWD
. scripts/sweep/begin.sh
. scripts/sweep/local.sh
. scripts/sweep/slurm.sh

usage='usage: scripts/sweep.sh show|run|slurm|status|resume|gather|failed FILE [WORD ...]; see docs/sweeps.md'

# What all but show and run want.
begun() {
  if [ ! -s "$folder/plan" ]; then
    if [ ! -e "$folder/lock" ]; then fail "sweep: $name has not been begun; scripts/sweep.sh run $file begins it" 2; fi
    if ! flock --nonblock "$folder/lock" true; then fail "sweep: the first cases of $name are being tried now; none is computed yet" 2; fi
    fail "sweep: $name was ended while its first cases were tried, and none is computed; scripts/sweep.sh run $file begins it again" 2
  fi
  read_plan
}

main() { # COMMAND FILE WORD...
  local command=${1:-}
  [ $# -ge 2 ] || fail "$usage" 2
  case $command in show | run | slurm | status | resume | gather | failed) ;; *) fail "sweep: '$command': $usage" 2 ;; esac
  find_description "$2"
  shift 2
  read_words "$command" "$@"
  case $command in
    show) show ;;
    run)
      begin
      not_queued
      compute
      ;;
    slurm)
      begin
      submit "${options[@]}"
      ;;
    status)
      begun
      cases status
      slurm_status
      ;;
    resume)
      begun
      not_queued
      compute
      ;;
    gather | failed)
      begun
      cases "$command"
      ;;
  esac
}

main "$@"
