#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# wheels.sh [option of cmake]...: builds the wheels, installs them in bare environments and draws the same picture as
# with libshd at $SHD_LIBRARY. PYTHON is the interpreter, WORK a folder. Exit code 77: something that wheel.sh needs, or
# venv, is absent.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
if ! "$PYTHON" -c 'import ensurepip, numpy' 2> /dev/null; then
  echo "skipped: $PYTHON lacks venv or NumPy (Debian: python3-venv python3-numpy)"
  exit 77
fi
"$here/../../wheel.sh" "$WORK" "$@"
cd "$WORK"
PYTHONPATH=$here/../.. "$PYTHON" -m shd expected.png --size 64 48
unset SHD_LIBRARY PYTHONPATH

# name, wheel...: an environment that has NumPy and the wheels
environment() {
  rm -rf "$1"
  "$PYTHON" -m venv --system-site-packages "$1"
  "$1/bin/python" -m pip install --quiet --disable-pip-version-check --no-index --no-deps "${@:2}"
}
environment core dist/shd-*.whl
core/bin/python -m shd picture.png --size 64 48
cmp picture.png expected.png
core/bin/python "$here/model.py" model.png
core/bin/python -m shd compare picture.png expected.png
core/bin/python - <<'CHECK'
import os
import re
import shd
context = shd.Context()
workers = shd._api.lib.shd_context_get_worker_count(context.handle("shd_context", []))
assert workers == len(os.sched_getaffinity(0)), workers  # of oneTBB
shd._api.lib.shd_scene_load  # also loads libshd_io
found = set(re.findall(r"\S*/lib(?:shd|hwy|tbb|png|jpeg|z|zstd|draco)\S*", open("/proc/self/maps").read()))
assert {path for path in found if "/libshd" in path} == {
    f"{shd.__path__[0]}/{name}.so" for name in ("libshd", "libshd_io", "libshd_scene")}, found
assert not [path for path in found if re.search("/lib(hwy|tbb|draco)", path)], found
CHECK
core/bin/python "$here/../../start_time.py" --installed
if core/bin/python -c 'import pytest' 2> /dev/null; then
  mkdir -p suite
  printf 'import numpy as np\ndef test_a(golden):\n    golden.check(np.zeros((4, 4, 3), np.uint8), "a")\n' \
    > suite/test_a.py
  core/bin/python -m pytest -q -p no:cacheprovider --shd-update suite       # the installed plugin
  core/bin/python -m pytest -q -p no:cacheprovider -p shd.pytest_plugin suite  # is not loaded twice
else
  echo "pytest is absent (Debian: python3-pytest): the installed plugin is not tested"
fi

environment whole dist/*.whl
whole/bin/python - <<'CHECK'
import re
import shd
assert b"ocio_profile_version" in shd._api.lib.shd_color_default_config()
found = set(re.findall(r"\S*/(?:libOpenColorIO|libyaml-cpp|libshd)\S*", open("/proc/self/maps").read()))
assert len(found) == 4 and all(path.startswith(shd.__path__[0]) for path in found), found
CHECK
"$PYTHON" - dist/*.whl <<'CHECK'
import sys
import zipfile
for wheel in sys.argv[1:]:
    names = zipfile.ZipFile(wheel).namelist()
    assert any("dist-info/" in n and n.endswith("shd.txt") for n in names), f"{wheel} has no licences: {names}"
CHECK
