#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Strong scaling on local ranks: seconds of one picture on 1 and 2 ranks, each bound to a core, the best of some rounds.
# Usage: strong_scaling.sh FARM [ROUNDS] [OPTIONS OF shd-farm...]
set -euo pipefail
farm=$1 rounds=${2:-5}
shift $(($# < 2 ? $# : 2))
options=("$@")
[ $# -gt 0 ] || options=(--size 4096x4096 --supersampling 2)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
flags=(--bind-to core)
[ "$(id -u)" != 0 ] || flags+=(--allow-run-as-root)
declare -A best=([1]=1e9 [2]=1e9)
for round in $(seq "$rounds"); do
  for ranks in 1 2; do
    mpirun "${flags[@]}" -n "$ranks" "$farm" "${options[@]}" --fresh -o "$folder/picture.exr" \
      >"$folder/log" 2>/dev/null
    seconds=$(sed -n 's/^[0-9]* ranks, \(.*\) s$/\1/p' "$folder/log")
    echo "round $round, $ranks ranks: $seconds s"
    best[$ranks]=$(awk -v a="${best[$ranks]}" -v b="$seconds" 'BEGIN { print (a < b ? a : b) }')
  done
done
awk -v a="${best[1]}" -v b="${best[2]}" 'BEGIN { printf "best: %.3f s and %.3f s, speed-up %.3f\n", a, b, a / b }'
