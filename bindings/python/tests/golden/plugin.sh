#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the tests of the pytest plugin with $PYTHON and libshd $SHD_LIBRARY. Exit code 77: pytest is absent.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
if ! "$PYTHON" -c 'import pytest, numpy' 2>/dev/null; then
  echo "skipped: $PYTHON lacks pytest or NumPy (Debian: python3-pytest python3-numpy)"
  exit 77
fi
temporary=$(mktemp -d)
trap 'rm -rf "$temporary"' EXIT
cd "$temporary"
export PYTHONPATH=$here/../.. PYTHONDONTWRITEBYTECODE=1 PYTEST_DISABLE_PLUGIN_AUTOLOAD=1
"$PYTHON" -m pytest -q -p pytester -p no:cacheprovider --basetemp="$temporary/base" --rootdir="$temporary" \
  "$here/plugin_cases.py"
