#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the package from a copy of the sources without a network, with the path of libshd in SHD_LIBRARY, and runs it
# without that path; then a wheel that has libshd. Exit code 77: pip, setuptools, wheel or NumPy is absent.
set -euo pipefail
sources=$(cd "$(dirname "$0")/../.." && pwd)
if ! "$PYTHON" -c 'import setuptools, numpy, pip, wheel' 2>/dev/null; then
  echo "skipped: $PYTHON lacks NumPy, pip, setuptools or wheel (Debian: python3-numpy python3-pip python3-wheel)"
  exit 77
fi
rm -rf "$WORK"
mkdir -p "$WORK/bindings"
cp -r "$sources"/{shd.json,generate.py,generated.py,python} "$WORK/bindings/"  # pip builds inside the sources
"$PYTHON" -m pip install --quiet --root-user-action=ignore --disable-pip-version-check --no-index \
  --no-build-isolation --no-deps --target "$WORK/site" "$WORK/bindings/python"
library=$SHD_LIBRARY
unset SHD_LIBRARY
export PYTHONPATH=$WORK/site
cd "$WORK"
"$PYTHON" -m shd picture.png --size 64 48
[ "$(head -c 4 picture.png | tail -c 3)" = PNG ]

# A wheel with its own libshd: nothing else than the system's libraries comes from elsewhere.
SHD_BUNDLE=$library "$PYTHON" -m pip wheel --quiet --disable-pip-version-check --no-index \
  --no-build-isolation --no-deps --wheel-dir "$WORK" "$WORK/bindings/python"
"$PYTHON" -m zipfile -e "$WORK"/shd-*-py3-none-linux_*.whl "$WORK/wheel"
size=$(stat -c %s "$WORK"/shd-*.whl)
echo "the wheel has $size bytes"
[ "$size" -le 4194304 ]
cd "$WORK/wheel"
PYTHONPATH=$WORK/wheel "$PYTHON" - <<'CHECK'
import re
import shd
shd.Context()
maps = open("/proc/self/maps").read()
found = set(re.findall(r"\S*/(?:libshd|libhwy|libtbb)\.so\S*", maps))
assert found and all(path.startswith(shd.__path__[0]) for path in found), found
CHECK
PYTHONPATH=$WORK/wheel "$PYTHON" -m shd ../other.png --size 64 48
cmp ../other.png ../picture.png
