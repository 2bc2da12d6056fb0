#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the models of scene_files.mjs with libshd_scene of this machine: the pictures are those of shd.wasm.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
for python in "$PYTHON" /usr/bin/python3; do
  if "$python" -c "import numpy" 2>/dev/null; then
    exec "$here/../../../tests/arm/compare_hashes.sh" "$here/scene_hashes.txt" "$python" "$here/scene_native.py"
  fi
done
echo "skipped: NumPy is not installed (Debian: python3-numpy)"
exit 77
