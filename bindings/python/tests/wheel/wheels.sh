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
core/bin/python -m shd compare picture.png expected.png
core/bin/python - <<'CHECK'
import os
import re
import shd
context = shd.Context()
workers = shd._api.lib.shd_context_worker_count(context.handle("shd_context", []))
assert workers == len(os.sched_getaffinity(0)), workers  # of oneTBB
found = set(re.findall(r"\S*/(?:libshd|libhwy|libtbb)\S*", open("/proc/self/maps").read()))
assert found == {f"{shd.__path__[0]}/libshd.so"}, found
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
import ctypes
import re
import shd
from shd import _api
assert b"ocio_profile_version" in _api.lib.shd_color_default_config()
context, keep = shd.Context(), []
bitmap, (desc, save, image) = ctypes.c_void_p(), map(_api.new, ("shd_load_desc", "shd_save_desc", "shd_image"))
_api.check(_api.lib.shd_bitmap_load(context.handle("shd_context", keep), b"picture.png", ctypes.addressof(desc),
                                    ctypes.addressof(bitmap)))  # by the program shd-io-worker of the wheel
_api.check(_api.lib.shd_bitmap_image(bitmap, ctypes.addressof(image)))
assert (image.width, image.height) == (64, 48)
found = set(re.findall(r"\S*/(?:libOpenColorIO|libyaml-cpp|libshd)\S*", open("/proc/self/maps").read()))
assert len(found) == 5 and all(path.startswith(shd.__path__[0]) for path in found), found
# This opens the module of OpenImageIO, which loads the system's own OpenColorIO beside that of the wheel.
_api.check(_api.lib.shd_image_save(ctypes.addressof(image), b"saved.png", ctypes.addressof(save)))
_api.lib.shd_bitmap_release(bitmap)
CHECK
whole/bin/python -m shd compare saved.png expected.png --max-abs 1
"$PYTHON" - dist/*.whl <<'CHECK'
import sys
import zipfile
for wheel in sys.argv[1:]:
    names = zipfile.ZipFile(wheel).namelist()
    assert any("dist-info/" in n and n.endswith("shd.txt") for n in names), f"{wheel} has no licences: {names}"
CHECK
