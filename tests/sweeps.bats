# sweeps.bats - is a sweep's table what its cases answer, whatever engine made it and killed it?
#
# Needs   the models, build/bin/mlg; GNU parallel; for one test slurm-wlm and root
# Writes  build/tests/sweeps; all that a test starts it ends, by its id

bats_require_minimum_version 1.5.0
load scratch
load sweeps/slurm

setup_file() {
  scratch sweeps
  export PARALLEL_HOME=$SCRATCH/build/sweeps/.parallel
}

setup() {
  cd "$SCRATCH" || return
}

teardown() {
  [ -z "${slurmctld:-}" ] || end_slurm
}

# sweep NAME < description
sweep() {
  cat > "build/$1.sweep"
}

# The rows of a table of a sweep, with their names.
rows() { # NAME [TABLE]
  grep -v '^#' "build/sweeps/$1/${2:-table.csv}"
}

# A process and all that it began.
tree() { # PID
  local child
  echo "$1"
  for child in $(ps -o pid= --ppid "$1"); do tree "$child"; done
}

# until_true SECONDS COMMAND...
until_true() {
  local end=$((SECONDS + $1))
  shift
  until "$@" > /dev/null 2>&1; do
    [ "$SECONDS" -lt "$end" ] || { echo "not within the time: $*"; return 1; }
    sleep 0.05
  done
}

