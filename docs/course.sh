#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the commands that the pages of the course print, in an empty folder, and replaces their pictures. With --check it
# compares the pictures with those of the tree instead, and checks the table of concepts; see course.py.
# Usage: course.sh [--check] BUILD [FOLDER]; BUILD is a finished build, FOLDER is emptied. Exits with 77, as CTest skips
# tests, if a program or NumPy is absent.
set -euo pipefail
docs=$(cd "$(dirname "$0")" && pwd)
check=
if [ "${1:-}" = --check ]; then
  check=--check
  shift
fi
build=$(cd "$1" && pwd)
folder=${2:-$build/course}

skip() {
  echo "course.sh: skipped, $*"
  exit 77
}

for program in src/tool/shd-render examples/polygon examples/deform docs/shd-footprints src/libshd.so; do
  [ -e "$build/$program" ] || skip "$build/$program is not built"
done
python=
for candidate in "${PYTHON:-python3}" python3 /usr/bin/python3; do
  if "$candidate" -c "import numpy" 2>/dev/null; then
    python=$candidate
    break
  fi
done
[ -n "$python" ] || skip "no NumPy (Debian: python3-numpy)"

export SHD_LIBRARY=$build/src/libshd.so
export PYTHONPATH=$docs/../bindings/python${PYTHONPATH:+:$PYTHONPATH} PYTHONDONTWRITEBYTECODE=1
export PATH=$build/src/tool:$build/examples:$build/examples/course:$build/docs:$docs:$PATH
exec "$python" "$docs/course.py" $check "$folder"
