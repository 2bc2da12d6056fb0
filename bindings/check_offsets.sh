#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles an assertion for each size, offset and value in shd.json. A wrong offset must not compile.
set -euo pipefail
cd "$(dirname "$0")"
file=$WORK/asserts.c
compile=("$CC" -std=c11 -Wall -Wextra -Werror -fsyntax-only -I ../include)
if ! grep -q '__LP64__ 1' <<<"$("$CC" -E -dM -x c /dev/null)"; then
  echo "skipped: the offsets are those of 64-bit machines"
  exit 77
fi
"$PYTHON" describe.py --asserts "$file"
"${compile[@]}" "$file"
sed 's/offsetof(shd_mesh_desc, uv) == /&1 + /' "$file" >"$WORK/wrong.c"
if "${compile[@]}" "$WORK/wrong.c" 2>/dev/null; then
  echo "a wrong offset compiles"
  exit 1
fi
echo "$(grep -c _Static_assert "$file") sizes, offsets and values are those of $CC"