has_records() { # NAME
  cat build/sweeps/"$1"/blocks/0/* | grep -qa '^ok'
}

no_jobs() {
  [ -z "$(squeue --noheader)" ]
}

# Times that a case was computed.
records() { # NAME
  find "build/sweeps/$1/blocks" -type f -exec cat {} + | grep -caE '^(ok [0-9]+ [0-9]+ [0-9a-f]{8}|failed [0-9]+ [0-9]+ [0-9]+ [0-9a-f]{8} .*)$'
}

@test "a table has for each case what mlg answers to its words, none for no row, several for several" {
  local n c_d e
  sweep exact <<'END'
layout = l1
c_d = 2800, 3e4
e = 0.06 : 0.18 : 3
ask = hopf {layout} {parameters}
keep = V, shimmy as mode
END
  mkdir -p 'build/a folder'
  mv build/exact.sweep 'build/a folder'
  (cd 'build/a folder' && ../../scripts/sweep.sh run exact.sweep jobs=1)
  [ "$(rows exact | head -n 1)" = case,c_d,e,V,mode ]
  n=0
  for c_d in 2800 3e4; do
    for e in 0.06 0.12 0.18; do
      n=$((n + 1))
      mlg hopf l1 c_d=$c_d e=$e | sed 1,2d | awk -F, -v at="$n,$c_d,$e" '{ print at "," $2 "," $4 } END { if (!NR) print at ",," }'
    done
  done > build/expected
  diff build/expected <(rows exact | sed 1d)
  [ "$(cut -d , -f 1 build/expected | sort -u | wc -l)" -lt "$(wc -l < build/expected)" ] # several
  grep -q ',,$' build/expected                                                            # none
  [ "$(sed -n 3p build/sweeps/exact/table.csv)" = "# c_d N m s/rad; e m; V m/s" ]
}

@test "commands that are called again in one process answer as in one of their own" {
  local command words columns n e layout
  while IFS='|' read -r command words columns; do
    sweep again <<< "layout = li1, l1
e = 0.05, 0.2, 0.12
ask = $command {layout} {parameters} $words
keep = $columns"
    rm -rf build/again
    mkdir -p build/again
    mlg cases build/again.sweep block=1 size=100 folder=build/again
    mlg cases build/again.sweep gather size=100 folder=build/again > /dev/null
    n=0
    for layout in li1 l1; do
      for e in 0.05 0.2 0.12; do
        n=$((n + 1))
        # shellcheck disable=SC2086 # one word for each parameter
        mlg "$command" "$layout" e=$e $words | awk -F, -v at="$n,$layout,$e" -v columns="${columns// /}" '
          /^#/ { next }
          !names++ { m = split(columns, wanted, ","); for (k = 1; k <= NF; k++) place[$k] = k; next }
          { row = at; for (k = 1; k <= m; k++) row = row "," $place[wanted[k]]; print row; rows++ }
          END { if (!rows) { row = at; for (k = 1; k <= m; k++) row = row ","; print row } }'
      done
    done > build/expected
    diff build/expected <(grep -v '^#' build/again/table.csv | sed 1d)
  done <<'END'
boundary|zeta=1e-4|c_d, V, shimmy
hopf|V=30|c_d, grows
hopf|c_d=5e3 V_top=90|V, frequency_hz
intervals|V_least=1|c_lo, c_hi, upper
widest|b=0|k_s, width, limit
eigenvalues|V=20 c_d=5e3|real_part
damping|V=20 c_d=5e3|zeta, t_5
damping|c_d=5e3|zeta, V
END
}

@test "killed with -9 and resumed: the same bytes, and no case twice; two jobs and one, blocks of other sizes" {
  local kind block pid
  for kind in whole:1000 killed:300; do
    IFS=: read -r kind block <<< "$kind"
    sweep "$kind" <<< "block = $block
layout = l1, l2, li1
k_s = inf
e = 0.05 : 0.2 : 40
l = 0.2 ~ 0.4
c_d = 1e3 ~ 1e5 log
sample = 20
ask = damping {layout} {parameters}
keep = zeta, V"
  done
  scripts/sweep.sh run build/whole.sweep jobs=1
  scripts/sweep.sh run build/killed.sweep jobs=2 > /dev/null 2>&1 &
  pid=$!
  until_true 60 has_records killed
  # shellcheck disable=SC2046 # one word for each process
  kill -KILL $(tree $pid)
  wait $pid || true
  run scripts/sweep.sh status build/killed.sweep
  [[ ${lines[0]} =~ ^\ \ ([0-9]+)\ of\ 2400\ cases ]] && [ "${BASH_REMATCH[1]}" -gt 0 ] && [ "${BASH_REMATCH[1]}" -lt 2400 ]
  run -1 scripts/sweep.sh gather build/killed.sweep
  [[ $output = *"build/sweeps/killed/partial.csv: "*" not computed yet" ]]
  scripts/sweep.sh resume build/killed.sweep jobs=2
  cmp <(sed 1d build/sweeps/whole/table.csv) <(sed 1d build/sweeps/killed/table.csv)
  [ "$(rows whole | wc -l)" -eq 2401 ]
  [ "$(records killed)" -eq 2400 ]
  [ ! -e build/sweeps/killed/partial.csv ]
}

@test "a part cut off at any byte is gone on with, and damage is noticed" {
  local bytes file=build/cut/blocks/0/1.done
  sweep cut <<'END'
layout = l1
e = 0.06 : 0.18 : 8
ask = hopf {layout} {parameters} c_d=3e4
keep = V, shimmy
END
  mkdir -p build/cut
  mlg cases build/cut.sweep block=1 size=8 folder=build/cut
  cp $file build/good
  for ((bytes = 0; bytes < $(stat -c %s build/good); bytes += 23)); do
    head -c $bytes build/good > build/cut/blocks/0/1.part
    rm $file
    mlg cases build/cut.sweep block=1 size=8 folder=build/cut
    cmp build/good $file
  done
  { head -c 100 build/good; head -c 30 /dev/zero; tail -c +131 build/good; } > $file
  run -1 mlg cases build/cut.sweep gather size=8 folder=build/cut
  [ "${#lines[@]}" -eq 1 ] && [[ ${lines[0]} = *"$file is damaged"* ]]
}

# Straight rolling and the first steps of shimmy; without a Hopf point, as at e = 0.05, it fails.
auto_sweep() { # NAME CASES [LINE]
  sweep "$1" <<< "layout = l1
e = 0.05 : 0.19 : $2
block = 2
do = run straight {layout}.straight {parameters} c_d=1e4 DSMAX=1 UZSTOP={'V': 80.0}
do = run shimmy {layout}.periodic from=straight IRS='HB1' NMX=4 -- EP=1
ask = points straight
names = prefix, run, type, V, c_d, k_s, b, frequency, psi, dstar
keep = V as V_hopf
rows = first
ask = table shimmy
keep = V, psi_max
rows = largest psi_max
${3:-memory = 800 MB}"
}

@test "chains of runs of AUTO: what is read of them, a case that fails is told and stops no other" {
  auto_sweep linked 3
  run scripts/sweep.sh run build/linked.sweep jobs=2
  [ "$status" -eq 0 ]
  [ "${lines[-1]}" = "  build/sweeps/linked/table.csv: 2 of 3 cases; 1 failed: build/sweeps/linked/failed.csv" ]
  [ "$(rows linked failed.csv | sed 1d | cut -d , -f 1-5)" = "1,0.05,2,run,1" ]
  grep -q 'Restart label HB1 not found' build/sweeps/linked/failed.csv
  scripts/sweep.sh failed build/linked.sweep | cmp - build/sweeps/linked/failed.csv
  auto_run straight l1.straight e=0.12 c_d=1e4 DSMAX=1 UZSTOP="{'V': 80.0}"
  near "$(rows linked | sed -n '/^2,/p' | cut -d , -f 3)" "$(value straight HB V)" 1e-7 "the Hopf point of case 2"
  [ "$(rows linked | sed -n '/^2,/p' | cut -d , -f 5 | awk '{ print ($1 > 0) }')" = 1 ]
  [ -z "$(find build/sweeps/linked -name 'b.*')" ] && [ -z "$(find build/sweeps/linked -name 'scratch*')" ]
  auto_sweep kept 2 'files = keep'
  scripts/sweep.sh run build/kept.sweep jobs=1
  [ -s build/sweeps/kept/runs/2/shimmy/b.shimmy ]
  mlg table build/sweeps/kept/runs/2/shimmy/b.shimmy > /dev/null
}

@test "a case that takes too long, and one whose process is killed: told, and retried on request alone" {
  local pid worker
  sweep slow <<'END'
layout = l1
step = 1, 1e-5, 0.9
block = 3
time = 2 s
do = run straight {layout}.straight c_d=1e4 DSMAX={step} DS={step} DSMIN=1e-6 NMX=99999
ask = points straight
names = prefix, run, type, V, c_d, k_s, b, frequency, psi, dstar
keep = V
rows = first
END
  scripts/sweep.sh run build/slow.sweep jobs=1 &
  pid=$!
  until_true 60 grep -qa '^ok 1 ' build/sweeps/slow/blocks/0/1.part
  wait $pid
  [ "$(rows slow | cut -d , -f 1 | xargs)" = "case 1 3" ]
  [ "$(rows slow failed.csv | sed -n 2p)" = "2,1e-5,1,run,124,took longer than 2 s (time)" ]
  until_true 5 bash -c '! pgrep -f "build/models/l1.ex[e]" -s 0'

  # the worker of a block is killed while it computes its second case
  sed 's/^time.*/time = 100 s/' build/slow.sweep > build/struck.sweep
  scripts/sweep.sh run build/struck.sweep jobs=1 &
  pid=$!
  until_true 60 grep -qa '^ok 1 ' build/sweeps/struck/blocks/0/1.part
  for worker in $(pgrep -f "mlg cases build/struck.sweep bloc[k]=1"); do
    [[ $(readlink "/proc/$worker/exe") != */mlg || $(readlink "/proc/$(ps -o ppid= "$worker" | xargs)/exe") = */mlg ]] || break
  done
  worker=$(pgrep -P "$worker")
  kill -KILL "$worker"
  wait $pid
  [ "$(rows struck failed.csv | sed -n 2p)" = "2,1e-5,1,run,137,killed by signal 9 (Killed)" ]
  scripts/sweep.sh resume build/struck.sweep jobs=1
  [ "$(records struck)" -eq 3 ]
}

