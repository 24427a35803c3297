# shellcheck shell=bash disable=SC2034,SC2154 # they share variables
# begin.sh - what a sweep is, and the plan it is begun with; sourced by sweep.sh
#
# build/sweeps/NAME/plan holds the size of a block, which its files are named by, and sums
# of all that its numbers hang on: with another description they would mean other cases.

# Sets file, name, folder; builds what computes it.
find_description() { # FILE
  case $1 in /*) file=$1 ;; *) file=$(realpath -ms --relative-to=. "$here/$1") ;; esac
  [ -f "$file" ] || fail "sweep: no description $file" 2
  name=${file##*/}
  name=${name%.sweep}
  check_name "$name"
  folder=build/sweeps/$name
  if grep -qE '^[[:space:]]*do[[:space:]]*=[[:space:]]*run[[:space:]]' "$file"; then
    # shellcheck disable=SC2119 # the models too
    build
  else
    build build/bin/mlg
  fi
  files=$(mlg cases "$file" files) || exit $?
}

# Sets retry, jobs, tasks and options.
read_words() { # COMMAND WORD...
  local command=$1 word seen=' '
  shift
  retry=() jobs=$(processors) tasks=1000 options=()
  for word; do
    case $command:$word in
      *:jobs=* | *:tasks=*)
        [[ $seen != *" ${word%%=*} "* ]] || fail "sweep: '$word': ${word%%=*} is given already" 2
        seen+="${word%%=*} "
        ;;&
      run:jobs=* | resume:jobs=*) jobs=$(count_of "$word" 4096) || exit $? ;;
      slurm:tasks=*) tasks=$(count_of "$word" 100000) || exit $? ;;
      resume:retry | slurm:retry) retry=(retry) ;;
      slurm:--array* | slurm:-a*) fail "sweep: '$word': the array is made by tasks=N" 2 ;;
      slurm:-*) options+=("$word") ;;
      *) fail "sweep: '$word': no such word of $command; $usage" 2 ;;
    esac
  done
  if [ "$command" = slurm ]; then jobs=$(((tasks + 7) / 8)); fi # a block for each task
}

count_of() { # NAME=N MOST
  if [[ ! ${1#*=} =~ ^[1-9][0-9]{0,5}$ ]] || [ "${1#*=}" -gt "$2" ]; then
    fail "sweep: '$1': expected a whole number from 1 to $2" 2
  fi
  echo "${1#*=}"
}

# mlg cases for the blocks of this sweep
cases() { mlg cases "$file" "$@" folder="$folder" size="$size" || exit $?; }

# Waits until nobody else tries cases of this sweep: their runs would mix.  Who had the lock may
# have removed it with the folder; then another is made.
lock_folder() {
  local tries
  for ((tries = 0; tries < 100; tries++)); do
    mkdir -p "$folder"
    { exec 6> "$folder/lock"; } 2> /dev/null || continue
    flock 6
    if [ "$folder/lock" -ef /dev/fd/6 ]; then return; fi
  done
  fail "sweep: $folder/lock cannot be written"
}

# A folder with no plan holds nothing.
unlock_folder() {
  if [ ! -s "$folder/plan" ]; then
    rm -rf "$folder/lock" "$folder/plan.new" "$folder/scratch.try"
    rmdir "$folder" 2> /dev/null || true
  fi
  exec 6>&-
}

# Sets tried, failed, why, seconds and bytes by trying some cases.
try_cases() {
  local line lines status=0
  why=''
  lines=$(mlg cases "$file" plan folder="$folder" 6>&-) || status=$?
  if [ "$status" != 0 ]; then
    unlock_folder
    exit "$status"
  fi
  while read -r line; do
    case $line in tried=* | failed=* | why=* | seconds=* | bytes=*) declare -g "$line" ;; esac
  done <<< "$lines"
  total=$(mlg cases "$file" | sed -n '1s/.*: \([0-9]*\) cases/\1/p')
}

# The cases of a block: some 20 s of them, no more than leaves every job eight blocks, and no
# fewer than make 100 000 blocks: each is a file.
block_of() {
  local given
  given=$(sed -n 's/^block *= *\([0-9]*\).*/\1/p' "$file")
  awk -v given="$given" -v seconds="$seconds" -v total="$total" -v jobs="$jobs" 'BEGIN {
    size = given ? given : 20 / seconds
    if (!given && size * jobs * 8 > total) size = total / jobs / 8
    if (!given && size * 1e5 < total) size = total / 1e5 + 1
    size = size < 1 ? 1 : size > 1e7 ? 1e7 : size
    printf "%d\n", size }'
}

show() {
  lock_folder
  try_cases # first: what it finds wrong is the one line then
  mlg cases "$file"
  why=$why awk -v tried="$tried" -v failed="$failed" -v seconds="$seconds" -v bytes="$bytes" -v total="$total" -v jobs="$jobs" -v size="$(block_of)" '
    function time(s) { return s < 120 ? sprintf("%.3g s", s) : s < 7200 ? sprintf("%.3g min", s / 60) : s < 172800 ? sprintf("%.3g h", s / 3600) : sprintf("%.3g days", s / 86400) }
    BEGIN {
      printf "  of %d cases tried %d failed; %.3g ms a case\n", tried, failed, 1e3 * seconds
      if (ENVIRON["why"] != "") printf "    %s\n", ENVIRON["why"]
      printf "  about %s on 1 core, %s on %d; %.3g MB of tables, as much of blocks: %.0f blocks of %d cases\n",
        time(total * seconds), time(total * seconds / jobs), jobs, total * bytes / 1e6, int((total + size - 1) / size), size }'
  unlock_folder
}

# Sums of all that the numbers hang on: the description, its files, the equations; with runs of
# AUTO the constants files and AUTO.
sums() {
  local own
  mapfile -t own < <(grep -vx run <<< "$files")
  md5sum "${own[@]}" models/*.[ch] models/libmlg/*.[ch]
  if grep -qx run <<< "$files"; then md5sum constants/c.* build/auto.mk; fi
}

read_plan() {
  size=$(sed -n 's/^size=//p' "$folder/plan")
  if ! sums | cmp -s - <(sed 1d "$folder/plan"); then
    fail "sweep: $(sums | diff - <(sed 1d "$folder/plan") | sed -n '2s/.*  //p') is not what $folder was begun with: its cases would mix; rename the description, or remove that folder" 2
  fi
}

# Sets size: that of the plan, or a new plan's.
begin() {
  lock_folder
  if [ ! -s "$folder/plan" ]; then
    try_cases
    { echo "size=$(block_of)" && sums; } > "$folder/plan.new"
    mv "$folder/plan.new" "$folder/plan"
  fi
  unlock_folder
  read_plan
}
