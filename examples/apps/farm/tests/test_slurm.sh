#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The two batch scripts on a Slurm cluster of this machine: a job whose rank is killed, which Slurm starts again, and an
# array of frames.
# Usage: test_slurm.sh FARM FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
farm=$1 folder=$2
tools=(mpirun:openmpi-bin pgrep:procps slurmctld:slurmctld slurmd:slurmd sbatch:slurm-client munged:munge)
for tool in "${tools[@]}"; do
  PATH=$PATH:/usr/sbin command -v "${tool%:*}" >/dev/null && continue
  echo "skipped: ${tool%:*} is absent, ${tool#*:}"
  exit 77
done
[ "$(id -u)" = 0 ] || { echo "skipped: the daemons of Slurm need root"; exit 77; }
PATH=$PATH:/usr/sbin
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
. "$here/launch.sh"
. "$here/slurm_cluster.sh"
cluster=$(mktemp -d)  # short, because names of sockets are short
trap 'stop_cluster; rm -rf "$cluster"' EXIT
start_cluster
export FARM=$farm FARM_MPIRUN_FLAGS="--oversubscribe"

picture=(--size 1500x900 --window 96 --supersampling 12 --samples 16)
"$farm" "${picture[@]}" --single 16384 -o alone.exr

echo "== A job of ranks, one of them killed"
number=$(sbatch --parsable --ntasks=2 "$here/../farm.sbatch" "${picture[@]}" -o job.exr)
for _ in $(seq 300); do
  [ ! -e job.exr.journal ] || [ "$(wc -l <job.exr.journal)" -le 20 ] || break
  sleep 0.1
done
for process in $(pgrep -x shd-farm); do  # of this job only
  grep -qz "SLURM_CONF=$SLURM_CONF" "/proc/$process/environ" && victim=$process
done
kill -KILL "$victim"
sleep 1
# A requeued job waits for a while. The operator may release it at once.
for _ in $(seq 300); do
  [ ! -e job.exr ] || break
  scontrol update JobId="$number" StartTime=now 2>/dev/null || true
  sleep 1
done
wait_for_job "$number"
cat "shd-farm-$number.log"
cmp job.exr alone.exr
grep -q "job $number, start 2" "shd-farm-$number.log"
grep -Eq '160 windows: [1-9][0-9]* from earlier jobs' "shd-farm-$number.log"

echo "== An array of frames"
frames=(--size 200x150 --window 64 --frames 4)
number=$(sbatch --parsable --array=0-3 "$here/../frames.sbatch" "${frames[@]}" -o array.exr)
wait_for_job "$number"
"$farm" "${frames[@]}" --single 16384 -o turn.exr
for frame in 0 1 2 3; do cmp "array.000$frame.exr" "turn.000$frame.exr"; done
echo "slurm: passed"