@test "a case that wants more memory than it may have fails alone" {
  auto_sweep large 2 'memory = 64 MB'
  sed -i 's/^e = .*/e = 0.12\nNTST = 20, 9000/; s/NMX=4/NMX=2 NTST={NTST}/' build/large.sweep
  scripts/sweep.sh run build/large.sweep jobs=1
  [ "$(rows large | cut -d , -f 1 | xargs)" = "case 1" ]
  [ "$(rows large failed.csv | sed 1d | cut -d , -f 1-5)" = "2,9000,2,run,1" ]
}

@test "what has failed is computed again with retry, and only that" {
  sweep again <<'END'
layout = l1
V = 1 : 5 : 5
file = build/gear.late
ask = eigenvalues {layout} V={V} gear={file}
keep = real_part
rows = first
END
  echo "PAR = {'e': 0.1}" > build/gear.late
  scripts/sweep.sh run build/again.sweep jobs=1
  cp build/sweeps/again/table.csv build/good
  rm -r build/sweeps/again build/gear.late
  run -2 scripts/sweep.sh run build/again.sweep jobs=1
  [[ ${lines[0]} = "build/again.sweep:4: 'eigenvalues': all 5 cases that were tried fail, case 1 with status 2: build/gear.late: No such file"* ]]
  mkdir -p build/sweeps/again
  echo "PAR = {'e': 0.1}" > build/gear.late
  scripts/sweep.sh run build/again.sweep jobs=1 > /dev/null
  rm -r build/sweeps/again/blocks build/gear.late
  scripts/sweep.sh resume build/again.sweep jobs=1
  [ "$(rows again failed.csv | wc -l)" -eq 6 ]
  echo "PAR = {'e': 0.1}" > build/gear.late
  scripts/sweep.sh resume build/again.sweep jobs=1
  [ "$(rows again | wc -l)" -eq 1 ]
  scripts/sweep.sh resume build/again.sweep retry jobs=1
  cmp build/good build/sweeps/again/table.csv
  [ ! -e build/sweeps/again/failed.csv ]
}

