#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Frames in Godot have the bits of frames in C. The environment has GODOT, CC, GODOT_HEADERS, SHD_LIBRARY and WORK.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
if [ ! -f "$GODOT_HEADERS/gdnative_api_struct.gen.h" ]; then
  echo "skipped: no headers of GDNative in $GODOT_HEADERS;" \
    "run examples/apps/godot/fetch_headers.sh $(dirname "$GODOT_HEADERS")"
  exit 77
fi
rm -rf "$WORK"
mkdir -p "$WORK"
"$here/build.sh" "$WORK/project"
"$CC" -std=c99 -O2 -ffp-contract=off -Wall -Wextra -Werror -I "$here/../../../include" "$here/plain.c" "$here/scene.c" \
  "$SHD_LIBRARY" -lm -Wl,-rpath,"$(dirname "$SHD_LIBRARY")" -o "$WORK/plain"
"$WORK/plain" 3 512 288 >"$WORK/expected.txt"
export HOME=$WORK SHD_PICTURE=$WORK/godot.png  # Godot writes its settings below HOME
status=0
timeout 60 "$GODOT" --path "$WORK/project" >"$WORK/log.txt" 2>&1 || status=$?
grep '^frame' "$WORK/log.txt" >"$WORK/frames.txt" || true
cat "$WORK/frames.txt"
if [ "$status" != 0 ] || ! diff "$WORK/expected.txt" "$WORK/frames.txt" ||
  ! grep -qx 'refusals 8 of 8' "$WORK/log.txt" || [ ! -s "$SHD_PICTURE" ]; then
  cat "$WORK/log.txt"
  echo "exit code $status of Godot"
  exit 1
fi
