# shellcheck shell=bash disable=SC2034,SC2154 # they share variables
# local.sh - the blocks of a sweep on this machine, by GNU parallel; sourced by sweep.sh
#
# GNU parallel asks to be cited: O. Tange, GNU Parallel, doi:10.5281/zenodo.1146014.  Its
# notice is left as it is; who has read it says so by `parallel --citation` (docs/sweeps.md).

is_gnu_parallel() { parallel --version 2> /dev/null | grep -q '^GNU parallel'; }

compute() {
  local left todo bar=() status=0
  is_gnu_parallel || scripts/setup.sh sweeps || exit $?
  todo=$(cases todo "${retry[@]}") || exit $?
  left=$(wc -w <<< "$todo")
  if [ "$left" -gt 0 ]; then
    [ ! -t 2 ] || bar=(--bar)
    printf '  %s: %d blocks of %d cases, %d jobs; by GNU parallel (O. Tange, doi:10.5281/zenodo.1146014; please cite it)\n' "$name" "$left" "$size" "$jobs"
    export PARALLEL_HOME=$PWD/build/sweeps/.parallel # what it notes for itself; ~/.parallel counts too
    mkdir -p "$PARALLEL_HOME"
    parallel -q --jobs "$jobs" "${bar[@]}" --halt now,fail=1 --joblog "$folder/joblog" \
      build/bin/mlg cases "$file" block={} folder="$folder" size="$size" "${retry[@]}" <<< "$todo" || status=$?
  fi
  [ "$status" = 0 ] || fail "sweep: $name ended early; scripts/sweep.sh resume $file goes on"
  cases gather
}