@test "a full disk ends a block, and what is done stays" {
  sweep full <<'END'
layout = l1
e = 0.06 : 0.18 : 200
ask = hopf {layout} {parameters} c_d=3e4
keep = V, frequency_hz, shimmy
END
  mkdir -p build/full
  run -1 bash -c "trap '' XFSZ; ulimit -f 4; build/bin/mlg cases build/full.sweep block=1 size=200 folder=build/full"
  [ "${#lines[@]}" -eq 1 ] && [[ ${lines[0]} = *"1.part: File too large; what is done stays"* ]]
  mlg cases build/full.sweep block=1 size=200 folder=build/full
  mlg cases build/full.sweep gather size=200 folder=build/full > /dev/null
  cp build/full/table.csv build/good
  rm -r build/full/blocks
  mlg cases build/full.sweep block=1 size=200 folder=build/full
  run -1 bash -c "trap '' XFSZ; ulimit -f 4; build/bin/mlg cases build/full.sweep gather size=200 folder=build/full"
  cmp build/good build/full/table.csv
}

@test "steps, lists, samples and tables of cases, the last fastest, and other descriptions are no part of a sweep" {
  printf 'k_d,c_psi\n1e5,200\n2e5,250\n' > build/some.csv
  sweep axes <<'END'
cases = build/some.csv
e = 0.1 : 0.2 by 0.05   # three
V = 1 : 100 : 3 log
l = 0.3 +- 10 %
h = 0.1 ~ 0.2
sample = 4
ask = damping l1 {parameters} c_d=3e3
keep = zeta
END
  run mlg cases build/axes.sweep
  [ "${lines[0]}" = "build/axes.sweep: 72 cases" ]
  [[ $output = *"mlg damping l1 k_d=1e5 c_psi=200 e=0.1 V=1 l=0.3 h=0.15 c_d=3e3"* ]]
  [[ $output = *"  case 72:"* && $output = *"mlg damping l1 k_d=2e5 c_psi=250 e=0.2 V=100 l="* ]]
  scripts/sweep.sh run build/axes.sweep jobs=1 > /dev/null
  [ "$(rows axes | sed 1d | cut -d , -f 2-5 | sort -u | wc -l)" -eq 18 ]
  # a table beside the description, with a column that names its cases
  mkdir -p build/tyres
  printf 'tyre,l\nnew,0.3\nworn,0.26\n' > build/tyres/tyres.csv
  printf 'cases = tyres.csv\nask = intervals l1 {parameters}\nkeep = c_lo\nrows = largest width\n' > build/tyres/two.sweep
  scripts/sweep.sh run build/tyres/two.sweep jobs=1 > /dev/null
  [ "$(rows two | sed -n 2p | cut -d , -f 1-3)" = 1,new,0.3 ]
  # a sample is spread: of 1000 points between 49 and 51 in each 20th
  sed -e 's/sample = 4/sample = 1000/' build/axes.sweep > build/spread.sweep
  mkdir -p build/spread
  mlg cases build/spread.sweep block=1 size=1000 folder=build/spread
  run -1 mlg cases build/spread.sweep gather size=1000 folder=build/spread
  grep -v '^#' build/spread/partial.csv | sed 1d | awk -F, '{ l[int(($6 - 0.27) / 0.003)]++; h[int(($7 - 0.1) / 0.005)]++ }
    END { for (k = 0; k < 20; k++) if (l[k] < 48 || l[k] > 52 || h[k] < 48 || h[k] > 52) { print k, l[k], h[k]; exit 1 } }'
  sed -i 's/3e3/4e3/' build/axes.sweep
  run -2 scripts/sweep.sh resume build/axes.sweep
  [ "${#lines[@]}" -eq 1 ] && [[ ${lines[0]} = "sweep: build/axes.sweep is not what build/sweeps/axes was begun with"* ]]
}

