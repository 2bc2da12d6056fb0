#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Drives the playground in Chromium, and draws its picture with the native library. Screenshots are in $WORK/playground.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$WORK/playground"
cd "$WORK/playground"
"$here/npm_install.sh" playwright-core
"$NODE" "$here/playground.mjs" "$CHROMIUM" "$WORK/playground"
for python in "$PYTHON" /usr/bin/python3; do
  if "$python" -c "import numpy" 2>/dev/null; then
    exec "$python" "$here/playground_native.py" scene.json
  fi
done
echo "NumPy is not installed (Debian: python3-numpy): the picture was not compared with the native library"
