#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh with a small picture, and the model of scaling with its times.
# Usage: test_run.sh BUILD FOLDER
set -euo pipefail
build=$1 folder=$2
here=$(cd "$(dirname "$0")/.." && pwd)
for tool in mpirun:openmpi-bin pgrep:procps; do
  command -v "${tool%:*}" >/dev/null || { echo "skipped: ${tool%:*} is absent, ${tool#*:}"; exit 77; }
done
mkdir -p "$folder"
"$here/run.sh" --build "$build" --folder "$folder" --ranks 2 2048 | tee "$folder/run.log"
grep -qx equal "$folder/run.log"
. "$here/tests/launch.sh"
launch 2 "$build/examples/apps/farm/shd-farm" --fresh --size 1024x1024 --window 64 --supersampling 8 --samples 4 \
  -o "$folder/times.exr" --times "$folder/times.csv"
# These windows have 1/16 of the pixels of the default, so a window of 256 takes 16 times as long.
python3 "$here/scaling.py" "$folder/times.csv" --scale 16 --require 0.9