@test "slips in a description end in one line: file, value, what would be right" {
  local n=0 slip right good='layout = l1
e = 0.1, 0.2
ask = intervals {layout} {parameters}
keep = c_lo'
  printf 'tyre,l\n1,0.3\n2,0.31\n' > build/numbers.csv
  printf 'h,l\n0.1,0.3\n0.2,foo\n' > build/wrong.csv
  printf 'h,l\n0.1,0.3\n0.2,\n' > build/empty.csv
  printf 'layout,l\nl9,0.3\n' > build/l9.csv
  printf 'maker,l\nacme ltd,0.3\n' > build/maker.csv
  printf 'e,l\n0.1,0.3\n' > build/again.csv
  printf 'l,l\n0.1,0.3\n' > build/twice.csv
  printf 'l;h\n0,3;0,1\n' > build/semicolons.csv
  while IFS='|' read -r slip right; do
    n=$((n + 1))
    printf '%b\n' "${slip//GOOD/$good}" > build/slip.sweep
    run --separate-stderr -2 mlg cases build/slip.sweep
    # shellcheck disable=SC2154 # set by run
    [ "${#stderr_lines[@]}" -eq 1 ] && [[ $stderr = build/slip.sweep*"$right"* ]] || { echo "$slip: $stderr, expected $right"; return 1; }
  done < "$ROOT/tests/sweeps/slips"
  [ "$n" -ge 40 ]
  run -2 mlg cases build/none.sweep
  run -2 scripts/sweep.sh run build/none.sweep
  [ "$output" = "sweep: no description build/none.sweep" ]
  sweep good <<< "$good"
  run -2 scripts/sweep.sh run build/good.sweep jobs=1 jobs=2
  [[ "$output" == "sweep: 'jobs=2': jobs is given already" ]]
  run -2 scripts/sweep.sh run build/good.sweep jobs=0
  run -2 scripts/sweep.sh fly build/good.sweep
  run -2 scripts/sweep.sh status build/good.sweep
  [ "$output" = "sweep: good has not been begun; scripts/sweep.sh run build/good.sweep begins it" ]
  run -2 scripts/sweep.sh slurm build/good.sweep --array=0-3
}

@test "Slurm: the table of GNU parallel; an array killed in the middle and resumed; a case that fails" {
  local why
  begin_slurm build/slurm 2 > build/why || { why=$(cat build/why) && skip "Slurm on loopback: $why"; }
  sweep here <<'END'
layout = l1, l2
k_s = inf
block = 25
e = 0.05 : 0.2 : 50
c_d = 1e3 ~ 1e5 log
sample = 20
V_top = 0.2, 200
ask = damping {layout} {parameters} V_least=0.3
keep = zeta, V
END
  sed 's/^block.*/block = 40/' build/here.sweep > build/there.sweep
  scripts/sweep.sh run build/here.sweep jobs=2 > /dev/null
  scripts/sweep.sh slurm build/there.sweep tasks=4 --time=5
  until_true 30 has_records there
  scripts/sweep.sh status build/there.sweep | grep -E 'job [0-9]+: [0-9]+ tasks'
  run -2 scripts/sweep.sh resume build/there.sweep
  scancel --signal=KILL "$(cat build/sweeps/there/job)" || true
  scancel "$(cat build/sweeps/there/job)"
  until_true 30 no_jobs
  run -1 scripts/sweep.sh gather build/there.sweep
  scripts/sweep.sh slurm build/there.sweep tasks=2
  until_true 60 no_jobs
  scripts/sweep.sh status build/there.sweep | grep -q 'the blocks say'
  scripts/sweep.sh gather build/there.sweep
  cmp <(sed 1d build/sweeps/here/table.csv) <(sed 1d build/sweeps/there/table.csv)
  cmp <(sed 1d build/sweeps/here/failed.csv) <(sed 1d build/sweeps/there/failed.csv)
  [ "$(records there)" -eq 4000 ] && [ "$(rows there failed.csv | wc -l)" -eq 2001 ]
}

