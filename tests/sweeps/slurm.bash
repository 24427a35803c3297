# shellcheck shell=bash
# slurm.bash - a Slurm of one node on loopback, for the tests; as root and without munge
#
# All its files are in one folder, its daemons are ended by their ids, and what they listen
# on is 127.0.0.1 and ports of its own.

# begin_slurm FOLDER CPUS: status 1 and a line when it cannot be
begin_slurm() {
  local daemon _
  for daemon in slurmctld slurmd sbatch squeue; do
    command -v "$daemon" > /dev/null || { echo "no $daemon (Debian: slurm-wlm)"; return 1; }
  done
  [ "$(id -u)" = 0 ] || { echo "not root"; return 1; }
  slurm=$(realpath -m "$1")
  mkdir -p "$slurm/state" "$slurm/spool"
  slurm_conf "$2" > "$slurm/slurm.conf"
  export SLURM_CONF=$slurm/slurm.conf
  slurmctld -D -c > "$slurm/slurmctld.log" 2>&1 &
  slurmctld=$!
  slurmd -D -N sweeps -c > "$slurm/slurmd.log" 2>&1 &
  slurmd=$!
  for _ in {1..20}; do
    if timeout 2 sinfo --noheader --format=%T 2> /dev/null | grep -qx idle; then return; fi
    sleep 0.5
  done
  end_slurm
  echo "it does not start: $(tail -n 1 "$slurm/slurmctld.log" "$slurm/slurmd.log" | xargs)"
  return 1
}

slurm_conf() { # CPUS
  local port=$((20000 + $$ % 20000))
  cat << END
ClusterName=sweeps
SlurmctldHost=$(hostname -s)(127.0.0.1)
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
SchedulerParameters=defer,sched_interval=1
KillWait=2
MinJobAge=10
ReturnToService=2
NodeName=sweeps NodeAddr=127.0.0.1 NodeHostname=sweeps CPUs=$1 State=UNKNOWN
PartitionName=all Nodes=sweeps Default=YES MaxTime=INFINITE State=UP
END
}

# Steps first, then the daemons, each by its id.
end_slurm() {
  local pid
  scancel --user=root --quiet 2> /dev/null || true
  sleep 1
  for pid in $(ps -o pid= --ppid "$slurmd" 2> /dev/null) "$slurmd" "$slurmctld"; do
    kill "$pid" 2> /dev/null || true
  done
  wait "$slurmd" "$slurmctld" 2> /dev/null || true
}
