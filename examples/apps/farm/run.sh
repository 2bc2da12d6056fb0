#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Renders a picture on local ranks, kills one of them half-way, resumes, and compares the file with that of one process.
# Usage: run.sh [--build FOLDER] [--ranks N] [--folder FOLDER] [EDGE]
#   EDGE    pixels of each side of the picture, default 16384; the three files take 8 bytes for each of its pixels
#   FOLDER  of the build, default build/farm, which is built if it is absent; folder of the pictures, default out/farm
set -euo pipefail
cd "$(dirname "$0")/../../.."

build=build/farm ranks=$(nproc) folder=out/farm edge=16384
while [ $# -gt 0 ]; do
  case $1 in
    --build) build=$2; shift 2 ;;
    --ranks) ranks=$2; shift 2 ;;
    --folder) folder=$2; shift 2 ;;
    *) edge=$1; shift ;;
  esac
done
[ "$ranks" -ge 2 ] || ranks=2
farm=$build/examples/apps/farm/shd-farm
if [ ! -x "$farm" ]; then
  echo "== Building shd-farm in $build"
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF
  cmake --build "$build" --target shd-farm
fi
. examples/apps/farm/tests/launch.sh
mkdir -p "$folder"
rm -f "$folder"/{farm,alone}.exr*

window=256
[ "$edge" -ge 4096 ] || window=64
picture=(--size "${edge}x$edge" --supersampling 2 --window "$window")
spider=/usr/share/assimp/models/OBJ/spider.obj  # Debian: assimp-testmodels
# A build without libshd_scene has no models.
if [ -e "$spider" ] &&
  "$farm" --single 16 --size 16x16 --window 16 --model "$spider" -o "$folder/farm.exr" >/dev/null 2>&1; then
  picture+=(--model "$spider")
  echo "== The spiders of the gallery, $edge x $edge pixels, $ranks ranks"
else
  echo "== The scene made in code ($spider is absent: assimp-testmodels), $edge x $edge pixels, $ranks ranks"
fi
rm -f "$folder/farm.exr"
windows=$(((edge + window - 1) / window * ((edge + window - 1) / window)))

echo "== A job whose last rank is killed half-way"
launch "$ranks" "$farm" "${picture[@]}" -o "$folder/farm.exr" >"$folder/killed.log" 2>&1 &
job=$!
wait_for_windows "$folder/farm.exr.journal" $((windows / 2)) "$job"
victim=$(ranks_of "$job" | tail -n 1)
kill -KILL "$victim"
status=0
wait "$job" || status=$?
echo "rank with process $victim killed, status of the job $status," \
  "$(($(wc -l <"$folder/farm.exr.journal") - 1)) of $windows windows kept"
grep -h 'noticed that process\|PRTE\|exited on signal' "$folder/killed.log" || true
[ "$status" -ne 0 ] || { echo "the job did not notice the kill"; exit 1; }

echo "== The same command again"
launch "$ranks" "$farm" "${picture[@]}" -o "$folder/farm.exr"

echo "== One process, bands of 4096 rows"
"$farm" "${picture[@]}" --single 4096 --threads "$(nproc)" -o "$folder/alone.exr"

echo "== Hashes"
sha256sum "$folder/farm.exr" "$folder/alone.exr"
if cmp "$folder/farm.exr" "$folder/alone.exr"; then
  echo "equal"
else
  echo "NOT equal"
  exit 1
fi