# Slurm keeps accounts in a database only (slurmdbd), which is not set up here: sacct is a stub
# that prints what Slurm's manual page says it does.
@test "status counts what sacct says of a job that squeue knows no longer; sacct is a stub, not Slurm" {
  mkdir -p build/stubs
  printf '#!/bin/bash\n' | tee build/stubs/sbatch > build/stubs/squeue
  cat > build/stubs/sacct <<'END'
#!/bin/bash
[ "$*" = "--noheader --allocations --parsable2 --jobs=77 --format=State" ] || exit 1
printf '%s\n' COMPLETED COMPLETED 'CANCELLED by 1000' OUT_OF_MEMORY TIMEOUT NODE_FAIL
END
  chmod +x build/stubs/*
  sweep counted <<< "layout = l1
e = 0.1, 0.12
ask = hopf {layout} {parameters} c_d=3e4
keep = V"
  scripts/sweep.sh run build/counted.sweep jobs=1 > /dev/null
  echo 77 > build/sweeps/counted/job
  mkdir build/sweeps/counted/log
  echo "slurmstepd: error: *** JOB 77 CANCELLED ***" > build/sweeps/counted/log/3
  PATH=$PWD/build/stubs:$PATH run -0 scripts/sweep.sh status build/counted.sweep
  [ "${lines[1]}" = "  job 77: 1 tasks cancelled" ]
  [ "${lines[2]}" = "  job 77: 2 tasks completed" ]
  [[ $output = *"job 77: 1 tasks node_fail"*"1 tasks out_of_memory"*"1 tasks timeout"*"JOB 77 CANCELLED"* ]]
  printf '#!/bin/bash\nexit 1\n' > build/stubs/sacct # no accounts are kept
  PATH=$PWD/build/stubs:$PATH run -0 scripts/sweep.sh status build/counted.sweep
  [[ $output = *"job 77 is not in the queue, and Slurm keeps no accounts here"* ]]
}

@test "what a command prints goes into a file where into says so, and AUTO's branch begins there" {
  sweep begun <<'END'
layout = l1
g_psi = 0.002, 0.004
V = 20
c_d = 2886.7
corner = 0.01
do = cycle {layout} orbit {parameters} psi=0.05
into = start.dat
do = run play {layout}.orbit {parameters} dat=start.dat ICP=['V', 'period', 'psi_max', 'dstar_max'] NMX=3 -- EP=1
ask = rows play only=EP columns=V,psi_max:.8g
names = V, psi_max
rows = first
keep = psi_max
files = keep
END
  scripts/sweep.sh run build/begun.sweep jobs=1 > /dev/null
  near "$(rows begun | sed -n 3p | cut -d , -f 3)" "$(cell psi_max cycle l1 g_psi=0.004 V=20 c_d=2886.7 corner=0.01 psi=0.05)" 1e-5 psi_max
  cmp build/sweeps/begun/runs/2/start.dat <(mlg cycle l1 orbit g_psi=0.004 V=20 c_d=2886.7 corner=0.01 psi=0.05)
}

@test "a table says in which units its columns are: psi_max of AUTO in degrees" {
  sweep degrees <<'END'
layout = l1, li1
V = 60
c_d = 2890
g_psi = 0.004
ask = cycle {layout} motion {parameters} psi=0.05 settle=1 rtol=1e-6
keep = motion, psi_most as most, watched
ask = hopf {layout} V_least=1 c_d=3e4
rows = first
keep = V as V_hopf, grows
ask = transients {layout} V=60 c_d=2890 t_end=1
rows = first
keep = psi_max
END
  mkdir -p build/degrees build/apart
  mlg cases build/degrees.sweep block=1 size=2 folder=build/degrees
  mlg cases build/degrees.sweep gather size=2 folder=build/degrees
  [ "$(grep '^#' build/degrees/table.csv | tail -n 1)" = "# most deg; watched s; V_hopf m/s; psi_max deg" ]
  mlg cases build/degrees.sweep block=2 size=1 folder=build/apart
  mlg cases build/degrees.sweep block=1 size=1 folder=build/apart
  mlg cases build/degrees.sweep gather size=1 folder=build/apart
  cmp build/degrees/table.csv build/apart/table.csv
}

@test "kill -9 of the group: what is computed ends, status tells, nothing is left over, resume goes on" {
  local pid
  sweep group <<< "layout = l1, l2
e = 0.05 : 0.2 : 4000
block = 8000
ask = damping {layout} best {parameters}
keep = zeta"
  setsid scripts/sweep.sh run build/group.sweep jobs=1 > /dev/null 2>&1 &
  pid=$!
  until_true 60 has_records group
  scripts/sweep.sh status build/group.sweep | grep -q ', 1 begun, 1 of them being computed now$'
  kill -KILL -- -"$(ps -o pgid= "$(pgrep -f 'sweep.sh run build/group.swee[p]' | head -n 1)" | xargs)"
  wait $pid || true
  until_true 5 bash -c "scripts/sweep.sh status build/group.sweep | grep -q ', 1 begun, 0 of them being computed now$'"
  [ -z "$(find build/sweeps/group -name 'todo.*')" ]
}

@test "what is ended while it tries its first cases says so; a slip found by trying is one line and leaves nothing" {
  local file word
  sweep tried <<< "layout = l1
e = 0.1, 0.12
ask = hopf {layout} {parameters} c_d=3e4
keep = V"
  mkdir -p build/sweeps/tried/scratch.try
  : > build/sweeps/tried/lock
  run -2 scripts/sweep.sh status build/tried.sweep
  [ "$output" = "sweep: tried was ended while its first cases were tried, and none is computed; scripts/sweep.sh run build/tried.sweep begins it again" ]
  flock build/sweeps/tried/lock sleep 5 &
  until_true 5 bash -c '! flock --nonblock build/sweeps/tried/lock true'
  run -2 scripts/sweep.sh gather build/tried.sweep
  [ "$output" = "sweep: the first cases of tried are being tried now; none is computed yet" ]
  kill $!
  rm -r build/sweeps/tried
  for word in "keep = V, shimy" "keep = V\nrows = largest shimy"; do
    printf 'layout = l1\ne = 0.1, 0.12\nask = hopf {layout} {parameters} c_d=3e4\n%b\n' "$word" > build/tried.sweep
    for file in show run; do
      run -2 scripts/sweep.sh $file build/tried.sweep
      [ "$output" = "build/tried.sweep:$(grep -n shimy build/tried.sweep | cut -d : -f 1): 'shimy': mlg hopf prints no such column; it has c_d V frequency_hz shimmy grows" ]
      [ ! -e build/sweeps/tried ]
    done
  done
  printf 'layout = l1\ne = 0.1, 0.12\nask = hopf {layout} {parameters} c_d=3e4\nnames = c_d, V, f, s, g\nkeep = V' > build/tried.sweep
  run -2 scripts/sweep.sh run build/tried.sweep
  [[ $output = *"mlg hopf prints the names of its columns itself; take the line names away" ]]
}

@test "a CSV and a description as Windows writes them; show tells what fails and lists what stands in a CSV" {
  printf '\xef\xbb\xbflayout, c_d ,e\r\nl1 , 3e4, 0.1\r\nl1,3e4,0.14\r\nl1,3e4,1e-4\r\n' > build/marked.csv
  printf '\xef\xbb\xbfcases = marked.csv\r\nask = damping {layout} best {parameters}\r\nkeep = zeta\r\n' > build/marked.sweep
  sed -i 's/ best//' build/marked.sweep
  mlg cases build/marked.sweep > build/shown
  grep -q '^  e            0.1, 0.14, 1e-4$' build/shown
  grep -q 'mlg damping l1 c_d=3e4 e=0.14$' build/shown
  sweep partly <<< "file = constants/gear.printed, build/none
ask = hopf l1 gear={file} c_d=3e4
keep = V
rows = first"
  run -0 scripts/sweep.sh show build/partly.sweep
  [[ $output = *"of 2 cases tried 1 failed;"*"case 2, command 1, status 2: build/none: No such file"*" blocks of "* ]]
}

@test "the examples of docs/sweeps.md" {
  examples docs/sweeps.md > build/examples.sh
  bash -euo pipefail build/examples.sh
  [ "$(rows mine | wc -l)" -eq 55 ]
  [ "$(rows mine | sed 1d | grep -vc ',,')" -gt 20 ]
  [ "$(rows chain | wc -l)" -eq 9 ]
  [ "$(rows worn | sed 1d | wc -l)" -eq 6 ] && rows worn | sed 1d | grep -q ,periodic,
  near "$(rows chain | sed -n '$p' | cut -d , -f 4)" "$(mlg hopf l1 c_d=3e4 e=0.14 | sed -n 3p | cut -d , -f 2)" 1e-6 "the Hopf point of the last case"
}

# study_functions: those of scripts/studies/sweeps.sh
study_functions() {
  sed -n '/^coverage() {/,/^}/p; /^outcomes() {/,/^}/p' scripts/studies/sweeps.sh
}

@test "the tables of record, by cases chosen at random" {
  local row layout k_s b e l c_d zeta load g T psi
  # shellcheck disable=SC1090 # they are in the study
  . <(study_functions)
  while IFS=, read -r layout k_s b e l c_d zeta _; do
    near "$(cell c_d damping "$layout" best k_s="$k_s" b="$b" e="$e" l="$l")" "$c_d" 1e-5 "best c_d of $layout, e = $e, l = $l"
    near "$(cell zeta damping "$layout" best k_s="$k_s" b="$b" e="$e" l="$l")" "$zeta" 1e-5 "its zeta"
  done < <(grep '^l' "$ROOT/results/sweeps_map.csv" | sed 1d | shuf -n 4)
  [ "$(grep -c '^l[1i]' "$ROOT/results/sweeps_map.csv")" -ge 1900 ]

  # branches of AUTO, beside the sharp gap
  [ "$(grep -c '^[0-9].*,1,\(EP\|UZ\)$' "$ROOT/results/sweeps_play.csv")" -eq 121 ]
  while IFS=, read -r g T psi _; do
    near "$(cell psi_max cycle l1 V=20 c_d=2886.7 g_psi="$g" T_f="$T" v_f=0.01 psi=0.05)" "$psi" 1e-4 "psi_max at g_psi = $g, T_f = $T"
  done < <(grep '^[0-9]' "$ROOT/results/sweeps_play.csv" | shuf -n 3)

  row=$(grep '^l[12i]' "$ROOT/results/sweeps.csv" | shuf -n 1)
  IFS=, read -r layout load _ <<< "$row"
  { echo layout,k_s,b && grep "^$layout," constants/sweeps/devices.csv; } > build/one.csv
  sed "s|^cases.*|cases = build/one.csv|; s|^F_z.*|F_z = 1, $load|" constants/sweeps/load.sweep | sed 's/F_z = 1, /F_z = 1e5, /' > build/share.sweep
  mkdir -p build/share
  mlg cases build/share.sweep block=2 size=10000 folder=build/share
  run mlg cases build/share.sweep gather size=10000 folder=build/share
  sed 's/^case,F_z/case,layout,F_z/; /^[0-9]/s/,/,'"$layout"',/' build/share/partial.csv | grep -v '^#' | coverage > build/row
  diff build/row - <<< "$row"

  mkdir -p build/hopf
  mlg cases constants/sweeps/hopf.sweep block=$((RANDOM % 1250 + 1)) size=8 folder=build/hopf
  mlg cases constants/sweeps/hopf.sweep gather size=8 folder=build/hopf > build/said || true
  grep -v '^#' build/hopf/partial.csv | outcomes > build/outcomes
  [ "$(sed -n 's/^the same point,\([0-9]*\),.*/\1/p' build/outcomes)" -ge 1 ]
  [ "$(grep -v '^#' "$ROOT/results/sweeps_hopf.csv" | awk -F, '{ n += $2 } END { print n }')" -eq 10000 ]
}
