# SPDX-License-Identifier: MIT
# A Slurm cluster of one machine, in $cluster, with daemons in the foreground of this shell, a socket of munge and high
# ports. Needs root. start_cluster sets SLURM_CONF; stop_cluster ends the daemons that were started here.

daemons=()

stop_cluster() {
  local daemon
  for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2>/dev/null || true; done
}

start_munge() {
  local munge=$cluster/munge
  mkdir -p "$munge"
  chmod 755 "$munge"
  dd if=/dev/urandom of="$munge/key" bs=32 count=32 2>/dev/null
  chmod 400 "$munge/key"
  munged --foreground --force --socket="$munge/socket" --key-file="$munge/key" --log-file="$munge/log" \
    --pid-file="$munge/pid" --seed-file="$munge/seed" >"$munge/out" 2>&1 &
  daemons+=($!)
}

write_slurm_conf() {
  local cpus
  cpus=$(nproc)
  cat >"$cluster/slurm.conf" <<END
ClusterName=farm
SlurmctldHost=localhost(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$cluster/munge/socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$1
SlurmdPort=$2
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
JobAcctGatherType=jobacct_gather/none
NodeName=localhost NodeAddr=127.0.0.1 CPUs=$cpus State=UNKNOWN
PartitionName=farm Nodes=localhost Default=YES OverSubscribe=NO MaxTime=10 State=UP
END
}

start_cluster() {
  local port=$((20000 + $$ % 20000))
  mkdir -p "$cluster/state" "$cluster/spool"
  start_munge
  write_slurm_conf "$port" $((port + 1))
  export SLURM_CONF=$cluster/slurm.conf
  for _ in $(seq 50); do [ -S "$cluster/munge/socket" ] && break || sleep 0.1; done
  slurmctld -D >"$cluster/slurmctld.log" 2>&1 &
  daemons+=($!)
  slurmd -D -N localhost >"$cluster/slurmd.log" 2>&1 &
  daemons+=($!)
  for _ in $(seq 150); do
    sinfo -h -o %t 2>/dev/null | grep -q idle && return
    sleep 0.2
  done
  echo "the cluster did not start"
  tail -n 5 "$cluster/slurmctld.log" "$cluster/slurmd.log"
  return 1
}

# wait_for_job NUMBER: until it has left the queue
wait_for_job() {
  for _ in $(seq 300); do
    [ -n "$(squeue -h -j "$1" 2>/dev/null)" ] || return 0
    scontrol update JobId="$1" StartTime=now 2>/dev/null || true  # a requeued job waits for minutes
    sleep 0.2
  done
  squeue
  return 1
}
