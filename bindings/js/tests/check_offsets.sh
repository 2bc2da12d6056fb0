#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles an assertion for each size and offset of lib/api.js with Emscripten. A wrong offset must not compile.
set -euo pipefail
cd "$(dirname "$0")/.."
file=$WORK/asserts32.c
compile=("$EMCC" -std=c11 -Wall -Wextra -Werror -fsyntax-only -I ../../include)
"$PYTHON" generate.py --asserts "$file"
"${compile[@]}" "$file"
sed 's/offsetof(shd_mesh_desc, uv) == /&1 + /' "$file" >"$WORK/wrong32.c"
if "${compile[@]}" "$WORK/wrong32.c" 2>/dev/null; then
  echo "a wrong offset compiles"
  exit 1
fi
echo "$(grep -c _Static_assert "$file") sizes and offsets are those of $EMCC"
