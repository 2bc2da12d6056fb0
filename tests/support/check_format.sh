#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks every tracked C and C++ file with clang-format 14; --fix rewrites them.
set -euo pipefail
cd "$(dirname "$0")/../.."
format=$(command -v clang-format-14 || command -v clang-format) || { echo "clang-format is not installed"; exit 1; }
"$format" --version | grep -q 'version 14\.' || { echo "$format is not version 14"; exit 1; }
mapfile -t files < <(git ls-files -- '*.c' '*.cpp' '*.h' '*.hpp' | grep -v '^tests/golden/')
if [ "${1:-}" = --fix ]; then
  "$format" -i --style=file "${files[@]}"
else
  bad=0
  for file in "${files[@]}"; do
    "$format" --dry-run -Werror --style=file "$file" 2>/dev/null || { echo "not formatted: $file"; bad=$((bad + 1)); }
  done
  echo "style.format: $bad of ${#files[@]} files are not formatted"
  [ "$bad" -eq 0 ]
fi
