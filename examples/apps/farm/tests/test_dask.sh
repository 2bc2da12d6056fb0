#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Dask example with local workers, one of them killed. SHD_LIBRARY names libshd.
# Usage: test_dask.sh
set -euo pipefail
cd "$(dirname "$0")/.."
python=
for candidate in python3 /usr/bin/python3; do
  if "$candidate" -c 'import numpy, distributed' 2>/dev/null; then python=$candidate && break; fi
done
[ -n "$python" ] || { echo "skipped: distributed is absent, python3-distributed"; exit 77; }
PYTHONPATH=$PWD/../../../bindings/python PYTHONDONTWRITEBYTECODE=1 "$python" dask_farm.py --size 1024 --kill
