#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks every tracked C and C++ file with clang-format 14, and that no line is longer than 120 columns (clang-format
# does not break comments); --fix rewrites the files.
set -euo pipefail
cd "$(dirname "$0")/../.."
format=$(command -v clang-format-14 || command -v clang-format) || { echo "clang-format is not installed"; exit 1; }
"$format" --version | grep -q 'version 14\.' || { echo "$format is not version 14"; exit 1; }
mapfile -t files < <(git ls-files -- '*.c' '*.cpp' '*.h' '*.hpp' | grep -v '^tests/golden/')
if [ "${1:-}" = --fix ]; then
  "$format" -i --style=file "${files[@]}"
else
  # Many files to a process: starting it takes longer than checking a file.
  status=0
  report=$(printf '%s\0' "${files[@]}" |
    xargs -0 -n 16 -P "$(nproc)" "$format" --dry-run -Werror --style=file 2>&1) || status=$?
  mapfile -t bad < <(sed -n 's/:[0-9]*:[0-9]*: error: .*//p' <<<"$report" | sort -u)
  [ "${#bad[@]}" -eq 0 ] || printf 'not formatted: %s\n' "${bad[@]}"
  [ "$status" -eq 0 ] || [ "${#bad[@]}" -gt 0 ] || printf '%s\n' "$report"
  mapfile -t long < <(awk 'length($0) > 120 {print FILENAME ":" FNR}' "${files[@]}")
  [ "${#long[@]}" -eq 0 ] || printf 'longer than 120 columns: %s\n' "${long[@]}"
  echo "style.format: ${#bad[@]} of ${#files[@]} files are not formatted, ${#long[@]} lines are too long"
  [ "$status" -eq 0 ] && [ "${#long[@]}" -eq 0 ]
fi
