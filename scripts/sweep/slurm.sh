# shellcheck shell=bash disable=SC2034,SC2154 # they share variables
# slurm.sh - the blocks of a sweep as a job array of Slurm; sourced by sweep.sh
#
# Task i of T computes blocks i, i + T, i + 2 T, ... of those that were left when it was
# submitted; each writes its own file, so nothing is shared but the folder.

has_slurm() { command -v sbatch > /dev/null && command -v squeue > /dev/null; }

# The last job array, and whether it waits or runs.
job() { cat "$folder/job" 2> /dev/null; }
queued() { has_slurm && [ -n "$(job)" ] && [ -n "$(squeue --noheader --jobs="$(job)" 2> /dev/null)" ]; }

not_queued() {
  if queued; then fail "sweep: job $(job) of $name is still there: scancel $(job), or wait for it" 2; fi
}

submit() { # SBATCH_OPTION...
  local left most
  has_slurm || scripts/setup.sh slurm || exit $?
  not_queued
  cases todo "${retry[@]}" > "$folder/todo"
  left=$(wc -l < "$folder/todo")
  if [ "$left" = 0 ]; then
    cases gather
    return
  fi
  # beyond MaxArraySize, 1001 unless the cluster has another, sbatch refuses
  most=$(scontrol show config 2> /dev/null | sed -n 's/^MaxArraySize *= *//p')
  [ "$tasks" -lt "${most:-1001}" ] || tasks=$((${most:-1001} - 1))
  [ "$tasks" -le "$left" ] || tasks=$left
  rm -rf "$folder/log"
  mkdir -p "$folder/log"
  write_task > "$folder/task.sh"
  sbatch --parsable --job-name="$name" --array="0-$((tasks - 1))" --output="$folder/log/%a" --open-mode=append \
    "$@" "$folder/task.sh" > "$folder/job.new" || fail "sweep: sbatch refuses $name, see above"
  sed 's/;.*//' "$folder/job.new" > "$folder/job"
  rm -f "$folder/job.new"
  printf '  %s: job %s, %d tasks for %d blocks of %d cases; scripts/sweep.sh status %s\n' "$name" "$(job)" "$tasks" "$left" "$size" "$file"
}

# A step that fails (the disk is full) does not keep a task from its other blocks; they go on
# after a signal to end only when the task is started again.
write_task() {
  cat << END
#!/bin/bash
# a task of the sweep $name, written by scripts/sweep.sh
#SBATCH --ntasks=1 --requeue
cd $(printf %q "$PWD") || exit
export LC_ALL=C OMP_NUM_THREADS=1
status=0
while read -r block; do
  build/bin/mlg cases $(printf %q "$file") block="\$block" folder=$folder size=$size ${retry[*]} || status=\$?
  [ "\$status" -lt 128 ] || exit "\$status"
done < <(awk -v i="\$SLURM_ARRAY_TASK_ID" 'NR % $tasks == i' $folder/todo)
exit "\$status"
END
}

# What Slurm knows of the last job: squeue while it is there, then sacct where accounts are kept.
slurm_status() {
  local states
  [ -n "$(job)" ] && has_slurm || return 0
  states=$(squeue --noheader --array --jobs="$(job)" --format=%T 2> /dev/null) || true
  [ -n "$states" ] || states=$(sacct --noheader --allocations --parsable2 --jobs="$(job)" --format=State 2> /dev/null) || true
  if [ -n "$states" ]; then
    sort <<< "$states" | uniq -c | awk -v job="$(job)" '{ printf "  job %s: %d tasks %s\n", job, $1, tolower($2) }'
  else
    echo "  job $(job) is not in the queue, and Slurm keeps no accounts here: the blocks say what is done"
  fi
  cat "$folder"/log/* | tail -n 3
}
