#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puts the Python package, as pip installs it, into a folder: python.sh FOLDER. pip builds inside a copy of the sources.
set -euo pipefail
bindings=$(readlink -f "$(dirname "$0")/../../../bindings")
mkdir -p "$1"
folder=$(readlink -f "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$bindings"/{shd.json,generate.py,generated.py,python} "$work"
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-315532800}
env -u SHD_LIBRARY -u SHD_BUNDLE /usr/bin/python3 -m pip wheel --quiet --disable-pip-version-check --no-index \
  --no-build-isolation --no-deps --wheel-dir "$work" "$work/python"
rm -rf "$folder"
/usr/bin/python3 -m zipfile -e "$work"/shd-*.whl "$folder"
