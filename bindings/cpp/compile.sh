#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles the programs of this folder with g++ and clang++ without a warning, and the headers without exceptions.
set -euo pipefail
cd "$(dirname "$0")"
options=(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -fsyntax-only -I ../../include -I .)
count=0
for compiler in g++ clang++; do
  if ! command -v "$compiler" >/dev/null; then
    echo "$compiler: not installed, skipped"
    continue
  fi
  "$compiler" -std=c++17 "${options[@]}" hello.cpp
  "$compiler" -std=c++20 "${options[@]}" -DSHD_TEST_SCENE test_shd_hpp.cpp
  "$compiler" -std=c++17 -fno-exceptions "${options[@]}" -x c++ - <<<'#include <shd.hpp>'
  count=$((count + 1))
done
echo "$count compilers"
[ "$count" -gt 0 ]
