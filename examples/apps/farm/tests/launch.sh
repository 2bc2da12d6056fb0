# SPDX-License-Identifier: MIT
# Local ranks for run.sh and the tests.

# launch RANKS PROGRAM...: also as root, and with more ranks than cores. Replaces a shell that runs in the background.
launch() {
  local ranks=$1 flags=(--oversubscribe)
  shift
  [ "$(id -u)" != 0 ] || flags+=(--allow-run-as-root)
  mpirun "${flags[@]}" -n "$ranks" "$@"
}

# ranks_of SHELL: processes of the ranks, in order, below a shell in the background that launches them
ranks_of() {
  local runner
  runner=$(pgrep -P "$1" -x mpirun || true)
  pgrep -P "${runner:-$1}" -x shd-farm
}

# wait_for_windows JOURNAL COUNT SHELL: until that number of windows is kept, or the job ends
wait_for_windows() {
  while kill -0 "$3" 2>/dev/null; do
    [ ! -e "$1" ] || [ "$(wc -l <"$1")" -le "$2" ] || return 0
    sleep 0.02
  done
  echo "the job ended before $2 windows were kept"
  return 1
}
