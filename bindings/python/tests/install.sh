#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the package from a copy of the sources without a network, with the path of libshd in SHD_LIBRARY, and runs it
# without that path. Exit code 77: pip, setuptools, wheel or NumPy is absent.
set -euo pipefail
sources=$(cd "$(dirname "$0")/../.." && pwd)
if ! "$PYTHON" -c 'import setuptools, numpy, pip, wheel' 2>/dev/null; then
  echo "skipped: $PYTHON lacks NumPy, pip, setuptools or wheel (Debian: python3-numpy python3-pip python3-wheel)"
  exit 77
fi
rm -rf "$WORK"
mkdir -p "$WORK/bindings"
cp -r "$sources/shd.json" "$sources/python" "$WORK/bindings/"  # pip builds inside the sources
"$PYTHON" -m pip install --quiet --root-user-action=ignore --disable-pip-version-check --no-index \
  --no-build-isolation --no-deps --target "$WORK/site" "$WORK/bindings/python"
unset SHD_LIBRARY
export PYTHONPATH=$WORK/site
cd "$WORK"
"$PYTHON" -m shd picture.png --size 64 48
[ "$(head -c 4 picture.png | tail -c 3)" = PNG ]
"$PYTHON" "$sources/python/tests/run.py" --installed
