#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The source of one file has the same bytes for any order of Python's hashes, and every function of the API.
# Usage: repeatable.sh python work-folder
set -euo pipefail
source=$(readlink -f "$(dirname "$0")/../..")
rm -rf "$2"
for seed in 1 2; do PYTHONHASHSEED=$seed "$1" "$source/src/packaging/amalgamate.py" "$2/$seed"; done
diff -r "$2/1" "$2/2"

# names.cpp makes its functions with a macro: SHD_NAMED_ENUMS lists (type, function, names).
functions=$(grep -oE '\bshd_[a-z0-9_]+(\(|_name, )' "$2/1/shd.cpp" | tr -d '(, ' | sort -u)
missing=$(comm -23 <(sort "$source/tests/abi/symbols_shd.txt") <(echo "$functions"))
if [ -n "$missing" ]; then
  echo "not in shd.cpp: $missing"
  exit 1
fi
if grep -n '^ *# *include "' "$2/1/shd.cpp" | grep -v '"shd_all.h"'; then
  echo "shd.cpp includes other sources"
  exit 1
fi
