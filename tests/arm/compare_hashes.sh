#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# compare_hashes.sh hashes.txt command...: the lines that the command prints are those of the file.
set -uo pipefail
stored=$(grep -v '^#' "$1") || exit 1
shift
printed=$("$@") || { echo "failed: $*"; exit 1; }
count=$(printf '%s\n' "$stored" | wc -l)
equal=$(comm -12 <(printf '%s\n' "$stored" | sort) <(printf '%s\n' "$printed" | sort) | wc -l)
echo "$equal of $count hashes are equal"
[ "$stored" = "$printed" ] && exit 0
diff <(printf '%s\n' "$stored") <(printf '%s\n' "$printed")
exit 1
